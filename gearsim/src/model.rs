//! What a derived model says about itself: the half of a generated file that people and scenes read.
//!
//! The other half, the equations, is [`crate::engine::Equations`]. Both are written by the `equations!` macro
//! from the files under `generated/`; nothing here is typed by hand for a particular model.

/// A drivetrain model: what a scene can set, and what it can ask for.
#[derive(Debug, Clone, Copy)]
pub struct Model {
    /// Name in scenes and on the command line, e.g. `gear_pair`.
    pub name: &'static str,
    /// One line saying what it is.
    pub title: &'static str,
    /// Where it comes from: author, year, equations.
    pub source: &'static str,
    /// Generalised coordinates, in the order of every state vector.
    pub coordinates: &'static [Coordinate],
    /// Parameters, in the order of every parameter vector.
    pub parameters: &'static [Parameter],
    /// Laws that a scene fills in: mesh stiffnesses, and behind them transmission errors, and behind these friction.
    pub laws: &'static [Law],
    /// Rigid motions by which a scene may state its start: `speed = "300 rpm"`.
    pub motions: &'static [Motion],
    /// Effects that a scene may name; bit `i` of an effect set is entry `i`.
    pub effects: &'static [Effect],
    /// External torques, in the order in which their work is recorded.
    pub torques: &'static [Torque],
    /// Deflections with play, in the order of the law values behind those of the laws.
    pub dead_bands: &'static [DeadBand],
    /// The terms that make a cell nonlinear, with the energies they come from; empty where cells are linear.
    pub nonlinear: &'static str,
    /// Those that make it so with an effect: the effect, and the term.
    pub nonlinear_with: &'static [(&'static str, &'static str)],
    /// The derived equations as plain text, one a line.
    pub equations: &'static str,
    /// The derived equations in LaTeX, one a line.
    pub latex: &'static str,
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
    /// Where a scene that does not say otherwise starts it.
    pub start: Start,
}

/// Where a coordinate starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// At this value [SI unit of the coordinate].
    At(f64),
    /// Where the forces on it balance, the other coordinates given.
    Static,
    /// The same; of several such places that which is found from this value [SI unit of the coordinate].
    Near(f64),
}

impl Start {
    /// Whether it is where forces balance.
    pub fn is_static(self) -> bool {
        !matches!(self, Start::At(_))
    }

    /// Its value, or the one from which the balance is looked for.
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
    /// Value [SI] if a scene gives none; `None` if a scene must give one.
    pub default: Option<f64>,
    /// The effect that alone needs it: without a default, it must be given only by scenes that name this effect.
    pub with: Option<&'static str>,
    /// Whether a scene may let it vary in time: the generalised forces are linear in it, and nothing else depends on it.
    pub varies: bool,
    /// Admissible values [SI].
    pub range: Range,
    /// What it is.
    pub doc: &'static str,
}

/// An interval of admissible values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Lower end; may be `-inf`.
    pub low: f64,
    /// Upper end; may be `inf`.
    pub high: f64,
    /// Whether the lower end itself is admissible.
    pub low_included: bool,
    /// Whether the upper end itself is admissible.
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

impl std::fmt::Display for Range {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let open = if self.low_included { '[' } else { '(' };
        let close = if self.high_included { ']' } else { ')' };
        write!(f, "{open}{}, {}{close}", self.low, self.high)
    }
}

/// A mesh stiffness, a transmission error, or how a mesh rubs: it depends on the mesh phase, periodic with one tooth pitch; an
/// error also with several.
#[derive(Debug, Clone, Copy)]
pub struct Law {
    /// Name, e.g. `k`.
    pub name: &'static str,
    /// SI unit of its value, e.g. `N*m`.
    pub unit: &'static str,
    /// The coordinate that is its phase, e.g. `theta`.
    pub phase: &'static str,
    /// One pitch [unit of the phase].
    pub period: f64,
    /// Whether whole pitches of the phase change nothing else: then they are counted off, and cost no digits.
    pub rolling: bool,
    /// The effect without which it is zero; `None` for a stiffness.
    pub with: Option<&'static str>,
    /// What it says of the mesh.
    pub role: Role,
    /// What it is.
    pub doc: &'static str,
}

/// What a law says of its mesh. Of the pairs of teeth in contact, pair i bears the share s_i of the force, at the place xi_i along the
/// line of action from the pitch point on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Its stiffness, never negative.
    Stiffness,
    /// Its transmission error, of any sign.
    Error,
    /// sum s_i sgn(xi_i), of any sign: friction works over it as the flanks slide at the pitch point.
    Side,
    /// sum s_i |xi_i|, never negative: the arm of friction as the gears roll.
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

/// A deflection with play: a spring that is felt only beyond half the play to either side.
#[derive(Debug, Clone, Copy)]
pub struct DeadBand {
    /// Name of what is beyond the play, e.g. `over`.
    pub name: &'static str,
    /// Its SI unit, e.g. `m`.
    pub unit: &'static str,
    /// The effect without which there is none.
    pub with: &'static str,
    /// What it is.
    pub doc: &'static str,
}

impl Model {
    /// Law values with every dead band in contact at its drive flank and without play: those of the laws, 0 for those that
    /// `laws` leaves out, then four of each band (touch, edge, damp, clip).
    pub fn in_contact(&self, laws: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let laws = laws.into_iter().chain(std::iter::repeat(0.0)).take(self.laws.len());
        laws.chain(self.dead_bands.iter().flat_map(|_| [1.0, 0.0, 1.0, 0.0])).collect()
    }
}

/// A rigid motion of the whole train, scaled by one number.
#[derive(Debug, Clone, Copy)]
pub struct Motion {
    /// Key in `[start]`, e.g. `speed`.
    pub name: &'static str,
    /// SI unit, e.g. `rad/s`.
    pub unit: &'static str,
    /// What it is, e.g. "rotational speed of the driving gear".
    pub doc: &'static str,
}

/// An effect that a scene may name.
#[derive(Debug, Clone, Copy)]
pub struct Effect {
    /// Name in a scene's `effects`.
    pub name: &'static str,
    /// What it adds to the equations, or drops from them.
    pub doc: &'static str,
    /// Effects without which it makes no sense.
    pub requires: &'static [&'static str],
    /// Effects that contradict it.
    pub excludes: &'static [&'static str],
}

/// An external torque whose work is accounted for.
#[derive(Debug, Clone, Copy)]
pub struct Torque {
    /// Name, e.g. `drive`.
    pub name: &'static str,
    /// What it is.
    pub doc: &'static str,
}
