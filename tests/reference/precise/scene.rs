//! The gear pair of Oh, Grosh & Barber in 50 and more digits: every event, and the state at the end.
//!
//! The given parameters and start are taken as exact binary numbers; M1, M2, C = 2 zeta w0/M2 and everything else is computed from
//! them in all digits. theta = theta_0 + u t + (M1/M2)(phi - phi_0) is the sum of a mode without stiffness and the mode phi.

use super::cell::{Law, Motion};
use super::crossing::Surface;
use super::number::{Real, Scalar};
use crate::oh2005::{GearPair, Kind, PITCH, State};

/// An event: theta meets an end of its cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// time \[s\], as a sum of two numbers
    pub t: (f64, f64),
    /// transmission or reflection
    pub kind: Kind,
    /// cell before, counted as in [`GearPair::k`]
    pub cell_from: i64,
    /// cell after; the same in a reflection
    pub cell_to: i64,
}

/// Position and velocity, each as a sum of two numbers: 32 digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End {
    /// mean rotation theta, unwrapped \[rad\]
    pub theta: (f64, f64),
    /// its velocity \[rad/s\]
    pub theta_dot: (f64, f64),
    /// relative deflection phi \[rad\]
    pub phi: (f64, f64),
    /// its velocity \[rad/s\]
    pub phi_dot: (f64, f64),
    /// the cell
    pub cell: i64,
    /// theta beyond the lower end of the cell \[rad\]
    pub local: (f64, f64),
}

/// A motion from its start to its end time.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// events, in order
    pub events: Vec<Event>,
    /// state at the end time
    pub end: End,
    /// number of transmissions
    pub cell_changes: u64,
    /// number of reflections
    pub reflections: u64,
    /// (U at the end - U at the start)/(U at the start)
    pub energy_change: f64,
    /// smallest |theta'^2 - M2 dk phi^2|/theta'^2 of the events: how close a decision between transmission and reflection was
    pub narrowest: f64,
    /// smallest distance \[rad\] of theta from an end of a cell that was nearly reached
    pub near_miss: f64,
}

/// Parameters in all digits.
struct Pair<const BITS: usize> {
    m2: Real<BITS>,
    /// M1/M2
    ratio: Real<BITS>,
    t0: Real<BITS>,
    k: [Real<BITS>; 2],
    width: [Real<BITS>; 2],
    oscillator: [Law<Real<BITS>>; 2],
    drift: Law<Real<BITS>>,
}

/// theta from the lower end of the cell, theta', phi, phi'.
#[derive(Clone)]
struct Point<const BITS: usize> {
    theta: Real<BITS>,
    theta_dot: Real<BITS>,
    phi: Real<BITS>,
    phi_dot: Real<BITS>,
}

impl<const BITS: usize> Pair<BITS> {
    fn new(p: &GearPair) -> Self {
        let real = Real::<BITS>::exact;
        let squared = |n: f64| real(n) * real(n);
        let (one, two) = (squared(p.n1) / real(p.i1), squared(p.n2) / real(p.i2));
        let (m1, m2) = ((one.clone() - two.clone()).scaled(-1), (one + two).scaled(-1));
        let k = [p.k1, p.k2].map(real);
        let k0 = (k[0].clone() + k[1].clone()).scaled(-1);
        let sigma = real(p.zeta) * (m2.clone() * k0).root();
        let oscillator = [0, 1].map(|i: usize| Law::new(sigma.clone(), m2.clone() * k[i].clone()));
        let width = [real(p.width1), real(PITCH) - real(p.width1)];
        let ratio = m1 / m2.clone();
        let drift = Law::new(real(0.0), real(0.0));
        Self { m2, ratio, t0: real(p.t0), k, width, oscillator, drift }
    }

    /// The modes x and y of theta = x + (M1/M2) y, where x'' = 0 and y = phi - phi_0. So a start on the end of a cell has no rounding
    /// error.
    fn modes(&self, side: usize, s: &Point<BITS>) -> [Motion<Real<BITS>>; 2] {
        let zero = || Real::exact(0.0);
        let v = s.theta_dot.clone() - self.ratio.clone() * s.phi_dot.clone();
        let push = self.m2.clone() * (self.t0.clone() - self.k[side].clone() * s.phi.clone());
        let law = self.oscillator[side].clone();
        [
            Motion::new(self.drift.clone(), zero(), s.theta.clone(), v, Real::exact(1.0)),
            Motion::new(law, push, zero(), s.phi_dot.clone(), self.ratio.clone()),
        ]
    }

    /// The point at which the modes are in `states`.
    fn at(&self, from: &Point<BITS>, states: &[(Real<BITS>, Real<BITS>)]) -> Point<BITS> {
        let [(x, v), (y, phi_dot)] = states else { panic!("two modes") };
        let theta = x.clone() + self.ratio.clone() * y.clone();
        let theta_dot = v.clone() + self.ratio.clone() * phi_dot.clone();
        Point { theta, theta_dot, phi: from.phi.clone() + y.clone(), phi_dot: phi_dot.clone() }
    }

