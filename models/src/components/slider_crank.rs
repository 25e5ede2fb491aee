//! A slider-crank: a piston whose place follows from the angle of the crank.
//!
//! The constraint of the connecting rod, (x - r cos theta)² + (r sin theta)² = l², is solved for the place of the piston, so that it
//! adds neither a coordinate nor a reaction: x(theta) = r cos theta + (l² - r² sin² theta)^(1/2).

use gearsim_derive::{Expr, Model, Range, half};

use super::named;
use super::observed::of_part;

/// A piston that is driven by a crank through a rigid connecting rod. `theta` \[rad\] is the angle of the crank from the line of the piston.
/// Declares the radius of the crank `r`, the length of the rod `l`, which is greater, and the mass of the piston `m`. The mass of
/// the rod is divided, as usual, between the piston and the crank pin, where it is part of the crank's inertia. Adds the kinetic
/// energy of the piston, and its weight in the effect `gravity`. Returns its distance from the crank's axis \[m\].
pub fn slider_crank(m: &mut Model, part: &str, what: &str, theta: Expr) -> Expr {
    let r = m.parameter(&named("r", part), "m", None, Range::Positive, &format!("radius of the crank of the {what}"));
    let doc = format!("length of the connecting rod of the {what}, longer than the radius of the crank");
    let l = m.parameter(&named("l", part), "m", None, Range::Above(r), &doc);
    let doc = format!("moving mass of the {what}, with a part of its rod");
    let mass = m.parameter(&named("m", part), "kg", None, Range::Positive, &doc);
    let crank = m.deflection(&named("crank", part), theta);
    let x = m.function(&named("x", part), crank, |theta| r * theta.cos() + (l.sq() - (r * theta.sin()).sq()).sqrt());
    m.kinetic(half(mass * x.dot().sq()));
    m.output(&of_part("slider_place", part), "m", x, &format!("distance of the {what} from the crank's axis"));
    m.output(
        &of_part("slider_speed", part),
        "m/s",
        x.dot(),
        &format!("speed of the {what}, away from the crank's axis"),
    );
    m.effect("gravity", "weight of bodies whose height varies", |m| {
        let doc =
            format!("gravity along the path of the {what}, towards the crank; negative if the {what} is below it");
        let g = m.parameter(&named("g", part), "m/s^2", Some(9.81), Range::Any, &doc);
        m.potential(mass * g * x);
    });
    x
}
