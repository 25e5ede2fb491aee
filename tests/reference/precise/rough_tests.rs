//! Tests that exclusion in `f64` is safe, and that none of very many cells remains undecided.

use super::crossing::{Surface, prepared};
use super::first_crossing;
use super::number::{Real, Scalar};
use super::rough::Rough;
use super::tests::{Noise, random_cell};

/// The claimed bounds on rounding errors in `f64` hold with a margin, so a rounding error never excludes a crossing.
#[test]
fn rounding_errors_of_f64_stay_within_their_bounds() {
    let mut noise = Noise(6);
    let mut worst = 0f64;
    for case in 0..3000 {
        let mut modes = random_cell(&mut noise, 1 + case % 3);
        if case % 2 == 0 {
            // near critical damping, or far above it
            let off = 10f64.powf(-16.0 * noise.next());
            let m = &mut modes[0];
            m.sigma = m.omega2.sqrt() * if case % 4 == 0 { 1.0 + off } else { 1e6 * off.max(1e-5) };
        }
        let motions = modes.iter().map(prepared::<256>).collect::<Vec<_>>();
        let surface = Surface { motions: &motions, level: Real::exact(1.0), sign: 1.0 };
        let rough = Rough::new(&surface);
        let t = 10f64.powf(5.0 * noise.next() - 3.0);
        let (local, exact) = (rough.local(t), surface.exact(&Real::exact(t)));
        for (i, exact) in exact.iter().enumerate() {
            let error = (exact.clone() - Real::exact(local.gap[i])).approx().abs();
            worst = worst.max(error / local.error[i].max(f64::MIN_POSITIVE));
            assert!(error <= 0.2 * local.error[i], "{case} {i}: {error:e} {:e} {modes:?} {t}", local.error[i]);
        }
        // |gap'''| must be below its bounds from earlier times
        let h = 1e-6 * t;
        let later = surface.exact(&Real::exact(t + h))[2].clone();
        let third = ((later - exact[2].clone()) / (Real::exact(t + h) - Real::exact(t))).approx().abs();
        assert!(third <= rough.third(0.7 * t) && third <= rough.third(0.0), "{case}: {third:e}");
    }
    println!("errors of f64 reach {worst:.1e} of their bounds");
}

/// `cargo test -p gearsim-tests -- --ignored --nocapture soak`
#[test]
#[ignore = "ten seconds"]
fn soak() {
    let mut noise = Noise(7);
    let mut crossed = 0;
    let clock = std::time::Instant::now();
    for case in 0..100_000 {
        let modes = random_cell(&mut noise, 1 + case % 4);
        let start = modes.iter().map(|m| m.weight * m.x).sum::<f64>();
        let margin = if case % 3 == 0 { 10f64.powf(-14.0 * noise.next()) } else { noise.next() };
        crossed += usize::from(first_crossing(&modes, start + margin, 20.0).is_some());
    }
    println!("{crossed} crossings of 100000, {:.1} s", clock.elapsed().as_secs_f64());
}
