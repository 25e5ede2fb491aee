//! Time per cell change of many scenes side by side, compared with the same scenes one after the other.
//!
//! `cargo bench -p gearsim --bench ensemble`: 64 gear pairs near the 4500 rpm scene of the paper, on one core.
//!
//! The times are for prepared simulations. They exclude equations, starts, cells and energy accounts, which take about 12 us per
//! scene (3 ns per cell change in runs of 3,600). `benches/c_program.rs` measures whole batches, and names other influences on these times.

use divan::Bencher;
use divan::counter::ItemsCount;
use gearsim::__private::equations::{Derived, Equations};
use gearsim::__private::models::GearPair;
use gearsim::__private::{Simulation, ensemble};
use gearsim::scene::Scene;

/// Number of scenes in the ensemble.
const SCENES: u32 = 64;

fn main() {
    divan::main();
}

/// Scenes with different torques and speeds.
fn scenes() -> Vec<(Scene, Box<dyn Equations>)> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/oh2005/spectrum_4500rpm_exact.toml");
    let scene = |i: u32| {
        let overrides = [
            "run.t_end=1.0 s".to_string(),
            format!("parameters.T0={} N*m", 5.0 + 0.2 * f64::from(i)),
            format!("start.speed={} rpm", 4000 + 20 * i),
        ];
        let scene = Scene::load_with(path.as_ref(), &overrides, &[&GearPair::MODEL]);
        let scene = scene.unwrap_or_else(|e| panic!("{}", e.render(100, false)));
        let equations = GearPair::equations(&scene.effects, &scene.parameters, &[scene.laws[0].mid()]);
        (scene, equations.expect("the scene was checked"))
    };
    (0..SCENES).map(scene).collect()
}

fn simulations(scenes: &[(Scene, Box<dyn Equations>)]) -> Vec<Simulation<'_>> {
    scenes.iter().map(|(scene, e)| Simulation::new(&**e, scene).expect("the scene is sound")).collect()
}

fn changes(simulations: &[Simulation<'_>]) -> u64 {
    simulations.iter().map(|s| s.now.counts.cell_changes).sum()
}

fn bench(bencher: Bencher, run: impl Fn(&mut [Simulation<'_>])) {
    let scenes = scenes();
    let mut once = simulations(&scenes);
    run(&mut once);
    bencher
        .counter(ItemsCount::new(changes(&once)))
        .with_inputs(|| simulations(&scenes))
        .bench_local_refs(|all| run(all));
}

#[divan::bench]
fn side_by_side(bencher: Bencher) {
    bench(bencher, |all| assert!(ensemble::run(all).iter().all(Result::is_ok)));
}

#[divan::bench]
fn one_by_one(bencher: Bencher) {
    bench(bencher, |all| all.iter_mut().for_each(|s| s.run(None, &mut |_| {}).expect("the run ends")));
}
