//! Whether a steady motion meets both flanks of a mesh. Friction of the flanks is proportional to the absolute value of the mesh force,
//! which has a kink where the force is zero. Linearised friction is therefore valid for one flank only. The derivatives of the forces show
//! the kink, so this module does not depend on the model of a mesh.

use crate::engine::equations::Equations;
use crate::engine::vector::{Matrix, Vector};
use crate::model::Role;
use crate::scene::Scene;
use crate::tolerance::analysis::{BEND, BEND_ROUNDING, NO_LOAD, NO_LOAD_PART};

/// Why the motion about the state `q`, `q_dot` (n each) with the law values `k` meets both flanks, in words; `None` if it does not:
///
/// - no load: the derivatives of the forces differ on the two sides of `q`;
/// - a transmission error that varies by more than the load deflects the flanks. At speed the gears cannot follow the error and stay at
///   their mean place. There the derivatives differ when the error is at an extreme.
pub fn both(equations: &dyn Equations, scene: &Scene, (q, q_dot): (&Vector, &Vector), k: &[f64]) -> Option<String> {
    let flat = vec![0.0; scene.model.laws.len()];
    let slopes = |q: &Vector, k: &[f64]| {
        let [by_q, _] = equations.jacobian(q, q_dot, k, &flat, &flat);
        by_q
    };
    let no_load = (0..q.len()).any(|i| {
        let step = NO_LOAD.max(NO_LOAD_PART * q[i].abs());
        let [mut up, mut down] = [q.clone(), q.clone()];
        (up[i], down[i]) = (q[i] + step, q[i] - step);
        differ(&slopes(&up, k), &slopes(&down, k))
    });
    if no_load {
        return Some("no load presses the flanks together".into());
    }
    let here = slopes(q, k);
    let reverses = |(i, mean, (least, largest)): (usize, f64, (f64, f64))| {
        [least, largest].into_iter().any(|extreme| {
            let mut other = k.to_vec();
            other[i] += extreme - mean;
            differ(&here, &slopes(q, &other))
        })
    };
    let errors = scene.present().enumerate().filter(|(_, (law, _))| law.role == Role::Error);
    let names: Vec<_> = errors
        .filter(|(i, (_, given))| reverses((*i, given.mean(), given.extremes())))
        .map(|(_, (law, _))| format!("`{}`", law.name))
        .collect();
    (!names.is_empty()).then(|| {
        format!("the transmission error {} varies by more than the load deflects the flanks", names.join(", "))
    })
}

/// Whether two matrices of derivatives (n x n) differ by more than rounding errors.
fn differ(a: &Matrix, b: &Matrix) -> bool {
    let least = BEND_ROUNDING * a.amax().max(b.amax());
    a.iter().zip(b.iter()).any(|(a, b)| {
        let apart = (a - b).abs();
        apart > least && apart > BEND * (a.abs() + b.abs())
    })
}
