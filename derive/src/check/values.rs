//! Checks the phases and pitches of laws, and the defaults of parameters.

use symbolica::atom::Atom;

use crate::expr::{Kind, symbol, symbols};
use crate::model::{Model, Parameter, Range};
use crate::slip::Slip;

/// The phase of a law must be a coordinate, its pitch a positive number.
pub(super) fn laws(model: &Model) -> Result<(), Slip> {
    for law in &model.laws {
        if !(law.period.is_finite() && law.period > 0.0) {
            return Err(Slip::Pitch { model: model.name.clone(), law: law.name.clone(), pitch: law.period });
        }
        let phase = law.phase.atom();
        let coordinate = matches!(symbols(&phase).as_slice(), [(Kind::Coordinate, name)] if phase == Atom::var(symbol(Kind::Coordinate, name)));
        if !coordinate {
            return Err(Slip::Phase { model: model.name.clone(), law: law.name.clone(), phase: phase.to_string() });
        }
    }
    Ok(())
}

/// Every default must be finite and in the range of its parameter. A parameter with [`Range::Above`] has no default, and its lower bound is
/// another parameter, which is positive.
pub(super) fn defaults(model: &Model) -> Result<(), Slip> {
    for p in &model.parameters {
        let admissible = |x: f64| match p.range {
            Range::Any => true,
            Range::Positive => x > 0.0,
            Range::NotNegative => x >= 0.0,
            Range::Above(_) => true,
        };
        if let Some(lesser) = p.range.above() {
            let is_positive = |other: &Parameter| matches!(other.range, Range::Positive | Range::Above(_));
            if p.default.is_some() || !model.parameters.iter().any(|other| other.name == lesser && is_positive(other)) {
                return Err(Slip::Above { model: model.name.clone(), parameter: p.name.clone(), lesser });
            }
        }
        if let Some(default) = p.default.filter(|x| !(x.is_finite() && admissible(*x))) {
            return Err(Slip::Default { model: model.name.clone(), parameter: p.name.clone(), default });
        }
    }
    Ok(())
}
