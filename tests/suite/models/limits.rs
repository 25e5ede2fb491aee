//! Limits: a model with very stiff shafts or bearings approaches the model without them. The difference falls as one over the
//! stiffness.

use gearsim::__private::models::{PlanarPlanetary3, Planetary3};
use gearsim::run::Outcome;
use gearsim::scene::Scene;

use crate::common::{model, models, root, run};
use crate::train::train;

pub const TESTS: &[(&str, fn())] = &[
    ("a_gear_pair_with_stiff_shafts_approaches_the_plain_gear_pair", stiff_shafts),
    ("a_gear_pair_with_stiff_bearings_approaches_the_plain_gear_pair", stiff_bearings),
    ("a_planar_planetary_with_stiff_bearings_approaches_the_torsional_one", stiff_planetaries),
    ("a_planar_planetary_with_play_and_stiff_bearings_approaches_the_torsional_one", stiff_planetaries_with_play),
];

const N1: f64 = 24.0;
const N2: f64 = 96.0;
const R1: f64 = 0.0716;
/// Total inertias of the two shafts [kg m²], and the parts of them that are motor and load.
const I: [f64; 2] = [4.1e-3, 0.94];
const OUTER: [f64; 2] = [1.2e-3, 0.2];

/// The plain gear pair. Its stiffness [N m] belongs to phi; it is computed from `K`, which acts along the line of action.
fn plain() -> Outcome {
    // V = k s^2/2 with s = 2 h phi is 2 k h^2 phi^2.
    let kt = |k: f64| 2.0 * k * (R1 / N1).powi(2);
    let scene = format!(
        r#"
model = "gear_pair"
effects = ["stiffness_step", "rigid_kinematics", "torques"]
parameters = {{ N1 = {N1}, N2 = {N2}, I1 = "{i1} kg*m^2", I2 = "{i2} kg*m^2", T0 = "{t0} N*m" }}
laws.k.steps = [{{ value = "{k1} N*m", width = "1.73 rad" }}, {{ value = "{k2} N*m" }}]
start = {{ speed = "{SPEED} rad/s", phi = 0 }}
run.t_end = "{T_END} s"
output = {{ rate = "{RATE} Hz", events = false }}
"#,
        i1 = I[0],
        i2 = I[1],
        t0 = T1 / N1,
        k1 = kt(K[0]),
        k2 = kt(K[1]),
    );
    run_text(&scene)
}

/// Driving torque [N m], mesh stiffnesses [N/m], speed [rad/s], and run time [s]: a few mesh periods and a few periods of the
/// natural frequency.
const T1: f64 = 240.0;
const K: [f64; 2] = [8.0e7, 15.6e7];
const SPEED: f64 = 30.0;
const T_END: f64 = 0.02;
const RATE: f64 = 10_000.0;

fn run_text(text: &str) -> Outcome {
    let scene = Scene::parse("limit", "limit.toml", text, &[], &models());
    run(&scene.unwrap_or_else(|errors| panic!("{}\n{text}", errors.render(100, false))))
}

/// The scene of a pair with shafts or bearings, without the jump terms. An impulse at the teeth acts only on the gears, however
/// stiff the shafts and bearings are, so with jump terms the limit is a different one.
fn scene(model: &str, parameters: &str) -> String {
    format!(
        r#"
model = "{model}"
effects = ["stiffness_step", "rigid_kinematics", "torques"]
parameters = {{ N1 = {N1}, N2 = {N2}, r1 = "{R1} m", T_motor = "{T1} N*m", T_load = "{load} N*m", {parameters} }}
laws.k12.steps = [{{ value = "{k1} N/m", width = "1.73 rad" }}, {{ value = "{k2} N/m" }}]
start = {{ speed = "{SPEED} rad/s", s = 0 }}
run.t_end = "{T_END} s"
output = {{ rate = "{RATE} Hz", events = false }}
"#,
        load = T1 * N2 / N1,
        k1 = K[0],
        k2 = K[1],
    )
}

/// Largest difference of the mesh deflections of two runs [m]. `mesh` gives the deflection of the second run at a row.
fn difference(plain: &Outcome, other: &Outcome, mesh: impl Fn(usize) -> f64) -> f64 {
    assert_eq!(plain.trajectory.len(), other.trajectory.len(), "the number of samples");
    let phi = &plain.trajectory.q[1];
    (0..phi.len()).map(|row| (2.0 * R1 / N1 * phi[row] - mesh(row)).abs()).fold(0.0, f64::max)
}

/// Checks that differences fall as one over the stiffness: the slope of their logarithms from the first to the last is -1.
fn assert_slope_minus_one(what: &str, stiffness: &[f64], differences: &[f64], tolerance: f64) {
    let (k, d) = (stiffness, differences);
    let last = k.len() - 1;
    let slope = (d[last] / d[0]).ln() / (k[last] / k[0]).ln();
    println!("{what}: {differences:?} for {stiffness:?}: slope {slope:.4}");
    assert!((slope + 1.0).abs() < tolerance, "{what}: {differences:?} falls with a slope of {slope}");
}

fn column(outcome: &Outcome, name: &str) -> Vec<f64> {
    let coordinates = outcome.trajectory.model.coordinates;
    outcome.trajectory.q[coordinates.iter().position(|c| c.name == name).expect("a coordinate")].clone()
}

