//! The derivatives of the accelerations, which implicit methods need, against differences of the accelerations.

use gearsim::__private::equations::{Equations, accelerated};
use gearsim::__private::{Inside, Matrix, Vector};

use super::common;

fn check(name: &str, q: &[f64], v: &[f64]) {
    let scene = common::scene(name, &[]);
    let entry = gearsim::models().iter().find(|entry| entry.model.name == scene.model.name).expect("a known model");
    let equations: Box<dyn Equations> = entry.equations(&scene).expect("effects that do not contradict one another");
    assert!(!equations.is_inertia_constant());
    let k = scene.model.in_contact(scene.mids());
    let none = vec![0.0; scene.model.laws.len()];
    let acceleration = |q: &[f64], v: &[f64]| equations.acceleration(q, v, &k, &none);
    let a = acceleration(q, v);
    let [mut by_q, by_v] = equations.jacobian(q, v, &k, &none, &none);
    by_q -= equations.inertia(q, &a);
    let derived = accelerated(&equations.mobility(q), [by_q, by_v]);
    let difference = |which: usize, j: usize| -> Vector {
        let h = 1e-5 * if which == 0 { [1.0, 1e-5][j] } else { [10.0, 1e-2][j] };
        let at = |sign: f64| {
            let (mut q, mut v) = (q.to_vec(), v.to_vec());
            if which == 0 {
                q[j] += sign * h
            } else {
                v[j] += sign * h
            }
            acceleration(&q, &v)
        };
        (at(1.0) - &at(-1.0)) * (0.5 / h)
    };
    for (which, derived) in derived.iter().enumerate() {
        let numeric = Matrix::from_fn(2, 2, |i, j| difference(which, j)[i]);
        for i in 0..2 {
            for j in 0..2 {
                // Relative to the largest of the row, in units in which the coordinates are of one size.
                let size =
                    (0..2).map(|j| (numeric[(i, j)] * [1.0, 1e-5][j]).abs()).fold(0.0, f64::max) / [1.0, 1e-5][j];
                let error = (derived[(i, j)] - numeric[(i, j)]).abs();
                assert!(error < 1e-5 * size, "{name}: {which} {i} {j}: {} is not {}", derived[(i, j)], numeric[(i, j)]);
            }
        }
    }
}

#[test]
fn derivatives_of_the_accelerations_include_those_of_the_inertia() {
    for theta in [3.0, 40.0, 111.0, 260.0] {
        check("crank_drive", &[theta, 2e-6], &[1500.0, -3e-3]);
        check("cardan_drive", &[theta, 2e-6], &[2000.0, -3e-3]);
    }
}
