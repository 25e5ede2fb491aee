//! Holds: motions that a reaction prevents. A phase is held at a step that it cannot pass, once its bounces are negligible; a switch
//! may hold its deflection (dry friction at rest, a locked clutch).
//!
//! **Phases.** Each reflection keeps the normal speed, damping reduces it, and the bounces become ever shorter. Once the energy of the
//! normal motion E = v²/(2 G) is below `HOLD_ENERGY` of all energy and a bounce is short, the phase is held where it is:
//! n.q' = 0, with the reaction R. E is neglected at each hold; the sum is in the account. The hold ends when
//! - R pulls, by `RELEASE` of the forces that it consists of: the phase leaves the step it came from;
//! - the step vanishes, dV = 0: the phase slips through without loss; with play, that is also where the flanks beyond it separate;
//! - a step of another stiffness gives an impulse: what is held is released, and bounces or leaves.
//!
//! **Deflections.** A switch enters a mode that holds where the rate of its deflection is zero. Its guards are linear in the reaction, and
//! the hold ends at the zero of one. Friction and clutches transmit bounded forces, so they transmit no impulse: the deflection slips after
//! an impulse, and sticks again later.
//!
//! With the outward normals n of the held phases and the gradients of the held deflections as columns of N, the remaining motion has the
//! mobility P = M⁻¹ - M⁻¹N (NᵀM⁻¹N)⁻¹ NᵀM⁻¹, and the reactions to the generalised forces F are R = (NᵀM⁻¹N)⁻¹ NᵀM⁻¹ F. N is constant. Where
//! M depends on the coordinates, so do P and the factors of F in R; both are then computed where they are needed ([`held`]). The same is done
//! where a switch holds a rate in which friction laws are factors; N then changes with the motion ([`Turned`]).

use nalgebra::linalg::Cholesky;
use nalgebra::{DMatrix, DVector, Dyn};

use crate::engine::cells::Stand;
use crate::engine::crossing::Side;
use crate::engine::equations::{Affine, Equations};
use crate::engine::error::Refusal;
use crate::engine::hybrid::Hybrid;
use crate::engine::law::{self, LawState};
use crate::engine::motion::End;
use crate::engine::record::State;
use crate::engine::switch::Switch;
use crate::engine::vector::{Matrix, Vector};
use crate::tolerance::events::{DOUBLE_ZERO, HOLD_ENERGY, INDEPENDENT, ONE_DEFLECTION, RELEASE, SHORT_BOUNCE};

/// How the hold of a law ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The reaction pulls: the phase leaves.
    Release,
    /// The step has vanished: the phase slips through.
    Slip,
}

/// Phases held at steps, and deflections held by switches.
#[derive(Debug, Clone)]
pub struct Contact {
    /// The laws held, and at which side of their cell.
    pub laws: Vec<(usize, Side)>,
    /// The switches that hold their deflections, and the column of N that is the gradient of each.
    pub switches: Vec<(usize, usize)>,
    /// N, the outward normals of the laws, then the gradients of the deflections (n, one a column).
    pub normals: DMatrix<f64>,
    /// P, the remaining mobility (n x n), where the hold began.
    pub mobility: Matrix,
    /// The functions that can end the holds.
    pub watches: Vec<Watch>,
    /// Those of `switches` whose held rates have friction laws as factors, which vary while the phase moves.
    turning: Vec<(usize, usize)>,
    /// The switches whose deflections cannot move, because of their own hold or of other holds.
    pub locked: Vec<usize>,
}

/// Held motions whose gradients vary: Nᵀq' = 0 gives Nᵀq'' = -N'ᵀq'. With the force c = N (NᵀM⁻¹N)⁻¹ N'ᵀq' the reactions are those to F + c, and
/// q'' = P F - M⁻¹ c.
pub struct Turned {
    /// N (n, one a column).
    pub normals: DMatrix<f64>,
    /// c (n).
    pub force: Vector,
}

impl Turned {
    /// The speeds without the errors of the held ones; `mobility` is M⁻¹.
    pub fn still(&self, mobility: &Matrix, q_dot: &Vector) -> Vector {
        let held = self.normals.transpose() * DVector::from(q_dot);
        q_dot - &(mobility * &centripetal(mobility, &self.normals, &held))
    }
}

/// A function of the state whose zero ends a hold.
#[derive(Debug, Clone)]
pub struct Watch {
    /// The event at the zero.
    pub end: End,
    /// The function.
    pub form: Form,
}

