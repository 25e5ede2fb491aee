//! Explicit Runge-Kutta methods, given by their tableaux.
//!
//! k_i = f(t + c_i h, y + h sum_j a_ij k_j). The argument of stage `last` is the state at the end of the step. The k of this stage is
//! therefore the first k of the next step.

use super::dense::Dense;
use super::field::Field;
use super::flow::{Flow, Scale};
use super::{Method, Trial};

/// The nonzero entries of a row of the tableau: index of k, and its factor.
pub type Row = &'static [(usize, f64)];

/// The tableau of a method.
#[derive(Debug, Clone, Copy)]
pub struct Tableau {
    /// Its name in scenes.
    pub name: &'static str,
    /// Its order.
    pub order: u32,
    /// a_ij, one row per stage.
    pub rows: &'static [Row],
    /// c_i, one per stage.
    pub nodes: &'static [f64],
    /// The stage whose argument is the state at the end of the step. The stages after it are used by the dense output only.
    pub last: usize,
    /// The error estimate.
    pub error: ErrorEstimate,
    /// The dense output.
    pub interpolant: Interpolant,
    /// Stability limit: the largest |h lambda| on the negative real axis.
    pub stability: f64,
}

/// The error estimate of a step.
#[derive(Debug, Clone, Copy)]
pub enum ErrorEstimate {
    /// None.
    None,
    /// One linear combination of the k.
    Single(Row),
    /// Two linear combinations e5 and e3 of the k: e = e5²/sqrt(e5² + e3²/100).
    Double {
        /// Weights of the estimate of order 5.
        fifth: Row,
        /// Weights of the estimate of order 3.
        third: Row,
    },
}

