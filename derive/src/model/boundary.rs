//! How laws switch where their phase reaches a boundary between two levels, and which effects decide it.
//!
//! A model declares this: `m.boundaries("steps", Boundary::WithJump)`. The derivation forms two conditions from these declarations, and the
//! generated file states both. So neither the derivation nor the engine needs to know the name of such an effect.

use super::Model;

/// How laws switch in scenes with an effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// Where the phase of a law reaches a boundary, with the impulse that conserves energy. Without this effect laws are constant.
    WithJump,
    /// Where the phase of a law reaches a boundary, without the impulse: the speeds do not change at a step.
    WithoutJump,
    /// At the times of a steady rotation, whatever the phase is.
    ByTime,
}

impl Boundary {
    /// All ways, in the order in which a file states them.
    pub(crate) const ALL: [Boundary; 3] = [Boundary::WithJump, Boundary::WithoutJump, Boundary::ByTime];

    /// Its word in a file.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Boundary::WithJump => "with_jump",
            Boundary::WithoutJump => "without_jump",
            Boundary::ByTime => "by_time",
        }
    }
}

/// Condition of the terms with the slope of a law: the laws step with the motion itself, and the impulses are kept.
pub(crate) const JUMP_TERMS: &str = "jump_terms";
/// Condition of all terms through the phase of a law: the phase is not frozen. Implied by [`JUMP_TERMS`].
pub(crate) const MOVING_PHASE: &str = "moving_phase";

impl Model {
    /// Declares that `effect`, declared before, decides how laws switch. A model with laws needs one effect with [`Boundary::WithJump`];
    /// the others are effects that require this one.
    pub fn boundaries(&mut self, effect: &str, how: Boundary) {
        let stated = (how, effect.to_string());
        if !self.switching.contains(&stated) {
            self.switching.push(stated);
        }
    }

    /// The effect with which laws switch in the way `how`.
    pub(crate) fn switching(&self, how: Boundary) -> Option<&str> {
        self.switching.iter().find(|(other, _)| *other == how).map(|(_, effect)| effect.as_str())
    }

    /// The two conditions of laws, each with the effects that it needs present (or, with `!`, absent); none if the model has no laws.
    pub(crate) fn conditions(&self) -> Vec<(&'static str, String)> {
        let absent = |how| self.switching(how).map(|effect| format!("!{effect}"));
        let present = |hows: &[Boundary]| {
            let step = self.switching(Boundary::WithJump).map(String::from);
            step.into_iter().chain(hows.iter().filter_map(|how| absent(*how))).collect::<Vec<_>>().join(", ")
        };
        let both = [
            (JUMP_TERMS, present(&[Boundary::WithoutJump, Boundary::ByTime])),
            (MOVING_PHASE, present(&[Boundary::ByTime])),
        ];
        if self.laws.is_empty() { vec![] } else { both.into() }
    }
}
