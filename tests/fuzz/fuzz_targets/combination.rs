//! The entry point of libFuzzer to `bodies/combination.rs`.
#![no_main]

#[path = "../../suite/combinations/checks.rs"]
mod checks;
#[path = "../bodies/combination.rs"]
mod combination;
#[path = "../../suite/two_methods/compare.rs"]
mod compare;
#[path = "../../suite/combinations/draw.rs"]
mod draw;
#[path = "../../suite/common/effects.rs"]
mod effects;
#[path = "../../suite/common/random.rs"]
mod random;

libfuzzer_sys::fuzz_target!(|data: &[u8]| combination::check(data));
