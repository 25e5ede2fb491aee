//! Held motions of a run: phases at steps, and deflections of switches.

use crate::engine::contact::{self, Contact};
use crate::engine::crossing::Side;
use crate::engine::error::Refusal;
use crate::engine::record::State;

use super::Hybrid;

impl Hybrid<'_> {
    /// Whether the phase of a law is held.
    #[inline]
    pub fn holds(&self, law: usize) -> bool {
        self.contact.as_ref().is_some_and(|contact| contact.holds(law))
    }

    /// Value of the function number `which` that can end a hold; it may have either sign. It is infinite if there is no such function.
    pub fn left_of_hold(&self, which: usize) -> f64 {
        let Some(contact) = &self.contact else { return f64::INFINITY };
        let (State { q, q_dot, .. }, Some(watch)) = (&self.state, contact.watches.get(which)) else {
            return f64::INFINITY;
        };
        let form =
            if self.steps_only() { watch.form.clone() } else { watch.at(self.equations, &self.switches, q, &self.k) };
        if let Some(turned) =
            contact.turned((self.equations, &self.switches), (q, q_dot), &self.k, || self.law_rates(q, q_dot))
        {
            let (_, to_reactions) = contact::held(&self.equations.mobility(q), &turned.normals);
            return form.at(&to_reactions).value(q, q_dot, || self.force() + &turned.force);
        }
        if self.equations.is_inertia_constant() {
            return form.value(q, q_dot, || self.force());
        }
        let (_, to_reactions) = contact::held(&self.equations.mobility(q), &contact.normals);
        form.at(&to_reactions).value(q, q_dot, || self.force())
    }

    /// Holds the phases of `laws` and the deflections of switches if their reactions admit it.
    ///
    /// # Errors
    /// Those of [`Contact::begin`].
    pub fn hold(&mut self, laws: Vec<(usize, Side)>) -> Result<(), Refusal> {
        let (contact, neglected) = Contact::begin(self, laws)?;
        self.contact = contact.map(Box::new);
        self.ignored += neglected;
        Ok(())
    }

    /// Removes the numerical errors of held rates: after an event they would decide in which direction a deflection slides, or whether it
    /// still rests. In double-double precision, the solver removes them.
    pub fn still(&mut self) {
        let Some(contact) = self.contact.as_ref().filter(|contact| !contact.switches.is_empty()) else { return };
        if !self.state.low.is_empty() {
            return;
        }
        let State { q, q_dot, .. } = &self.state;
        let of = (self.equations, &self.switches[..]);
        let turned = contact.turned(of, (q, q_dot), &self.k, || self.law_rates(q, q_dot));
        let normals = turned.as_ref().map_or(&contact.normals, |turned| &turned.normals);
        self.state.q_dot = contact::still(&self.equations.mobility(q), normals, q_dot);
    }

    /// Whether the deflection of a switch cannot move.
    #[inline]
    pub fn is_locked(&self, switch: usize) -> bool {
        self.contact.as_ref().is_some_and(|contact| contact.locked.contains(&switch))
    }

    /// Whether a switch is in a mode that holds its deflection.
    pub fn is_stuck(&self) -> bool {
        self.switches.iter().any(|switch| switch.here().held)
    }
}
