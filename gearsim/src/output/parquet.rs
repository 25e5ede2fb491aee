//! A table as Parquet: compact, typed, with the unit of each column and the provenance inside.
//!
//! Columns are required `DOUBLE`s and UTF-8 strings. The key-value metadata of the file hold the provenance, and under
//! [`UNITS`] a JSON object of column name and unit, and under [`CHECKSUM`] the SHA-256 of the content, which is
//! verified when a file is read.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::Write;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, LogicalType, Repetition, Type as PhysicalType};
use parquet::column::reader::ColumnReader;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{ChunkReader, FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::OutputError;
use super::checksum::Checksum;
use super::table::{Column, Table, Values};
use crate::trajectory::Trajectory;

/// Key of the metadata under which the units are.
pub const UNITS: &str = "units";

/// Key of the metadata under which the checksum of the content is.
pub const CHECKSUM: &str = "content_sha256";

/// Rows of a row group. Each group repeats the dictionaries of its columns, so that small groups make a larger file.
const GROUP: usize = 1 << 20;
/// Rows of text converted at a time, so that the text of a group is not held in memory twice.
const WORDS: usize = 1 << 12;

/// Writes `table` to `sink` with `provenance` as pairs of name and value.
///
/// Errors: [`OutputError::Sink`], [`OutputError::Format`].
pub fn write<'a>(
    table: &Table,
    provenance: impl IntoIterator<Item = (&'a str, &'a str)>,
    sink: impl Write + Send,
) -> Result<(), OutputError> {
    let mut writer = Writer::new(table, provenance, sink, GROUP)?;
    writer.write(table)?;
    writer.close()
}

/// Writes a trajectory part by part; the file is that of [`write()`] with [`Table::of_trajectory`].
///
/// Errors: those of [`write()`] and [`Table::of_trajectory`].
pub fn write_trajectory<'a>(
    run: &Trajectory,
    provenance: impl IntoIterator<Item = (&'a str, &'a str)>,
    sink: impl Write + Send,
) -> Result<(), OutputError> {
    let mut writer = Writer::new(&Table::of_trajectory(&run.without_rows())?, provenance, sink, GROUP)?;
    Table::parts(run, GROUP).try_for_each(|part| writer.write(&part?))?;
    writer.close()
}

/// A file that is being written.
struct Writer<W: Write + Send> {
    file: SerializedFileWriter<W>,
    checksum: Checksum,
    /// Largest number of rows of a row group.
    group: usize,
}

