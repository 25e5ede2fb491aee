//! The derived files are those that the energies give. `cargo test` skips this test, `cargo test --workspace` runs it.

use std::path::Path;

use gearsim_derive::{Model, derive};

#[test]
fn the_derived_files_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/generated");
    for (name, describe) in energies::MODELS {
        let model = Model::new(name, describe);
        let derivation = derive(&model).unwrap_or_else(|slip| panic!("{slip}"));
        for (file, derived) in derivation.files(energies::HOME) {
            let committed = std::fs::read_to_string(folder.join(&file)).unwrap_or_default();
            assert!(derived == committed, "{file} is not current: run `cargo derive {name}`");
        }
    }
}
