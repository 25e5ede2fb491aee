//! Whether the phases of laws roll.

use std::collections::BTreeMap;

use symbolica::atom::{Atom, AtomCore};

use super::Derivation;
use crate::expr::{symbol, symbols, total};
use crate::markers;
use crate::model::Law;
use crate::symbols::Sparse;

/// The effects that prevent a phase from rolling; a single one is enough. `None`: the phase never rolls.
type Unless = Option<Vec<String>>;

impl Derivation<'_> {
    /// For each law the effects that prevent its phase from rolling. A phase rolls if it is a coordinate on which energies and torques
    /// depend only through laws. A rotation by whole pitches then changes nothing, and the engine counts whole pitches separately. For
    /// example, a torsional support of the rotor prevents rolling. If all parts of an effect prevent it, the effect itself is named.
    pub(crate) fn rolling(&self) -> Vec<Unless> {
        let (m, s) = (self.model, &self.symbols);
        let gradients = |parts: &mut dyn Iterator<Item = Atom>| parts.flat_map(|e| s.by_coordinates(&e)).collect();
        let energies = [&m.kinetic, &m.potential, &m.dissipation].into_iter();
        let energies = energies.map(|e| gradients(&mut e.iter().map(|piece| piece.atom())));
        let torques = self.motion.external.iter().map(|force| gradients(&mut std::iter::once(m.written_out(force))));
        let gradients: Vec<Sparse> = energies.chain(torques).collect();
        // Many laws have the same phase.
        let mut known = BTreeMap::new();
        let mut of = |i: usize| known.entry(i).or_insert_with(|| self.unless(&gradients, i)).clone();
        m.laws.iter().map(|law| of(self.coordinate(law)?)).collect()
    }

    /// The coordinate that is the phase of a law, by its index.
    fn coordinate(&self, law: &Law) -> Option<usize> {
        let phase = symbols(&law.phase.atom());
        let [(kind, name)] = phase.as_slice() else { return None };
        self.symbols.q.iter().position(|q| *q == symbol(*kind, name))
    }

    /// The effects with which energies or torques depend on coordinate `i`; `None` if they depend on it without any effect. `gradients` are
    /// the gradients of the energies and torques.
    fn unless(&self, gradients: &[Sparse], i: usize) -> Unless {
        let m = self.model;
        let along = |gradient: &Sparse| {
            let parts = gradient.iter().filter(|(j, _)| *j == i).map(|(_, by)| by.clone());
            total(parts.collect()).expand()
        };
        let mut stopped: Vec<String> = vec![];
        for term in gradients.iter().map(along).flat_map(|sum| markers::terms(&sum)) {
            // If the term needs several effects, only the last one is named. The phase then counts as not rolling with this effect alone,
            // too.
            let marks = markers::markers(&term);
            stopped.push(m.effects.iter().rfind(|effect| marks.contains(&effect.name))?.name.clone());
        }
        let of = |effect: &String| m.effects.iter().find(|e| e.name == *effect).and_then(|e| e.of.clone());
        let all =
            |of: &String| m.effects.iter().filter(|e| e.of.as_ref() == Some(of)).all(|e| stopped.contains(&e.name));
        let mut named: Vec<String> =
            stopped.iter().map(|effect| of(effect).filter(&all).unwrap_or_else(|| effect.clone())).collect();
        named.sort();
        named.dedup();
        Some(named)
    }
}
