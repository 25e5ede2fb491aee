//! One case: a command with a fault, what it says, what it leaves, and the same command again without the fault.

use std::path::Path;
use std::process::Output;

use crate::fault::Fault;
use crate::kinds::disk::Disk;
use crate::prepared::Prepared;
use crate::state::{State, files, is_leftover, state};

/// Runs a command with a fault in a folder of its own. Returns what the fault left. The error says which guarantee is broken.
pub fn run(prepared: &Prepared, fault: &Fault) -> Result<State, String> {
    let place = prepared.place();
    std::fs::create_dir(&place).unwrap();
    let disk = fault.disk.map(|size| Disk::mount(&place, size));
    prepared.copy_to(&place);
    let output = fault.run(prepared, &place);
    let left = state(prepared, &place)?;
    answers(fault, &output, left)?;
    if let Some(disk) = &disk {
        disk.enlarge();
    }
    again(prepared, &place, left)?;
    drop(disk);
    std::fs::remove_dir_all(&place).unwrap();
    Ok(left)
}

/// Checks the exit code and the message.
fn answers(fault: &Fault, output: &Output, left: State) -> Result<(), String> {
    let said = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
    let wrong = |what: &str| Err(format!("{what}, {}, the folder is {left:?}: {said}", output.status));
    // At the start of a thread the standard library itself panics if there is no memory for its signal stack.
    let at_thread_start = said.contains("failed to allocate an alternative stack");
    if !at_thread_start && (said.contains("panicked") || said.contains("stack backtrace")) {
        return wrong("it panicked");
    }
    if fault.succeeds.is_some_and(|succeeds| succeeds != output.status.success()) {
        return wrong("not the expected exit code");
    }
    if output.status.success() {
        return if left == State::New { Ok(()) } else { wrong("it reports success") };
    }
    match fault.says {
        Some(_) if output.status.code() != Some(1) => wrong("not the exit code of a result that cannot be written"),
        Some(cause) if !said.contains(cause) => wrong(&format!("the message does not say `{cause}`")),
        Some(_) if !["out", "stdout"].iter().any(|name| said.contains(name)) => wrong("the message names no file"),
        _ => Ok(()),
    }
}

/// Runs the command again without a fault, unless nothing was left that could be in its way.
fn again(prepared: &Prepared, place: &Path, left: State) -> Result<(), String> {
    if files(place) == prepared.old {
        return Ok(());
    }
    if left == State::New && !prepared.command.replaces {
        std::fs::remove_dir_all(place.join("out")).unwrap();
    }
    let output = Fault::default().run(prepared, place);
    if !output.status.success() {
        return Err(format!("run again, it fails: {}", String::from_utf8_lossy(&output.stderr)));
    }
    match state(prepared, place).map_err(|why| format!("run again: {why}"))? {
        State::New => {}
        other => return Err(format!("run again, the folder is {other:?}")),
    }
    match files(place).keys().find(|path| is_leftover(path)) {
        Some(path) => Err(format!("run again, {} is left over", path.display())),
        None => Ok(()),
    }
}
