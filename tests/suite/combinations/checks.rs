//! Checks that every scene must pass.

use gearsim::__private::error;
use gearsim::run::Outcome;
use gearsim::trajectory::Trajectory;
use gearsim::{Error, Results, Scene};

use crate::compare;
use crate::draw::Case;

/// The result of a check.
#[derive(Clone)]
pub enum Checked {
    /// The check passed.
    Right,
    /// The check does not apply, for this reason.
    Left(String),
    /// The check failed, for this reason.
    Wrong(String),
}

use Checked::{Left, Right, Wrong};

/// A check and its name.
type Check = (&'static str, fn(&Case) -> Checked);
/// All checks.
pub const CHECKS: [Check; 4] = [("run", run), ("sweep", sweep), ("halves", halves), ("another method", another_method)];

/// Share of the scenes that are run by another method: it takes longer than all other checks.
const METHODS: u64 = 4;
/// Allowed difference between a run and its halves: as a number of rounding errors, before the motion amplifies them, and the smallest
/// allowed relative difference. The start of the second half is rounded. A vibration of the size of this rounding has a speed that is
/// larger by its frequency.
const ROUNDINGS: (f64, f64) = (1e4, 1e-8);
/// Rounding errors of a number at the middle of a run [units of its last place].
const UNITS: f64 = 4.0;

/// Values below this count as zero [SI units]: rounding errors of double-double numbers of the size of a metre or of 1e6 m/s, for
/// coordinates at rest.
const AT_REST: f64 = 1e-25;

/// The run of the scene, or why there is nothing to check. All checks share one run.
fn ran(case: &Case) -> Result<&Results, &Checked> {
    let run = || {
        let scene = case.scene.as_ref().map_err(|error| Left(format!("not read, {}", words(error))))?;
        scene.run().map_err(|error| match error {
            Error::Refused { refusal, .. } => Left(format!("refused, {}", words(&refusal.to_string()))),
            other => Wrong(other.to_string()),
        })
    };
    case.run.get_or_init(run).as_ref()
}

/// The run ends, its numbers are finite, and its energy account closes.
fn run(case: &Case) -> Checked {
    let outcome = match ran(case) {
        Ok(results) => &results.outcome,
        Err(checked) => return checked.clone(),
    };
    if let Some(stop) = &outcome.stopped_by {
        return Left(format!("stopped, {}", words(&stop.to_string())));
    }
    let run = &outcome.trajectory;
    let finite = |columns: &[Vec<f64>]| columns.iter().flatten().all(|x| x.is_finite());
    if !finite(&run.q) || !finite(&run.q_dot) || !run.residual.iter().all(|x| x.is_finite()) {
        return Wrong("a number is not finite".into());
    }
    // Fixed steps and equations without jump terms do not conserve energy, and the account reports this.
    let honest = outcome.solver.method == "rk4" || drops_terms(case);
    match outcome.refuted {
        Some(_) if honest => Left("the account says that the result is wrong".into()),
        Some(account) => Wrong(account.to_string()),
        None => Right,
    }
}

/// Whether the scene has effects that drop terms.
fn drops_terms(case: &Case) -> bool {
    let has = |scene: &Scene, name: &str| scene.effects.names(scene.model).contains(&name);
    case.scene.as_ref().is_ok_and(|scene| has(scene, "rigid_kinematics") || has(scene, "frozen_phase"))
}

/// A sweep over one point gives the same bits as the run.
fn sweep(case: &Case) -> Checked {
    let rate = "20 kHz";
    let Ok(results) = ran(case) else { return Left("has no run".into()) };
    let scene = &results.scene;
    let table = scene.vary(&format!("output.rate={rate}")).record(&["state", "extremes"]).run();
    let single = scene.with("output.rate", rate).and_then(|scene| scene.run());
    let (table, single) = match (table, single) {
        (Ok(table), Ok(single)) => (table, single.outcome),
        (table, single) => return Wrong(format!("{:?}, {:?}", table.err(), single.err())),
    };
    let run = &single.trajectory;
    for (i, coordinate) in scene.model.coordinates.iter().enumerate() {
        for (name, column) in
            [(coordinate.name.to_owned(), &run.q[i]), (format!("{}_dot", coordinate.name), &run.q_dot[i])]
        {
            let swept = table.numbers(&name).and_then(|column| column.first());
            if swept.map(|x| x.to_bits()) != column.last().map(|x| x.to_bits()) {
                return Wrong(format!("{name} is {swept:?} in the sweep, {:?} in the run", column.last()));
            }
        }
    }
    Right
}

/// A run to half the time, and another one from the state that it reaches, end where the whole run ends.
fn halves(case: &Case) -> Checked {
    let Ok(whole) = ran(case) else { return Left("has no run".into()) };
    let scene = &whole.scene;
    if !scene.time_histories.is_empty() || drops_terms(case) {
        return Left("depends on the time".into());
    }
    if scene.model.switches.iter().any(|switch| scene.effects.has(switch.with, scene.model)) {
        return Left("switches have a mode, which a start does not state".into());
    }
    if whole.outcome.stopped_by.is_some() || whole.outcome.refuted.is_some() || whole.outcome.solver.method == "rk4" {
        return Left("the whole run has no right end".into());
    }
    let Some(left) = whole.outcome.digits else { return Left("no digits are known".into()) };
    // Not a round number, so that the parts do not meet at an event.
    let t = 0.4731 * scene.t_end;
    let part = |scene: Scene, t_end: f64| scene.with("run.t_end", t_end)?.run();
    let first = match part(scene.clone(), t) {
        Ok(first) => first.outcome.trajectory,
        Err(error) => return Wrong(error.to_string()),
    };
    let ends: Vec<f64> = first.q.iter().chain(&first.q_dot).map(|x| x.last().copied().unwrap_or(f64::NAN)).collect();
    let second = |start: &[f64]| {
        let (q, v) = start.split_at(first.q.len());
        let entries =
            scene.model.coordinates.iter().zip(q.iter().zip(v)).map(|(c, (q, v))| {
                format!("{} = \"{q:?} {}\", {}_dot = \"{v:?} {}/s\"", c.name, c.unit, c.name, c.unit)
            });
        let start = format!("start={{ {} }}", entries.collect::<Vec<_>>().join(", "));
        let overrides = [scene.overrides.clone(), vec![start]].concat();
        let second = Scene::from_toml_with(&scene.name, &scene.text, &overrides)?;
        part(second, scene.t_end - t).map(|second| second.outcome)
    };
    let half = match second(&ends) {
        Ok(half) => half,
        Err(error) => return Wrong(error.to_string()),
    };
    let grown = 10f64.powf(15.95 - left.at_end);
    let mut allowed = (ROUNDINGS.0 * f64::EPSILON.max(tolerance(whole)) * grown).max(ROUNDINGS.1);
    if allowed > 1e-4 {
        return Left("too few digits are left".into());
    }
    let end = apart(&half, &whole.outcome);
    if end > allowed {
        // The start of the second half is rounded to 16 digits, as every number in a plain run is a few times. The effect of this rounding
        // is measured: each number of the start in turn is increased by one unit in its last place.
        let mut moved = 0.0;
        for i in 0..ends.len() {
            let mut start = ends.clone();
            start[i] = start[i].next_up();
            match second(&start) {
                Ok(other) => moved += apart(&other, &half),
                Err(error) => return Wrong(error.to_string()),
            }
        }
        allowed = allowed.max(UNITS * moved);
    }
    if end <= allowed { Right } else { Wrong(format!("the ends are {end:.1e} apart, {allowed:.1e} allowed")) }
}

/// The largest difference of a coordinate or speed at the ends of two runs, relative to its size in the second.
fn apart(a: &Outcome, b: &Outcome) -> f64 {
    let moving = |run: &Trajectory| {
        let mut run = run.clone();
        run.q.iter_mut().chain(&mut run.q_dot).flatten().filter(|x| x.abs() < AT_REST).for_each(|x| *x = 0.0);
        run
    };
    let (a, b) = (moving(&a.trajectory), moving(&b.trajectory));
    error::difference((&a, a.len() - 1), (&b, b.len() - 1), &error::sizes(&b))
}

/// The tolerance of a method by steps; 0 for the exact method.
fn tolerance(run: &Results) -> f64 {
    if run.outcome.solver.method == "exact" { 0.0 } else { run.scene.solver.tolerance }
}

/// Two methods that share only the equations give the same events, end and account.
fn another_method(case: &Case) -> Checked {
    let Ok(scene) = &case.scene else { return Left("has no run".into()) };
    if !case.choice.is_multiple_of(METHODS) || drops_terms(case) {
        return Left("not chosen".into());
    }
    match run(case) {
        Right => {}
        _ => return Left("has no run".into()),
    }
    match compare::agree(scene) {
        Ok(_) => Right,
        Err(why) => Wrong(why),
    }
}

/// A reason without its numbers, so that equal reasons are counted together.
fn words(text: &str) -> String {
    let first = first_line(text);
    first.split(' ').filter(|word| !word.contains(|c: char| c.is_ascii_digit())).collect::<Vec<_>>().join(" ")
}

fn first_line(text: &str) -> String {
    text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default().to_owned()
}
