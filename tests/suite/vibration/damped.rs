//! Runs of a model whose damping couples its modes: flights, crossings, held contact, energy.

use gearsim::run::Outcome;
use gearsim::trajectory::Moment;
use gearsim_tests::precise::exponential::Exponential;
use gearsim_tests::precise::number::{Real, Scalar};

use crate::models::{DAMPERS, FIRST_ENDS, LEVELS, scene};

type Digits = Real<192>;

const J: f64 = 0.5;
const K: f64 = 20.0;

/// The cell with stiffness `k` in 50 digits.
pub fn cell(k: f64, c1: f64, c2: f64, torque: f64) -> Exponential<192> {
    let mass = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, J]];
    let damping = [[c1, -c1, 0.0], [-c1, c1, 0.0], [0.0, 0.0, c2]];
    Exponential::new(&mass, &damping, &[[0.0; 3], [0.0, k + K, -K], [0.0, -K, K]], &[torque, 0.0, 0.0])
}

fn run(more: &str) -> Outcome {
    let outcome = DAMPERS.run(&scene(more), &mut |_| {}).expect("a scene that can be simulated");
    assert!(outcome.stopped_by.is_none(), "{:?}", outcome.stopped_by);
    outcome
}

fn residual(outcome: &Outcome) -> f64 {
    outcome.trajectory.residual.iter().fold(0.0f64, |m, r| m.max(r.abs()))
}

/// Every flight between two events agrees with the matrix exponential, ends on a boundary and meets none before. Each event keeps the
/// energy. The energy account closes, with the loss as an integral of the speeds.
#[test]
fn every_flight_with_coupled_damping_agrees_with_the_matrix_exponential() {
    for (c1, c2, torque, speed, end) in [
        (0.05, 0.3, 0.1, 2.0, 12.0),
        (0.4, 0.0, 0.0, 2.0, 12.0),
        (0.0, 0.5, 0.0, 2.0, 12.0),
        (1.5, 20.0, 0.0, 30.0, 0.8),
    ] {
        let outcome = run(&format!(
            "parameters = {{ c1 = \"{c1:?} N*m*s\", c2 = \"{c2:?} N*m*s\", T = \"{torque:?} N*m\" }}\n\
             start = {{ speed = \"{speed:?} rad/s\", beta_dot = \"1 rad/s\" }}\nrun.t_end = \"{end:?} s\"\noutput.rate = \"1 Hz\""
        ));
        let t = &outcome.trajectory;
        let state = |row: usize| {
            let of = |columns: &[Vec<f64>]| columns.iter().map(|c| Digits::exact(c[row])).collect::<Vec<_>>();
            (of(&t.q), of(&t.q_dot))
        };
        let mut after = 0;
        let mut flights = 0;
        for row in 0..t.len() {
            if t.moment[row] == Moment::After {
                after = row;
            }
            if t.moment[row] != Moment::Before {
                continue;
            }
            flights += 1;
            let (q, v) = state(after);
            // Times are rounded to f64, so the states have an error of one rounding of t times the speeds and accelerations.
            let span = Digits::exact(t.t[row]) - Digits::exact(t.t[after]);
            let error = |level: usize| {
                let (x, y) = cell(LEVELS[level], c1, c2, torque).over(&span).of(&q, &v);
                let apart = |a: &[Digits], columns: &[Vec<f64>]| {
                    let each = a.iter().zip(columns).map(|(a, c)| (a.clone() - Digits::exact(c[row])).approx().abs());
                    each.fold(0.0, f64::max)
                };
                apart(&x, &t.q).max(apart(&y, &t.q_dot))
            };
            let level = if error(0) < error(1) { 0 } else { 1 };
            assert!(error(level) < 2e-12, "{:e} at t = {}", error(level), t.t[row]);
            // The cell of the flight within the turn; the flight must stay in it.
            let turn = (0.5 * (t.q[0][after] + t.q[0][row])).floor();
            let turns = [turn - 1.0, turn, turn + 1.0];
            let bounds = |turn: f64| [(turn, turn + FIRST_ENDS), (turn + FIRST_ENDS, turn + 1.0)][level];
            let within = |x: f64, (low, high): (f64, f64)| x > low - 1e-12 && x < high + 1e-12;
            let here = turns.map(bounds).into_iter().find(|b| within(t.q[0][after], *b) && within(t.q[0][row], *b));
            let (low, high) = here.unwrap_or_else(|| panic!("row {row} ends a flight from another cell"));
            let end = t.q[0][row];
            assert!((end - low).abs() < 1e-12 || (end - high).abs() < 1e-12, "{end} is on no boundary");
            let step = cell(LEVELS[level], c1, c2, torque).over(&span.over(9));
            let (mut x, mut y) = (q, v);
            for _ in 0..8 {
                (x, y) = step.of(&x, &y);
                assert!(within(x[0].approx(), (low, high)), "left its cell before t = {}", t.t[row]);
            }
            let energy = |row: usize| t.kinetic[row] + t.strain[row];
            assert!((energy(row + 1) - energy(row)).abs() < 1e-13 * outcome.energy_at_start.max(energy(row)));
        }
        println!("c1 = {c1}, c2 = {c2}: {flights} flights, {:e} J unaccounted for", residual(&outcome));
        assert!(flights > 10, "{flights} flights");
        assert!(residual(&outcome) < 1e-13 * outcome.energy_at_start.max(t.dissipated[t.len() - 1]));
        assert!(t.dissipated.windows(2).all(|w| w[1] >= w[0]), "the dissipated energy falls");
    }
}

/// The first rotor is pressed against a step that reflects it, bounces and is held. The other two rotors come to rest by dampers that
/// couple them.
#[test]
fn a_phase_is_held_while_coupled_damping_stops_the_other_rotors() {
    let outcome = run("parameters = { c1 = \"2 N*m*s\", c2 = \"0.7 N*m*s\", T = \"3 N*m\", load = \"10 N*m\" }\n\
         start = { beta = \"2 rad\", gamma = \"2.2 rad\" }\nrun.t_end = \"120 s\"\noutput.rate = \"1 Hz\"");
    let t = &outcome.trajectory;
    let last = t.len() - 1;
    println!("{} bounces, {:e} J unaccounted for", outcome.counts.reflections, residual(&outcome));
    assert!(outcome.counts.holds >= 1 && outcome.counts.cell_changes == 0, "{:?}", outcome.counts);
    assert_eq!((t.q[0][last], t.q_dot[0][last]), (FIRST_ENDS, 0.0));
    for i in [1, 2] {
        // beta = gamma = load/k, with no force between the two. The slowest mode of the held cell decays faster than 0.4/s.
        assert!(
            (t.q[i][last] - 2.0).abs() < 1e-12 && t.q_dot[i][last].abs() < 1e-12,
            "{} {}",
            t.q[i][last],
            t.q_dot[i][last]
        );
    }
    assert!(residual(&outcome) < 1e-12 * outcome.energy_at_start, "{:e}", residual(&outcome));
}
