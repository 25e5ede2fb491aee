//! Where a result comes from, as every file says it.

use crate::output::summary::Provenance;
use crate::scene::{Precision, Scene};

/// The commit that the program was built from, where known.
pub(super) const COMMIT: Option<&str> = option_env!("GEARSIM_COMMIT");

/// Where the results of `scene`, read with `overrides`, come from.
pub(super) fn of(scene: &Scene, overrides: &[String]) -> Provenance {
    Provenance {
        program: "gearsim".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        commit: COMMIT.map(Into::into),
        scene_sha256: scene.hash.clone(),
        solver: match scene.precision {
            Precision::Plain => "exact cells, guaranteed first crossing".into(),
            Precision::Compensated => "exact cells, guaranteed first crossing, in twice the digits".into(),
        },
        overrides: overrides.to_vec(),
    }
}

/// The same as pairs of name and value, with what was simulated.
pub(super) fn pairs(scene: &Scene, overrides: &[String]) -> Vec<(&'static str, String)> {
    let provenance = of(scene, overrides);
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
