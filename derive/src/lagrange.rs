//! Euler-Lagrange: mass matrix, generalised forces, accelerations, Jacobian.
//!
//! d/dt dT/dq' - dT/dq + dV/dq + dD/dq' = Q becomes M q'' = F(q, q', k), with F_i = Q_i - dV/dq_i - dD/dq'_i - c_i. Where M depends on
//! the coordinates, c_i = sum_j d(dT/dq'_i)/dq_j q'_j - dT/dq_i are the centrifugal and gyroscopic forces; else they are zero. dV/dq_i
//! includes the derivative through the mesh stiffness, (dV/dk) (dk/ds) (ds/dq_i): the jump terms.

use symbolica::atom::{Atom, AtomCore, Symbol};

use crate::expr::{Expr, Kind, acceleration_name, number, symbol, total};
use crate::model::{JUMP_TERMS, Model, Torque, mobility_name, why_not};
use crate::slip::Slip;
use crate::symbols::{Sparse, Symbols};
use crate::trigonometry::simplified;

/// The equations of motion M q'' = F, and q'' itself where M was inverted.
pub(crate) struct EquationsOfMotion {
    /// Generalised external forces Q.
    pub external: Vec<Atom>,
    pub mass: Vec<Vec<Atom>>,
    /// Derivatives of M q'' (rows) by the coordinates (columns), linear in the accelerations; `None` if M is constant.
    pub inertia: Option<Vec<Vec<Atom>>>,
    /// F + c: the forces without the centrifugal and gyroscopic ones.
    pub applied: Vec<Atom>,
    pub force: Vec<Atom>,
    /// The constants of the model and their definitions, each in parameters, mid values and the constants before it.
    pub constants: Vec<(String, Atom)>,
    /// The inverse mass matrix of a model with one or two coordinates, written in the names of the constants.
    pub mobility: Option<Vec<Vec<Atom>>>,
    /// q'', if M is constant and was inverted.
    pub acceleration: Option<Vec<Atom>>,
}

/// The gradient including the derivatives through the phases of the laws; those terms carry `marker`.
pub(crate) fn gradient(s: &Symbols, e: &Atom, marker: &str) -> Sparse {
    let mut all = s.by_coordinates(e);
    all.extend(through_laws(s, e, marker));
    all
}

/// The derivatives by the coordinates through the phases of the laws; the terms carry `marker`.
pub(crate) fn through_laws(s: &Symbols, e: &Atom, marker: &str) -> Sparse {
    let mut all = vec![];
    let marker = Atom::var(symbol(Kind::Marker, marker));
    let values = s.by_laws(e).into_iter().map(|(l, by)| (l, by * Atom::var(s.slope[l])));
    let slopes = s.slopes(e).into_iter().map(|(l, by)| (l, by * Atom::var(s.curvature[l])));
    for (l, part) in values.chain(slopes).collect::<Vec<_>>() {
        let part = &marker * &s.gate[l] * part;
        all.extend(s.phase[l].iter().map(|(i, through)| (*i, &part * through)));
    }
    all
}

/// The displacement that a torque works through, without its value at q = 0. It is a linear form: with changes of the
/// coordinates in place of the coordinates it gives the change of the displacement.
pub(crate) fn displacement(s: &Symbols, torque: &Torque) -> Atom {
    let slopes = s.by_coordinates(&torque.through.atom());
    slopes.into_iter().fold(number(0), |sum, (i, slope)| sum + slope.expand() * Atom::var(s.q[i]))
}

/// Generalised forces Q of the torques that `which` selects.
pub(crate) fn external(model: &Model, s: &Symbols, which: impl Fn(&Torque) -> bool) -> Vec<Atom> {
    let torques = model.torques.iter().filter(|t| which(t));
    rows(
        s.q.len(),
        torques.flat_map(|t| {
            let value = t.value.atom();
            let slopes = match t.along {
                Some(speed) => s.by_speeds(&speed.atom()),
                None => s.by_coordinates(&t.through.atom()),
            };
            slopes.into_iter().map(move |(i, slope)| (i, &value * slope.expand()))
        }),
    )
}

/// The sums of the parts of each row, expanded.
pub(crate) fn rows(n: usize, parts: impl Iterator<Item = (usize, Atom)>) -> Vec<Atom> {
    let mut rows = vec![vec![]; n];
    parts.for_each(|(i, part)| rows[i].push(part));
    rows.into_iter().map(|parts| total(parts).expand()).collect()
}

