//! Tests of the advice on the paper's scenes: estimates against full runs.

use std::path::Path;

use crate::known::MODELS;
use crate::library::advise::Advice;
use crate::scene::Scene;

fn advice(name: &str, set: &[&str]) -> Advice {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(format!("{name}.toml"));
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let set: Vec<_> = set.iter().map(ToString::to_string).collect();
    let scene = Scene::load_with(&path, &set, &models).unwrap();
    scene.advise().unwrap()
}

/// At 4500 rpm the jump terms and the moving phase are negligible, at 600 rpm they are needed, as in the paper. No other effect is
/// negligible. The estimates agree with the runs, and give the loss of speed to within 10 %.
#[test]
fn jump_terms_are_negligible_at_4500_rpm_and_needed_at_600_rpm() {
    for (name, small) in [("oh2005/spectrum_4500rpm_exact", true), ("oh2005/spectrum_600rpm_exact", false)] {
        let advice = advice(name, &[]);
        let negligible = advice.negligible();
        assert_eq!(negligible.len(), 5);
        for (i, (without, estimate, truth)) in negligible.iter().enumerate() {
            let want = Some(small && i < 2);
            assert_eq!((*estimate, *truth), (want, want), "{name}: without {without}");
        }
        let (estimate, truth) = advice.speeds(0).unwrap();
        assert!((estimate / truth - 1.0).abs() < 0.1, "{name}: {estimate} {truth}");
    }
}

/// For a scene that stalls, the estimate is that steps reflect the motion.
#[test]
fn a_stall_is_predicted_without_a_full_run() {
    let advice = advice("oh2005/stall_300rpm", &[]);
    assert_eq!(advice.speeds(0), None, "no estimate");
    assert!(advice.negligible().iter().all(|(_, estimate, truth)| (*estimate, *truth) == (Some(false), Some(false))));
}

/// Scenes with smooth laws and scenes without damping have no settled motion: their estimates come from short runs.
#[test]
fn scenes_without_a_settled_motion_are_estimated_by_short_runs() {
    for (name, set) in [("oh2005/energy_300rpm", "laws.k.ramp=0.1 rad"), ("idler", "run.t_end=0.02 s")] {
        let advice = advice(name, &[set]);
        assert!(advice.no_orbit.is_some(), "{name}");
        assert!(advice.negligible().iter().all(|(_, estimate, truth)| estimate.is_some() && truth.is_some()), "{name}");
    }
}

/// Where contact is never lost, backlash only shifts the deflection by half its size, which causes no force.
#[test]
fn backlash_is_negligible_where_contact_is_never_lost() {
    let settled = ["start.speed=300 rpm", "parameters.T0=20 N*m", "run.t_end=50 ms", "parameters.zeta=0.1"];
    let advice = advice("backlash", &settled);
    let backlash: Vec<_> = advice.negligible().into_iter().filter(|(without, ..)| *without == "backlash").collect();
    assert!(matches!(backlash[..], [(_, Some(true), Some(true))]), "{backlash:?}");
}