/// The interpolation of the motion within a step.
#[derive(Debug, Clone, Copy)]
pub enum Interpolant {
    /// For each k, factors of the powers x to x⁴.
    Powers(&'static [(usize, [f64; 4])]),
    /// The form of [`Dense::nested`]: three parts from the states and rates at both ends of the step, and four parts from all k.
    Nested(&'static [Row; 4]),
}

/// An explicit method with its stages.
#[derive(Debug, Clone)]
pub struct Explicit {
    tableau: Tableau,
    /// Number of coordinates.
    n: usize,
    /// The rates k_i of the stages, one after another: q', v' and the dissipated power, with zeros up to a multiple of [`BLOCK`].
    k: Vec<f64>,
    /// A sum of such rates.
    sum: Vec<f64>,
}

/// Length of the blocks in which stages are added: the sum of a block stays in registers.
const BLOCK: usize = 4;

impl Explicit {
    /// The method with the given tableau.
    pub fn new(tableau: Tableau) -> Self {
        Explicit { tableau, n: 0, k: vec![], sum: vec![] }
    }

    /// The sum of the rates with the factors of a row.
    fn add_up(&mut self, row: Row) {
        let width = self.width();
        let (blocks, _) = self.sum.as_chunks_mut::<BLOCK>();
        for (i, sum) in blocks.iter_mut().enumerate() {
            let mut block = [0.0; BLOCK];
            for &(j, a) in row {
                let k = &self.k[j * width + i * BLOCK..][..BLOCK];
                for l in 0..BLOCK {
                    block[l] += a * k[l];
                }
            }
            *sum = block;
        }
    }

    fn sum(&mut self, row: Row) -> Flow {
        self.add_up(row);
        self.flow(&self.sum)
    }

    /// Sets `end` to the argument of a stage: `start`, plus `h` times the sum of a row.
    fn advance(&mut self, end: &mut Flow, start: &Flow, h: f64, row: Row) {
        self.add_up(row);
        let n = self.n;
        let add = |end: &mut [f64], start: &[f64], rates: &[f64]| {
            for i in 0..n {
                end[i] = start[i] + h * rates[i];
            }
        };
        add(&mut end.q[..n], &start.q[..n], &self.sum[..n]);
        add(&mut end.v[..n], &start.v[..n], &self.sum[n..2 * n]);
        end.lost = start.lost + self.sum[2 * n] * h;
    }

    /// Number of entries of a stage in `k`, with its zeros at the end.
    fn width(&self) -> usize {
        (2 * self.n + 1).next_multiple_of(BLOCK)
    }

    fn stage(&self, i: usize) -> &[f64] {
        &self.k[i * self.width()..][..self.width()]
    }

    fn flow(&self, stage: &[f64]) -> Flow {
        Flow { q: stage[..self.n].into(), v: stage[self.n..2 * self.n].into(), lost: stage[2 * self.n] }
    }

    fn set(&mut self, i: usize, rate: &Flow) {
        let (n, width) = (self.n, self.width());
        let stage = &mut self.k[i * width..][..width];
        stage[..n].copy_from_slice(&rate.q);
        stage[n..2 * n].copy_from_slice(&rate.v);
        stage[2 * n] = rate.lost;
    }

    fn error(&mut self, h: f64, scale: &Scale) -> f64 {
        let error = self.tableau.error;
        let mut size = |row| h * scale.norm(&self.sum(row));
        match error {
            ErrorEstimate::None => 0.0,
            ErrorEstimate::Single(row) => size(row),
            ErrorEstimate::Double { fifth, third } => {
                let (e5, e3) = (size(fifth), size(third));
                if e5 == 0.0 { 0.0 } else { e5 * e5 / (e5 * e5 + 0.01 * e3 * e3).sqrt() }
            }
        }
    }
}

impl Method for Explicit {
    fn name(&self) -> &'static str {
        self.tableau.name
    }

    fn exponent(&self) -> f64 {
        1.0 / f64::from(self.tableau.order)
    }

    fn stability(&self) -> f64 {
        self.tableau.stability
    }

    fn attempt(&mut self, field: &mut Field<'_>, start: &Flow, rate: &Flow, h: f64, scale: &Scale) -> Option<Trial> {
        let Tableau { rows, nodes, last, .. } = self.tableau;
        self.n = start.q.len();
        self.k.resize(rows.len() * self.width(), 0.0);
        self.sum.resize(self.width(), 0.0);
        self.set(0, rate);
        let mut at_end = rate.clone();
        let (mut end, mut before) = (start.clone(), start.clone());
        for i in 1..=last {
            if i == last {
                before = end.clone();
            }
            self.advance(&mut end, start, h, rows[i]);
            at_end = field.rate(nodes[i] * h, &end);
            self.set(i, &at_end);
        }
        // The estimate of h |lambda|: |df| / |dy| of the two stages at t + h.
        let (df, dy) = (at_end.plus(-1.0, &self.flow(self.stage(last - 1))), end.plus(-1.0, &before));
        let (df, dy) = (scale.norm(&df), scale.norm(&dy));
        let stiffness = if dy > 0.0 { h * df / dy } else { 0.0 };
        Some(Trial { end, rate: at_end, error: self.error(h, scale), stiffness })
    }

    fn dense(&mut self, field: &mut Field<'_>, start: &Flow, h: f64, trial: &Trial) -> Dense {
        match self.tableau.interpolant {
            Interpolant::Powers(factors) => {
                let mut c = vec![Flow::zero(start.q.len()); 5];
                c[0] = start.clone();
                for (i, powers) in factors {
                    for (c, p) in c[1..].iter_mut().zip(powers) {
                        c.add(h * p, &self.flow(self.stage(*i)));
                    }
                }
                Dense::new(&c)
            }
            Interpolant::Nested(rows) => {
                let mut argument = start.clone();
                for i in self.tableau.last + 1..self.tableau.rows.len() {
                    self.advance(&mut argument, start, h, self.tableau.rows[i]);
                    let rate = field.rate(self.tableau.nodes[i] * h, &argument);
                    self.set(i, &rate);
                }
                let width = 2 * self.n + 1;
                let mut parts = vec![0.0; 7 * width];
                let (first, last) = parts.split_at_mut(3 * width);
                // From both ends: the increment of y, and its differences from the slopes at the ends.
                // By index: iterators over whole states took up to 6 % more instructions in a step.
                let ends = |i: usize| match i.checked_sub(self.n) {
                    None => (trial.end.q[i] - start.q[i], self.k[i], trial.rate.q[i]),
                    Some(j) if j < self.n => (trial.end.v[j] - start.v[j], self.k[i], trial.rate.v[j]),
                    Some(_) => (trial.end.lost - start.lost, self.k[i], trial.rate.lost),
                };
                for i in 0..width {
                    let (rise, before, after) = ends(i);
                    first[i] = rise;
                    first[width + i] = before * h - rise;
                    first[2 * width + i] = (rise * 2.0 - h * after) - h * before;
                }
                for (part, row) in last.chunks_exact_mut(width).zip(rows) {
                    self.add_up(row);
                    part.iter_mut().zip(&self.sum).for_each(|(part, sum)| *part = sum * h);
                }
                Dense::nested(start, &parts)
            }
        }
    }
}
