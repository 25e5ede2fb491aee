//! The derived equations of the gear pair, compared with the paper's equations written by hand.

use gearsim_derive::{Derivation, Expr, Model, derive};

use crate::paper::Paper;

const THETA: usize = 0;
const PHI: usize = 1;

fn with_gear_pair(test: impl FnOnce(&Derivation, &Paper)) {
    let model = Model::new("gear_pair", gearsim_models::gear_pair::gear_pair);
    test(&derive(&model).expect("the gear pair is sound"), &Paper::new());
}

fn same(what: &str, derived: Expr, by_hand: Expr) {
    let rest = derived - by_hand;
    assert!(rest.is_zero(), "{what}: derived {derived}\nby hand {by_hand}\ndifference {rest}");
}

/// The effects that the paper does not have.
const BEYOND: [&str; 13] = [
    "backlash",
    "transmission_error",
    "sliding_friction",
    "governor_motor",
    "dc_motor",
    "induction_motor",
    "traction_motor",
    "fan_motor",
    "governor_load",
    "dc_load",
    "induction_load",
    "traction_load",
    "fan_load",
];

/// The derived equation of a coordinate without these effects, and without `absent`.
fn equation(d: &Derivation, i: usize, absent: &[&str]) -> Expr {
    d.equation(i, &[&BEYOND, absent].concat())
}

pub fn equations_equal_those_of_the_paper() {
    with_gear_pair(|d, paper| {
        same("Eq. (2), phi''", equation(d, PHI, &[]), paper.eq2());
        same("Eq. (3), theta''", equation(d, THETA, &[]), paper.eq3());
        // The effects rigid_kinematics and frozen_phase mean that the terms under these conditions are absent.
        same("Eq. (4), phi''", equation(d, PHI, &["jump_terms"]), paper.eq4());
        same("Eq. (5), theta''", equation(d, THETA, &["jump_terms"]), paper.eq5());
        same("Eq. (6), phi''", equation(d, PHI, &["jump_terms", "moving_phase"]), paper.eq6());
        // Without damping and torques the rest of Eq. (2) remains.
        let bare = |e: Expr, of_torque: Expr, of_damping: Expr| e - of_torque - of_damping;
        let (torque, damping) = (paper.eq4_of_torque(), paper.eq4_of_damping());
        same(
            "Eq. (2) without damping and torques",
            equation(d, PHI, &["damping", "torques"]),
            bare(paper.eq2(), torque, damping),
        );
        same("Eq. (2) without torques", equation(d, PHI, &["torques"]), paper.eq2() - torque);
        same("(M2 C)^2 = (2 zeta w0)^2", (paper.M2() * paper.C()).sq(), paper.damping_squared());
    });
}

pub fn jump_rule_equals_that_of_the_paper() {
    with_gear_pair(|d, paper| {
        same("Eq. (9)", d.speed_lost(0, &BEYOND).expect("M was inverted"), paper.eq9());
        same("Eq. (11)", d.direction(0, PHI).expect("M was inverted"), paper.eq11());
        same("the phase's own speed", d.direction(0, THETA).expect("M was inverted"), 1.into());
        let doubled = d.speed_lost(0, &BEYOND).expect("M was inverted") - 2 * paper.eq9();
        assert!(!doubled.is_zero(), "the comparison takes twice Eq. (9) for Eq. (9)");
        let turned = d.direction(0, PHI).expect("M was inverted") + paper.eq11();
        assert!(!turned.is_zero(), "the comparison takes Eq. (11) with the opposite sign for Eq. (11)");
    });
}

pub fn wrong_equations_are_detected() {
    with_gear_pair(|d, paper| {
        for (slip, of_phi, wrong) in paper.wrong() {
            let derived = equation(d, if of_phi { PHI } else { THETA }, &[]);
            assert!(!(derived - wrong).is_zero(), "{slip}: the wrong equation equals the derived one");
        }
    });
}

pub fn equations_match_the_snapshot() {
    let model = Model::new("gear_pair", gearsim_models::gear_pair::gear_pair);
    let derivation = derive(&model).expect("the gear pair is sound");
    insta::assert_snapshot!("gear_pair", derivation.text());
}
