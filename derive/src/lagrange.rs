//! Euler-Lagrange: mass matrix, generalised forces, accelerations, Jacobian.
//!
//! d/dt dT/dq' - dT/dq + dV/dq + dD/dq' = Q becomes M(q) q'' = F(q, q', k), with
//! F_i = Q_i - dV/dq_i - dD/dq'_i + dT/dq_i - sum_j (d²T/dq'_i dq_j) q'_j. Here dV/dq_i includes the derivative through the
//! mesh stiffness, (dV/dk) (dk/ds) (ds/dq_i): the jump terms.

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Expr, Kind, number, speed_name, symbol};
use crate::model::{DeadBand, Deflection, JUMP_TERMS, Model, Torque, mobility_name};
use crate::slip::Slip;

/// The symbols of one model; entry i belongs to coordinate i, or law i.
pub(crate) struct Symbols {
    pub q: Vec<Symbol>,
    pub v: Vec<Symbol>,
    pub law: Vec<Symbol>,
    /// The marker of the effect without which the law is zero; 1 for a stiffness.
    pub gate: Vec<Atom>,
    pub slope: Vec<Symbol>,
    pub curvature: Vec<Symbol>,
    pub deflections: Vec<Linear>,
}

/// A named deflection, delta = sum_i slope_i q_i + rest, and its rate, delta' = sum_i slope_i q'_i.
pub(crate) struct Linear {
    pub symbol: Symbol,
    pub rate_symbol: Symbol,
    /// Its nonzero derivatives by coordinates: coordinate and derivative.
    pub slopes: Vec<(usize, Atom)>,
    /// Its value at q = 0: minus the edge of a dead band, minus transmission errors.
    pub rest: Atom,
    /// Its nonzero derivatives by laws: law and derivative.
    by_law: Vec<(usize, Atom)>,
    /// For a dead band: the symbol `clip` of its damper times the marker of its effect.
    pub clip: Option<Atom>,
}

impl Linear {
    /// The deflection, written in the coordinates `q`.
    pub fn of(&self, q: &[Symbol]) -> Atom {
        self.rate(q) + &self.rest
    }

    /// Its rate, written in the speeds `v`.
    pub fn rate(&self, v: &[Symbol]) -> Atom {
        self.slopes.iter().fold(number(0), |sum, (i, slope)| sum + slope * Atom::var(v[*i]))
    }

    fn along(&self, i: usize) -> Option<&Atom> {
        self.slopes.iter().find(|s| s.0 == i).map(|s| &s.1)
    }

    fn along_law(&self, l: usize) -> Option<&Atom> {
        self.by_law.iter().find(|s| s.0 == l).map(|s| &s.1)
    }
}

impl Symbols {
    pub fn new(model: &Model) -> Self {
        let laws =
            |kind, prefix: &str| model.laws.iter().map(|l| symbol(kind, &format!("{prefix}{}", l.name))).collect();
        let q: Vec<Symbol> = model.coordinates.iter().map(|c| symbol(Kind::Coordinate, &c.name)).collect();
        let law: Vec<Symbol> = model.laws.iter().map(|l| symbol(l.kind(), &l.name)).collect();
        let gate =
            |with: &Option<String>| with.as_ref().map_or(number(1), |effect| Atom::var(symbol(Kind::Marker, effect)));
        let linear = |d: &Deflection| {
            let band: Option<&DeadBand> = model.dead_bands.iter().find(|band| band.over == d.name);
            let value = d.value.atom();
            let slopes = q.iter().map(|q| value.derivative(*q).expand()).enumerate();
            let by_law = law.iter().map(|law| value.derivative(*law).expand()).enumerate();
            let at_rest = |e: Atom, q: &Symbol| e.replace(Atom::var(*q).to_pattern()).with(number(0).to_pattern());
            Linear {
                symbol: symbol(Kind::Deflection, &d.name),
                rate_symbol: symbol(Kind::Rate, &speed_name(&d.name)),
                slopes: slopes.filter(|s| !s.1.is_zero()).collect(),
                rest: q.iter().fold(value.clone(), at_rest).expand(),
                by_law: by_law.filter(|s| !s.1.is_zero()).collect(),
                clip: band.map(|band| {
                    Atom::var(symbol(Kind::Marker, &band.effect)) * Atom::var(symbol(Kind::Clip, &band.clip))
                }),
            }
        };
        Symbols {
            deflections: model.deflections.iter().map(linear).collect(),
            q: q.clone(),
            v: model.speeds().iter().map(|s| symbol(Kind::Speed, s)).collect(),
            law: law.clone(),
            gate: model.laws.iter().map(|l| gate(&l.with)).collect(),
            slope: laws(Kind::Slope, "d"),
            curvature: laws(Kind::Curvature, "dd"),
        }
    }

