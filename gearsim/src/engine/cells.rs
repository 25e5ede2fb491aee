//! The modes of every cell: every combination of the levels of the laws and the regimes of the dead bands, worked
//! out once, where there are many not before it is met.

use std::collections::HashMap;

use smallvec::SmallVec;

use crate::engine::cell::Cell;
use crate::engine::dead_band::{DeadBand, Elastic, REGIMES};
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::law::Law;
use crate::engine::vector::Vector;
use crate::engine::watch::Watch;
use crate::tolerance::events::CELLS_IN_ADVANCE;

/// The cells of a scene.
#[derive(Debug, Clone)]
pub struct Cells {
    cells: Vec<Prepared>,
    /// Where each combination met so far stands; `None` where all of them stand in their order.
    met: Option<HashMap<usize, usize>>,
    /// Where the present one stands.
    present: usize,
    /// Rigid motions of the model.
    motions: usize,
}

/// A cell, and what is watched in it.
#[derive(Debug, Clone)]
pub struct Prepared {
    /// Its modes.
    pub cell: Cell,
    /// n.X of each law: how its modes take part in the phase.
    pub participation: Vec<Vector>,
    /// n.Y of each law, where damping couples the modes: how the phase follows their speeds.
    pub on_speed: Vec<Option<Vector>>,
    /// Spring and damper of the contact of each dead band.
    pub elastic: Vec<Elastic>,
    /// How the modes take part in each exit of each dead band.
    pub exits: Vec<SmallVec<[Watch; 2]>>,
}

/// What cells are combinations of.
pub type Stand<'a> = (&'a [Law], &'a [DeadBand], &'a [f64]);

impl Cells {
    /// The cells of laws and dead bands, whose values are `k`, of equations with so many rigid `motions`.
    ///
    /// # Errors
    /// Where one of them has no modes.
    pub fn new(equations: &dyn Equations, motions: usize, (laws, bands, k): Stand<'_>) -> Result<Self, Refusal> {
        let count = laws.iter().map(|l| l.pitch.cells()).chain(bands.iter().map(|_| REGIMES.len()));
        let count = count.fold(1, usize::saturating_mul);
        if count > CELLS_IN_ADVANCE {
            let mut cells = Cells { cells: vec![], met: Some(HashMap::new()), present: 0, motions };
            cells.meet(equations, (laws, bands, k))?;
            return Ok(cells);
        }
        let prepare = |i| {
            let (mut laws, mut bands) = (laws.to_vec(), bands.to_vec());
            stand(&mut laws, &mut bands, i);
            let mut k = k.to_vec();
            write_levels((&laws, &mut bands), &mut k);
            let cell = Cell::new(equations, &k)?.conserving(equations, &k, motions);
            Ok(Prepared::new(cell, equations, (&laws, &bands, &k)))
        };
        let cells = (0..count).map(prepare).collect::<Result<_, _>>()?;
        Ok(Cells { cells, met: None, present: index(laws, bands), motions })
    }

    /// Makes the cell in which laws and dead bands stand the present one; works it out, if that is still to be done.
    ///
    /// # Errors
    /// Where it has no modes.
    #[inline]
    pub fn meet(&mut self, equations: &dyn Equations, (laws, bands, k): Stand<'_>) -> Result<(), Refusal> {
        self.present = index(laws, bands);
        let Some(met) = &mut self.met else { return Ok(()) };
        self.present = match met.get(&self.present) {
            Some(place) => *place,
            None => {
                let cell = Cell::new(equations, k)?.conserving(equations, k, self.motions);
                self.cells.push(Prepared::new(cell, equations, (laws, bands, k)));
                met.insert(self.present, self.cells.len() - 1);
                self.cells.len() - 1
            }
        };
        Ok(())
    }

    /// All of them, by their numbers; `None` where they are worked out as they are met.
    pub fn all(&self) -> Option<&[Prepared]> {
        self.met.is_none().then_some(&self.cells)
    }

    /// The present one.
    #[inline]
    pub fn here(&self) -> &Prepared {
        &self.cells[self.present]
    }
}

impl Prepared {
    /// A cell with the laws' participation and the exits of the dead bands.
    pub fn new(cell: Cell, equations: &dyn Equations, (laws, bands, k): Stand<'_>) -> Self {
        let (participation, on_speed) = laws.iter().map(|l| cell.follow(&l.surface.normal, None)).unzip();
        let elastic: Vec<Elastic> = bands.iter().map(|band| band.elastic(equations, k)).collect();
        let watches = |(band, elastic): (&DeadBand, &Elastic)| {
            band.exits(*elastic).into_iter().map(|exit| Watch::new(&cell, exit.slopes(band))).collect()
        };
        let exits = bands.iter().zip(&elastic).map(watches).collect();
        Prepared { participation, on_speed, elastic, exits, cell }
    }
}

/// The number of the cell in which laws and dead bands stand: the first law's counts fastest.
#[inline]
pub fn index(laws: &[Law], bands: &[DeadBand]) -> usize {
    let of_bands = bands.iter().rev().fold(0, |index, band| index * REGIMES.len() + band.place());
    laws.iter().rev().fold(of_bands, |index, law| index * law.pitch.cells() + law.cell)
}

/// Has laws and dead bands stand in the cell of a number.
fn stand(laws: &mut [Law], bands: &mut [DeadBand], mut index: usize) {
    let mut digit = |base: usize| {
        let digit = index % base;
        index /= base;
        digit
    };
    laws.iter_mut().for_each(|law| law.cell = digit(law.pitch.cells()));
    bands.iter_mut().for_each(|band| band.regime = REGIMES[digit(REGIMES.len())]);
}

/// Writes the law values at the coordinates `q` and the time `t` \[s\], and those of the dead bands, which follow them, to where
/// they belong in `k`.
#[inline]
pub fn write((laws, bands): (&[Law], &mut [DeadBand]), (q, t): (&[f64], f64), k: &mut [f64]) {
    k.iter_mut().zip(laws).for_each(|(k, law)| *k = law.course(q[law.phase], t)[0]);
    follow(bands, k);
}

/// The same of laws that are constant within their cells.
fn write_levels((laws, bands): (&[Law], &mut [DeadBand]), k: &mut [f64]) {
    k.iter_mut().zip(laws).for_each(|(k, law)| *k = law.level());
    follow(bands, k);
}

/// Writes the values of dead bands, which follow the laws, to where they belong in `k`.
#[inline]
fn follow(bands: &mut [DeadBand], k: &mut [f64]) {
    for band in bands {
        band.follow(k);
        band.write(k);
    }
}

/// Moves the edges of dead bands with steps of transmission errors, at the coordinates `q` and the time `t` \[s\]. Returns how
/// many flanks have met.
pub fn displace((laws, bands): (&[Law], &mut [DeadBand]), (q, t): (&[f64], f64), k: &mut [f64]) -> u64 {
    k.iter_mut().zip(laws).for_each(|(k, law)| *k = law.course(q[law.phase], t)[0]);
    bands.iter_mut().map(|band| u64::from(band.displace(k, q))).sum()
}

/// The law values in a cell without dead bands, by its number; `rest` stand behind those of the laws.
pub fn levels(laws: &[Law], index: usize, rest: &[f64]) -> Vec<f64> {
    let (mut laws, mut k) = (laws.to_vec(), [&vec![0.0; laws.len()], rest].concat());
    stand(&mut laws, &mut [], index);
    write_levels((&laws, &mut []), &mut k);
    k
}
