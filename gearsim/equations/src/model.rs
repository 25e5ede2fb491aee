//! Description of a derived model: names, units, parameters, laws, effects. Scenes and the command line use it.
//!
//! [`equations!`](crate::equations) generates a description, with its equations, from a file of derived equations. No description is
//! written by hand.

/// Description of a drivetrain model: what a scene can set, and which effects it can activate.
#[derive(Debug, Clone, Copy)]
pub struct Model {
    /// Name in scenes and on the command line, e.g. `gear_pair`.
    pub name: &'static str,
    /// Title, one line.
    pub title: &'static str,
    /// Source: author, year, equations.
    pub source: &'static str,
    /// Generalised coordinates, in the order of all state vectors.
    pub coordinates: &'static [Coordinate],
    /// Parameters, in the order of all parameter vectors.
    pub parameters: &'static [Parameter],
    /// Laws whose profiles a scene gives: first the mesh stiffnesses, then transmission errors, then friction laws.
    pub laws: &'static [Law],
    /// Rigid motions with which a scene may state initial speeds, e.g. `speed = "300 rpm"`.
    pub motions: &'static [RigidMotion],
    /// Effects that a scene may activate; bit `i` of an effect set is entry `i`.
    pub effects: &'static [Effect],
    /// External torques, in the order of their columns of work. A run has a column for each torque whose effects it has.
    pub torques: &'static [Torque],
    /// The quantities that a run can record besides the coordinates, in the order of their columns.
    pub outputs: &'static [Output],
    /// Switches. Vectors of law values have the values of their symbols, in this order, after the entries of the laws.
    pub switches: &'static [Switch],
    /// The terms that make cells nonlinear without any effect, with the energies they come from; empty if there are none.
    pub nonlinear: &'static str,
    /// Terms that make cells nonlinear, each with its effects: (effects, term). The term is present only if all of these effects are
    /// active.
    pub nonlinear_with: &'static [(&'static [&'static str], &'static str)],
    /// The derived equations as plain text, one group of terms per line.
    pub equations: &'static str,
    /// The derived equations in LaTeX, one group of terms per line.
    pub latex: &'static str,
    /// The elements of which a scene puts the model together; empty for a model whose equations are derived as a whole.
    pub elements: &'static [&'static Model],
    /// The rotations of gears relative to carriers in a train; empty for a model whose equations are derived as a whole.
    pub relative: &'static [Relative],
}

/// The rotation of a gear of a planet set relative to the carrier. Its speed gives the frequency at which a tooth of the gear meets the
/// planets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relative {
    /// Name, e.g. `rotor_speed_sun - rotor_speed_c`.
    pub name: &'static str,
    /// The stiffness law of a mesh of the set.
    pub law: &'static str,
    /// The output that is the speed of the gear; `None`: it is fixed to the ground.
    pub gear: Option<&'static str>,
    /// The output that is the speed of the carrier; `None`: it is fixed to the ground.
    pub carrier: Option<&'static str>,
    /// Number of times that a tooth of the gear is in mesh in one turn relative to the carrier.
    pub meets: u32,
}

impl Model {
    /// The vector of law values without the effects of the switches, that is with every play closed and in contact. It has the values
    /// `laws`, padded with 0 to the number of laws, then the neutral values of each switch.
    pub fn in_contact(&self, laws: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let laws = laws.into_iter().chain(std::iter::repeat(0.0)).take(self.laws.len());
        laws.chain(self.switches.iter().flat_map(|switch| switch.neutral.iter().copied())).collect()
    }

    /// The effect with which laws switch in this way; `None` if the model has none.
    pub fn switching(&self, how: Switching) -> Option<&'static Effect> {
        self.effects.iter().find(|effect| effect.switching == Some(how))
    }
}

/// A generalised coordinate.
#[derive(Debug, Clone, Copy)]
pub struct Coordinate {
    /// Name, e.g. `theta`; its speed is `theta_dot`.
    pub name: &'static str,
    /// SI unit, e.g. `rad`.
    pub unit: &'static str,
    /// What it measures.
    pub doc: &'static str,
    /// Initial value if the scene gives none.
    pub start: Start,
}

/// Initial value of a coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// At this value [SI unit of the coordinate].
    At(f64),
    /// The static equilibrium of the coordinate.
    Static,
    /// The static equilibrium. If there are several, the one that the search finds from this value [SI unit of the coordinate].
    Near(f64),
}

impl Start {
    /// Whether it is a static equilibrium.
    pub fn is_static(self) -> bool {
        !matches!(self, Start::At(_))
    }

