//! Where a result comes from, as every file says it.

use crate::output::summary::Provenance;
use crate::run::Outcome;
use crate::scene::{Precision, Scene, Solver};

/// The commit that the program was built from, where known.
pub(super) const COMMIT: Option<&str> = option_env!("GEARSIM_COMMIT");

/// Where the results of `scene`, read with `overrides` and had from `solver`, come from.
pub(super) fn of(scene: &Scene, overrides: &[String], solver: String) -> Provenance {
    Provenance {
        program: "gearsim".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        commit: COMMIT.map(Into::into),
        scene_sha256: scene.hash.clone(),
        solver,
        overrides: overrides.to_vec(),
    }
}

/// The same as pairs of name and value, with what was simulated.
pub(super) fn pairs(scene: &Scene, overrides: &[String], outcome: &Outcome) -> Vec<(&'static str, String)> {
    let provenance = of(scene, overrides, solver(scene, outcome));
    vec![
        ("program", provenance.program),
        ("version", provenance.version),
        ("commit", provenance.commit.unwrap_or_default()),
        ("scene", scene.name.clone()),
        ("scene_sha256", provenance.scene_sha256),
        ("model", scene.model.name.into()),
        ("effects", scene.effects.names(scene.model).join(", ")),
        ("solver", provenance.solver),
        ("overrides", overrides.join("\n")),
    ]
}

/// What ran `scene` to `outcome`, in words.
pub(super) fn solver(scene: &Scene, outcome: &Outcome) -> String {
    let Solver { tolerance, step, precision, .. } = scene.solver;
    match (outcome.solver.method, step) {
        ("exact", _) if precision == Precision::Compensated => {
            "exact cells, guaranteed first crossing, in twice the digits".into()
        }
        ("exact", _) => "exact cells, guaranteed first crossing".into(),
        ("rk4_grid", Some(h)) => format!("rk4 in steps of {h} s, events taken after the step in which they fall"),
        (method, Some(h)) => format!("{method} in steps of {h} s, first crossing of its dense output"),
        (method, None) => format!("{method} at {tolerance:e}, first crossing of its dense output"),
    }
}
