//! The cells that a run meets, in double-double precision, and the steps of V between them. Each is computed when it is first met.

use std::collections::HashMap;
use std::sync::Arc;

use nalgebra::DVector;
use xprec::Df64;

use super::cell::Cell;
use super::held::{self, Held};
use super::step::StiffnessStep;
use crate::engine::cell::{self, HeldModes};
use crate::engine::cells::Number;
use crate::engine::contact::Contact;
use crate::engine::crossing::Side;
use crate::engine::equations::ExactCells;
use crate::engine::error::Refusal;
use crate::engine::hybrid::Hybrid;
use crate::engine::law;
use crate::engine::modal::Modal;
use crate::engine::switch::Switch;

/// The cells.
pub struct Cells {
    /// The cells met so far, by number.
    met: HashMap<Number, Arc<Cell>>,
    /// The cells in which motions are held.
    held: HashMap<CellKey, Arc<Held>>,
    /// Steps from one cell to another one.
    steps: HashMap<(Number, Number), StiffnessStep>,
    /// Geometry of the steps of each law.
    surfaces: Vec<Surface>,
    /// The present cell.
    here: Arc<Cell>,
    /// The present cell with its holds, if it has any.
    present: Option<Arc<Held>>,
}

/// The number of a cell, and the phases and switches held in it.
type CellKey = (Number, Vec<(usize, Side)>, Vec<(usize, usize)>);

/// Geometry of the steps of a law.
pub struct Surface {
    /// G = n.M⁻¹n.
    pub compliance: Df64,
    /// M⁻¹n / G (n).
    pub direction: DVector<Df64>,
}

impl Cells {
    /// The cells of a run. Computes the cell of `now` and makes it the present one.
    ///
    /// # Errors
    /// If its modes cannot be computed.
    pub fn new(exact: &dyn ExactCells, now: &Hybrid<'_>) -> Result<Self, Refusal> {
        let here = Arc::new(cell(exact, now, (&now.switches, &now.k))?);
        let mobility = here.mobility();
        // The phase is a coordinate, n its unit vector: M⁻¹n is a column of M⁻¹.
        let surface = |phase: usize| Surface {
            compliance: mobility[(phase, phase)],
            direction: mobility.column(phase) / mobility[(phase, phase)],
        };
        let surfaces = now.laws.iter().map(|law| surface(law.phase)).collect();
        let met = HashMap::from([(now.cell(), here.clone())]);
        Ok(Cells { met, held: HashMap::new(), steps: HashMap::new(), surfaces, here, present: None })
    }

    /// Makes the cell of `now`, with its holds, the present one.
    ///
    /// # Errors
    /// If the modes of its cell cannot be computed.
    pub fn meet(&mut self, exact: &dyn ExactCells, now: &Hybrid<'_>) -> Result<(), Refusal> {
        self.here = self.cell(exact, now, now.cell(), (&now.switches, &now.k))?;
        self.present = match &now.contact {
            Some(contact) => Some(self.meet_held(exact, now, contact)?),
            None => None,
        };
        Ok(())
    }

    /// The cell with these switches and law values, found by its number or computed.
    fn cell(
        &mut self,
        exact: &dyn ExactCells,
        now: &Hybrid<'_>,
        number: Number,
        stand: (&[Switch], &[f64]),
    ) -> Result<Arc<Cell>, Refusal> {
        if let Some(cell) = self.met.get(&number) {
            return Ok(cell.clone());
        }
        let cell = Arc::new(cell(exact, now, stand)?);
        self.met.insert(number, cell.clone());
        Ok(cell)
    }

    fn meet_held(&mut self, exact: &dyn ExactCells, now: &Hybrid<'_>, contact: &Contact) -> Result<Arc<Held>, Refusal> {
        let place = (now.cell(), contact.laws.clone(), contact.switches.clone());
        if let Some(held) = self.held.get(&place) {
            return Ok(held.clone());
        }
        let k = values(exact, &now.switches, &now.k);
        let normals = held::normals(exact, now, contact, &k);
        let plain = HeldModes::of(now.equations, (&now.switches, &now.k), &contact.normals)?;
        let cell = Cell::new(self.here.matrices.clone(), (&plain.modal, &plain.shapes), Some(&normals));
        let steps = contact.laws.iter().map(|&(law, side)| self.step(exact, now, law, side).cloned()).collect();
        let held = Arc::new(Held::new(cell, &self.here, &normals, steps).ok_or(Refusal::Mass)?);
        self.held.insert(place, held.clone());
        Ok(held)
    }

    /// The present cell. If motions are held, the cell of the remaining motion.
    pub fn here(&self) -> &Cell {
        self.present.as_ref().map_or(&self.here, |held| &held.cell)
    }

    /// The holds in the present cell.
    pub fn held(&self) -> Option<&Held> {
        self.present.as_deref()
    }

    /// Geometry of the steps of a law.
    pub fn surface(&self, law: usize) -> &Surface {
        &self.surfaces[law]
    }

    /// The step of V where `law` meets `side` of its cell; `None` if the modes of the cell beyond cannot be computed.
    pub fn step(&mut self, exact: &dyn ExactCells, now: &Hybrid<'_>, law: usize, side: Side) -> Option<&StiffnessStep> {
        let stand = (&now.laws[..], &now.switches[..], &now.k[..]);
        let switches = law::switches_beyond(now.equations, stand, law, side, &now.state);
        let switches = switches.as_deref().unwrap_or(&now.switches);
        let step = (now.cell(), law::number_beyond(&now.laws, switches, law, side, &now.state));
        if !self.steps.contains_key(&step) {
            let mut k = now.k.clone();
            law::met(&now.laws, law, side, &now.state).for_each(|i| k[i] = now.laws[i].level_beyond(side));
            switches.iter().for_each(|switch| switch.write(&mut k));
            let from = self.cell(exact, now, step.0.clone(), (&now.switches, &now.k)).ok()?;
            let to = self.cell(exact, now, step.1.clone(), (switches, &k)).ok()?;
            self.steps.insert(step.clone(), StiffnessStep::between(&from.matrices, &to.matrices));
        }
        self.steps.get(&step)
    }
}

/// A cell with these switches and law values.
fn cell(exact: &dyn ExactCells, now: &Hybrid<'_>, (switches, k): (&[Switch], &[f64])) -> Result<Cell, Refusal> {
    let matrices = exact.matrices(&values(exact, switches, k));
    let modal = Modal::of(&cell::matrices(now.equations, switches, k)?)?;
    Ok(Cell::new(matrices, (&modal, &modal.shapes), None))
}

/// The law values in double-double precision: the levels of the laws as given in the scene, and the values of the modes of switches.
pub fn values(exact: &dyn ExactCells, switches: &[Switch], k: &[f64]) -> Vec<Df64> {
    let mut wide: Vec<Df64> = k.iter().copied().map(Df64::from).collect();
    for switch in switches {
        let mode = exact.mode(switch.index, switch.mode).unwrap_or_default();
        wide[switch.place()..][..mode.len()].copy_from_slice(&mode);
    }
    wide
}
