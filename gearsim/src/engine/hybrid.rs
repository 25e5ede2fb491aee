//! The hybrid state of a run: coordinates and speeds, and the mode in which they move.

use std::borrow::Cow;
use std::sync::Arc;

use xprec::Df64;

use crate::engine::cells::{self, Number};
use crate::engine::clock::Clock;
use crate::engine::contact::{self, Contact};
use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::equations::{Equations, Switching, varying_by_steps};
use crate::engine::error::Stop;
use crate::engine::forcing::Forcing;
use crate::engine::jump::{Passage, Surface};
use crate::engine::law::{self, LawState};
use crate::engine::motion::Reached;
use crate::engine::record::State;
use crate::engine::start::Initial;
use crate::engine::switch::{Guards, Switch};
use crate::engine::vector::{Matrix, Vector};
use crate::scene::Scene;
use crate::tolerance::events::RELEASE;

mod held;
mod modes;
mod rattle;

use rattle::Rattle;

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
    /// Steps met together whose order changes the speeds. The computed motion is then one of several possible ones.
    pub ambiguous: u64,
    /// The cost of the searches for crossings.
    pub cost: Cost,
}

impl Counts {
    /// Steps of a stiffness that were met: transmissions and reflections.
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
    /// Torques that vary in time, if there are any.
    pub forcing: Option<Box<Forcing>>,
    /// How far a reaction must exceed its bound to end a hold [relative to the forces it consists of]: the accuracy of the solver.
    pub release: f64,
    /// Indices of the external torques of the scene.
    pub torques: Arc<[usize]>,
    /// The last changes of the modes of switches.
    pub rattle: Rattle,

    /// Energy that damping has taken so far \[J\].
    pub dissipated: f64,
    /// Energy neglected so far at the start of holds \[J\].
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
            release: RELEASE,
            rattle: Rattle::default(),
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

    /// M⁻¹ at the present coordinates; P if phases are held (n x n).
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

    /// Whether laws and guards change at events only: every law is constant within its cells, no deflection bends, and no guard depends on
    /// a parameter that varies.
    pub fn steps_only(&self) -> bool {
        self.laws.iter().all(|law| law.pitch.steps_only()) && !self.guards_move()
    }

    /// Whether the factors of guards change within a mode for other reasons than laws.
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

    /// Generalised forces of the torques that vary, beyond those of the start (n).
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

    /// The derivatives of the law values by their phases, at the coordinates `q` and the time `t` \[s\]: one for each law value; 0 for
    /// values that are not of laws.
    pub fn slopes(&self, q: &[f64], t: f64) -> Vec<f64> {
        let mut slopes = vec![0.0; self.k.len()];
        for (slope, law) in slopes.iter_mut().zip(&self.laws) {
            *slope = law.course(q[law.phase], t)[1];
        }
        slopes
    }

    /// All generalised forces (n).
    pub fn force(&self) -> Vector {
        let State { q, q_dot, .. } = &self.state;
        let mut force = self.equations.force(q, q_dot, &self.k, &self.slopes(q, self.clock.now()));
        if self.forcing.is_some() {
            force += &self.further_load();
        }
        force
    }

    /// The generalised forces of a linear cell at the present coordinates, without those of speeds and of torques that vary (n).
    pub fn force_at_rest(&self) -> Vector {
        let n = self.state.q.len();
        self.equations.force(&self.state.q, &Vector::zeros(n), &self.k, &vec![0.0; self.k.len()])
    }

    /// Energy that the forces of switches dissipate while the coordinates move by `dq` \[J\].
    #[inline]
    pub fn lost_by_switches(&self, dq: &Vector) -> f64 {
        self.guards.lost(&self.state.q, dq, &self.k)
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

    /// The error with which a search without a result ends the run.
    #[cold]
    pub fn lost(&self, lost: SearchError) -> Stop {
        let (t, state, cell) = (self.clock.now(), self.state.describe(), self.cell());
        match lost {
            SearchError::Stuck(steps) => Stop::Search { t, steps: steps as usize, state, cell },
            SearchError::Overflow => Stop::NotFinite { t, state, cell },
        }
    }
}
