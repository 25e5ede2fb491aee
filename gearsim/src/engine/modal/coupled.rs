//! Modes coupled by damping: xi'' + G xi' + Omega² xi = g, in the modes of the undamped system. G is symmetric and full.
//!
//! Two eigenvalues, complex conjugates or both real, form one real [`Mode`] with s = 2 sigma = -(lambda1 + lambda2) and b =
//! omega² = lambda1 lambda2. With a'' + s a' + b a = const,
//!
//! ```text
//! xi' = sum X1 a' + X2 a''
//! (Omega² - b) X1 = b (G - s) X2,   (Omega² - b) X2 + (G - s)(X1 - s X2) = 0
//! ```
//!
//! This form stays regular where the two eigenvalues coincide, at critical damping. Modes that are not coupled have X1 = 1, X2 =
//! 0.
//!
//! The modal amplitudes of a motion follow from biorthogonality. Z_k = [X1, X2; -b X2, X1 - s X2] are invariant subspaces of B z'
//! = A z with z = (xi', xi'') and B = [G, 1; 1, 0]. They are B-orthogonal to one another (P. Lancaster, Lambda-matrices and
//! Vibrating Systems, 1966). B z = (F, xi') with F = g - Omega² xi.

use nalgebra::{DMatrix, DVector};

use super::pairs::{Nearness, Pair, eigenpairs};
use super::{refine, subspace};
use crate::engine::error::Refusal;
use crate::engine::mode::Mode;
use crate::tolerance::modes::{BIORTHOGONAL, CONDITION, MISSED};

/// The modes of a damped system in the modes of the undamped one (n x n each). Each mode is a column of X1 and X2, and a row of
/// the other matrices.
#[derive(Debug, Clone)]
pub struct Coupled {
    /// The modes, in order of rising frequency.
    pub modes: Vec<Mode>,
    /// X1: coefficients of a' in xi'.
    pub by_speed: DMatrix<f64>,
    /// X2: coefficients of a'' in xi' [s].
    pub by_acceleration: DMatrix<f64>,
    /// Matrices (A, B) with a' = A xi' + B F.
    pub speed: [DMatrix<f64>; 2],
    /// Matrices (A, B) with a'' + s a' = A xi' + B F.
    pub force: [DMatrix<f64>; 2],
    /// G.
    pub damping: DMatrix<f64>,
    /// Condition number of the modes [1]: a mode can be this much larger than the motion.
    pub condition: f64,
}

impl Coupled {
    /// The modes of xi'' + G xi' + diag(omega2) xi = g. `watch` is called for each pair of eigenvalues.
    ///
    /// The error of an eigenvalue is a few eps times this eigenvalue, or in the worst case times the fastest one. Therefore it is not known
    /// beforehand which pairs are equal. Modes that represent every motion ([`verify`]) are correct, whichever pairs were taken for equal.
    ///
    /// # Errors
    /// If a pair of complex eigenvalues is defective, the modes are not found, or damping adds energy.
    pub fn of(omega2: &[f64], damping: &DMatrix<f64>, watch: &dyn Fn()) -> Result<Coupled, Refusal> {
        let narrow = Coupled::with(omega2, damping, Nearness::NARROW, watch);
        let wider = |nearness| Coupled::with(omega2, damping, nearness, watch).ok();
        narrow.or_else(|refusal| Nearness::WIDER.into_iter().find_map(wider).ok_or(refusal))
    }