    /// U = T + V - 2 T0 phi, with T = (theta' + phi')^2/(2 a) + (theta' - phi')^2/(2 b) and a, b = M2 +- M1.
    fn energy(&self, side: usize, s: &Point<BITS>) -> Real<BITS> {
        let m1 = self.ratio.clone() * self.m2.clone();
        let [first, second] = [s.theta_dot.clone() + s.phi_dot.clone(), s.theta_dot.clone() - s.phi_dot.clone()];
        let kinetic =
            first.clone() * first / (self.m2.clone() + m1.clone()) + second.clone() * second / (self.m2.clone() - m1);
        let potential = self.k[side].clone() * s.phi.clone() * s.phi.clone();
        kinetic.scaled(-1) + potential - (self.t0.clone() * s.phi.clone()).scaled(1)
    }
}

/// The motion over \[0, `t_end`\] \[s\] with `digits` decimal digits: up to 50, 70 or 110.
pub fn scene(pair: &GearPair, start: &State, t_end: f64, digits: u32) -> Run {
    match digits {
        0..=50 => scene_with::<192>(pair, start, t_end),
        51..=70 => scene_with::<256>(pair, start, t_end),
        71..=110 => scene_with::<384>(pair, start, t_end),
        _ => panic!("up to 110 digits, not {digits}"),
    }
}

/// [`scene`] with `BITS` binary digits.
pub fn scene_with<const BITS: usize>(pair: &GearPair, start: &State, t_end: f64) -> Run {
    let p = Pair::<BITS>::new(pair);
    let side = |cell: i64| (cell & 1) as usize;
    let (mut cell, _) = pair.locate(start.theta);
    let below = |cell: i64| {
        let pitches = Real::exact(cell.div_euclid(2) as f64) * Real::exact(PITCH);
        if side(cell) == 0 { pitches } else { pitches + p.width[0].clone() }
    };
    let mut s = Point {
        theta: Real::exact(start.theta) - below(cell),
        theta_dot: Real::exact(start.theta_dot),
        phi: Real::exact(start.phi),
        phi_dot: Real::exact(start.phi_dot),
    };
    let first = p.energy(side(cell), &s);
    let (mut events, mut cell_changes, mut reflections) = (Vec::new(), 0, 0);
    let (mut narrowest, mut near_miss) = (f64::INFINITY, f64::INFINITY);
    let (mut t, until) = (Real::exact(0.0), Real::exact(t_end));
    loop {
        // solve
        let here = side(cell);
        let modes = p.modes(here, &s);
        // locate: the upper end, then the lower end at an earlier time
        let left = until.clone() - t.clone();
        let horizon = left.approx() * (1.0 + 1e-15);
        let upper = Surface { motions: &modes, level: p.width[here].clone(), sign: 1.0 }.first_crossing(horizon);
        let before = upper.root.as_ref().map_or(horizon, |f| f.t.approx() * (1.0 + 1e-15));
        let lower = Surface { motions: &modes, level: Real::exact(0.0), sign: -1.0 }.first_crossing(before);
        near_miss = near_miss.min(upper.near_miss).min(lower.near_miss);
        let found = match (upper.root, lower.root) {
            (Some(up), Some(low)) if up.t < low.t => Some((up, true)),
            (_, Some(low)) => Some((low, false)),
            (up, None) => up.map(|up| (up, true)),
        };
        let Some((found, upwards)) = found.filter(|(f, _)| f.t <= left) else {
            let states = modes.each_ref().map(|m| m.state(&left));
            s = p.at(&s, &states);
            let last = p.energy(here, &s);
            let change = ((last - first.clone()) / first).approx();
            let theta = (below(cell) + s.theta.clone()).pair();
            let [theta_dot, phi, phi_dot, local] = [&s.theta_dot, &s.phi, &s.phi_dot, &s.theta].map(Real::pair);
            let end = End { theta, theta_dot, phi, phi_dot, cell, local };
            return Run { events, end, cell_changes, reflections, energy_change: change, narrowest, near_miss };
        };
        assert!(!found.tangency, "theta touches the end of cell {cell} without crossing it, to all digits");
        s = p.at(&s, &found.states);
        t = t + found.t;
        // jump, Eqs. (9), (11)
        let beyond = if upwards { cell + 1 } else { cell - 1 };
        let work = p.m2.clone() * (p.k[side(beyond)].clone() - p.k[here].clone()) * s.phi.clone() * s.phi.clone();
        let square = s.theta_dot.clone() * s.theta_dot.clone() - work;
        narrowest = narrowest.min((square.clone() / (s.theta_dot.clone() * s.theta_dot.clone())).abs().approx());
        let (kind, cell_to, after) = if square.is_negative() {
            reflections += 1;
            s.theta = if upwards { p.width[here].clone() } else { Real::exact(0.0) };
            (Kind::Reflect, cell, -s.theta_dot.clone())
        } else {
            cell_changes += 1;
            s.theta = if upwards { Real::exact(0.0) } else { p.width[side(beyond)].clone() };
            let speed = square.root();
            (Kind::Transmit, beyond, if upwards { speed } else { -speed })
        };
        s.phi_dot = s.phi_dot.clone() + p.ratio.clone() * (after.clone() - s.theta_dot.clone());
        s.theta_dot = after;
        events.push(Event { t: t.pair(), kind, cell_from: cell, cell_to });
        cell = cell_to;
    }
}
