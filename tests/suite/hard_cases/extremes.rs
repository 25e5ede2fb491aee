//! Row 15: numbers of every size: refused with a named error, run to the end, or stopped with a named error.

use std::panic::catch_unwind;

use crate::case::{Case, NONE, WRONG, count};
use crate::common;
use crate::refusals::load;

pub const CASES: &[Case] = &[
    Case {
        row: "15",
        name: "parameters that give no valid matrices",
        proves: "refused before the run, with a named error",
        tolerance: 0.0,
        unit: "not refused",
        reason: NONE,
        measure: magnitudes,
    },
    Case {
        row: "15",
        name: "parameters of 5e-324 to 1e300, one and two at a time",
        proves: "no panic, no endless loop, no silent NaN: refused, finite to the end, or stopped with a named error",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: extremes,
    },
];

/// Runs a scene with these overrides: the error if it is refused, otherwise whether it stopped with a named error or its last row is
/// finite.
fn end(overrides: &[String]) -> Result<bool, String> {
    let scene = load(overrides)?;
    let outcome = common::model(scene.model.name).run(&scene, &mut |_| {}).map_err(|e| e.to_string())?;
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
                // The run is short, because at such speeds a longer one would pass too many steps.
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
