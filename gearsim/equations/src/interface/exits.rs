//! Computes the exits of a mode and the gradients of deflections from short statements in the code of a model. So this code need not be
//! repeated in each model.

use super::{Affine, Deflection, Exit, no_such};
use crate::real::Real;

/// The quantity of which an addend of a guard is a multiple.
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

/// An exit as the code of a model states it: the mode that follows, whether it is sudden ([`Exit`]), and the addends of its guard. Each
/// addend has the index of its factor.
pub type Stated = (usize, bool, &'static [(On, usize)]);

/// The gradient of a linear form: its value for a unit displacement of each coordinate.
pub fn gradient<R: Real, const N: usize>(form: &dyn Fn(&[R; N]) -> R) -> [R; N] {
    let mut along = [R::from(0.0); N];
    std::array::from_fn(|j| {
        along[j] = R::from(1.0);
        let slope = form(&along);
        along[j] = R::from(0.0);
        slope
    })
}

/// The values of the symbols in a mode of a switch. `modes` has for each mode the indices of its values in `values`.
///
/// # Panics
/// If the switch has no such mode.
pub fn mode<R: Real>(modes: &[&[usize]], mode: usize, values: &[R]) -> Vec<R> {
    let places = modes.get(mode).unwrap_or_else(|| no_such("mode", mode));
    places.iter().map(|&place| values[place]).collect()
}

/// The exits of a mode of a switch, for a model with `n` coordinates and the named deflections `of`. `modes` has for each mode the exits
/// that the code of the model states; their factors are indices in `factors`.
///
/// # Panics
/// If the switch has no such mode.
pub fn exits<R: Real>(
    n: usize,
    modes: &[&[Stated]],
    mode: usize,
    factors: &[R],
    of: &dyn Fn(usize) -> Deflection<R>,
) -> Vec<Exit<R>> {
    let exit = |&(beyond, sudden, addends): &Stated| {
        let mut guard = Affine::zero(n);
        for &(on, place) in addends {
            let factor = factors[place];
            match on {
                On::One => guard.add_constant(factor),
                On::Deflection(i) => guard.add(factor, &of(i)),
                On::Rate(i) => guard.add_rate(factor, &of(i)),
                On::Reaction => guard.on_reaction += factor,
            }
        }
        Exit { beyond, sudden, guard }
    };
    modes.get(mode).unwrap_or_else(|| no_such("mode", mode)).iter().map(exit).collect()
}
