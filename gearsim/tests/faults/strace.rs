//! The system calls that a command makes for its files. `strace` finds them and makes them fail.

use std::collections::{BTreeSet, HashMap};
use std::process::Command;
use std::sync::LazyLock;

use crate::fault::Fault;
use crate::prepared::Prepared;

/// The calls that are traced. Calls with a question mark do not exist on all machines.
const TRACED: &str =
    "trace=write,openat,?rename,renameat,renameat2,fsync,fdatasync,?unlink,unlinkat,?mkdir,mkdirat,?rmdir";

/// A call.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Call {
    /// Its name.
    pub name: String,
    /// Its number among the calls of this name by its thread, from 1.
    pub ordinal: usize,
}

/// Whether `strace` can follow programs here.
static AVAILABLE: LazyLock<bool> = LazyLock::new(|| {
    let follows = Command::new("strace").args(["-f", "-qq", "-o", "/dev/null", "true"]).output();
    let follows = follows.is_ok_and(|output| output.status.success());
    let demanded = cfg!(target_os = "linux") && std::env::var_os("CI").is_some();
    assert!(follows || !demanded, "strace cannot follow programs: install it (Debian: apt-get install strace)");
    if !follows {
        crate::say("strace is not installed, or may not follow programs: the cases of calls that fail are skipped\n");
    }
    follows
});

/// The calls for files in the folder of a case, in their order, each once.
pub fn calls(prepared: &Prepared) -> Vec<Call> {
    if !prepared.writes() || !*AVAILABLE {
        return vec![];
    }
    let place = prepared.place();
    std::fs::create_dir(&place).unwrap();
    prepared.copy_to(&place);
    let log = place.with_extension("log");
    let mut fault = Fault { prefix: strace(TRACED, &log.display().to_string()), ..Fault::default() };
    fault.prefix.push("-y".into());
    let output = fault.run(prepared, &place);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let log = String::from_utf8_lossy(&std::fs::read(log).unwrap()).into_owned();
    parse(&log, &place.display().to_string())
}

/// The calls in a log that concern files below `place`.
fn parse(log: &str, place: &str) -> Vec<Call> {
    let (mut counts, mut seen, mut calls) = (HashMap::new(), BTreeSet::new(), vec![]);
    for line in log.lines() {
        let Some((thread, rest)) = line.split_once(' ') else { continue };
        let Some((name, arguments)) = rest.trim_start().split_once('(') else { continue };
        if name.starts_with(['<', '+', '-']) {
            continue;
        }
        let ordinal = counts.entry((thread.to_owned(), name.to_owned())).or_insert(0);
        *ordinal += 1;
        let call = Call { name: name.to_owned(), ordinal: *ordinal };
        if concerns(name, arguments, place) && seen.insert(call.clone()) {
            calls.push(call);
        }
    }
    calls
}

/// Whether a call changes files below `place`, where the program runs.
fn concerns(name: &str, arguments: &str, place: &str) -> bool {
    // A file is opened for reading without these flags.
    if name == "openat" && !["O_CREAT", "O_TMPFILE"].iter().any(|flag| arguments.contains(flag)) {
        return false;
    }
    let here = format!("AT_FDCWD<{place}>");
    let relative = arguments.contains(&here) && !arguments.contains("\"/");
    relative || name != "write" && arguments.contains("\"out") || arguments.replace(&here, "").contains(place)
}

/// A fault that `strace` makes at a call: `how` in its notation, `error=EIO:when=3`.
pub fn injecting(call: &Call, how: &str) -> Fault {
    let mut prefix = strace(&format!("trace={}", call.name), "/dev/null");
    prefix.push(format!("--inject={}:{how}", call.name));
    Fault { what: format!("{}:{how}", call.name), prefix, ..Fault::default() }
}

/// The words that start `strace`, with the filter that keeps other calls fast.
fn strace(trace: &str, log: &str) -> Vec<String> {
    ["strace", "-f", "-qq", "--seccomp-bpf", "-o", log, "-e", trace].map(str::to_owned).into()
}
