//! The same motion in other units of mass and time. A unit of length would scale the inertias as a unit of mass does.
//!
//! If the units are scaled by powers of two, every number is scaled without rounding and the motion is the same bit by bit. The unit
//! of mass is scaled by a power of four, because mode shapes scale with the square root of the mass and sqrt(2) is rounded.

use proptest::prelude::*;

use crate::pair::Pair;
use crate::{COARSE, draw, tolerance};

/// The pair in units in which an inertia of 1 becomes `mass` and a time of 1 becomes `time`.
fn scaled(pair: &Pair, mass: f64, time: f64) -> Pair {
    let torque = mass / time / time;
    Pair {
        inertia: pair.inertia.map(|i| i * mass),
        zeta: pair.zeta,
        t0: pair.t0 * torque,
        steps: pair.steps.iter().map(|(k, width)| (k * torque, *width)).collect(),
        q: pair.q,
        q_dot: pair.q_dot.map(|v| v / time),
        span: pair.span * time,
    }
}

#[test]
fn units_scaled_by_powers_of_two_give_the_same_bits() {
    draw::check((draw::pair(draw::damping()), -20..20i32, -20..20i32), |(pair, mass, time)| {
        let (mass, time) = (4f64.powi(mass), 2f64.powi(time));
        let (a, b) = (pair.run(), scaled(&pair, mass, time).run());
        prop_assert_eq!(a.times.iter().map(|t| t * time).collect::<Vec<_>>(), b.times);
        prop_assert_eq!(a.state.q, b.state.q);
        prop_assert_eq!(a.state.q_dot, b.state.q_dot * time);
        prop_assert_eq!((a.cell, a.state.turns, a.counts), (b.cell, b.state.turns, b.counts));
        Ok(())
    });
}

#[test]
fn other_units_change_the_motion_only_by_rounding() {
    draw::check((draw::pair(draw::damping()), any::<bool>()), |(pair, by_mass)| {
        let (mass, time) = if by_mass { (3.7, 1.0) } else { (1.0, 3.7) };
        let a = pair.run();
        prop_assume!(a.stop.is_none());
        let tolerance = tolerance(&pair, a.times.len());
        prop_assume!(tolerance < COARSE);
        let mut b = scaled(&pair, mass, time).run();
        b.state.q_dot.iter_mut().for_each(|v| *v *= time);
        let difference = pair.difference(&a.state, &b.state);
        prop_assert!(difference < tolerance, "{difference:e}, not {tolerance:e}");
        prop_assert_eq!(a.times.len(), b.times.len());
        Ok(())
    });
}
