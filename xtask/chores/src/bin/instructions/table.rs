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
                let bound = path.at_most.map_or(String::new(), |most| format!(" (at most {most})"));
                (format!("`{other}`"), format!("{:.3}{bound}", self.ratio(*count, other)))
            });
            text += &format!("| `{}` | {} | {count:.1} | {} | {} |\n", path.name, path.what, compared.0, compared.1);
        }
        text
    }

    /// A count over that of the path `other`.
    fn ratio(&self, count: f64, other: &str) -> f64 {
        PATHS.iter().position(|path| path.name == other).map_or(f64::NAN, |i| count / self.counts[i])
    }

    /// Compares the counts with those of a committed table.
    ///
    /// # Errors
    /// Names every path that the table lacks, whose count differs from it by more than 3 %, or whose ratio is too large.
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
        for (path, now) in PATHS.iter().zip(&self.counts) {
            let (Some(other), Some(most)) = (path.compared_with, path.at_most) else { continue };
            let ratio = self.ratio(*now, other);
            if ratio.is_nan() || ratio > most {
                faults.push(format!(
                    "`{}` takes {ratio:.3} times the instructions of `{other}`, at most {most} allowed",
                    path.name
                ));
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
