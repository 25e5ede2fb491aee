//! Tests of `gearsim run --html`.

use super::go;
use crate::cli::run::Run;
#[cfg(feature = "html")]
use {
    super::scene,
    crate::cli::{Failure, Verb},
    clap::Parser,
};

/// A program without the feature says how to add it, and runs nothing.
#[cfg(not(feature = "html"))]
#[test]
fn a_program_without_pages_names_the_command_that_adds_them() {
    let root = tempfile::tempdir().unwrap();
    let failure = go::<Run>(&root.path().join("out"), &["-q", "--html"]).unwrap_err();
    assert_eq!(failure.code(), 2);
    assert!(failure.to_string().contains("cargo build --release --features html"), "{failure}");
    assert!(!root.path().join("out").exists());
}

/// The page names every section and every column of the table; a hostile file name and a hostile text stay text.
#[cfg(feature = "html")]
#[test]
fn a_page_shows_the_run_and_escapes_the_scene() {
    let root = tempfile::tempdir().unwrap();
    let hostile = root.path().join("<img src=x onerror=alert(1)> \"a\" 'b' &amp; \u{2028}.toml");
    let text = std::fs::read_to_string(scene()).unwrap();
    let about = "about = \"</script><script>alert(2)</script>\"";
    let lines = text.lines().filter(|line| !line.starts_with("about"));
    let text = [about].into_iter().chain(lines).collect::<Vec<_>>().join("\n");
    std::fs::write(&hostile, text).unwrap();

    let (out, path) = (root.path().join("out"), hostile.display().to_string());
    let folder = out.display().to_string();
    let set = "output.plots=[\"energy\"]";
    Run::try_parse_from(["gearsim", &path, "--out", &folder, "-q", "--html", "--set", set])
        .map_err(Failure::Usage)
        .and_then(Run::run)
        .unwrap();
    let page = std::fs::read_to_string(out.join("page.html")).unwrap();
    let (content, _) = page.split_once("</main>").unwrap();
    for id in ["method", "motion", "energy", "spectra", "orders", "numbers", "counts", "scene", "model", "provenance"] {
        assert!(content.contains(&format!("<section id=\"{id}\"")), "no section {id}");
    }
    let (table, _) = crate::output::parquet::read(&out.join("trajectory.parquet")).unwrap();
    for column in table.columns().iter().filter(|column| !["t", "moment"].contains(&&*column.name)) {
        assert!(content.contains(&format!("\"name\":\"{}\"", column.name)), "no curve {}", column.name);
    }
    for wrong in ["<img", "<script>alert"] {
        assert!(!page.contains(wrong), "{wrong}");
    }
    assert!(content.contains("&lt;img src=x onerror=alert(1)&gt; &quot;a&quot; &#39;b&#39; &amp;amp; "));

    let summary = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: crate::output::Summary = serde_json::from_str(&summary).unwrap();
    assert!(summary.files.contains(&"page.html".into()));
    go::<Run>(&out, &["-q", "--set", set]).unwrap();
    assert!(!out.join("page.html").exists(), "a page of an earlier result stays");
}
