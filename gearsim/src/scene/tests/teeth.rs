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

/// A law of a damaged tooth repeats after the teeth of its gear: whole pitches of its phase count, as a number and as an angle. They
/// decide which planet the tooth meets when.
#[test]
fn whole_pitches_of_a_phase_shift_a_damaged_tooth() {
    let steps = "steps = [{ value = \"1 N*m\", width = \"2 rad\" }, { value = \"2 N*m\" }]";
    let damage = "damage = [{ tooth = 1, of = 27, loss = 0.4 }]";
    let teeth = "parameters.N1=27";
    let origin = |phase: &str| with(&format!("{steps}\n{damage}\nphase = {phase}"), &[teeth]).unwrap().origin;
    assert_eq!(origin("9"), -9.0 * TAU);
    assert!((origin("\"3240 deg\"") + 9.0 * TAU).abs() < 1e-13);
    assert_eq!(origin("{ sun = 27, at = \"120 deg\" }"), 9.0 * TAU);
    assert_eq!(origin("{ sun = 27, at = \"240 deg\" }"), 18.0 * TAU);
    assert_eq!(origin("27"), 0.0);
    // Without damage a whole pitch is no shift.
    let healthy = |phase: &str| with(&format!("{steps}\nphase = {phase}"), &[]).unwrap().origin;
    assert_eq!([healthy("9"), healthy("{ sun = 27, at = \"120 deg\" }")], [0.0; 2]);
}

/// The law of damaged teeth equals a law over several pitches that is written out.
#[test]
fn a_stiffness_over_several_pitches_is_that_of_damaged_teeth() {
    let [low, high] = ["{ value = \"10 N*m\", width = \"1.73 rad\" }", "{ value = \"20 N*m\", width = \"W rad\" }"];
    let high = high.replace('W', &(TAU - 1.73).to_string());
    let damaged =
        with(&format!("steps = [{low}, {high}]\ndamage = [{{ tooth = 1, of = 2, loss = 0.5 }}]"), &["parameters.N1=2"])
            .unwrap();
    let [less, least] = [high.replace("20", "15"), low.replace("10", "5")];
    let written = with(&format!("pitches = 2\nsteps = [{low}, {less}, {least}, {less}]"), &[]).unwrap();
    assert_eq!((written.pitches, &written.steps[..3]), (2, &damaged.steps[..3]));
    assert!((written.steps[3].width - damaged.steps[3].width).abs() < 1e-14);
}

/// The value of a law at the phase `s`.
fn value(law: &Profile, s: f64) -> f64 {
    let mut x = (s - law.origin).rem_euclid(law.steps.iter().map(|step| step.width).sum());
    for (i, step) in law.steps.iter().enumerate() {
        if x <= step.width {
            return law.curves.get(i).map_or(step.value, |curve| curve.at(x)[0]);
        }
        x -= step.width;
    }
    f64::NAN
}

/// Each section of helical gears meets a damaged tooth at another phase. The law is the mean of the laws of the sections.
#[test]
fn a_damaged_tooth_of_helical_gears_is_that_of_all_sections() {
    let damage = "\ndamage = [{ tooth = 3, of = 24, loss = 0.4 }]\nmethod = \"energy\"\ncourse = \"curves\"";
    let helical = with(&format!("{TEETH}{damage}\nhelix_angle = \"20 deg\""), &[]).unwrap();
    let healthy = with(&format!("{TEETH}{}\nhelix_angle = \"20 deg\"", damage.replace("0.4", "0")), &[]).unwrap();
    assert_eq!([helical.pitches, healthy.pitches], [24, 24]);
    // The damaged pair is in contact over the contact ratio and the overlap: about 2.3 of 24 pitches. There the law is less, elsewhere the same.
    let place = |i: usize| i as f64 * TAU / 50.0;
    let lost: Vec<f64> = (0..24 * 50).map(|i| 1.0 - value(&helical, place(i)) / value(&healthy, place(i))).collect();
    let less = lost.iter().filter(|&&lost| lost > 1e-12).count() as f64 / 50.0;
    let contact =
        Gears { helix_angle: 20f64.to_radians(), ..Gears::standard([24.0, 96.0], 6.35e-3, 20f64.to_radians(), 7e-3) };
    let contact = contact.contact().unwrap();
    assert!((less - contact.ratio() - contact.overlap).abs() < 0.1, "{less}");
    assert!(lost.iter().all(|lost| (-1e-12..0.4 + 1e-12).contains(lost)));
    let mean = lost.iter().sum::<f64>() / lost.len() as f64;
    assert!((mean * 24.0 / 0.4 - 1.0).abs() < 0.1, "a tooth in 24 loses 0.4 of its part: {mean}");
}

/// A series or a table does not say where pairs enter contact. Damage is refused there.
#[test]
fn damage_in_a_series_or_table_is_refused() {
    let damage = "damage = [{ tooth = 1, of = 24, loss = 0.5 }]";
    let series = "mean = \"10 N*m\"\nharmonics = [{ order = 1, amplitude = \"1 N*m\" }]";
    let table = "table = [{ at = 0, value = \"10 N*m\" }, { at = \"3 rad\", value = \"12 N*m\" }]";
    for law in [series, table] {
        let message = with(&format!("{law}\n{damage}"), &[]).unwrap_err();
        assert!(message.contains("does not say where tooth pairs enter contact"), "{message}");
    }
    let several = "pitches = 2\nsteps = [{ value = \"1 N*m\", width = \"7 rad\" }, { value = \"2 N*m\" }]";
    assert!(with(&format!("{several}\n{damage}"), &[]).unwrap_err().contains("leave out damage or pitches"));
    assert!(with(&format!("pitches = 2\n{TEETH}"), &[]).unwrap_err().contains("has both pitches and teeth"));
    assert!(with(&format!("{TEETH}\nmethod = \"energy\"\ncourse = \"curves\"\n{damage}"), &[]).is_ok());
}
