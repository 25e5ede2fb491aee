//! The table of published and computed numbers. It changes only if a result changes.

use std::fmt::Write;

use crate::published::{CASES, check};

/// Environment variable with the path of the file to write.
const FILE: &str = "GEARSIM_PUBLISHED";

const HEAD: &str = "\
# Published numbers

Natural frequencies as published, and as computed from the derived mass and stiffness matrices. `cargo xtask published` writes
this file from a run; do not edit it. The multiplicity of a frequency is in brackets.
";

/// Writes the table if the environment variable is set and every case passes.
pub fn write() -> Result<(), String> {
    let Some(path) = std::env::var_os(FILE) else { return Ok(()) };
    let mut text = HEAD.to_string();
    for case in CASES {
        let (worst, ours) = check(case)?;
        let mut add = |line: String| writeln!(text, "{line}").expect("a string takes any text");
        add(format!("\n## {}\n\n{}. {}.\n", sentence(case.what), case.source, sentence(case.input)));
        add("| published [Hz] | ours [Hz] | difference | allowed |\n| --- | --- | --- | --- |".into());
        let mut at = 0;
        for &(f, times, tolerance) in case.printed {
            let same = &ours[at..at + times];
            at += times;
            let found = same.iter().fold(0.0, |sum, f| sum + f) / times as f64;
            let difference = if f > 0.0 { format!("{:.0e}", (found - f).abs() / f) } else { "-".into() };
            let times = if times > 1 { format!(" (x{times})") } else { String::new() };
            add(format!("| {f}{times} | {found:.3} | {difference} | {tolerance:.0e} |"));
        }
        add(format!("\nAllowed: {}. The largest difference is {worst:.1} of the allowed one.", case.reason));
    }
    std::fs::write(&path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))
}

fn sentence(text: &str) -> String {
    text[..1].to_uppercase() + &text[1..]
}
