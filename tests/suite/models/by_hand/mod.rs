//! Energies written by hand in absolute rotations and displacements, compared with the derived ones at random states. The natural
//! frequencies of the hand-written matrices are compared too. One file per family of models.

mod belt;
mod chains;
mod gear_pairs;
mod gear_trains;
mod planar_planetary;
mod planetary;
mod stage;
mod wind_turbine;

use gearsim::__private::equations::Derived;
use nalgebra::DMatrix;

use crate::train::{frequencies, train_with};

/// A system in absolute coordinates: an inertia for each coordinate, and springs. A spring is a stiffness and its deflection, a sum
/// of (coordinate index, coefficient).
pub struct ByHand {
    inertia: Vec<f64>,
    springs: Vec<(f64, Vec<(usize, f64)>)>,
}

impl ByHand {
    /// T with `x` as speeds, and V with `x` as coordinates.
    fn energies(&self, x: &[f64]) -> [f64; 2] {
        let deflection = |terms: &[(usize, f64)]| terms.iter().map(|(i, c)| c * x[*i]).sum::<f64>();
        let kinetic = self.inertia.iter().zip(x).map(|(m, v)| m * v * v / 2.0).sum();
        [kinetic, self.springs.iter().map(|(k, terms)| k * deflection(terms).powi(2) / 2.0).sum()]
    }

    /// Natural frequencies [Hz], rising.
    fn frequencies(&self) -> Vec<f64> {
        let n = self.inertia.len();
        let mut stiffness = DMatrix::zeros(n, n);
        for (k, terms) in &self.springs {
            terms.iter().for_each(|(i, a)| terms.iter().for_each(|(j, b)| stiffness[(*i, *j)] += k * a * b));
        }
        frequencies(DMatrix::from_fn(n, n, |i, j| if i == j { self.inertia[i] } else { 0.0 }), stiffness)
    }
}

/// A number for every parameter and law. All numbers of a model differ, so that exchanging two of them changes the result.
type Numbers = &'static [(&'static str, f64)];

/// Compares the model `D` with a system by hand. `absolute` computes the coordinates of that system from those of the model.
fn compare<D: Derived>(numbers: &[(&str, f64)], by_hand: &ByHand, absolute: impl Fn(&dyn Fn(&str) -> f64) -> Vec<f64>) {
    compare_with::<D>(&[], numbers, by_hand, absolute);
}

/// [`compare`] for the model with these effects.
fn compare_with<D: Derived>(
    effects: &[&str],
    numbers: &[(&str, f64)],
    by_hand: &ByHand,
    absolute: impl Fn(&dyn Fn(&str) -> f64) -> Vec<f64>,
) {
    let train = train_with::<D>(effects, numbers);
    let name = train.model.name;
    let index = |c: &str| train.model.coordinates.iter().position(|q| q.name == c).unwrap_or_else(|| panic!("no {c}"));
    let n = train.model.coordinates.len();
    for draw in 0..100 {
        // Multiples of the golden ratio, modulo 1, fill the interval evenly and never repeat.
        let number = |i: usize| ((draw * n + i + 1) as f64 * 0.618_033_988_749_895).fract() - 0.5;
        let x: Vec<f64> = (0..n).map(number).collect();
        let found = train.energies(&x);
        let expected = by_hand.energies(&absolute(&|c| x[index(c)]));
        for ((found, expected), energy) in found.iter().zip(expected).zip(["T", "V"]) {
            // The rounding errors of sums of up to a hundred products of numbers near one, with a margin.
            assert!((found - expected).abs() <= 1e-12 * expected, "{name}: {energy} = {found}, by hand {expected}");
        }
    }
    assert_frequencies(name, &train.frequencies(), by_hand);
}

/// Compares natural frequencies [Hz] with those of the system by hand.
fn assert_frequencies(name: &str, found: &[f64], by_hand: &ByHand) {
    let expected = by_hand.frequencies();
    assert_eq!(found.len(), expected.len(), "{name}");
    let highest = expected.last().copied().unwrap_or(0.0);
    for (f, e) in found.iter().zip(&expected) {
        // The squares of the frequencies have errors of eps times the largest square. A rigid motion, whose frequency is zero,
        // may therefore show sqrt(eps) times the largest frequency.
        let tolerance = 1e-10 * e + if *e < 1e-6 * highest { 1e-6 * highest } else { 0.0 };
        assert!((f - e).abs() <= tolerance, "{name}: {found:?}, by hand {expected:?}");
    }
    println!("{name}: {expected:.2?} Hz");
}

pub const TESTS: &[(&str, fn())] = &[
    ("gear_pair_shafts", gear_pairs::shafts),
    ("gear_pair_bearings", gear_pairs::bearings),
    ("geared_branches", gear_trains::branches),
    ("two_stage", gear_trains::two_stages),
    ("idler", gear_trains::idlers),
    ("belt_drive", belt::drive),
    ("planetary_3", planetary::derived),
    ("planetaries_of_1_to_7_as_trains", planetary::trains),
    ("planar_planetaries_of_3_4_and_5", planar_planetary::stages),
    ("wind_turbine", wind_turbine::turbine),
    ("chains", chains::discs),
];

const TORQUES: [(&str, f64); 2] = [("T_motor", 0.0), ("T_load", 0.0)];

fn with(numbers: Numbers, more: &[(&'static str, f64)]) -> Vec<(&'static str, f64)> {
    [numbers, more].concat()
}

/// A function that looks a number up by its name.
fn of<'a>(numbers: &'a [(&str, f64)]) -> impl Fn(&str) -> f64 + 'a {
    |name| numbers.iter().find(|n| n.0 == name).unwrap_or_else(|| panic!("no {name}")).1
}

/// A spring that acts on the difference of two rotations: a shaft between two rotors.
fn twist(k: f64, i: usize, j: usize) -> (f64, Vec<(usize, f64)>) {
    (k, vec![(i, 1.0), (j, -1.0)])
}

/// Rotations of two gears from N1 theta1 + N2 theta2 = 2 theta and r1 theta1 - r2 theta2 = s, by Cramer's rule.
fn pair(theta: f64, s: f64, n1: f64, n2: f64, r1: f64) -> (f64, f64) {
    let r2 = r1 * n2 / n1;
    let determinant = -n1 * r2 - n2 * r1;
    ((-2.0 * theta * r2 - n2 * s) / determinant, (n1 * s - 2.0 * theta * r1) / determinant)
}
