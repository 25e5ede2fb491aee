//! The cells of a train in double-double numbers, put together from those of its parts.

use nalgebra::{DMatrix, DVector};
use xprec::Df64;

use super::Elements;
use super::geometry::{self, Geometry};
use crate::engine::equations::{Affine, Deflection, ExactCells, Exit, Matrices};
use crate::scene::Scene;
use crate::train::{Part, Train};

/// The cells.
pub(super) struct Cells<'a> {
    train: &'a Train,
    /// The cells of each part, with R.
    parts: Vec<(Box<dyn ExactCells>, DMatrix<Df64>)>,
    /// For each law its part, and its number there.
    laws: Vec<[usize; 2]>,
    /// For each switch its part, and its number there.
    switches: Vec<[usize; 2]>,
}

impl<'a> Cells<'a> {
    /// The cells of a scene with these values of its parameters and mid values of its laws.
    pub fn new(elements: &Elements, scene: &'a Scene, parameters: Vec<Df64>, mids: Vec<Df64>) -> Self {
        let zero = Df64::from(0.0);
        let Some(train) = scene.train.as_ref() else { unreachable!("the scene of a train lists its parts") };
        let rows = Geometry::<Df64>::of(train, &parameters).rows;
        let of_part = |part: &Part| {
            let own: Vec<Df64> = part.parameters.iter().map(|i| i.map_or(zero, |i| parameters[i])).collect();
            let of_laws: Vec<Df64> = part.values[..part.laws].iter().map(|&i| mids[i]).collect();
            (elements.0[part.element].1.exactly)(&elements.effects(part, scene), &own, &of_laws)
        };
        let mut laws = vec![[0; 2]; train.counts[0]];
        for (i, part) in train.parts.iter().enumerate() {
            part.values[..part.laws].iter().enumerate().for_each(|(j, &law)| laws[law] = [i, j]);
        }
        let parts = train.parts.iter().map(of_part).zip(rows).collect();
        let of_switches = |(i, part): (usize, &Part)| (0..part.switches).map(move |j| [i, j]).collect::<Vec<_>>();
        Cells { train, parts, laws, switches: train.parts.iter().enumerate().flat_map(of_switches).collect() }
    }

    /// The values of the laws and symbols of a part.
    fn values(&self, part: usize, k: &[Df64]) -> Vec<Df64> {
        self.train.parts[part].values.iter().map(|&i| k[i]).collect()
    }

    /// The coordinates of a part.
    fn at(&self, part: usize, q: &[Df64]) -> DVector<Df64> {
        &self.parts[part].1 * DVector::from_column_slice(q)
    }

    /// Converts a gradient from the coordinates of a part to those of the train.
    fn spread(&self, part: usize, gradient: &DVector<Df64>) -> DVector<Df64> {
        self.parts[part].1.transpose() * gradient
    }
}

impl ExactCells for Cells<'_> {
    fn matrices(&self, k: &[Df64]) -> Matrices<Df64> {
        let zero = Df64::from(0.0);
        let n = self.train.coordinates.len();
        let square = || DMatrix::from_element(n, n, zero);
        let load = DVector::from_element(n, zero);
        let mut all =
            Matrices { mass: square(), mobility: None, damping: square(), stiffness: square(), load, at_zero: zero };
        for (i, (cells, rows)) in self.parts.iter().enumerate() {
            let of_part = cells.matrices(&self.values(i, k));
            geometry::add(&mut all.mass, &of_part.mass, rows);
            geometry::add(&mut all.damping, &of_part.damping, rows);
            geometry::add(&mut all.stiffness, &of_part.stiffness, rows);
            all.load += self.spread(i, &of_part.load);
            all.at_zero += of_part.at_zero;
        }
        all
    }

    fn potential(&self, q: &[Df64], k: &[Df64]) -> Df64 {
        let of = |(i, (cells, _)): (usize, &(Box<dyn ExactCells>, _))| {
            cells.potential(self.at(i, q).as_slice(), &self.values(i, k))
        };
        self.parts.iter().enumerate().map(of).fold(Df64::from(0.0), |sum, x| sum + x)
    }

    fn step(&self, law: usize, q: &[Df64], k: &[Df64], dk: Df64) -> Df64 {
        let [part, own] = self.laws[law];
        self.parts[part].0.step(own, self.at(part, q).as_slice(), &self.values(part, k), dk)
    }

    fn mode(&self, i: usize, mode: usize) -> Option<Vec<Df64>> {
        let [part, own] = self.switches[i];
        self.parts[part].0.mode(own, mode)
    }

    fn exits(&self, i: usize, mode: usize, k: &[Df64]) -> Vec<Exit<Df64>> {
        let [part, own] = self.switches[i];
        let exits = self.parts[part].0.exits(own, mode, &self.values(part, k));
        let laws = &self.train.parts[part].values;
        let affine = |of: Affine<Df64>| Affine {
            errors: of.errors.iter().map(|&(law, unit)| (laws[law], unit)).collect(),
            on_q: self.spread(part, &of.on_q),
            on_speed: self.spread(part, &of.on_speed),
            ..of
        };
        exits.into_iter().map(|exit| Exit { guard: affine(exit.guard), ..exit }).collect()
    }

    fn switched(&self, i: usize, k: &[Df64]) -> Deflection<Df64> {
        let [part, own] = self.switches[i];
        let of = self.parts[part].0.switched(own, &self.values(part, k));
        let laws = &self.train.parts[part].values;
        let errors = of.errors.iter().map(|&(law, unit)| (laws[law], unit)).collect();
        Deflection { normal: self.spread(part, &of.normal), errors, ..of }
    }
}
