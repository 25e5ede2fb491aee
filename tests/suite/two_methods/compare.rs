//! Compares one scene by two methods: events, impacts, the motion and the energy account.

use gearsim::__private::{Runner, digits, error};
use gearsim::run::{Digits, Entry, Outcome};
use gearsim::scene::Scene;
use gearsim::scene::solver::{Method, Precision, Solver};

/// Tolerance of the explicit methods.
const TOLERANCE: f64 = 1e-12;
/// Tolerance of the first run if its energy account refutes the run with `TOLERANCE`. Steps lose digits over a kink of |F|, where friction
/// of the flanks changes to the other flank.
const FINEST: f64 = 1e-13;
/// Tolerance of radau. Its order is 5, so that its number of steps grows by a factor of 2.5 for two more digits. The allowed difference
/// does not contain this tolerance. If radau exceeds the allowed difference, it runs again with `TOLERANCE`.
const IMPLICIT: f64 = 1e-10;
/// Digits that a run must have left at its end for its events to be compared one by one.
const ENOUGH: f64 = 7.0;
/// A run that has not enough digits left after this time \[s\] is at rest: only its end and its account are compared.
const SHORTEST: f64 = 1e-9;
/// Allowed difference, in units of the tolerance times the growth factor of rounding errors.
const UNITS: f64 = 3e3;
/// Smallest allowed difference, relative to the size of each coordinate and speed.
const LEAST: f64 = 1e-8;

/// The model of a scene, with its functions.
fn entry(scene: &Scene) -> Entry {
    *gearsim::models().iter().find(|entry| entry.model.name == scene.model.name).unwrap()
}

/// Runs `scene` by two methods, up to its end or up to a time at which it has enough digits left.
///
/// # Errors
/// A text that says how the methods disagree.
pub fn agree(scene: &Scene) -> Result<String, String> {
    let mut scene = scene.clone();
    scene.output.rate = 500.0 / scene.t_end;
    scene.solver = Solver { tolerance: TOLERANCE, precision: Precision::Plain, ..Solver::default() };
    let run = |scene: &Scene| entry(scene).run(scene, &mut |_| {});
    let (first, left) = loop {
        let outcome = digits::noted(&scene, run(&scene).map_err(|e| e.to_string())?, &run);
        if outcome.refuted.is_some() && scene.solver.tolerance > FINEST {
            scene.solver.tolerance = FINEST;
            continue;
        }
        let left = outcome.digits.ok_or("the companion was refused")?;
        if left.at_end >= ENOUGH || scene.t_end < SHORTEST {
            break (outcome, left);
        }
        // Not a round number, so that the end does not fall on an event.
        scene.t_end *= 0.7431;
        scene.output.rate = 500.0 / scene.t_end;
    };
    let others: &[Method] = match first.solver.method {
        "exact" => &[Method::Dop853],
        _ => &[Method::Radau],
    };
    let mut text = format!("{} until {} s, {:.1} digits left", scene.name, scene.t_end, left.at_end);
    for &method in others {
        let with = |tolerance: f64| {
            let mut other = scene.clone();
            (other.solver.method, other.solver.tolerance) = (Some(method), tolerance);
            let second = run(&other).map_err(|e| e.to_string())?;
            compared(&first, &second, left, &|| claimed(&other, &second, &run))
        };
        let compared = match method {
            Method::Radau => with(IMPLICIT).or_else(|_| with(TOLERANCE)),
            _ => with(TOLERANCE),
        };
        text = match compared {
            Ok(agreed) => format!("{text}; {agreed}"),
            Err(wrong) => return Err(format!("{text}; {}: {wrong}", method.name())),
        };
    }
    Ok(text)
}

/// The error that a run claims of its own end, from its companion.
fn claimed(scene: &Scene, outcome: &Outcome, run: Runner<'_>) -> f64 {
    let noted = digits::noted(scene, outcome.clone(), run);
    noted.digits.map_or(0.0, |left| 10f64.powf(-left.at_end))
}

/// Compares two runs of a scene. `left` has the digits that the first run has left, `claim` is the error that the second run claims. The
/// error of a coordinate at rest is relative to a share of the coordinates that move. There the rounding errors of a method with long steps
/// may exceed the error that follows from `left`, and `claim` is allowed instead.
fn compared(first: &Outcome, second: &Outcome, left: Digits, claim: &dyn Fn() -> f64) -> Result<String, String> {
    for run in [first, second] {
        if let Some(stop) = &run.stopped_by {
            return Err(format!("{} stopped: {stop}", run.solver.method));
        }
        if let Some(account) = run.refuted {
            return Err(format!("{}: {account}", run.solver.method));
        }
    }
    // A reflection at which a hold begins is no bounce. Rounding errors release a phase at rest that is hardly pressed, and it is held again.
    let bounces = |run: &Outcome| run.counts.reflections.saturating_sub(run.counts.holds);
    let counts = |run: &Outcome| (run.counts.cell_changes, bounces(run), run.counts.impacts);
    // A train at rest has no digits at any time: only rounding errors move it. Whether they move a phase over a step depends on the method.
    if left.at_end >= ENOUGH && counts(first) != counts(second) {
        return Err(format!("cell changes, bounces and impacts {:?} and {:?}", counts(first), counts(second)));
    }
    let grown = 10f64.powf(15.95 - left.at_end);
    let mut allowed = (UNITS * TOLERANCE * grown).max(LEAST);
    let end = error::of(second, first, 0.0).end;
    if end > allowed {
        allowed = allowed.max(claim());
    }
    let text = format!("{:?} events, end {end:.1e} apart, {allowed:.1e} allowed", counts(first));
    // NaN is an error too.
    if end <= allowed { Ok(text) } else { Err(text) }
}
