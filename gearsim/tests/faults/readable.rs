//! Whether a file is whole.

use std::path::Path;

use gearsim::output::parquet;

/// Checks that a file is whole and can be read. The error names it.
pub fn readable(path: &Path, content: &[u8]) -> Result<(), String> {
    let text = || std::str::from_utf8(content).map_err(|error| error.to_string());
    let ends = |with: &str| text()?.trim_end().ends_with(with).then_some(()).ok_or(format!("does not end with {with}"));
    let read = match path.extension().and_then(|extension| extension.to_str()) {
        Some("parquet") => table(content),
        Some("json") => {
            serde_json::from_slice::<serde_json::Value>(content).map(drop).map_err(|error| error.to_string())
        }
        Some("svg") => ends("</svg>"),
        Some("png") => content.ends_with(b"IEND\xaeB`\x82").then_some(()).ok_or("does not end with IEND".into()),
        Some("csv") => rows(text()?),
        _ if content.ends_with(b"\n") => Ok(()),
        _ => Err("does not end with a line".into()),
    };
    read.map_err(|why| format!("{} cannot be read: {why}", path.display()))
}

fn table(content: &[u8]) -> Result<(), String> {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), content).unwrap();
    parquet::read(file.path()).map(drop).map_err(|error| error.to_string())
}

/// Every line of a CSV file has the same number of fields, and ends.
fn rows(text: &str) -> Result<(), String> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().try_for_each(|record| record.map(drop)).map_err(|error| error.to_string())?;
    if text.ends_with('\n') { Ok(()) } else { Err("does not end with a line".into()) }
}