/// A linear function of the coordinates, the speeds and the generalised forces F (n each).
#[derive(Debug, Clone)]
pub struct Form {
    /// Its slopes along the coordinates.
    pub on_q: Vector,
    /// Those along the speeds.
    pub on_speed: Vector,
    /// Those along the forces: a multiple of a row of the factors of the reactions.
    pub on_force: Vector,
    /// The number of that row, and the multiple; `None` if the function does not depend on reactions.
    reaction: Option<(usize, f64)>,
    /// Its value where all of them are zero, without the margin.
    constant: f64,
    /// How far a reaction may pull before the hold ends. It is 0 if the function does not depend on reactions.
    margin: f64,
}

impl Watch {
    /// Its function at the coordinates `q` and the law values `k`. Curved laws are factors of the guards of a switch, so that these change
    /// within a mode.
    pub fn at(&self, equations: &dyn Equations, switches: &[Switch], q: &[f64], k: &[f64]) -> Form {
        let (End::Loose(switch, beyond), Some((_, factor))) = (self.end, self.form.reaction) else {
            return self.form.clone();
        };
        let exits = switches[switch].exits(equations, q, k);
        let exit = exits.into_iter().find(|exit| exit.beyond == beyond && exit.guard.on_reaction == factor);
        let guard = exit.expect("the guard of which the hold was made").guard;
        let constant = guard.constant_at(k);
        Form { on_q: guard.on_q, on_speed: guard.on_speed, constant, ..self.form.clone() }
    }
}

impl Form {
    /// R plus the margin by which it may pull: the forces times row `which` of the factors, plus the margin.
    fn reaction(on_force: Vector, which: usize, margin: f64) -> Self {
        let none = Vector::zeros(on_force.len());
        Form { on_q: none.clone(), on_speed: none, on_force, reaction: Some((which, 1.0)), constant: 0.0, margin }
    }

    /// Its value where coordinates, speeds and forces are zero.
    pub fn constant(&self) -> f64 {
        self.constant + self.margin
    }

    /// The same function where the factors of the reactions are `to_reactions` (one a row).
    pub fn at(&self, to_reactions: &DMatrix<f64>) -> Self {
        let row =
            |(which, factor): (usize, f64)| Vector::from_fn(self.on_force.len(), |i| factor * to_reactions[(which, i)]);
        Form { on_force: self.reaction.map_or_else(|| self.on_force.clone(), row), ..self.clone() }
    }

    /// A deflection less the value `at`.
    fn deflection(on_q: Vector, at: f64) -> Self {
        let none = Vector::zeros(on_q.len());
        Form { on_q, on_speed: none.clone(), on_force: none, reaction: None, constant: -at, margin: 0.0 }
    }

    /// Its value at coordinates and speeds, with the generalised forces that `force` gives.
    pub fn value(&self, q: &[f64], q_dot: &[f64], force: impl FnOnce() -> Vector) -> f64 {
        self.on_q.dot(q) + self.on_speed.dot(q_dot) + self.on_force.dot(&force()) + self.constant()
    }
}

/// Whether a phase that was just reflected at `side` must be held: it is pressed against the step, and its bounces are negligible.
/// `acceleration` is q'' now, `rate` bounds the rates of the cell, `energy` is T + V.
pub fn presses(law: &LawState, side: Side, state: &State, acceleration: &Vector, rate: f64, energy: f64) -> bool {
    let v = law.surface.normal.dot(&state.q_dot).abs();
    let a = side.sign() * law.surface.normal.dot(acceleration);
    a > 0.0 && v * v <= HOLD_ENERGY * energy * 2.0 * law.surface.compliance && 2.0 * v * rate <= SHORT_BOUNCE * a
}

impl Contact {
    /// Holds the phases of `laws` whose reactions press. Holds the deflections of switches in modes that hold, if the mode admits the
    /// reaction; other switches go on to the modes beyond. `None` if nothing is held. Sets the held speeds to zero and returns the energy
    /// that this neglects \[J\].
    ///
    /// # Errors
    /// If the mass matrix is not positive definite.
    pub fn begin(now: &mut Hybrid<'_>, mut laws: Vec<(usize, Side)>) -> Result<(Option<Self>, f64), Refusal> {
        loop {
            let holds = Holds::new(now, &laws)?;
            if holds.held.is_empty() {
                return Ok((None, 0.0));
            }
            let watches = holds.watches(now);
            let State { q, q_dot, .. } = &now.state;
            let force = now.force() + &holds.centripetal(now);
            let pulls = |watch: &&Watch| watch.form.value(q, q_dot, || force.clone()) <= 0.0;
            match watches.iter().filter(|watch| !matches!(watch.end, End::Hold(_, Ending::Slip))).find(pulls) {
                Some(Watch { end: End::Loose(switch, mode), .. }) => {
                    let (switch, mode) = (*switch, *mode);
                    now.set_mode(switch, mode);
                }
                Some(Watch { end: End::Hold(law, _), .. }) => {
                    let law = *law;
                    laws.retain(|held| held.0 != law);
                }
                _ => return holds.begin(now, watches),
            }
        }
    }

