//! The hard cases of the engine: the promises that it makes, each proved by a number that must stay within a tolerance.
//!
//! Every case runs as a test. With GEARSIM_HARD_CASES=FILE the run writes its numbers as a table, in Markdown:
//! `cargo xtask hard-cases`. GEARSIM_CELLS, GEARSIM_SCENES, GEARSIM_EVENTS and GEARSIM_SEED set how much random work is
//! done, and on what.
//!
//! A group of rows of the catalogue is a file; a case is an entry of its `CASES`.

mod case;
#[path = "../common/mod.rs"]
mod common;
mod linear;
mod models;
mod noise;
mod pair;
mod rattle;
mod table;

mod absent;
mod backlash;
mod cells;
mod claims;
mod contact;
mod coupled;
mod damping;
mod digits;
mod displaced;
mod edges;
mod ends;
mod extremes;
mod graze;
mod jump;
mod limits;
mod long;
mod mirror;
mod ramps;
mod ratios;
mod refusals;
mod resonance;
mod scenes;
mod splits;
mod stiff;
mod together;
mod trapped;

use std::process::ExitCode;

use case::{Case, check};
// Where the expansions of the models find the engine, as they do within gearsim.
use gearsim::{engine, model};
use libtest_mimic::{Arguments, Trial};
use table::Table;

/// The catalogue, by rows.
const GROUPS: &[&[Case]] = &[
    graze::CASES,
    jump::CASES,
    trapped::CASES,
    contact::CASES,
    displaced::CASES,
    ends::CASES,
    together::CASES,
    splits::CASES,
    ratios::CASES,
    damping::CASES,
    long::CASES,
    digits::CASES,
    mirror::CASES,
    backlash::CASES,
    edges::CASES,
    resonance::CASES,
    stiff::CASES,
    coupled::CASES,
    limits::CASES,
    ramps::CASES,
    refusals::CASES,
    extremes::CASES,
    absent::CASES,
    cells::CASES,
    scenes::CASES,
    claims::CASES,
];

/// Promises not kept yet, and why. They are in the table, as failing; tests pass them over by name.
const OPEN: [(&str, &str); 0] = [];

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let cases: Vec<&'static Case> = GROUPS.iter().flat_map(|group| group.iter()).collect();
    let table = Table::new(&cases);
    let trials = cases.iter().enumerate().map(|(i, case)| {
        let (case, table) = (*case, table.clone());
        let open = OPEN.iter().any(|(name, _)| *name == case.name);
        let trial = Trial::test(format!("{}::{}", case.row, case.name.replace(' ', "_")), move || {
            let (measured, verdict) = check(case);
            table.enter(i, measured);
            match verdict {
                Err(message) if !open => Err(message.into()),
                _ => Ok(()),
            }
        });
        trial.with_ignored_flag(open && !table::asked_for())
    });
    let conclusion = libtest_mimic::run(&arguments, trials.collect());
    if !arguments.list
        && let Err(message) = table.write()
    {
        eprintln!("{message}");
        return ExitCode::FAILURE;
    }
    conclusion.exit_code()
}
