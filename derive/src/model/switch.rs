//! Switches: a deflection has a finite number of modes, and the equations depend on the mode.

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Expr, Kind, number, set, symbol};
use crate::model::{Deflection, Model};

/// A switch: a deflection x, and a finite number of modes. In each mode the symbols of the switch are constant. A mode ends at the zero of
/// a guard, a linear function of the state.
#[derive(Clone)]
pub(crate) struct Switch {
    /// Name of the deflection x, from which the offset of the mode is subtracted.
    pub over: String,
    pub unit: String,
    pub symbols: Vec<Constant>,
    pub modes: Vec<SwitchMode>,
    /// The dissipative force against x besides those of V and D; linear in x.
    pub loss: Expr,
    /// Symbols of springs, each with the symbol that takes its place in Rayleigh damping.
    pub damped: Vec<(String, String)>,
    /// Without this effect there is no switch: the symbols have their neutral values.
    pub effect: String,
    pub doc: String,
}

/// A symbol that is constant in each mode.
#[derive(Clone)]
pub(crate) struct Constant {
    pub name: String,
    /// [`Kind::Edge`] or [`Kind::Switched`].
    pub kind: Kind,
    /// Its value in scenes without the effect.
    pub neutral: i64,
}

/// A mode of a switch.
#[derive(Clone)]
pub(crate) struct SwitchMode {
    pub name: String,
    /// The values of the symbols.
    pub values: Vec<Expr>,
    /// Whether x' = 0 is enforced by a reaction.
    pub held: bool,
    /// Whether a static equilibrium may be in it.
    pub rests: bool,
    /// Name of the event that is counted when a run enters the mode from a mode without this name.
    pub counts: Option<String>,
    pub exits: Vec<Exit>,
}

/// An exit of a mode: the guard that ends it, and the next mode.
#[derive(Clone)]
pub(crate) struct Exit {
    /// The mode beyond.
    pub to: String,
    /// The mode lasts while this is >= 0.
    pub guard: Expr,
    /// Whether only a sudden change of the state can violate the guard. In every continuous motion another exit comes first.
    pub sudden: bool,
}

/// A switch that is being described.
pub struct Switching<'m> {
    model: &'m mut Model,
    index: usize,
    delta: Expr,
}

/// A mode that is being described.
pub struct Describing<'s>(&'s mut SwitchMode);

impl Model {
    /// Declares a switch of the deflection `delta` [unit], which is linear in the coordinates, named `over`. In scenes without
    /// `effect` there is no switch.
    pub fn switch(&mut self, over: &str, unit: &str, delta: Expr, effect: &str, doc: &str) -> Switching<'_> {
        let index = self.switches.len();
        self.deflections.push(Deflection { name: over.into(), value: delta.expand() });
        self.switches.push(Switch {
            over: over.into(),
            unit: unit.into(),
            symbols: vec![],
            modes: vec![],
            loss: Expr::from(0),
            damped: vec![],
            effect: effect.into(),
            doc: doc.into(),
        });
        Switching { model: self, index, delta }
    }
}

impl Switching<'_> {
    fn switch(&mut self) -> &mut Switch {
        &mut self.model.switches[self.index]
    }

    /// A symbol that is subtracted from the deflection, constant in each mode; 0 in scenes without the effect.
    pub fn offset(&mut self, name: &str) {
        self.switch().symbols.push(Constant { name: name.into(), kind: Kind::Edge, neutral: 0 });
        let (over, value) = (self.switch().over.clone(), self.delta.expand() - Expr::var(Kind::Edge, name));
        self.model.deflections.iter_mut().filter(|d| d.name == over).for_each(|d| d.value = value);
    }

    /// Subtracts `by` from the deflection: a function of positions times a factor that is constant in each mode.
    pub fn bend(&mut self, by: Expr) {
        self.delta = self.delta - by;
        let over = self.switch().over.clone();
        self.model.deflections.iter_mut().filter(|d| d.name == over).for_each(|d| d.value = (d.value - by).expand());
    }

    /// A factor for energies and for the dissipative force, constant in each mode; `neutral` in scenes without the effect.
    pub fn factor(&mut self, name: &str, neutral: i64) -> Expr {
        self.switch().symbols.push(Constant { name: name.into(), kind: Kind::Switched, neutral });
        Expr::var(Kind::Switched, name)
    }

    /// In Rayleigh damping the factor `damper` takes the place of the factor `spring`.
    pub fn damped(&mut self, spring: &str, damper: &str) {
        self.switch().damped.push((spring.into(), damper.into()));
    }

    /// The deflection x [unit].
    pub fn over(&mut self) -> Expr {
        Expr::var(Kind::Deflection, &self.switch().over)
    }

    /// The force of the springs of x, dV/dx.
    pub fn spring(&mut self) -> Expr {
        Expr::var(Kind::Spring, &self.switch().over)
    }

    /// The force of the dampers of x, dD/dx', as if all of them acted.
    pub fn damper(&mut self) -> Expr {
        Expr::var(Kind::Damper, &self.switch().over)
    }

    /// In a mode that holds x: the force along x that the hold resists. Only guards of that mode may contain it.
    pub fn reaction(&self) -> Expr {
        Expr::var(Kind::Reaction, REACTION)
    }

    /// The dissipative force `f` against x; linear in x, with f x' >= 0 in every mode.
    pub fn loss(&mut self, f: Expr) {
        self.switch().loss = f;
    }

    /// A mode, with the values of all symbols in the order of their declarations.
    pub fn mode(&mut self, name: &str, values: &[Expr]) -> Describing<'_> {
        let modes = &mut self.switch().modes;
        let (name, values) = (name.into(), values.to_vec());
        modes.push(SwitchMode { name, values, held: false, rests: false, counts: None, exits: vec![] });
        Describing(modes.last_mut().expect("just added"))
    }
}