    /// N at a state and the force c, where friction laws are factors of held rates; otherwise `None`. `k_dot` gives the rates of the law values `k`.
    pub fn turned(
        &self,
        (equations, switches): (&dyn Equations, &[Switch]),
        (q, q_dot): (&[f64], &[f64]),
        k: &[f64],
        k_dot: impl FnOnce() -> Vec<f64>,
    ) -> Option<Turned> {
        if self.turning.is_empty() {
            return None;
        }
        let k_dot = k_dot();
        let mut normals = self.normals.clone();
        let mut drift = DVector::zeros(normals.ncols());
        for &(switch, column) in &self.turning {
            let switch = &switches[switch];
            normals.set_column(column, &DVector::from(&switch.held(equations, q, k)));
            drift[column] = switch.drift(equations, (q, q_dot), &k_dot);
        }
        let force = centripetal(&equations.mobility(q), &normals, &drift);
        Some(Turned { normals, force })
    }

    /// Whether friction laws are factors of held rates.
    pub fn turns(&self) -> bool {
        !self.turning.is_empty()
    }

    /// Whether a law's phase is held.
    pub fn holds(&self, law: usize) -> bool {
        self.laws.iter().any(|l| l.0 == law)
    }
}

/// A held motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Held {
    /// The phase of a law, at a side of its cell.
    Law(usize, Side),
    /// The deflection of a switch.
    Switch(usize),
}

/// The held motions, with the matrices of their reactions.
struct Holds {
    held: Vec<Held>,
    normals: DMatrix<f64>,
    /// M⁻¹N.
    mobility: DMatrix<f64>,
    /// (NᵀM⁻¹N)⁻¹.
    compliance: Cholesky<f64, Dyn>,
    /// R per F.
    to_reactions: DMatrix<f64>,
}

impl Holds {
    /// The phases of `laws` and the deflections of switches in modes that hold. A motion that earlier holds already prevent is left out,
    /// because it has no reaction of its own.
    fn new(now: &Hybrid<'_>, laws: &[(usize, Side)]) -> Result<Self, Refusal> {
        let stuck = (0..now.switches.len()).filter(|&i| now.switches[i].here().held).map(Held::Switch);
        let mass = now.equations.mass(&now.state.q).cholesky().ok_or(Refusal::Mass)?;
        let (n, mut held, mut columns) = (now.state.q.len(), vec![], vec![]);
        for one in laws.iter().map(|&(law, side)| Held::Law(law, side)).chain(stuck) {
            let normal = match one {
                Held::Law(law, side) => &now.laws[law].surface.normal * side.sign(),
                Held::Switch(switch) => now.switches[switch].held(now.equations, &now.state.q, &now.k),
            };
            columns.push(DVector::from(&normal));
            if !is_free(&mass, &columns) {
                columns.pop();
                continue;
            }
            held.push(one);
        }
        let normals = DMatrix::from_fn(n, held.len(), |i, c| columns[c][i]);
        let mobility = mass.solve(&normals);
        let compliance = (normals.transpose() * &mobility).cholesky().ok_or(Refusal::Mass)?;
        let to_reactions = compliance.solve(&mobility.transpose());
        Ok(Holds { held, normals, mobility, compliance, to_reactions })
    }

