//! Checks a model before anything is derived from it. One file for each kind of check.

mod boundaries;
mod effects;
mod forms;
mod functions;
mod names;
mod places;
mod sign;
mod values;

use crate::model::Model;
use crate::slip::Slip;

pub(crate) use functions::numbers;
pub(crate) use sign::{never_negative, positive};

/// Checks a whole model.
///
/// # Errors
/// The first error found.
pub(crate) fn check(model: &Model) -> Result<(), Slip> {
    if model.coordinates.is_empty() {
        return Err(Slip::Empty { model: model.name.clone() });
    }
    let declared = names::declared(model)?;
    places::places(model, declared)?;
    effects::parameters(model)?;
    values::laws(model)?;
    boundaries::boundaries(model)?;
    values::defaults(model)?;
    forms::quadratic(model)?;
    forms::dissipative(model)?;
    forms::linear(model)
}
