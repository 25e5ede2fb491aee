//! Numbers and tables as Markdown, and the parts of the README between markers.

use std::fmt::Write;

use anyhow::{Context, ensure};

/// A part of the README: its name and its text.
pub type Part = (&'static str, String);

/// `x` to `digits` significant digits, with a power of ten if it is below 1e-3 or from 1e5 on.
pub fn number(x: f64, digits: usize) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let text = format!("{x:.*e}", digits - 1);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    match exponent.parse::<i32>() {
        Ok(power @ -3..=4) => format!("{x:.*}", (digits as i32 - 1 - power).max(0) as usize),
        _ => format!("{mantissa}e{exponent}"),
    }
}

/// `x` to `decimals` decimals; zero without a sign.
pub fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.chars().all(|c| "0.".contains(c)) => zero.to_owned(),
        _ => text,
    }
}

/// The values that satisfy a condition, in words: `1 to 50`, `1, 5`, `none`, `all (1 to 500)`.
pub fn which(values: &[f64], holds: impl Fn(f64) -> bool) -> String {
    let good: Vec<usize> = (0..values.len()).filter(|i| holds(values[*i])).collect();
    let (Some(first), Some(last)) = (good.first(), good.last()) else { return "none".into() };
    let range = format!("{} to {}", values[*first], values[*last]);
    if good.len() == values.len() {
        return format!("all ({range})");
    }
    if last - first + 1 == good.len() && good.len() > 2 {
        return range;
    }
    good.iter().map(|i| values[*i].to_string()).collect::<Vec<_>>().join(", ")
}

/// A table as Markdown.
pub fn table(head: &[&str], rows: &[Vec<String>]) -> String {
    let mut out = format!("| {} |\n|{}\n", head.join(" | "), " --- |".repeat(head.len()));
    for row in rows {
        let _ = writeln!(out, "| {} |", row.join(" | "));
    }
    out
}

/// `text` with every part between its markers replaced.
///
/// # Errors
/// If a part has no markers, or if markers have no part.
pub fn fill(text: &str, parts: &[Part]) -> anyhow::Result<String> {
    const BEGIN: &str = "<!-- cargo xtask oh2005: ";
    const END: &str = "<!-- end -->";
    let mut out = text.to_owned();
    for (name, part) in parts {
        let begin = format!("{BEGIN}{name} -->\n");
        let from =
            out.find(&begin).with_context(|| format!("the README has no line `{}`", begin.trim()))? + begin.len();
        let length = out[from..].find(END).with_context(|| format!("part `{name}` of the README has no `{END}`"))?;
        out.replace_range(from..from + length, &format!("\n{part}\n"));
    }
    ensure!(
        out.matches(BEGIN).count() == parts.len(),
        "the README has markers of parts that this program does not make"
    );
    Ok(out)
}

/// The number of the first line in which two texts differ, and that line of each.
pub fn difference<'a>(old: &'a str, new: &'a str) -> Option<(usize, &'a str, &'a str)> {
    let mut lines = old.lines().map(Some).chain(std::iter::repeat(None)).zip(new.lines().map(Some));
    let at = lines.position(|(a, b)| a != b);
    let line = |text: &'a str, i: usize| text.lines().nth(i).unwrap_or("(nothing)");
    at.or((old != new).then_some(new.lines().count())).map(|i| (i + 1, line(old, i), line(new, i)))
}
