//! Elements that drive, load and brake.

use gearsim_derive::{Expr, Model};

use super::coordinate;
use crate::components;

/// Viscous friction.
pub fn viscous(m: &mut Model) {
    let theta = begin(m, "viscous friction");
    components::viscous(m, "x", "{}", theta);
}

/// A torque that drives.
pub fn drive(m: &mut Model) {
    let theta = begin(m, "a drive");
    components::drive(m, "x", "drive {}", theta);
}

/// A torque against the rotation.
pub fn load(m: &mut Model) {
    let theta = begin(m, "a load");
    components::load(m, "x", "load {}", theta);
}

/// A motor with a speed governor.
pub fn governor(m: &mut Model) {
    motor(m, "a motor with a speed governor", components::governor);
}

/// A DC motor.
pub fn dc_motor(m: &mut Model) {
    motor(m, "a DC motor", components::dc_motor);
}

/// An induction motor.
pub fn induction_motor(m: &mut Model) {
    motor(m, "an induction motor", components::induction_motor);
}

/// A traction motor.
pub fn traction_motor(m: &mut Model) {
    motor(m, "a traction motor", components::traction_motor);
}

/// A fan as load.
pub fn fan(m: &mut Model) {
    motor(m, "a fan", components::fan);
}

fn motor(m: &mut Model, title: &str, add: fn(&mut Model, &str, &str, Expr, Expr) -> String) {
    let theta = begin(m, title);
    add(m, "x", "drive {}", theta, theta.dot());
}

fn begin(m: &mut Model, title: &str) -> Expr {
    m.title(title);
    m.source("an element of trains");
    coordinate(m, "theta", "rad", "rotation")
}
