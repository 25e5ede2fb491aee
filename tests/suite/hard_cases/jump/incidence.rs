//! Near-critical incidence on a step, and the speed after the step in 115 digits.

use gearsim_tests::oh2005::GearPair;
use gearsim_tests::precise::number::{Real, Scalar};

use crate::noise::Noise;

pub type Digits = Real<384>;

/// A step met by the paper's gear pair: phi, the step of k, and the speeds. theta'², for either sign of theta', is (1 + depth) times its
/// critical value.
pub struct Incidence {
    pub phi: f64,
    pub dk: f64,
    pub v: [f64; 2],
    pub depth: f64,
}

/// A hundred incidences of each depth from 1e-1 to 1e-14, of either sign.
pub fn incidences(seed: u64) -> impl Iterator<Item = Incidence> {
    let (mut noise, m2) = (Noise::new(seed), GearPair::paper(0.0, 0.0).m2());
    let depths = (1..=14).flat_map(|k| [1.0, -1.0].map(|sign| sign * 10f64.powi(-k)));
    let depths: Vec<f64> = depths.flat_map(|depth| [depth; 100]).collect();
    depths.into_iter().map(move |depth| {
        let (phi, dk) = (noise.even() * 0.1, noise.power(0.0, 5.0));
        let v = (m2 * dk * phi * phi * (1.0 + depth)).sqrt().copysign(noise.even());
        Incidence { phi, dk, v: [v, noise.even() * v], depth }
    })
}

/// theta'+² in multiple precision.
pub fn square(i: &Incidence) -> Digits {
    let (p, real) = (GearPair::paper(0.0, 0.0), Digits::exact);
    let part = |n: f64, inertia: f64| real(n) * real(n) / real(inertia);
    let m2 = (part(p.n1, p.i1) + part(p.n2, p.i2)).scaled(-1);
    real(i.v[0]) * real(i.v[0]) - m2 * real(i.dk) * real(i.phi) * real(i.phi)
}
