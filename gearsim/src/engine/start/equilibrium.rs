//! Static equilibrium: the coordinates at which the generalised forces on them are zero, without the part that accelerates the rigid
//! motions. With the rigid motions R, RᵀM R = 1, this is (1 - M R Rᵀ) F = 0. If the torques are not in balance, the rotors speed up
//! together, with constant deflections between them.
//!
//! The equations F(q, q'; k(s)) = 0 for the free coordinates are solved by Newton's method. Its matrix is the exact derivative of the
//! forces, [`Equations::jacobian`]. A law whose phase is free is followed from cell to cell. A step of the iteration ends at the first
//! boundary that it meets; the law enters the next cell there, and the iteration continues with the stiffness of this cell. If the forces
//! of both cells push a phase towards the boundary between them, the phase is in equilibrium on that boundary.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use crate::engine::crossing::Side;
use crate::engine::equations::{Equations, Switching};
use crate::engine::error::Refusal;
use crate::engine::law::{self, LawState};
use crate::engine::record::State;
use crate::engine::start::rigid::RigidMotions;
use crate::engine::switch::Switch;
use crate::engine::vector::{Matrix, Vector};
use crate::model::Coordinate;
use crate::scene::Scene;
use crate::tolerance::start;

/// The equilibrium problem of the coordinates `free`, with the others given.
pub struct Equilibrium<'a> {
    pub equations: &'a dyn Equations,
    pub scene: &'a Scene,
    /// Indices of the coordinates in equilibrium.
    pub free: &'a [usize],
    /// Speeds at the start (n). Forces that depend on speeds, e.g. of a motor or a damper, act as at the start.
    pub q_dot: Vector,
}

/// An equilibrium: the state, and the laws in their cells.
#[derive(Clone)]
pub struct Settled {
    pub state: State,
    pub laws: Vec<LawState>,
    /// Whether the strain energy has a minimum there, with respect to the coordinates that are not on a boundary.
    pub stable: bool,
    /// The force that each hold of a rigid motion resists, with the index of its switch.
    pub reactions: Vec<(usize, f64)>,
}

/// A state, the laws in their cells, and the switches in their modes.
type Configuration<'a> = (&'a State, &'a [LawState], &'a [Switch]);

/// A step of the iteration (n). It is zero for the coordinates that do not move.
struct NewtonStep {
    step: Vector,
    /// The diagonal of the stiffness matrix, absolute values (n).
    stiffness: Vector,
    /// Whether V is convex here.
    stable: bool,
}