    /// The value, or the starting point of the search for the equilibrium [SI unit of the coordinate].
    pub fn guess(self) -> f64 {
        match self {
            Start::At(x) | Start::Near(x) => x,
            Start::Static => 0.0,
        }
    }
}

/// A scalar parameter.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    /// Name, e.g. `T0`.
    pub name: &'static str,
    /// SI unit, e.g. `kg*m^2`; `1` for a plain number.
    pub unit: &'static str,
    /// Default value \[SI\]; `None` if the scene must give one.
    pub default: Option<f64>,
    /// The only effect that uses the parameter, if there is one. Scenes without this effect need not give it.
    pub with: Option<&'static str>,
    /// Its role in the data of a gear, if it has one of these roles.
    pub gear_data: Option<GearData>,
    /// Whether it may vary in time.
    pub varies: Varies,
    /// Allowed values \[SI\].
    pub range: Range,
    /// A parameter that it must exceed.
    pub above: Option<&'static str>,
    /// What it is.
    pub doc: &'static str,
}

/// The role of a parameter in the data of a gear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GearData {
    /// A number of teeth.
    Teeth,
    /// A base radius \[m\].
    BaseRadius,
    /// A working pressure angle \[rad\].
    PressureAngle,
    /// The torsional stiffness \[N m/rad\] of the support of a gear.
    Support,
}

/// Whether a parameter may vary in time. This requires that the generalised forces are linear in it, and that energies and inertias do not
/// depend on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Varies {
    /// It may not.
    Never,
    /// Forces are linear in it, with factors that are the same in every state. Cells stay linear.
    AsLoad,
    /// Forces are linear in it, with factors that depend on the state. Example: the demand on a motor whose torque falls with its speed.
    /// Only numerical methods can compute the motion.
    WithState,
    /// Guards or losses of switches depend on the parameter too. Example: the capacity of a clutch. Only numerical methods can compute the
    /// motion.
    WithGuards,
}

impl Varies {
    /// Whether the parameter may vary.
    pub fn may(self) -> bool {
        self != Varies::Never
    }

    /// Whether cells are not linear if it varies, so that only numerical methods can compute the motion.
    pub fn by_steps(self) -> bool {
        matches!(self, Varies::WithState | Varies::WithGuards)
    }
}

/// An interval of allowed values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Lower end; may be `-inf`.
    pub low: f64,
    /// Upper end; may be `inf`.
    pub high: f64,
    /// Whether the lower end is allowed.
    pub low_included: bool,
    /// Whether the upper end is allowed.
    pub high_included: bool,
}

impl Range {
    /// Whether `x` is finite and lies in the interval.
    pub fn contains(&self, x: f64) -> bool {
        x.is_finite()
            && (if self.low_included { x >= self.low } else { x > self.low })
            && (if self.high_included { x <= self.high } else { x < self.high })
    }
}

impl Parameter {
    /// The allowed values \[SI\] as text, e.g. `(0, inf) and above r_p`.
    pub fn allowed(&self) -> String {
        self.range.to_string() + &self.above.map_or(String::new(), |lesser| format!(" and above {lesser}"))
    }
}

impl std::fmt::Display for Range {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let open = if self.low_included { '[' } else { '(' };
        let close = if self.high_included { ']' } else { ')' };
        write!(f, "{open}{}, {}{close}", self.low, self.high)
    }
}

/// A mesh stiffness, a transmission error or a friction law: a periodic function of the mesh phase. The period is one pitch; that of a
/// transmission error may be several pitches.
#[derive(Debug, Clone, Copy)]
pub struct Law {
    /// Name, e.g. `k`.
    pub name: &'static str,
    /// SI unit of its value, e.g. `N*m`.
    pub unit: &'static str,
    /// The coordinate on which it depends, e.g. `theta`.
    pub phase: &'static str,
    /// One pitch [unit of the phase].
    pub period: f64,
    /// Whether nothing else depends on the number of whole pitches in the phase. The engine then subtracts whole pitches and counts
    /// them, so that large angles do not lose digits.
    pub rolling: bool,
    /// Effects with which the phase does not roll, for example a torsional support of a rotating part. Each of them alone is sufficient.
    pub held: &'static [&'static str],
    /// The effect that activates it; without this effect it is zero. `None` for a stiffness, which is always active.
    pub with: Option<&'static str>,
    /// Its meaning for the mesh.
    pub role: Role,
    /// What it is.
    pub doc: &'static str,
}

/// The meaning of a law for its mesh. Of the tooth pairs in contact, pair i carries the share s_i of the force and touches at the distance
/// xi_i beyond the pitch point along the line of action.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Mesh stiffness, never negative.
    Stiffness,
    /// Transmission error, of any sign.
    Error,
    /// sum s_i sgn(xi_i), of any sign: the factor with which the friction force does work along the sliding at the pitch point.
    Side,
    /// sum s_i |xi_i|, never negative: the lever arm with which the friction force does work along the rolling angle of the gears.
    Arm,
}