fn stiff_shafts() {
    let plain = plain();
    let stiffness = [1e9, 1e10, 1e11, 1e12];
    let differences = stiffness.map(|k: f64| {
        let parameters = format!(
            "I_m = '{m} kg*m^2', I1 = '{i1} kg*m^2', I2 = '{i2} kg*m^2', I_l = '{l} kg*m^2', k_m = '{k} N*m', k_l = '{k} N*m'",
            m = OUTER[0],
            i1 = I[0] - OUTER[0],
            i2 = I[1] - OUTER[1],
            l = OUTER[1],
        );
        let other = run_text(&scene("gear_pair_shafts", &parameters));
        let s = column(&other, "s");
        difference(&plain, &other, |row| s[row])
    });
    // The stiff mode reaches its extremes between samples, so the samples may miss a tenth of its amplitude.
    assert_slope_minus_one("shafts", &stiffness, &differences, 0.02);
}

fn stiff_bearings() {
    let plain = plain();
    let (sin, cos) = 20f64.to_radians().sin_cos();
    let stiffness = [1e11, 1e12, 1e13, 1e14];
    let differences = stiffness.map(|k: f64| {
        let parameters = format!(
            "I1 = '{} kg*m^2', I2 = '{} kg*m^2', m1 = '0.6 kg', m2 = '8 kg', kb1 = '{k} N/m', kb2 = '{k} N/m'",
            I[0], I[1]
        );
        let other = run_text(&scene("gear_pair_bearings", &parameters));
        let [s, x1, y1, x2, y2] = ["s", "x1", "y1", "x2", "y2"].map(|name| column(&other, name));
        difference(&plain, &other, |row| s[row] + (x1[row] - x2[row]) * sin + (y1[row] - y2[row]) * cos)
    });
    assert_slope_minus_one("bearings", &stiffness, &differences, 0.02);
}

/// With stiff bearings a planar planetary has the frequencies of the torsional one; its other frequencies grow without bound.
fn stiff_planetaries() {
    let stage = [
        ("Z_s", 27.0),
        ("Z_r", 99.0),
        ("r_s", 0.0387),
        ("I_s", 6e-4),
        ("I_c", 0.05),
        ("I_r", 0.06),
        ("I_p", 1.5e-3),
        ("m_p", 0.66),
        ("k_r", 2e7),
        ("k_s1", 5e8),
        ("k_r1", 5e8),
        ("k_s2", 5e8),
        ("k_r2", 5e8),
        ("k_s3", 5e8),
        ("k_r3", 5e8),
        ("T_motor", 0.0),
        ("T_load", 0.0),
    ];
    let torsional = train::<Planetary3>(&stage).frequencies();
    let stiffness = [1e12, 1e13, 1e14];
    let differences = stiffness.map(|k| {
        let plane = [("m_s", 0.4), ("m_c", 5.43), ("m_r", 2.35), ("kb_s", k), ("kb_c", k), ("kb_r", k), ("kb_p", k)];
        let planar = train::<PlanarPlanetary3>(&[&stage[..], &plane].concat()).frequencies();
        // All but the rigid motion, whose frequency is zero in both.
        let off = torsional.iter().zip(&planar).skip(1).map(|(t, p)| (t - p).abs() / t);
        off.fold(0.0, f64::max)
    });
    assert_slope_minus_one("planetary", &stiffness, &differences, 0.01);
    assert!(model("planetary_3").model.coordinates.len() == torsional.len());
}

/// The same with play, in the motion instead of the frequencies. Both models start in the middle of their play, cross it under their
/// torques, and bounce.
fn stiff_planetaries_with_play() {
    let scene = |model: &str, planar: &[String]| {
        let path = root().join("models/scenes").join(format!("{model}.toml"));
        let text = std::fs::read_to_string(path).expect("a scene");
        let play = ["s1", "r1", "s2", "r2", "s3", "r3"].map(|mesh| format!("parameters.b_{mesh}=\"30 um\""));
        let zero = ["theta_c", "theta_r", "u1", "u2", "u3"].map(|q| format!("start.{q}=0"));
        let laws = ["s1", "r1", "s2", "r2", "s3", "r3"]
            .map(|mesh| format!("laws.k_{mesh}={{steps=[{{value=\"500 MN/m\"}}]}}"));
        let others = [
            "effects=[\"torques\",\"backlash\"]",
            "run={t_end=\"1 ms\",method=\"exact\"}",
            "output={rate=\"1 MHz\",events=false}",
        ];
        let all = others.map(String::from).into_iter().chain(play).chain(zero).chain(laws);
        let all: Vec<String> = all.chain(planar.iter().cloned()).collect();
        Scene::parse(model, model, &text, &all, &models()).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
    };
    let torsional = run(&scene("planetary_3", &[]));
    assert!(torsional.counts.impacts > 6, "{:?}", torsional.counts);
    let stiffness = [1e12, 1e13, 1e14];
    let names = ["theta_c", "theta_r", "u1", "u2", "u3"];
    let differences = stiffness.map(|k| {
        let bearings = ["s", "c", "r", "p"].map(|part| format!("parameters.kb_{part}=\"{k:e} N/m\""));
        let planar = run(&scene("planar_planetary_3", &bearings));
        assert_eq!(planar.counts.impacts, torsional.counts.impacts, "{k:e} N/m");
        assert_eq!(planar.trajectory.len(), torsional.trajectory.len());
        let off = names.map(|name| {
            let (a, b) = (column(&torsional, name), column(&planar, name));
            let size = a.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            a.iter().zip(&b).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
        });
        off.into_iter().fold(0.0, f64::max)
    });
    assert_slope_minus_one("planetary with play", &stiffness, &differences, 0.2);
}
