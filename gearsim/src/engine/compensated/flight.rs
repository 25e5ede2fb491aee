//! The motion in a cell in double-double precision, and the time at which a guard becomes zero.

use nalgebra::DVector;
use xprec::Df64;

use super::State;
use super::cell::Cell;
use super::forces::Forces;
use super::guard::{Guard, dot, product, transposed};
use super::series::Series;
use crate::tolerance::events::{COMPENSATED_CORRECTION, COMPENSATED_TAYLOR};

/// The motion in a cell from a given state on.
pub struct Flight<'a> {
    cell: &'a Cell,
    start: State,
    course: Course<'a>,
}

/// How the modes move.
enum Course<'a> {
    /// Uncoupled modes in closed form: modal speeds and forces at the start.
    Closed([DVector<Df64>; 2]),
    /// Coupled or forced modes, by power series.
    Series(Box<Series<'a>>),
}

/// The motion at one instant, in modes.
pub struct Instant {
    /// xi(t) - xi(0).
    pub moved: DVector<Df64>,
    /// xi'(t) - xi'(0).
    pub gained: DVector<Df64>,
    /// xi', xi'', xi'''.
    pub rates: [DVector<Df64>; 3],
}

/// Maximum number of Newton steps. One step is enough for a guess with 16 digits; near a graze a few are needed.
const MOST_STEPS: usize = 8;

impl<'a> Flight<'a> {
    /// The motion from the state `start` at the time `since` \[s\]. `fastest` is the highest angular frequency of `forces` \[rad/s\]. If
    /// `flat`, the forces are constant.
    pub fn new(cell: &'a Cell, start: State, since: Df64, (forces, fastest, flat): (Forces<'a>, f64, bool)) -> Self {
        let speed = product(&cell.momentum, &start.q_dot);
        let mut force = &cell.load - product(&cell.springs, &start.q);
        let course = match &cell.modes {
            Some(_) if flat => {
                for (load, series) in forces.loads().zip(forces.series(since, 1.0)) {
                    force += cell.shapes.transpose() * load * series[0];
                }
                Course::Closed([speed, force])
            }
            _ => Course::Series(Box::new(Series::new(cell, forces, since, fastest, [speed, force]))),
        };
        Flight { cell, start, course }
    }

    /// The modes after the time `t` \[s\].
    fn look(&mut self, t: Df64) -> Instant {
        match (&mut self.course, &self.cell.modes) {
            (Course::Closed(start), Some(modes)) => {
                let [speed, force] = &*start;
                let n = speed.len();
                let none = || DVector::from_element(n, t);
                let (mut moved, mut gained, mut v, mut a, mut jerk) = (none(), none(), none(), none(), none());
                for (i, mode) in modes.iter().enumerate() {
                    let (s1, s2) = mode.response(t);
                    moved[i] = speed[i] * s1 + force[i] * s2;
                    gained[i] = (force[i] - mode.sigma * speed[i] * 2.0) * s1 - mode.omega2 * speed[i] * s2;
                    v[i] = speed[i] + gained[i];
                    a[i] = force[i] - mode.omega2 * moved[i] - mode.sigma * v[i] * 2.0;
                    jerk[i] = -(mode.omega2 * v[i] + mode.sigma * a[i] * 2.0);
                }
                Instant { moved, gained, rates: [v, a, jerk] }
            }
            (Course::Series(series), _) => series.at(t),
            (Course::Closed(_), None) => unreachable!("coupled modes move by series"),
        }
    }

    fn state(&self, moved: &DVector<Df64>, gained: &DVector<Df64>) -> State {
        let of_modes = |xi: &DVector<Df64>| product(&self.cell.shapes, xi);
        State { q: &self.start.q + of_modes(moved), q_dot: &self.start.q_dot + of_modes(gained) }
    }

    /// The state after the time `t` [s].
    pub fn at(&mut self, t: Df64) -> State {
        let Instant { moved, gained, .. } = self.look(t);
        self.state(&moved, &gained)
    }

    /// The time near `t` [s] at which `guard` is zero, and the state there; `None` if it has no zero near `t`, e.g. at a graze.
    pub fn meet(&mut self, guard: &Guard, t: f64) -> Option<(Df64, State)> {
        let on_q = transposed(&self.cell.shapes, &guard.on_q);
        let depends_on_speed = guard.on_speed.iter().any(|slope| slope.hi() != 0.0);
        let on_speed = depends_on_speed.then(|| transposed(&self.cell.shapes, &guard.on_speed));
        let along = |moved: &DVector<Df64>, gained: &DVector<Df64>| match &on_speed {
            Some(on_speed) => dot(&on_q, moved) + dot(on_speed, gained),
            None => dot(&on_q, moved),
        };
        let (value, begun) = (guard.value(&self.start), Df64::from(t));
        let mut t = begun;
        for _ in 0..MOST_STEPS {
            let Instant { mut moved, mut gained, rates: [v, a, jerk] } = self.look(t);
            let [pushed, push_rate, push_curve] = match &self.course {
                Course::Series(series) => series.pushed(&guard.on_force, t),
                Course::Closed(_) => [Df64::from(0.0); 3],
            };
            let gap = -(value + along(&moved, &gained) + pushed);
            let rate = along(&v, &a) + push_rate;
            let curve = (along(&a, &jerk) + push_curve).hi();
            let newton = gap / rate;
            // Relative correction of Newton's step to the root of gap - rate dt - curve dt²/2.
            let lacking = 0.5 * curve * newton.hi() / rate.hi();
            let dt = newton - newton * lacking;
            let far = (t + dt - begun).hi().abs() * self.cell.rate;
            if !dt.hi().is_finite() || far > COMPENSATED_CORRECTION {
                break;
            }
            if dt.hi().abs() * self.cell.rate <= COMPENSATED_TAYLOR && lacking.abs() <= COMPENSATED_TAYLOR {
                let half = dt * 0.5;
                for i in 0..moved.len() {
                    moved[i] += (v[i] + a[i] * half) * dt;
                    gained[i] += (a[i] + jerk[i] * half) * dt;
                }
                return Some((t + dt, self.state(&moved, &gained)));
            }
            t += dt;
        }
        None
    }
}
