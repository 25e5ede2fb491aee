//! The cost of the guarantee that the first crossing is found: time per search on the flights of the paper's scenes, with the guarantee,
//! and with Newton's method alone from the same guess.
//!
//! `cargo bench -p gearsim --bench guarantee`. Both rows of a scene search the same flights, and must find the same crossings.

use divan::Bencher;
use gearsim::__private::equations::Derived;
use gearsim::__private::models::GearPair;
use gearsim::__private::{Cost, Delay, Search, Side, Signal, Simulation, Vector};
use gearsim::scene::Scene;

/// The scenes, and the simulated time of each.
const SCENES: [(&str, &str); 3] =
    [("energy_300rpm", "0.3 s"), ("spectrum_600rpm_exact", "1 s"), ("spectrum_4500rpm_exact", "1 s")];

fn main() {
    divan::main();
}

fn scene(name: &str, span: &str) -> Scene {
    let path = format!("{}/../models/scenes/oh2005/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let overrides = [format!("run.t_end={span}"), "output.rate=1 kHz".to_string()];
    Scene::load_with(path.as_ref(), &overrides, &[&GearPair::MODEL])
        .unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

/// The start of a flight: its cell, the state, and the boundaries of the phase.
struct Start {
    cell: usize,
    q: Vector,
    q_dot: Vector,
    bounds: (f64, f64),
}

/// Searches all flights; returns the sides of the boundaries reached and the sum of the crossing times [s].
fn search(simulation: &Simulation<'_>, starts: &[Start], guaranteed: bool) -> (Vec<Option<Side>>, f64) {
    let cells = simulation.cells().and_then(|cells| cells.all()).expect("the gear pair has two cells");
    let mut lateness = vec![Delay::default(); cells.len()];
    let (mut met, mut sum, mut cost) = (Vec::with_capacity(starts.len()), 0.0, Cost::default());
    for Start { cell, q, q_dot, bounds: (lower, upper) } in starts {
        let prepared = &cells[*cell];
        let flight = prepared.cell.flight(q, q_dot);
        let signal = Signal { flight: &flight, on_moved: &prepared.participation[0], on_speed: None, direct: None };
        let search = Search { signal, rate: q_dot[0], down: q[0] - lower, up: upper - q[0], horizon: f64::MAX };
        let (lateness, mut point) = (&mut lateness[*cell], flight.begin());
        met.push(match guaranteed {
            true => search.first_near(lateness, &mut point, &mut cost).expect("the search ends"),
            false => search.newton_alone(lateness, &mut point, &mut cost),
        });
        sum += point.t;
    }
    (met, sum)
}

fn measure(bencher: Bencher, (name, span): (&str, &str), guaranteed: bool) {
    let scene = scene(name, span);
    let mids = [scene.laws[0].mid()];
    let equations = GearPair::equations(&scene.effects, &scene.parameters, &mids).expect("the scene was checked");
    let mut simulation = Simulation::new(&*equations, &scene).expect("the scene is sound");
    let mut starts = vec![];
    loop {
        let law = &simulation.now.laws[0];
        let (q, q_dot) = (simulation.now.state.q.clone(), simulation.now.state.q_dot.clone());
        starts.push(Start { cell: law.cell, q, q_dot, bounds: law.bounds() });
        if simulation.step(&mut None).expect("the run goes on") {
            break;
        }
    }
    let [safe, plain] = [true, false].map(|guaranteed| search(&simulation, &starts, guaranteed));
    assert_eq!(safe.0, plain.0, "{name}: not the same crossings");
    assert!((safe.1 - plain.1).abs() < 1e-12 * safe.1, "{name}: not the same times");
    bencher
        .counter(divan::counter::ItemsCount::new(starts.len()))
        .bench_local(|| search(&simulation, &starts, guaranteed).1);
}

#[divan::bench(args = SCENES)]
fn guaranteed(bencher: Bencher, scene: (&str, &str)) {
    measure(bencher, scene, true);
}

#[divan::bench(args = SCENES)]
fn newton_alone(bencher: Bencher, scene: (&str, &str)) {
    measure(bencher, scene, false);
}
