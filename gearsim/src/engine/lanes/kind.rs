//! Which simulations can be side by side.

use crate::engine::cell::Cell;
use crate::engine::lanes::LARGEST;
use crate::engine::mode::Mode;
use crate::engine::simulate::Simulation;
use crate::tolerance::modes::EIGENVALUES_APART;

/// What simulations must have in common to be side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Kind {
    /// Cells in a pitch.
    pub places: usize,
    /// Coordinate that is the phase.
    pub phase: usize,
    /// Which modes are rigid, in every cell; the others oscillate.
    pub rigid: Vec<bool>,
}

impl Kind {
    /// That of a simulation; `None` if it can be in no lane: it has too many coordinates, its events are never plain, or a mode is rigid in some cells
    /// only, damped beyond oscillating, or coupled to others by damping.
    pub fn of(simulation: &Simulation<'_>) -> Option<Self> {
        let law = simulation.laws.first().filter(|_| simulation.is_plain() && simulation.state.q.len() <= LARGEST)?;
        let cells = simulation.cells().all()?;
        let rigid: Vec<bool> = cells[0].cell.modes.iter().map(Mode::is_rigid).collect();
        let oscillates = |mode: &Mode| mode.damped_frequency() > EIGENVALUES_APART * mode.sigma;
        let plain = |(mode, rigid): (&Mode, &bool)| if *rigid { mode.is_rigid() } else { oscillates(mode) };
        let fits = |cell: &Cell| cell.coupling.is_none() && cell.modes.iter().zip(&rigid).all(plain);
        let fits = cells.iter().all(|prepared| fits(&prepared.cell));
        fits.then_some(Kind { places: law.pitch.cells(), phase: law.phase, rigid })
    }
}
