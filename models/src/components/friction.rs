//! Coulomb friction between the flanks of a mesh, in the effect `sliding_friction`.
//!
//! A pair of teeth touches on the line of action at xi from the pitch point, positive in recess. There the flanks slide on each
//! other with tau' + xi psi': the gears roll with psi' = omega1 + omega2, and tau' is what the flanks slide at the pitch point,
//! tan(alpha) times the rate at which the gears turn against each other along the line of action, and the motion of their centres
//! across it. A pair that bears the share s of the mesh force F has the friction mu s |F|, in the direction against
//! rigid rolling, sgn(xi psi'). All pairs together do the work
//!
//! ```text
//! dW = -mu |F| sgn(psi') (side dtau + arm dpsi),     side = sum s_i sgn(xi_i),   arm = sum s_i |xi_i| >= 0
//! ```
//!
//! with laws of the phase, side and arm, that follow from the teeth. Rolling so takes energy, whichever way the gears turn; what
//! is done over tau comes and goes with the deflection. Friction of this kind in the dynamics of gears: M. Vaishya, R. Singh,
//! J. Sound Vib. 243 (2001); S. He, R. Gunda, R. Singh, J. Sound Vib. 301 (2007).
//!
//! Two corners are rounded. sgn(psi') is psi'/(psi'² + w_mix²)^(1/2): less friction at low speed, none at rest, no
//! stiction. And |F| is k (delta² + tiny²)^(1/2), tiny = 1e-12, far below any deflection that matters: so F has slopes at zero load.
//! F is the spring's force, without the damper's; a mesh on its coast flank rubs as on its drive flank.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, Friction, Model, Range};

use super::{Mesh, named};

/// How the flanks of a mesh slide.
#[derive(Clone, Copy)]
pub struct Sliding {
    /// The phase of the mesh, a coordinate [rad]; one pitch is 2 pi.
    pub phase: Expr,
    /// What they slide at the pitch point [unit of the mesh's deflection], positive where the driving gear is ahead.
    pub tau: Expr,
    /// The sum of the gears' rotations, each positive as it drives or is driven [rad].
    pub psi: Expr,
}

/// Friction in a mesh whose deflection has the `unit`. Declares the laws `side` [1] and `arm` [unit], both periodic in the phase, the
/// coefficient `mu`, and the rolling speed `w_mix` below which it fades.
pub fn sliding_friction(m: &mut Model, part: &str, what: &str, unit: &str, mesh: Mesh, sliding: Sliding) {
    m.sliding_friction(|m| {
        let doc = format!("coefficient of friction of the {what}");
        let mu = m.parameter(&named("mu", part), "1", None, Range::NotNegative, &doc);
        let doc = format!(
            "rolling speed, omega1 + omega2, of the {what} below which friction fades (mixed film), and is zero at rest"
        );
        let mixed = m.parameter(&named("w_mix", part), "rad/s", Some(0.1), Range::Positive, &doc);
        let Sliding { phase, tau, psi } = sliding;
        let mut law = |quantity, unit: &str, which, says| {
            let doc = format!("{says} of the {what}");
            m.friction_law(&named(quantity, part), unit, phase, TAU, which, &doc)
        };
        let says = "share of the force on pairs of teeth beyond the pitch point, less that on pairs before it,";
        let side = law("side", "1", Friction::Side, says);
        let says = "mean distance of the force from the pitch point along the line of action";
        let arm = law("arm", unit, Friction::Arm, says);
        let tiny = m.constant(&named("tiny", part), Expr::from(1) / 1_000_000_000_000);
        let tau = m.deflection(&named("tau", part), tau);
        let psi = m.deflection(&named("psi", part), psi);
        let direction = psi.dot() / (psi.dot().sq() + mixed.sq()).sqrt();
        let friction = mu * mesh.stiffness * (mesh.delta.sq() + tiny.sq()).sqrt() * direction;
        let friction = m.force(&named("F_mu", part), friction);
        let doc = format!("friction of the {what}, over what the flanks slide at the pitch point");
        m.torque(&named("slide", part), -side * friction, tau, &doc);
        let doc = format!("friction of the {what}, over their rolling");
        m.torque(&named("roll", part), -arm * friction, psi, &doc);
    });
}

/// The tangent of the pressure angle, for a model that needs it for friction alone. Declares `alpha`.
pub fn pressure_tangent(m: &mut Model) -> Expr {
    let mut tangent = Expr::from(0);
    m.sliding_friction(|m| {
        let doc = "working pressure angle, for friction";
        let alpha = m.parameter("alpha", "rad", Some(20f64.to_radians()), Range::Positive, doc);
        tangent = m.constant("tan_a", alpha.sin() / alpha.cos());
    });
    tangent
}
