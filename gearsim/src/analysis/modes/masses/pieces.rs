//! The pieces of an inertia that several bodies have in common, such as the planets of a set.
//!
//! Each planet has coordinates that belong to it alone, and shares the others with all planets: A = sum_i A_i. If the coordinates K belong
//! to piece i alone, then A_i = A[:, K] A[K, K]⁻¹ A[K, :]. The sets K are the groups of coupled coordinates that remain after the most
//! coupled coordinates have been removed from A. Pieces are accepted only if their sum is A.

use nalgebra::DMatrix;

/// Largest accepted difference between the sum of the pieces and the whole [relative to the largest entry].
const ROUNDING: f64 = 1e-9;

/// A piece: the index of the first coordinate that belongs to it alone, and its part of the inertia (n x n).
pub type InertiaPart = (usize, DMatrix<f64>);

/// The pieces of `whole`, which is positive semidefinite; empty if it is one body.
pub fn of(whole: &DMatrix<f64>) -> Vec<InertiaPart> {
    let largest = whole.amax();
    let coupled = |i: usize, j: usize| whole[(i, j)].abs() > ROUNDING * largest;
    let mut own: Vec<usize> = (0..whole.nrows()).filter(|&i| whole[(i, i)] > 0.0).collect();
    let mut best = vec![];
    while !own.is_empty() {
        let groups = groups(&own, &coupled);
        if groups.len() > best.len().max(1)
            && let Some(pieces) = groups.iter().map(|group| piece(whole, group)).collect::<Option<Vec<InertiaPart>>>()
        {
            let rest = pieces.iter().fold(whole.clone(), |rest, (_, piece)| rest - piece);
            if rest.amax() <= ROUNDING * largest {
                best = pieces;
            }
        }
        let degree = |&i: &usize| own.iter().filter(|&&j| coupled(i, j)).count();
        // The first of the most coupled coordinates.
        let most = (0..own.len()).rev().max_by_key(|&at| degree(&own[at])).unwrap_or(0);
        own.remove(most);
    }
    best
}

/// The groups of coupled coordinates among `own`.
fn groups(own: &[usize], coupled: &dyn Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = vec![];
    for &i in own {
        let (mut joined, apart): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|group: &Vec<usize>| group.iter().any(|&j| coupled(i, j)));
        joined.push(vec![i]);
        groups = apart;
        groups.push(joined.concat());
    }
    groups.iter_mut().for_each(|group| group.sort_unstable());
    groups.sort();
    groups
}

fn piece(whole: &DMatrix<f64>, group: &[usize]) -> Option<InertiaPart> {
    let columns = whole.select_columns(group);
    let inverse = columns.select_rows(group).cholesky()?.inverse();
    Some((*group.first()?, &columns * inverse * columns.transpose()))
}

#[test]
fn the_inertias_of_planets_are_separate_and_one_body_is_whole() {
    // A shared rotation, and a rotation of each of three planets against it.
    let planets: Vec<DMatrix<f64>> = (1..=3)
        .map(|i| {
            let along = DMatrix::from_fn(1, 4, |_, j| if j == 0 { -7.0 } else { f64::from(u8::from(j == i)) });
            along.transpose() * along
        })
        .collect();
    let whole = planets.iter().fold(DMatrix::zeros(4, 4), |sum, planet| sum + planet);
    let found = of(&whole);
    assert_eq!(found.iter().map(|(own, _)| *own).collect::<Vec<_>>(), [1, 2, 3]);
    for ((_, piece), planet) in found.iter().zip(&planets) {
        assert!((piece - planet).amax() < 1e-12, "{piece}");
    }
    let one = DMatrix::from_fn(1, 3, |_, j| j as f64 + 1.0);
    assert!(of(&(one.transpose() * one)).is_empty());
    // With another body on the shared rotation, the planets do not sum to the whole.
    let mut more = whole;
    more[(0, 0)] += 5.0;
    assert!(of(&more).is_empty());
}
