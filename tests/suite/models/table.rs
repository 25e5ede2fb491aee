//! The table of published numbers beside ours; it changes only if a result does.

use std::fmt::Write;

use crate::published::{CASES, check};

/// Names the file that the table goes to.
const FILE: &str = "GEARSIM_PUBLISHED";

const HEAD: &str = "\
# Published numbers

Natural frequencies as published, and as they come out of the derived mass and stiffness matrices. Written by
`cargo xtask published` from a run; not to be edited. How often a frequency comes is in brackets.
";

/// Writes the table where it is asked for; only a whole one.
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
        add(format!("\nAllowed: {}. At most {worst:.1} of it is taken.", case.reason));
    }
    std::fs::write(&path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))
}

fn sentence(text: &str) -> String {
    text[..1].to_uppercase() + &text[1..]
}
