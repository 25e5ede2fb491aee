//! What a mesh feels of two gears along its line of action.
//!
//! A gear moves by x, y and turns by u = r_b theta at its base circle, counterclockwise. In a mesh whose line of centres
//! (from the first gear to the second; from the middle of a ring outwards) is in the direction psi, a point of it moves
//! along the line of action by y cos(l) - x sin(l) + u, with l = psi - alpha for an external and l = psi + alpha for an
//! internal mesh of the pressure angle alpha (Lin & Parker 1999, Eq. (3)). The deflection is
//!
//! ```text
//! delta = (y1 - y2) cos(l) - (x1 - x2) sin(l) + u1 + u2     external
//! delta = (y1 - y2) cos(l) - (x1 - x2) sin(l) + u1 - u2     internal, 1 the ring
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

impl Direction {
    /// The opposite angle.
    pub fn mirrored(self) -> Direction {
        Direction { sin: -self.sin, ..self }
    }
}

impl Gear {
    /// A gear whose centre does not move.
    pub fn centred(u: Expr) -> Gear {
        Gear { x: 0.into(), y: 0.into(), u }
    }

    /// What its centre moves in a direction.
    pub fn along(self, l: Direction) -> Expr {
        self.x * l.cos + self.y * l.sin
    }

    /// What its centre moves at right angles to a direction.
    pub fn across(self, l: Direction) -> Expr {
        self.y * l.cos - self.x * l.sin
    }
}

/// The deflection of an external mesh [m]. The second gear may be given in a frame of its own, with the line `l2` in it.
pub fn external(a: Gear, l1: Direction, b: Gear, l2: Direction) -> Expr {
    a.across(l1) - b.across(l2) + a.u + b.u
}

/// The deflection of the mesh of a ring with a planet [m].
pub fn internal(ring: Gear, l1: Direction, planet: Gear, l2: Direction) -> Expr {
    ring.across(l1) - planet.across(l2) + ring.u - planet.u
}
