//! Held contact: a phase pressed against a step that it cannot climb, from when its bounces no longer count.
//!
//! Each reflection keeps the normal speed, damping takes from it, and the bounces come ever faster. Once the energy of
//! the normal motion E = v²/(2 G) is below `HOLD_ENERGY` of all energy and a bounce is short, the phase is held where it is:
//! n.q' = 0, under the reaction R. What is ignored is E at each hold; it is counted, and its sum is in the account.
//! The hold ends when
//! - R pulls, by `RELEASE` of the forces that make it up: the phase leaves the step it came from;
//! - the step vanishes, dV = 0: the phase slips through without loss; with play, that is also where the flanks beyond it part;
//! - a step of another stiffness gives an impulse: what is held is let go, and bounces or leaves.
//!
//! With the outward normals n of the held phases as columns of N, the motion that is left has the mobility
//! P = M⁻¹ - M⁻¹N (NᵀM⁻¹N)⁻¹ NᵀM⁻¹, and the reactions to the generalised forces F are R = (NᵀM⁻¹N)⁻¹ NᵀM⁻¹ F.

use nalgebra::{DMatrix, DVector};

use crate::engine::cells::Stand;
use crate::engine::crossing::Side;
use crate::engine::equations::Equations;
use crate::engine::error::Refusal;
use crate::engine::hybrid::Hybrid;
use crate::engine::law::{self, Law};
use crate::engine::record::State;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::events::{DOUBLE_ZERO, HOLD_ENERGY, ONE_DEFLECTION, RELEASE, SHORT_BOUNCE};

/// What ends the hold of a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The reaction pulls: the phase leaves.
    Release,
    /// The step has vanished: the phase slips through.
    Slip,
}

/// Phases held at steps.
#[derive(Debug, Clone)]
pub struct Contact {
    /// The laws held, and at which side of their cell.
    pub laws: Vec<(usize, Side)>,
    /// N, their outward normals (n, one a column).
    pub normals: DMatrix<f64>,
    /// P, the mobility that is left (n x n).
    pub mobility: Matrix,
    /// What can end the hold of each.
    pub watches: Vec<Watch>,
}

/// A function of the state whose zero ends the hold of a law.
#[derive(Debug, Clone)]
pub struct Watch {
    /// The law.
    pub law: usize,
    /// What then happens.
    pub ending: Ending,
    /// The function.
    pub form: Form,
}

/// The functions that end holds.
#[derive(Debug, Clone)]
pub enum Form {
    /// The reaction plus what it may pull: the generalised forces times a row (n), and a margin.
    Reaction(Vector, f64),
    /// A deflection less the value at which the step vanishes: the coordinates times its gradient (n), less that.
    Deflection(Vector, f64),
}

impl Form {
    /// Its value in a state with the coordinates `q` and the generalised forces that `force` gives (n each).
    pub fn value(&self, q: &[f64], force: impl FnOnce() -> Vector) -> f64 {
        match self {
            Form::Reaction(row, margin) => row.dot(&force()) + margin,
            Form::Deflection(gradient, at) => gradient.dot(q) - at,
        }
    }
}

/// Whether a phase that was just turned back at `side` is pressed against the step so hard, and bounces so little, that
/// it is to be held. `acceleration` is q'' now, `rate` bounds the rates of the cell, `energy` is T + V.
pub fn presses(law: &Law, side: Side, state: &State, acceleration: &Vector, rate: f64, energy: f64) -> bool {
    let v = law.surface.normal.dot(&state.q_dot).abs();
    let a = side.sign() * law.surface.normal.dot(acceleration);
    a > 0.0 && v * v <= HOLD_ENERGY * energy * 2.0 * law.surface.compliance && 2.0 * v * rate <= SHORT_BOUNCE * a
}

impl Contact {
    /// Holds the phases of `held`, those of them whose reactions press; `None` if none does. Brings their normal speeds
    /// to rest and gives the energy that this ignores \[J\].
    ///
    /// # Errors
    /// Where the mass matrix is not positive definite.
    pub fn begin(now: &mut Hybrid<'_>, mut held: Vec<(usize, Side)>) -> Result<(Option<Self>, f64), Refusal> {
        let (equations, force) = (now.equations, now.force());
        loop {
            if held.is_empty() {
                return Ok((None, 0.0));
            }
            let n = now.state.q.len();
            let normals = DMatrix::from_fn(n, held.len(), |i, c| {
                let (law, side) = held[c];
                side.sign() * now.laws[law].surface.normal[i]
            });
            let mass = equations.mass().cholesky().ok_or(Refusal::Mass)?;
            // M⁻¹N, (NᵀM⁻¹N)⁻¹ and R per F.
            let mobility = mass.solve(&normals);
            let compliance = (normals.transpose() * &mobility).cholesky().ok_or(Refusal::Mass)?;
            let to_reactions = compliance.solve(&mobility.transpose());

            let reactions = reactions(now, &held, &to_reactions);
            let pulls = |watch: &Watch| watch.form.value(&now.state.q, || force.clone()) <= 0.0;
            if let Some(pulls) = reactions.iter().position(pulls) {
                held.remove(pulls);
                continue;
            }
            let slips = held.iter().flat_map(|&(law, side)| {
                let zeros = barriers(equations, (&now.laws, &now.bands, &now.k), law, side, &now.state);
                zeros.into_iter().map(move |form| Watch { law, ending: Ending::Slip, form })
            });
            let watches = reactions.into_iter().chain(slips).collect();

            let speeds = normals.transpose() * DVector::from(&now.state.q_dot);
            let impulses = compliance.solve(&speeds);
            now.state.q_dot -= &Vector::from(&(&mobility * &impulses));
            now.state.lost = Vector::zeros(n);
            let ignored = 0.5 * speeds.dot(&impulses);
            let mobility = equations.mobility() - &mobility * &to_reactions;
            return Ok((Some(Contact { laws: held, normals, mobility, watches }), ignored));
        }
    }

