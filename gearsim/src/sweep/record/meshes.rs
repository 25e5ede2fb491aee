//! The dynamic factor of each mesh: the largest force over the force without vibration, and K_v of ISO 6336-1, method B.

use super::{Column, Ended, Group, column};
use crate::analysis::{dynamic_factor, orders};
use crate::model::{Law, Model, Role};

pub(super) const GROUP: Group = Group {
    name: "meshes",
    doc: "of every mesh after --from: its k_dynamic_factor and k_kv_iso6336",
    samples: true,
    limits: true,
    digits: false,
    outputs: true,
    columns,
    values,
};

/// The stiffnesses of meshes whose force or torque is an output.
fn meshes(model: &Model) -> impl Iterator<Item = &'static Law> {
    let laws: &'static [Law] = model.laws;
    let is_mesh = |law: &&Law| law.role == Role::Stiffness && orders::force(model, law.name).is_some();
    laws.iter().filter(is_mesh).collect::<Vec<_>>().into_iter()
}

fn columns(model: &Model, _: &[usize]) -> Vec<Column> {
    let both = |law: &Law| ["dynamic_factor", "kv_iso6336"].map(|what| column(format!("{}_{what}", law.name), "1"));
    meshes(model).flat_map(both).collect()
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let run = &ended.outcome.trajectory;
    let factors = dynamic_factor::of(ended.scene, ended.entry, run, ended.from);
    let both = |law: &Law| {
        let of = factors.iter().find(|factor| factor.law.name == law.name);
        let value = |value: &Result<f64, String>| value.as_ref().map_or(f64::NAN, |value| *value);
        of.map_or([f64::NAN; 2], |of| [value(&of.factor), value(&of.iso6336)])
    };
    meshes(run.model).flat_map(both).collect()
}
