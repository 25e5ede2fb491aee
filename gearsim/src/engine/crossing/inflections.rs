//! The search for a phase in which one mode oscillates and the others move steadily: from inflection to inflection.
//!
//! The acceleration of such a phase is s''(t) = e^(-sigma t) (a cos wt + b sin wt). Its zeros are pi/w apart. Between two of them
//! s is convex or concave. A concave phase may rise to its upper boundary and must turn before it falls to the lower one, so that
//! three values decide which it meets first: those at both ends, and that at the turn.

use super::{Cost, Search, Side};
use crate::engine::cell::Point;
use crate::engine::mode::Mode;
use crate::tolerance::events::{BRACKET_WIDTH, INFLECTIONS};

/// The oscillation of a phase.
struct Oscillation<'a> {
    mode: &'a Mode,
    /// s'' and s''' at the start.
    acceleration: f64,
    jerk: f64,
}

/// A place of the phase: time, distance moved, rate.
#[derive(Clone, Copy)]
struct Place {
    t: f64,
    moved: f64,
    rate: f64,
}

impl Search<'_> {
    /// The first boundary reached before the horizon, as [`Search::first`] gives it. The outer `None` means that the phase is not of
    /// this kind, or that it passes too many inflections; `point` is then anywhere.
    pub(super) fn between_inflections(&self, point: &mut Point, cost: &mut Cost) -> Option<Option<Side>> {
        let Oscillation { mode, acceleration, jerk } = self.single_oscillation()?;
        let leaves = |side: Side| self.gap(side) <= self.tolerance() && side.sign() * self.rate >= 0.0;
        if leaves(Side::Upper) || leaves(Side::Lower) {
            return None;
        }
        let w = mode.damped_frequency();
        let phase = (-acceleration).atan2((jerk + mode.sigma * acceleration) / w);
        let half_period = std::f64::consts::PI / w;
        let mut inflection = if phase <= 0.0 { phase / w + half_period } else { phase / w };
        // 1 while s is convex, -1 while it is concave.
        let mut bends = if acceleration != 0.0 { acceleration.signum() } else { jerk.signum() };
        let mut from = Place { t: 0.0, moved: 0.0, rate: self.rate };
        for _ in 0..INFLECTIONS {
            cost.steps += 1;
            // Not where a number has overflowed.
            if !(inflection > from.t && inflection.is_finite()) {
                return None;
            }
            self.go(point, inflection, cost);
            let to = self.place(point);
            if !(to.moved.is_finite() && to.rate.is_finite()) {
                return None;
            }
            // It turns away from the first boundary, towards the second.
            let (first, second) = if bends < 0.0 { (Side::Upper, Side::Lower) } else { (Side::Lower, Side::Upper) };
            if first.sign() * from.rate > 0.0
                && let Some(side) = self.before_the_turn(first, from, to, point, cost)
            {
                return Some((point.t < self.horizon).then_some(side));
            }
            let gap = self.gap(second);
            if second.sign() * to.moved > gap {
                self.go(point, to.t, cost);
                return Some(self.newton(second, gap, (from.t, to.t), point, cost));
            }
            if to.t >= self.horizon {
                return Some(None);
            }
            (from, bends, inflection) = (to, -bends, inflection + half_period);
            if point.t != from.t {
                self.go(point, from.t, cost);
            }
            // Half periods in which it cannot reach a boundary are left out, two by two.
            let pairs = (0.5 * self.out_of_reach(from, point) / half_period).floor();
            if pairs >= 1.0 {
                let t = from.t + 2.0 * pairs * half_period;
                if t >= self.horizon {
                    return Some(None);
                }
                self.go(point, t, cost);
                (from, inflection) = (self.place(point), t + half_period);
            }
        }
        None
    }

    /// The time from a place on before which the phase reaches no boundary \[s\]; `point` is there.
    fn out_of_reach(&self, place: Place, point: &Point) -> f64 {
        let reach = self.signal.reach(point);
        let time = |side: Side| match self.gap(side) {
            gap if gap.is_finite() => reach.time((gap - side.sign() * place.moved).max(0.0), side.sign()),
            _ => f64::INFINITY,
        };
        time(Side::Upper).min(time(Side::Lower))
    }

    /// Whether the phase crosses `side` between two places, on its way from the first; `point` is then moved there.
    fn before_the_turn(&self, side: Side, from: Place, to: Place, point: &mut Point, cost: &mut Cost) -> Option<Side> {
        let (sign, gap, tolerance) = (side.sign(), self.gap(side), self.tolerance());
        let beyond = |place: Place| sign * place.moved - gap;
        let mut end = to;
        if sign * to.rate < 0.0 {
            // It goes no further than to where the tangents at both ends meet.
            let until = (to.moved - from.moved - to.rate * (to.t - from.t)) / (from.rate - to.rate);
            let most = Place { moved: from.moved + from.rate * until, ..from };
            if beyond(most) < -tolerance {
                return None;
            }
            end = self.turn(from, to, point, cost);
            if beyond(end) <= tolerance {
                cost.grazes += u64::from(beyond(end) >= -tolerance);
                return None;
            }
        } else if beyond(to) <= 0.0 {
            return None;
        }
        // From the side where s is still short of the boundary, Newton's method does not pass the root.
        self.go(point, from.t, cost);
        self.newton(side, gap, (from.t, end.t), point, cost);
        Some(side)
    }

    /// Where the rate is zero between two places at which it has opposite signs, to half the digits of the time: then the place is
    /// known to all its digits. By Newton's method in a bracket.
    fn turn(&self, from: Place, to: Place, point: &mut Point, cost: &mut Cost) -> Place {
        let (mut low, mut high) = (from.t, to.t);
        self.go(point, from.t + (to.t - from.t) * from.rate / (from.rate - to.rate), cost);
        loop {
            cost.steps += 1;
            let [_, rate, acceleration, ..] = self.signal.derivatives(point);
            let t = point.t;
            if (rate > 0.0) == (from.rate > 0.0) {
                low = t
            } else {
                high = t
            }
            let newton = t - rate / acceleration;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            let near = (next - t).abs() <= BRACKET_WIDTH.sqrt() * (to.t - from.t);
            self.go(point, next, cost);
            if near || high - low <= BRACKET_WIDTH * high {
                return self.place(point);
            }
        }
    }

    fn place(&self, point: &Point) -> Place {
        let [moved, rate, ..] = self.signal.derivatives(point);
        Place { t: point.t, moved, rate }
    }

    fn gap(&self, side: Side) -> f64 {
        if side == Side::Upper { self.up } else { self.down }
    }

    /// The only oscillation of the phase; `None` if there is none or more than one, or if a mode moves otherwise.
    fn single_oscillation(&self) -> Option<Oscillation<'_>> {
        if self.signal.on_speed.is_some() {
            return None;
        }
        let mut single = None;
        for ((mode, v, a), c) in self.signal.flight.motions_at_start().zip(self.signal.on_moved) {
            if *c == 0.0 || (mode.is_rigid() && a == 0.0) || (v == 0.0 && a == 0.0) {
                continue;
            }
            if single.is_some() || mode.damped_frequency() <= 0.0 {
                return None;
            }
            single = Some(Oscillation { mode, acceleration: c * a, jerk: c * mode.next(v, a) });
        }
        single
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::cell::Cell;
    use crate::engine::equations::Derived;
    use crate::engine::signal::Signal;
    use crate::engine::vector::Vector;
    use crate::generated::gear_pair::GearPair;

    /// Against the search by steps, over flights of the paper's gear pair from all kinds of states: fast and slow, from a boundary and
    /// from between, with and without damping, deep swings and shallow ones.
    #[test]
    fn agrees_with_the_search_by_steps() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        let (mut found, mut none, mut different) = (0, 0, vec![]);
        for i in 0..20_000 {
            let zeta = [0.0, 0.01, 0.1, 0.7][i % 4];
            let parameters: Vec<f64> = GearPair::MODEL
                .parameters
                .iter()
                .map(|p| match p.name {
                    "I1" => 2890e-6,
                    "I2" => 0.7402,
                    "zeta" => zeta,
                    "T0" => 10.0,
                    _ => p.default.unwrap_or(1.0),
                })
                .collect();
            let names = ["stiffness_step", "damping", "torques"];
            let effects = GearPair::MODEL.effects.iter().enumerate().filter(|(_, e)| names.contains(&e.name));
            let effects = effects.fold(0, |set, (bit, _)| set | 1 << bit);
            let equations = GearPair::equations(effects, &parameters, &[2105.0]).expect("effects that agree");
            let cell = Cell::new(&*equations, &GearPair::MODEL.in_contact([1430.0])).expect("a linear cell");
            let speed = (random() - 0.5) * 10f64.powf(6.0 * random() - 3.0);
            let swing = 10f64.powf(4.0 * random() - 4.0);
            let (q, v) = ([0.0, 10.0 / 1430.0 + swing * (random() - 0.5)], [speed, 1e3 * swing * (random() - 0.5)]);
            let down = if i % 3 == 0 && speed > 0.0 { 0.0 } else { random() };
            let flight = cell.flight(&Vector::from(&q[..]), &Vector::from(&v[..]));
            let on_moved = cell.participation(&Vector::from([1.0, 0.0]));
            let signal = Signal { flight: &flight, on_moved: &on_moved, on_speed: None };
            let search = Search { signal, rate: speed, down, up: 1e-3 + random(), horizon: 0.1 };
            let (mut a, mut b, mut cost) = (flight.begin(), flight.begin(), Cost::default());
            let Some(side) = search.between_inflections(&mut a, &mut cost) else { continue };
            let by_steps = search.by_steps(&mut b, &mut cost).expect("the search ends");
            let same = side == by_steps && (side.is_none() || (a.t - b.t).abs() <= 1e-9 * b.t.max(1e-6));
            found += u32::from(side.is_some());
            none += u32::from(side.is_none());
            if !same {
                different.push((i, side, a.t, by_steps, b.t));
            }
        }
        println!("{found} crossings, {none} flights without");
        assert!(found > 5_000 && none > 200, "{found} {none}");
        assert!(
            different.is_empty(),
            "{} of {}: {:?}",
            different.len(),
            found + none,
            &different[..different.len().min(8)]
        );
    }
}
