//! The motion in a window of a power series, in a linear cell under torques that vary in time.

use smallvec::SmallVec;
use xprec::Df64;

use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::forcing::Forcing;
use crate::engine::forcing::linear::LinearCell;
use crate::engine::forcing::window::{TERMS, Window};
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::{End, Guard, Motion, Reached};
use crate::engine::record::State;
use crate::engine::root;
use crate::engine::vector::Vector;
use crate::engine::watch::Watch;
use crate::tolerance::events::WINDOW_CUT;

/// A window from the state of `now`.
pub struct InWindow<'s> {
    now: &'s Hybrid<'s>,
    forcing: &'s Forcing,
    window: Window<'s>,
    /// The exits of the switches, and the functions that end the holds.
    exits: &'s [SmallVec<[Watch; 2]>],
    held: &'s [Watch],
    /// The event that was found last: its time \[s\], and its fraction of the window.
    found: Option<(f64, f64)>,
}

impl<'s> InWindow<'s> {
    /// The window from the state of `now`, at most `longest` \[s\] long.
    pub fn begin(
        now: &'s Hybrid<'s>,
        forcing: &'s Forcing,
        linear: &'s LinearCell,
        (exits, held): (&'s [SmallVec<[Watch; 2]>], &'s [Watch]),
        longest: f64,
    ) -> Self {
        let State { q, q_dot, .. } = &now.state;
        let mut window = Window::begin(linear, forcing, &now.clock, q, q_dot, longest);
        shorten(&mut window, now);
        InWindow { now, forcing, window, exits, held, found: None }
    }

    /// The fraction of the window at which a phase first meets a boundary of its cell, and the boundary.
    fn first_boundary(&self, law: usize, cost: &mut Cost) -> Option<(f64, Side)> {
        let (law, State { q, q_dot, .. }) = (&self.now.laws[law], &self.now.state);
        let mut course = self.window.along(&law.surface.normal);
        // The rate comes from the state, because the sum over the modes has the rounding errors of its terms.
        course[1] = law.surface.normal.dot(q_dot) * self.window.width;
        let mut first: Option<(f64, Side)> = None;
        for side in [Side::Upper, Side::Lower] {
            let gap = side.sign() * (law.boundary(side) - q[law.phase]);
            let gap: [f64; TERMS] = std::array::from_fn(|n| if n == 0 { gap } else { -side.sign() * course[n] });
            let found = root::first_of::<TERMS>(&gap, 4.0 * law.rounding());
            (cost.steps, cost.grazes) = (cost.steps + found.steps, cost.grazes + found.grazes);
            if let Some(root) = found.root.filter(|root| first.is_none_or(|first| *root < first.0)) {
                first = Some((root, side));
            }
        }
        first
    }

    fn part(&self, t: f64) -> f64 {
        if self.window.width > 0.0 { (t / self.window.width).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// The state after the fraction `x` of the window.
    fn reached(&self, x: f64, state: impl FnOnce(&State, &Vector, &Vector) -> State) -> Reached {
        let (dq, dv) = self.window.increments(x);
        let gains = self.window.gains(self.forcing, x);
        let dissipated = gains.lost + self.now.lost_by_switches(&dq);
        Reached { state: state(&self.now.state, &dq, &dv), dissipated, work: gains.work }
    }
}

impl Motion for InWindow<'_> {
    fn length(&self) -> f64 {
        self.window.width
    }

    fn first(&mut self, guard: Guard, until: f64, cost: &mut Cost) -> Result<Option<(f64, Side)>, SearchError> {
        let (window, now) = (&self.window, self.now);
        let first = match guard {
            Guard::Phase(law) => self.first_boundary(law, cost),
            Guard::Exit(switch, which) => {
                let value = now.left_to(&now.guards.exits[switch][which]);
                self.exits[switch][which].first_zero_in(value, window, cost).map(|x| (x, Side::Lower))
            }
            Guard::Hold(which) => {
                let value = now.left_of_hold(which);
                self.held[which].first_zero_in(value, window, cost).map(|x| (x, Side::Lower))
            }
        };
        let first = first.map(|(x, side)| (x * window.width, x, side)).filter(|(t, ..)| *t < until);
        Ok(first.map(|(t, x, side)| {
            self.found = Some((t, x));
            (t, side)
        }))
    }

    fn at(&mut self, t: f64) -> Reached {
        self.reached(self.part(t), State::moved)
    }

    fn arrive(&mut self, t: f64, _: End, cost: &mut Cost) -> (Df64, Reached) {
        cost.evaluations += 1;
        let x = self.found.filter(|found| found.0 == t).map_or_else(|| self.part(t), |found| found.1);
        (t.into(), self.reached(x, State::advanced))
    }
}

/// Shortens a window in which a phase would go far beyond its cell, so that its polynomial keeps its digits.
fn shorten(window: &mut Window<'_>, now: &Hybrid<'_>) {
    for law in &now.laws {
        let (lower, upper) = law.bounds();
        for _ in 0..4 {
            let course = window.along(&law.surface.normal);
            let far = course[1].abs() + course[2].abs() + course[3].abs();
            let part = 2.0 * (upper - lower) / far;
            if part.is_nan() || part >= 1.0 {
                break;
            }
            window.shorten(part.max(WINDOW_CUT));
        }
    }
}
