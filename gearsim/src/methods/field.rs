//! The right-hand side that methods integrate, smooth within a mode: q'' = P F(q, q', k(s), dk/ds, t), and the power that damping
//! dissipates.
//!
//! P = M⁻¹. If phases or deflections are held, P is the mobility of the remaining motion ([`contact`]). Where M depends on q, so does P.
//! The modes of switches do not change within a step: a step may go beyond the end of its mode, and the forces continue smoothly there.

use std::sync::Arc;

use nalgebra::DMatrix;

use crate::engine::contact::{self, Contact, Turned, Watch};
use crate::engine::crossing::Side;
use crate::engine::equations::{Equations, accelerated};
use crate::engine::forcing::Forcing;
use crate::engine::hybrid::Hybrid;
use crate::engine::law::LawState;
use crate::engine::motion::Guard;
use crate::engine::switch::{Guards, Switch};
use crate::engine::vector::{Matrix, Vector};
use crate::methods::flow::Flow;
use gearsim_equations::LinearForces;

/// The equations of a run in its present mode.
pub struct Field<'a> {
    /// The equations.
    pub equations: &'a (dyn Equations + 'a),
    laws: Vec<LawState>,
    switches: Vec<Switch>,
    guards: Arc<Guards>,
    forcing: Option<Box<Forcing>>,
    /// The functions whose zeros end held contacts.
    holds: Vec<Watch>,
    /// P (N x N); `None` where M depends on q.
    mobility: Option<Matrix>,
    /// The torques that depend on the state: for each, its index among the torques of the scene, and its index in the model.
    of_state: Vec<(usize, usize)>,
    /// The linear forces of the present mode, if the model puts them together from parts.
    linear: Option<LinearForces>,
    /// Gradients of the held motions (N, one per column).
    held: Option<DMatrix<f64>>,
    /// The contact, if friction laws are factors in its held rates: the gradients then change with the motion.
    turning: Option<Box<Contact>>,
    /// Time at which the present step begins \[s\].
    pub begins: f64,
    /// Evaluations of the right-hand side so far.
    pub evaluations: u64,
    /// Whether laws and guards change at events only ([`Hybrid::steps_only`]).
    steps_only: bool,
    /// At the state of the last evaluation: the law values, and their first and second derivatives by the phase.
    k: Vec<f64>,
    dk: Vec<f64>,
    ddk: Vec<f64>,
}

impl<'a> Field<'a> {
    /// The equations of a run in the mode of `now`.
    pub fn new(now: &Hybrid<'a>) -> Self {
        let none = vec![0.0; now.k.len()];
        let mut field = Field {
            equations: now.equations,
            laws: vec![],
            switches: vec![],
            guards: Arc::default(),
            forcing: None,
            holds: vec![],
            mobility: None,
            of_state: now.torques.iter().copied().enumerate().filter(|(_, i)| now.equations.has_power(*i)).collect(),
            linear: None,
            held: None,
            turning: None,
            begins: now.clock.now(),
            evaluations: 0,
            steps_only: now.steps_only(),
            k: vec![],
            dk: none.clone(),
            ddk: none,
        };
        field.enter(now);
        field
    }

    /// Changes to the mode of `now`.
    pub fn enter(&mut self, now: &Hybrid<'_>) {
        self.laws.clone_from(&now.laws);
        self.switches.clone_from(&now.switches);
        self.guards.clone_from(&now.guards);
        self.k.clone_from(&now.k);
        self.forcing.clone_from(&now.forcing);
        self.holds = now.contact.iter().flat_map(|contact| &contact.watches).cloned().collect();
        self.held = now.contact.as_ref().map(|contact| contact.normals.clone());
        self.turning = now.contact.clone().filter(|contact| contact.turns());
        self.linear = if self.steps_only { self.equations.linear_forces(&self.k) } else { None };
        self.mobility = self.equations.is_inertia_constant().then(|| now.mobility());
    }

    /// y' at `y`, the time `t` after the step began.
    #[inline]
    pub fn rate(&mut self, t: f64, y: &Flow) -> Flow {
        self.evaluations += 1;
        let force = self.force(t, y);
        let v = match (self.turned(y), &self.mobility) {
            (Some(turned), _) => {
                let free = self.equations.mobility(&y.q);
                &contact::held(&free, &turned.normals).0 * &force - &(&free * &turned.force)
            }
            (None, Some(mobility)) => mobility * &force,
            (None, None) => &self.mobility_at(&y.q) * &force,
        };
        Flow { q: y.v.clone(), v, lost: self.loss(y) }
    }

    /// N and the force c at `y`, if friction laws are factors in held rates ([`Turned`]). The field must have been evaluated at `y`.
    #[inline]
    fn turned(&self, y: &Flow) -> Option<Turned> {
        let contact = self.turning.as_ref()?;
        let rates = || {
            let mut rates = vec![0.0; self.k.len()];
            for (i, law) in self.laws.iter().enumerate() {
                rates[i] = self.dk[i] * law.speed(&y.v);
            }
            rates
        };
        contact.turned((self.equations, &self.switches), (&y.q, &y.v), &self.k, rates)
    }

    /// P at the coordinates `q` (N x N).
    fn mobility_at(&self, q: &[f64]) -> Matrix {
        let free = self.equations.mobility(q);
        match &self.held {
            Some(normals) => contact::held(&free, normals).0,
            None => free,
        }
    }

