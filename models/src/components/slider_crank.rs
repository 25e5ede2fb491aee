//! A slider-crank: a piston whose place follows from the angle of the crank.
//!
//! The constraint of the connecting rod, (x - r cos theta)² + (r sin theta)² = l², is solved for the place of the piston, so that no
//! coordinate and no constraint is added: x = r cos theta + (l² - r² sin² theta)^(1/2).

use gearsim_derive::{Expr, Model, Range, half};

use super::named;

/// A piston that a crank moves by a rigid connecting rod. `theta` [rad] is the angle of the crank from the line of the piston.
/// Declares the radius of the crank `r`, the length of the rod `l`, which must be longer, and the mass of the piston `m`. The mass of
/// the rod is divided, as usual, between the crank pin, where it is part of the crank's inertia, and the piston. Adds the kinetic
/// energy of the piston and returns its distance from the crank's axis [m].
pub fn slider_crank(m: &mut Model, part: &str, what: &str, theta: Expr) -> Expr {
    let r = m.parameter(&named("r", part), "m", None, Range::Positive, &format!("radius of the crank of the {what}"));
    let doc = format!("length of the connecting rod of the {what}, longer than the radius of the crank");
    let l = m.parameter(&named("l", part), "m", None, Range::Positive, &doc);
    let mass =
        m.parameter(&named("m", part), "kg", None, Range::Positive, &format!("moving mass of the {what}, with a part of its rod"));
    let x = r * theta.cos() + (l.sq() - (r * theta.sin()).sq()).sqrt();
    m.kinetic(half(mass * x.dot().sq()));
    m.effect("gravity", "weight of the piston along its path", |m| {
        let doc = format!("gravity along the path of the {what}, towards the crank; negative if the piston is below the crank");
        let g = m.parameter(&named("g", part), "m/s^2", Some(9.81), Range::Any, &doc);
        m.potential(mass * g * x);
    });
    x
}
