//! The provenance that every result file carries: program, commit, scene, solver and values set.

use crate::output::summary::Provenance;
use crate::run::Outcome;
use crate::scene::{Precision, Scene, Solver};

/// The commit that the program was built from, if known.
pub(crate) const COMMIT: Option<&str> = option_env!("GEARSIM_COMMIT");

/// The provenance of results of `scene`, computed by `solver`.
pub(crate) fn of(scene: &Scene, solver: String) -> Provenance {
    Provenance {
        program: "gearsim".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        commit: COMMIT.map(Into::into),
        scene_sha256: scene.hash.clone(),
        solver,
        overrides: scene.overrides.clone(),
    }
}

/// The provenance as pairs of name and value, with the scene, the model and its effects.
pub(crate) fn pairs(scene: &Scene, outcome: &Outcome) -> Vec<(&'static str, String)> {
    let provenance = of(scene, solver(scene, outcome));
    vec![
        ("program", provenance.program),
        ("version", provenance.version),
        ("commit", provenance.commit.unwrap_or_default()),
        ("scene", scene.name.clone()),
        ("scene_sha256", provenance.scene_sha256),
        ("model", scene.model.name.into()),
        ("effects", scene.effects.names(scene.model).join(", ")),
        ("solver", provenance.solver),
        ("overrides", scene.overrides.join("\n")),
    ]
}

/// The solver that computed `outcome` from `scene`, in words.
pub(crate) fn solver(scene: &Scene, outcome: &Outcome) -> String {
    let Solver { tolerance, step, precision, .. } = scene.solver;
    match (outcome.solver.method, step) {
        ("exact", _) if precision == Precision::Compensated => {
            "exact cells, guaranteed first crossing, in twice the digits".into()
        }
        ("exact", _) => "exact cells, guaranteed first crossing".into(),
        ("rk4_grid", Some(h)) => format!("rk4 in steps of {h} s, each event handled at the end of its step"),
        (method, Some(h)) => format!("{method} in steps of {h} s, first crossing of its dense output"),
        (method, None) => format!("{method} at {tolerance:e}, first crossing of its dense output"),
    }
}
