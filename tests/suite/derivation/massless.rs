//! Coordinates without inertia: the equations are those of the springs in series, written by hand.

use gearsim_derive::{Derivation, Expr, Model, Range, Start, derive, half};

use crate::slips::{Oscillator, oscillator};

fn derived(model: &Model) -> Derivation<'_> {
    derive(model).unwrap_or_else(|slip| panic!("{slip}"))
}

/// The accelerations of both models are the same.
fn same(listed: &Model, by_hand: &Model) {
    let (a, b) = (derived(listed), derived(by_hand));
    assert!((a.equation(0, &[]) - b.equation(0, &[])).is_zero(), "{}\n\n{}", a.text(), b.text());
}

fn spring(m: &mut Model, name: &str) -> Expr {
    m.parameter(name, "N/m", None, Range::Positive, "a spring")
}

fn node(m: &mut Model, name: &str) -> Expr {
    m.coordinate(name, "m", Start::Static, "a place without inertia")
}

/// Adds one spring between the mass and the ground, and damping in proportion to all springs.
fn with_one(m: &mut Model, stiffness: impl FnOnce([Expr; 3]) -> Expr) {
    let o = oscillator(m);
    let springs = ["k1", "k2", "k3"].map(|name| spring(m, name));
    m.potential(half(stiffness(springs) * o.x.sq()));
    damped(m);
}

fn damped(m: &mut Model) {
    let beta = m.parameter("beta", "s", None, Range::NotNegative, "damping over stiffness");
    m.effect("damping", "damping", |m| m.rayleigh(0.into(), beta));
}

/// Two places without inertia between three springs, with named deflections and without.
pub fn springs_in_series_are_one_spring() {
    let in_series = |named: bool| {
        Model::new("series", |m| {
            let Oscillator { x, .. } = oscillator(m);
            let [k1, k2, k3] = ["k1", "k2", "k3"].map(|name| spring(m, name));
            let (y, z) = (node(m, "y"), node(m, "z"));
            for (k, name, over) in [(k1, "d1", x - y), (k2, "d2", y - z), (k3, "d3", z)] {
                let over = if named { m.deflection(name, over) } else { over };
                m.potential(half(k * over.sq()));
            }
            damped(m);
        })
    };
    let by_hand = Model::new("series", |m| with_one(m, |[a, b, c]| a * b * c / (a * b + b * c + a * c)));
    for named in [true, false] {
        same(&in_series(named), &by_hand);
    }
}

/// A place between three springs that meet there.
pub fn springs_that_meet_are_a_star() {
    let star = Model::new("star", |m| {
        let Oscillator { x, .. } = oscillator(m);
        let [k1, k2, k3] = ["k1", "k2", "k3"].map(|name| spring(m, name));
        let y = node(m, "y");
        m.potential(half(k1 * (x - y).sq()));
        m.potential(half((k2 + k3) * y.sq()));
        damped(m);
    });
    same(&star, &Model::new("star", |m| with_one(m, |[a, b, c]| a * (b + c) / (a + b + c))));
}

/// A shaft of two springs between two rotors: its deflections vanish exactly where both rotors turn alike, and the place between the
/// springs is an output.
pub fn a_node_of_a_shaft_is_an_output() {
    let model = Model::new("shaft", |m| {
        let [i1, i2] = ["I1", "I2"].map(|name| m.parameter(name, "kg*m^2", None, Range::Positive, "inertia"));
        let [a, b] = ["a", "b"].map(|name| m.coordinate(name, "rad", Start::At(0.0), "rotation"));
        let y = m.coordinate("y", "rad", Start::Static, "rotation of the node");
        let [k1, k2] = ["k1", "k2"].map(|name| m.parameter(name, "N*m/rad", None, Range::Positive, "spring"));
        m.kinetic(half(i1 * a.dot().sq()));
        m.kinetic(half(i2 * b.dot().sq()));
        let [d1, d2] = [("d1", a - y), ("d2", y - b)].map(|(name, over)| m.deflection(name, over));
        m.potential(half(k1 * d1.sq()));
        m.potential(half(k2 * d2.sq()));
        m.motion("speed", "rad/s", &[(a, 1.into()), (b, 1.into()), (y, 1.into())], "all turn alike");
    });
    let derived = derived(&model);
    // The same factor occurs with both signs, so that equal rotations cancel exactly.
    let text = derived.text();
    assert!(text.contains("d1 = d1_per_a*a - d1_per_a*b"), "{text}");
    let file = derived.file();
    assert!(file.contains("y \"rad\"") && file.contains("rotation of the node"), "{file}");
}
