//! The dynamic factor of each mesh: the largest force over the force without vibration, and K_v of ISO 6336-1, method B. And for how long
//! and how hard its teeth pull.

use super::{Column, Ended, Group, column};
use crate::analysis::dynamic_factor::{self, DynamicFactor};
use crate::analysis::orders;
use crate::model::{Law, Model, Role};

pub(super) const GROUP: Group = Group {
    name: "meshes",
    doc: "of meshes after --from: k_dynamic_factor, k_kv_iso6336, k_pulling_share, k_largest_pull",
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
    let four = |law: &Law| {
        let unit = orders::force(model, law.name).map_or("", |force| force.unit);
        let all = [("dynamic_factor", "1"), ("kv_iso6336", "1"), ("pulling_share", "1"), ("largest_pull", unit)];
        all.map(|(what, unit)| column(format!("{}_{what}", law.name), unit))
    };
    meshes(model).flat_map(four).collect()
}

fn values(ended: &Ended<'_>) -> Vec<f64> {
    let run = &ended.outcome.trajectory;
    let factors = dynamic_factor::of(ended.scene, ended.entry, run, ended.from);
    let four = |law: &Law| {
        let of = factors.iter().find(|factor| factor.law.name == law.name);
        let value = |value: &Result<f64, String>| value.as_ref().map_or(f64::NAN, |value| *value);
        let pull = |of: &DynamicFactor| of.pulling.map_or([f64::NAN; 2], |pulling| [pulling.share, pulling.largest]);
        of.map_or([f64::NAN; 4], |of| {
            let [share, largest] = pull(of);
            [value(&of.factor), value(&of.iso6336), share, largest]
        })
    };
    meshes(run.model).flat_map(four).collect()
}
