//! The reactions R of held deflections and the powers of the external torques, for outputs.
//!
//! With the gradients N of the held motions, R = (NᵀM⁻¹N)⁻¹ NᵀM⁻¹ F, see [`contact`](crate::engine::contact). The power of a torque has
//! three parts: the part of its value at the start, the part that depends on the state, and the part that varies in time.

use smallvec::SmallVec;

use crate::engine::contact;
use crate::engine::equations::Known;
use crate::engine::hybrid::Hybrid;
use crate::engine::record::State;

/// Reactions and powers in a `state` of the present mode of a run, with the law values `k`, at the time `t` \[s\].
pub fn known(now: &Hybrid<'_>, t: f64, state: &State, k: &[f64]) -> Known {
    let State { q, q_dot, .. } = state;
    let further = now.forcing.as_ref().map(|forcing| forcing.power(t, q_dot));
    let powers = SmallVec::from_elem(0.0, now.torques.last().map_or(0, |last| last + 1));
    let mut known = Known { powers, ..Known::default() };
    for (at, &i) in now.torques.iter().enumerate() {
        let varying = further.as_ref().map_or(0.0, |further| further[at]);
        known.powers[i] = now.equations.torque_work(i, q_dot) + now.equations.torque_power(i, q, q_dot, k) + varying;
    }
    add_reactions(&mut known, now, t, state, k);
    known
}

fn add_reactions(known: &mut Known, now: &Hybrid<'_>, t: f64, State { q, q_dot, .. }: &State, k: &[f64]) {
    let Some(held) = now.contact.as_ref().filter(|contact| !contact.switches.is_empty()) else { return };
    let reactions = &mut known.reactions;
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
}
