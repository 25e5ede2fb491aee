//! Faults at system calls for files of the result: each call in turn fails, or the program is killed at it.

use crate::fault::Fault;
use crate::prepared::Prepared;
use crate::strace::{Call, calls, injecting};

/// The calls that fail, the error that each returns, and the words of the message about it.
const ERRORS: &[(&[&str], &str, &str)] = &[
    (&["write"], "ENOSPC", "no space left"),
    (&["openat", "mkdir", "mkdirat"], "EACCES", "permission denied"),
    (&["rename", "renameat", "renameat2", "unlink", "unlinkat", "rmdir"], "EIO", "Input/output error"),
    (&["fsync", "fdatasync"], "EIO", "Input/output error"),
];

/// The largest number of calls of one name that fail in turn.
const MOST: usize = 8;

/// Each call fails once, as on a disk that is freed again; or all writes from one on fail.
pub fn failing(prepared: &Prepared) -> Vec<Fault> {
    let calls = calls(prepared);
    let mut faults = vec![];
    for &(names, error, says) in ERRORS {
        for name in names {
            let all: Vec<&Call> = calls.iter().filter(|call| call.name == *name).collect();
            for call in spread(&all, MOST) {
                let once = format!("error={error}:when={}", call.ordinal);
                faults.push(Fault { says: Some(says), ..injecting(call, &once) });
            }
        }
    }
    let writes: Vec<&Call> = calls.iter().filter(|call| call.name == "write").collect();
    for call in spread(&writes, MOST) {
        let on = format!("error=ENOSPC:when={}+", call.ordinal);
        // The message is a write too, and fails. The message about a full disk is tested by `disk.rs`.
        faults.push(Fault { succeeds: Some(false), ..injecting(call, &on) });
    }
    faults
}

/// The program is killed at calls that change the folder, and at every tenth of all calls.
pub fn killed(prepared: &Prepared) -> Vec<Fault> {
    let calls = calls(prepared);
    let all: Vec<&Call> = calls.iter().collect();
    let changes = ["rename", "renameat", "renameat2", "unlink", "unlinkat", "rmdir", "mkdir"];
    let changes: Vec<&Call> = calls.iter().filter(|call| changes.contains(&&*call.name)).collect();
    let mut at = [spread(&all, 10), spread(&changes, 2 * MOST)].concat();
    at.sort();
    at.dedup();
    at.into_iter().map(|call| injecting(call, &format!("signal=KILL:when={}", call.ordinal))).collect()
}

/// At most `most` of some calls, evenly spread, the first and the last among them.
fn spread<'a>(calls: &[&'a Call], most: usize) -> Vec<&'a Call> {
    let count = calls.len().min(most);
    (0..count).map(|i| calls[i * (calls.len() - 1) / (count - 1).max(1)]).collect()
}
