//! Which points a sweep has, and in which order: a grid of all values of its axes, the last axis counting fastest;
//! with random axes so many samples at every place of the grid, counting faster still.

use super::axis::Axis;

/// The points of a sweep. Point `i` is a function of the plan and `i` alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What is varied.
    pub axes: Vec<Axis>,
    /// Points at every place of the grid; 1 without random axes.
    pub samples: usize,
    /// Seed of the random axes.
    pub seed: u64,
}

/// More points than this are refused: their rows would not fit in memory.
pub const MOST_POINTS: usize = 10_000_000;

impl Plan {
    /// Number of points; `None` if there are more than [`MOST_POINTS`].
    pub fn points(&self) -> Option<usize> {
        let points = self.axes.iter().filter_map(Axis::count).try_fold(self.samples, usize::checked_mul);
        points.filter(|&points| points <= MOST_POINTS)
    }

    /// Whether an axis has random values.
    pub fn is_random(&self) -> bool {
        self.axes.iter().any(|axis| axis.count().is_none())
    }

    /// The value of each axis at a point, as it would stand in a scene.
    pub fn values(&self, point: usize) -> Vec<String> {
        let random = self.axes.iter().filter(|axis| axis.count().is_none()).count();
        let mut place = point / self.samples;
        let (mut values, mut drawn) = (vec![], random);
        for axis in self.axes.iter().rev() {
            values.push(match axis.count() {
                Some(n) => {
                    let i = place % n;
                    place /= n;
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

    /// Points that stand for all when values are checked: every listed value and every end of a range once, the others
    /// at their first.
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
