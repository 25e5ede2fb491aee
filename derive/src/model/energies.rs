//! The energies T and V, and the dissipation function D.

use symbolica::atom::{Atom, AtomCore};

use super::Model;
use super::law::mid_name;
use crate::expr::{Expr, Kind, set, speed_name, symbol, symbols};

impl Model {
    /// Adds to the kinetic energy T \[J\].
    pub fn kinetic(&mut self, t: Expr) {
        let t = self.marked(t);
        self.kinetic.push(t);
    }

    /// Adds to the potential energy V \[J\].
    pub fn potential(&mut self, v: Expr) {
        let v = self.marked(v);
        self.potential.push(v);
    }

    /// Adds to Rayleigh's dissipation function D \[W\]; the dissipated power is 2 D.
    pub fn dissipation(&mut self, d: Expr) {
        let d = self.marked(d);
        self.dissipation.push(d);
    }

    /// Adds Rayleigh damping, C = alpha M + beta K: D = alpha T + beta V, where V has the speeds instead of the coordinates and
    /// every law at its mid value. `alpha` [1/s], `beta` \[s\]. Call it after all of T and V. Terms of T that depend on coordinates and
    /// terms of V that are not quadratic, as those of gravity, are left out: they are not the inertia of a rotor or a spring.
    pub fn rayleigh(&mut self, alpha: Expr, beta: Expr) {
        let (mut kinetic, mut potential) = (self.kinetic.clone(), self.potential.clone());
        kinetic.retain(|t| !depends_on_positions(t));
        potential.retain(is_spring);
        for t in kinetic {
            self.dissipation(alpha * t);
        }
        for v in potential {
            // Only symbols that occur are replaced: a spring has few of those of the model.
            let at_mid = symbols(&v.atom()).into_iter().fold(v, |v, (kind, name)| {
                let rate = match kind {
                    Kind::Coordinate => (Kind::Speed, speed_name(&name)),
                    Kind::Deflection => (Kind::Rate, speed_name(&name)),
                    Kind::Law => (Kind::Mid, mid_name(&name)),
                    Kind::Switched => {
                        match self.switches.iter().flat_map(|s| &s.damped).find(|(spring, _)| *spring == name) {
                            Some((_, damper)) => (Kind::Switched, damper.clone()),
                            None => return v,
                        }
                    }
                    _ => return v,
                };
                v.with((kind, &name), (rate.0, &rate.1))
            });
            self.dissipation(beta * at_mid);
        }
    }

    /// Whether T depends on coordinates.
    pub(crate) fn inertia_moves(&self) -> bool {
        self.kinetic.iter().any(depends_on_positions)
    }
}

/// Whether a term of T depends on coordinates.
pub(super) fn depends_on_positions(t: &Expr) -> bool {
    symbols(&t.atom()).iter().any(|s| matches!(s.0, Kind::Coordinate | Kind::Function))
}

/// Whether a term of V is homogeneous of degree two in coordinates and deflections.
fn is_spring(v: &Expr) -> bool {
    let v = v.atom();
    if symbols(&v).iter().any(|s| s.0 == Kind::Function) {
        return false;
    }
    let moving = symbols(&v).into_iter().filter(|s| matches!(s.0, Kind::Coordinate | Kind::Deflection));
    let doubled = moving.fold(v.clone(), |e, (kind, name)| {
        let x = symbol(kind, &name);
        set(&e, x, &(Atom::var(x) * Atom::num(2)))
    });
    (doubled - v * Atom::num(4)).expand().is_zero()
}
