//! Gears whose centres move, exactly, in the effect `moving_centres`: the line of action turns with the line of centres, the working pressure
//! angle follows the distance of the centres, and the play opens with it.
//!
//! Let the second gear's centre move by (x, y) relative to the first, x along the line of centres, and R be the sum of the base radii,
//! a = R/cos(alpha) the distance of the centres at rest. A string from base circle to base circle, crossed between them, touches the same
//! flanks as the teeth (an involute is the path of its end). Its length on the circles and between them gives, with
//!
//! ```text
//! w² = (a + x)² + y²,   tan(phi) = y/(a + x),   cos(alpha') = R/w,   inv(alpha) = tan(alpha) - alpha
//!
//! drive flanks:  s - R phi - R (inv(alpha') - inv(alpha))
//! coast flanks:  s - R phi + R (inv(alpha') - inv(alpha))
//! ```
//!
//! as their deflection, where s = r1 theta1 - r2 theta2. So the play opens by 2 R (inv(alpha') - inv(alpha)) along the line of action, which is
//! 2 w cos(alpha') (inv(alpha') - inv(alpha)): F. L. Litvin & A. Fuentes, Gear Geometry and Applied Theory, 2004, Sec. 10.5; ISO 21771. To
//! first order in x, y the deflections are s - y cos(alpha) - x sin(alpha) and s - y cos(alpha) + x sin(alpha), those of the linear model. The
//! effects on vibration: W. Kim, H. H. Yoo & J. Chung, J. Sound Vib. 329 (2010).

use gearsim_derive::{Expr, Model};

use super::{Direction, named};

/// The change of the deflections of a mesh by moving centres beyond the linear ones \[m\], zero without the effect ([`super::Flanks::bent`]).
#[derive(Clone, Copy)]
pub struct Bend {
    /// Subtracted for both flanks: the line of action turns.
    pub turn: Expr,
    /// Subtracted for the drive flanks, added for the coast flanks: the opening of the play.
    pub open: Expr,
}

/// Declares the effect for the mesh of two external gears. `apart` \[m\] is the displacement of the second gear's centre relative to the first
/// gear's centre, along and across the line of centres. `sum` \[m\] is the sum of the base radii. `angle` \[rad\] is the pressure angle at rest, and
/// `alpha` its direction.
pub fn moving_centres(
    m: &mut Model,
    part: &str,
    apart: [Expr; 2],
    sum: Expr,
    (angle, alpha): (Expr, Direction),
) -> Bend {
    let sum = m.constant(&named("R", part), sum);
    let distance = m.constant(&named("a", part), sum / alpha.cos);
    let involute = m.constant(&named("inv", part), alpha.sin / alpha.cos - angle);
    let names = [named("x_c", part), named("y_c", part)];
    let [x, y] = [m.deflection(&names[0], apart[0]), m.deflection(&names[1], apart[1])];
    let square = |[x, y]: [Expr; 2]| (distance + x).sq() + y.sq();
    let tangent = |at: [Expr; 2]| (square(at) - sum.sq()).sqrt();
    let mut bend = Bend { turn: 0.into(), open: 0.into() };
    let doc = "the line of action turns with the gears' centres, the pressure angle follows their distance, and the play opens with it";
    m.part_effect("moving_centres", part, doc, |m| {
        bend.turn = m.function_of(
            &named("turn", part),
            [x, y],
            |[x, y]| sum * (y / (distance + x)).atan() - y * alpha.cos,
            |[x, y]| [-sum * y / square([x, y]), sum * (distance + x) / square([x, y]) - alpha.cos],
        );
        bend.open = m.function_of(
            &named("open", part),
            [x, y],
            |at| tangent(at) - sum * (tangent(at) / sum).atan() - sum * involute - at[0] * alpha.sin,
            |[x, y]| {
                let by = |along: Expr| tangent([x, y]) * along / square([x, y]);
                [by(x + distance) - alpha.sin, by(y)]
            },
        );
    });
    bend
}
