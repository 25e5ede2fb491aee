//! A model in the making: coordinates, parameters, laws, effects and the energies T, V, D, Q.

mod parts;

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Expr, Kind, speed_name, symbol, varies};

pub(crate) use parts::{Coordinate, DeadBand, Deflection, Effect, Force, Law, Motion, Parameter, Role, Torque};
pub use parts::{Friction, Range, Start};

/// A drivetrain, described by its energies.
///
/// The methods are called in any order that declares a symbol before it is used; [`crate::derive`] checks the whole.
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
    pub(crate) dead_bands: Vec<DeadBand>,
    pub(crate) forces: Vec<Force>,
    pub(crate) torques: Vec<Torque>,
    pub(crate) kinetic: Vec<Expr>,
    pub(crate) potential: Vec<Expr>,
    pub(crate) dissipation: Vec<Expr>,
    /// Effect whose closure is running: what is added now is marked with it.
    within: Option<String>,
}

impl Model {
    /// The model called `name`, described by `describe`.
    pub fn new(name: &str, describe: impl FnOnce(&mut Model)) -> Model {
        let mut model = Model { name: name.into(), ..Model::default() };
        describe(&mut model);
        model
    }

    /// One line saying what it is.
    pub fn title(&mut self, title: &str) {
        self.title = title.into();
    }

    /// Where it comes from: author, year, equations.
    pub fn source(&mut self, source: &str) {
        self.source = source.into();
    }

    /// A generalised coordinate, with its SI unit.
    pub fn coordinate(&mut self, name: &str, unit: &str, start: Start, doc: &str) -> Expr {
        self.coordinates.push(Coordinate { name: name.into(), unit: unit.into(), start, doc: doc.into() });
        Expr::var(Kind::Coordinate, name)
    }

    /// A parameter with its SI unit; scenes must give it where `default` [SI] is `None`, and within an effect only if they
    /// name that.
    pub fn parameter(&mut self, name: &str, unit: &str, default: Option<f64>, range: Range, doc: &str) -> Expr {
        let with = self.within.clone();
        self.parameters.push(Parameter { name: name.into(), unit: unit.into(), default, with, range, doc: doc.into() });
        Expr::var(Kind::Parameter, name)
    }

    /// A name for a constant of the motion: an expression in parameters, earlier constants, mid values of laws and
    /// [`Model::inverse_mass`].
    pub fn constant(&mut self, name: &str, value: Expr) -> Expr {
        self.constants.push((name.into(), value));
        Expr::var(Kind::Constant, name)
    }

    /// A name for what a spring feels: linear in the coordinates, and zero where they are, less transmission errors. V may
    /// be written in it and D in its `.dot()`, in which an error has no part; the equations then are, too, instead of being
    /// multiplied out. What is a coordinate keeps that name.
    pub fn deflection(&mut self, name: &str, value: Expr) -> Expr {
        let value = value.expand();
        if self.coordinates.iter().any(|c| value.atom() == Expr::var(Kind::Coordinate, &c.name).atom()) {
            return value;
        }
        self.deflections.push(Deflection { name: name.into(), value });
        Expr::var(Kind::Deflection, name)
    }

    /// Play about `delta` [unit], linear in the coordinates: nothing is felt within `half` [unit] to either side of zero. For
    /// scenes without `effect` there is none. V is to be written in what comes back, `k.value * gap.touch * gap.over.sq()`,
    /// and a damper that acts in contact in `gap.damp * gap.over.dot().sq()`.
    ///
    /// V does not step at an edge, so there is no impulse. The damper never pulls, nor pushes more than the spring (as in
    /// Modelica.Mechanics.Rotational.Components.ElastoBacklash2): its force is clipped to plus or minus the spring's.
    ///
    /// Names: `over`, `touch`, `edge`, `damp`, `clip`, each with `part` behind it.
    pub fn dead_band(&mut self, part: &str, unit: &str, delta: Expr, half: Expr, effect: &str, doc: &str) -> Play {
        let named = |what: &str| format!("{what}{part}");
        let (over, touch, edge) = (named("over"), named("touch"), named("edge"));
        let (damp, clip) = (named("damp"), named("clip"));
        let value = delta.expand() - Expr::var(Kind::Edge, &edge);
        self.deflections.push(Deflection { name: over.clone(), value });
        let play = Play {
            over: Expr::var(Kind::Deflection, &over),
            touch: Expr::var(Kind::Touch, &touch),
            damp: Expr::var(Kind::Damp, &damp),
        };
        let (unit, effect, doc) = (unit.into(), effect.into(), doc.into());
        self.dead_bands.push(DeadBand { over, touch, edge, damp, clip, unit, half, effect, doc });
        play
    }