impl<W: Write + Send> Writer<W> {
    /// Begins a file of tables with the columns of `like`.
    fn new<'a>(
        like: &Table,
        provenance: impl IntoIterator<Item = (&'a str, &'a str)>,
        sink: W,
        group: usize,
    ) -> Result<Self, OutputError> {
        let units: BTreeMap<_, _> = like.columns().iter().map(|column| (&column.name, &column.unit)).collect();
        let units = serde_json::to_string(&units).map_err(|e| OutputError::format("Parquet", e))?;
        let pair = |(name, value): (&str, &str)| KeyValue::new(name.to_owned(), value.to_owned());
        let mut metadata: Vec<_> = provenance.into_iter().map(pair).collect();
        metadata.push(pair((UNITS, &units)));
        let properties = WriterProperties::builder()
            .set_created_by(concat!("gearsim ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(Some(metadata))
            .build();
        let fields = like.columns().iter().map(|column| Ok(Arc::new(field(column)?)));
        let fields = fields.collect::<Result<_, ParquetError>>().map_err(failed)?;
        let schema = Type::group_type_builder("schema").with_fields(fields).build().map_err(failed)?;
        let file = SerializedFileWriter::new(sink, Arc::new(schema), Arc::new(properties)).map_err(failed)?;
        Ok(Writer { file, checksum: Checksum::new(like), group })
    }

    /// Adds the rows of a table.
    fn write(&mut self, table: &Table) -> Result<(), OutputError> {
        self.checksum.add(table);
        for start in (0..table.rows()).step_by(self.group) {
            self.write_group(table, start..table.rows().min(start + self.group)).map_err(failed)?;
        }
        Ok(())
    }

    fn write_group(&mut self, table: &Table, rows: Range<usize>) -> Result<(), ParquetError> {
        let mut group = self.file.next_row_group()?;
        for column in table.columns() {
            let mut writer = group.next_column()?.expect("the schema has a field for each column");
            match &column.values {
                Values::Number(numbers) => {
                    writer.typed::<DoubleType>().write_batch(&numbers[rows.clone()], None, None)?;
                }
                Values::Text(words) => {
                    for words in words[rows.clone()].chunks(WORDS) {
                        let words: Vec<_> = words.iter().map(|word| ByteArray::from(word.as_ref())).collect();
                        writer.typed::<ByteArrayType>().write_batch(&words, None, None)?;
                    }
                }
            }
            writer.close()?;
        }
        group.close()?;
        Ok(())
    }

    fn close(mut self) -> Result<(), OutputError> {
        self.file.append_key_value_metadata(KeyValue::new(CHECKSUM.to_owned(), self.checksum.text()));
        self.file.close().map_err(failed).map(drop)
    }
}

/// A full disk is reported as such, not as bad Parquet.
fn failed(error: ParquetError) -> OutputError {
    match error {
        ParquetError::External(e) => match e.downcast::<std::io::Error>() {
            Ok(e) => OutputError::Sink(*e),
            Err(e) => OutputError::format("Parquet", e),
        },
        other => OutputError::format("Parquet", other),
    }
}

fn field(column: &Column) -> Result<Type, ParquetError> {
    let (physical, logical) = match column.values {
        Values::Number(_) => (PhysicalType::DOUBLE, None),
        Values::Text(_) => (PhysicalType::BYTE_ARRAY, Some(LogicalType::String)),
    };
    Type::primitive_type_builder(&column.name, physical)
        .with_repetition(Repetition::REQUIRED)
        .with_logical_type(logical)
        .build()
}

/// A table read from a file, and its provenance as pairs of name and value.
pub type TableAndProvenance = (Table, Vec<(String, String)>);

/// Reads a file written by [`write()`], and verifies its checksum. Errors: [`OutputError::Read`].
pub fn read(path: &Path) -> Result<TableAndProvenance, OutputError> {
    let failed = |why: String| OutputError::Read { path: path.to_owned(), why };
    let file = File::open(path).map_err(|error| failed(error.to_string()))?;
    read_any(file).map_err(failed)
}

/// Reads the bytes of such a file. Errors: [`OutputError::Read`].
pub fn read_bytes(bytes: Vec<u8>) -> Result<TableAndProvenance, OutputError> {
    read_any(Bytes::from(bytes)).map_err(|why| OutputError::Read { path: "bytes of rows".into(), why })
}

fn read_any(file: impl ChunkReader + 'static) -> Result<TableAndProvenance, String> {
    // The reader may panic on damaged bytes.
    catch_unwind(AssertUnwindSafe(|| read_checked(file))).unwrap_or_else(|_| Err("it is damaged".into()))
}

fn read_checked(file: impl ChunkReader + 'static) -> Result<TableAndProvenance, String> {
    let text = |e: &dyn std::fmt::Display| e.to_string();
    let file = SerializedFileReader::new(file).map_err(|e| text(&e))?;
    let metadata = file.metadata().file_metadata();
    let pairs = metadata.key_value_metadata().into_iter().flatten();
    let mut pairs: Vec<_> = pairs.map(|pair| (pair.key.clone(), pair.value.clone().unwrap_or_default())).collect();
    let mut take = |key: &str| {
        let at = pairs.iter().position(|(name, _)| name == key).ok_or(format!("its metadata have no `{key}`"));
        at.map(|at| pairs.remove(at).1)
    };
    let (units, checksum) = (take(UNITS)?, take(CHECKSUM)?);
    let units: BTreeMap<String, String> =
        serde_json::from_str(&units).map_err(|e| format!("`{UNITS}` of its metadata: {e}"))?;

    let mut table = Table::default();
    for (i, column) in metadata.schema_descr().columns().iter().enumerate() {
        let name = column.name();
        if column.max_def_level() > 0 || column.max_rep_level() > 0 {
            return Err(format!("column `{name}` may have missing or repeated entries"));
        }
        let values = read_column(&file, i).map_err(|e| format!("column `{name}`: {e}"))?;
        table.push(name, units.get(name).map_or("", String::as_str), values).map_err(|e| text(&e))?;
    }
    let mut found = Checksum::new(&table);
    found.add(&table);
    match found.text() == checksum {
        true => Ok((table, pairs)),
        false => Err("its content does not have its checksum: it is damaged".into()),
    }
}

/// The values of the `i`-th column, which has none missing.
fn read_column(file: &impl FileReader, i: usize) -> Result<Values, ParquetError> {
    let (mut numbers, mut words) = (vec![], vec![]);
    let is_number = file.metadata().file_metadata().schema_descr().column(i).physical_type() == PhysicalType::DOUBLE;
    for group in 0..file.num_row_groups() {
        match file.get_row_group(group)?.get_column_reader(i)? {
            ColumnReader::DoubleColumnReader(mut reader) => {
                reader.read_records(usize::MAX, None, None, &mut numbers)?;
            }
            ColumnReader::ByteArrayColumnReader(mut reader) => {
                let mut bytes = vec![];
                reader.read_records(usize::MAX, None, None, &mut bytes)?;
                for word in &bytes {
                    words.push(word.as_utf8()?.to_owned().into());
                }
            }
            _ => return Err(ParquetError::General("neither numbers nor text".into())),
        }
    }
    Ok(if is_number { Values::Number(numbers) } else { Values::Text(words) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::fixture::oscillator;

    #[test]
    fn what_is_read_back_is_what_was_written() {
        // Several groups, the last of them shorter, and several conversions of text in each.
        let table = Table::of_trajectory(&oscillator(2 * WORDS + 1030)).unwrap();
        let file = tempfile::NamedTempFile::new().unwrap();
        let mut writer = Writer::new(&table, [("scene", "test"), ("commit", "")], &file, WORDS + 500).unwrap();
        writer.write(&table).unwrap();
        writer.close().unwrap();
        let (back, provenance) = read(file.path()).unwrap();
        assert!(back == table, "{} columns, {} rows", back.columns().len(), back.rows());
        let pairs: Vec<_> = provenance.iter().map(|(n, v)| (n.as_str(), v.as_str())).collect();
        assert_eq!(pairs, [("scene", "test"), ("commit", "")]);
    }

    #[test]
    fn units_are_a_json_object_in_the_metadata() {
        let mut table = Table::default();
        table.push("t", "s", Values::Number(vec![0.0, f64::NAN])).unwrap();
        table.push("moment", "", Values::Text(vec!["start".into(), "end".into()])).unwrap();
        let file = tempfile::NamedTempFile::new().unwrap();
        write(&table, [], &file).unwrap();
        let file = SerializedFileReader::new(file.reopen().unwrap()).unwrap();
        let metadata = file.metadata().file_metadata();
        let pairs: Vec<_> = metadata.key_value_metadata().into_iter().flatten().collect();
        assert_eq!(pairs[0], &KeyValue::new(UNITS.to_owned(), r#"{"moment":"","t":"s"}"#.to_owned()));
        assert!(pairs.len() == 2 && pairs[1].key == CHECKSUM);
    }

    #[test]
    fn a_table_without_rows_keeps_its_columns() {
        let mut table = Table::default();
        table.push("t", "s", Values::Number(vec![])).unwrap();
        table.push("moment", "", Values::Text(vec![])).unwrap();
        let file = tempfile::NamedTempFile::new().unwrap();
        write(&table, [], &file).unwrap();
        assert!(read(file.path()).unwrap().0 == table);
    }

    /// A byte changed anywhere is found, unless it changes nothing that is read.
    #[test]
    fn a_changed_byte_never_gives_other_numbers() {
        let table = Table::of_trajectory(&oscillator(50)).unwrap();
        let file = tempfile::NamedTempFile::new().unwrap();
        write(&table, [("scene", "test")], &file).unwrap();
        let whole = std::fs::read(file.path()).unwrap();
        let mut refused = 0;
        for at in (0..whole.len()).step_by(3) {
            let mut bytes = whole.clone();
            bytes[at] ^= 0x10;
            std::fs::write(file.path(), &bytes).unwrap();
            match read(file.path()) {
                Ok((back, _)) => assert!(back == table, "byte {at}"),
                Err(error) => refused += usize::from(matches!(error, OutputError::Read { .. })),
            }
        }
        assert!(refused > whole.len() / 10, "{refused} of {}", whole.len() / 3);
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
