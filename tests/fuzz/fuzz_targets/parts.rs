//! The entry point of libFuzzer to `bodies/parts.rs`.
#![no_main]

#[path = "../bodies/parts.rs"]
mod parts;

libfuzzer_sys::fuzz_target!(|data: &[u8]| parts::check(data));
