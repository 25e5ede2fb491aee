//! The closed form of one mode and of a sum of modes, for any damping and stiffness.
//!
//! ```text
//! xi'' + 2 sigma xi' + omega2 xi = g
//! xi = x + v E1(t) + (g - omega2 x) E2(t),   E1(0) = 0, E1'(0) = 1, E1'' + 2 sigma E1' + omega2 E1 = 0,   E2 = int E1
//! ```
//!
//! sigma \[1/s\] >= 0, omega2 \[1/s^2\] >= 0, g in units of xi per s^2. E1 is the response to an impulse, E2 the response to a
//! step. Both are entire functions of sigma and omega2, so there is no singularity at critical damping or zero stiffness. Only
//! the formulas that avoid cancellation differ from case to case.

use super::number::Scalar;

/// One mode, its state at t = 0 and its factor in the surface function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// damping sigma \[1/s\]
    pub sigma: f64,
    /// stiffness omega^2 \[1/s^2\]
    pub omega2: f64,
    /// constant modal force g
    pub force: f64,
    /// xi at t = 0
    pub x: f64,
    /// xi' at t = 0
    pub v: f64,
    /// factor in the surface function
    pub weight: f64,
}

/// xi'' + 2 sigma xi' + omega2 xi, with the constants of its responses, computed once.
#[derive(Debug, Clone)]
pub struct Law<T> {
    pub(super) sigma: T,
    pub(super) omega2: T,
    /// sigma^2 - omega2
    excess: T,
    /// sqrt |sigma^2 - omega2|
    rate: T,
}

/// E1', E1 and E2 at one time.
#[derive(Debug, Clone)]
pub struct Response<T> {
    pub(super) rate: T,
    pub(super) impulse: T,
    pub(super) step: T,
}

impl<T: Scalar> Law<T> {
    /// Panics unless sigma and omega2 are at least 0.
    pub fn new(sigma: T, omega2: T) -> Self {
        let zero = T::exact(0.0);
        assert!(sigma >= zero && omega2 >= zero, "damping and stiffness must not be negative");
        let excess = sigma.clone() * sigma.clone() - omega2.clone();
        let rate = if excess < zero { -excess.clone() } else { excess.clone() }.root();
        Self { sigma, omega2, excess, rate }
    }

    /// The responses at time `t` \[s\].
    pub fn response(&self, t: &T) -> Response<T> {
        if self.sigma.approx() == 0.0 && self.omega2.approx() == 0.0 || t.approx() == 0.0 {
            let step = (t.clone() * t.clone()).scaled(-1);
            return Response { rate: T::exact(1.0), impulse: t.clone(), step };
        }
        let (damping, stiffness) = (self.sigma.clone() * t.clone(), self.omega2.clone() * t.clone() * t.clone());
        if 2.0 * damping.approx() + stiffness.approx() <= 0.5 {
            return series(t, &damping.scaled(1), &stiffness);
        }
        let excess = self.excess.clone() * t.clone() * t.clone();
        match excess.approx() {
            z if z.abs() < 1.0 / 64.0 => self.near_critical(t, &damping, &excess),
            z if z < 0.0 => self.underdamped(t, &damping),
            _ => self.overdamped(t),
        }
    }

    fn near_critical(&self, t: &T, damping: &T, z: &T) -> Response<T> {
        // c = cosh(sqrt(z)), s = sinh(sqrt(z))/sqrt(z); for z < 0 these are cos and sin
        let one = T::exact(1.0);
        let (mut c, mut s, mut term, mut n) = (one.clone(), one.clone(), one.clone(), 1);
        while term.approx().abs() > T::NEGLIGIBLE && n < 200 {
            // z^k/(2k)! for c, over (2k + 1) for s
            term = (term * z.clone()).over(n * (n + 1));
            c = c + term.clone();
            s = s + term.over(n + 2);
            n += 2;
        }
        self.oscillation(damping, c, s * t.clone())
    }

    fn underdamped(&self, t: &T, damping: &T) -> Response<T> {
        let (sin, cos) = (self.rate.clone() * t.clone()).sine_cosine();
        self.oscillation(damping, cos, sin / self.rate.clone())
    }

    /// The responses from c and s, where E1 = e^{-sigma t} s and E1' = e^{-sigma t} (c - sigma s).
    fn oscillation(&self, damping: &T, c: T, s: T) -> Response<T> {
        let decay = (-damping.clone()).exponential();
        let damped = self.sigma.clone() * s.clone();
        let rest = decay.clone() * (c.clone() + damped.clone());
        let step = (T::exact(1.0) - rest) / self.omega2.clone();
        Response { rate: decay.clone() * (c - damped), impulse: decay * s, step }
    }

