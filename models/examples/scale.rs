//! Time of the derivation with its proofs, and size of its file, for the gear pair, chains of discs and planar planetaries.
//! Usage: `cargo build --workspace --example scale && target/debug/examples/scale [--once] [NAME]...`; with `-p` instead of `--workspace`
//! Symbolica would be compiled once more, with other features. `cargo xtask derivation-costs` counts the instructions of this program.

use std::time::Instant;

use gearsim_derive::{Derivation, Model, derive};
use gearsim_models::{chain::chain, gear_pair::gear_pair, planar_planetary::planar_planetary};

/// A function that describes a model.
type Describe = Box<dyn Fn(&mut Model)>;

/// Each model is derived this many times; the shortest time is the one that other programs disturbed least.
const TIMES: usize = 3;

fn main() {
    let (options, names): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|word| word == "--once");
    let times = if options.is_empty() { TIMES } else { 1 };
    let mut all: Vec<(String, Describe)> = vec![("gear_pair".into(), Box::new(gear_pair))];
    all.extend(
        [2, 8, 32, 64, 128].map(|n| (format!("chain_{n}"), Box::new(move |m: &mut Model| chain(m, n)) as Describe)),
    );
    all.extend(
        [3, 5, 9].map(|n| {
            (format!("planar_planetary_{n}"), Box::new(move |m: &mut Model| planar_planetary(m, n)) as Describe)
        }),
    );
    println!("| model | derived and proved | with its file | lines | kB |\n| --- | ---: | ---: | ---: | ---: |");
    for (name, describe) in all.iter().filter(|(n, _)| names.is_empty() || names.contains(n)) {
        let mut best = [f64::INFINITY; 2];
        let mut size = (0, 0);
        for _ in 0..times {
            let start = Instant::now();
            let model = Model::new(name, describe);
            let derivation = derived(&model);
            let derived = start.elapsed().as_secs_f64();
            let file = derivation.file();
            let time = [derived, start.elapsed().as_secs_f64()];
            best = [0, 1].map(|i| time[i].min(best[i]));
            size = (file.lines().count(), file.len() / 1024);
        }
        println!("| {name} | {:.1} ms | {:.1} ms | {} | {} |", 1e3 * best[0], 1e3 * best[1], size.0, size.1);
    }
}

/// Derives and proves a model. Not inlined, because callgrind finds this function by its name.
#[inline(never)]
fn derived(model: &Model) -> Derivation<'_> {
    derive(model).unwrap_or_else(|slip| panic!("{slip}"))
}
