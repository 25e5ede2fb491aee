//! The JSON schema of scenes, by which editors complete and check them: <https://json-schema.org/draft/2020-12>.

use serde_json::{Map, Value, json};

use super::key::{Key, Kind, REQUIRED};
use crate::model::{Model, Parameter, Role};
use crate::scene::{PLOTS, check, effects, laws, time_history, train};

/// The schema of scenes of these models. The reader checks more: units, ranges, and combinations of keys.
pub(crate) fn schema(models: &[&Model]) -> Value {
    let mut all = table(&[check::KEYS, train::KEYS]);
    let names: Vec<_> = models.iter().map(|model| model.name).collect();
    all["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    all["title"] = json!("A scene of gearsim");
    all["properties"]["model"]["enum"] = json!(names);
    let of = |model: &&Model| {
        json!({
            "if": { "properties": { "model": { "const": model.name } }, "required": ["model"] },
            "then": { "properties": of_model(model) },
        })
    };
    all["allOf"] = models.iter().map(of).collect();
    all
}

/// What the names of a model allow: its effects, parameters, laws and coordinates.
fn of_model(model: &Model) -> Value {
    // The names of a train follow from its parts.
    if !model.elements.is_empty() {
        return json!({});
    }
    let signals = |more: Vec<&'static str>| json!({ "items": { "enum": more } });
    let outputs: Vec<_> = model.outputs.iter().map(|output| output.name).collect();
    let parameters = model.parameters.iter().map(|p| (p.name.to_owned(), parameter(p)));
    let law = |role: &Role| match role {
        Role::Stiffness => laws::STIFFNESS,
        Role::Error => laws::ERROR,
        Role::Side | Role::Arm => laws::FRICTION,
    };
    let laws = model.laws.iter().map(|l| (l.name.to_owned(), described(table(law(&l.role)), l.doc, "")));
    let coordinates = model.coordinates.iter().flat_map(|c| {
        let speed = described(quantity(&format!("{}/s", c.unit)), &format!("speed of the {}", c.doc), "");
        [(c.name.to_owned(), described(quantity(c.unit), c.doc, "")), (format!("{}_dot", c.name), speed)]
    });
    let motions = model.motions.iter().map(|m| (m.name.to_owned(), described(quantity(m.unit), m.doc, "0")));
    let mut of = Map::new();
    of.insert("effects".into(), signals(effects::allowed(model)));
    of.insert("parameters".into(), object(parameters.collect(), &[]));
    of.insert("laws".into(), object(laws.collect(), &[]));
    of.insert("start".into(), object(coordinates.chain(motions).collect(), &[]));
    of.insert(
        "output".into(),
        json!({ "properties": { "record": signals(outputs), "plots": signals(PLOTS.to_vec()) } }),
    );
    of.extend(train::KEYS.iter().map(|key| (key.name.to_owned(), Value::Bool(false))));
    of.into()
}

fn parameter(parameter: &Parameter) -> Value {
    let value = quantity(parameter.unit);
    let value = match parameter.varies.may() {
        true => json!({ "anyOf": [value, table(&[time_history::KEYS])] }),
        false => value,
    };
    described(value, parameter.doc, &parameter.default.map_or(String::new(), |x| format!("{x} {}", parameter.unit)))
}

/// A number with this unit; 0 needs none.
fn quantity(unit: &str) -> Value {
    match unit {
        "1" => json!({ "type": ["number", "string"] }),
        unit => json!({ "anyOf": [{ "type": "string", "examples": [format!("1 {unit}")] }, { "const": 0 }] }),
    }
}

fn described(mut schema: Value, doc: &str, default: &str) -> Value {
    let default = if default.is_empty() { String::new() } else { format!(". Without it: {default}") };
    schema["description"] = json!(format!("{doc}{default}"));
    schema
}

/// A table with the keys of these lists, and no others.
fn table(keys: &[&[Key]]) -> Value {
    let keys: Vec<&Key> = keys.iter().flat_map(|keys| keys.iter()).collect();
    let required: Vec<_> = keys.iter().filter(|key| key.default == REQUIRED).map(|key| key.name).collect();
    let properties = keys.iter().map(|key| (key.name.to_owned(), described(value(key.kind), key.doc, key.default)));
    object(properties.collect(), &required)
}

fn object(properties: Map<String, Value>, required: &[&str]) -> Value {
    json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
}

/// What a value may be.
fn value(kind: Kind) -> Value {
    match kind {
        Kind::Text | Kind::Name(_) => json!({ "type": "string" }),
        Kind::Flag => json!({ "type": "boolean" }),
        Kind::Number => quantity("1"),
        Kind::Quantity(unit) => quantity(unit),
        // The unit may be that of a plain number.
        Kind::ValueIn(_) => json!({ "type": ["number", "string"] }),
        Kind::Choice(names) => json!({ "enum": names }),
        Kind::List(kind) => json!({ "type": "array", "items": value(*kind) }),
        Kind::Table(keys) => table(keys),
        Kind::Named(all) => {
            let kinds: Vec<_> =
                all.iter().map(|named| described(value(named.kind), named.doc, named.default)).collect();
            json!({ "type": "object", "additionalProperties": { "anyOf": kinds } })
        }
        Kind::Either(kinds) => json!({ "anyOf": kinds.iter().map(|kind| value(*kind)).collect::<Vec<_>>() }),
    }
}
