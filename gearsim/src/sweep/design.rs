//! Designs: where the random points of a sweep lie in the unit cube, one dimension per random axis.
//!
//! | design | points | good for |
//! | --- | --- | --- |
//! | `random` | independent | probabilities, with exact confidence intervals |
//! | `latin-hypercube` | on each axis one point in each of N equal intervals | means of nearly additive quantities |
//! | `sobol` | a Sobol' sequence | means and percentiles; N a power of two |
//! | `saltelli` | N times d + 2 points on a Sobol' sequence, for d axes | indices of sensitivity |
//!
//! Every number depends on the seed and on the number of the point alone, so that points can be run in any order and on any machine.
//! The design `random` draws new numbers at each grid point. The other designs use the same numbers at all grid points: differences
//! between grid points are then not caused by the sampling.
//!
//! Sources: M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21 (1979), 239-245 (Latin hypercube); I. M. Sobol', USSR Comput.
//! Math. Math. Phys. 7 (1967), 86-112, with the direction numbers of S. Joe, F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008), 2635-2654; R.
//! Cranley, T. N. L. Patterson, SIAM J. Numer. Anal. 13 (1976), 904-914 (random shift, here digit by digit); A. Saltelli et al.,
//! Comput. Phys. Commun. 181 (2010), 259-270.

use std::str::FromStr;

use serde::{Deserialize, Serialize};
use sobol::Sobol;
use sobol::params::JoeKuoD6;

use super::random;

/// How the random points of a sweep are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Design {
    /// Independent points.
    #[default]
    Random,
    /// One point in each of N equal intervals of each axis.
    LatinHypercube,
    /// A Sobol' sequence.
    Sobol,
    /// Points for indices of sensitivity.
    Saltelli,
}

impl Design {
    /// All designs.
    pub const ALL: [Design; 4] = [Design::Random, Design::LatinHypercube, Design::Sobol, Design::Saltelli];

    /// Its name in options and files.
    pub fn name(self) -> &'static str {
        match self {
            Design::Random => "random",
            Design::LatinHypercube => "latin-hypercube",
            Design::Sobol => "sobol",
            Design::Saltelli => "saltelli",
        }
    }

    /// Number of points that the design makes from `samples` samples with `axes` random axes; `None` if it is too large for a number.
    pub fn points(self, samples: usize, axes: usize) -> Option<usize> {
        match self {
            Design::Saltelli => samples.checked_mul(axes + 2),
            _ => Some(samples),
        }
    }

    /// Number of dimensions of the Sobol' sequence that the design uses for `axes` random axes.
    fn dimensions(self, axes: usize) -> usize {
        match self {
            Design::Saltelli => 2 * axes,
            _ => axes,
        }
    }

    /// Maximum number of random axes.
    pub fn axes(self) -> usize {
        match self {
            Design::Random | Design::LatinHypercube => usize::MAX,
            Design::Sobol => SEQUENCE,
            Design::Saltelli => SEQUENCE / 2,
        }
    }
}

impl FromStr for Design {
    type Err = String;

    fn from_str(name: &str) -> Result<Design, String> {
        Design::ALL.into_iter().find(|design| design.name() == name).ok_or_else(|| {
            format!("no design is called `{name}`; there are {}", Design::ALL.map(Design::name).join(", "))
        })
    }
}

/// Number of dimensions of the Sobol' sequence whose direction numbers the program has.
const SEQUENCE: usize = 100;
/// Bits of the direction numbers: enough for 2^32 points.
const BITS: usize = 32;

/// The random numbers of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Sampler {
    /// The design.
    pub design: Design,
    /// The number N of samples per point of the grid, as the user gave it.
    pub samples: usize,
    /// The seed.
    pub seed: u64,
    /// Number of random axes.
    pub axes: usize,
    /// Direction numbers of the Sobol' sequence, by dimension.
    directions: Vec<Vec<u64>>,
}

impl Sampler {
    /// The numbers of a design for some random axes, at most [`Design::axes`].
    pub fn new(design: Design, samples: usize, seed: u64, axes: usize) -> Sampler {
        let directions = match design {
            Design::Random | Design::LatinHypercube => vec![],
            // The generator is an iterator. From its direction numbers any point is computed directly.
            Design::Sobol | Design::Saltelli => Sobol::<u64>::init_direction_vals::<u32>(
                design.dimensions(axes).min(SEQUENCE),
                BITS,
                &JoeKuoD6::minimal(),
            ),
        };
        Sampler { design, samples, seed, axes, directions }
    }

    /// Number of points per point of the grid; `None` if it is too large for a number.
    pub fn points(&self) -> Option<usize> {
        self.design.points(self.samples, self.axes)
    }

    /// The number in [0, 1) of random axis `axis` at sample `sample` of point `grid` of the grid.
    pub fn fraction(&self, grid: usize, sample: usize, axis: usize) -> f64 {
        match self.design {
            Design::Random => random::fraction(self.seed, ((grid * self.samples + sample) * self.axes + axis) as u64),
            Design::LatinHypercube => {
                let stratum = permute(sample as u32, self.samples as u32, random::bits(self.seed, axis as u64) as u32);
                let within = random::fraction(!self.seed, (sample * self.axes + axis) as u64);
                (f64::from(stratum) + within) / self.samples as f64
            }
            Design::Sobol => self.sequence(sample, axis),
            Design::Saltelli => {
                // The points of a base sample: A, then A with the value of one axis taken from B, then B.
                let (base, which) = (sample / (self.axes + 2), sample % (self.axes + 2));
                let of_b = which == axis + 1 || which == self.axes + 1;
                self.sequence(base, if of_b { self.axes + axis } else { axis })
            }
        }
    }

