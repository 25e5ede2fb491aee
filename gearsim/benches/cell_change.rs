//! Time per cell change on the 4500 rpm scene of the paper, compared with a hand-written solver.
//!
//! `cargo bench -p gearsim`. Every row runs 3,600 cell changes or an equivalent amount of work, so that rows are comparable
//! within one run: the engine with its guarantee and energy account; the hand-written program for this one system; and three pairs of
//! exponential and sine-cosine per cell change, each of which waits for the result of the one before. The hand-written program needs one
//! such pair. `benches/c_program.rs` also measures the program in C, on three scenes.

use divan::{Bencher, black_box};
use gearsim::__private::equations::Derived;
use gearsim::__private::models::GearPair;
use gearsim::__private::{Simulation, ensemble};
use gearsim::scene::Scene;
use gearsim_tests::oh2005;

/// Number of cell changes in a run.
const CHANGES: u64 = 3_600;

fn main() {
    divan::main();
}

fn scene(extra: &[&str]) -> Scene {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/oh2005/spectrum_4500rpm_exact.toml");
    let mut overrides = vec!["run.t_end=1.0 s".to_string()];
    overrides.extend(extra.iter().map(|s| s.to_string()));
    Scene::load_with(path.as_ref(), &overrides, &[&GearPair::MODEL])
        .unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

fn engine(bencher: Bencher, extra: &[&str]) {
    let scene = scene(extra);
    let mids = [scene.laws[0].mid()];
    let equations = GearPair::equations(&scene.effects, &scene.parameters, &mids).expect("the scene was checked");
    bencher.counter(divan::counter::ItemsCount::new(CHANGES)).bench_local(|| {
        let mut simulation = Simulation::new(&*equations, &scene).expect("the scene is sound");
        simulation.run(None, &mut |_| {}).expect("the run ends");
        assert!(simulation.now.counts.cell_changes.abs_diff(CHANGES) < 40, "{}", simulation.now.counts.cell_changes);
        simulation.now.state
    });
}

#[divan::bench]
fn engine_damped(bencher: Bencher) {
    engine(bencher, &[]);
}

/// Unrecorded runs are simulated in this way.
#[divan::bench]
fn engine_unwatched(bencher: Bencher) {
    let scene = scene(&[]);
    let mids = [scene.laws[0].mid()];
    let equations = GearPair::equations(&scene.effects, &scene.parameters, &mids).expect("the scene was checked");
    bencher.counter(divan::counter::ItemsCount::new(CHANGES)).bench_local(|| {
        let mut simulation = [Simulation::new(&*equations, &scene).expect("the scene is sound")];
        ensemble::run(&mut simulation).pop().expect("there is one").expect("the run ends");
        assert!(
            simulation[0].now.counts.cell_changes.abs_diff(CHANGES) < 40,
            "{}",
            simulation[0].now.counts.cell_changes
        );
        simulation[0].now.state.clone()
    });
}

#[divan::bench]
fn engine_undamped(bencher: Bencher) {
    engine(bencher, &["effects=[\"stiffness_step\", \"torques\"]"]);
}

#[divan::bench]
fn hand_written(bencher: Bencher) {
    let pair = oh2005::GearPair::paper(0.05, 10.0);
    let s = pair.start(4500.0);
    bencher.counter(divan::counter::ItemsCount::new(CHANGES)).bench_local(|| {
        let run = pair.solve_fast(black_box(s.theta), s.theta_dot, s.phi, s.phi_dot, 1.0);
        assert!((run.cell_changes as u64).abs_diff(CHANGES) < 40);
        run.end
    });
}

#[divan::bench]
fn three_exp_and_sincos(bencher: Bencher) {
    bencher.counter(divan::counter::ItemsCount::new(CHANGES)).bench_local(|| {
        let mut x = black_box(0.3_f64);
        for _ in 0..3 * CHANGES {
            // Each value depends on the one before, as in the evaluations of one solution.
            let (s, c) = (3.0 + x).sin_cos();
            x = (-0.2 - 1e-3 * x).exp() * (s + 0.5 * c);
        }
        x
    });
}
