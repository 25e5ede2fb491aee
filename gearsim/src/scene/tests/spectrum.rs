//! `[output] spectrum`: its values, the references of levels, and its mistakes.

use super::fixture::{SCENE, parse};
use crate::scene::{Spectrum, SpectrumKind};

fn read(table: &str) -> Result<Spectrum, String> {
    let scene = parse(SCENE, &[&format!("output.spectrum={table}")]);
    scene.map(|scene| scene.output.spectrum).map_err(|mistakes| mistakes.render(100, false))
}

#[test]
fn a_scene_chooses_signals_and_scale() {
    assert_eq!(parse(SCENE, &[]).unwrap().output.spectrum, Spectrum::DEFAULT);
    let given = r#"{ of = ["phi"], kind = "rms", scale = "dB", reference = ["2 N", "1 mrad"], from = "20 ms" }"#;
    let spectrum = read(given).unwrap();
    assert_eq!((&spectrum.of[..], spectrum.kind, spectrum.decibels), (&["phi"][..], SpectrumKind::Rms, true));
    assert!((spectrum.from - 0.02).abs() < 1e-15);
    assert_eq!(spectrum.reference("N"), ("2 N".into(), 2.0));
    assert_eq!(spectrum.reference("rad"), ("1 mrad".into(), 1e-3));
    assert_eq!(spectrum.reference("m"), ("1 um".into(), 1e-6));
    assert_eq!(spectrum.reference("W"), ("1 W".into(), 1.0));
}

#[test]
fn mistakes_say_what_is_allowed() {
    let cases = [
        (r#"{ of = ["psi"] }"#, "there is no recorded signal `psi`"),
        (r#"{ kind = "power" }"#, "there is no kind of spectrum `power`"),
        (r#"{ scale = "dBA" }"#, "did you mean `dB`?"),
        (r#"{ reference = "1 N" }"#, "has no use without levels in dB"),
        (r#"{ scale = "dB", reference = 1 }"#, "must be text"),
        (r#"{ scale = "dB", reference = "-1 N" }"#, "is a positive quantity with a unit"),
        (r#"{ from = "0.2 s" }"#, "must lie within the run"),
        (r#"{ window = "hann" }"#, "has no `window`"),
    ];
    for (table, says) in cases {
        let text = read(table).expect_err(says);
        assert!(text.contains(says), "{table}: {text}");
    }
}
