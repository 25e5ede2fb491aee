//! Torques that drive or load a rotor. Motor and load of the effect `torques` are constant, or vary in time if a scene says so. The torque
//! of the other machines depends on the speed.

use gearsim_derive::{Expr, Model, Range};

use super::{dc_motor, fan, governor, induction_motor, named, traction_motor};

/// Adds a constant torque that drives a rotor, and all [`machines`]. `theta` \[rad\] is the rotation of the rotor.
pub fn driven(m: &mut Model, part: &str, what: &str, theta: Expr) {
    drive(m, part, what, theta);
    machines(m, part, what, theta);
}

/// Adds a constant torque that loads a rotor, and all [`machines`]. `theta` \[rad\] is the rotation of the rotor.
pub fn loaded(m: &mut Model, part: &str, what: &str, theta: Expr) {
    load(m, part, what, theta);
    machines(m, part, what, theta);
}

/// Adds the machines whose torque depends on the speed of a rotor: a motor with a speed governor, a DC motor, an induction motor, a traction
/// motor, and a fan. Each is an effect of this rotor. A scene has at most one motor on a rotor. Above the speed at which its torque is zero, a
/// motor brakes as a generator, so that it can be a load too. `theta` \[rad\] is the rotation of the rotor.
pub fn machines(m: &mut Model, part: &str, what: &str, theta: Expr) {
    // A named deflection, so that the equations are written in its rate.
    let omega = m.deflection(&named("theta", part), theta).dot();
    let motors = [governor, dc_motor, induction_motor, traction_motor].map(|add| add(m, part, what, theta, omega));
    for (i, motor) in motors.iter().enumerate() {
        let others: Vec<&str> = motors[i + 1..].iter().map(String::as_str).collect();
        m.exclude(motor, &others);
    }
    fan(m, part, what, theta, omega);
}

/// A motor that drives a body with the rotation `theta` \[rad\]. Declares its torque `T`.
pub fn drive(m: &mut Model, part: &str, what: &str, theta: Expr) {
    torque(m, part, &format!("driving torque of the {what}"), theta);
}

/// A load on a body with the rotation `theta` \[rad\], against that rotation. Declares its torque `T`.
pub fn load(m: &mut Model, part: &str, what: &str, theta: Expr) {
    torque(m, part, &format!("load torque of the {what}, against its rotation"), -theta);
}

fn torque(m: &mut Model, part: &str, doc: &str, through: Expr) {
    m.effect("torques", "constant torques of motor and load", |m| {
        let value = m.parameter(&named("T", part), "N*m", None, Range::Any, doc);
        m.torque(part, value, through, doc);
    });
}
