//! The builder of a model: coordinates, parameters, laws, effects, the energies T and V, the dissipation function D, torques.

mod function;
mod output;
mod parts;
mod switch;

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Expr, Kind, number, speed_name, symbol, symbols, total, varies};

pub(crate) use function::{Derivative, Function};
pub(crate) use output::Output;
pub(crate) use parts::{Coordinate, Deflection, Effect, Force, Law, Motion, Parameter, Role, Torque};
pub use parts::{Friction, Range, Start};
pub use switch::{Describing, Switching};
pub(crate) use switch::{Exit, Mode, REACTION, Switch, set};

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
    pub(crate) motions: Vec<Motion>,
    pub(crate) effects: Vec<Effect>,
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
    /// The effect whose closure is running: everything that is added now belongs to it.
    within: Option<String>,
}

impl Model {
    /// The model called `name`, described by `describe`.
    pub fn new(name: &str, describe: impl FnOnce(&mut Model)) -> Model {
        let mut model = Model { name: name.into(), ..Model::default() };
        Expr::forget_rates();
        describe(&mut model);
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

    /// Declares a generalised coordinate with its SI unit.
    pub fn coordinate(&mut self, name: &str, unit: &str, start: Start, doc: &str) -> Expr {
        self.coordinates.push(Coordinate { name: name.into(), unit: unit.into(), start, doc: doc.into() });
        Expr::var(Kind::Coordinate, name)
    }

    /// Declares a parameter with its SI unit. A scene must give it if `default` [SI] is `None`; if it is declared inside an
    /// effect, only a scene that names the effect must.
    pub fn parameter(&mut self, name: &str, unit: &str, default: Option<f64>, range: Range, doc: &str) -> Expr {
        let with = self.within.clone();
        self.parameters.push(Parameter { name: name.into(), unit: unit.into(), default, with, range, doc: doc.into() });
        Expr::var(Kind::Parameter, name)
    }

    /// Names a constant: an expression in parameters, earlier constants, mid values of laws and [`Model::inverse_mass`].
    pub fn constant(&mut self, name: &str, value: Expr) -> Expr {
        self.constants.push((name.into(), value));
        Expr::var(Kind::Constant, name)
    }

    /// Names a deflection, for example of a spring: a linear form of the coordinates without a constant term, from which
    /// transmission errors and functions of several positions ([`Model::function_of`]) may be subtracted. V may be written in the deflection, D in its `.dot()`, which does not contain the
    /// rate of an error. The equations are then written in the deflection instead of being multiplied out.
    pub fn deflection(&mut self, name: &str, value: Expr) -> Expr {
        self.deflections.push(Deflection { name: name.into(), value: value.expand() });
        Expr::var(Kind::Deflection, name)
    }

    /// Names a smooth function of one position: the place of a piston as a function of the angle of its crank. `of` is a coordinate or
    /// a named deflection without transmission errors, and `value` gives the function of it. T, V and the displacements of torques may
    /// be written in the function and its `.dot()`. The equations are then written in the function and its derivatives, `name`, `dname`,
    /// `ddname` and `dddname`, instead of being multiplied out. This is how a holonomic constraint is stated: solved for one quantity.
    pub fn function(&mut self, name: &str, of: Expr, value: impl FnOnce(Expr) -> Expr) -> Expr {
        let (name, of, value) = (name.into(), vec![of], value(of));
        self.declare_function(Function { name, of, value, gradient: vec![], with: None })
    }

    /// Names a smooth function of several positions: how far a line of action turns as the centres of gears move. `of` are coordinates or
    /// named deflections without transmission errors; `value` and `gradient` give the function of them and its derivatives by them, which
    /// the derivation compares. Inside the closure of an effect: it is zero in scenes without the effect. V may be written in it, and so may
    /// deflections: these then bend, which means that they are not linear in the coordinates. The equations are written in the function and
    /// its derivatives `name_by_x`, `name_by_x_by_y`.
    pub fn function_of<const N: usize>(
        &mut self,
        name: &str,
        of: [Expr; N],
        value: impl FnOnce([Expr; N]) -> Expr,
        gradient: impl FnOnce([Expr; N]) -> [Expr; N],
    ) -> Expr {
        let (value, gradient, with) = (value(of), gradient(of).to_vec(), self.within.clone());
        self.declare_function(Function { name: name.into(), of: of.to_vec(), value, gradient, with })
    }

    fn declare_function(&mut self, function: Function) -> Expr {
        let name = function.name.clone();
        Expr::set_rate(&name, Expr::new(self.function_rate(&function, 0)));
        self.functions.push(function);
        Expr::var(Kind::Function, &name)
    }

    /// The rate of a function, or of one of its derivatives, in the speeds: the sum of its derivatives times the rates of the positions, with
    /// the marker of its effect.
    pub(crate) fn function_rate(&self, function: &Function, derivative: usize) -> Atom {
        let all = function.derivatives();
        let next = all.get(derivative).map(|d| d.next.clone()).unwrap_or_default();
        let parts = next.into_iter().zip(&function.of).filter_map(|(next, of)| {
            Some(Atom::var(symbol(Kind::Function, &all.get(next)?.name)) * self.position(*of).dot().atom())
        });
        let marker = function.with.as_ref().map_or(number(1), |effect| Atom::var(symbol(Kind::Marker, effect)));
        marker * total(parts.collect())
    }

    /// A coordinate, or a named deflection written in the coordinates.
    pub(crate) fn position(&self, of: Expr) -> Expr {
        let named = self.deflections.iter().find(|d| of.atom() == Expr::var(Kind::Deflection, &d.name).atom());
        named.map_or(of, |d| d.value)
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

    /// Declares a mesh stiffness [unit]: a law that is periodic with one tooth pitch of `phase` and whose steps the scene gives.
    /// Declares the effects `stiffness_step` (with the jump terms), `rigid_kinematics` (without them) and `frozen_phase`.
    pub fn mesh_stiffness(&mut self, name: &str, unit: &str, phase: Expr, period: f64, doc: &str) -> MeshStiffness {
        self.declare_mesh_effects();
        // Laws with effects come last, so that a scene without the effects numbers its laws in the same way.
        let place = self.laws.iter().take_while(|law| law.with.is_none()).count();
        let role = Role::Stiffness;
        let law = Law { name: name.into(), unit: unit.into(), phase, period, with: None, role, doc: doc.into() };
        self.laws.insert(place, law);
        MeshStiffness {
            value: Expr::var(Kind::Law, name),
            slope: Expr::var(Kind::Slope, &format!("d{name}")),
            mid: Expr::var(Kind::Mid, &mid_name(name)),
        }
    }

    /// Declares a transmission error e [unit of the deflection]: the deviation of the unloaded flanks from their ideal position.
    /// It is periodic with one tooth pitch of `phase`, or with several if the scene says so; the scene gives its values. Subtract
    /// it from the deflection of the mesh, V = k (delta - e)^2/2. It is zero in scenes without the effect `transmission_error`,
    /// which this declares. It steps or varies continuously by the same rules as a stiffness.
    ///
    /// Dampers act on the rate of delta, not of delta - e: the rate of e is infinite at a step.
    pub fn transmission_error(
        &mut self,
        [name, part]: [&str; 2],
        unit: &str,
        phase: Expr,
        period: f64,
        what: &str,
    ) -> MeshError {
        self.declare_mesh_effects();
        let doc =
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        let effect = self.part_effect(TRANSMISSION_ERROR, part, doc, |_| {});
        self.require(&effect, &[STIFFNESS_STEP]);
        let (with, role) = (Some(effect), Role::Error);
        let law = Law { name: name.into(), unit: unit.into(), phase, period, with, role, doc: what.into() };
        // Before the laws of friction: a scene may have friction without transmission errors.
        let place = self.laws.iter().take_while(|law| !matches!(law.role, Role::Friction(_))).count();
        self.laws.insert(place, law);
        MeshError { value: Expr::var(Kind::Error, name) }
    }

    /// The effect `sliding_friction` of a part: what `add` adds is in the equations only of scenes that name the effect.
    pub fn sliding_friction(&mut self, part: &str, add: impl FnOnce(&mut Model)) {
        self.declare_mesh_effects();
        let doc = "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        let effect = self.part_effect(SLIDING_FRICTION, part, doc, add);
        self.require(&effect, &[STIFFNESS_STEP]);
    }

    /// Declares a friction law [unit], periodic with one tooth pitch of `phase`; the scene gives its values, from tooth data or
    /// otherwise. It is zero without the effect of [`Model::sliding_friction`], inside whose closure this must be called. It may
    /// only be a factor of torques in that effect, which may then depend on deflections and stiffnesses too. It is in no energy,
    /// so that the speeds are continuous where it steps.
    pub fn friction_law(
        &mut self,
        name: &str,
        unit: &str,
        phase: Expr,
        period: f64,
        what: Friction,
        doc: &str,
    ) -> Expr {
        let effect = self.within.clone().unwrap_or_else(|| SLIDING_FRICTION.into());
        let (with, role) = (Some(effect), Role::Friction(what));
        self.laws.push(Law { name: name.into(), unit: unit.into(), phase, period, with, role, doc: doc.into() });
        Expr::var(Kind::Friction, name)
    }

    fn declare_mesh_effects(&mut self) {
        if !self.effects.iter().any(|e| e.name == STIFFNESS_STEP) {
            self.effects.extend(mesh_effects());
        }
    }

    /// Declares a rigid motion by which a scene may state its initial speeds in one number [unit]: pairs of a coordinate and
    /// its speed for a motion of size 1. Other coordinates have the speed 0.
    pub fn motion(&mut self, name: &str, unit: &str, speeds: &[(Expr, Expr)], doc: &str) {
        self.motions.push(Motion { name: name.into(), unit: unit.into(), speeds: speeds.to_vec(), doc: doc.into() });
    }

    /// Declares an effect: what `add` adds is in the equations only of scenes that name the effect. Several components may add
    /// to one effect, one after another, each with the same `name` and `doc`.
    pub fn effect(&mut self, name: &str, doc: &str, add: impl FnOnce(&mut Model)) {
        if !self.effects.iter().any(|e| e.name == name && e.doc == doc) {
            self.effects.push(Effect::new(name, &[], &[], doc));
        }
        let outer = self.within.replace(name.into());
        add(self);
        self.within = outer;
    }

    /// The effect `name` at one part of the model, which scenes may name alone: `backlash_12`; `backlash` is that of all parts. A model
    /// whose only part has no name has the effect `name` itself. Otherwise as [`Model::effect`]. Returns the name of the effect.
    pub fn part_effect(&mut self, name: &str, part: &str, doc: &str, add: impl FnOnce(&mut Model)) -> String {
        if part.is_empty() {
            self.effect(name, doc, add);
            return name.into();
        }
        let own = format!("{name}_{part}");
        self.effect(&own, doc, add);
        self.effects.iter_mut().filter(|effect| effect.name == own).for_each(|effect| effect.of = Some(name.into()));
        own
    }

    /// Declares that the effect `name`, declared before, needs each of `others`.
    pub fn require(&mut self, name: &str, others: &[&str]) {
        for effect in self.effects.iter_mut().filter(|effect| effect.name == name) {
            for other in
                others.iter().filter(|other| !effect.requires.iter().any(|known| known == *other)).collect::<Vec<_>>()
            {
                effect.requires.push(other.to_string());
            }
        }
    }

    /// Adds to the kinetic energy T [J].
    pub fn kinetic(&mut self, t: Expr) {
        let t = self.marked(t);
        self.kinetic.push(t);
    }

    /// Adds to the potential energy V [J].
    pub fn potential(&mut self, v: Expr) {
        let v = self.marked(v);
        self.potential.push(v);
    }

    /// Adds to Rayleigh's dissipation function D [W]; the dissipated power is 2 D.
    pub fn dissipation(&mut self, d: Expr) {
        let d = self.marked(d);
        self.dissipation.push(d);
    }

    /// Adds Rayleigh damping, C = alpha M + beta K: D = alpha T + beta V, where V has the speeds instead of the coordinates and
    /// every law at its mid value. `alpha` [1/s], `beta` [s]. Call it after all of T and V. Terms of T that depend on coordinates and
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

    /// Adds an external torque (or force) of size `value` that works through the displacement `through`. The torque is constant or
    /// depends on speeds; only with a friction law as a factor may it depend on deflections and stiffnesses too. A torque that is not
    /// constant, or whose displacement is not linear in the coordinates, makes the cells nonlinear. If it is linear in the speed of `through`,
    /// avoid this by writing it as a constant torque and a dissipation: T = c (n - omega) is the torque c n and D = c omega^2/2. Its power
    /// is the output `power_NAME` [W].
    pub fn torque(&mut self, name: &str, value: Expr, through: Expr, doc: &str) {
        let value = self.marked(value);
        self.torques.push(Torque { name: name.into(), value, through, along: None, doc: doc.into() });
        self.power_output(name, doc);
    }

    /// Adds an external torque (or force) of size `value` that works along `speed`, a linear form of the speeds with factors that may
    /// depend on the coordinates, where the displacement has no closed form: the speed of a shaft behind a universal joint. Otherwise
    /// as [`Model::torque`].
    pub fn torque_along(&mut self, name: &str, value: Expr, speed: Expr, doc: &str) {
        let (value, through) = (self.marked(value), Expr::from(0));
        self.torques.push(Torque { name: name.into(), value, through, along: Some(speed), doc: doc.into() });
        self.power_output(name, doc);
    }

    /// Declares the power of an external torque as an output. Their sum is the rate of the work in the energy account.
    fn power_output(&mut self, name: &str, doc: &str) {
        let power = self.power(name);
        self.output(&format!("power_{name}"), "W", power, &format!("power of the {doc}: positive if it drives"));
    }

    /// Names a force, for example a friction force, that is a factor in several torques or acts on several coordinates. It may
    /// depend on whatever those torques may depend on. The equations are written in its name instead of being multiplied out.
    pub fn force(&mut self, name: &str, value: Expr) -> Expr {
        self.forces.push(Force { name: name.into(), value, with: self.within.clone() });
        Expr::var(Kind::Force, name)
    }

    /// Declares that the effect `name`, declared before, excludes each of `others`: a scene may name one side only.
    pub fn exclude(&mut self, name: &str, others: &[&str]) {
        for effect in self.effects.iter_mut().filter(|effect| effect.name == name) {
            for other in
                others.iter().filter(|other| !effect.excludes.iter().any(|known| known == *other)).collect::<Vec<_>>()
            {
                effect.excludes.push(other.to_string());
            }
        }
    }

    /// The expression times the marker of the effect whose closure is running, if there is one.
    fn marked(&self, e: Expr) -> Expr {
        match &self.within {
            Some(effect) => Expr::var(Kind::Marker, effect) * e,
            None => e,
        }
    }

    /// The expression with named forces written out. In reverse order, since a force may depend on earlier ones.
    pub(crate) fn written_out(&self, e: &Atom) -> Atom {
        self.forces.iter().rev().fold(e.clone(), |e, force| {
            let name = Atom::var(symbol(Kind::Force, &force.name));
            e.replace(name.to_pattern()).with(force.value.atom().to_pattern())
        })
    }

    /// Whether a torque acts with generalised forces that are not constant: it depends on speeds, has a friction law in it, or its
    /// displacement is not linear.
    pub(crate) fn varies(&self, torque: &Torque) -> bool {
        varies(&self.written_out(&torque.value.atom())) || !torque.is_linear()
    }

    /// Whether T depends on coordinates.
    pub(crate) fn inertia_moves(&self) -> bool {
        self.kinetic.iter().any(depends_on_positions)
    }

    /// Names of the speeds, in the order of the coordinates.
    pub(crate) fn speeds(&self) -> Vec<String> {
        self.coordinates.iter().map(|c| speed_name(&c.name)).collect()
    }
}

/// Whether a term of T depends on coordinates.
fn depends_on_positions(t: &Expr) -> bool {
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
        let x = Atom::var(symbol(kind, &name));
        e.replace(x.to_pattern()).with((&x * Atom::num(2)).to_pattern())
    });
    (doubled - v * Atom::num(4)).expand().is_zero()
}

