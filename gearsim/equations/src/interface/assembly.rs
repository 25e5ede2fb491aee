//! Forces and matrices, assembled from terms that act along deflections. The gradient of a deflection is given by its nonzero entries, each
//! with index and value.

use crate::real::Real;

/// Adds f g to the generalised forces `v`: the force `f` acts along a deflection with the gradient `g`.
pub fn add_force<R: Real>(v: &mut [R], f: R, g: &[(usize, R)]) {
    g.iter().for_each(|(i, slope)| v[*i] += f * *slope);
}

/// Adds k g gᵀ to the symmetric matrix `v` (n x n, by rows), with the gradient `g` of a deflection.
pub fn add_square<R: Real>(v: &mut [R], n: usize, k: R, g: &[(usize, R)]) {
    for (i, a) in g {
        for (j, b) in g {
            // a b = b a: the matrix stays symmetric to the last digit.
            v[i * n + j] += k * (*a * *b);
        }
    }
}

/// Adds k (g hᵀ + h gᵀ) to the symmetric matrix `v` (n x n, by rows), with the gradients `g` and `h` of two deflections.
pub fn add_product<R: Real>(v: &mut [R], n: usize, k: R, g: &[(usize, R)], h: &[(usize, R)]) {
    for (i, a) in g {
        for (j, b) in h {
            let entry = k * (*a * *b);
            v[i * n + j] += entry;
            v[j * n + i] += entry;
        }
    }
}

/// The chain rule for forces that are written in deflections. `v` has the derivatives of N forces by coordinates and by speeds (N x N each).
/// The derivatives through D deflections are added to it. `by` has the derivatives of the forces by the deflections and by their rates (D x N each). `gradients` has the gradients of the
/// deflections.
pub fn add_through<const N: usize, const D: usize>(
    v: &mut [[[f64; N]; N]; 2],
    by: &[[[f64; N]; D]; 2],
    gradients: &[&[(usize, f64)]; D],
) {
    for (v, by) in v.iter_mut().zip(by) {
        for (by, gradient) in by.iter().zip(gradients) {
            for (row, by) in v.iter_mut().zip(by).filter(|(_, by)| **by != 0.0) {
                gradient.iter().for_each(|(j, slope)| row[*j] += by * slope);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sums against their definitions, and symmetry to the last digit.
    #[test]
    fn sparse_sums_equal_dense_sums() {
        let (g, h) = ([(0, 0.1), (2, -0.7)], [(1, 0.3), (2, 1.1)]);
        let dense = |sparse: &[(usize, f64)]| {
            let mut dense = [0.0; 3];
            sparse.iter().for_each(|(i, x)| dense[*i] = *x);
            dense
        };
        let (mut force, mut matrix) = ([0.0; 3], [0.0; 9]);
        add_force(&mut force, 2.0, &g);
        add_square(&mut matrix, 3, 0.9, &g);
        add_product(&mut matrix, 3, 1.3, &g, &h);
        let (g, h) = (dense(&g), dense(&h));
        for i in 0..3 {
            assert_eq!(force[i], 2.0 * g[i]);
            for j in 0..3 {
                let expected: f64 = 0.9 * g[i] * g[j] + 1.3 * (g[i] * h[j] + h[i] * g[j]);
                assert!((matrix[3 * i + j] - expected).abs() < 1e-15);
                assert_eq!(matrix[3 * i + j], matrix[3 * j + i]);
            }
        }
    }

    #[test]
    fn derivatives_through_deflections_follow_the_chain_rule() {
        let mut v = [[[0.0; 2]; 2]; 2];
        add_through(&mut v, &[[[3.0, 0.0]], [[0.0, 5.0]]], &[&[(0, 2.0), (1, -1.0)]]);
        assert_eq!(v, [[[6.0, -3.0], [0.0; 2]], [[0.0; 2], [10.0, -5.0]]]);
    }
}
