//! A universal (Cardan, Hooke's) joint between two shafts at an angle.
//!
//! With beta the angle between the shafts, tan theta_out = tan theta_in/cos beta if theta_in is counted from the position in which the
//! driving fork is perpendicular to the plane of the shafts. Hence theta_out' = cos beta/(1 - sin² beta cos² theta_in) theta_in'.
//! Source: e.g. Seherr-Thoss, Schmelz & Aucktor, Universal Joints and Driveshafts, Ch. 1.

use gearsim_derive::{Expr, Model, Range};

use super::named;
use super::observed::of_part;

/// The speed [rad/s] of the shaft behind a universal joint whose driving shaft has the rotation `theta` \[rad\]. Declares the angle
/// between the shafts `beta`. The joint itself has no mass. Give the shaft behind it an inertia with [`Model::kinetic`] and torques
/// with [`Model::torque_along`]; its angle is not needed.
pub fn universal_joint(m: &mut Model, part: &str, theta: Expr) -> Expr {
    let doc = "angle between the shafts of the universal joint, less than a quarter turn";
    let beta = m.parameter(&named("beta", part), "rad", None, Range::NotNegative, doc);
    let fork = m.deflection(&named("fork", part), theta);
    let ratio = m.function(&named("ratio", part), fork, |theta| beta.cos() / (1 - (beta.sin() * theta.cos()).sq()));
    let speed = ratio * theta.dot();
    m.output(&of_part("joint_speed", part), "rad/s", speed, "rotational speed behind the universal joint");
    speed
}
