//! The contents of a file of derived equations as plain structs; `parse` and `items` fill them.

use std::cell::OnceCell;

use quote::format_ident;
use syn::{Expr, Ident, Index, LitStr};

use crate::equations::lets::Variables;

/// One file of derived equations.
pub struct Model {
    pub name: Ident,
    pub title: LitStr,
    pub source: Option<LitStr>,
    pub coordinates: Vec<Coordinate>,
    pub parameters: Vec<Parameter>,
    pub laws: Vec<Law>,
    pub motions: Vec<RigidMotion>,
    pub effects: Vec<Effect>,
    /// The effects that decide how laws switch.
    pub switching: Vec<Boundary>,
    pub conditions: Vec<Condition>,
    pub constants: Vec<Assignment>,
    pub deflections: Vec<Assignment>,
    /// Rates of the deflections. The file gives the rates of bent deflections; `resolve` writes the others in the speeds.
    pub rates: Vec<Assignment>,
    /// Functions of positions, and their derivatives.
    pub functions: Vec<Function>,
    pub switches: Vec<Switch>,
    pub kinetic: Sum,
    pub potential: Sum,
    pub dissipation: Sum,
    /// Named forces.
    pub forces: Vec<Row>,
    /// Partial derivatives of the forces, in which the Jacobian is written.
    pub partials: Vec<Row>,
    pub torques: Vec<Torque>,
    pub work: Vec<Row>,
    pub outputs: Vec<Output>,
    pub mass: Vec<Entry>,
    pub mobility: Option<Vec<Entry>>,
    /// Derivatives of M q'' (rows) by the coordinates (columns), if M depends on them.
    pub inertia: Vec<Entry>,
    pub force: Option<Vec<Row>>,
    /// Derivatives of the force (rows) by coordinates, speeds, deflections and rates (columns).
    pub jacobian: Option<Vec<Entry>>,
    /// Entries in coordinates and deflections, as described in `gradients`.
    pub stiffness: Vec<Entry>,
    pub damping: Vec<Entry>,
    pub load: Vec<Row>,
    /// The terms that make a cell nonlinear, as text.
    pub nonlinear: Option<LitStr>,
    /// The terms that make a cell nonlinear in scenes with some effects.
    pub nonlinear_with: Vec<NonlinearWith>,
    pub jumps: Vec<Jump>,
    /// Paths of the equations as text and in LaTeX, from the file of the model.
    pub text: Option<LitStr>,
    pub latex: Option<LitStr>,
    /// Properties of its variables, computed by `lets` when they are first needed.
    pub variables: OnceCell<Variables>,
}

/// `theta "rad" start 0.0, "doc";`
pub struct Coordinate {
    pub name: Ident,
    pub unit: LitStr,
    /// `None`: `start static`.
    pub start: Option<f64>,
    pub doc: LitStr,
}

/// `beta_K "s" default 0.0, from 0.0 to inf, "doc";`, `N1 "1" teeth default 24.0, open 0.0 to inf, "doc";`
pub struct Parameter {
    pub name: Ident,
    pub unit: LitStr,
    /// Its index in [`GEAR_DATA`].
    pub gear_data: Option<usize>,
    /// `None`: `required`.
    pub default: Option<f64>,
    /// `with damping`: only scenes with this effect use it.
    pub with: Option<Ident>,
    pub low: f64,
    pub low_included: bool,
    pub high: f64,
    pub high_included: bool,
    /// `above r`: greater than this parameter.
    pub above: Option<Ident>,
    pub doc: LitStr,
}

/// The gear data of a parameter: the word in a derived file, and the variant of `model::GearData`.
pub const GEAR_DATA: [(&str, &str); 4] =
    [("teeth", "Teeth"), ("base_radius", "BaseRadius"), ("pressure_angle", "PressureAngle"), ("support", "Support")];

