//! The modes of every cell: every combination of the levels of the stiffnesses, worked out once.

use nalgebra::SVector;

use crate::engine::cell::Cell;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::law::Law;

/// The cells of a scene.
#[derive(Debug, Clone)]
pub struct Cells<const N: usize> {
    cells: Vec<Prepared<N>>,
}

/// A cell, and how its modes take part in the phase of each law.
#[derive(Debug, Clone)]
pub struct Prepared<const N: usize> {
    /// Its modes.
    pub cell: Cell<N>,
    /// n.X of each law.
    pub participation: Vec<SVector<f64, N>>,
    /// n.Y of each law, where damping couples the modes: how the phase follows their speeds.
    pub on_speed: Vec<Option<SVector<f64, N>>>,
}

/// More cells than this are refused: their modes would take minutes and gigabytes.
const MOST: usize = 1 << 16;

impl<const N: usize> Cells<N> {
    /// All cells of `laws`.
    ///
    /// # Errors
    /// Where one of them has no modes, or there are too many.
    pub fn new(equations: &dyn Equations<N>, laws: &[Law<N>]) -> Result<Self, Refusal> {
        let count = laws.iter().map(|l| l.pitch.cells()).fold(1, usize::saturating_mul);
        if count > MOST {
            return Err(Refusal::Cells { cells: count, most: MOST });
        }
        let prepare = |index| Ok(Prepared::new(Cell::new(equations, &levels(laws, index))?, laws));
        Ok(Cells { cells: (0..count).map(prepare).collect::<Result<_, _>>()? })
    }

    /// All of them, by their numbers.
    pub fn all(&self) -> &[Prepared<N>] {
        &self.cells
    }

    /// The cell in which the laws stand.
    #[inline]
    pub fn at(&self, laws: &[Law<N>]) -> &Prepared<N> {
        &self.cells[index(laws)]
    }
}

impl<const N: usize> Prepared<N> {
    /// A cell with the laws' participation.
    pub fn new(cell: Cell<N>, laws: &[Law<N>]) -> Self {
        let (participation, on_speed) = laws.iter().map(|l| cell.follow(&l.surface.normal, None)).unzip();
        Prepared { cell, participation, on_speed }
    }
}

/// The number of the cell in which the laws stand: the first law's counts fastest.
#[inline]
pub fn index<const N: usize>(laws: &[Law<N>]) -> usize {
    laws.iter().rev().fold(0, |index, law| index * law.pitch.cells() + law.cell)
}

/// The law values in a cell, by its number.
pub fn levels<const N: usize>(laws: &[Law<N>], mut index: usize) -> Vec<f64> {
    let level = |law: &Law<N>| {
        let place = index % law.pitch.cells();
        index /= law.pitch.cells();
        law.pitch.level(place)
    };
    laws.iter().map(level).collect()
}
