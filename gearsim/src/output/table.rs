//! A table of named columns with units; all results with rows are written as such tables.

use std::borrow::Cow;
use std::ops::Range;

use super::OutputError;
use crate::trajectory::Trajectory;

/// Columns of equal length.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    columns: Vec<Column>,
}

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name, e.g. `theta_dot`.
    pub name: String,
    /// SI unit, e.g. `rad/s`; empty for text.
    pub unit: String,
    /// One value per row.
    pub values: Values,
}

/// The values of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Numbers.
    Number(Vec<f64>),
    /// Texts.
    Text(Vec<Cow<'static, str>>),
}

impl Values {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            Values::Number(v) => v.len(),
            Values::Text(v) => v.len(),
        }
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Table {
    /// The columns, in order.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Takes the columns out of the table, in order.
    pub fn into_columns(self) -> Vec<Column> {
        self.columns
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |c| c.values.len())
    }

    /// The numbers of the column `name`; `None` if there is no such column of numbers.
    pub fn numbers(&self, name: &str) -> Option<&[f64]> {
        match &self.columns.iter().find(|c| c.name == name)?.values {
            Values::Number(values) => Some(values),
            Values::Text(_) => None,
        }
    }

    /// The texts of the column `name`; `None` if there is no such column of texts.
    pub fn words(&self, name: &str) -> Option<&[Cow<'static, str>]> {
        match &self.columns.iter().find(|c| c.name == name)?.values {
            Values::Text(values) => Some(values),
            Values::Number(_) => None,
        }
    }

    /// Adds a column. Errors: [`OutputError::Ragged`] if its length differs from that of the others.
    pub fn push(&mut self, name: &str, unit: &str, values: Values) -> Result<(), OutputError> {
        if !self.columns.is_empty() && values.len() != self.rows() {
            let (rows, expected) = (values.len(), self.rows());
            return Err(OutputError::Ragged { column: name.to_owned(), rows, expected });
        }
        self.columns.push(Column { name: name.to_owned(), unit: unit.to_owned(), values });
        Ok(())
    }

    /// The table of a trajectory: `t`, `moment`, each coordinate and its speed, the recorded outputs, then the energy account.
    ///
    /// Errors: [`OutputError::Ragged`] if a column has not exactly one entry per row.
    pub fn of_trajectory(run: &Trajectory) -> Result<Self, OutputError> {
        Self::of_rows(run, 0..run.len())
    }

    /// The tables of a trajectory in parts of `rows` rows, the last of which may be shorter; one empty part if it has no rows. A
    /// long trajectory is written part by part, so that it is not held in memory twice.
    pub fn parts(run: &Trajectory, rows: usize) -> impl Iterator<Item = Result<Self, OutputError>> {
        let parts = run.len().div_ceil(rows).max(1);
        (0..parts).map(move |i| Self::of_rows(run, i * rows..run.len().min((i + 1) * rows)))
    }

    /// The table of some rows of a trajectory. Errors: [`OutputError::Ragged`].
    fn of_rows(run: &Trajectory, rows: Range<usize>) -> Result<Self, OutputError> {
        let mut table = Table::default();
        for (i, series) in run.columns().enumerate() {
            let part = series.part(rows.clone()).ok_or_else(|| {
                let (column, rows) = (series.name.to_string(), series.rows());
                OutputError::Ragged { column, rows, expected: run.len() }
            })?;
            table.push(&series.name, &series.unit, Values::Number(part.into_owned()))?;
            if i == 0 {
                let moments = run.moment.iter().skip(rows.start).take(rows.len());
                table.push("moment", "", Values::Text(moments.map(|m| Cow::Borrowed(m.name())).collect()))?;
            }
        }
        Ok(table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::fixture::oscillator;

    #[test]
    fn a_trajectory_has_its_columns_in_order() {
        let table = Table::of_trajectory(&oscillator(100)).unwrap();
        let names: Vec<_> = table.columns().iter().map(|c| c.name.as_str()).collect();
        let expected = "t moment theta theta_dot phi phi_dot rotor_speed dte kinetic strain work work_drive work_load \
                        dissipated residual energy";
        assert_eq!(names, expected.split_whitespace().collect::<Vec<_>>());
        assert_eq!(table.columns()[3].unit, "rad/s");
    }

    #[test]
    fn columns_of_different_length_are_refused() {
        let mut run = oscillator(100);
        run.work.pop();
        assert!(matches!(Table::of_trajectory(&run), Err(OutputError::Ragged { .. })));
    }
}
