//! The dynamic factor of a mesh, and beside it K_v of ISO 6336-1 \[1\]; for how long and how hard its teeth pull; as in the group `meshes`
//! of sweeps. The static force is computed
//! with the torques of the point, including the value of the parameter that holds its speed.

use super::{Measure, ResponsePoint};
use crate::analysis::orders::force;
use crate::analysis::pulling::Pulling;
use crate::model::{Model, Output, Role};

pub(super) const FACTOR: Measure = Measure {
    name: "dynamic_factor",
    unit: Some("1"),
    beside: Some(("kv_iso6336", "K_v of ISO 6336-1, method B")),
    is_of: is_mesh_force,
    value: |point, i| point.factors[i].as_ref().and_then(|of| of.factor.clone().ok()).unwrap_or(f64::NAN),
    lacks: |point, i| point.factors[i].as_ref().and_then(|of| of.factor.as_ref().err()).map(String::as_str),
};
pub(super) const ISO_6336: Measure = Measure {
    name: "kv_iso6336",
    beside: None,
    value: |point, i| point.factors[i].as_ref().and_then(|of| of.iso6336.clone().ok()).unwrap_or(f64::NAN),
    lacks: |point, i| point.factors[i].as_ref().and_then(|of| of.iso6336.as_ref().err()).map(String::as_str),
    ..FACTOR
};

/// Share of the time in which the teeth pull \[1\].
pub(super) const PULLING_SHARE: Measure = Measure {
    name: "pulling_share",
    beside: None,
    value: |point, i| pulling(point, i).map_or(f64::NAN, |pulling| pulling.share),
    lacks: |_, _| None,
    ..FACTOR
};
/// Largest pulling force.
pub(super) const LARGEST_PULL: Measure = Measure {
    name: "largest_pull",
    unit: None,
    value: |point, i| pulling(point, i).map_or(f64::NAN, |pulling| pulling.largest),
    ..PULLING_SHARE
};

fn pulling(point: &ResponsePoint, output: usize) -> Option<&Pulling> {
    point.factors[output].as_ref()?.pulling.as_ref()
}

fn is_mesh_force(model: &Model, output: &Output) -> bool {
    let stiffnesses = model.laws.iter().filter(|law| law.role == Role::Stiffness);
    stiffnesses.filter_map(|law| force(model, law.name)).any(|force| force.name == output.name)
}
