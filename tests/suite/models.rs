//! The models: against published numbers, against energies written by hand, against each other in their limits, and
//! their scenes against the conservation of energy.
//!
//! With GEARSIM_PUBLISHED=FILE the run writes the published numbers beside the computed ones as a table, in Markdown:
//! `cargo xtask published`.

#[path = "models/by_hand/mod.rs"]
mod by_hand;
mod common;
#[path = "models/limits.rs"]
mod limits;
#[path = "models/published.rs"]
mod published;
#[path = "models/scenes.rs"]
mod scenes;
#[path = "models/table.rs"]
mod table;
#[path = "models/train.rs"]
mod train;

use std::process::ExitCode;

use libtest_mimic::{Arguments, Trial};

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let done = |test: fn()| {
        move || {
            test();
            Ok(())
        }
    };
    let mut trials: Vec<Trial> = published::CASES
        .iter()
        .map(|case| {
            Trial::test(format!("published::{}", case.what.replace(' ', "_")), move || {
                published::check(case).map(|_| ()).map_err(Into::into)
            })
        })
        .collect();
    trials.extend(by_hand::TESTS.iter().map(|(name, test)| Trial::test(format!("by_hand::{name}"), done(*test))));
    trials.extend(limits::TESTS.iter().map(|(name, test)| Trial::test(format!("limits::{name}"), done(*test))));
    trials.extend(scenes::names().into_iter().map(|name| {
        Trial::test(format!("scenes::{name}_keeps_its_energy"), move || {
            scenes::keeps_its_energy(&name);
            Ok(())
        })
    }));
    let conclusion = libtest_mimic::run(&arguments, trials);
    if !arguments.list
        && let Err(message) = table::write()
    {
        eprintln!("{message}");
        return ExitCode::FAILURE;
    }
    conclusion.exit_code()
}
