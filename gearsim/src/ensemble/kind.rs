//! Which simulations can be side by side.

use crate::engine::cell::Cell;
use crate::engine::mode::Mode;
use crate::engine::simulate::Simulation;

/// What simulations must have in common to be side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kind<const N: usize> {
    /// Cells in a pitch.
    pub places: usize,
    /// Coordinate that is the phase.
    pub phase: usize,
    /// Which modes are rigid, in every cell; the others oscillate.
    pub rigid: [bool; N],
}

impl<const N: usize> Kind<N> {
    /// That of a simulation; `None` if it can be in no lane: its events are never plain, or a mode is rigid in some cells
    /// only, damped beyond oscillating, or coupled to others by damping.
    pub fn of(simulation: &Simulation<'_, N>) -> Option<Self> {
        let law = simulation.laws.first().filter(|_| simulation.is_plain())?;
        let cells = simulation.cells().all()?;
        let rigid: [bool; N] = std::array::from_fn(|i| cells[0].cell.modes[i].is_rigid());
        let oscillates = |mode: &Mode| mode.damped_frequency() > 0.1 * mode.sigma;
        let plain = |(mode, rigid): (&Mode, &bool)| if *rigid { mode.is_rigid() } else { oscillates(mode) };
        let fits = |cell: &Cell<N>| cell.coupling.is_none() && cell.modes.iter().zip(&rigid).all(plain);
        let fits = cells.iter().all(|prepared| fits(&prepared.cell));
        fits.then_some(Kind { places: law.pitch.cells(), phase: law.phase, rigid })
    }
}
