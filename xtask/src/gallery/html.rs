//! `cargo xtask gallery --html`: all scenes as one page, each with its key plots, its numbers and a link to its interactive page.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, bail};
use serde_json::Value;

/// Plots of a scene on the page, in order of preference; two of those that the run has drawn are shown.
const PLOTS: [&str; 6] = ["outputs", "motion", "orders", "energy", "spectrum", "order_cuts"];
const SHOWN: usize = 2;

/// A scene of the gallery and its run.
struct Shown {
    /// Path under models/scenes, without the ending: `drives/governor`.
    name: String,
    about: String,
    /// summary.json.
    summary: Value,
}

/// Runs every scene under models/scenes, and writes the page and its folders to target/gallery. Returns the path of the page.
///
/// # Errors
/// If a scene fails, or a file cannot be read or written.
pub(super) fn write(root: &Path) -> anyhow::Result<PathBuf> {
    let target = root.join("target/gallery");
    let mut all = vec![];
    for name in scenes(&root.join("models/scenes"))? {
        let scene = root.join("models/scenes").join(&name).with_extension("toml");
        let out = target.join(folder(&name));
        let mut gearsim = Command::new(env!("CARGO"));
        gearsim.args([
            "run",
            "--quiet",
            "--release",
            "--features",
            "html",
            "--package",
            "gearsim",
            "--",
            "run",
            "--html",
            "-q",
        ]);
        let status =
            gearsim.arg(&scene).arg("--out").arg(&out).current_dir(root).status().context("cannot start cargo")?;
        if !status.success() {
            bail!("the scene {name} failed; its message is above");
        }
        let summary = fs::read(out.join("summary.json")).with_context(|| format!("{name} has no summary"))?;
        let text = fs::read_to_string(&scene).with_context(|| format!("cannot read {}", scene.display()))?;
        all.push(Shown { about: about(&text), name, summary: serde_json::from_slice(&summary)? });
    }
    let path = target.join("index.html");
    fs::write(&path, page(&all)).with_context(|| format!("cannot write {}", path.display()))?;
    Ok(path)
}

/// The scenes under a folder, by their paths without the ending, sorted.
fn scenes(folder: &Path) -> anyhow::Result<Vec<String>> {
    let (mut open, mut found) = (vec![folder.to_owned()], vec![]);
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(&next).with_context(|| format!("cannot read {}", next.display()))? {
            let path = entry?.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|ending| ending == "toml") {
                let name = path.strip_prefix(folder)?.with_extension("");
                found.push(name.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    found.sort();
    Ok(found)
}

/// The folder of a scene's run.
fn folder(name: &str) -> String {
    name.replace('/', "_")
}

/// The text `about` of a scene; empty if it has none.
fn about(scene: &str) -> String {
    let line = scene.lines().find_map(|line| line.strip_prefix("about = "));
    line.map_or(String::new(), |text| text.trim().trim_matches('"').to_owned())
}

/// The page.
fn page(all: &[Shown]) -> String {
    let mut body = String::new();
    let _ = write!(
        body,
        "<h1>Scenes of gearsim</h1>\n<p>{} scenes. Each name opens the interactive page of its run.</p>\n",
        all.len()
    );
    body += "<nav><ul>\n";
    for shown in all {
        let _ = writeln!(body, "<li><a href=\"#{0}\">{1}</a></li>", folder(&shown.name), escape(&shown.name));
    }
    body += "</ul></nav>\n";
    all.iter().for_each(|shown| body += &section(shown));
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, \
         initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n<title>Scenes of gearsim</title>\n<style>{STYLE}</style>\n\
         </head>\n<body>\n{body}</body>\n</html>\n"
    )
}

fn section(Shown { name, about, summary }: &Shown) -> String {
    let id = folder(name);
    let mut text = format!(
        "<section id=\"{id}\">\n<h2><a href=\"{id}/page.html\">{}</a></h2>\n<p>{}</p>\n",
        escape(name),
        escape(about)
    );
    let drawn: Vec<&str> = summary["files"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let has = |plot: &&&str| drawn.contains(&format!("{plot}.svg").as_str());
    text += "<div class=\"plots\">\n";
    for plot in PLOTS.iter().filter(has).take(SHOWN) {
        let _ = writeln!(
            text,
            "<a href=\"{id}/page.html\"><img loading=\"lazy\" src=\"{id}/{plot}.svg\" alt=\"{} of {}\"></a>",
            plot.replace('_', " "),
            escape(name)
        );
    }
    text += "</div>\n<dl>\n";
    for (what, value) in facts(summary) {
        let _ = writeln!(text, "<dt>{what}</dt><dd>{}</dd>", escape(&value));
    }
    text + "</dl>\n</section>\n"
}

/// The facts in the summary of a run: the name and the text of each.
fn facts(summary: &Value) -> Vec<(&'static str, String)> {
    let text = |value: &Value| value.as_str().unwrap_or("not known").to_owned();
    let number = |value: &Value| value.as_f64().map_or("not known".into(), short);
    let list = |value: &Value| value.as_array().into_iter().flatten().map(text).collect::<Vec<_>>().join(", ");
    let energy = &summary["energy"];
    let mut facts = vec![
        ("model", text(&summary["model"])),
        ("effects", list(&summary["effects"])),
        ("method", format!("{}: {}", text(&summary["method"]["name"]), text(&summary["method"]["why"]))),
        (
            "time",
            format!(
                "{} s of motion in {} s of processor time",
                number(&summary["t_end"]),
                number(&summary["cpu_seconds"])
            ),
        ),
        ("events", format!("{} cell changes, {} reflections", summary["cell_changes"], summary["reflections"])),
        ("energy", format!("{} J unaccounted for, of {} J", number(&energy["residual"]), number(&energy["largest"]))),
    ];
    if let Some(digits) = summary["digits"]["at_end"].as_f64() {
        facts.push(("digits", format!("{digits:.1} left at the end")));
    }
    let meshes = summary["meshes"].as_object().into_iter().flatten();
    let factors = meshes.filter_map(|(law, mesh)| Some(format!("{law}: {}", short(mesh["dynamic_factor"].as_f64()?))));
    let factors: Vec<String> = factors.collect();
    if !factors.is_empty() {
        facts.push(("dynamic factor", factors.join(", ")));
    }
    facts
}

/// A number with three digits.
fn short(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => {
            let digits = (2 - size.log10().floor() as i32).max(0) as usize;
            let text = format!("{x:.digits$}");
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
        }
        _ => format!("{x:.2e}"),
    }
}

/// `text` as text of HTML and of its attributes.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;").replace('\'', "&#39;")
}

