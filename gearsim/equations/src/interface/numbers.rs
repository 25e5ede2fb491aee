//! Conversion of matrices, deflections and exits from one type of numbers to another.

use nalgebra::DMatrix;

use super::{Affine, Deflection, Exit, Matrices};
use crate::real::Real;

/// The numbers in type S.
pub fn numbers<R: Real, S: Real + From<R>>(of: &[R]) -> Vec<S> {
    of.iter().map(|&x| x.into()).collect()
}

fn row<R: Real, S: Real + From<R>>(of: &R::Row) -> S::Row {
    S::row(&numbers(of.as_ref()))
}

impl<R: Real> Matrices<R> {
    /// The same matrices in numbers of type S.
    pub fn in_numbers<S: Real + From<R>>(&self) -> Matrices<S> {
        let square = |m: &DMatrix<R>| m.map(S::from);
        Matrices {
            mass: square(&self.mass),
            mobility: self.mobility.as_ref().map(square),
            damping: square(&self.damping),
            stiffness: square(&self.stiffness),
            load: self.load.map(S::from),
            at_zero: self.at_zero.into(),
        }
    }
}

impl<R: Real> Deflection<R> {
    /// Itself in numbers of type S.
    pub fn in_numbers<S: Real + From<R>>(&self) -> Deflection<S> {
        let errors = self.errors.iter().map(|&(law, unit)| (law, unit.into())).collect();
        Deflection { normal: row::<R, S>(&self.normal), constant: self.constant.into(), errors }
    }
}

impl<R: Real> Exit<R> {
    /// Itself in numbers of type S.
    pub fn in_numbers<S: Real + From<R>>(&self) -> Exit<S> {
        let Affine { constant, size, errors, on_q, on_speed, on_reaction } = &self.guard;
        let guard = Affine {
            constant: (*constant).into(),
            size: (*size).into(),
            errors: errors.iter().map(|&(law, unit)| (law, unit.into())).collect(),
            on_q: row::<R, S>(on_q),
            on_speed: row::<R, S>(on_speed),
            on_reaction: (*on_reaction).into(),
        };
        Exit { beyond: self.beyond, sudden: self.sudden, guard }
    }
}
