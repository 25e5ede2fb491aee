//! Tables: columns with units, as NumPy arrays and, without a copy, as Arrow.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{ArrayRef, Float64Array, RecordBatch, RecordBatchIterator, StringArray};
use arrow_schema::{DataType, Field, Schema};
use gearsim::output::table::Values;
use pyo3::exceptions::{PyKeyError, PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict, PyIterator};

use crate::argument;
use crate::error::raised;

/// Key of the unit in the metadata of an Arrow field.
const UNIT: &str = "unit";

/// A table. Its columns are read-only NumPy arrays by name, without a copy. The table is an Arrow stream:
/// `pyarrow.table(table)` and `polars.DataFrame(table)` make no copy, `pandas.DataFrame.from_arrow(table)` makes one.
#[pyclass(frozen, module = "gearsim")]
pub struct Table {
    batch: RecordBatch,
}

impl Table {
    /// The columns of a table; they are moved, not copied.
    pub fn new(table: gearsim::output::Table) -> PyResult<Table> {
        let (mut fields, mut arrays) = (vec![], Vec::<ArrayRef>::new());
        for column in table.into_columns() {
            let (kind, array): (_, ArrayRef) = match column.values {
                Values::Number(numbers) => (DataType::Float64, Arc::new(Float64Array::from(numbers))),
                Values::Text(texts) => (DataType::Utf8, Arc::new(StringArray::from_iter_values(texts))),
            };
            let metadata = HashMap::from([(UNIT.to_string(), column.unit)]);
            fields.push(Field::new(column.name, kind, false).with_metadata(metadata));
            arrays.push(array);
        }
        let batch = RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays);
        Ok(Table { batch: batch.map_err(|error| PyRuntimeError::new_err(error.to_string()))? })
    }

    /// A copy of the table as the type of gearsim.
    pub fn inner(&self) -> PyResult<gearsim::output::Table> {
        let mut table = gearsim::output::Table::default();
        for (field, array) in self.batch.schema().fields().iter().zip(self.batch.columns()) {
            let values = match array.as_any().downcast_ref::<Float64Array>() {
                Some(numbers) => Values::Number(numbers.values().to_vec()),
                None => Values::Text(texts(array).map(|text| text.to_owned().into()).collect()),
            };
            let unit = field.metadata().get(UNIT).map_or("", String::as_str);
            table.push(field.name(), unit, values).map_err(|error| raised(error.into()))?;
        }
        Ok(table)
    }
}

/// The texts of a column; none if it has numbers.
fn texts(array: &ArrayRef) -> impl Iterator<Item = &str> {
    array.as_any().downcast_ref::<StringArray>().into_iter().flatten().map(Option::unwrap_or_default)
}

#[pymethods]
impl Table {
    /// Names of the columns.
    #[getter]
    pub fn columns(&self) -> Vec<String> {
        self.batch.schema().fields().iter().map(|field| field.name().clone()).collect()
    }

    /// SI unit of each column; empty for text.
    #[getter]
    fn units(&self) -> HashMap<String, String> {
        let unit = |field: &Arc<Field>| (field.name().clone(), field.metadata().get(UNIT).cloned().unwrap_or_default());
        self.batch.schema().fields().iter().map(unit).collect()
    }

    fn __len__(&self) -> usize {
        self.batch.num_rows()
    }

    fn keys(&self) -> Vec<String> {
        self.columns()
    }

    /// The names of the columns, so that `list(table)` has them and `dict(table)` the columns by name.
    pub fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        self.columns().into_pyobject(py)?.try_iter()
    }

    pub fn __contains__(&self, #[pyo3(from_py_with = argument::column)] name: &str) -> bool {
        self.batch.column_by_name(name).is_some()
    }

    /// A column: a NumPy array of numbers, or a list of texts.
    pub fn __getitem__<'py>(table: &Bound<'py, Self>, name: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let this = table.get();
        let Ok(name) = name.extract::<&str>() else {
            let (kind, columns) = (name.get_type().name()?, this.columns());
            let first = columns.first().map_or("t", String::as_str);
            return Err(PyTypeError::new_err(format!(
                "columns are read by their names, which are texts, not {kind}: table[{first:?}] is a column, table[{first:?}][0] its number in \
                 the first row; the columns are {}",
                columns.join(", ")
            )));
        };
        let array = this.batch.column_by_name(name).ok_or_else(|| {
            PyKeyError::new_err(format!("there is no column `{name}`; the columns are {}", this.columns().join(", ")))
        })?;
        match array.as_any().downcast_ref::<Float64Array>() {
            Some(numbers) => {
                let column = Bound::new(table.py(), Column { numbers: numbers.clone() })?;
                table.py().import("numpy")?.call_method1("asarray", (column,))
            }
            None => texts(array).collect::<Vec<_>>().into_pyobject(table.py()),
        }
    }

    /// The table as an Arrow stream (PyCapsule interface).
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // By the specification a request for a schema need not be fulfilled. Each column has only one type, so the request is ignored.
        drop(requested_schema);
        let batches = RecordBatchIterator::new([Ok(self.batch.clone())], self.batch.schema());
        PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(batches)), c"arrow_array_stream")
    }

    fn __repr__(&self) -> String {
        format!("gearsim.Table: {} rows of {}", self.batch.num_rows(), self.columns().join(", "))
    }
}

/// A column of numbers. Its NumPy array refers to it and reads its memory, which is neither moved nor changed.
#[pyclass(frozen, module = "gearsim._gearsim")]
struct Column {
    numbers: Float64Array,
}

#[pymethods]
impl Column {
    /// Version 3 of NumPy's array interface: the address of the numbers, read-only.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let numbers = self.numbers.values();
        let dict = PyDict::new(py);
        dict.set_item("version", 3)?;
        dict.set_item("shape", (numbers.len(),))?;
        dict.set_item("typestr", if cfg!(target_endian = "little") { "<f8" } else { ">f8" })?;
        dict.set_item("data", (numbers.as_ptr().addr(), true))?;
        Ok(dict)
    }
}
