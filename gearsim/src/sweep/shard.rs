//! A part of a sweep for one machine: shard i of n has every n-th point, from the i-th on.

use std::fmt;
use std::str::FromStr;

/// Shard `i` of `n`, 1 <= i <= n.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    i: usize,
    n: usize,
}

impl Shard {
    /// The whole sweep.
    pub const WHOLE: Shard = Shard { i: 1, n: 1 };

    /// Whether a point is in this shard. Neighbouring points take about the same time, so they are in different shards.
    pub fn has(self, point: usize) -> bool {
        point % self.n == self.i - 1
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Shard, String> {
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
        match parts {
            Some((i, n)) if (1..=n).contains(&i) => Ok(Shard { i, n }),
            _ => Err("write I/N with I from 1 to N, e.g. 2/8".into()),
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.i, self.n)
    }
}