    /// de/dq_i, including the derivative through deflections, with the laws held constant.
    pub fn by_coordinate(&self, e: &Atom, i: usize) -> Atom {
        let through = self.deflections.iter().filter_map(|d| Some(d.along(i)? * e.derivative(d.symbol)));
        through.fold(e.derivative(self.q[i]), |sum, part| sum + part)
    }

    /// de/dk for law `l`, including the derivative through deflections.
    pub fn by_law(&self, e: &Atom, l: usize) -> Atom {
        let through = self.deflections.iter().filter_map(|d| Some(d.along_law(l)? * e.derivative(d.symbol)));
        through.fold(e.derivative(self.law[l]), |sum, part| sum + part)
    }

    /// The expression after law `l` has stepped by an amount written as the symbol of its slope, including the step of
    /// deflections.
    pub fn stepped(&self, e: &Atom, l: usize) -> Atom {
        let step = Atom::var(self.slope[l]);
        let shift = |e: Atom, symbol: Symbol, by: Atom| {
            let symbol = Atom::var(symbol);
            e.replace(symbol.to_pattern()).with((&symbol + by).to_pattern())
        };
        self.deflections.iter().fold(shift(e.clone(), self.law[l], step.clone()), |e, d| match d.along_law(l) {
            Some(slope) => shift(e, d.symbol, slope * &step),
            None => e,
        })
    }

    /// The sum of the clipped damper forces of dead bands in row i, to be added to the restoring force dV/dq_i.
    pub fn clipped(&self, potential: &Atom, i: usize) -> Atom {
        let clipped = |d: &Linear| Some(d.clip.as_ref()? * potential.derivative(d.symbol) * d.along(i)?);
        self.deflections.iter().filter_map(clipped).fold(number(0), |sum, part| sum + part)
    }

    /// de/dq'_i, including the derivative through the rates of deflections.
    pub fn by_speed(&self, e: &Atom, i: usize) -> Atom {
        let through = self.deflections.iter().filter_map(|d| Some(d.along(i)? * e.derivative(d.rate_symbol)));
        through.fold(e.derivative(self.v[i]), |sum, part| sum + part)
    }
}

/// The equations of motion M q'' = F, and q'' itself where M was inverted.
pub(crate) struct Motion {
    pub kinetic: Atom,
    pub potential: Atom,
    pub dissipation: Atom,
    /// Generalised external forces Q.
    pub external: Vec<Atom>,
    pub mass: Vec<Vec<Atom>>,
    pub force: Vec<Atom>,
    /// The constants of the model and their definitions, each in parameters, mid values and the constants before it.
    pub constants: Vec<(String, Atom)>,
    /// The inverse mass matrix of a model with one or two coordinates, written in the names of the constants.
    pub mobility: Option<Vec<Vec<Atom>>>,
    /// The same, written in parameters, for the proofs.
    pub mobility_exact: Option<Vec<Vec<Atom>>>,
    /// q'', if M was inverted.
    pub acceleration: Option<Vec<Atom>>,
}

