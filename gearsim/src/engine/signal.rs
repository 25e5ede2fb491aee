//! A linear function of the motion on a flight, minus its value at the start: a phase, or the reaction of a held contact.

use crate::engine::cell::{Flight, Point, Varying};
use crate::engine::mode::Mode;
use crate::engine::vector::dot;
use crate::tolerance::events;

mod driven;

/// s(t) = c.dxi(t) + d.dxi'(t), plus a multiple of the loads that vary in time.
#[derive(Debug, Clone, Copy)]
pub struct Signal<'a> {
    /// The flight.
    pub flight: &'a Flight<'a>,
    /// c: the contribution of the displacement of each mode (one per mode).
    pub on_moved: &'a [f64],
    /// d: the contribution of the speed of each mode (one per mode); `None` if there is none.
    pub on_speed: Option<&'a [f64]>,
    /// Contribution of the loads of the flight that vary in time, one entry; `None` if there is none.
    pub direct: Option<&'a Varying>,
}

/// A signal from a point on, as a steady drift and an oscillation about it.
#[derive(Debug, Clone, Copy)]
pub struct Reach {
    /// Speed of the drift.
    drift: f64,
    /// Upper bound of the oscillation.
    amplitude: f64,
    /// The present deviation from the drift.
    deviation: f64,
}

/// Rounding errors of a signal and of its first derivatives.
#[derive(Debug, Clone, Copy)]
pub struct Rounding {
    /// Error of the signal.
    pub value: f64,
    /// Error of its first derivative.
    pub rate: f64,
    /// Error of its second derivative.
    pub acceleration: f64,
    /// Error of its third derivative.
    pub jerk: f64,
}

/// Power series of a signal at the start: s(t) = s'(0) t + sum over k >= 2 of s^(k)(0) t^k/k!, and a remainder.
#[derive(Debug, Clone, Copy)]
pub struct PowerSeries {
    /// s'', s''', ... at the start.
    pub derivatives: [f64; TERMS],
    /// Rounding error of each of them.
    pub rounding: [f64; TERMS],
    /// Upper bound of the next derivative for all later times.
    pub bound: f64,
}

/// Number of derivatives in a [`PowerSeries`]: the second one and those after it.
pub const TERMS: usize = 12;

impl Reach {
    /// Time before which a boundary at the distance `gap` in the direction `sign` cannot be reached.
    pub fn time(&self, gap: f64, sign: f64) -> f64 {
        // The distance has the rounding errors of the oscillation.
        let rounding = events::REACH_ROUNDING * (gap + self.amplitude + self.deviation.abs());
        let clear = (gap + sign * self.deviation - self.amplitude - rounding) * (1.0 - events::BOUND_MARGIN);
        match (clear > 0.0, sign * self.drift > 0.0) {
            (true, true) => clear / self.drift.abs(),
            (true, false) => f64::INFINITY,
            _ => 0.0,
        }
    }
}

