//! A formula with a mistake in it fails its proof, and a model with a failed proof is refused.

use gearsim_derive::{Expr, Factor, Model, Range, Start, Wrong, derive, derive_wrong, half};
use gearsim_models::MODELS;
use gearsim_models::components::dead_band;
use gearsim_models::components::{friction_effect, mesh_with_play, transmission_error};

use crate::slips::{Oscillator, oscillator};

/// The mistake, a model, and the proof that must fail.
const MISTAKES: &[(Wrong, &str, &str)] = &[
    (Wrong::Mass, "gear_pair", "T = q'.M q'/2"),
    (Wrong::Mass, "planetary_3", "T = q'.M q'/2"),
    (Wrong::Mirror, "two_stage", "M is symmetric"),
    (Wrong::Inverse, "gear_pair", "M M⁻¹ = 1"),
    (Wrong::Force, "chain_5", "d/dt (q'.dT/dq' - T + V)"),
    (Wrong::Centrifugal, "crank_drive", "d/dt (q'.dT/dq' - T + V)"),
    (Wrong::Gyroscopic, "crank_drive", "d/dt dT/dq' - dT/dq = M q'' + c"),
    (Wrong::Inverse, "cardan_drive", "M M⁻¹ = 1"),
    (Wrong::Clip, "gear_pair", "d/dt (q'.dT/dq' - T + V)"),
    (Wrong::Clip, "backlash_oscillator", "d/dt (q'.dT/dq' - T + V)"),
    (Wrong::Normal, "gear_pair", "T+ - T-"),
    (Wrong::Normal, "planetary_3", "T+ - T-"),
    (Wrong::Direction, "gear_pair", "T+ - T-"),
    (Wrong::Step, "gear_pair", "V+ - V- = dV"),
    (Wrong::Step, "planar_planetary_3", "V+ - V- = dV"),
    (Wrong::LastStep, "planetary_3", "V is the same on both sides of a step of side_s1"),
    (Wrong::LastStep, "gear_pair", "V is the same on both sides of a step of side, arm"),
    (Wrong::Deflection, "idler", "every deflection equals the linear form"),
];

pub fn a_wrong_formula_is_refused() {
    for &(wrong, name, proof) in MISTAKES {
        let describe = MODELS.iter().find(|m| m.0 == name).expect("a known model").1;
        let refused = derive_wrong(&Model::new(name, describe), wrong).err();
        let slip = refused.unwrap_or_else(|| panic!("{wrong:?} in {name}: not refused")).to_string();
        assert!(slip.contains("proof failed") && slip.contains(proof), "{wrong:?} in {name}: {slip}");
    }
}

/// The step dV of the last of several laws that occur in V: the transmission error of the second of two meshes.
pub fn a_wrong_step_of_a_later_law_is_refused() {
    let model = Model::new("two_meshes", |m| {
        let o = oscillator(m);
        let inertia = m.parameter("I", "kg*m^2", None, Range::Positive, "");
        let phase = m.coordinate("phase", "rad", Start::At(0.0), "");
        m.kinetic(half(inertia * phase.dot().sq()));
        mesh_with_play(m, "1", "first mesh", phase, o.x, None);
        mesh_with_play(m, "2", "second mesh", phase, 2 * o.x, None);
    });
    let proofs = derive(&model).unwrap_or_else(|slip| panic!("{slip}")).proofs().join("\n");
    assert!(proofs.contains("e2"), "{proofs}");
    let slip = derive_wrong(&model, Wrong::LastStep).err().expect("not refused").to_string();
    assert!(slip.contains("proof failed") && slip.contains("V+ - V- = dV") && slip.contains("e2"), "{slip}");
}

