//! Play and held contacts under torques that vary in time.

use super::{ALL, residual, run, run_of};

/// The same gear pair on shafts between a motor and a load. Torques, damping, start and end are set by each test.
const TRAIN: &str = r#"
model = "gear_pair_shafts"
effects = ["stiffness_step", "damping", "torques"]
[parameters]
N1 = 24
N2 = 96
r1 = "71.6 mm"
I1 = "2890 kg*mm^2"
I2 = "740200 kg*mm^2"
I_m = "0.02 kg*m^2"
I_l = "1.5 kg*m^2"
k_m = "20 kN*m/rad"
k_l = "200 kN*m/rad"
[laws.k12]
steps = [{ value = "80.3 MN/m", width = "1.73 rad" }, { value = "156 MN/m" }]
"#;

/// Flanks that separate and meet under a torque that oscillates about a small mean: both solvers pass the same events.
#[test]
fn play_under_a_harmonic_torque() {
    let swing = "parameters.T0={mean=\"2 N*m\", harmonics=[{amplitude=\"9 N*m\", frequency=\"300 Hz\"}]}";
    let play = "effects=[\"stiffness_step\", \"torques\", \"damping\", \"backlash\"]";
    let keys = [&ALL[1..3], &[play, "parameters.b=\"0.02 rad\"", swing]].concat();
    let exact = run(&keys);
    assert!(exact.counts.impacts > 4 && exact.counts.cell_changes > 4, "{:?}", exact.counts);
    assert!(residual(&exact) < 1e-13, "{:e}", residual(&exact));
    let steps = run(&[&keys[..], &["run.method=dop853", "run.tolerance=1e-12"]].concat());
    assert_eq!(steps.counts.cell_changes, exact.counts.cell_changes);
    assert_eq!(steps.counts.impacts, exact.counts.impacts);
    let off = crate::methods::tests::difference(&steps.trajectory, &exact.trajectory);
    assert!(off < 1e-8 && residual(&steps) < 1e-9, "{off:e} {:e}", residual(&steps));
}

/// A pair at rest at a boundary of the stiffness, with its flanks just in contact, under a torque that rises from zero. Its first
/// displacements are below the rounding error of its state. They must not be taken for a separation of the flanks.
#[test]
fn rounding_errors_do_not_separate_flanks_at_rest() {
    for (phase, impacts) in [("90 deg", 3), ("-90 deg", 0)] {
        let swing = format!(
            "parameters.T0={{mean=\"0 N*m\", harmonics=[{{amplitude=\"5 N*m\", frequency=\"200 Hz\", phase=\"{phase}\"}}]}}"
        );
        let play = "effects=[\"stiffness_step\", \"torques\", \"damping\", \"backlash\"]";
        let rest =
            [play, "parameters.b=\"31.5e-3 rad\"", "start={speed=\"0 rpm\"}", "run.t_end=2 ms", "output.events=false"];
        let keys = [&ALL[1..3], &rest, &[&swing]].concat();
        let exact = run(&keys);
        let steps = run(&[&keys[..], &["run.method=dop853", "run.tolerance=1e-11"]].concat());
        assert_eq!((exact.counts.impacts, steps.counts.impacts), (impacts, impacts), "{phase}");
        let off = crate::methods::tests::difference(&steps.trajectory, &exact.trajectory);
        assert!(off < 1e-8, "{phase}: {off:e}");
    }
}

/// The same with shafts. The torque acts through a shaft, so the first displacements grow with the fifth power of time, far below the
/// rounding error of the balanced forces.
#[test]
fn a_train_at_rest_with_play_starts_up() {
    let run = |overrides: &[&str]| {
        let rest = [
            "effects=[\"stiffness_step\", \"damping\", \"torques\", \"backlash\"]",
            "parameters.b12=0.1 mm",
            "parameters.alpha_M=5 1/s",
            "parameters.T_motor={ramp={from=\"0 N*m\", to=\"240 N*m\", duration=\"50 ms\"}}",
            "parameters.T_load=0 N*m",
            "start.theta=0.5 rad",
            "run.t_end=60 ms",
            "output={rate=\"5 kHz\", events=false}",
        ];
        run_of(TRAIN, &[&rest[..], overrides].concat())
    };
    // Also with a damper at the mesh, and with a torque that begins as the sine of a rounded angle and may separate the flanks.
    let damped = "parameters.beta_K=2 us";
    let pulls = "parameters.T_motor={harmonics=[{amplitude=\"200 N*m\", frequency=\"50 Hz\", phase=\"90 deg\"}]}";
    for start in ["start.theta=0.5 rad", "start.theta=0 rad"] {
        for more in [&[start][..], &[start, damped], &[start, pulls], &[start, pulls, damped]] {
            let exact = run(more);
            let changes = exact.counts.cell_changes + exact.counts.impacts;
            assert!(changes > 4 && residual(&exact) < 1e-12, "{more:?} {:?} {:e}", exact.counts, residual(&exact));
        }
    }
    // The numerical method is compared only if rounding errors do not decide in which cell the phase starts.
    let exact = run(&[]);
    let steps = run(&["run.method=dop853", "run.tolerance=1e-12"]);
    assert_eq!(steps.counts.cell_changes, exact.counts.cell_changes);
    let off = crate::methods::tests::difference(&steps.trajectory, &exact.trajectory);
    assert!(off < 1e-6, "{off:e}");
}

/// A load slightly larger than the motor torque presses the gear back against a step, where it is held. The motor torque rises and
/// releases it.
#[test]
fn a_rising_torque_releases_a_held_contact() {
    let held = run_of(
        TRAIN,
        &[
            "parameters.alpha_M=3000 1/s",
            "parameters.T_motor={ramp={from=\"235 N*m\", to=\"245 N*m\", start=\"0.1 s\", duration=\"0.4 s\"}}",
            "parameters.T_load=960 N*m",
            "start.theta=1e-3 rad",
            "run.t_end=0.5 s",
            "output.rate=1 kHz",
        ],
    );
    assert!(held.counts.reflections > 0 && held.counts.holds > 0, "{:?}", held.counts);
    let t = &held.trajectory;
    // The phase is held when the ramp begins, and stays held until the torques are in balance at 0.3 s.
    let speed = |at: f64| t.q_dot[0][t.t.iter().position(|t| *t >= at).unwrap()];
    assert!(speed(0.1).abs() < 1e-15, "{:e} {:?}", speed(0.1), held.counts);
    assert!(
        speed(0.28).abs() < 1e-15 && speed(0.35) > 0.0 && speed(0.45) > speed(0.35),
        "{} {}",
        speed(0.28),
        speed(0.35)
    );
    assert!(residual(&held) < 1e-10, "{:e}", residual(&held));
}
