//! The derivation: compared with the paper's equations and with the committed files, and given models with mistakes.
//!
//! Everything here calls Symbolica. Without a licence key Symbolica runs in one thread of one process per machine. So this test
//! has its own harness, which runs the tests one after another on the main thread. The child processes that derive a model
//! afresh end before this process first calls Symbolica.

mod paper;

#[path = "derivation/blocks.rs"]
mod blocks;
#[path = "derivation/files.rs"]
mod files;
#[path = "derivation/gear_pair.rs"]
mod gear_pair;
#[path = "derivation/massless.rs"]
mod massless;
#[path = "derivation/models.rs"]
mod models;
#[path = "derivation/newcomer.rs"]
mod newcomer;
#[path = "derivation/odd.rs"]
mod odd;
#[path = "derivation/proofs.rs"]
mod proofs;
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
        ("committed_files_match_a_new_derivation", files::committed_files_are_current),
        ("derived_equations_equal_those_of_the_paper", gear_pair::equations_equal_those_of_the_paper),
        ("derived_jump_rule_equals_that_of_the_paper", gear_pair::jump_rule_equals_that_of_the_paper),
        ("a_wrong_equation_differs_from_the_derived_one", gear_pair::wrong_equations_are_detected),
        ("equations_of_the_gear_pair_match_the_snapshot", gear_pair::equations_match_the_snapshot),
        ("equations_of_models_match_the_snapshots", models::equations_match_the_snapshots),
        ("every_mass_matrix_is_proved_positive_definite", models::every_mass_matrix_is_proved_positive_definite),
        ("a_named_deflection_gives_the_same_equations", models::a_named_deflection_gives_the_same_equations),
        ("energies_may_contain_mid_values", models::energies_may_contain_mid_values),
        ("files_of_the_newcomer_models_match_a_new_derivation", newcomer::files_are_current),
        ("files_of_a_new_crate_match_a_new_derivation", newcomer::files_of_a_new_crate_are_current),
        ("nonlinear_terms_are_reported", newcomer::nonlinear_terms_are_reported),
        ("torques_that_depend_on_speeds_are_reported", newcomer::torques_that_depend_on_speeds_are_reported),
        ("a_model_with_three_coordinates_is_proved", newcomer::a_model_with_three_coordinates_is_proved),
        ("springs_in_series_are_one_spring", massless::springs_in_series_are_one_spring),
        ("springs_that_meet_are_a_star", massless::springs_that_meet_are_a_star),
        ("a_node_of_a_shaft_is_an_output", massless::a_node_of_a_shaft_is_an_output),
        ("each_mobility_entry_is_one_fraction", blocks::each_mobility_entry_is_one_fraction),
        ("mobility_is_omitted_where_no_closed_form_exists", blocks::mobility_is_omitted_where_no_closed_form_exists),
        ("constant_offsets_do_no_work", blocks::constant_offsets_do_no_work),
        ("a_model_without_constants_has_no_constants_block", blocks::a_model_without_constants_has_no_constants_block),
        ("a_wrong_formula_is_refused_by_its_proof", proofs::a_wrong_formula_is_refused),
        ("a_wrong_step_of_a_later_law_is_refused", proofs::a_wrong_step_of_a_later_law_is_refused),
        ("a_model_that_feeds_energy_is_refused", proofs::a_model_that_feeds_energy_is_refused),
        ("dampers_of_other_forms_are_proved", proofs::other_dampers_are_proved),
        ("a_torque_through_a_deflection_is_in_the_balance", proofs::a_torque_through_a_deflection_is_in_the_balance),
        ("every_mistake_is_refused_with_the_name_of_the_culprit", slips::every_mistake_is_refused),
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
