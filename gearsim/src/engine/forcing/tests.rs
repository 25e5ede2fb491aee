//! Torques that vary in time against closed forms, an independent integration, and brute force.

use std::f64::consts::TAU;

use crate::engine::Refusal;
use crate::engine::equations::DerivedModel;
use crate::engine::simulate::Simulation;
use crate::engine::start;
use crate::generated::MODELS;
use crate::generated::gear_pair::GearPair;
use crate::model::Model;
use crate::run::Entry;
use crate::run::Outcome;
use crate::scene::Scene;

use super::Forcing;

/// The paper's gear pair at one stiffness, phi'' + 2 zeta w phi' + w² phi = M2 T0(t).
const SCENE: &str = r#"
model = "gear_pair"
effects = ["torques"]
[parameters]
I1 = "2890 kg*mm^2"
I2 = "740200 kg*mm^2"
T0 = "10 N*m"
[laws.k]
steps = [{ value = "2 kN*m" }]
[start]
theta_dot = "1000 rad/s"
phi = 0
[run]
t_end = "0.02 s"
[output]
rate = "20 kHz"
"#;
const K: f64 = 2000.0;
const M: [f64; 2] =
    [0.5 * (24.0 * 24.0 / 2.89e-3 - 96.0 * 96.0 / 0.7402), 0.5 * (24.0 * 24.0 / 2.89e-3 + 96.0 * 96.0 / 0.7402)];

fn omega() -> f64 {
    (M[1] * K).sqrt()
}

/// The same gears on shafts, between a motor and a load; what is to be set: torques, damping, start and end.
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

fn scene(overrides: &[&str]) -> Scene {
    parse(SCENE, overrides)
}

fn parse(text: &str, overrides: &[&str]) -> Scene {
    let overrides: Vec<_> = overrides.iter().map(|text| text.to_string()).collect();
    let models: Vec<&'static Model> = MODELS.iter().map(|m| m.model).collect();
    Scene::parse("test", "test", text, &overrides, &models).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

fn entry(scene: &Scene) -> &'static Entry {
    MODELS.iter().find(|m| m.model.name == scene.model.name).unwrap()
}

fn run(overrides: &[&str]) -> Outcome {
    run_of(SCENE, overrides)
}

