//! Numbers for people, with few digits.

/// `x` with four significant digits: as a decimal number from 1e-3 to below 1e6, else with an exponent.
pub(crate) fn short(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return format!("{x}");
    }
    let text = format!("{x:.3e}");
    let Some((digits, exponent)) = text.split_once('e') else {
        return text;
    };
    match exponent.parse::<i32>() {
        Ok(power @ -3..=5) => trim(&format!("{x:.*}", (3 - power).max(0) as usize)),
        _ => format!("{}e{exponent}", trim(digits)),
    }
}

/// A time [s] in ns, µs, ms, s or min, with one or two digits.
pub(crate) fn time(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        s if s < 1e-6 => (1e9, "ns"),
        s if s < 1e-3 => (1e6, "µs"),
        s if s < 1.0 => (1e3, "ms"),
        s if s < 600.0 => (1.0, "s"),
        _ => (1.0 / 60.0, "min"),
    };
    let x = seconds * scale;
    format!("{x:.*} {unit}", if x < 9.95 { 1 } else { 0 })
}

/// `text` without trailing zeros after the decimal point.
fn trim(text: &str) -> String {
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    }
}

#[test]
fn numbers_and_times_have_few_digits() {
    let cases = [(0.0, "0"), (0.1, "0.1"), (1.0 / 3.0, "0.3333"), (125.66371, "125.7"), (123456.0, "123456")];
    for (x, text) in cases.into_iter().chain([(-2.5e-9, "-2.5e-9"), (0.00012, "1.2e-4"), (f64::NAN, "NaN")]) {
        assert_eq!(short(x), text);
    }
    assert_eq!([time(3.2e-8), time(0.0042), time(3600.0)], ["32 ns", "4.2 ms", "60 min"]);
}
