//! Planets that mesh together, and planets that mesh one after another: what the errors of their meshes excite by symmetry alone.
//! R. G. Parker, J. Sound Vib. 236(4) (2000); V. K. Ambarisha, R. G. Parker, J. Vib. Acoust. 128(4) (2006).

use gearsim::run::Outcome;

use crate::common;

/// The planetary stage of the gallery in balance, the meshes of each planet so many degrees after those before, errors times `scale`.
fn stage(step: f64, scale: f64) -> Outcome {
    let mut set: Vec<String> =
        ["start.speed=\"1000 rpm\"", "parameters.T_motor=\"300 N*m\"", "run={t_end=\"10 ms\", tolerance=1e-11}"]
            .map(String::from)
            .to_vec();
    for planet in 1..=3 {
        for (ring, mesh, amplitude) in [(0.0, "s", 3.0 * scale), (180.0, "r", 2.0 * scale)] {
            let phase = ring - step * f64::from(planet - 1);
            set.push(format!(
                "laws.e_{mesh}{planet}={{harmonics=[{{order=1, amplitude=\"{amplitude} um\", phase=\"{phase} deg\"}}]}}"
            ));
        }
    }
    common::run(&common::scene("planetary_errors", &set))
}

/// How far the named coordinate moves.
fn swing(outcome: &Outcome, name: &str) -> f64 {
    let i =
        common::model("planar_planetary_3").model.coordinates.iter().position(|c| c.name == name).expect("is there");
    let q = &outcome.trajectory.q[i];
    let (low, high) = q.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
    high - low
}

#[test]
fn planets_in_phase_twist_and_planets_in_sequence_shake() {
    let (together, sequence) = (stage(0.0, 1.0), stage(120.0, 1.0));
    let twist = [&together, &sequence].map(|outcome| swing(outcome, "theta_c"));
    let shake = [&together, &sequence].map(|outcome| swing(outcome, "x_s"));
    println!("carrier twists by {twist:?} rad, sun moves by {shake:?} m, together and in sequence");
    assert!(twist[0] > 1e-5 && shake[1] > 5e-7);
    // Together, the sun stays where it is. In sequence, the errors cancel to first order: what twists the train is their square.
    assert!(shake[0] < 1e-9 * shake[1] && twist[1] < 5e-3 * twist[0], "{twist:?} {shake:?}");
    let less = swing(&stage(120.0, 0.1), "theta_c") / twist[1];
    assert!((less - 0.01).abs() < 1e-3, "{less}");
    for outcome in [together, sequence] {
        assert!(crate::unaccounted(&outcome) < 1e-9, "{:e}", crate::unaccounted(&outcome));
    }
}
