//! Quantities: exact decimal scaling, ambiguous symbols, rejected texts.

use std::f64::consts::PI;

use crate::scene::dimension::Dimension;
use crate::scene::quantity::Quantity;
use crate::scene::unit::Unit;

#[track_caller]
fn check(text: &str, value: f64, unit: &str) {
    let quantity = Quantity::parse(text).unwrap();
    assert_eq!(quantity.value, value, "{text}");
    assert_eq!(quantity.dimension, Unit::parse(unit).unwrap().dimension, "{text}");
}

#[test]
fn decimal_factors_are_exact() {
    check("1.43 kN*m", 1430.0, "J");
    check("2890 kg*mm^2", 2.89e-3, "kg*m^2");
    check("740200 kg mm²", 0.7402, "kg*m^2");
    check("24 mm", 0.024, "m");
    check("20 kHz", 20e3, "1/s");
    check("1e-3 rad", 1e-3, "rad");
    check("2.5e3 N*m/rad", 2500.0, "N*m/rad");
    check("100 N.m/s", 100.0, "W");
    check("0.3 um", 0.3e-6, "m");
    check("7 g/cm^3", 7000.0, "kg/m^3");
    check("5 %", 0.05, "1");
    check("-.5e1ms", -5e-3, "s");
}

#[test]
fn other_factors_are_multiplied() {
    check("300 rpm", 300.0 * PI / 30.0, "rad/s");
    check("180 deg", PI, "rad");
    check("90°", PI / 2.0, "rad");
    check("2 rev/min", 4.0 * PI / 60.0, "rad/s");
    check("1.5 h", 5400.0, "s");
}

#[test]
fn symbols_are_read_whole_before_prefixes() {
    check("1 min", 60.0, "s");
    check("1 mm", 1e-3, "m");
    check("1 MN", 1e6, "N");
    check("1 mN", 1e-3, "N");
    check("1 kNm", 1e3, "N*m");
    check("1 mNm", 1e-3, "N*m");
    check("1 m N", 1.0, "N*m");
    check("1 m⁻¹·N", 1.0, "N/m");
    check("5 /s", 5.0, "Hz");
    check("5 1/s", 5.0, "Hz");
}

#[test]
fn errors_mark_the_wrong_part_of_a_quantity() {
    #[track_caller]
    fn at(text: &str, offending: &str) {
        let error = Quantity::parse(text).expect_err(text);
        assert_eq!(&text[error.span], offending, "{text}: {}", error.message);
    }
    at("ten N", "ten N");
    at("", "");
    at("1,5 mm", ",");
    at("10 N*m/rad*s", "s");
    at("10 N**m", "*");
    at("10 N*", "*");
    at("10 kg*m2", "2");
    at("10 kg*m^", "^");
    at("10 kg*m^99", "^99");
    at("10 furlong", "furlong");
    at("10 N-m", "-");
    at("10 N*µ²€", "µ");
}

#[test]
fn unknown_units_come_with_a_suggestion() {
    for (text, meant) in [
        ("KHz", "kHz"),
        ("RPM", "rpm"),
        ("degs", "deg"),
        ("Nmm", "N*mm"),
        ("Kg", "kg"),
        ("NM", "Nm or nm"),
        ("MHZ", "MHz or mHz"),
    ] {
        let error = Unit::parse(text).expect_err(text);
        assert!(error.help.contains(&format!("did you mean {meant}?")), "{text}: {}", error.help);
    }
}

#[test]
fn huge_exponents_do_not_panic() {
    assert_eq!(Quantity::parse("1e99999999999999999999 m").unwrap().value, f64::INFINITY);
    assert_eq!(Quantity::parse("1e-99999999999999999999 m").unwrap().value, 0.0);
}

#[test]
fn radians_are_ignored_if_mass_or_length_is_involved() {
    let dimension = |unit: &str| Unit::parse(unit).unwrap().dimension;
    assert!(dimension("N*m/rad").fits(dimension("N*m")));
    assert!(dimension("N*m").fits(dimension("N*m/rad")));
    assert!(!dimension("Hz").fits(dimension("rad/s")));
    assert!(!dimension("rpm").fits(dimension("Hz")));
    assert!(!dimension("deg").fits(Dimension::NONE));
}

#[test]
fn dimensions_are_described_by_name_or_by_base_units() {
    let describe = |unit: &str| Unit::parse(unit).unwrap().dimension.describe();
    assert_eq!(describe("N*m"), "a torque or energy");
    assert_eq!(describe("N*m/rad"), "a torque or energy");
    assert_eq!(describe("N^2/s"), "measured in kg^2*m^2/s^5");
}
