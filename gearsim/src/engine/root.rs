//! The first root of a polynomial in (0, 1], guaranteed, from its Bernstein coefficients.
//!
//! On an interval a polynomial lies between its smallest and largest Bernstein coefficient, and it has at most as many roots as the
//! coefficients change sign (Farouki & Rajan, CAGD 4(3), 1987). If all coefficients have one sign, there is no root. With one change of
//! sign there is one root, and the interval is its bracket. Otherwise the interval is bisected (de Casteljau), and the left half is
//! searched first. Double roots are handled in the same way. A touch that does not pass zero by more than the tolerance is a graze: it is
//! counted, but it is not a root.

use crate::tolerance::events::{DENSE_FAR, DENSE_NOISE, ROOT_ERROR, ROOT_HALVINGS};

/// Maximum number of coefficients of a method's dense output.
const DENSE: usize = 8;

/// The result of a search.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Found {
    /// The first root at which the polynomial changes from positive to negative.
    pub root: Option<f64>,
    /// Number of intervals searched.
    pub steps: u64,
    /// Number of grazes.
    pub grazes: u64,
}

/// The first x in \[0, 1\] at which the polynomial sum c_j x^j turns from positive to negative.
///
/// The result is 0 only if the polynomial is negative right after 0 by more than a rounding error. A root at 1 is not reported:
/// the next step begins with it. A value within `tolerance` of zero counts as zero unless the polynomial then leaves this band;
/// the sign with which it leaves decides.
pub fn first(coefficients: &[f64], tolerance: f64) -> Found {
    first_of::<DENSE>(coefficients, tolerance)
}

/// The same for a polynomial with an error of `slack`, e.g. a dense output. When it leaves a boundary from rest, it may start on
/// the wrong side. A root at 0 is ignored if the polynomial becomes positive within the step and was not below -`slack` before.
pub fn first_known_to(coefficients: &[f64], tolerance: f64, slack: f64) -> Found {
    let mut found = first(coefficients, tolerance);
    if found.root != Some(0.0) {
        return found;
    }
    let mut lifted = coefficients.to_vec();
    lifted[0] += slack;
    let beyond = first(&lifted, tolerance);
    found.steps += beyond.steps;
    let turned: Vec<f64> = coefficients.iter().map(|c| -c).collect();
    found.root = match (beyond.root, first(&turned, tolerance).root) {
        // The root after the polynomial has become positive again. Beyond this root it is negative by more than its error.
        (Some(x), Some(back)) if back < x => Some(x),
        (Some(_), _) => Some(0.0),
        (None, _) => (evaluate(coefficients, 1.0) < 0.0).then_some(0.0),
    };
    found
}

/// The same for a polynomial of at most `MOST` coefficients.
pub fn first_of<const MOST: usize>(coefficients: &[f64], tolerance: f64) -> Found {
    // Most polynomials stay far from zero: c_0 - sum |c_j| is a lower bound of p(x) and of each Bernstein coefficient.
    let first = coefficients[0];
    if coefficients.iter().skip(1).fold(0.0, |sum, c| sum + c.abs()) < DENSE_FAR * first {
        return Found { root: None, steps: 1, grazes: 0 };
    }
    let mut c = coefficients.to_vec();
    // Negative by rounding and increasing: the polynomial starts on the boundary.
    if c[0] < 0.0 && c[0] >= -tolerance && c.get(1).is_some_and(|c| *c > 0.0) {
        c[0] = 0.0;
    }
    // Divide out a root at 0. The quotient has the same sign for x > 0.
    let Some(order) = c.iter().position(|c| *c != 0.0) else { return Found::default() };
    // If all coefficients are within the rounding errors of the states, only the value at the end decides.
    if c.iter().all(|c| c.abs() <= DENSE_NOISE * tolerance) && evaluate(&c, 1.0) >= -tolerance {
        return Found { root: None, steps: 1, grazes: 0 };
    }
    if c[order] < 0.0 {
        return Found { root: Some(0.0), steps: 1, grazes: 0 };
    }
    let c = &c[order..];
    search::<MOST>(&bernstein(c), c, order as i32, tolerance)
}

/// An interval, and the Bernstein coefficients on it.
#[derive(Clone, Copy)]
struct BernsteinInterval<const MOST: usize> {
    low: f64,
    width: f64,
    depth: u32,
    b: [f64; MOST],
}

