//! The precise engine, compared with closed forms, with other precisions and with samples.

use super::cell::{Law, Mode, Motion};
use super::crossing::first_crossing_with;
use super::first_crossing;
use super::number::{Real, Scalar};
use super::refine::Found;

/// A deterministic sequence of numbers in 0..1.
pub struct Noise(pub u64);

impl Noise {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (self.0 ^ (self.0 >> 33)).wrapping_mul(0xff51_afd7_ed55_8ccd);
        (mixed >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// For any damping, critical damping included, and any stiffness, zero included, xi satisfies its equation.
#[test]
fn responses_satisfy_their_equation() {
    let mut noise = Noise(2);
    for case in 0..400 {
        let omega2 = if case % 5 == 0 { 0.0 } else { 10f64.powf(8.0 * noise.next() - 4.0) };
        let sigma = match case % 4 {
            0 => 0.0,
            1 => omega2.sqrt() * (1.0 + (noise.next() - 0.5) * 10f64.powf(-16.0 * noise.next())),
            2 => omega2.sqrt() * noise.next(),
            _ => 10f64.powf(6.0 * noise.next() - 3.0),
        };
        let t = 10f64.powf(4.0 * noise.next() - 3.0);
        let law = Law::new(Real::<384>::exact(sigma), Real::exact(omega2));
        let [x, v, g] = [0.0; 3].map(|_| Real::exact(noise.next() - 0.5));
        let motion = Motion::new(law, g, x, v, Real::exact(1.0));
        // the flow over t/3 followed by that over 2t/3 equals the flow over t
        let t = Real::exact(t);
        let (first, second) = (t.clone() / Real::exact(3.0), t.clone() - t.clone() / Real::exact(3.0));
        let (x, v) = motion.state(&first);
        let halfway = Motion::new(motion.law.clone(), motion.force.clone(), x, v, Real::exact(1.0));
        let [whole, parts] = [motion.state(&t), halfway.state(&second)];
        let scale = whole.0.approx().abs() + 1.0;
        assert!((whole.0 - parts.0).approx().abs() / scale < 1e-100, "{sigma} {omega2} {}", t.approx());
        // xi(t + h) - xi(t - h) = 2 h xi' + O(h^3)
        let h = Real::exact(2f64.powi(-100));
        let ahead = motion.state(&(t.clone() + h.clone())).0 - motion.state(&(t.clone() - h.clone())).0;
        let slope = (ahead / h.scaled(1)) - motion.state(&t).1;
        assert!(slope.approx().abs() < 1e-30 * (1.0 + sigma * sigma + omega2).powi(2), "{sigma} {omega2}");
        // the result in f64 has a small error
        let rounded = motion.rounded().state(&t.approx());
        assert!((rounded.0 - motion.state(&t).0.approx()).abs() < 1e-10 * scale, "{sigma} {omega2} {}", t.approx());
    }
}

fn mode(sigma: f64, omega2: f64, force: f64, x: f64, v: f64) -> Mode {
    Mode { sigma, omega2, force, x, v, weight: 1.0 }
}

#[test]
fn crossings_with_closed_forms_are_found() {
    // sin t = 1/2; constant acceleration; exponential approach 1 - e^{-2 t} = 3/4
    let cases = [
        (mode(0.0, 1.0, 0.0, 0.0, 1.0), 0.5, std::f64::consts::FRAC_PI_6),
        (mode(0.0, 0.0, 2.0, 0.0, 0.0), 9.0, 3.0),
        (mode(1.0, 0.0, 0.0, 0.0, 2.0), 0.75, 4f64.ln() / 2.0),
    ];
    for (mode, level, t) in cases {
        let root = first_crossing(&[mode], level, 100.0).expect("a crossing");
        assert!((root.t.0 - t).abs() < 1e-15 && !root.tangency, "{root:?} {t}");
    }
    assert_eq!(first_crossing(&[cases[0].0], 1.0 + 1e-15, 1e4), None);
    let touch = first_crossing(&[mode(0.0, 1.0, 0.0, 0.0, 1.0)], 1.0, 10.0).expect("a tangency");
    assert!(touch.tangency && (touch.t.0 - std::f64::consts::FRAC_PI_2).abs() < 1e-15, "{touch:?}");
    // critical damping: t e^{-t} has its maximum 1/e at t = 1; the level is just below or above it
    let e = (-1f64).exp();
    assert!(first_crossing(&[mode(1.0, 1.0, 0.0, 0.0, 1.0)], e * (1.0 - 1e-15), 10.0).is_some());
    assert!(first_crossing(&[mode(1.0, 1.0, 0.0, 0.0, 1.0)], e * (1.0 + 1e-15), 10.0).is_none());
}

#[test]
fn a_start_on_the_level_is_a_crossing_only_if_it_moves_beyond() {
    let leaving = first_crossing(&[mode(0.0, 1.0, 0.0, 0.5, 1.0)], 0.5, 10.0).expect("beyond at once");
    assert_eq!(leaving.t, (0.0, 0.0));
    let returning = first_crossing(&[mode(0.0, 1.0, 0.0, 0.0, -1.0)], 0.0, 10.0).expect("back after half a turn");
    assert!((returning.t.0 - std::f64::consts::PI).abs() < 1e-15);
    assert_eq!(first_crossing(&[mode(0.0, 0.0, -1.0, 0.0, 0.0)], 0.0, 10.0), None);
}

/// The crest of a sum of two modes is above or below the level by `depth`. There is a crossing if it is above.
#[test]
fn grazes_of_every_depth_are_decided_correctly() {
    for k in 1..=30 {
        for sign in [1.0, -1.0] {
            // sin t + depth, with its crest at pi/2; depth is a mode at rest, so the level 1 is exact
            let depth = sign * 10f64.powi(-k);
            let modes = [mode(0.0, 1.0, 0.0, 0.0, 1.0), Mode { weight: depth, ..mode(0.0, 0.0, 0.0, 1.0, 0.0) }];
            let found = first_crossing_with::<256>(&modes, 1.0, 3.0);
            assert_eq!(found.root.is_some(), sign > 0.0, "{k} {sign}");
            if let Some(Found { t, tangency, .. }) = found.root {
                // 1 - sin t = depth
                let expected = std::f64::consts::FRAC_PI_2 - 2.0 * (depth / 2.0).sqrt().asin();
                assert!(!tangency && (t.approx() - expected).abs() < 2e-15, "{k}: {} {expected}", t.approx());
            } else {
                assert!((found.near_miss / depth.abs() - 1.0).abs() < 0.02, "{k} {}", found.near_miss);
            }
        }
    }
}

/// Random cells of one to four modes. Dense samples check that no earlier crossing was missed.
#[test]
fn random_cells_agree_across_precisions_and_with_samples() {
    let mut noise = Noise(3);
    let mut crossed = 0;
    for case in 0..2000 {
        let modes = random_cell(&mut noise, 1 + case % 4);
        let level = modes.iter().map(|m| m.weight * m.x).sum::<f64>() + 2.0 * noise.next();
        let few = first_crossing_with::<192>(&modes, level, 20.0).root;
        let many = first_crossing_with::<256>(&modes, level, 20.0).root.map(|f| narrow(&f.t));
        assert_eq!(few.is_some(), many.is_some());
        let rough: Vec<Motion<f64>> = modes.iter().map(Motion::from).collect();
        let gap = |t: f64| level - rough.iter().map(|m| m.weight * m.state(&t).0).sum::<f64>();
        let until = few.as_ref().map_or(20.0, |f| f.t.approx());
        for i in 1..400 {
            let t = until * f64::from(i) / 400.0;
            assert!(gap(t) > -1e-11, "{case}: gap {} at {t} before {until}", gap(t));
        }
        if let (Some(Found { t: a, .. }), Some(b)) = (few, many) {
            crossed += 1;
            let apart = (a.clone() - b).approx().abs();
            assert!(apart <= 1e-44 * until.max(1e-3), "{case}: {apart}");
            assert!(gap(until).abs() < 1e-11);
        }
    }
    assert!(crossed > 500, "{crossed}");
}

/// A number of 256 bits in 192 bits.
fn narrow(x: &Real<256>) -> Real<192> {
    let (mut rest, mut sum) = (x.clone(), Real::exact(0.0));
    for _ in 0..5 {
        let part = rest.approx();
        rest = rest - Real::exact(part);
        sum = sum + Real::exact(part);
    }
    sum
}

/// A random cell of `n` modes. A third of the modes have no damping; half of the first modes have no stiffness.
pub fn random_cell(noise: &mut Noise, n: usize) -> Vec<Mode> {
    let each = |i: usize| {
        let omega2 = if i == 0 && noise.next() < 0.5 { 0.0 } else { 10f64.powf(4.0 * noise.next() - 1.0) };
        let damping = if noise.next() < 0.3 { 0.0 } else { 10f64.powf(4.0 * noise.next() - 3.0) };
        let sigma = damping * omega2.sqrt();
        let mut even = || 2.0 * noise.next() - 1.0;
        let force = even() * omega2;
        Mode { sigma, omega2, force, x: even(), v: even() * omega2.sqrt().max(0.3), weight: even() }
    };
    (0..n).map(each).collect()
}

/// `cargo test -p gearsim-tests -- --ignored --nocapture cost_of`
#[test]
#[ignore = "measures the cost, tests nothing"]
fn cost_of_cells() {
    for n in [1, 2, 4, 16] {
        let mut noise = Noise(4);
        let cells: Vec<_> = (0..1000).map(|_| random_cell(&mut noise, n)).collect();
        let clock = std::time::Instant::now();
        let level = |c: &[Mode]| c.iter().map(|m| m.weight * m.x).sum::<f64>() + 1.0;
        let crossed = cells.iter().filter(|c| first_crossing(c, level(c), 20.0).is_some()).count();
        println!("{n} modes: {:.1} us a cell, {crossed} crossings of 1000", clock.elapsed().as_secs_f64() * 1e3);
    }
}
