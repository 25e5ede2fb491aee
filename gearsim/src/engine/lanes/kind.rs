//! The properties that simulations in lanes must have in common.

use crate::engine::cell::Cell;
use crate::engine::lanes::LARGEST;
use crate::engine::lanes::vectors::Vectors;
use crate::engine::mode::Mode;
use crate::engine::simulate::Simulation;
use crate::tolerance::modes::EIGENVALUES_APART;

/// The properties that simulations must share to run side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Kind {
    /// Number of cells in a pitch.
    pub places: usize,
    /// Index of the coordinate that is the phase.
    pub phase: usize,
    /// Whether each mode is rigid. It is the same in every cell; the other modes oscillate.
    pub rigid: Vec<bool>,
    /// The instructions that all are compiled for.
    pub vectors: Vectors,
}

impl Kind {
    /// The kind of a simulation; `None` if it cannot run in a lane. The reasons are: the processor lacks the vector instructions; the
    /// simulation has too many coordinates; its events are never plain; a mode is rigid in some cells only, is damped too strongly to
    /// oscillate, or is coupled to others by damping.
    pub fn of(simulation: &Simulation<'_>) -> Option<Self> {
        let vectors = Vectors::of_processor()?;
        let law =
            simulation.now.laws.first().filter(|_| simulation.is_plain() && simulation.now.state.q.len() <= LARGEST)?;
        let cells = simulation.cells()?.all()?;
        let rigid: Vec<bool> = cells[0].cell.modes.iter().map(Mode::is_rigid).collect();
        let oscillates = |mode: &Mode| mode.damped_frequency() > EIGENVALUES_APART * mode.sigma;
        let plain = |(mode, rigid): (&Mode, &bool)| if *rigid { mode.is_rigid() } else { oscillates(mode) };
        let fits = |cell: &Cell| cell.coupling.is_none() && cell.modes.iter().zip(&rigid).all(plain);
        let fits = cells.iter().all(|prepared| fits(&prepared.cell));
        fits.then_some(Kind { places: law.pitch.cells(), phase: law.phase, rigid, vectors })
    }
}
