//! `cargo xtask gallery`: run the example scenes and write a plot of each to models/scenes/plots, or compare them with those that are there.

mod html;

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

/// The scenes, by their paths under models/scenes, and the plot that is kept of each.
const SCENES: [(&str, &str); 29] = [
    ("backlash", "motion"),
    ("backlash_oscillator", "motion"),
    ("drives/fan_run_up", "outputs"),
    ("drives/governor", "outputs"),
    ("drives/start_up", "motion"),
    ("drives/torque_ripple", "outputs"),
    ("drives/traction_run_up", "outputs"),
    ("drives/tip_in", "outputs"),
    ("gear_pair_bearings", "outputs"),
    ("gear_pair_shafts", "spectrum"),
    ("geared_branches", "motion"),
    ("idler", "outputs"),
    ("pitch_errors", "outputs"),
    ("rattle", "motion"),
    ("sliding_friction", "outputs"),
    ("flank_stiction", "motion"),
    ("transmission_error", "outputs"),
    ("planetary_errors", "spectrum"),
    ("two_stage", "outputs"),
    ("belt_drive", "outputs"),
    ("chain_5", "motion"),
    ("friction_oscillator", "motion"),
    ("freewheel", "motion"),
    ("clutch_engages", "outputs"),
    ("damaged_tooth", "orders"),
    ("electric_axle", "outputs"),
    ("end_stop", "motion"),
    ("train_branches", "outputs"),
    ("train_turbine", "outputs"),
];

/// The scenes whose response curves are kept, each with its speeds, and the time in which a point settles.
const RESPONSES: [(&str, &str, &str); 2] = [
    ("response", "start.speed=2200 rpm:4200 rpm:51", "0.1 s"),
    ("train_kahraman_singh", "start.speed=3400 rpm:8600 rpm:53", "30 ms"),
];

/// Run the example scenes; write a plot of each to models/scenes/plots.
#[derive(clap::Args)]
pub struct Gallery {
    /// Instead write all scenes as a page, with plots, numbers and interactive pages, to target/gallery
    #[arg(long)]
    html: bool,
    /// Write no plot; fail if one of models/scenes/plots differs from what its scene gives here, to the byte
    #[arg(long, conflicts_with = "html")]
    check: bool,
}

impl Gallery {
    /// Runs the scenes one after another; their outputs go to out/gallery, or to target/gallery as a page.
    ///
    /// # Errors
    /// If a scene fails, or its plot cannot be copied, or differs with `--check`.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent folder")?;
        if self.html {
            println!("{}", html::write(root)?.display());
            return Ok(());
        }
        let (scenes, plots) = (root.join("models/scenes"), root.join("models/scenes/plots"));
        fs::create_dir_all(&plots).with_context(|| format!("cannot make the folder {}", plots.display()))?;
        let mut stale = vec![];
        let mut draw = |command: &str, scene: &str, arguments: &[&str], plot: &str, name: &str| {
            let out = root.join("out/gallery").join(name);
            let mut gearsim = Command::new(env!("CARGO"));
            gearsim.args(["run", "--quiet", "--release", "--", command]);
            gearsim.arg(scenes.join(scene).with_extension("toml")).args(arguments).arg("--out").arg(&out);
            let status = gearsim.current_dir(root).status().context("cannot start cargo")?;
            if !status.success() {
                bail!("{command} of the scene {scene} failed; its message is above");
            }
            let (from, to) = (out.join(plot), plots.join(name));
            let (from, to) = (from.with_extension("png"), to.with_extension("png"));
            if self.check {
                let fresh = fs::read(&from).with_context(|| format!("cannot read {}", from.display()))?;
                if fs::read(&to).ok() != Some(fresh) {
                    stale.push(name.to_owned());
                }
                return Ok(0);
            }
            fs::copy(&from, &to).with_context(|| format!("cannot copy {} to {}", from.display(), to.display()))
        };
        for (scene, plot) in SCENES {
            draw("run", scene, &["--set", &format!("output.plots=[\"{plot}\"]")], plot, &scene.replace('/', "_"))?;
        }
        for (scene, over, settle) in RESPONSES {
            let arguments = ["--over", over, "--settle", settle, "--output", "dte_12"];
            draw("response", scene, &arguments, "response", scene)?;
        }
        if !stale.is_empty() {
            bail!("stale in {}: {}; renew them with `cargo xtask gallery`", plots.display(), stale.join(", "));
        }
        println!("{}", plots.display());
        Ok(())
    }
}