    /// Whether a law's phase is held.
    pub fn holds(&self, law: usize) -> bool {
        self.laws.iter().any(|l| l.0 == law)
    }
}

/// The reactions of held phases, each with what it may pull; `to_reactions` gives them from generalised forces.
fn reactions(now: &Hybrid<'_>, held: &[(usize, Side)], to_reactions: &DMatrix<f64>) -> Vec<Watch> {
    let (equations, k, State { q, q_dot, .. }) = (now.equations, &now.k, &now.state);
    let (stiffness, damping) = (equations.stiffness(k), equations.damping(k));
    let load = DVector::from(&(equations.load(k) + &now.further_load()));
    let n = q.len();
    let reaction = |(c, &(law, _)): (usize, &(usize, Side))| {
        let w = to_reactions.rows(c, 1);
        let row = |m: Matrix| Vector::from_fn(n, |i| m[(0, i)]);
        let (on_q, on_speed) = (row(w * &stiffness), row(w * &damping));
        let forces = (w * &load)[0].abs() + on_q.abs().dot(&q.abs()) + on_speed.abs().dot(&q_dot.abs());
        let row = Vector::from_fn(n, |i| w[(0, i)]);
        Watch { law, ending: Ending::Release, form: Form::Reaction(row, RELEASE * forces) }
    };
    held.iter().enumerate().map(reaction).collect()
}

/// Whether a step of a law is none in the present cell, whatever the state: what it strains is out of contact.
pub fn is_void(equations: &dyn Equations, stand: Stand<'_>, (law, side): (usize, Side), state: &State) -> bool {
    let (beyond, k) = (law::beyond(stand, law, side, state), stand.2);
    equations.stiffness(k) == equations.stiffness(&beyond) && equations.load(k) == equations.load(&beyond)
}

/// What vanishes with the step of a law: of dV = q.dK q/2 - df.q + h
/// - that of a transmission error, dK = 0: it is linear;
/// - that of the stiffness of one deflection x = d.q, c x²/2 - g x + h with dK = c d dᵀ and df = g d, each of its zeros; of a
///   mere stiffness it is c (x - e)²/2.
///
/// Nothing where the law strains more than one deflection: they do not vanish together. Laws of other phases are taken at their
/// present values.
fn barriers(equations: &dyn Equations, stand: Stand<'_>, law: usize, side: Side, state: &State) -> Vec<Form> {
    let (beyond, k) = (law::beyond(stand, law, side, state), stand.2);
    let (here, there) = (equations.stiffness(k), equations.stiffness(&beyond));
    let (load_here, load_there) = (equations.load(k), equations.load(&beyond));
    let (stiffness, load) = (there - here, load_there - &load_here);
    let n = load.len();
    let still = Vector::zeros(n);
    let h = equations.potential(&still, &beyond) - equations.potential(&still, k);
    if stiffness.amax() == 0.0 {
        return vec![Form::Deflection(-load, -h)];
    }
    let diagonal = stiffness.diagonal();
    let row = diagonal.iamax();
    let c = diagonal[row];
    let d = Vector::from_fn(n, |i| stiffness[(i, row)] / c);
    let g = load[row];
    let one = DMatrix::from_fn(n, n, |i, j| c * d[i] * d[j]);
    let of_one = (&stiffness - one).amax() <= ONE_DEFLECTION * stiffness.amax()
        && (&load - &(&d * g)).amax() <= ONE_DEFLECTION * load.amax();
    if !of_one {
        return vec![];
    }
    let (middle, square) = (g / c, (g / c).powi(2) - 2.0 * h / c);
    let at = |x: f64| Form::Deflection(d.clone(), x);
    match square.abs() <= DOUBLE_ZERO * middle.powi(2) {
        true => vec![at(middle)],
        false if square < 0.0 => vec![],
        false => vec![at(middle - square.sqrt()), at(middle + square.sqrt())],
    }
}
