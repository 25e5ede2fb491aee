//! Scenes.

use std::cell::RefCell;
use std::path::PathBuf;

use gearsim::Scene as Inner;
use gearsim::sweep::response::Hold;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::argument::{self, Function, Mapping};
use crate::error::raised;
use crate::interrupt::{detached, left};
use crate::job::Job;
use crate::results::Results;
use crate::table::Table;
use crate::value;

/// A scene: a model, its active effects, its numbers, and an end time.
#[pyclass(frozen, module = "gearsim", from_py_object)]
#[derive(Clone)]
pub struct Scene {
    pub inner: Inner,
}

/// How a sweep is defined, beside its axes.
pub struct Definition {
    pub record: Vec<String>,
    pub start: Option<f64>,
    pub samples: Option<(usize, u64)>,
    pub design: gearsim::Design,
}

impl Scene {
    /// The sweep over axes, each a text as for `--vary`. `None` if there are no axes.
    pub fn variation(&self, axes: &[String], definition: &Definition) -> Option<gearsim::Variation> {
        let mut axes = axes.iter();
        let first = self.inner.vary(axes.next()?);
        let record: Vec<&str> = definition.record.iter().map(String::as_str).collect();
        let mut variation = axes.fold(first, |variation, axis| variation.vary(axis));
        if let Some(start) = definition.start {
            variation = variation.from(start);
        }
        if !record.is_empty() {
            variation = variation.record(&record);
        }
        variation = variation.design(definition.design);
        Some(match definition.samples {
            Some((samples, seed)) => variation.samples(samples, seed),
            None => variation,
        })
    }
}

/// Name, text and overrides of a scene, from which pickle makes it again.
type Saved = (String, String, Vec<String>);

#[pymethods]
impl Scene {
    /// Builds a scene of a model from keyword arguments: the tables of a scene file, e.g. `parameters={"I1": "0.5 kg*m^2"}`. Numbers
    /// are in SI units.
    #[new]
    #[pyo3(signature = (model, effects=None, name=None, **tables))]
    fn new(
        #[pyo3(from_py_with = argument::model)] model: &str,
        effects: Option<&Bound<'_, PyAny>>,
        #[pyo3(from_py_with = argument::scene_name)] name: Option<&str>,
        tables: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let effects = effects.map_or(Ok(vec![]), |effects| value::names(effects, "effects"))?;
        let effects: Vec<&str> = effects.iter().map(String::as_str).collect();
        let mut builder = Inner::of_model(model).name(name.unwrap_or(model)).effects(&effects);
        for (key, value) in tables.map_or(Ok(vec![]), |tables| value::flat(tables, ""))? {
            builder = builder.set(&key, value);
        }
        Ok(Scene { inner: builder.build().map_err(raised)? })
    }

    /// Reads a scene file.
    #[staticmethod]
    fn load(py: Python<'_>, #[pyo3(from_py_with = argument::path)] path: PathBuf) -> PyResult<Self> {
        Ok(Scene { inner: py.detach(|| Inner::load(path)).map_err(raised)? })
    }

    /// Reads a scene from its text in TOML.
    #[staticmethod]
    #[pyo3(signature = (text, name="scene"))]
    fn from_toml(
        py: Python<'_>,
        #[pyo3(from_py_with = argument::text)] text: &str,
        #[pyo3(from_py_with = argument::scene_name)] name: &str,
    ) -> PyResult<Self> {
        Ok(Scene { inner: py.detach(|| Inner::from_toml(name, text)).map_err(raised)? })
    }

    /// The same scene with other values: `scene.replace({"parameters.T0": 20.0})`, `scene.replace(run={"t_end": "1 s"})`.
    #[pyo3(signature = (values=None, **tables))]
    fn replace(
        &self,
        #[pyo3(from_py_with = argument::values)] values: Option<Mapping<'_>>,
        tables: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let mut all = vec![];
        for table in [values.as_ref().map(|values| &values.0), tables].into_iter().flatten() {
            all.extend(value::flat(table, "")?);
        }
        let all = all.iter().map(|(key, value)| (key.as_str(), value.clone()));
        Ok(Scene { inner: self.inner.with_all(all).map_err(raised)? })
    }

