//! A signal on a flight under loads that vary in time: the same functions as without them.
//!
//! Each derivative y of the displacement of a mode obeys y'' + 2 sigma y' + omega² y = G(t), where G is the derivative of the load. A swing
//! of G moves y by its steady amplitude |G|/|P(i W)| about a free motion, or by at most |G| ∫|S1| dt over a limited time. The smaller of the
//! two is taken: the first far from resonance, the second close to it. The derivatives of a ramp vanish from the second on, so that a fast
//! mode adds no more than its own amplitude.

use nalgebra::Complex;

use super::{PowerSeries, Reach, Rounding, Signal, TERMS};
use crate::engine::cell::{Driven, Point, Varying};
use crate::engine::mode::Mode;
use crate::tolerance::events;

/// Derivatives of a mode that are needed: its displacement and six derivatives.
const ORDERS: usize = 7;

impl Signal<'_> {
    /// The displacement of mode `i` since the start, and its derivatives.
    fn of_mode(&self, i: usize, driven: &Driven, point: &Point) -> [f64; ORDERS] {
        let mode = self.flight.mode(i);
        let [_, load @ ..] = driven.on_modes.derivatives(i, point.t, &driven.frequencies, &point.phases);
        let (v, a) = self.flight.rates(i, point);
        let mut all = [point.moved[i], v, a, 0.0, 0.0, 0.0, 0.0];
        for k in 3..ORDERS {
            all[k] = mode.next(all[k - 2], all[k - 1]) + load[k - 3];
        }
        all
    }

    fn direct(&self, driven: &Driven, point: &Point) -> [f64; 5] {
        let of = |direct: &&Varying| direct.derivatives(0, point.t, &driven.frequencies, &point.phases);
        self.direct.as_ref().map_or([0.0; 5], of)
    }

    /// [`Signal::derivatives`].
    #[cold]
    pub(super) fn driven_derivatives(&self, driven: &Driven, point: &Point) -> [f64; 5] {
        let mut sum = self.direct(driven, point);
        for i in 0..self.flight.n() {
            let (c, d) = (self.on_moved[i], self.on_speed.map_or(0.0, |d| d[i]));
            let all = self.of_mode(i, driven, point);
            for k in 0..5 {
                let on_speed = if k == 0 { point.gained[i] } else { all[k + 1] };
                sum[k] += c * all[k] + d * on_speed;
            }
        }
        sum
    }

    /// Bound on derivative number `order` >= 2 of mode `i` from a time with `phases` on, for the time `span` \[s\]. `now` are this
    /// derivative and the next one at that time.
    fn bound_of(
        &self,
        i: usize,
        order: i32,
        now: (f64, f64),
        (driven, phases): (&Driven, &[Complex<f64>]),
        span: f64,
    ) -> f64 {
        let (mode, slope) = (self.flight.mode(i), driven.on_modes.slope[i]);
        let swings = driven.on_modes.swings.iter().map(|swing| swing[i]).zip(&driven.frequencies).zip(phases);
        if mode.is_rigid() {
            let further = swings.map(|((swing, w), _)| swing.norm() * w.powi(order - 2) * (w * span).min(2.0));
            let ramp = if order == 2 { slope.abs() * span } else { 0.0 };
            return now.0.abs() + ramp + further.sum::<f64>();
        }
        let ((y, y_dot), further) = about_steady(mode, order, now, mode.effect(span), swings);
        mode.bound(y, y_dot) + further
    }

    /// [`Signal::bounds`] over the time `span` \[s\].
    #[cold]
    pub(super) fn driven_bounds(&self, driven: &Driven, point: &Point, span: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for i in 0..self.flight.n() {
            let (c, d) = (self.on_moved[i], self.on_speed.map_or(0.0, |d| d[i]));
            let all = self.of_mode(i, driven, point);
            for (at, sum) in sum.iter_mut().enumerate() {
                let bound = |k: usize| self.bound_of(i, k as i32, (all[k], all[k + 1]), (driven, &point.phases), span);
                if c != 0.0 {
                    *sum += c.abs() * bound(at + 2);
                }
                if d != 0.0 {
                    *sum += d.abs() * bound(at + 3);
                }
            }
        }
        for (at, sum) in sum.iter_mut().enumerate() {
            let of = |direct: &&Varying| {
                direct.sizes(0).zip(&driven.frequencies).map(|(size, w)| size * w.powi(at as i32 + 2)).sum::<f64>()
            };
            *sum += self.direct.as_ref().map_or(0.0, of);
            *sum *= 1.0 + events::BOUND_MARGIN;
        }
        sum
    }

    /// The sizes of the loads on mode `i`, and of their first three derivatives, for rounding errors.
    fn load_sizes(&self, i: usize, driven: &Driven, t: f64) -> [f64; 4] {
        let slope = driven.on_modes.slope[i].abs();
        let mut sizes = [slope * t, slope, 0.0, 0.0];
        for (size, w) in driven.on_modes.sizes(i).zip(&driven.frequencies) {
            (0..4).for_each(|k| sizes[k] += 2.0 * size * w.powi(k as i32));
        }
        sizes
    }

    /// [`Signal::rounding`].
    #[cold]
    pub(super) fn driven_rounding(&self, driven: &Driven, point: &Point, free: Rounding) -> Rounding {
        let mut sum = [0.0; 3];
        for i in 0..self.flight.n() {
            let (c, d) = (self.on_moved[i].abs(), self.on_speed.map_or(0.0, |d| d[i].abs()));
            let sizes = self.load_sizes(i, driven, point.t);
            for k in 0..3 {
                let on_moved = if k == 0 { 0.0 } else { sizes[k - 1] };
                sum[k] += events::SIGNAL_ROUNDING * (c * on_moved + d * sizes[k]);
            }
        }
        let direct = self.direct(driven, point).map(|x| events::SIGNAL_ROUNDING * x.abs());
        Rounding {
            value: free.value + direct[0],
            rate: free.rate + sum[0] + direct[1],
            acceleration: free.acceleration + sum[1] + direct[2],
            jerk: free.jerk + sum[2] + direct[3],
        }
    }

    /// [`Signal::drift_and_oscillation`] over the time `span` \[s\].
    #[cold]
    pub(super) fn driven_drift(&self, driven: &Driven, span: f64) -> (f64, f64) {
        let (mut drift, mut oscillation) = (0.0, 0.0);
        for i in 0..self.flight.n() {
            let (mode, c) = (self.flight.mode(i), self.on_moved[i]);
            let (v, a) = self.flight.rates_at_start(i);
            let slope = driven.on_modes.slope[i];
            let swings = || driven.on_modes.swings.iter().map(|swing| swing[i]).zip(&driven.frequencies);
            if c != 0.0 && mode.is_rigid() {
                let steady = a - swings().map(|(swing, _)| swing.re).sum::<f64>();
                let further = swings().map(|(swing, w)| 2.0 * swing.norm() / w).sum::<f64>();
                let growing = swings().map(|(swing, w)| 0.5 * swing.norm() * w * span * span).sum::<f64>();
                drift += c * v;
                let change = (steady.abs() * span + further).min(a.abs() * span + growing);
                oscillation += c.abs() * (change + 0.5 * slope.abs() * span * span);
            } else if c != 0.0 {
                let effect = mode.effect(span);
                let with_slope = mode.omega2 * effect >= 1.0;
                let steady = if with_slope { slope / mode.omega2 } else { 0.0 };
                let start = std::iter::repeat(&Complex::ZERO);
                let swings = swings().zip(start);
                let ((y, y_dot), of_swings) = about_steady(mode, 1, (v - steady, a), effect, swings);
                let further = of_swings + if with_slope { 0.0 } else { slope.abs() * effect };
                drift += c * steady;
                if mode.omega2 == 0.0 {
                    let excess = -y_dot / (2.0 * mode.sigma);
                    drift += c * (y - excess);
                    oscillation += c.abs() * (excess.abs() + further);
                } else {
                    oscillation += c.abs() * (mode.rough_bound(y, y_dot) + further);
                }
            }
            if let Some(d) = self.on_speed.map(|d| d[i]).filter(|d| *d != 0.0) {
                let start = self.flight.begin();
                let all = self.of_mode(i, driven, &start);
                oscillation += d.abs() * self.bound_of(i, 2, (all[2], all[3]), (driven, &start.phases), span);
            }
        }
        if let Some(direct) = self.direct {
            drift += direct.slope[0];
            oscillation += direct.sizes(0).zip(&driven.frequencies).map(|(size, w)| size * w).sum::<f64>();
        }
        (drift, oscillation)
    }

    /// [`Signal::series`] with a bound over the time `span` \[s\].
    #[cold]
    pub(super) fn driven_series(&self, driven: &Driven, span: f64) -> PowerSeries {
        let mut series = PowerSeries { derivatives: [0.0; TERMS], rounding: [0.0; TERMS], bound: 0.0 };
        let start = self.flight.begin();
        for i in 0..self.flight.n() {
            let mode = self.flight.mode(i);
            let (c, d) = (self.on_moved[i], self.on_speed.map_or(0.0, |d| d[i]));
            let (mut v, mut a) = self.flight.rates_at_start(i);
            let [mut v_size, mut a_size, ..] = mode.sizes((v, a));
            // Derivative number k + 1 of the load.
            let mut swings: Vec<(Complex<f64>, f64)> =
                driven.on_modes.swings.iter().map(|s| s[i]).zip(driven.frequencies.iter().copied()).collect();
            for k in 0..TERMS {
                swings.iter_mut().for_each(|(swing, w)| *swing *= Complex::new(0.0, *w));
                let slope = if k == 0 { driven.on_modes.slope[i] } else { 0.0 };
                let load = swings.iter().map(|(swing, _)| swing.re).sum::<f64>() + slope;
                let load_size = swings.iter().map(|(swing, _)| swing.norm()).sum::<f64>() + slope.abs();
                let jerk = mode.next(v, a) + load;
                let jerk_size = 2.0 * mode.sigma * a_size + mode.omega2 * v_size + load_size;
                series.derivatives[k] += c * a + d * jerk;
                series.rounding[k] += events::SIGNAL_ROUNDING * (c.abs() * a_size + d.abs() * jerk_size);
                (v, a, v_size, a_size) = (a, jerk, a_size, jerk_size);
            }
            swings.iter_mut().for_each(|(swing, w)| *swing *= Complex::new(0.0, *w));
            let next = mode.next(v, a) + swings.iter().map(|(swing, _)| swing.re).sum::<f64>();
            let bound = |order: usize, now| self.bound_of(i, order as i32, now, (driven, &start.phases), span);
            if c != 0.0 {
                series.bound += c.abs() * bound(TERMS + 2, (a, next));
            }
            if d != 0.0 {
                let after = mode.next(a, next) + swings.iter().map(|(swing, w)| -w * swing.im).sum::<f64>();
                series.bound += d.abs() * bound(TERMS + 3, (next, after));
            }
        }
        if let Some(direct) = self.direct {
            for (swing, w) in direct.swings.iter().zip(&driven.frequencies) {
                let mut part = swing[0] * Complex::new(0.0, *w);
                for k in 0..TERMS {
                    part *= Complex::new(0.0, *w);
                    series.derivatives[k] += part.re;
                    series.rounding[k] += events::SIGNAL_ROUNDING * part.norm();
                }
                series.bound += part.norm() * w;
            }
        }
        series
    }

    /// [`Signal::reach`].
    #[cold]
    pub(super) fn driven_reach(&self, driven: &Driven, point: &Point) -> Reach {
        let mut reach = Reach { drift: 0.0, amplitude: 0.0, deviation: 0.0 };
        for i in 0..self.flight.n() {
            let mode = self.flight.mode(i);
            let (c, d) = (self.on_moved[i], self.on_speed.map_or(0.0, |d| d[i]));
            if c == 0.0 && d == 0.0 {
                continue;
            }
            let slope = driven.on_modes.slope[i];
            let all = self.of_mode(i, driven, point);
            if mode.omega2 == 0.0 {
                if slope != 0.0
                    || all[1..4].iter().any(|x| *x != 0.0)
                    || driven.on_modes.sizes(i).any(|size| size > 0.0)
                {
                    reach.amplitude = f64::INFINITY;
                }
                continue;
            }
            // The steady motion under the ramp and the swings, and the free motion about it.
            let drift = slope / mode.omega2;
            let (mut v, mut a) = (all[1] - drift, all[2]);
            reach.drift += c * drift;
            for (j, w) in driven.frequencies.iter().enumerate() {
                let steady = driven.on_modes.swings[j][i] / mode.stiffness_at(*w);
                if steady == Complex::ZERO {
                    continue;
                }
                let (now, iw) = (steady * (point.phases[j] + 1.0), Complex::new(0.0, *w));
                (v, a) = (v - (now * iw).re, a - (now * iw * iw).re);
                reach.deviation += c * now.re + d * (now * iw).re;
                reach.amplitude += (c.abs() + d.abs() * w) * steady.norm();
            }
            let y = -(a + 2.0 * mode.sigma * v) / mode.omega2;
            reach.deviation += c * y + d * v;
            reach.amplitude += c.abs() * mode.bound(y, v) + d.abs() * mode.bound(v, a);
        }
        if let Some(direct) = self.direct {
            reach.drift += direct.slope[0];
            for (swing, phase) in direct.swings.iter().zip(&point.phases) {
                reach.deviation += (swing[0] * (phase + 1.0)).re;
                reach.amplitude += swing[0].norm();
            }
        }
        if reach.amplitude.is_nan() || reach.deviation.is_nan() {
            reach = Reach { drift: 0.0, amplitude: f64::INFINITY, deviation: 0.0 };
        }
        reach
    }
}

/// Takes the steady motions under swings off a derivative of a mode. `now` are the derivative of this `order` and the next one. Returns what is
/// left of them: it moves freely. Also returns a bound on what the swings add to it: the steady amplitude of each swing, or the most that its
/// load can do, `effect` times its size. Each swing comes with its frequency and its phase e^{i W t} - 1.
fn about_steady<'a>(
    mode: &Mode,
    order: i32,
    now: (f64, f64),
    effect: f64,
    swings: impl Iterator<Item = ((Complex<f64>, &'a f64), &'a Complex<f64>)>,
) -> ((f64, f64), f64) {
    let ((mut y, mut y_dot), mut further) = (now, 0.0);
    for ((swing, w), phase) in swings.filter(|((swing, _), _)| *swing != Complex::ZERO) {
        let (load, stiffness) = (swing.norm() * w.powi(order), mode.stiffness_at(*w));
        let steady = load / stiffness.norm();
        if steady <= load * effect {
            let iw = Complex::new(0.0, *w);
            let z = swing * (phase + 1.0) * iw.powi(order) / stiffness;
            (y, y_dot) = (y - z.re, y_dot - (z * iw).re);
            further += steady;
        } else {
            further += load * effect;
        }
    }
    ((y, y_dot), further)
}