    /// The modes, where pairs of eigenvalues within `nearness` of one another are taken for equal.
    fn with(omega2: &[f64], damping: &DMatrix<f64>, nearness: Nearness, watch: &dyn Fn()) -> Result<Coupled, Refusal> {
        let n = omega2.len();
        let mut pairs: Vec<Pair> = vec![];
        for group in groups(damping) {
            let clusters = pairs.iter().map(|p| p.cluster + 1).max().unwrap_or(0);
            let (w, g) = (subspace::pick(omega2, &group), subspace::block(damping, &group));
            for pair in solve(&w, &g, nearness, watch)? {
                let whole = |x: &DVector<f64>| {
                    let mut all = DVector::zeros(n);
                    group.iter().zip(x.iter()).for_each(|(&i, x)| all[i] = *x);
                    all
                };
                pairs.push(Pair { x1: whole(&pair.x1), x2: whole(&pair.x2), cluster: clusters + pair.cluster, ..pair });
            }
        }
        pairs.sort_by(|p, q| (p.b, p.s).partial_cmp(&(q.b, q.s)).unwrap_or(std::cmp::Ordering::Equal));
        if let Some(fed) = pairs.iter().find(|p| p.s < 0.0 || p.b < 0.0) {
            return Err(Refusal::Feeding { rate: -0.5 * fed.s });
        }
        let (functionals, condition) = functionals(omega2, damping, &pairs)?;
        let by = |f: &dyn Fn(usize, usize) -> f64| DMatrix::from_fn(n, n, f);
        let rows = |r: usize, of: usize| by(&|k, i| functionals[(2 * k + r, of * n + i)]);
        let force = |of: usize| {
            by(&|k, i| functionals[(2 * k + 1, of * n + i)] + pairs[k].s * functionals[(2 * k, of * n + i)])
        };
        Ok(Coupled {
            modes: pairs.iter().map(|p| Mode::new(0.5 * p.s, p.b)).collect(),
            by_speed: by(&|i, k| pairs[k].x1[i]),
            by_acceleration: by(&|i, k| pairs[k].x2[i]),
            speed: [rows(0, 0), rows(0, 1)],
            force: [force(0), force(1)],
            damping: damping.clone(),
            condition,
        })
    }
}

/// The sets of modes that damping couples with one another.
fn groups(damping: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let n = damping.nrows();
    let mut seen = vec![false; n];
    let mut groups = vec![];
    for first in 0..n {
        if seen[first] {
            continue;
        }
        seen[first] = true;
        let (mut group, mut next) = (vec![first], 0);
        while next < group.len() {
            let i = group[next];
            next += 1;
            for j in (0..n).filter(|&j| damping[(i, j)] != 0.0) {
                if !std::mem::replace(&mut seen[j], true) {
                    group.push(j);
                }
            }
        }
        group.sort_unstable();
        groups.push(group);
    }
    groups
}

/// The pairs of eigenvalues of one set.
fn solve(omega2: &[f64], g: &DMatrix<f64>, nearness: Nearness, watch: &dyn Fn()) -> Result<Vec<Pair>, Refusal> {
    if let [omega2] = omega2 {
        let (x1, x2) = (DVector::from_element(1, 1.0), DVector::zeros(1));
        return Ok(vec![Pair { x1, x2, s: g[(0, 0)], b: *omega2, cluster: 0 }]);
    }
    let mut pairs = vec![];
    let mut rigid = (0..omega2.len()).filter(|&i| omega2[i] == 0.0);
    for (cluster, values) in eigenpairs(omega2, g, nearness)?.into_iter().enumerate() {
        watch();
        let of_rigid = values[0].1 == 0.0;
        let starts = match of_rigid {
            true => subspace::of_rigid(omega2, g, &values, &mut rigid)?,
            false => subspace::of(omega2, g, &values)?,
        };
        let cluster = if of_rigid { 0 } else { cluster + 1 };
        let equal = starts.len();
        pairs.extend(starts.into_iter().map(|start| Pair { cluster, ..refine::newton(omega2, g, equal, start) }));
    }
    Ok(pairs)
}

