//! Unusual input: the derivation always ends with equations or with an error (`Slip`), never with a panic.

use gearsim_derive::{Expr, Model, Range, Start, derive, half};
use gearsim_models::components::mesh_stiffness;

use crate::slips::oscillator;

/// The unusual property, and the model.
type Row = (&'static str, fn(&mut Model));

/// Models that may be derived or refused, but must not panic.
const ODD: &[Row] = &[
    ("nothing at all", |_| {}),
    ("energies without coordinates", |m| m.kinetic(Expr::symbol("x").sq())),
    ("a coordinate without energies", |m| {
        m.coordinate("x", "m", Start::Static, "");
    }),
    ("energies that are zero", |m| {
        let x = m.coordinate("x", "m", Start::Static, "");
        m.kinetic(x.dot() + -x.dot());
        m.potential(0.into());
        m.dissipation(0.into());
        m.torque("none", 0.into(), 0.into(), "");
    }),
    ("names that are not identifiers", |m| {
        for name in ["", " ", "a b", "1", "é", "a::b", "`", "\"", "\n", "\0", "_", "_x", "{}", "%", "🙂", "x!"] {
            let x = m.coordinate(name, name, Start::At(f64::NAN), name);
            let p = m.parameter(name, name, None, Range::Positive, name);
            let k = mesh_stiffness(m, name, name, x, 1.0, name);
            m.constant(name, p);
            m.kinetic(p * x.dot().sq() + Expr::symbol(name) * Expr::function(name, k.value));
            m.effect(name, name, |m| m.torque(name, p, x, name));
        }
    }),
    ("unusual characters in the documentation", |m| {
        oscillator(m);
        m.title("\"}\\ \n//! \0 🙂 {} */");
        m.source("\r\n\"#");
        m.parameter("p", "\"\\", Some(1.0), Range::Any, "\"; } \u{202e}");
    }),
    ("names of Symbolica, of Rust and of the generated code", |m| {
        for name in ["i", "e", "pi", "E", "sin", "cos", "exp", "f64", "dx", "ddx", "W0_0", "stretch", "u", "m0_0"] {
            let x = m.coordinate(name, "m", Start::Static, "");
            m.kinetic(x.dot().sq());
            m.potential(half(x.sq()));
        }
    }),
    ("an effect with the name of a condition", |m| {
        let o = oscillator(m);
        m.effect("jump_terms", "", |m| m.potential(o.x.sq()));
    }),
    ("effects within effects", |m| {
        let o = oscillator(m);
        m.effect("a", "", |m| m.effect("b", "", |m| m.effect("c", "", |m| m.kinetic(o.m * o.x.dot().sq()))));
    }),
    ("parameters that are infinite or NaN", |m| {
        let o = oscillator(m);
        let p = m.parameter("p", "1", Some(f64::INFINITY), Range::Any, "");
        m.parameter("n", "1", Some(f64::NAN), Range::Any, "");
        mesh_stiffness(m, "k", "N/m", o.x, f64::NAN, "");
        m.kinetic(p * o.x.dot().sq());
    }),
    ("divisions by zero", |m| {
        let o = oscillator(m);
        m.potential(o.x / (o.s + -o.s));
        m.kinetic(o.x.dot().sq() / 0);
        m.constant("c", Expr::from(0).pow(-1));
        m.constant("d", Expr::from(0) / 0);
    }),
    ("roots and logarithms that do not exist", |m| {
        let o = oscillator(m);
        m.potential(Expr::from(-1).sqrt() * o.x + Expr::function("log", 0.into()) * o.x.sq());
        m.constant("c", Expr::function("log", Expr::from(-1).sqrt()));
    }),
    ("the largest and the smallest integers", |m| {
        let o = oscillator(m);
        m.potential(i64::MAX * o.x.sq() + i64::MIN * o.x.pow(3));
        m.kinetic(Expr::from(i64::MAX).pow(3) * o.x.dot().sq());
    }),
    ("integers whose products are large", |m| {
        let x = m.coordinate("x", "m", Start::Static, "");
        m.kinetic(x.dot().sq() / (1 << 40));
        m.potential((1 << 40) * x.sq());
    }),
    ("a large power", |m| {
        let o = oscillator(m);
        m.potential(o.s * o.x.pow(1000) + o.x.pow(-1000));
    }),
    ("functions of functions", |m| {
        let o = oscillator(m);
        m.potential((0..20).fold(o.s * o.x, |e, _| Expr::function("sin", e + 1)));
    }),
    ("a chain of twelve masses", |m| {
        let q: Vec<Expr> = (0..12).map(|i| m.coordinate(&format!("x{i}"), "m", Start::Static, "")).collect();
        q.iter().for_each(|x| m.kinetic(half(x.dot().sq())));
        q.windows(2).for_each(|x| m.potential(half((x[0] - x[1]).sq())));
    }),
    ("a thousand terms", |m| {
        let o = oscillator(m);
        (1..1000).for_each(|i| m.potential(o.s * (o.x - i).sq()));
    }),
    ("names a thousand letters long", |m| {
        let x = m.coordinate(&"x".repeat(1000), "m", Start::Static, "");
        m.kinetic(half(x.dot().sq()));
    }),
    ("very many effects", |m| {
        let o = oscillator(m);
        (0..40).for_each(|i| m.effect(&format!("e{i}"), "", |m| m.potential(i * o.x)));
    }),
];

pub fn no_input_panics() {
    for (what, describe) in ODD {
        // Caught only to say which model panics.
        let outcome = std::panic::catch_unwind(|| {
            let model = Model::new("odd", describe);
            derive(&model).map(|d| d.file()).map_err(|slip| slip.to_string())
        });
        match outcome.unwrap_or_else(|_| panic!("{what}: panics")) {
            Ok(file) => {
                println!("{what}: sound");
                syn::parse_file(&file).unwrap_or_else(|e| panic!("{what}: not Rust: {e}\n{file}"));
            }
            Err(slip) => println!("{what}: {slip}"),
        }
    }
}
