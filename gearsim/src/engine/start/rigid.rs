//! Rigid motions: motions that no spring resists. At the start of a run they may accelerate, while nothing vibrates.
//!
//! The external forces F accelerate the rigid motions R, RᵀM R = 1, by c = RᵀF; the part M R c of the forces causes this. Friction and
//! clutches that hold rates, with the gradients N, prevent a part of these motions by the forces -N r. The held rates stay constant if
//! Nᵀ R c = 0. This gives c = RᵀF - G r, with G = RᵀN and r the solution of G r = RᵀF by least squares. If several holds can resist the
//! same force, least squares distributes it among them.

use nalgebra::{DMatrix, DVector};

use crate::engine::equations::Equations;
use crate::engine::vector::{Matrix, Vector};
use crate::scene::Scene;
use crate::tolerance::start;

/// Rigid motions at a place, orthonormal with respect to M.
pub struct RigidMotions {
    motions: Vec<Vector>,
    /// M r of each.
    momenta: Vec<Vector>,
    /// For each motion, the largest force along it that can be a rounding error where the forces are in balance.
    rounding: Vec<f64>,
    /// The holds that prevent a part of the rigid motions: the switch of each, and the gradient of the rate that it holds.
    holds: Vec<(usize, Vector)>,
}

impl RigidMotions {
    /// The rigid motions at the coordinates `q` (n). There are two kinds of candidates. The first are motions of one coordinate that is not
    /// `free`; they count if they do not deform `stiffness`, the matrix K of all potentials at `q`. The second are the rigid motions that
    /// the model declares for `[start]`; they count if they do not deform `springs`, K without nonlinear potentials. Example: gravity
    /// resists the rotation of a crank, but does not hold it. `sizes` are the absolute values of the forces (n) before they cancel one
    /// another.
    pub fn at(
        (equations, scene): (&dyn Equations, &Scene),
        q: &Vector,
        [stiffness, springs]: [&Matrix; 2],
        sizes: &Vector,
        free: &[usize],
    ) -> RigidMotions {
        let n = q.len();
        let mass = equations.mass(q);
        let given = (0..n).filter(|i| !free.contains(i));
        let alone = given.map(|i| Vector::from_fn(n, |j| f64::from(u8::from(i == j))));
        let alone = alone.filter(|motion| is_free(stiffness, &mass, motion));
        let declared = (0..scene.model.motions.len()).map(|i| equations.motion(i));
        let declared = declared.filter(|motion| is_free(springs, &mass, motion));
        let mut rigid = RigidMotions { motions: vec![], momenta: vec![], rounding: vec![], holds: vec![] };
        for motion in alone.chain(declared) {
            rigid.add(motion, &mass);
        }
        rigid.rounding = rigid.motions.iter().map(|motion| start::BALANCED * motion.abs().dot(sizes)).collect();
        rigid
    }

    /// Adds the part of a motion that is independent of the motions before, if it is more than a rounding error.
    fn add(&mut self, motion: Vector, mass: &Matrix) {
        let size = motion.dot(&(mass * &motion));
        let mut rest = motion;
        for (known, momentum) in self.motions.iter().zip(&self.momenta) {
            rest.add_times(-momentum.dot(&rest), known);
        }
        let momentum = mass * &rest;
        let left = rest.dot(&momentum);
        if left > start::SAME_MOTION * size {
            self.motions.push(&rest * (1.0 / left.sqrt()));
            self.momenta.push(&momentum * (1.0 / left.sqrt()));
        }
    }

    /// Lets a switch hold the rate with the gradient `normal` (n), if rigid motions take part in it.
    pub fn hold(&mut self, switch: usize, normal: Vector, mobility: &Matrix) {
        let compliance = normal.dot(&(mobility * &normal));
        let of_rigid: f64 = self.motions.iter().map(|motion| motion.dot(&normal).powi(2)).sum();
        if of_rigid > start::TAKES_PART * compliance {
            self.holds.push((switch, normal));
        }
    }

    /// The force r that each hold resists, with the index of its switch.
    pub fn reactions(&self, external: &Vector) -> Vec<(usize, f64)> {
        self.balance(external).1
    }

    /// c and r.
    fn balance(&self, external: &Vector) -> (DVector<f64>, Vec<(usize, f64)>) {
        let mut along = DVector::from_iterator(self.motions.len(), self.motions.iter().map(|r| r.dot(external)));
        let mut reactions = vec![];
        if !self.holds.is_empty() && !self.motions.is_empty() {
            let holds =
                DMatrix::from_fn(self.motions.len(), self.holds.len(), |i, j| self.motions[i].dot(&self.holds[j].1));
            let svd = holds.clone().svd(true, true);
            let least = start::TAKES_PART.sqrt() * svd.singular_values.max();
            // It fails only if U or V were not computed.
            let r = svd.solve(&along, least).unwrap_or_else(|_| DVector::zeros(self.holds.len()));
            along -= holds * &r;
            reactions = self.holds.iter().zip(r.iter()).map(|((switch, _), r)| (*switch, *r)).collect();
        }
        along.iter_mut().zip(&self.rounding).filter(|(c, rounding)| c.abs() <= **rounding).for_each(|(c, _)| *c = 0.0);
        (along, reactions)
    }

    /// The sum of the forces (n) and the forces of the holds, minus the part M R c, by which the `external` forces accelerate the rigid
    /// motions. In a static start the sum is zero at the static coordinates.
    pub fn without(&self, mut force: Vector, external: &Vector) -> Vector {
        let (accelerations, reactions) = self.balance(external);
        for (c, momentum) in accelerations.iter().zip(&self.momenta).filter(|(c, _)| **c != 0.0) {
            force.add_times(-c, momentum);
        }
        for ((_, r), (_, normal)) in reactions.iter().zip(&self.holds) {
            force.add_times(-r, normal);
        }
        force
    }
}

/// Whether a motion does not deform the springs. Its strain energy is then only a rounding error: of the terms of this energy, or of the
/// energy of the stiffest coordinate at the same kinetic energy.
fn is_free(stiffness: &Matrix, mass: &Matrix, motion: &Vector) -> bool {
    let n = motion.len();
    let (mut energy, mut size) = (0.0, 0.0);
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let term = motion[i] * stiffness[(i, j)] * motion[j];
        energy += term;
        size += f64::abs(term);
    }
    let stiffest = (0..n).map(|i| (stiffness[(i, i)] / mass[(i, i)]).abs()).fold(0.0, f64::max);
    f64::abs(energy) <= start::STRAINED * size.max(stiffest * motion.dot(&(mass * motion)))
}
