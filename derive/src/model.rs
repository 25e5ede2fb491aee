//! The builder of a model: coordinates, parameters, laws, effects, the energies T and V, the dissipation function D, torques.

mod boundary;
mod effect;
mod energies;
mod function;
mod law;
mod massless;
mod output;
mod parts;
mod switch;
mod torque;

use crate::expr::{Expr, Kind, speed_name};

pub use boundary::Boundary;
pub(crate) use boundary::{JUMP_TERMS, MOVING_PHASE};
pub(crate) use effect::Effect;
pub(crate) use function::{Derivative, Function};
pub use law::{Factor, Stiffness};
pub(crate) use law::{Law, Role, mid_name};
pub(crate) use massless::why_not;
pub(crate) use output::Output;
pub(crate) use parts::{Coordinate, Deflection, Parameter, RigidMotion};
pub use parts::{GearData, Range, Start};
pub use switch::{Describing, Switching};
pub(crate) use switch::{Exit, REACTION, Switch, SwitchMode};
pub(crate) use torque::{Force, Torque};

/// A drivetrain, described by its energies.
///
/// The methods may be called in any order in which every symbol is declared before it is used. [`crate::derive`] checks the
/// complete model.
#[derive(Default)]
pub struct Model {
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) source: String,
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) parameters: Vec<Parameter>,
    pub(crate) laws: Vec<Law>,
    pub(crate) motions: Vec<RigidMotion>,
    pub(crate) effects: Vec<Effect>,
    /// The effects that decide how laws switch.
    pub(crate) switching: Vec<(Boundary, String)>,
    pub(crate) constants: Vec<(String, Expr)>,
    pub(crate) deflections: Vec<Deflection>,
    pub(crate) functions: Vec<Function>,
    pub(crate) switches: Vec<Switch>,
    pub(crate) forces: Vec<Force>,
    pub(crate) torques: Vec<Torque>,
    pub(crate) outputs: Vec<Output>,
    pub(crate) kinetic: Vec<Expr>,
    pub(crate) potential: Vec<Expr>,
    pub(crate) dissipation: Vec<Expr>,
    /// The effects whose closures are running, the innermost one last: everything that is added now belongs to them.
    within: Vec<String>,
}

impl Model {
    /// The model called `name`, described by `describe`.
    pub fn new(name: &str, describe: impl FnOnce(&mut Model)) -> Model {
        let mut model = Model { name: name.into(), ..Model::default() };
        Expr::forget_rates();
        describe(&mut model);
        massless::eliminate(&mut model);
        switch::complete(&mut model);
        output::complete(&mut model);
        model
    }

    /// What the model is, in one line.
    pub fn title(&mut self, title: &str) {
        self.title = title.into();
    }

    /// The source of the model: author, year, equations.
    pub fn source(&mut self, source: &str) {
        self.source = source.into();
    }

    /// Declares a generalised coordinate with its SI unit. A coordinate without inertia on which only springs of constant stiffness act is
    /// eliminated: its value follows from the balance of their forces. It becomes an output.
    pub fn coordinate(&mut self, name: &str, unit: &str, start: Start, doc: &str) -> Expr {
        self.coordinates.push(Coordinate { name: name.into(), unit: unit.into(), start, doc: doc.into() });
        Expr::var(Kind::Coordinate, name)
    }

    /// Declares a parameter with its SI unit. A scene must give it if `default` \[SI\] is `None`; if it is declared inside an
    /// effect, only a scene that names the effect must.
    pub fn parameter(&mut self, name: &str, unit: &str, default: Option<f64>, range: Range, doc: &str) -> Expr {
        let with = self.innermost();
        let (name, unit, doc) = (name.into(), unit.into(), doc.into());
        let parameter = Parameter { name, unit, default, with, gear_data: None, range, doc };
        let symbol = Expr::var(Kind::Parameter, &parameter.name);
        self.parameters.push(parameter);
        symbol
    }

    /// Declares a parameter of a gear, as [`Model::parameter`]. Its unit and range follow from `gear_data`.
    pub fn gear_data(&mut self, gear_data: GearData, name: &str, default: Option<f64>, doc: &str) -> Expr {
        let with = self.innermost();
        self.parameters.push(Parameter::of_gear(gear_data, name, default, with, doc));
        Expr::var(Kind::Parameter, name)
    }

    /// Names a constant: an expression in parameters, earlier constants, mid values of laws and [`Model::inverse_mass`].
    pub fn constant(&mut self, name: &str, value: Expr) -> Expr {
        self.constants.push((name.into(), value));
        Expr::var(Kind::Constant, name)
    }

    /// Names a deflection, for example of a spring: a linear form of the coordinates without a constant term, from which
    /// offsets ([`Model::offset_law`]) and functions of several positions ([`Model::function_of`]) may be subtracted. V may be written in
    /// the deflection, and D in its `.dot()`, which does not contain the rate of an offset. The equations then contain the name of the
    /// deflection; they are not multiplied out.
    pub fn deflection(&mut self, name: &str, value: Expr) -> Expr {
        self.deflections.push(Deflection { name: name.into(), value: value.expand() });
        Expr::var(Kind::Deflection, name)
    }

    /// The entry of the inverse mass matrix for the coordinates `a` and `b`; the derivation fills in its value. Only for models
    /// with at most two coordinates: larger mass matrices are not inverted symbolically.
    pub fn inverse_mass(&self, a: Expr, b: Expr) -> Expr {
        let index =
            |e: Expr| self.coordinates.iter().position(|c| e.atom() == Expr::var(Kind::Coordinate, &c.name).atom());
        match (index(a), index(b)) {
            (Some(i), Some(j)) => Expr::var(Kind::Mobility, &mobility_name(i, j)),
            _ => Expr::var(Kind::Mobility, NO_MOBILITY),
        }
    }

    /// Declares a rigid motion by which a scene may state its initial speeds in one number [unit]: pairs of a coordinate and
    /// its speed for a motion of size 1. Other coordinates have the speed 0.
    pub fn motion(&mut self, name: &str, unit: &str, speeds: &[(Expr, Expr)], doc: &str) {
        self.motions.push(RigidMotion {
            name: name.into(),
            unit: unit.into(),
            speeds: speeds.to_vec(),
            doc: doc.into(),
        });
    }

    /// Names of the speeds, in the order of the coordinates.
    pub(crate) fn speeds(&self) -> Vec<String> {
        self.coordinates.iter().map(|c| speed_name(&c.name)).collect()
    }
}

/// Name of the inverse mass of an expression that is not a coordinate. It is never replaced by a value, hence refused.
const NO_MOBILITY: &str = "none";

pub(crate) fn mobility_name(i: usize, j: usize) -> String {
    format!("W{}_{}", i.min(j), i.max(j))
}
