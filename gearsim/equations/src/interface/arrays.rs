//! Vectors as arrays of a known length, for the generated code.

use nalgebra::{DMatrix, DVector, Scalar};

/// A vector as an array of N numbers, for code compiled for a known N.
///
/// # Panics
/// If its length is not N.
#[inline]
pub fn array<R, const N: usize>(numbers: &[R]) -> &[R; N] {
    numbers.try_into().unwrap_or_else(|_| wrong_length(N, numbers.len()))
}

/// The first L numbers as an array: the values of the laws and symbols of a model, or the slopes of its laws. For code compiled for a known
/// L.
///
/// # Panics
/// If there are too few.
#[inline]
pub fn values<R, const L: usize>(values: &[R]) -> &[R; L] {
    values.first_chunk().unwrap_or_else(|| too_few_values(L, values.len()))
}

#[cold]
fn too_few_values(l: usize, given: usize) -> ! {
    panic!("{l} values of laws and switches are needed, {given} are given")
}

/// [`array()`], mutable.
///
/// # Panics
/// Those of [`array()`].
#[inline]
pub fn array_mut<const N: usize>(numbers: &mut [f64]) -> &mut [f64; N] {
    let given = numbers.len();
    numbers.try_into().unwrap_or_else(|_| wrong_length(N, given))
}

#[cold]
fn wrong_length(n: usize, given: usize) -> ! {
    panic!("the model has {n} coordinates, not {given}")
}

/// A vector with the given entries.
pub fn vector<R: Scalar, const N: usize>(numbers: &[R; N]) -> DVector<R> {
    DVector::from_column_slice(numbers)
}

/// A matrix with the given rows.
pub fn matrix<R: Scalar, const N: usize>(rows: &[[R; N]; N]) -> DMatrix<R> {
    DMatrix::from_fn(N, N, |i, j| rows[i][j].clone())
}

/// Panics because the model has no `what` number `i`.
///
/// # Panics
/// Always.
#[cold]
pub fn no_such(what: &str, i: usize) -> ! {
    panic!("the model has no {what} number {i}")
}
