//! Models as JSON.

use serde::Serialize;

use crate::model::Model;
use crate::output::{OutputError, document};
use crate::scene::Effects;

/// Version of the format.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Report<'a> {
    models: Vec<Description<'a>>,
}

#[derive(Serialize)]
struct Description<'a> {
    name: &'a str,
    title: &'a str,
    source: &'a str,
    coordinates: Vec<Quantity<'a>>,
    parameters: Vec<Parameter<'a>>,
    laws: Vec<Quantity<'a>>,
    effects: Vec<&'a str>,
    outputs: Vec<Quantity<'a>>,
}

#[derive(Serialize)]
struct Quantity<'a> {
    name: &'a str,
    unit: &'a str,
    doc: &'a str,
}

#[derive(Serialize)]
struct Parameter<'a> {
    #[serde(flatten)]
    quantity: Quantity<'a>,
    /// Default value [SI]; `null` if a scene must give one.
    default: Option<f64>,
    /// The only effect that uses it.
    with: Option<&'a str>,
    /// Allowed values [SI], e.g. `(0, inf)`.
    range: String,
    /// Whether it may vary in time.
    varies: bool,
}

/// The text of the JSON document.
///
/// # Errors
/// [`OutputError::Format`].
pub(super) fn json(models: &[&Model]) -> Result<String, OutputError> {
    document::json("models", VERSION, &Report { models: models.iter().map(|model| describe(model)).collect() })
}

fn describe<'a>(model: &'a Model) -> Description<'a> {
    let quantity = |name: &'a str, unit: &'a str, doc: &'a str| Quantity { name, unit, doc };
    Description {
        name: model.name,
        title: model.title,
        source: model.source,
        coordinates: model.coordinates.iter().map(|c| quantity(c.name, c.unit, c.doc)).collect(),
        parameters: model
            .parameters
            .iter()
            .map(|p| Parameter {
                quantity: quantity(p.name, p.unit, p.doc),
                default: p.default,
                with: p.with,
                range: p.allowed(),
                varies: p.varies.may(),
            })
            .collect(),
        laws: model.laws.iter().map(|law| quantity(law.name, law.unit, law.doc)).collect(),
        effects: Effects::all(model).names(model),
        outputs: model.outputs.iter().map(|o| quantity(o.name, o.unit, o.doc)).collect(),
    }
}
