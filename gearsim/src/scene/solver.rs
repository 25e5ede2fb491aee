//! `[run]`: the method by which a scene is solved, its tolerance or step, and its precision.

use super::document::{KeyEntry, Node};
use super::keys::{Key, Kind, key};
use super::mistake::Report;
use super::{field, keys};
use crate::tolerance::methods;

/// Settings of the solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver {
    /// The method. `None`: the exact method if cells are linear, otherwise a method that suits the scene.
    pub method: Option<Method>,
    /// Tolerance of an adaptive method: error allowed in a step, relative to the largest magnitude that each component has reached.
    pub tolerance: f64,
    /// Whether the scene states this tolerance.
    pub states_tolerance: bool,
    /// Step length of a method with fixed steps \[s\].
    pub step: Option<f64>,
    /// Precision of the exact method.
    pub precision: Precision,
    /// Number of steps after which a stepping method stops with an error.
    pub most_steps: u64,
}

/// Precision in which a run stores its state, its time and the constants of its cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// Double precision (f64).
    #[default]
    Plain,
    /// Double-double precision: twice the digits.
    Compensated,
}

/// A method that a scene can name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Closed-form solution between two steps of the stiffness.
    Exact,
    /// Dormand & Prince 5(4), explicit, adaptive.
    Dopri5,
    /// Dormand & Prince 8(5,3), explicit, adaptive.
    Dop853,
    /// Radau IIA 5, implicit, adaptive.
    Radau,
    /// The classical Runge-Kutta method of order 4 with a fixed step; events are located.
    Rk4,
    /// As [`Method::Rk4`], but on a fixed time grid without event location: a jump is applied at the end of the step in which it occurs.
    /// For comparison.
    Rk4Grid,
}

/// Keys of `[run]` for the solver.
pub(super) const KEYS: &[Key] = &[
    key(
        "method",
        Kind::Choice(&METHODS),
        "exact where cells are linear, else one that suits",
        "how the scene is solved",
    ),
    key("precision", Kind::Choice(&PRECISIONS), "plain", "compensated: the exact method with twice the digits"),
    key("tolerance", Kind::Number, "1e-9", "relative error allowed in a step, for adaptive methods"),
    key("step", Kind::Quantity("s"), "required by rk4 and rk4_grid", "the fixed step length of these methods"),
];

/// Names of the methods.
const METHODS: [&str; Method::ALL.len()] = {
    let mut names = [""; Method::ALL.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = Method::ALL[i].1;
        i += 1;
    }
    names
};

/// Names of the precisions, in the order of [`Precision`].
const PRECISIONS: [&str; 2] = ["plain", "compensated"];

impl Method {
    /// All methods, with their names in scenes.
    pub const ALL: [(Method, &'static str); 6] = [
        (Method::Exact, "exact"),
        (Method::Dopri5, "dopri5"),
        (Method::Dop853, "dop853"),
        (Method::Radau, "radau"),
        (Method::Rk4, "rk4"),
        (Method::Rk4Grid, "rk4_grid"),
    ];

    /// Name in scenes.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(method, _)| *method == self).map_or("", |(_, name)| name)
    }

    /// Whether the step length is fixed.
    pub fn has_fixed_steps(self) -> bool {
        matches!(self, Method::Rk4 | Method::Rk4Grid)
    }
}

impl Default for Solver {
    fn default() -> Self {
        Solver {
            method: None,
            tolerance: methods::DEFAULT,
            states_tolerance: false,
            step: None,
            precision: Precision::Plain,
            most_steps: methods::STEPS,
        }
    }
}