pub(crate) fn sum(pieces: &[Expr]) -> Atom {
    pieces.iter().fold(number(0), |sum, piece| sum + piece.atom())
}

/// de/dq_i including the derivative through the phases of the laws; those terms carry `marker`.
pub(crate) fn gradient(model: &Model, s: &Symbols, e: &Atom, i: usize, marker: &str) -> Atom {
    let mut g = s.by_coordinate(e, i);
    for (l, law) in model.laws.iter().enumerate() {
        let through = law.phase.atom().derivative(s.q[i]);
        if !through.is_zero() {
            let marker = Atom::var(symbol(Kind::Marker, marker)) * &s.gate[l];
            g += marker
                * (s.by_law(e, l) * Atom::var(s.slope[l]) + e.derivative(s.slope[l]) * Atom::var(s.curvature[l]))
                * through;
        }
    }
    g
}

/// The displacement that a torque works through, without its value at q = 0. It is a linear form: with changes of the
/// coordinates in place of the coordinates it gives the change of the displacement.
pub(crate) fn displacement(s: &Symbols, torque: &Torque) -> Atom {
    let through = torque.through.atom();
    (0..s.q.len()).fold(number(0), |sum, i| sum + s.by_coordinate(&through, i).expand() * Atom::var(s.q[i]))
}

/// Generalised forces Q of the torques that `which` selects.
pub(crate) fn external(model: &Model, s: &Symbols, which: impl Fn(&Torque) -> bool) -> Vec<Atom> {
    let along = |i: usize| {
        let torques = model.torques.iter().filter(|t| which(t));
        let force = |t: &Torque| t.value.atom() * s.by_coordinate(&t.through.atom(), i).expand();
        torques.fold(number(0), |sum, t| sum + force(t)).expand()
    };
    (0..s.q.len()).map(along).collect()
}

/// Derives the equations of motion.
pub(crate) fn derive(model: &Model, s: &Symbols) -> Result<Motion, Slip> {
    let n = model.coordinates.len();
    let (kinetic, potential, dissipation) = (sum(&model.kinetic), sum(&model.potential), sum(&model.dissipation));
    let momentum: Vec<Atom> = s.v.iter().map(|v| kinetic.derivative(*v)).collect();
    let mass: Vec<Vec<Atom>> =
        (0..n).map(|i| (0..n).map(|j| momentum[i].derivative(s.v[j]).expand()).collect()).collect();
    for (row, coordinate) in mass.iter().zip(&model.coordinates) {
        if row.iter().all(|m| m.is_zero()) {
            let coordinate = coordinate.name.clone();
            return Err(Slip::Massless { model: model.name.clone(), coordinate });
        }
    }
    let external = external(model, s, |_| true);
    let force: Vec<Atom> = (0..n)
        .map(|i| {
            let carried = (0..n).fold(number(0), |c, j| c + momentum[i].derivative(s.q[j]) * Atom::var(s.v[j]));
            let elastic = gradient(model, s, &potential, i, JUMP_TERMS) + s.clipped(&potential, i);
            (&external[i] - elastic - s.by_speed(&dissipation, i) + kinetic.derivative(s.q[i]) - carried).expand()
        })
        .collect();
    let mut motion = Motion {
        kinetic,
        potential,
        dissipation,
        external,
        mass,
        force,
        constants: vec![],
        mobility: None,
        mobility_exact: None,
        acceleration: None,
    };
    crate::mobility::name(model, &mut motion)?;
    motion.acceleration = motion
        .mobility
        .as_ref()
        .map(|w| (0..n).map(|i| (0..n).fold(number(0), |a, j| a + &w[i][j] * &motion.force[j]).expand()).collect());
    Ok(motion)
}

/// The placeholder for an entry of the inverse mass matrix in the constants of a model.
pub(crate) fn mobility_symbol(i: usize, j: usize) -> Atom {
    Atom::var(symbol(Kind::Mobility, &mobility_name(i, j)))
}
