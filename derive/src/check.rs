//! Is the model what it must be before anything is derived from it? One room for each kind of question.

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

/// Checks a whole model; the first slip found ends it.
pub(crate) fn check(model: &Model) -> Result<(), Slip> {
    if model.coordinates.is_empty() {
        return Err(Slip::Empty { model: model.name.clone() });
    }
    let declared = names::declared(model)?;
    places::places(model, declared)?;
    values::laws(model)?;
    values::defaults(model)?;
    forms::quadratic(model)?;
    forms::dissipative(model)?;
    forms::linear(model)
}
