//! A part of a train with its equations, in its place.

use super::linear::Sparse;
use crate::engine::equations::{Affine, Equations};
use crate::engine::vector::{Matrix, Vector};
use crate::model::Model;
use crate::scene::Effects;
use crate::train::Part;

/// Largest number of coordinates, speeds and values of an element that are kept on the stack.
const NUMBERS: usize = 16;

/// A part with its equations.
pub(super) struct Placed {
    pub part: Part,
    pub equations: Box<dyn Equations>,
    /// R.
    pub rows: Vec<Sparse>,
    /// R as a matrix, for sums of matrices.
    pub matrix: Matrix,
    /// Index of the first of its numbers x, x' and values among those of all parts.
    pub place: usize,
    /// Whether its forces are linear in x and x', with constant factors.
    pub is_constant: bool,
    /// Whether they are linear while the values of its laws and switches do not change.
    pub is_linear: bool,
}

impl Placed {
    pub fn new(part: Part, effects: &Effects, model: &Model, equations: Box<dyn Equations>, rows: &Matrix) -> Placed {
        let is_linear = effects.nonlinear(model).is_empty();
        let is_constant = is_linear && model.laws.is_empty() && model.switches.is_empty();
        let of_row = |i| Sparse::of(rows.row(i).iter().copied());
        let sparse = (0..rows.nrows()).map(of_row).collect();
        Placed { part, equations, rows: sparse, matrix: rows.clone(), place: 0, is_constant, is_linear }
    }

    /// Total number of its x, x' and values.
    pub fn numbers(&self) -> usize {
        2 * self.rows.len() + self.part.values.len()
    }

    /// Its coordinates, or their rates.
    #[inline]
    pub fn at(&self, q: &[f64]) -> Vector {
        Vector::from_fn(self.rows.len(), |i| self.rows[i].dot(q))
    }

    /// The values of its laws and symbols.
    #[inline]
    pub fn values(&self, k: &[f64]) -> Vector {
        Vector::from_fn(self.part.values.len(), |i| k[self.part.values[i]])
    }

    /// The derivatives of its laws; absent ones are zero.
    #[inline]
    pub fn slopes(&self, dk: &[f64]) -> Vector {
        Vector::from_fn(self.part.laws, |i| dk.get(self.part.values[i]).copied().unwrap_or(0.0))
    }

    /// Writes x, x' and the values of its laws and symbols at a state of the train [q, q', values].
    // Inlined: as a call it takes one percent more instructions for a row of outputs.
    #[inline(always)]
    pub fn localise(&self, [q, q_dot, k]: [&[f64]; 3], numbers: &mut [f64]) {
        let n = self.rows.len();
        let (x, rest) = numbers.split_at_mut(n);
        let (x_dot, values) = rest.split_at_mut(n);
        for i in 0..n {
            (x[i], x_dot[i]) = self.rows[i].dot_both(q, q_dot);
        }
        // By index: a `zip` of the two slices is not inlined here, and takes longer than the copies.
        for (i, &value) in self.part.values.iter().enumerate() {
            values[i] = k[value];
        }
    }

    /// Splits these numbers into x, x' and the values.
    #[inline]
    pub fn split<'n>(&self, numbers: &'n [f64]) -> [&'n [f64]; 3] {
        let (x, rest) = numbers.split_at(self.rows.len());
        let (x_dot, values) = rest.split_at(x.len());
        [x, x_dot, values]
    }

    /// Evaluates `of` with x, x' and the values at a state of the train. It is called at every step; a small element therefore has its
    /// numbers in an array.
    #[inline]
    pub fn at_state<T>(&self, state: [&[f64]; 3], of: impl FnOnce(&dyn Equations, [&[f64]; 3]) -> T) -> T {
        let mut array = [0.0; NUMBERS];
        let mut vector = vec![];
        let count = self.numbers();
        let numbers = if count <= NUMBERS {
            &mut array[..count]
        } else {
            vector.resize(count, 0.0);
            &mut vector[..]
        };
        self.localise(state, numbers);
        of(&*self.equations, self.split(numbers))
    }

    /// Its dissipation function [W] at a state of the train.
    #[inline]
    pub fn dissipation(&self, state: [&[f64]; 3]) -> f64 {
        self.at_state(state, |equations, [x, x_dot, k]| equations.dissipation(x, x_dot, k))
    }

    /// Adds its forces; `dk` are the slopes of the laws of the train.
    #[inline]
    pub fn add_force(&self, [q, q_dot, k, dk]: [&[f64]; 4], force: &mut [f64]) {
        let mut own = Vector::zeros(self.rows.len());
        let slopes = self.slopes(dk);
        self.at_state([q, q_dot, k], |equations, [x, x_dot, k]| equations.write_force(x, x_dot, k, &slopes, &mut own));
        self.rows.iter().zip(own.iter()).filter(|(_, f)| **f != 0.0).for_each(|(row, f)| row.add_to(*f, force));
    }

    /// Its mass matrix, which is constant.
    pub fn mass(&self) -> Matrix {
        self.equations.mass(&Vector::zeros(self.rows.len()))
    }

    /// The work of its torque `i`, without the part that varies, per displacement of each of the `n` coordinates of the train.
    pub fn work(&self, i: usize, n: usize) -> Sparse {
        let own = self.rows.len();
        let unit = |j: usize| Vector::from_fn(own, |i| f64::from(u8::from(i == j)));
        let gradient = Vector::from_fn(own, |j| self.equations.torque_work(i, &unit(j)));
        Sparse::of(self.spread(&gradient, n).iter().copied())
    }

    /// Converts a gradient from its coordinates to those of the train.
    pub fn spread(&self, gradient: &Vector, n: usize) -> Vector {
        let mut sum = Vector::zeros(n);
        self.rows.iter().zip(gradient.iter()).for_each(|(row, x)| row.add_to(*x, &mut sum));
        sum
    }

    pub fn affine(&self, of: Affine, n: usize) -> Affine {
        let errors = of.errors.iter().map(|&(law, unit)| (self.part.values[law], unit)).collect();
        let (on_q, on_speed) = (self.spread(&of.on_q, n), self.spread(&of.on_speed, n));
        Affine { errors, on_q, on_speed, ..of }
    }
}
