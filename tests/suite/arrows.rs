//! The modules of gearsim form layers: a module may use only the modules below it. The core knows no effect by name.

use std::fs;
use std::path::{Path, PathBuf};

/// The modules, from the bottom up. A module may use those before it. Unit tests may use any module.
const LAYERS: [&str; 20] = [
    "tolerance",
    "train",
    "profile",
    "gear",
    "trajectory",
    "scene",
    "engine",
    "methods",
    "ensemble",
    "run",
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
                is_test || ["lib", "main", "examples"].contains(&parts[0].as_str()),
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

/// The core: the code that derives equations, expands them, and runs them.
const CORE: [&str; 7] = [
    "derive/src",
    "derive/macros/src",
    "gearsim/equations/src",
    "gearsim/src/engine",
    "gearsim/src/methods",
    "gearsim/src/run",
    "gearsim/src/ensemble",
];

/// Effects whose names are also words of the core: the matrix C of a cell and its block, and the terms that a model adds by `m.torque`.
const WORDS: [&str; 2] = ["damping", "torques"];

/// The code of a file without comments and unit tests. A file that has only unit tests has no code.
fn code(path: &Path, root: &Path) -> String {
    let inside = path.strip_prefix(root).expect("below it").with_extension("");
    let is_test = inside.iter().any(|part| ["tests", "runs", "fixture"].iter().any(|of| part == *of));
    let text = if is_test { String::new() } else { fs::read_to_string(path).expect("a readable file") };
    let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or("").lines();
    code.map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// Only the model that declares an effect, and the file derived from it, state what the effect does.
#[test]
fn the_core_knows_no_effect_by_name() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let effects = gearsim::models().iter().flat_map(|entry| entry.model.effects);
    let mut names: Vec<&str> = effects.flat_map(|effect| [Some(effect.name), effect.of]).flatten().collect();
    names.sort();
    names.dedup();
    names.retain(|name| !WORDS.contains(name));
    for known in ["stiffness_step", "backlash", "sliding_friction_12", "overrunning_clutch"] {
        assert!(names.contains(&known), "{known} is not an effect of a model: {names:?}");
    }
    let mut all = vec![];
    CORE.iter().for_each(|folder| files(&root.join(folder), &mut all));
    all.push(root.join("gearsim/src/run.rs"));
    let (mut lines, mut wrong) = (0, vec![]);
    for path in all {
        for line in code(&path, &root).lines() {
            lines += 1;
            let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
            if let Some(name) = words.find(|word| names.contains(word)) {
                wrong.push(format!("{}: `{name}` in {}", path.display(), line.trim()));
            }
        }
    }
    assert!(lines > 15_000, "only {lines} lines of code were read");
    assert!(wrong.is_empty(), "the core names an effect: {wrong:#?}");
}