fn run_of(text: &str, overrides: &[&str]) -> Outcome {
    let scene = parse(text, overrides);
    let outcome = entry(&scene).run(&scene, &mut |_| {}).unwrap();
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

/// The largest difference of phi and of phi' from closed forms of t, in units of the largest of each.
fn worst(outcome: &Outcome, phi: impl Fn(f64) -> [f64; 2]) -> f64 {
    let t = &outcome.trajectory;
    let expected: Vec<[f64; 2]> = t.t.iter().map(|t| phi(*t)).collect();
    let off = |column: &[f64], which: usize| {
        let size = expected.iter().fold(0.0f64, |m, e| m.max(e[which].abs()));
        column.iter().zip(&expected).fold(0.0f64, |m, (x, e)| m.max((x - e[which]).abs() / size))
    };
    off(&t.q[1], 0).max(off(&t.q_dot[1], 1))
}

/// The largest residual of the account, in units of the largest energy.
fn residual(outcome: &Outcome) -> f64 {
    let t = &outcome.trajectory;
    let size = t.kinetic.iter().chain(&t.work).fold(0.0f64, |m, x| m.max(x.abs()));
    t.residual.iter().fold(0.0f64, |m, x| m.max(x.abs())) / size
}

#[test]
fn ramps_have_closed_forms() {
    let (start, duration, to) = (2e-3, 7e-3, 12.0);
    let course = format!("parameters.T0={{ramp={{to=\"{to} N*m\", start=\"{start} s\", duration=\"{duration} s\"}}}}");
    let (w, slope) = (omega(), to / duration);
    // From rest on: slope/K (t - sin(w t)/w); what begins at the end takes it back.
    let from = |t: f64| match t > 0.0 {
        true => [slope / K * (t - (w * t).sin() / w), slope / K * (1.0 - (w * t).cos())],
        false => [0.0; 2],
    };
    let phi = |t: f64| {
        let (up, down) = (from(t - start), from(t - start - duration));
        [up[0] - down[0], up[1] - down[1]]
    };
    let outcome = run(&[&course]);
    assert_eq!(outcome.solver.method, "exact");
    assert!(worst(&outcome, phi) < 2e-13, "{:e}", worst(&outcome, phi));
    assert!(residual(&outcome) < 1e-13, "{:e}", residual(&outcome));
}

#[test]
fn rigid_motions_under_ramps_are_polynomials() {
    let course = "parameters.T0={ramp={from=\"-3 N*m\", to=\"5 N*m\", duration=\"0.02 s\"}}";
    let outcome = run(&[course, "laws.k.steps=[{value=0}]"]);
    let phi = |t: f64| [M[1] * (-1.5 * t * t + 400.0 / 6.0 * t.powi(3)), M[1] * (-3.0 * t + 200.0 * t * t)];
    assert!(worst(&outcome, phi) < 1e-14, "{:e}", worst(&outcome, phi));
    assert!(residual(&outcome) < 1e-14, "{:e}", residual(&outcome));
}

/// phi'' + 2 zeta w phi' + w² phi = M2 a cos(W t), from rest: off resonance, close to it, and on it, damped or not.
#[test]
fn harmonics_have_closed_forms_on_resonance_too() {
    let (w, a) = (omega(), 7.0);
    for (part, zeta) in [(0.3, 0.0), (1.0, 0.0), (1.0 + 1e-9, 0.0), (7.3, 0.0), (1.0, 0.03), (0.8, 0.03), (1.4, 1.2)] {
        let drive = part * w;
        let course =
            format!("parameters.T0={{harmonics=[{{amplitude=\"{a} N*m\", frequency=\"{:?} Hz\"}}]}}", drive / TAU);
        let outcome = run(&[
            &course,
            &format!("parameters.zeta={zeta:?}"),
            if zeta > 0.0 { "effects=[\"torques\", \"damping\"]" } else { "effects=[\"torques\"]" },
        ]);
        let phi = |t: f64| {
            if zeta == 0.0 {
                // Divided differences of the cosines, by the product formula: good on resonance.
                let (mean, half) = (0.5 * (drive + w), 0.5 * (drive - w));
                let sinc = if half == 0.0 { t } else { (half * t).sin() / half };
                let x = M[1] * a * sinc * (mean * t).sin() / (2.0 * mean);
                let cosine = (half * t).cos() * (mean * t).sin() + mean * sinc * (mean * t).cos();
                return [x, M[1] * a * cosine / (2.0 * mean)];
            }
            let (real, imaginary) = (w * w - drive * drive, 2.0 * zeta * w * drive);
            let size = M[1] * a / (real * real + imaginary * imaginary);
            // Steady: size (real cos + imaginary sin); free: what takes it to rest at the start.
            let (c, s) = (size * real, size * imaginary);
            let steady = [
                c * (drive * t).cos() + s * (drive * t).sin(),
                drive * (s * (drive * t).cos() - c * (drive * t).sin()),
            ];
            let (x, v) = (-c, -s * drive);
            let sigma = zeta * w;
            let mode = crate::engine::mode::Mode::new(sigma, w * w);
            let r = mode.response(t);
            let force = -w * w * x;
            let moved = x + v * r.s1 + force * r.s2;
            let speed = v + (force - 2.0 * sigma * v) * r.s1 - w * w * v * r.s2;
            [steady[0] + moved, steady[1] + speed]
        };
        assert!(worst(&outcome, phi) < 1e-12, "{part} {zeta}: {:e}", worst(&outcome, phi));
        assert!(residual(&outcome) < 1e-13, "{part} {zeta}: {:e}", residual(&outcome));
    }
}

/// Everything at once: steps of the stiffness with their jumps, damping, a table with harmonics on top.
const ALL: [&str; 4] = [
    "effects=[\"stiffness_step\", \"torques\", \"damping\"]",
    "parameters.zeta=0.05",
    "laws.k.steps=[{value=\"1.43 kN*m\", width=\"1.73 rad\"}, {value=\"2.78 kN*m\"}]",
    "parameters.T0={table=[{at=\"2 ms\", value=\"5 N*m\"}, {at=\"7 ms\", value=\"25 N*m\"}, {at=\"7.5 ms\", value=\"8 N*m\"}], \
     harmonics=[{amplitude=\"3 N*m\", frequency=\"4 kHz\", phase=\"20 deg\"}, {amplitude=\"2 N*m\", frequency=\"130 Hz\"}]}",
];

#[test]
fn an_independent_integration_agrees() {
    let exact = run(&ALL);
    assert!(exact.counts.cell_changes > 4 && residual(&exact) < 1e-13, "{:e}", residual(&exact));
    for (method, tolerance, bound) in [("dop853", 1e-12, 3e-10), ("radau", 1e-9, 1e-5)] {
        let keys = [format!("run.method={method}"), format!("run.tolerance={tolerance:e}")];
        let by = [&ALL[..], &[&keys[0], &keys[1]]].concat();
        let steps = run(&by);
        assert_eq!(steps.counts.cell_changes, exact.counts.cell_changes);
        let off = crate::methods::tests::difference(&steps.trajectory, &exact.trajectory);
        assert!(off < bound, "{method}: {off:e}");
        assert!(residual(&steps) < bound, "{method}: {:e}", residual(&steps));
        let work = |o: &Outcome| o.trajectory.torque_work.iter().map(|w| w[w.len() - 1]).collect::<Vec<_>>();
        let (a, b) = (work(&steps), work(&exact));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= bound * b.abs()), "{method}: {a:?} {b:?}");
    }
}

