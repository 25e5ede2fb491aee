//! A case: what it proves, the number that it measures, and the largest allowed number.

/// One promise, tested by a number.
pub struct Case {
    /// Number of the kind of difficulty, or `random`.
    pub row: &'static str,
    /// Description of the case.
    pub name: &'static str,
    /// What it proves if the number is within the tolerance.
    pub proves: &'static str,
    /// The largest allowed number.
    pub tolerance: f64,
    /// Unit of the number and of the tolerance.
    pub unit: &'static str,
    /// Why this tolerance is right.
    pub reason: &'static str,
    /// Measures the number; may write a note on its sample.
    pub measure: fn(&mut String) -> f64,
}

/// The unit of a count of wrong results; it must be 0.
pub const WRONG: &str = "wrong";
/// The reason why such a count must be 0.
pub const NONE: &str = "a decision or a bit is right or wrong";

/// The number of a case, and a note on its sample.
#[derive(Debug, Clone)]
pub struct Measured {
    pub value: f64,
    pub note: String,
}

/// Measures a case. It passes if the number is at most the tolerance; NaN fails.
pub fn check(case: &Case) -> (Measured, Result<(), String>) {
    let mut note = String::new();
    let value = (case.measure)(&mut note);
    let (unit, tolerance) = (case.unit, case.tolerance);
    println!("row {}, {}: {value:.3e} {unit}, at most {tolerance:e}. {note}", case.row, case.name);
    let verdict = match value <= tolerance {
        true => Ok(()),
        false => Err(format!("{value:e} {unit}, but at most {tolerance:e} is allowed ({}). {note}", case.reason)),
    };
    (Measured { value, note }, verdict)
}

/// The largest of some numbers, at least 0; NaN if one of them is NaN.
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |m, x| if x.is_nan() || x > m { x } else { m })
}

/// The number of `true` values.
pub fn count(wrong: impl IntoIterator<Item = bool>) -> f64 {
    wrong.into_iter().filter(|wrong| *wrong).count() as f64
}
