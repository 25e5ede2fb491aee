//! The errors that a model can have.

/// Why a model was refused, with the offending symbol or term.
#[derive(Debug, thiserror::Error, PartialEq)]
#[allow(missing_docs)] // the messages are the documentation
pub enum Slip {
    #[error(
        "{model}: `{symbol}` in {place} is not declared. Declare it with m.parameter(...), m.coordinate(...) or m.constant(...); declared are: {declared}"
    )]
    Undeclared { model: String, symbol: String, place: String, declared: String },
    #[error("{model}: the name `{name}` is declared twice ({first} and {second}); every name must be unique")]
    Twice { model: String, name: String, first: &'static str, second: &'static str },
    #[error(
        "{model}: `{name}` is not a valid name: a name starts with a letter, continues with letters, digits and `_`, does not end in `_dot` or `_mid`, and is neither a Rust keyword nor a name of the generated code itself"
    )]
    Name { model: String, name: String },
    #[error("{model}: {place} may not contain `{symbol}`: {why}")]
    Misplaced { model: String, symbol: String, place: String, why: &'static str },
    #[error(
        "{model}: `{function}` in {place} is not a known smooth function; allowed are sin, cos, exp, log and sqrt. Declare piecewise behaviour as a law or as a switch: m.stiffness_law(...), m.switch(...)"
    )]
    Function { model: String, function: String, place: String },
    #[error(
        "{model}: the number {number} in {place} cannot be written as code: it must be real, finite and rational, with numerator and denominator of at most 2^53. Was something divided by zero? If it is a quantity, declare it with m.parameter(...)"
    )]
    Number { model: String, number: String, place: String },
    #[error("{model}: the kinetic energy must be quadratic in the speeds; this term is not: {term}")]
    NotQuadratic { model: String, term: String },
    #[error(
        "{model}: coordinate `{coordinate}` has no inertia: its speed is not in the kinetic energy. It is eliminated where springs of constant stiffness alone place it, but {why}. Give it an inertia, or leave the coordinate out"
    )]
    Massless { model: String, coordinate: String, why: String },
    #[error(
        "{model}: the mass matrix is singular: some linear combination of coordinates that contains ({coordinates}) has no inertia"
    )]
    Singular { model: String, coordinates: String },
    #[error(
        "{model}: the dissipation function must be a sum of squares with factors that are never negative, or damping could add energy; this term is not one: {term}"
    )]
    NegativeDissipation { model: String, term: String },
    #[error(
        "{model}: the speed along which the torque `{torque}` works must be a linear form of the speeds, without a constant term; {speed} is not"
    )]
    NotLinear { model: String, torque: String, speed: String },
    #[error(
        "{model}: the deflection `{deflection}` must be a linear form of the coordinates without a constant term, minus transmission errors with constant factors; {value} is not"
    )]
    NotADeflection { model: String, deflection: String, value: String },
    #[error("{model}: the switch of `{switch}`, `{mode}`: {why}")]
    Switch { model: String, switch: String, mode: String, why: &'static str },
    #[error("{model}: the phase of `{law}` must be one of the coordinates, not {phase}")]
    Phase { model: String, law: String, phase: String },
    #[error("{model}: the pitch of `{law}` must be a positive number, not {pitch}")]
    Pitch { model: String, law: String, pitch: f64 },
    #[error("{model}: the law `{law}` is zero without an effect, but it is in none: declare it inside m.effect(...)")]
    WithoutEffect { model: String, law: String },
    #[error(
        "{model}: no effect says how the law `{law}` switches: declare one with m.effect(...) and m.boundaries(EFFECT, Boundary::WithJump), or call the component `steps`"
    )]
    NeverSwitches { model: String, law: String },
    #[error("{model}: the effect `{effect}` decides how laws switch, but {why}")]
    Boundary { model: String, effect: String, why: String },
    #[error("{model}: the default of `{parameter}`, {default}, is not in its range")]
    Default { model: String, parameter: String, default: f64 },
    #[error(
        "{model}: `{parameter}` must exceed {lesser}: Range::Above takes a parameter that is positive, and the greater one has no default"
    )]
    Above { model: String, parameter: String, lesser: String },
    #[error(
        "{model}: m.inverse_mass(...) takes two coordinates of a model that has at most two, and whose mass matrix is constant: only then is it inverted symbolically"
    )]
    InverseMass { model: String },
    #[error("{model}: proof failed: {what}; what contradicts it: {rest}")]
    Unproved { model: String, what: String, rest: String },
    #[error(
        "{model}: the parameter `{parameter}` is declared in the effect `{effect}`, but {place} contains it without this effect. Declare it before m.effect(...)"
    )]
    OfAnEffect { model: String, parameter: String, effect: String, place: String },
    #[error("{model}: no coordinates; declare at least one with m.coordinate(...)")]
    Empty { model: String },
}
