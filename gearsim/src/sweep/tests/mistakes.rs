//! Error messages on sweeps that are not valid.

use super::{load, request};
use crate::sweep::{Design, Error, Manifest, manifest};

fn message(error: Error) -> String {
    match error {
        Error::Scene(errors) => errors.render(200, false),
        other => other.to_string(),
    }
}

#[test]
fn every_mistake_in_an_axis_has_its_message() {
    let cases = [
        ("parameters.T0", "an axis without values"),
        ("=1:2:3", "without a valid key"),
        ("model=gear_pair", "cannot be varied"),
        ("parameters.T0=", "a value of a list is missing"),
        ("parameters.T0=1,,2", "a value of a list is missing"),
        ("parameters.T0=1:2", "not a range of values"),
        ("parameters.T0=1:2:3:4", "not a range of values"),
        ("parameters.T0=uniform:1:2:3", "not a range of values"),
        ("parameters.T0=lin:1:2:3", "not a range of values"),
        ("parameters.T0=1:b:3", "cannot be read"),
        ("parameters.T0=1:1e999:3", "not a finite number"),
        ("parameters.T0=1 N*m:2 Nq:3", "unknown unit"),
        ("parameters.T0=1:2:1", "`1` is not a valid number of values"),
        ("parameters.T0=1:2:2.5", "`2.5` is not a valid number of values"),
        ("parameters.T0=1:2:99999999", "from 2 to 10000000"),
        ("parameters.T0=log:0:2 N*m:3", "not positive"),
        ("parameters.T0=log:-1 N*m:2 N*m:3", "not positive"),
        ("parameters.T0=1:2 N*m:3", "some numbers of the axis have a unit"),
        ("parameters.T0=1 N*m:2 rad:3", "different dimensions"),
        ("parameters.T0=1:2:3", "write the unit with each number, e.g. \"1 N*m:2 N*m\""),
        ("parameters.T0=1 N*m,2", "a number without a unit"),
        ("start.phi=static,0.01", "a number without a unit"),
        ("parameters.T0=normal:5 N*m:1 N*m:3", "not a range of values"),
        ("parameters.T0=normal:5 N*m:-1 N*m", "a standard deviation that is not positive"),
        ("parameters.T0=normal:5 N*m:1 N*m:9 N*m:3 N*m", "in the wrong order"),
        // Values that the scene does not admit.
        ("parameters.T0=1 rpm:2 rpm:3", "`parameters.T0` is a torque or energy"),
        ("parameters.zeta=-0.1:0.1:5", "`parameters.zeta` must not be negative, but is -0.1"),
        ("parameters.zeta=0.1:-0.1:5", "`parameters.zeta` must not be negative, but is -0.1"),
        ("parameters.zeta=0.1,0.2,-3", "but is -3"),
        ("parameters.I1=1 kg*m^2,0", "`parameters.I1` must be positive"),
        ("parameters.T1=1:2:3", "has no `T1`"),
        ("laws.k.steps.5.value=1 N*m,2 N*m", "no entry `5`"),
        ("effects=[\"damping\"],[\"dampning\"]", "did you mean `damping`"),
        ("laws.k.steps.0.value=-1 N*m:1 N*m:3", "must not be negative, but is -1 N*m"),
    ];
    for (text, expected) in cases {
        let shown = message(load(&request(&[text])).err().expect(text));
        assert!(shown.contains(expected), "{text}: {shown}");
    }
}

#[test]
fn mistakes_of_all_axes_are_shown_at_once() {
    let shown = message(
        load(&request(&["parameters.T0=1:x:3", "parameters.zeta", "start.speed=1 rpm:2 rpm:0"])).err().unwrap(),
    );
    assert!(shown.contains("3 mistakes"), "{shown}");
}

#[test]
fn requests_that_contradict_themselves_are_refused() {
    let base = request(&["parameters.T0=1 N*m:2 N*m:3"]);
    let random = request(&["parameters.T0=uniform:1 N*m:2 N*m"]);
    let two = |a: &str, b: &str| request(&[a, b]);
    let cases = [
        (request(&[]), "nothing is varied"),
        (two("parameters.T0=1 N*m:2 N*m:3", "parameters.T0=4 N*m"), "varied twice"),
        (random.clone(), "without a number of samples"),
        (crate::sweep::Request { samples: Some(0), ..random }, "at least one"),
        (crate::sweep::Request { samples: Some(5), ..base.clone() }, "no axis is random"),
        (crate::sweep::Request { design: Design::Sobol, ..base.clone() }, "no axis is random"),
        (crate::sweep::Request { record: vec!["energie".into()], ..base.clone() }, "called `energie`"),
        (crate::sweep::Request { from: Some(0.02), ..base.clone() }, "the run ends at 0.02 s"),
        (two("parameters.T0=1 N*m:2 N*m:9999999", "parameters.zeta=0:1:9999999"), "more than 10000000 points"),
        (crate::sweep::Request { overrides: vec!["parameters.T0 = 9 N*m".into()], ..base }, "is both set and varied"),
    ];
    for (request, expected) in cases {
        let shown = message(load(&request).err().unwrap());
        assert!(shown.contains(expected), "{request:?}: {shown}");
    }
}

/// An axis with text cut off or inserted anywhere gives a sweep or an error message.
#[test]
fn no_axis_text_causes_a_panic() {
    let texts = [
        " start.speed =uniform:0:3 rev/s",
        "parameters.T0=log:1 N*m:5 kN*m:7",
        "effects=[\"damping\", 'x'],[]",
        "é=µ:°:3",
    ];
    for text in texts {
        for cut in (0..=text.len()).filter(|cut| text.is_char_boundary(*cut)) {
            for put in ["", ":", ",", "=", "\"", "[", "µ", "-", "1e999", " "] {
                for rest in ["", &text[cut..]] {
                    let request = request(&[&format!("{}{put}{rest}", &text[..cut])]);
                    if let Err(error) = load(&request) {
                        assert!(!message(error).is_empty());
                    }
                }
            }
        }
    }
}

#[test]
fn a_manifest_of_another_version_is_refused() {
    let request = request(&["parameters.T0=1 N*m:2 N*m:3"]);
    let folder = tempfile::tempdir().unwrap();
    let read = |text: &str| {
        std::fs::write(folder.path().join(manifest::FILE), text).unwrap();
        Manifest::read(folder.path())
    };
    let written = Manifest::new(&load(&request).unwrap(), &request, None);
    let text = written.json().unwrap();
    assert_eq!(read(&text).unwrap(), Some(written));
    let other = text.replace("\"version\": 3", "\"version\": 4").replace("\"seed\"", "\"seeds\"");
    let refused = read(&other).unwrap_err().to_string();
    assert!(
        refused.contains("gearsim.sweep_manifest, version 4; this program reads gearsim.sweep_manifest, version 3"),
        "{refused}"
    );
}
