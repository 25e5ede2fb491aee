//! The rows of a result that a page contains: all rows or, if there are very many, the smallest and the largest value of every few rows.

use std::ops::Range;

/// Most numbers that a page embeds of a result: 80 MB as base64 where they do not pack well.
pub const MOST: usize = 30_000_000;

/// The rows of a result that a page contains.
#[derive(Debug, Clone, PartialEq)]
pub struct Rows {
    /// 1: every row is in the page. Otherwise two rows stand for this many rows: they have the lowest and the highest value of each column,
    /// in the order of the rows.
    pub every: usize,
    /// The rows that are wanted; `None`: all rows. Of the rows before and after them, the page has only the first and the last row of all.
    within: Option<Range<usize>>,
}

impl Rows {
    /// As many of `rows` rows of each of `columns` columns as a page with `most` numbers may have.
    pub fn at_most(most: usize, rows: usize, columns: usize) -> Self {
        let allowed = (most / columns.max(1)).max(2);
        Rows { every: if rows <= allowed { 1 } else { (2 * rows).div_ceil(allowed) }, within: None }
    }

    /// The given rows, as the extremes in each of `parts` parts.
    pub fn within(rows: Range<usize>, parts: usize) -> Self {
        let every = rows.len().div_ceil(parts.max(1));
        Rows { every: if every <= 2 { 1 } else { every }, within: Some(rows) }
    }

    /// The values of a column in the page.
    pub fn values(&self, column: &[f64]) -> Vec<f64> {
        let Some(Range { start, end }) = self.within else { return self.extremes(column) };
        let before = column[..start].first();
        let after = column[end..].last();
        before.copied().into_iter().chain(self.extremes(&column[start..end])).chain(after.copied()).collect()
    }

    fn extremes(&self, column: &[f64]) -> Vec<f64> {
        if self.every == 1 {
            return column.to_vec();
        }
        let ends = |rows: &[f64]| {
            let (mut low, mut high) = (0, 0);
            for (i, x) in rows.iter().enumerate() {
                low = if *x < rows[low] || rows[low].is_nan() { i } else { low };
                high = if *x > rows[high] || rows[high].is_nan() { i } else { high };
            }
            [rows[low.min(high)], rows[low.max(high)]]
        };
        column.chunks(self.every).flat_map(ends).collect()
    }

    /// The times in the page: the first and the last of each step.
    pub fn times(&self, t: &[f64]) -> Vec<f64> {
        self.values(t)
    }
}

#[test]
fn extremes_of_steps_stand_for_many_rows() {
    let rows = Rows::at_most(12, 10, 2);
    assert_eq!(rows, Rows { every: 4, within: None });
    let nan = f64::NAN;
    assert_eq!(rows.values(&[0.0, 5.0, -1.0, 2.0, nan, 1.0, 1.0, 3.0, 7.0, 6.0]), [5.0, -1.0, 1.0, 3.0, 7.0, 6.0]);
    assert_eq!(rows.times(&[0.0, 1.0, 2.0, 3.0, 4.0]), [0.0, 3.0, 4.0, 4.0]);
    assert_eq!(Rows::at_most(20, 10, 2), Rows { every: 1, within: None });
}

#[test]
fn some_rows_come_with_the_first_and_the_last_of_all() {
    let column: Vec<f64> = (0..20).map(f64::from).collect();
    assert_eq!(Rows::within(5..17, 3).values(&column), [0.0, 5.0, 8.0, 9.0, 12.0, 13.0, 16.0, 19.0]);
    assert_eq!(Rows::within(5..9, 2).values(&column), [0.0, 5.0, 6.0, 7.0, 8.0, 19.0]);
    assert_eq!(Rows::within(0..20, 2).values(&column), [0.0, 9.0, 10.0, 19.0]);
    assert_eq!(Rows::within(20..20, 5).values(&column), [0.0]);
    assert!(Rows::within(0..0, 5).values(&[]).is_empty());
}
