//! Checks the tree of a scene file and builds the [`Scene`]. All mistakes are reported at once.

use super::document::{KeyEntry, Node, Place};
use super::keys::{Key, Kind, REQUIRED, key};
use super::mistake::{Report, did_you_mean};
use super::per_radius::{OfModel, Radii};
use super::{
    Scene, assembly, effects, field, gear_data, inert, keys, laws, meshes, output, parameters, solver, start, train,
};
use crate::model::Model;

/// Keys of the top level of a scene. A scene of `model = "train"` also has the keys [`train::KEYS`].
pub(super) const KEYS: &[Key] = &[
    key("about", Kind::Text, "empty", "what the scene shows, in the author's words"),
    key("model", Kind::Name("a model"), REQUIRED, "what is simulated; `gearsim models` lists the models"),
    key("effects", Kind::List(&Kind::Name("an effect of the model")), REQUIRED, "the active effects; [] for none"),
    key("parameters", Kind::Named(parameters::NAMED), "defaults of the model", "values of the model's parameters"),
    key("laws", Kind::Named(laws::NAMED), "required by models with meshes", "what repeats with each pitch of a mesh"),
    key("start", Kind::Named(start::NAMED), "those of the model", "the state at t = 0"),
    key("run", Kind::Table(RUN), "required by all that runs, not by modes and floquet", "how long and by which method"),
    key("output", Kind::Table(&[output::KEYS]), "all defaults", "what is recorded and drawn"),
];

/// Keys of `[run]`.
pub(super) const RUN: &[&[Key]] = &[output::END, solver::KEYS];

/// Reads a scene without name, hash and text. `end` is the place where a missing table would be added. Returns `None` only if a mistake was
/// reported.
pub(super) fn scene(root: &Node, end: &Place, models: &[&'static Model], report: &mut Report) -> Option<Scene> {
    let entries = field::table("", root, report)?;
    let required = [("model", "model = \"...\""), ("effects", "effects = []  # or some names")];
    let lacking = required.into_iter().filter(|(key, _)| keys::get(entries, key).is_none());
    let lacking: Vec<_> = lacking.map(|(key, line)| (key, line.to_string())).collect();
    keys::missing(&lacking, "the scene", &root.place, report);

    let mut absent = Vec::new();
    let about = keys::get(entries, "about").and_then(|node| field::text("about", node, report));
    let model = keys::get(entries, "model").and_then(|node| read_model(node, models, report));
    let mut entries = entries.to_vec();
    let listed = match model {
        Some(bare) if !bare.elements.is_empty() => Some(train::read(bare, &mut entries, [&root.place, end], report)?),
        _ => None,
    };
    let model = listed.as_ref().map(|listed| listed.model).or(model);
    let of_train = listed.as_ref().map(|listed| &listed.meshes);
    if let Some(model) = model {
        meshes::infer_rings(&mut entries, model, of_train);
    }
    let entries = &entries[..];
    stray_keys(entries, model, report);
    let of_model = model.map(|model| {
        let effects = keys::get(entries, "effects");
        let effects = effects.and_then(|node| effects::read(node, model, report));
        let of_model = OfModel(model);
        let radii: &dyn Radii = listed.as_ref().map_or(&of_model, |listed| &listed.radii);
        (
            effects.clone(),
            parameters::read(entries, (model, radii), effects.as_ref(), &mut absent, report),
            laws::read(entries, model, effects.as_ref(), &mut absent, report),
            laws::gears(entries, model),
            start::read(entries, model, report),
        )
    });
    let (t_end, solver) = output::read_run(entries, &mut absent, report);
    let effects = of_model.as_ref().and_then(|of_model| of_model.0.as_ref());
    let output = output::read(entries, (model, effects), t_end, report);
    // Analyses without a run do not need `[run]`, and a run refuses a scene without it. Report it here only together with other mistakes.
    if !report.is_empty() || absent.iter().any(|(name, _)| *name != output::RUN) {
        keys::missing(&absent, "the scene", end, report);
    }

    let (effects, parameters, laws, gears, start) = of_model?;
    let (model, effects, parameters, laws) = (model?, effects?, parameters?, laws?);
    inert::warn(entries, model, &effects, (&parameters, &laws), report);
    let mut scene = Scene {
        name: String::new(),
        about: about.unwrap_or_default().to_string(),
        model,
        train: listed.as_ref().map(|listed| listed.train.clone()),
        effects,
        parameters: parameters.values,
        time_histories: parameters.varying,
        laws,
        gears,
        modules: vec![],
        start: start?,
        t_end: t_end?,
        solver: solver?,
        output: output?,
        hash: String::new(),
        text: "".into(),
        source: "".into(),
        overrides: vec![],
        conversions: parameters.conversions,
        warnings: vec![],
    };
    scene.modules = gear_data::modules(&scene, of_train);
    assembly::check(&scene, report);
    gear_data::check(&scene, entries, of_train, report);
    Some(scene)
}

/// Reports keys that are not allowed at the top level. For a key that belongs to a table, the help names that table.
fn stray_keys(entries: &[KeyEntry], model: Option<&Model>, report: &mut Report) {
    let mut homes = vec![("run", keys::names(RUN)), ("output", keys::names(&[output::KEYS]))];
    if let Some(model) = model {
        let coordinates = model.coordinates.iter().map(|coordinate| coordinate.name);
        let motions = model.motions.iter().map(|motion| motion.name);
        homes.push(("parameters", model.parameters.iter().map(|p| p.name).collect()));
        homes.push(("laws", model.laws.iter().map(|law| law.name).collect()));
        homes.push(("start", coordinates.chain(motions).collect()));
    }
    let of_train = if model.is_some_and(|model| !model.elements.is_empty()) { train::KEYS } else { &[] };
    let known = keys::names(&[KEYS, of_train]);
    for KeyEntry { key, place, .. } in keys::unknown(entries, &known) {
        let home = homes.iter().find(|(_, keys)| keys.contains(&key.as_str()));
        let (label, help) = match home {
            Some((table, _)) => ("in the wrong place", format!("it belongs to [{table}]: `{table}.{key}`")),
            None => ("unknown key", keys::choices(key, &known)),
        };
        report.add(place, format!("the top level of a scene has no `{key}`"), label, help);
    }
}

fn read_model(node: &Node, models: &[&'static Model], report: &mut Report) -> Option<&'static Model> {
    let name = field::text("model", node, report)?;
    let found = models.iter().copied().find(|model| model.name == name);
    if found.is_none() {
        let near = || Some(format!("did you mean `{}`?", did_you_mean(name, models.iter().map(|model| model.name))?));
        let mut help = train::in_place_of(name).or_else(near).map_or(String::new(), |help| help + "\n");
        help.push_str("the models are");
        for model in models {
            help.push_str(&format!("\n{}: {}", model.name, model.title));
        }
        report.add(&node.place, format!("there is no model `{name}`"), "unknown model", help);
    }
    found
}
