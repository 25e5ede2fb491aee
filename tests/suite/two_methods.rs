//! Every scene is solved by two methods that share only the equations. Static starts are checked by a balance of forces.
//!
//! Scenes with exact cells are compared with dop853, scenes with nonlinear cells with radau, each at a tight tolerance. A motion
//! magnifies the error of a method as it magnifies a rounding error. The run reports this factor (`digits`), and the allowed difference
//! contains it. A scene that loses nearly all digits is compared up to an earlier time.

mod common;
#[path = "two_methods/compare.rs"]
mod compare;
#[path = "two_methods/random.rs"]
mod random;
#[path = "two_methods/statics.rs"]
mod statics;

use std::process::ExitCode;

use libtest_mimic::{Arguments, Trial};

/// The names of all scenes in `models/scenes`, with their folders.
fn names() -> Vec<String> {
    let scenes = common::root().join("models/scenes");
    let mut names = vec![];
    for folder in ["", "drives", "oh2005"] {
        let files = std::fs::read_dir(scenes.join(folder)).expect("the folder of scenes is there");
        let files = files.map(|entry| entry.expect("a readable folder").path());
        let toml = files.filter(|path| path.extension().is_some_and(|e| e == "toml"));
        names.extend(toml.map(|path| {
            let stem = path.file_stem().expect("a file").to_string_lossy().into_owned();
            if folder.is_empty() { stem } else { format!("{folder}/{stem}") }
        }));
    }
    names.sort();
    names
}

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let mut trials = vec![];
    for name in names() {
        let (of_scene, of_random, of_statics) = (name.clone(), name.clone(), name.clone());
        trials.push(Trial::test(format!("{name}_agrees_by_two_methods"), move || {
            compare::agree(&common::scene(&of_scene, &[])).map(|text| println!("{text}")).map_err(Into::into)
        }));
        trials.push(Trial::test(format!("random_variants_of_{name}_agree_by_two_methods"), move || {
            random::agree(&of_random).map(|text| println!("{text}")).map_err(Into::into)
        }));
        trials.push(Trial::test(format!("static_starts_of_{name}_balance_the_forces"), move || {
            statics::balance(&of_statics).map(|text| println!("{text}")).map_err(Into::into)
        }));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}
