//! Friction laws in scenes: meaning of their keys, and messages for mistakes.

use std::f64::consts::TAU;

use super::fixture::{SCENE, parse};
use crate::gear::{FrictionLaw, Gears, StiffnessMethod, friction};
use crate::profile::Profile;
use crate::scene::Scene;

const TEETH: &str = "teeth = [24, 96]\nmodule = \"6.35 mm\"\nface_width = \"7 mm\"\nmethod = \"energy\"";

/// The scene with the effect, its stiffness computed from teeth.
fn scene_with_friction() -> String {
    let (begin, end) = (SCENE.find("steps = [").unwrap(), SCENE.find("[start]").unwrap());
    let text = format!("{}{TEETH}\nphase = 0.25\n\n{}", &SCENE[..begin], &SCENE[end..]);
    text.replace("\"damping\",", "\"sliding_friction\",")
}

/// The scene with friction and the tables `laws`; the messages if it has mistakes.
fn with(laws: &str, overrides: &[&str]) -> Result<Scene, String> {
    parse(&format!("{}\n{laws}", scene_with_friction()), overrides).map_err(|errors| errors.render(100, false))
}

fn gears() -> Gears {
    Gears::standard([24.0, 96.0], 6.35e-3, 20f64.to_radians(), 7e-3)
}

/// `teeth_of` takes teeth and phase of the stiffness. The transmission error, whose effect is not active, is zero.
#[test]
fn friction_laws_use_the_teeth_of_another_law() {
    let scene = with("[laws.side]\nteeth_of = \"k\"\n[laws.arm]\nteeth_of = \"k\"\n", &[]).unwrap();
    assert_eq!(scene.present().map(|(law, _)| law.name).collect::<Vec<_>>(), ["k", "e", "side", "arm"]);
    assert_eq!(scene.laws[1].extremes(), (0.0, 0.0));
    let of = |what, scale| friction(&gears(), StiffnessMethod::Energy, what, TAU, scale).unwrap();
    let ahead = |law: Profile| {
        let origin = law.origin;
        law.with_origin(origin - 0.25 * TAU)
    };
    assert_eq!(scene.laws[2], ahead(of(FrictionLaw::Side, 1.0)));
    // The deflection is a phase: one base pitch is one turn of it.
    let arm = ahead(of(FrictionLaw::Arm, TAU / gears().contact().unwrap().base_pitch));
    let off = |a: &Profile| a.steps.iter().zip(&arm.steps).fold(0.0f64, |m, (a, b)| m.max((a.value - b.value).abs()));
    assert!(off(&scene.laws[3]) < 1e-14 && scene.laws[3].origin == arm.origin);
}

/// A friction law may be given by steps or a series (a side has any sign), or by its own teeth, which another law may then use.
#[test]
fn friction_laws_take_steps_series_and_their_own_teeth() {
    let steps = "steps = [{ value = -1, width = \"1 rad\" }, { value = 1 }]";
    let own = TEETH.replace("method = \"energy\"", "");
    let scene = with(&format!("[laws.side]\n{steps}\n[laws.arm]\n{own}"), &[]).unwrap();
    assert_eq!((scene.laws[2].steps[0].value, scene.laws[2].steps[1].width), (-1.0, TAU - 1.0));
    let scale = TAU / gears().contact().unwrap().base_pitch;
    let equal = friction(&gears(), StiffnessMethod::Iso6336(None), FrictionLaw::Arm, TAU, scale).unwrap();
    assert!((scene.laws[3].mid() - equal.mid()).abs() < 1e-14);
    let scene = with(&format!("[laws.side]\nteeth_of = \"arm\"\n[laws.arm]\n{own}"), &[]).unwrap();
    assert_eq!(scene.laws[2], friction(&gears(), StiffnessMethod::Iso6336(None), FrictionLaw::Side, TAU, 1.0).unwrap());
    let wave = "[laws.side]\nharmonics = [{ order = 1, amplitude = 1 }]\n[laws.arm]\nmean = \"1 rad\"\nharmonics = []";
    assert_eq!(with(wave, &[]).unwrap().laws[2].extremes(), (-1.0, 1.0));
}

#[test]
fn messages_name_the_mistake() {
    let side = "[laws.side]\nteeth_of = \"k\"\n";
    let cases = [
        (format!("{side}[laws.arm]\nteeth_of = 3"), "`laws.arm.teeth_of` must be text"),
        (format!("{side}[laws.arm]\nteeth_of = \"side\""), "`laws.side` is not given by its teeth"),
        (format!("{side}[laws.arm]\nteeth_of = \"k\"\nphase = 0.1"), "[laws.arm] with teeth_of has no `phase`"),
        (
            format!("{side}[laws.arm]\nsteps = [{{ value = \"-1 rad\" }}]"),
            "`laws.arm.steps.0.value` must not be negative",
        ),
        (format!("{side}[laws.arm]\nharmonics = [{{ order = 1, amplitude = \"1 rad\" }}]\nmean = 0"), "falls to -1"),
        (format!("{side}[laws.arm]\npitches = 2\n{TEETH}"), "has both pitches and teeth"),
        (format!("{side}[laws.arm]\n{TEETH}\ncourse = \"levels\""), "has no `course`"),
    ];
    for (laws, message) in cases {
        let text = with(&laws, &[]).expect_err(&laws);
        assert!(text.contains(message), "{laws}: {text}");
    }
    let both = "[laws.side]\nteeth_of = \"k\"\n[laws.arm]\nteeth_of = \"k\"\n";
    let text = with(both, &["laws.k.teeth_of=\"side\""]).expect_err("a stiffness has its own");
    assert!(text.contains("[laws.k] has no `teeth_of`"), "{text}");
    let text = with(both, &["effects=[\"stiffness_step\", \"sliding_friction\", \"frozen_phase\"]"]).expect_err("both");
    assert!(text.contains("effects `sliding_friction` and `frozen_phase` contradict each other"), "{text}");
}

/// A missing law is reported with the line to add. Unsuitable gears are reported at the law that asks for them.
#[test]
fn mistakes_point_to_their_places() {
    let both = "[laws.side]\nteeth_of = \"k\"\n[laws.arm]\nteeth_of = \"k\"\n";
    insta::assert_snapshot!(with("", &[]).unwrap_err());
    insta::assert_snapshot!(with(&both.replace("\"k\"", "\"kk\""), &[]).unwrap_err());
    let ring = scene_with_friction().replace("method = \"energy\"", "internal = true");
    insta::assert_snapshot!(parse(&format!("{ring}\n{both}"), &[]).expect_err("a ring").render(100, false));
}
