//! A fault, and a command that is run with it.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use crate::prepared::{PROGRAM, Prepared};

/// Where the standard output goes.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub enum Stdout {
    #[default]
    Null,
    /// A device that is full.
    Full,
    /// A pipe that is closed after the first line.
    Closed,
}

/// What is done to a command.
#[derive(Debug, Default)]
pub struct Fault {
    /// What it is, for messages.
    pub what: String,
    /// Words before those of the command: a program that sets a limit, or makes calls of the system fail.
    pub prefix: Vec<String>,
    /// Where the standard output goes.
    pub stdout: Stdout,
    /// The time after which the program is killed.
    pub killed_after: Option<Duration>,
    /// Size of the disk of the case [bytes]; without one, the case has no disk of its own.
    pub disk: Option<usize>,
    /// The words about the cause in the error message, if the program can print one. Without them the program may end in any way but
    /// a panic.
    pub says: Option<&'static str>,
    /// Whether the program succeeds or fails; without it, either is possible.
    pub succeeds: Option<bool>,
}

impl Fault {
    /// A command under limits that `setting` gives to the shell.
    pub fn limit(setting: &str) -> Fault {
        let shell = ["sh", "-c", &format!("{setting}; exec \"$@\""), "sh"].map(str::to_owned);
        Fault { what: setting.to_owned(), prefix: shell.into(), ..Fault::default() }
    }

    /// Runs the command with this fault in the folder `place`.
    pub fn run(&self, prepared: &Prepared, place: &Path) -> Output {
        let program = [PROGRAM].into_iter().chain(prepared.command.words.iter().copied());
        let words: Vec<&str> = self.prefix.iter().map(String::as_str).chain(program).collect();
        let mut command = Command::new(words[0]);
        command.args(&words[1..]).current_dir(place).stderr(Stdio::piped()).stdout(match self.stdout {
            Stdout::Null => Stdio::null(),
            Stdout::Full => std::fs::File::options().write(true).open("/dev/full").unwrap().into(),
            Stdout::Closed => Stdio::piped(),
        });
        // A user who sets this asks for a backtrace where an allocation fails.
        command.env_remove("RUST_BACKTRACE");
        let mut child = command.spawn().unwrap();
        if let Some(pipe) = child.stdout.take() {
            let _ = BufReader::new(pipe).read_line(&mut String::new());
        }
        if let Some(time) = self.killed_after {
            std::thread::sleep(time);
            child.kill().unwrap();
        }
        child.wait_with_output().unwrap()
    }
}
