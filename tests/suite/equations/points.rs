//! Random points: parameters and states of a gear pair, log-uniform over many decades, the same in every run.

use gearsim::__private::equations::{Derived, Equations};
use gearsim::__private::models::GearPair as Generated;
use gearsim::scene::Effects;
use gearsim_tests::oh2005::{GearPair, PITCH};

pub const POINTS: usize = 10_000;

pub const STIFFNESS_STEP: u64 = 1;
pub const RIGID_KINEMATICS: u64 = 2;
pub const FROZEN_PHASE: u64 = 4;
pub const DAMPING: u64 = 32;
pub const TORQUES: u64 = 64;

/// A gear pair and a state of it. `pair` always has damping and torque; `Point::pair` removes those that the effects exclude.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    pair: GearPair,
    pub theta: f64,
    pub theta_dot: f64,
    pub phi: f64,
    pub phi_dot: f64,
    /// Stiffness at this point [N m], one of the two levels.
    pub k: f64,
    /// Slope of the stiffness [N m/rad], or its step [N m].
    pub dk: f64,
}

impl Point {
    pub fn q(&self) -> [f64; 2] {
        [self.theta, self.phi]
    }

    pub fn q_dot(&self) -> [f64; 2] {
        [self.theta_dot, self.phi_dot]
    }

    /// The values of laws and switches: that of the stiffness, and NaN for those that exist only with other effects.
    pub fn values(&self) -> [f64; 9] {
        std::array::from_fn(|i| if i == 0 { self.k } else { f64::NAN })
    }

    /// The slopes of the laws.
    pub fn slopes(&self) -> [f64; 4] {
        [self.dk, f64::NAN, f64::NAN, f64::NAN]
    }

    /// The hand-written gear pair, with zeta and T0 zero where their effects are absent.
    pub fn pair(&self, effects: u64) -> GearPair {
        let keep = |effect, x| if effects & effect == 0 { 0.0 } else { x };
        GearPair { zeta: keep(DAMPING, self.pair.zeta), t0: keep(TORQUES, self.pair.t0), ..self.pair }
    }

    /// The generated equations with the same numbers.
    pub fn equations(&self, effects: u64) -> Box<dyn Equations> {
        let p = &self.pair;
        // NaN for the parameters of effects that no point has.
        let mut numbers = vec![f64::NAN; Generated::MODEL.parameters.len()];
        numbers[..8].copy_from_slice(&[p.n1, p.n2, p.i1, p.i2, p.zeta, p.t0, f64::NAN, 0.35]);
        let bits = (0..u64::BITS as usize).filter(|i| effects >> i & 1 == 1);
        Generated::equations(&Effects::numbered(&Generated::MODEL, bits), &numbers, &[p.k0()])
            .expect("these effects go together")
    }
}

/// splitmix64: a well-mixed random sequence, the same on every machine.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Log-uniform between two powers of ten.
    fn positive(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(low + (high - low) * self.unit())
    }

    fn either_sign(&mut self, low: f64, high: f64) -> f64 {
        let size = self.positive(low, high);
        if self.bits() & 1 == 0 { size } else { -size }
    }
}

/// The first `n` points.
pub fn points(n: usize) -> impl Iterator<Item = Point> {
    let mut r = Random(2005);
    (0..n).map(move |_| {
        let teeth = |r: &mut Random| r.positive(0.5, 3.0).round();
        let (n1, n2) = (teeth(&mut r), teeth(&mut r));
        let (i1, i2) = (r.positive(-8.0, 4.0), r.positive(-8.0, 4.0));
        let (k1, k2) = (r.positive(-2.0, 8.0), r.positive(-2.0, 8.0));
        let (zeta, t0) = (r.positive(-6.0, 1.0), r.either_sign(-6.0, 6.0));
        let width1 = PITCH * (0.1 + 0.8 * r.unit());
        let pair = GearPair { i1, i2, n1, n2, k1, k2, width1, zeta, t0 };
        let (k, dk) = if r.bits() & 1 == 0 { (k1, k2 - k1) } else { (k2, k1 - k2) };
        Point {
            pair,
            theta: r.either_sign(-6.0, 6.0),
            theta_dot: r.either_sign(-4.0, 6.0),
            phi: r.either_sign(-9.0, 1.0),
            phi_dot: r.either_sign(-6.0, 5.0),
            k,
            dk,
        }
    })
}