/// The symbols of a mesh stiffness.
#[derive(Clone, Copy, Debug)]
pub struct MeshStiffness {
    /// Its value at the present phase.
    pub value: Expr,
    /// Its derivative by the phase. The derived equations contain it, energies may not.
    pub slope: Expr,
    /// Its mid value, (max + min)/2 over one pitch.
    pub mid: Expr,
}

/// The symbol of a transmission error.
#[derive(Clone, Copy, Debug)]
pub struct MeshError {
    /// Its value at the present phase, to be subtracted from a deflection.
    pub value: Expr,
}

pub(crate) fn mid_name(law: &str) -> String {
    format!("{law}_mid")
}

/// Name of the inverse mass of an expression that is not a coordinate. It is never replaced by a value, hence refused.
const NO_MOBILITY: &str = "none";

pub(crate) fn mobility_name(i: usize, j: usize) -> String {
    format!("W{}_{}", i.min(j), i.max(j))
}

/// Effect without which the stiffnesses are constant.
const STIFFNESS_STEP: &str = "stiffness_step";
/// Effect without which there is no friction.
const SLIDING_FRICTION: &str = "sliding_friction";
/// Effect without which transmission errors are zero.
const TRANSMISSION_ERROR: &str = "transmission_error";

/// Condition of the terms with the slope of a law: the laws step with the motion itself, and the impulses are kept.
pub(crate) const JUMP_TERMS: &str = "jump_terms";
/// Condition of all terms through the phase of a law: the phase is not frozen. Implied by [`JUMP_TERMS`].
pub(crate) const MOVING_PHASE: &str = "moving_phase";
/// These two conditions, with the effects that they need present (or, with `!`, absent).
pub(crate) const CONDITIONS: [(&str, &str); 2] =
    [(JUMP_TERMS, "stiffness_step, !rigid_kinematics, !frozen_phase"), (MOVING_PHASE, "stiffness_step, !frozen_phase")];

fn mesh_effects() -> [Effect; 3] {
    [
        Effect::new(
            STIFFNESS_STEP,
            &[],
            &[],
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value",
        ),
        Effect::new(
            "rigid_kinematics",
            &[STIFFNESS_STEP],
            &["frozen_phase"],
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved",
        ),
        Effect::new(
            "frozen_phase",
            &[STIFFNESS_STEP],
            &["rigid_kinematics"],
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations",
        ),
    ]
}
