//! What a reader of a run's numbers must know, found in its rows: teeth that pull, absurd deflections, and frequencies that its samples cannot
//! show. Runs, sweeps, responses and comparisons have the same remarks. The words before the colon are the same in every run with the same finding.

use indexmap::IndexMap;

use super::number::short;
use super::unit::in_words;
use crate::analysis::absurd::{self, Absurd};
use crate::analysis::pulling::{self, Pulling};
use crate::analysis::sampling::{self, Folding};
use crate::scene::Scene;
use crate::scene::solver::Precision;
use crate::trajectory::Trajectory;

/// Most meshes that a remark names; the others are in the table of meshes.
const NAMED: usize = 3;

/// What separates the remarks of a point in a table.
pub(crate) const BETWEEN: &str = " | ";

/// The remarks on the rows of a run from the time `from` \[s\] on, a sentence each.
pub(crate) fn of(scene: &Scene, run: &Trajectory, from: f64) -> Vec<String> {
    let pull = pull(pulling::of(scene, run, from));
    pull.into_iter().chain(absurd(scene, run, from)).chain(samples(scene, run, from)).collect()
}

/// What the digits of a run in compensated precision are about.
pub(crate) fn of_precision(scene: &Scene) -> Option<String> {
    let text = "compensated precision: the digits left are those of the scene with its numbers as they are read. Conversions of units and \
                2 pi are rounded to 16 digits before the run, and a chaotic motion magnifies this as it magnifies any other change";
    (scene.solver.precision == Precision::Compensated).then(|| text.to_owned())
}

/// The meshes whose teeth pull.
fn pull(mut all: Vec<Pulling>) -> Option<String> {
    all.retain(|mesh| mesh.share > 0.0);
    // The order of the laws is kept where shares are equal, as in planet sets.
    all.sort_by(|a, b| b.share.total_cmp(&a.share));
    let one = |mesh: &Pulling| {
        let (share, unit) = (short(100.0 * mesh.share), mesh.force.unit);
        let forces = [mesh.largest, mesh.mean.abs()].map(|force| in_words(force, unit));
        let [largest, mean] = forces;
        format!("`{}` for {share} % of the time, with {largest} at most beside a mean load of {mean}", mesh.force.name)
    };
    let mut meshes: Vec<String> = all.iter().take(NAMED).map(one).collect();
    if let Some(more) = all.len().checked_sub(NAMED).filter(|more| *more > 0) {
        meshes.push(format!("{more} more meshes"));
    }
    let mut effects: Vec<&str> = all.iter().filter_map(|mesh| mesh.without).collect();
    effects.dedup();
    let why = match &effects[..] {
        [] => "The model has no play here".to_owned(),
        [one] => format!("Without the effect `{one}` they cannot part"),
        _ => "Without the effect `backlash` they cannot part".to_owned(),
    };
    let found = format!("the teeth pull: {}", meshes.join("; "));
    (!all.is_empty())
        .then(|| format!("{found}. {why}: real teeth would rattle, so that forces, losses and spectra differ"))
}

/// Deflections that no drivetrain has.
fn absurd(scene: &Scene, run: &Trajectory, from: f64) -> Option<String> {
    let all = absurd::of(scene, run, from);
    let one = |absurd: &Absurd| match absurd {
        Absurd::Teeth(force, modules) => format!("`{}` bends its teeth by {} modules", force.name, short(*modules)),
        Absurd::Twist(twist, turns) => format!("`{}` reaches {} turns", twist.name, short(*turns)),
    };
    let more = all.len().checked_sub(NAMED).filter(|more| *more > 0).map(|more| format!("{more} more"));
    let named: Vec<String> = all.iter().take(NAMED).map(one).chain(more).collect();
    let check = "Real parts break before: check torques, stiffnesses and their units";
    (!all.is_empty()).then(|| format!("absurd deflections: {}. {check}", named.join("; ")))
}

/// What the samples cannot show.
fn samples(scene: &Scene, run: &Trajectory, from: f64) -> Option<String> {
    let found = sampling::folding(scene, run, from)?;
    let Folding { rate, frequencies, vibrates, enough } = &found;
    let show = |frequency: f64| in_words(frequency, "Hz");
    let one = |(name, frequency): &(String, f64)| {
        format!("{name} of {} shows at {}", show(*frequency), show(sampling::folded(*frequency, *rate)))
    };
    let named = frequencies.iter().take(NAMED).map(one);
    let more = frequencies.len().checked_sub(NAMED).filter(|more| *more > 0).map(|more| format!("{more} more do too"));
    let vibrates = vibrates.map(|coordinate| format!("`{coordinate}` vibrates faster than they can show"));
    let all: Vec<String> = named.chain(more).chain(vibrates).collect();
    Some(format!(
        "too few samples: at {} {}. Spectra, lines, sounds and load cycles are wrong. Set a higher output.rate, for example \"{}\"",
        show(*rate),
        all.join("; "),
        show(*enough)
    ))
}

/// The remarks of many runs, called `words`: for each finding the number of runs, and the remark of the first one.
pub(crate) fn counted<'a>(words: &str, runs: impl Iterator<Item = &'a [String]>) -> Vec<String> {
    let (mut all, mut first) = (0, IndexMap::<&str, (usize, &str)>::new());
    for remarks in runs {
        all += 1;
        for remark in remarks {
            first.entry(remark.split(": ").next().unwrap_or_default()).or_insert((0, remark)).0 += 1;
        }
    }
    let said = |(count, remark): (usize, &str)| match count {
        _ if count == all => format!("at all {words}, the first: {remark}"),
        _ => format!("at {count} of {all} {words}, the first: {remark}"),
    };
    first.into_values().map(said).collect()
}
