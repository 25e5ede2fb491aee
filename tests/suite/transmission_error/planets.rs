//! Planets that mesh in phase and planets that mesh in sequence: symmetry alone decides which motions their mesh errors excite.
//! R. G. Parker, J. Sound Vib. 236(4) (2000); V. K. Ambarisha, R. G. Parker, J. Vib. Acoust. 128(4) (2006).

use gearsim::run::Outcome;

use crate::common;

/// Runs the planetary stage of the scene `planetary_errors` with balanced torques. The mesh errors of each planet lag those of the planet
/// before by `step` degrees; the errors are multiplied by `scale`.
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

/// The difference between the largest and the smallest value of the named coordinate.
fn swing(outcome: &Outcome, name: &str) -> f64 {
    let i = common::model("planar_planetary_3")
        .model
        .coordinates
        .iter()
        .position(|c| c.name == name)
        .expect("a coordinate");
    let q = &outcome.trajectory.q[i];
    let (low, high) = q.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(*x), high.max(*x)));
    high - low
}

#[test]
fn planets_in_phase_twist_the_carrier_and_planets_in_sequence_move_the_sun() {
    let (together, sequence) = (stage(0.0, 1.0), stage(120.0, 1.0));
    let twist = [&together, &sequence].map(|outcome| swing(outcome, "theta_c"));
    let shake = [&together, &sequence].map(|outcome| swing(outcome, "x_s"));
    println!("carrier twists by {twist:?} rad, sun moves by {shake:?} m, together and in sequence");
    assert!(twist[0] > 1e-5 && shake[1] > 5e-7);
    // In phase, the sun does not move. In sequence, the errors cancel to first order, so the twist is of second order in the errors.
    assert!(shake[0] < 1e-9 * shake[1] && twist[1] < 5e-3 * twist[0], "{twist:?} {shake:?}");
    let less = swing(&stage(120.0, 0.1), "theta_c") / twist[1];
    assert!((less - 0.01).abs() < 1e-3, "{less}");
    for outcome in [together, sequence] {
        assert!(crate::unaccounted(&outcome) < 1e-9, "{:e}", crate::unaccounted(&outcome));
    }
}
