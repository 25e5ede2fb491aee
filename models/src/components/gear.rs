//! What a mesh feels of two gears along its line of action.
//!
//! Seen from the line of centres, which runs from the first gear to the second (from the middle of a ring outwards), a
//! gear moves by r radially along that line and by t at right angles to it, and turns by u = r_b theta at its base
//! circle; t and u are positive counterclockwise. With the pressure angle alpha (Lin & Parker 1999, Eq. (3)):
//!
//! ```text
//! delta = (t1 - t2) cos(alpha) + (r1 - r2) sin(alpha) + u1 + u2     external
//! delta = (t1 - t2) cos(alpha) - (r1 - r2) sin(alpha) + u1 - u2     internal, 1 the ring
//! ```

use gearsim_derive::Expr;

/// The plane motion of a gear [m]: of its centre along x and y, and of its base circle.
#[derive(Clone, Copy)]
pub struct Gear {
    /// Displacement of the centre along x.
    pub x: Expr,
    /// Displacement of the centre along y.
    pub y: Expr,
    /// Rotation times the radius of the base circle, positive counterclockwise.
    pub u: Expr,
}

/// A direction by its cosine and its sine.
#[derive(Clone, Copy)]
pub struct Direction {
    /// Cosine.
    pub cos: Expr,
    /// Sine.
    pub sin: Expr,
}

/// The motion of a gear [m] as seen from a line of centres.
#[derive(Clone, Copy)]
pub struct Seen {
    /// Along the line.
    pub radial: Expr,
    /// At right angles to it.
    pub tangential: Expr,
    /// Rotation times the radius of the base circle.
    pub u: Expr,
}

impl Gear {
    /// A gear on a fixed axis.
    pub fn fixed(u: Expr) -> Gear {
        Gear { x: 0.into(), y: 0.into(), u }
    }

    /// As seen from a line of centres in a direction.
    pub fn seen_from(self, psi: Direction) -> Seen {
        let Gear { x, y, u } = self;
        Seen { radial: x * psi.cos + y * psi.sin, tangential: y * psi.cos - x * psi.sin, u }
    }
}

/// The deflection of an external mesh [m].
pub fn external(a: Seen, b: Seen, alpha: Direction) -> Expr {
    (a.tangential - b.tangential) * alpha.cos + (a.radial - b.radial) * alpha.sin + a.u + b.u
}

/// The deflection of the mesh of a ring with a planet [m].
pub fn internal(ring: Seen, planet: Seen, alpha: Direction) -> Expr {
    (ring.tangential - planet.tangential) * alpha.cos - (ring.radial - planet.radial) * alpha.sin + ring.u - planet.u
}
