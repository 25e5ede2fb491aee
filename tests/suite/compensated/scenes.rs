//! All scenes whose cells are linear: both precisions have the same events, and ends that differ only by rounding errors of plain
//! precision.

use gearsim::__private::{Hybrid, Inside};
use gearsim::scene::Precision;

use crate::common::{model, root, scene};

/// Scenes whose contacts, holds or clipped dampers occur late, each with the part of its length that is run. Of other scenes 0.02 is run.
const CONTACTS: [(&str, f64); 5] = [
    ("backlash", 0.5),
    ("backlash_oscillator", 0.3),
    ("freewheel", 1.0),
    ("friction_oscillator", 1.0),
    ("oh2005/stall_300rpm", 1.0),
];

/// The counts of events, which must be equal, and the coordinates and speeds at the end.
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
            // Only the first part of each, in which the errors of plain precision are still below the tolerance.
            scene.t_end *= CONTACTS.iter().find(|(contact, _)| *contact == name).map_or(0.02, |(_, part)| *part);
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
