//! Laws computed from teeth, and phases of laws.

use std::f64::consts::TAU;

use super::fixture::{SCENE, parse};
use crate::gear::{Gears, Iso6336};
use crate::profile::Profile;

const TEETH: &str = r#"teeth = [24, 96]
module = "6.35 mm"
face_width = "7 mm""#;

fn with(law: &str, overrides: &[&str]) -> Result<Profile, String> {
    let begin = SCENE.find("steps = [").unwrap();
    let end = SCENE.find("[start]").unwrap();
    let text = format!("{}{law}\n\n{}", &SCENE[..begin], &SCENE[end..]);
    parse(&text, overrides).map(|scene| scene.laws[0].clone()).map_err(|e| e.render(160, false))
}

/// The gears of Oh, Grosh & Barber (2005) give the widths of the paper; k = 2 kt h², with the base radius per tooth h = m cos(alpha)/2.
#[test]
fn teeth_give_widths_and_stiffness_of_a_gear_pair() {
    let law = with(TEETH, &[]).unwrap();
    let [one, two] = law.steps[..] else { panic!("{law:?}") };
    assert!((one.width - 1.728).abs() < 1e-3 && (one.width + two.width - TAU).abs() < 1e-14);
    let h = 6.35e-3 * 20f64.to_radians().cos() / 2.0;
    let gears = Gears::standard([24.0, 96.0], 6.35e-3, 20f64.to_radians(), 7e-3);
    let kt = Iso6336::of(&gears, None).unwrap().single * 7e-3;
    assert!((one.value / (2.0 * kt * h * h) - 1.0).abs() < 1e-14, "{}", one.value);
    assert!((two.value / one.value - 1.75).abs() < 1e-14);
    // The paper's 1.43 kN m would need a face width of 5.8 mm; its inertias imply about 7 mm.
    assert!((one.value - 1724.0).abs() < 2.0, "{}", one.value);
}

/// The law is that of gears with the same data set in Rust.
#[test]
fn every_key_of_teeth_is_read() {
    let keys = r#"
pressure_angle = "25 deg"
addendum = [0.9, 1.0]
dedendum = 1.2
fillet = 0.3
profile_shift = [0.2, 0.1]
young = "103 GPa"
poisson = [0.25, 0.3]
line_load = "50 N/mm"
"#;
    let law = with(&format!("{TEETH}{keys}"), &[]).unwrap();
    let mut gears = Gears::standard([24.0, 96.0], 6.35e-3, 25f64.to_radians(), 7e-3);
    gears.addendum = [0.9, 1.0];
    gears.dedendum = [1.2; 2];
    gears.profile_shift = [0.2, 0.1];
    gears.material.iter_mut().for_each(|material| material.young = 103e9);
    let kt = Iso6336::of(&gears, Some(50e3)).unwrap().single * 7e-3;
    let h = 6.35e-3 * 25f64.to_radians().cos() / 2.0;
    assert!((law.steps[0].value / (2.0 * kt * h * h) - 1.0).abs() < 1e-14);
    let energy = with(&format!("{TEETH}{keys}"), &["laws.k.line_load=1 N/mm", "laws.k.method=\"energy\""]);
    assert!(energy.unwrap_err().contains("has no effect with the method"));
    let curves =
        with(&format!("{TEETH}\nmethod = \"energy\"\ncourse = \"curves\"\nbore = [\"60 mm\", \"200 mm\"]"), &[])
            .unwrap();
    assert!(!curves.steps_only() && curves.steps.len() == 8);
    let ramped = with(&format!("{TEETH}\nramp = \"0.01 rad\""), &[]).unwrap();
    assert!(!ramped.steps_only() && ramped.origin == with(TEETH, &[]).unwrap().origin);
}

