use std::f64::consts::TAU;

use super::*;
use crate::model::{Model, Output};
use crate::output::fixture::MODEL;
use crate::trajectory::Moment;

static OUTPUTS: [Output; 1] = [Output { name: "rotor_speed", unit: SHAFT, with: None, known: false, doc: "" }];
static TURNS: Model = Model { outputs: &OUTPUTS, ..MODEL };

/// A run of `n` samples at `rate` with the rotor at the speed `speed(t)` [revolutions/s].
fn run(n: usize, rate: f64, speed: impl Fn(f64) -> f64) -> Trajectory {
    let mut run = Trajectory::new(&TURNS, &[], &[0]);
    run.t = (0..n).map(|i| i as f64 / rate).collect();
    run.moment = vec![Moment::Sample; n];
    run.outputs[0].1 = run.t.iter().map(|t| TAU * speed(*t)).collect();
    run
}

#[test]
fn a_line_at_constant_speed_has_its_amplitude() {
    let run = run(20_001, 20e3, |_| 10.0);
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    assert_eq!(turning.revolutions(), 10);
    // 23 teeth, and a sideband.
    let x: Vec<f64> =
        run.t.iter().map(|t| 5.0 + 3.0 * (TAU * 230.0 * t).sin() + 0.5 * (TAU * 240.0 * t).cos()).collect();
    let orders = turning.orders(&x).unwrap();
    // The error comes from the interpolation: (2 pi 240 Hz/20 kHz)^4 = 3e-5.
    for (order, amplitude) in [(23.0, 3.0), (24.0, 0.5)] {
        let found = orders.at(order).unwrap();
        // The main lobe of the window reaches two lines to either side; the sideband is ten lines away.
        assert!((found / amplitude - 1.0).abs() < 1e-4, "{order}: {found}");
    }
    assert!(orders.at(12.0).unwrap() < 1e-4);
}

/// A line between two orders of the spectrum is interpolated; it loses little.
#[test]
fn a_line_between_two_orders_keeps_its_amplitude() {
    let run = run(20_001, 20e3, |_| 10.0);
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    for order in [23.0, 23.0125, 23.03, 23.05, 23.07] {
        let x: Vec<f64> = run.t.iter().map(|t| 3.0 * (TAU * 10.0 * order * t).sin()).collect();
        let found = turning.orders(&x).unwrap().at(order).unwrap();
        assert!((found / 3.0 - 1.0).abs() < 5e-3, "{order}: {found}");
    }
}

/// A line beside an order contributes little to the amplitude at that order: 3 dB less at half a bandwidth, nothing at two lines.
#[test]
fn lines_beside_an_order_are_attenuated() {
    let run = run(20_001, 20e3, |_| 10.0);
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let x: Vec<f64> = run.t.iter().map(|t| 3.0 * (TAU * 10.0 * 24.0 * t).sin()).collect();
    let orders = turning.orders(&x).unwrap();
    for (lines, share) in [(0.0, 1.0), (0.5 * BANDWIDTH, 0.5_f64.sqrt()), (1.0, 0.5), (2.0, 0.0)] {
        let found = orders.at(24.0 - lines / 10.0).unwrap() / 3.0;
        assert!((found - share).abs() < 5e-3, "{lines}: {found} {share}");
    }
    assert_eq!(orders.at(1001.0), None);
}

#[test]
fn a_run_up_does_not_smear_an_order() {
    // From 5 to 25 revolutions a second in 2 s, with 17 pulses a revolution.
    let run = run(100_001, 50e3, |t| 5.0 + 10.0 * t);
    let x: Vec<f64> = run.t.iter().map(|t| (TAU * 17.0 * (5.0 * t + 5.0 * t * t)).sin()).collect();
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let orders = turning.orders(&x).unwrap();
    let found = orders.at(17.0).unwrap();
    assert!((found - 1.0).abs() < 1e-3, "{found}");
    // In time the line would be spread over 85 to 425 Hz.
    let elsewhere =
        orders.order.iter().zip(&orders.amplitude).filter(|(o, _)| (*o - 17.0).abs() > 0.5).map(|(_, a)| *a);
    assert!(elsewhere.fold(0.0, f64::max) < 1e-3);
}

#[test]
fn a_shaft_that_stands_or_turns_back_has_no_orders() {
    for speed in [|_: f64| 0.0, |t: f64| 1.0 - 2.0 * t] {
        let run = run(1001, 1e3, speed);
        assert!(matches!(Turning::of(&run, "rotor_speed", 0.0), Err(SpectrumError::NotTurning { .. })));
    }
    let run = run(1001, 1e3, |_| -3.0);
    assert_eq!(Turning::of(&run, "rotor_speed", 0.0).unwrap().revolutions(), 3);
}

