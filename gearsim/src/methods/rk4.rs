//! RK4: the classical Runge-Kutta method of order 4, with steps of fixed length, and cubic Hermite interpolation within a step.
//!
//! Kutta (1901), Z. Math. Phys. 46. The method has no error estimate; the scene states the step length.

use super::explicit::{ErrorEstimate, Interpolant, Tableau};

/// The method.
pub const RK4: Tableau = Tableau {
    name: "rk4",
    order: 4,
    rows: &ROWS,
    nodes: &[0.0, 0.5, 0.5, 1.0, 1.0],
    last: 4,
    error: ErrorEstimate::None,
    // y_0 + h k_0 x + (3 (y_1 - y_0) - h (2 k_0 + k_4)) x² + (h (k_0 + k_4) - 2 (y_1 - y_0)) x³.
    interpolant: Interpolant::Powers(&[
        (0, [1.0, -1.5, 2.0 / 3.0, 0.0]),
        (1, [0.0, 1.0, -2.0 / 3.0, 0.0]),
        (2, [0.0, 1.0, -2.0 / 3.0, 0.0]),
        (3, [0.0, 0.5, -1.0 / 3.0, 0.0]),
        (4, [0.0, -1.0, 1.0, 0.0]),
    ]),
    stability: 2.785,
};

const ROWS: [&[(usize, f64)]; 5] =
    [&[], &[(0, 0.5)], &[(1, 0.5)], &[(2, 1.0)], &[(0, 1.0 / 6.0), (1, 1.0 / 3.0), (2, 1.0 / 3.0), (3, 1.0 / 6.0)]];
