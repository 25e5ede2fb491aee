//! Tests of profiles: splines, ramps, mean and mid.

use std::f64::consts::TAU;

use super::*;

/// k, dk/ds and d²k/ds² at the phase `s` within the period.
fn at(stiffness: &Profile, s: f64) -> [f64; 3] {
    let mut begin = 0.0;
    for (curve, step) in stiffness.curves.iter().zip(&stiffness.steps) {
        if s < begin + step.width {
            return curve.at(s - begin);
        }
        begin += step.width;
    }
    stiffness.curves[stiffness.curves.len() - 1].at(stiffness.steps[stiffness.steps.len() - 1].width)
}

fn width(stiffness: &Profile) -> f64 {
    stiffness.steps.iter().map(|step| step.width).sum()
}

/// The spline passes through its points, and is twice continuously differentiable at its knots and at the end of the period.
#[test]
fn a_spline_interpolates_and_is_smooth_and_periodic() {
    let points = [(0.3, 1.0), (1.0, 3.0), (2.5, 2.0), (4.0, 2.5), (5.5, 0.5)];
    let spline = Profile::spline(&points, TAU).unwrap();
    assert!((width(&spline) - TAU).abs() < 1e-14);
    let same = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
    for (s, k) in points {
        assert!((at(&spline, s)[0] - k).abs() < 1e-13, "{s}");
        assert!(same(at(&spline, s - 1e-14), at(&spline, s + 1e-14)), "{s}");
    }
    assert!(same(at(&spline, 0.0), at(&spline, TAU)));
    assert_eq!(Profile::spline(&points[..2], TAU), None);
    assert_eq!(Profile::spline(&[(0.0, 1.0), (0.0, 2.0), (3.0, 1.0)], TAU), None);
}

/// The error of a spline through n points of a cosine is proportional to n⁻⁴.
#[test]
fn splines_converge_with_order_4() {
    let error = |n: usize| {
        let point = |i: usize| TAU * i as f64 / n as f64;
        let points: Vec<_> = (0..n).map(|i| (point(i), point(i).cos())).collect();
        let spline = Profile::spline(&points, TAU).unwrap();
        (0..1000).map(|i| TAU * f64::from(i) / 1000.0).fold(0.0f64, |m, s| m.max((at(&spline, s)[0] - s.cos()).abs()))
    };
    let order = (error(16) / error(64)).log2() / 2.0;
    assert!((order - 4.0).abs() < 0.2, "{order}");
}

#[test]
fn ramps_replace_steps_and_leave_the_law_continuous() {
    let steps = [(1.0, 2.0), (3.0, TAU - 2.0)].map(|(value, width)| Step { value, width });
    let stepping = Profile::stepping(steps.to_vec());
    for before in [0.0, 0.5, 1.0] {
        let ramped = stepping.ramped(0.1, before).unwrap();
        assert!((width(&ramped) - TAU).abs() < 1e-14);
        // The middle of the ramp, at half the height of the step.
        let middle = 2.0 + 0.1 * (0.5 - before);
        assert!((at(&ramped, middle)[0] - 2.0).abs() < 1e-12 && (at(&ramped, middle)[1] - 20.0).abs() < 1e-9);
        assert_eq!(ramped.extremes(), (1.0, 3.0));
        // The law is continuous, also across the end of the period.
        let ends = ramped.curves.iter().zip(&ramped.steps).map(|(c, s)| (c.at(0.0)[0], c.at(s.width)[0]));
        let ends: Vec<_> = ends.collect();
        assert!((0..ends.len()).all(|i| (ends[i].1 - ends[(i + 1) % ends.len()].0).abs() < 1e-12), "{ends:?}");
    }
    assert_eq!(stepping.ramped(2.1, 0.5), None);
}

#[test]
fn mid_is_between_the_extremes_and_mean_is_the_average() {
    let steps = vec![Step { value: 1.0, width: 3.0 }, Step { value: 5.0, width: 1.0 }];
    let stiffness = Profile::stepping(steps);
    assert_eq!(stiffness.mid(), 3.0);
    assert_eq!(stiffness.mean(), 2.0);
}