/// Helical teeth: ramps about the mean c_gamma b, with the base radius per tooth in the transverse plane.
#[test]
fn helical_teeth_give_ramps() {
    let law = with(&format!("{TEETH}\nhelix_angle = \"12 deg\""), &[]).unwrap();
    let gears =
        Gears { helix_angle: 12f64.to_radians(), ..Gears::standard([24.0, 96.0], 6.35e-3, 20f64.to_radians(), 7e-3) };
    let (mean, h) = (Iso6336::of(&gears, None).unwrap().mean * 7e-3, gears.contact().unwrap().base[0] / 24.0);
    assert!(!law.steps_only() && (law.mean() / (2.0 * mean * h * h) - 1.0).abs() < 1e-12);
    let energy = with(&format!("{TEETH}\nhelix_angle = \"12 deg\""), &["laws.k.method=\"energy\""]).unwrap();
    assert!(!energy.steps_only() && (energy.mean() / law.mean() - 1.0).abs() < 0.2);
    let shown = with(&format!("{TEETH}\nhelix_angle = \"12 deg\""), &["laws.k.helix_angle=50 deg"]).unwrap_err();
    assert!(shown.contains("between 0 and 45 deg"), "{shown}");
}

#[test]
fn messages_name_the_mistake() {
    let cases = [
        ("laws.k.teeth=[24]", "has 1 numbers"),
        ("laws.k.teeth=[24.5, 96]", "must be a whole number"),
        ("laws.k.teeth=[6, 96]", "below its base circle"),
        ("laws.k.module=6.35", "give a unit"),
        ("laws.k.module=0 mm", "must lie between 0.01 and 100 mm"),
        ("laws.k.pressure_angle=60 deg", "between 5 and 45 deg"),
        ("laws.k.profile_shift=[0, 0.2]", "smaller profile shift"),
        ("laws.k.addendum=[1, 2, 3]", "not two gears"),
        ("laws.k.method=\"iso\"", "there is no method `iso`"),
        ("laws.k.course=\"curves\"", "no curves between the steps"),
        ("laws.k.internal=1", "true or false"),
        ("laws.k.steps=[{ value = \"1 N*m\" }]", "has both steps and teeth"),
        ("laws.k.modul=1 mm", "did you mean `module`"),
        ("laws.k.phase=1 m", "is an angle, but"),
        ("laws.k.phase=[1]", "must be a phase"),
        ("laws.k.phase={ at = \"1 rad\" }", "must have either `sun` or `ring`"),
        ("laws.k.phase={ sun = 27 }", "lacks `at`"),
        ("laws.k.phase={ sun = 27.5, at = 0 }", "must be a whole number"),
        ("laws.k.phase={ sun = 27, planet = 36, at = 0 }", "goes with `ring`"),
    ];
    for (change, said) in cases {
        let shown = with(TEETH, &[change]).expect_err(change);
        assert!(shown.contains(said), "{change}: {shown}");
    }
    let lacking = with("teeth = [24, 96]", &[]).unwrap_err();
    assert!(lacking.contains("lacks `module` and `face_width`"), "{lacking}");
}

/// k(s) = k0(s + phase): the first level begins earlier by the phase.
#[test]
fn a_phase_shifts_the_origin_of_a_law() {
    let origin =
        |phase: &str| with(&format!("steps = [{{ value = \"1 N*m\" }}]\nphase = {phase}"), &[]).unwrap().origin;
    assert_eq!(origin("0.25"), -0.25 * TAU);
    assert_eq!(origin("\"25 %\""), -0.25 * TAU);
    assert_eq!(origin("3"), 0.0);
    assert!((origin("\"90 deg\"") + 0.25 * TAU).abs() < 1e-15);
    // Planets that fit: sun and ring give the same phase; two thirds of a pitch are exact to the last bit.
    let third = origin("{ ring = 98, at = \"120 deg\" }");
    assert_eq!(third, -(2.0 / 3.0) * TAU);
    let of_sun: f64 = origin("{ sun = 28, at = \"120 deg\" }");
    assert!(((third - of_sun).rem_euclid(TAU)).min(TAU - (third - of_sun).rem_euclid(TAU)) < 1e-14, "{third} {of_sun}");
    assert_eq!(origin("{ ring = 99, at = \"120 deg\" }"), 0.0);
    // The two meshes of one planet differ by half a pitch if the planet has an even number of teeth.
    assert_eq!(origin("{ ring = 99, at = 0, planet = 36 }").abs(), 0.5 * TAU);
    assert_eq!(origin("{ ring = 99, at = 0, planet = 35 }"), 0.0);
}