/// Models that feed energy, and the proof that must fail.
type Row = (&'static str, fn(&mut Model, Oscillator));

const FEEDING: &[Row] = &[
    ("every damper takes energy or none", |m, o| m.dissipation(o.m * (o.x.dot().sq() + 1).pow(-2))),
    ("the force of the switch over takes energy or none", |m, o| clipped(m, o, Range::Any)),
    ("the force of the switch slip takes energy or none", |m, o| dry(m, o, -1)),
    ("V is the same on both sides of the exits of over", |m, o| shifted(m, o)),
    ("the friction `roll` takes energy or none", |m, o| friction(m, o, 1, -1)),
    ("the friction `slide`", |m, o| friction(m, o, -1, -2)),
    ("the friction `slide` takes with `roll` energy or none in every mode of psi", |m, o| sticking(m, o, -1)),
];

/// A contact with a spring `k` of this range and a damper.
fn clipped(m: &mut Model, o: Oscillator, range: Range) {
    let [k, b] = [("k", range), ("b", Range::Positive)].map(|(name, range)| m.parameter(name, "1", None, range, ""));
    let play = dead_band(m, "", "m", o.x, b, "backlash", "");
    m.effect("backlash", "", |_| {});
    m.potential(half(k * play.touch * play.over.sq()));
    m.dissipation(half(o.s * play.damp * play.over.dot().sq()));
}

/// Dry friction, against the motion or, with the sign -1, along it.
fn dry(m: &mut Model, o: Oscillator, sign: i64) {
    m.effect("dry_friction", "", |_| {});
    let mut slip = m.switch("slip", "m", o.x, "dry_friction", "");
    let (direction, rate) = (slip.factor("dir", 0), slip.over().dot());
    slip.mode("forward", &[1.into()]).until("backward", rate);
    slip.mode("backward", &[Expr::from(-1)]).until("forward", -rate);
    slip.loss(sign * o.s * direction);
}

/// A spring that is switched on where it is strained.
fn shifted(m: &mut Model, o: Oscillator) {
    m.effect("backlash", "", |_| {});
    let mut gap = m.switch("over", "m", o.x, "backlash", "");
    let (touch, over) = (gap.factor("touch", 1), gap.over());
    gap.mode("free", &[0.into()]).until("on", 1 - over);
    gap.mode("on", &[1.into()]).until("free", over - 1);
    m.potential(half(o.s * touch * over.sq()));
}

/// Friction of rolling `roll` times its force, and of sliding `slide` times its force.
fn friction(m: &mut Model, o: Oscillator, roll: i64, slide: i64) {
    friction_effect(m, "", |m| {
        let [side, arm] = [("side", Factor::Side), ("arm", Factor::Arm)]
            .map(|(name, what)| m.factor_law(name, "1", o.x, 1.0, what, ""));
        let tau = m.deflection("tau", 2 * o.x);
        let force = m.force("F_mu", o.m * o.x.dot());
        m.torque("slide", slide * side * force, tau, "");
        m.torque("roll", roll * arm * force, o.x, "");
    });
}

/// Friction that sticks and slips. In slip it acts against the motion or, with the sign -1, along it.
fn sticking(m: &mut Model, o: Oscillator, sign: i64) {
    friction_effect(m, "", |m| {
        let [side, arm] = [("side", Factor::Side), ("arm", Factor::Arm)]
            .map(|(name, what)| m.factor_law(name, "1", o.x, 1.0, what, ""));
        let tau = m.deflection("tau", 2 * o.x);
        m.effect("flank_stiction", "", |_| {});
        let mut slip = m.switch("psi", "m", o.x, "flank_stiction", "");
        let (direction, psi, resisted) = (slip.factor("dir", 0), slip.over(), slip.reaction());
        let sliding = arm * psi.dot() + side * tau.dot();
        slip.mode("stuck", &[0.into()]).holds().until("forward", o.s - resisted).until("backward", o.s + resisted);
        slip.mode("forward", &[1.into()]).until("stuck", sliding);
        slip.mode("backward", &[Expr::from(-1)]).until("stuck", -sliding);
        let smoothed = m.force("F_mu", o.m * psi.dot());
        let instead = m.force("F_dir", sign * o.m * direction - o.m * psi.dot());
        let force = smoothed + m.only_with("flank_stiction", instead);
        m.torque("slide", -side * force, tau, "");
        m.torque("roll", -arm * force, psi, "");
    });
}

pub fn a_model_that_feeds_energy_is_refused() {
    let of = |describe: fn(&mut Model, Oscillator)| {
        Model::new("train", move |m| {
            let o = oscillator(m);
            describe(m, o);
        })
    };
    for (proof, describe) in FEEDING {
        let slip = derive(&of(*describe)).err().unwrap_or_else(|| panic!("{proof}: not refused")).to_string();
        assert!(slip.contains("proof failed") && slip.contains(proof), "{proof}: {slip}");
    }
    let sound: [fn(&mut Model, Oscillator); 4] = [
        |m, o| clipped(m, o, Range::NotNegative),
        |m, o| dry(m, o, 1),
        |m, o| friction(m, o, -1, -1),
        |m, o| sticking(m, o, 1),
    ];
    for sound in sound {
        let model = of(sound);
        derive(&model).unwrap_or_else(|slip| panic!("{slip}"));
    }
}

/// Dampers need not be linear, and the power of a damper need not be a multiple of its term in D.
pub fn other_dampers_are_proved() {
    let smooth_dry: fn(Expr, Expr) -> Expr = |m, v| m * (v.sq() + 1).sqrt();
    for damper in [|m: Expr, v: Expr| m * v.pow(4), smooth_dry] {
        let model = Model::new("train", |m| {
            let o = oscillator(m);
            let y = m.coordinate("y", "m", Start::Static, "");
            m.kinetic(half(o.m * y.dot().sq()));
            m.dissipation(damper(o.m, o.x.dot()));
            m.dissipation(o.m * (o.x.dot() - y.dot()).sq());
        });
        let derivation = derive(&model).unwrap_or_else(|slip| panic!("{slip}"));
        assert!(derivation.proofs().iter().any(|p| p.starts_with("every damper takes energy or none")));
    }
}

/// A torque may act along a deflection with a transmission error. Its power has the rate of the deflection without the rate of the error.
pub fn a_torque_through_a_deflection_is_in_the_balance() {
    let model = Model::new("train", |m| {
        let o = oscillator(m);
        let e = transmission_error(m, ["e", ""], "m", o.x, 1.0, "");
        let delta = m.deflection("delta", 2 * o.x - e);
        m.potential(half(o.s * delta.sq()));
        m.torque("pull", o.s, delta, "");
    });
    let derivation = derive(&model).unwrap_or_else(|slip| panic!("{slip}"));
    assert!(derivation.proofs().iter().any(|p| p.starts_with("at a step of e: T+ - T-")), "{:?}", derivation.proofs());
}
