//! A planetary stage: sun `s`, ring `r`, carrier `c` and n planets, as Lin & Parker (1999), J. Vib. Acoust. 121(3).
//!
//! All meshes of a stage have the same phase, theta = Z_s (theta_s - theta_c), in which one pitch is 2 pi. The rolling distance along
//! the line of action is rho = h theta with h = r_s/Z_s. If ring and gears are rigid and the ring is at rest, the carrier turns by
//! rho/r_r, and a planet by -rho/r_p relative to the carrier. The coordinates of carrier and planets are their motions in excess of
//! this rigid rolling, so that no deflection depends on theta. Angles are counterclockwise. The frame turns with the carrier;
//! gyroscopic terms are neglected.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, GearData, Model, Range, Start, half};

use super::gear::Direction;
use super::{
    Flanks, Gear, Sliding, bearing_damper, external, external_sliding, internal, internal_sliding, mesh_in_plane,
    mesh_with_play, observed, sliding_friction,
};

/// The geometry of a stage and its rotations.
#[derive(Clone, Copy)]
pub struct Stage {
    /// The phase of its meshes, a coordinate \[rad\]; one pitch is 2 pi.
    pub theta: Expr,
    /// Rotation of the sun \[rad\].
    pub theta_s: Expr,
    /// Rotation of the carrier \[rad\].
    pub theta_c: Expr,
    /// Rotation of the carrier in excess of rigid rolling, a coordinate \[rad\].
    excess: Expr,
    /// Base radius of the sun \[m\].
    pub r_s: Expr,
    /// Base radius of the ring \[m\].
    pub r_r: Expr,
    /// Radius of the circle of the planets' centres \[m\].
    pub a: Expr,
    /// Speed of theta per speed of the sun, with the ring at rest.
    pub per_sun: Expr,
    /// Base radius of a planet \[m\]: in parameters, and as a named constant.
    r_p: [Expr; 2],
    /// `a` as a named constant.
    named_a: Expr,
    /// The pressure angle as a direction.
    alpha: Direction,
    /// Rolling distance along the line of action \[m\].
    rho: Expr,
    /// Rotations of the sun and of the ring relative to a planet, per theta, if all roll rigidly and the ring is at rest.
    per_theta: [Expr; 2],
}

/// Declares the geometry of a stage (`Z_s`, `Z_r`, `r_s`, `alpha`), and the coordinates `theta` and `theta_c`.
#[allow(non_snake_case)] // the field's symbols
pub fn stage(m: &mut Model) -> Stage {
    let Z_s = m.gear_data(GearData::Teeth, "Z_s", None, "number of teeth of the sun");
    let Z_r = m.gear_data(GearData::Teeth, "Z_r", None, "number of teeth of the ring");
    let r_s = m.gear_data(GearData::BaseRadius, "r_s", None, "base radius of the sun");
    let angle = m.gear_data(GearData::PressureAngle, "alpha", Some(20f64.to_radians()), "pressure angle");
    let alpha = Direction { cos: m.constant("cos_a", angle.cos()), sin: m.constant("sin_a", angle.sin()) };
    let h = m.constant("h", r_s / Z_s);
    // In parameters where theta must cancel symbolically, as named constants elsewhere.
    let (r_p, a) = (half(h * (Z_r - Z_s)), half(h * (Z_r + Z_s)) / alpha.cos);
    let (named_r_p, named_a) = (m.constant("r_p", r_p), m.constant("a", a));
    let against = [("roll_s", h / named_r_p + 1 / Z_s), ("roll_r", h / named_r_p - 1 / Z_r)];
    let per_theta = against.map(|(name, value)| m.constant(name, value));
    let theta = m.coordinate("theta", "rad", Start::At(0.0), "phase of the meshes, Z_s (theta_s - theta_c)");
    let beyond = m.coordinate("theta_c", "rad", Start::Static, "rotation of the carrier in excess of rigid rolling");
    Stage {
        theta,
        theta_s: theta / Z_s + theta / Z_r + beyond,
        theta_c: theta / Z_r + beyond,
        excess: beyond,
        r_s: h * Z_s,
        r_r: h * Z_r,
        a,
        per_sun: Z_s * Z_r / (Z_s + Z_r),
        r_p: [r_p, named_r_p],
        named_a,
        alpha,
        rho: h * theta,
        per_theta,
    }
}

