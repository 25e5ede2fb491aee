//! Small models that a new author might write: those that `tests/suite/newcomer.rs` runs, one with nonlinear cells, one with a
//! torque that depends on a speed, one of three rotors.

use std::path::Path;

use gearsim_derive::{Home, Model, Range, Start, derive, half};
use gearsim_models::components::mesh_stiffness;

use crate::files::first_difference;

#[path = "../newcomer/cracked.rs"]
mod cracked;
#[path = "../newcomer/model.rs"]
mod model;
#[path = "../newcomer/moving.rs"]
mod moving;
#[path = "../../../gearsim/src/cli/new/template/energies/src/my_axle.rs"]
mod my_axle;
#[path = "../newcomer/well.rs"]
mod well;

/// Environment variable; if it is set, the files are written before they are compared.
const ACCEPT: &str = "GEARSIM_ACCEPT";

/// The files that `tests/suite/newcomer.rs` expands and runs equal a new derivation.
pub fn files_are_current() {
    let models: [gearsim_models::Entry; 6] = [
        ("spring_rotor", model::spring_rotor),
        ("cracked_rotor", cracked::cracked_rotor),
        ("double_well", well::double_well),
        ("pendulum", moving::pendulum),
        ("double_pendulum", moving::double_pendulum),
        ("linkage", moving::linkage),
    ];
    for (name, describe) in models {
        compare(name, describe, "suite/newcomer", Home::default());
    }
}

/// The derived files of the crate that `gearsim new` writes equal a new derivation.
pub fn files_of_a_new_crate_are_current() {
    let home = Home { energies: "energies/src", command: "cargo derive" };
    compare("my_axle", my_axle::my_axle, "../gearsim/src/cli/new/template/src/generated", home);
}

/// Compares the files of a model in a folder with a new derivation.
fn compare(name: &'static str, describe: fn(&mut Model), folder: &str, home: Home<'_>) {
    let files = derive(&Model::new(name, describe)).expect("the model is sound").files(home);
    for (file, derived) in files {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder).join(&file);
        if std::env::var_os(ACCEPT).is_some() {
            path.parent().map_or(Ok(()), std::fs::create_dir_all).expect("its folder can be made");
            std::fs::write(&path, &derived).expect("the file can be written");
        }
        let committed = std::fs::read_to_string(&path).unwrap_or_default();
        if let Some((line, (a, b))) = first_difference(&derived, &committed) {
            panic!(
                "{folder}/{file}, line {line}, derived:\n{a}\ncommitted:\n{b}\n\
                 Mend with: {ACCEPT}=1 cargo test --workspace --test derivation"
            );
        }
    }
}

/// For a model with nonlinear cells the derivation names the nonlinear terms and their energies. The proofs hold as well.
pub fn nonlinear_terms_are_reported() {
    let model = Model::new("pendulum", |m| {
        let [mass, l, g, s] = ["m", "l", "g", "s"].map(|name| m.parameter(name, "1", None, Range::Positive, ""));
        let x = m.coordinate("x", "rad", Start::At(0.1), "angle");
        let psi = m.coordinate("psi", "rad", Start::At(0.0), "angle of the wheel that switches");
        m.kinetic(half(mass * l.sq() * x.dot().sq()));
        m.kinetic(half(s * psi.dot().sq()));
        let k = mesh_stiffness(m, "k", "N*m", psi, 1.0, "");
        m.potential(half(k.value * x.sq()));
        m.potential(s * x.pow(4));
        m.potential(-mass * g * l * gearsim_derive::Expr::function("cos", x));
    });
    let d = derive(&model).expect("a nonlinear model is allowed");
    let mut terms = d.nonlinear_terms().to_vec();
    terms.sort();
    assert_eq!(terms, ["-g*l*m*cos(x) in the potential energy", "s*x^4 in the potential energy"]);
    assert!(d.text().contains("nonlinear: s*x^4 in the potential energy"), "{}", d.text());
    assert!(d.file().contains("nonlinear \"") && d.file().contains("stiffness { x x { _ => k; } }"), "{}", d.file());
    proved(
        d.proofs(),
        &["d/dt (q'.dT/dq' - T + V)", "at a step of k: T+ - T-", "M is symmetric", "M is positive definite: every"],
    );
}

