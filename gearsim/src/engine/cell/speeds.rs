//! The speeds of the modes on a flight, as sums of terms c tᵏ e^{nu t}: the eigenvalues of the modes, 0 and ± i W are nu. The integrals of
//! their products have a closed form ([`Moments`]).

use nalgebra::Complex;
use smallvec::SmallVec;

use super::{Driven, Flight, Point, Varying};
use crate::engine::mode::exp_m1;
use crate::tolerance::modes::{CANCELLING_TERMS, SERIES_SPAN, SERIES_TERM, SLOW_SPAN, SLOW_TERMS};

/// tᵏ e^{nu t}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// nu \[1/s\].
    pub rate: Complex<f64>,
    /// k.
    pub power: usize,
}

/// A sum of terms, each with its factor.
pub type Sum = SmallVec<[(Term, Complex<f64>); 6]>;

/// The speed of a mode.
#[derive(Debug, Clone, Default)]
pub struct Speed {
    /// The steady motion under its load.
    pub steady: Sum,
    /// The free motion about it: both eigenvalues, each with its factor.
    pub free: [(Complex<f64>, Complex<f64>); 2],
}

impl Speed {
    /// All terms that are not zero.
    pub fn terms(&self) -> Sum {
        let free = self.free.iter().filter(|(_, factor)| *factor != Complex::from(0.0));
        let free = free.map(|(rate, factor)| (Term { rate: *rate, power: 0 }, *factor));
        self.steady.iter().copied().chain(free).collect()
    }
}

/// The speeds a' of the modes on a flight.
#[derive(Debug)]
pub struct Speeds(pub Vec<Speed>);

impl Speeds {
    /// Those of `flight` until the time `horizon` \[s\]; `None` if the two eigenvalues of a mode coincide.
    pub fn new(flight: &Flight<'_>, horizon: f64) -> Option<Self> {
        Some(Speeds((0..flight.n()).map(|i| speed(flight, i, horizon)).collect::<Option<_>>()?))
    }

    /// Whether the terms are not much larger than the speeds from the start to a `point`: those of damped modes than the speeds of damped
    /// modes, whose squares are the loss, and those of all modes than all speeds.
    pub fn keep_digits(&self, flight: &Flight<'_>, point: &Point) -> bool {
        let size = |factor: &Complex<f64>| factor.re.abs() + factor.im.abs();
        // Sums over damped modes, and over all modes.
        let (mut terms, mut speeds) = ([0.0; 2], [0.0; 2]);
        for (i, Speed { steady, free }) in self.0.iter().enumerate() {
            let (before, after) = (flight.speed[i], flight.speed[i] + point.gained[i]);
            let of_steady = steady.iter().map(|(term, factor)| size(factor) * point.t.powi(term.power as i32));
            let sum = free.iter().map(|(_, factor)| size(factor)).sum::<f64>() + of_steady.sum::<f64>();
            for which in if flight.mode(i).sigma > 0.0 { 0..2 } else { 1..2 } {
                terms[which] += sum * sum;
                speeds[which] += before * before + after * after;
            }
        }
        (0..2).all(|which| terms[which] <= CANCELLING_TERMS * CANCELLING_TERMS * speeds[which])
    }

    /// Energy that damping has taken until the time `t` \[J\]; `None` if the eigenvalues of a mode of the cell coincide.
    #[inline]
    pub fn lost(&self, flight: &Flight<'_>, t: f64) -> Option<f64> {
        if let Some(coupling) = &flight.cell.coupling {
            return coupling.lost(&self.0, flight.driven(), t);
        }
        let of_mode = |(i, speed): (usize, &Speed)| match flight.mode(i).sigma {
            0.0 => 0.0,
            sigma => {
                let sum = speed.terms();
                2.0 * sigma * product(&sum, &sum, t)
            }
        };
        Some(self.0.iter().enumerate().map(of_mode).sum())
    }
}

