//! The hybrid state of a run: coordinates and speeds, and the mode in which they move.

use std::borrow::Cow;
use std::sync::Arc;

use xprec::Df64;

use crate::engine::cells::{self, Number};
use crate::engine::clock::Clock;
use crate::engine::contact::{self, Contact};
use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::equations::{Affine, Equations, Exit, Switching, varying_by_steps};
use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Forcing;
use crate::engine::jump::{Passage, Surface};
use crate::engine::law::{self, LawState};
use crate::engine::motion::Reached;
use crate::engine::record::State;
use crate::engine::start::Initial;
use crate::engine::switch::{self, Guards, Switch};
use crate::engine::vector::{Matrix, Vector};
use crate::scene::Scene;
use crate::tolerance::events::{DOUBLINGS, EVENTS_AT_ONE_TIME, NO_TIME};

/// Event counts and search cost of a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Counts {
    /// Steps of a stiffness that were passed.
    pub cell_changes: u64,
    /// Steps at which the motion turned back.
    pub reflections: u64,
    /// Times that a phase was held at a step.
    pub holds: u64,
    /// Impacts. An impact is an entry into a mode that counts its entries, after the deflection had been away from such modes.
    pub impacts: u64,
    /// Times that a clutch or dry friction locked.
    pub sticks: u64,
    /// Steps met together whose order changes the speeds: the result is one of several.
    pub ambiguous: u64,
    /// What the searches for crossings cost.
    pub cost: Cost,
}

impl Counts {
    /// Steps of a stiffness met: passed, or turned back from.
    pub fn events(&self) -> u64 {
        self.cell_changes + self.reflections
    }
}

/// The state of a run.
#[derive(Clone)]
pub struct Hybrid<'a> {
    /// The equations.
    pub equations: &'a (dyn Equations + 'a),
    /// Time.
    pub clock: Clock,
    /// End of the run \[s\]. It may be set to a later time, and the run goes on.
    pub t_end: f64,
    /// Coordinates and speeds.
    pub state: State,
    /// The laws, each in its cell.
    pub laws: Vec<LawState>,
    /// The switches, each in its mode.
    pub switches: Vec<Switch>,
    /// The guards of their modes.
    pub guards: Arc<Guards>,
    /// The law values: of the laws, then of the symbols of each switch of the model.
    pub k: Vec<f64>,
    /// Phases that are held at steps, and deflections that switches hold.
    pub contact: Option<Box<Contact>>,
    /// Torques that vary in time, if any does.
    pub forcing: Option<Box<Forcing>>,
    /// The external torques of the scene, by their numbers.
    pub torques: Arc<[usize]>,
    /// When a switch last changed its mode \[s\], and the number of changes between which the deflections did not move.
    pub rattle: (f64, u32),

    /// Energy that damping has taken so far \[J\].
    pub dissipated: f64,
    /// Energy of bounces that were not followed to their ends, so far \[J\].
    pub ignored: f64,
    /// Work of the varying part of each of `torques` so far \[J\]; empty if all are constant.
    pub work: Vec<f64>,
    /// Events so far.
    pub counts: Counts,
}

impl<'a> Hybrid<'a> {
    /// The state at the start of a run of `scene`.
    pub fn new(equations: &'a dyn Equations, scene: &Scene, begun: Initial, forcing: Option<Forcing>) -> Self {
        let Initial { state, laws, switches, .. } = begun;
        let torques: Arc<[usize]> = scene.torques().into();
        let varying = forcing.is_some() || torques.iter().any(|&i| equations.has_power(i));
        let mut k = scene.model.in_contact(laws.iter().map(LawState::level));
        k.resize(k.len() + varying_by_steps(scene).count(), 0.0);
        let mut now = Hybrid {
            equations,
            clock: Clock::default(),
            t_end: scene.t_end,
            k,
            state,
            laws,
            switches,
            guards: Arc::default(),
            contact: None,
            forcing: forcing.map(Box::new),
            rattle: (f64::NAN, 0),
            dissipated: 0.0,
            ignored: 0.0,
            work: vec![0.0; if varying { torques.len() } else { 0 }],
            torques,
            counts: Counts::default(),
        };
        now.set_levels();
        now
    }
}

