//! The entry point of libFuzzer to `bodies/derived_file.rs`.
#![no_main]

#[path = "../bodies/derived_file.rs"]
mod derived_file;
#[path = "../../../derive/macros/src/equations/mod.rs"]
mod equations;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    derived_file::check(data);
    // proc-macro2 keeps the text of everything it has parsed: 2 GiB after 170,000 cases.
    proc_macro2::extra::invalidate_current_thread_spans();
});
