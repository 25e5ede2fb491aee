//! The hard cases of the engine: each is a promise, tested by a measured number that must stay within a tolerance.
//!
//! Every case runs as a test. With GEARSIM_HARD_CASES=FILE the run writes its numbers to FILE as a table, in Markdown:
//! `cargo xtask hard-cases`. The environment variables GEARSIM_CELLS, GEARSIM_SCENES and GEARSIM_EVENTS set the amount of random work,
//! GEARSIM_SEED selects its random numbers.
//!
//! Each file holds a group of cases, and each case is an entry of the file's `CASES`. Its `row` numbers the kind of difficulty.

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
mod damage;
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
mod stops;
mod switches;
mod together;
mod touching;
mod trapped;

use std::process::ExitCode;

use case::{Case, check};
use libtest_mimic::{Arguments, Trial};
use table::Table;

/// All cases, in the order of the table.
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
    touching::CASES,
    resonance::CASES,
    stiff::CASES,
    switches::CASES,
    stops::CASES,
    damage::CASES,
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

/// Names of cases that still fail, and why. The table shows them as failing; the tests ignore them.
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
