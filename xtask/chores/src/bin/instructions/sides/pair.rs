//! Right-hand sides of the gear pair of Oh, Grosh & Barber (2005), with various effects.

use gearsim::__private::equations::Derived;
use gearsim::__private::models::GearPair;
use gearsim::scene::Effects;

use super::{Side, derived};
use crate::by_hand::ByHand;
use crate::by_hand::pair::{Exact, Free, Pair, Rigid, Undamped, WithError, WithFriction, WithPlay};

/// Parameters: the pair of the paper with zeta = 0.1 and T0 = 10 N m.
const NUMBERS: [(&str, f64); 7] =
    [("N1", 24.0), ("N2", 96.0), ("I1", 2.89e-3), ("I2", 0.7402), ("zeta", 0.1), ("T0", 10.0), ("mu", 0.06)];
/// Mid mesh stiffness [N m/rad].
const MID: f64 = 2105.0;

fn numbers() -> Pair {
    let (first, second) = (24.0 * 24.0 / 2.89e-3, 96.0 * 96.0 / 0.7402);
    let (m1, m2): (f64, f64) = ((first - second) / 2.0, (first + second) / 2.0);
    Pair { m1, m2, c: 0.2 * (MID / m2).sqrt(), t0: 10.0 }
}

fn pair(effects: &str, by_hand: impl ByHand<2> + 'static) -> Side<2> {
    Side {
        generated: derived::<GearPair>(effects, &NUMBERS, &[MID]),
        by_hand: Box::new(by_hand),
        q: [0.1, 7e-3],
        q_dot: [1800.0, 0.3],
        // Values of the laws k, e, side, arm; then touch, edge, damp, clip of the dead band, and the direction of sliding.
        k: vec![1430.0, 1e-4, 0.3, 0.02, 1.0, 5e-4, 1.0, 0.0, 0.0],
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

/// The same from a model that does not declare damping, transmission errors, play and friction.
pub fn undeclared() -> Side<2> {
    let bare = crate::bare::BarePair::equations(
        &Effects::all(&crate::bare::BarePair::MODEL),
        &[24.0, 96.0, 2.89e-3, 0.7402, 10.0],
        &[MID],
    );
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
