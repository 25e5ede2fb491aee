//! Data flows one way: what a module of gearsim may use lies below it.

use std::fs;
use std::path::{Path, PathBuf};

/// The modules, from the bottom up. A module uses those before it; tests may use any.
const LAYERS: [&str; 15] = [
    "model",
    "profile",
    "gear",
    "trajectory",
    "scene",
    "engine",
    "methods",
    "ensemble",
    "run",
    "generated",
    "analysis",
    "output",
    "sweep",
    "plot",
    "cli",
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

/// The modules named in the code of a file, without its comments and its tests.
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
            assert!(is_test || ["lib", "main"].contains(&parts[0].as_str()), "{parts:?} has no place among the layers");
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
    assert!(seen > 200, "{seen} uses were found");
    assert!(wrong.is_empty(), "{wrong:#?}");
}
