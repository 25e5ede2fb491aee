//! The table of counts, and its comparison with the one that is kept.

use anyhow::bail;

use crate::paths::{PATHS, Path};

/// Counts may differ by this from those kept: compilers and C libraries do.
const TOLERANCE: f64 = 0.03;

/// Instructions per item of every path.
pub struct Table {
    /// In the order of [`PATHS`].
    pub counts: Vec<f64>,
}

impl Table {
    /// As Markdown.
    pub fn markdown(&self) -> String {
        let mut text = String::from(
            "# Instructions of the main paths\n\n\
             `cargo xtask instructions`, under callgrind; `--check` in CI holds new counts to these within 3 %.\n\n\
             | path | what | instructions an item | beside | ratio |\n| --- | --- | --- | --- | --- |\n",
        );
        for (path, count) in PATHS.iter().zip(&self.counts) {
            let beside = path.beside.map_or((String::new(), String::new()), |other| {
                let ratio = self.of(other).map_or(f64::NAN, |other| count / other);
                (format!("`{other}`"), format!("{ratio:.3}"))
            });
            text += &format!("| `{}` | {} | {count:.1} | {} | {} |\n", path.name, path.what, beside.0, beside.1);
        }
        text
    }

    fn of(&self, name: &str) -> Option<f64> {
        PATHS.iter().position(|path| path.name == name).map(|i| self.counts[i])
    }

    /// Holds the counts to those of a table that was kept.
    ///
    /// # Errors
    /// Every path that is missing there or differs.
    pub fn compare(&self, kept: &str) -> anyhow::Result<()> {
        let row = |path: &Path| kept.lines().find(|line| line.starts_with(&format!("| `{}` |", path.name)));
        let value = |line: &str| line.split('|').nth(3).and_then(|cell| cell.trim().parse::<f64>().ok());
        let mut faults = vec![];
        for (path, now) in PATHS.iter().zip(&self.counts) {
            match row(path).and_then(value) {
                None => faults.push(format!("`{}` is not in the table", path.name)),
                Some(then) if (now / then - 1.0).abs() <= TOLERANCE => println!("{:32} {now:9.1}", path.name),
                Some(then) => faults.push(format!(
                    "`{}` takes {now:.1} instructions, {:+.1} % of the {then:.1} kept",
                    path.name,
                    100.0 * (now / then - 1.0)
                )),
            }
        }
        if faults.is_empty() {
            return Ok(());
        }
        bail!("{}\nIf this is meant to be, `cargo xtask instructions` writes the table anew.", faults.join("\n"))
    }
}
