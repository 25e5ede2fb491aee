//! The gear pair on bearings: accelerations from the flank forces as vectors in the plane, their moments about the centres, and the
//! equations of Newton and Euler.

use gearsim::__private::equations::Derived;
use gearsim::__private::models::GearPairBearings;

use crate::common;

type Vector = [f64; 2];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn plus(a: Vector, b: Vector, factor: f64) -> Vector {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}

/// Moment of a force about the origin of its arm, counterclockwise.
fn moment(arm: Vector, force: Vector) -> f64 {
    arm[0] * force[1] - arm[1] * force[0]
}

/// The vector turned by 90 degrees counterclockwise.
fn turned(a: Vector) -> Vector {
    [-a[1], a[0]]
}

const EFFECTS: &str = r#"effects=["stiffness_step", "sliding_friction", "torques"]"#;

/// Compares the accelerations of theta, s, x1, y1, x2, y2.
#[test]
fn accelerations_with_friction_agree_with_forces_as_vectors() {
    let scene = common::scene("sliding_friction", &[EFFECTS.into(), "parameters.mu12=0.2".into()]);
    let model = scene.model;
    let names: Vec<_> = model.coordinates.iter().map(|c| c.name).collect();
    assert_eq!(names, ["theta", "s", "x1", "y1", "x2", "y2"]);
    let of = |name: &str| scene.parameter(name).unwrap_or_else(|| panic!("no {name}"));
    let equations = GearPairBearings::equations(&scene.effects, &scene.parameters, &[scene.laws[0].mid()])
        .expect("effects that go together");
    let (n1, n2, r1, alpha) = (of("N1"), of("N2"), of("r1"), of("alpha"));
    let (h, r2) = (r1 / n1, r1 / n1 * n2);
    // The tooth pairs: distance from the pitch point along the line of action [m], and share of the force.
    let pairs = [(-7e-3, 0.3), (2e-3, 0.45), (9e-3, 0.25)];
    let side: f64 = pairs.iter().map(|(xi, share)| f64::signum(*xi) * share).sum();
    let arm: f64 = pairs.iter().map(|(xi, share)| f64::abs(*xi) * share).sum();
    let k = 1.3e8;
    for (q, v) in [
        ([0.7, 8e-5, 2e-6, -3e-6, 1e-6, 4e-6], [1500.0, 0.02, 3e-3, -2e-3, 1e-3, 5e-3]),
        ([2.7, 5e-5, -9e-6, 8e-6, 3e-6, -7e-6], [-900.0, -0.3, 0.1, 0.2, -0.1, 0.3]),
        ([2.7, -5e-5, 1e-6, 2e-6, -4e-6, 1e-6], [6.0, -0.3, 0.1, 0.2, -0.1, 0.3]),
    ] {
        let found = equations.acceleration(&q, &v, &model.in_contact([k, 0.0, side, arm]), &[0.0; 4]);

        let speeds = [(v[0] + v[1] / (2.0 * h)) / n1, (v[0] - v[1] / (2.0 * h)) / n2];
        let (c1, c2) = ([q[2], q[3]], [q[4], q[5]]);
        // The line of action, along which gear 1 pushes gear 2 when gear 1 turns counterclockwise. The centre of gear 1 is the origin,
        // that of gear 2 is on the x axis.
        let line = [alpha.sin(), alpha.cos()];
        let distance = [(r1 + r2) / alpha.cos(), 0.0];
        let force = k * (dot(line, plus(c1, c2, -1.0)) + q[1]);
        let mut on = [plus([0.0; 2], c1, -of("kb1")), plus([0.0; 2], c2, -of("kb2"))];
        let mut moments = [of("T_motor"), of("T_load")];
        for (xi, share) in pairs {
            let place = plus([r1 / alpha.cos(), 0.0], line, xi);
            let arms = [place, plus(place, distance, -1.0)];
            // Sliding speed across the line of action of rigid gears, gear 2 turning clockwise.
            let rolling = |w1: f64| {
                let flanks = plus([0.0; 2], turned(arms[0]), w1);
                dot(turned(line), plus(flanks, turned(arms[1]), w1 * r1 / r2))
            };
            let direction =
                rolling(1.0).signum() * (speeds[0] + speeds[1]) / (speeds[0] + speeds[1]).hypot(of("w_mix12"));
            let friction = of("mu12") * share * force.abs() * direction;
            let on_first = plus(plus([0.0; 2], line, -share * force), turned(line), -friction);
            for (i, sign) in [1.0, -1.0].into_iter().enumerate() {
                on[i] = plus(on[i], on_first, sign);
                moments[i] += sign * moment(arms[i], on_first);
            }
        }
        // Gear 2 turns clockwise; the load holds it back, so the load's moment is counterclockwise.
        let (a1, a2) = (moments[0] / of("I1"), -moments[1] / of("I2"));
        let expected = [
            (n1 * a1 + n2 * a2) / 2.0,
            h * (n1 * a1 - n2 * a2),
            on[0][0] / of("m1"),
            on[0][1] / of("m1"),
            on[1][0] / of("m2"),
            on[1][1] / of("m2"),
        ];
        for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
            assert!((found - expected).abs() < 1e-10 * expected.abs(), "{}: {found} for {expected}", names[i]);
        }
    }
}
