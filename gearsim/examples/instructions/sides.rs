//! Right-hand sides at a state, generated and by hand.

use gearsim::engine::equations::{Derived, Equations, product};
use gearsim::generated::{chain_5::Chain5, gear_pair::GearPair, idler::Idler, planetary_3::Planetary3};
use gearsim::model::Model;

use crate::by_hand::pair::{Exact, Free, Pair, Rigid, Undamped, WithError, WithFriction, WithPlay};
use crate::by_hand::{ByHand, trains};
use crate::paths::Job;

/// The same right-hand side twice.
pub struct Side<const N: usize> {
    pub generated: Box<dyn Equations<N>>,
    pub by_hand: Box<dyn ByHand<N>>,
    q: [f64; N],
    q_dot: [f64; N],
    k: Vec<f64>,
    dk: Vec<f64>,
}

/// Evaluations that are counted.
const EVALUATIONS: u64 = 10_000;

impl<const N: usize> Side<N> {
    /// The generated one.
    pub fn generated(self) -> Job {
        self.demand_agreement();
        let Side { generated, q, q_dot, k, dk, .. } = self;
        // As the table compares them: accelerations of pairs, forces of trains, whose masses are inverted in numbers.
        let mobility = generated.mobility();
        match N {
            2 => evaluated(q, q_dot, k, dk, move |q, v, k, dk| product(&mobility, &generated.force(q, v, k, dk))),
            _ => evaluated(q, q_dot, k, dk, move |q, v, k, dk| generated.force(q, v, k, dk)),
        }
    }

    /// The one by hand, behind a pointer as the generated one is.
    pub fn by_hand(self) -> Job {
        self.demand_agreement();
        let Side { by_hand, q, q_dot, k, dk, .. } = self;
        evaluated(q, q_dot, k, dk, move |q, v, k, dk| by_hand.evaluate(q, v, k, dk))
    }

    fn demand_agreement(&self) {
        let Side { q, q_dot, k, dk, .. } = self;
        let by_hand = self.by_hand.evaluate(q, q_dot, k, dk);
        let generated = match N {
            2 => self.generated.acceleration(q, q_dot, k, dk),
            _ => self.generated.force(q, q_dot, k, dk),
        };
        let largest = by_hand.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        let apart = by_hand.iter().zip(generated).fold(0.0f64, |apart, (a, b)| apart.max((a - b).abs()));
        assert!(apart <= 1e-12 * largest, "by hand {by_hand:?}, generated {generated:?}");
    }
}

fn evaluated<const N: usize>(
    mut q: [f64; N],
    mut q_dot: [f64; N],
    k: Vec<f64>,
    dk: Vec<f64>,
    f: impl Fn(&[f64; N], &[f64; N], &[f64], &[f64]) -> [f64; N] + 'static,
) -> Job {
    Box::new(move || {
        let (k, dk) = (std::hint::black_box(&k), std::hint::black_box(&dk));
        for _ in 0..EVALUATIONS {
            let a = f(&q, &q_dot, k, dk);
            (q[1], q_dot[1]) = (q[1] + 1e-12 * a[0], q_dot[1] + 1e-12 * a[1]);
        }
        std::hint::black_box((q, q_dot));
        EVALUATIONS
    })
}

/// The generated equations with some effects, parameters by name.
fn derived<D: Derived<N>, const N: usize>(
    effects: &str,
    numbers: &[(&str, f64)],
    mids: &[f64],
) -> Box<dyn Equations<N>> {
    let model: &Model = &D::MODEL;
    let bit = |name: &str| model.effects.iter().position(|e| e.name == name).unwrap_or_else(|| panic!("no {name}"));
    let parameters = model.parameters.iter().map(|p| {
        let given = numbers.iter().find(|(name, _)| *name == p.name).map(|(_, x)| *x);
        given.or(p.default).unwrap_or(1.0)
    });
    let parameters: Vec<f64> = parameters.collect();
    let effects = effects.split_whitespace().fold(0, |set, name| set | 1 << bit(name));
    D::equations(effects, &parameters, mids).expect("effects that go together")
}

/// The pair of the paper, zeta 0.1, 10 N m.
const NUMBERS: [(&str, f64); 7] =
    [("N1", 24.0), ("N2", 96.0), ("I1", 2.89e-3), ("I2", 0.7402), ("zeta", 0.1), ("T0", 10.0), ("mu", 0.06)];
const MID: f64 = 2105.0;

fn numbers() -> Pair {
    let (first, second) = (24.0 * 24.0 / 2.89e-3, 96.0 * 96.0 / 0.7402);
    let (m1, m2): (f64, f64) = ((first - second) / 2.0, (first + second) / 2.0);
    Pair { m1, m2, c: 0.2 * (MID / m2).sqrt(), t0: 10.0 }
}

fn pair(effects: &str, by_hand: impl ByHand<2> + 'static) -> Side<2> {
    Side {
        generated: derived::<GearPair, 2>(effects, &NUMBERS, &[MID]),
        by_hand: Box::new(by_hand),
        q: [0.1, 7e-3],
        q_dot: [1800.0, 0.3],
        // k, e, side, arm; touch, edge, damp, clip.
        k: vec![1430.0, 1e-4, 0.3, 0.02, 1.0, 5e-4, 1.0, 0.0],
        dk: vec![7.0, 1e-5, 0.0, 0.0],
    }
}