fn search<const MOST: usize>(b: &[f64; MOST], c: &[f64], order: i32, tolerance: f64) -> Found {
    let n = c.len();
    let mut found = Found::default();
    let mut stack = vec![BernsteinInterval { low: 0.0, width: 1.0, depth: 0, b: *b }];
    while let Some(BernsteinInterval { low, width, depth, b }) = stack.pop() {
        found.steps += 1;
        let b_of = &b[..n];
        if b_of.iter().all(|b| *b > 0.0) {
            continue;
        }
        let high = low + width;
        let changes = b_of.windows(2).filter(|b| (b[0] > 0.0) != (b[1] > 0.0)).count();
        if changes == 1 && b[0] > 0.0 && b[n - 1] < 0.0 {
            found.root = Some(bisect(c, low, high, &mut found.steps));
            return found;
        }
        // The depth of the polynomial itself, from which `order` roots at 0 were divided out.
        let depth_here = b_of.iter().fold(0.0f64, |m, b| m.max(b.abs())) * high.powi(order);
        if depth == ROOT_HALVINGS || depth_here <= tolerance {
            if b[n - 1] < 0.0 && (depth_here > tolerance || evaluate(c, high) < 0.0 && decreases(c, high)) {
                found.root = Some(high);
                return found;
            }
            // If the step ends on the boundary, the next step decides.
            found.grazes += u64::from(high < 1.0 && b[n - 1] >= 0.0 && b_of.iter().any(|b| *b <= 0.0));
            continue;
        }
        let (left, right) = halves(&b, n);
        let width = 0.5 * width;
        stack.push(BernsteinInterval { low: low + width, width, depth: depth + 1, b: right });
        stack.push(BernsteinInterval { low, width, depth: depth + 1, b: left });
    }
    found
}

/// Whether the polynomial decreases at x.
fn decreases(c: &[f64], x: f64) -> bool {
    c.iter().enumerate().skip(1).rev().fold(0.0, |sum, (j, c)| sum * x + j as f64 * c) < 0.0
}

/// The Bernstein coefficients on \[0, 1\]: b_j = sum_{i<=j} (j over i)/(d over i) c_i.
fn bernstein<const MOST: usize>(c: &[f64]) -> [f64; MOST] {
    let d = c.len() - 1;
    let mut b = [0.0; MOST];
    for (j, b) in b.iter_mut().enumerate().take(d + 1) {
        let mut weight = 1.0;
        for (i, c) in c.iter().enumerate().take(j + 1) {
            *b += weight * c;
            weight *= (j - i) as f64 / (d - i).max(1) as f64;
        }
    }
    b
}

/// The Bernstein coefficients on the two halves of the interval (de Casteljau).
fn halves<const MOST: usize>(b: &[f64; MOST], n: usize) -> ([f64; MOST], [f64; MOST]) {
    let (mut left, mut right) = ([0.0; MOST], *b);
    for (i, left) in left.iter_mut().enumerate().take(n) {
        *left = right[0];
        for j in 0..n - 1 - i {
            right[j] = 0.5 * (right[j] + right[j + 1]);
        }
    }
    (left, right)
}

