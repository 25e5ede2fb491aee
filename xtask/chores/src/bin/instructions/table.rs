//! The table of counts, and its comparison with the committed one.

use anyhow::bail;

use crate::paths::{PATHS, Path};

/// Largest relative difference to a committed count: versions of the compiler and of the C library change the counts.
const TOLERANCE: f64 = 0.03;

/// Instructions per item of every path.
pub struct Table {
    /// In the order of [`PATHS`].
    pub counts: Vec<f64>,
}

impl Table {
    /// The table as Markdown.
    pub fn markdown(&self) -> String {
        let mut text = String::from(
            "# Instruction counts of the main code paths\n\n\
             Measured by `cargo xtask instructions` under callgrind. With `--check`, as in CI, new counts must agree with these within 3 %.\n\n\
             | path | what | instructions per item | compared with | ratio |\n| --- | --- | --- | --- | --- |\n",
        );
        for (path, count) in PATHS.iter().zip(&self.counts) {
            let compared = path.compared_with.map_or((String::new(), String::new()), |other| {
                let ratio = self.of(other).map_or(f64::NAN, |other| count / other);
                (format!("`{other}`"), format!("{ratio:.3}"))
            });
            text += &format!("| `{}` | {} | {count:.1} | {} | {} |\n", path.name, path.what, compared.0, compared.1);
        }
        text
    }

    fn of(&self, name: &str) -> Option<f64> {
        PATHS.iter().position(|path| path.name == name).map(|i| self.counts[i])
    }

    /// Compares the counts with those of a committed table.
    ///
    /// # Errors
    /// Names every path that the table lacks, or whose count differs from it by more than 3 %.
    pub fn compare(&self, kept: &str) -> anyhow::Result<()> {
        let row = |path: &Path| kept.lines().find(|line| line.starts_with(&format!("| `{}` |", path.name)));
        let value = |line: &str| line.split('|').nth(3).and_then(|cell| cell.trim().parse::<f64>().ok());
        let mut faults = vec![];
        for (path, now) in PATHS.iter().zip(&self.counts) {
            match row(path).and_then(value) {
                None => faults.push(format!("`{}` is not in the table", path.name)),
                Some(then) if (now / then - 1.0).abs() <= TOLERANCE => println!("{:32} {now:9.1}", path.name),
                Some(then) => faults.push(format!(
                    "`{}` takes {now:.1} instructions, {:+.1} % against {then:.1} in the table",
                    path.name,
                    100.0 * (now / then - 1.0)
                )),
            }
        }
        if faults.is_empty() {
            return Ok(());
        }
        bail!(
            "{}\nIf the change is intended, run `cargo xtask instructions` to write the table anew.",
            faults.join("\n")
        )
    }
}
