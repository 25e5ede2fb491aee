//! What a file says of small models, and what it leaves out.

use gearsim_derive::{Expr, Model, Range, Start, derive, half};

use crate::slips::oscillator;

fn file(describe: impl FnOnce(&mut Model)) -> String {
    let model = Model::new("train", describe);
    derive(&model).unwrap_or_else(|slip| panic!("{slip}")).file()
}

/// The block that starts with `head`, in one line.
#[track_caller]
fn block(file: &str, head: &str) -> String {
    let lines = file.lines().skip_while(|line| line.trim() != head);
    let end = format!("{}}}", " ".repeat(file.lines().find(|l| l.trim() == head).map_or(0, |l| l.len() - head.len())));
    let inside: Vec<&str> = lines.skip(1).take_while(|line| *line != end).map(str::trim).collect();
    assert!(!inside.is_empty(), "{head} is not there: {file}");
    inside.join(" ")
}

/// A cart and a pendulum's worth of coupling: no entry of M⁻¹ is one term.
fn coupled(m: &mut Model) -> [Expr; 2] {
    let [cart, bob, l, j] = ["m1", "m2", "l", "J"].map(|name| m.parameter(name, "1", None, Range::Positive, ""));
    let [x, y] = ["x", "y"].map(|name| m.coordinate(name, "1", Start::At(0.0), ""));
    m.kinetic(half(cart * x.dot().sq()));
    m.kinetic(half(bob * (x.dot() + l * y.dot()).sq()));
    m.kinetic(half(j * y.dot().sq()));
    [x, y]
}

/// Fractions whose sums have no term to cancel another: the cofactors over the determinant.
pub fn mobility_is_one_fraction_an_entry() {
    let plain = file(|m| {
        coupled(m);
    });
    let determinant = "(J*m1 + J*m2 + l.powi(2)*m1*m2)";
    assert_eq!(
        block(&plain, "mobility {"),
        format!(
            "x x {{ _ => (J + l.powi(2)*m2)/{determinant}; }} x y {{ _ => -l*m2/{determinant}; }} \
             y y {{ _ => (m1 + m2)/{determinant}; }}"
        )
    );
    let named = file(|m| {
        let [x, y] = coupled(m);
        let w = m.inverse_mass(x, y);
        m.constant("W", 3 * w);
    });
    assert!(block(&named, "mobility {").contains("x y { _ => W/3.0; }"), "{named}");
}

/// Not for three coordinates, nor where an effect adds inertia: there M is left to be inverted as numbers.
pub fn mobility_is_left_out_where_it_is_not_known() {
    let of_effect = file(|m| {
        let o = oscillator(m);
        m.effect("ring", "", |m| m.kinetic(o.m * o.x.dot().sq()));
    });
    let of_three = file(|m| {
        let o = oscillator(m);
        let [y, z] = ["y", "z"].map(|name| m.coordinate(name, "m", Start::Static, ""));
        m.kinetic(half(o.m * (y.dot().sq() + z.dot().sq())));
    });
    for file in [of_effect, of_three] {
        assert!(file.contains("    mass {\n") && !file.contains("mobility"), "{file}");
    }
}

/// A torque works through the change of its displacement: what is constant in it does no work.
pub fn offsets_do_no_work() {
    let file = file(|m| {
        let o = oscillator(m);
        let [force, at, ratio] = ["F", "a", "r"].map(|name| m.parameter(name, "1", None, Range::Any, ""));
        m.torque("plain", force, ratio * (o.x + 2 * o.x), "");
        m.torque("offset", force, o.x + at, "");
        m.torque("scaled", -force, (o.x - at) / ratio + 1, "");
        m.torque("unexpanded", force, (o.x + at).sq() - (o.x - at).sq(), "");
        m.torque("fixed", force, at, "");
    });
    for work in [
        "plain \"\" {\n            _ => 3.0*F*r*x;\n",
        "offset \"\" {\n            _ => F*x;\n",
        "scaled \"\" {\n            _ => -F*x/r;\n",
        "unexpanded \"\" {\n            _ => 4.0*F*a*x;\n",
        "fixed \"\" {}\n",
    ] {
        assert!(file.contains(work), "{work} is not there: {file}");
    }
}

pub fn nothing_is_said_of_no_constants() {
    let without = file(|m| {
        oscillator(m);
    });
    assert!(!without.to_lowercase().contains("constants"), "{without}");
    let with = file(|m| {
        let o = oscillator(m);
        m.constant("w", (o.s / o.m).sqrt());
    });
    for said in ["//! # Constants\n", "    constants {\n        w = (s/m).sqrt();\n", "| constants (once a scene) |"] {
        assert!(with.contains(said), "{said} is not there: {with}");
    }
}
