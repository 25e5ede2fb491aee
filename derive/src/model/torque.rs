//! External torques, and named forces that are factors of them.

use symbolica::atom::{Atom, AtomCore};

use super::Model;
use crate::expr::{Expr, Kind, set, symbol, symbols};
use crate::markers::{optional, terms};

/// A named force, a factor in torques.
pub(crate) struct Force {
    pub name: String,
    pub value: Expr,
    /// The effect in whose closure it was declared.
    pub with: Option<String>,
}

pub(crate) struct Torque {
    pub name: String,
    pub value: Expr,
    pub through: Expr,
    /// The speed along which it works, if that is not the rate of `through`.
    pub along: Option<Expr>,
    pub doc: String,
}

impl Torque {
    /// Its power \[W\]: the value times the speed along which it works.
    pub fn power(&self) -> Atom {
        (self.value * self.along.unwrap_or_else(|| self.through.dot())).atom()
    }

    /// Its power \[W\] as a list of parts. It is one part, or one part for each term of the value if an effect changes only some of these
    /// terms.
    pub fn powers(&self) -> Vec<Atom> {
        let value = self.value.atom();
        if optional(&value).is_empty() {
            return vec![self.power()];
        }
        let speed = self.along.unwrap_or_else(|| self.through.dot()).atom();
        terms(&value.expand()).into_iter().map(|term| term * &speed).collect()
    }

    /// Whether it works through a displacement that is linear in the coordinates and deflections.
    pub fn is_linear(&self) -> bool {
        let moves = |e: &Atom| symbols(e).iter().any(|s| matches!(s.0, Kind::Coordinate | Kind::Deflection));
        let through = self.through.atom();
        if symbols(&through).iter().any(|s| s.0 == Kind::Function) {
            return false;
        }
        let by = |(kind, name): (Kind, String)| through.derivative(symbol(kind, &name)).expand();
        let moving = symbols(&through).into_iter().filter(|s| matches!(s.0, Kind::Coordinate | Kind::Deflection));
        self.along.is_none() && !moving.map(by).any(|slope| moves(&slope))
    }
}

impl Model {
    /// Adds an external torque (or force) of size `value` that works through the displacement `through`. The torque is constant or depends
    /// on speeds. It may depend on deflections and stiffnesses too only if a friction law is a factor of it. A torque that is not constant,
    /// or whose displacement is not linear in the coordinates, makes the cells nonlinear. If the torque is linear in the speed of
    /// `through`, avoid this by writing it as a constant torque and a dissipation: T = c (n - omega) is the torque c n and D = c omega^2/2.
    /// The power of the torque is the output `power_NAME` \[W\].
    pub fn torque(&mut self, name: &str, value: Expr, through: Expr, doc: &str) {
        let value = self.marked(value);
        self.torques.push(Torque { name: name.into(), value, through, along: None, doc: doc.into() });
        self.power_output(name, doc);
    }

    /// Adds an external torque (or force) of size `value` that works along `speed`, for displacements without a closed form. `speed` is a
    /// linear form of the speeds with factors that may depend on the coordinates, e.g. the speed of a shaft behind a universal joint.
    /// Otherwise as [`Model::torque`].
    pub fn torque_along(&mut self, name: &str, value: Expr, speed: Expr, doc: &str) {
        let (value, through) = (self.marked(value), Expr::from(0));
        self.torques.push(Torque { name: name.into(), value, through, along: Some(speed), doc: doc.into() });
        self.power_output(name, doc);
    }

    /// Declares the power of an external torque as an output. The sum of these powers is the rate of the work in the energy account.
    fn power_output(&mut self, name: &str, doc: &str) {
        let power = self.power(name);
        self.output(&format!("power_{name}"), "W", power, &format!("power of the {doc}: positive if it drives"));
    }

    /// Names a force, for example a friction force, that is a factor in several torques or acts on several coordinates. It may depend on
    /// everything on which those torques may depend. The equations contain its name; it is not multiplied out. A term of [`Model::only_with`]
    /// is added to it in scenes with the effect of that term.
    pub fn force(&mut self, name: &str, value: Expr) -> Expr {
        self.forces.push(Force { name: name.into(), value, with: self.innermost() });
        Expr::var(Kind::Force, name)
    }

    /// The expression with named forces written out. They are replaced in reverse order, because a force may depend on earlier ones.
    pub(crate) fn written_out(&self, e: &Atom) -> Atom {
        let forces = self.forces.iter().rev();
        forces.fold(e.clone(), |e, force| set(&e, symbol(Kind::Force, &force.name), &force.value.atom()))
    }

    /// Whether a torque acts with generalised forces that are not constant: it depends on speeds, has a friction law in it, or its
    /// displacement is not linear.
    pub(crate) fn varies(&self, torque: &Torque) -> bool {
        self.moves(&torque.value.atom()) || !torque.is_linear()
    }

    /// Whether an expression contains a speed or a friction law, itself or in a named force.
    fn moves(&self, e: &Atom) -> bool {
        symbols(e).iter().any(|(kind, name)| match kind {
            Kind::Speed | Kind::Rate | Kind::Friction => true,
            Kind::Force => self.forces.iter().any(|force| force.name == *name && self.moves(&force.value.atom())),
            _ => false,
        })
    }
}