/// Two results. The matrix (2n x 2n) gives a' and a'' of each pair of eigenvalues from (xi', F). The number is the condition number of the
/// modes.
fn functionals(omega2: &[f64], g: &DMatrix<f64>, pairs: &[Pair]) -> Result<(DMatrix<f64>, f64), Refusal> {
    let n = omega2.len();
    // Z as (xi', F) and as (xi', xi''). The first is B times the second, with its halves exchanged.
    let (mut forces, mut rates) = (DMatrix::zeros(2 * n, 2 * n), DMatrix::zeros(2 * n, 2 * n));
    for (k, p) in pairs.iter().enumerate() {
        let (x1, x2) = (&p.x1, &p.x2);
        for (r, (speed, acceleration)) in [(x1.clone(), x2 * -p.b), (x2.clone(), x1 - x2 * p.s)].into_iter().enumerate()
        {
            forces.view_mut((0, 2 * k + r), (n, 1)).copy_from(&speed);
            forces.view_mut((n, 2 * k + r), (n, 1)).copy_from(&(g * &speed + &acceleration));
            rates.view_mut((0, 2 * k + r), (n, 1)).copy_from(&acceleration);
            rates.view_mut((n, 2 * k + r), (n, 1)).copy_from(&speed);
        }
    }
    // Zᵀ B z = (xi''ᵀ, xi'ᵀ)(xi', F). Pairs are orthogonal except within one cluster, whose Gram matrix is inverted.
    let products = rates.transpose() * &forces;
    let gram = DMatrix::from_fn(2 * n, 2 * n, |i, j| {
        if pairs[i / 2].cluster == pairs[j / 2].cluster { products[(i, j)] } else { 0.0 }
    });
    let rows = gram.lu().solve(&rates.transpose()).ok_or(Refusal::Defective { condition: f64::INFINITY })?;
    let units: Vec<f64> =
        (0..n).map(|i| omega2[i].sqrt().max(g[(i, i)])).map(|u| if u > 0.0 { u } else { 1.0 }).collect();
    let rows = biorthogonal(&rows, &forces)?;
    let condition = verify(&units, &rows, &forces)?;
    Ok((rows, condition))
}

/// The rows W with W Z = 1, from `rows`, where the products of pairs with nearly equal eigenvalues are not yet zero; `columns` is Z.
fn biorthogonal(rows: &DMatrix<f64>, columns: &DMatrix<f64>) -> Result<DMatrix<f64>, Refusal> {
    let size = rows.nrows();
    let noise = BIORTHOGONAL * (rows.abs() * columns.abs());
    let product = rows * columns;
    let between = DMatrix::from_fn(size, size, |i, j| {
        let excess = product[(i, j)] - f64::from(u8::from(i == j));
        if excess.abs() <= noise[(i, j)] { 0.0 } else { excess }
    });
    if between.amax() == 0.0 {
        return Ok(rows.clone());
    }
    let whole = DMatrix::identity(size, size) + between;
    whole.lu().solve(rows).ok_or(Refusal::Defective { condition: f64::INFINITY })
}

/// The condition number of the modes: a mode can be this much larger than the motion. It is the largest diagonal entry of
/// sum_k |Z_k| |W_k|, which does not depend on the scaling of coordinates or modes.
///
/// # Errors
/// If the modes cannot represent every motion, or if the condition number exceeds [`CONDITION`].
fn verify(units: &[f64], rows: &DMatrix<f64>, columns: &DMatrix<f64>) -> Result<f64, Refusal> {
    let n = units.len();
    let parts = |i: usize| columns.row(i).iter().zip(rows.column(i).iter()).map(|(z, w)| (z * w).abs()).sum::<f64>();
    let condition = (0..2 * n).map(parts).fold(0.0, |worst, x| if x.is_nan() || x > worst { x } else { worst });
    // Units of the rows: 1 for speeds, and the rate of its mode for a force.
    let unit = |i: usize| if i < n { 1.0 } else { units[i - n] };
    let whole = columns * rows;
    let missed =
        DMatrix::from_fn(2 * n, 2 * n, |i, j| (whole[(i, j)] - f64::from(u8::from(i == j))) * unit(j) / unit(i));
    let missed = missed.iter().fold(0.0, |worst: f64, x| if x.is_nan() { f64::INFINITY } else { worst.max(x.abs()) });
    match condition <= CONDITION {
        true if missed <= MISSED => Ok(condition),
        true => Err(Refusal::ModesMissed { missed }),
        false => Err(Refusal::Defective { condition }),
    }
}
