//! The inertias of a scene: the moments of inertia and the masses among its parameters. M is linear in each of them.
//!
//! T is the sum of the energies of the parts. The energy of a part is half its inertia times a sum of squared speeds. The part of M that
//! comes from an inertia is therefore positive semidefinite, and its share of the kinetic energy is between 0 and 1. (Coordinates have no
//! such shares: if the inertia couples coordinates, Re(conj(phi_i) (M phi)_i) may be negative for one coordinate and larger than the whole
//! energy for another.)

mod pieces;

use nalgebra::{Complex, DMatrix, DVector};

use super::linear::{multiple, part};
use crate::engine::Refusal;
use crate::engine::system::System;
use crate::engine::vector::Vector;
use crate::run::Entry;
use crate::scene::Scene;

/// The units of inertias.
const UNITS: [&str; 2] = ["kg*m^2", "kg"];

/// A moment of inertia or a mass, or all with the same parameter.
#[derive(Debug, Clone)]
pub struct Mass {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its part of M (n x n).
    pub inertia: DMatrix<f64>,
    /// Momentum of the part in the first rigid motion (n). If the part is at rest in that motion, its momentum in a motion of the
    /// coordinate with its largest inertia. The product with a mode shape has the sign of the part's motion.
    pub sense: DVector<f64>,
    /// The pieces that it consists of, such as the planets of a set; empty if it is one body.
    pub pieces: Vec<Piece>,
}

/// A piece of an inertia.
#[derive(Debug, Clone)]
pub struct Piece {
    /// The first coordinate that belongs to this piece alone.
    pub coordinate: &'static str,
    /// Its part of M (n x n).
    pub inertia: DMatrix<f64>,
    /// Its momentum, as [`Mass::sense`].
    pub sense: DVector<f64>,
}

/// The inertias of `scene` in the order of its parameters. M is evaluated at the coordinates about which `system` is linearised. `watch` is
/// called for each parameter.
///
/// # Errors
/// Those of the equations of the scene.
pub fn of(scene: &Scene, entry: &Entry, system: &System, watch: &dyn Fn()) -> Result<Vec<Mass>, Refusal> {
    let place = system.steady().map_or_else(|| Vector::zeros(scene.model.coordinates.len()), |about| about.q.clone());
    let mass = |scene: &Scene| Ok(entry.equations(scene)?.mass(&place));
    let rigid = (!scene.model.motions.is_empty()).then(|| DVector::from_column_slice(&system.motion(0)));
    let once = mass(scene)?;
    let mut masses = vec![];
    for (i, parameter) in scene.model.parameters.iter().enumerate() {
        let is_active = scene.effects.activate(parameter.with, scene.model);
        if scene.parameters[i] == 0.0 || !is_active || !UNITS.contains(&parameter.unit) {
            continue;
        }
        watch();
        let [twice, thrice] = [2.0, 3.0].map(|times| multiple(scene, (i, times), &mass));
        let Some((twice, thrice)) = twice.zip(thrice) else { continue };
        if let Some((inertia, _)) = part([&once, &twice, &thrice])
            && inertia.amax() > 0.0
        {
            let sense = |inertia: &DMatrix<f64>| sense(inertia, rigid.as_ref());
            let piece = |(own, inertia): pieces::InertiaPart| Piece {
                coordinate: scene.model.coordinates[own].name,
                sense: sense(&inertia),
                inertia,
            };
            let pieces = pieces::of(&inertia).into_iter().map(piece).collect();
            masses.push(Mass { name: parameter.name, sense: sense(&inertia), inertia, pieces });
        }
    }
    Ok(masses)
}

/// A body with a share in the kinetic energy of a mode: a mass that is one body, or a piece of a mass.
#[derive(Debug, Clone, Copy)]
pub struct Body<'a> {
    /// Index of the mass.
    pub mass: usize,
    /// Name of its parameter.
    pub name: &'static str,
    /// For a piece, the first coordinate that belongs to it alone.
    pub coordinate: Option<&'static str>,
    inertia: &'a DMatrix<f64>,
    sense: &'a DVector<f64>,
}

/// The bodies of `masses`.
pub fn bodies(masses: &[Mass]) -> Vec<Body<'_>> {
    let mut all = vec![];
    for (i, mass) in masses.iter().enumerate() {
        let body = |coordinate, inertia, sense| Body { mass: i, name: mass.name, coordinate, inertia, sense };
        match &mass.pieces[..] {
            [] => all.push(body(None, &mass.inertia, &mass.sense)),
            pieces => all.extend(pieces.iter().map(|p| body(Some(p.coordinate), &p.inertia, &p.sense))),
        }
    }
    all
}

impl Body<'_> {
    /// The share of the body in the kinetic energy of a mode with this shape, with the sign of the body's motion. `of_mass` is the share of
    /// its whole mass.
    pub fn share(&self, shape: &[Complex<f64>], of_mass: f64, mass: &Mass) -> f64 {
        let shape = DVector::from_column_slice(shape);
        let energy = |a: &DMatrix<f64>| shape.dotc(&(a.map(Complex::from) * &shape)).re;
        let along: f64 = self.sense.iter().zip(&shape).map(|(sense, x)| sense * x.re).sum();
        let part = if self.coordinate.is_none() { 1.0 } else { energy(self.inertia) / energy(&mass.inertia) };
        let share = if of_mass == 0.0 { 0.0 } else { of_mass * part };
        if along < 0.0 { -share } else { share }
    }
}

fn sense(inertia: &DMatrix<f64>, rigid: Option<&DVector<f64>>) -> DVector<f64> {
    let along = rigid.map(|rigid| inertia * rigid).filter(|along| along.amax() > 0.0);
    along.unwrap_or_else(|| inertia.column(inertia.diagonal().imax()).into_owned())
}
