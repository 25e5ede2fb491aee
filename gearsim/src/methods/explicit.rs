//! Explicit Runge-Kutta methods, from their tableaux.
//!
//! k_i = f(t + c_i h, y + h sum_j a_ij k_j). The stage `last` is where the step ends, so that its k is the first of the next.

use super::dense::Dense;
use super::field::Field;
use super::flow::{Flow, Scale};
use super::{Method, Trial};

/// Entries of a row that are not zero: which k, and its factor.
pub type Row = &'static [(usize, f64)];

/// A method.
#[derive(Debug, Clone, Copy)]
pub struct Tableau {
    /// Its name in scenes.
    pub name: &'static str,
    /// Its order.
    pub order: u32,
    /// a_ij of each stage.
    pub rows: &'static [Row],
    /// c_i of each stage.
    pub nodes: &'static [f64],
    /// The stage whose argument is the end of the step; those after it serve the dense output.
    pub last: usize,
    /// Its estimate of the error.
    pub error: Error,
    /// Its dense output.
    pub interpolant: Interpolant,
    /// Where on the negative real axis h lambda leaves its region of stability.
    pub stability: f64,
}

/// How the error of a step is estimated.
#[derive(Debug, Clone, Copy)]
pub enum Error {
    /// Not at all.
    None,
    /// By one combination of the k.
    Single(Row),
    /// By two: e = e5²/sqrt(e5² + e3²/100).
    Double {
        /// Of order 5.
        fifth: Row,
        /// Of order 3.
        third: Row,
    },
}

/// How the motion within a step is interpolated.
#[derive(Debug, Clone, Copy)]
pub enum Interpolant {
    /// By a factor of each k for the powers x to x⁴.
    Powers(&'static [(usize, [f64; 4])]),
    /// By three parts from both ends, and more from all k: [`Dense::nested`].
    Nested(&'static [Row; 4]),
}

/// An explicit method at work.
#[derive(Debug, Clone)]
pub struct Explicit {
    tableau: Tableau,
    /// The rates of the stages.
    k: Vec<Flow>,
}

impl Explicit {
    /// The method of a tableau.
    pub fn new(tableau: Tableau) -> Self {
        Explicit { tableau, k: vec![Flow::zero(0); tableau.rows.len()] }
    }

    fn sum(&self, row: Row) -> Flow {
        let mut sum = Flow::zero(self.k[0].q.len());
        row.iter().for_each(|(j, a)| sum.add(*a, &self.k[*j]));
        sum
    }

    fn error(&self, h: f64, scale: &Scale) -> f64 {
        let size = |row| h * scale.norm(&self.sum(row));
        match self.tableau.error {
            Error::None => 0.0,
            Error::Single(row) => size(row),
            Error::Double { fifth, third } => {
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
        self.k[0] = rate.clone();
        let (mut end, mut before) = (start.clone(), start.clone());
        for i in 1..=last {
            before = end;
            end = start.plus(h, &self.sum(rows[i]));
            self.k[i] = field.rate(nodes[i] * h, &end);
        }
        // |df| / |dy| of the two stages that end at t + h.
        let (df, dy) = (self.k[last].plus(-1.0, &self.k[last - 1]), end.plus(-1.0, &before));
        let (df, dy) = (scale.norm(&df), scale.norm(&dy));
        let stiffness = if dy > 0.0 { h * df / dy } else { 0.0 };
        Some(Trial { end, rate: self.k[last].clone(), error: self.error(h, scale), stiffness })
    }

    fn dense(&mut self, field: &mut Field<'_>, start: &Flow, h: f64, trial: &Trial) -> Dense {
        match self.tableau.interpolant {
            Interpolant::Powers(factors) => {
                let mut c = vec![Flow::zero(start.q.len()); 5];
                c[0] = start.clone();
                for (i, powers) in factors {
                    for (c, p) in c[1..].iter_mut().zip(powers) {
                        c.add(h * p, &self.k[*i]);
                    }
                }
                Dense::new(c)
            }
            Interpolant::Nested(rows) => {
                for i in self.tableau.last + 1..self.tableau.rows.len() {
                    let argument = start.plus(h, &self.sum(self.tableau.rows[i]));
                    self.k[i] = field.rate(self.tableau.nodes[i] * h, &argument);
                }
                let rise = trial.end.plus(-1.0, start);
                let zero = Flow::zero(start.q.len());
                let mut f = vec![
                    rise.clone(),
                    zero.plus(h, &self.k[0]).plus(-1.0, &rise),
                    zero.plus(2.0, &rise).plus(-h, &trial.rate).plus(-h, &self.k[0]),
                ];
                f.extend(rows.iter().map(|row| zero.plus(h, &self.sum(row))));
                Dense::nested(start, &f)
            }
        }
    }
}