impl Role {
    /// Whether it may be negative.
    pub fn has_sign(self) -> bool {
        matches!(self, Role::Error | Role::Side)
    }

    /// Whether it is a friction law.
    pub fn is_friction(self) -> bool {
        matches!(self, Role::Side | Role::Arm)
    }
}

/// A deflection with several modes, each with other equations. Examples: play, a clutch, dry friction.
#[derive(Debug, Clone, Copy)]
pub struct Switch {
    /// Name of the deflection, e.g. `over`.
    pub name: &'static str,
    /// SI unit, e.g. `m`.
    pub unit: &'static str,
    /// The effect that activates it.
    pub with: &'static str,
    /// The values of its symbols without the effect.
    pub neutral: &'static [f64],
    /// Its modes.
    pub modes: &'static [SwitchMode],
    /// What it is.
    pub doc: &'static str,
}

/// A mode of a switch.
#[derive(Debug, Clone, Copy)]
pub struct SwitchMode {
    /// Name, e.g. `upper`.
    pub name: &'static str,
    /// Whether its deflection is held by a reaction.
    pub held: bool,
    /// Whether a static equilibrium may be in this mode.
    pub rests: bool,
    /// What is counted when a run enters it from a mode that does not count the same, e.g. "flanks met".
    pub counts: Option<&'static str>,
}

impl SwitchMode {
    /// Whether an entry from the mode `before` is counted.
    pub fn counts_after(&self, before: &SwitchMode) -> bool {
        !self.held && self.counts.is_some() && self.counts != before.counts
    }
}

/// A rigid motion of the whole drivetrain, scaled by one number.
#[derive(Debug, Clone, Copy)]
pub struct RigidMotion {
    /// Key in `[start]`, e.g. `speed`.
    pub name: &'static str,
    /// SI unit, e.g. `rad/s`.
    pub unit: &'static str,
    /// What it is, e.g. "rotational speed of the driving gear".
    pub doc: &'static str,
}

/// An effect that a scene may activate.
#[derive(Debug, Clone, Copy)]
pub struct Effect {
    /// Name in a scene's `effects`.
    pub name: &'static str,
    /// If it is the effect at one part, the common name of these effects: `backlash` for `backlash_12`. A scene with the common name has
    /// the effect at all parts.
    pub of: Option<&'static str>,
    /// What it adds to the equations, or removes from them.
    pub doc: &'static str,
    /// Effects that must be active too.
    pub requires: &'static [&'static str],
    /// Effects that must not be active.
    pub excludes: &'static [&'static str],
    /// How laws switch in scenes with this effect; `None` if the effect does not change that.
    pub switching: Option<Switching>,
    /// Whether a deflection is a nonlinear function of the coordinates in scenes with this effect.
    pub bends: bool,
}

/// How a law switches between its levels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Switching {
    /// Never: the law is constant at its mid value.
    Never,
    /// When its phase passes a step, with the impulse that conserves energy.
    WithJump,
    /// When its phase passes a step, without the impulse (rigid kinematics).
    WithoutJump,
    /// When Omega0 t passes a step, independent of the motion.
    ByTime,
}

/// A quantity that a run can record: a force, a loss, a speed.
#[derive(Debug, Clone, Copy)]
pub struct Output {
    /// Name, e.g. `mesh_force_12`: that of its column.
    pub name: &'static str,
    /// SI unit, e.g. `N`.
    pub unit: &'static str,
    /// The effect without which it does not exist.
    pub with: Option<&'static str>,
    /// Whether it depends on a quantity that only the engine knows: a reaction, or the power of a torque.
    pub known: bool,
    /// What it is.
    pub doc: &'static str,
}

impl Output {
    /// Whether it is a dissipated power. The account of losses by cause has these outputs.
    pub fn is_loss(&self) -> bool {
        self.unit == "W" && !self.is_power()
    }

    /// Whether it is a power that passes through a part, or that of an external torque.
    pub fn is_power(&self) -> bool {
        self.unit == "W" && (self.name.starts_with("power_") || self.name.contains("_power"))
    }
}

/// An external torque whose work is recorded.
#[derive(Debug, Clone, Copy)]
pub struct Torque {
    /// Name, e.g. `drive`.
    pub name: &'static str,
    /// The effects that all of its terms need. If one of them is missing, the torque is absent.
    pub with: &'static [&'static str],
    /// What it is.
    pub doc: &'static str,
}
