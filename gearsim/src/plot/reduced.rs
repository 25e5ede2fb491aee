//! Figures with fewer points, where a picture must be small: a notebook keeps the pictures of all its cells.

use super::decimate::decimate;
use super::figure::{Figure, Scale, Series, extremes};

/// Most points that [`decimate`] keeps in a column.
const A_COLUMN: usize = 6;
/// Least columns of a curve.
const COLUMNS: usize = 20;

impl Figure {
    /// The same figure with about `points` points in all curves together. Each curve keeps the ends, the extremes and the largest jump in
    /// each column along x. A figure with fewer points is unchanged.
    pub fn reduced(&self, points: usize) -> Figure {
        let mut figure = self.clone();
        let series = || self.panels.iter().flat_map(|panel| &panel.series);
        if series().map(|series| series.x.len()).sum::<usize>() <= points {
            return figure;
        }
        let place = |x: f64| if self.x.scale == Scale::Log10 { x.log10() } else { x };
        let (low, high) = extremes(series().flat_map(|series| series.x.iter().map(|x| place(*x))));
        if low >= high {
            return figure;
        }
        let columns = (points / (A_COLUMN * series().count())).max(COLUMNS);
        let column = |x: f64| (place(x) - low) / (high - low) * columns as f64;
        figure.panels.iter_mut().flat_map(|panel| &mut panel.series).for_each(|series| reduce(series, column));
        figure
    }
}

/// Reduces the pieces of a curve between its gaps. `column` is the place of an x, counted in columns.
fn reduce(series: &mut Series, column: impl Fn(f64) -> f64) {
    let points: Vec<(f64, f64)> = series.x.iter().copied().zip(series.y.iter().copied()).collect();
    let is_drawn = |&(x, y): &(f64, f64)| column(x).is_finite() && y.is_finite();
    let (mut x, mut y) = (vec![], vec![]);
    for piece in points.chunk_by(|a, b| is_drawn(a) == is_drawn(b)) {
        if !is_drawn(&piece[0]) {
            x.push(piece[0].0);
            y.push(f64::NAN);
            continue;
        }
        // The kept points are found again by their order, because x itself is drawn, not its place in columns.
        let placed: Vec<(f64, f64)> = piece.iter().map(|&(x, y)| (column(x), y)).collect();
        let mut from = 0;
        for (at, value) in decimate(&placed) {
            let next = placed[from..].iter().position(|point| *point == (at, value)).map_or(from, |i| from + i);
            x.push(piece[next].0);
            y.push(value);
            from = next + 1;
        }
    }
    (series.x, series.y) = (x, y);
}

#[cfg(test)]
mod tests {
    use super::super::figure::{Axis, Panel};
    use super::*;

    #[test]
    fn a_reduced_figure_has_the_ends_the_extremes_and_the_gaps() {
        let t: Vec<f64> = (0..50_000).map(|i| f64::from(i) * 1e-4).collect();
        let mut y: Vec<f64> = t.iter().map(|t| (300.0 * t).sin() * t).collect();
        y[30_000] = f64::NAN;
        let (low, high) = extremes(y.iter().copied());
        let panel = Panel { y: Axis::linear("y", ""), series: vec![Series::new(0, "y", t, y)] };
        let figure =
            Figure { title: "t".into(), subtitle: None, x: Axis::linear("t", "s"), panels: vec![panel.clone(), panel] };
        let small = figure.reduced(4000);
        let points: usize = small.panels.iter().flat_map(|panel| &panel.series).map(|series| series.x.len()).sum();
        assert!((2000..=4100).contains(&points), "{points}");
        let series = &small.panels[1].series[0];
        assert_eq!(extremes(series.y.iter().copied()), (low, high));
        assert_eq!((series.x[0], *series.x.last().unwrap()), (0.0, 4.9999));
        assert!(series.x.is_sorted());
        assert_eq!(series.y.iter().filter(|y| y.is_nan()).count(), 1);
        // A figure with fewer points is unchanged.
        assert_eq!(figure.reduced(100_000).panels[0].series[0].x, figure.panels[0].series[0].x);
    }
}
