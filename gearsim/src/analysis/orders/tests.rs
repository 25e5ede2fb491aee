use std::f64::consts::TAU;

use super::*;
use crate::model::{Model, Output};
use crate::output::fixture::MODEL;
use crate::trajectory::Moment;

static OUTPUTS: [Output; 1] = [Output { name: "rotor_speed", unit: SHAFT, with: None, doc: "" }];
static TURNS: Model = Model { outputs: &OUTPUTS, ..MODEL };

/// A run of `n` samples at `rate` with the rotor at the speed `speed(t)` [revolutions/s].
fn run(n: usize, rate: f64, speed: impl Fn(f64) -> f64) -> Trajectory {
    let mut run = Trajectory::new(&TURNS, &[0]);
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
    // The interpolation is the error: (2 pi 240 Hz/20 kHz)^4 = 3e-5.
    for (order, amplitude) in [(23.0, 3.0), (24.0, 0.5)] {
        let found = orders.at(order).unwrap();
        // The main lobe of the window reaches one bin to either side; the sideband is ten bins away.
        assert!((found / amplitude - 1.0).abs() < 1e-4, "{order}: {found}");
    }
    assert!(orders.at(12.0).unwrap() < 1e-4);
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
    assert!(cuts.len() > 10 && cuts[cuts.len() - 1].speed > 4.0 * cuts[0].speed);
    for cut in &cuts {
        let expected = cut.speed / TAU;
        // Within a window of 8 revolutions the speed changes by up to a third at its beginning.
        assert!((cut.amplitude[0] / expected - 1.0).abs() < 0.03, "{} of {expected}", cut.amplitude[0]);
        assert!(cut.amplitude[1] < 1e-3 * expected);
    }
}
