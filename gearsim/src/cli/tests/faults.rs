//! Faults on purpose: every operation on a file fails in turn, once or permanently, while a run replaces an earlier one. Afterwards
//! the folder holds all files of the earlier run, or all of the new one, or the marker of an incomplete folder. Every file can be read.

use std::path::Path;

use super::go;
use crate::cli::failure::Failure;
use crate::cli::run::Run;
use crate::output::fault::{self, Fault};
use crate::output::marker::MARKER;
use crate::output::{Summary, parquet};

const OLD: [&str; 6] = ["--csv", "-q", "--set", "run.t_end=2 ms", "--set", "output.plots=[\"energy\"]"];
const NEW: [&str; 7] = ["-q", "--set", "run.t_end=1 ms", "--set", "output.plots=[]", "--set", "output.rate=200 kHz"];
/// The files of the new run.
const WHOLE: [&str; 2] = ["summary.json", "trajectory.parquet"];

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Checks that a file is whole.
fn assert_readable(path: &Path) {
    match path.extension().and_then(|e| e.to_str()) {
        Some("parquet") => drop(parquet::read(path).unwrap()),
        Some("json") => drop(serde_json::from_slice::<Summary>(&std::fs::read(path).unwrap()).unwrap()),
        Some("svg") => assert!(std::fs::read_to_string(path).unwrap().trim_end().ends_with("</svg>")),
        Some("png") => assert!(std::fs::read(path).unwrap().ends_with(b"IEND\xaeB`\x82")),
        Some("csv") => assert!(std::fs::read_to_string(path).unwrap().ends_with('\n')),
        _ => panic!("unexpected file {}", path.display()),
    }
}

/// Checks the folder after a fault; returns whether it says that it is incomplete.
fn check(folder: &Path, what: &str) -> bool {
    let visible: Vec<_> = names(folder).into_iter().filter(|name| !name.starts_with(".gearsim-")).collect();
    let files = visible.iter().filter(|name| name.contains('.'));
    files.clone().for_each(|name| assert_readable(&folder.join(name)));
    for kept in std::fs::read_dir(folder.join("incomplete")).into_iter().flatten().flatten() {
        assert_readable(&kept.path());
    }
    if visible.iter().any(|name| name == MARKER) {
        return true;
    }
    let summary: Summary = serde_json::from_slice(&std::fs::read(folder.join("summary.json")).unwrap()).unwrap();
    let mut expected = summary.files.clone();
    expected.push("summary.json".into());
    expected.sort();
    assert_eq!(files.cloned().collect::<Vec<_>>(), expected, "{what}");
    let hash = &summary.provenance.scene_sha256;
    let (_, pairs) = parquet::read(&folder.join("trajectory.parquet")).unwrap();
    assert!(
        pairs.iter().any(|(name, value)| name == "scene_sha256" && value == hash),
        "{what}: two runs in one folder"
    );
    false
}

#[test]
fn a_run_that_replaces_another_leaves_one_of_them_whole_at_every_fault() {
    let root = tempfile::tempdir().unwrap();
    let old = root.path().join("old");
    go::<Run>(&old, &OLD).unwrap();
    let fresh = |name: String| {
        let folder = root.path().join(name);
        std::fs::create_dir(&folder).unwrap();
        for name in names(&old) {
            std::fs::copy(old.join(&name), folder.join(&name)).unwrap();
        }
        folder
    };
    let folder = fresh("none".into());
    let (done, operations) = fault::with(None, || go::<Run>(&folder, &NEW));
    done.unwrap();
    assert_eq!(names(&folder), WHOLE);
    assert!((15..400).contains(&operations), "{operations}");
    let mut marked = 0;
    for n in 0..operations {
        for fault in [Fault::Once(n), Fault::From(n)] {
            let folder = fresh(format!("{n}_{}", fault == Fault::Once(n)));
            let (result, _) = fault::with(Some(fault), || go::<Run>(&folder, &NEW));
            if let Err(failure) = &result {
                assert!(matches!(failure, Failure::Output(_)), "{fault:?}: {failure}");
                assert_eq!(failure.code(), 1);
            }
            marked += usize::from(check(&folder, &format!("{fault:?}")));
            go::<Run>(&folder, &NEW).unwrap();
            assert!(!check(&folder, "run again"));
            assert_eq!(names(&folder), WHOLE, "{fault:?}");
        }
    }
    assert!(marked > 5, "{marked}");
}