/// The speed of mode `i` until the time `horizon` \[s\]: the steady motion under its load, and the free motion about it. `None` if its eigenvalues coincide.
fn speed(flight: &Flight<'_>, i: usize, horizon: f64) -> Option<Speed> {
    let (mode, driven) = (flight.mode(i), flight.driven());
    let slope = driven.map_or(0.0, |driven| driven.on_modes.slope[i]);
    let (v, a) = flight.rates_at_start(i);
    let mut speed = Speed::default();
    let mut add = |rate: Complex<f64>, power: usize, factor: Complex<f64>| {
        if factor != Complex::from(0.0) {
            speed.steady.push((Term { rate, power }, factor));
        }
    };
    let zero = Complex::from(0.0);
    // Steady speed and acceleration at the start, and the constant part of the load.
    let (mut steady, mut constant) = ((0.0, 0.0), flight.force[i]);
    let swings = driven.iter().flat_map(|driven| driven.on_modes.swings.iter().zip(&driven.frequencies));
    for (swing, w) in swings.map(|(swing, w)| (swing[i], w)) {
        let iw = Complex::new(0.0, *w);
        let of_speed = swing * iw / mode.stiffness_at(*w);
        add(iw, 0, of_speed * 0.5);
        add(-iw, 0, of_speed.conj() * 0.5);
        steady = (steady.0 + of_speed.re, steady.1 + (of_speed * iw).re);
        constant -= swing.re;
    }
    if mode.is_rigid() {
        add(zero, 0, (v - steady.0).into());
        add(zero, 1, constant.into());
        add(zero, 2, (0.5 * slope).into());
        return Some(speed);
    }
    let (v, a) = (v - steady.0, a - steady.1);
    if mode.rate * horizon <= SLOW_SPAN {
        // Its power series: the exponentials of slow eigenvalues cancel.
        let (mut y, mut next, mut size) = (v, a, 1.0);
        let mut reached = 1.0;
        for k in 0..SLOW_TERMS {
            add(zero, k, (y * size).into());
            size /= k as f64 + 1.0;
            reached *= mode.rate * horizon / (k as f64 + 1.0);
            // The first three terms have the speed, the acceleration and the slope of the load.
            if k > 2 && reached < SERIES_TERM {
                break;
            }
            (y, next) = (next, mode.next(y, next) + if k == 0 { slope } else { 0.0 });
        }
        return Some(speed);
    }
    let (drift, growth) = match mode.omega2 > 0.0 {
        true => (slope / mode.omega2, 0.0),
        false => ((constant - slope / (2.0 * mode.sigma)) / (2.0 * mode.sigma), slope / (2.0 * mode.sigma)),
    };
    add(zero, 0, drift.into());
    add(zero, 1, growth.into());
    let (v, a) = (v - drift, a - growth);
    let [first, second] = mode.eigenvalues()?;
    let factor = |own: Complex<f64>, other: Complex<f64>| (Complex::from(a) - other * v) / (own - other);
    let own = factor(first, second);
    let other = if first.im != 0.0 { own.conj() } else { factor(second, first) };
    speed.free = [(first, own), (second, other)];
    Some(speed)
}

/// The rate of entry `i` of a vector that varies.
pub fn rate_of(of: &Varying, driven: &Driven, i: usize) -> Sum {
    let mut sum: Sum = [(Term { rate: 0.0.into(), power: 0 }, of.slope[i].into())].into_iter().collect();
    for (swing, w) in of.swings.iter().zip(&driven.frequencies) {
        let (iw, half) = (Complex::new(0.0, *w), swing[i] * 0.5);
        sum.extend([(Term { rate: iw, power: 0 }, half * iw), (Term { rate: -iw, power: 0 }, (half * iw).conj())]);
    }
    sum
}

/// The derivative of a sum.
pub fn derivative(sum: &Sum) -> Sum {
    let of = |(term, factor): &(Term, Complex<f64>)| {
        let lower = (Term { power: term.power.saturating_sub(1), ..*term }, factor * term.power as f64);
        [(*term, factor * term.rate), lower]
    };
    sum.iter().flat_map(of).filter(|(_, factor)| *factor != Complex::from(0.0)).collect()
}

/// The value of a sum at the time `t`.
pub fn at(sum: &Sum, t: f64) -> f64 {
    sum.iter().map(|(term, factor)| (factor * (term.rate * t).exp()).re * t.powi(term.power as i32)).sum()
}

/// ∫ of the product of two sums over 0 to `t`.
pub fn product(a: &Sum, b: &Sum, t: f64) -> f64 {
    let mut sum = 0.0;
    for (x, by) in a {
        for (y, factor) in b {
            let power = x.power + y.power;
            sum += (by * factor * Moments::of(x.rate + y.rate, power + 1, t).0[power]).re;
        }
    }
    sum
}

/// ∫ sᵏ e^{nu s} ds over 0 to t, for k = 0, 1, ...
pub struct Moments(pub [Complex<f64>; 2 * SLOW_TERMS + 4]);

impl Moments {
    /// The first `count` of them, at least one, for nu = `rate`.
    pub fn of(rate: Complex<f64>, count: usize, t: f64) -> Self {
        let mut moments = [Complex::from(0.0); 2 * SLOW_TERMS + 4];
        let (x, last) = (rate * t, count - 1);
        if x == Complex::from(0.0) {
            let mut power = t;
            for (k, moment) in moments.iter_mut().enumerate().take(count) {
                *moment = (power / (k as f64 + 1.0)).into();
                power *= t;
            }
            return Moments(moments);
        }
        let (first, size) = (exp_m1(x), x.norm());
        let grown = first + 1.0;
        // Upwards, while the recurrence reduces errors: J_k = (t^k e^x - k J_(k-1))/nu.
        let turn = if size < SERIES_SPAN { 0 } else { count.min(size as usize + 1) };
        if turn > 0 {
            moments[0] = first / rate;
            let mut end = grown;
            for k in 1..turn {
                end *= t;
                moments[k] = (end - moments[k - 1] * k as f64) / rate;
            }
        }
        if turn == count {
            return Moments(moments);
        }
        // The last one by its series, t^(k+1) e^x times the sum of (-x)^n/((k+1) ... (k+n+1)), and those before it downwards.
        let (mut term, mut sum) = (Complex::from(1.0), Complex::from(0.0));
        for n in count.. {
            term /= n as f64;
            sum += term;
            if term.norm_sqr() <= SERIES_TERM * SERIES_TERM * sum.norm_sqr() {
                break;
            }
            term *= -x;
        }
        moments[last] = sum * grown * t.powi(count as i32);
        let mut end = grown * t.powi(last as i32);
        for k in (turn + 1..count).rev() {
            moments[k - 1] = (end - rate * moments[k]) / k as f64;
            end /= t;
        }
        Moments(moments)
    }
}

#[cfg(test)]
mod tests;
