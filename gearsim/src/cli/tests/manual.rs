//! The manual, gearsim/manual: each command, effect and model has its chapter, and the table of contents lists it.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::cli::program;
use crate::known::MODELS;
use crate::scene::Effects;

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("manual/src")
}

/// The names of the chapters in a folder.
fn chapters(folder: &str) -> BTreeSet<String> {
    let files = fs::read_dir(source().join(folder)).unwrap().map(|file| file.unwrap().path());
    files.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect()
}

#[test]
fn each_command_has_a_chapter() {
    let commands: BTreeSet<_> = program().get_subcommands().map(|command| command.get_name().to_string()).collect();
    assert_eq!(chapters("commands"), commands, "gearsim/manual/src/commands has one chapter for each command");
}

#[test]
fn each_effect_has_a_chapter() {
    let names = MODELS.iter().flat_map(|entry| Effects::all(entry.model).names(entry.model));
    let effects: BTreeSet<_> = names.map(String::from).collect();
    assert_eq!(chapters("effects"), effects, "gearsim/manual/src/effects has one chapter for each effect");
}

/// Models that differ in the number of their parts have one chapter: `chain` of `chain_2` and `chain_5`.
#[test]
fn each_kind_of_model_has_a_chapter() {
    let kind = |name: &str| name.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_').to_string();
    let models: BTreeSet<_> = MODELS.iter().map(|entry| kind(entry.model.name)).collect();
    assert_eq!(chapters("models"), models, "gearsim/manual/src/models has one chapter for each kind of model");
}

#[test]
fn the_table_of_contents_lists_each_chapter() {
    let contents = fs::read_to_string(source().join("SUMMARY.md")).unwrap();
    for folder in ["commands", "effects", "models"] {
        for name in chapters(folder) {
            let entry = format!("[{name}]({folder}/{name}.md)");
            assert!(contents.contains(&entry), "SUMMARY.md lacks {entry}");
        }
    }
}
