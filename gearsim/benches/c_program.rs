//! Time per event of gearsim, compared with programs that are written by hand for this one system in C and in Rust. All are measured
//! together.
//!
//! `cargo bench -p gearsim --bench c_program`. It compiles `tests/peers/c/gear_pair.c` with `gcc -O3` (or `cc`) into a temporary
//! folder. An event is a cell change or a reflection. All programs run the same scene to the same end state.
//!
//! Rows of the first table:
//! - **C**, **Rust by hand**: the same method in both languages (`tests/reference/oh2005/fast.rs`), with plain `f64` states,
//!   without recording and without an energy account.
//! - **unrecorded**: [`ensemble::run`] with one simulation, as in sweeps and for end states. It includes the guarantee and the
//!   energy account.
//! - **recordable**: [`Simulation::run`] without a recorder.
//! - **recorded, no rows**: [`Simulation::run`] with a recorder, without events, and with such a low rate that there are no samples.
//!
//! The times of gearsim do not include [`Simulation::new`], which is in the column "preparation". The times of the hand-written
//! programs include the preparation of their two cells.
//!
//! The second table is for whole batches: from scenes to outcomes ([`Entry::ends`], one thread), including equations, starts,
//! cells, tables of the lanes and energy accounts. "lanes alone" is [`ensemble::run`] on prepared simulations, as in
//! `benches/ensemble.rs`. The difference between them is the preparation: about 12 us per scene, which is 3 ns per event in runs
//! of 3,600 events, and more in shorter ones. It does not depend on the size of the batch. Both columns depend on the other load
//! of the machine. Eight lanes keep the vector units of a core busy, so a compiler on the other hardware thread of this core
//! slows them down by a factor of 1.1 to 1.4. The C program mostly waits for its own results and is hardly affected. The ratio to
//! C is therefore meaningful only on an idle machine.
//!
//! Every time is the smallest of several rounds. In each round the programs run one after another.

use std::hint::black_box;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

use gearsim::__private::equations::{Derived, Equations};
use gearsim::__private::models::GearPair;
use gearsim::__private::{Recorder, Simulation, ensemble};
use gearsim::run::Entry;
use gearsim::scene::Scene;
use gearsim_tests::oh2005;

/// Scenes: name, file of `models/scenes/oh2005`, speed of the driving gear [rpm], torque T0 [N m], end of the run [s].
const SCENES: [(&str, &str, f64, f64, f64); 3] = [
    ("4500 rpm", "spectrum_4500rpm_exact", 4500.0, 10.0, 1.0),
    ("600 rpm", "spectrum_600rpm_exact", 600.0, 10.0, 1.0),
    ("stall: 600 rpm, 50 N m", "spectrum_600rpm_exact", 600.0, 50.0, 0.8),
];
/// Number of rounds, and duration of each program in a round.
const ROUNDS: usize = 9;
const SLICE: Duration = Duration::from_millis(30);
/// Largest allowed difference of end states, see [`apart`].
const TOLERANCE: f64 = 1e-9;
/// Numbers of scenes in a batch, and events per scene.
const BATCHES: [usize; 3] = [8, 64, 512];
const EVENTS: f64 = 3600.0;

/// The result of a run: cell changes, reflections, cell, theta above the lower boundary of the cell, theta', phi and phi'.
#[derive(Debug, Clone, Copy, PartialEq)]
struct End {
    counts: [i64; 3],
    state: [f64; 4],
}

