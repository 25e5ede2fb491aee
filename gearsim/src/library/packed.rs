//! The file of a part of a sweep on its way from the process that ran its points to the one that gathers them.
//!
//! The bytes are, in this order: the SHA-256 of all bytes after it, the SHA-256 of the manifest of the sweep, the number of the first
//! point (8 bytes, the lowest first), and the file. So the gathering process checks a part without reading the rows.

use sha2::{Digest, Sha256};

use super::Error;
use crate::output::OutputError;
use crate::sweep::Manifest;

/// Bytes of a SHA-256.
const DIGEST: usize = 32;
/// Bytes of the number of a point.
const NUMBER: usize = 8;

/// The bytes of the part `file` with the first point `first`.
pub(super) fn pack(manifest: &Manifest, first: usize, file: &[u8]) -> Result<Vec<u8>, OutputError> {
    let mut bytes = vec![0; DIGEST];
    bytes.reserve(DIGEST + NUMBER + file.len());
    bytes.extend_from_slice(&Sha256::digest(manifest.json()?));
    bytes.extend_from_slice(&(first as u64).to_le_bytes());
    bytes.extend_from_slice(file);
    let whole = Sha256::digest(&bytes[DIGEST..]);
    bytes[..DIGEST].copy_from_slice(&whole);
    Ok(bytes)
}

/// The first point and the file in the bytes of [`pack`].
///
/// # Errors
/// If they are damaged, or those of another sweep.
pub(super) fn unpack<'a>(manifest: &Manifest, bytes: &'a [u8]) -> Result<(usize, &'a [u8]), Error> {
    let damaged =
        || Error::impossible("these rows are damaged: their checksum does not match", "run their points again");
    let (sum, rest) = bytes.split_at_checked(DIGEST).ok_or_else(damaged)?;
    if Sha256::digest(rest)[..] != *sum {
        return Err(damaged());
    }
    let (sweep, rest) = rest.split_at_checked(DIGEST).ok_or_else(damaged)?;
    let (first, file) = rest.split_first_chunk::<NUMBER>().ok_or_else(damaged)?;
    if Sha256::digest(manifest.json()?)[..] != *sweep {
        return Err(Error::impossible(
            "these rows are those of another sweep",
            "keep rows in the folder of their own sweep",
        ));
    }
    Ok((u64::from_le_bytes(*first) as usize, file))
}
