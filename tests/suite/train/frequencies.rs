//! Natural frequencies in closed form: uniform chains, free and grounded.

use std::f64::consts::{PI, TAU};

use gearsim::__private::{Cell, Inside};
use gearsim::scene::Scene;

use crate::common;

/// A chain of `n` equal discs, with `extra` tables.
fn chain(n: usize, extra: &str) -> Scene {
    let mut text = String::from("model = \"train\"\neffects = []\n[run]\nt_end = \"1 ms\"\n[rotors]\n");
    for i in 1..=n {
        text += &format!("{i} = \"0.02 kg*m^2\"\n");
    }
    for i in 1..n {
        text += &format!("[shafts.{i}]\nbetween = [\"{i}\", \"{}\"]\nstiffness = \"5 kN*m/rad\"\n", i + 1);
    }
    text += extra;
    Scene::parse("chain", "chain.toml", &text, &[], &common::models())
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render(100, false)))
}

/// Natural frequencies [Hz], rising.
fn frequencies(scene: &Scene) -> Vec<f64> {
    let equations = common::model("train").equations(scene).expect("sound effects");
    let cell = Cell::new(&*equations, &scene.model.in_contact([])).expect("a linear cell");
    let mut all: Vec<f64> = cell.modes.iter().map(|mode| mode.omega2.max(0.0).sqrt() / TAU).collect();
    all.sort_by(f64::total_cmp);
    all
}

fn compare(found: &[f64], expected: impl Fn(usize) -> f64) {
    let root = (5e3f64 / 0.02).sqrt() / TAU;
    for (i, found) in found.iter().enumerate() {
        let expected = 2.0 * root * expected(i).sin();
        let off = (found - expected).abs() / (2.0 * root);
        assert!(off < 1e-13 + 1e-9 * f64::from(u8::from(i == 0)), "mode {i}: {found}, not {expected}");
    }
}

/// omega_i = 2 sqrt(k/I) sin(i pi/(2 n)), i = 0, ..., n - 1.
#[test]
fn a_free_chain_of_64_discs() {
    let scene = chain(64, "");
    assert_eq!(scene.model.coordinates.len(), 64);
    compare(&frequencies(&scene), |i| PI * i as f64 / 128.0);
}

/// A chain grounded at its first disc: omega_i = 2 sqrt(k/I) sin((2 i + 1) pi/(2 (2 n + 1))).
#[test]
fn a_chain_with_a_grounded_end() {
    let ground = "[supports.g]\nrotor = \"1\"\nstiffness = \"5 kN*m/rad\"\n";
    compare(&frequencies(&chain(20, ground)), |i| PI * (2 * i + 1) as f64 / 82.0);
}

/// Grounded at both ends, once by a shaft to the ground: omega_i = 2 sqrt(k/I) sin((i + 1) pi/(2 (n + 1))).
#[test]
fn a_chain_between_two_grounds() {
    let ground = "[supports.g]\nrotor = \"1\"\nstiffness = \"5 kN*m/rad\"\n\
                  [shafts.end]\nbetween = [\"20\", \"ground\"]\nstiffness = \"5 kN*m/rad\"\n";
    compare(&frequencies(&chain(20, ground)), |i| PI * (i + 1) as f64 / 42.0);
}
