//! Gear pairs with play: functions shared by the cases of row 11.

use gearsim::scene::Scene;
use gearsim::scene::solver::Method;
use gearsim::trajectory::{Moment, Trajectory};

use crate::case::largest;
use crate::common;
use crate::models::{end, residual};
use crate::noise::Noise;

/// M1, M2 [1/(kg m²)] and C [N m s] of the paper's gear pair.
pub fn constants(zeta: f64) -> (f64, f64, f64) {
    let (a, b) = (24f64.powi(2) / 2890e-6, 96f64.powi(2) / 740200e-6);
    let m2 = (a + b) / 2.0;
    ((a - b) / 2.0, m2, 2.0 * zeta * ((1430.0 + 2780.0) / 2.0 / m2).sqrt())
}

/// The rows recorded just before events.
pub fn before(run: &Trajectory) -> impl Iterator<Item = usize> + '_ {
    (0..run.len()).filter(|&i| run.moment[i] == Moment::Before)
}

/// A random gear pair that rattles: small torque, little damping, high speeds of phi at the start; with `more` overrides.
pub fn rattling(noise: &mut Noise, more: &[String]) -> Scene {
    let play = noise.power(-3.0, -1.5);
    let own = [
        format!("parameters.zeta={:?}", 0.2 * noise.unit()),
        format!("parameters.T0={:?} N*m", noise.power(-1.0, 2.0)),
        format!("parameters.b={play:?} rad"),
        format!("start.theta={:?} rad", noise.unit()),
        format!("start.phi={:?} rad", play * noise.even()),
        format!("start.phi_dot={:?} rad/s", noise.power(0.0, 2.0)),
        format!("start.speed={:?} rad/s", noise.power(0.5, 2.5)),
        "run.t_end=20 ms".into(),
        "output.rate=\"1 kHz\"".into(),
    ];
    common::scene("backlash", &[&own[..], more].concat())
}

/// The largest difference between dop853 and the exact engine at the end of shortened `scenes`, relative to the sizes of the motion.
/// Infinite if the numbers of impacts or reflections differ. The note gets the number of impacts.
pub fn apart_by_steps(scenes: impl Iterator<Item = Scene>, note: &mut String) -> f64 {
    let (mut count, mut impacts) = (0, 0);
    let worst = scenes.map(|mut scene| {
        scene.t_end = 4e-3;
        let exact = common::run(&scene);
        scene.solver.method = Some(Method::Dop853);
        scene.solver.tolerance = 1e-13;
        let steps = common::run(&scene);
        (count, impacts) = (count + 1, impacts + exact.counts.impacts);
        if (exact.counts.impacts, exact.counts.reflections) != (steps.counts.impacts, steps.counts.reflections) {
            return f64::INFINITY;
        }
        let (a, b) = (end(&exact), end(&steps));
        let size = |x: &[f64]| largest(x.iter().map(|x| x.abs()));
        let t = &exact.trajectory;
        let off =
            |i: usize| largest([(a.0[i] - b.0[i]).abs() / size(&t.q[i]), (a.1[i] - b.1[i]).abs() / size(&t.q_dot[i])]);
        largest([off(0), off(1), residual(&steps)])
    });
    let worst = largest(worst);
    *note = format!("{count} scenes, {impacts} impacts");
    worst
}

/// Integrates y' = rate(y) from `y` over the time `t_end` by the classical Runge-Kutta method with this number of steps.
pub fn rk4<const N: usize>(rate: impl Fn([f64; N]) -> [f64; N], mut y: [f64; N], t_end: f64, steps: u32) -> [f64; N] {
    let h = t_end / f64::from(steps);
    let go = |y: [f64; N], k: [f64; N], h: f64| -> [f64; N] { std::array::from_fn(|i| y[i] + h * k[i]) };
    for _ in 0..steps {
        let k1 = rate(y);
        let k2 = rate(go(y, k1, h / 2.0));
        let k3 = rate(go(y, k2, h / 2.0));
        let k4 = rate(go(y, k3, h));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    y
}
