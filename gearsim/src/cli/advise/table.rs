//! The advice as text for the terminal.

use std::fmt::Write;

use crate::analysis::advise::groups::Groups;
use crate::analysis::advise::{Apart, LIMITS};
use crate::cli::{number, report};
use crate::library::advise::{Advice, Estimate, Verdict};

/// The whole text. `dropped`: whether the scene itself has effects that drop terms.
pub(super) fn render(advice: &Advice, dropped: bool, width: usize) -> String {
    let mut text = String::new();
    if dropped {
        let says = "the terms that the scene's effects drop; leaving them out is among the candidates";
        text += &report::line("added", says, width);
    }
    for (name, says) in groups(advice) {
        text += &report::line(&name, &says, width);
    }
    text.push('\n');
    text += &row("", "without", Apart::NAMES.map(str::to_string), "time", "");
    for verdict in &advice.verdicts {
        text += &both(verdict);
    }
    text += &row("", "limits", LIMITS.in_words(), "", "");
    text.push('\n');
    for line in conclusions(advice) {
        text += &report::line(line.0, &line.1, width);
    }
    text
}

/// The dimensionless groups and the origin of the estimates, each a name and a text.
pub(super) fn groups(advice: &Advice) -> Vec<(String, String)> {
    let mut lines = match &advice.groups {
        Ok(groups) => numbers(groups),
        Err(why) => vec![("no groups".to_owned(), why.clone())],
    };
    let says = |why: &String| format!("from short runs, not from the settled motion: {why}");
    lines.extend(advice.no_orbit.iter().map(|why| ("estimates".to_owned(), says(why))));
    lines
}

/// The dimensionless groups, each a name and a text.
fn numbers(groups: &Groups) -> Vec<(String, String)> {
    let lowest = groups.modes.iter().map(|mode| mode.0).find(|f| *f > 0.0);
    let mut lines = vec![];
    for mesh in &groups.meshes {
        let ratio =
            lowest.map_or(String::new(), |f| format!(", {} of the lowest mode", number::short(mesh.frequency / f)));
        let says = format!(
            "jump strength J = {} ({}), stiffness ratio {}, mesh frequency {} Hz{ratio}",
            number::short(mesh.strength),
            strength(mesh.strength),
            number::short(mesh.ratio),
            number::short(mesh.frequency),
        );
        lines.push((format!("mesh {}", mesh.law), says));
    }
    if let (Some(first), Some(last)) = (groups.modes.first(), groups.modes.last()) {
        let zetas = groups.modes.iter().map(|mode| mode.1);
        let (low, high) = zetas.fold((f64::INFINITY, 0.0f64), |m, z| (m.0.min(z), m.1.max(z)));
        let says = match groups.modes.len() {
            1 => format!("{} Hz, damping factor {}", number::short(first.0), number::short(first.1)),
            n => format!(
                "{n}, from {} to {} Hz, damping factors {} to {}",
                number::short(first.0),
                number::short(last.0),
                number::short(low),
                number::short(high)
            ),
        };
        lines.push(("modes".into(), says));
    }
    if let Some((law, meeting)) = groups.meetings.first() {
        let says = format!(
            "harmonic {} of {law} is at {} times the frequency of mode {}: near a resonance, dropped terms matter most",
            meeting.harmonic,
            number::short(meeting.ratio),
            meeting.mode
        );
        lines.push(("near resonance".into(), says));
    }
    for (name, gap) in &groups.gaps {
        lines.push(((*name).to_owned(), format!("{} of the static deflection", number::short(*gap))));
    }
    lines
}

/// The meaning of a jump strength J = 2 G dV/v².
fn strength(j: f64) -> &'static str {
    match j {
        j if j >= 1.0 => "a step reflects the motion",
        j if j >= 1e-3 => "adds up over many pitches",
        _ => "small",
    }
}

/// Two rows of a candidate: the estimate, and below it the deviation of the full runs.
fn both(verdict: &Verdict) -> String {
    let (estimated, true_) = verdict.negligible();
    let says = |small: Option<bool>| small.map_or("", |small| if small { "negligible" } else { "needed" });
    let time = verdict.time_in_words();
    let name = &verdict.candidate.without;
    let estimate = |what: &str, apart: &Apart| row(name, what, apart.in_words(), "", says(estimated));
    let first = match &verdict.estimate {
        Estimate::Settled(apart) => estimate("estimate", apart),
        Estimate::Short(apart) => estimate("short run", apart),
        Estimate::TurnedBack => format!("{}estimate  {:<62}  needed\n", label(name), "  steps reflect the motion"),
        Estimate::None(why) => format!("{}no estimate: {why}\n", label(name)),
    };
    let second = match &verdict.truth {
        Ok(apart) => row(&format!("  {}", verdict.candidate.how), "truth", apart.in_words(), &time, says(true_)),
        Err(why) => format!("  {}: cannot be run, {why}\n", verdict.candidate.how),
    };
    first + &second
}

