//! The expansion of the sample, and what the macro refuses, with the place to which each error points.

use proc_macro2::TokenStream;

use crate::check::check;
use crate::expand::expand;
use crate::model::Model;

const FILE: &str = include_str!("../../../gearsim/src/generated/gear_pair.rs");

/// The block of the sample, its line breaks and indents made single spaces: patterns need not know them.
fn sample() -> String {
    let block = &FILE[FILE.find("equations! {").unwrap()..];
    block.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What stands between the braces of `equations! { .. }`.
fn tokens(file: &str) -> TokenStream {
    let items = syn::parse_file(file).unwrap().items;
    let tokens = items.into_iter().find_map(|item| match item {
        syn::Item::Macro(item) => Some(item.mac.tokens),
        _ => None,
    });
    tokens.unwrap()
}

/// The errors of the sample with `good` replaced by `bad`: the text to which each points, and its message.
fn errors(good: &str, bad: &str) -> Vec<(String, String)> {
    let sample = sample();
    assert!(sample.contains(good), "{good}");
    let result = syn::parse2(tokens(&sample.replacen(good, bad, 1))).and_then(|mut m: Model| check(&mut m));
    let errors = result.expect_err(bad).into_iter();
    errors.map(|e| (e.span().source_text().unwrap(), e.to_string())).collect()
}

/// One error and no other, at `place`, saying `message`.
#[track_caller]
fn refused(good: &str, bad: &str, place: &str, message: &str) {
    let errors = errors(good, bad);
    let [(found, text)] = &errors[..] else { panic!("{errors:#?}") };
    assert_eq!(found, place, "{text}");
    assert!(text.contains(message), "{text}");
}

/// A mid value is a number like a parameter, wherever numbers may stand; large sums of deflections are shared.
#[test]
fn mid_values_and_deflections() {
    let sample = sample().replacen("_ => k*touch*over.powi(2);", "_ => k_mid*delta.powi(2);", 1);
    let sample = sample.replacen("deflections {", "deflections { delta = phi - theta;", 1);
    let code = expand(tokens(&sample)).to_string();
    assert!(!code.contains("compile_error"), "{code}");
    for said in ["self . k_mid * d [0] . powi (2)", "let d = self . deflections (q , e , edge)", "[q [1] - q [0] ,"] {
        assert!(code.contains(said), "{said} is not there: {code}");
    }
}

#[test]
fn gear_pair() {
    let code = syn::parse2(expand(tokens(FILE))).unwrap();
    insta::assert_snapshot!(prettyplease::unparse(&code));
}

#[test]
fn unknown_identifier() {
    refused(
        "k*touch*over.powi(2)",
        "k*touch*chi.powi(2)",
        "chi",
        "`chi` is unknown in potential; allowed: C, I1, I2, M1, M2, N1, N2, T0, alpha, arm, b, clip, damp, e, edge, k, k_mid, mu, \
         over, phi, psi, side, tan_a, tau, theta, tiny, touch, w_mix, zeta",
    );
}

#[test]
fn identifier_that_the_block_is_not_given() {
    refused("C*damp*over_dot.powi(2)", "C*damp*phi.powi(2)", "phi", "`phi` is unknown in dissipation");
    refused("M1 = (N1", "M1 = (M2", "M2", "`M2` is unknown in constants");
    refused("theta phi { _ => M1/2.0; }", "theta phi { _ => k; }", "k", "`k` is unknown in mobility");
}

#[test]
fn unknown_condition() {
    refused(
        "{ damping => C*damp",
        "{ dumping => C*damp",
        "dumping",
        "there are: stiffness_step, rigid_kinematics, frozen_phase, transmission_error, backlash, damping, torques, sliding_friction, jump_terms",
    );
}

#[test]
fn unknown_effect() {
    refused("!frozen_phase;", "!frozen;", "frozen", "no effect is called `frozen`");
    refused("excludes(frozen_phase)", "excludes(frozen)", "frozen", "no effect is called `frozen`");
}

#[test]
fn duplicate_coordinate() {
    refused(
        r#"phi "rad" start static, "#,
        r#"phi "rad" start static, ""; phi "rad" start 1.0, "#,
        "phi",
        "coordinate `phi`: `phi` already belongs to the coordinate `phi`",
    );
}

#[test]
fn name_that_a_law_takes() {
    let errors = errors("M1 = ", "dk = 1.0; M1 = ");
    assert_eq!(errors[0], ("dk".into(), "constant `dk`: `dk` already belongs to the law `k`".into()));
}

#[test]
fn missing_mass_row() {
    refused("phi phi { _ => I1/N1.powi(2) + I2/N2.powi(2); }", "", "phi", "mass: no row for the coordinate `phi`");
}

#[test]
fn missing_mobility_row() {
    refused("phi phi { _ => M2/2.0; }", "", "phi", "mobility: no row for the coordinate `phi`");
}

#[test]
fn missing_force_row() {
    let sample = sample();
    let begin = sample.find("force { theta {").unwrap() + "force { ".len();
    let row = &sample[begin..begin + sample[begin..].find(" phi {").unwrap()];
    refused(row, "", "theta", "force: no row for the coordinate `theta`");
}

#[test]
fn second_entry_of_a_symmetric_matrix() {
    refused("phi phi { _ => I1", "phi theta { _ => I1; } phi phi { _ => I1", "phi", "a second entry");
    refused("phi phi { _ => M2", "phi theta { _ => M1; } phi phi { _ => M2", "phi", "a second entry");
}

#[test]
fn piecewise_expressions() {
    for (bad, place) in [
        ("if phi > 0.0 { k } else { 0.0 }", "if phi > 0.0 { k } else { 0.0 }"),
        ("k*(phi > 0.0)", "phi > 0.0"),
        ("k*phi.abs()", "abs"),
        ("match k { _ => 0.0 }", "match k { _ => 0.0 }"),
    ] {
        refused("k*touch*over.powi(2)", bad, place, "a piecewise thing");
    }
}

#[test]
fn integers_and_calls() {
    refused("_ => k*touch*over.powi(2)", "_ => 2*k", "2", "write it with a point");
    refused("_ => k*touch*over.powi(2)", "_ => k.powi(2.0)", "2.0", "`powi` takes an integer");
    refused("_ => k*touch*over.powi(2)", "_ => f(k)", "f(k)", "not of the grammar");
    refused("_ => k*touch*over.powi(2)", "_ => k.sinh()", "sinh", "not a method of the grammar");
}

#[test]
fn blocks() {
    refused("cell {", "cells {", "cells", "no block is called `cells`");
    refused("work {", "text {} work {", "text", "a second `text`");
    refused("step { _ => dk*touch*over.powi(2); }", "", "k", "jump k: no `step`");
}

#[test]
fn ranges() {
    refused("default 0.0, from 0.0", "default 0.0, open 0.0", "zeta", "default is out of range");
    refused("from 0.0 to inf", "from 1.0 to 0.0", "zeta", "its range is empty");
    refused("from 0.0 to inf", "0.0 to inf", "0.0", "expected `open` or `from`");
}

#[test]
fn too_many_effects() {
    let many: String = (0..11).map(|i| format!("e{i} \"\"; ")).collect();
    refused("effects {", &format!("effects {{ {many}"), "gear_pair", "in more than 1024 ways");
}

#[test]
fn all_errors_at_once() {
    let all = errors("I1*(phi_dot", "nought.abs()*2*I1*(nix").into_iter().map(|(place, _)| place);
    assert_eq!(all.collect::<Vec<_>>(), ["nought", "abs", "2", "nix"]);
}

/// The grammar at the head of the crate is one that the macro takes.
#[test]
fn documented_grammar() {
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
    syn::parse2::<syn::File>(crate::emit::emit(&model)).unwrap();
}

/// Scenes have the laws up to those of an effect, by the same numbers.
#[test]
fn laws_with_an_effect_come_last() {
    let swapped = r#"e "rad" phase theta period 1.0 with transmission_error, "error"; k "N*m""#;
    let errors = errors(r#"laws { k "N*m""#, &format!("laws {{ {swapped}"));
    assert!(
        errors.iter().any(|(place, text)| place == "k" && text.contains("laws with an effect come last")),
        "{errors:?}"
    );
    refused("rolling with transmission_error", "rolling with errors", "errors", "no effect is called `errors`");
    let apart = r#"f "rad" phase theta period 1.0 with transmission_error, "error"; arm "rad""#;
    let errors = self::errors(r#"arm "rad""#, apart);
    assert!(
        errors.iter().any(|(place, text)| place == "f" && text.contains("those of one side by side")),
        "{errors:?}"
    );
    refused("as side", "as end", "end", "expected `side` or `arm`");
    // An error has no mid value.
    refused("k_mid/M2", "e_mid/M2", "e_mid", "`e_mid` is unknown in constants");
}

/// A law of an effect is zero without it, as the code is compiled, and never switches.
#[test]
fn laws_with_an_effect_are_gated() {
    let code = expand(tokens(&sample())).to_string();
    for said in [
        "let e = if Self :: TRANSMISSION_ERROR { k [1] } else { 0f64 . into () }",
        "let arm = if Self :: SLIDING_FRICTION { k [3] } else { 0f64 . into () }",
        "if ! STIFFNESS_STEP || law == 1 && ! TRANSMISSION_ERROR || law == 2 && ! SLIDING_FRICTION",
        // Friction moves no deflection.
        "let d = self . deflections (q , e , edge)",
    ] {
        assert!(code.contains(said), "{said} is not there");
    }
}
