//! Slips in a model: what a derivation refuses, and whom it names.

/// Why a model was refused.
#[derive(Debug, thiserror::Error, PartialEq)]
#[allow(missing_docs)] // the messages are the documentation
pub enum Slip {
    #[error(
        "{model}: `{symbol}` in {place} is not declared. Declare it with m.parameter(...), m.coordinate(...) or m.constant(...); declared are: {declared}"
    )]
    Undeclared { model: String, symbol: String, place: String, declared: String },
    #[error("{model}: the name `{name}` is declared twice ({first} and {second}); every name must be its own")]
    Twice { model: String, name: String, first: &'static str, second: &'static str },
    #[error(
        "{model}: `{name}` cannot be a name: it must start with a letter, go on with letters, digits and `_`, and not be a word of Rust or end in `_dot` or `_mid`"
    )]
    Name { model: String, name: String },
    #[error("{model}: {place} may not contain `{symbol}`: {why}")]
    Misplaced { model: String, symbol: String, place: String, why: &'static str },
    #[error(
        "{model}: `{function}` in {place} is not smooth, or not known. Smooth functions are sin, cos, exp, log and sqrt; whatever is piecewise must be one of the declared primitives: m.mesh_stiffness(...)"
    )]
    Function { model: String, function: String, place: String },
    #[error(
        "{model}: the number {number} in {place} is not one that code can have: it must be real, finite, rational, and of no more than 53 bits. Was something divided by zero? If it is a quantity, declare it with m.parameter(...)"
    )]
    Number { model: String, number: String, place: String },
    #[error("{model}: the kinetic energy must be quadratic in the speeds; this term is not: {term}")]
    NotQuadratic { model: String, term: String },
    #[error(
        "{model}: coordinate `{coordinate}` has no inertia: its speed is not in the kinetic energy. Give it one, or leave the coordinate out"
    )]
    Massless { model: String, coordinate: String },
    #[error(
        "{model}: the mass matrix is singular, its determinant zero: a combination of coordinates in which ({coordinates}) takes part has no inertia"
    )]
    Singular { model: String, coordinates: String },
    #[error(
        "{model}: the dissipation function can be negative, so damping would feed energy in; the culprit is the term {term}"
    )]
    NegativeDissipation { model: String, term: String },
    #[error(
        "{model}: the displacement of the torque `{torque}` must be linear in the coordinates, or its work over a turn would depend on where the turn began; {displacement} is not"
    )]
    NotLinear { model: String, torque: String, displacement: String },
    #[error(
        "{model}: the deflection `{deflection}` must be linear in the coordinates, and zero where they are but for transmission errors; {value} is not"
    )]
    NotADeflection { model: String, deflection: String, value: String },
    #[error("{model}: the phase of `{law}` must be one of the coordinates, not {phase}")]
    Phase { model: String, law: String, phase: String },
    #[error("{model}: the pitch of `{law}` must be a positive number, not {pitch}")]
    Pitch { model: String, law: String, pitch: f64 },
    #[error("{model}: the default of `{parameter}`, {default}, is not in its range")]
    Default { model: String, parameter: String, default: f64 },
    #[error(
        "{model}: m.inverse_mass(...) takes two coordinates, and at most two can be declared: a larger mass matrix is not inverted symbolically"
    )]
    InverseMass { model: String },
    #[error("{model}: proof failed: {what}; left over: {rest}")]
    Unproved { model: String, what: String, rest: String },
    #[error("{model}: no coordinates; declare at least one with m.coordinate(...)")]
    Empty { model: String },
}
