//! Zero friction, reverse rotation, reversal through rest, and friction together with other effects: motions that must be equal, and
//! energy accounts that must close.

use crate::{common, run, state, unaccounted, work};
use gearsim::run::Outcome;

/// Largest differences over two runs of theta, phi, theta' and phi'. theta and theta' of `b` are multiplied by `sign` before.
fn apart(a: &Outcome, b: &Outcome, sign: f64) -> [f64; 4] {
    assert_eq!(a.trajectory.len(), b.trajectory.len());
    let mut worst = [0.0f64; 4];
    for row in 0..a.trajectory.len() {
        let (a, b) = (state(a, row), state(b, row));
        for (i, worst) in worst.iter_mut().enumerate() {
            let sign = if i % 2 == 0 { sign } else { 1.0 };
            *worst = worst.max((a[i] - sign * b[i]).abs());
        }
    }
    worst
}

const SHORT: &str = "run={t_end=\"20 ms\", method=\"dop853\", tolerance=1e-12}";
const SAMPLES: &str = "output={rate=\"20 kHz\", events=false}";

#[test]
fn a_coefficient_of_zero_gives_no_friction() {
    let with = run(&["parameters.mu=0", SHORT, SAMPLES]);
    let without = run(&[r#"effects=["stiffness_step", "torques"]"#, SHORT, SAMPLES]);
    let worst = apart(&with, &without, 1.0);
    assert!(worst[0] < 1e-8 && worst[1] < 1e-10 && worst[2] < 1e-5 && worst[3] < 1e-5, "{worst:?}");
    assert!(work(&with, "roll").iter().all(|w| *w == 0.0));
}

/// Two equal gears that turn backwards are the mirror image of the same gears that turn forwards.
#[test]
fn reverse_rotation_of_equal_gears_gives_the_mirrored_motion() {
    let towards = |rpm: &str| {
        run(&[
            r#"effects=["stiffness_step", "sliding_friction", "damping", "torques"]"#,
            "parameters.N2=24",
            "parameters.I2=\"2890 kg*mm^2\"",
            r#"laws.k={teeth=[24, 24], module="6.35 mm", face_width="7 mm", method="energy", course="curves"}"#,
            &format!("start={{speed=\"{rpm}\"}}"),
            SHORT,
            SAMPLES,
        ])
    };
    let (forwards, backwards) = (towards("600 rpm"), towards("-600 rpm"));
    let worst = apart(&forwards, &backwards, -1.0);
    assert!(worst[0] < 1e-8 && worst[1] < 1e-10 && worst[2] < 1e-5 && worst[3] < 1e-5, "{worst:?}");
    let roll = work(&forwards, "roll");
    assert!((roll.last().unwrap() / work(&backwards, "roll").last().unwrap() - 1.0).abs() < 1e-8);
    assert!(*roll.last().unwrap() < -0.1);
}

/// A train is slowed, comes to rest and turns back. Rolling friction takes energy at every row, and the energy account closes.
#[test]
fn friction_opposes_rolling_through_rest() {
    let set = ["parameters.T_motor=\"20 N*m\"", "start={speed=\"100 rpm\"}", "run.tolerance=1e-11"];
    let set: Vec<String> = set.iter().map(|s| s.to_string()).collect();
    let outcome = common::run(&common::scene("sliding_friction", &set));
    let speeds = &outcome.trajectory.q_dot[0];
    assert!(speeds[0] > 200.0 && *speeds.last().unwrap() < -200.0, "{speeds:?}");
    let roll = work(&outcome, "roll12");
    assert!(roll.windows(2).all(|w| w[1] <= w[0] + 1e-12) && *roll.last().unwrap() < 0.0);
    println!("unaccounted for: {:.1e}", unaccounted(&outcome));
    assert!(unaccounted(&outcome) < 1e-6, "{:e}", unaccounted(&outcome));
}

#[test]
fn friction_combines_with_backlash_and_transmission_errors() {
    let cases: [&[&str]; 3] = [
        &[
            r#"effects=["stiffness_step", "sliding_friction", "backlash", "damping", "torques"]"#,
            "parameters.b=\"1e-3 rad\"",
        ],
        &[
            r#"effects=["stiffness_step", "sliding_friction", "transmission_error", "damping", "torques"]"#,
            r#"laws.e={pitch_errors=["0 rad", "1e-4 rad", "3e-4 rad"]}"#,
        ],
        &[
            r#"effects=["stiffness_step", "sliding_friction", "transmission_error", "torques"]"#,
            r#"laws.e={harmonics=[{order=1, amplitude="1e-4 rad"}]}"#,
            r#"laws.k={teeth=[24, 96], module="6.35 mm", face_width="7 mm", method="energy", course="curves"}"#,
        ],
    ];
    for case in cases {
        let outcome = run(&[case, &[SHORT, SAMPLES]].concat());
        println!("{}: unaccounted for {:.1e}", case[0], unaccounted(&outcome));
        assert!(unaccounted(&outcome) < 1e-8, "{}: {:e}", case[0], unaccounted(&outcome));
        assert!(*work(&outcome, "roll").last().unwrap() < 0.0);
    }
}

/// An idler has sliding friction in both meshes.
#[test]
fn both_meshes_of_an_idler_lose_energy() {
    let effects = r#"effects=["stiffness_step", "sliding_friction", "torques"]"#;
    let mut set = vec![effects.to_string(), "run={t_end=\"20 ms\", tolerance=1e-11}".into()];
    for (mesh, teeth) in [("12", "[28, 35]"), ("23", "[35, 56]")] {
        set.push(format!("parameters.mu{mesh}=0.05"));
        set.push(format!(r#"laws.side{mesh}={{teeth={teeth}, module="2.5 mm", face_width="20 mm"}}"#));
        set.push(format!(r#"laws.arm{mesh}={{teeth_of="side{mesh}"}}"#));
    }
    let outcome = common::run(&common::scene("idler", &set));
    assert!(unaccounted(&outcome) < 1e-8, "{:e}", unaccounted(&outcome));
    assert!(["roll12", "roll23"].iter().all(|torque| *work(&outcome, torque).last().unwrap() < 0.0));
}
