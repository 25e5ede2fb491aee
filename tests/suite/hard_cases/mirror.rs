//! Row 10: reverse rotation, and speeds that pass zero.

use gearsim::__private::Side;
use gearsim::scene::Step;
use gearsim_tests::oh2005::{GearPair, PITCH, State};
use gearsim_tests::precise::{self, first_crossing};

use crate::case::{Case, NONE, WRONG, count, largest};
use crate::linear::{Linear, Met, first_from};
use crate::noise::Noise;
use crate::pair;

pub const CASES: &[Case] = &[
    Case {
        row: "10",
        name: "gear pairs and their mirror images",
        proves: "with theta, phi, T0 and the order of the steps reversed, times and states have the same bits",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: mirrored,
    },
    Case {
        row: "10",
        name: "x'' = -a: away, to rest, and back",
        proves: "no event at the turning point; the boundary behind is met at 2 v/a",
        tolerance: 4.0,
        unit: "eps t",
        reason: "the root of a quadratic whose coefficients are exact",
        measure: turning,
    },
    Case {
        row: "10",
        name: "speed that becomes zero just before or just beyond a boundary",
        proves: "v²/(2 a) decides, to 1e-14 of the way",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: height,
    },
    Case {
        row: "10",
        name: "a damped mode that slowly reverses",
        proves: "the boundary behind the turning point is met at the time given by 50 digits",
        tolerance: 8.0,
        unit: "eps (t + amplitude/slope)",
        reason: "one rounding error of the phase over its slope, and one of t",
        measure: damped,
    },
];

fn mirrored(note: &mut String) -> f64 {
    let mut noise = Noise::new(1001);
    let mut rows = 0;
    let wrong = (0..40).map(|_| {
        // The start angle is on a coarse grid and the width has few digits, so that PITCH - x is exact.
        let pair = GearPair { width1: 1.75, ..GearPair::paper(0.1 * noise.unit(), noise.power(0.0, 2.0)) };
        let standard = pair.start(noise.power(1.0, 3.5));
        let start = State { theta: (64.0 * PITCH * noise.unit()).round() / 64.0, phi_dot: noise.even(), ..standard };
        let scene = pair::scene(&pair, &start, 0.03);
        let State { theta, theta_dot, phi, phi_dot } = start;
        let back = State { theta: -theta, theta_dot: -theta_dot, phi: -phi, phi_dot: -phi_dot };
        let mut mirror = pair::scene(&GearPair { t0: -pair.t0, ..pair }, &back, 0.03);
        let steps = [(pair.k2, PITCH - pair.width1), (pair.k1, pair.width1)];
        mirror.laws[0].steps = steps.map(|(value, width)| Step { value, width }).into();
        let [a, b] = [&scene, &mirror].map(|scene| pair::of(scene).outcome);
        let (a, b, counts) = (&a.trajectory, &b.trajectory, a.counts != b.counts);
        rows += a.len();
        let differ = |a: &[f64], b: &[f64]| count(a.iter().zip(b).map(|(a, b)| a.to_bits() != b.to_bits()));
        let negated = |x: &[f64]| x.iter().map(|x| -x).collect::<Vec<_>>();
        differ(&a.t, &b.t)
            + differ(&a.q[1], &negated(&b.q[1]))
            + differ(&a.q_dot[0], &negated(&b.q_dot[0]))
            + differ(&a.q_dot[1], &negated(&b.q_dot[1]))
            + f64::from(u8::from(counts || a.len() != b.len()))
    });
    let wrong = wrong.sum();
    *note = format!("40 scenes, {rows} rows");
    wrong
}

fn turning(_: &mut String) -> f64 {
    let mut noise = Noise::new(1002);
    largest((0..10_000).map(|_| {
        let (v, a) = (noise.power(-6.0, 6.0).copysign(noise.even()), noise.power(-6.0, 6.0));
        let height = 0.5 * v * v / a;
        let gaps = if v > 0.0 { [0.0, 2.0 * height] } else { [2.0 * height, 0.0] };
        let met = first_from(&Linear::modal([(0.0, 0.0)], [-a.copysign(v)]), [v], gaps, f64::INFINITY);
        let behind = if v > 0.0 { Side::Lower } else { Side::Upper };
        let t = 2.0 * v.abs() / a;
        if met.side == Some(behind) { (met.t - t).abs() / (f64::EPSILON * t) } else { f64::INFINITY }
    }))
}

fn height(_: &mut String) -> f64 {
    let mut noise = Noise::new(1003);
    count((0..10_000).map(|_| {
        let (v, a) = (noise.power(-3.0, 3.0), noise.power(-3.0, 3.0));
        let depth = noise.power(-14.0, -1.0).copysign(noise.even());
        let height = 0.5 * v * v / a;
        let Met { side, .. } =
            first_from(&Linear::modal([(0.0, 0.0)], [-a]), [v], [0.0, height * (1.0 - depth)], f64::INFINITY);
        side != Some(if depth > 0.0 { Side::Upper } else { Side::Lower })
    }))
}

fn damped(_: &mut String) -> f64 {
    let mut noise = Noise::new(1004);
    largest((0..2000).map(|_| {
        let (zeta, force) = (noise.power(-2.0, 2.0), -noise.unit());
        let v = noise.power(-2.0, 1.0);
        let mode = precise::Mode { sigma: zeta, omega2: 1.0, force, x: 0.0, v, weight: -1.0 };
        let (level, far, horizon) = (0.5 * -force, 2.0 * v + 1.0, 1e4);
        let exact = first_crossing(&[mode], level, horizon).expect("it settles beyond the level");
        let met = first_from(&Linear::modal([(zeta, 1.0)], [force]), [v], [level, far], horizon);
        if met.side != Some(Side::Lower) {
            return f64::INFINITY;
        }
        let unit = f64::EPSILON * (exact.t.0 + (far + level) / exact.slope.abs());
        ((met.t - exact.t.0) - exact.t.1).abs() / unit
    }))
}