    /// Runs the scene. `progress` is called with the time reached [s] now and then.
    #[pyo3(signature = (progress=None))]
    fn run(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = argument::progress)] progress: Option<Function>,
    ) -> PyResult<Results> {
        let run = detached(py, progress, |watch| self.inner.run_watched(&mut |t| watch.at_or_unwind(t)))?;
        Results::new(run.map_err(raised)?)
    }

    /// The scene as text in TOML, with the values that were set; comments stay. `Scene.from_toml` reads it; the run of
    /// that scene has the same numbers, bit for bit.
    fn to_toml(&self) -> PyResult<String> {
        self.inner.to_toml().map_err(raised)
    }

    /// The scene under the exact, the rigid kinematic and the classical equations, by the names of these, as `gearsim compare` runs it.
    fn equation_sets<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (name, inner) in self.inner.equation_sets().map_err(raised)? {
            dict.set_item(name, Scene { inner })?;
        }
        Ok(dict)
    }

    /// Natural frequencies [Hz], damping factors and shapes at the mid stiffnesses, or at `levels` [SI]: one dict per mode. A shape has one
    /// number for each of the `coordinates` of the scene. `strain_energy` and `kinetic_energy` are dicts too: the shares of the stiffnesses
    /// and of the inertias, by their names in the scene. `strain_energy` is empty for a rigid motion.
    #[pyo3(signature = (levels=None))]
    fn modes<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = argument::levels)] levels: Option<Vec<f64>>,
    ) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let levels = levels.unwrap_or_else(|| self.inner.mid_stiffnesses());
        let scene = self.inner.clone();
        let cell = left(py, move |watch| scene.modes_watched(&levels, watch))?.map_err(raised)?;
        let elastic: Vec<_> = self.inner.stiffnesses().map(|(law, _)| law.name).chain(cell.springs).collect();
        let mode = |mode: gearsim::analysis::modes::Vibration| {
            let strain = mode.strain.into_iter().chain(mode.springs);
            let dict = PyDict::new(py);
            dict.set_item("natural_frequency", mode.natural)?;
            dict.set_item("damped_frequency", mode.damped)?;
            dict.set_item("damping_factor", mode.zeta)?;
            dict.set_item("shape", mode.shape)?;
            dict.set_item("strain_energy", elastic.iter().zip(strain).into_py_dict(py)?)?;
            dict.set_item("kinetic_energy", cell.inertias.iter().zip(mode.kinetic).into_py_dict(py)?)?;
            Ok(dict)
        };
        cell.modes.into_iter().map(mode).collect()
    }

    /// Stability of the steady rotation: Floquet multipliers, period [s], verdict.
    fn floquet<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let scene = self.inner.clone();
        let floquet = left(py, move |watch| scene.floquet_watched(watch))?.map_err(raised)?;
        let dict = PyDict::new(py);
        dict.set_item("period", floquet.period)?;
        dict.set_item("growth", floquet.growth())?;
        dict.set_item("unstable", floquet.verdict.is_unstable())?;
        dict.set_item("multipliers", floquet.multipliers)?;
        Ok(dict)
    }

    /// Which effects the scene needs, as the text of `gearsim advise --json`.
    #[pyo3(signature = (progress))]
    fn _advise(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = argument::progress)] progress: Option<Function>,
    ) -> PyResult<String> {
        let advice = detached(py, progress, |watch| {
            let watch = RefCell::new(watch);
            self.inner
                .advise_watched(&|t| watch.borrow_mut().at_or_unwind(t))
                .and_then(|advice| advice.json(&self.inner))
        })?;
        advice.map_err(raised)
    }

    /// The response curve of the recorded outputs over an axis, upward and downward. Each point is measured from its time `start` [s] on.
    /// The axis is a text as for `--vary`, or a dict of its key and its rising values: `{"start.speed": numpy.linspace(10.0, 90.0, 50)}`.
    /// For each output the table has `_mean`, `_rms`, the root mean square about the mean, and `_peak_to_peak`. `hold` is the parameter
    /// that holds the speed, or "nothing". Without `hold`, a varied speed is held by the set point of a governor if there is one, else by
    /// a torque. `progress` is called with the number of finished points now and then.
    #[pyo3(signature = (axis, start=None, progress=None, hold=None))]
    fn response(
        &self,
        py: Python<'_>,
        axis: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = argument::axis_start)] start: Option<f64>,
        #[pyo3(from_py_with = argument::progress)] progress: Option<Function>,
        #[pyo3(from_py_with = argument::hold)] hold: Option<&str>,
    ) -> PyResult<Table> {
        let [axis] = &value::axes(axis, &self.inner)?[..] else {
            return Err(PyValueError::new_err("a response has one axis: give one key with its values"));
        };
        let mut variation = self.inner.vary(axis).hold(Hold::named(hold));
        if let Some(start) = start {
            variation = variation.from(start);
        }
        let table = detached(py, progress, |watch| {
            let response = variation.response_watched(&mut |done| watch.at_or_unwind(done as f64))?;
            Ok(response.table()?)
        })?;
        Table::new(table.map_err(raised)?)
    }

    /// The points of a sweep over `axes`, to be run here or elsewhere: a text as for the option `--vary`, a dict of keys and values, or a
    /// list of these. `record` names groups of quantities, or one.
    #[pyo3(signature = (axes, record=None, start=None, samples=None, seed=0, design="random"))]
    fn job(
        &self,
        axes: &Bound<'_, PyAny>,
        record: Option<&Bound<'_, PyAny>>,
        #[pyo3(from_py_with = argument::axis_start)] start: Option<f64>,
        #[pyo3(from_py_with = argument::samples)] samples: Option<usize>,
        #[pyo3(from_py_with = argument::seed)] seed: u64,
        #[pyo3(from_py_with = argument::design)] design: &str,
    ) -> PyResult<Job> {
        let design = design.parse().map_err(PyValueError::new_err)?;
        let record = match record {
            Some(record) => value::one_or_more(record, "record")?,
            None => vec![],
        };
        let definition = Definition { record, start, samples: samples.map(|samples| (samples, seed)), design };
        Job::new(self, &value::axes(axes, &self.inner)?, &definition)
    }

    /// Accelerations at a state and law values [SI], with every play closed, for comparison with hand-written equations.
    fn acceleration(
        &self,
        #[pyo3(from_py_with = argument::q)] q: Vec<f64>,
        #[pyo3(from_py_with = argument::q_dot)] q_dot: Vec<f64>,
        #[pyo3(from_py_with = argument::laws)] laws: Vec<f64>,
    ) -> PyResult<Vec<f64>> {
        self.inner.acceleration(&q, &q_dot, &laws).map_err(raised)
    }

    #[getter]
    fn name(&self) -> &str {
        &self.inner.name
    }

    #[getter]
    fn model(&self) -> &str {
        self.inner.model.name
    }

    #[getter]
    fn about(&self) -> &str {
        &self.inner.about
    }

    #[getter]
    fn effects(&self) -> Vec<&'static str> {
        self.inner.effects.names(self.inner.model)
    }

    /// Names of the coordinates, in the order of the numbers of mode shapes and of `acceleration`.
    #[getter]
    fn coordinates(&self) -> Vec<&'static str> {
        self.inner.model.coordinates.iter().map(|coordinate| coordinate.name).collect()
    }

    /// Values of the parameters [SI].
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (parameter, value) in self.inner.model.parameters.iter().zip(&self.inner.parameters) {
            if !value.is_nan() {
                dict.set_item(parameter.name, value)?;
            }
        }
        Ok(dict)
    }

    /// End time [s].
    #[getter]
    fn t_end(&self) -> f64 {
        self.inner.t_end
    }

    fn __repr__(&self) -> String {
        let effects = self.effects().join(", ");
        format!("gearsim.Scene: {}, model {}, effects [{effects}]", self.inner.name, self.inner.model.name)
    }

    /// Text, name and set values, which `_restore` needs: scenes are sent to other processes in this form.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Saved)> {
        let restore = py.import("gearsim._gearsim")?.getattr("Scene")?.getattr("_restore")?;
        Ok((restore, (self.inner.name.clone(), self.inner.text.to_string(), self.inner.overrides.clone())))
    }

    #[staticmethod]
    fn _restore(
        #[pyo3(from_py_with = argument::scene_name)] name: &str,
        #[pyo3(from_py_with = argument::text)] text: &str,
        #[pyo3(from_py_with = argument::overrides)] overrides: Vec<String>,
    ) -> PyResult<Self> {
        let mut inner = Inner::from_toml_with(name, text, &overrides).map_err(raised)?;
        inner.name = name.into();
        Ok(Scene { inner })
    }
}
