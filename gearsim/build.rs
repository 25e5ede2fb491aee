//! Tells the program the commit it is built from, where git knows it.

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // Edits turn the commit into a dirty one.
    println!("cargo::rerun-if-changed=src");
    println!("cargo::rerun-if-env-changed=GEARSIM_COMMIT");
    if std::env::var_os("GEARSIM_COMMIT").is_some() {
        return; // whoever packages the program says so himself
    }
    for file in ["HEAD", "logs/HEAD"] {
        // A file that is not there would make every build run this again.
        if let Some(path) = git(&["rev-parse", "--git-path", file]).filter(|path| Path::new(path).exists()) {
            println!("cargo::rerun-if-changed={path}");
        }
    }
    if let Some(commit) = git(&["describe", "--always", "--dirty", "--abbrev=40", "--exclude=*"]) {
        println!("cargo::rustc-env=GEARSIM_COMMIT={commit}");
    }
}

/// What git answers; `None` where there is no git, or nothing that it knows.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).env("GIT_OPTIONAL_LOCKS", "0").output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?.trim().to_owned();
    (output.status.success() && !text.is_empty()).then_some(text)
}
