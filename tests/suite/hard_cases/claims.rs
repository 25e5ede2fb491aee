//! The number of correct digits that a run claims to have left, compared with the true number, for random gear pairs. The true number
//! follows from a run in 50 digits.
//!
//! A quarter of the scenes run five times as long, so that some lose all their digits. GEARSIM_SCENES sets their number, GEARSIM_SEED
//! selects others.

use std::sync::OnceLock;

use gearsim::__private::{digits, error};
use gearsim_tests::precise::scene::scene;

use crate::case::Case;
use crate::common;
use crate::noise::setting;
use crate::pair;
use crate::scenes::compare::until_pressed;
use crate::scenes::draw;

pub const CASES: &[Case] = &[
    Case {
        row: "random",
        name: "digits that a run claims to have left and does not have",
        proves: "999 of 1,000 claims exceed the truth by at most one digit",
        tolerance: 1.0,
        unit: "digits",
        reason: "the estimate is the distance to one other run, which may be close by chance",
        measure: |note| {
            let Sum { scenes, lost, claims } = sum();
            let largest = claims.last().copied().unwrap_or(f64::NAN);
            *note = format!(
                "{scenes} scenes, {lost} of them with less than one digit left; the largest excess is {largest:.1}"
            );
            claims[claims.len() - 1 - claims.len() / 1000]
        },
    },
    Case {
        row: "random",
        name: "digits that a run has left and does not claim",
        proves: "the median over all runs: an estimate that claims too little would always be safe",
        tolerance: 3.0,
        unit: "digits",
        reason: "one digit is a margin, because the two runs may be close by chance; the start and the parameters are moved by four rounding errors",
        measure: |note| {
            let Sum { scenes, claims, .. } = sum();
            *note = format!("{scenes} scenes");
            -claims[claims.len() / 2]
        },
    },
];

#[derive(Default)]
struct Sum {
    scenes: u64,
    lost: u64,
    /// Claimed digits minus true digits, rising.
    claims: Vec<f64>,
}

/// Number of samples of a run. The claim uses the largest distance of the two runs in the last samples. At the end state alone, two runs are
/// more often close by chance.
const SAMPLES: f64 = 100.0;

/// The number of digits of an f64. More are neither claimed nor counted.
const MOST: f64 = 15.95;

fn sum() -> &'static Sum {
    static SUM: OnceLock<Sum> = OnceLock::new();
    SUM.get_or_init(|| {
        let mut sum = Sum { scenes: setting("GEARSIM_SCENES", 1000), ..Sum::default() };
        for i in 0..sum.scenes {
            let (pair, start, t_end) = draw(i);
            let t_end = if i % 4 == 3 { 5.0 * t_end } else { t_end };
            let t_end = until_pressed(&pair::run(&pair, &start, t_end).events, pair.w0()).unwrap_or(t_end);
            let exact = scene(&pair, &start, t_end, 50).end;
            let mut scene = pair::scene(&pair, &start, t_end);
            scene.output.rate = SAMPLES / t_end;
            let run = |scene: &_| common::model("gear_pair").run(scene, &mut |_| {});
            let outcome = digits::noted(&scene, run(&scene).expect("a sound scene"), &run);
            let claimed = outcome.digits.expect("a companion that runs").at_end;
            let (q, v) = error::sizes(&outcome.trajectory);
            let run = &outcome.trajectory;
            let columns = [&run.q[0], &run.q_dot[0], &run.q[1], &run.q_dot[1]];
            let exact = [exact.theta, exact.theta_dot, exact.phi, exact.phi_dot];
            let each = columns.iter().zip(exact).zip([q[0], v[0], q[1], v[1]]);
            let off = each.map(|((x, exact), size)| ((x[x.len() - 1] - exact.0) - exact.1).abs() / size);
            let there = (-off.fold(f64::MIN_POSITIVE, f64::max).log10()).clamp(0.0, MOST);
            sum.lost += u64::from(there < 1.0);
            if claimed - there > 0.9 {
                println!("scene {i}: {claimed:.1} digits claimed, {there:.1} true; {pair:?} {start:?} until {t_end:e}");
            }
            sum.claims.push(claimed - there);
        }
        sum.claims.sort_by(f64::total_cmp);
        sum
    })
}
