//! Eight simulations under way: one cell change of all of them at once.
//!
//! A lane passes a step where its phase is monotone for certain, Newton's method converges in the bracket, the step lies
//! before the end of the run, and the energy suffices. What is not so plain is left as it was, for the scalar engine.

use xprec::Df64;

use crate::engine::cell::Cell;
use crate::engine::equations::Switching;
use crate::engine::mode::{Mode, NEAR};
use crate::engine::simulate::Simulation;
use crate::ensemble::cells::Cells;
use crate::ensemble::elementary::LARGEST_ANGLE;
use crate::ensemble::flight::{Flight, Point};
use crate::ensemble::pack::{LANES, Mask, Pack};

/// The state of eight simulations, in arrays.
pub struct Lanes<const N: usize> {
    /// The cells, by their place in the pitch.
    pub tables: Vec<Cells<N>>,
    /// Which modes are rigid, in every lane.
    pub rigid: [bool; N],
    /// Coordinate that is the phase.
    pub phase: usize,
    /// G and M⁻¹n / G (N) of the steps; no impulse where G is zero.
    pub compliance: Pack,
    pub direction: [Pack; N],

    pub q: [Pack; N],
    pub q_dot: [Pack; N],
    /// Time from the start of the lane, as a sum of two numbers [s], and where the lane ends.
    pub clock: [Pack; 2],
    pub end: Pack,
    pub dissipated: Pack,
    /// The cell of each lane.
    pub at: [usize; LANES],
    /// Whole pitches since the start of the lane, and cell changes.
    pub turns: [i64; LANES],
    pub changes: [u64; LANES],
    /// How much longer each cell took than its steady part alone, when last passed.
    pub lateness: Vec<Pack>,
}

/// What simulations must have in common to be side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kind<const N: usize> {
    /// Cells in a pitch.
    places: usize,
    /// Coordinate that is the phase.
    phase: usize,
    /// Which modes are rigid, in every cell; the others oscillate.
    rigid: [bool; N],
}

impl<const N: usize> Kind<N> {
    /// That of a simulation; `None` if it can be in no lane: its events are never plain, or a mode is rigid in some cells
    /// only, damped beyond oscillating, or coupled to others by damping.
    pub fn of(simulation: &Simulation<'_, N>) -> Option<Self> {
        let law = simulation.laws.first().filter(|_| simulation.is_plain())?;
        let cells = simulation.cells().all();
        let rigid: [bool; N] = std::array::from_fn(|i| cells[0].cell.modes[i].is_rigid());
        let oscillates = |mode: &Mode| mode.damped_frequency() > 0.1 * mode.sigma;
        let plain = |(mode, rigid): (&Mode, &bool)| if *rigid { mode.is_rigid() } else { oscillates(mode) };
        let fits = |cell: &Cell<N>| cell.coupling.is_none() && cell.modes.iter().zip(&rigid).all(plain);
        let fits = cells.iter().all(|prepared| fits(&prepared.cell));
        fits.then_some(Kind { places: law.pitch.cells(), phase: law.phase, rigid })
    }
}

/// Evaluations of the motion beyond which a lane is left to the scalar engine.
const MOST: usize = 3;

impl<const N: usize> Lanes<N> {
    /// Empty lanes for simulations of one kind.
    pub fn new(kind: Kind<N>) -> Self {
        let zero = Pack::all(0.0);
        let Kind { places, phase, rigid } = kind;
        Lanes {
            tables: vec![Cells::empty(); places],
            rigid,
            phase,
            compliance: zero,
            direction: [zero; N],
            q: [zero; N],
            q_dot: [zero; N],
            clock: [zero; 2],
            end: zero,
            dissipated: zero,
            at: [0; LANES],
            turns: [0; LANES],
            changes: [0; LANES],
            lateness: vec![zero; places],
        }
    }

    /// Puts a simulation into a lane; its cells only if it is `new` there.
    pub fn load(&mut self, lane: usize, simulation: &Simulation<'_, N>, new: bool) {
        let law = &simulation.laws[0];
        if new {
            self.tables.iter_mut().enumerate().for_each(|(place, table)| table.fill(lane, simulation, place));
            self.lateness.iter_mut().for_each(|lateness| lateness.0[lane] = 0.0);
            let impulse = law.switching == Switching::WithJump;
            self.compliance.0[lane] = if impulse { law.surface.compliance } else { 0.0 };
            (0..N).for_each(|i| self.direction[i].0[lane] = law.surface.direction[i]);
        }
        for i in 0..N {
            self.q[i].0[lane] = simulation.state.q[i];
            self.q_dot[i].0[lane] = simulation.state.q_dot[i];
        }
        (self.clock[0].0[lane], self.clock[1].0[lane]) = (simulation.clock.0.hi(), simulation.clock.0.lo());
        self.end.0[lane] = simulation.t_end;
        self.dissipated.0[lane] = simulation.dissipated;
        (self.at[lane], self.turns[lane], self.changes[lane]) = (law.cell, 0, 0);
    }

