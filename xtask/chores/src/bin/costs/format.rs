//! Numbers as text, with units.

/// The exponent h of a growth x ~ n^h between two points.
pub fn exponent(n: [usize; 2], x: [f64; 2]) -> String {
    format!("{:.2}", (x[1] / x[0]).ln() / (n[1] as f64 / n[0] as f64).ln())
}

/// A time [s].
pub fn time(seconds: f64) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "us")];
    let unit = units.into_iter().find(|(scale, _)| seconds >= *scale);
    let (scale, unit) = unit.unwrap_or((1e-9, "ns"));
    format!("{} {unit}", digits(seconds / scale))
}

/// A size [bytes].
pub fn memory(bytes: f64) -> String {
    if bytes < 1e6 { format!("{} kB", digits(bytes / 1e3)) } else { format!("{} MB", digits(bytes / 1e6)) }
}

/// To three significant digits, for numbers from 1 to 1000.
fn digits(x: f64) -> String {
    if x >= 100.0 {
        format!("{x:.0}")
    } else if x >= 10.0 {
        format!("{x:.1}")
    } else {
        format!("{x:.2}")
    }
}
