use super::*;
use crate::output::fixture::MODEL;
use crate::trajectory::Moment;

/// The counts by range, as pairs of range and count.
fn by_range(column: &[f64]) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = vec![];
    for cycle in count(column) {
        match all.iter_mut().find(|(range, _)| *range == cycle.range) {
            Some((_, count)) => *count += cycle.count,
            None => all.push((cycle.range, cycle.count)),
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all
}

/// ASTM E1049-85, Fig. 6: the history A to I, and its counts.
#[test]
fn the_example_of_the_standard_has_its_counts() {
    let history = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];
    let expected = [(3.0, 0.5), (4.0, 1.5), (6.0, 0.5), (8.0, 1.0), (9.0, 0.5)];
    assert_eq!(by_range(&history), expected);
    // The cycle inside, E to F, has the mean 1.
    assert!(count(&history).contains(&Cycle { range: 4.0, mean: 1.0, count: 1.0 }));
    // Points between reversals, and values twice, as on both sides of an event, change nothing.
    let dense: Vec<f64> = history.windows(2).flat_map(|p| [p[0], p[0], 0.5 * (p[0] + p[1]), p[1]]).collect();
    assert_eq!(by_range(&dense), expected);
}

#[test]
fn a_sine_of_constant_amplitude_has_one_range() {
    let x: Vec<f64> = (0..=8000).map(|i| 7.0 + 2.0 * (std::f64::consts::TAU * f64::from(i) / 200.0).sin()).collect();
    let cycles = count(&x);
    let whole: f64 = cycles.iter().filter(|c| (c.range - 4.0).abs() < 1e-9).map(|c| c.count).sum();
    // 40 periods. The quarter periods at the beginning and at the end have smaller ranges.
    assert_eq!(whole, 39.5);
    let classes = classes(&cycles, 10);
    assert_eq!((classes[9].count, classes[9].exceeded, classes.len()), (39.5, 39.5, 10));
    assert!((classes[9].mean - 7.0).abs() < 1e-9);
    assert!((classes[0].exceeded - cycles.iter().map(|c| c.count).sum::<f64>()).abs() < 1e-12);
}

#[test]
fn a_constant_column_has_no_cycles() {
    assert!(count(&[1.0; 5]).is_empty() && count(&[]).is_empty() && classes(&[], 5).is_empty());
    assert_eq!(count(&[0.0, 2.0]), [Cycle { range: 2.0, mean: 1.0, count: 0.5 }]);
}

#[test]
fn the_equivalent_range_is_a_power_mean() {
    let cycle = |range, count| Cycle { range, mean: 0.0, count };
    let cycles = [cycle(1.0, 1.0), cycle(2.0, 1.0)];
    // ((1 + 2^3)/2)^(1/3)
    assert!((equivalent(&cycles, 3.0) - 4.5_f64.powf(1.0 / 3.0)).abs() < 1e-14);
    assert!((equivalent(&cycles[..1], 6.0) - 1.0).abs() < 1e-15);
}

#[test]
fn a_ramp_spends_the_same_time_in_every_class() {
    let mut run = Trajectory::new(&MODEL, &[], &[]);
    run.t = (0..=1000).map(|i| f64::from(i) * 2e-3).collect();
    run.moment = vec![Moment::Sample; 1001];
    let column: Vec<f64> = run.t.iter().map(|t| 3.0 + 5.0 * t).collect();
    let durations = durations(&run, 0.0, &column, 10);
    assert!((durations.iter().map(|d| d.time).sum::<f64>() - 2.0).abs() < 1e-12);
    assert!(durations.iter().all(|d| (d.time - 0.2).abs() < 0.0021), "{durations:?}");
    assert!((durations[0].low, durations[9].high) == (3.0, 13.0));
}