    /// Hands its state back to a simulation.
    pub fn unload(&self, lane: usize, simulation: &mut Simulation<'_, N>) {
        for i in 0..N {
            simulation.state.q[i] = self.q[i].0[lane];
            simulation.state.q_dot[i] = self.q_dot[i].0[lane];
        }
        simulation.state.turns[self.phase] += self.turns[lane];
        simulation.laws[0].cell = self.at[lane];
        simulation.clock.0 = Df64::new_full(self.clock[0].0[lane], self.clock[1].0[lane]);
        simulation.dissipated = self.dissipated.0[lane];
        simulation.counts.cell_changes += self.changes[lane];
    }

    /// Passes one step in those of the `active` lanes that can; tells which have.
    #[inline(always)]
    pub fn pass(&mut self, active: Mask) -> Mask {
        let first = (0..LANES).find(|lane| active.says(*lane)).map_or(0, |lane| self.at[lane]);
        let together = (0..LANES).all(|lane| !active.says(lane) || self.at[lane] == first);
        let gathered;
        let cells = if together {
            &self.tables[first]
        } else {
            gathered = Cells::gather(&self.tables, &self.at);
            &gathered
        };
        let flight = Flight::new(cells, &self.q, &self.q_dot);

        // Certainty: the steady part of the phase's speed outweighs all that the oscillations can do.
        let (mut drift, mut wobble) = (Pack::all(0.0), Pack::all(0.0));
        let mut sure = active;
        for i in 0..N {
            let (c, v, a) = (cells.modes[i].part, flight.speed[i], flight.acceleration(i));
            if self.rigid[i] {
                drift = drift + c * v;
                sure = sure.and((c * a).compare(c, |a, _| a == 0.0));
            } else {
                wobble = wobble + c.abs() * (v.abs() + a.abs() * cells.modes[i].gain);
            }
        }
        sure = sure.and(drift.abs().compare(wobble, |d, w| d > w * (1.0 + 1e-12)));
        let up = drift.compare(drift, |d, _| d > 0.0);
        let sign = Pack::all(1.0).or(up, Pack::all(-1.0));
        let boundary = cells.bounds[1].or(up, cells.bounds[0]);
        let gap = sign * (boundary - self.q[self.phase]);
        let steady = gap / drift.abs();

        // Newton's method, from the time that the cell took last.
        let lateness = self.lateness(together, first);
        let mut t = (steady + lateness).zip(steady, |t, steady| if t > 0.0 { t } else { steady });
        let mut near = flight.all_at(&self.rigid, t);
        // Each lane's result is that of its first good step, however long the others take.
        let (mut points, mut taken, mut done) = (near, t, Mask::of(|_| false));
        for round in 1..=MOST {
            let [s, r, a, jerk, snap] = self.signal(cells, &flight, &near, sign);
            let f = gap - s;
            // The root of f - r dt - a dt²/2 - jerk dt³/6 - snap dt⁴/24 by reversion of the series.
            let inverse = 1.0 / r;
            let h = f * inverse;
            let (a, j) = (0.5 * a * inverse * h, (1.0 / 6.0) * jerk * inverse * h * h);
            let snap = (1.0 / 24.0) * snap * inverse * h * h * h;
            let dt = h * (1.0 - a + (2.0 * a * a - j) - (5.0 * a * (a * a - j) + snap));
            let angle = dt.abs() * cells.rate;
            let next = a * a + j.abs();
            let lacking = (14.0 * next * next + snap.abs() * (angle + 6.0 * a.abs())) * dt.abs();
            let good = angle.compare(a, |angle, a| (angle <= NEAR) & (a.abs() < 0.1)).and(r.compare(r, |r, _| r > 0.0));
            let good = good.and(lacking.compare(t, |l, t| l <= f64::EPSILON * t)).without(done);
            let shifted = flight.all_shifted(&self.rigid, &near, t, dt);
            for i in 0..N {
                points[i] = shifted[i].or(good, &points[i]);
            }
            taken = (t + dt).or(good, taken);
            done = done.with(good);
            if done.covers(sure) || round == MOST {
                break;
            }
            t = t + dt.zip(t, |dt, t| dt.max(-0.5 * t).min(t));
            near = flight.all_at(&self.rigid, t);
        }
        let t = taken;
        sure = sure.and(done).and(t.compare(self.end - self.clock[0] - self.clock[1], |t, left| t < left));
        sure = sure.and((cells.rate * t).compare(t, |angle, _| (angle >= 0.5) & (angle < LARGEST_ANGLE)));

        // The state there, and the jump.
        let (mut q, mut q_dot, mut lost) = (self.q, self.q_dot, self.dissipated);
        for j in 0..N {
            for i in 0..N {
                q[i] = q[i] + cells.shapes[i][j] * points[j].moved;
                q_dot[i] = q_dot[i] + cells.shapes[i][j] * points[j].gained;
            }
            if !self.rigid[j] {
                lost = lost + flight.dissipated(j, &points[j]);
            }
        }
        q[self.phase] = boundary;
        let mut dv = Pack::all(0.0);
        for i in 0..N {
            for j in 0..N {
                dv = dv + cells.step[1][i][j].or(up, cells.step[0][i][j]) * q[i] * q[j];
            }
        }
        let v = q_dot[self.phase];
        let lowered = 2.0 * self.compliance * dv;
        let square = v * v - lowered;
        sure = sure.and(square.compare(v, |square, v| (square > 0.0) & v.is_finite()));
        let gain = -(sign * lowered) / (square.sqrt() + v.abs());
        q[self.phase] = cells.entered[1].or(up, cells.entered[0]);

        // Only where all of it holds.
        for i in 0..N {
            self.q[i] = q[i].or(sure, self.q[i]);
            self.q_dot[i] = (q_dot[i] + self.direction[i] * gain).or(sure, self.q_dot[i]);
        }
        self.dissipated = lost.or(sure, self.dissipated);
        self.advance(t, sure);
        self.remember(t - steady, sure, together, first);
        self.enter(up, sure);
        sure
    }