impl Hybrid<'_> {
    /// The number of the cell.
    pub fn cell(&self) -> Number {
        Number::of(&self.laws, &self.switches)
    }

    /// Updates the law values to the present state and time: those of the laws, of the switches, and of the parameters that vary.
    #[inline]
    pub fn set_levels(&mut self) {
        let of = (&self.laws[..], &self.switches[..], self.forcing.as_deref());
        cells::write(of, (&self.state.q, self.clock.now()), &mut self.k);
    }

    /// Updates the geometry of the steps at the present coordinates, if M depends on them.
    #[inline]
    pub fn set_surfaces(&mut self) {
        if self.equations.is_inertia_constant() {
            return;
        }
        for (i, law) in self.laws.iter_mut().enumerate() {
            law.surface = Surface::new(self.equations, i, &self.state.q);
        }
    }

    /// M⁻¹ at the present coordinates; P if phases are held (N x N).
    pub fn mobility(&self) -> Matrix {
        let free = || self.equations.mobility(&self.state.q);
        match &self.contact {
            None => free(),
            Some(contact) if self.equations.is_inertia_constant() => contact.mobility.clone(),
            Some(contact) => contact::held(&free(), &contact.normals).0,
        }
    }

    /// The law values in a `state` of the present mode at the time `t` \[s\].
    pub fn levels_at(&self, state: &State, t: f64) -> Cow<'_, [f64]> {
        if !self.levels_move() {
            return Cow::Borrowed(&self.k);
        }
        let mut k = self.k.clone();
        cells::write((&self.laws, &self.switches, self.forcing.as_deref()), (&state.q, t), &mut k);
        Cow::Owned(k)
    }

    /// Whether laws and guards change at events only: every law is constant within its cells, no deflection bends, and no guard depends on a
    /// parameter that varies.
    pub fn steps_only(&self) -> bool {
        self.laws.iter().all(|law| law.pitch.steps_only()) && !self.guards_move()
    }

    /// Whether the factors of guards change within a mode otherwise than by laws.
    fn guards_move(&self) -> bool {
        self.equations.bends() || self.forcing.as_ref().is_some_and(|forcing| forcing.moves_guards())
    }

    /// Whether the law values change within a mode.
    fn levels_move(&self) -> bool {
        !self.steps_only() || self.forcing.as_ref().is_some_and(|forcing| forcing.is_by_steps())
    }

    /// Whether the phase of a law can meet a boundary of its cell by its motion.
    #[inline]
    pub fn watches(&self, law: usize) -> bool {
        let LawState { switching, pitch, .. } = &self.laws[law];
        let changes = *switching != Switching::Never || !pitch.steps_only();
        changes && self.laws[law].next_switch().is_none() && !self.holds(law)
    }

    /// Whether the phase of a law is held.
    #[inline]
    pub fn holds(&self, law: usize) -> bool {
        self.contact.as_ref().is_some_and(|contact| contact.holds(law))
    }

    /// Value of the guard of an exit of a switch. Before the exit a negative value is a rounding error and counts as zero.
    ///
    /// A train that starts from rest moves at first by less than the rounding errors of its state. These can make a switch rattle: it
    /// changes its mode repeatedly at one time. Such a switch changes only when its guard is violated by more than the rounding error.
    pub fn left_to(&self, exit: &Exit) -> f64 {
        exit.guard.value(&self.state.q, &self.state.q_dot, &self.k).max(0.0) + self.slack_of(exit)
    }

    /// Whether the guards of the switches have changed by at most their rounding errors in the last `dt` \[s\]. Their signs then say nothing
    /// about the side on which the deflections are. `rate` bounds the rates of the motion \[1/s\].
    pub fn has_not_moved(&self, dt: f64, rate: f64) -> bool {
        let still = |Exit { guard, .. }: &Exit| {
            let by_speed = guard.on_speed.amax() == 0.0 || dt * rate <= NO_TIME;
            by_speed && (guard.on_q.dot(&self.state.q_dot) * dt).abs() <= guard.rounding(&self.k)
        };
        dt == 0.0 || dt > 0.0 && self.guards.exits.iter().flatten().all(still)
    }

    /// What is added to the value of a guard while a switch rattles: the rounding error of the guard. It doubles with each further change, since
    /// a method by steps has larger errors.
    pub fn slack_of(&self, Exit { guard, .. }: &Exit) -> f64 {
        let (each, all) = EVENTS_AT_ONE_TIME;
        let Some(further) = self.rattle.1.checked_sub(all.min(each * self.switches.len() as u32)) else { return 0.0 };
        let rate = switch::rest(self.equations, (&self.state.q, &self.state.q_dot), &guard.on_speed);
        2f64.powi(further.min(DOUBLINGS) as i32) * (guard.rounding(&self.k) + rate)
    }

    /// Value of a function that ends a hold, by its number; it may have either sign.
    pub fn left_of_hold(&self, which: usize) -> f64 {
        let Some(contact) = &self.contact else { return f64::INFINITY };
        let (State { q, q_dot, .. }, Some(watch)) = (&self.state, contact.watches.get(which)) else {
            return f64::INFINITY;
        };
        let form =
            if self.steps_only() { watch.form.clone() } else { watch.at(self.equations, &self.switches, q, &self.k) };
        if let Some(turned) =
            contact.turned((self.equations, &self.switches), (q, q_dot), &self.k, || self.law_rates(q, q_dot))
        {
            let (_, to_reactions) = contact::held(&self.equations.mobility(q), &turned.normals);
            return form.at(&to_reactions).value(q, q_dot, || self.force() + &turned.force);
        }
        if self.equations.is_inertia_constant() {
            return form.value(q, q_dot, || self.force());
        }
        let (_, to_reactions) = contact::held(&self.equations.mobility(q), &contact.normals);
        form.at(&to_reactions).value(q, q_dot, || self.force())
    }

    /// Generalised forces of the torques that vary, beyond those of the start (N).
    #[cold]
    pub fn further_load(&self) -> Vector {
        let none = || Vector::zeros(self.state.q.len());
        self.forcing.as_ref().map_or_else(none, |forcing| forcing.load(self.clock.now()))
    }

    /// The rates of the law values along the motion `q`, `q_dot`.
    pub fn law_rates(&self, q: &[f64], q_dot: &[f64]) -> Vec<f64> {
        let mut rates = self.slopes(q, self.clock.now());
        for (rate, law) in rates.iter_mut().zip(&self.laws) {
            *rate *= law.speed(q_dot);
        }
        rates
    }

    /// The derivatives of the law values by their phases, at the coordinates `q` and the time `t` \[s\], in the places of the values.
    pub fn slopes(&self, q: &[f64], t: f64) -> Vec<f64> {
        let mut slopes = vec![0.0; self.k.len()];
        for (slope, law) in slopes.iter_mut().zip(&self.laws) {
            *slope = law.course(q[law.phase], t)[1];
        }
        slopes
    }

    /// All generalised forces (N).
    pub fn force(&self) -> Vector {
        let State { q, q_dot, .. } = &self.state;
        let mut force = self.equations.force(q, q_dot, &self.k, &self.slopes(q, self.clock.now()));
        if self.forcing.is_some() {
            force += &self.further_load();
        }
        force
    }

    /// The generalised forces of a linear cell at the present coordinates, without those of speeds and of torques that vary (N).
    pub fn force_at_rest(&self) -> Vector {
        let n = self.state.q.len();
        self.equations.force(&self.state.q, &Vector::zeros(n), &self.k, &vec![0.0; self.k.len()])
    }

    /// Energy that the forces of switches dissipate while the coordinates move by `dq` \[J\].
    #[inline]
    pub fn lost_by_switches(&self, dq: &Vector) -> f64 {
        self.guards.lost(&self.state.q, dq, &self.k)
    }

    /// Puts a switch into a mode, then into the one in which the state violates no guard; `crossed` is the guard that became zero.
    pub fn put(&mut self, switch: usize, mode: usize, crossed: Option<&Affine>) {
        let place = &mut self.switches[switch];
        let before = std::mem::replace(&mut place.mode, mode);
        place.write(&mut self.k);
        let state = (&self.state.q[..], &self.state.q_dot[..]);
        switch::settle(place, self.equations, state, &mut self.k, crossed);
        self.counts.impacts += u64::from(place.count(before));
        place.leave(before, self.clock.now());
    }

    /// Puts every switch into the mode that the state admits, after a sudden change.
    pub fn settle(&mut self) {
        (0..self.switches.len()).for_each(|i| self.put(i, self.switches[i].mode, None));
    }

    /// Puts a switch into a mode, whatever the state is.
    pub fn set_mode(&mut self, switch: usize, mode: usize) {
        let place = &mut self.switches[switch];
        let before = std::mem::replace(&mut place.mode, mode);
        place.write(&mut self.k);
        place.leave(before, self.clock.now());
    }

    /// Holds the phases of `laws` and the deflections of switches if their reactions admit it.
    ///
    /// # Errors
    /// Those of [`Contact::begin`].
    pub fn hold(&mut self, laws: Vec<(usize, Side)>) -> Result<(), Refusal> {
        let (contact, neglected) = Contact::begin(self, laws)?;
        self.contact = contact.map(Box::new);
        self.ignored += neglected;
        Ok(())
    }

    /// Removes the errors of held rates in which friction laws are factors: the motion after the hold would begin with them.
    pub fn still(&mut self) {
        let State { q, q_dot, .. } = &self.state;
        let turned = self.contact.as_ref().and_then(|contact| {
            contact.turned((self.equations, &self.switches), (q, q_dot), &self.k, || self.law_rates(q, q_dot))
        });
        if let Some(turned) = turned {
            self.state.q_dot = turned.still(&self.equations.mobility(q), q_dot);
        }
    }

    /// Whether the deflection of a switch cannot move.
    #[inline]
    pub fn is_locked(&self, switch: usize) -> bool {
        self.contact.as_ref().is_some_and(|contact| contact.locked.contains(&switch))
    }

    /// Whether a switch is in a mode that holds its deflection.
    pub fn is_stuck(&self) -> bool {
        self.switches.iter().any(|switch| switch.here().held)
    }

    /// Changes the speeds at the step of `law` met at `side`.
    pub fn jump(&mut self, law: usize, side: Side) -> Passage {
        let dv = law::barrier(self.equations, (&self.laws, &self.switches, &self.k), law, side, &self.state);
        let (passage, gained) = self.laws[law].surface.jump(&self.state.q_dot, side, dv);
        self.state.gain(&gained);
        passage
    }

    /// Moves to the state that a motion has reached after the time `t` \[s\].
    #[inline]
    pub fn take(&mut self, t: Df64, reached: Reached) {
        self.clock.advance(t);
        self.state = reached.state;
        self.dissipated += reached.dissipated;
        self.work.iter_mut().zip(reached.work).for_each(|(work, more)| *work += more);
        if self.levels_move() {
            self.set_levels();
            if self.guards_move() {
                self.guards = Arc::new(Guards::of(self.equations, &self.switches, &self.state.q, &self.k));
            }
        }
    }

    /// Ends a run whose state is not finite.
    ///
    /// # Errors
    /// [`Stop::NotFinite`].
    #[inline(always)]
    pub fn require_finite(&self) -> Result<(), Stop> {
        if self.state.is_finite() {
            return Ok(());
        }
        Err(Stop::NotFinite { t: self.clock.now(), state: self.state.describe(), cell: self.cell() })
    }

    /// Why a search without an answer ends the run.
    #[cold]
    pub fn lost(&self, lost: SearchError) -> Stop {
        let (t, state, cell) = (self.clock.now(), self.state.describe(), self.cell());
        match lost {
            SearchError::Stuck(steps) => Stop::Search { t, steps: steps as usize, state, cell },
            SearchError::Overflow => Stop::NotFinite { t, state, cell },
        }
    }
}
