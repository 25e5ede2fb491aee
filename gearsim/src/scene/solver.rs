//! `[run]`: by which method a scene is solved, and how finely.

use super::document::{Entry, Node};
use super::error::Report;
use super::{field, keys, measure};

/// How a scene is to be solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver {
    /// The method; `None`: the exact one where cells are linear, else a suitable one.
    pub method: Option<Method>,
    /// Error allowed in a step of an adaptive method, relative to what each component has reached.
    pub tolerance: f64,
    /// Length of the steps of a method of fixed ones \[s\].
    pub step: Option<f64>,
    /// Digits in which the exact method carries its state.
    pub precision: Precision,
    /// Steps after which a method by steps gives up.
    pub most_steps: u64,
}

/// Digits in which a run carries its state, its time and the constants of its cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// Those of f64.
    #[default]
    Plain,
    /// Twice as many.
    Compensated,
}

/// A method that a scene can name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Closed form between two steps of the stiffness.
    Exact,
    /// Dormand & Prince 5(4), explicit, adaptive.
    Dopri5,
    /// Dormand & Prince 8(5,3), explicit, adaptive.
    Dop853,
    /// Radau IIA 5, implicit, adaptive.
    Radau,
    /// The classical method with steps of one length, events located.
    Rk4,
    /// The same on a grid that knows of no events: a jump is taken after the step in which it was due. For comparison.
    Rk4Grid,
}

/// Keys of `[run]` that say how.
pub(super) const KEYS: [&str; 4] = ["method", "precision", "tolerance", "step"];

/// Tolerance of a scene that states none.
const TOLERANCE: f64 = 1e-9;
/// Steps after which a run is given up: some hours.
const MOST_STEPS: u64 = 10_000_000_000;
/// Admissible tolerances: below, a step's rounding is larger; above, the error estimate means nothing.
const TOLERANCES: std::ops::RangeInclusive<f64> = 1e-14..=1e-2;

impl Method {
    /// All of them, with their names in scenes.
    pub const ALL: [(Method, &'static str); 6] = [
        (Method::Exact, "exact"),
        (Method::Dopri5, "dopri5"),
        (Method::Dop853, "dop853"),
        (Method::Radau, "radau"),
        (Method::Rk4, "rk4"),
        (Method::Rk4Grid, "rk4_grid"),
    ];

    /// Its name in scenes.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(method, _)| *method == self).map_or("", |(_, name)| name)
    }

    /// Whether its steps are of one length.
    pub fn has_fixed_steps(self) -> bool {
        matches!(self, Method::Rk4 | Method::Rk4Grid)
    }
}

impl Default for Solver {
    fn default() -> Self {
        Solver { method: None, tolerance: TOLERANCE, step: None, precision: Precision::Plain, most_steps: MOST_STEPS }
    }
}

/// Reads the solver out of `[run]`, whose other keys are read elsewhere.
pub(super) fn read(run: &[Entry], place: &Node, report: &mut Report) -> Option<Solver> {
    let method = match keys::get(run, "method") {
        None => Some(None),
        Some(node) => read_method(node, report).map(Some),
    };
    let (tolerance, step) = (keys::get(run, "tolerance"), keys::get(run, "step"));
    let fixed = method.flatten().map(Method::has_fixed_steps);
    let exact = method.flatten() == Some(Method::Exact);
    if let Some(node) = tolerance.filter(|_| exact || fixed == Some(true)) {
        let why = if exact { "it is exact" } else { "its steps are of one length: it has `step`" };
        report.add(&node.place, "this method has no tolerance".to_string(), "out of place", why);
    }
    if let Some(node) = step.filter(|_| fixed == Some(false)) {
        let why = "it chooses its steps by `tolerance`; `rk4` has steps of one length";
        report.add(&node.place, "this method has no step of its own".to_string(), "out of place", why);
    }
    if fixed == Some(true) && step.is_none() {
        let line = "step = \"... s\"  # the length of its steps".to_string();
        keys::missing(&[("step", line)], "[run]", &place.place, report);
    }
    let tolerance = match tolerance {
        None => Some(TOLERANCE),
        Some(node) => measure::quantity("run.tolerance", node, "1", report).filter(|x| {
            let inside = TOLERANCES.contains(x);
            if !inside {
                let must = format!("must lie between {:e} and {:e}", TOLERANCES.start(), TOLERANCES.end());
                measure::out_of_range("run.tolerance", node, &must, "the relative error allowed in a step", report);
            }
            inside
        }),
    };
    let step = match step {
        None => Some(None),
        Some(node) => measure::quantity("run.step", node, "s", report)
            .filter(|x| {
                if *x <= 0.0 {
                    measure::out_of_range("run.step", node, "must be positive", "the length of a step", report);
                }
                *x > 0.0
            })
            .map(Some),
    };
    let precision = read_precision(run, method.flatten(), report);
    let (method, tolerance, step, precision) = (method?, tolerance?, step?, precision?);
    Some(Solver { method, tolerance, step, precision, ..Solver::default() })
}

fn read_precision(run: &[Entry], method: Option<Method>, report: &mut Report) -> Option<Precision> {
    let Some(node) = keys::get(run, "precision") else { return Some(Precision::Plain) };
    let precision = match field::choice("run.precision", node, "precision", &["plain", "compensated"], report)? {
        0 => Precision::Plain,
        _ => Precision::Compensated,
    };
    if precision == Precision::Compensated && method.is_some_and(|method| method != Method::Exact) {
        let why = "only the exact method carries more digits: its error is rounding, theirs is that of their steps";
        report.add(&node.place, "this method is not compensated".to_string(), "out of place", why);
    }
    Some(precision)
}

fn read_method(node: &Node, report: &mut Report) -> Option<Method> {
    let name = field::text("run.method", node, report)?;
    let found = Method::ALL.iter().find(|(_, known)| *known == name).map(|(method, _)| *method);
    if found.is_none() {
        let names: Vec<_> = Method::ALL.iter().map(|(_, name)| *name).collect();
        let help = keys::choices(name, &names) + "\nleave it out for the one that suits the scene";
        report.add(&node.place, format!("there is no method `{name}`"), "unknown method", help);
    }
    found
}
