//! Tests of `--html`.

use super::go;
use crate::cli::compare::Compare;
use crate::cli::modes::Modes;
use crate::cli::run::Run;
use crate::cli::sweep::SweepCommand;
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
    let out = root.path().join("out");
    let vary = ["-q", "--html", "--vary", "parameters.T0=1 N*m:2 N*m:2"];
    let failures = [
        go::<Run>(&out, &["-q", "--html"]),
        go::<Compare>(&out, &["-q", "--html"]),
        go::<Modes>(&out, &["-q", "--html"]),
        go::<SweepCommand>(&out, &vary),
    ];
    for failure in failures.map(Result::unwrap_err) {
        assert_eq!(failure.code(), 2);
        assert!(failure.to_string().contains("cargo build --release --features html"), "{failure}");
        assert!(!out.exists());
    }
}

/// The page of a result is replaced with it: the same command without `--html` leaves none.
#[cfg(feature = "html")]
#[test]
fn a_page_belongs_to_its_result() {
    let root = tempfile::tempdir().unwrap();
    let page = |out: &std::path::Path| std::fs::read_to_string(out.join("page.html")).ok();
    let vary = ["-q", "--vary", "parameters.T0=1 N*m:2 N*m:2"];
    for (html, name) in [(&["--html"][..], "with"), (&[], "without")] {
        let (compared, modes, swept) = (root.path().join("c"), root.path().join("m"), root.path().join("s"));
        go::<Compare>(&compared, &[&["-q"][..], html].concat()).unwrap();
        go::<Modes>(&modes, &[&["-q"][..], html].concat()).unwrap();
        go::<SweepCommand>(&swept, &[&vary[..], html].concat()).unwrap();
        for out in [compared, modes, swept] {
            assert_eq!(page(&out).is_some(), name == "with", "{name} --html in {}", out.display());
            assert!(page(&out).is_none_or(|text| text.trim_end().ends_with("</html>")));
        }
    }
}

/// Each plot that the scene asks for is in the page, and the loads of the meshes.
#[cfg(feature = "html")]
#[test]
fn a_page_has_the_plots_of_the_scene() {
    let root = tempfile::tempdir().unwrap();
    let (out, path) = (root.path().join("out").display().to_string(), scene().display().to_string());
    let sets =
        ["output.plots=[\"load_duration\", \"rainflow\", \"order_waterfall\"]", "output.rainflow=[\"mesh_torque\"]"];
    let sets = sets.iter().flat_map(|set| ["--set", set]);
    let words = ["gearsim", &path, "--out", &out, "-q", "--html"].into_iter().chain(sets);
    Run::try_parse_from(words).map_err(Failure::Usage).and_then(Run::run).unwrap();
    let page = std::fs::read_to_string(root.path().join("out/page.html")).unwrap();
    for said in ["Load duration", "Load spectrum", "Loads of the meshes", "dynamic factor"] {
        assert!(page.contains(said), "no {said}");
    }
    // The run is too short for a waterfall, and the page says so.
    assert!(page.contains("There is no plot order_waterfall"));
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
