//! Transmission errors in scenes: meaning of their keys, and messages for mistakes.

use std::f64::consts::TAU;

use super::fixture::{SCENE, parse};
use crate::profile::{Curve, Profile};

/// The transmission error of the scene with the effect and with the keys `law` in `[laws.e]`; the messages if it has mistakes.
fn with(law: &str, overrides: &[&str]) -> Result<Profile, String> {
    let text = SCENE.replace("\"damping\",", "\"transmission_error\",") + "\n[laws.e]\n" + law;
    let scene = parse(&text, overrides).map_err(|errors| errors.render(100, false))?;
    assert_eq!(scene.present().map(|(law, _)| law.name).collect::<Vec<_>>(), ["k", "e"]);
    Ok(scene.laws[1].clone())
}

#[test]
fn pitch_errors_are_levels_of_one_pitch_each() {
    let law = with("pitch_errors = [\"0 rad\", \"-2e-4 rad\", \"0.01 deg\"]\nphase = 1.25", &[]).unwrap();
    let levels: Vec<f64> = law.steps.iter().map(|step| step.value).collect();
    assert_eq!((levels, law.pitches), (vec![0.0, -2e-4, 0.01f64.to_radians()], 3));
    assert!(law.steps.iter().all(|step| step.width == TAU) && law.origin == -1.25 * TAU);
}

#[test]
fn steps_series_and_tables_cover_the_given_number_of_pitches() {
    let steps = "pitches = 2\nsteps = [{ value = \"-1 rad\", width = \"7 rad\" }, { value = \"1 rad\" }]";
    let steps = with(steps, &[]).unwrap();
    assert_eq!((steps.steps[1].width, steps.pitches), (2.0 * TAU - 7.0, 2));
    let series = with("pitches = 24\nharmonics = [{ order = 24, amplitude = \"1 rad\" }]", &[]).unwrap();
    let wave = Curve::Fourier { mean: 0.0, harmonics: vec![(24.0, 1.0, 0.0)], period: 24.0 * TAU };
    assert_eq!((&series.curves[..], series.pitches), (&[wave][..], 24));
    let table = "pitches = 3\ntable = [{ at = 0, value = 0 }, { at = \"9 rad\", value = \"1 rad\" }, { at = \"18 rad\", value = 0 }]";
    let table = with(table, &[]).unwrap();
    let width: f64 = table.steps.iter().map(|step| step.width).sum();
    assert!((width - 3.0 * TAU).abs() < 1e-13);
    let ramped = with("pitch_errors = [0, \"1 rad\"]\nramp = \"0.1 rad\"", &[]).unwrap();
    assert_eq!((ramped.pitches, ramped.steps_only()), (2, false));
}

#[test]
fn messages_name_the_mistake() {
    let steps = "steps = [{ value = \"1 rad\" }]";
    let cases = [
        ("", "lacks `steps`"),
        ("pitches = 1.5\nsteps = []", "`laws.e.pitches` must be a whole number"),
        ("pitches = 0\nsteps = []", "`laws.e.pitches` must be a whole number"),
        ("pitch_errors = []", "has 0 errors"),
        ("pitch_errors = 3", "must be an array"),
        ("pitch_errors = [\"1 um\"]", "is an angle, but"),
        ("pitch_errors = [0]\npitches = 1", "has both pitches and pitch_errors"),
        ("pitch_errors = [0]\nsteps = []", "has both steps and pitch_errors"),
        ("pitches = 2\nsteps = [{ value = 0, width = \"1 rad\" }]", "the pitches are 12.566"),
        ("teeth = [24, 96]", "has no `teeth`"),
    ];
    for (law, message) in cases {
        let text = with(law, &[]).expect_err(law);
        assert!(text.contains(message), "{law}: {text}");
    }
    let text = with(steps, &["effects=[\"transmission_error\"]"]).expect_err("a phase at rest");
    assert!(text.contains("`transmission_error` needs `stiffness_step`"), "{text}");
}

#[test]
fn mistakes_point_to_their_places() {
    let lacking = SCENE.replace("\"damping\",", "\"transmission_error\",");
    let render = |text: &str| parse(text, &[]).expect_err(text).render(100, false);
    insta::assert_snapshot!(render(&lacking));
    insta::assert_snapshot!(render(&format!(
        "{lacking}\n[laws.e]\npitch_errors = [\"0 rad\", \"3 um\"]\npitches = 2\n"
    )));
    insta::assert_snapshot!(render(&format!("{lacking}\n[laws.e]\npitches = 2.5\nteeth = [24, 96]\n")));
}
