//! Reduction of a curve to the points that matter on screen: per pixel column its ends, its extremes and its largest jump.

/// The points to draw of a curve given in pixels, x not decreasing.
///
/// At most six points are kept per pixel column, in their order and at their exact positions: the first, the lowest, the highest,
/// the last, and both ends of the largest jump (two points in a row with equal x). The extremes are therefore drawn exactly, and
/// jumps stay vertical.
pub fn decimate(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut kept = Vec::with_capacity(points.len().min(8192));
    for column in points.chunk_by(|a, b| a.0.floor() == b.0.floor()) {
        if column.len() <= 6 {
            kept.extend_from_slice(column);
            continue;
        }
        let y = |i: usize| column[i].1;
        let last = column.len() - 1;
        let (mut lowest, mut highest, mut jump, mut height) = (0, 0, 0, 0.0);
        for i in 1..=last {
            if y(i) < y(lowest) {
                lowest = i;
            }
            if y(i) > y(highest) {
                highest = i;
            }
            let step = (y(i) - y(i - 1)).abs();
            if column[i].0 == column[i - 1].0 && step > height {
                (jump, height) = (i - 1, step);
            }
        }
        let mut places = vec![0, lowest, highest, last];
        if height > 0.0 {
            places.extend([jump, jump + 1]);
        }
        places.sort_unstable();
        places.dedup();
        kept.extend(places.into_iter().map(|i| column[i]));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extremes_and_ends_of_every_pixel_column_are_kept() {
        let points: Vec<_> = (0..100_000).map(|i| i as f64 * 0.004).map(|x| (x, (x * 7.0).sin() * x)).collect();
        let kept = decimate(&points);
        assert!(kept.len() <= 6 * 401);
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[points.len() - 1]));
        assert!(kept.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        for column in points.chunk_by(|a, b| a.0.floor() == b.0.floor()) {
            let high = column.iter().map(|p| p.1).fold(f64::MIN, f64::max);
            let low = column.iter().map(|p| p.1).fold(f64::MAX, f64::min);
            for y in [low, high] {
                assert!(kept.iter().any(|p| p.1 == y && p.0.floor() == column[0].0.floor()));
            }
        }
    }

    #[test]
    fn a_curve_of_few_points_is_unchanged() {
        let points = [(0.0, 0.0), (10.5, 1.0), (10.5, 5.0), (20.0, 5.0)];
        assert_eq!(decimate(&points), points);
    }

    #[test]
    fn a_jump_among_many_points_stays_vertical() {
        let step = |i: usize| {
            let x = i as f64 * 0.01;
            if i <= 50 { (x, 1.0) } else { (x - 0.01, 0.0) }
        };
        let points: Vec<_> = (0..100).map(step).collect();
        assert_eq!(points[50].0, points[51].0);
        let kept = decimate(&points);
        assert!(kept.windows(2).any(|pair| pair == [points[50], points[51]]), "{kept:?}");
        assert!(kept.len() <= 6);
    }
}