    /// The entry of the inverse mass matrix for two coordinates, whatever the derivation finds it to be. (At most two
    /// coordinates: larger mass matrices are never inverted symbolically.)
    pub fn inverse_mass(&self, a: Expr, b: Expr) -> Expr {
        let index =
            |e: Expr| self.coordinates.iter().position(|c| e.atom() == Expr::var(Kind::Coordinate, &c.name).atom());
        match (index(a), index(b)) {
            (Some(i), Some(j)) => Expr::var(Kind::Mobility, &mobility_name(i, j)),
            _ => Expr::var(Kind::Mobility, NO_MOBILITY),
        }
    }

    /// A mesh stiffness: periodic with one tooth pitch of `phase`, its steps given by the scene. Declares the effects
    /// `stiffness_step` (with the jump terms), `rigid_kinematics` (without them) and `frozen_phase`.
    pub fn mesh_stiffness(&mut self, name: &str, unit: &str, phase: Expr, period: f64, doc: &str) -> MeshStiffness {
        self.declare_mesh_effects();
        // Laws with effects come last: scenes without the effects have the laws before them, by the same numbers.
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

    /// A transmission error: what unloaded flanks are beyond their ideal places [unit of the deflection], periodic with
    /// one tooth pitch of `phase` or, as the scene may say, with several; its course given by the scene. It is to be taken
    /// from the deflection that a mesh feels, V = k (delta - e)^2/2, and is zero for scenes without the effect
    /// `transmission_error`, which this declares. It steps or goes on as a stiffness does, by the same rules.
    ///
    /// Dampers feel the rate of delta, not that of e, which a step would make infinite.
    pub fn transmission_error(&mut self, name: &str, unit: &str, phase: Expr, period: f64, doc: &str) -> MeshError {
        self.declare_mesh_effects();
        let says =
            "flanks deviate from their ideal places: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        self.declare(Effect::new(TRANSMISSION_ERROR, &[STIFFNESS_STEP], &[], says));
        let (with, role) = (Some(TRANSMISSION_ERROR.into()), Role::Error);
        let law = Law { name: name.into(), unit: unit.into(), phase, period, with, role, doc: doc.into() };
        // Before those of friction, which a scene may have without it.
        let place = self.laws.iter().take_while(|law| !matches!(law.role, Role::Friction(_))).count();
        self.laws.insert(place, law);
        MeshError { value: Expr::var(Kind::Error, name) }
    }

    /// The effect `sliding_friction`: what `add` adds is in the equations only of scenes that name it. It needs flanks that
    /// move with the phase, so that it rules out `rigid_kinematics` and `frozen_phase`, in which energy has no account.
    pub fn sliding_friction(&mut self, add: impl FnOnce(&mut Model)) {
        self.declare_mesh_effects();
        let doc = "Coulomb friction between the flanks, against their sliding, which turns about where a pair of teeth \
                   passes the pitch point";
        self.declare(Effect::new(SLIDING_FRICTION, &[STIFFNESS_STEP], &["rigid_kinematics", "frozen_phase"], doc));
        self.effect(SLIDING_FRICTION, doc, add);
    }

    /// A law of friction, periodic with one tooth pitch of `phase`, its course given by the scene, by its teeth or otherwise;
    /// zero without the effect [`Model::sliding_friction`], to be called in its closure. It may be a factor of torques in that
    /// effect, which may then depend on deflections and stiffnesses too, and of nothing else: no energy is stored
    /// in it, and where it steps speeds do not.
    pub fn friction_law(
        &mut self,
        name: &str,
        unit: &str,
        phase: Expr,
        period: f64,
        what: Friction,
        doc: &str,
    ) -> Expr {
        let (with, role) = (Some(SLIDING_FRICTION.into()), Role::Friction(what));
        self.laws.push(Law { name: name.into(), unit: unit.into(), phase, period, with, role, doc: doc.into() });
        Expr::var(Kind::Friction, name)
    }

    fn declare_mesh_effects(&mut self) {
        if !self.effects.iter().any(|e| e.name == STIFFNESS_STEP) {
            self.effects.extend(mesh_effects());
        }
    }

    /// Adds an effect, if there is none of that name.
    fn declare(&mut self, effect: Effect) {
        if !self.effects.iter().any(|e| e.name == effect.name) {
            self.effects.push(effect);
        }
    }

    /// A rigid motion by which a scene may state its start: the speeds (coordinate, speed per unit) of the train.
    pub fn motion(&mut self, name: &str, unit: &str, speeds: &[(Expr, Expr)], doc: &str) {
        self.motions.push(Motion { name: name.into(), unit: unit.into(), speeds: speeds.to_vec(), doc: doc.into() });
    }

    /// An effect: what `add` adds is in the equations only of scenes that name it. Components may add to one effect
    /// one after another, each with the same `name` and `doc`.
    pub fn effect(&mut self, name: &str, doc: &str, add: impl FnOnce(&mut Model)) {
        if !self.effects.iter().any(|e| e.name == name && e.doc == doc) {
            self.effects.push(Effect::new(name, &[], &[], doc));
        }
        let outer = self.within.replace(name.into());
        add(self);
        self.within = outer;
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

    /// Adds to Rayleigh's dissipation function D [W]; the power lost is 2 D.
    pub fn dissipation(&mut self, d: Expr) {
        let d = self.marked(d);
        self.dissipation.push(d);
    }

    /// Rayleigh damping, D = alpha T + beta V with speeds in the place of coordinates and every law at its mid value:
    /// C = alpha M + beta K. To be called after all of T and V, which must be sums of squares.
    pub fn rayleigh(&mut self, alpha: Expr, beta: Expr) {
        let (kinetic, potential) = (self.kinetic.clone(), self.potential.clone());
        for t in kinetic {
            self.dissipation(alpha * t);
        }
        for v in potential {
            let speeds = self
                .coordinates
                .iter()
                .fold(v, |v, c| v.with((Kind::Coordinate, &c.name), (Kind::Speed, &speed_name(&c.name))));
            let speeds = self
                .deflections
                .iter()
                .fold(speeds, |v, d| v.with((Kind::Deflection, &d.name), (Kind::Rate, &speed_name(&d.name))));
            let speeds = self
                .dead_bands
                .iter()
                .fold(speeds, |v, band| v.with((Kind::Touch, &band.touch), (Kind::Damp, &band.damp)));
            let at_mid =
                self.laws.iter().fold(speeds, |v, l| v.with((Kind::Law, &l.name), (Kind::Mid, &mid_name(&l.name))));
            self.dissipation(beta * at_mid);
        }
    }

    /// An external torque (or force) of size `value` that works through the displacement `through`, linear in the
    /// coordinates. It is constant, or depends on speeds; then cells are not linear, so that what is linear in the speed of
    /// `through` is better said as a constant torque and a dissipation: T = c (n - omega) is c n, and D = c omega^2/2. With a
    /// law of friction as a factor it may also depend on deflections and stiffnesses.
    pub fn torque(&mut self, name: &str, value: Expr, through: Expr, doc: &str) {
        let value = self.marked(value);
        self.torques.push(Torque { name: name.into(), value, through, doc: doc.into() });
    }

    /// A name for what several torques, or several coordinates, have of one force: a friction, say. It may depend on what the
    /// torques may in which it stands, and the equations are written in it instead of being multiplied out.
    pub fn force(&mut self, name: &str, value: Expr) -> Expr {
        self.forces.push(Force { name: name.into(), value, with: self.within.clone() });
        Expr::var(Kind::Force, name)
    }

    /// Says that the effect `name`, declared before, contradicts `others`: a scene names it or them. Each set of effects is
    /// compiled by itself, so that it pays to rule out sets that nobody needs.
    pub fn exclude(&mut self, name: &str, others: &[&str]) {
        for effect in self.effects.iter_mut().filter(|effect| effect.name == name) {
            effect.excludes.extend(others.iter().map(|other| other.to_string()));
        }
    }

    fn marked(&self, e: Expr) -> Expr {
        match &self.within {
            Some(effect) => Expr::var(Kind::Marker, effect) * e,
            None => e,
        }
    }

    /// An expression with its forces written out, of which the later may depend on the earlier.
    pub(crate) fn written_out(&self, e: &Atom) -> Atom {
        self.forces.iter().rev().fold(e.clone(), |e, force| {
            let name = Atom::var(symbol(Kind::Force, &force.name));
            e.replace(name.to_pattern()).with(force.value.atom().to_pattern())
        })
    }

    /// Whether a torque is not constant: it depends on speeds, or is friction.
    pub(crate) fn varies(&self, torque: &Torque) -> bool {
        varies(&self.written_out(&torque.value.atom()))
    }

    /// Names of the speeds, in the order of the coordinates.
    pub(crate) fn speeds(&self) -> Vec<String> {
        self.coordinates.iter().map(|c| speed_name(&c.name)).collect()
    }
}

/// A mesh stiffness in expressions.
#[derive(Clone, Copy, Debug)]
pub struct MeshStiffness {
    /// Its present value.
    pub value: Expr,
    /// Its slope along the phase; derived equations contain it, energies may not.
    pub slope: Expr,
    /// Its mid value, (max + min)/2 over a pitch.
    pub mid: Expr,
}

/// A transmission error in expressions.
#[derive(Clone, Copy, Debug)]
pub struct MeshError {
    /// Its present value, to be taken from a deflection.
    pub value: Expr,
}

/// A dead band in expressions.
#[derive(Clone, Copy, Debug)]
pub struct Play {
    /// The deflection beyond the band, to either side.
    pub over: Expr,
    /// 1 in contact, 0 within the band.
    pub touch: Expr,
    /// 1 while the damper of the contact acts.
    pub damp: Expr,
}

pub(crate) fn mid_name(law: &str) -> String {
    format!("{law}_mid")
}

/// Stands for the inverse mass of what is no coordinate; no derivation replaces it, so it is refused.
const NO_MOBILITY: &str = "none";

pub(crate) fn mobility_name(i: usize, j: usize) -> String {
    format!("W{}_{}", i.min(j), i.max(j))
}

/// Effect without which laws are constant.
const STIFFNESS_STEP: &str = "stiffness_step";
/// Effect without which there is no friction.
const SLIDING_FRICTION: &str = "sliding_friction";
/// Effect without which transmission errors are zero.
const TRANSMISSION_ERROR: &str = "transmission_error";

/// Marker of the terms with a law's slope: in force where the stiffness steps with the motion itself.
pub(crate) const JUMP_TERMS: &str = "jump_terms";
/// Marker of what depends on the phase at all: in force unless the phase is frozen. Implied by [`JUMP_TERMS`].
pub(crate) const MOVING_PHASE: &str = "moving_phase";
/// When they are there.
pub(crate) const CONDITIONS: [(&str, &str); 2] =
    [(JUMP_TERMS, "stiffness_step, !rigid_kinematics, !frozen_phase"), (MOVING_PHASE, "stiffness_step, !frozen_phase")];

fn mesh_effects() -> [Effect; 3] {
    [
        Effect::new(
            STIFFNESS_STEP,
            &[],
            &[],
            "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; \
             without it the stiffness is constant at its mid value",
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
            "steps at the times of a steady rotation, k(Omega0 t) for k(theta): the classical equations",
        ),
    ]
}
