//! The end of a run in all its digits.

use gearsim::__private::{Hybrid, Inside, State};
use gearsim::scene::{Precision, Scene};
use gearsim_tests::precise::number::{Real, Scalar};

use crate::common::{self, model};

/// Numbers of 50 digits.
pub type Digits = Real<192>;

pub fn exact(x: f64) -> Digits {
    Digits::exact(x)
}

/// pi, by Newton's method for the zero of the sine.
pub fn pi() -> Digits {
    (0..3).fold(exact(std::f64::consts::PI), |pi, _| {
        let (sine, _) = pi.sine_cosine();
        pi + sine
    })
}

/// The largest whole number that is not above x.
pub fn floor(x: &Digits) -> f64 {
    let near = x.approx().round();
    if (x.clone() - exact(near)).is_negative() { near - 1.0 } else { near }
}

/// Coordinates and speeds of a state.
pub fn of(state: &State) -> [Vec<Digits>; 2] {
    let wide = |x: &[f64], low: &[f64]| {
        x.iter().enumerate().map(|(i, x)| exact(*x) + exact(low.get(i).copied().unwrap_or(0.0))).collect()
    };
    [wide(&state.q, &state.low), wide(&state.q_dot, &state.lost)]
}

/// Runs `scene` in plain and in compensated precision. Returns what `judge` gives at the end of each run, in this order.
pub fn in_both(scene: &Scene, mut judge: impl FnMut(&Hybrid<'_>) -> f64) -> [f64; 2] {
    [Precision::Plain, Precision::Compensated].map(|precision| {
        let mut scene = scene.clone();
        scene.solver.precision = precision;
        let entry = model(scene.model.name);
        let equations = entry.equations(&scene).unwrap();
        let mut simulation = entry.simulation(&scene, &*equations).unwrap_or_else(|refusal| panic!("{refusal}"));
        simulation.run(None, &mut |_| {}).unwrap_or_else(|stop| panic!("{stop}"));
        judge(&simulation.now)
    })
}

/// The scene of a file with other values.
pub fn scene(name: &str, set: &[&str]) -> Scene {
    common::scene(name, &set.iter().map(|set| set.to_string()).collect::<Vec<_>>())
}

/// |a - b| / size.
pub fn apart(a: &Digits, b: &Digits, size: f64) -> f64 {
    (a.clone() - b.clone()).approx().abs() / size
}

/// Checks the relative errors of both precisions: below 1e-14 `lost` in plain and below 1e-30 `lost` in compensated precision.
pub fn judge(what: &str, [plain, compensated]: [f64; 2], lost: f64) {
    println!("{what}: plain {plain:.1e}, compensated {compensated:.1e}");
    assert!(plain < 1e-14 * lost, "{what}: plain {plain:.1e}");
    assert!(compensated < 1e-30 * lost, "{what}: compensated {compensated:.1e}");
}
