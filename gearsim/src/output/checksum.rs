//! A checksum of the content of a table. Each column has a SHA-256 of its name, unit and values; the checksum is the SHA-256 of these.
//!
//! It does not depend on how the rows are cut into groups or pages, or on the compression, and it finds any change of a number.

use sha2::{Digest, Sha256};

use super::table::{Table, Values};

/// The checksum of a table whose rows are added part by part.
#[derive(Clone)]
pub(super) struct Checksum {
    columns: Vec<Sha256>,
}

impl Checksum {
    /// The checksum of a table with the columns of `like`, before its first row.
    pub(super) fn new(like: &Table) -> Checksum {
        let head = |name: &str, unit: &str| Sha256::new().chain_update(format!("{name}\0{unit}\0"));
        Checksum { columns: like.columns().iter().map(|column| head(&column.name, &column.unit)).collect() }
    }

    /// Adds the rows of `part`.
    pub(super) fn add(&mut self, part: &Table) {
        for (hash, column) in self.columns.iter_mut().zip(part.columns()) {
            match &column.values {
                Values::Number(numbers) => numbers.iter().for_each(|x| hash.update(x.to_le_bytes())),
                Values::Text(words) => words.iter().for_each(|word| {
                    hash.update((word.len() as u64).to_le_bytes());
                    hash.update(word.as_bytes());
                }),
            }
        }
    }

    /// In hexadecimal.
    pub(super) fn text(self) -> String {
        let whole = self.columns.into_iter().fold(Sha256::new(), |whole, column| whole.chain_update(column.finalize()));
        format!("{:x}", whole.finalize())
    }
}
