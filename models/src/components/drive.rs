//! What drives and loads a rotor. Motor and load of the effect `torques` are constant, or vary in time if a scene says so; beside them are the
//! machines whose torque depends on the speed.

use gearsim_derive::{Expr, Model, Range};

use super::{dc_motor, fan, governor, induction_motor, named, traction_motor};

/// A rotor with the rotation `theta` \[rad\] that may have each drive: [`drive`] and [`machine`].
pub fn driven(m: &mut Model, part: &str, what: &str, theta: Expr) {
    drive(m, part, what, theta);
    machine(m, part, what, theta);
}

/// A rotor with the rotation `theta` \[rad\] that may have each load: [`load`] and [`fan`](fn@fan).
pub fn loaded(m: &mut Model, part: &str, what: &str, theta: Expr) {
    load(m, part, what, theta);
    let omega = speed(m, part, theta);
    fan(m, part, what, theta, omega);
}

/// Machines whose torque depends on the speed of the rotor with the rotation `theta` \[rad\]. Each is an effect of its own: a motor with a speed
/// governor, a DC motor, an induction motor, a traction motor. Above the speed at which its torque is zero, a machine brakes as a generator.
pub fn machine(m: &mut Model, part: &str, what: &str, theta: Expr) {
    let omega = speed(m, part, theta);
    governor(m, part, what, theta, omega);
    dc_motor(m, part, what, theta, omega);
    induction_motor(m, part, what, theta, omega);
    traction_motor(m, part, what, theta, omega);
    let one = ["speed_governor", "dc_motor", "induction_motor", "traction_motor"];
    for (i, effect) in one.iter().enumerate() {
        m.exclude(effect, &one[i + 1..]);
    }
}

/// The speed on which torques depend: named, so that the equations are written in it.
fn speed(m: &mut Model, part: &str, theta: Expr) -> Expr {
    m.deflection(&named("theta", part), theta).dot()
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
