//! A case: what it proves, the number that it measures, and how large that number may be.

/// One promise, held to a number.
pub struct Case {
    /// Row of the catalogue, or `random`.
    pub row: &'static str,
    /// What is done.
    pub name: &'static str,
    /// What it shows where the number is within its tolerance.
    pub proves: &'static str,
    /// How large the number may be.
    pub tolerance: f64,
    /// Unit of the number and of its tolerance.
    pub unit: &'static str,
    /// Why that tolerance.
    pub reason: &'static str,
    /// The number; it may note on what it was measured.
    pub measure: fn(&mut String) -> f64,
}

/// The unit of what is counted: there must be none.
pub const WRONG: &str = "wrong";
/// Why nothing counted may be wrong.
pub const NONE: &str = "a decision or a bit is right or wrong";

/// The number of a case, and on what it was measured.
#[derive(Debug, Clone)]
pub struct Measured {
    pub value: f64,
    pub note: String,
}

/// Measures a case: it passes if the number is at most its tolerance. NaN is not.
pub fn check(case: &Case) -> (Measured, Result<(), String>) {
    let mut note = String::new();
    let value = (case.measure)(&mut note);
    let (unit, tolerance) = (case.unit, case.tolerance);
    println!("row {}, {}: {value:.3e} {unit}, at most {tolerance:e}. {note}", case.row, case.name);
    let verdict = match value <= tolerance {
        true => Ok(()),
        false => Err(format!("{value:e} {unit}, where at most {tolerance:e} is allowed ({}). {note}", case.reason)),
    };
    (Measured { value, note }, verdict)
}

/// The largest of some numbers; NaN if one of them is.
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |m, x| if x.is_nan() || x > m { x } else { m })
}

/// How many hold.
pub fn count(wrong: impl IntoIterator<Item = bool>) -> f64 {
    wrong.into_iter().filter(|wrong| *wrong).count() as f64
}
