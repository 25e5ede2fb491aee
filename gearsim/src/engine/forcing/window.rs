//! The motion of a linear cell under torques that vary in time, over a window short enough for its power series.
//!
//! xi(t_0 + W x) - xi(t_0) = sum c_n xⁿ, 0 <= x <= 1, with the load g_n xⁿ of linear and harmonic torques:
//!
//! ```text
//! c_1 = W xi'    (n+2)(n+1) c_(n+2) = W² (g_n - omega² c_n) - W (n+1) G c_(n+1)
//! ```
//!
//! The motion is an entire function of t, whatever the damping, on resonance and off it, for rigid modes as for elastic
//! ones. A window lasts no longer than `WINDOW_SPAN` divided by the fastest rate of cell and load: then [`TERMS`] terms leave a
//! remainder of 2²⁸/28! < 1e-21 of the motion, far below its rounding, and lose less than a digit to cancellation. The first crossing is
//! therefore the first root of a polynomial, which is found with certainty ([`root`](crate::engine::root)).

use super::Forcing;
use super::linear::LinearCell;
use crate::engine::clock::Clock;
use crate::engine::mode::GAUSS_16;
use crate::engine::vector::{Vector, transposed};
use crate::tolerance::events::{WINDOW_ROUNDING, WINDOW_SPAN};

/// Terms of the series.
pub const TERMS: usize = 28;

/// The motion over a window.
#[derive(Debug, Clone)]
pub struct Window<'a> {
    linear: &'a LinearCell,
    /// Generalised forces per unit of each parameter that varies.
    units: Vec<Vector>,
    /// Its length W \[s\].
    pub width: f64,
    /// c_n, one entry per mode.
    terms: Vec<Vector>,
    /// Power series of the parameters that vary.
    loads: Vec<[f64; TERMS]>,
}

/// Terms of the energy account over a part of a window.
#[derive(Debug, Clone)]
pub struct Gains {
    /// Energy lost to damping \[J\].
    pub lost: f64,
    /// Work of each torque beyond that of its value at the start \[J\].
    pub work: Vec<f64>,
}

impl<'a> Window<'a> {
    /// The window from the state (q, q') at the clock's time, at most `longest` \[s\] long.
    pub fn begin(
        linear: &'a LinearCell,
        forcing: &Forcing,
        clock: &Clock,
        q: &Vector,
        q_dot: &Vector,
        longest: f64,
    ) -> Self {
        let width = longest.min(WINDOW_SPAN / linear.rate.max(forcing.fastest()));
        let loads = forcing.series(clock, width);
        let push: Vec<Vector> = forcing.drives.iter().map(|d| transposed(&linear.shapes, &d.load)).collect();
        let m = linear.omega2.len();
        let mut terms = vec![Vector::zeros(m); TERMS];
        terms[1] = &linear.momentum * q_dot * width;
        for n in 0..TERMS - 2 {
            let mut force = match n {
                0 => &linear.load - &(&linear.springs * q),
                _ => -linear.omega2.component_mul(&terms[n]),
            };
            push.iter().zip(&loads).for_each(|(push, load)| force.add_times(load[n], push));
            if n == 0 {
                // Forces in balance must sum to exactly zero: a rounding error would separate flanks that just touch.
                let mut sizes = linear.load.abs() + &(&linear.springs.abs() * &q.abs());
                push.iter().zip(&loads).for_each(|(push, load)| sizes.add_times(load[n].abs(), &push.abs()));
                force = force.zip_map(&sizes, beyond_rounding);
            }
            let drag = match linear.by_itself {
                true => Vector::from_fn(m, |i| linear.damping[(i, i)] * terms[n + 1][i]),
                false => &linear.damping * &terms[n + 1],
            };
            let n = (n + 1) as f64;
            terms[n as usize + 1] = (force * (width * width) - &(drag * (width * n))) * (1.0 / (n * (n + 1.0)));
        }
        let units = forcing.drives.iter().map(|d| d.load.clone()).collect();
        Window { linear, units, width, terms, loads }
    }

    /// Shortens the window to the fraction `part` of its length.
    pub fn shorten(&mut self, part: f64) {
        let mut power = 1.0;
        self.width *= part;
        for n in 0..TERMS {
            self.terms[n].iter_mut().for_each(|x| *x *= power);
            self.loads.iter_mut().for_each(|load| load[n] *= power);
            power *= part;
        }
    }

    /// Coefficients in x of on_q.q minus its value at the start. Terms of modes that cancel to rounding errors are set to zero: a torque
    /// that does not yet act on a phase at rest must not move it by a rounding error.
    pub fn along(&self, on_q: &Vector) -> [f64; TERMS] {
        let modal = transposed(&self.linear.shapes, on_q);
        std::array::from_fn(|n| {
            let parts = modal.component_mul(&self.terms[n]);
            beyond_rounding(parts.sum(), parts.abs().sum())
        })
    }

