//! The modes of M q'' + C q' + K q = 0 with C and K that need not be symmetric: friction of the flanks, motors and loads, linearised about
//! a steady motion. Eigenvalues of the companion matrix; shapes from the null space of lambda² M + lambda C + K.

use nalgebra::{Complex, DMatrix, DVector};

use super::energies::Forms;
use super::{CellModes, Parts, Vibration, vibration};
use crate::engine::modal::Matrices;
use crate::engine::mode::Mode;
use crate::tolerance::analysis::{EQUAL_EIGENVALUES, RIGID, RIGID_EIGENVALUE};

/// The modes of the `linearised` matrices of a cell with law values `k`; energies and the shares of laws and parts are those of the
/// `linear` part.
pub fn of(
    linear: &Matrices,
    linearised: &Matrices,
    k: &[f64],
    (laws, parts): (&[DMatrix<f64>], &Parts),
    watch: &dyn Fn(),
) -> CellModes {
    let pairs = pairs(linearised);
    let forms = Forms::of(laws, parts);
    let mut modes: Vec<_> = vec![];
    for (i, &(slow, fast)) in pairs.iter().enumerate() {
        watch();
        let before = pairs[..i].iter().filter(|(other, _)| (other - slow).norm() <= EQUAL_EIGENVALUES * slow.norm());
        let shape = shape(linearised, slow, before.count());
        let (sigma, omega2) = (-0.5 * (slow + fast).re, (slow * fast).re.max(0.0));
        let rate = slow.re.max(fast.re);
        let growth = if rate > EQUAL_EIGENVALUES * fast.norm() { rate } else { 0.0 };
        modes.push(Vibration { growth, ..vibration(&Mode::new(sigma, omega2), shape, linear, &forms) });
    }
    CellModes::new(k, parts, modes, true)
}

/// The eigenvalues in pairs: conjugates, of which the first has the positive imaginary part, or two real ones, of which the first is the
/// slower. Rigid motions come first, then the others by ascending frequency.
fn pairs(m: &Matrices) -> Vec<(Complex<f64>, Complex<f64>)> {
    let n = m.mass.nrows();
    // Scale the coordinates to unit masses and the time to the fastest mode: all entries then have similar sizes.
    let unit = m.mass.diagonal().map(|m| m.sqrt());
    let scaled = |a: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| unit[i] * a[(i, j)] / unit[j]);
    let [springs, dampers] = [&m.stiffness, &m.damping].map(|a| scaled(&(&m.mobility * a)));
    let rate = springs.norm().sqrt().max(dampers.norm());
    let rate = if rate > 0.0 { rate } else { 1.0 };
    let mut companion = DMatrix::zeros(2 * n, 2 * n);
    companion.view_mut((0, n), (n, n)).fill_diagonal(1.0);
    companion.view_mut((n, 0), (n, n)).copy_from(&(&springs * (-1.0 / (rate * rate))));
    companion.view_mut((n, n), (n, n)).copy_from(&(&dampers * (-1.0 / rate)));
    let mut values: Vec<Complex<f64>> = companion.complex_eigenvalues().iter().map(|z| z * rate).collect();
    values.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    // Each direction without a spring has one eigenvalue 0. Its other eigenvalue is that of its damper, or also 0.
    let singular = springs.singular_values();
    let rigid = singular.iter().filter(|s| **s <= RIGID * singular.amax()).count();
    let fastest = values.last().map_or(0.0, |z| z.norm());
    for (i, z) in values.iter_mut().enumerate() {
        if i < rigid || i < 2 * rigid && z.norm() <= RIGID_EIGENVALUE * fastest {
            *z = Complex::from(0.0);
        }
    }
    let is_real = |z: &Complex<f64>| z.im.abs() <= EQUAL_EIGENVALUES * z.norm();
    let real: Vec<_> = values.iter().copied().filter(is_real).map(|z| Complex::from(z.re)).collect();
    let conjugate = values.iter().copied().filter(|z| !is_real(z) && z.im > 0.0).map(|z| (z, z.conj()));
    let mut pairs: Vec<_> = real.chunks_exact(2).map(|pair| (pair[0], pair[1])).chain(conjugate).collect();
    pairs.sort_by(|a, b| (a.0 * a.1).re.total_cmp(&(b.0 * b.1).re));
    pairs
}

/// The mode shape of the eigenvalue `lambda`. If several eigenvalues are equal, `which` is its number among them.
fn shape(m: &Matrices, lambda: Complex<f64>, which: usize) -> DVector<Complex<f64>> {
    let n = m.mass.nrows();
    let unit = m.mass.diagonal().map(|m| 1.0 / m.sqrt());
    let pencil = DMatrix::from_fn(n, n, |i, j| {
        let at = (i, j);
        (lambda * lambda * m.mass[at] + lambda * m.damping[at] + m.stiffness[at]) * unit[i] * unit[j]
    });
    let svd = pencil.svd(false, true);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| svd.singular_values[a].total_cmp(&svd.singular_values[b]));
    let row = order[which.min(n - 1)];
    let right = svd.v_t.unwrap_or_else(|| DMatrix::identity(n, n));
    DVector::from_fn(n, |i, _| right[(row, i)].conj() * unit[i])
}
