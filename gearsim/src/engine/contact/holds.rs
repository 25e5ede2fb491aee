//! The start of holds: which motions are held, what ends each hold, and the energy that the start of the holds neglects.

use nalgebra::linalg::Cholesky;
use nalgebra::{DMatrix, DVector, Dyn};

use crate::engine::contact::reaction::{centripetal, is_free, left};
use crate::engine::contact::step::barriers;
use crate::engine::contact::watch::{StateForm, Watch};
use crate::engine::contact::{Contact, Ending};
use crate::engine::crossing::Side;
use crate::engine::equations::Affine;
use crate::engine::error::Refusal;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::End;
use crate::engine::record::State;
use crate::engine::vector::{Matrix, Vector, transposed};

/// A held motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Held {
    /// The phase of a law, at a side of its cell.
    Law(usize, Side),
    /// The deflection of a switch.
    Switch(usize),
}

/// The held motions, with the matrices of their reactions.
pub struct Holds {
    pub(super) held: Vec<Held>,
    normals: DMatrix<f64>,
    /// M⁻¹N.
    mobility: DMatrix<f64>,
    /// The Cholesky factor of NᵀM⁻¹N.
    compliance: Cholesky<f64, Dyn>,
    /// The matrix that gives the reactions R from the forces F.
    to_reactions: DMatrix<f64>,
}

impl Holds {
    /// The phases of `laws` and the deflections of switches in modes that hold. A motion that the holds before it already prevent is left
    /// out, because its reaction is not determined.
    pub(super) fn new(now: &Hybrid<'_>, laws: &[(usize, Side)]) -> Result<Self, Refusal> {
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

    /// The functions that end the holds. For a law: the reaction plus a margin, and the functions that are zero where its step is zero. For
    /// a switch: its guards that depend on the reaction, plus such a margin.
    pub(super) fn watches(&self, now: &Hybrid<'_>) -> Vec<Watch> {
        let (equations, k, State { q, q_dot, .. }) = (now.equations, &now.k, &now.state);
        let (stiffness, damping) = (equations.stiffness(k), equations.damping(k));
        let load = DVector::from(&(equations.load(k) + &now.further_load()));
        let energies = [equations.potential(q, k), equations.dissipation(q, q_dot, k)];
        let n = q.len();
        let (mut reactions, mut slips) = (vec![], vec![]);
        for (c, held) in self.held.iter().enumerate() {
            let row = Vector::from_fn(n, |i| self.to_reactions[(c, i)]);
            let loaded = row.iter().zip(load.iter()).map(|(w, f)| (w * f).abs()).sum::<f64>();
            // |w.K x|² <= w.K w x.K x: the forces of springs and dampers follow from their energies. These depend on deflections, while the
            // terms of K q grow with the angles of a train that has turned far.
            let of = |matrix: &Matrix, energy: f64| (row.dot(&(matrix * &row)) * 2.0 * energy).max(0.0).sqrt();
            let forces = loaded + of(&stiffness, energies[0]) + of(&damping, energies[1]);
            let terms = |matrix: &Matrix, x: &Vector| transposed(matrix, &row).abs().dot(&x.abs());
            let rounding = 0.5 * f64::EPSILON * (terms(&stiffness, q) + terms(&damping, q_dot));
            let margin = |size: f64| now.release * size + rounding;
            match *held {
                Held::Law(law, side) => {
                    let form = StateForm::reaction(row, c, margin(forces));
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
                        let (on_q, on_speed) = (exit.guard.on_q.clone(), exit.guard.on_speed.clone());
                        let constant = exit.guard.constant_at(k);
                        let bound = (constant + on_q.dot(q) + on_speed.dot(q_dot)).abs();
                        let margin = on_reaction.abs() * margin(forces + bound / on_reaction.abs());
                        let form = StateForm {
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

    /// The force c: if factors of the held rates vary, the reactions are those to the forces F + c.
    pub(super) fn centripetal(&self, now: &Hybrid<'_>) -> Vector {
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

    /// Sets the held speeds to zero. Returns the contact and the energy that this neglects \[J\].
    pub(super) fn begin(self, now: &mut Hybrid<'_>, watches: Vec<Watch>) -> Result<(Option<Contact>, f64), Refusal> {
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
            let gradient = DVector::from(&now.switches[*i].gradient(now.equations, &now.state.q, &now.k));
            held.contains(&Held::Switch(*i)) || !is_free(&mass, &[&columns[..], &[gradient]].concat())
        };
        let locked = (0..now.switches.len()).filter(is_locked).collect();
        let mobility = left(&now.equations.mobility(&now.state.q), &mobility, &to_reactions);
        Ok((Some(Contact { laws, switches, normals, mobility, watches, turning, locked }), neglected))
    }
}
