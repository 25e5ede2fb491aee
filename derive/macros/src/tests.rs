//! Tests of the expansion of a sample file, of the errors that the macro reports, and of the places to which they point.

use proc_macro2::TokenStream;

use crate::equations::check::check;
use crate::equations::expand;
use crate::equations::model::Model;

const FILE: &str = include_str!("../../../gearsim/generated/src/gear_pair.rs");

/// The block of the sample with single spaces instead of line breaks and indents, so that patterns need none.
fn sample() -> String {
    let block = &FILE[FILE.find("equations! {").unwrap()..];
    block.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The tokens between the braces of `equations! { .. }`.
fn tokens(file: &str) -> TokenStream {
    let items = syn::parse_file(file).unwrap().items;
    let tokens = items.into_iter().find_map(|item| match item {
        syn::Item::Macro(item) => Some(item.mac.tokens),
        _ => None,
    });
    tokens.unwrap()
}

/// The errors of the sample with `good` replaced by `bad`: for each, the text to which it points and its message.
fn errors(good: &str, bad: &str) -> Vec<(String, String)> {
    let sample = sample();
    assert!(sample.contains(good), "{good}");
    let result = syn::parse2(tokens(&sample.replacen(good, bad, 1))).and_then(|mut m: Model| check(&mut m));
    let errors = result.expect_err(bad).into_iter();
    errors.map(|e| (e.span().source_text().unwrap(), e.to_string())).collect()
}

/// Asserts that there is exactly one error, at the text `place`, with `message` in its text.
#[track_caller]
fn refused(good: &str, bad: &str, place: &str, message: &str) {
    let errors = errors(good, bad);
    let [(found, text)] = &errors[..] else { panic!("{errors:#?}") };
    assert_eq!(found, place, "{text}");
    assert!(text.contains(message), "{text}");
}

/// A mid value is a number of the scene like a parameter. A deflection is a variable of the code that names it.
#[test]
fn energies_may_contain_mid_values_and_deflections() {
    let sample = sample().replacen("_ => k*touch*over.powi(2);", "_ => k_mid*delta.powi(2);", 1);
    let sample = sample.replacen("deflections {", "deflections { delta = phi - theta;", 1);
    let code = expand(tokens(&sample)).to_string();
    assert!(!code.contains("compile_error"), "{code}");
    for said in ["self . k_mid * delta . powi (2)", "let delta = q [1] - q [0] ;"] {
        assert!(code.contains(said), "{said} is not there: {code}");
    }
}

#[test]
fn gear_pair() {
    let code = syn::parse2(expand(tokens(FILE))).unwrap();
    insta::assert_snapshot!(prettyplease::unparse(&code));
}

#[test]
fn an_unknown_name_is_refused() {
    refused(
        "k*touch*over.powi(2)",
        "k*touch*chi.powi(2)",
        "chi",
        "`chi` is unknown in potential; allowed: C, I1, I2, M1, M2, N1, N2, Pp_load, Pp_motor, T0, Tb_load, Tb_motor, Tp_load, Tp_motor, Ts_load, \
         Ts_motor, alpha, arm, b, c_load, c_motor, cf_load, cf_motor, clip, d_load, d_motor, damp, e, edge, k, k_mid, mu, mu_rise, n0_load, \
         n0_motor, n_load, n_motor, ns_load, ns_motor, over, per_wb_load, per_wb_motor, phi, psi, round_load, round_motor, sb_load, \
         sb_motor, side, slide_dir, tan_a, tau, theta, theta_load, theta_motor, tiny, touch, w0_load, w0_motor, w_mix, zeta",
    );
}

#[test]
fn a_name_that_its_block_may_not_use_is_refused() {
    refused("C*damp*over_dot.powi(2)", "C*damp*k*over_dot.powi(2)", "k", "`k` is unknown in dissipation");
    refused("M1 = (N1", "M1 = (M2", "M2", "`M2` is unknown in constants");
    refused("theta phi { _ => M1/2.0; }", "theta phi { _ => k; }", "k", "`k` is unknown in mobility");
}

#[test]
fn an_unknown_condition_is_refused() {
    refused(
        "{ damping => C*damp",
        "{ dumping => C*damp",
        "dumping",
        "there are: stiffness_step, rigid_kinematics, frozen_phase, transmission_error, backlash, damping, torques, sliding_friction, flank_stiction, \
         governor_motor, dc_motor, induction_motor, traction_motor, fan_motor, governor_load, dc_load, induction_load, traction_load, fan_load, \
         jump_terms",
    );
}

#[test]
fn an_unknown_effect_is_refused() {
    refused("!frozen_phase;", "!frozen;", "frozen", "there is no effect `frozen`");
    refused("excludes(frozen_phase)", "excludes(frozen)", "frozen", "there is no effect `frozen`");
}

#[test]
fn ways_to_switch_that_contradict_each_other_are_refused() {
    refused("stiffness_step => with_jump;", "steps => with_jump;", "steps", "there is no effect `steps`");
    refused("frozen_phase => by_time;", "frozen_phase => late;", "late", "`with_jump` or `without_jump` or `by_time`");
    refused(
        "frozen_phase => by_time;",
        "frozen_phase => without_jump;",
        "frozen_phase",
        "`frozen_phase` makes laws switch as `rigid_kinematics` does",
    );
    let twice = "stiffness_step => by_time;";
    refused("frozen_phase => by_time;", twice, "stiffness_step", "a second way to switch of the effect");
    let never = errors("stiffness_step => with_jump;", "");
    let says = |(_, text): &(String, String)| text.contains("write `EFFECT => with_jump;` too");
    assert!(never.len() == 2 && never.iter().all(says), "{never:#?}");
}

/// If the effects of the sample are renamed, the code differs only in these names.
#[test]
fn renaming_effects_changes_only_names_in_the_code() {
    let renamed = |text: &str| {
        let names = [
            "stiffness_step",
            "rigid_kinematics",
            "frozen_phase",
            "transmission_error",
            "backlash",
            "sliding_friction",
        ];
        names.iter().fold(text.to_string(), |text, name| text.replace(name, &format!("{name}_by_another_name")))
    };
    let code = expand(tokens(&sample())).to_string();
    assert!(code.contains("if met . frozen_phase {"), "{code}");
    assert_eq!(expand(tokens(&renamed(&sample()))).to_string(), renamed(&code));
}

#[test]
fn a_second_coordinate_of_the_same_name_is_refused() {
    refused(
        r#"phi "rad" start static, "#,
        r#"phi "rad" start static, ""; phi "rad" start 1.0, "#,
        "phi",
        "coordinate `phi`: `phi` already belongs to the coordinate `phi`",
    );
}

#[test]
fn a_name_that_belongs_to_a_law_is_refused() {
    let errors = errors("M1 = ", "dk = 1.0; M1 = ");
    assert_eq!(errors[0], ("dk".into(), "constant `dk`: `dk` already belongs to the law `k`".into()));
}

#[test]
fn a_missing_row_of_the_mass_matrix_is_refused() {
    refused("phi phi { _ => I1/N1.powi(2) + I2/N2.powi(2); }", "", "phi", "mass: no row for the coordinate `phi`");
}

#[test]
fn a_missing_row_of_the_inverse_mass_matrix_is_refused() {
    refused("phi phi { _ => M2/2.0; }", "", "phi", "mobility: no row for the coordinate `phi`");
}

#[test]
fn a_missing_row_of_the_force_is_refused() {
    let sample = sample();
    let begin = sample.find("force { theta {").unwrap() + "force { ".len();
    let row = &sample[begin..begin + sample[begin..].find(" phi {").unwrap()];
    refused(row, "", "theta", "force: no row for the coordinate `theta`");
}

#[test]
fn a_second_entry_of_a_symmetric_matrix_is_refused() {
    refused("phi phi { _ => I1", "phi theta { _ => I1; } phi phi { _ => I1", "phi", "a second entry");
    refused("phi phi { _ => M2", "phi theta { _ => M1; } phi phi { _ => M2", "phi", "a second entry");
}

#[test]
fn piecewise_expressions_are_refused() {
    for (bad, place) in [
        ("if phi > 0.0 { k } else { 0.0 }", "if phi > 0.0 { k } else { 0.0 }"),
        ("k*(phi > 0.0)", "phi > 0.0"),
        ("k*phi.abs()", "abs"),
        ("match k { _ => 0.0 }", "match k { _ => 0.0 }"),
    ] {
        refused("k*touch*over.powi(2)", bad, place, "a piecewise function");
    }
}

#[test]
fn integers_and_unknown_functions_are_refused() {
    refused("_ => k*touch*over.powi(2)", "_ => 2*k", "2", "write it with a decimal point");
    refused("_ => k*touch*over.powi(2)", "_ => k.powi(2.0)", "2.0", "`powi` takes an integer");
    refused("_ => k*touch*over.powi(2)", "_ => f(k)", "f(k)", "not in the grammar");
    refused("_ => k*touch*over.powi(2)", "_ => k.sinh()", "sinh", "not a method in the grammar");
}

#[test]
fn unknown_repeated_and_missing_blocks_are_refused() {
    refused("cell {", "cells {", "cells", "there is no block `cells`");
    refused("work {", "text \"a\"; work {", "text", "a second `text`");
    refused("step { _ => dk*touch*over.powi(2); }", "", "k", "jump k: no block `step`");
}

#[test]
fn empty_ranges_and_defaults_out_of_range_are_refused() {
    refused("default 0.0, from 0.0", "default 0.0, open 0.0", "zeta", "default is out of range");
    refused("from 0.0 to inf", "from 1.0 to 0.0", "zeta", "its range is empty");
    refused("from 0.0 to inf", "0.0 to inf", "0.0", "expected `open` or `from`");
    refused("from 0.0 to inf", "from 0.0 to inf above q", "q", "there is no parameter `q`");
}

/// The sample with `count` more effects, each with a term of the force.
fn with_effects(count: usize) -> String {
    let effects: String = (0..count).map(|i| format!("e{i} \"\"; ")).collect();
    let terms: String = (0..count).map(|i| format!("e{i} => {i}.0*over.powi(3); ")).collect();
    let sample = sample().replacen("effects {", &format!("effects {{ {effects}"), 1);
    sample.replacen("force { theta {", &format!("force {{ theta {{ {terms}"), 1)
}

/// A model may have any number of effects.
#[test]
fn the_number_of_effects_has_no_limit() {
    let code = expand(tokens(&with_effects(200))).to_string();
    assert!(!code.contains("compile_error"), "{code}");
    assert_eq!(code.matches("if met . e199 {").count(), 1, "{code}");
}

/// Code grows with the number of effects, not with the number of their combinations: each effect adds one block with its own term.
#[test]
fn each_effect_adds_one_block() {
    let size = |count| expand(tokens(&with_effects(count))).to_string().len();
    let code = expand(tokens(&with_effects(24))).to_string();
    assert_eq!(code.matches("if met . e17 {").count(), 1, "{code}");
    let (few, many) = (size(12) - size(0), size(36) - size(24));
    assert!(many.abs_diff(few) < few / 10, "12 effects add {few} characters to 0 effects, {many} to 24");
}

/// The functions that are called at every step have variants by kinds of values, not by effects: their number does not grow with the effects.
#[test]
fn variants_do_not_multiply_with_effects() {
    let variants = |sample: &str| expand(tokens(sample)).to_string().matches("Self :: force_in :: <").count();
    assert_eq!([sample(), with_effects(24)].map(|sample| variants(&sample)), [5, 5]);
}

/// A variant has no test of effects whose values it does not have.
#[test]
fn variants_are_chosen_by_the_values_of_effects() {
    let code = expand(tokens(&sample())).to_string();
    for said in [
        "if ! (met . transmission_error) && ! (met . backlash || met . flank_stiction) \
         && ! (met . sliding_friction || met . governor_motor || met . dc_motor || met . induction_motor || met . traction_motor \
         || met . fan_motor || met . governor_load || met . dc_load || met . induction_load || met . traction_load || met . fan_load) { \
         (Self :: force_in :: < false , false , false >",
        "if met . transmission_error && ERRORS { let e = k [1] ; over = over - e ; }",
        "let arm = if met . sliding_friction && OTHERS { k [3] } else { 0f64 . into () }",
        "if met . governor_motor && OTHERS {",
        "if met . traction_motor && OTHERS {",
    ] {
        assert!(code.contains(said), "{said} is not there: {code}");
    }
}

#[test]
fn all_errors_are_reported_at_once() {
    let all = errors("I1*(phi_dot", "nought.abs()*2*I1*(nix").into_iter().map(|(place, _)| place);
    assert_eq!(all.collect::<Vec<_>>(), ["nought", "abs", "2", "nix"]);
}

/// The macro accepts the grammar documented at the head of the crate.
#[test]
fn the_documented_grammar_is_accepted() {
    let text: String = include_str!("lib.rs")
        .lines()
        .skip_while(|line| *line != "//! ```text")
        .skip(1)
        .take_while(|line| *line != "//! ```")
        .map(|line| line.trim_start_matches("//!").to_string() + "\n")
        .filter(|line| !line.contains("{ .. }"))
        .collect();
    let mut model = syn::parse_str::<Model>(&text).unwrap();
    check(&mut model).unwrap();
    syn::parse2::<syn::File>(crate::equations::emit::emit(model)).unwrap();
}

/// Laws must have the same indices in scenes with and without their effects.
#[test]
fn laws_with_an_effect_must_come_last() {
    let swapped = r#"e "rad" phase theta period 1.0 with transmission_error, "error"; k "N*m""#;
    let errors = errors(r#"laws { k "N*m""#, &format!("laws {{ {swapped}"));
    assert!(
        errors.iter().any(|(place, text)| place == "k" && text.contains("laws with an effect must come last")),
        "{errors:?}"
    );
    refused("rolling with transmission_error", "rolling with errors", "errors", "there is no effect `errors`");
    refused(
        "rolling with transmission_error",
        "rolling unless(support) with transmission_error",
        "support",
        "there is no effect `support`",
    );
    let apart = r#"f "rad" phase theta period 1.0 with transmission_error, "error"; arm "rad""#;
    let errors = self::errors(r#"arm "rad""#, apart);
    assert!(
        errors.iter().any(|(place, text)| place == "f" && text.contains("those of one effect together")),
        "{errors:?}"
    );
    refused("as side", "as end", "end", "expected `side` or `arm`");
    // A transmission error has no mid value.
    refused("k_mid/M2", "e_mid/M2", "e_mid", "`e_mid` is unknown in constants");
}

/// Without its effect a law has no part in deflections, is zero elsewhere, and never switches.
#[test]
fn laws_are_absent_without_their_effect() {
    let code = expand(tokens(&sample())).to_string();
    for said in [
        "let mut over = q [1] ; if met . backlash { let edge = k [5] ; over = over - edge ; } \
         if met . transmission_error { let e = k [1] ; over = over - e ; }",
        "let arm = if met . sliding_friction { k [3] } else { 0f64 . into () }",
        "if ! met . stiffness_step || law == 1 && ! met . transmission_error || law == 2 && ! met . sliding_friction",
    ] {
        assert!(code.contains(said), "{said} is not there: {code}");
    }
}

/// How a parameter may vary in time by the expansion of the sample with `good` replaced by `bad`: the name of a variant of `model::Varies`.
fn variation(parameter: &str, good: &str, bad: &str) -> String {
    let sample = sample();
    assert!(sample.contains(good), "{good}");
    let code = expand(tokens(&sample.replace(good, bad))).to_string();
    let (_, after) = code.split_once(&format!("name : \"{parameter}\"")).expect("the parameter is described");
    let (_, after) = after.split_once("varies : model :: Varies :: ").expect("it says how it may vary");
    after.chars().take_while(|c| c.is_alphabetic()).collect()
}

/// Forces must be linear in a parameter that varies. If guards, losses, outputs or state-dependent forces depend on it too, they must be
/// linear in it. The parameter must then not occur in a constant torque, whose work is computed from the displacement.
#[test]
fn a_parameter_varies_if_forces_are_linear_in_it() {
    let as_it_is = |parameter| variation(parameter, "", "");
    for (how, parameters) in [
        ("AsLoad", &["T0", "n_motor"][..]),
        ("WithState", &["d_motor", "Tb_motor", "cf_load"]),
        ("WithGuards", &["mu"]),
        ("Never", &["I1", "b", "zeta", "mu_rise", "c_motor", "Tp_motor", "sb_motor", "w0_load"]),
    ] {
        parameters.iter().for_each(|parameter| assert_eq!(as_it_is(parameter), how, "{parameter}"));
    }
    for (good, bad) in [
        ("one { _ => b/2.0; }", "one { _ => b/2.0 + T0; }"),
        ("loss { over { _ => 2.0*k*clip*touch; } }", "loss { over { _ => 2.0*k*clip*touch*T0; } }"),
        ("_ => 2.0*phi/N1;", "_ => 2.0*phi/N1*T0;"),
    ] {
        assert_eq!(variation("T0", good, bad), "Never", "{bad}");
    }
    let fan = "fan_load => -cf_load*theta_load_dot*";
    assert_eq!(variation("cf_load", fan, "fan_load => -cf_load*cf_load*theta_load_dot*"), "Never");
    assert_eq!(variation("T0", fan, "fan_load => -cf_load*T0*theta_load_dot*"), "Never");
    // Each alone is linear, both together are not.
    let product = "fan_load => -cf_load*d_motor*theta_load_dot*";
    assert_eq!(["cf_load", "d_motor"].map(|parameter| variation(parameter, fan, product)), ["Never"; 2]);
}