    /// The functions that end the holds. For a law: its reaction plus the margin, and the zeros of its step. For a switch: its guards plus
    /// the same margin.
    fn watches(&self, now: &Hybrid<'_>) -> Vec<Watch> {
        let (equations, k, State { q, q_dot, .. }) = (now.equations, &now.k, &now.state);
        let (stiffness, damping) = (equations.stiffness(k), equations.damping(k));
        let load = DVector::from(&(equations.load(k) + &now.further_load()));
        let n = q.len();
        let (mut reactions, mut slips) = (vec![], vec![]);
        for (c, held) in self.held.iter().enumerate() {
            let w = self.to_reactions.rows(c, 1);
            let row = |m: Matrix| Vector::from_fn(n, |i| m[(0, i)]);
            let (on_q, on_speed) = (row(w * &stiffness), row(w * &damping));
            let forces = (w * &load)[0].abs() + on_q.abs().dot(&q.abs()) + on_speed.abs().dot(&q_dot.abs());
            let row = Vector::from_fn(n, |i| w[(0, i)]);
            match *held {
                Held::Law(law, side) => {
                    let form = Form::reaction(row, c, RELEASE * forces);
                    reactions.push(Watch { end: End::Hold(law, Ending::Release), form });
                    let stand = (&now.laws[..], &now.switches[..], &k[..]);
                    let zeros = barriers(equations, stand, law, side, &now.state).into_iter();
                    slips.extend(zeros.map(|form| Watch { end: End::Hold(law, Ending::Slip), form }));
                }
                Held::Switch(i) => {
                    for exit in now.switches[i]
                        .exits(equations, &now.state.q, k)
                        .into_iter()
                        .filter(|exit| exit.guard.on_reaction != 0.0)
                    {
                        let Affine { on_reaction, .. } = exit.guard;
                        let (constant, margin) = (exit.guard.constant_at(k), RELEASE * on_reaction.abs() * forces);
                        let (on_q, on_speed) = (exit.guard.on_q.clone(), exit.guard.on_speed.clone());
                        let form = Form {
                            on_q,
                            on_speed,
                            on_force: &row * on_reaction,
                            reaction: Some((c, on_reaction)),
                            constant,
                            margin,
                        };
                        reactions.push(Watch { end: End::Loose(i, exit.beyond), form });
                    }
                }
            }
        }
        reactions.into_iter().chain(slips).collect()
    }

    /// The force c that varying factors of the held rates add to the reactions.
    fn centripetal(&self, now: &Hybrid<'_>) -> Vector {
        let State { q, q_dot, .. } = &now.state;
        let k_dot = now.law_rates(q, q_dot);
        let drift = self.held.iter().map(|held| match held {
            Held::Law(..) => 0.0,
            Held::Switch(switch) => now.switches[*switch].drift(now.equations, (q, q_dot), &k_dot),
        });
        let drift = DVector::from_iterator(self.held.len(), drift);
        if drift.amax() == 0.0 {
            return Vector::zeros(q.len());
        }
        centripetal(&now.equations.mobility(q), &self.normals, &drift)
    }

    /// Sets the held speeds to zero.
    fn begin(self, now: &mut Hybrid<'_>, watches: Vec<Watch>) -> Result<(Option<Contact>, f64), Refusal> {
        let Holds { held, normals, mobility, compliance, to_reactions } = self;
        let speeds = normals.transpose() * DVector::from(&now.state.q_dot);
        let impulses = compliance.solve(&speeds);
        // In double-double precision, the solver sets them to zero.
        if now.state.low.is_empty() {
            now.state.q_dot -= &Vector::from(&(&mobility * &impulses));
            now.state.lost = Vector::zeros(now.state.q.len());
        }
        let neglected = 0.5 * speeds.dot(&impulses);
        let laws = held.iter().filter_map(|held| match held {
            Held::Law(law, side) => Some((*law, *side)),
            Held::Switch(_) => None,
        });
        let laws = laws.collect();
        let switches = held.iter().enumerate().filter_map(|(column, held)| match held {
            Held::Switch(switch) => Some((*switch, column)),
            Held::Law(..) => None,
        });
        let switches: Vec<_> = switches.collect();
        let turns = |&(switch, _): &(usize, usize)| now.switches[switch].turns(now.equations, &now.state.q, &now.k);
        let turning = switches.iter().copied().filter(turns).collect();
        let mass = now.equations.mass(&now.state.q).cholesky().ok_or(Refusal::Mass)?;
        let columns: Vec<DVector<f64>> = normals.column_iter().map(|column| column.into_owned()).collect();
        let is_locked = |i: &usize| {
            let normal = DVector::from(&now.switches[*i].normal);
            held.contains(&Held::Switch(*i)) || !is_free(&mass, &[&columns[..], &[normal]].concat())
        };
        let locked = (0..now.switches.len()).filter(is_locked).collect();
        let mobility = now.equations.mobility(&now.state.q) - &mobility * &to_reactions;
        Ok((Some(Contact { laws, switches, normals, mobility, watches, turning, locked }), neglected))
    }
}

/// N (NᵀM⁻¹N)⁻¹ d, from M⁻¹ = `mobility` and N = `normals`; NaN if NᵀM⁻¹N is not positive definite.
fn centripetal(mobility: &Matrix, normals: &DMatrix<f64>, d: &DVector<f64>) -> Vector {
    let compliance = (normals.transpose() * (mobility * normals)).cholesky();
    let force = compliance.map(|compliance| normals * compliance.solve(d));
    force.map_or_else(|| Vector::from_fn(normals.nrows(), |_| f64::NAN), |force| Vector::from(&force))
}

