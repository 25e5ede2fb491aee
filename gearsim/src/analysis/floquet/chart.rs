//! Stability charts over one or two varied quantities.

use super::Floquet;
use crate::tolerance::analysis::SAME_RATIO;

/// A quantity that is varied.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    /// Its key in the scene, e.g. `start.speed`; or a name to show.
    pub name: String,
    /// Unit of the values.
    pub unit: String,
    /// Its values, ascending.
    pub values: Vec<f64>,
}

impl Varied {
    /// Its name without that of its table in the scene: `speed` of `start.speed`.
    pub fn label(&self) -> &str {
        self.name.split_once('.').map_or(&self.name, |(_, name)| name)
    }

    /// The smallest value.
    pub fn low(&self) -> f64 {
        self.values.first().copied().unwrap_or(0.0)
    }

    /// The largest value.
    pub fn high(&self) -> f64 {
        self.values.last().copied().unwrap_or(1.0)
    }
}

/// The result at one point of a chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Growth per period: ln of the largest absolute value of a multiplier.
    pub growth: f64,
    /// Whether a disturbance grows exponentially.
    pub unstable: bool,
    /// Mesh frequency over the lowest natural frequency at the mean stiffness.
    pub ratio: f64,
}

impl From<&Floquet> for Spot {
    fn from(f: &Floquet) -> Spot {
        Spot { growth: f.growth(), unstable: f.verdict.is_unstable(), ratio: f.mesh / f.natural }
    }
}

/// A stability chart: a row of points for each value of y; a single row without y.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Name of the scene.
    pub scene: String,
    /// The quantity that varies along a row.
    pub x: Varied,
    /// The quantity that varies from row to row.
    pub y: Option<Varied>,
    /// The rows; `None` for a point that has no multipliers.
    pub rows: Vec<Vec<Option<Spot>>>,
}

impl Chart {
    /// The same chart with the ratio of mesh frequency to natural frequency as x, which says more than a speed. The chart is unchanged
    /// if that ratio does not rise along x, or differs between rows.
    pub fn by_ratio(mut self) -> Chart {
        let ratios = |row: &Vec<Option<Spot>>| row.iter().map(|s| s.map(|s| s.ratio)).collect::<Option<Vec<f64>>>();
        let all: Option<Vec<Vec<f64>>> = self.rows.iter().map(ratios).collect();
        let Some(all) = all else { return self };
        let Some(first) = all.first() else { return self };
        let rising = first.windows(2).all(|w| w[1] > w[0]);
        let same = all.iter().all(|row| row.iter().zip(first).all(|(a, b)| (a - b).abs() <= SAME_RATIO * b.abs()));
        if rising && same {
            self.x = Varied {
                name: "mesh frequency / natural frequency".into(),
                unit: String::new(),
                values: first.clone(),
            };
        }
        self
    }
}
