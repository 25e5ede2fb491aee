//! The blocks in the derived files of small models, and the blocks that are left out.

use gearsim_derive::{Expr, Model, Range, Start, derive, half};

use crate::slips::oscillator;

fn file(describe: impl FnOnce(&mut Model)) -> String {
    let model = Model::new("train", describe);
    derive(&model).unwrap_or_else(|slip| panic!("{slip}")).file()
}

/// The file in one line, with single spaces.
fn in_one_line(file: &str) -> String {
    file.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Two coordinates coupled by inertia as a cart and a pendulum are, so that no entry of M⁻¹ is a single term.
fn coupled(m: &mut Model) -> [Expr; 2] {
    let [cart, bob, l, j] = ["m1", "m2", "l", "J"].map(|name| m.parameter(name, "1", None, Range::Positive, ""));
    let [x, y] = ["x", "y"].map(|name| m.coordinate(name, "1", Start::At(0.0), ""));
    m.kinetic(half(cart * x.dot().sq()));
    m.kinetic(half(bob * (x.dot() + l * y.dot()).sq()));
    m.kinetic(half(j * y.dot().sq()));
    [x, y]
}

/// An entry of M⁻¹ is a cofactor over the determinant; no terms in these sums cancel.
pub fn each_mobility_entry_is_one_fraction() {
    let plain = file(|m| {
        coupled(m);
    });
    let determinant = "(J*m1 + J*m2 + l.powi(2)*m1*m2)";
    let mobility = format!(
        "mobility {{ x x {{ _ => (J + l.powi(2)*m2)/{determinant}; }} x y {{ _ => -l*m2/{determinant}; }} \
         y y {{ _ => (m1 + m2)/{determinant}; }} }}"
    );
    assert!(in_one_line(&plain).contains(&mobility), "{plain}");
    let named = file(|m| {
        let [x, y] = coupled(m);
        let w = m.inverse_mass(x, y);
        m.constant("W", 3 * w);
    });
    assert!(named.contains("x y { _ => W/3.0; }"), "{named}");
}

/// With three coordinates, or where an effect adds inertia, the file has no M⁻¹: M is then inverted as a matrix of numbers.
pub fn mobility_is_omitted_where_no_closed_form_exists() {
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
        assert!(file.contains("    mass {") && !file.contains("mobility"), "{file}");
    }
}

/// The work of a torque follows from the change of its displacement, so a constant part of the displacement does no work.
pub fn constant_offsets_do_no_work() {
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
        "plain \"\" { _ => 3.0*F*r*x; }",
        "offset \"\" { _ => F*x; }",
        "scaled \"\" { _ => -F*x/r; }",
        "unexpanded \"\" { _ => 4.0*F*a*x; }",
        "fixed \"\" {}\n",
    ] {
        assert!(file.contains(work), "{work} is missing: {file}");
    }
}

pub fn a_model_without_constants_has_no_constants_block() {
    let without = file(|m| {
        oscillator(m);
    });
    assert!(!without.to_lowercase().contains("constants"), "{without}");
    let with = file(|m| {
        let o = oscillator(m);
        m.constant("w", (o.s / o.m).sqrt());
    });
    for said in ["    constants { w = (s/m).sqrt(); }\n", "| constants (once a scene) |"] {
        assert!(with.contains(said), "{said} is missing: {with}");
    }
}
