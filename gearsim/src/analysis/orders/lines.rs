//! The lines that a drivetrain is expected to have: mesh orders and their sidebands.

use super::{Orders, Turning};
use crate::trajectory::Trajectory;

/// Multiples of a mesh order that are listed.
const HARMONICS: usize = 4;
/// Sidebands on either side of a mesh order that are listed.
const SIDEBANDS: i32 = 3;

/// A line of an order spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The law of the mesh, by its name.
    pub mesh: &'static str,
    /// The multiple of the mesh order.
    pub harmonic: usize,
    /// The sideband: so many orders of the shaft above the multiple.
    pub sideband: i32,
    /// Its order.
    pub order: f64,
    /// Its frequency at the mean speed of the shaft \[Hz\].
    pub frequency: f64,
    /// Its peak amplitude [unit of the signal].
    pub amplitude: f64,
}

/// The mesh orders of a run: the first law of each phase that rolls, and the pitches per revolution of the shaft.
pub fn mesh_orders(run: &Trajectory, turning: &Turning) -> Vec<(&'static str, f64)> {
    let (first, last) = (turning.rows[0], turning.rows[turning.rows.len() - 1]);
    let revolutions = turning.angle[turning.angle.len() - 1];
    let mut orders: Vec<(&'static str, f64)> = vec![];
    let mut phases = vec![];
    for law in run.model.laws.iter().filter(|law| law.with.is_none()) {
        let Some(i) = run.model.coordinates.iter().position(|c| c.name == law.phase) else { continue };
        if !phases.contains(&law.phase) {
            phases.push(law.phase);
            orders.push((law.name, ((run.q[i][last] - run.q[i][first]) / law.period / revolutions).abs()));
        }
    }
    orders
}

/// The mesh orders and sidebands in a spectrum of a run, as far as it reaches.
pub fn lines(run: &Trajectory, turning: &Turning, spectrum: &Orders) -> Vec<Line> {
    let duration = (turning.rows.len() - 1) as f64 / turning.rate;
    let shaft = turning.angle[turning.angle.len() - 1] / duration;
    let mut all = vec![];
    for (mesh, base) in mesh_orders(run, turning) {
        for harmonic in 1..=HARMONICS {
            for sideband in -SIDEBANDS..=SIDEBANDS {
                let order = harmonic as f64 * base + f64::from(sideband);
                if let Some(amplitude) = spectrum.at(order).filter(|_| order > 0.0) {
                    all.push(Line { mesh, harmonic, sideband, order, frequency: order * shaft, amplitude });
                }
            }
        }
    }
    all
}