#[test]
fn an_order_cut_follows_the_amplitude_over_speed() {
    // A run-up whose 17th order grows in proportion to the speed.
    let run = run(200_001, 50e3, |t| 5.0 + 10.0 * t);
    let x: Vec<f64> = run.t.iter().map(|t| (5.0 + 10.0 * t) * (TAU * 17.0 * (5.0 * t + 5.0 * t * t)).sin()).collect();
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let cuts = cuts(&turning, &x, &[17.0, 11.0], 8).unwrap();
    // The run has 100 revolutions and one cut for each, so that a narrow resonance has many points.
    assert!(cuts.len() > 85 && cuts[cuts.len() - 1].speed > 4.0 * cuts[0].speed);
    for cut in &cuts {
        let expected = cut.speed / TAU;
        // Within a window of 8 revolutions the speed changes by up to a third at its beginning.
        assert!((cut.amplitude[0] / expected - 1.0).abs() < 0.03, "{} of {expected}", cut.amplitude[0]);
        assert!(cut.amplitude[1] < 1e-3 * expected);
    }
}

#[test]
fn lines_have_their_amplitudes_wherever_their_orders_lie() {
    // Seven revolutions of a run-up, with orders between two lines of a transform.
    let run = run(40_001, 20e3, |t| 2.0 + 1.5 * t + 0.02 * (TAU * 3.0 * t).sin());
    let turns = |t: f64| 2.0 * t + 0.75 * t * t + 0.02 / (TAU * 3.0) * (1.0 - (TAU * 3.0 * t).cos());
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let x: Vec<f64> = run
        .t
        .iter()
        .map(|t| TAU * turns(*t))
        .map(|a| 40.0 + 3.0 * (17.37 * a).sin() + 0.5 * (20.37 * a).cos() + 0.25 * (19.37 * a).sin())
        .collect();
    let line = |order: f64| Line {
        mesh: "k",
        harmonic: 1,
        rotor: None,
        sideband: 0,
        order,
        frequency: order * turning.frequency(),
    };
    let found = turning.amplitudes(&[&x], &[17.37, 20.37, 19.37, 25.0].map(line));
    // The shaft turns 7.0 revolutions in 2 s, so that the orders of all lines differ by whole multiples of 1/7.
    for (amplitude, expected) in found.iter().zip([3.0, 0.5, 0.25, 0.0]) {
        // The constant and the lines at negative orders leak: 1/(order revolutions)^3 of each.
        assert!((amplitude[0] - expected).abs() < 1e-4, "{found:?}");
    }
}

/// A mesh of 23 teeth on the rotor, whose phase is the rotation.
fn geared() -> Trajectory {
    static LAWS: [crate::model::Law; 1] = [crate::model::Law {
        name: "k",
        unit: "N/m",
        phase: "theta",
        period: TAU,
        rolling: true,
        held: &[],
        with: None,
        role: crate::model::Role::Stiffness,
        doc: "",
    }];
    static GEARED: Model = Model { outputs: &OUTPUTS, laws: &LAWS, ..MODEL };
    let mut geared = run(30_001, 10e3, |_| 10.0 / 3.0);
    geared.model = &GEARED;
    geared.q = vec![geared.t.iter().map(|t| TAU * 230.0 / 3.0 * t).collect(), vec![0.0; geared.len()]];
    geared.q_dot = vec![vec![TAU * 230.0 / 3.0; geared.len()], vec![0.0; geared.len()]];
    geared
}

#[test]
fn twenty_three_teeth_at_200_rpm_mesh_at_76_7_hz() {
    let run = geared();
    let meshes = meshes(&run, 0.0);
    assert!((meshes[0].frequency - 76.667).abs() < 1e-3 && meshes[0].steady, "{meshes:?}");
    assert!(matches!(&meshes[0].rotors[..], [Rotor { name: "rotor_speed", teeth: 23.0, .. }]), "{meshes:?}");
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let lines = lines(&turning, &meshes);
    // Twenty multiples, five of them with six sidebands each.
    assert_eq!(lines.len(), 50);
    assert!(lines.iter().any(|line| (line.order - 47.0).abs() < 1e-9 && (line.harmonic, line.sideband) == (2, 1)));
}

#[test]
fn a_pitch_error_of_one_tooth_shows_in_all_sidebands() {
    // One of 23 teeth deviates by 1 over its pitch: a rectangle, whose order n has the amplitude 2 sin(pi n/23)/(pi n).
    let run = geared();
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let e: Vec<f64> = turning.angle.iter().map(|a| if a.fract() * 23.0 < 1.0 { 1.0 } else { 0.0 }).collect();
    let lines = lines(&turning, &meshes(&run, 0.0));
    let found = turning.amplitudes(&[&e], &lines);
    for (line, amplitude) in lines.iter().zip(&found) {
        let pi_n = std::f64::consts::PI * line.order;
        let expected = (2.0 * (pi_n / 23.0).sin() / pi_n).abs();
        // The edges lie between samples: each is known to 1/3000 revolution, which changes the amplitude by at most 2/3000.
        assert!((amplitude[0] - expected).abs() < 2.0 * 2.0 / 3000.0, "{line:?} {} {expected}", amplitude[0]);
    }
}

