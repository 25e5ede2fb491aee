//! Results of runs, and figures.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyIterator};

use crate::argument::{self, Function};
use crate::error::raised;
use crate::interrupt::detached;
use crate::scene::Scene;
use crate::table::Table;

/// The results of a run: its recorded columns by name, its summary, plots and files.
#[pyclass(frozen, module = "gearsim")]
pub struct Results {
    inner: gearsim::Results,
    table: Py<Table>,
}

impl Results {
    pub fn new(inner: gearsim::Results) -> PyResult<Results> {
        let table = Table::new(inner.table())?;
        Ok(Results { inner, table: Python::attach(|py| Py::new(py, table))? })
    }
}

#[pymethods]
impl Results {
    /// A recorded column [SI]: `results["mesh_force_12"]`.
    fn __getitem__<'py>(&self, py: Python<'py>, name: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        Table::__getitem__(self.table.bind(py), name)
    }

    fn keys(&self) -> Vec<String> {
        self.table.get().columns()
    }

    fn __contains__(&self, #[pyo3(from_py_with = argument::column)] name: &str) -> bool {
        self.table.get().__contains__(name)
    }

    /// The names of the recorded columns, so that `dict(results)` has the columns by name.
    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        self.table.get().__iter__(py)
    }

    /// All recorded columns.
    #[getter]
    fn table(&self, py: Python<'_>) -> Py<Table> {
        self.table.clone_ref(py)
    }

    /// The scene that was run.
    #[getter]
    fn scene(&self) -> Scene {
        Scene { inner: self.inner.scene.clone() }
    }

    /// The summary, as the text of `summary.json`.
    fn _summary(&self) -> PyResult<String> {
        self.inner.summary().json().map_err(|error| raised(error.into()))
    }

    /// For each recorded event, the numbers of its row before and its row after.
    #[getter]
    fn events(&self) -> Vec<(usize, usize)> {
        self.inner.events().collect()
    }

    /// Raises if the run stopped early, or its energy account does not close.
    fn check(&self) -> PyResult<()> {
        self.inner.check().map_err(raised)
    }

    /// Draws a plot: `outputs`, `orders`, `energy`, `spectrum`, `motion`, ...
    #[pyo3(signature = (name="outputs"))]
    fn plot(&self, py: Python<'_>, #[pyo3(from_py_with = argument::plot)] name: &str) -> PyResult<Figure> {
        py.detach(|| self.inner.plot(name)).map(|inner| Figure { inner }).map_err(raised)
    }

    /// Writes the result files to `folder`, as `gearsim run` does, and returns their paths. With `html=True`, writes the interactive page
    /// `page.html` too.
    #[pyo3(signature = (folder, html=false))]
    fn write(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = argument::folder)] folder: PathBuf,
        #[pyo3(from_py_with = argument::html)] html: bool,
    ) -> PyResult<Vec<PathBuf>> {
        let written = py.detach(|| if html { self.inner.write_with_page(folder) } else { self.inner.write(folder) });
        written.map_err(raised)
    }

    /// The interactive page of the run in HTML: one file that needs no other files and no network.
    fn page(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| self.inner.page()).map_err(raised)
    }

    fn __repr__(&self) -> String {
        let run = self.inner.trajectory();
        let (scene, rows) = (&self.inner.scene.name, run.len());
        format!("gearsim.Results of {scene}: {rows} rows to t = {} s", run.t.last().copied().unwrap_or_default())
    }
}

/// Number of points in all curves of a figure in a notebook. The notebook stores the SVG text, about 80 kB with this number.
const SHOWN: usize = 4000;

/// Runs that are compared, by their names.
#[pyclass(frozen, module = "gearsim")]
pub struct Comparison {
    inner: gearsim::Comparison,
}

#[pymethods]
impl Comparison {
    /// Runs scenes one after the other. `progress` is called with the time that the present run has reached [s].
    #[new]
    #[pyo3(signature = (scenes, progress=None))]
    fn new(
        py: Python<'_>,
        #[pyo3(from_py_with = argument::scenes)] scenes: Vec<(String, Scene)>,
        #[pyo3(from_py_with = argument::progress)] progress: Option<Function>,
    ) -> PyResult<Self> {
        let scenes: Vec<_> = scenes.into_iter().map(|(name, scene)| (name, scene.inner)).collect();
        let run = detached(py, progress, |watch| gearsim::Comparison::of(scenes, &mut |t| watch.at_or_unwind(t)))?;
        Ok(Comparison { inner: run.map_err(raised)? })
    }

    /// The results of each run, by its name.
    #[getter]
    fn runs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (name, results) in &self.inner.runs {
            dict.set_item(name, Results::new(results.clone())?)?;
        }
        Ok(dict)
    }

    /// Draws the curves of all runs over each other: `outputs`, `energy`, `spectrum`, ...
    #[pyo3(signature = (name="outputs"))]
    fn plot(&self, py: Python<'_>, #[pyo3(from_py_with = argument::plot)] name: &str) -> PyResult<Figure> {
        py.detach(|| self.inner.plot(name)).map(|inner| Figure { inner }).map_err(raised)
    }

    fn __repr__(&self) -> String {
        let names: Vec<&str> = self.inner.runs.iter().map(|(name, _)| name.as_str()).collect();
        format!("gearsim.Comparison of {}", names.join(", "))
    }
}

/// A figure.
#[pyclass(frozen, module = "gearsim")]
pub struct Figure {
    inner: gearsim::plot::Figure,
}

#[pymethods]
impl Figure {
    /// The figure as SVG. If `points` is given, all curves together have about this many points; their extremes are kept.
    #[pyo3(signature = (points=None))]
    fn svg(&self, #[pyo3(from_py_with = argument::points)] points: Option<usize>) -> PyResult<String> {
        let svg = match points {
            Some(points) => self.inner.reduced(points).svg(),
            None => self.inner.svg(),
        };
        svg.map_err(|error| raised(error.into()))
    }

    /// The figure as PNG.
    fn png<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let png = py.detach(|| self.inner.png()).map_err(|error| raised(error.into()))?;
        Ok(PyBytes::new(py, &png))
    }

    fn _repr_svg_(&self) -> PyResult<String> {
        self.svg(Some(SHOWN))
    }
}
