//! A solver by steps that carries small disturbances along: Phi' = A(t) Phi, with A = [[0, 1], [dq''/dq, dq''/dq']] along the motion.
//!
//! Within a step A follows the dense output of the motion, and Phi advances by the Magnus expansion ([`super::super::magnus`]). At
//! an event Phi is multiplied by the saltation matrix ([`super::saltation`]).

use std::cell::RefCell;
use std::rc::Rc;

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use super::super::magnus;
use super::saltation::Event;
use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::error::{Refusal, Stop};
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::{Effort, End, Guard, Motion, Reached, Solver};
use crate::engine::record::State;
use crate::engine::vector::Vector;
use crate::methods::field::Field;
use crate::methods::flow::Flow;
use crate::methods::steps::BySteps;
use crate::tolerance::analysis::MAGNUS_STEPS;

/// The disturbances that a solver carries along.
#[derive(Debug)]
pub struct Carried {
    /// Phi (2n x 2n) in the units below.
    pub phi: DMatrix<f64>,
    /// Units of a disturbance (2n) \[SI\]. A unit of speed has the kinetic energy 1/2; a unit of a coordinate is that unit of speed over
    /// the fastest rate.
    pub units: DVector<f64>,
    /// Why there is no result, in words.
    pub trouble: Option<&'static str>,
    /// The event at which the last motion ended.
    event: Option<Event>,
}

impl Carried {
    /// Phi = 1, at the start `now` of a run.
    pub fn new(now: &Hybrid<'_>, rate: f64) -> Rc<RefCell<Self>> {
        let mass = now.equations.mass(&now.state.q);
        let n = mass.nrows();
        let unit = |i: usize| 1.0 / mass[(i % n, i % n)].sqrt() * if i < n { 1.0 / rate } else { 1.0 };
        let (phi, units) = (DMatrix::identity(2 * n, 2 * n), DVector::from_fn(2 * n, |i, _| unit(i)));
        Rc::new(RefCell::new(Carried { phi, units, trouble: None, event: None }))
    }

    /// A matrix that acts on disturbances, in the units of disturbances.
    fn scaled(&self, a: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| a[(i, j)] * self.units[j] / self.units[i])
    }
}

/// A solver that advances Phi along the motions of `inner`.
pub struct Variational<'a> {
    inner: BySteps<'a>,
    field: Field<'a>,
    carried: Rc<RefCell<Carried>>,
    /// The laws of friction among the laws of the model.
    frictions: Vec<usize>,
    /// Error of a step of the propagator [1].
    error: f64,
}

impl<'a> Variational<'a> {
    /// The solver of a run that begins with `now`, around `inner`. `error` is that of a step of the propagator [1].
    pub fn new(
        now: &Hybrid<'a>,
        inner: BySteps<'a>,
        carried: Rc<RefCell<Carried>>,
        frictions: Vec<usize>,
        error: f64,
    ) -> Self {
        Variational { inner, field: Field::new(now), carried, frictions, error }
    }
}

impl Solver for Variational<'_> {
    fn enter(&mut self, now: &mut Hybrid<'_>) -> Result<(), Refusal> {
        self.inner.enter(now)?;
        self.field.enter(now);
        self.field.begins = now.clock.now();
        let carried = &mut *self.carried.borrow_mut();
        if now.contact.is_some() {
            carried.trouble = carried.trouble.or(Some("a phase or a deflection is held"));
        }
        if let Some(event) = carried.event.take() {
            let y = Flow { q: now.state.q.clone(), v: now.state.q_dot.clone(), lost: 0.0 };
            let acceleration = self.field.rate(0.0, &y).v;
            match event.saltation(now, self.field.laws_at().1, &acceleration, &self.frictions) {
                Ok(saltation) => carried.phi = carried.scaled(&saltation) * &carried.phi,
                Err(trouble) => carried.trouble = carried.trouble.or(Some(trouble)),
            }
        }
        Ok(())
    }

    fn solve<'s>(&'s mut self, now: &'s Hybrid<'_>, horizon: f64) -> Result<Box<dyn Motion + 's>, Stop> {
        self.field.begins = now.clock.now();
        let (inner, carried) = (self.inner.solve(now, horizon)?, self.carried.clone());
        Ok(Box::new(Carrier { inner, now, field: &mut self.field, carried, error: self.error }))
    }

    fn rate(&self) -> f64 {
        self.inner.rate()
    }

    fn effort(&self) -> Effort {
        self.inner.effort()
    }
}

/// A motion that carries disturbances along.
struct Carrier<'s, 'a, 'f> {
    inner: Box<dyn Motion + 's>,
    now: &'s Hybrid<'a>,
    field: &'s mut Field<'f>,
    carried: Rc<RefCell<Carried>>,
    error: f64,
}

impl Carrier<'_, '_, '_> {
    /// A in the units of disturbances, the time `t` after the motion began.
    fn generator(&mut self, t: f64) -> DMatrix<f64> {
        let State { q, q_dot, .. } = self.inner.at(t).state;
        let n = q.len();
        let [by_q, by_v] = self.field.jacobian(t, &Flow { q, v: q_dot, lost: 0.0 });
        let mut a = DMatrix::zeros(2 * n, 2 * n);
        a.view_mut((0, n), (n, n)).fill_diagonal(1.0);
        a.view_mut((n, 0), (n, n)).copy_from(&by_q);
        a.view_mut((n, n), (n, n)).copy_from(&by_v);
        self.carried.borrow().scaled(&a)
    }

    /// Advances Phi by the time `t`.
    fn carry(&mut self, t: f64) {
        if t <= 0.0 {
            return;
        }
        let (first, last) = (self.generator(0.0), self.generator(t));
        let (size, change) = (t * first.norm().max(last.norm()), t * (&last - &first).norm());
        // The error of one step is about (h |A|)^5 h |dA|/1e5, and of m steps m⁻⁶ of that.
        let steps = (size.powi(5) * change / 1e5 / self.error).powf(1.0 / 6.0).ceil().clamp(1.0, MAGNUS_STEPS);
        let h = t / steps;
        for step in 0..steps as usize {
            let at = magnus::instants(step as f64 * h, h).map(|t| self.generator(t));
            magnus::advance(&at, h, &mut self.carried.borrow_mut().phi);
        }
    }
}

impl Motion for Carrier<'_, '_, '_> {
    fn length(&self) -> f64 {
        self.inner.length()
    }

    fn first(&mut self, guard: Guard, until: f64, cost: &mut Cost) -> Result<Option<(f64, Side)>, SearchError> {
        self.inner.first(guard, until, cost)
    }

    fn at(&mut self, t: f64) -> Reached {
        self.inner.at(t)
    }

    fn arrive(&mut self, t: f64, end: End, cost: &mut Cost) -> (Df64, Reached) {
        let (taken, reached) = self.inner.arrive(t, end, cost);
        self.carry(taken.hi().min(self.inner.length()));
        let y = Flow { q: reached.state.q.clone(), v: reached.state.q_dot.clone(), lost: 0.0 };
        let acceleration: Vector = self.field.rate(taken.hi(), &y).v;
        let (values, slopes) = self.field.laws_at();
        let (values, slopes) = (values.to_vec(), slopes.to_vec());
        let carried = &mut *self.carried.borrow_mut();
        match Event::at(self.now, end, [y.q, y.v, acceleration], [values, slopes]) {
            Ok(event) => carried.event = event,
            Err(trouble) => carried.trouble = carried.trouble.or(Some(trouble)),
        }
        (taken, reached)
    }
}
