//! A flight under loads that vary in time: ramps and swings, beyond the loads at its start.
//!
//! Each mode obeys xi'' + 2 sigma xi' + omega² xi = g(t). The load g is the sum of a constant, a ramp and swings. The motion is the sum of
//! the responses to them ([`Mode::ramp`](crate::engine::mode::Mode::ramp), [`Mode::swing`](crate::engine::mode::Mode::swing)), so that the
//! cost does not depend on the length of the flight.
//!
//! Where damping couples the modes, a load that jumps changes the speeds a' of the modes at once: a' is a function of speeds and of forces.
//! With P_s and P_f, which give speeds and forces of the modes from the load f, the mode obeys the same equation with
//! g = P_f f + P_s f'.

use nalgebra::Complex;

use super::{Cell, Flight, Point};
use crate::engine::mode::exp_m1;
use crate::engine::vector::{Vector, transposed};

/// A vector beyond its value at the start of a flight: slope t + sum over j of Re(swing_j (e^{i W_j t} - 1)).
#[derive(Debug, Clone)]
pub struct Varying {
    pub slope: Vector,
    /// One vector for each W_j.
    pub swings: Vec<Vec<Complex<f64>>>,
}

/// Loads on a flight that vary in time.
#[derive(Debug, Clone)]
pub struct Driven {
    /// Angular frequencies W_j \[rad/s\].
    pub frequencies: Vec<f64>,
    /// Load on each mode.
    pub on_modes: Varying,
    /// Generalised forces (n).
    pub force: Varying,
    /// P_s f and P_f f, if damping couples the modes.
    pub coupled: Option<[Varying; 2]>,
}

impl Varying {
    /// Entry `i` and its first four derivatives at the time `t` \[s\], where `phases` are e^{i W_j t} - 1.
    #[inline]
    pub fn derivatives(&self, i: usize, t: f64, frequencies: &[f64], phases: &[Complex<f64>]) -> [f64; 5] {
        let slope = self.slope[i];
        let mut sum = [slope * t, slope, 0.0, 0.0, 0.0];
        for ((swing, w), phase) in self.swings.iter().zip(frequencies).zip(phases) {
            let now = swing[i] * (phase + 1.0);
            sum[0] += (swing[i] * phase).re;
            sum[1] -= w * now.im;
            sum[2] -= w * w * now.re;
            sum[3] += w * w * w * now.im;
            sum[4] += w * w * w * w * now.re;
        }
        sum
    }

    /// Entry `i` at a time with these phases.
    #[inline]
    pub fn value(&self, i: usize, t: f64, phases: &[Complex<f64>]) -> f64 {
        self.slope[i] * t + self.swings.iter().zip(phases).map(|(swing, phase)| (swing[i] * phase).re).sum::<f64>()
    }

    /// Its image under a linear map.
    pub fn image(&self, map: impl Fn(&Vector) -> Vector) -> Self {
        let swing = |swing: &Vec<Complex<f64>>| {
            let part = |of: fn(&Complex<f64>) -> f64| map(&Vector::from_fn(swing.len(), |i| of(&swing[i])));
            let (re, im) = (part(|c| c.re), part(|c| c.im));
            re.iter().zip(im.iter()).map(|(re, im)| Complex::new(*re, *im)).collect()
        };
        Varying { slope: map(&self.slope), swings: self.swings.iter().map(swing).collect() }
    }

    /// Its scalar product with `row`, as a vector of one entry.
    pub fn along(&self, row: &Vector) -> Self {
        self.image(|x| Vector::from([row.dot(x)]))
    }

    /// Its size per swing of entry `i`.
    #[inline]
    pub fn sizes(&self, i: usize) -> impl Iterator<Item = f64> {
        self.swings.iter().map(move |swing| swing[i].norm())
    }
}

impl Driven {
    /// e^{i W_j t} - 1 of each swing.
    pub fn phases(&self, t: f64) -> Vec<Complex<f64>> {
        self.frequencies.iter().map(|w| exp_m1(Complex::new(0.0, w * t))).collect()
    }

    /// The fastest angular frequency \[rad/s\].
    pub fn fastest(&self) -> f64 {
        self.frequencies.iter().copied().fold(0.0, f64::max)
    }
}

impl Cell {
    /// The motion of `flight` with the generalised `force` (n) in addition, which has swings with these `frequencies` \[rad/s\].
    pub fn driven<'a>(&'a self, mut flight: Flight<'a>, frequencies: Vec<f64>, force: Varying) -> Flight<'a> {
        let shapes = &self.shapes;
        let (on_modes, coupled) = match &self.coupling {
            None => (force.image(|f| transposed(shapes, f)), None),
            Some(coupling) => {
                let [of_speed, mut on_modes] = coupling.loading().each_ref().map(|by| force.image(|f| by * f));
                let on_force = on_modes.clone();
                flight.force += &of_speed.slope;
                for (j, w) in frequencies.iter().enumerate() {
                    for i in 0..self.modes.len() {
                        let rate = of_speed.swings[j][i] * Complex::new(0.0, *w);
                        on_modes.swings[j][i] += rate;
                        flight.force[i] += rate.re;
                    }
                }
                (on_modes, Some([of_speed, on_force]))
            }
        };
        Flight { driven: Some(Box::new(Driven { frequencies, on_modes, force, coupled })), ..flight }
    }

    /// The slopes of the function c.q + d.q' along the generalised forces that vary (n): where damping couples the modes, it is not only a
    /// function of displacements and speeds of the modes.
    pub fn follow_force(&self, c: &Vector, d: Option<&Vector>) -> Option<Vector> {
        let coupling = self.coupling.as_ref()?;
        let [by_speed, by_force] = coupling.loading();
        let mut slopes = -transposed(by_speed, &transposed(&coupling.shapes, c));
        if let Some(d) = d {
            slopes += &transposed(by_force, &transposed(&coupling.shapes, d));
        }
        Some(slopes)
    }
}

impl Flight<'_> {
    /// Adds the responses to loads that vary to a `point`.
    #[cold]
    pub(super) fn push(&self, driven: &Driven, point: &mut Point) {
        let t = point.t;
        point.phases = driven.phases(t);
        for i in 0..self.n() {
            let (mode, at) = (self.mode(i), &point.responses[i]);
            let slope = driven.on_modes.slope[i];
            if slope != 0.0 {
                point.moved[i] += slope * mode.ramp(t, at);
                point.gained[i] += slope * at.s2;
            }
            for (j, w) in driven.frequencies.iter().enumerate() {
                let swing = driven.on_modes.swings[j][i];
                if swing != Complex::from(0.0) {
                    let [moved, rate] = mode.swing(*w, t, point.phases[j], at);
                    point.moved[i] += (swing * moved).re;
                    point.gained[i] += (swing * rate).re;
                }
            }
        }
    }

    /// Of the modes at a `point`: the integral of the speeds that multiply the shapes Y since the start, and the changes of these speeds
    /// ([`Coupling`](crate::engine::coupling::Coupling)).
    pub(super) fn further(&self, point: &Point) -> [Vector; 2] {
        let Point { t, phases, moved, gained, .. } = point;
        let of_forces = self.driven.as_ref().and_then(|driven| driven.coupled.as_ref());
        let at = |which: usize, i: usize| of_forces.map_or(0.0, |of| of[which].value(i, *t, phases));
        let moved_by = Vector::from_fn(self.n(), |i| gained[i] - at(0, i));
        [moved_by, Vector::from_fn(self.n(), |i| self.mode(i).next(moved[i], gained[i]) + at(1, i))]
    }
}

#[cfg(test)]
mod tests;
