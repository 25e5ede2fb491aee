//! A train whose flanks are out of contact is several independent systems, and a damper acts on only one of them.
//!
//! The train is the reducer of an electric car: motor and gear 1, gears 2 and 3, gear 4 and the vehicle, each pair on its own shaft.
//! The coordinates are a phase and a deflection for each mesh and the twists of the outer shafts, as in the models. The damper acts
//! on one body alone, as that of a governor or a DC motor does.

use gearsim::__private::{Matrices, Modal};
use nalgebra::{DMatrix, DVector};

const INERTIAS: [f64; 6] = [0.05, 3e-4, 6e-3, 5e-4, 0.08, 144.0];
const SHAFTS: [(usize, usize, f64); 3] = [(0, 1, 2e4), (2, 3, 5e5), (4, 5, 1.6e4)];
const MESHES: [(usize, f64); 2] = [(1, 4e8), (3, 6e8)];

/// The matrix from the coordinates (theta1, s1, theta3, s3, psi_m, psi_w) to the rotations of the six bodies.
fn rotations() -> DMatrix<f64> {
    let [(n1, n2, r1), (n3, n4, r3)] = [(23.0, 59.0, 0.025), (19.0, 71.0, 0.027)];
    let first = [[1.0 / n1, 0.5 / r1], [1.0 / n2, -0.5 * n1 / (r1 * n2)]];
    let second = [[1.0 / n3, 0.5 / r3], [1.0 / n4, -0.5 * n3 / (r3 * n4)]];
    let row = |pair: [f64; 2], second: bool, psi: [f64; 2]| match second {
        false => [pair[0], pair[1], 0.0, 0.0, psi[0], psi[1]],
        true => [0.0, 0.0, pair[0], pair[1], psi[0], psi[1]],
    };
    let rows = [
        row(first[0], false, [1.0, 0.0]),
        row(first[0], false, [0.0, 0.0]),
        row(first[1], false, [0.0, 0.0]),
        row(second[0], true, [0.0, 0.0]),
        row(second[1], true, [0.0, 0.0]),
        row(second[1], true, [0.0, -1.0]),
    ];
    DMatrix::from_fn(6, 6, |i, j| rows[i][j])
}

/// The train with these meshes in contact and a damper `c` \[N m s/rad\] on body `damped`.
fn train(contact: [bool; 2], damped: usize, c: f64) -> Matrices {
    let t = rotations();
    let seen = |a: &DMatrix<f64>| {
        let a = t.transpose() * a * &t;
        0.5 * (&a + a.transpose())
    };
    let mut shafts = DMatrix::zeros(6, 6);
    for (i, j, k) in SHAFTS {
        shafts[(i, i)] += k;
        shafts[(j, j)] += k;
        shafts[(i, j)] -= k;
        shafts[(j, i)] -= k;
    }
    let mut stiffness = seen(&shafts);
    for ((coordinate, k), _) in MESHES.into_iter().zip(contact).filter(|(_, contact)| *contact) {
        stiffness[(coordinate, coordinate)] += k;
    }
    let mut damping = DMatrix::zeros(6, 6);
    damping[(damped, damped)] = c;
    let inverse = t.clone().try_inverse().expect("coordinates that determine the rotations");
    let mobility =
        &inverse * DMatrix::from_diagonal(&DVector::from_row_slice(&INERTIAS.map(|i| 1.0 / i))) * inverse.transpose();
    Matrices {
        mass: seen(&DMatrix::from_diagonal(&DVector::from_row_slice(&INERTIAS))),
        mobility: 0.5 * (&mobility + mobility.transpose()),
        damping: seen(&damping),
        stiffness,
        load: DVector::zeros(6),
    }
}

/// For every combination of contacts, damper coefficient and damped body the modes are found. The sum of their decay rates 2 sigma is
/// the trace of M⁻¹C. Two bodies on a shaft that the damper does not reach have an undamped mode at their own frequency.
#[test]
fn parts_out_of_contact_have_independent_modes() {
    for contact in [[false, false], [true, false], [false, true], [true, true]] {
        for (damped, inertia) in INERTIAS.into_iter().enumerate() {
            for c in [1e-4, 0.01, 0.05, 0.3, 1.0, 5.0, 10.0, 100.0, 1e3] {
                let modal = Modal::of(&train(contact, damped, c));
                let modal = modal.unwrap_or_else(|refusal| panic!("{contact:?}, {c} on body {damped}: {refusal}"));
                let modes = modal.coupled.as_ref().map_or(&modal.modes, |coupled| &coupled.modes);
                let decays: f64 = modes.iter().map(|mode| 2.0 * mode.sigma).sum();
                let trace = c / inertia;
                assert!((decays / trace - 1.0).abs() < 1e-9, "{contact:?}, {c} on body {damped}: {decays} for {trace}");
                // The two bodies at each end of the train, if their mesh is out of contact.
                for (mesh, shaft, bodies) in [(0, SHAFTS[0], [0, 1]), (1, SHAFTS[2], [4, 5])] {
                    if contact[mesh] || bodies.contains(&damped) {
                        continue;
                    }
                    let square = shaft.2 * (1.0 / INERTIAS[shaft.0] + 1.0 / INERTIAS[shaft.1]);
                    let own = modes.iter().find(|mode| (mode.omega2 / square - 1.0).abs() < 1e-10);
                    assert_eq!(own.map(|mode| mode.sigma), Some(0.0), "{contact:?}, {c} on body {damped}: {modes:?}");
                }
            }
        }
    }
}