pub fn exact() -> Side<2> {
    pair("stiffness_step damping torques", Exact(numbers()))
}

pub fn rigid() -> Side<2> {
    pair("stiffness_step rigid_kinematics damping torques", Rigid(numbers()))
}

pub fn free() -> Side<2> {
    pair("", Free(numbers()))
}

pub fn undamped() -> Side<2> {
    pair("stiffness_step torques", Undamped(numbers()))
}

/// The same, of a model that never declared damping, errors, play and friction.
pub fn undeclared() -> Side<2> {
    let bare = crate::bare::BarePair::equations(0b11, &[24.0, 96.0, 2.89e-3, 0.7402, 10.0], &[MID]);
    Side { generated: bare.expect("effects that go together"), ..undamped() }
}

pub fn with_error() -> Side<2> {
    pair("stiffness_step transmission_error torques", WithError(numbers()))
}

pub fn with_play() -> Side<2> {
    pair("stiffness_step backlash damping torques", WithPlay(numbers()))
}

pub fn with_friction() -> Side<2> {
    let (mu, mixed, tangent) = (0.06, 0.1, 20f64.to_radians().tan());
    let (n1, n2) = (1.0 / 24.0 - 1.0 / 96.0, 1.0 / 24.0 + 1.0 / 96.0);
    let by_hand = WithFriction { pair: numbers(), mu, mixed, tangent, n1, n2 };
    pair("stiffness_step sliding_friction torques", by_hand)
}

pub fn chain() -> Side<5> {
    let (alpha, beta, k) = (3.0, 1e-4, [1e3, 2e3, 3e3, 4e3]);
    let names = ["k1", "k2", "k3", "k4"];
    let mut numbers = vec![("alpha_M", alpha), ("beta_K", beta), ("T_motor", 5.0), ("T_load", 4.0)];
    numbers.extend(names.into_iter().zip(k));
    let by_hand = trains::Chain { k, c: k.map(|k| beta * k), drag: [alpha; 5], motor: 5.0, load: 4.0 };
    Side {
        generated: derived::<Chain5, 5>("torques damping", &numbers, &[]),
        by_hand: Box::new(by_hand),
        q: [0.1, 0.09, 0.07, 0.06, 0.05],
        q_dot: [10.0, 9.0, 11.0, 10.5, 9.5],
        k: vec![],
        dk: vec![],
    }
}

pub fn idler() -> Side<3> {
    let (n1, n2, n3, r2, i, alpha, beta) = (28.0, 35.0, 56.0, 0.0411, [4e-3, 1.5e-3, 1.2e-2], 3.0, 1e-6);
    let numbers = [
        ("N1", n1),
        ("N2", n2),
        ("N3", n3),
        ("r2", r2),
        ("I1", i[0]),
        ("I2", i[1]),
        ("I3", i[2]),
        ("T_motor", 50.0),
        ("T_load", 100.0),
        ("alpha_M", alpha),
        ("beta_K", beta),
    ];
    let (h, mids) = (r2 / n2, [2.35e8, 2.5e8]);
    let [a, b, c] = [i[0] / (n1 * n1), i[1] / (n2 * n2), i[2] / (n3 * n3)].map(|i| alpha * i);
    let across = [beta * mids[0] + a / (h * h), beta * mids[1] + c / (h * h)];
    let by_hand = trains::Idler {
        c: [a + b + c, a / h, -c / h, across[0], across[1]],
        torque: [50.0 / n1 - 100.0 / n3, 50.0 / (h * n1), 100.0 / (h * n3)],
    };
    Side {
        generated: derived::<Idler, 3>("stiffness_step torques damping", &numbers, &mids),
        by_hand: Box::new(by_hand),
        q: [0.1, 7e-6, 6e-6],
        q_dot: [1800.0, 3e-3, 2e-3],
        k: vec![1.8e8, 3.1e8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        dk: vec![1e6, 2e6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    }
}

pub fn planetary() -> Side<6> {
    let (z_s, z_r, r_s, k_r) = (30.0, 90.0, 0.04, 1e8);
    let numbers = [("Z_s", z_s), ("Z_r", z_r), ("r_s", r_s), ("k_r", k_r), ("T_motor", 300.0), ("T_load", 1200.0)];
    let by_hand = trains::Planetary {
        r_r: r_s / z_s * z_r,
        k_r,
        torque: [300.0 * (1.0 / z_s + 1.0 / z_r) - 1200.0 / z_r, 300.0 - 1200.0],
    };
    Side {
        generated: derived::<Planetary3, 6>("stiffness_step torques", &numbers, &[4e8; 6]),
        by_hand: Box::new(by_hand),
        q: [0.1, 2e-5, 1e-5, 7e-6, 6e-6, 5e-6],
        q_dot: [1800.0, 3e-3, 2e-3, 1e-3, 2e-3, 3e-3],
        k: vec![3.5e8, 6e8, 3.6e8, 5e8, 4e8, 4.5e8],
        dk: vec![1e6, 2e6, 3e6, 4e6, 5e6, 6e6],
    }
}
