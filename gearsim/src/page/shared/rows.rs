//! The rows of a table that a page contains: all rows or, if there are very many, the smallest and the largest value of every few rows.

use crate::output::Table;
use crate::output::table::Values;

/// Most numbers that a page embeds of a table: 80 MB as base64.
pub const MOST: usize = 30_000_000;

/// How many rows of the table one step of the page covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rows {
    /// 1: every row is in the page. Otherwise two rows stand for this many: the lowest and the highest value of each column, in order.
    pub every: usize,
}

impl Rows {
    /// As many rows of `table` as a page may have.
    pub fn of(table: &Table) -> Self {
        let columns = table.columns().iter().filter(|c| matches!(c.values, Values::Number(_))).count();
        Self::at_most(MOST, table.rows(), columns)
    }

    /// As many of `rows` rows of each of `columns` columns as a page with `most` numbers may have.
    pub fn at_most(most: usize, rows: usize, columns: usize) -> Self {
        let allowed = (most / columns.max(1)).max(2);
        Rows { every: if rows <= allowed { 1 } else { (2 * rows).div_ceil(allowed) } }
    }

    /// The values of a column in the page.
    pub fn values(self, column: &[f64]) -> Vec<f64> {
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
    pub fn times(self, t: &[f64]) -> Vec<f64> {
        self.values(t)
    }
}

#[test]
fn extremes_of_steps_stand_for_many_rows() {
    let rows = Rows::at_most(12, 10, 2);
    assert_eq!(rows, Rows { every: 4 });
    let nan = f64::NAN;
    assert_eq!(rows.values(&[0.0, 5.0, -1.0, 2.0, nan, 1.0, 1.0, 3.0, 7.0, 6.0]), [5.0, -1.0, 1.0, 3.0, 7.0, 6.0]);
    assert_eq!(rows.times(&[0.0, 1.0, 2.0, 3.0, 4.0]), [0.0, 3.0, 4.0, 4.0]);
    assert_eq!(Rows::at_most(20, 10, 2), Rows { every: 1 });
}