fn main() {
    // `cargo test --all-targets` starts benchmarks too, but without this argument.
    if !std::env::args().any(|word| word == "--bench") {
        return println!("nothing is measured without --bench: cargo bench -p gearsim --bench c_program");
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let c = compile(folder.path().join("gear_pair"));
    if c.is_none() {
        println!(
            "neither gcc nor cc is installed, or they do not compile gear_pair.c: there are no times of the C program"
        );
    }
    let base = singles(c.as_ref());
    batches(base);
}

/// Compiles the program in C; `None` if there is no compiler.
fn compile(to: PathBuf) -> Option<PathBuf> {
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/peers/c/gear_pair.c");
    let compiles = |compiler: &str| {
        let status = Command::new(compiler).args(["-O3", "-o"]).arg(&to).arg(source).arg("-lm").status();
        status.is_ok_and(|status| status.success())
    };
    ["gcc", "cc"].into_iter().any(compiles).then_some(to)
}

/// Runs the program in C; returns its end state and its smallest time per event [ns].
fn run_c(program: &PathBuf, rpm: f64, torque: f64, t_end: f64, events: f64) -> (End, f64) {
    let repetitions = (SLICE.as_secs_f64() / (events * 1e-7)).ceil();
    let words = [rpm, torque, t_end, repetitions].map(|x| x.to_string());
    let output = Command::new(program).args(words).output().expect("the program in C starts");
    let text = String::from_utf8(output.stdout).expect("it prints text");
    let numbers: Vec<f64> = text.split_whitespace().map(|word| word.parse().expect("it prints numbers")).collect();
    let [changes, reflections, cell, theta, theta_dot, phi, phi_dot, ns] = numbers[..] else {
        panic!("the program in C printed `{text}`");
    };
    let counts = [changes as i64, reflections as i64, cell as i64];
    (End { counts, state: [theta, theta_dot, phi, phi_dot] }, ns)
}

/// Loads a scene with changes.
fn scene(file: &str, changes: &[String]) -> Scene {
    let path = format!("{}/../models/scenes/oh2005/{file}.toml", env!("CARGO_MANIFEST_DIR"));
    Scene::load_with(path.as_ref(), changes, &[&GearPair::MODEL]).unwrap_or_else(|e| panic!("{}", e.render(100, false)))
}

fn equations(scene: &Scene) -> Box<dyn Equations> {
    let equations = GearPair::equations(&scene.effects, &scene.parameters, &[scene.laws[0].mid()]);
    equations.expect("the scene was checked")
}

fn prepare<'a>(scene: &Scene, equations: &'a dyn Equations) -> Simulation<'a> {
    Simulation::new(equations, scene).expect("the scene is sound")
}

fn unrecorded(simulation: &mut Simulation<'_>) {
    let mut results = ensemble::run(std::slice::from_mut(simulation));
    results.pop().expect("there is one").expect("the run ends");
}

fn recordable(simulation: &mut Simulation<'_>) {
    simulation.run(None, &mut |_| {}).expect("the run ends");
}

fn without_rows(scene: &Scene, simulation: &mut Simulation<'_>) {
    let (lengths, start, levels) =
        (simulation.turn_lengths(), simulation.now.state.clone(), simulation.now.k[..].to_vec());
    let mut recorder = Recorder::new(scene, simulation.equations(), lengths, start, &levels);
    let rate = 1e-3 / scene.t_end;
    simulation.run(Some((&mut recorder, rate, false)), &mut |_| {}).expect("the run ends");
}

/// The end state of a simulation.
fn end(simulation: &Simulation<'_>) -> End {
    let (counts, state, law) = (&simulation.now.counts, &simulation.now.state, &simulation.now.laws[0]);
    let cell = 2 * state.turns[0] + law.cell as i64;
    let counts = [counts.cell_changes as i64, counts.reflections as i64, cell];
    End { counts, state: [state.q[0] - law.bounds().0, state.q_dot[0], state.q[1], state.q_dot[1]] }
}

/// Largest difference of two states. The differences are relative: that of theta to a pitch, that of theta' to its value at the start, that
/// of phi to T0/k1, and that of phi' to w0 T0/k1.
fn apart(pair: &oh2005::GearPair, rpm: f64, a: &End, b: &End) -> f64 {
    let (phi, theta_dot) = (pair.t0 / pair.k1, pair.start(rpm).theta_dot);
    let units = [oh2005::PITCH, theta_dot, phi, pair.w0() * phi];
    (0..4).map(|i| (a.state[i] - b.state[i]).abs() / units[i]).fold(0.0, f64::max)
}

/// Smallest time of `run` on the result of `prepare` [ns]. Both are repeated for about one slice.
fn least<T>(mut prepare: impl FnMut() -> T, mut run: impl FnMut(&mut T)) -> f64 {
    let (begun, mut least) = (Instant::now(), f64::INFINITY);
    while begun.elapsed() < SLICE {
        let mut what = prepare();
        let start = Instant::now();
        run(black_box(&mut what));
        least = least.min(start.elapsed().as_nanos() as f64);
    }
    least
}