impl Signal<'_> {
    /// The value at a point.
    #[inline]
    pub fn value(&self, point: &Point) -> f64 {
        let direct = self.direct.map_or(0.0, |direct| direct.value(0, point.t, &point.phases));
        dot(self.on_moved, &point.moved) + self.on_speed.map_or(0.0, |d| dot(d, &point.gained)) + direct
    }

    /// The steady part of its rate, and an upper bound of the rate of the oscillations. Both are cheap to compute. Under loads that vary
    /// they hold for the time `span` \[s\], otherwise for all times.
    #[inline]
    pub fn drift_and_oscillation(&self, span: f64) -> (f64, f64) {
        if let Some(driven) = self.flight.driven() {
            return self.driven_drift(driven, span);
        }
        let (mut drift, mut oscillation) = (0.0, 0.0);
        for i in 0..self.flight.n() {
            let (mode, c) = (self.flight.mode(i), self.on_moved[i]);
            let (v, a) = self.flight.rates_at_start(i);
            if mode.is_rigid() && a == 0.0 {
                drift += c * v;
            } else if mode.omega2 == 0.0 && mode.sigma > 0.0 {
                let excess = -a / (2.0 * mode.sigma);
                drift += c * (v - excess);
                oscillation += (c * excess).abs();
            } else if c != 0.0 {
                oscillation += c.abs() * mode.rough_bound(v, a);
            }
        }
        if let Some(d) = self.on_speed {
            oscillation += self.oscillation_by_speeds(d);
        }
        (drift, oscillation)
    }

    /// The part of this bound that comes from the accelerations of the modes.
    #[cold]
    fn oscillation_by_speeds(&self, d: &[f64]) -> f64 {
        let bound = |(i, mode): (usize, &Mode)| {
            let (v, a) = self.flight.rates_at_start(i);
            if d[i] == 0.0 { 0.0 } else { d[i].abs() * mode.rough_bound(a, mode.next(v, a)) }
        };
        self.flight.modes().iter().enumerate().map(bound).sum()
    }

    /// The value at a point and its first four derivatives.
    #[inline]
    pub fn derivatives(&self, point: &Point) -> [f64; 5] {
        if let Some(driven) = self.flight.driven() {
            return self.driven_derivatives(driven, point);
        }
        let mut sum = [0.0; 5];
        for i in 0..self.flight.n() {
            let (mode, c) = (self.flight.mode(i), self.on_moved[i]);
            let (v, a) = self.flight.rates(i, point);
            let jerk = mode.next(v, a);
            let derivatives = [point.moved[i], v, a, jerk, mode.next(a, jerk)];
            for k in 0..5 {
                sum[k] += c * derivatives[k];
            }
        }
        if let Some(d) = self.on_speed {
            self.add_by_speeds(d, point, &mut sum);
        }
        sum
    }

    /// Adds the contributions of the modes' speeds to the value and the derivatives.
    #[cold]
    fn add_by_speeds(&self, d: &[f64], point: &Point, sum: &mut [f64; 5]) {
        for (i, mode) in self.flight.modes().iter().enumerate() {
            let (v, a) = self.flight.rates(i, point);
            let jerk = mode.next(v, a);
            let snap = mode.next(a, jerk);
            for (sum, x) in sum.iter_mut().zip([point.gained[i], a, jerk, snap, mode.next(jerk, snap)]) {
                *sum += d[i] * x;
            }
        }
    }

    /// Upper bounds of its second, third and fourth derivative from a point on. Under loads that vary they hold for the time `span` \[s\],
    /// otherwise for all times.
    pub fn bounds(&self, point: &Point, span: f64) -> [f64; 3] {
        if let Some(driven) = self.flight.driven() {
            return self.driven_bounds(driven, point, span);
        }
        let mut sum = [0.0; 3];
        for i in 0..self.flight.n() {
            let (mode, c) = (self.flight.mode(i), self.on_moved[i]);
            let (v, a) = self.flight.rates(i, point);
            let jerk = mode.next(v, a);
            let snap = mode.next(a, jerk);
            let crackle = mode.next(jerk, snap);
            let derivatives = [a, jerk, snap, crackle, mode.next(snap, crackle)];
            for (k, sum) in sum.iter_mut().enumerate() {
                if c != 0.0 {
                    *sum += c.abs() * mode.bound(derivatives[k], derivatives[k + 1]);
                }
                if let Some(d) = self.on_speed.map(|d| d[i]).filter(|d| *d != 0.0) {
                    *sum += d.abs() * mode.bound(derivatives[k + 1], derivatives[k + 2]);
                }
            }
        }
        let [b2, b3, b4] = sum;
        let margin = 1.0 + events::BOUND_MARGIN;
        [b2 * margin, b3 * margin, b4 * margin]
    }

    /// Rounding errors of the value and of its first derivatives at a point, from the sizes of their terms there and at the
    /// start.
    pub fn rounding(&self, point: &Point) -> Rounding {
        let mut sum = [0.0; 4];
        for i in 0..self.flight.n() {
            let mode = self.flight.mode(i);
            let (then, now) = (self.flight.rates_at_start(i), self.flight.rates(i, point));
            let (then, now) = (mode.sizes(then), mode.sizes(now));
            let sizes: [f64; 4] = std::array::from_fn(|k| then[k] + now[k]);
            let (c, d) = (self.on_moved[i].abs(), self.on_speed.map_or(0.0, |d| d[i].abs()));
            sum[0] += events::SIGNAL_ROUNDING * (c * point.moved[i].abs() + d * point.gained[i].abs());
            for k in 0..3 {
                sum[k + 1] += events::SIGNAL_ROUNDING * (c * sizes[k] + d * sizes[k + 1]);
            }
        }
        let [value, rate, acceleration, jerk] = sum;
        let free = Rounding { value, rate, acceleration, jerk };
        self.flight.driven().map_or(free, |driven| self.driven_rounding(driven, point, free))
    }

    /// Its power series at the start. Under loads that vary, the bound holds for the time `span` \[s\].
    pub fn series(&self, span: f64) -> PowerSeries {
        if let Some(driven) = self.flight.driven() {
            return self.driven_series(driven, span);
        }
        let mut series = PowerSeries { derivatives: [0.0; TERMS], rounding: [0.0; TERMS], bound: 0.0 };
        for i in 0..self.flight.n() {
            let mode = self.flight.mode(i);
            let (c, d) = (self.on_moved[i], self.on_speed.map_or(0.0, |d| d[i]));
            let (mut v, mut a) = self.flight.rates_at_start(i);
            let [mut v_size, mut a_size, ..] = mode.sizes((v, a));
            for k in 0..TERMS {
                let (jerk, jerk_size) = (mode.next(v, a), 2.0 * mode.sigma * a_size + mode.omega2 * v_size);
                series.derivatives[k] += c * a + d * jerk;
                series.rounding[k] += events::SIGNAL_ROUNDING * (c.abs() * a_size + d.abs() * jerk_size);
                (v, a, v_size, a_size) = (a, jerk, a_size, jerk_size);
            }
            let next = mode.next(v, a);
            // A rigid motion under a constant force has no further derivatives. Its bound is infinite, so it is skipped.
            if c != 0.0 && (a != 0.0 || next != 0.0) {
                series.bound += c.abs() * mode.bound(a, next);
            }
            if d != 0.0 && (a != 0.0 || next != 0.0) {
                series.bound += d.abs() * mode.bound(next, mode.next(a, next));
            }
        }
        series
    }

    /// The drift from a point on, and the oscillation about it.
    pub fn reach(&self, point: &Point) -> Reach {
        if let Some(driven) = self.flight.driven() {
            return self.driven_reach(driven, point);
        }
        let mut reach = Reach { drift: 0.0, amplitude: 0.0, deviation: 0.0 };
        for i in 0..self.flight.n() {
            let mode = self.flight.mode(i);
            let (c, d) = (self.on_moved[i], self.on_speed.map_or(0.0, |d| d[i]));
            let (v, a) = self.flight.rates(i, point);
            if (c == 0.0 && d == 0.0) || (v == 0.0 && a == 0.0) {
                continue;
            }
            if mode.is_rigid() && a == 0.0 {
                reach.drift += c * v;
            } else if mode.omega2 > 0.0 {
                // Deviation from equilibrium: -(spring force)/omega² with the spring force a + 2 sigma v.
                let y = -(a + 2.0 * mode.sigma * v) / mode.omega2;
                reach.deviation += c * y + d * v;
                reach.amplitude += c.abs() * mode.bound(y, v) + d.abs() * mode.bound(v, a);
            } else if mode.sigma > 0.0 {
                // The difference between the present and the final speed decays.
                let excess = -a / (2.0 * mode.sigma);
                let y = -excess / (2.0 * mode.sigma);
                reach.drift += c * (v - excess);
                reach.deviation += c * y + d * excess;
                reach.amplitude += (c * y).abs() + (d * excess).abs();
            } else {
                reach.amplitude = f64::INFINITY;
            }
        }
        reach
    }
}
