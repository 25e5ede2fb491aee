//! The closed form against quadrature.

use super::*;

/// A rigid motion and two vibrations that one damper couples. The weights of the rigid motion in the damper give it decay rates from 1e-24
/// to 1 per second: the terms of the closed form are up to 1e24 times larger than the motion, unless they are taken together.
#[test]
fn the_loss_of_weakly_damped_rigid_motions_keeps_its_digits() {
    let rates = [(3.0, 55.0), (1.0, -7.0), (0.3, 100.0)];
    for weight in [0.0, 1e-12, 1e-8, 1e-5, 1e-3, 0.1, 1.0] {
        let along = DVector::from_vec(vec![weight, 1.0, 0.5]);
        let coupled = Coupled::of(&[0.0, 2500.0, 1.6e5], &(&along * along.transpose()), &|| {}).unwrap();
        let loss = Loss::new(&coupled);
        for t in [1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0] {
            let (closed, quadrature) = (loss.until(&rates, t), loss.by_quadrature(&rates, t));
            let error = (closed / quadrature - 1.0).abs();
            assert!(error < 3e-14, "weight {weight:e}, t {t:e} s: {closed:e} J, by quadrature {quadrature:e} J");
        }
    }
}

/// Upwards, downwards, and at the change from one to the other: against Gauss-Legendre quadrature in panels.
#[test]
fn moments_are_integrals() {
    let panels = 200;
    for z in
        [(0.0, 0.0), (-1e-20, 0.0), (-0.3, 0.2), (-5.0, 3.0), (0.0, 15.9), (-11.3, 11.4), (-40.0, 0.0), (-2.0, 150.0)]
    {
        let z = Complex::new(z.0, z.1);
        for (p, found) in moments(z).into_iter().enumerate() {
            let mut sum = Complex::from(0.0);
            for (x, weight) in (0..panels).flat_map(|_| GAUSS_16).enumerate().flat_map(|(i, (x, weight))| {
                let middle = (i / GAUSS_16.len()) as f64 + 0.5;
                [(middle - 0.5 * x, weight), (middle + 0.5 * x, weight)]
            }) {
                let x = x / f64::from(panels);
                sum += (z * x).exp() * x.powi(p as i32) * (0.5 * weight / f64::from(panels));
            }
            assert!((found - sum).norm() < 1e-14, "I_{p}({z}) = {found}, not {sum}");
        }
    }
}
