//! Euler-Lagrange: mass matrix, generalised forces, accelerations, Jacobian.
//!
//! d/dt dT/dq' + dV/dq + dD/dq' = Q becomes M q'' = F(q, q', k), with F_i = Q_i - dV/dq_i - dD/dq'_i. T depends on speeds only
//! (`check` refuses other models). dV/dq_i includes the derivative through the mesh stiffness, (dV/dk) (dk/ds) (ds/dq_i): the
//! jump terms.

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Expr, Kind, number, symbol, total};
use crate::model::{JUMP_TERMS, Model, Torque, mobility_name};
use crate::slip::Slip;
use crate::symbols::{Sparse, Symbols};

/// The equations of motion M q'' = F, and q'' itself where M was inverted.
pub(crate) struct Motion {
    /// Generalised external forces Q.
    pub external: Vec<Atom>,
    pub mass: Vec<Vec<Atom>>,
    pub force: Vec<Atom>,
    /// The constants of the model and their definitions, each in parameters, mid values and the constants before it.
    pub constants: Vec<(String, Atom)>,
    /// The inverse mass matrix of a model with one or two coordinates, written in the names of the constants.
    pub mobility: Option<Vec<Vec<Atom>>>,
    /// q'', if M was inverted.
    pub acceleration: Option<Vec<Atom>>,
}

/// The gradient including the derivatives through the phases of the laws; those terms carry `marker`.
pub(crate) fn gradient(s: &Symbols, e: &Atom, marker: &str) -> Sparse {
    let mut all = s.by_coordinates(e);
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
            s.by_coordinates(&t.through.atom()).into_iter().map(move |(i, slope)| (i, &value * slope.expand()))
        }),
    )
}

/// The sums of the parts of each row, expanded.
pub(crate) fn rows(n: usize, parts: impl Iterator<Item = (usize, Atom)>) -> Vec<Atom> {
    let mut rows = vec![vec![]; n];
    parts.for_each(|(i, part)| rows[i].push(part));
    rows.into_iter().map(|parts| total(parts).expand()).collect()
}

/// The restoring forces dV/dq of the potential energies, and the forces of switches whose work is lost.
pub(crate) fn restoring<'a>(
    model: &'a Model,
    s: &'a Symbols,
    gradient: impl Fn(&Atom) -> Sparse + 'a,
) -> impl Iterator<Item = (usize, Atom)> + 'a {
    let lost = model.switches.iter().filter(|switch| !switch.loss.atom().is_zero()).flat_map(|switch| {
        let x = s.deflections.iter().find(|d| d.symbol == symbol(Kind::Deflection, &switch.over));
        let force = switch.lost();
        x.into_iter().flat_map(|x| &x.slopes).map(|(i, slope)| (*i, &force * slope)).collect::<Sparse>()
    });
    model.potential.iter().flat_map(move |v| gradient(&v.atom())).chain(lost)
}

/// Second derivatives of a sum of energies: the sum of the Hessians of `pieces`, where `by` gives a gradient.
pub(crate) fn hessian(n: usize, pieces: &[Expr], by: impl Fn(&Atom) -> Sparse) -> Vec<Vec<Atom>> {
    let mut parts: Vec<Sparse> = vec![vec![]; n];
    for (i, slope) in pieces.iter().flat_map(|piece| by(&piece.atom())) {
        parts[i].extend(by(&slope));
    }
    parts.into_iter().map(|row| rows(n, row.into_iter())).collect()
}

/// Derives the equations of motion.
pub(crate) fn derive(model: &Model, s: &Symbols) -> Result<Motion, Slip> {
    let n = model.coordinates.len();
    let mass = hessian(n, &model.kinetic, |e| s.by_speeds(e));
    for (row, coordinate) in mass.iter().zip(&model.coordinates) {
        if row.iter().all(|m| m.is_zero()) {
            let coordinate = coordinate.name.clone();
            return Err(Slip::Massless { model: model.name.clone(), coordinate });
        }
    }
    let external = external(model, s, |_| true);
    let elastic = restoring(model, s, |v| gradient(s, v, JUMP_TERMS));
    let damping = model.dissipation.iter().flat_map(|d| s.by_speeds(&d.atom()));
    let against = elastic.chain(damping).map(|(i, part)| (i, -part));
    let force = rows(n, external.iter().cloned().enumerate().chain(against));
    let mut motion = Motion { external, mass, force, constants: vec![], mobility: None, acceleration: None };
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