/// P and the factors of the forces in the reactions, from M⁻¹ = `mobility` and N = `normals`; NaN if NᵀM⁻¹N is not positive definite.
pub fn held(mobility: &Matrix, normals: &DMatrix<f64>) -> (Matrix, DMatrix<f64>) {
    let response = mobility * normals;
    let unknown = || DMatrix::repeat(normals.ncols(), normals.nrows(), f64::NAN);
    let compliance = (normals.transpose() * &response).cholesky();
    let to_reactions = compliance.map_or_else(unknown, |compliance| compliance.solve(&response.transpose()));
    (mobility - &response * &to_reactions, to_reactions)
}

/// Whether the last of several motions is possible while those before it are held. Each is a column of gradients (n).
fn is_free(mass: &Cholesky<f64, Dyn>, columns: &[DVector<f64>]) -> bool {
    let Some((last, before)) = columns.split_last() else { return true };
    let response = mass.solve(last);
    let alone = last.dot(&response);
    if before.is_empty() {
        return alone > 0.0;
    }
    let before = DMatrix::from_columns(before);
    let coupling = before.transpose() * &response;
    let compliance = (before.transpose() * mass.solve(&before)).cholesky();
    let left = compliance.map(|compliance| alone - coupling.dot(&compliance.solve(&coupling)));
    left.is_some_and(|left| left > INDEPENDENT * alone)
}

/// Whether dV of a law is zero at every state in the present cell, because the deflection that it strains is out of contact.
pub fn is_void(equations: &dyn Equations, stand: Stand<'_>, law: (usize, Side), state: &State) -> bool {
    StepOfV::new(equations, stand, law, state)
        .is_some_and(|StepOfV { stiffness, load, .. }| stiffness.amax() == 0.0 && load.amax() == 0.0)
}

/// The step of V at a boundary, dV = q.dK q/2 - df.q + h.
struct StepOfV {
    /// dK (n x n).
    stiffness: Matrix,
    /// df (n).
    load: Vector,
    /// h.
    at_zero: f64,
}

impl StepOfV {
    /// The step of a law at a side of its cell. `None` if dV is not quadratic in the coordinates.
    fn new(equations: &dyn Equations, stand: Stand<'_>, (law, side): (usize, Side), state: &State) -> Option<Self> {
        let (beyond, k, q) = (law::beyond(equations, stand, law, side, state), stand.2, &state.q);
        let stiffness = equations.stiffness(&beyond) - equations.stiffness(k);
        let load = equations.load(&beyond) - &equations.load(k);
        let still = Vector::zeros(load.len());
        let dv = |q: &[f64]| equations.potential(q, &beyond) - equations.potential(q, k);
        let at_zero = dv(&still);
        let (bent, pulled) = (0.5 * q.dot(&(&stiffness * q)), load.dot(q));
        let size = equations.potential(q, &beyond).abs() + bent.abs() + pulled.abs() + at_zero.abs();
        let error = dv(q) - (bent - pulled + at_zero);
        (error.abs() <= ONE_DEFLECTION * size).then_some(StepOfV { stiffness, load, at_zero })
    }
}

/// Linear functions of the coordinates that are zero where the step dV = q.dK q/2 - df.q + h of a law is:
/// - for a transmission error dK = 0, and dV itself is linear;
/// - for the stiffness of one deflection x = d.q, dV = c x²/2 - g x + h with dK = c d dᵀ and df = g d, one function for each root x.
///
/// There are none if the law strains several deflections, which are not zero together, or if dV is not of this form. Laws of other phases
/// have their present values.
fn barriers(equations: &dyn Equations, stand: Stand<'_>, law: usize, side: Side, state: &State) -> Vec<Form> {
    let Some(StepOfV { stiffness, load, at_zero: h }) = StepOfV::new(equations, stand, (law, side), state) else {
        return vec![];
    };
    let n = load.len();
    if stiffness.amax() == 0.0 {
        return vec![Form::deflection(-load, -h)];
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
    let at = |x: f64| Form::deflection(d.clone(), x);
    match square.abs() <= DOUBLE_ZERO * middle.powi(2) {
        true => vec![at(middle)],
        false if square < 0.0 => vec![],
        false => vec![at(middle - square.sqrt()), at(middle + square.sqrt())],
    }
}
