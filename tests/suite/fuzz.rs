//! The bodies of the fuzz targets, run on the committed corpus and on a fixed number of random cases.
//!
//! `cargo xtask fuzz` searches for new cases with libFuzzer. Put every crash that it finds into `tests/fuzz/corpus`: each run
//! of the tests then repeats it.

#[path = "../fuzz/bodies/axes.rs"]
mod axes;
#[path = "../fuzz/bodies/derived_file.rs"]
mod derived_file;
#[path = "../fuzz/bodies/engine.rs"]
mod engine;
#[path = "../../derive/macros/src/equations/mod.rs"]
mod equations;
#[path = "../fuzz/bodies/parts.rs"]
mod parts;
#[path = "../fuzz/bodies/scene.rs"]
mod scene;

mod common;
#[path = "common/random.rs"]
mod random;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

use random::Random;

/// Number of random cases of each body; the environment variable `FUZZ_CASES` overrides it.
const CASES: u64 = 1500;

fn cases() -> u64 {
    std::env::var("FUZZ_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(CASES)
}

/// The random numbers of a test with this `seed`; the environment variable `FUZZ_SEED` selects another sequence.
fn random(seed: u64) -> Random {
    let other = std::env::var("FUZZ_SEED").ok().and_then(|n| n.parse().ok()).unwrap_or(0u64);
    Random::new(seed ^ other.wrapping_mul(0x2545_f491_4f6c_dd1d))
}

/// The committed corpus of a target.
fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = common::root().join("tests/fuzz/corpus").join(target);
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.into_iter().map(|path| fs::read(path).unwrap()).collect()
}

/// Runs a body; if it fails, prints the case in hexadecimal and as text.
fn run(body: Body, data: &[u8]) {
    if let Err(panic) = catch_unwind(AssertUnwindSafe(|| body(data))) {
        let hex: String = data.iter().map(|byte| format!("{byte:02x}")).collect();
        eprintln!("failing case, to be added to the corpus: {hex}\n{}", String::from_utf8_lossy(data));
        std::panic::resume_unwind(panic);
    }
}

/// Runs a case.
type Body = fn(&[u8]);

/// The targets whose cases are texts or bytes in a format. The target `combination` has a separate suite, `combinations`.
const TARGETS: [(&str, Body); 5] = [
    ("scene", scene::check),
    ("axes", axes::check),
    ("parts", parts::check),
    ("derived_file", derived_file::check),
    ("engine", engine::check),
];

#[test]
fn cases_of_the_corpus_are_read_or_refused() {
    for (target, body) in TARGETS {
        corpus(target).iter().for_each(|data| run(body, data));
    }
}

#[test]
fn mutated_scenes_are_read_or_refused() {
    mutated("scene", scene::check, cases(), 1);
}

#[test]
fn mutated_axes_are_read_or_refused() {
    mutated("axes", axes::check, cases(), 3);
}

#[test]
fn mutated_sweep_folders_are_read_as_written_or_refused() {
    mutated("parts", parts::check, cases() / 3, 4);
}

#[test]
fn mutated_derived_files_give_code_or_errors() {
    mutated("derived_file", derived_file::check, cases() / 3, 5);
}

/// Runs a body on cases of its corpus with changes: a byte, a piece that is left out, a piece of another case.
fn mutated(target: &str, body: Body, cases: u64, seed: u64) {
    let (corpus, mut random) = (corpus(target), random(seed));
    for _ in 0..cases {
        let mut data = corpus[random.below(corpus.len())].clone();
        for _ in 0..1 + random.below(6) {
            let at = random.below(data.len());
            let other = &corpus[random.below(corpus.len())];
            let from = random.below(other.len());
            let piece = &other[from..(from + random.below(24)).min(other.len())];
            match random.below(4) {
                0 if !data.is_empty() => data[at] = random.next() as u8,
                1 => drop(data.drain(at..(at + random.below(24)).min(data.len()))),
                2 => drop(data.splice(at..at, piece.iter().copied())),
                _ => drop(data.splice(at..(at + piece.len()).min(data.len()), piece.iter().copied())),
            }
        }
        run(body, &data);
    }
}

#[test]
fn runs_of_arbitrary_numbers_end_or_stop_with_an_error() {
    let mut random = random(2);
    for _ in 0..cases() {
        let data: Vec<u8> = (0..64).map(|_| random.next() as u8).collect();
        run(engine::check, &data);
    }
}

/// This failed once; the fuzzer found it.
#[test]
fn a_start_may_give_every_coordinate() {
    let scene = common::scene("oh2005/energy_300rpm", &["start.phi=0.01 rad".into()]);
    common::run(&scene);
}

#[test]
fn a_start_at_an_angle_too_large_to_count_pitches_does_not_panic() {
    let scene = common::scene("oh2005/energy_300rpm", &["start.theta=1e30 rad".into()]);
    let _ = common::model("gear_pair").run(&scene, &mut |_| {});
}

#[test]
fn damping_that_overflows_is_refused_or_gives_finite_energies() {
    let scene = common::scene("oh2005/energy_300rpm", &["parameters.zeta=1e200".into()]);
    if let Ok(outcome) = common::model("gear_pair").run(&scene, &mut |_| {}) {
        assert!(outcome.stopped_by.is_some() || outcome.trajectory.residual.iter().all(|x| x.is_finite()));
    }
}