impl Stage {
    /// Adds `n` planets with their centres fixed to the carrier, and their meshes with a sun on a fixed axis and a ring with the
    /// rotation `theta_r` \[rad\]. Declares mass `m_p` \[kg\] and inertia `I_p` \[kg m²\] of a planet, and for each planet a coordinate
    /// (`u1`, ...). For its meshes with sun and ring (`s1`, `r1`, ...) declares what [`mesh_with_play`] and [`sliding_friction`] declare.
    pub fn planets(&self, m: &mut Model, n: usize, theta_r: Expr) {
        let (mass, inertia) = inertia(m);
        m.kinetic(half(n as i64 * mass * (self.named_a * self.theta_c.dot()).sq()));
        let gears = [Gear::centred(self.r_s * self.theta_s), Gear::centred(self.r_r * theta_r)];
        for i in 1..=n {
            let (beyond, u) = self.rotation(m, i, inertia);
            let planet = Gear { x: 0.into(), y: self.a * self.theta_c, u };
            self.meshes(m, i, gears, None, (planet, beyond), theta_r);
        }
    }

    /// Adds `n` planets on bearings on the carrier, and their meshes with sun and ring. Declares mass `m_p`, inertia `I_p` and
    /// bearing stiffness `kb_p` and damping `cb_p` of a planet, for each planet its angular position `psi1`, ... and its coordinates `zeta1` (radial),
    /// `eta1` (tangential), `u1` (rotation), ..., and the laws of its meshes.
    pub fn planets_on_bearings(
        &self,
        m: &mut Model,
        n: usize,
        sun: Gear,
        (ring, theta_r): (Gear, Expr),
        carrier: Gear,
    ) {
        let (mass, inertia) = inertia(m);
        let kb = m.parameter("kb_p", "N/m", None, Range::NotNegative, "radial stiffness of a planet's bearing");
        let mut damped = vec![];
        for i in 1..=n {
            let place = TAU * (i - 1) as f64 / n as f64;
            let doc = format!("angular position of planet {i}");
            let psi = m.parameter(&format!("psi{i}"), "rad", Some(place), Range::Any, &doc);
            let mut constant = |name: &str, value| m.constant(&format!("{name}{i}"), value);
            let l_c = Direction { cos: constant("cos_c", psi.cos()), sin: constant("sin_c", psi.sin()) };
            // The lines of action are at the angles psi - alpha and psi + alpha. Both have these products, with different signs.
            let Direction { cos, sin } = self.alpha;
            let (cc, ss) = (constant("cc", l_c.cos * cos), constant("ss", l_c.sin * sin));
            let (sc, cs) = (constant("sc", l_c.sin * cos), constant("cs", l_c.cos * sin));
            let l_s = Direction { cos: cc + ss, sin: sc - cs };
            let l_r = Direction { cos: cc - ss, sin: sc + cs };
            let coordinate =
                |m: &mut Model, name: &str, doc: &str| m.coordinate(&format!("{name}{i}"), "m", Start::Static, doc);
            let zeta = coordinate(m, "zeta", &format!("radial displacement of planet {i}"));
            let doc = format!("tangential displacement of planet {i} in excess of the rotation of the carrier");
            let eta = coordinate(m, "eta", &doc);
            let (beyond, u) = self.rotation(m, i, inertia);
            let planet = Gear { x: zeta, y: self.a * self.theta_c + eta, u };
            m.kinetic(half(mass * zeta.dot().sq()));
            m.kinetic(half(mass * (self.named_a * self.theta_c.dot() + eta.dot()).sq()));
            let radial = m.deflection(&format!("radial{i}"), carrier.x * l_c.cos + carrier.y * l_c.sin - zeta);
            let tangential = m.deflection(&format!("tangential{i}"), carrier.across(l_c) - eta);
            m.potential(half(kb * radial.sq()));
            m.potential(half(kb * tangential.sq()));
            damped.extend([radial, tangential]);
            observed::planet_bearing(m, &i.to_string(), [radial, tangential]);
            self.meshes(m, i, [sun, ring], Some([l_s, l_r]), (planet, beyond), theta_r);
        }
        bearing_damper(m, "p", "bearing of a planet", &damped);
    }