impl Equilibrium<'_> {
    /// The equilibrium found from the coordinates `guess` (n), with the switches in their present modes.
    ///
    /// # Errors
    /// [`Refusal::NoEquilibrium`] if the iteration finds none; those of [`LawState::begin`].
    pub fn from(&self, guess: &Vector, switches: &[Switch]) -> Result<Settled, Refusal> {
        let (mut state, mut laws) = self.begin(guess.clone())?;
        let rigid = self.rigid_motions(&state, &laws, switches);
        // The coordinates held on a boundary to which both cells push them.
        let mut held: Vec<usize> = vec![];
        let mut entered: Option<(usize, Side)> = None;
        let (mut reached, mut last) = (Vector::zeros(guess.len()), f64::INFINITY);
        for _ in 0..start::STEPS {
            let moving: Vec<usize> = self.free.iter().copied().filter(|i| !held.contains(i)).collect();
            let NewtonStep { step, stiffness, stable } =
                self.newton(&moving, (&state, &laws, switches), &rigid).ok_or_else(|| self.refusal())?;
            if laws.iter().any(|law| step[law.phase].abs() > law.pitch.period()) {
                // The step is longer than a pitch: restart at its end instead of passing every boundary on the way.
                let here = state.unwrapped(&law::turn_lengths(state.q.len(), &laws));
                (state, laws) = self.begin(here + &step)?;
                (held, entered, last) = (vec![], None, f64::INFINITY);
                continue;
            }
            if let Some((part, law, side)) = first_boundary(&laws, &state, &step) {
                let phase = laws[law].phase;
                state.q += &(&step * part);
                laws[law].snap(side, &mut state);
                if entered == Some((phase, side.opposite())) && part == 0.0 {
                    held.push(phase);
                } else {
                    law::enter(&mut laws, law, side, &mut state);
                }
                (entered, last) = (Some((phase, side)), f64::INFINITY);
                continue;
            }
            state.q += &step;
            reached = reached.zip_map(&state.q, |a, b| a.max(b.abs()));
            if step.iter().any(|x| *x != 0.0) {
                entered = None;
            }
            let size = energy(&stiffness, &step) / energy(&stiffness, &reached).max(f64::MIN_POSITIVE);
            if size <= start::CONVERGED || (size <= start::STALLED && size >= 0.5 * last) {
                let (_, external, _) = self.balance((&state, &laws, switches));
                return Ok(self.settled((state, laws), stable, rigid.reactions(&external)));
            }
            last = size;
        }
        Err(self.refusal())
    }

    /// The state at the coordinates `q` (n), with each law in its cell. All phases move during the iteration. Phases that the scene freezes
    /// are frozen at the end of the iteration.
    fn begin(&self, q: Vector) -> Result<(State, Vec<LawState>), Refusal> {
        let mut state = State::new(q, self.q_dot.clone());
        let laws = LawState::moving(self.equations, self.scene, &mut state)?;
        Ok((state, laws))
    }

    /// The laws at the start of the motion. A phase on a boundary is in the cell into which it moves. Phases that the scene freezes are
    /// frozen here.
    fn settled(
        &self,
        (mut state, mut laws): (State, Vec<LawState>),
        stable: bool,
        reactions: Vec<(usize, f64)>,
    ) -> Settled {
        for i in 0..laws.len() {
            let speed = self.q_dot[laws[i].phase];
            for (side, onwards) in [(Side::Upper, speed >= 0.0), (Side::Lower, speed < 0.0)] {
                if onwards && self.free.contains(&laws[i].phase) && laws[i].is_at(side, &state, 0.0) {
                    law::enter(&mut laws, i, side, &mut state);
                }
            }
        }
        let mut settled = Settled { state, laws, stable, reactions };
        let there = settled.absolute();
        settled.laws.iter_mut().for_each(|law| law.freeze(&there, &self.q_dot));
        settled
    }

    /// Newton's step. Where V is not convex, negative curvatures count as positive, so that the step reduces V and leads to the
    /// minimum nearest to the guess. `None` if the forces do not determine the step.
    fn newton(&self, moving: &[usize], place: Configuration<'_>, rigid: &RigidMotions) -> Option<NewtonStep> {
        let (mut step, mut diagonal) = (Vector::zeros(self.q_dot.len()), Vector::zeros(self.q_dot.len()));
        if moving.is_empty() {
            return Some(NewtonStep { step, stiffness: diagonal, stable: true });
        }
        let (force, external, stiffness) = self.balance(place);
        // The forces along rigid motions do not depend on the deflections, so subtracting them does not change the derivative.
        let force = rigid.without(force, &external);
        let stiffness = DMatrix::from_fn(moving.len(), moving.len(), |i, j| stiffness[(moving[i], moving[j])]);
        let force = DVector::from_fn(moving.len(), |i, _| force[moving[i]]);
        moving.iter().enumerate().for_each(|(i, &row)| diagonal[row] = stiffness[(i, i)].abs());
        let (unit, scaled) = scaled(&stiffness);
        let stable = scaled.clone().cholesky().is_some();
        // A matrix with an overflow has no curvatures. It is refused below.
        let curvatures = (!stable && scaled.iter().all(|x| x.is_finite())).then(|| scaled.symmetric_eigen());
        let concave = curvatures.filter(|curvatures| curvatures.eigenvalues.min() < -start::FLAT);
        let solved = match concave {
            Some(curvatures) => {
                let along = curvatures.eigenvectors.tr_mul(&force.component_div(&unit));
                let along = along.zip_map(&curvatures.eigenvalues, |force, curvature| force / curvature.abs());
                (curvatures.eigenvectors * along).component_div(&unit)
            }
            None => stiffness.lu().solve(&force)?,
        };
        if solved.iter().any(|x| !x.is_finite()) {
            return None;
        }
        moving.iter().zip(solved.iter()).for_each(|(&i, x)| step[i] = *x);
        Some(NewtonStep { step, stiffness: diagonal, stable })
    }

    /// The generalised forces (n), the same forces without those of the slopes of laws (n), and minus the derivatives of the forces by the
    /// coordinates (n x n).
    fn balance(&self, (state, laws, switches): Configuration<'_>) -> (Vector, Vector, Matrix) {
        let [mut k, dk, ddk] = courses(self.scene, state, laws);
        switches.iter().for_each(|switch| switch.write(&mut k));
        let (q, v) = (&state.q, &self.q_dot);
        if self.scene.effects.nonlinear(self.scene.model).is_empty() && laws.iter().all(|law| law.pitch.steps_only()) {
            let (stiffness, damping, load) =
                (self.equations.stiffness(&k), self.equations.damping(&k), self.equations.load(&k));
            let force = load - &(&stiffness * q) - &(&damping * v);
            return (force.clone(), force, stiffness);
        }
        let [slopes, _] = self.equations.jacobian(q, v, &k, &dk, &ddk);
        let external = self.equations.force(q, v, &k, &vec![0.0; dk.len()]);
        (self.equations.force(q, v, &k, &dk), external, -slopes)
    }

    /// The rigid motions at a state, and the holds that prevent a part of them. The laws count as constant.
    fn rigid_motions(&self, state: &State, laws: &[LawState], switches: &[Switch]) -> RigidMotions {
        let [mut k, mut flat, _] = courses(self.scene, state, laws);
        switches.iter().for_each(|switch| switch.write(&mut k));
        flat.fill(0.0);
        let rest = Vector::zeros(state.q.len());
        let springs = self.equations.stiffness(&k);
        let stiffness = if self.scene.effects.nonlinear(self.scene.model).is_empty() {
            springs.clone()
        } else {
            let [by_q, _] = self.equations.jacobian(&state.q, &rest, &k, &flat, &flat);
            -by_q
        };
        // Forces of dampers may cancel forces that do not depend on speeds, or one another.
        let (at_rest, damping) = (self.equations.force(&state.q, &rest, &k, &flat), self.equations.damping(&k));
        let damped = |i: usize| (0..rest.len()).map(|j| (damping[(i, j)] * self.q_dot[j]).abs()).sum::<f64>();
        let sizes = Vector::from_fn(rest.len(), |i| at_rest[i].abs() + damped(i));
        let mut rigid =
            RigidMotions::at((self.equations, self.scene), &state.q, [&stiffness, &springs], &sizes, self.free);
        let mobility = self.equations.mobility(&state.q);
        for (i, switch) in switches.iter().enumerate().filter(|(_, switch)| switch.here().held) {
            rigid.hold(i, switch.held(self.equations, &state.q, &k), &mobility);
        }
        rigid
    }

    /// Other equilibria, found from guesses around `settled`, in order of their distance from `guess`.
    ///
    /// A linear cell in given modes of the switches has one equilibrium. Others are sought only if phases are free (in the neighbouring
    /// cells), or if cells are not linear.
    pub fn others(&self, settled: &Settled, guess: &Vector, switches: &[Switch]) -> Vec<Settled> {
        let linear = self.scene.effects.nonlinear(self.scene.model).is_empty();
        let (at, mut found) = (settled.absolute(), vec![settled.clone()]);
        for &i in self.free {
            let steps: Vec<f64> = match settled.laws.iter().find(|law| law.phase == i && law.pitch.cells() > 1) {
                Some(law) => {
                    [law.boundary(Side::Upper), law.boundary(Side::Lower)].map(|b| b - settled.state.q[i]).into()
                }
                None if linear => vec![],
                None if self.scene.model.coordinates[i].unit == "rad" => {
                    [0.5, 1.0, -0.5, -1.0].map(|half_turns| half_turns * PI).into()
                }
                None => {
                    // The mirrored place, and places of many sizes, because the unit does not show the scale.
                    let sizes =
                        [1.0, 2.0, 4.0].map(|x| x * at[i].abs()).into_iter().chain((-6..2).map(|n| 10f64.powi(n)));
                    sizes.flat_map(|size| [size - at[i], -size - at[i]]).collect()
                }
            };
            for step in steps.into_iter().filter(|step| *step != 0.0) {
                let mut from = at.clone();
                // Start beyond the boundary, not on it.
                from[i] += start::BEYOND * step;
                let other = self.from(&from, switches).ok();
                found.extend(other.filter(|other| !found.iter().any(|known| self.same(known, other))));
            }
        }
        found.remove(0);
        let distance = |other: &Settled| {
            let apart = other.absolute() - guess;
            apart.dot(&apart).sqrt()
        };
        found.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        found
    }

    fn same(&self, a: &Settled, b: &Settled) -> bool {
        let (a, b) = (a.absolute(), b.absolute());
        self.free.iter().all(|&i| (a[i] - b[i]).abs() <= start::SAME * a[i].abs().max(b[i].abs()))
    }

    /// The message about the equilibria `found` besides the one that is taken; `None` if there are no others and this one is stable.
    pub fn describe(&self, taken: &Settled, found: &[Settled]) -> Option<String> {
        let place = |settled: &Settled| {
            let at = settled.absolute();
            let coordinate = |&i: &usize| {
                let Coordinate { name, unit, .. } = self.scene.model.coordinates[i];
                format!("{name} = {:.6e} {unit}", at[i])
            };
            let all: Vec<_> = self.free.iter().map(coordinate).collect();
            all.join(", ") + if settled.stable { "" } else { " (unstable)" }
        };
        let others: Vec<_> = found.iter().filter(|other| !self.same(other, taken)).map(place).collect();
        let first = self.scene.model.coordinates[*self.free.first()?].name;
        let which = place(taken);
        (!others.is_empty() || !taken.stable).then(|| match &others[..] {
            [] => format!("the static start is unstable: {which}"),
            others => format!(
                "the static start is one of several equilibria: {which}; also found: {}. To choose one, write for example \
                 start.{first} = \"static near ...\"",
                others.join("; ")
            ),
        })
    }

    fn refusal(&self) -> Refusal {
        let names: Vec<_> = self.free.iter().map(|&i| self.scene.model.coordinates[i].name).collect();
        Refusal::NoEquilibrium { coordinates: names.join(", ") }
    }
}

