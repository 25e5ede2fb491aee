//! A table as CSV: one header line with the names and, in brackets, the SI units, `theta [rad]`; numbers in the shortest form that reads
//! back bit for bit.
//!
//! Numbers that are not finite are written as `inf`, `-inf`, `NaN`.

use std::borrow::Borrow;
use std::io::Write;

use super::OutputError;
use super::table::{Column, Table, Values};

/// Writes `table` to `sink`. Errors: [`OutputError::Sink`], [`OutputError::Format`].
pub fn write(table: &Table, sink: impl Write) -> Result<(), OutputError> {
    write_parts([Ok(table)], sink)
}

/// Writes a table given in parts, which have the same columns. Errors: those of the parts and of [`write()`].
pub fn write_parts<T: Borrow<Table>>(
    parts: impl IntoIterator<Item = Result<T, OutputError>>,
    sink: impl Write,
) -> Result<(), OutputError> {
    let mut csv = csv::Writer::from_writer(sink);
    for (i, part) in parts.into_iter().enumerate() {
        let part = part?;
        let table = part.borrow();
        if i == 0 {
            csv.write_record(table.columns().iter().map(header)).map_err(failed)?;
        }
        write_rows(table, &mut csv)?;
    }
    Ok(csv.flush()?)
}

/// The name of a column, with its unit if it has one.
fn header(column: &Column) -> String {
    match column.unit.as_str() {
        "" | "1" => column.name.clone(),
        unit => format!("{} [{unit}]", column.name),
    }
}

fn write_rows(table: &Table, csv: &mut csv::Writer<impl Write>) -> Result<(), OutputError> {
    let mut cell = String::new();
    for row in 0..table.rows() {
        for column in table.columns() {
            match &column.values {
                Values::Number(v) => {
                    cell.clear();
                    // Unlike Display, Debug uses an exponent for very small and very large numbers.
                    let _ = std::fmt::Write::write_fmt(&mut cell, format_args!("{:?}", v[row]));
                    csv.write_field(&cell).map_err(failed)?;
                }
                Values::Text(v) => csv.write_field(v[row].as_bytes()).map_err(failed)?,
            }
        }
        csv.write_record(None::<&[u8]>).map_err(failed)?;
    }
    Ok(())
}

/// Input and output errors, e.g. a full disk, stay as they are; all others are errors of the format.
fn failed(error: csv::Error) -> OutputError {
    match error.into_kind() {
        csv::ErrorKind::Io(e) => OutputError::Sink(e),
        other => OutputError::format("CSV", format!("{other:?}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_bit_for_bit() {
        let numbers = vec![
            0.1,
            -0.0,
            1.0 / 3.0,
            5e-324,
            f64::MAX,
            -f64::MIN_POSITIVE,
            1e21,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
        ];
        let mut table = Table::default();
        table.push("x", "J", Values::Number(numbers.clone())).unwrap();
        table.push("word", "", Values::Text(vec!["a, \"b\"".into(); numbers.len()])).unwrap();
        let mut file = vec![];
        write(&table, &mut file).unwrap();

        let mut reader = csv::Reader::from_reader(&file[..]);
        assert_eq!(reader.headers().unwrap(), vec!["x [J]", "word"]);
        let records: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert_eq!(records.len(), numbers.len());
        for (record, x) in records.iter().zip(numbers) {
            assert_eq!(record[0].parse::<f64>().unwrap().to_bits(), x.to_bits());
            assert_eq!(&record[1], "a, \"b\"");
        }
    }
}
