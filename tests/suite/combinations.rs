//! Every effect with every other: random scenes over models, sets of effects, numbers, methods and precisions. For each run the energy
//! account closes and all numbers are finite. A sweep gives the same bits as the run. Two halves end where the whole run ends. Another
//! method gives the same motion. A scene that cannot be run is refused with a message.
//!
//! `COMBINATIONS=N` runs N scenes instead of 1,000, `COMBINATIONS_FROM=I` begins with scene I: `cargo xtask combinations`. The command of
//! a single scene is shown before it runs.
//!
//! Scenes 0 to 99,999 have been run, in parts of 500: `COMBINATIONS_FROM=I COMBINATIONS=500`. With the present scenes of `models/scenes`
//! scenes 0 to 999, 9,500 to 15,499, 20,000 to 28,499 and 60,000 to 60,999 have been run.

#[path = "combinations/checks.rs"]
mod checks;
mod common;
#[path = "two_methods/compare.rs"]
mod compare;
#[path = "combinations/draw.rs"]
mod draw;
#[path = "common/effects.rs"]
mod effects;
#[path = "common/random.rs"]
mod random;

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use checks::{CHECKS, Checked};

/// A check that takes longer than this is printed with its scene.
const SLOW: Duration = Duration::from_secs(10);

/// A number from the environment.
fn number(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).ok().map_or(otherwise, |text| text.parse().unwrap_or_else(|_| panic!("{name} is no number")))
}

#[test]
fn every_effect_works_with_every_other() {
    let (from, count) = (number("COMBINATIONS_FROM", 0), number("COMBINATIONS", 1000));
    let bases = draw::bases();
    let (next, found) = (AtomicU64::new(from), Mutex::new((BTreeMap::<String, u64>::new(), vec![])));
    let work = || loop {
        let case = next.fetch_add(1, Ordering::Relaxed);
        if case >= from + count {
            return;
        }
        let drawn = draw::case(&bases, case);
        if count == 1 {
            println!("{}", drawn.command());
        }
        for (name, check) in CHECKS {
            let begin = Instant::now();
            let checked = catch_unwind(AssertUnwindSafe(|| check(&drawn)));
            let checked = checked.unwrap_or_else(|_| Checked::Wrong("a panic".into()));
            let taken = begin.elapsed();
            if taken > SLOW {
                println!("scene {case}, {name}: {:.0} s\n{}", taken.as_secs_f64(), drawn.command());
            }
            let mut found = found.lock().unwrap();
            let said = match checked {
                Checked::Right => "right".to_owned(),
                Checked::Left(why) => format!("left out: {why}"),
                Checked::Wrong(why) => {
                    found.1.push(format!("scene {case}, {name}: {why}\n{}", drawn.command()));
                    "wrong".to_owned()
                }
            };
            *found.0.entry(format!("{name}: {said}")).or_default() += 1;
        }
    };
    std::thread::scope(|scope| {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        (0..threads).for_each(|_| drop(scope.spawn(work)));
    });
    let (counts, wrong) = found.into_inner().unwrap();
    counts.iter().for_each(|(what, n)| println!("{n:7}  {what}"));
    assert!(wrong.is_empty(), "{} of {count} scenes are wrong\n\n{}", wrong.len(), wrong.join("\n\n"));
    // A refusal is a valid result too, but most scenes must run.
    assert!(2 * counts.get("run: right").copied().unwrap_or(0) > count, "too few scenes ran");
}
