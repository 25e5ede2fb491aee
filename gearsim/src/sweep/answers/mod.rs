//! Results of a finished sweep with random axes: statistics of each quantity, probabilities that limits are broken, and sensitivity
//! indices. Each is computed at every point of the grid of the other axes, from the table of the points alone.

pub mod limit;
pub mod sensitivity;
pub mod statistics;
#[cfg(test)]
mod tests;

use super::axis::Axis;
use super::folder::Rows;
use super::manifest::Layout;
use super::row::{self, Row, Status};
use crate::output::{OutputError, Table};

/// The samples at one point of the grid; without random axes, all points.
pub struct Block<'a> {
    /// The values of all axes at its first point; those that are not random are the same at all of its points.
    values: Vec<String>,
    /// Its rows in the order of its samples; `None` if the point did not run to its end, or its account does not close.
    rows: Vec<Option<&'a Row>>,
}

impl<'a> Block<'a> {
    /// The blocks of a complete sweep.
    pub fn all(layout: &Layout, rows: &'a Rows) -> Vec<Block<'a>> {
        let size = if layout.plan.is_random() { layout.plan.block() } else { rows.len().max(1) };
        let done = |point: usize| rows.get(&point).filter(|row| row.status == Status::Done);
        let block =
            |first: usize| Block { values: layout.plan.values(first), rows: (first..first + size).map(done).collect() };
        (0..rows.len()).step_by(size).map(block).collect()
    }

    /// The block without the samples of the design that repeat values of other samples.
    pub fn independent(&self, layout: &Layout) -> Block<'a> {
        let rows = self.rows.iter().enumerate().filter(|(i, _)| layout.plan.sampler.is_independent(*i));
        Block { values: self.values.clone(), rows: rows.map(|(_, row)| *row).collect() }
    }

    /// The recorded quantity `column` of each point that ran to its end; numbers that do not exist are left out.
    fn numbers(&self, column: usize) -> impl Iterator<Item = f64> {
        self.rows.iter().flatten().map(move |row| row.numbers[column]).filter(|x| x.is_finite())
    }

    /// The values that define the point of the grid, as text: `start.speed = 300 rpm`. Empty if there is no grid of blocks.
    pub fn name(&self, layout: &Layout) -> String {
        let fixed = layout.plan.axes.iter().zip(&self.values).filter(|(axis, _)| is_of_grid(layout, axis));
        fixed.map(|(axis, value)| format!("{} = {value}", axis.key)).collect::<Vec<_>>().join(", ")
    }
}

/// Whether an axis has one value in each block.
fn is_of_grid(layout: &Layout, axis: &Axis) -> bool {
    layout.plan.is_random() && axis.count().is_some()
}

/// A table that begins with the values of the axes that are not random, one entry per row: `blocks` are the blocks of the rows.
fn table(layout: &Layout, blocks: &[&Block<'_>]) -> Result<Table, OutputError> {
    let mut table = Table::default();
    for (i, (axis, unit)) in layout.plan.axes.iter().zip(&layout.units).enumerate() {
        if is_of_grid(layout, axis) {
            row::push_values(&mut table, axis, unit, blocks.iter().map(|block| block.values[i].clone()).collect())?;
        }
    }
    Ok(table)
}
