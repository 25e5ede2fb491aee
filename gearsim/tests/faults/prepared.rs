//! A command, the folder before it, and the folder after it without a fault.

use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use crate::commands::Command;
use crate::state::{Files, files};

/// The program under test.
pub const PROGRAM: &str = env!("CARGO_BIN_EXE_gearsim");

/// A command, and what it starts from and makes.
pub struct Prepared {
    pub command: &'static Command,
    root: PathBuf,
    cases: AtomicUsize,
    /// The files before the command.
    pub old: Files,
    /// The files after it, without a fault.
    pub new: Files,
    /// Its duration without a fault.
    pub duration: Duration,
}

impl Prepared {
    /// Runs the command once without a fault, in the folder `root`.
    pub fn new(command: &'static Command, root: &Path) -> Prepared {
        let before = root.join("before");
        std::fs::create_dir(&before).unwrap();
        for words in command.before {
            succeed(words, &before);
        }
        let after = root.join("after");
        copy(&before, &after);
        let begin = Instant::now();
        succeed(command.words, &after);
        let duration = begin.elapsed();
        let (old, new) = (files(&before), files(&after));
        Prepared { command, root: root.to_owned(), cases: AtomicUsize::new(0), old, new, duration }
    }

    /// The path of a new folder for a case, which does not exist yet.
    pub fn place(&self) -> PathBuf {
        self.root.join(format!("case_{}", self.cases.fetch_add(1, Ordering::Relaxed)))
    }

    /// Copies the files before the command to the folder `to`.
    pub fn copy_to(&self, to: &Path) {
        copy(&self.root.join("before"), to);
    }

    /// Whether the command writes files.
    pub fn writes(&self) -> bool {
        self.old != self.new
    }
}

/// Runs the program in the folder `place`; it must succeed.
fn succeed(words: &[&str], place: &Path) {
    let output = std::process::Command::new(PROGRAM).args(words).current_dir(place).stdout(Stdio::null()).output();
    let output = output.unwrap();
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// Copies a folder with all in it. `to` may be there already.
fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap().map(Result::unwrap) {
        let to = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => copy(&entry.path(), &to),
            false => drop(std::fs::copy(entry.path(), to).unwrap()),
        }
    }
}