/// Flanks that part and meet under a torque that swings through zero: the exact solver and a method by steps pass the same events.
#[test]
fn play_goes_with_torques_that_vary() {
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

/// A pair at rest, its flanks just touching at a boundary of the stiffness, under a torque that begins from nothing: what it
/// moves at first is below the rounding of its state, in which no flank must be seen to part.
#[test]
fn flanks_at_rest_do_not_rattle() {
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

/// At rest, flanks just touching at a boundary of the stiffness, under a torque that begins from nothing: what is pushed
/// through a shaft moves with the fifth power of time, far below the rounding of the forces that balance.
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
    // With a damper at the mesh, too; and where the torque at first pulls the flanks apart, the sine of a rounded angle.
    let damped = "parameters.beta_K=2 us";
    let pulls = "parameters.T_motor={harmonics=[{amplitude=\"200 N*m\", frequency=\"50 Hz\", phase=\"90 deg\"}]}";
    for start in ["start.theta=0.5 rad", "start.theta=0 rad"] {
        for more in [&[start][..], &[start, damped], &[start, pulls], &[start, pulls, damped]] {
            let exact = run(more);
            let changes = exact.counts.cell_changes + exact.counts.impacts;
            assert!(changes > 4 && residual(&exact) < 1e-12, "{more:?} {:?} {:e}", exact.counts, residual(&exact));
        }
    }
    // By steps only where no rounding of the phase at rest decides in which cell it begins.
    let exact = run(&[]);
    let steps = run(&["run.method=dop853", "run.tolerance=1e-12"]);
    assert_eq!(steps.counts.cell_changes, exact.counts.cell_changes);
    let off = crate::methods::tests::difference(&steps.trajectory, &exact.trajectory);
    assert!(off < 1e-6, "{off:e}");
}

/// Levels: cells are the ordinary ones between breakpoints; one of them falls on a sample, one on an event's neighbourhood.
#[test]
fn levels_are_constant_torques_one_after_another() {
    let steps = "parameters.T0={steps=[{value=\"5 N*m\", until=\"3 ms\"}, {value=\"30 N*m\", until=\"9 ms\"}, {value=\"-2 N*m\"}]}";
    let exact = run(&[ALL[0], ALL[1], ALL[2], steps]);
    let by = run(&[ALL[0], ALL[1], ALL[2], steps, "run.method=dop853", "run.tolerance=1e-13"]);
    let off = crate::methods::tests::difference(&by.trajectory, &exact.trajectory);
    assert!(off < 1e-10 && residual(&exact) < 1e-13, "{off:e} {:e}", residual(&exact));
    // A course that says what a number says is that number, to the last bit.
    let [number, course] = ["parameters.T0=\"12 N*m\"", "parameters.T0={mean=\"12 N*m\"}"].map(|t0| run(&[t0]));
    assert_eq!(number.trajectory.q, course.trajectory.q);
    assert_eq!(number.trajectory.work, course.trajectory.work);
}

#[test]
fn a_run_split_anywhere_is_the_whole() {
    let scene = scene(&ALL);
    let equations = DerivedModel::of::<GearPair>().equations(&scene).unwrap();
    let state = |splits: &[f64]| {
        let forcing = Forcing::of(&DerivedModel::of::<GearPair>(), &scene);
        let mut simulation =
            Simulation::exact(&*equations, &scene, start::begin(&*equations, &scene).unwrap(), forcing).unwrap();
        for t in splits.iter().chain([&scene.t_end]) {
            simulation.now.t_end = *t;
            simulation.run(None, &mut |_| {}).unwrap();
        }
        (
            simulation.now.state.q,
            simulation.now.state.q_dot,
            simulation.now.state.turns,
            simulation.now.counts.cell_changes,
        )
    };
    let whole = state(&[]);
    for splits in [&[0.007][..], &[0.002, 0.0075], &[1e-9, 0.00700001, 0.0199999]] {
        let split = state(splits);
        assert_eq!((&split.2, split.3), (&whole.2, whole.3));
        assert!((&split.0 - &whole.0).amax() < 1e-12 && (&split.1 - &whole.1).amax() < 1e-9, "{split:?} {whole:?}");
    }
}

/// A phase that a harmonic swings to and fro over boundaries which change nothing (levels of one value): each crossing of
/// the closed form, sampled finely, is there.
#[test]
fn no_crossing_is_missed() {
    let mut random = 12345u64;
    let mut fraction = || {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (random >> 11) as f64 / (1u64 << 53) as f64
    };
    let (w, mut crossings) = (omega(), 0);
    for case in 0..200 {
        let (drive, a) = (w * (0.2 + 2.0 * fraction()), 4000.0 * fraction());
        let (v, begin) = (400.0 * (fraction() - 0.5), TAU * fraction());
        let widths = [0.05 + 3.0 * fraction(), 0.01 + 3.0 * fraction()];
        let t_end = 4e-3;
        let outcome = run(&[
            "effects=[\"stiffness_step\", \"torques\"]",
            &format!("parameters.T0={{harmonics=[{{amplitude=\"{a:?} N*m\", frequency=\"{:?} Hz\"}}]}}", drive / TAU),
            &format!(
                "laws.k.steps=[{{value=\"2 kN*m\", width=\"{:?} rad\"}}, {{value=\"2 kN*m\", width=\"{:?} rad\"}}, {{value=\"2 kN*m\"}}]",
                widths[0], widths[1]
            ),
            &format!("start={{theta=\"{begin:?} rad\", theta_dot=\"{v:?} rad/s\", phi=0}}"),
            &format!("run.t_end=\"{t_end} s\""),
            "output.rate=\"1 kHz\"",
        ]);
        // theta'' = (M1/M2) phi'' where nothing damps.
        let frequency: f64 = format!("{:?}", drive / TAU).parse().unwrap();
        let drive = TAU * frequency;
        let (mean, half) = (0.5 * (drive + w), 0.5 * (drive - w));
        let phi = |t: f64| M[1] * a * (half * t).sin() / half * (mean * t).sin() / (2.0 * mean);
        let theta = |t: f64| begin + v * t + M[0] / M[1] * phi(t);
        let cell = |x: f64| {
            let (turn, rest) = ((x / TAU).floor() as i64, x.rem_euclid(TAU));
            3 * turn + i64::from(rest >= widths[0]) + i64::from(rest >= widths[0] + widths[1])
        };
        let (n, mut passed, mut last) = (100_000, 0, cell(theta(0.0)));
        for i in 1..=n {
            let now = cell(theta(t_end * f64::from(i) / f64::from(n)));
            passed += now.abs_diff(last);
            last = now;
        }
        let changes = outcome.counts.cell_changes;
        // Samples may step over a pair of crossings, the engine over none.
        assert!(
            changes >= passed && (changes - passed).is_multiple_of(2) && changes - passed <= 2,
            "{case}: {changes} {passed}"
        );
        crossings += passed;
    }
    assert!(crossings > 1000, "{crossings}");
}

/// What has no way with torques that vary says so, and an ensemble runs such a scene by itself.
#[test]
fn other_ways_refuse_or_stand_aside() {
    let compensated = scene(&[&ALL[..], &["run.precision=compensated"]].concat());
    let refusal = entry(&compensated).run(&compensated, &mut |_| {}).unwrap_err();
    assert_eq!(refusal, Refusal::CompensatedVarying { torques: "`T0`".into() });
    assert!(refusal.to_string().contains("varies in time (`T0`)"), "{refusal}");
    let equations = DerivedModel::of::<GearPair>().equations(&compensated).unwrap();
    let plain = Simulation::new(&*equations, &compensated).err();
    assert_eq!(plain, Some(Refusal::Varying { torques: "`T0`".into() }));
    let scenes = [scene(&ALL), scene(&ALL[..3])];
    let together = entry(&scenes[0]).ends(&scenes);
    let alone = run(&ALL);
    let end = |o: &Outcome| o.trajectory.q.iter().map(|q| q[q.len() - 1]).collect::<Vec<_>>();
    assert_eq!(end(together[0].as_ref().unwrap()), end(&alone));
}

/// A load that outweighs the motor a little presses the gear back against a step, where it comes to be held; the motor's
/// torque rises, and lets it go on.
#[test]
fn a_ramp_frees_what_is_held() {
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
    // Held as the ramp begins, and for as long as the load outweighs the motor: until 0.3 s, when the torques balance.
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
