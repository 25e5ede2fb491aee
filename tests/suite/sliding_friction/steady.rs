//! Friction linearised about the steady motion, in `modes` and `floquet`.

use std::f64::consts::TAU;

use gearsim::__private::Inside;
use gearsim::scene::Scene;

use crate::common::{model, scene};

/// The gear pair given by its teeth, with friction and damping. The load is small: steps of the stiffness, which the linear analysis has at
/// given times, then take no part of the energy of rotation.
fn pair(set: &[&str]) -> Scene {
    let mut all = vec![
        r#"effects=["stiffness_step", "sliding_friction", "torques", "damping"]"#,
        "parameters.mu=0.2",
        "parameters.zeta=0.1",
        "parameters.T0=\"1e-3 N*m\"",
        r#"laws.side={teeth_of="k"}"#,
        r#"laws.arm={teeth_of="k"}"#,
        "start.speed=\"3000 rpm\"",
        "run.tolerance=1e-13",
        "run.method=\"dop853\"",
    ];
    all.extend(set);
    scene("gear_pair_teeth", &all.iter().map(|s| s.to_string()).collect::<Vec<_>>())
}

/// phi and phi' at the end of a run, or at its start where `t_end` is zero.
fn end(scene: &Scene, t_end: f64, [phi, phi_dot]: [Option<f64>; 2]) -> [f64; 2] {
    let mut scene = scene.clone();
    scene.t_end = if t_end > 0.0 { t_end } else { 1e-12 };
    if let Some(phi) = phi {
        scene.start.q[1] = gearsim::model::Start::At(phi);
    }
    scene.start.q_dot[1] = phi_dot;
    let entry = model("gear_pair");
    let equations = entry.equations(&scene).unwrap();
    let mut simulation = entry.simulation(&scene, &*equations).unwrap();
    if t_end > 0.0 {
        simulation.run(None, &mut |_| {}).unwrap();
    }
    [simulation.now.state.q[1], simulation.now.state.q_dot[1]]
}

/// The monodromy matrix of the analysis has the trace and the determinant of the differences of the motion over a period, by dop853.
#[test]
fn multipliers_are_those_of_the_flow_of_the_numerical_solver() {
    for (mu, speed) in [("0", "3000 rpm"), ("0.2", "9000 rpm"), ("0.2", "3000 rpm")] {
        let scene = pair(&[&format!("parameters.mu={mu}"), &format!("start.speed=\"{speed}\"")]);
        let floquet = scene.floquet().unwrap();
        assert_eq!((floquet.multipliers.len(), floquet.rigid), (2, 1), "{:?}", floquet.multipliers);
        let steady = floquet.steady.as_ref().expect("friction is linearised");
        assert!(steady.terms.contains("F_mu") && steady.q_dot[0] > 0.0 && steady.q[1] > 0.0, "{steady:?}");
        let [phi, _] = end(&scene, 0.0, [None, None]);
        let (h, omega) = (0.01 * phi, TAU * floquet.natural);
        let flow = |start: [f64; 2]| end(&scene, floquet.period, start.map(Some));
        let [up, down] = [flow([phi + h, 0.0]), flow([phi - h, 0.0])];
        let [fast, slow] = [flow([phi, h * omega]), flow([phi, -h * omega])];
        let column = |a: [f64; 2], b: [f64; 2]| [(a[0] - b[0]) / (2.0 * h), (a[1] - b[1]) / (2.0 * h * omega)];
        let ([a, c], [b, d]) = (column(up, down), column(fast, slow));
        let [first, second] = [floquet.multipliers[0], floquet.multipliers[1]];
        let apart = [(first + second).re - (a + d), (first * second).re - (a * d - b * c)];
        println!("mu = {mu}, {speed}: trace {:.6}, determinant {:.6}, apart {apart:?}", a + d, a * d - b * c);
        assert!(apart.iter().all(|x| x.abs() < 2e-5), "mu = {mu}, {speed}: {apart:?}");
    }
    // Friction changes the multipliers by far more than that.
    let of = |mu: &str| pair(&[&format!("parameters.mu={mu}")]).floquet().unwrap().multipliers[0];
    assert!((of("0.2") - of("0")).norm() > 1e-3, "{} {}", of("0.2"), of("0"));
}

