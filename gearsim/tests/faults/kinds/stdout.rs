//! The standard output is full, or closed after the first line.

use crate::fault::{Fault, Stdout};
use crate::prepared::Prepared;

pub fn faults(_: &Prepared) -> Vec<Fault> {
    let full = Fault {
        what: "the standard output is full".into(),
        stdout: Stdout::Full,
        says: Some("cannot write to stdout: No space left on device"),
        succeeds: Some(false),
        ..Fault::default()
    };
    let closed =
        Fault { what: "the pipe is closed".into(), stdout: Stdout::Closed, succeeds: Some(true), ..Fault::default() };
    let full_exists = std::path::Path::new("/dev/full").exists();
    full_exists.then_some(full).into_iter().chain([closed]).collect()
}
