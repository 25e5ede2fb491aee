//! The kinematics of a train: R of each part, and its rigid motions.
//!
//! With the rotations theta of the rotors, the coordinates are q = B theta, and the coordinates of a part x = D theta, so that R = D B⁻¹.
//! Numbers that cancel to rounding errors are set to zero: a deflection that does not depend on a phase then keeps its digits however large
//! the phase is.

use nalgebra::DMatrix;

use crate::engine::real::{Real, Sized64};
use crate::engine::vector::Vector;
use crate::tolerance::scene::CANCELLED;
use crate::train::{Factor, RotationForm, Row, Train};

/// The kinematics of a train, in numbers of type `R`. `rows` has the matrix R of each part (number of its coordinates x n). `products` has,
/// for each output that is a product with a speed, the slopes of the displacement along the coordinates of the train (n). `motions` has the
/// speeds of each rigid motion (n).
pub(super) struct Geometry<R> {
    pub rows: Vec<DMatrix<R>>,
    pub products: Vec<Vec<R>>,
    /// The factors of the outputs that are multiples of other outputs.
    pub multiples: Vec<R>,
    pub motions: Vec<Vector>,
}

impl<R: Sized64> Geometry<R> {
    /// The kinematics for these values of the parameters. If they leave a coordinate undetermined, the numbers are NaN, and the engine
    /// refuses the mass matrix.
    pub fn of(train: &Train, parameters: &[R]) -> Geometry<R> {
        let n = train.coordinates.len();
        let dense = |form: &RotationForm| dense(form, n, parameters);
        let b: Vec<Vec<R>> = train.coordinates.iter().map(&dense).collect();
        let inverse = inverse(&b);
        // A form has few rotors: only their terms are added up.
        let by_coordinates = |form: &RotationForm| {
            let d = dense(form);
            let rotors: Vec<usize> = (0..n).filter(|&i| d[i].rounded() != 0.0).collect();
            let d: Vec<R> = rotors.iter().map(|&i| d[i]).collect();
            (0..n).map(|j| product(&d, |i| inverse[rotors[i]][j])).collect::<Vec<R>>()
        };
        let row = |row: &Row| match row {
            Row::Coordinate(j) => (0..n).map(|i| R::from(f64::from(u8::from(i == *j)))).collect(),
            Row::Form(form) => by_coordinates(form),
        };
        let rows = |rows: &Vec<Row>| {
            let rows: Vec<Vec<R>> = rows.iter().map(row).collect();
            DMatrix::from_fn(rows.len(), n, |i, j| rows[i][j])
        };
        let motion = |forms: &Vec<(RotationForm, f64)>| {
            let system: Vec<Vec<R>> = forms.iter().map(|(form, _)| dense(form)).collect();
            let solved = self::inverse(&system);
            let values: Vec<R> = forms.iter().map(|(_, value)| R::from(*value)).collect();
            let theta: Vec<R> = solved.iter().map(|row| product(&values, |i| row[i])).collect();
            Vector::from_fn(n, |j| product(&b[j], |i| theta[i]).rounded())
        };
        Geometry {
            rows: train.parts.iter().map(|part| rows(&part.rows)).collect(),
            products: train.products.iter().map(|(_, _, form)| by_coordinates(form)).collect(),
            multiples: train.multiples.iter().map(|(_, _, factor)| factor.value(parameters)).collect(),
            motions: train.motions.iter().map(motion).collect(),
        }
    }
}

/// A form as a vector of n numbers.
fn dense<R: Real>(form: &RotationForm, n: usize, parameters: &[R]) -> Vec<R> {
    let mut vector = vec![R::from(0.0); n];
    for (rotor, factor) in form {
        vector[*rotor] += factor.value(parameters);
    }
    vector
}

impl Factor {
    /// Its value with these values of the parameters.
    fn value<R: Real>(&self, parameters: &[R]) -> R {
        self.powers.iter().fold(R::from(self.number), |value, &(p, power)| value * parameters[p].powi(power))
    }
}

/// A scalar product, zero where its terms cancel.
fn product<R: Sized64>(a: &[R], b: impl Fn(usize) -> R) -> R {
    let (mut sum, mut size) = (R::from(0.0), 0.0);
    for (i, a) in a.iter().enumerate() {
        let term = *a * b(i);
        sum += term;
        size += term.rounded().abs();
    }
    if sum.rounded().abs() <= CANCELLED * size { R::from(0.0) } else { sum }
}

/// The inverse of a square matrix, by Gauss-Jordan elimination with the largest pivot of each column. Rows are scaled to a size of about 1.
fn inverse<R: Sized64>(rows: &[Vec<R>]) -> Vec<Vec<R>> {
    let n = rows.len();
    let (zero, one) = (R::from(0.0), R::from(1.0));
    let mut left: Vec<Vec<R>> = rows.to_vec();
    let mut right: Vec<Vec<R>> = (0..n).map(|i| (0..n).map(|j| if i == j { one } else { zero }).collect()).collect();
    for i in 0..n {
        let size = left[i].iter().map(|x| x.rounded().abs()).fold(0.0, f64::max);
        let scale = R::from(2f64.powi(-(size.log2().round() as i32)));
        left[i].iter_mut().chain(&mut right[i]).for_each(|x| *x = *x * scale);
    }
    for column in 0..n {
        let size = |i: &usize| left[*i][column].rounded().abs();
        let pivot = (column..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(column);
        left.swap(column, pivot);
        right.swap(column, pivot);
        let by = one / left[column][column];
        for x in left[column].iter_mut().chain(&mut right[column]) {
            *x = *x * by;
        }
        let (pivot_left, pivot_right) = (left[column].clone(), right[column].clone());
        for i in (0..n).filter(|&i| i != column) {
            let factor = left[i][column];
            if factor.rounded() == 0.0 {
                continue;
            }
            let reduce = |x: &mut R, by: R| {
                let (old, less) = (*x, factor * by);
                let left = old - less;
                let size = old.rounded().abs() + less.rounded().abs();
                *x = if left.rounded().abs() <= CANCELLED * size { zero } else { left };
            };
            left[i].iter_mut().zip(&pivot_left).for_each(|(x, by)| reduce(x, *by));
            right[i].iter_mut().zip(&pivot_right).for_each(|(x, by)| reduce(x, *by));
        }
    }
    right
}

/// Adds Rᵀ m R to a sum.
pub(super) fn add<R: Real>(sum: &mut DMatrix<R>, m: &DMatrix<R>, rows: &DMatrix<R>) {
    let zero = R::from(0.0);
    let (own, n) = (rows.nrows(), rows.ncols());
    let present: Vec<Vec<usize>> = (0..own).map(|i| (0..n).filter(|&j| rows[(i, j)] != zero).collect()).collect();
    for a in 0..own {
        for b in 0..own {
            let x = m[(a, b)];
            if x == zero {
                continue;
            }
            for &i in &present[a] {
                for &j in &present[b] {
                    sum[(i, j)] += rows[(a, i)] * x * rows[(b, j)];
                }
            }
        }
    }
}
