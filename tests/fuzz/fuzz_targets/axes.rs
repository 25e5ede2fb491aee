//! The entry point of libFuzzer to `bodies/axes.rs`.
#![no_main]

#[path = "../bodies/axes.rs"]
mod axes;

libfuzzer_sys::fuzz_target!(|data: &[u8]| axes::check(data));
