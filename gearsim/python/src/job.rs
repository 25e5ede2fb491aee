//! Sweeps whose points are run in parts.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Mutex;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::argument::{self, Function};
use crate::error::{GearsimError, raised};
use crate::interrupt::detached;
use crate::scene::{Definition, Scene};
use crate::table::Table;
use crate::value;

/// The points of a sweep. A part is a range of their numbers; its rows are sent as bytes with a checksum.
#[pyclass(frozen, module = "gearsim")]
pub struct Job {
    inner: gearsim::Job,
}

impl Job {
    pub fn new(scene: &Scene, axes: &[String], definition: &Definition) -> PyResult<Job> {
        let variation = scene.variation(axes, definition);
        let variation = variation.ok_or_else(|| PyValueError::new_err("nothing is varied: give an axis"))?;
        Ok(Job { inner: variation.job().map_err(raised)? })
    }
}

#[pymethods]
impl Job {
    fn __len__(&self) -> usize {
        self.inner.points()
    }

    /// The axes, each as for the option `--vary`.
    #[getter]
    fn axes(&self) -> &[String] {
        self.inner.axes()
    }

    /// Runs the points from `first` to before `end` on `threads` threads, or on all cores of this machine, and returns their rows as bytes.
    /// `progress` is called with the number of finished points.
    #[pyo3(signature = (first, end, progress=None, threads=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = argument::first)] first: usize,
        #[pyo3(from_py_with = argument::end)] end: usize,
        #[pyo3(from_py_with = argument::progress)] progress: Option<Function>,
        #[pyo3(from_py_with = argument::threads)] threads: Option<NonZeroUsize>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = detached(py, progress, |watch| {
            let mut raised_by_watch = None;
            let rows = self.inner.run(first..end, threads, |count| match watch.now(count as f64) {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => {
                    raised_by_watch = Some(error);
                    ControlFlow::Break(())
                }
            });
            match raised_by_watch {
                Some(error) => Err(error),
                None => rows.and_then(|rows| self.inner.pack(&rows)).map_err(raised),
            }
        })?;
        Ok(PyBytes::new(py, &bytes?))
    }

    /// Mean, deviation and percentiles of each quantity. `table` has all points of the sweep.
    fn statistics(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = argument::table)] table: Bound<'_, Table>,
    ) -> PyResult<Table> {
        let table = table.get().inner()?;
        Table::new(py.detach(|| self.inner.statistics(&table)).map_err(raised)?)
    }

    /// Indices of sensitivity of each quantity. `table` has all points of a sweep with the design "saltelli".
    fn sensitivity(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = argument::table)] table: Bound<'_, Table>,
    ) -> PyResult<Table> {
        let table = table.get().inner()?;
        Table::new(py.detach(|| self.inner.sensitivity(&table)).map_err(raised)?)
    }

    /// The probability that each of the limits, `"mesh_force_12_max <= 5 kN"`, is broken, with its 95 % interval. `table` has all points of
    /// the sweep.
    fn limits(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = argument::table)] table: Bound<'_, Table>,
        limits: &Bound<'_, PyAny>,
    ) -> PyResult<Table> {
        let (table, limits) = (table.get().inner()?, value::one_or_more(limits, "limits")?);
        let limits: Vec<&str> = limits.iter().map(String::as_str).collect();
        Table::new(py.detach(|| self.inner.limits(&table, &limits)).map_err(raised)?)
    }

    /// Opens the folder in which finished rows are stored. It may contain points of an earlier run of the same sweep.
    fn gather(&self, #[pyo3(from_py_with = argument::folder)] folder: PathBuf) -> PyResult<Gathering> {
        Ok(Gathering { inner: Mutex::new(Some(self.inner.gather(folder).map_err(raised)?)) })
    }

    /// Ranges of at most `most` points that are not in the folder yet.
    fn missing(
        &self,
        #[pyo3(from_py_with = argument::gathering)] gathering: Bound<'_, Gathering>,
        #[pyo3(from_py_with = argument::most)] most: usize,
    ) -> PyResult<Vec<(usize, usize)>> {
        gathering.get().with(|inner| {
            let ranges = self.inner.missing(inner, most)?;
            Ok(ranges.into_iter().map(|range| (range.start, range.end)).collect())
        })
    }

    /// Keeps rows in the folder.
    fn keep(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = argument::gathering)] gathering: Bound<'_, Gathering>,
        #[pyo3(from_py_with = argument::rows)] rows: Bound<'_, PyBytes>,
    ) -> PyResult<()> {
        let bytes = rows.as_bytes();
        let gathering = gathering.get();
        py.detach(|| gathering.with(|inner| inner.keep_packed(bytes)))
    }
}

/// The folder of a running sweep.
#[pyclass(frozen, module = "gearsim")]
pub struct Gathering {
    inner: Mutex<Option<gearsim::Gathering>>,
}

impl Gathering {
    fn with<T>(&self, work: impl FnOnce(&mut gearsim::Gathering) -> Result<T, gearsim::Error>) -> PyResult<T> {
        let mut inner = self.inner.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        work(inner.as_mut().ok_or_else(finished)?).map_err(raised)
    }
}

#[pymethods]
impl Gathering {
    /// Closes the folder, so that another process can continue the sweep in it.
    fn close(&self) {
        self.inner.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).take();
    }

    /// Joins all rows to `sweep.parquet`, and returns their table. Its bytes are those of `gearsim sweep`.
    fn finish(&self, py: Python<'_>) -> PyResult<Table> {
        let inner = self.inner.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).take().ok_or_else(finished)?;
        Table::new(py.detach(|| inner.finish()).map_err(raised)?)
    }
}

fn finished() -> PyErr {
    GearsimError::new_err("this folder is finished: open it again by `job.gather`")
}
