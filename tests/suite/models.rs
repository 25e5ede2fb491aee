//! The models, compared with published frequencies and a published response curve, with energies written by hand and, in their limits, with
//! each other. Every scene of a model must conserve energy.
//!
//! With GEARSIM_PUBLISHED=FILE the run writes a table of the published and the computed numbers to FILE, in Markdown:
//! `cargo xtask published`.

#[path = "models/by_hand/mod.rs"]
mod by_hand;
mod common;
#[path = "models/limits.rs"]
mod limits;
#[path = "models/printed.rs"]
mod printed;
#[path = "models/published.rs"]
mod published;
#[path = "models/response_curve.rs"]
mod response_curve;
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
    trials.push(Trial::test("published::response_of_kahraman_and_singh", || {
        response_curve::rows().map(|_| ()).map_err(Into::into)
    }));
    trials.extend(by_hand::TESTS.iter().map(|(name, test)| Trial::test(format!("by_hand::{name}"), done(*test))));
    trials.extend(printed::TESTS.iter().map(|(name, test)| Trial::test(format!("printed::{name}"), done(*test))));
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
