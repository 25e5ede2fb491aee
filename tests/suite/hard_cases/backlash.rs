//! Row 11: backlash. Both flanks, contact lost at a step of the stiffness, a damper that would pull.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_8, PI};

use gearsim::__private::Simulation;
use gearsim::__private::equations::DerivedModel;
use gearsim::__private::models::GearPair;
use gearsim::scene::{Effects, Scene};

use crate::case::{Case, NONE, count, largest};
use crate::common;
use crate::models::residual;
use crate::noise::Noise;
use crate::rattle::{apart_by_steps, before, constants, rattling, rk4};

pub const CASES: &[Case] = &[
    Case {
        row: "11",
        name: "an undamped rotor that crosses its play 1000 times",
        proves: "contact lasts pi/w, flight b/v: position and speed after 1000 crossings, in closed form",
        tolerance: 1e-11,
        unit: "of b, of v",
        reason: "2000 events, each with a few rounding errors of its time",
        measure: crossed_play,
    },
    Case {
        row: "11",
        name: "the backlash example of the Modelica Standard Library",
        proves: "states at 0.02, 0.03, 0.05 s; times where the torque is clipped and where edges are met, as published",
        tolerance: 1e-5,
        unit: "of 90 deg, of 66 rad/s, of 0.05 s",
        reason: "the published result is a numerical integration with this error; the comparison with an integration by small steps, below, holds ours to 1e-7",
        measure: published,
    },
    Case {
        row: "11",
        name: "contact lost at a step of the stiffness",
        proves: "after the step the damper would pull more than the softer spring pushes: the force is zero at once, the flight ballistic",
        tolerance: 1e-12,
        unit: "of the motion's sizes",
        reason: "rounding errors of a few closed forms",
        measure: let_go,
    },
    Case {
        row: "11",
        name: "held at a step that vanishes when the flanks separate",
        proves: "theta rests until the deflection is zero; then both coordinates move under the torque alone, in closed form",
        tolerance: 1e-12,
        unit: "of the motion's sizes",
        reason: "rounding errors of closed forms",
        measure: held,
    },
    Case {
        row: "11",
        name: "flanks without a load that touch to rounding, beside gears that turn",
        proves: "rounding errors of the deflection are no events: the largest number of events in 0.1 s at 4500 rpm, beside those of the mesh",
        tolerance: 40.0,
        unit: "events",
        reason: "a deflection that moves by less than its rounding error cannot tell on which side of the edge it is; four changes without a motion are followed, then it must pass the edge by the rounding error",
        measure: touching,
    },
    Case {
        row: "11",
        name: "random gear pairs that rattle: contact forces",
        proves: "at every event the contact force does not pull, and the damper does not push more than the spring",
        tolerance: 1e-12,
        unit: "of the forces' sizes",
        reason: "rounding errors of the penetration, which is small compared with the play",
        measure: pulls,
    },
    Case {
        row: "11",
        name: "gear pairs that rattle: the energy account",
        proves: "the account closes, with clipped dampers and reflections",
        tolerance: 1e-12,
        unit: "of the energy at the start",
        reason: "about 1000 events, each with a few rounding errors",
        measure: accounted,
    },
    Case {
        row: "11",
        name: "compared with an integration by small steps of a right-hand side with min and max",
        proves: "another algorithm, without events, gives the same motion on both flanks",
        tolerance: 1e-7,
        unit: "of b, of v",
        reason: "the integration steps across the kinks of the force",
        measure: integrated,
    },
    Case {
        row: "11",
        name: "gear pairs that rattle, at constant stiffness, and their mirror images",
        proves: "drive and coast flank are treated alike: the same rows and impacts, and mostly the same numbers",
        tolerance: 1e-11,
        unit: "of the motion's sizes",
        reason: "the flank that is searched second has a shorter search, which may end one rounding apart; impacts amplify it",
        measure: mirrored,
    },
    Case {
        row: "11",
        name: "gear pairs that rattle, by dop853",
        proves: "a step method that finds the edges on its dense output and clips dampers gives the same contacts and the same end",
        tolerance: 1e-8,
        unit: "of the motion's sizes",
        reason: "the tolerance of the steps, 1e-13, times its growth by impacts and steps of stiffness",
        measure: by_steps,
    },
    Case {
        row: "11",
        name: "play without a size",
        proves: "refused before the run, with a named error",
        tolerance: 0.0,
        unit: "not refused",
        reason: NONE,
        measure: refused,
    },
];

fn oscillator(overrides: &[&str]) -> Scene {
    common::scene("backlash_oscillator", &overrides.iter().map(|s| s.to_string()).collect::<Vec<_>>())
}

