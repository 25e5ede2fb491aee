//! The points of a sweep and their order: a grid of all values of the axes that are not random, in which the last axis varies
//! fastest. With random axes, every grid point is a number of samples in a row.

use super::axis::Axis;
use crate::tolerance::scene::SWEEP_POINTS;

/// The points of a sweep. Point `i` is a function of the plan and `i` alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What is varied.
    pub axes: Vec<Axis>,
    /// Number of points per grid point; 1 without random axes.
    pub samples: usize,
    /// Seed of the random axes.
    pub seed: u64,
}

impl Plan {
    /// Number of points; `None` if there are more than `SWEEP_POINTS`.
    pub fn points(&self) -> Option<usize> {
        let points = self.axes.iter().filter_map(Axis::count).try_fold(self.samples, usize::checked_mul);
        points.filter(|&points| points <= SWEEP_POINTS)
    }

    /// Whether an axis has random values.
    pub fn is_random(&self) -> bool {
        self.axes.iter().any(|axis| axis.count().is_none())
    }

    /// The value of each axis at a point, written as in a scene file.
    pub fn values(&self, point: usize) -> Vec<String> {
        let random = self.axes.iter().filter(|axis| axis.count().is_none()).count();
        let mut grid_point = point / self.samples;
        let (mut values, mut drawn) = (vec![], random);
        for axis in self.axes.iter().rev() {
            values.push(match axis.count() {
                Some(n) => {
                    let i = grid_point % n;
                    grid_point /= n;
                    axis.value(i, self.seed)
                }
                None => {
                    drawn -= 1;
                    axis.value(point * random + drawn, self.seed)
                }
            });
        }
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
        let samples: Vec<Vec<String>> = self.axes.iter().map(Axis::samples).collect();
        let first: Vec<String> = samples.iter().filter_map(|values| values.first().cloned()).collect();
        let mut trials = vec![self.assign(first.clone())];
        for (i, values) in samples.iter().enumerate() {
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
