//! A table as Parquet: compact, typed, with the unit of each column and the provenance inside.
//!
//! The unit is the field metadata `unit` of the Arrow schema; provenance is the file's key-value metadata.

use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

use arrow_array::{Array, ArrayRef, Float64Array, RecordBatch, StringArray};
use arrow_schema::{DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::Compression;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;

use super::OutputError;
use super::table::{Column, Table, Values};

/// Rows handed to the writer at a time, so that a long run is not held in memory twice.
const ROWS_AT_ONCE: usize = 1 << 16;

/// Writes `table` to `sink` with `provenance` as pairs of name and value.
///
/// Errors: [`OutputError::Sink`], [`OutputError::Format`].
pub fn write<'a>(
    table: &Table,
    provenance: impl IntoIterator<Item = (&'a str, &'a str)>,
    sink: impl Write + Send,
) -> Result<(), OutputError> {
    let provenance =
        provenance.into_iter().map(|(name, value)| KeyValue::new(name.to_owned(), value.to_owned())).collect();
    let properties = WriterProperties::builder()
        .set_created_by(concat!("gearsim ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::SNAPPY)
        .set_key_value_metadata(Some(provenance))
        .build();
    let schema = Arc::new(Schema::new(table.columns().iter().map(field).collect::<Vec<_>>()));
    let mut writer = ArrowWriter::try_new(sink, schema.clone(), Some(properties)).map_err(failed)?;
    for start in (0..table.rows()).step_by(ROWS_AT_ONCE) {
        let rows = start..table.rows().min(start + ROWS_AT_ONCE);
        let arrays = table.columns().iter().map(|c| array(&c.values, rows.clone())).collect();
        let batch = RecordBatch::try_new(schema.clone(), arrays).map_err(|e| OutputError::format("Parquet", e))?;
        writer.write(&batch).map_err(failed)?;
    }
    writer.close().map_err(failed)?;
    Ok(())
}

/// A table read from a file, and its provenance as pairs of name and value.
pub type TableAndProvenance = (Table, Vec<(String, String)>);

/// Reads a file written by [`write()`]. Errors: [`OutputError::Read`].
pub fn read(path: &Path) -> Result<TableAndProvenance, OutputError> {
    let failed = |why: String| OutputError::Read { path: path.to_owned(), why };
    let file = File::open(path).map_err(|e| failed(e.to_string()))?;
    let builder = ParquetRecordBatchReaderBuilder::try_new(file).map_err(|e| failed(e.to_string()))?;
    let schema = builder.schema().clone();
    let provenance = builder.metadata().file_metadata().key_value_metadata();
    let provenance = provenance
        .into_iter()
        .flatten()
        .filter(|pair| !pair.key.starts_with("ARROW:"))
        .map(|pair| (pair.key.clone(), pair.value.clone().unwrap_or_default()))
        .collect();

    let mut columns: Vec<Values> = (schema.fields().iter())
        .map(|field| match field.data_type() {
            DataType::Float64 => Values::Number(vec![]),
            _ => Values::Text(vec![]),
        })
        .collect();
    for batch in builder.build().map_err(|e| failed(e.to_string()))? {
        let batch = batch.map_err(|e| failed(e.to_string()))?;
        for (values, array) in columns.iter_mut().zip(batch.columns()) {
            append(values, array).ok_or_else(|| failed(format!("unexpected column type {}", array.data_type())))?;
        }
    }
    let mut table = Table::default();
    for (field, values) in schema.fields().iter().zip(columns) {
        let unit = field.metadata().get("unit").map_or("", String::as_str);
        table.push(field.name(), unit, values)?;
    }
    Ok((table, provenance))
}

fn field(column: &Column) -> Field {
    let data_type = match column.values {
        Values::Number(_) => DataType::Float64,
        Values::Text(_) => DataType::Utf8,
    };
    Field::new(&column.name, data_type, false).with_metadata([("unit".to_owned(), column.unit.clone())].into())
}

fn array(values: &Values, rows: std::ops::Range<usize>) -> ArrayRef {
    match values {
        Values::Number(v) => Arc::new(Float64Array::from(v[rows].to_vec())),
        Values::Text(v) => Arc::new(StringArray::from_iter_values(&v[rows])),
    }
}

/// Appends `array` to `values`; `None` if it is of another type or has missing entries.
fn append(values: &mut Values, array: &ArrayRef) -> Option<()> {
    if array.null_count() > 0 {
        return None;
    }
    match values {
        Values::Number(v) => {
            v.extend_from_slice(array.as_any().downcast_ref::<Float64Array>()?.values());
        }
        Values::Text(v) => {
            let words = array.as_any().downcast_ref::<StringArray>()?;
            v.extend(words.iter().flatten().map(|word| word.to_owned().into()));
        }
    }
    Some(())
}

/// A full disk must be reported as such, not as bad Parquet.
fn failed(error: parquet::errors::ParquetError) -> OutputError {
    match error {
        parquet::errors::ParquetError::External(e) => match e.downcast::<std::io::Error>() {
            Ok(e) => OutputError::Sink(*e),
            Err(e) => OutputError::format("Parquet", e),
        },
        other => OutputError::format("Parquet", other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::fixture::oscillator;

    #[test]
    fn what_is_read_back_is_what_was_written() {
        // More rows than are handed over at once.
        let table = Table::of_trajectory(&oscillator(ROWS_AT_ONCE + 10)).unwrap();
        let file = tempfile::NamedTempFile::new().unwrap();
        write(&table, [("scene", "test"), ("commit", "")], &file).unwrap();
        let (back, provenance) = read(file.path()).unwrap();
        assert!(back == table, "{} columns, {} rows", back.columns().len(), back.rows());
        let pairs: Vec<_> = provenance.iter().map(|(n, v)| (n.as_str(), v.as_str())).collect();
        assert_eq!(pairs, [("scene", "test"), ("commit", "")]);
    }

    #[test]
    fn a_full_disk_is_an_error_of_the_sink() {
        struct Full;
        impl Write for Full {
            fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
                Err(std::io::ErrorKind::StorageFull.into())
            }
            fn flush(&mut self) -> std::io::Result<()> {
                Ok(())
            }
        }
        let table = Table::of_trajectory(&oscillator(10)).unwrap();
        assert!(matches!(write(&table, [], Full), Err(OutputError::Sink(_))));
    }
}
