//! The table of published and computed numbers. It changes only if a result changes.

use std::fmt::Write;

use crate::published::{CASES, check};
use crate::response_curve;

/// Environment variable with the path of the file to write.
const FILE: &str = "GEARSIM_PUBLISHED";

const HEAD: &str = "\
# Published numbers

Natural frequencies as published, and as computed from the derived mass and stiffness matrices; then a response curve with contact loss.
`cargo xtask published` writes this file from a run; do not edit it. The multiplicity of a frequency is in brackets.
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
    response(&mut text)?;
    std::fs::write(&path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))
}

const CURVE: &str = "
## Response of a spur gear pair with backlash

Kahraman & Singh (1990), J. Sound Vib. 142(1), 49-75, with the describing functions of Comparin & Singh (1989), J. Sound Vib. 134(2), 259-290.
Fm = 0.1, Fah = 0.05, zeta = 0.05; scene `models/scenes/train_kahraman_singh.toml`, its plot `models/scenes/plots/train_kahraman_singh.png`. W is the mesh
frequency over the natural frequency; amplitudes are those of the transmission error, in halves of the backlash. The published curve is the
closed form of the harmonic balance. The papers themselves were not at hand: the formula is written from the method, a balance of the mean and of the
first harmonic; the parameters are chosen here; no points were read from a printed figure. Beside it is the same equation integrated by a program that
shares no code with gearsim (tests/suite/models/response_curve.rs).

| what | published formula | integrated | ours | ours from the formula | allowed | ours from the integration | allowed |
| --- | --- | --- | --- | --- | --- | --- | --- |
";
const CURVE_END: &str = "
The balance has one harmonic. With contact lost for half of a period, the harmonics that it neglects make its lower jump 4 % too low and its
amplitudes up to 6 % too small (those of the deflection q, 3 %), as the integration shows too; onset and end of contact loss are exact in the
formula. Jumps are known to half a step of the sweep, 0.0005 and 0.001. The measured time of a point is no whole number of periods, which changes an
amplitude by up to 0.5 %.
";

/// Adds the response curve.
fn response(text: &mut String) -> Result<(), String> {
    text.push_str(CURVE);
    for response_curve::Row { what, published, integrated, ours, allowed } in response_curve::rows()? {
        let off = |from: f64| (ours / from - 1.0).abs();
        let line = format!(
            "| {what} | {published:.4} | {integrated:.4} | {ours:.4} | {:.1e} | {:.0e} | {:.1e} | {:.0e} |",
            off(published),
            allowed[0],
            off(integrated),
            allowed[1]
        );
        writeln!(text, "{line}").expect("a string takes any text");
    }
    text.push_str(CURVE_END);
    Ok(())
}

fn sentence(text: &str) -> String {
    text[..1].to_uppercase() + &text[1..]
}