/// `k "N*m" phase theta period 6.28 rolling, "doc";`, `e "m" phase theta period 6.28 with EFFECT, "doc";`,
/// `side "1" phase theta period 6.28 with EFFECT as side, "doc";`
pub struct Law {
    pub name: Ident,
    pub unit: LitStr,
    pub phase: Ident,
    pub period: f64,
    /// `rolling`: if the phase moves by whole pitches, only the law can change. The engine may then count whole pitches separately.
    pub rolling: bool,
    /// `unless(a, b)`: effects that stop the rolling, for example a support of a part that rotates. Any one of them is enough.
    pub held: Vec<Ident>,
    /// `with EFFECT`: the law is zero without the effect.
    pub with: Option<Ident>,
    pub role: Role,
    pub doc: LitStr,
}

/// The quantity that a law gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// A stiffness.
    Stiffness,
    /// `with EFFECT`: an offset of deflections, of any sign.
    Error,
    /// `with EFFECT as side`: a factor of torques, of any sign.
    Side,
    /// `with EFFECT as arm`: a factor of torques, never negative.
    Arm,
}

/// `speed "rad/s" { theta_dot = N1; }, "doc";`
pub struct RigidMotion {
    pub name: Ident,
    pub unit: LitStr,
    pub speeds: Vec<Assignment>,
    pub doc: LitStr,
}

/// `backlash_12 of backlash requires(a, b) excludes(c) "doc";`
pub struct Effect {
    pub name: Ident,
    /// For an effect of one part: the effect of all parts.
    pub of: Option<Ident>,
    pub requires: Vec<Ident>,
    pub excludes: Vec<Ident>,
    pub doc: LitStr,
}

/// `steps => with_jump;`: how laws switch in scenes with an effect.
pub struct Boundary {
    pub effect: Ident,
    pub how: How,
}

/// How laws switch where their phase reaches a boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum How {
    /// `with_jump`: with the impulse. Without such an effect laws are constant.
    WithJump,
    /// `without_jump`: without the impulse.
    WithoutJump,
    /// `by_time`: at the times of a steady rotation.
    ByTime,
}

impl How {
    /// All of them, each with its word in a file.
    pub const WORDS: [(&str, How); 3] =
        [("with_jump", How::WithJump), ("without_jump", How::WithoutJump), ("by_time", How::ByTime)];
}

/// `jump_terms = steps, !frozen;`: a conjunction of effects present (`true`) or absent.
pub struct Condition {
    pub name: Ident,
    pub effects: Vec<(bool, Ident)>,
}

/// `NAME = EXPR;` or `NAME with EFFECT = EXPR;`: zero without the effect.
pub struct Function {
    pub name: Ident,
    pub with: Option<Ident>,
    pub value: Expr,
}

/// `NAME = EXPR;`
pub struct Assignment {
    pub name: Ident,
    pub value: Expr,
}

/// `over "m" (edge 0.0, touch 1.0) with backlash, "doc" { MODES loss { ROWS } }`: modes of the deflection `over`.
pub struct Switch {
    pub over: Ident,
    pub unit: LitStr,
    /// The symbols, which are constant in each mode, each with its value in scenes without the effect.
    pub symbols: Vec<(Ident, f64)>,
    /// Without this effect there is no switch.
    pub effect: Ident,
    pub doc: LitStr,
    pub modes: Vec<SwitchMode>,
    /// The dissipative force against the deflection, as a linear form.
    pub loss: Vec<Row>,
}

/// `upper (b/2.0, 1.0) holds rests counts "flanks met" { EXITS }`
pub struct SwitchMode {
    pub name: Ident,
    /// The values of the symbols.
    pub values: Vec<Expr>,
    pub held: bool,
    pub rests: bool,
    pub counts: Option<LitStr>,
    pub exits: Vec<Exit>,
}

/// `until free { ROWS }`, `unless free { ROWS }`
pub struct Exit {
    pub to: Ident,
    /// `unless`: only a sudden change of the state can violate the guard.
    pub sudden: bool,
    /// The guard, as a linear form.
    pub guard: Vec<Row>,
}

