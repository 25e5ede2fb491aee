//! The derivation: against the paper's equations, against the committed files, and against authors' slips.
//!
//! Everything here calls Symbolica, which without a key is for one thread of one process on a machine: a harness of
//! its own, whose tests run one after another on the main thread. The child processes that derive afresh are run to
//! their ends before this one first calls it.

mod paper;

#[path = "derivation/blocks.rs"]
mod blocks;
#[path = "derivation/files.rs"]
mod files;
#[path = "derivation/gear_pair.rs"]
mod gear_pair;
#[path = "derivation/models.rs"]
mod models;
#[path = "derivation/newcomer.rs"]
mod newcomer;
#[path = "derivation/odd.rs"]
mod odd;
#[path = "derivation/slips.rs"]
mod slips;

use std::process::ExitCode;

use libtest_mimic::{Arguments, Trial};

fn main() -> ExitCode {
    if files::in_child() {
        return ExitCode::SUCCESS;
    }
    let arguments = Arguments { test_threads: Some(1), ..Arguments::from_args() };
    let afresh = if arguments.list { vec![] } else { files::derive_in_children() };

    let mut trials = vec![Trial::test("deriving_in_a_fresh_process_gives_the_committed_file", move || {
        files::fresh_processes_agree(&afresh);
        Ok(())
    })];
    let tests: [(&str, fn()); _] = [
        ("committed_files_are_what_the_energies_say", files::committed_files_are_current),
        ("derived_equations_are_the_papers", gear_pair::equations_are_the_papers),
        ("derived_jump_rule_is_the_papers", gear_pair::jump_rule_is_the_papers),
        ("a_wrong_equation_is_told_from_the_derived_one", gear_pair::wrong_equations_are_told),
        ("derived_equations_read_as_before", gear_pair::equations_read_as_before),
        ("models_read_as_before", models::models_read_as_before),
        ("every_inertia_is_proved_definite", models::every_inertia_is_proved_definite),
        ("deflections_are_what_they_stand_for", models::deflections_are_what_they_stand_for),
        ("mid_values_may_stand_in_energies", models::mid_values_may_stand_in_energies),
        ("a_newcomers_file_is_what_the_energies_say", newcomer::files_are_current),
        ("nonlinear_cells_are_named", newcomer::nonlinear_cells_are_named),
        ("torques_by_speed_are_named_with_their_effects", newcomer::torques_by_speed_are_named_with_their_effects),
        ("three_coordinates_are_proved", newcomer::three_coordinates_are_proved),
        ("mobility_is_one_fraction_an_entry", blocks::mobility_is_one_fraction_an_entry),
        ("mobility_is_left_out_where_it_is_not_known", blocks::mobility_is_left_out_where_it_is_not_known),
        ("offsets_do_no_work", blocks::offsets_do_no_work),
        ("nothing_is_said_of_no_constants", blocks::nothing_is_said_of_no_constants),
        ("every_slip_is_refused_by_name", slips::every_slip_is_refused_by_name),
        ("no_input_makes_the_derivation_panic", odd::no_input_panics),
    ];
    trials.extend(tests.map(|(name, test)| {
        Trial::test(name, move || {
            test();
            Ok(())
        })
    }));
    libtest_mimic::run(&arguments, trials).exit_code()
}
