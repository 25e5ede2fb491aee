//! Row 4: events at t = 0, at the horizon of a search, and one bit apart.

use gearsim::__private::Side;
use gearsim::scene::Step;
use gearsim_tests::oh2005::{GearPair, PITCH};

use crate::case::{Case, NONE, WRONG, count, largest};
use crate::linear::{Linear, Met, first_from};
use crate::noise::Noise;
use crate::pair::{self, distance};

pub const CASES: &[Case] = &[
    Case {
        row: "4",
        name: "start on a boundary",
        proves: "moving outwards, or at rest and accelerated outwards: one event, at t = 0; inwards: none there",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: starts,
    },
    Case {
        row: "4",
        name: "horizon at a crossing, and one bit after it",
        proves: "a crossing at the horizon is not found; with the horizon one bit later it is",
        tolerance: 0.0,
        unit: WRONG,
        reason: NONE,
        measure: horizons,
    },
    Case {
        row: "4",
        name: "two boundaries one bit apart",
        proves: "both are events, one after the other: three events per pitch instead of two, and the same motion",
        tolerance: 1e-12,
        unit: "of the motion's sizes",
        reason: "the two steps add up to the step that they replace; infinite if an event is lost",
        measure: bits_apart,
    },
];

fn starts(_: &mut String) -> f64 {
    // x'' = f from x = 0, in a cell with one boundary at 0; the other one is 1 away.
    let from = |v: f64, f: f64, upper: bool| {
        let gaps = if upper { [1.0, 0.0] } else { [0.0, 1.0] };
        let Met { side, t, .. } = first_from(&Linear::modal([(0.0, 0.0)], [f]), [v], gaps, 10.0);
        side.map(|side| (side == Side::Upper, t))
    };
    let swing = |v: f64, upper: bool| {
        let gaps = if upper { [9.0, 0.0] } else { [0.0, 9.0] };
        let met = first_from(&Linear::modal([(0.0, 1.0)], [0.0]), [v], gaps, 3.0);
        met.side.map(|side| (side == Side::Upper, met.t))
    };
    count([true, false].into_iter().flat_map(|upper| {
        let out = if upper { 1.0 } else { -1.0 };
        [
            from(out, 0.0, upper) != Some((upper, 0.0)),
            from(1e-300 * out, 0.0, upper) != Some((upper, 0.0)),
            from(0.0, out, upper) != Some((upper, 0.0)),
            swing(out, upper) != Some((upper, 0.0)),
            // to the other boundary
            from(-out, 0.0, upper) != Some((!upper, 1.0)),
            from(0.0, -2.0 * out, upper) != Some((!upper, 1.0)),
            // there and back to this one
            from(-out, 2.0 * out, upper) != Some((upper, 1.0)),
            // in, but not back within half a turn
            swing(-out, upper).is_some(),
            // at rest and not pushed
            from(0.0, 0.0, upper).is_some(),
        ]
    }))
}

fn horizons(_: &mut String) -> f64 {
    let mut noise = Noise::new(401);
    count((0..1000).flat_map(|_| {
        let (v, omega2) = (noise.even(), if noise.unit() < 0.5 { 0.0 } else { noise.power(-1.0, 1.0) });
        let system = Linear::modal([(0.0, omega2)], [0.0]);
        let gap = 0.3 * v.abs();
        let until = |horizon: f64| first_from(&system, [v], [gap, gap], horizon);
        let met = until(100.0);
        let (at, after) = (until(met.t), until(met.t.next_up()));
        [met.side.is_none(), at.side.is_some(), after.side != met.side || after.t != met.t]
    }))
}

fn bits_apart(note: &mut String) -> f64 {
    let mut events = 0;
    let worst = largest([60.0, -1000.0].map(|rpm| {
        let pair = GearPair { width1: 1.75, ..GearPair::paper(0.05, 3.0) };
        let start = pair.start(rpm);
        let plain = pair::scene(&pair, &start, 30.0 / start.theta_dot.abs());
        let mut split = plain.clone();
        let (width, thin) = (pair.width1, pair.width1.next_up() - pair.width1);
        let steps = [(pair.k1, width), (2000.0, thin), (pair.k2, PITCH - width - thin)];
        split.laws[0].steps = steps.map(|(value, width)| Step { value, width }).into();
        let [one, two] = [&plain, &split].map(pair::of);
        let [c1, c2] = [&one, &two].map(|run| &run.outcome.counts);
        events += c2.cell_changes;
        // Every other boundary that is passed is doubled.
        let doubled = c1.cell_changes.div_ceil(2)..=c1.cell_changes.div_ceil(2) + 1;
        if c1.reflections + c2.reflections > 0 || !doubled.contains(&(c2.cell_changes - c1.cell_changes + 1)) {
            println!("{c1:?} {c2:?}");
            return f64::INFINITY;
        }
        distance(&one.end, &two.end, &pair, start.theta_dot)
    }));
    *note = format!("{events} events");
    worst
}