/// Reads the solver's keys of `[run]`, a run until `t_end` [s]. The caller reads the others.
pub(super) fn read(run: &[KeyEntry], place: &Node, t_end: Option<f64>, report: &mut Report) -> Option<Solver> {
    let method = match keys::get(run, "method") {
        None => Some(None),
        Some(node) => read_method(node, report).map(Some),
    };
    let (tolerance, step) = (keys::get(run, "tolerance"), keys::get(run, "step"));
    let fixed = method.flatten().map(Method::has_fixed_steps);
    let exact = method.flatten() == Some(Method::Exact);
    if let Some(node) = tolerance.filter(|_| exact || fixed == Some(true)) {
        let why = if exact { "leave it out: it is exact" } else { "leave it out: its step is fixed, give `step`" };
        report.add(&node.place, "this method has no tolerance".to_string(), "out of place", why);
    }
    if let Some(node) = step.filter(|_| fixed != Some(true)) {
        let (what, why) = match method {
            // Without a name the exact method or an adaptive one is chosen: neither would use the step.
            Some(None) => {
                ("`run.step` is given, but no method with a fixed step", "add method = \"rk4\", or leave out `step`")
            }
            _ if exact => ("this method has no steps", "leave it out: it is exact; `rk4` has a fixed step"),
            _ => (
                "this method has no fixed step",
                "leave it out: it chooses its steps from `tolerance`; `rk4` has a fixed step",
            ),
        };
        if method.is_some() {
            report.add(&node.place, what, "out of place", why);
        }
    }
    if fixed == Some(true) && step.is_none() {
        let line = "step = \"... s\"  # the fixed step length".to_string();
        keys::missing(&[("step", line)], "[run]", &place.place, report);
    }
    let states_tolerance = tolerance.is_some();
    let tolerance = match tolerance {
        None => Some(methods::DEFAULT),
        Some(node) => field::quantity("run.tolerance", node, "1", report).filter(|x| {
            let inside = methods::ALLOWED.contains(x);
            if !inside {
                let must = format!("must lie between {:e} and {:e}", methods::ALLOWED.start(), methods::ALLOWED.end());
                field::out_of_range("run.tolerance", node, &must, "the relative error allowed in a step", report);
            }
            inside
        }),
    };
    let step = match step {
        None => Some(None),
        Some(node) => read_step(node, t_end, report).map(Some),
    };
    let precision = read_precision(run, method.flatten(), report);
    let (method, tolerance, step, precision) = (method?, tolerance?, step?, precision?);
    Some(Solver { method, tolerance, states_tolerance, step, precision, ..Solver::default() })
}

/// Reads the length of a step [s]: at most the run, and not so short that the run would reach its limit of steps.
fn read_step(node: &Node, t_end: Option<f64>, report: &mut Report) -> Option<f64> {
    let step = field::quantity("run.step", node, "s", report)?;
    let must = match t_end {
        _ if step <= 0.0 => "must be positive".to_string(),
        Some(t_end) if step > t_end => format!("must be at most the run, {t_end} s"),
        Some(t_end) if t_end / step > methods::STEPS as f64 => {
            format!(
                "must be at least {:e} s: a run has at most {:e} steps",
                t_end / methods::STEPS as f64,
                methods::STEPS
            )
        }
        _ => return Some(step),
    };
    field::out_of_range("run.step", node, &must, "the length of a step", report);
    None
}

fn read_precision(run: &[KeyEntry], method: Option<Method>, report: &mut Report) -> Option<Precision> {
    let Some(node) = keys::get(run, "precision") else { return Some(Precision::Plain) };
    let precision = match field::choice("run.precision", node, "precision", &PRECISIONS, report)? {
        0 => Precision::Plain,
        _ => Precision::Compensated,
    };
    if precision == Precision::Compensated && method.is_some_and(|method| method != Method::Exact) {
        let why =
            "only the exact method can: its errors are rounding errors, those of other methods come from their steps";
        report.add(&node.place, "this method is not compensated".to_string(), "out of place", why);
    }
    Some(precision)
}

fn read_method(node: &Node, report: &mut Report) -> Option<Method> {
    let name = field::text("run.method", node, report)?;
    let found = Method::ALL.iter().find(|(_, known)| *known == name).map(|(method, _)| *method);
    if found.is_none() {
        let names: Vec<_> = Method::ALL.iter().map(|(_, name)| *name).collect();
        let help = keys::choices(name, &names) + "\nleave it out to have one chosen that suits the scene";
        report.add(&node.place, format!("there is no method `{name}`"), "unknown method", help);
    }
    found
}
