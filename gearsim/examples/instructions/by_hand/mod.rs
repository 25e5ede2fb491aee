//! Right-hand sides as one would write them by hand, a function a set of effects: what generated ones are held to.

pub mod pair;
pub mod trains;

/// What is compared with `Equations`, from the state, the law values and their slopes: accelerations of pairs, forces of trains,
/// whose masses are inverted in numbers.
pub trait ByHand<const N: usize> {
    fn evaluate(&self, q: &[f64; N], q_dot: &[f64; N], k: &[f64], dk: &[f64]) -> [f64; N];
}
