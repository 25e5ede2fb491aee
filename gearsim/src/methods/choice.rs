//! The choice of the method that runs a scene, with its reason.

use crate::engine::equations::varying_by_steps;
use crate::engine::error::Refusal;
use crate::engine::law::{LawState, curved};
use crate::scene::solver::Method as Name;
use crate::scene::{Scene, list};
use crate::tolerance::methods::HIGH_ORDER;

use super::Method;
use super::control::Steps;
use super::dop853::DOP853;
use super::dopri5::DOPRI5;
use super::explicit::Explicit;
use super::radau::Radau;
use super::rk4::RK4;
use super::steps::{Events, Settings};

/// The method of a run, and the reason for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// The method.
    pub method: Name,
    /// Whether an explicit method may be replaced by the implicit one during the run.
    pub give_way: bool,
    /// The reason, in words.
    pub why: String,
}

/// The method for `scene`; `laws` are its laws at the start.
///
/// # Errors
/// If the scene asks for the exact method, and its cells are not linear.
pub fn of(scene: &Scene, laws: &[LawState]) -> Result<Choice, Refusal> {
    let varying: Vec<_> = varying_by_steps(scene).map(|(p, _)| scene.model.parameters[*p].name).collect();
    let terms = match scene.effects.nonlinear(scene.model) {
        terms if !terms.is_empty() => Some(terms),
        _ if !varying.is_empty() => Some(format!("{} in time, with factors that depend on the state", vary(&varying))),
        _ => curved(scene.model, laws),
    };
    let named = |method| Choice { method, give_way: false, why: "the scene names it".into() };
    match (scene.solver.method, terms) {
        (Some(Name::Exact), Some(terms)) => Err(Refusal::Nonlinear { terms }),
        (Some(method), _) => Ok(named(method)),
        (None, None) => {
            let load =
                scene.varying().map_or(", f".into(), |torques| format!(", and f that varies in time with {torques}"));
            let why = format!("every cell is linear: M q'' + C q' + K q = f with constant M, C, K{load}");
            Ok(Choice { method: Name::Exact, give_way: false, why })
        }
        (None, Some(terms)) => {
            let high = scene.solver.tolerance < HIGH_ORDER;
            let method = if high { Name::Dop853 } else { Name::Dopri5 };
            Ok(Choice { method, give_way: true, why: format!("cells are not linear: {terms}") })
        }
    }
}

fn vary(names: &[&str]) -> String {
    format!("{} {}", list(names), if names.len() == 1 { "varies" } else { "vary" })
}

/// The numerical method of a choice, and its settings. `None` for the exact method.
pub fn numerical(choice: &Choice, scene: &Scene) -> Option<(Box<dyn Method>, Settings)> {
    let method: Box<dyn Method> = match choice.method {
        Name::Exact => return None,
        Name::Dopri5 => Box::new(Explicit::new(DOPRI5)),
        Name::Dop853 => Box::new(Explicit::new(DOP853)),
        Name::Rk4 | Name::Rk4Grid => Box::new(Explicit::new(RK4)),
        Name::Radau => Box::new(Radau::new(scene.solver.tolerance)),
    };
    let steps = match scene.solver.step {
        Some(h) if choice.method.has_fixed_steps() => Steps::Fixed(h),
        _ => Steps::Adaptive(scene.solver.tolerance),
    };
    let events = if choice.method == Name::Rk4Grid { Events::AfterStep } else { Events::Located };
    Some((method, Settings { steps, events, give_way: choice.give_way, most_steps: scene.solver.most_steps }))
}
