//! The entry point of libFuzzer to `bodies/derived_file.rs`.
#![no_main]

#[path = "../bodies/derived_file.rs"]
mod derived_file;
#[path = "../../../derive/macros/src/equations/mod.rs"]
mod equations;

libfuzzer_sys::fuzz_target!(|data: &[u8]| derived_file::check(data));
