//! Tests of the folder of a result: what is replaced, and what is left if something fails.

use std::path::Path;

use super::*;
use crate::output::fault::{self, Fault};
use crate::output::marker::MARKER;

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Writes a result with the given files; each contains `text`.
fn result(folder: &Path, index: &str, files: &[&str], text: &str) -> Result<(), OutputError> {
    let mut folder = OutputFolder::create(folder)?;
    for name in files {
        folder.write_bytes(name, text.as_bytes())?;
    }
    let list = serde_json::to_string(files).unwrap();
    let json = format!("{{\"files\": {list}, \"text\": \"{text}\", \"provenance\": {{\"program\": \"gearsim\"}}}}");
    folder.write_bytes(index, json.as_bytes())?;
    folder.commit(index)
}

#[test]
fn a_result_appears_when_it_is_whole_and_replaces_the_earlier_one() {
    let root = tempfile::tempdir().unwrap();
    std::fs::write(root.path().join("notes.txt"), "of the user").unwrap();
    result(root.path(), "summary.json", &["trajectory.parquet", "trajectory.csv", "plots/energy.svg"], "1").unwrap();
    let mut folder = OutputFolder::create(root.path()).unwrap();
    folder.write_bytes("trajectory.parquet", b"2").unwrap();
    assert_eq!(std::fs::read(root.path().join("trajectory.parquet")).unwrap(), b"1", "not before it is whole");
    drop(folder);
    result(root.path(), "summary.json", &["trajectory.parquet"], "2").unwrap();
    assert_eq!(names(root.path()), ["notes.txt", "plots", "summary.json", "trajectory.parquet"]);
    assert!(names(&root.path().join("plots")).is_empty());
    assert_eq!(std::fs::read(root.path().join("trajectory.parquet")).unwrap(), b"2");
}

/// Results with other names stay beside each other; one that shares a file is removed with all its files.
#[test]
fn a_result_that_shares_a_file_is_removed_whole() {
    let root = tempfile::tempdir().unwrap();
    result(root.path(), "modes.json", &["shapes.svg"], "modes").unwrap();
    result(root.path(), "compare.json", &["trajectory_exact.parquet", "energy.svg"], "compare").unwrap();
    result(root.path(), "summary.json", &["trajectory.parquet", "energy.svg"], "run").unwrap();
    let expected = ["energy.svg", "modes.json", "shapes.svg", "summary.json", "trajectory.parquet"];
    assert_eq!(names(root.path()), expected);
}

/// A page is removed together with its own result, even if the index of that result does not list the page. Another result leaves it.
#[test]
fn a_page_is_replaced_with_its_result() {
    let root = tempfile::tempdir().unwrap();
    let page = |index: &str| {
        let mut folder = OutputFolder::create(root.path()).unwrap();
        folder
            .write_bytes("page.html", format!("<!DOCTYPE html>{}", crate::output::belongs(index)).as_bytes())
            .unwrap();
        folder.write_bytes(index, b"t").unwrap();
        folder.commit(index).unwrap();
    };
    page("response.csv");
    result(root.path(), "modes.json", &["shapes.svg"], "modes").unwrap();
    assert!(names(root.path()).contains(&"page.html".into()));
    result(root.path(), "response.csv", &["response.svg"], "2").unwrap();
    assert_eq!(names(root.path()), ["modes.json", "response.csv", "response.svg", "shapes.svg"]);
    std::fs::write(root.path().join("page.html"), "of the user").unwrap();
    result(root.path(), "response.csv", &["response.svg"], "3").unwrap();
    assert!(names(root.path()).contains(&"page.html".into()));
}

