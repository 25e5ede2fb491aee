//! The modules of gearsim form layers: a module may use only the modules below it.

use std::fs;
use std::path::{Path, PathBuf};

/// The modules, from the bottom up. A module may use those before it. Unit tests may use any module.
const LAYERS: [&str; 22] = [
    "tolerance",
    "model",
    "train",
    "profile",
    "gear",
    "trajectory",
    "scene",
    "engine",
    "methods",
    "ensemble",
    "run",
    "generated",
    "known",
    "analysis",
    "output",
    "sweep",
    "plot",
    "page",
    "library",
    "explore",
    "cli",
    "__private",
];

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// The names that follow `crate::` in the code of a file; comments and unit tests are left out.
fn named(text: &str) -> Vec<&str> {
    let code = text.split("#[cfg(test)]").next().unwrap_or("").lines();
    let code = code.filter(|line| !line.trim_start().starts_with("//"));
    let after = code.flat_map(|line| line.split("crate::").skip(1));
    after.map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("")).collect()
}

#[test]
fn no_module_uses_one_above_it() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("../gearsim/src");
    let mut all = vec![];
    files(&src, &mut all);
    let (mut seen, mut wrong) = (0, vec![]);
    for path in all {
        let inside = path.strip_prefix(&src).expect("below it").with_extension("");
        let parts: Vec<_> = inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
        let layer = |name: &str| LAYERS.iter().position(|layer| *layer == name);
        let is_test = parts.iter().any(|part| ["tests", "runs", "fixture"].contains(&part.as_str()));
        let Some(own) = layer(&parts[0]).filter(|_| !is_test) else {
            assert!(
                is_test || ["lib", "main"].contains(&parts[0].as_str()),
                "{parts:?} is in no layer: add its module to LAYERS"
            );
            continue;
        };
        let text = fs::read_to_string(&path).expect("a readable file");
        for used in named(&text).into_iter().filter_map(layer) {
            seen += 1;
            if used > own {
                wrong.push(format!("{} uses {}", inside.display(), LAYERS[used]));
            }
        }
    }
    assert!(seen > 200, "only {seen} uses were found: the search for `crate::` misses some");
    assert!(wrong.is_empty(), "a module uses one above it: {wrong:#?}");
}
