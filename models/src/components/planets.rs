//! A planetary stage: sun `s`, ring `r`, carrier `c` and n planets, as Lin & Parker (1999), J. Vib. Acoust. 121(3).
//!
//! All meshes of a stage move on with one phase, theta = Z_s (theta_s - theta_c): one pitch is 2 pi, and rho = h theta
//! rolls along the line of action, h = r_s/Z_s. On a ring at rest the carrier then turns by rho/r_r and a planet by
//! -rho/r_p against it. The coordinates of carrier and planets are what they move beyond that, so that no deflection
//! depends on theta. Angles are counterclockwise; the frame turns with the carrier, without gyroscopic terms.

use gearsim_derive::{Expr, Model, Range, Start, half};

use super::gear::Direction;
use super::{Gear, Seen, external, internal, mesh};

/// A stage's geometry, and how it turns.
#[derive(Clone, Copy)]
pub struct Stage {
    /// The phase of its meshes, a coordinate [rad]; one pitch is 2 pi.
    pub theta: Expr,
    /// Rotation of the sun [rad].
    pub theta_s: Expr,
    /// Rotation of the carrier [rad].
    pub theta_c: Expr,
    /// Radii of the base circles of sun, planets and ring [m].
    pub r_s: Expr,
    /// Of a planet.
    pub r_p: Expr,
    /// Of the ring.
    pub r_r: Expr,
    /// Radius of the circle of the planets' centres [m].
    pub a: Expr,
    /// Pressure angle.
    pub alpha: Direction,
    /// Speed of theta per speed of the sun on a ring at rest.
    pub per_sun: Expr,
    rho: Expr,
}

/// Declares the geometry of a stage (`Z_s`, `Z_r`, `r_s`, `alpha`), and the coordinates `theta` and `theta_c`.
#[allow(non_snake_case)] // the field's symbols
pub fn stage(m: &mut Model) -> Stage {
    let Z_s = m.parameter("Z_s", "1", None, Range::Positive, "number of teeth of the sun");
    let Z_r = m.parameter("Z_r", "1", None, Range::Positive, "number of teeth of the ring");
    let r_s = m.parameter("r_s", "m", None, Range::Positive, "base radius of the sun");
    let alpha = m.parameter("alpha", "rad", Some(20f64.to_radians()), Range::Positive, "pressure angle");
    let h = m.constant("h", r_s / Z_s);
    let r_r = m.constant("r_r", h * Z_r);
    let alpha = Direction { cos: m.constant("cos_a", alpha.cos()), sin: m.constant("sin_a", alpha.sin()) };
    let theta = m.coordinate("theta", "rad", Start::At(0.0), "phase of the meshes, Z_s (theta_s - theta_c)");
    let beyond = m.coordinate("theta_c", "rad", Start::Static, "rotation of the carrier beyond rolling");
    let rho = h * theta;
    let theta_c = rho / r_r + beyond;
    Stage {
        theta,
        theta_s: rho / r_s + theta_c,
        theta_c,
        r_s,
        r_p: half(r_r - r_s),
        r_r,
        a: half(r_r + r_s) / alpha.cos,
        alpha,
        per_sun: Z_s * Z_r / (Z_s + Z_r),
        rho,
    }
}

impl Stage {
    /// The sun, its centre where it is said to be.
    pub fn sun(&self, [x, y]: [Expr; 2]) -> Gear {
        Gear { x, y, u: self.r_s * self.theta_s }
    }

    /// Adds `n` planets with their centres fixed to the carrier, and their meshes with a sun on a fixed axis and a ring
    /// that turns by `theta_r`. Declares the planets' `m_p`, `I_p` and coordinates `u1`, ..., the laws `k_s1`, `k_r1`, ...
    pub fn planets(&self, m: &mut Model, n: usize, theta_r: Expr) {
        let fixed = |u| Seen { radial: 0.into(), tangential: 0.into(), u };
        let (sun, ring) = (fixed(self.r_s * self.theta_s), fixed(self.r_r * theta_r));
        let (mass, inertia) = inertia(m);
        m.kinetic(half(n as i64 * mass * (self.a * self.theta_c.dot()).sq()));
        for i in 1..=n {
            let u = self.rotation(m, i, inertia);
            let planet = Seen { radial: 0.into(), tangential: self.a * self.theta_c, u };
            self.meshes(m, i, sun, ring, planet);
        }
    }

    /// Adds `n` planets on bearings on the carrier, and their meshes with sun and ring. Declares, of planet i, its place
    /// `psi1`, its coordinates `zeta1` (radial), `eta1` (tangential), `u1`; of all, `m_p`, `I_p` and the bearings' `kb_p`.
    pub fn planets_on_bearings(&self, m: &mut Model, n: usize, sun: Gear, ring: Gear, carrier: Gear) {
        let (mass, inertia) = inertia(m);
        let kb = m.parameter("kb_p", "N/m", None, Range::NotNegative, "radial stiffness of a planet's bearing");
        for i in 1..=n {
            let place = std::f64::consts::TAU * (i - 1) as f64 / n as f64;
            let psi = m.parameter(&format!("psi{i}"), "rad", Some(place), Range::Any, &format!("place of planet {i}"));
            let psi = Direction { cos: m.constant(&format!("cos{i}"), psi.cos()), sin: m.constant(&format!("sin{i}"), psi.sin()) };
            let zeta = m.coordinate(&format!("zeta{i}"), "m", Start::Static, &format!("radial displacement of planet {i}"));
            let eta = m.coordinate(&format!("eta{i}"), "m", Start::Static, &format!("tangential displacement of planet {i} beyond the carrier's rotation"));
            let tangential = self.a * self.theta_c + eta;
            m.kinetic(half(mass * zeta.dot().sq()));
            m.kinetic(half(mass * tangential.dot().sq()));
            let carrier = carrier.seen_from(psi);
            m.potential(half(kb * (carrier.radial - zeta).sq()));
            m.potential(half(kb * (carrier.tangential - eta).sq()));
            let planet = Seen { radial: zeta, tangential, u: self.rotation(m, i, inertia) };
            self.meshes(m, i, sun.seen_from(psi), ring.seen_from(psi), planet);
        }
    }

    /// Planet `i` turns: its rotation times its base radius.
    fn rotation(&self, m: &mut Model, i: usize, inertia: Expr) -> Expr {
        let doc = format!("rotation of planet {i} beyond rolling, times its base radius");
        let beyond = m.coordinate(&format!("u{i}"), "m", Start::Static, &doc);
        let u = self.r_p * self.theta_c - self.rho + beyond;
        m.kinetic(half(inertia * (u.dot() / self.r_p).sq()));
        u
    }

    fn meshes(&self, m: &mut Model, i: usize, sun: Seen, ring: Seen, planet: Seen) {
        mesh(m, &format!("s{i}"), &format!("mesh of sun and planet {i}"), self.theta, external(sun, planet, self.alpha));
        mesh(m, &format!("r{i}"), &format!("mesh of ring and planet {i}"), self.theta, internal(ring, planet, self.alpha));
    }
}

fn inertia(m: &mut Model) -> (Expr, Expr) {
    let mass = m.parameter("m_p", "kg", None, Range::Positive, "mass of a planet");
    (mass, m.parameter("I_p", "kg*m^2", None, Range::Positive, "moment of inertia of a planet"))
}