    /// The phase's way, in the direction of its boundary, and its derivatives.
    #[inline(always)]
    fn signal(&self, cells: &Cells<N>, flight: &Flight<'_, N>, points: &[Point; N], sign: Pack) -> [Pack; 5] {
        let mut sum = [Pack::all(0.0); 5];
        for i in 0..N {
            let c = sign * cells.modes[i].part;
            let [v, a, jerk, snap] = flight.derivatives(i, &points[i]);
            for (sum, x) in sum.iter_mut().zip([points[i].moved, v, a, jerk, snap]) {
                *sum = *sum + c * x;
            }
        }
        sum
    }

    /// Knuth's two-sum.
    #[inline(always)]
    fn advance(&mut self, t: Pack, sure: Mask) {
        let [high, low] = self.clock;
        let dt = t + low;
        let sum = high + dt;
        let part = sum - high;
        let rest = (high - (sum - part)) + (dt - part);
        self.clock = [sum.or(sure, high), rest.or(sure, low)];
    }

    #[inline(always)]
    fn lateness(&self, together: bool, first: usize) -> Pack {
        if together {
            return self.lateness[first];
        }
        Pack(std::array::from_fn(|lane| self.lateness[self.at[lane]].0[lane]))
    }

    #[inline(always)]
    fn remember(&mut self, lateness: Pack, sure: Mask, together: bool, first: usize) {
        if together {
            let kept = &mut self.lateness[first];
            *kept = lateness.or(sure, *kept);
            return;
        }
        for lane in (0..LANES).filter(|lane| sure.says(*lane)) {
            self.lateness[self.at[lane]].0[lane] = lateness.0[lane];
        }
    }

    /// Goes on into the cells beyond.
    #[inline(always)]
    fn enter(&mut self, up: Mask, sure: Mask) {
        let last = self.tables.len() - 1;
        for lane in 0..LANES {
            if !sure.says(lane) {
                continue;
            }
            self.changes[lane] += 1;
            (self.at[lane], self.turns[lane]) = match (up.says(lane), self.at[lane]) {
                (true, at) if at == last => (0, self.turns[lane] + 1),
                (true, at) => (at + 1, self.turns[lane]),
                (false, 0) => (last, self.turns[lane] - 1),
                (false, at) => (at - 1, self.turns[lane]),
            };
        }
    }
}
