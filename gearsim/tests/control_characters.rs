//! Control characters of a scene are printed as visible text.

use std::process::Command;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/oh2005/energy_300rpm.toml");

#[test]
fn control_characters_of_a_scene_are_shown_and_not_sent() {
    let root = tempfile::tempdir().unwrap();
    let path = root.path().join("scene.toml");
    let text = std::fs::read_to_string(SCENE).unwrap();
    let begin = text.find("about = ").unwrap();
    let end = begin + text[begin..].find('\n').unwrap();
    let evil = "about = \"red \\u001b[31m, \\u009b31m, \\r over\"";
    std::fs::write(&path, format!("{}{evil}{}", &text[..begin], &text[end..])).unwrap();
    let out = root.path().join("out").display().to_string();
    let plots = "output.plots=[]";
    let mut run = Command::new(env!("CARGO_BIN_EXE_gearsim"));
    let done = run.arg("run").arg(path).args(["--out", &out, "--set", plots]).output().unwrap();
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(done.status.success() && text.contains("red \\u{1b}[31m"), "{text:?}");
    assert!(!text.contains(|c: char| c.is_control() && c != '\n'), "{text:?}");
}
