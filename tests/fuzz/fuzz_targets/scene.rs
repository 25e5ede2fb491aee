//! The entry point of libFuzzer to `bodies/scene.rs`.
#![no_main]

#[path = "../bodies/scene.rs"]
mod scene;

libfuzzer_sys::fuzz_target!(|data: &[u8]| scene::check(data));
