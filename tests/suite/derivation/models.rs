//! The models made of components: snapshots of their equations, and what is proved about them.

use gearsim_derive::{Expr, Model, Range, Start, derive, half};
use gearsim_models::components::mesh_stiffness;
use gearsim_models::{ELEMENTS, MODELS};

use crate::slips::oscillator;

fn model(name: &str) -> Model {
    let (name, describe) = MODELS.iter().find(|m| m.0 == name).unwrap_or_else(|| panic!("no model {name}"));
    Model::new(name, describe)
}

pub fn equations_match_the_snapshots() {
    for name in ["idler", "gear_pair_bearings", "planar_planetary_3"] {
        insta::assert_snapshot!(name, derive(&model(name)).unwrap_or_else(|slip| panic!("{slip}")).text());
    }
}

/// The models whose inertia depends on the coordinates: their cells are not linear.
const MOVING: [&str; 2] = ["crank_drive", "cardan_drive"];

/// Models for which the proof cannot decide. M contains the square of a distance divided by cos(alpha), and the proof cannot show that
/// this is not zero.
const UNDECIDED: [&str; 1] = ["element_planets"];

/// The mass matrix of every model but [`UNDECIDED`] is proved positive definite for all parameters, so no scene's numbers need a check. No model
/// of constant inertia has nonlinear terms without effects.
pub fn every_mass_matrix_is_proved_positive_definite() {
    for (name, describe) in MODELS.iter().chain(ELEMENTS) {
        let model = Model::new(name, describe);
        let derivation = derive(&model).unwrap_or_else(|slip| panic!("{slip}"));
        let proved = derivation.proofs().iter().filter(|proof| proof.starts_with("M is positive definite"));
        let [proof] = &proved.collect::<Vec<_>>()[..] else {
            panic!("{name}: not exactly one proof that M is positive definite")
        };
        assert_eq!(proof.contains("not decided"), UNDECIDED.contains(name), "{name}: {proof}");
        let terms = derivation.nonlinear_terms();
        let expected: &[&str] = if MOVING.contains(name) { &["M(theta, s) in the kinetic energy"] } else { &[] };
        assert_eq!(terms, expected, "{name}");
    }
}

/// A model with `m.deflection(...)` and the same model with the deflection written out have the same equations.
pub fn a_named_deflection_gives_the_same_equations() {
    let describe = |m: &mut Model, name: &dyn Fn(&mut Model, Expr) -> Expr| {
        let [mass, r, s, c] = ["m", "r", "s", "c"].map(|name| m.parameter(name, "1", None, Range::Positive, ""));
        let q = ["x", "y", "z"].map(|name| m.coordinate(name, "1", Start::At(0.0), ""));
        q.iter().for_each(|q| m.kinetic(half(mass * q.dot().sq())));
        let k = mesh_stiffness(m, "k", "1", q[0], 1.0, "");
        let delta = name(m, q[0] - r * q[1] + q[2] / r);
        m.potential(half(k.value * delta.sq()));
        m.potential(half(s * q[2].sq()));
        m.dissipation(half(c * delta.dot().sq()));
    };
    let named = Model::new("named", |m| describe(m, &|m, delta| m.deflection("delta", delta)));
    let written = Model::new("written", |m| describe(m, &|_, delta| delta));
    let (named, written) = (derive(&named).expect("sound"), derive(&written).expect("sound"));
    for i in 0..3 {
        let (a, b) = (named.equation(i, &[]), written.equation(i, &[]));
        assert!((a - b).is_zero(), "row {i}: {a}\nwritten out: {b}");
    }
    assert!(named.file().contains("deflections {") && !written.file().contains("deflections {"));
}

/// T, V, D and torques may contain the mid value of a stiffness; the generated code has it by name.
pub fn energies_may_contain_mid_values() {
    let model = Model::new("train", |m| {
        let o = oscillator(m);
        let k = mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.kinetic(k.mid * o.x.dot().sq());
        m.potential(k.mid * o.x.sq());
        m.dissipation(k.mid * o.x.dot().sq());
        m.torque("pull", k.mid, o.x, "");
    });
    let file = derive(&model).unwrap_or_else(|slip| panic!("{slip}")).file();
    for said in ["k_mid*x.powi(2)", "k_mid*x_dot.powi(2)", "=> k_mid*x;"] {
        assert!(file.contains(said), "{said} is missing: {file}");
    }
}