    /// The same for on_q.q + on_speed.q' + on_load.f. The value at the start is not subtracted; the coefficient n = 0 has no meaning.
    pub fn course(&self, on_q: &Vector, on_speed: &Vector, on_load: &Vector) -> [f64; TERMS] {
        let [place, speed] = [on_q, on_speed].map(|on| transposed(&self.linear.shapes, on));
        std::array::from_fn(|n| {
            let moved = place.component_mul(&self.terms[n]);
            let rate = match n + 1 < TERMS && self.width > 0.0 {
                true => speed.component_mul(&self.terms[n + 1]) * ((n + 1) as f64 / self.width),
                false => Vector::zeros(speed.len()),
            };
            let loads = self.units.iter().zip(&self.loads).map(|(unit, load)| on_load.dot(unit) * load[n]);
            let (load, size) = loads.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()));
            beyond_rounding(moved.sum() + rate.sum() + load, moved.abs().sum() + rate.abs().sum() + size)
        })
    }

    /// Increments of q and q' at the fraction `x` of the window.
    pub fn increments(&self, x: f64) -> (Vector, Vector) {
        let (n, m) = self.linear.shapes.shape();
        if self.width == 0.0 {
            return (Vector::zeros(n), Vector::zeros(n));
        }
        let (mut moved, mut gained) = (Vector::zeros(m), Vector::zeros(m));
        for n in (1..TERMS).rev() {
            moved = (moved + &self.terms[n]) * x;
            if n > 1 {
                gained.add_times(n as f64, &self.terms[n]);
                gained = gained * x;
            }
        }
        (&self.linear.shapes * &moved, &self.linear.shapes * &gained * (1.0 / self.width))
    }

    /// Modal speeds times the width at places in the window, mode by mode. Each term is added at all places in one loop, because a term at
    /// a single place is only a few operations.
    fn speeds(&self, places: &[f64; NODES]) -> Vec<[f64; NODES]> {
        let of_mode = |i: usize| {
            let mut speeds = [0.0; NODES];
            for n in (1..TERMS).rev() {
                multiply_add(&mut speeds, places, n as f64 * self.terms[n][i]);
            }
            speeds
        };
        (0..self.linear.omega2.len()).map(of_mode).collect()
    }

    /// Terms of the energy account until the fraction `x`: integrals over the speeds by Gauss-Legendre quadrature, exact to rounding over
    /// so short a time.
    pub fn gains(&self, forcing: &Forcing, x: f64) -> Gains {
        let m = self.linear.omega2.len();
        let places: [f64; NODES] = std::array::from_fn(|j| 0.5 * x * (1.0 + node(j).0));
        let speeds = self.speeds(&places);
        let of_load = |load: &[f64; TERMS]| {
            let mut values = [0.0; NODES];
            load.iter().rev().for_each(|c| multiply_add(&mut values, &places, *c));
            values
        };
        let loads: Vec<[f64; NODES]> = self.loads.iter().map(of_load).collect();
        let mut lost = 0.0;
        let mut swept = vec![Vector::zeros(m); loads.len()];
        for j in 0..NODES {
            let (weight, speed) = (node(j).1, Vector::from_fn(m, |i| speeds[i][j]));
            lost += weight * speed.dot(&(&self.linear.damping * &speed));
            for (swept, load) in swept.iter_mut().zip(&loads) {
                swept.add_times(weight * load[j], &speed);
            }
        }
        let mut work = vec![0.0; forcing.torques];
        for (drive, swept) in forcing.drives.iter().zip(swept) {
            let swept = &self.linear.shapes * &swept * (0.5 * x);
            work.iter_mut().zip(&drive.power).for_each(|(sum, row)| *sum += row.dot(&swept));
        }
        // The speeds are derivatives by x = t/W: the square needs one division by W, the work none.
        Gains { lost: if self.width > 0.0 { lost * 0.5 * x / self.width } else { 0.0 }, work }
    }
}

/// Nodes of the quadrature.
const NODES: usize = 2 * GAUSS_16.len();

/// A node of the quadrature in -1..1, and its weight.
fn node(j: usize) -> (f64, f64) {
    let (node, weight) = GAUSS_16[j / 2];
    (if j.is_multiple_of(2) { -node } else { node }, weight)
}

/// A step of Horner's rule at each place x: `sums` becomes `sums` x + `c`.
#[inline]
fn multiply_add(sums: &mut [f64; NODES], x: &[f64; NODES], c: f64) {
    for j in 0..NODES {
        sums[j] = sums[j] * x[j] + c;
    }
}

/// `sum`, or zero if its terms, whose absolute values sum to `size`, cancel to rounding errors.
fn beyond_rounding(sum: f64, size: f64) -> f64 {
    if sum.abs() <= WINDOW_ROUNDING * size { 0.0 } else { sum }
}
