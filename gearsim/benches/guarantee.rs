//! What the guarantee of first crossings costs: time per cell change on the paper's scenes with it, and with Newton's
//! method alone from the same guess.
//!
//! `cargo bench -p gearsim --bench guarantee`. Both rows of a scene run the same code but for the search itself, over the same
//! model time, without a recorder; they must meet the same crossings.

use divan::Bencher;
use gearsim::engine::equations::{Derived, Equations};
use gearsim::engine::simulate::Simulation;
use gearsim::generated::gear_pair::GearPair;
use gearsim::scene::Scene;

/// The scenes, and model time to measure over.
const SCENES: [(&str, &str); 3] =
    [("energy_300rpm", "0.3 s"), ("spectrum_600rpm_exact", "1 s"), ("spectrum_4500rpm_exact", "1 s")];

fn main() {
    divan::main();
}

fn scene(name: &str, span: &str) -> Scene {
    let path = format!("{}/../models/scenes/oh2005/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let overrides = [format!("run.t_end={span}"), "output.rate=1 kHz".to_string()];
    Scene::load(path.as_ref(), &overrides, &[&GearPair::MODEL]).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

/// A simulation of a scene, run to its end.
fn run<'a>(scene: &Scene, equations: &'a dyn Equations, unguarded: bool) -> Simulation<'a> {
    let mut simulation = Simulation::new(scene.model, equations, scene).expect("the scene is sound");
    simulation.unguarded = unguarded;
    simulation.run(None, &mut |_| {}).expect("the run ends");
    simulation
}

fn measure(bencher: Bencher, (name, span): (&str, &str), unguarded: bool) {
    let scene = scene(name, span);
    let mids = [scene.laws[0].mid()];
    let equations = GearPair::equations(scene.effects.0, &scene.parameters, &mids).expect("the scene was checked");
    let [safe, plain] = [false, true].map(|unguarded| run(&scene, &*equations, unguarded));
    assert_eq!(safe.counts.cell_changes, plain.counts.cell_changes, "{name}: not the same crossings");
    let difference = (&safe.state.q - &plain.state.q).amax();
    assert!(difference < 1e-9, "{name}: not the same motion, {difference:e} rad apart");
    bencher
        .counter(divan::counter::ItemsCount::new(safe.counts.cell_changes))
        .bench_local(|| run(&scene, &*equations, unguarded).state.clone());
}

#[divan::bench(args = SCENES)]
fn guaranteed(bencher: Bencher, scene: (&str, &str)) {
    measure(bencher, scene, false);
}

#[divan::bench(args = SCENES)]
fn newton_alone(bencher: Bencher, scene: (&str, &str)) {
    measure(bencher, scene, true);
}
