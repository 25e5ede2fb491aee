//! Stability over one or two varied quantities.

use super::Floquet;

/// A quantity that is varied.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    /// Its key in the scene, e.g. `start.speed`; or what it is shown as.
    pub name: String,
    /// Unit of the values.
    pub unit: String,
    /// Its values, rising.
    pub values: Vec<f64>,
}

impl Varied {
    /// Its name without the table of the scene that it is in.
    pub fn label(&self) -> &str {
        self.name.split_once('.').map_or(&self.name, |(_, name)| name)
    }

    /// The smallest value.
    pub fn low(&self) -> f64 {
        self.values.first().copied().unwrap_or(0.0)
    }

    /// The largest.
    pub fn high(&self) -> f64 {
        self.values.last().copied().unwrap_or(1.0)
    }
}

/// What is known at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// ln of the largest multiplier.
    pub growth: f64,
    /// Whether a disturbance grows exponentially.
    pub unstable: bool,
    /// Frequency of the mesh over the lowest natural frequency at the mean stiffness.
    pub ratio: f64,
}

impl From<&Floquet> for Spot {
    fn from(f: &Floquet) -> Spot {
        Spot { growth: f.growth(), unstable: f.verdict.is_unstable(), ratio: f.mesh / f.natural }
    }
}

/// A chart: a row of spots for each value of y, or one row.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Name of the scene.
    pub scene: String,
    /// What changes along a row.
    pub x: Varied,
    /// What changes from row to row.
    pub y: Option<Varied>,
    /// The rows; `None` where a spot is refused.
    pub rows: Vec<Vec<Option<Spot>>>,
}

impl Chart {
    /// The same over the ratio of the mesh frequency to the natural frequency, where that changes along x and is the same in
    /// every row: what says more than a speed.
    pub fn by_ratio(mut self) -> Chart {
        let ratios = |row: &Vec<Option<Spot>>| row.iter().map(|s| s.map(|s| s.ratio)).collect::<Option<Vec<f64>>>();
        let all: Option<Vec<Vec<f64>>> = self.rows.iter().map(ratios).collect();
        let Some(all) = all else { return self };
        let Some(first) = all.first() else { return self };
        let rising = first.windows(2).all(|w| w[1] > w[0]);
        let same = all.iter().all(|row| row.iter().zip(first).all(|(a, b)| (a - b).abs() <= 1e-9 * b.abs()));
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
