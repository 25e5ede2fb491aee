//! Reduction of a curve to what can be seen: in each column of pixels its first, lowest, highest and last point.

/// The points to draw of a curve given in pixels, x not decreasing.
///
/// In a column of one pixel no more than four points are kept, in their order and at their own places, so that
/// extremes survive and jumps stay upright.
pub fn decimate(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut kept = Vec::with_capacity(points.len().min(8192));
    for column in points.chunk_by(|a, b| a.0.floor() == b.0.floor()) {
        if column.len() <= 4 {
            kept.extend_from_slice(column);
            continue;
        }
        let (mut lowest, mut highest) = (0, 0);
        for (i, p) in column.iter().enumerate() {
            if p.1 < column[lowest].1 {
                lowest = i;
            }
            if p.1 > column[highest].1 {
                highest = i;
            }
        }
        let mut places = [0, lowest, highest, column.len() - 1];
        places.sort_unstable();
        for (n, &i) in places.iter().enumerate() {
            if n == 0 || places[n - 1] != i {
                kept.push(column[i]);
            }
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_and_ends_survive_in_every_column() {
        let points: Vec<_> = (0..100_000)
            .map(|i| i as f64 * 0.004)
            .map(|x| (x, (x * 7.0).sin() * x))
            .collect();
        let kept = decimate(&points);
        assert!(kept.len() <= 4 * 401);
        assert_eq!(
            (kept[0], kept[kept.len() - 1]),
            (points[0], points[points.len() - 1])
        );
        assert!(kept.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        for column in points.chunk_by(|a, b| a.0.floor() == b.0.floor()) {
            let high = column.iter().map(|p| p.1).fold(f64::MIN, f64::max);
            let low = column.iter().map(|p| p.1).fold(f64::MAX, f64::min);
            for y in [low, high] {
                assert!(
                    kept.iter()
                        .any(|p| p.1 == y && p.0.floor() == column[0].0.floor())
                );
            }
        }
    }

    #[test]
    fn few_points_and_jumps_are_kept_as_they_are() {
        let points = [(0.0, 0.0), (10.5, 1.0), (10.5, 5.0), (20.0, 5.0)];
        assert_eq!(decimate(&points), points);
    }
}