/// A rotor that makes four revolutions has sidebands four lines apart. The skirt of a line between two sidebands is not a sideband. Nothing
/// within the main lobe of a mesh line is listed as a sideband.
#[test]
fn sidebands_are_lines_of_their_own() {
    let run = run(20_001, 10e3, |_| 2.0);
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let mesh = |frequency: f64, rotor: f64| Mesh {
        name: "k",
        frequency,
        fastest: frequency,
        steady: true,
        force: None,
        rotors: vec![Rotor { name: "rotor_speed", frequency: rotor, teeth: 23.0, meets: 1 }],
        geared: vec!["rotor_speed"],
    };
    let lines = lines(&turning, &[mesh(46.0, 2.0), mesh(50.4, 1.0)]);
    // 50 Hz is 0.8 lines from the second mesh order, 52 Hz 3.2 lines.
    let listed = |order: f64| lines.iter().any(|line| line.rotor.is_some() && (line.order - order).abs() < 1e-9);
    assert!(!listed(25.0) && listed(26.0));
    let signal = |order: f64| run.t.iter().map(|t| (TAU * 2.0 * order * t).sin()).collect::<Vec<f64>>();
    let has = |x: &[f64], order: f64| {
        let has = turning.has(x, &lines);
        lines.iter().zip(has).any(|(line, has)| has && line.rotor.is_some() && (line.order - order).abs() < 1e-9)
    };
    for (at, own) in [(24.0, true), (24.1, true), (24.2, false), (23.7, false)] {
        assert_eq!(has(&signal(at), 24.0), own, "{at}");
    }
}

/// Two meshes whose lines are 0.31 and 3.1 lines of the transform apart, while only the first one vibrates: the record does not separate the
/// first pair, so that it is one line with both names; of the second pair, the absent line has no amplitude.
#[test]
fn lines_that_a_record_does_not_separate_are_one_line() {
    let run = run(20_001, 10e3, |_| 2.0);
    let turning = Turning::of(&run, "rotor_speed", 0.0).unwrap();
    let mesh = |name: &'static str, frequency: f64| Mesh {
        name,
        frequency,
        fastest: frequency,
        steady: true,
        force: None,
        rotors: vec![],
        geared: vec![],
    };
    // The record has four revolutions in two seconds: lines are 0.5 Hz apart.
    let x: Vec<f64> = run.t.iter().map(|t| 3.0 * (TAU * 46.0 * t).sin() + 0.5 * (TAU * 92.0 * t).cos()).collect();
    for (other, separate) in [(46.155, false), (47.55, true)] {
        let lines = lines(&turning, &[mesh("k12", 46.0), mesh("k34", other)]);
        let listed = turning.listed(&[&x], &lines).remove(0);
        let near = |frequency: f64| listed.iter().filter(move |of| (of.line.frequency - frequency).abs() < 0.9);
        let first = near(46.0).next().unwrap();
        assert!((first.amplitude - 3.0).abs() < 1e-4 && first.line.mesh == "k12", "{first:?}");
        assert_eq!(
            first.with.iter().map(|line| line.mesh).collect::<Vec<_>>(),
            if separate { vec![] } else { vec!["k34"] }
        );
        if separate {
            let (raw, absent) = (turning.amplitudes(&[&x], &lines), near(other).next().unwrap());
            let l = lines.iter().position(|line| *line == absent.line).unwrap();
            assert!(raw[l][0] > 0.02 && absent.amplitude < 1e-4, "{} {absent:?}", raw[l][0]);
        }
    }
}

/// A motor that a freewheel separates from the gears for a part of the run is not the reference shaft, although it is the first rotor.
#[test]
fn orders_refer_to_a_shaft_that_turns_with_a_mesh() {
    static MOTOR: Output = Output { name: "rotor_speed_m", unit: SHAFT, with: None, known: false, doc: "" };
    let mut run = geared();
    assert_eq!(reference_shaft(&run, None).unwrap().name, "rotor_speed");
    let slower = run.t.iter().map(|t| TAU * if *t < 1.0 { 10.0 / 3.0 } else { 2.5 }).collect();
    run.outputs.insert(0, (&MOTOR, slower));
    assert_eq!(reference_shaft(&run, None).unwrap().name, "rotor_speed");
    assert_eq!(reference_shaft(&run, Some("rotor_speed_m")).unwrap().name, "rotor_speed_m");
}
