//! The effects `stiffness_step`, `rigid_kinematics` and `frozen_phase`. They decide how the laws of a mesh change where tooth pairs enter and
//! leave contact: Oh, Grosh & Barber (2005), Eqs. (2)-(6).

use gearsim_derive::{Boundary, Model};

/// The effect without which laws are constant. Effects that add laws require it.
pub const STIFFNESS_STEP: &str = "stiffness_step";
const RIGID_KINEMATICS: &str = "rigid_kinematics";
const FROZEN_PHASE: &str = "frozen_phase";

/// Declares the three effects. Every component with a law calls it.
pub fn steps(m: &mut Model) {
    let steps = "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
    let rigid = "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
    let frozen = "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
    for (name, how, doc) in [
        (STIFFNESS_STEP, Boundary::WithJump, steps),
        (RIGID_KINEMATICS, Boundary::WithoutJump, rigid),
        (FROZEN_PHASE, Boundary::ByTime, frozen),
    ] {
        m.effect(name, doc, |_| {});
        m.boundaries(name, how);
    }
    for (name, other) in [(RIGID_KINEMATICS, FROZEN_PHASE), (FROZEN_PHASE, RIGID_KINEMATICS)] {
        m.require(name, &[STIFFNESS_STEP]);
        m.exclude(name, &[other]);
    }
}
