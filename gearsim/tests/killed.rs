//! The program, killed at every tenth of its run or by a limit on the size of files: its folder holds the earlier run, whole, or the new
//! one, whole, or says that it is incomplete, and every file in it can be read. And the program before a full standard output.

#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use gearsim::output::{MARKER, Summary, parquet};

const OLD: [&str; 4] = ["--csv", "-q", "--set", "run.t_end=5 ms"];
const NEW: [&str; 5] = ["-q", "--set", "output.plots=[]", "--set", "output.rate=2 MHz"];

fn scene() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/oh2005/energy_300rpm.toml")
}

/// `gearsim run` of the scene into `out`.
fn run(out: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gearsim"));
    command.arg("run").arg(scene()).arg("--out").arg(out).args(more).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Checks the folder of a run that was killed while it replaced another one. Returns whether the new run is there.
fn check(folder: &Path, what: &str) -> bool {
    let visible: Vec<_> = names(folder).into_iter().filter(|name| !name.starts_with('.')).collect();
    if visible.iter().any(|name| name == MARKER) {
        return false;
    }
    let json =
        std::fs::read(folder.join("summary.json")).unwrap_or_else(|error| panic!("{what}: {error}, {visible:?}"));
    let summary: Summary = serde_json::from_slice(&json).unwrap();
    let mut expected = summary.files.clone();
    expected.push("summary.json".into());
    expected.sort();
    assert_eq!(visible, expected, "{what}");
    let (_, pairs) = parquet::read(&folder.join("trajectory.parquet")).unwrap();
    let hash = pairs.iter().find(|(name, _)| name == "scene_sha256").map(|(_, hash)| hash.as_str());
    assert_eq!(hash, Some(summary.provenance.scene_sha256.as_str()), "{what}: files of two runs");
    !summary.files.iter().any(|name| name == "trajectory.csv")
}

/// A folder with the old run, and the duration of the new one.
fn old(root: &Path) -> (PathBuf, Duration) {
    let (old, new) = (root.join("old"), root.join("new"));
    assert!(run(&old, &OLD).status().unwrap().success());
    let begin = Instant::now();
    assert!(run(&new, &NEW).status().unwrap().success());
    (old, begin.elapsed())
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir(to).unwrap();
    for name in names(from) {
        std::fs::copy(from.join(&name), to.join(&name)).unwrap();
    }
}

#[test]
fn a_run_killed_at_every_tenth_leaves_one_whole_result() {
    let root = tempfile::tempdir().unwrap();
    let (old, duration) = old(root.path());
    let mut leftovers = 0;
    for (tenth, signal) in (1..=10).flat_map(|tenth| [(tenth, "-TERM"), (tenth, "-KILL")]) {
        let folder = root.path().join(format!("{tenth}{signal}"));
        copy(&old, &folder);
        let mut child = run(&folder, &NEW).spawn().unwrap();
        std::thread::sleep(duration * tenth / 10);
        let _ = Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status();
        child.wait().unwrap();
        check(&folder, &format!("{tenth} tenths, {signal}"));
        leftovers += usize::from(names(&folder).iter().any(|name| name.starts_with(".gearsim-")));
        assert!(run(&folder, &NEW).status().unwrap().success());
        assert!(check(&folder, "run again"));
        assert_eq!(names(&folder), ["lines.csv", "summary.json", "trajectory.parquet"]);
    }
    println!("{leftovers} of 20 kills left a temporary folder");
}

/// The kernel ends a program that writes more than `ulimit -f` allows, in the middle of a file.
#[test]
fn a_run_ended_by_a_limit_on_files_leaves_the_earlier_result() {
    let root = tempfile::tempdir().unwrap();
    let (old, _) = old(root.path());
    for blocks in [0, 1, 20, 200, 2000] {
        let folder = root.path().join(format!("{blocks}"));
        copy(&old, &folder);
        let command = run(&folder, &NEW);
        let mut limited = Command::new("sh");
        limited.args(["-c", &format!("ulimit -f {blocks}; exec \"$@\""), "sh"]).arg(command.get_program());
        let status = limited.args(command.get_args()).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
        assert!(!status.success(), "{blocks} blocks");
        assert!(!check(&folder, &format!("{blocks} blocks")), "{blocks} blocks: the new run cannot be whole");
    }
}

fn output(arguments: &[&str], stdout: Stdio) -> Output {
    let child =
        Command::new(env!("CARGO_BIN_EXE_gearsim")).args(arguments).stdout(stdout).stderr(Stdio::piped()).spawn();
    child.unwrap().wait_with_output().unwrap()
}

#[test]
fn what_cannot_be_printed_is_a_failure() {
    for arguments in [&["models"][..], &["models", "gear_pair"], &["--help"]] {
        let full = || std::fs::File::options().write(true).open("/dev/full");
        let Ok(full) = full() else { return };
        let done = output(arguments, full.into());
        assert_eq!(done.status.code(), Some(1), "{arguments:?}");
        assert!(String::from_utf8_lossy(&done.stderr).contains("cannot write to stdout"), "{arguments:?}");
    }
}

#[test]
fn control_characters_of_a_scene_are_shown_and_not_sent() {
    let root = tempfile::tempdir().unwrap();
    let path = root.path().join("scene.toml");
    let text = std::fs::read_to_string(scene()).unwrap();
    let begin = text.find("about = ").unwrap();
    let end = begin + text[begin..].find('\n').unwrap();
    let evil = "about = \"red \\u001b[31m, \\u009b31m, \\r over\"";
    std::fs::write(&path, format!("{}{evil}{}", &text[..begin], &text[end..])).unwrap();
    let out = root.path().join("out").display().to_string();
    let plots = "output.plots=[]";
    let done = output(&["run", path.to_str().unwrap(), "--out", &out, "--set", plots], Stdio::piped());
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(done.status.success() && text.contains("red \\u{1b}[31m"), "{text:?}");
    assert!(!text.contains(|c: char| c.is_control() && c != '\n'), "{text:?}");
}
