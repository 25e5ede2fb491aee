//! Row 15: NaN, infinite, negative, subnormal, empty: refused by a named error, or run to a named end.

use std::panic::catch_unwind;

use gearsim::engine::Refusal;
use gearsim::engine::cell::Cell;
use gearsim::scene::Scene;

use crate::case::{Case, NONE, WRONG, count};
use crate::common;
use crate::linear::{Linear, diagonal};

pub const CASES: &[Case] = &[
    Case {
        row: "15",
        name: "scenes with a number that is none, or out of range",
        proves: "refused before the run, with the key named",
        tolerance: 0.0,
        unit: "not refused",
        reason: NONE,
        measure: scenes,
    },
    Case {
        row: "15",
        name: "parameters whose matrices are none",
        proves: "refused before the run, by a named error",
        tolerance: 0.0,
        unit: "not refused",
        reason: NONE,
        measure: magnitudes,
    },
    Case {
        row: "15",
        name: "cells: NaN, infinite, no or negative inertia, indefinite, coupled damping",
        proves: "each refused by the error that names it",
        tolerance: 0.0,
        unit: "not refused",
        reason: NONE,
        measure: cells,
    },
    Case {
        row: "15",
        name: "parameters of 5e-324 to 1e300, one and two at a time",
        proves: "no panic, no endless loop, no silent NaN: refused, finite to the end, or stopped by name",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: extremes,
    },
];

/// The key, as it must be named, and what it is set to.
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

fn load(overrides: &[String]) -> Result<Scene, String> {
    let path = common::root().join("models/scenes/oh2005/energy_300rpm.toml");
    Scene::load(&path, overrides, &common::models()).map_err(|errors| errors.render(100, false))
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

/// What a run of a scene with these overrides comes to: refused, or the finiteness of its last row.
fn end(overrides: &[String]) -> Result<bool, String> {
    let scene = load(overrides)?;
    let outcome = (common::model(scene.model.name).run)(&scene, &mut |_| {}).map_err(|e| e.to_string())?;
    let t = &outcome.trajectory;
    let last = t.len() - 1;
    Ok(outcome.stopped_by.is_some() || (0..2).all(|i| t.q[i][last].is_finite() && t.q_dot[i][last].is_finite()))
}

fn magnitudes(note: &mut String) -> f64 {
    let pairs = [
        ("parameters.I1=\"5e-324 kg*m^2\"", "parameters.I2=\"740200 kg*mm^2\""),
        ("parameters.I1=\"1e-310 kg*m^2\"", "parameters.I2=\"1e-310 kg*m^2\""),
        ("parameters.I1=\"1e308 kg*m^2\"", "parameters.N1=1e-10"),
        ("parameters.N1=1e200", "parameters.N2=1e200"),
        ("parameters.N1=1e-200", "parameters.N2=1e-200"),
        ("laws.k.steps.0.value=\"1e308 N*m\"", "laws.k.steps.1.value=\"1e308 N*m\""),
        ("parameters.zeta=1e308", "parameters.I1=\"2890 kg*mm^2\""),
    ];
    *note = format!("{} pairs of parameters", pairs.len());
    count(pairs.map(|(a, b)| match catch_unwind(|| end(&[a.to_string(), b.to_string()])) {
        Ok(Err(_)) => false,
        other => {
            println!("{a}, {b}: {other:?}");
            true
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
    all.push((Linear { stiffness: diagonal([1.0, 2.0]), damping: with(0.1), ..sound }, "coupled"));
    *note = format!("{} cells", all.len());
    count(all.into_iter().map(|(cell, expected)| {
        let named = match catch_unwind(|| Cell::new(&cell, &[]).err()) {
            Ok(Some(Refusal::Overflow)) => "overflow",
            Ok(Some(Refusal::Mass)) => "mass",
            Ok(Some(Refusal::Unstable { .. })) => "unstable",
            Ok(Some(Refusal::CoupledDamping { .. })) => "coupled",
            Ok(_) => "accepted",
            Err(_) => "a panic",
        };
        if named != expected {
            println!("{named}, not {expected}: {cell:?}");
        }
        named != expected
    }))
}

fn extremes(note: &mut String) -> f64 {
    let keys = [
        ("parameters.I1", "kg*m^2"),
        ("parameters.T0", "N*m"),
        ("laws.k.steps.0.value", "N*m"),
        ("start.phi_dot", "rad/s"),
        ("start.theta_dot", "rad/s"),
        ("parameters.zeta", ""),
    ];
    let sizes = ["5e-324", "1e-310", "1e-150", "1e-20", "1e8", "1e150", "1e300"];
    let one = |(key, unit): (&str, &str), size: &str| match unit {
        "" => format!("{key}={size}"),
        _ => format!("{key}=\"{size} {unit}\""),
    };
    let mut runs = 0;
    let mut wrong = 0.0;
    for (i, a) in keys.iter().enumerate() {
        for b in &keys[i..] {
            for (x, y) in sizes.iter().flat_map(|x| sizes.iter().map(move |y| (x, y))).filter(|(x, y)| a != b || x == y)
            {
                // A short run, or a speed like that would pass steps without end.
                let overrides =
                    [one(*a, x), one(*b, y), "run.t_end=1e-9 s".to_string(), "output.rate=1 GHz".to_string()];
                runs += 1;
                if !matches!(catch_unwind(|| end(&overrides)), Ok(Err(_) | Ok(true))) {
                    println!("{overrides:?}");
                    wrong += 1.0;
                }
            }
        }
    }
    *note = format!("{runs} runs");
    wrong
}
