//! The motion in a cell by power series in double-double precision, in successive windows. It is used under torques that vary in time, and
//! where damping couples the modes. The recurrence is that of [`crate::engine::forcing::window`].

use nalgebra::DVector;
use xprec::Df64;

use super::cell::Cell;
use super::flight::Instant;
use super::forces::Forces;
use crate::tolerance::events::WINDOW_SPAN;

/// Number of terms of the series. The remainder is below 2⁴⁰/40! < 2e-36 of the motion.
pub const TERMS: usize = 40;

/// The motion from the start of a flight on.
pub struct Series<'a> {
    cell: &'a Cell,
    forces: Forces<'a>,
    /// Time at the start of the flight \[s\].
    since: Df64,
    /// Modal speeds and forces at the start of the flight, without the forces that vary.
    start: [DVector<Df64>; 2],
    /// Start of the present window, since the start of the flight, and its length \[s\].
    window: (Df64, f64),
    /// Increments of the displacements and speeds of the modes until the start of the window.
    before: [DVector<Df64>; 2],
    /// Coefficients of the displacements since then, as a series in the fraction of the window.
    terms: Vec<DVector<Df64>>,
}

impl<'a> Series<'a> {
    /// The motion that begins at the time `since` \[s\] with the modal speeds and forces `start`.
    pub fn new(cell: &'a Cell, forces: Forces<'a>, since: Df64, fastest: f64, start: [DVector<Df64>; 2]) -> Self {
        let rate = cell.rate.max(fastest);
        // Without any rate the motion is a polynomial, and a window of any width is exact.
        let width = if rate > 0.0 { WINDOW_SPAN / rate } else { 1.0 };
        let none = || DVector::from_element(start[0].len(), Df64::from(0.0));
        let before = [none(), none()];
        let mut series = Series { cell, forces, since, start, window: (Df64::from(0.0), width), before, terms: vec![] };
        series.expand();
        series
    }

    /// Coefficients about the start of the present window: (n+2)(n+1) c_(n+2) = W² (g_n - omega² c_n) - W (n+1) G c_(n+1).
    fn expand(&mut self) {
        let Series {
            cell, forces, since, start: [speed, force], window: (begin, width), before: [moved, gained], ..
        } = self;
        let (m, w) = (speed.len(), Df64::from(*width));
        let loads = forces.series(*since + *begin, *width);
        let push: Vec<DVector<Df64>> = forces.loads().map(|load| cell.shapes.transpose() * load).collect();
        let mut terms = vec![DVector::from_element(m, Df64::from(0.0)); TERMS];
        terms[1] = (&*speed + &*gained) * w;
        for n in 0..TERMS - 2 {
            let drag = &cell.damping * &terms[n + 1] * (w * (n + 1) as f64);
            let next = DVector::from_fn(m, |i, _| {
                let spring = match n {
                    0 => force[i] - cell.omega2[i] * moved[i],
                    _ => -cell.omega2[i] * terms[n][i],
                };
                let pushed = push.iter().zip(&loads).fold(spring, |sum, (push, load)| sum + push[i] * load[n]);
                (pushed * w * w - drag[i]) / ((n + 2) * (n + 1)) as f64
            });
            terms[n + 2] = next;
        }
        self.terms = terms;
    }

    /// The motion at the time `t` \[s\]. It must not be earlier than in the previous call, except for the corrections of an event.
    pub fn at(&mut self, t: Df64) -> Instant {
        loop {
            let (begin, width) = self.window;
            let x = (t - begin) / width;
            if x.hi() <= 1.0 || !x.hi().is_finite() {
                return self.within(if x.hi().is_finite() { x } else { Df64::from(0.0) });
            }
            let Instant { moved, gained, .. } = self.within(Df64::from(1.0));
            self.before = [moved, gained];
            self.window.0 += Df64::from(width);
            self.expand();
        }
    }

    /// The motion at the fraction `x` of the window.
    fn within(&self, x: Df64) -> Instant {
        let m = self.start[0].len();
        let zero = || DVector::from_element(m, Df64::from(0.0));
        let mut at = [zero(), zero(), zero(), zero()];
        for term in self.terms.iter().rev() {
            for i in 0..m {
                let [y, v, a, jerk] = at.each_ref().map(|of| of[i]);
                (at[3][i], at[2][i], at[1][i], at[0][i]) = (jerk * x + a, a * x + v, v * x + y, y * x + term[i]);
            }
        }
        let [y, v, a, jerk] = at;
        let w = Df64::from(self.window.1);
        let v = v / w;
        Instant {
            moved: &self.before[0] + y,
            gained: &v - &self.start[0],
            rates: [v, a * Df64::from(2.0) / (w * w), jerk * Df64::from(6.0) / (w * w * w)],
        }
    }

    /// The scalar product of `on_force` and the forces that vary, and its first two derivatives, at the time `t` \[s\] of the flight.
    pub fn pushed(&self, on_force: &DVector<Df64>, t: Df64) -> [Df64; 3] {
        let at = self.since + t;
        let width = 1.0;
        let mut sum = [Df64::from(0.0); 3];
        for (load, series) in self.forces.loads().zip(self.forces.series(at, width)) {
            let along = super::guard::dot(on_force, load);
            (0..3).for_each(|n| sum[n] += along * series[n] * [1.0, 1.0, 2.0][n]);
        }
        sum
    }
}
