//! Row 4: runs that end at an event, and runs that are split into two parts.

use std::sync::OnceLock;

use gearsim_tests::oh2005::{GearPair, State};

use crate::case::{Case, NONE, WRONG, count, largest};
use crate::noise::Noise;
use crate::pair::{self, distance};

pub const CASES: &[Case] = &[
    Case {
        row: "4",
        name: "runs that end at an event, 4 bits before, 4 bits after",
        proves: "an event is in the run if and only if its time is in it",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: ends,
    },
    Case {
        row: "4",
        name: "runs split at a thousand random times and at 40 events",
        proves: "the events of the parts are those of the whole",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: |_| splits().0,
    },
    Case {
        row: "4",
        name: "ends of split runs",
        proves: "two parts end in the same state as the whole run",
        tolerance: 1e-12,
        unit: "of the motion's sizes",
        reason: "the motion is regular: the rounding errors of 40 events only add up",
        measure: |_| splits().1,
    },
];

/// Length of the run [s]: a regular motion with about 40 events.
const T_END: f64 = 0.05;

fn regular() -> (GearPair, State) {
    let pair = GearPair::paper(0.05, 10.0);
    (pair, pair.start(1000.0))
}

fn ends(note: &mut String) -> f64 {
    let (pair, start) = regular();
    let whole = pair::run(&pair, &start, T_END).events;
    *note = format!("{} events", whole.len());
    count(whole.iter().enumerate().flat_map(|(i, event)| {
        let moved = |bits: i64| f64::from_bits((event.t.to_bits() as i64 + bits) as u64);
        let events = |t: f64| pair::run(&pair, &start, t).events.len();
        // With the end at the event itself both counts are right, because its time is known only to a bit.
        [events(moved(-4)) != i, events(moved(4)) != i + 1, !(i..=i + 1).contains(&events(event.t))]
    }))
}

/// The number of splits that lose or repeat an event, and the largest difference of the ends.
fn splits() -> (f64, f64) {
    static SPLITS: OnceLock<(f64, f64)> = OnceLock::new();
    *SPLITS.get_or_init(split)
}

fn split() -> (f64, f64) {
    let (pair, start) = regular();
    let whole = pair::run(&pair, &start, T_END);
    let mut noise = Noise::new(402);
    let instants: Vec<f64> = (0..1000).map(|_| T_END * noise.unit()).chain(whole.events.iter().map(|e| e.t)).collect();
    let speed = start.theta_dot;
    let (mut wrong, mut apart) = (0.0, 0.0);
    for t in instants {
        let first = pair::run(&pair, &start, t);
        let second = pair::run(&pair, &first.end, T_END - t);
        if first.events.len() + second.events.len() != whole.events.len() {
            let theta = first.end.theta;
            println!("split at {t}, theta = {theta:?}: {} + {} events", first.events.len(), second.events.len());
            wrong += 1.0;
            continue;
        }
        let here = distance(&second.end, &whole.end, &pair, speed);
        if here > 1e-9 {
            println!("split at {t}: {:?} goes on to {:?}, not {:?}", first.end, second.end, whole.end);
        }
        apart = largest([apart, here]);
    }
    (wrong, apart)
}
