//! A derived model, and its linear cells in other types of numbers.

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use super::{Deflection, Equations, Exit, no_such};
use crate::effects::Effects;
use crate::model::Model;
use crate::real::Real;

/// A derived model: its description, and its equations for any set of effects.
pub trait Derived: Sync {
    /// The description of the model.
    const MODEL: Model;

    /// The equations with these effects, the parameter values [SI, order of `MODEL.parameters`] and the mid value (max + min)/2 of each
    /// stiffness; `None` if the effects contradict one another.
    fn equations(effects: &Effects, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>>;

    /// The matrices of a cell with law values `k`, in numbers of type R. The other arguments are those of [`Derived::equations`].
    fn matrices<R: Real>(effects: &Effects, parameters: &[R], mids: &[R], k: &[R]) -> Matrices<R>;

    /// The linear cells in double-double precision. The arguments are those of [`Derived::equations`].
    fn exactly(effects: &Effects, parameters: &[Df64], mids: &[Df64]) -> Box<dyn ExactCells>;
}

/// A linear cell, M q'' + C q' + K q = f, in numbers of type R.
#[derive(Debug, Clone)]
pub struct Matrices<R> {
    /// M (n x n), which is constant in a linear cell.
    pub mass: DMatrix<R>,
    /// M⁻¹ (n x n), if a closed form is known.
    pub mobility: Option<DMatrix<R>>,
    /// C (n x n).
    pub damping: DMatrix<R>,
    /// K (n x n).
    pub stiffness: DMatrix<R>,
    /// f (n).
    pub load: DVector<R>,
    /// V where all coordinates are zero.
    pub at_zero: R,
}

/// [`Derived::equations`] of a model.
type EquationsOf = fn(&Effects, &[f64], &[f64]) -> Option<Box<dyn Equations>>;

/// [`Derived::exactly`] of a model.
type ExactlyOf = fn(&Effects, &[Df64], &[Df64]) -> Box<dyn ExactCells>;

/// The functions of a derived model as values. The engine is compiled once and calls the functions of each model by pointer.
#[derive(Debug, Clone, Copy)]
pub struct Functions {
    /// [`Derived::equations`].
    pub equations: EquationsOf,
    /// [`Derived::exactly`].
    pub exactly: ExactlyOf,
}

impl Functions {
    /// The functions of model `D`.
    pub const fn of<D: Derived>() -> Functions {
        Functions { equations: D::equations, exactly: D::exactly }
    }
}

/// The linear cells of a scene in double-double precision; `k` are the values of laws and switches.
pub trait ExactCells {
    /// The matrices of a cell.
    fn matrices(&self, k: &[Df64]) -> Matrices<Df64>;
    /// [`Equations::potential`].
    fn potential(&self, q: &[Df64], k: &[Df64]) -> Df64;
    /// [`Equations::step`].
    fn step(&self, law: usize, q: &[Df64], k: &[Df64], dk: Df64) -> Df64;
    /// [`Equations::mode`].
    fn mode(&self, i: usize, _mode: usize) -> Option<Vec<Df64>> {
        no_such("switch", i)
    }
    /// [`Equations::exits`].
    fn exits(&self, i: usize, _mode: usize, _k: &[Df64]) -> Vec<Exit<Df64>> {
        no_such("switch", i)
    }
    /// The deflection of switch `i`.
    fn switched(&self, i: usize, _k: &[Df64]) -> Deflection<Df64> {
        no_such("switch", i)
    }
}