    /// The rotation of planet `i` in excess of rigid rolling, and its whole rotation, both times its base radius \[m\]. Adds the kinetic energy of
    /// the rotation.
    fn rotation(&self, m: &mut Model, i: usize, inertia: Expr) -> (Expr, Expr) {
        let doc = format!("rotation of planet {i} in excess of rigid rolling, times its base radius");
        let beyond = m.coordinate(&format!("u{i}"), "m", Start::Static, &doc);
        let [r_p, named] = self.r_p;
        m.kinetic(half(inertia * (self.theta_c.dot() + (beyond - self.rho).dot() / named).sq()));
        (beyond, r_p * self.theta_c - self.rho + beyond)
    }

    /// Adds the meshes of planet `i` with sun and ring. `lines` are the directions of the lines of action in the frame of sun and ring, if
    /// these move in the plane: first at the angle psi - alpha, then at psi + alpha, where psi is the angular position of the planet and
    /// alpha the pressure angle. The drive flanks of the sun's mesh have the first line and those of the ring's mesh the second; the coast
    /// flanks have the other one. `beyond` \[m\] is the rotation of the planet in excess of rigid rolling, times its base radius. `theta_r`
    /// \[rad\] is the rotation of the ring.
    fn meshes(
        &self,
        m: &mut Model,
        i: usize,
        [sun, ring]: [Gear; 2],
        lines: Option<[Direction; 2]>,
        (planet, beyond): (Gear, Expr),
        theta_r: Expr,
    ) {
        let Stage { theta, excess, alpha, per_theta: [roll_s, roll_r], r_p: [_, r_p], .. } = *self;
        // In the frame of the planet the lines of action are at the angles -alpha and alpha.
        let own = [alpha.mirrored(), alpha];
        let (in_plane, lines) = (lines.is_some(), lines.unwrap_or(own));
        let tangent = alpha.sin / alpha.cos;
        // The rotations relative to the planet, theta_s - theta_p and theta_r - theta_p, with theta_p = theta_c + (beyond - rho)/r_p.
        let psi_s = roll_s * theta - beyond / r_p;
        let psi_r = theta_r - excess + roll_r * theta - beyond / r_p;
        let of_sun = |l: usize, tangent: Expr| Side {
            delta: external(sun, lines[l], planet, own[l]),
            tau: external_sliding(sun, lines[l], planet, own[l], tangent),
            driving: sun.across(lines[l]) + sun.u,
        };
        let of_ring = |l: usize, tangent: Expr| Side {
            delta: internal(ring, lines[l], planet, own[l]),
            tau: internal_sliding(ring, lines[l], planet, own[l], tangent),
            driving: ring.across(lines[l]) + ring.u,
        };
        let meshes = [
            ("s", "sun", [of_sun(0, tangent), of_sun(1, -tangent)], psi_s),
            ("r", "ring", [of_ring(1, tangent), of_ring(0, -tangent)], psi_r),
        ];
        for (part, with, [drive, coast], psi) in meshes {
            let (part, what) = (format!("{part}{i}"), format!("mesh of {with} and planet {i}"));
            let mesh = match in_plane {
                true => {
                    let flanks = Flanks::of(drive.delta, coast.delta);
                    mesh_in_plane(m, &part, &what, theta, flanks, [drive.driving, coast.driving])
                }
                false => mesh_with_play(m, &part, &what, theta, drive.delta, drive.driving),
            };
            let tau = mesh.on_flanks(drive.tau, coast.tau);
            sliding_friction(m, &part, &what, "m", mesh, Sliding { phase: theta, tau, psi });
        }
    }
}

/// The motion of a mesh along and across the line of action of one flank \[m\].
struct Side {
    /// Its deflection.
    delta: Expr,
    /// Its sliding distance at the pitch point.
    tau: Expr,
    /// Displacement of the first gear's flank.
    driving: Expr,
}

/// Declares mass and moment of inertia of a planet.
fn inertia(m: &mut Model) -> (Expr, Expr) {
    let mass = m.parameter("m_p", "kg", None, Range::Positive, "mass of a planet");
    (mass, m.parameter("I_p", "kg*m^2", None, Range::Positive, "moment of inertia of a planet"))
}
