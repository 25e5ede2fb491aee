//! The motion in a cell from a given state on, in closed form.
//!
//! Loops over modes are loops over an index, for the reason that `vector.rs` gives.

use nalgebra::Complex;
use smallvec::SmallVec;

use super::Cell;
use super::driven::Driven;
use crate::engine::conserved::Conserved;
use crate::engine::mode::{Mode, Response};
use crate::engine::vector::Vector;

/// The motion in a cell from a given state on.
#[derive(Debug, Clone)]
pub struct Flight<'a> {
    pub(super) cell: &'a Cell,
    /// Modal speeds at the start (one per mode).
    pub(super) speed: Vector,
    /// Modal forces g - omega² xi at the start (one per mode).
    pub(super) force: Vector,
    /// Loads that vary in time, beyond those at the start.
    pub(super) driven: Option<Box<Driven>>,
}

/// The motion at one instant of a flight.
#[derive(Debug, Clone)]
pub struct Point {
    /// Time since the start of the flight \[s\].
    pub t: f64,
    /// Responses of each mode to a unit speed and to a unit force.
    pub(super) responses: SmallVec<[Response; 10]>,
    /// e^{i W t} - 1 of each swing of a load that varies.
    pub phases: Vec<Complex<f64>>,
    /// xi(t) - xi(0).
    pub moved: Vector,
    /// xi'(t) - xi'(0).
    pub gained: Vector,
}

impl<'a> Flight<'a> {
    /// The modes of its cell.
    pub fn modes(&self) -> &'a [Mode] {
        &self.cell.modes
    }

    /// Its loads that vary in time.
    #[inline]
    pub fn driven(&self) -> Option<&Driven> {
        self.driven.as_deref()
    }

    /// The number of its modes.
    #[inline]
    pub fn n(&self) -> usize {
        self.speed.len()
    }

    /// Mode `i`.
    #[inline]
    pub fn mode(&self, i: usize) -> &'a Mode {
        &self.cell.modes[i]
    }

    /// Modal speed and acceleration of mode `i` at the start.
    #[inline]
    pub fn rates_at_start(&self, i: usize) -> (f64, f64) {
        let v = self.speed[i];
        (v, self.force[i] - 2.0 * self.cell.modes[i].sigma * v)
    }

    /// Modal speed and acceleration of mode `i` at a `point` of the flight.
    #[inline]
    pub fn rates(&self, i: usize, point: &Point) -> (f64, f64) {
        let mode = &self.cell.modes[i];
        let v = self.speed[i] + point.gained[i];
        let load = self.driven.as_ref().map_or(0.0, |driven| driven.on_modes.value(i, point.t, &point.phases));
        (v, self.force[i] - mode.omega2 * point.moved[i] - 2.0 * mode.sigma * v + load)
    }

    /// The point at the start.
    #[inline]
    pub fn begin(&self) -> Point {
        let still = Response { s1: 0.0, s2: 0.0, decay: 0.0 };
        let n = self.speed.len();
        let (moved, gained) = (Vector::zeros(n), Vector::zeros(n));
        let phases = self.driven.as_ref().map_or(vec![], |driven| vec![Complex::from(0.0); driven.frequencies.len()]);
        Point { t: 0.0, responses: SmallVec::from_elem(still, n), phases, moved, gained }
    }

    /// The point after the time `t` [s].
    pub fn at(&self, t: f64) -> Point {
        let mut point = self.begin();
        self.go(&mut point, t);
        point
    }

    /// Moves `point` to the time `t` [s]. It works in place, because a point is expensive to copy.
    #[inline]
    pub fn go(&self, point: &mut Point, t: f64) {
        point.t = t;
        self.place(point, |mode, _| mode.response(t));
    }

    /// Moves `point` by a short time `dt` [s] of either sign: |`dt`| * rate <=
    /// `tolerance::modes::SHIFT_SPAN`.
    #[inline]
    pub fn shift(&self, point: &mut Point, dt: f64) {
        point.t += dt;
        self.place(point, |mode, response| mode.shifted(response, dt));
    }

    /// Updates `point` with the new response of each mode, which `respond` computes.
    #[inline(always)]
    fn place(&self, point: &mut Point, respond: impl Fn(&Mode, &Response) -> Response) {
        for i in 0..self.n() {
            let (mode, v, f) = (self.mode(i), self.speed[i], self.force[i]);
            let response = respond(mode, &point.responses[i]);
            let Response { s1, s2, .. } = response;
            point.responses[i] = response;
            point.moved[i] = v * s1 + f * s2;
            point.gained[i] = (f - 2.0 * mode.sigma * v) * s1 - mode.omega2 * s2 * v;
        }
        if let Some(driven) = &self.driven {
            self.push(driven, point);
        }
    }

    /// Upper bound of the rates of its modes and loads [1/s].
    #[inline]
    pub fn rate(&self) -> f64 {
        self.driven.as_ref().map_or(self.cell.rate, |driven| self.cell.rate.max(driven.fastest()))
    }

    /// Increments of q and q' since the start, at a point (n each).
    #[inline]
    pub fn increments(&self, point: &Point) -> (Vector, Vector) {
        let (shapes, Point { moved, gained, .. }) = (&self.cell.shapes, point);
        let mut dv = shapes * gained;
        for Conserved { motion, on_gained, .. } in &self.cell.conserved {
            dv.add_times(-on_gained.dot(gained), motion);
        }
        let Some(coupling) = &self.cell.coupling else { return (shapes * moved, dv) };
        let [along, further] = self.further(point);
        for Conserved { motion, on_further, .. } in &self.cell.conserved {
            dv.add_times(-on_further.as_ref().map_or(0.0, |on_further| on_further.dot(&further)), motion);
        }
        (shapes * moved + &(&coupling.shapes * &along), dv + &(&coupling.shapes * &further))
    }

    /// Energy dissipated from the start to a point [J], an integral of the speeds.
    #[inline]
    pub fn dissipated(&self, point: &Point) -> f64 {
        if self.cell.coupling.is_some() {
            return self.lost_by_coupled(point);
        }
        let mut dissipated = 0.0;
        for i in 0..self.speed.len() {
            let mode = &self.cell.modes[i];
            if mode.sigma > 0.0 {
                let (v, a) = self.rates_at_start(i);
                dissipated += mode.dissipated(v, a, point.t, &point.responses[i]);
            }
        }
        dissipated
    }
}
