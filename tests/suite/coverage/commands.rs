//! The commands, each as a call of the library.

use gearsim::__private;
use gearsim::{Error, Scene};

/// Runs a command on a scene; the error is the reason why it cannot.
type Command = fn(&Scene) -> Result<(), String>;

/// The columns of the table. A run that stops early or is refuted is an error too.
pub const COMMANDS: &[(&str, Command)] = &[
    ("run", |scene| run(scene, &[])),
    ("exact", |scene| run(scene, &[("run.method", "exact")])),
    ("compensated", |scene| run(scene, &[("run.precision", "compensated")])),
    ("dopri5", |scene| run(scene, &[("run.method", "dopri5")])),
    ("dop853", |scene| run(scene, &[("run.method", "dop853")])),
    ("radau", |scene| run(scene, &[("run.method", "radau")])),
    ("rk4", |scene| run(scene, &[("run.method", "rk4"), ("run.step", "1 us")])),
    ("rk4_grid", |scene| run(scene, &[("run.method", "rk4_grid"), ("run.step", "1 us")])),
    ("compare", compare),
    ("sweep", sweep),
    ("modes", |scene| scene.modes().map(drop).map_err(reason)),
    ("floquet", |scene| scene.floquet().map(drop).map_err(reason)),
    ("advise", |scene| scene.advise().map(drop).map_err(reason)),
    ("work-precision", reference),
];

fn run(scene: &Scene, set: &[(&str, &str)]) -> Result<(), String> {
    let changed = scene.with_all(set.iter().map(|(key, value)| (*key, (*value).into())));
    let results = changed.and_then(|scene| scene.run()).map_err(reason)?;
    results.check().map_err(reason)
}

/// The approximate equations of the paper in place of those of the scene.
fn compare(scene: &Scene) -> Result<(), String> {
    let names = scene.effects.names(scene.model);
    for approximate in ["rigid_kinematics", "frozen_phase"] {
        if !scene.model.effects.iter().any(|effect| effect.name == approximate) {
            return Err(
                "no tooth passes a step of a stiffness in this model: there are no approximate equations".into()
            );
        }
        if names.iter().any(|name| ["rigid_kinematics", "frozen_phase"].contains(name)) {
            return Ok(()); // the scene is one of those that are compared
        }
        let effects: Vec<_> = names.iter().copied().chain([approximate]).collect();
        run(scene, &[("effects", &format!("{effects:?}"))])?;
    }
    Ok(())
}

fn sweep(scene: &Scene) -> Result<(), String> {
    let table = scene.vary("output.rate=10 kHz,20 kHz").run().map_err(reason)?;
    let reasons = table.words("reason").unwrap_or_default().iter();
    reasons.zip(table.words("status").unwrap_or_default()).try_for_each(|(reason, status)| match status.as_ref() {
        "done" => Ok(()),
        other => Err(format!("{other}: {reason}")),
    })
}

/// The reference with which `work-precision` compares all methods. The methods have separate columns.
fn reference(scene: &Scene) -> Result<(), String> {
    let entry = gearsim::models().iter().find(|entry| entry.model.name == scene.model.name).ok_or("no such model")?;
    __private::reference(scene, &|scene: &Scene| entry.run(scene, &mut |_| {})).map(drop)
}

/// The text of an error without the parts that differ between scenes: the name of the scene, and times.
fn reason(error: Error) -> String {
    let text = match error {
        Error::Refused { refusal, .. } => refusal.to_string(),
        Error::Scene(mistakes) => mistakes.brief(),
        Error::Floquet { cause, .. } => cause.to_string(),
        other => other.to_string(),
    };
    text.split('\n').next().unwrap_or_default().to_string()
}