    fn overdamped(&self, t: &T) -> Response<T> {
        // the slow rate as a quotient, because sigma - sqrt(sigma^2 - omega2) would cancel
        let fast = self.sigma.clone() + self.rate.clone();
        let slow = self.omega2.clone() / fast.clone();
        let apart = self.rate.scaled(1);
        let [late, early] = [&slow, &fast].map(|rate| (-(rate.clone() * t.clone())).exponential());
        let rate = (fast.clone() * early.clone() - slow.clone() * late.clone()) / apart.clone();
        let impulse = (late.clone() - early.clone()) / apart.clone();
        // int_0^t e^{-rate s} ds for either rate
        let short = slow.clone() * t.clone();
        let lasting =
            if short.approx() < 0.125 { mean_decay(&short) * t.clone() } else { (T::exact(1.0) - late) / slow };
        let passing = (T::exact(1.0) - early) / fast;
        Response { rate, impulse, step: (lasting - passing) / apart }
    }
}

/// (1 - e^{-x})/x for small x, by its series.
fn mean_decay<T: Scalar>(x: &T) -> T {
    let (mut sum, mut term, mut n) = (T::exact(1.0), T::exact(1.0), 2);
    while term.approx().abs() > T::NEGLIGIBLE && n < 200 {
        term = -(term * x.clone()).over(n);
        sum = sum + term.clone();
        n += 1;
    }
    sum
}

/// The responses as power series in t, for 2 sigma t + omega2 t^2 <= 1/2.
fn series<T: Scalar>(t: &T, damping: &T, stiffness: &T) -> Response<T> {
    // E1' = sum d_n with d_(n+2) (n+1)(n+2) = -(2 sigma t (n+1) d_(n+1) + omega2 t^2 d_n), integrated term by term
    let one = T::exact(1.0);
    let (mut last, mut term) = (one.clone(), -damping.clone());
    let (mut rate, mut impulse, mut step) =
        (one.clone() + term.clone(), one.clone() + term.over(2), one.over(2) + term.over(6));
    for n in 0..250 {
        let next = -((damping.clone() * term.clone()).over(n + 2) + (stiffness.clone() * last).over((n + 1) * (n + 2)));
        (last, term) = (term, next);
        if last.approx().abs().max(term.approx().abs()) <= T::NEGLIGIBLE {
            break;
        }
        rate = rate + term.clone();
        impulse = impulse + term.over(n + 3);
        step = step + term.over((n + 3) * (n + 4));
    }
    Response { rate, impulse: impulse * t.clone(), step: step * t.clone() * t.clone() }
}

/// A mode prepared for evaluation.
#[derive(Debug, Clone)]
pub struct Motion<T> {
    pub(super) law: Law<T>,
    pub(super) force: T,
    pub(super) x: T,
    pub(super) v: T,
    pub(super) weight: T,
    /// g - omega2 x
    pub(super) push: T,
}

impl<T: Scalar> Motion<T> {
    /// A mode from state (x, v) under the force g.
    pub fn new(law: Law<T>, force: T, x: T, v: T, weight: T) -> Self {
        let push = force.clone() - law.omega2.clone() * x.clone();
        Self { law, force, x, v, weight, push }
    }

    /// xi and xi' at time `t` \[s\].
    pub fn state(&self, t: &T) -> (T, T) {
        let Response { rate, impulse, step } = self.law.response(t);
        let x = self.x.clone() + (self.v.clone() * impulse.clone() + self.push.clone() * step);
        (x, self.v.clone() * rate + self.push.clone() * impulse)
    }

    /// The same motion with its time counted from `t` \[s\].
    pub(super) fn moved(&self, t: &T) -> Self {
        let (x, v) = self.state(t);
        Self::new(self.law.clone(), self.force.clone(), x, v, self.weight.clone())
    }

    /// xi, xi', xi'' at time `t` \[s\].
    pub fn at(&self, t: &T) -> [T; 3] {
        let (x, v) = self.state(t);
        let damped = (self.law.sigma.clone() * v.clone()).scaled(1);
        let a = self.force.clone() - damped - self.law.omega2.clone() * x.clone();
        [x, v, a]
    }
}

impl From<&Mode> for Motion<f64> {
    fn from(m: &Mode) -> Self {
        Self::new(Law::new(m.sigma, m.omega2), m.force, m.x, m.v, m.weight)
    }
}

impl<T: Scalar> Motion<T> {
    /// The same motion in `f64`.
    pub(super) fn rounded(&self) -> Motion<f64> {
        // sigma^2 - omega2 is rounded once; a difference of rounded numbers would lose digits
        let [sigma, omega2, excess, rate] =
            [&self.law.sigma, &self.law.omega2, &self.law.excess, &self.law.rate].map(T::approx);
        let law = Law { sigma, omega2, excess, rate };
        let [force, x, v, weight] = [&self.force, &self.x, &self.v, &self.weight].map(T::approx);
        let rounded = Motion::new(law, force, x, v, weight);
        Motion { push: self.push.approx(), ..rounded }
    }
}
