//! A table of named columns with units; all results with rows are written as such tables.

use std::borrow::Cow;

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

    /// The table of a trajectory: `t`, `moment`, each coordinate and its speed, then the energy account.
    ///
    /// Errors: [`OutputError::Ragged`] if a column has not exactly one entry per row.
    pub fn of_trajectory(run: &Trajectory) -> Result<Self, OutputError> {
        let number = |v: &Vec<f64>| Values::Number(v.clone());
        let moment = run.moment.iter().map(|m| Cow::Borrowed(m.name())).collect();
        let energy: Vec<f64> = (run.kinetic.iter().zip(&run.strain).zip(&run.work))
            .map(|((kinetic, strain), work)| kinetic + strain - work)
            .collect();

        let mut table = Table::default();
        table.push("t", "s", number(&run.t))?;
        table.push("moment", "", Values::Text(moment))?;
        for ((coordinate, q), q_dot) in run.model.coordinates.iter().zip(&run.q).zip(&run.q_dot) {
            let (name, unit) = (coordinate.name, coordinate.unit);
            table.push(name, unit, number(q))?;
            table.push(&format!("{name}_dot"), &format!("{unit}/s"), number(q_dot))?;
        }
        table.push("kinetic", "J", number(&run.kinetic))?;
        table.push("strain", "J", number(&run.strain))?;
        table.push("work", "J", number(&run.work))?;
        for (torque, work) in run.model.torques.iter().zip(&run.torque_work) {
            table.push(&format!("work_{}", torque.name), "J", number(work))?;
        }
        table.push("dissipated", "J", number(&run.dissipated))?;
        table.push("residual", "J", number(&run.residual))?;
        table.push("energy", "J", Values::Number(energy))?;
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
        let expected = "t moment theta theta_dot phi phi_dot kinetic strain work work_drive work_load \
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