impl Describing<'_> {
    /// In this mode a reaction that does no work keeps a rate at zero. The rate is the guard of the modes that lead to this one: x', or a
    /// sum of rates with friction laws as factors. Only methods by steps can have friction laws as factors.
    pub fn holds(self) -> Self {
        self.0.held = true;
        self
    }

    /// A static equilibrium may be in this mode.
    pub fn rests(self) -> Self {
        self.0.rests = true;
        self
    }

    /// Names the event that a run counts when it enters this mode from a mode without this name, e.g. "flanks met".
    pub fn counts(self, what: &str) -> Self {
        self.0.counts = Some(what.into());
        self
    }

    /// The mode lasts while `guard` >= 0; then the mode is `to`. The guard is linear in deflections and rates, and in the reaction of a
    /// mode that holds.
    pub fn until(self, to: &str, guard: Expr) -> Self {
        self.0.exits.push(Exit { to: to.into(), guard, sudden: false });
        self
    }

    /// As [`Describing::until`], for a guard that only a sudden change of the state can violate: in every continuous motion another exit
    /// comes first.
    pub fn unless(self, to: &str, guard: Expr) -> Self {
        self.0.exits.push(Exit { to: to.into(), guard, sudden: true });
        self
    }
}

/// The name of the reaction in guards.
pub(crate) const REACTION: &str = "reaction";

impl Switch {
    /// The dissipative force, with the marker of the effect.
    pub fn lost(&self) -> Atom {
        Atom::var(symbol(Kind::Marker, &self.effect)) * self.loss.atom()
    }

    /// An expression in which the symbols have their values in a mode.
    pub fn within(&self, mode: &SwitchMode, e: &Atom) -> Atom {
        let values = self.symbols.iter().zip(&mode.values).map(|(s, value)| (s, value.atom()));
        values.fold(e.clone(), |e, (s, value)| set(&e, symbol(s.kind, &s.name), &value))
    }

    /// An expression in which the symbols have their neutral values.
    pub fn neutral(&self, e: &Atom) -> Atom {
        self.symbols.iter().fold(e.clone(), |e, s| set(&e, symbol(s.kind, &s.name), &number(s.neutral)))
    }

    /// The mode with a name.
    pub fn mode(&self, name: &str) -> Option<&SwitchMode> {
        self.modes.iter().find(|mode| mode.name == name)
    }

    /// Its exits, each with the mode that it ends.
    pub fn exits(&self) -> impl Iterator<Item = (&SwitchMode, &Exit)> {
        self.modes.iter().flat_map(|mode| mode.exits.iter().map(move |exit| (mode, exit)))
    }
}

/// Replaces the forces of springs and dampers in guards and losses by the derivatives of V and D.
pub(super) fn complete(model: &mut Model) {
    let mut switches = model.switches.clone();
    for switch in &mut switches {
        let spring = model.spring_force(&switch.over);
        let damper = switch.neutral(&model.damper_force(&switch.over));
        let over = switch.over.clone();
        let written = |e: Expr| {
            let e = set(&e.atom(), symbol(Kind::Spring, &over), &spring);
            Expr::new(set(&e, symbol(Kind::Damper, &over), &damper).expand())
        };
        switch.loss = written(switch.loss);
        let here = switch.clone();
        for mode in &mut switch.modes {
            let values = mode.clone();
            for exit in &mut mode.exits {
                exit.guard = Expr::new(here.within(&values, &written(exit.guard).atom()).expand());
            }
        }
    }
    model.switches = switches;
}
