//! Published natural frequencies of torsional systems, and the energies and shapes of modes.
//!
//! Source: M. I. Friswell, J. E. T. Penny, S. D. Garvey & A. W. Lees, Dynamics of Rotating Machines, Cambridge 2010,
//! Chapter 9.

use gearsim::__private::linear::{self, Mass, Parts};
use gearsim::__private::{Inside, Matrices};
use gearsim::analysis::modes::CellModes;
use nalgebra::{DMatrix, DVector};

use crate::models::{DAMPERS, scene};

/// The modes of discs with these inertias, and shafts between two of them.
fn of(inertias: &[f64], shafts: &[(usize, usize, f64)]) -> CellModes {
    let n = inertias.len();
    let mut stiffness = DMatrix::zeros(n, n);
    for &(i, j, k) in shafts {
        stiffness[(i, i)] += k;
        stiffness[(j, j)] += k;
        stiffness[(i, j)] -= k;
        stiffness[(j, i)] -= k;
    }
    let diagonal = DVector::from_column_slice(inertias);
    let disc = |i: usize| {
        let inertia = DMatrix::from_fn(n, n, |a, b| if (a, b) == (i, i) { inertias[i] } else { 0.0 });
        Mass { name: "disc", sense: inertia.column(i).into_owned(), inertia, pieces: vec![] }
    };
    let parts = Parts { masses: (0..n).map(disc).collect(), springs: vec![] };
    let matrices = Matrices {
        mass: DMatrix::from_diagonal(&diagonal),
        mobility: DMatrix::from_diagonal(&diagonal.map(|j| 1.0 / j)),
        damping: DMatrix::zeros(n, n),
        stiffness,
        load: DVector::zeros(n),
    };
    linear::modes_of(&matrices, &parts).expect("discs on shafts have modes")
}

/// Checks frequencies against their printed values, to half a unit in the last digit.
fn assert_frequencies(found: &CellModes, printed: &[&str]) {
    assert_eq!(found.modes.len(), printed.len());
    for (mode, printed) in found.modes.iter().zip(printed) {
        let decimals = printed.split_once('.').map_or(0, |(_, digits)| digits.len());
        assert_eq!(format!("{:.decimals$}", mode.natural), *printed);
    }
}

#[test]
fn frequencies_of_two_discs_on_a_shaft_are_those_published() {
    assert_frequencies(&of(&[211.4, 8.3], &[(0, 1, 9.775e6)]), &["0", "176.1"]);
}

#[test]
fn frequencies_of_five_discs_are_those_of_example_9_7_1() {
    let shafts = [(0, 1, 12e3), (1, 2, 12e3), (2, 3, 14e3), (3, 4, 10e3)];
    let found = of(&[3.5e-3, 3.5e-3, 3.5e-3, 0.15, 0.05], &shafts);
    assert_frequencies(&found, &["0", "81.21", "141.21", "378.95", "536.36"]);
    for mode in &found.modes {
        let kinetic: f64 = mode.kinetic.iter().sum();
        assert!((kinetic - 1.0).abs() < 1e-14, "shares of the kinetic energy add up to {kinetic}");
    }
}

/// Gear B meshes rigidly with gear A, 1:1, so both have one coordinate; three shafts start there.
#[test]
fn frequencies_of_three_branches_at_a_gear_pair_are_those_published() {
    let shafts = [(0, 1, 1e4), (1, 2, 5e3), (1, 3, 5e3)];
    assert_frequencies(&of(&[400e-6, 50e-6, 700e-6, 700e-6], &shafts), &["0", "425.4", "634.1", "3247.2"]);
}

/// Where damping couples the modes, each eigenvalue and mode shape satisfy (lambda² M + lambda C + K) phi = 0. The strain energies that a
/// mode reports for the law and for the other spring are those of its shape.
#[test]
fn damped_modes_are_eigenvectors_of_the_quadratic_pencil() {
    use nalgebra::Complex;
    let scene = scene("parameters = { c1 = \"0.4 N*m*s\", c2 = \"0.3 N*m*s\" }\nrun.t_end = \"1 s\"");
    let system = DAMPERS.system(&scene).expect("a linear model");
    let parts = linear::parts(&scene, &DAMPERS, &system).expect("it has springs");
    let cell = linear::modes(&system, &[5.0], &parts).expect("it has modes");
    assert!(cell.coupled);
    let m = system.matrices(&[5.0]).expect("matrices");
    let mut oscillating = 0;
    for mode in cell.modes.iter().filter(|mode| mode.damped > 0.0) {
        oscillating += 1;
        let omega = std::f64::consts::TAU * mode.natural;
        let zeta = mode.zeta.expect("not rigid");
        let lambda = Complex::new(-zeta * omega, std::f64::consts::TAU * mode.damped);
        let complex = |a: &DMatrix<f64>| a.map(Complex::from);
        let phi = DVector::from_vec(mode.shape.clone());
        let pencil = complex(&m.mass) * (lambda * lambda) + complex(&m.damping) * lambda + complex(&m.stiffness);
        let left = (pencil * &phi).map(|z| z.norm()).amax();
        // The three products have the size K |phi| = 50.
        assert!(left < 1e-13 * 50.0, "{left:e}");
        let (second, third) = (mode.shape[1].norm_sqr() * 5.0, (mode.shape[2] - mode.shape[1]).norm_sqr() * 20.0);
        assert!((mode.strain[0] - second / (second + third)).abs() < 1e-13);
        assert_eq!(mode.springs.len(), 1);
        assert!((mode.springs[0] - third / (second + third)).abs() < 1e-13);
    }
    assert_eq!(oscillating, 2);
}
