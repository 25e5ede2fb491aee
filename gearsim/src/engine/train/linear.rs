//! What is constant in a train: the forces f - k x - c x' of the parts whose factors do not change, the inertias of all parts, and the
//! displacements along which torques work.

use crate::engine::equations::Equations;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::scene::BALANCED;

/// A row of R: its entries that are not zero, each with its coordinate.
#[derive(Debug, Clone)]
pub(super) struct Sparse(Box<[(u32, f64)]>);

impl Sparse {
    pub fn of(row: impl Iterator<Item = f64>) -> Sparse {
        Sparse(row.enumerate().filter(|(_, x)| *x != 0.0).map(|(i, x)| (i as u32, x)).collect())
    }

    #[inline]
    pub fn dot(&self, q: &[f64]) -> f64 {
        self.0.iter().map(|&(i, x)| x * q[i as usize]).sum()
    }

    /// The products with two vectors.
    #[inline]
    pub fn dot_both(&self, q: &[f64], q_dot: &[f64]) -> (f64, f64) {
        let (mut x, mut x_dot) = (0.0, 0.0);
        // With equal lengths the compiler leaves out the second bounds check.
        let q_dot = &q_dot[..q.len()];
        for &(i, factor) in &*self.0 {
            x += factor * q[i as usize];
            x_dot += factor * q_dot[i as usize];
        }
        (x, x_dot)
    }

    /// Adds a multiple of the row.
    #[inline]
    pub fn add_to(&self, factor: f64, sum: &mut [f64]) {
        self.0.iter().for_each(|&(i, x)| sum[i as usize] += factor * x);
    }
}

/// A sum of multiples of rows. An entry whose terms cancel to rounding errors is zero.
#[derive(Debug)]
pub(super) struct Balance {
    sum: Vector,
    size: Vector,
}

impl Balance {
    /// The empty sum over `n` coordinates.
    pub fn zero(n: usize) -> Balance {
        Balance { sum: Vector::zeros(n), size: Vector::zeros(n) }
    }

    /// Adds a multiple of a row.
    pub fn add(&mut self, factor: f64, row: &Sparse) {
        for &(i, x) in &*row.0 {
            self.sum[i as usize] += factor * x;
            self.size[i as usize] += (factor * x).abs();
        }
    }

    /// The sum.
    pub fn total(self) -> Vector {
        let entry = |i: usize| if self.sum[i].abs() <= BALANCED * self.size[i] { 0.0 } else { self.sum[i] };
        Vector::from_fn(self.sum.len(), entry)
    }
}

/// A spring and a damper along a coordinate of a part.
#[derive(Debug)]
struct Spring {
    row: Sparse,
    stiffness: f64,
    damping: f64,
}

/// The springs, dampers and loads of all parts with constant factors.
#[derive(Debug)]
pub(super) struct ConstantParts {
    springs: Vec<Spring>,
    load: Vector,
}

impl ConstantParts {
    /// The springs and dampers of `parts`, each with one coordinate, in a train with `n` coordinates. The factors are those of the derived
    /// cells.
    pub fn of<'a>(n: usize, parts: impl Iterator<Item = (&'a dyn Equations, &'a [Sparse])>) -> ConstantParts {
        let (mut springs, mut load): (Vec<Spring>, _) = (vec![], Balance::zero(n));
        for (equations, rows) in parts {
            let (stiffness, damping, force) = (equations.stiffness(&[]), equations.damping(&[]), equations.load(&[]));
            for (i, row) in rows.iter().enumerate() {
                load.add(force[i], row);
                let (stiffness, damping) = (stiffness[(i, i)], damping[(i, i)]);
                if stiffness != 0.0 || damping != 0.0 {
                    springs.push(Spring { row: row.clone(), stiffness, damping });
                }
            }
        }
        ConstantParts { springs, load: load.total() }
    }

    pub fn potential(&self, q: &[f64]) -> f64 {
        self.springs.iter().map(|spring| spring.stiffness * spring.row.dot(q).powi(2) / 2.0).sum()
    }

    pub fn dissipation(&self, q_dot: &[f64]) -> f64 {
        self.springs.iter().map(|spring| spring.damping * spring.row.dot(q_dot).powi(2) / 2.0).sum()
    }

    /// Writes the forces.
    pub fn write_force(&self, q: &[f64], q_dot: &[f64], force: &mut [f64]) {
        force.copy_from_slice(&self.load);
        for Spring { row, stiffness, damping } in &self.springs {
            let (x, x_dot) = row.dot_both(q, q_dot);
            row.add_to(-(stiffness * x + damping * x_dot), force);
        }
    }
}

/// The kinetic energy as a sum of squares: each has a mass, and its speed is a combination of those of the train.
#[derive(Debug)]
pub(super) struct Inertias(Vec<(f64, Sparse)>);

impl Inertias {
    /// The inertias of parts with the mass matrices m and the matrices R. With m = L D L^T, the energy of a part is the sum of
    /// D_i (L^T R q')_i^2/2.
    pub fn of<'a>(parts: impl Iterator<Item = (Matrix, &'a Matrix)>) -> Inertias {
        let mut squares = vec![];
        for (mut m, rows) in parts {
            let n = m.nrows();
            for i in 0..n {
                // The rows before i are already eliminated. A mass of zero has no energy.
                let mass = m[(i, i)];
                if mass == 0.0 {
                    continue;
                }
                let factors: Vec<f64> = (0..n).map(|j| m[(j, i)] / mass).collect();
                let speed = (0..rows.ncols()).map(|c| (i..n).map(|j| factors[j] * rows[(j, c)]).sum());
                squares.push((mass, Sparse::of(speed)));
                for (a, b) in (i + 1..n).flat_map(|a| (i + 1..n).map(move |b| (a, b))) {
                    m[(a, b)] -= factors[a] * mass * factors[b];
                }
            }
        }
        Inertias(squares)
    }

    /// T \[J\] with these speeds.
    pub fn kinetic(&self, q_dot: &[f64]) -> f64 {
        self.0.iter().map(|(mass, speed)| mass * speed.dot(q_dot).powi(2) / 2.0).sum()
    }
}