/// The restoring forces dV/dq of the terms `potential` of V, and the dissipative forces of switches.
pub(crate) fn restoring<'a>(
    model: &'a Model,
    s: &'a Symbols,
    potential: &'a [Expr],
    gradient: impl Fn(&Atom) -> Sparse + 'a,
) -> impl Iterator<Item = (usize, Atom)> + 'a {
    let lost = model.switches.iter().filter(|switch| !switch.loss.atom().is_zero()).flat_map(|switch| {
        let x = s.deflections.iter().find(|d| d.symbol == symbol(Kind::Deflection, &switch.over));
        let force = switch.lost();
        x.into_iter().flat_map(|x| &x.slopes).map(|(i, slope)| (*i, &force * slope)).collect::<Sparse>()
    });
    potential.iter().flat_map(move |v| gradient(&v.atom())).chain(lost)
}

/// Second derivatives of a sum of energies: the sum of the Hessians of `pieces`, where `by` gives a gradient.
pub(crate) fn hessian(n: usize, pieces: &[Expr], by: impl Fn(&Atom) -> Sparse) -> Vec<Vec<Atom>> {
    let mut parts: Vec<Sparse> = vec![vec![]; n];
    for (i, slope) in pieces.iter().flat_map(|piece| by(&piece.atom())) {
        parts[i].extend(by(&slope));
    }
    parts.into_iter().map(|row| rows(n, row.into_iter())).collect()
}

/// The centrifugal and gyroscopic forces c of a term of T: c_i = sum_j d(dT/dq'_i)/dq_j q'_j - dT/dq_i.
fn inertial(s: &Symbols, t: &Atom) -> Sparse {
    let momenta = s.by_speeds(t).into_iter().flat_map(|(i, momentum)| {
        s.by_coordinates(&momentum).into_iter().map(move |(j, by)| (i, by * Atom::var(s.v[j])))
    });
    momenta.chain(s.by_coordinates(t).into_iter().map(|(i, by)| (i, -by))).collect()
}

/// The derivatives of M q'' by the coordinates; `None` if M is constant.
fn inertia(model: &Model, s: &Symbols, mass: &[Vec<Atom>]) -> Option<Vec<Vec<Atom>>> {
    let accelerations: Vec<Atom> =
        model.coordinates.iter().map(|c| Atom::var(symbol(Kind::Acceleration, &acceleration_name(&c.name)))).collect();
    let row = |row: &Vec<Atom>| {
        let parts = row
            .iter()
            .zip(&accelerations)
            .flat_map(|(entry, a)| s.by_coordinates(entry).into_iter().map(move |(j, by)| (j, by * a)));
        rows(s.q.len(), parts).iter().map(simplified).collect::<Vec<_>>()
    };
    let inertia: Vec<Vec<Atom>> = mass.iter().map(row).collect();
    inertia.iter().flatten().any(|entry| !entry.is_zero()).then_some(inertia)
}

/// Derives the equations of motion.
pub(crate) fn derive(model: &Model, s: &Symbols) -> Result<EquationsOfMotion, Slip> {
    let n = model.coordinates.len();
    let mut mass = hessian(n, &model.kinetic, |e| s.by_speeds(e));
    if model.inertia_moves() {
        mass.iter_mut().flatten().for_each(|m| *m = simplified(m));
    }
    let inertia = inertia(model, s, &mass);
    for (row, coordinate) in mass.iter().zip(&model.coordinates) {
        if row.iter().all(|m| m.is_zero()) {
            let coordinate = coordinate.name.clone();
            let why = why_not(model, &coordinate);
            return Err(Slip::Massless { model: model.name.clone(), coordinate, why });
        }
    }
    let external = external(model, s, |_| true);
    let elastic = restoring(model, s, &model.potential, |v| gradient(s, v, JUMP_TERMS));
    let damping = model.dissipation.iter().flat_map(|d| s.by_speeds(&d.atom()));
    let against = elastic.chain(damping).map(|(i, part)| (i, -part));
    let applied = rows(n, external.iter().cloned().enumerate().chain(against));
    let force = match inertia {
        Some(_) => {
            let inertial = model.kinetic.iter().flat_map(|t| inertial(s, &t.atom())).map(|(i, c)| (i, -c));
            let force = rows(n, applied.iter().cloned().enumerate().chain(inertial));
            force.iter().map(simplified).collect()
        }
        None => applied.clone(),
    };
    let (constants, mobility, acceleration) = (vec![], None, None);
    let mut motion = EquationsOfMotion { external, mass, inertia, applied, force, constants, mobility, acceleration };
    crate::mobility::name(model, &mut motion)?;
    let constant = motion.inertia.is_none();
    motion.acceleration = motion
        .mobility
        .as_ref()
        .filter(|_| constant)
        .map(|w| (0..n).map(|i| (0..n).fold(number(0), |a, j| a + &w[i][j] * &motion.force[j]).expand()).collect());
    Ok(motion)
}

/// The placeholder for an entry of the inverse mass matrix in the constants of a model.
pub(crate) fn mobility_symbol(i: usize, j: usize) -> Symbol {
    symbol(Kind::Mobility, &mobility_name(i, j))
}