/// Starts at the edge of the play, and a few units in the last place away from it.
fn touching(note: &mut String) -> f64 {
    let edge = 5e-4_f64;
    let starts = [0, 1, 2, 4, 8, 40]
        .into_iter()
        .flat_map(|ulps: u64| [f64::from_bits(edge.to_bits() + ulps), f64::from_bits(edge.to_bits() - ulps)]);
    let mut mesh = 0;
    let events = starts.map(|phi| {
        let scene = common::scene(
            "oh2005/spectrum_4500rpm_rigid",
            &[
                "effects=[\"damping\", \"backlash\", \"rigid_kinematics\", \"stiffness_step\"]".into(),
                "parameters.b=\"1e-3 rad\"".into(),
                format!("start.phi=\"{phi:?} rad\""),
                "start.theta=\"-5.662020397690919 rad\"".into(),
                "run.t_end=0.1 s".into(),
            ],
        );
        let run = common::run(&scene);
        mesh = run.counts.cell_changes;
        before(&run.trajectory).count() as f64 - mesh as f64
    });
    let worst = largest(events);
    *note = format!("12 starts, {mesh} steps of the mesh");
    worst
}

fn crossed_play(_: &mut String) -> f64 {
    // Starts at the edge of the drive flank, moving outwards. One round is contact, flight, contact, flight.
    let (v, half, w) = (7.0, FRAC_PI_8, (20e3f64 / 5.0).sqrt());
    let round = 2.0 * (PI / w + 2.0 * half / v);
    let t_end = format!("run.t_end={:?} s", 500.0 * round + 0.25 * half / v);
    let start = [format!("start.phi={half:?} rad"), format!("start.speed={v:?} rad/s"), t_end];
    let mut overrides = vec![r#"effects=["backlash"]"#, "output.rate=\"1 Hz\""];
    overrides.extend(start.iter().map(String::as_str));
    let outcome = common::run(&oscillator(&overrides));
    if outcome.counts.impacts != 1000 {
        return f64::INFINITY;
    }
    // The end is after 500 rounds and a short time in the next contact.
    let after = 0.25 * half / v;
    let run = &outcome.trajectory;
    let (phi, speed) = (run.q[0][run.len() - 1], run.q_dot[0][run.len() - 1]);
    let expected = [half + v / w * (w * after).sin(), v * (w * after).cos()];
    largest([(phi - expected[0]).abs() / (2.0 * half), (speed - expected[1]).abs() / v])
}

/// Scales of phi [rad], of its speed [rad/s], and of the time [s].
const SIZES: [f64; 3] = [FRAC_PI_2, 66.0, 0.05];

fn published(_: &mut String) -> f64 {
    let states =
        [(0.02, 0.798241640, -64.4100489), (0.03, 0.138452743, -66.1964950), (0.05, -1.078364326, -42.5653991)];
    let at = |t: f64| {
        let run = common::run(&oscillator(&[&format!("run.t_end={t:?} s"), "output.rate=\"10 Hz\""])).trajectory;
        (run.q[0][run.len() - 1], run.q_dot[0][run.len() - 1])
    };
    let states = states.into_iter().flat_map(|(t, phi, speed)| {
        let ours = at(t);
        [(ours.0 - phi) / SIZES[0], (ours.1 - speed) / SIZES[1]]
    });
    let run = common::run(&oscillator(&["run.t_end=0.04 s"])).trajectory;
    let met: Vec<f64> = before(&run).map(|i| run.t[i]).collect();
    let times = [0.0236592180, 0.0261592175, 0.0380238663];
    let times = times.iter().zip(&met).map(|(printed, ours)| (ours - printed) / SIZES[2]);
    largest(states.chain(times).map(f64::abs))
}

fn let_go(_: &mut String) -> f64 {
    let (zeta, half, t0) = (0.1, 0.01, 5.0);
    let (_, m2, c) = constants(zeta);
    // Just before the end of the stiffer cell, with x and v for which k x + C v is positive in this cell and negative in the next.
    let x = 1e-3;
    let v = -0.75 * 2780.0 * x / c;
    let scene = common::scene(
        "backlash",
        &[
            format!("parameters.zeta={zeta:?}"),
            format!("parameters.T0={t0:?} N*m"),
            format!("parameters.b={:?} rad", 2.0 * half),
            format!("start.theta={:?} rad", 2.0 * PI - 1e-9),
            format!("start.phi={:?} rad", half + x),
            format!("start.phi_dot={v:?} rad/s"),
            "run.t_end=1 ms".into(),
        ],
    );
    let run = common::run(&scene).trajectory;
    let events: Vec<usize> = before(&run).collect();
    let (switch, edge) = (events[0] + 1, events[1]);
    let force = |i: usize, k: f64| k * (run.q[1][i] - half) + c * run.q_dot[1][i];
    if !(force(switch - 1, 2780.0) > 0.0 && force(switch, 1430.0) < 0.0) {
        return f64::INFINITY;
    }
    // The flight to the edge under the torque alone: phi'' = M2 T0.
    let (x, v, t) = (run.q[1][switch] - half, run.q_dot[1][switch], run.t[edge] - run.t[switch]);
    let (phi, speed) = (x + v * t + 0.5 * m2 * t0 * t * t, v + m2 * t0 * t);
    largest([(run.q[1][edge] - half).abs() / half, phi.abs() / x, (run.q_dot[1][edge] - speed).abs() / v.abs()])
}

fn held(_: &mut String) -> f64 {
    let (t0, half) = (-10.0, 0.02);
    let (m1, m2, _) = constants(0.0);
    let inertia: f64 = 2890e-6 / 576.0 + 740200e-6 / 9216.0;
    // T0 < 0. With theta held, phi swings about its rest, |T0|/k1 inside the edge, with an amplitude of 3 |T0|/k1, until it is at the
    // edge.
    let (rest, w) = (10.0 / 1430.0, (2.0 * 1430.0 / inertia).sqrt());
    let (met, speed) = ((1.0f64 / 3.0).acos() / w, -3.0 * rest * w * (1.0f64 - 1.0 / 9.0).sqrt());
    let after = 1e-4;
    let scene = common::scene(
        "backlash",
        &[
            r#"effects=["stiffness_step", "backlash", "torques"]"#.into(),
            format!("parameters.T0={t0:?} N*m"),
            format!("parameters.b={:?} rad", 2.0 * half),
            "start.speed=0 rpm".into(),
            format!("start.phi={:?} rad", half + 2.0 * rest),
            format!("run.t_end={:?} s", met + after),
        ],
    );
    let outcome = common::run(&scene);
    let run = &outcome.trajectory;
    let last = run.len() - 1;
    let expected = [
        (run.q[0][last], 0.5 * m1 * t0 * after * after, half),
        (run.q[1][last], half + speed * after + 0.5 * m2 * t0 * after * after, half),
        (run.q_dot[0][last], m1 * t0 * after, speed.abs()),
        (run.q_dot[1][last], speed + m2 * t0 * after, speed.abs()),
    ];
    if outcome.counts.holds != 1 || residual(&outcome) > 1e-14 {
        return f64::INFINITY;
    }
    largest(expected.map(|(ours, closed, size)| (ours - closed).abs() / size))
}

fn pulls(note: &mut String) -> f64 {
    let mut noise = Noise::new(1101);
    let (mut events, mut regimes) = (0, std::collections::HashSet::new());
    let worst = (0..60).map(|_| {
        let scene = rattling(&mut noise, &[]);
        let zeta = scene.parameter("zeta").expect("a parameter");
        let equations = DerivedModel::of::<GearPair>().equations(&scene).expect("effects that go together");
        let mut simulation = Simulation::new(&*equations, &scene).expect("a system");
        let (_, _, c) = constants(zeta);
        let c = c * (scene.laws[0].mid() / ((1430.0 + 2780.0) / 2.0)).sqrt();
        let mut worst = 0.0f64;
        let mut over = false;
        while !over {
            over = simulation.step(&mut None).expect("a run");
            events += 1;
            let ([k, .., edge, damp, clip, _], switch) = (&simulation.now.k[..], &simulation.now.switches[0]) else {
                unreachable!()
            };
            let mode = switch.here().name;
            regimes.insert(mode);
            if mode == "free" {
                continue;
            }
            let side = edge.signum();
            let x = side * (switch.normal.dot(&simulation.now.state.q) - edge);
            let (spring, damper) = (k * x, c * side * simulation.now.state.q_dot[1]);
            // The contact force by its definition, and by the law values that the engine uses.
            let force = spring + damper.clamp(-spring.abs(), spring.abs());
            let ours = k * x * (1.0 + clip) + damp * damper;
            let size = spring.abs() + damper.abs() + k * edge.abs();
            let wrong = match mode.split_once('_') {
                None => damper - spring,
                Some((_, "hit")) => spring - damper,
                Some(_) => spring + damper,
            };
            worst = largest([worst, -ours / size, wrong / size, (ours - force).abs() / size]);
        }
        worst
    });
    let worst = largest(worst);
    *note = format!("60 scenes, {events} events");
    if regimes.len() == 7 { worst } else { f64::INFINITY }
}

fn accounted(note: &mut String) -> f64 {
    let mut noise = Noise::new(1102);
    let outcomes: Vec<_> = (0..60).map(|_| common::run(&rattling(&mut noise, &[]))).collect();
    let total = |of: fn(&gearsim::run::Counts) -> u64| outcomes.iter().map(|o| of(&o.counts)).sum::<u64>();
    let (impacts, reflections, holds) = (total(|c| c.impacts), total(|c| c.reflections), total(|c| c.holds));
    *note = format!("60 scenes, {impacts} impacts, {reflections} reflections, {holds} holds");
    largest(outcomes.iter().map(residual))
}

fn integrated(_: &mut String) -> f64 {
    let (zeta, half, t0, k, t_end) = (0.05, 0.005, 2.0, 2105.0, 4e-3);
    let scene = common::scene(
        "backlash",
        &[
            r#"effects=["backlash", "damping", "torques"]"#.into(),
            format!("parameters.zeta={zeta:?}"),
            format!("parameters.T0={t0:?} N*m"),
            format!("parameters.b={:?} rad", 2.0 * half),
            "start.phi_dot=-150 rad/s".into(),
            format!("run.t_end={t_end:?} s"),
        ],
    );
    let outcome = common::run(&scene);
    let run = &outcome.trajectory;
    if outcome.counts.impacts < 6 {
        return f64::INFINITY;
    }
    let (_, m2, c) = constants(zeta);
    let rate = |[phi, v]: [f64; 2]| {
        let x = phi.abs() - half;
        let force = if x > 0.0 { k * x + (c * v * phi.signum()).clamp(-k * x, k * x) } else { 0.0 };
        [v, m2 * (t0 - force * phi.signum())]
    };
    let y = rk4(rate, [run.q[1][0], run.q_dot[1][0]], t_end, 4_000_000);
    let last = run.len() - 1;
    largest([(run.q[1][last] - y[0]).abs() / (2.0 * half), (run.q_dot[1][last] - y[1]).abs() / 150.0])
}

fn mirrored(note: &mut String) -> f64 {
    let mut noise = Noise::new(1103);
    let (mut rows, mut same) = (0, 0);
    let worst = largest((0..30).map(|_| {
        let mut scene = rattling(&mut noise, &[]);
        scene.effects = Effects::from_names(["backlash", "damping", "torques"], scene.model).expect("effects");
        let mut mirror = scene.clone();
        let t0 = scene.model.parameters.iter().position(|p| p.name == "T0").expect("a parameter");
        mirror.parameters[t0] = -scene.parameters[t0];
        mirror.start.motions[0] = -scene.start.motions[0];
        for q in &mut mirror.start.q {
            if let gearsim::model::Start::At(x) = q {
                *x = -*x;
            }
        }
        mirror.start.q_dot.iter_mut().flatten().for_each(|v| *v = -*v);
        let [a, b] = [&scene, &mirror].map(common::run);
        let counts = a.counts.impacts != b.counts.impacts;
        let (a, b) = (&a.trajectory, &b.trajectory);
        if counts || a.len() != b.len() {
            return f64::INFINITY;
        }
        rows += a.len();
        let equal = |i: usize| a.t[i] == b.t[i] && a.q[1][i] == -b.q[1][i] && a.q_dot[1][i] == -b.q_dot[1][i];
        same += (0..a.len()).filter(|&i| equal(i)).count();
        let apart = |a: &[f64], b: &[f64], sign: f64| {
            let size = largest(a.iter().map(|x| x.abs()));
            largest(a.iter().zip(b).map(|(a, b)| (a - sign * b).abs() / size))
        };
        largest([apart(&a.t, &b.t, 1.0), apart(&a.q[1], &b.q[1], -1.0), apart(&a.q_dot[1], &b.q_dot[1], -1.0)])
    }));
    *note = format!("30 scenes, {rows} rows, {same} with the same numbers");
    worst
}

fn by_steps(note: &mut String) -> f64 {
    let mut noise = Noise::new(1104);
    apart_by_steps((0..20).map(|_| rattling(&mut noise, &[])), note)
}

fn refused(_: &mut String) -> f64 {
    let without = |line: &str| {
        let path = common::root().join("models/scenes/backlash.toml");
        let text = std::fs::read_to_string(&path).expect("a scene");
        let text: String = text.lines().filter(|l| !l.starts_with(line)).map(|l| format!("{l}\n")).collect();
        let errors = Scene::parse("case", "case.toml", &text, &[], &common::models()).err();
        errors.map(|errors| errors.render(100, false)).unwrap_or_default()
    };
    count([!without("b =").contains("`b`")])
}