/// The label of a row, padded. A label that is too long gets a line of its own.
fn label(name: &str) -> String {
    const WIDTH: usize = 30;
    match name.chars().count() {
        n if n < WIDTH => format!("{name:<WIDTH$}"),
        _ => format!("{name}\n{:WIDTH$}", ""),
    }
}

fn row(name: &str, what: &str, cells: [String; 6], time: &str, says: &str) -> String {
    let mut line = format!("{}{what:<10}", label(name));
    for cell in cells {
        let _ = write!(line, "{cell:>9}");
    }
    let _ = write!(line, "{time:>8}  {says}");
    format!("{}\n", line.trim_end())
}

/// The conclusions, each a name and a text.
pub(super) fn conclusions(advice: &Advice) -> Vec<(&'static str, String)> {
    let mut lines = vec![];
    let named = |small: bool| {
        let verdicts = advice.verdicts.iter().filter(|v| v.negligible().1 == Some(small));
        let names = verdicts.map(|v| v.candidate.without.clone());
        names.collect::<Vec<_>>().join("; ")
    };
    let none = |text: String| if text.is_empty() { "nothing".to_owned() } else { text };
    lines.push(("negligible", none(named(true))));
    lines.push(("needed", none(named(false))));
    let wrong = advice.verdicts.iter().filter(|v| matches!(v.negligible(), (Some(a), Some(b)) if a != b));
    let wrong: Vec<_> = wrong.map(|v| v.candidate.without.clone()).collect();
    if !wrong.is_empty() {
        let says = format!("{}: estimate and run do not agree; the run is right", wrong.join("; "));
        lines.push(("wrong estimate", says));
    }
    if advice.reflections > 0 {
        let says =
            format!("steps reflected the motion {} times, which only the full equations predict", advice.reflections);
        lines.push(("reflections", says));
    }
    if let Some(why) = &advice.stopped {
        lines.push(("stopped early", why.clone()));
    }
    let says = format!(
        "the scene takes {}; rms, peak and bands are those of the worst elastic coordinate about its mean, in {} bands of {} Hz; speed, \
         energy and events are those at the end, t = {} s",
        number::time(advice.seconds),
        advice.bands.count,
        number::short(advice.bands.width),
        number::short(advice.t_end)
    );
    lines.push(("measured", says));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::modes;
    use crate::analysis::steady;
    use crate::known;
    use crate::plot::{campbell, modes as shapes};

    /// A mode has the same number in the advice, in the table of modes, and in both figures: its place in `CellModes`.
    #[test]
    fn modes_have_the_same_numbers_everywhere() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/two_stage.toml");
        let scene = crate::scene::Scene::load(&path).unwrap();
        let system = known::of(&scene).unwrap().system(&scene).unwrap();
        let groups = Groups::of(&scene, &system).unwrap();
        let courses = steady::courses(&scene, &system).unwrap();
        let mids = scene.mid_stiffnesses();
        let parts = modes::Parts::of(&scene, known::of(&scene).unwrap(), &system, &|| {}).unwrap();
        let cell = modes::of(&system, &mids, &parts, &|| {}).unwrap();
        let (law, meeting) = *groups.meetings.first().expect("a harmonic of the meshes is near a mode");
        let mesh = courses.iter().find(|course| course.name == law).unwrap().mesh_frequency();
        let frequency = cell.modes[meeting.mode].damped;
        assert!((meeting.harmonic as f64 * mesh / frequency / meeting.ratio - 1.0).abs() < 1e-12);
        let mode = format!("the frequency of mode {}:", meeting.mode);
        assert!(numbers(&groups).iter().any(|(_, says)| says.contains(&mode)));
        // The lowest vibrating mode comes after the rigid motions.
        let first = cell.modes.iter().position(|mode| mode.natural > 0.0).unwrap();
        let figure = shapes::draw(&scene, &cell, &parts).unwrap();
        let named = figure.panels[0].series.iter().any(|s| s.label.starts_with(&format!("mode {first}, ")));
        assert!(first > 0 && named, "{:?}", figure.panels[0].series);
        let figure = campbell::draw(&scene, &courses, &cell).unwrap();
        let (highest, mode) = (cell.modes.len() - 1, cell.modes.last().unwrap().damped);
        let name = figure.panels[0].series.iter().rfind(|s| s.y == [mode]).unwrap();
        assert_eq!(name.note.text, highest.to_string());
        assert!(figure.panels[0].y.range.unwrap().1 > mode);
    }
}
