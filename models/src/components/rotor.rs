//! A rotor: T = I theta'^2/2, plus m (x'^2 + y'^2)/2 if its centre moves.

use gearsim_derive::{Expr, Model, Range, half};

use super::{named, observed};

/// A rotor on a fixed axis with the rotation `theta` \[rad\]. Declares its moment of inertia `I`.
pub fn rotor(m: &mut Model, part: &str, what: &str, theta: Expr) {
    let doc = format!("moment of inertia of the {what}");
    let inertia = m.parameter(&named("I", part), "kg*m^2", None, Range::Positive, &doc);
    m.kinetic(half(inertia * theta.dot().sq()));
    observed::rotor(m, part, what, theta);
}

/// A rotor with the rotation `theta` \[rad\] whose centre moves by `x`, `y` \[m\]. Declares its moment of inertia `I` and mass `m`.
pub fn planar_rotor(m: &mut Model, part: &str, what: &str, [x, y]: [Expr; 2], theta: Expr) {
    rotor(m, part, what, theta);
    let mass = m.parameter(&named("m", part), "kg", None, Range::Positive, &format!("mass of the {what}"));
    m.kinetic(half(mass * x.dot().sq()));
    m.kinetic(half(mass * y.dot().sq()));
}
