//! The points of a sweep and their order: a grid of all values of the axes that are not random, in which the last axis varies
//! fastest. With random axes, every grid point is a block of points, as the [design](super::design) makes them.

use super::axis::Axis;
use super::design::{Design, Sampler};
use crate::tolerance::scene::SWEEP_POINTS;

/// The points of a sweep. Point `i` is a function of the plan and `i` alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What is varied.
    pub axes: Vec<Axis>,
    /// The numbers of the random axes.
    pub sampler: Sampler,
}

impl Plan {
    /// The points of `axes`, with `samples` of a design per point of the grid: 1 without random axes.
    pub fn new(axes: Vec<Axis>, design: Design, samples: usize, seed: u64) -> Plan {
        let random = axes.iter().filter(|axis| axis.count().is_none()).count();
        Plan { axes, sampler: Sampler::new(design, samples, seed, random) }
    }

    /// Number of points; `None` if there are more than `SWEEP_POINTS`.
    pub fn points(&self) -> Option<usize> {
        let mut counts = self.axes.iter().filter_map(Axis::count);
        let points = counts.try_fold(self.sampler.points()?, usize::checked_mul);
        points.filter(|&points| points <= SWEEP_POINTS)
    }

    /// Whether an axis has random values.
    pub fn is_random(&self) -> bool {
        self.sampler.axes > 0
    }

    /// Number of points per point of the grid. They are consecutive.
    pub fn block(&self) -> usize {
        self.sampler.points().unwrap_or(usize::MAX)
    }

    /// The value of each axis at a point, written as in a scene file.
    pub fn values(&self, point: usize) -> Vec<String> {
        let (grid, sample) = (point / self.block(), point % self.block());
        let (mut rest, mut random) = (grid, self.sampler.axes);
        let mut value = |axis: &Axis| match axis.count() {
            Some(n) => {
                let i = rest % n;
                rest /= n;
                axis.value(i)
            }
            None => {
                random -= 1;
                axis.drawn(self.sampler.fraction(grid, sample, random))
            }
        };
        let mut values: Vec<String> = self.axes.iter().rev().map(&mut value).collect();
        values.reverse();
        values
    }

    /// The point as overrides of the scene: `parameters.T0=20 N*m`.
    pub fn overrides(&self, point: usize) -> Vec<String> {
        self.assign(self.values(point))
    }

    /// The points to check instead of all, as overrides: every listed value and every end of a range occurs once, with the other
    /// axes at their first values.
    pub fn trials(&self) -> Vec<Vec<String>> {
        let tried: Vec<Vec<String>> = self.axes.iter().map(Axis::trials).collect();
        let first: Vec<String> = tried.iter().filter_map(|values| values.first().cloned()).collect();
        let mut trials = vec![self.assign(first.clone())];
        for (i, values) in tried.iter().enumerate() {
            for value in values.iter().skip(1) {
                let mut trial = first.clone();
                trial[i] = value.clone();
                trials.push(self.assign(trial));
            }
        }
        trials
    }

    fn assign(&self, values: Vec<String>) -> Vec<String> {
        self.axes.iter().zip(values).map(|(axis, value)| format!("{}={value}", axis.key)).collect()
    }
}
