//! The deflection of a mesh along its line of action, from the motion of its two gears.
//!
//! The centre of a gear moves by x, y, its base circle by u = r_b theta, counterclockwise. Let psi be the direction of the line
//! of centres, from the first gear to the second, or from the middle of a ring outwards, and alpha the pressure angle. A point of
//! the gear in contact then moves along the line of action by y cos(l) - x sin(l) + u, with l = psi - alpha for an external and
//! l = psi + alpha for an internal mesh (Lin & Parker 1999, Eq. (3)). The deflection is
//!
//! ```text
//! delta = (y1 - y2) cos(l) - (x1 - x2) sin(l) + u1 + u2     external
//! delta = (y1 - y2) cos(l) - (x1 - x2) sin(l) + u1 - u2     internal, 1 the ring
//! ```
//!
//! At the pitch point the flanks slide on each other across the line of action, for two reasons. They turn about the points where the line
//! of action touches the base circles, at the distance r_b tan(alpha), and the centres move. At other points of the line of action they
//! also slide by the relative rotation of the gears ([`super::friction`]). The sign of tau is chosen so that both parts have the same sign
//! in recess.
//!
//! ```text
//! tau = tan(alpha) (u1 + u2) - (x1 - x2) cos(l) - (y1 - y2) sin(l)     external
//! tau = tan(alpha) (u1 - u2) + (x1 - x2) cos(l) + (y1 - y2) sin(l)     internal, 1 the ring
//! ```
//!
//! The line of action of the coast flanks is the mirror image about the line of centres, at 2 psi - l. The formulas of delta hold for this
//! line too. In the formulas of tau, the rotations then have the factor -tan(alpha).

use gearsim_derive::Expr;

/// The plane motion of a gear \[m\].
#[derive(Clone, Copy)]
pub struct Gear {
    /// Displacement of the centre along x.
    pub x: Expr,
    /// Displacement of the centre along y.
    pub y: Expr,
    /// Rotation times the radius of the base circle, positive counterclockwise.
    pub u: Expr,
}

/// A direction, by the cosine and the sine of its angle.
#[derive(Clone, Copy)]
pub struct Direction {
    /// Cosine.
    pub cos: Expr,
    /// Sine.
    pub sin: Expr,
}

impl Direction {
    /// The direction at the negative angle.
    pub fn mirrored(self) -> Direction {
        Direction { sin: -self.sin, ..self }
    }
}

impl Gear {
    /// A gear with a fixed centre.
    pub fn centred(u: Expr) -> Gear {
        Gear { x: 0.into(), y: 0.into(), u }
    }

    /// Displacement of the centre in a direction.
    pub fn along(self, l: Direction) -> Expr {
        self.x * l.cos + self.y * l.sin
    }

    /// Displacement of the centre perpendicular to a direction.
    pub fn across(self, l: Direction) -> Expr {
        self.y * l.cos - self.x * l.sin
    }
}

/// The deflection of an external mesh \[m\]. The second gear may be given in its own frame, with the direction `l2` of the line
/// of action in that frame.
pub fn external(a: Gear, l1: Direction, b: Gear, l2: Direction) -> Expr {
    a.across(l1) - b.across(l2) + a.u + b.u
}

/// The sliding distance of the flanks of an external mesh at the pitch point \[m\]. `tangent` is the tangent of the pressure angle, negative on the
/// coast flanks.
pub fn external_sliding(a: Gear, l1: Direction, b: Gear, l2: Direction, tangent: Expr) -> Expr {
    tangent * (a.u + b.u) - a.along(l1) + b.along(l2)
}

/// The deflection \[m\] of the internal mesh between a ring and a planet.
pub fn internal(ring: Gear, l1: Direction, planet: Gear, l2: Direction) -> Expr {
    ring.across(l1) - planet.across(l2) + ring.u - planet.u
}

/// The sliding distance \[m\] of the flanks of the internal mesh between a ring and a planet, at the pitch point. `tangent` is as in
/// [`external_sliding`].
pub fn internal_sliding(ring: Gear, l1: Direction, planet: Gear, l2: Direction, tangent: Expr) -> Expr {
    tangent * (ring.u - planet.u) + ring.along(l1) - planet.along(l2)
}