/// A torque that depends on a speed makes cells nonlinear only where its effect is on. Its power is in the power balance, and
/// the matrices of the cell do not contain it. If the torque belongs to no effect, no cell is linear.
pub fn torques_that_depend_on_speeds_are_reported() {
    let describe = |with: bool| {
        Model::new("windmill", move |m| {
            let [inertia, k, c, t] = ["J", "k", "c", "T"].map(|name| m.parameter(name, "1", None, Range::Positive, ""));
            let x = m.coordinate("x", "rad", Start::At(0.0), "angle");
            m.kinetic(half(inertia * x.dot().sq()));
            m.potential(half(k * x.sq()));
            m.torque("motor", t, x, "");
            let fan = |m: &mut Model| m.torque("fan", -c * x.dot().pow(3), x, "");
            if with { m.effect("fan_load", "", fan) } else { fan(m) }
        })
    };
    let model = describe(true);
    let d = derive(&model).expect("a sound model");
    let term = "-c*x_dot^3 in the torque `fan`".to_string();
    assert!(d.nonlinear_terms().is_empty());
    assert_eq!(d.nonlinear_with(), [(vec!["fan_load".to_string()], term.clone())]);
    proved(d.proofs(), &["d/dt (q'.dT/dq' - T + V)"]);
    let file = d.file();
    for said in [
        "fan \"\" {}\n        power { fan_load => -c*x_dot.powi(4); }",
        "work { x { _ => T; } }",
        "load { x { _ => T; } }",
        "fan_load \"-c*x_dot^3 in the torque `fan`\";",
    ] {
        assert!(file.contains(said), "{said} is not in {file}");
    }
    let model = describe(false);
    assert_eq!(derive(&model).expect("a sound model").nonlinear_terms(), [term]);
}

/// With three coordinates M is not inverted in closed form; cells are linear and the proofs hold.
pub fn a_model_with_three_coordinates_is_proved() {
    let model = Model::new("three_rotors", |m| {
        let inertias = ["J1", "J2", "J3"].map(|name| m.parameter(name, "kg*m^2", None, Range::Positive, ""));
        let shaft = m.parameter("s", "N*m", None, Range::Positive, "");
        let c = m.parameter("c", "N*m*s", None, Range::NotNegative, "");
        let [a, b, d] = ["a", "b", "d"].map(|name| m.coordinate(name, "rad", Start::At(0.0), ""));
        for (inertia, q) in inertias.into_iter().zip([a, a + b, a + b + d]) {
            m.kinetic(half(inertia * q.dot().sq()));
        }
        let k = mesh_stiffness(m, "k", "N*m", a, 1.0, "");
        m.potential(half(k.value * b.sq()));
        m.potential(half(shaft * d.sq()));
        m.effect("damping", "", |m| m.dissipation(half(c * d.dot().sq())));
    });
    let derivation = derive(&model).expect("the model is sound");
    assert!(derivation.nonlinear_terms().is_empty(), "{:?}", derivation.nonlinear_terms());
    assert!(derivation.speed_lost(0, &[]).is_none() && derivation.direction(0, 1).is_none(), "M is not inverted");
    proved(derivation.proofs(), &["d/dt (q'.dT/dq' - T + V)", "M is symmetric", "M is positive definite: every"]);
    insta::assert_snapshot!("three_rotors", derivation.text());
}

fn proved(proofs: &[String], claims: &[&str]) {
    for claim in claims {
        assert!(proofs.iter().any(|p| p.starts_with(claim)), "not proved: {claim}, but {proofs:#?}");
    }
}
