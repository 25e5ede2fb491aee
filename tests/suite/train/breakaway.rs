//! The breakaway of dry friction behind a shaft does not depend on the angle of the train.

use gearsim::{Results, Scene};

const BREAKAWAY: f64 = 13.0;
const SHAFT: f64 = 100.0;

/// A heavy rotor a turns and winds up a shaft. Friction of 10 N m, 13 N m at rest, holds the light rotor b at its other end. Both start
/// at `angle` \[rad\].
fn run(angle: f64, more: &str) -> Results {
    let text = format!(
        "model = \"train\"\neffects = [\"torques\", \"dry_friction\"]\n[rotors]\na = \"1000 kg*m^2\"\nb = \"0.01 kg*m^2\"\n\
         [shafts.s]\nbetween = [\"a\", \"b\"]\nstiffness = \"{SHAFT} N*m/rad\"\n\
         [bearings.q]\nrotor = \"b\"\nfriction = \"10 N*m\"\nbreakaway = {:?}\n[drives.d]\nrotor = \"a\"\ntorque = \"10 N*m\"\n\
         [start]\ntheta_a = \"{angle:?} rad\"\ntheta_b = \"{angle:?} rad\"\ntheta_a_dot = \"1 rad/s\"\ntheta_b_dot = \"0 rad/s\"\n\
         [run]\nt_end = \"3 s\"\n{more}\n[output]\nplots = []\nrate = \"100 Hz\"\n",
        BREAKAWAY / 10.0 - 1.0
    );
    Scene::from_toml("breakaway", &text).unwrap_or_else(|e| panic!("{e}")).run().unwrap_or_else(|e| panic!("{e}"))
}

/// While b sticks, the twist x of the shaft follows 1000 x'' = 10 - 100 x from x = 0, x' = 1. It reaches 0.13 rad at the breakaway.
#[test]
fn the_breakaway_torque_does_not_depend_on_the_angle() {
    let omega = 0.1f64.sqrt();
    let twist = |t: f64| 0.1 * (1.0 - (omega * t).cos()) + (omega * t).sin() / omega;
    let (mut low, mut high) = (0.0, 0.2);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if twist(middle) < BREAKAWAY / SHAFT { low = middle } else { high = middle }
    }
    for angle in [0.0, -3.0, 1e3, 1e5, -1e7] {
        let run = run(angle, "");
        let (before, _) = run.events().next().expect("a breakaway");
        let off = run.trajectory().t[before] - low;
        println!("from {angle:e} rad: the breakaway is {off:.1e} s late");
        // The speed of the twist is 1 rad/s. Each angle has a rounding error of half a unit in the last place.
        assert!(off.abs() < 2e-15 + 2.0 * f64::EPSILON * f64::abs(angle), "from {angle:e} rad: {off:e} s late");
    }
}

/// Rotor b sticks and slips 29 times, and each time amplifies the errors of the breakaway. The speed at the end is that of an engine in
/// quadruple precision; compensated precision has it too. The claimed digits are correct.
#[test]
fn stick_slip_keeps_its_digits() {
    let expected = 1.470_982_816_93;
    for (precision, allowed) in [("plain", 3e-11), ("compensated", 1e-11)] {
        let run = run(0.0, &format!("precision = \"{precision}\""));
        let off = (run.trajectory().q_dot[1].last().unwrap() / expected - 1.0).abs();
        let claimed = run.outcome.digits.as_ref().map(|digits| digits.at_end);
        println!("{precision}: off by {off:.1e}, claimed {claimed:?}");
        assert_eq!(run.outcome.counts.sticks, 29);
        assert!(off < allowed, "{precision}: off by {off:e}");
    }
}
