//! A sweep whose points are run in parts: by threads, by processes, by machines.

use std::num::NonZeroUsize;
use std::ops::{ControlFlow, Range};
use std::path::Path;

use super::{Error, packed, provenance};
use crate::known;
use crate::output::Table;
use crate::sweep::answers::limit::{self, Limit};
use crate::sweep::answers::{Block, sensitivity, statistics};
use crate::sweep::folder::{self, Folder};
use crate::sweep::manifest::Layout;
use crate::sweep::row::{self, Row};
use crate::sweep::{Design, Manifest, Request, Sweep};

/// A checked sweep. The result of a point depends on its number alone, so that the table does not depend on the division into parts.
pub struct Job {
    sweep: Sweep,
    manifest: Manifest,
    layout: Layout,
}

/// The rows of some points.
#[derive(Debug, Clone)]
pub struct Rows(Vec<Row>);

/// The folder of a sweep under way: what is finished stays there, also if the program ends.
pub struct Gathering {
    folder: Folder,
}

impl Job {
    pub(super) fn new(sweep: Sweep, request: &Request) -> Result<Job, Error> {
        let manifest = Manifest::new(&sweep, request, provenance::COMMIT);
        let layout = manifest.layout(known::models())?;
        Ok(Job { sweep, manifest, layout })
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.sweep.points
    }

    /// The axes, each as for the option `--vary`.
    pub fn axes(&self) -> &[String] {
        &self.manifest.vary
    }

    /// Runs some points on `threads` threads, or on all cores. `watch` gets the number of finished points. If it returns `Break`,
    /// no further points are run, and the result has only the rows of the finished ones.
    ///
    /// # Errors
    /// If there are no such points, or threads cannot be started.
    pub fn run(
        &self,
        points: Range<usize>,
        threads: Option<NonZeroUsize>,
        watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<Rows, Error> {
        if points.end > self.points() {
            let what = format!("the sweep has {} points, not {}", self.points(), points.end);
            return Err(Error::impossible(what, "points are counted from 0"));
        }
        let threads = threads.unwrap_or_else(|| std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN));
        let mut rows = Vec::with_capacity(points.len());
        let keep = |new| {
            rows.extend(new);
            Ok(())
        };
        self.sweep.run(&points.collect::<Vec<_>>(), threads, keep, watch)?;
        rows.sort_by_key(|row: &Row| row.point);
        Ok(Rows(rows))
    }

    /// The table of rows.
    ///
    /// # Errors
    /// If the rows are those of another sweep.
    pub fn table(&self, rows: &Rows) -> Result<Table, Error> {
        let Layout { plan, columns, units, .. } = &self.layout;
        Ok(row::table(plan, columns, units, &rows.0.iter().collect::<Vec<_>>())?)
    }

    /// Mean, deviation and percentiles of each quantity over the random points. There is one row for each quantity at each grid point.
    /// `table` has all points of the sweep.
    ///
    /// # Errors
    /// If the table is not that of all points of this sweep.
    pub fn statistics(&self, table: &Table) -> Result<Table, Error> {
        let rows = self.complete(table)?;
        Ok(statistics::table(&self.layout, &Block::all(&self.layout, &rows))?)
    }

    /// Indices of sensitivity (A. Saltelli et al., 2010). There is one row for each axis and quantity. `first_order` is the share of the
    /// quantity's variance that the axis causes alone, `total` the share with interactions. The columns `_bound` are half the widths of
    /// the 95 % intervals. `table` has all points of the sweep.
    ///
    /// # Errors
    /// As [`Job::statistics`], and if the design is not [`Design::Saltelli`].
    pub fn sensitivity(&self, table: &Table) -> Result<Table, Error> {
        if self.layout.plan.sampler.design != Design::Saltelli {
            let what = "indices of sensitivity need the points of their own design";
            return Err(Error::impossible(what, "vary by the design `saltelli`"));
        }
        let rows = self.complete(table)?;
        Ok(sensitivity::table(&self.layout, &Block::all(&self.layout, &rows))?)
    }

