//! A random place in the state space of a scene: coordinates, speeds, values and slopes of the laws, and a mode of each switch.

use gearsim::__private::equations::{Equations, Switching};
use gearsim::Scene;

/// Usual size of an angle [rad] and of a displacement [m], and of their rates.
const SIZES: [(&str, f64, f64); 2] = [("rad", 0.1, 50.0), ("m", 1e-3, 1.0)];

pub struct Place {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    /// Usual sizes of the coordinates and of the speeds.
    pub lengths: Vec<f64>,
    pub speeds: Vec<f64>,
    /// Values of the laws and of the symbols of switches.
    pub k: Vec<f64>,
    pub dk: Vec<f64>,
    pub ddk: Vec<f64>,
    /// The gradients of the phases on which the laws depend, zero where they depend on time or are constant.
    phases: Vec<Vec<f64>>,
}

impl Place {
    /// The place number `i`. A switch with n modes is in mode `i` modulo n.
    pub fn new(scene: &Scene, equations: &dyn Equations, i: usize) -> Self {
        let model = scene.model;
        let mut seed = 0x9e37_79b9_7f4a_7c15u64.wrapping_mul(i as u64 + 11);
        let mut random = || {
            // xorshift64
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        let size = |unit: &str| SIZES.iter().find(|(name, ..)| *name == unit).expect("rad or m");
        let lengths: Vec<f64> = model.coordinates.iter().map(|c| size(c.unit).1).collect();
        let speeds: Vec<f64> = model.coordinates.iter().map(|c| size(c.unit).2).collect();
        let q = lengths.iter().map(|size| size * random()).collect();
        let v = speeds.iter().map(|size| size * random()).collect();
        let present = scene.present().count();
        let (mut k, mut dk, mut ddk, mut phases) = (vec![], vec![], vec![], vec![]);
        for (law, (of, profile)) in model.laws.iter().zip(&scene.laws).enumerate() {
            let has = law < present && scene.effects.activate(of.with, model);
            let (low, high) = if has { profile.extremes() } else { (0.0, 0.0) };
            let size = 0.5 * (low.abs() + high.abs());
            k.push(if has { low + (high - low) * 0.5 * (1.0 + random()) } else { 0.0 });
            let switches = has && matches!(equations.switching(law), Switching::WithJump | Switching::WithoutJump);
            dk.push(if has { size / of.period * random() } else { 0.0 });
            ddk.push(if has { size / of.period.powi(2) * random() } else { 0.0 });
            phases.push(if switches { equations.normal(law).to_vec() } else { vec![0.0; model.coordinates.len()] });
        }
        let mut k = model.in_contact(k);
        let mut at = model.laws.len();
        for (which, switch) in model.switches.iter().enumerate() {
            if let Some(values) = equations.mode(which, i % switch.modes.len()) {
                k[at..at + values.len()].copy_from_slice(&values);
            }
            at += switch.neutral.len();
        }
        Place { q, v, lengths, speeds, k, dk, ddk, phases }
    }

    /// The values of laws and switches, and the slopes of the laws, at the coordinates `q`: the laws are parabolas of their phases.
    pub fn laws_at(&self, q: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (mut k, mut dk) = (self.k.clone(), self.dk.clone());
        for (law, phase) in self.phases.iter().enumerate() {
            let s: f64 = phase.iter().zip(q).zip(&self.q).map(|((n, q), own)| n * (q - own)).sum();
            k[law] += (self.dk[law] + 0.5 * self.ddk[law] * s) * s;
            dk[law] += self.ddk[law] * s;
        }
        (k, dk)
    }
}