/// Prints the table of single runs; returns the time per event of the C program on the first scene [ns].
fn singles(c: Option<&PathBuf>) -> Option<f64> {
    println!(
        "| scene | program | ns an event | beside C | events | end state beside Rust by hand | preparation [us] |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let mut base = None;
    for (name, file, rpm, torque, t_end) in SCENES {
        let changes = [format!("run.t_end={t_end} s"), format!("parameters.T0={torque} N*m")];
        let scene = scene(file, &changes);
        let equations = equations(&scene);
        let pair = oh2005::GearPair::paper(0.05, torque);
        let start = pair.start(rpm);
        let by_hand = || {
            let pair = black_box(pair);
            let run = pair.solve_fast(start.theta, start.theta_dot, start.phi, start.phi_dot, t_end);
            let counts = [run.cell_changes as i64, run.reflections as i64, run.end_cell];
            End { counts, state: [run.end_local, run.end.theta_dot, run.end.phi, run.end.phi_dot] }
        };
        let reference = by_hand();
        let events = (reference.counts[0] + reference.counts[1]) as f64;
        // End states of all programs.
        let mut ends = vec![];
        for run in [&unrecorded as &dyn Fn(&mut Simulation<'_>), &recordable, &|s| without_rows(&scene, s)] {
            let mut simulation = prepare(&scene, &*equations);
            run(&mut simulation);
            ends.push(end(&simulation));
        }
        // Times of all programs, one after the other in each round.
        let mut times = [f64::INFINITY; 6];
        let mut c_end = None;
        for _ in 0..ROUNDS {
            if let Some(program) = c {
                let (end, ns) = run_c(program, rpm, torque, t_end, events);
                (times[0], c_end) = (times[0].min(ns * events), Some(end));
            }
            let new = || prepare(&scene, &*equations);
            let taken = [
                least(
                    || (),
                    |()| {
                        black_box(by_hand());
                    },
                ),
                least(new, unrecorded),
                least(new, recordable),
                least(new, |s| without_rows(&scene, s)),
                least(|| (), |()| drop(black_box(new()))),
            ];
            times[1..].iter_mut().zip(taken).for_each(|(time, taken)| *time = time.min(taken));
        }
        let rows = [
            ("C, gcc -O3", c_end),
            ("Rust by hand", Some(reference)),
            ("gearsim, unrecorded", Some(ends[0])),
            ("gearsim, recordable", Some(ends[1])),
            ("gearsim, recorded, no rows", Some(ends[2])),
        ];
        for (i, (program, end)) in rows.into_iter().enumerate() {
            let Some(end) = end else { continue };
            let difference = apart(&pair, rpm, &end, &reference);
            assert_eq!(end.counts, reference.counts, "{name}, {program}: not the same events");
            assert!(difference < TOLERANCE, "{name}, {program}: end states differ by {difference:e}");
            let beside = c_end.map_or(String::new(), |_| format!("{:.2}", times[i] / times[0]));
            let preparation = if i < 2 { String::new() } else { format!("{:.1}", times[5] / 1e3) };
            let each = times[i] / events;
            println!("| {name} | {program} | {each:.1} | {beside} | {events} | {difference:.1e} | {preparation} |");
        }
        base = base.or(c_end.map(|_| times[0] / events));
    }
    println!("\nAll programs have the same cell changes and reflections, and end states within {TOLERANCE:e}.\n");
    base
}

/// Prints the table of batches. `c` is the time per event of the C program at 4500 rpm [ns].
fn batches(c: Option<f64>) {
    println!(
        "| scenes, {EVENTS} events each | whole batch, ns an event | beside C | lanes alone, ns an event | beside C |"
    );
    println!("| --- | --- | --- | --- | --- |");
    let entry = Entry::new::<GearPair>();
    let one = |i: usize, of: usize| {
        let (part, rpm) = (i as f64 / of as f64, 4000.0 + 1280.0 * i as f64 / of as f64);
        let changes = [
            format!("run.t_end={} s", EVENTS * 60.0 / (2.0 * 24.0 * rpm)),
            format!("parameters.T0={} N*m", 5.0 + 12.8 * part),
            format!("start.speed={rpm} rpm"),
        ];
        scene("spectrum_4500rpm_exact", &changes)
    };
    for size in BATCHES {
        let scenes: Vec<Scene> = (0..size).map(|i| one(i, size)).collect();
        let all: Vec<_> = scenes.iter().map(|scene| (scene, equations(scene))).collect();
        let (mut whole, mut lanes, mut events) = (f64::INFINITY, f64::INFINITY, 0);
        for _ in 0..ROUNDS {
            let start = Instant::now();
            let outcomes = entry.ends(black_box(&scenes));
            whole = whole.min(start.elapsed().as_nanos() as f64);
            let outcomes = outcomes.into_iter().map(|outcome| outcome.expect("the scene is sound"));
            events = outcomes.map(|outcome| outcome.counts.events()).sum();
            let mut simulations: Vec<_> = all.iter().map(|(scene, e)| prepare(scene, &**e)).collect();
            let start = Instant::now();
            assert!(ensemble::run(black_box(&mut simulations)).iter().all(Result::is_ok));
            lanes = lanes.min(start.elapsed().as_nanos() as f64);
            assert_eq!(simulations.iter().map(|s| s.now.counts.events()).sum::<u64>(), events, "not the same events");
        }
        let [whole, lanes] = [whole, lanes].map(|time| time / events as f64);
        let beside = |time: f64| c.map_or(String::new(), |c| format!("{:.2}", time / c));
        println!("| {size} | {whole:.1} | {} | {lanes:.1} | {} |", beside(whole), beside(lanes));
    }
}
