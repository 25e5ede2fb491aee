//! The exact solver: linear cells, in closed form.

use std::collections::HashMap;
use std::sync::Arc;

use crate::engine::cell::Cell;
use crate::engine::cells::{Cells, Number, Prepared};
use crate::engine::contact::{Contact, StateForm};
use crate::engine::crossing::{Delay, Side};
use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Onward;
use crate::engine::hybrid::Hybrid;
use crate::engine::law;
use crate::engine::motion::{Motion, Solver};
use crate::engine::record::State;
use crate::engine::vector::transposed;
use crate::engine::watch::Watch;
use crate::scene::Scene;
use crate::tolerance::events::HELD_CELLS;

mod flight;

use flight::InFlight;

/// The solver of runs whose cells are linear.
#[derive(Debug, Clone)]
pub struct Exact {
    cells: Cells,
    /// The present cell with what is held in it.
    held: Option<Held>,
    /// The cells met so far in which something was held, by their numbers and the phases held.
    met: HashMap<CellKey, Arc<HeldCell>>,
    /// The delay of the phase in each cell of a pitch at its last passage. Used only for a single law, whose motion repeats itself.
    lateness: Vec<Delay>,
}

/// The number of a cell, and the phases held in it.
type CellKey = (Number, Vec<(usize, Side)>);

/// A cell in which phases or deflections are held.
#[derive(Debug, Clone)]
struct HeldCell {
    cell: Prepared,
}

/// The present cell with what is held in it.
#[derive(Debug, Clone)]
struct Held {
    here: Arc<HeldCell>,
    /// The functions that end the holds, in the order of [`Contact::watches`]. They also depend on the place: laws of longer periods may
    /// step at the same boundary in one pitch and not in the next.
    watches: Vec<Watch>,
}

impl Exact {
    /// The solver of a run of `scene` that begins with `now`.
    ///
    /// # Errors
    /// If a cell is not linear, or its modes cannot be computed.
    pub fn new(scene: &Scene, now: &Hybrid<'_>) -> Result<Self, Refusal> {
        let terms = scene.effects.nonlinear(scene.model);
        if !terms.is_empty() {
            return Err(Refusal::Nonlinear { terms });
        }
        if let Some(terms) = law::curved(scene.model, &now.laws) {
            return Err(Refusal::Nonlinear { terms });
        }
        let cells = Cells::new(now.equations, scene.model.motions.len(), (&now.laws, &now.switches, &now.k))?;
        let lateness = vec![Delay::default(); now.laws.first().map_or(1, |law| law.pitch.cells())];
        Ok(Exact { cells, held: None, met: HashMap::new(), lateness })
    }
}

/// The present cell with what is held in it, and the functions that end the holds.
#[inline]
fn here<'s>(cells: &'s Cells, held: &'s Option<Held>) -> (&'s Prepared, &'s [Watch]) {
    held.as_ref().map_or_else(|| (cells.here(), &[][..]), |held| (&held.here.cell, &held.watches))
}

impl Exact {
    /// The present cell with what is held in it; computed once for each.
    fn meet_held(&mut self, now: &Hybrid<'_>, contact: &Contact) -> Result<Arc<HeldCell>, Refusal> {
        let key = (now.cell(), contact.laws.clone());
        if let Some(held) = self.met.get(&key) {
            return Ok(held.clone());
        }
        let held = Arc::new(HeldCell::new(now, contact)?);
        if self.met.len() < HELD_CELLS {
            self.met.insert(key, held.clone());
        }
        Ok(held)
    }
}

impl Solver for Exact {
    #[inline]
    fn enter(&mut self, now: &mut Hybrid<'_>) -> Result<(), Refusal> {
        self.cells.meet(now.equations, (&now.laws, &now.switches, &now.k))?;
        self.held = match &now.contact {
            Some(contact) => Some(Held::new(self.meet_held(now, contact)?, now, contact)),
            None => None,
        };
        if !now.switches.is_empty() {
            now.guards.clone_from(&here(&self.cells, &self.held).0.guards);
        }
        Ok(())
    }

    fn solve<'s>(&'s mut self, now: &'s Hybrid<'_>, horizon: f64) -> Result<Box<dyn Motion + 's>, Stop> {
        let Exact { cells, held, lateness, .. } = self;
        let (here, watches) = here(cells, held);
        let State { q, q_dot, .. } = &now.state;
        let balanced = !now.switches.is_empty() || now.state.is_at_rest();
        let mut flight = match balanced {
            false => here.cell.flight(q, q_dot),
            true => here.cell.flight_under(q, q_dot, &now.force_at_rest()),
        };
        let onward = now.forcing.as_ref().map_or(vec![], |forcing| forcing.onward(&now.clock));
        if !onward.is_empty() {
            flight = here.cell.pushed(flight, &Onward::force(&onward, q.len()));
            if balanced {
                flight = here.cell.balanced(flight, q);
            }
            if let Some((frequencies, force)) = Onward::varying(&onward, q.len()) {
                flight = here.cell.driven(flight, frequencies, force);
            }
        }
        let lateness = match &now.laws[..] {
            [law] => Some(&mut lateness[law.cell]),
            _ => None,
        };
        Ok(Box::new(InFlight::new(now, here, watches, flight, lateness, (onward, horizon))))
    }

    fn rate(&self) -> f64 {
        self.cells.here().cell.rate
    }

    fn cells(&self) -> Option<&Cells> {
        Some(&self.cells)
    }
}

impl HeldCell {
    fn new(now: &Hybrid<'_>, contact: &Contact) -> Result<Self, Refusal> {
        let (equations, k) = (now.equations, &now.k);
        let cell = Cell::held(equations, (&now.switches, k), &contact.normals)?;
        let cell = Prepared::new(cell, equations, (&now.laws, &now.switches, k));
        Ok(HeldCell { cell })
    }
}

impl Held {
    fn new(here: Arc<HeldCell>, now: &Hybrid<'_>, contact: &Contact) -> Self {
        let (stiffness, damping) = (now.equations.stiffness(&now.k), now.equations.damping(&now.k));
        let slopes = |StateForm { on_q, on_speed, on_force, .. }: &StateForm| {
            [on_q - &transposed(&stiffness, on_force), on_speed - &transposed(&damping, on_force), on_force.clone()]
        };
        let watches = contact.watches.iter().map(|watch| Watch::loaded(&here.cell.cell, slopes(&watch.form))).collect();
        Held { here, watches }
    }
}
