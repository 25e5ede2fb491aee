//! Row 15: NaN, infinite, negative and empty values: refused with a named error.

use std::panic::catch_unwind;

use gearsim::__private::Cell;
use gearsim::run::Refusal;
use gearsim::scene::Scene;

use crate::case::{Case, NONE, count};
use crate::common;
use crate::linear::{Linear, diagonal};

pub const CASES: &[Case] = &[
    Case {
        row: "15",
        name: "scenes with a number that is not finite, or out of range",
        proves: "refused before the run, with an error that names the key",
        tolerance: 0.0,
        unit: "not refused",
        reason: NONE,
        measure: scenes,
    },
    Case {
        row: "15",
        name: "cells with NaN, infinite values, no or negative inertia, indefinite stiffness or damping",
        proves: "each refused with the error for its cause",
        tolerance: 0.0,
        unit: "not refused",
        reason: NONE,
        measure: cells,
    },
];

/// A key, whose last part the error must name, and its bad value.
const BAD: [(&str, &str); 35] = [
    ("parameters.I1", "nan"),
    ("parameters.I1", "inf"),
    ("parameters.I1", "\"nan kg*m^2\""),
    ("parameters.I1", "\"inf kg*m^2\""),
    ("parameters.I1", "\"-1 kg*m^2\""),
    ("parameters.I2", "\"0 kg*m^2\""),
    ("parameters.I2", "\"1e400 kg*m^2\""),
    ("parameters.N1", "0"),
    ("parameters.N1", "-24"),
    ("parameters.N2", "nan"),
    ("parameters.zeta", "-0.1"),
    ("parameters.zeta", "inf"),
    ("parameters.T0", "nan"),
    ("parameters.T0", "\"-inf N*m\""),
    ("laws.k.steps.0.value", "\"-1 N*m\""),
    ("laws.k.steps.0.value", "nan"),
    ("laws.k.steps.1.value", "\"inf N*m\""),
    ("laws.k.steps.0.width", "\"0 rad\""),
    ("laws.k.steps.0.width", "\"-1 rad\""),
    ("laws.k.steps.0.width", "nan"),
    ("laws.k.steps", "[]"),
    ("laws.k.steps", "[{ value = \"1 N*m\", width = \"7 rad\" }, { value = \"2 N*m\" }]"),
    ("laws.k.steps", "[{ value = \"1 N*m\", width = \"1 rad\" }, { value = \"2 N*m\", width = \"1 rad\" }]"),
    ("start.theta", "nan"),
    ("start.phi", "\"inf rad\""),
    ("start.phi_dot", "\"nan rad/s\""),
    ("start.speed", "\"inf rpm\""),
    ("run.t_end", "\"0 s\""),
    ("run.t_end", "\"-1 s\""),
    ("run.t_end", "\"nan s\""),
    ("run.t_end", "\"inf s\""),
    ("run.t_end", "\"5e-324 s\""),
    ("output.rate", "\"0 Hz\""),
    ("output.rate", "\"-1 Hz\""),
    ("output.rate", "\"inf Hz\""),
];

pub fn load(overrides: &[String]) -> Result<Scene, String> {
    let path = common::root().join("models/scenes/oh2005/energy_300rpm.toml");
    Scene::load_with(&path, overrides, &common::models()).map_err(|errors| errors.render(100, false))
}

fn scenes(note: &mut String) -> f64 {
    *note = format!("{} scenes", BAD.len());
    count(BAD.iter().map(|(key, value)| {
        let named = key.rsplit('.').next().expect("a last part");
        match catch_unwind(|| load(&[format!("{key}={value}")])) {
            Ok(Err(message)) if message.contains(named) => false,
            other => {
                println!("{key} = {value}: {other:?}");
                true
            }
        }
    }))
}

fn cells(note: &mut String) -> f64 {
    let (one, none) = (diagonal([1.0; 2]), diagonal([0.0; 2]));
    let sound = Linear { mass: one, damping: none, stiffness: one, load: [0.0; 2], normal: [1.0, 0.0] };
    let with = |x: f64| [[1.0, x], [x, 1.0]];
    let mut all = vec![];
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        all.push((Linear { mass: with(x), ..sound }, "overflow"));
        all.push((Linear { stiffness: with(x), ..sound }, "overflow"));
        all.push((Linear { damping: with(x), ..sound }, "overflow"));
        all.push((Linear { load: [x, 0.0], ..sound }, "overflow"));
    }
    for mass in [diagonal([0.0, 1.0]), diagonal([1.0, -1.0]), with(1.0), with(-2.0), none] {
        all.push((Linear { mass, ..sound }, "mass"));
    }
    all.push((Linear { stiffness: diagonal([1.0, -1e-3]), ..sound }, "unstable"));
    all.push((Linear { stiffness: with(2.0), ..sound }, "unstable"));
    all.push((Linear { stiffness: diagonal([1.0, 2.0]), damping: with(2.0), ..sound }, "feeding"));
    *note = format!("{} cells", all.len());
    count(all.into_iter().map(|(cell, expected)| {
        let named = match catch_unwind(|| Cell::new(&cell, &[]).err()) {
            Ok(Some(Refusal::Overflow)) => "overflow",
            Ok(Some(Refusal::Mass)) => "mass",
            Ok(Some(Refusal::Unstable { .. })) => "unstable",
            Ok(Some(Refusal::Feeding { .. })) => "feeding",
            Ok(_) => "accepted",
            Err(_) => "a panic",
        };
        if named != expected {
            println!("{named}, not {expected}: {cell:?}");
        }
        named != expected
    }))
}
