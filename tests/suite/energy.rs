//! Energy never rises with damping, and is created only where the jump terms are dropped.

mod common;

use common::{run, scene};
use gearsim::trajectory::Moment;

fn torques() -> impl Iterator<Item = f64> {
    [0.0, 0.3, 1.0, 2.0, 5.0, 8.0, 10.0, 12.0, 15.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0].into_iter()
}

/// The largest rise of U from one row to the next [J].
fn rise(t: &gearsim::trajectory::Trajectory) -> f64 {
    (1..t.len()).map(|i| t.energy(i) - t.energy(i - 1)).fold(0.0, f64::max)
}

#[test]
fn energy_never_rises_when_damped() {
    for name in ["energy_300rpm", "spectrum_600rpm_exact", "spectrum_4500rpm_exact"] {
        for t0 in torques() {
            let scene =
                scene(&format!("oh2005/{name}"), &[format!("parameters.T0={t0} N*m"), "run.t_end=0.1 s".into()]);
            let outcome = run(&scene);
            let t = &outcome.trajectory;
            // Rounding error: a few eps of the largest energy in the account.
            let scale = t.kinetic.iter().chain(&t.strain).chain(&t.work).fold(0.0, |m: f64, x| m.max(x.abs()));
            let rise = rise(t);
            assert!(rise <= 8.0 * f64::EPSILON * scale, "{name}, T0 = {t0}: U rises by {rise:e} J, scale {scale} J");
            let residual = t.residual.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            println!(
                "{name}, T0 = {t0}: {} changes, {} reflections, residual {:.1e}",
                outcome.counts.cell_changes,
                outcome.counts.reflections,
                residual / scale
            );
            assert!(residual < 1e-12 * scale, "{name}, T0 = {t0}: residual {residual:e} J of {scale} J");
        }
    }
}

#[test]
fn without_jump_terms_energy_rises_where_a_tooth_enters() {
    let scene = scene("oh2005/energy_300rpm_rigid", &[]);
    let outcome = run(&scene);
    let t = &outcome.trajectory;
    let mut created = 0.0;
    for i in 1..t.len() {
        if t.moment[i] == Moment::After {
            let (before, after) = (t.energy(i - 1), t.energy(i));
            // A tooth enters at theta = 1.73: the stiffness rises, and the energy with it. Where a tooth leaves, both fall.
            let enters = (t.q[0][i].rem_euclid(std::f64::consts::TAU) - 1.73).abs() < 1e-9;
            assert_eq!(after > before, enters, "at {}", t.t[i]);
            created += after - before;
        }
    }
    // The residual of the account is the energy that the steps created.
    let residual = t.residual[t.len() - 1];
    assert!((residual - created).abs() < 1e-12 * outcome.energy_at_start, "{residual} {created}");
    assert!(created > 0.01, "{created}");
}