    /// Whether a sample is independent of those before it. For the design `saltelli` only the points A and B are.
    pub fn is_independent(&self, sample: usize) -> bool {
        let which = sample % (self.axes + 2);
        self.design != Design::Saltelli || which == 0 || which == self.axes + 1
    }

    /// Number `i` of a dimension of the Sobol' sequence, with its digits shifted at random.
    fn sequence(&self, i: usize, dimension: usize) -> f64 {
        let gray = i ^ (i >> 1);
        let bits = (0..BITS).filter(|bit| gray >> bit & 1 == 1).map(|bit| self.directions[dimension][bit]);
        let shifted = bits.fold(random::bits(self.seed, dimension as u64), |x, direction| x ^ direction);
        random::unit(shifted)
    }
}

/// The image of `i` in 0..n under permutation number `p`. Source: A. Kensler, "Correlated multi-jittered sampling", Pixar Technical Memo
/// 13-01 (2013): a bijection of the next power of two, applied until the result is below n.
fn permute(i: u32, n: u32, p: u32) -> u32 {
    let mask = n.next_power_of_two().wrapping_sub(1);
    let mut i = i;
    loop {
        i = (i ^ p).wrapping_mul(0xe170_893d);
        i ^= p >> 16;
        i ^= (i & mask) >> 4;
        i = (i ^ p >> 8).wrapping_mul(0x0929_eb3f);
        i ^= p >> 23;
        i ^= (i & mask) >> 1;
        i = i.wrapping_mul(1 | p >> 27).wrapping_mul(0x6935_fa69);
        i ^= (i & mask) >> 11;
        i = i.wrapping_mul(0x74dc_b303);
        i ^= (i & mask) >> 2;
        i = i.wrapping_mul(0x9e50_1cc3);
        i ^= (i & mask) >> 2;
        i = i.wrapping_mul(0xc860_a3df) & mask;
        i ^= i >> 5;
        if i < n {
            return ((u64::from(i) + u64::from(p)) % u64::from(n)) as u32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(sampler: &Sampler, axis: usize) -> Vec<f64> {
        (0..sampler.samples).map(|sample| sampler.fraction(0, sample, axis)).collect()
    }

    #[test]
    fn a_latin_hypercube_has_one_point_in_each_interval_of_each_axis() {
        for samples in [1, 2, 3, 7, 64, 1000] {
            let sampler = Sampler::new(Design::LatinHypercube, samples, 11, 3);
            for axis in 0..3 {
                let mut strata: Vec<usize> =
                    places(&sampler, axis).iter().map(|x| (x * samples as f64) as usize).collect();
                strata.sort_unstable();
                assert_eq!(strata, (0..samples).collect::<Vec<_>>());
            }
        }
        // The axes are independent: the correlation of 1000 points is 0 within four standard deviations.
        let sampler = Sampler::new(Design::LatinHypercube, 1000, 11, 2);
        let (x, y) = (places(&sampler, 0), places(&sampler, 1));
        let correlation: f64 = x.iter().zip(&y).map(|(x, y)| 12.0 * (x - 0.5) * (y - 0.5)).sum::<f64>() / 1000.0;
        assert!(correlation.abs() < 4.0 / 1000_f64.sqrt(), "{correlation}");
    }

    /// The first two dimensions of a Sobol' sequence are a (0, 2)-sequence: divide the unit square into 2^8 equal boxes of 2^-a by
    /// 2^-(8 - a), and 2^8 points lie one in each. The random shift of the digits does not change this.
    #[test]
    fn a_sobol_sequence_fills_elementary_boxes() {
        for seed in [0, 9] {
            let sampler = Sampler::new(Design::Sobol, 256, seed, 2);
            let (x, y) = (places(&sampler, 0), places(&sampler, 1));
            for a in 0..=8 {
                let boxed =
                    |(x, y): (&f64, &f64)| ((x * f64::from(1 << a)) as usize, (y * f64::from(1 << (8 - a))) as usize);
                let mut boxes: Vec<_> = x.iter().zip(&y).map(boxed).collect();
                boxes.sort_unstable();
                boxes.dedup();
                assert_eq!(boxes.len(), 256, "{a}");
            }
        }
    }

    #[test]
    fn the_points_of_saltelli_take_one_axis_from_the_other_sample() {
        let (d, sampler) = (3, Sampler::new(Design::Saltelli, 4, 2, 3));
        assert_eq!(sampler.points(), Some(4 * 5));
        for base in 0..4 {
            let point = |k: usize| [0, 1, 2].map(|axis| sampler.fraction(0, base * (d + 2) + k, axis));
            let (a, b) = (point(0), point(d + 1));
            assert!((0..d).all(|axis| a[axis] != b[axis]));
            for one in 0..d {
                let mut expected = a;
                expected[one] = b[one];
                assert_eq!(point(one + 1), expected);
            }
        }
    }
}
