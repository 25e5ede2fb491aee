//! M⁻¹ at random points, compared with M1 and M2 by hand, and multiplied by M. At these points the inertias referred to the mesh
//! differ by many decades.

use gearsim::__private::Matrix;
use gearsim::__private::equations::mobility;

use crate::TOLERANCE;
use crate::points::{POINTS, Point, points};

/// The inverse by hand.
fn by_hand(p: &Point) -> Matrix {
    let (m1, m2) = (p.pair(0).m1() / 2.0, p.pair(0).m2() / 2.0);
    Matrix::from_row_slice(2, 2, &[m2, m1, m1, m2])
}

/// The largest relative error of an entry.
fn error(found: &Matrix, expected: &Matrix) -> f64 {
    let pairs = found.iter().zip(expected.iter());
    pairs.fold(0.0, |worst, (x, y)| {
        assert!(x.is_finite(), "{found:?}");
        if x == y { worst } else { worst.max((x - y).abs() / y.abs()) }
    })
}

/// The ratio, at least one, of the inertias referred to the mesh.
fn ratio(p: &Point) -> f64 {
    let pair = p.pair(0);
    let (a, b) = (pair.i1 / pair.n1.powi(2), pair.i2 / pair.n2.powi(2));
    (a / b).max(b / a)
}

#[test]
fn mobility_is_the_inverse_of_the_mass() {
    let (mut worst, mut residual) = (0.0f64, 0.0f64);
    for p in points(POINTS) {
        let equations = p.equations(0);
        let (m, w) = (equations.mass(&[0.0; 2]), equations.mobility(&[0.0; 2]));
        worst = worst.max(error(&w, &by_hand(&p)));
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let terms = [m[(i, 0)] * w[(0, j)], m[(i, 1)] * w[(1, j)]];
            let one = if i == j { 1.0 } else { 0.0 };
            let scale = terms[0].abs().max(terms[1].abs()).max(1.0);
            residual = residual.max((terms[0] + terms[1] - one).abs() / scale);
        }
    }
    println!("M⁻¹ by hand {worst:.1e}, M M⁻¹ = 1 {residual:.1e} of its largest term");
    assert!(worst < TOLERANCE && residual < TOLERANCE, "{worst:e}, {residual:e}");
}

/// The reason for the closed form: the numerical inverse of M is as accurate only where the inertias are of similar size.
/// Elsewhere it lacks the digits that M has lost.
#[test]
fn the_numerical_inverse_of_the_mass_matrix_loses_digits() {
    let inverted = |p: &Point| error(&mobility(&p.equations(0).mass(&[0.0; 2])), &by_hand(p));
    let alike = points(POINTS).filter(|p| ratio(p) < 2.0 && ratio(p) > 1.1).map(|p| inverted(&p));
    let alike = alike.fold((0, 0.0f64), |(n, worst), e| (n + 1, worst.max(e)));
    let apart = points(POINTS).filter(|p| (1e9..1e10).contains(&ratio(p))).map(|p| inverted(&p));
    let apart = apart.fold((0, 0.0f64), |(n, worst), e| (n + 1, worst.max(e)));
    println!(
        "numerical inverse: {:.1e} at {} points with similar inertias, {:.1e} at {} with very different ones",
        alike.1, alike.0, apart.1, apart.0
    );
    assert!(alike.0 > 100 && alike.1 < TOLERANCE, "{alike:?}");
    assert!(apart.0 > 100 && apart.1 > 1e-8, "{apart:?}");
}
