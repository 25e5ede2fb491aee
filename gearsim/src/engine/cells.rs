//! The cells of a scene. A cell is one combination of a level of each law and a mode of each switch. The vibration modes of a cell are
//! computed once. If there are few combinations, this is done for all cells in advance; otherwise when a run first enters the cell.

mod number;

use std::collections::HashMap;
use std::sync::Arc;

use smallvec::SmallVec;

use crate::engine::cell::{Cell, matrices};
use crate::engine::equations::{Equations, Exit};
use crate::engine::error::Refusal;
use crate::engine::forcing::Forcing;
use crate::engine::law::LawState;
use crate::engine::switch::{Guards, Switch};
use crate::engine::vector::Vector;
use crate::engine::watch::Watch;
use crate::tolerance::events::CELLS_IN_ADVANCE;

pub use number::Number;

/// The cells of a scene.
#[derive(Debug, Clone)]
pub struct Cells {
    cells: Vec<Prepared>,
    /// The index in `cells` of each combination met so far; `None` if all combinations were computed in advance, in their order.
    met: Option<HashMap<Number, usize>>,
    /// The index of the present cell.
    present: usize,
    /// Number of rigid motions of the model.
    motions: usize,
}

/// A cell, and the phases and guards as functions of its modes.
#[derive(Debug, Clone)]
pub struct Prepared {
    /// Its modes.
    pub cell: Cell,
    /// n.X of each law: contribution of each mode to the phase.
    pub participation: Vec<Vector>,
    /// n.Y of each law, if damping couples the modes: contribution of the speed of each mode to the phase.
    pub on_speed: Vec<Option<Vector>>,
    /// The guards of the modes of the switches.
    pub guards: Arc<Guards>,
    /// The guard of each exit of each switch as a function of the modes.
    pub exits: Vec<SmallVec<[Watch; 2]>>,
}

/// The laws, the switches and the law values, which determine the cell.
pub type Stand<'a> = (&'a [LawState], &'a [Switch], &'a [f64]);

impl Cells {
    /// The cells of laws and switches with the values `k`. The equations have the given number of rigid `motions`.
    ///
    /// # Errors
    /// If the modes of a cell cannot be computed.
    pub fn new(equations: &dyn Equations, motions: usize, (laws, switches, k): Stand<'_>) -> Result<Self, Refusal> {
        let count = laws.iter().map(|l| l.pitch.cells()).chain(switches.iter().map(Switch::modes));
        let count = count.fold(1, usize::saturating_mul);
        if count.saturating_mul(equations.coordinates().pow(3)) > CELLS_IN_ADVANCE {
            let mut cells = Cells { cells: vec![], met: Some(HashMap::new()), present: 0, motions };
            cells.meet(equations, (laws, switches, k))?;
            return Ok(cells);
        }
        let prepare = |i| {
            let (mut laws, mut switches) = (laws.to_vec(), switches.to_vec());
            stand(&mut laws, &mut switches, i);
            let mut k = k.to_vec();
            write_levels((&laws, &switches), &mut k);
            let cell = cell(equations, motions, (&switches, &k))?;
            Ok(Prepared::new(cell, equations, (&laws, &switches, &k)))
        };
        let cells = (0..count).map(prepare).collect::<Result<_, _>>()?;
        Ok(Cells { cells, met: None, present: Number::of(laws, switches).index(), motions })
    }

    /// Makes the cell of these laws and switches the present one. Computes it if it is met for the first time.
    ///
    /// # Errors
    /// If its modes cannot be computed.
    #[inline]
    pub fn meet(&mut self, equations: &dyn Equations, (laws, switches, k): Stand<'_>) -> Result<(), Refusal> {
        let number = Number::of(laws, switches);
        let Some(met) = &mut self.met else {
            self.present = number.index();
            return Ok(());
        };
        self.present = match met.get(&number) {
            Some(place) => *place,
            None => {
                let cell = cell(equations, self.motions, (switches, k))?;
                self.cells.push(Prepared::new(cell, equations, (laws, switches, k)));
                met.insert(number, self.cells.len() - 1);
                self.cells.len() - 1
            }
        };
        Ok(())
    }

    /// All cells, by their numbers; `None` if cells are computed when a run first enters them.
    pub fn all(&self) -> Option<&[Prepared]> {
        self.met.is_none().then_some(&self.cells)
    }

    /// The present cell.
    #[inline]
    pub fn here(&self) -> &Prepared {
        &self.cells[self.present]
    }
}

impl Prepared {
    /// A cell with the laws' participation and the exits of the switches.
    pub fn new(cell: Cell, equations: &dyn Equations, (laws, switches, k): Stand<'_>) -> Self {
        let (participation, on_speed) = laws.iter().map(|l| cell.follow(&l.surface.normal, None)).unzip();
        // In linear cells the deflections are linear in q, so the guards are the same at every q.
        let guards = Guards::of(equations, switches, &Vector::zeros(equations.coordinates()), k);
        let watch = |exit: &Exit| Watch::new(&cell, [exit.guard.on_q.clone(), exit.guard.on_speed.clone()]);
        let exits = guards.exits.iter().map(|exits| exits.iter().map(watch).collect()).collect();
        Prepared { participation, on_speed, guards: Arc::new(guards), exits, cell }
    }
}

/// The cell of switches and law values.
fn cell(equations: &dyn Equations, motions: usize, (switches, k): (&[Switch], &[f64])) -> Result<Cell, Refusal> {
    let matrices = matrices(equations, switches, k)?;
    Ok(Cell::of(&matrices)?.conserving(equations, &matrices, motions))
}

/// Puts laws and switches into the cell with this index.
fn stand(laws: &mut [LawState], switches: &mut [Switch], mut index: usize) {
    let mut digit = |base: usize| {
        let digit = index % base;
        index /= base;
        digit
    };
    laws.iter_mut().for_each(|law| law.cell = digit(law.pitch.cells()));
    switches.iter_mut().for_each(|switch| switch.mode = digit(switch.modes()));
}

/// Writes the law values at the coordinates `q` and the time `t` \[s\] into `k`: those of the laws, of the switches, and of the parameters
/// that vary.
#[inline]
pub fn write(
    (laws, switches, forcing): (&[LawState], &[Switch], Option<&Forcing>),
    (q, t): (&[f64], f64),
    k: &mut [f64],
) {
    let of_laws = &mut k[..laws.len()];
    for i in 0..laws.len() {
        of_laws[i] = laws[i].course(q[laws[i].phase], t)[0];
    }
    switches.iter().for_each(|switch| switch.write(k));
    if let Some(forcing) = forcing {
        forcing.write_shares(t, k);
    }
}

/// The same for laws that are constant within their cells.
fn write_levels((laws, switches): (&[LawState], &[Switch]), k: &mut [f64]) {
    let of_laws = &mut k[..laws.len()];
    for i in 0..laws.len() {
        of_laws[i] = laws[i].level();
    }
    switches.iter().for_each(|switch| switch.write(k));
}