    /// The generalised forces at `y`, the time `t` after the step began (N).
    #[inline]
    fn force(&mut self, t: f64, y: &Flow) -> Vector {
        self.set(t, y);
        let mut force = match &self.linear {
            Some(linear) => linear.force(&y.q, &y.v),
            None => self.equations.force(&y.q, &y.v, &self.k, &self.dk),
        };
        if self.linear.is_some() {
            self.equations.add_other_forces(&y.q, &y.v, &self.k, &self.dk, &mut force);
        }
        if let Some(forcing) = &self.forcing {
            force += &forcing.load(self.begins + t);
        }
        force
    }

    /// The power that dampers dissipate at `y`, the time `t` after the step began \[W\]. The forces of switches are not included.
    pub fn lost(&mut self, t: f64, y: &Flow) -> f64 {
        self.set(t, y);
        self.loss(y)
    }

    /// [`Field::lost`] at `y`. The field must have been evaluated there.
    #[inline]
    fn loss(&self, y: &Flow) -> f64 {
        let dissipation = match &self.linear {
            Some(linear) => linear.dissipation(&y.v) + self.equations.other_dissipation(&y.q, &y.v, &self.k),
            None => self.equations.dissipation(&y.q, &y.v, &self.k),
        };
        2.0 * dissipation
    }

    /// The power that the forces of switches dissipate at `y` \[W\]. The field must have been evaluated there. If these forces do not
    /// change within a mode, the loss is computed from the displacement instead ([`Hybrid::lost_by_switches`]).
    pub fn lost_by_switches(&self, y: &Flow) -> f64 {
        Guards::of(self.equations, &self.switches, &y.q, &self.k).power(&y.q, &y.v, &self.k)
    }

    /// Writes to `power` the power of the varying part of each torque of the scene at `y`, the time `t` after the step began \[W\]
    /// (n_torques).
    pub fn write_power(&mut self, t: f64, y: &Flow, power: &mut [f64]) {
        self.set(t, y);
        power.fill(0.0);
        for &(at, i) in &self.of_state {
            power[at] = self.equations.torque_power(i, &y.q, &y.v, &self.k);
        }
        if let Some(forcing) = &self.forcing {
            let varying = forcing.power(self.begins + t, &y.v);
            power.iter_mut().zip(varying).for_each(|(power, varying)| *power += varying);
        }
    }

    /// Values of laws and switches, and slopes of the laws along their phases, at the state of the last evaluation.
    pub fn laws_at(&self) -> (&[f64], &[f64]) {
        (&self.k, &self.dk)
    }

    /// Derivatives of the accelerations by q and by q' (N x N each, row = equation).
    pub fn jacobian(&mut self, t: f64, y: &Flow) -> [Matrix; 2] {
        self.set(t, y);
        let [mut by_q, by_v] = self.equations.jacobian(&y.q, &y.v, &self.k, &self.dk, &self.ddk);
        if let Some(mobility) = &self.mobility {
            return accelerated(mobility, [by_q, by_v]);
        }
        // M q'' = F + N R with constant N and Nᵀq'' = 0. The differential is M dq'' = dF - dM q'' + N dR with Nᵀdq'' = 0.
        // Therefore dq'' = P (dF - dM q'').
        let mobility = self.mobility_at(&y.q);
        let acceleration = &mobility * &self.force(t, y);
        by_q -= self.equations.inertia(&y.q, &acceleration);
        accelerated(&mobility, [by_q, by_v])
    }

    /// The value of `guard` for `side` at `y`, the time `t` after the step began. It is positive before the guard is met.
    pub fn left(&mut self, guard: Guard, side: Side, t: f64, y: &Flow) -> f64 {
        match guard {
            Guard::Phase(i) => side.sign() * (self.laws[i].boundary(side) - y.q[self.laws[i].phase]),
            Guard::Exit(i, which) => {
                self.set(t, y);
                // With curved laws, the factors of a guard change within the mode. With nonlinear deflections, the guard is that of the
                // tangent at `y`.
                let guards = match self.steps_only {
                    true => self.guards.clone(),
                    false => Arc::new(Guards::of(self.equations, &self.switches, &y.q, &self.k)),
                };
                guards.exits[i][which].guard.value(&y.q, &y.v, &self.k)
            }
            Guard::Hold(which) => {
                let mut force = self.force(t, y);
                let mut form = match self.steps_only {
                    true => self.holds[which].form.clone(),
                    false => self.holds[which].at(self.equations, &self.switches, &y.q, &self.k),
                };
                if let (None, Some(normals)) = (&self.mobility, &self.held) {
                    form = form.at(&contact::held(&self.equations.mobility(&y.q), normals).1);
                }
                if let Some(turned) = self.turned(y) {
                    form = form.at(&contact::held(&self.equations.mobility(&y.q), &turned.normals).1);
                    force += &turned.force;
                }
                -side.sign() * form.value(&y.q, &y.v, || force)
            }
        }
    }

    /// Evaluates the laws and the parameters that vary at `y`, the time `t` after the step began.
    #[inline]
    fn set(&mut self, t: f64, y: &Flow) {
        if let Some(forcing) = &self.forcing {
            forcing.write_shares(self.begins + t, &mut self.k);
        }
        if self.steps_only {
            return;
        }
        for (i, law) in self.laws.iter().enumerate() {
            [self.k[i], self.dk[i], self.ddk[i]] = law.course(y.q[law.phase], self.begins + t);
        }
    }
}
