//! Coulomb friction between the flanks of a mesh, in the effect `sliding_friction`.
//!
//! A tooth pair touches on the line of action at the distance xi from the pitch point, positive in recess. There the flanks slide
//! on each other with the speed tau' + xi psi'. The rolling speed is psi' = omega1 + omega2. tau' is the sliding speed at the
//! pitch point: tan(alpha) times the relative speed of the gears along the line of action, plus the relative speed of their
//! centres across it. A pair that carries the share s of the mesh force F has the friction force mu s |F|, against the sliding of
//! rigid rolling, whose sign is sgn(xi psi'). The work of all pairs is
//!
//! ```text
//! dW = -mu sgn(psi') (F side dtau + |F| arm dpsi),     side = sum s_i sgn(xi_i),   arm = sum s_i |xi_i| >= 0
//! ```
//!
//! F is negative on the coast flank. Its line of action is the mirror image of that of the drive flank about the line of centres. In the mirror
//! the gears turn backward, and recess is approach: the sliding speed there is -tau' + xi psi', with xi positive in recess as before. Where
//! gears move in the plane, tau is another sum of their motions on the coast flank ([`super::gear`]), and |F| stands in place of F.
//!
//! The work is described by two laws of the phase, side and arm, that follow from the tooth geometry. The rolling part dissipates energy in either
//! direction of rotation; the work over tau changes its sign with the deflection. Sources for this friction in gear dynamics:
//! M. Vaishya, R. Singh, J. Sound Vib. 243 (2001); S. He, R. Gunda, R. Singh, J. Sound Vib. 301 (2007).
//!
//! Two functions are smoothed. sgn(psi') is replaced by psi'/(psi'² + w_mix²)^(1/2): friction decreases at low speed and is zero at
//! rest. |F| is replaced by k (delta² + tiny²)^(1/2), which is differentiable at zero load; tiny = 1e-12 in
//! the unit of delta is far below any deflection of interest. F = k delta is the force of the mesh spring without that of the damper.
//! Laws from tooth data are those of the drive flank. The laws of the coast flank would differ, because they depend on the backlash and on
//! where the contact begins.
//!
//! With this law flanks do not stick: gears at rest under load creep with psi' = w_mix x/(1 - x²)^(1/2), where x is the generalised force
//! of the other torques along psi, divided by mu |F| arm. The effect `flank_stiction` ([`super::stiction`]) makes them stick.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, Factor, GearData, Model, Range};

use super::observed::of_part;
use super::steps::{STIFFNESS_STEP, steps};
use super::{FLANK_STICTION, Mesh, Stiction, flank_stiction, named};

/// The kinematics of the sliding between the flanks of a mesh.
#[derive(Clone, Copy)]
pub struct Sliding {
    /// The phase of the mesh, a coordinate \[rad\]; one pitch is 2 pi.
    pub phase: Expr,
    /// Sliding distance at the pitch point [unit of the mesh deflection], positive if the driving gear is ahead; in a plane mesh that of the flanks
    /// in contact ([`Mesh::on_flanks`]).
    pub tau: Expr,
    /// The sum of the rotations of both gears \[rad\], each positive in its direction of rotation in normal drive.
    pub psi: Expr,
}

/// Friction in a mesh whose deflection has the unit `unit`. Declares the laws `side` \[1\] and `arm` [unit], which are periodic in the phase, the
/// coefficient of friction `mu`, and the rolling speed `w_mix` [rad/s] below which friction decreases. Also declares the effect
/// `flank_stiction`: the flanks then stick.
pub fn sliding_friction(m: &mut Model, part: &str, what: &str, unit: &str, mesh: Mesh, sliding: Sliding) {
    let effect = friction_effect(m, part, |m| {
        let doc = format!("coefficient of friction of the {what}");
        let mu = m.parameter(&named("mu", part), "1", None, Range::NotNegative, &doc);
        let doc =
            format!("rolling speed omega1 + omega2 of the {what} below which friction decreases to zero (mixed film)");
        let mixed = m.parameter(&named("w_mix", part), "rad/s", Some(0.1), Range::Positive, &doc);
        let Sliding { phase, tau, psi } = sliding;
        let mut law =
            |quantity, unit: &str, which, doc: &str| m.factor_law(&named(quantity, part), unit, phase, TAU, which, doc);
        let doc = format!(
            "share of the force of the {what} on tooth pairs beyond the pitch point, minus that on pairs before it"
        );
        let side = law("side", "1", Factor::Side, &doc);
        let doc = format!("mean distance of the force of the {what} from the pitch point along the line of action");
        let arm = law("arm", unit, Factor::Arm, &doc);
        let tiny = m.constant(&named("tiny", part), Expr::from(1) / 1_000_000_000_000);
        let tau = m.deflection(&named("tau", part), tau);
        let stiction = Stiction { psi, tau, side, arm, mu };
        let sticking = flank_stiction(m, part, what, mesh, stiction);
        let psi = sticking.psi;
        let direction = psi.dot() / (psi.dot().sq() + mixed.sq()).sqrt();
        let distance = (mesh.delta.sq() + tiny.sq()).sqrt();
        let size = mu * mesh.stiffness * distance;
        let smoothed = size * direction;
        let friction = m.force(&named("F_mu", part), smoothed + sticking.instead(m, smoothed, size));
        let along_tau = match mesh.flank {
            // delta/distance is the smoothed sign of F, which is the sign of the flank in contact.
            None => m.force(&named("F_tau", part), friction * mesh.delta / distance),
            Some(_) => friction,
        };
        let doc = format!("friction of the {what}, through the sliding of the flanks at the pitch point");
        m.torque(&named("slide", part), -side * along_tau, tau, &doc);
        let doc = format!("friction of the {what}, through the rolling of the gears");
        m.torque(&named("roll", part), -arm * friction, psi, &doc);
    });
    m.require(&of_part(FLANK_STICTION, part), &[&effect]);
}

/// Declares the effect `sliding_friction` of a part. The terms that `add` adds are in the equations only if a scene names this effect.
/// Returns its name.
pub fn friction_effect(m: &mut Model, part: &str, add: impl FnOnce(&mut Model)) -> String {
    steps(m);
    let doc = "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
    let effect = m.part_effect("sliding_friction", part, doc, add);
    m.require(&effect, &[STIFFNESS_STEP]);
    effect
}

/// The tangent of the pressure angle, for models in which only friction needs it. Declares the pressure angle `alpha` \[rad\] and its tangent
/// `tan_a`.
pub fn pressure_tangent(m: &mut Model) -> Expr {
    tangent_of(m, "", "working pressure angle, for friction")
}

/// As [`pressure_tangent`], for one mesh: declares `alpha12` \[rad\] and `tan_a12` for the mesh `12`.
pub fn pressure_tangent_of(m: &mut Model, part: &str, what: &str) -> Expr {
    tangent_of(m, part, &format!("working pressure angle of the {what}, for friction"))
}

fn tangent_of(m: &mut Model, part: &str, doc: &str) -> Expr {
    let alpha = m.gear_data(GearData::PressureAngle, &named("alpha", part), Some(20f64.to_radians()), doc);
    m.constant(&named("tan_a", part), alpha.sin() / alpha.cos())
}
