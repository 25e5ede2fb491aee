//! Right-hand sides written by hand, a function for each set of effects, with which the generated ones are compared.

pub mod pair;
pub mod trains;

/// A right-hand side from the state, the values of the laws and their slopes. It gives the accelerations of a gear pair, but the forces of
/// a train, whose mass matrix is inverted numerically.
pub trait ByHand<const N: usize> {
    fn evaluate(&self, q: &[f64; N], q_dot: &[f64; N], k: &[f64], dk: &[f64]) -> [f64; N];
}
