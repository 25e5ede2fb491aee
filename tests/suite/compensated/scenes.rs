//! All scenes whose cells are linear: both precisions have the same events, and the same end but for plain rounding.

use gearsim::engine::hybrid::Hybrid;
use gearsim::scene::Precision;

use crate::common::{model, root, scene};

/// What must be the same, and the coordinates and speeds at the end.
fn end(now: &Hybrid<'_>) -> ([u64; 5], Vec<f64>) {
    let c = &now.counts;
    let state = now.state.q.iter().chain(now.state.q_dot.iter()).copied().collect();
    ([c.cell_changes, c.reflections, c.holds, c.impacts, c.sticks], state)
}

#[test]
fn scenes_with_linear_cells_run_in_both_precisions() {
    let mut run = 0;
    for folder in ["", "drives/", "oh2005/"] {
        let mut names: Vec<_> = std::fs::read_dir(root().join("models/scenes").join(folder)).unwrap().collect();
        names.sort_by_key(|name| name.as_ref().unwrap().file_name());
        for name in names {
            let name = name.unwrap().file_name().into_string().unwrap();
            let Some(name) = name.strip_suffix(".toml") else { continue };
            let name = format!("{folder}{name}");
            let mut scene = scene(&name, &[]);
            // The first part of each: errors of plain numbers do not yet grow beyond what is asked for.
            scene.t_end *= 0.02;
            let entry = model(scene.model.name);
            if entry.check(&scene).unwrap().method != "exact" {
                continue;
            }
            let ends = [Precision::Plain, Precision::Compensated].map(|precision| {
                let mut scene = scene.clone();
                scene.solver.precision = precision;
                let equations = entry.equations(&scene).unwrap();
                let mut simulation = entry.simulation(&scene, &*equations).unwrap_or_else(|e| panic!("{name}: {e}"));
                simulation.run(None, &mut |_| {}).unwrap_or_else(|e| panic!("{name}: {e}"));
                end(&simulation.now)
            });
            let [(plain, a), (compensated, b)] = ends;
            let n = a.len() / 2;
            let apart = |range: std::ops::Range<usize>| {
                let size = range.clone().map(|i| b[i].abs()).fold(0.0, f64::max);
                range.map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max) / if size > 0.0 { size } else { 1.0 }
            };
            let apart = apart(0..n).max(apart(n..2 * n));
            println!("{name}: {plain:?}, {apart:.1e}");
            assert_eq!(plain, compensated, "{name}");
            assert!(apart < 1e-9, "{name}: {apart:.1e}");
            run += 1;
        }
    }
    assert!(run >= 15, "{run}");
}

#[test]
fn temporary() {
    for (name, part) in [("backlash", 0.05), ("backlash", 0.1), ("backlash", 0.15), ("backlash", 0.2), ("backlash", 0.25), ("backlash", 0.3), ("backlash", 0.4), ("backlash", 0.5), ("electric_axle", 0.002), ("electric_axle", 0.004), ("electric_axle", 0.006),("electric_axle", 0.008), ("electric_axle", 0.01), ("electric_axle", 0.012), ("electric_axle", 0.016), ("electric_axle", 0.02)] {
        let mut scene = scene(name, &[]);
        scene.t_end *= part;
        let entry = model(scene.model.name);
        let ends = [Precision::Plain, Precision::Compensated].map(|precision| {
            let mut scene = scene.clone();
            scene.solver.precision = precision;
            let equations = entry.equations(&scene).unwrap();
            let mut simulation = entry.simulation(&scene, &*equations).unwrap();
            simulation.run(None, &mut |_| {}).unwrap();
            (end(&simulation.now), simulation.now.switches.iter().map(|s| s.here().name).collect::<Vec<_>>())
        });
        let [((c, a), m), ((d, b), _)] = ends;
        println!("TEMP {name} {part} {c:?} {d:?} {m:?}");
        let mut steps = scene.clone();
        steps.solver.method = Some(gearsim::scene::solver::Method::Dop853);
        steps.solver.tolerance = 1e-13;
        let equations = entry.equations(&steps).unwrap();
        let mut simulation = entry.simulation(&steps, &*equations).unwrap();
        simulation.run(None, &mut |_| {}).unwrap();
        let (e, c) = end(&simulation.now);
        let n = a.len() / 2;
        let off = |a: &[f64]| (n..2 * n).map(|i| (a[i] - c[i]).abs()).fold(0.0, f64::max) / (n..2 * n).map(|i| c[i].abs()).fold(0.0, f64::max);
        println!("TEMP   dop853 {e:?} from plain {:.1e} from compensated {:.1e}", off(&a), off(&b));
        println!("XTEMP   {:?}", a.iter().zip(&b).map(|(a, b)| format!("{b:.5e}:{:.1e}", a - b)).collect::<Vec<_>>());
    }
}