/// The linear analysis contains the friction of one flank only. Its result says so if the motion meets both flanks, and only then.
#[test]
fn a_steady_motion_that_meets_both_flanks_is_stated() {
    let says = |set: &[&str]| {
        let floquet = pair(set).floquet().unwrap();
        floquet.steady.expect("friction is linearised").both_flanks
    };
    // T0 over the mean stiffness, in phi.
    let deflection = {
        let scene = pair(&[r#"parameters.T0="10 N*m""#]);
        end(&scene, 0.0, [None, None])[0]
    };
    let error = r#"effects=["stiffness_step", "transmission_error", "sliding_friction", "torques", "damping"]"#;
    let wave =
        |part: f64| format!("laws.e={{ harmonics = [{{ order = 1, amplitude = \"{:?} rad\" }}] }}", part * deflection);
    let loaded = r#"parameters.T0="10 N*m""#;
    assert_eq!(says(&[loaded]), None);
    assert_eq!(says(&[loaded, error, &wave(0.7)]), None);
    let varied = says(&[loaded, error, &wave(1.3)]).expect("the error reverses the mesh force");
    assert!(varied.contains("`e`"), "{varied}");
    let unloaded = says(&[r#"parameters.T0="0 N*m""#]).expect("no load");
    assert!(unloaded.contains("no load"), "{unloaded}");
}

/// phi'' = (M1 F_theta + M2 F_phi)/2 with the mean laws: omega² = M2 k + mu k ((M1/2)(1/N1 + 1/N2) a + (M2/2)((1/N1 - 1/N2) a + 2 tan(alpha) s)).
#[test]
fn the_natural_frequency_with_friction_has_a_closed_form() {
    let scene = pair(&[]);
    let modes = scene.modes().unwrap();
    let value = |name: &str| scene.parameters[scene.model.parameters.iter().position(|p| p.name == name).unwrap()];
    let mean = |name: &str| scene.present().find(|(law, _)| law.name == name).unwrap().1.mean();
    let k = scene.present().next().unwrap().1.mid();
    let [n1, n2] = ["N1", "N2"].map(value);
    let (one, two) = (n1 * n1 / value("I1"), n2 * n2 / value("I2"));
    let (m1, m2) = (0.5 * (one - two), 0.5 * (one + two));
    let (arm, side) = (mean("arm"), mean("side"));
    let friction = 0.5 * m1 * (1.0 / n1 + 1.0 / n2) * arm
        + 0.5 * m2 * ((1.0 / n1 - 1.0 / n2) * arm + 2.0 * value("alpha").tan() * side);
    let expected = (m2 * k + value("mu") * k * friction).sqrt() / TAU;
    let [rigid, elastic] = &modes.modes[..] else { panic!("two modes: {:?}", modes.modes) };
    println!("{} Hz, without friction {} Hz", elastic.natural, (m2 * k).sqrt() / TAU);
    assert!(rigid.natural == 0.0 && (elastic.natural / expected - 1.0).abs() < 1e-6, "{} {expected}", elastic.natural);
}

/// The linearised matrices are differences of the forces: friction of the flanks, an induction motor, a fan.
#[test]
fn linearised_matrices_are_differences_of_the_forces() {
    for name in ["sliding_friction", "drives/fan_run_up"] {
        let scene = scene(name, &[]);
        let entry = model(scene.model.name);
        let (system, equations) = (entry.about_steady_motion(&scene).unwrap(), entry.equations(&scene).unwrap());
        let steady = system.steady().unwrap();
        let (n, flat) = (steady.q.len(), vec![0.0; scene.model.laws.len()]);
        let k = scene.model.in_contact(steady.means.iter().copied());
        let m = system.linearised(&steady.means).unwrap();
        for j in 0..n {
            let (mut up, mut down) = (steady.q.clone(), steady.q.clone());
            // Friction is nonlinear on the scale of the deflection, so that the step is a small part of it.
            let h = 1e-3 * steady.q[j].abs().max(1e-9);
            (up[j], down[j]) = (up[j] + h, down[j] - h);
            let force = |q: &[f64], v: &[f64]| equations.force(q, v, &k, &flat);
            let by_q = (force(&up, &steady.q_dot) - &force(&down, &steady.q_dot)) * (-0.5 / h);
            let (mut fast, mut slow) = (steady.q_dot.clone(), steady.q_dot.clone());
            let g = 1e-4 * steady.q_dot[j].abs().max(1e-3);
            (fast[j], slow[j]) = (fast[j] + g, slow[j] - g);
            let by_speed = (force(&steady.q, &fast) - &force(&steady.q, &slow)) * (-0.5 / g);
            let sizes = [m.stiffness.amax(), m.damping.amax()];
            for i in 0..n {
                assert!((by_q[i] - m.stiffness[(i, j)]).abs() <= 1e-5 * sizes[0], "{name}: K {i} {j}");
                assert!((by_speed[i] - m.damping[(i, j)]).abs() <= 1e-5 * sizes[1], "{name}: C {i} {j}");
            }
        }
    }
}