impl Settled {
    /// The coordinates, with their whole turns (n).
    pub fn absolute(&self) -> Vector {
        self.state.unwrapped(&law::turn_lengths(self.state.q.len(), &self.laws))
    }
}

/// The values of the laws and their first and second derivatives by their phases, in the present cells. The neutral values of
/// the switches follow those of the laws.
pub fn courses(scene: &Scene, state: &State, laws: &[LawState]) -> [Vec<f64>; 3] {
    let courses: Vec<[f64; 3]> = laws.iter().map(|law| law.course(state.q[law.phase], 0.0)).collect();
    let padded = |i: usize| {
        let values = courses.iter().map(move |course| course[i]);
        values.chain(std::iter::repeat(0.0)).take(scene.model.laws.len()).collect()
    };
    [scene.model.in_contact(courses.iter().map(|course| course[0])), padded(1), padded(2)]
}

/// The first boundary on the path from `state` along `step`: the fraction of the step up to it, its law and its side.
fn first_boundary(laws: &[LawState], state: &State, step: &Vector) -> Option<(f64, usize, Side)> {
    let moved = |law: &LawState| law.switching != Switching::Never && law.next_switch().is_none();
    let ways = laws.iter().enumerate().filter(|(_, law)| moved(law) && step[law.phase] != 0.0);
    let ways = ways.map(|(i, law)| {
        let side = if step[law.phase] > 0.0 { Side::Upper } else { Side::Lower };
        ((law.boundary(side) - state.q[law.phase]) / step[law.phase], i, side)
    });
    let first = ways.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|first| first.0 < 1.0);
    first.map(|(part, law, side)| (part.max(0.0), law, side))
}

/// The square roots of the diagonal of a matrix, and the matrix divided by them in rows and columns, symmetric.
fn scaled(a: &DMatrix<f64>) -> (DVector<f64>, DMatrix<f64>) {
    let unit = a.diagonal().map(|x| if x == 0.0 { 1.0 } else { x.abs().sqrt() });
    let scaled = DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| 0.5 * (a[(i, j)] + a[(j, i)]) / (unit[i] * unit[j]));
    (unit, scaled)
}

/// The size of a displacement as the root of its strain energy, which has the same unit for all coordinates \[J^(1/2)\].
fn energy(stiffness: &Vector, x: &Vector) -> f64 {
    stiffness.zip_map(x, |k, x| k * x * x).sum().sqrt()
}
