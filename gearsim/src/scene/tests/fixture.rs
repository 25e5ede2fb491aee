//! A model of a gear pair without equations, and a scene of it.

use std::f64::consts::TAU;

use crate::model::{
    Coordinate, Effect, Law, Model, Parameter, Range, RigidMotion, Role, Start, Switching, Torque, Varies,
};
use crate::scene::{Scene, SceneMistakes};

const POSITIVE: Range = Range { low: 0.0, high: f64::INFINITY, low_included: false, high_included: false };
const NOT_NEGATIVE: Range = Range { low_included: true, ..POSITIVE };
const ANY: Range = Range { low: f64::NEG_INFINITY, ..POSITIVE };

const fn parameter(
    name: &'static str,
    unit: &'static str,
    default: Option<f64>,
    range: Range,
    doc: &'static str,
) -> Parameter {
    let varies = if matches!(name.as_bytes(), b"T0") { Varies::AsLoad } else { Varies::Never };
    Parameter { name, unit, default, with: None, gear_data: None, varies, range, above: None, doc }
}

const fn effect(name: &'static str, requires: &'static [&'static str], excludes: &'static [&'static str]) -> Effect {
    Effect { name, of: None, doc: "", requires, excludes, switching: None, bends: false }
}

const fn law(name: &'static str, unit: &'static str, with: Option<&'static str>, role: Role, doc: &'static str) -> Law {
    Law { name, unit, phase: "theta", period: TAU, rolling: true, held: &[], with, role, doc }
}

pub static GEAR_PAIR: Model = Model {
    name: "gear_pair",
    title: "Two spur gears on rigid shafts",
    source: "Oh, Grosh & Barber (2005)",
    coordinates: &[
        Coordinate { name: "theta", unit: "rad", doc: "mesh phase", start: Start::At(0.0) },
        Coordinate { name: "phi", unit: "rad", doc: "mesh deflection", start: Start::Static },
    ],
    parameters: &[
        parameter("I1", "kg*m^2", None, POSITIVE, "moment of inertia of the driving gear"),
        parameter("I2", "kg*m^2", None, POSITIVE, "moment of inertia of the driven gear"),
        parameter("N1", "1", Some(24.0), POSITIVE, "teeth of the driving gear"),
        parameter("N2", "1", Some(96.0), POSITIVE, "teeth of the driven gear"),
        parameter("zeta", "1", Some(0.0), NOT_NEGATIVE, "damping ratio"),
        parameter("T0", "N*m", Some(10.0), ANY, "driving torque"),
    ],
    outputs: &[],
    elements: &[],
    switches: &[],
    nonlinear: "",
    nonlinear_with: &[],
    laws: &[
        law("k", "N*m", None, Role::Stiffness, "mesh stiffness"),
        law("e", "rad", Some("transmission_error"), Role::Error, "transmission error"),
        law("side", "1", Some("sliding_friction"), Role::Side, "side of the pitch point"),
        law("arm", "rad", Some("sliding_friction"), Role::Arm, "arm about it"),
    ],
    motions: &[RigidMotion { name: "speed", unit: "rad/s", doc: "rotational speed of the driving gear" }],
    effects: &[
        Effect { switching: Some(Switching::WithJump), ..effect("stiffness_step", &[], &[]) },
        effect("rigid_kinematics", &["stiffness_step"], &["frozen_phase"]),
        effect("frozen_phase", &["stiffness_step"], &["rigid_kinematics"]),
        effect("damping", &[], &[]),
        effect("torques", &[], &[]),
        effect("transmission_error", &["stiffness_step"], &[]),
        effect("sliding_friction", &["stiffness_step"], &["rigid_kinematics", "frozen_phase"]),
    ],
    torques: &[
        Torque { name: "drive", with: &["torques"], doc: "" },
        Torque { name: "load", with: &["torques"], doc: "" },
    ],
    equations: "",
    latex: "",
    relative: &[],
};

pub const SCENE: &str = r#"about = "Gear pair at 300 rpm"
model = "gear_pair"
effects = ["stiffness_step", "damping", "torques"]

[parameters]
I1 = "2890 kg*mm^2"
I2 = "740200 kg*mm^2"
zeta = 0.1

[laws.k]
steps = [
    { value = "1.43 kN*m", width = "1.73 rad" },
    { value = "2.78 kN*m" },
]

[start]
speed = "300 rpm"
theta = 0
phi = "static"

[run]
t_end = "0.1 s"

[output]
rate = "20 kHz"
"#;

pub fn parse(text: &str, overrides: &[&str]) -> Result<Scene, SceneMistakes> {
    let overrides: Vec<_> = overrides.iter().map(|text| text.to_string()).collect();
    Scene::parse("energy", "scenes/energy.toml", text, &overrides, &[&GEAR_PAIR])
}