/// `drive "doc" { TERMS }`, `fan "doc" {} power { TERMS }`
pub struct Torque {
    pub name: Ident,
    pub doc: LitStr,
    /// Its work for a change of the coordinates, if the torque is constant; else empty.
    pub work: Sum,
    /// Its power, if the torque is not constant; else empty.
    pub power: Sum,
}

/// `force_12 "N" with backlash, "doc" { TERMS }`: what a run can record.
pub struct Output {
    pub unit: LitStr,
    /// `with EFFECT`: only scenes with this effect have it.
    pub with: Option<Ident>,
    pub doc: LitStr,
    /// Its name and its value.
    pub value: Row,
}

/// `fan_load "c*omega^2 in the torque `fan`";`, several effects with commas
pub struct NonlinearWith {
    pub effects: Vec<Ident>,
    pub text: LitStr,
}

/// `jump k { normal { ROWS } compliance { TERMS } direction { ROWS } step { TERMS } }`
pub struct Jump {
    pub law: Ident,
    pub normal: Option<Vec<Row>>,
    pub compliance: Option<Sum>,
    pub direction: Option<Vec<Row>>,
    pub step: Option<Sum>,
}

/// The sum of terms.
pub type Sum = Vec<Term>;

/// `COND => EXPR;`
pub struct Term {
    /// `None`: `_`, always.
    pub condition: Option<Ident>,
    pub value: Expr,
}

/// `theta { TERMS }`: one component of a vector.
pub struct Row {
    pub name: Ident,
    pub sum: Sum,
}

/// `theta phi { TERMS }`: one entry of a matrix.
pub struct Entry {
    pub row: Ident,
    pub column: Ident,
    pub sum: Sum,
}

impl Law {
    /// The name of its mid value.
    pub fn mid(&self) -> Ident {
        format_ident!("{}_mid", self.name)
    }
}

impl Model {
    /// The stiffnesses. They are the first laws, and the only ones with mid values.
    pub fn stiffnesses(&self) -> impl Iterator<Item = &Law> {
        self.laws.iter().filter(|law| law.with.is_none())
    }

    /// Number of the values of all laws and symbols of switches.
    pub fn values(&self) -> Index {
        Index::from(self.laws.len() + self.switches.iter().map(|switch| switch.symbols.len()).sum::<usize>())
    }

    /// The effect with which laws switch in this way.
    pub fn switching(&self, how: How) -> Option<&Ident> {
        self.switching.iter().find(|boundary| boundary.how == how).map(|boundary| &boundary.effect)
    }

    /// The names of the numbers in the equations that are constant in a scene: parameters, mid values of laws, constants.
    pub fn numbers(&self) -> impl Iterator<Item = Ident> {
        let mids = self.stiffnesses().map(Law::mid);
        let parameters = self.parameters.iter().map(|p| p.name.clone());
        parameters.chain(mids).chain(self.constants.iter().map(|c| c.name.clone()))
    }

    /// A model with a name and a title and nothing else; `parse` fills in the rest.
    pub fn empty(name: Ident, title: LitStr) -> Self {
        Self {
            name,
            title,
            source: None,
            coordinates: vec![],
            parameters: vec![],
            laws: vec![],
            motions: vec![],
            effects: vec![],
            switching: vec![],
            conditions: vec![],
            constants: vec![],
            deflections: vec![],
            rates: vec![],
            functions: vec![],
            switches: vec![],
            kinetic: vec![],
            potential: vec![],
            dissipation: vec![],
            forces: vec![],
            partials: vec![],
            torques: vec![],
            work: vec![],
            outputs: vec![],
            mass: vec![],
            mobility: None,
            inertia: vec![],
            force: None,
            jacobian: None,
            stiffness: vec![],
            damping: vec![],
            load: vec![],
            nonlinear: None,
            nonlinear_with: vec![],
            jumps: vec![],
            variables: OnceCell::new(),
            text: None,
            latex: None,
        }
    }
}
