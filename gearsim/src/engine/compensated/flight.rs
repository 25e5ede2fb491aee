//! The motion in a cell in double-double precision, and the time at which a phase reaches a boundary.

use nalgebra::DVector;
use xprec::Df64;

use crate::engine::compensated::cell::Cell;
use crate::tolerance::events::COMPENSATED_TAYLOR;

/// A state in double-double precision.
#[derive(Debug, Clone)]
pub struct State {
    /// Coordinates without their whole pitches (N).
    pub q: DVector<Df64>,
    /// Speeds (N).
    pub q_dot: DVector<Df64>,
}

/// The motion in a cell from a given state on.
pub struct Flight<'a> {
    cell: &'a Cell,
    start: State,
    /// Modal speeds at the start.
    speed: DVector<Df64>,
    /// Modal forces g - omega² xi at the start.
    force: DVector<Df64>,
}

/// Maximum number of Newton steps. One is enough for a guess of 16 digits, a few near a graze.
const MOST_STEPS: usize = 8;

impl<'a> Flight<'a> {
    /// The motion from `start` on.
    pub fn new(cell: &'a Cell, start: State) -> Self {
        let speed = &cell.momentum * &start.q_dot;
        let xi = &cell.momentum * &start.q;
        let force = DVector::from_fn(xi.len(), |i, _| cell.load[i] - cell.modes[i].omega2 * xi[i]);
        Flight { cell, start, speed, force }
    }

    /// xi(t) - xi(0) and xi'(t) - xi'(0) of the modes after the time `t` [s].
    fn modal(&self, t: Df64) -> (DVector<Df64>, DVector<Df64>) {
        let n = self.speed.len();
        let (mut moved, mut gained) = (DVector::from_element(n, t), DVector::from_element(n, t));
        for (i, mode) in self.cell.modes.iter().enumerate() {
            let (s1, s2) = mode.response(t);
            let (v, f) = (self.speed[i], self.force[i]);
            moved[i] = v * s1 + f * s2;
            gained[i] = (f - mode.sigma * v * 2.0) * s1 - mode.omega2 * v * s2;
        }
        (moved, gained)
    }

    /// Speeds, accelerations and jerks of the modes.
    fn rates(&self, moved: &DVector<Df64>, gained: &DVector<Df64>) -> [DVector<Df64>; 3] {
        let v = &self.speed + gained;
        let modes = &self.cell.modes;
        let a =
            DVector::from_fn(v.len(), |i, _| self.force[i] - modes[i].omega2 * moved[i] - modes[i].sigma * v[i] * 2.0);
        let jerk = DVector::from_fn(v.len(), |i, _| -(modes[i].omega2 * v[i] + modes[i].sigma * a[i] * 2.0));
        [v, a, jerk]
    }

    fn state(&self, moved: &DVector<Df64>, gained: &DVector<Df64>) -> State {
        State { q: &self.start.q + &self.cell.shapes * moved, q_dot: &self.start.q_dot + &self.cell.shapes * gained }
    }

    /// The state after the time `t` [s].
    pub fn at(&self, t: Df64) -> State {
        let (moved, gained) = self.modal(t);
        self.state(&moved, &gained)
    }

    /// The time near `t` [s] at which coordinate `phase` reaches `boundary`, and the state there. If it does not reach it, e.g.
    /// at a graze, `t` and the state at `t`.
    pub fn meet(&self, phase: usize, boundary: f64, t: f64) -> (Df64, State) {
        let weight = |i: usize| self.cell.shapes[(phase, i)];
        let along = |x: &DVector<Df64>| (0..x.len()).fold(Df64::from(0.0), |sum, i| sum + weight(i) * x[i]);
        let (gap, begun) = (Df64::from(boundary) - self.start.q[phase], Df64::from(t));
        let mut t = begun;
        for _ in 0..MOST_STEPS {
            let (mut moved, mut gained) = self.modal(t);
            let [v, a, jerk] = self.rates(&moved, &gained);
            let (gap, rate) = (gap - along(&moved), along(&v));
            let newton = gap / rate;
            // Relative correction of Newton's step to the root of gap - rate dt - a dt²/2.
            let lacking = 0.5 * along(&a).hi() * newton.hi() / rate.hi();
            let dt = newton - newton * lacking;
            if !dt.hi().is_finite() {
                break;
            }
            if dt.hi().abs() * self.cell.rate <= COMPENSATED_TAYLOR && lacking.abs() <= COMPENSATED_TAYLOR {
                moved += (v + &a * (dt * 0.5)) * dt;
                gained += (a + jerk * (dt * 0.5)) * dt;
                return (t + dt, self.state(&moved, &gained));
            }
            t += dt;
        }
        (begun, self.at(begun))
    }
}
