//! First crossings of random phases, compared with a scan.

use super::phase::Phase;
use crate::tolerance::events::TURN_STEP;

/// Random numbers in 0..1.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64
}

/// A random phase of unit frequency. It starts on a boundary or between two. Its drift is at most `fastest`, its damping at most `most`.
fn draw(seed: &mut u64, fastest: f64, most: f64) -> (Phase, [f64; 2]) {
    let mut even = |size: f64| size * (2.0 * random(seed) - 1.0);
    let (sigma, omega2, part) = (even(most).abs(), 1.0, even(2.0));
    let w: f64 = (omega2 - sigma * sigma).sqrt();
    let (v, y, drift) = (even(1.0), even(1.0), even(fastest));
    let a = -2.0 * sigma * v - omega2 * y;
    let jerk = -2.0 * sigma * a - omega2 * v;
    let phase = Phase {
        drift,
        part,
        sigma,
        omega2,
        per_omega2: 1.0 / omega2,
        w,
        v: [v, (a + sigma * v) / w],
        a: [a, (jerk + sigma * a) / w],
        start: y,
    };
    let (width, place) = (even(4.0).abs() + 1e-3, even(1.0));
    // A third of the phases start on a boundary and leave it.
    let inwards = drift + part * v;
    let down = match place {
        p if p.abs() > 0.33 => width * p.abs(),
        _ if inwards > 0.0 => 0.0,
        _ => width,
    };
    (phase, [down, width - down])
}

#[test]
fn first_crossings_are_those_of_a_scan() {
    agrees_with_scans(4000, 0.5, 0.2, 40.0);
}

#[test]
fn slow_phases_cross_where_a_scan_finds_the_crossing() {
    agrees_with_scans(400, 0.01, 0.002, 1000.0);
}

/// Checks for `count` random phases that the first crossing is the one that a scan up to the time `until` finds.
fn agrees_with_scans(count: usize, fastest: f64, damping: f64, until: f64) {
    let (mut seed, mut found, mut left, mut late) = (1, 0usize, 0usize, 0usize);
    let steps = (until / 5e-3) as u32;
    for _ in 0..count {
        let (phase, gaps) = draw(&mut seed, fastest, damping);
        let outside = |t: f64| {
            let s = phase.at(t).s;
            if s > gaps[1] { Some(true) } else { (s < -gaps[0]).then_some(false) }
        };
        let seen = (1..=steps).map(|i| until * f64::from(i) / f64::from(steps)).find_map(|t| Some((outside(t)?, t)));
        let Some((up, t)) = phase.first(gaps, 1.0 + 2.0 * phase.sigma, until) else {
            left += usize::from(seen.is_some());
            continue;
        };
        found += 1;
        late += usize::from(t > until / 4.0);
        // The phase is at the boundary at the time found. This holds also for a crossing that is too shallow for the scan.
        assert!(!phase.is_monotone() || up == (phase.drift > 0.0), "a monotone phase goes one way, {gaps:?}");
        let there = phase.at(t);
        let (gap, speed) = if up { (gaps[1] - there.s, there.rate) } else { (gaps[0] + there.s, -there.rate) };
        assert!(gap.abs() <= 2.0 * TURN_STEP * (speed.abs() + TURN_STEP), "{gap} at {t}, {gaps:?}");
        assert!(speed > -2.0 * TURN_STEP, "{speed} at {t}, {gaps:?}");
        if let Some((side, at)) = seen {
            assert!(t <= at + 2.0 * TURN_STEP, "{t} is later than {at}, {gaps:?}");
            assert!(side == up || t < at - until / f64::from(steps), "{up} at {t}, {side} at {at}, {gaps:?}");
        }
    }
    assert!(found * 2 > count && left * 50 < found, "{found} found, {left} left");
    assert!(late * 50 > found, "{late} of {found} are late");
}

#[test]
fn a_phase_that_stops_turning_back_has_one_crossing_left() {
    // Damping of 5 % takes some turns to bring the vibration below the steady speed; the boundary is a hundred vibrations away.
    let (sigma, w) = (0.05, (1.0 - 0.05f64 * 0.05).sqrt());
    let (v, y, drift, edge) = (1.0, 0.0, 0.3, 200.0);
    let a = -2.0 * sigma * v - y;
    let jerk = -2.0 * sigma * a - v;
    let phase = Phase {
        drift,
        part: 1.0,
        sigma,
        omega2: 1.0,
        per_omega2: 1.0,
        w,
        v: [v, (a + sigma * v) / w],
        a: [a, (jerk + sigma * a) / w],
        start: y,
    };
    assert!(!phase.is_monotone());
    // At the end only the steady motion is left: s = d t + c (y(inf) - y(0)), y(inf) = 0.
    let (up, t) = phase.first([10.0, edge], 1.1, 1e4).expect("it has a crossing");
    assert!(up && (t * drift / edge - 1.0).abs() <= 4.0 * f64::EPSILON, "{up} at {t}");
}
