//! Hostile input: files that are too long, too deep or have control characters, and paths that are no files.

use super::fixture::{SCENE, parse};
use crate::scene::Template;

#[test]
fn a_long_line_is_quoted_in_part() {
    for text in [format!("{SCENE}\nx = {}", "[".repeat(100_000)), format!("{SCENE}\nabout = {}", "1".repeat(200_000))] {
        let shown = parse(&text, &[]).expect_err("a mistake").render(100, false);
        assert!(shown.len() < 20_000, "{} bytes", shown.len());
    }
    let value = format!("parameters.T0={} N", "1".repeat(100_000));
    let shown = parse(SCENE, &[&value]).expect_err("a mistake").render(100, false);
    assert!(shown.len() < 20_000 && shown.contains("a part of line 1"), "{} bytes", shown.len());
}

/// The marked part is the mistake, after the line was cut.
#[test]
fn the_part_that_is_quoted_holds_the_mistake() {
    let text = SCENE.replace("zeta = 0.1", &format!("zeta = \"0.1 bananas\" # {}", "long ".repeat(200)));
    let shown = parse(&text, &[]).expect_err("a mistake").render(160, false);
    assert!(shown.contains("bananas") && shown.contains("a part of line 8"), "{shown}");
}

#[test]
fn many_mistakes_are_counted_but_not_all_shown() {
    let text = format!("{SCENE}\n[more]\n{}", (0..5000).map(|i| format!("zetta{i} = 1\n")).collect::<String>());
    let text = text.replace("[more]", "[parameters.more]").replace("[parameters.more]", "");
    let mistakes = parse(&text, &[]).expect_err("mistakes");
    assert!(mistakes.mistakes().len() <= 100 && mistakes.to_string().contains("of which 100 are shown"), "{mistakes}");
}

#[test]
fn control_characters_never_reach_the_terminal() {
    for text in [
        SCENE.replace("model = \"gear_pair\"", "model = \"gear\\u001b[31mpair\""),
        SCENE.replace("model = \"gear_pair\"", "model = \"gear\u{1b}[31mpair\""),
        SCENE.replace("zeta = 0.1", "\"ze\\u009bta\" = 0.1"),
    ] {
        let shown = parse(&text, &[]).expect_err("a mistake").render(100, false);
        assert!(!shown.contains(|c: char| c.is_control() && c != '\n'), "{shown:?}");
    }
}

#[test]
#[cfg(unix)]
fn pipes_folders_and_large_files_are_refused() {
    let root = tempfile::tempdir().unwrap();
    let fifo = root.path().join("fifo.toml");
    assert!(std::process::Command::new("mkfifo").arg(&fifo).status().unwrap().success());
    let big = root.path().join("big.toml");
    std::fs::File::create(&big).unwrap().set_len(17 << 20).unwrap();
    for (path, said) in [(fifo.as_path(), "a pipe or a device"), (root.path(), "a folder"), (&big, "at most 16 MB")] {
        let shown = Template::load(path, &[]).expect_err("refused").render(160, false);
        assert!(shown.contains(said), "{shown}");
    }
}