fn evaluate(c: &[f64], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// The only root between `low` (positive) and `high` (negative), by Newton's method in a bracket.
fn bisect(c: &[f64], mut low: f64, mut high: f64, steps: &mut u64) -> f64 {
    let mut x = 0.5 * (low + high);
    for _ in 0..200 {
        *steps += 1;
        let (mut f, mut slope) = (0.0, 0.0);
        for c in c.iter().rev() {
            slope = slope * x + f;
            f = f * x + c;
        }
        if f > 0.0 {
            low = x
        } else {
            high = x
        }
        let newton = x - f / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= ROOT_ERROR * x || high - low <= ROOT_ERROR * high {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients of prod (x_i - x). The polynomial is positive below the smallest root.
    fn with_roots(roots: &[f64]) -> Vec<f64> {
        roots.iter().fold(vec![1.0], |c, root| {
            let mut product = vec![0.0; c.len() + 1];
            for (i, c) in c.iter().enumerate() {
                product[i] += root * c;
                product[i + 1] -= c;
            }
            product
        })
    }

    #[test]
    fn the_first_of_several_roots() {
        for roots in
            [&[0.3, 0.7, 0.9][..], &[0.5], &[0.2, 0.201, 0.9], &[1e-6, 0.5, 2.0], &[0.4, 0.4, 0.4], &[0.999_999]]
        {
            let found = first(&with_roots(roots), 1e-15);
            // The error of a root of multiplicity m is the m-th root of the rounding error.
            let slack = if roots == [0.4, 0.4, 0.4] { 2e-5 } else { 1e-13 };
            assert!((found.root.unwrap() - roots[0]).abs() < slack, "{roots:?}: {found:?}");
        }
    }

    /// A narrow dip below zero is found if it is deeper than the tolerance, and ruled out if it is less deep.
    #[test]
    fn a_dip_counts_if_it_is_deeper_than_the_tolerance() {
        for k in 2..7 {
            let half = 10f64.powi(-k);
            let (a, b) = (0.37 - half, 0.37 + half);
            let found = first(&with_roots(&[a, b, 3.0]), 1e-15);
            assert!((found.root.unwrap() - a).abs() < 1e-9, "{k}: {found:?}");
            // The same dip, raised by twice its depth.
            let mut c = with_roots(&[a, b, 3.0]);
            c[0] += 2.0 * half * half * 2.63;
            assert_eq!(first(&c, 1e-15).root, None, "{k}");
        }
        let touch = first(&with_roots(&[0.5, 0.5]), 1e-14);
        assert_eq!((touch.root, touch.grazes > 0), (None, true));
    }

    #[test]
    fn roots_at_the_ends_of_the_interval() {
        // The polynomial leaves the boundary inwards: there is no root, or it is at the return.
        assert_eq!(first(&[0.0, 1.0, 0.0], 1e-15).root, None);
        assert!((first(&[0.0, 1.0, -2.0], 1e-15).root.unwrap() - 0.5).abs() < 1e-15);
        // The polynomial leaves the boundary outwards: a root at 0. If the slope is 0, the next derivative decides.
        assert_eq!(first(&[0.0, -1.0, 9.0], 1e-15).root, Some(0.0));
        assert_eq!(first(&[0.0, 0.0, -1.0], 1e-15).root, Some(0.0));
        assert_eq!(first(&[0.0, 0.0, 1.0], 1e-15).root, None);
        assert_eq!(first(&[0.0, 0.0, 0.0], 1e-15).root, None);
        // A root at the end of the step: the next step begins with it.
        assert_eq!(first(&[1.0, -1.0], 1e-15).root, None);
        // The polynomial starts outside by a rounding error, and returns.
        assert_eq!(first(&[-1e-16, 1.0], 1e-15).root, None);
        // All values are within rounding errors: only the end decides.
        assert_eq!(first(&[0.0, -3e-15, 3e-15, 0.0], 1e-15).root, None);
        assert_eq!(first(&[-2e-16, -5e-16, 4e-16], 1e-15).root, None);
        assert_eq!(first(&[0.0, -3e-15, 1e-15], 1e-15).root, Some(0.0));
    }

    /// A dense output that leaves the boundary on the wrong side, within its error.
    #[test]
    fn a_departure_from_rest_within_its_error_is_no_root() {
        let known_to = |slack: f64, c: &[f64]| first_known_to(c, 1e-15, slack).root;
        // x³ - x²/1000 has a minimum of -1.5e-10, and a root at 1/1000.
        let c = [0.0, 0.0, -1e-3, 1.0];
        assert_eq!(first(&c, 1e-15).root, Some(0.0));
        assert_eq!((known_to(1e-9, &c), known_to(1e-11, &c)), (None, Some(0.0)));
        // A polynomial with such a dip at the start becomes positive and has a root at x = 1/2. Another one stays negative.
        let twice = [0.0, 0.0, -1e-3 * 0.5, 0.5 + 1e-3, -1.0];
        assert!((first_known_to(&twice, 1e-15, 1e-9).root.unwrap() - 0.5).abs() < 1e-7);
        assert_eq!(known_to(1e-3, &[0.0, 0.0, -1e-4]), Some(0.0));
    }

    /// Random polynomials of all degrees against a scan. If the scan finds a negative value, the root is not later.
    #[test]
    fn random_polynomials_against_a_scan() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for i in 0..20_000 {
            let mut c: Vec<f64> = (0..2 + i % 7).map(|_| random()).collect();
            c[0] = c[0].abs() * 0.1 + 1e-3;
            let seen = (1..=1000).map(|i| f64::from(i) / 1000.0).find(|x| evaluate(&c, *x) < 0.0);
            let found = first(&c, 1e-15).root;
            match (found, seen) {
                (Some(x), Some(seen)) => assert!(x <= seen && evaluate(&c, x).abs() < 1e-12, "{c:?}: {x} {seen}"),
                (Some(x), None) => assert!(evaluate(&c, x).abs() < 1e-12 && decreases(&c, x), "{c:?}: {x}"),
                (None, seen) => assert_eq!(seen, None, "{c:?}"),
            }
        }
    }
}
