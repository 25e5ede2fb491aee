//! Quantities for outputs that only the engine knows: the reactions R of held deflections and the powers of the external torques.
//!
//! With the gradients N of the held motions, R = (NᵀM⁻¹N)⁻¹ NᵀM⁻¹ F, see [`contact`](crate::engine::contact). The power of a torque has
//! three parts: that of its value at the start, that which depends on the state, and that which varies in time.

use smallvec::SmallVec;

use crate::engine::contact;
use crate::engine::hybrid::Hybrid;
use crate::engine::record::State;

/// Some numbers, on the stack if they are few.
type Numbers = SmallVec<[f64; 4]>;

/// Reactions and powers. Those that are not requested are not computed and read as zero.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Known {
    /// For each switch of the model, the force along the deflection that its hold resists [N or N m].
    pub reactions: Numbers,
    /// For each external torque of the model up to the last one that the scene has, its power \[W\]; zero for those that it does not have.
    pub powers: Numbers,
}

impl Known {
    /// The reaction of the deflection of a switch [N or N m]; zero where it is not held.
    pub fn reaction(&self, switch: usize) -> f64 {
        self.reactions.get(switch).copied().unwrap_or(0.0)
    }

    /// The power of an external torque \[W\].
    pub fn power(&self, torque: usize) -> f64 {
        self.powers.get(torque).copied().unwrap_or(0.0)
    }

    /// Reactions and powers in a `state` of the present mode of a run, with the law values `k`, at the time `t` \[s\].
    pub fn of(now: &Hybrid<'_>, t: f64, state: &State, k: &[f64]) -> Self {
        let State { q, q_dot, .. } = state;
        let further = now.forcing.as_ref().map(|forcing| forcing.power(t, q_dot));
        let mut powers = Numbers::from_elem(0.0, now.torques.last().map_or(0, |last| last + 1));
        for (at, &i) in now.torques.iter().enumerate() {
            let varying = further.as_ref().map_or(0.0, |further| further[at]);
            powers[i] = now.equations.torque_work(i, q_dot) + now.equations.torque_power(i, q, q_dot, k) + varying;
        }
        Known { reactions: reactions(now, t, state, k), powers }
    }
}

fn reactions(now: &Hybrid<'_>, t: f64, State { q, q_dot, .. }: &State, k: &[f64]) -> Numbers {
    let mut reactions = Numbers::new();
    let Some(held) = now.contact.as_ref().filter(|contact| !contact.switches.is_empty()) else { return reactions };
    let mut force = now.equations.force(q, q_dot, k, &now.slopes(q, t));
    if let Some(forcing) = &now.forcing {
        force += &forcing.load(t);
    }
    let turned = held.turned((now.equations, &now.switches), (q, q_dot), k, || now.law_rates(q, q_dot));
    let normals = turned.as_ref().map_or(&held.normals, |turned| &turned.normals);
    let (_, to_reactions) = contact::held(&now.equations.mobility(q), normals);
    if let Some(turned) = &turned {
        force += &turned.force;
    }
    for &(switch, row) in &held.switches {
        let switch = now.switches[switch].index;
        reactions.resize(reactions.len().max(switch + 1), 0.0);
        reactions[switch] = (0..force.len()).map(|i| to_reactions[(row, i)] * force[i]).sum();
    }
    reactions
}