/// An index that another program wrote says nothing about files of gearsim.
#[test]
fn files_that_another_program_lists_are_left_alone() {
    let root = tempfile::tempdir().unwrap();
    std::fs::write(root.path().join("thesis.txt"), "text").unwrap();
    std::fs::write(root.path().join("summary.json"), r#"{"files": ["thesis.txt"]}"#).unwrap();
    result(root.path(), "summary.json", &["trajectory.parquet"], "1").unwrap();
    assert_eq!(names(root.path()), ["summary.json", "thesis.txt", "trajectory.parquet"]);
}

#[test]
fn leftovers_are_cleared_but_not_those_of_a_running_process() {
    let root = tempfile::tempdir().unwrap();
    let mut running = OutputFolder::create(root.path()).unwrap();
    running.write_bytes("trajectory.csv", b"1").unwrap();
    std::fs::write(root.path().join(".gearsim-abcdef"), "of an interrupted command").unwrap();
    std::fs::create_dir(root.path().join(".gearsim-ghijkl")).unwrap();
    std::fs::write(root.path().join(".gearsim-ghijkl/trajectory.parquet"), "half").unwrap();
    result(root.path(), "summary.json", &["energy.svg"], "2").unwrap();
    assert_eq!(names(root.path()).len(), 3, "{:?}", names(root.path()));
    running.commit("trajectory.csv").unwrap();
    assert_eq!(names(root.path()), ["energy.svg", "summary.json", "trajectory.csv"]);
}

#[test]
fn a_folder_in_the_place_of_a_file_is_refused_before_anything_changes() {
    let root = tempfile::tempdir().unwrap();
    result(root.path(), "summary.json", &["a.svg"], "1").unwrap();
    std::fs::create_dir(root.path().join("b.svg")).unwrap();
    let error = result(root.path(), "summary.json", &["b.svg"], "2").unwrap_err().to_string();
    assert!(error.contains("a folder has this name") && error.contains("kept in"), "{error}");
    assert_eq!(names(root.path()), ["a.svg", "b.svg", "incomplete", "summary.json"]);
    assert_eq!(std::fs::read_to_string(root.path().join("a.svg")).unwrap(), "1");
}

/// A fault in any operation on a file, or the end of the process there, leaves the earlier result, the new result, or a marker.
#[test]
fn at_every_fault_the_folder_holds_one_whole_result_or_says_that_it_does_not() {
    let (old, new) = (["a.svg", "b.svg"], ["b.svg", "c.svg"]);
    let write = |root: &Path| result(root, "summary.json", &new, "2");
    let fresh = || {
        let root = tempfile::tempdir().unwrap();
        result(root.path(), "summary.json", &old, "1").unwrap();
        root
    };
    let (done, operations) = fault::with(None, || write(fresh().path()));
    done.unwrap();
    assert!(operations > 15, "{operations}");
    let (mut kept, mut marked) = (0, 0);
    for fault in (0..operations).flat_map(|n| [Fault::Once(n), Fault::From(n)]) {
        let root = fresh();
        let (written, _) = fault::with(Some(fault), || write(root.path()));
        let text = |name: &str| std::fs::read_to_string(root.path().join(name)).ok();
        if text(MARKER).is_some_and(|says| says.contains("c.svg")) {
            marked += 1;
            for name in ["a.svg", "b.svg", "c.svg"] {
                assert!(text(name).is_none_or(|text| text == "1" || text == "2"), "{fault:?}: {name}");
            }
        } else {
            let index = text("summary.json").unwrap_or_else(|| panic!("{fault:?}: {:?}", names(root.path())));
            let (files, content) = if index.contains("\"text\": \"1\"") { (old, "1") } else { (new, "2") };
            assert!(written.is_err() || content == "2", "{fault:?}");
            let there: Vec<_> = names(root.path()).into_iter().filter(|name| name.ends_with(".svg")).collect();
            assert_eq!(there, files, "{fault:?}");
            assert!(files.iter().all(|name| text(name).as_deref() == Some(content)), "{fault:?}");
        }
        // What was whole before a file failed is kept, unless the process died.
        if let Err(OutputError::Partial { files, path, .. }) = &written {
            kept += 1;
            assert!(files.iter().all(|name| path.join(name).exists() || root.path().join(name).exists()), "{fault:?}");
        }
        write(root.path()).unwrap();
        assert_eq!(names(root.path()), ["b.svg", "c.svg", "summary.json"], "{fault:?}");
    }
    assert!(kept > 5 && marked > 5, "{kept} {marked}");
}
