//! Answers of sweeps whose results are known: the time that a run reaches is the end that its scene asks for.

use super::limit::Limit;
use super::{Block, sensitivity, statistics};
use crate::known::MODELS;
use crate::sweep::design::Design;
use crate::sweep::folder::Rows;
use crate::sweep::manifest::{Layout, Manifest};
use crate::sweep::tests::{load, request};
use crate::sweep::{Request, row::Status};

/// All points of a sweep over `vary`, with `samples` of a design.
fn swept(vary: &[&str], design: Design, samples: usize) -> (Layout, Rows) {
    let record = vec!["events".into()];
    let request = Request { samples: Some(samples), design, seed: 5, record, overrides: vec![], ..request(vary) };
    let sweep = load(&request).unwrap_or_else(|e| panic!("{vary:?}: {e}"));
    let rows = (0..sweep.points).map(|point| (point, sweep.point(point))).collect();
    (Manifest::new(&sweep, &request, None).layout(MODELS).unwrap(), rows)
}

fn column(layout: &Layout) -> usize {
    layout.columns.iter().position(|(name, _)| name == "t_end").unwrap()
}

/// A Latin hypercube has one point in each of N intervals of equal probability. With N = 200 its mean is right to 1 % of the standard
/// deviation; the mean of independent points would be right to 7 %.
#[test]
fn statistics_are_those_of_the_distribution() {
    let (layout, rows) = swept(&["run.t_end=normal:20 ms:1 ms"], Design::LatinHypercube, 200);
    let blocks = Block::all(&layout, &rows);
    let spread = statistics::of(&blocks[0], column(&layout)).unwrap();
    assert_eq!(spread.points, 200);
    assert!((spread.mean - 20e-3).abs() < 0.01e-3, "{spread:?}");
    assert!((spread.deviation - 1e-3).abs() < 0.03e-3, "{spread:?}");
    let [_, p05, _, median, _, p95, _] = spread.percentiles;
    assert!((median - 20e-3).abs() < 0.03e-3, "{spread:?}");
    assert!((p05 - 18.355e-3).abs() < 0.1e-3 && (p95 - 21.645e-3).abs() < 0.1e-3, "{spread:?}");
}

/// A normal distribution exceeds its mean by more than a deviation with the probability 0.1587. Points that cannot run
/// are not counted.
#[test]
fn limits_are_broken_as_often_as_the_distribution_says() {
    let (layout, mut rows) = swept(&["run.t_end=normal:20 ms:1 ms"], Design::LatinHypercube, 200);
    let limit = Limit::read("t_end <= 21 ms", &layout).unwrap();
    let count = limit.count(&layout, &Block::all(&layout, &rows)[0]);
    assert!((count.probability() - 0.158_655).abs() <= 1.0 / 200.0, "{count:?}");
    let (low, high) = count.interval();
    assert!(low < 0.158_655 && 0.158_655 < high, "{low} {high}");
    rows.get_mut(&7).unwrap().status = Status::Stopped;
    let fewer = limit.count(&layout, &Block::all(&layout, &rows)[0]);
    assert_eq!((fewer.points, fewer.unknown), (199, 1));
    for (wrong, said) in [
        ("t_end", "is not a limit"),
        ("t_ends < 1 s", "did you mean `t_end`"),
        ("t_end < 3 m", "no value of `t_end` [s]"),
        ("t_end < 3 sec", "unknown unit"),
        ("t_end < 3", "no value of"),
    ] {
        let error = Limit::read(wrong, &layout).unwrap_err().to_string();
        assert!(error.contains(said), "{wrong}: {error}");
    }
}

/// Without random axes the limit is counted over all points.
#[test]
fn a_grid_is_one_block() {
    let request = Request { record: vec!["events".into()], overrides: vec![], ..request(&["run.t_end=1 ms:5 ms:5"]) };
    let sweep = load(&request).unwrap();
    let rows: Rows = (0..sweep.points).map(|point| (point, sweep.point(point))).collect();
    let layout = Manifest::new(&sweep, &request, None).layout(MODELS).unwrap();
    let blocks = Block::all(&layout, &rows);
    let count = Limit::read("t_end < 3.5 ms", &layout).unwrap().count(&layout, &blocks[0]);
    assert_eq!((blocks.len(), count.broken, count.points), (1, 2, 5));
    // The points are chosen: there is no probability.
    assert!(count.probability().is_nan() && count.interval().0.is_nan() && count.interval().1.is_nan());
    assert_eq!(blocks[0].name(&layout), "");
}

/// Only the axis that sets the end of a run changes the time it reaches: its indices are 1, those of the other are 0. The answers are
/// computed at each point of the grid.
#[test]
fn indices_name_the_axis_that_matters_at_each_point_of_the_grid() {
    let vary = ["parameters.zeta=uniform:0.05:0.2", "start.speed=100 rpm,300 rpm", "run.t_end=uniform:1 ms:3 ms"];
    let (layout, rows) = swept(&vary, Design::Saltelli, 32);
    assert_eq!(rows.len(), 2 * 32 * 4);
    let blocks = Block::all(&layout, &rows);
    assert_eq!(blocks[1].name(&layout), "start.speed = 300 rpm");
    // Each base sample has the points A, A_1, A_2 and B. Only A and B are independent.
    let limit = Limit::read("t_end < 2 ms", &layout).unwrap();
    assert_eq!(limit.count(&layout, &blocks[0]).points, 2 * 32);
    for block in &blocks {
        let (indices, samples) = sensitivity::of(&layout, block, column(&layout)).unwrap();
        assert_eq!((samples, indices[0].key.as_str(), indices[1].key.as_str()), (32, "parameters.zeta", "run.t_end"));
        assert!(indices[0].first.value == 0.0 && indices[0].total.value == 0.0, "{indices:?}");
        assert!(
            (indices[1].first.value - 1.0).abs() < 0.1 && (indices[1].total.value - 1.0).abs() < 0.1,
            "{indices:?}"
        );
    }
    let table = sensitivity::table(&layout, &blocks).unwrap();
    assert!(table.rows() >= 4 && table.numbers("start.speed").is_some() && table.words("key").is_some());
    assert_eq!(statistics::table(&layout, &blocks).unwrap().words("quantity").unwrap()[0], "t_end");
}
