//! Flanks that stick, in the effect `flank_stiction`: Coulomb's law in place of the smoothed law of `sliding_friction`.
//!
//! The flanks slide on each other with the mean speed v = arm psi' + side tau', on the coast flank v = arm psi' - side tau'. Friction is F_mu along v.
//!
//! | mode | while | friction F_mu |
//! | --- | --- | --- |
//! | stuck | the force R along v that the friction resists is at most mu (1 + mu_rise) |F| | R, so that v = 0 |
//! | forward | v > 0 | mu |F| |
//! | backward | v < 0 | -mu |F| |
//!
//! and the same on the coast flank: stuck_coast, forward_coast, backward_coast.
//! F is the force of the mesh spring, without that of the damper. Its sign is that of the flank in contact, so that v and the bound of R are linear in
//! each mode. If a single tooth pair is in contact, side v = xi psi' + tau' is the sliding speed at its point of contact. If several are,
//! the stuck modes hold their mean sliding speed at zero.
//!
//! The stuck modes hold v, not psi'. The reaction then does no work, and the force along tau does not step where sliding begins. If psi'
//! alone were held, the flanks would break away at a torque that is wrong by the fraction mu tan(alpha), and then stick and slip in turn.

use gearsim_derive::{Expr, Model, Range};

use super::{Mesh, named};

/// Name of the effect.
pub const FLANK_STICTION: &str = "flank_stiction";

const DOC: &str =
    "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";

/// The quantities that decide whether the flanks of a mesh stick.
#[derive(Clone, Copy)]
pub struct Stiction {
    /// The sum of the rotations of both gears \[rad\], linear in the coordinates.
    pub psi: Expr,
    /// Sliding distance at the pitch point [unit of the mesh deflection], a named deflection.
    pub tau: Expr,
    /// The friction law `side` \[1\], see [`super::friction`].
    pub side: Expr,
    /// The friction law `arm` [unit of the mesh deflection], see [`super::friction`].
    pub arm: Expr,
    /// Coefficient of friction while the flanks slide.
    pub mu: Expr,
}

/// The symbols of flanks that stick.
#[derive(Clone)]
pub struct Sticking {
    /// The sum of the rotations of both gears, a named deflection.
    pub psi: Expr,
    /// 1 while the flanks slide forward, -1 while they slide backward, 0 while they stick.
    direction: Expr,
    effect: String,
}

/// Declares the effect `flank_stiction` of a part, the deflection `psi`, its switch, and the relative excess `mu_rise` of the static
/// coefficient of friction.
pub fn flank_stiction(m: &mut Model, part: &str, what: &str, mesh: Mesh, stiction: Stiction) -> Sticking {
    let Stiction { psi, tau, side, arm, mu } = stiction;
    let mut rise = Expr::from(0);
    let effect = m.part_effect(FLANK_STICTION, part, DOC, |m| {
        let doc = format!(
            "excess of the static coefficient of friction of the {what} over that of sliding, relative to that"
        );
        rise = m.parameter(&named("mu_rise", part), "1", Some(0.0), Range::NotNegative, &doc);
    });
    let doc = format!("whether the flanks of the {what} stick");
    let mut slip = m.switch(&named("psi", part), "rad", psi, &effect, &doc);
    let direction = slip.factor(&named("slide_dir", part), 0);
    let (psi, resisted) = (slip.over(), slip.reaction());
    let force = mu * (1 + rise) * mesh.stiffness * mesh.delta;
    let flanks = [("", "_coast", 1), ("_coast", "", -1)];
    for (flank, other, sign) in flanks {
        slip.mode(&format!("stuck{flank}"), &[0.into()])
            .holds()
            .rests()
            .counts("stuck")
            .unless(&format!("stuck{other}"), sign * mesh.delta)
            .until(&format!("forward{flank}"), sign * force - resisted)
            .until(&format!("backward{flank}"), sign * force + resisted);
    }
    for (flank, other, sign) in flanks {
        // In a plane mesh tau has the sign of the flanks in contact already.
        let of_tau = if mesh.flank.is_none() { sign } else { 1 };
        let sliding = arm * psi.dot() + of_tau * (side * tau.dot());
        for (mode, sense) in [("forward", 1), ("backward", -1)] {
            slip.mode(&format!("{mode}{flank}"), &[sense.into()])
                .until(&format!("{mode}{other}"), sign * mesh.delta)
                .until(&format!("stuck{flank}"), sense * sliding);
        }
    }
    Sticking { psi, direction, effect }
}

impl Sticking {
    /// What the effect adds to the `smoothed` friction, so that it has a constant direction and the given `size`.
    pub fn instead(&self, m: &Model, smoothed: Expr, size: Expr) -> Expr {
        m.only_with(&self.effect, size * self.direction - smoothed)
    }
}
