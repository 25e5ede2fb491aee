//! Row 4: steps that are met at the same time, of one phase and of two phases.

use gearsim::run::{Entry, Outcome};

use crate::case::{Case, NONE, WRONG, count, largest};
use crate::models::{end, meshes::Meshes, residual, run, twice::Twice};

pub const CASES: &[Case] = &[
    Case {
        row: "4",
        name: "two meshes that step at the same time: their order",
        proves: "not ambiguous without coupling by inertia; with coupling the run counts it; each mesh is passed once and the energy is kept",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: |_| orders(),
    },
    Case {
        row: "4",
        name: "two meshes that step at the same time, exchanged",
        proves: "without coupling the result does not depend on which mesh comes first",
        tolerance: 8.0,
        unit: "eps of the motion's sizes",
        reason: "the stiffnesses and dV are summed in another order: some rounding errors in two cells",
        measure: |_| exchanged(),
    },
    Case {
        row: "4",
        name: "two stiffnesses that step at one place",
        proves: "they act as one stiffness, whether they step in the same direction or in opposite ones: the same events, the same end",
        tolerance: 1e-12,
        unit: "rad, rad/s",
        reason: "sizes of 1, about twenty events; infinite if an event differs or energy is lost",
        measure: |_| one_place(),
    },
];

const MESHES: Entry = Entry::new::<Meshes>();
const TWICE: Entry = Entry::new::<Twice>();

/// Steps of both meshes are met at t = 0.2 s and passed. The inertia `mu` couples the two rotors.
fn meet(mu: f64, k: [f64; 2], l: [f64; 2]) -> Outcome {
    let text = format!(
        r#"
        model = "meshes"
        effects = ["stiffness_step"]
        parameters.mu = "{mu:?} kg*m^2"
        start.alpha_dot = "2 rad/s"
        start.gamma_dot = "2 rad/s"
        laws.k.steps = [{{ value = "{:?} N*m", width = "0.4 rad" }}, {{ value = "{:?} N*m" }}]
        laws.l.steps = [{{ value = "{:?} N*m", width = "0.4 rad" }}, {{ value = "{:?} N*m" }}]
        run.t_end = "0.3 s"
        "#,
        k[0], k[1], l[0], l[1]
    );
    run(&MESHES, &text)
}

fn orders() -> f64 {
    count([(0.0, 0), (0.5, 1), (-0.5, 1)].map(|(mu, ambiguous)| {
        let outcome = meet(mu, [5.0, 8.0], [3.0, 6.0]);
        (outcome.counts.ambiguous, outcome.counts.cell_changes) != (ambiguous, 2) || residual(&outcome) > 1e-14
    }))
}

fn exchanged() -> f64 {
    let [one, other] = [([5.0, 8.0], [3.0, 7.0]), ([3.0, 7.0], [5.0, 8.0])].map(|(k, l)| end(&meet(0.0, k, l)));
    let places = [(0, 1), (1, 0), (2, 2)];
    largest(places.into_iter().flat_map(|(i, j)| {
        [(one.0[i] - other.0[j]).abs(), (one.1[i] - other.1[j]).abs() / 2.0].map(|x| x / f64::EPSILON)
    }))
}

fn one_place() -> f64 {
    let scene = |k: [f64; 2], l: [f64; 2], speed: f64| {
        format!(
            r#"
            model = "twice"
            effects = ["stiffness_step"]
            start.alpha_dot = "{speed:?} rad/s"
            start.beta_dot = "0.1 rad/s"
            laws.k.steps = [{{ value = "{:?} N*m", width = "0.4 rad" }}, {{ value = "{:?} N*m" }}]
            laws.l.steps = [{{ value = "{:?} N*m", width = "0.4 rad" }}, {{ value = "{:?} N*m" }}]
            run.t_end = "10 s"
            "#,
            k[0], k[1], l[0], l[1]
        )
    };
    let steps = [([5.0, 8.0], [1.0, 4.0]), ([5.0, 8.0], [9.0, 7.0]), ([5.0, 8.0], [9.0, 2.0])];
    largest([2.0, 0.5, -2.0].into_iter().flat_map(|speed| steps.map(|(k, l)| (speed, k, l))).map(|(speed, k, l)| {
        let both = run(&TWICE, &scene(k, l, speed));
        let sum = run(&TWICE, &scene([k[0] + l[0], k[1] + l[1]], [0.0, 0.0], speed));
        let [(here, turned), (there, back)] =
            [&both, &sum].map(|outcome| (outcome.counts.cell_changes, outcome.counts.reflections));
        let lost = both.energy_at_start * residual(&both) > 1e-14 * both.energy_at_start.max(1.0);
        if (here, turned) != (there, back) || here + turned <= 5 || lost {
            println!("{:?}, not {:?}", both.counts, sum.counts);
            return f64::INFINITY;
        }
        let ((q, v), (q_sum, v_sum)) = (end(&both), end(&sum));
        largest(q.iter().chain(&v).zip(q_sum.iter().chain(&v_sum)).map(|(a, b)| (a - b).abs()))
    }))
}
