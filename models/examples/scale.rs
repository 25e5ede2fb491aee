//! Time of the derivation and size of the generated file against the number of coordinates, for chains and planar planetaries.
//! Usage: `cargo run -p gearsim-models --example scale [NAME]...`

use std::time::Instant;

use gearsim_derive::{Model, derive};
use gearsim_models::{chain::chain, planar_planetary::planar_planetary};

fn main() {
    let names: Vec<String> = std::env::args().skip(1).collect();
    let chains = [2, 8, 32, 64].map(|n| (format!("chain_{n}"), Model::new(&format!("chain_{n}"), |m| chain(m, n))));
    let stages = [3, 5, 9].map(|n| {
        (format!("planar_planetary_{n}"), Model::new(&format!("planar_planetary_{n}"), |m| planar_planetary(m, n)))
    });
    for (name, model) in chains.into_iter().chain(stages).filter(|(n, _)| names.is_empty() || names.contains(n)) {
        let start = Instant::now();
        let derivation = derive(&model).unwrap_or_else(|slip| panic!("{slip}"));
        let derived = start.elapsed();
        let file = derivation.file();
        println!(
            "{name}: derived and proved in {:.3} s, with its file in {:.3} s, {} lines, {} kB",
            derived.as_secs_f64(),
            start.elapsed().as_secs_f64(),
            file.lines().count(),
            file.len() / 1024
        );
        derivation.proofs().iter().for_each(|proof| println!("    {proof}"));
    }
}
