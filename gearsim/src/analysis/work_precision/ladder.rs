//! The runs of a work-precision diagram: each method or approximation with settings from coarse to fine. A new one is one entry here.

use std::f64::consts::TAU;

use crate::model::Start;
use crate::scene::Scene;
use crate::scene::solver::{Method, Precision, Solver};

use super::reference::{By, Reference, recorded};
use crate::tolerance::analysis::{RAMP, SMALLEST_RAMP};

/// The scene, and the same scene under approximate equations.
#[derive(Debug, Clone)]
pub struct Scenes {
    /// The scene itself.
    pub exact: Scene,
    /// The scene under equations that are cheaper to solve but not exact, each with their name.
    pub cheaper: Vec<(&'static str, Scene)>,
}

/// The origin of a family's error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The numerical method: the error falls with finer settings.
    Method,
    /// The equations: the error stays.
    Equations,
}

/// A method or approximation with its settings.
#[derive(Debug, Clone)]
pub struct Family {
    /// Its name in legends and tables.
    pub label: &'static str,
    /// The origin of its error.
    pub kind: Kind,
    /// Its settings, from coarse to fine.
    pub rungs: Vec<Rung>,
}

/// One setting of a family.
#[derive(Debug, Clone)]
pub struct Rung {
    /// The setting as text, e.g. `1e-9`.
    pub setting: String,
    /// The scene to run.
    pub scene: Scene,
    /// Width of the ramps that replace steps \[unit of the phase\]; 0 if they do not.
    pub blur: f64,
}

/// Tolerances of adaptive methods: 10 to the power of -3 to -13.
const TOLERANCES: std::ops::RangeInclusive<i32> = 3..=13;
/// Fixed time steps: the period of the elastic mode over 2 to these powers.
const HALVINGS: std::ops::RangeInclusive<i32> = 3..=13;
/// Number of time steps allowed for events, per event of the reference.
const MOST_EVENTS: u64 = 100;
/// Widths of ramps: a pitch over 10 to these powers.
const RAMPS: std::ops::RangeInclusive<i32> = 2..=7;

/// All families for `scenes`.
pub fn families(scenes: &Scenes, reference: &Reference) -> Vec<Family> {
    let scene = recorded(&scenes.exact);
    let with = |solver: Solver| Scene { solver, ..scene.clone() };
    let by = |method| Solver { method: Some(method), ..Solver::default() };
    let rung = |setting: String, scene: Scene| Rung { setting, scene, blur: 0.0 };
    let method = |label, rungs| Family { label, kind: Kind::Method, rungs };

    let adaptive = |label, name| {
        let at = |k: i32| 10f64.powi(-k);
        let rungs = TOLERANCES.map(|k| rung(format!("{:e}", at(k)), with(Solver { tolerance: at(k), ..by(name) })));
        method(label, rungs.collect())
    };
    let period = reference.outcome.reference_frequency.map_or(scene.t_end / 100.0, |w| TAU / w);
    let fixed = |label, name| {
        let at = |k: i32| period / 2f64.powi(k);
        let rungs = HALVINGS.map(|k| {
            let h = at(k);
            // If the method is unstable, the motion grows and meets more and more events: stop such a run long before its end.
            let most_steps = (2.0 * scene.t_end / h) as u64 + MOST_EVENTS * (reference.events() + 1);
            rung(format!("h = {h:.2e} s"), with(Solver { step: Some(h), most_steps, ..by(name) }))
        });
        method(label, rungs.collect())
    };
    let compensated = Solver { precision: Precision::Compensated, ..by(Method::Exact) };
    let mut families = vec![];
    // A method that the scene does not allow is left out, not shown as failed.
    if reference.by == By::Compensated {
        families.push(method("exact cells", vec![rung("f64".into(), with(by(Method::Exact)))]));
        families.push(method("exact cells, compensated", vec![rung("f64 x 2".into(), with(compensated))]));
    }
    families.extend([
        adaptive("explicit, order 5 (dopri5)", Method::Dopri5),
        adaptive("explicit, order 8 (dop853)", Method::Dop853),
        adaptive("implicit, order 5 (radau)", Method::Radau),
        fixed("rk4, events located", Method::Rk4),
        fixed("rk4, events ignored", Method::Rk4Grid),
    ]);
    let ramps: Vec<Rung> = RAMPS.filter_map(|k| ramp(&scene, reference, 10f64.powi(-k))).collect();
    if !ramps.is_empty() {
        families.push(method("ramps for steps (dop853)", ramps));
    }
    for (label, scene) in &scenes.cheaper {
        let scene = Scene { solver: by(Method::Exact), ..recorded(scene) };
        families.push(Family { label, kind: Kind::Equations, rungs: vec![rung("f64".into(), scene)] });
    }
    families
}

/// The scene with ramps of the width `part` of a pitch instead of steps; `None` if the levels are too short for them, or there are no
/// steps.
fn ramp(scene: &Scene, reference: &Reference, part: f64) -> Option<Rung> {
    let start = &reference.outcome.trajectory;
    let column = |name: &str| scene.model.coordinates.iter().position(|c| c.name == name);
    let widths: Vec<f64> = scene.model.laws.iter().map(|law| part * law.period).collect();
    let ramped = scene.model.laws.iter().zip(&scene.laws).zip(&widths).map(|((law, stiffness), width)| {
        // A scene that starts at a step has already passed it: the ramp must lie behind the start, too.
        let behind = column(law.phase).is_none_or(|i| start.q_dot[i][0] >= 0.0);
        stiffness.ramped(*width, if behind { 1.0 } else { 0.0 })
    });
    let laws: Vec<_> = ramped.collect::<Option<_>>()?;
    if !scene.laws.iter().any(|law| law.steps_only() && law.steps.len() > 1) {
        return None;
    }
    let mut scene = Scene { laws, ..scene.clone() };
    scene.start.q = start.q.iter().map(|q| Start::At(q[0])).collect();
    scene.start.q_dot = start.q_dot.iter().map(|v| Some(v[0])).collect();
    // A tolerance far below the error caused by the ramps themselves.
    scene.solver =
        Solver { method: Some(Method::Dop853), tolerance: (RAMP * part).max(SMALLEST_RAMP), ..Solver::default() };
    let blur = widths.iter().fold(0.0f64, |m, w| m.max(*w));
    Some(Rung { setting: format!("eps = {blur:.1e}"), scene, blur })
}
