//! Advice on the paper's scenes, by estimate and in truth.

use std::path::Path;

use crate::cli::advise;
use crate::generated::MODELS;
use crate::scene::Scene;

fn advice(name: &str, set: &[&str]) -> advise::Advice {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(format!("{name}.toml"));
    let models: Vec<_> = MODELS.iter().map(|entry| entry.model).collect();
    let set: Vec<_> = set.iter().map(ToString::to_string).collect();
    let scene = Scene::load(&path, &set, &models).unwrap();
    advise::of(&crate::analysis::advise::base(&scene)).unwrap()
}

/// At 4500 rpm the jump terms and the moving phase may go, at 600 rpm they are needed, as the paper has it; nothing else may go;
/// and the estimates say so before any run, with the speed that is lost to a tenth of it.
#[test]
fn the_papers_speeds_are_told_apart() {
    for (name, goes) in [("oh2005/spectrum_4500rpm_exact", true), ("oh2005/spectrum_600rpm_exact", false)] {
        let advice = advice(name, &[]);
        let told = advice.told();
        assert_eq!(told.len(), 5);
        for (i, (without, estimate, truth)) in told.iter().enumerate() {
            let want = Some(goes && i < 2);
            assert_eq!((*estimate, *truth), (want, want), "{name}: without {without}");
        }
        let (estimate, truth) = advice.speeds(0).unwrap();
        assert!((estimate / truth - 1.0).abs() < 0.1, "{name}: {estimate} {truth}");
    }
}

/// Where the gear stalls, numbers say that steps turn it back.
#[test]
fn a_stall_is_foreseen() {
    let advice = advice("oh2005/stall_300rpm", &[]);
    assert_eq!(advice.speeds(0), None, "no estimate");
    assert!(advice.told().iter().all(|(_, estimate, truth)| (*estimate, *truth) == (Some(false), Some(false))));
}

/// Smooth laws and undamped trains have estimates from short runs.
#[test]
fn others_are_run_shortly() {
    for (name, set) in [("oh2005/energy_300rpm", "laws.k.ramp=0.1 rad"), ("idler", "run.t_end=0.02 s")] {
        let advice = advice(name, &[set]);
        assert!(advice.no_orbit().is_some(), "{name}");
        assert!(advice.told().iter().all(|(_, estimate, truth)| estimate.is_some() && truth.is_some()), "{name}");
    }
}
