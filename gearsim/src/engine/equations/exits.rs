//! The exits of a mode and the gradients of deflections, from what the code of a model states of them. The sums are written here, not in the code
//! of each model.

use super::{Affine, Deflection, Exit};
use crate::engine::real::Real;

/// What an addend of a guard is a multiple of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum On {
    /// One.
    One,
    /// The named deflection with this index.
    Deflection(usize),
    /// The rate of the named deflection with this index.
    Rate(usize),
    /// The reaction of a held deflection.
    Reaction,
}

/// An exit as the code of a model states it: the mode that follows, whether it is sudden ([`Exit`]), and the addends of its guard.
pub type Stated<'a, R> = (usize, bool, &'a [(On, R)]);

/// The gradient of a linear form: its values along each coordinate.
pub fn gradient<R: Real, const N: usize>(form: &dyn Fn(&[R; N]) -> R) -> [R; N] {
    let mut along = [R::from(0.0); N];
    std::array::from_fn(|j| {
        along[j] = R::from(1.0);
        let slope = form(&along);
        along[j] = R::from(0.0);
        slope
    })
}

/// The exits of a mode of a model with `n` coordinates and the named deflections `of`.
pub fn exits<R: Real>(n: usize, stated: &[Stated<'_, R>], of: &dyn Fn(usize) -> Deflection<R>) -> Vec<Exit<R>> {
    let exit = |&(beyond, sudden, addends): &Stated<'_, R>| {
        let mut guard = Affine::zero(n);
        for &(on, factor) in addends {
            match on {
                On::One => guard.constant += factor,
                On::Deflection(i) => guard.add(factor, &of(i)),
                On::Rate(i) => guard.add_rate(factor, &of(i)),
                On::Reaction => guard.on_reaction += factor,
            }
        }
        Exit { beyond, sudden, guard }
    };
    stated.iter().map(exit).collect()
}