    /// The probability that each limit, `mesh_force_12_max <= 5 kN`, is broken at a random point, with the ends of its 95 % interval. There
    /// is one row for each limit at each grid point. Points of a grid without random axes are counted and have no probability. `table` has
    /// all points of the sweep.
    ///
    /// # Errors
    /// As [`Job::statistics`], and if a limit has no comparison, names no recorded quantity, or has a value of another dimension.
    pub fn limits(&self, table: &Table, limits: &[&str]) -> Result<Table, Error> {
        let read = limits.iter().map(|text| Limit::read(text, &self.layout)).collect::<Result<Vec<_>, _>>()?;
        let rows = self.complete(table)?;
        Ok(limit::table(&self.layout, &Block::all(&self.layout, &rows), &read)?)
    }

    /// The rows of a table of all points.
    fn complete(&self, table: &Table) -> Result<folder::Rows, Error> {
        let not_of_this = |what: String| Error::impossible(what, "give the table that this sweep has returned");
        let rows = row::read(table, &self.layout.columns).ok_or_else(|| {
            let columns: Vec<&str> = self.layout.columns.iter().map(|(name, _)| name.as_str()).collect();
            not_of_this(format!("this table is not that of the sweep, which has the columns {}", columns.join(", ")))
        })?;
        let rows: folder::Rows = rows.into_iter().map(|row| (row.point, row)).collect();
        if table.rows() != self.points() || !rows.keys().copied().eq(0..self.points()) {
            let what = format!("this table has {} points, not all {} of the sweep", rows.len(), self.points());
            return Err(not_of_this(what));
        }
        match row::strange(table, &self.layout.plan) {
            Some(key) => Err(not_of_this(format!("this table is that of another sweep: its values of `{key}` differ"))),
            None => Ok(rows),
        }
    }

    /// Rows as bytes, to be sent to the process that gathers them ([`Gathering::keep_packed`]): the file of a part, with a checksum.
    ///
    /// # Errors
    /// As [`Job::table`].
    pub fn pack(&self, rows: &Rows) -> Result<Vec<u8>, Error> {
        let rows = folder::in_order(&rows.0);
        let first = rows.first().map_or(0, |row| row.point);
        let file = folder::table_in_bytes(&self.manifest, &self.layout, &rows)?;
        Ok(packed::pack(&self.manifest, first, &file)?)
    }

    /// Opens the folder of the sweep, as `gearsim sweep --out` does. It may hold finished points of an earlier run of the same sweep.
    ///
    /// # Errors
    /// If it holds another sweep, if another process writes to it, or if it cannot be written to.
    pub fn gather(&self, folder: impl AsRef<Path>) -> Result<Gathering, Error> {
        let folder = Folder::open(folder.as_ref(), self.manifest.clone(), self.layout.clone())?;
        Ok(Gathering { folder })
    }

    /// The points that are not in the folder yet, as ranges of at most `most` points.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn missing(&self, gathering: &Gathering, most: usize) -> Result<Vec<Range<usize>>, Error> {
        let there = gathering.folder.rows()?;
        let mut ranges: Vec<Range<usize>> = vec![];
        for point in (0..self.points()).filter(|point| !there.contains_key(point)) {
            match ranges.last_mut() {
                Some(last) if last.end == point && last.len() < most.max(1) => last.end += 1,
                _ => ranges.push(point..point + 1),
            }
        }
        Ok(ranges)
    }
}

impl Gathering {
    /// Writes rows to the folder. If this fails, none of them are in it.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn keep(&mut self, rows: &Rows) -> Result<(), Error> {
        Ok(self.folder.keep(&rows.0)?)
    }

    /// Writes rows that [`Job::pack`] has packed, perhaps on another machine. The rows are not unpacked, because for short runs
    /// this would take a twentieth of the time of the run.
    ///
    /// # Errors
    /// If the bytes are damaged, are those of another sweep, or cannot be written.
    pub fn keep_packed(&mut self, bytes: &[u8]) -> Result<(), Error> {
        let (first, file) = packed::unpack(self.folder.manifest(), bytes)?;
        Ok(self.folder.keep_bytes(first, file)?)
    }

    /// Joins all rows to the file `sweep.parquet`, whose bytes depend on the sweep alone, and returns their table.
    ///
    /// # Errors
    /// If a file cannot be read or written.
    pub fn finish(self) -> Result<Table, Error> {
        let path = self.folder.path().to_owned();
        let (_, table) = self.folder.finish()?;
        folder::end(&path)?;
        Ok(table)
    }
}
