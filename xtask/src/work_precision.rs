//! `cargo xtask work-precision`: measure time against error on the scenes of the paper; plots and tables go into the READMEs.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// Scenes under models/scenes/oh2005, the end of each run, and the name of its plot and tables.
const SCENES: [(&str, &str, &str); 3] = [
    ("spectrum_4500rpm_exact", "0.05 s", "4500rpm"),
    ("spectrum_600rpm_exact", "0.1 s", "600rpm"),
    ("stall_300rpm", "0.1 s", "stall"),
];
/// Files that have these tables between markers.
const READMES: [&str; 2] = ["README.md", "models/scenes/oh2005/README.md"];

/// Measure time against error on the scenes of the paper; write plots and tables into the READMEs.
#[derive(clap::Args)]
pub struct WorkPrecision {}

impl WorkPrecision {
    /// Measures one scene after another. The machine should be idle otherwise.
    ///
    /// # Errors
    /// If a measurement fails, or a README has no end marker.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent folder")?;
        let paper = root.join("models/scenes/oh2005");
        let mut parts = vec![];
        for (scene, t_end, name) in SCENES {
            let out = root.join("out/work_precision").join(name);
            let mut run = Command::new(env!("CARGO"));
            run.args(["run", "--quiet", "--release", "--", "work-precision"]);
            run.arg(paper.join(scene).with_extension("toml")).arg("--out").arg(&out);
            run.arg("--set").arg(format!("run.t_end={t_end}")).current_dir(root);
            if !run.status().context("cannot start cargo")?.success() {
                bail!("the measurement of {scene} failed; its message is above");
            }
            let text = fs::read_to_string(out.join("work_precision.md")).context("no table was written")?;
            let (words, table) = pick(&text).with_context(|| format!("no text or no table for {scene}"))?;
            parts.push((format!("{name} in words"), words));
            parts.push((name.to_string(), table));
            let to = paper.join("plots").join(format!("work_precision_{name}.png"));
            fs::copy(out.join("work_precision.png"), &to).with_context(|| format!("cannot write {}", to.display()))?;
        }
        for readme in READMES.map(|name| root.join(name)) {
            let text = fs::read_to_string(&readme).with_context(|| format!("cannot read {}", readme.display()))?;
            let text = parts.iter().try_fold(text, |text, (name, part)| fill(text, name, part))?;
            fs::write(&readme, text).with_context(|| format!("cannot write {}", readme.display()))?;
            println!("{}", readme.display());
        }
        Ok(())
    }
}

/// The paragraph below the plot, and the table of times.
fn pick(text: &str) -> Option<(String, String)> {
    let mut paragraphs = text.split("\n\n");
    let table = paragraphs.clone().find(|part| part.starts_with("| time at error"))?;
    paragraphs.find(|part| part.starts_with("!["))?;
    Some((paragraphs.next()?.trim().into(), table.trim().into()))
}

/// `text` with the lines between the markers of the part `name` replaced by `part`, if it has these markers.
fn fill(text: String, name: &str, part: &str) -> anyhow::Result<String> {
    let (begin, end) = (format!("<!-- cargo xtask work-precision: {name} -->\n"), "<!-- end -->");
    let Some((before, rest)) = text.split_once(&begin) else { return Ok(text) };
    let (_, after) = rest.split_once(end).with_context(|| format!("no `{end}` after `{}`", begin.trim()))?;
    Ok(format!("{before}{begin}\n{part}\n\n{end}{after}"))
}