const STYLE: &str = include_str!("gallery.css");

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
    }

    fn summary() -> Value {
        serde_json::json!({
            "model": "gear_pair", "effects": ["damping"], "method": { "name": "exact", "why": "every cell is linear" }, "t_end": 0.1,
            "cpu_seconds": 0.002, "cell_changes": 12, "reflections": 3, "energy": { "residual": 1e-13, "largest": 2.5 },
            "digits": { "at_end": 11.26 }, "meshes": { "k": { "dynamic_factor": 1.5 } },
            "files": ["trajectory.parquet", "energy.svg", "motion.svg", "outputs.svg", "page.html"],
        })
    }

    /// Every scene file under models/scenes has a section with its page, two plots and its text `about`.
    #[test]
    fn the_page_has_every_scene() {
        let names = scenes(&root().join("models/scenes")).unwrap();
        assert!(names.len() > 30 && names.iter().any(|name| name == "drives/governor"), "{names:?}");
        let shown = |name: &String| {
            let text = fs::read_to_string(root().join("models/scenes").join(name).with_extension("toml")).unwrap();
            assert!(!about(&text).is_empty(), "the scene {name} does not say what it shows");
            Shown { name: name.clone(), about: about(&text), summary: summary() }
        };
        let all: Vec<_> = names.iter().map(shown).collect();
        let text = page(&all);
        for Shown { name, about, .. } in &all {
            let id = folder(name);
            assert!(
                text.contains(&format!("<section id=\"{id}\">")) && text.contains(&format!("href=\"{id}/page.html\"")),
                "{name}"
            );
            assert!(text.contains(&escape(about)) && text.contains(&format!("src=\"{id}/outputs.svg\"")), "{name}");
            assert_eq!(text.matches(&format!("src=\"{id}/")).count(), SHOWN, "{name}");
        }
        // Two scenes do not share a folder.
        let folders: std::collections::BTreeSet<_> = names.iter().map(|name| folder(name)).collect();
        assert_eq!(folders.len(), names.len());
    }

    #[test]
    fn texts_of_scenes_are_escaped_in_html() {
        let hostile = Shown { name: "a".into(), about: "</p><script>alert(1)</script>".into(), summary: summary() };
        assert!(!page(&[hostile]).contains("<script"));
        let words: Vec<_> = facts(&summary()).into_iter().map(|(_, text)| text).collect();
        assert_eq!(
            words[3..],
            [
                "0.1 s of motion in 0.002 s of processor time",
                "12 cell changes, 3 reflections",
                "1.00e-13 J unaccounted for, of 2.5 J",
                "11.3 left at the end",
                "k: 1.5"
            ]
        );
    }
}
