//! The results of a soak run: a table, the same as JSON, and a plot of the energy error.

use gearsim::plot::{Axis, Figure, Panel, Series, Style};
use serde_json::json;

use crate::growth::{Growth, LIMIT};
use crate::walk::Walk;

/// The table, as Markdown.
pub fn markdown(walk: &Walk, growth: &Growth, command: &str) -> String {
    let events = walk.total();
    let rows = [
        ("events", format!("{events}, of which {} reflections", walk.reflections)),
        ("model time", format!("{:.6} s", walk.model_time)),
        (
            "largest error of T + V - W, relative to T + V at the start",
            format!("{:.2e} (limit {LIMIT:e})", growth.largest),
        ),
        ("growth of the error over m events", format!("m^{:.2} (random walk: 0.5, bias: 1)", growth.exponent)),
        ("standard deviation per event", format!("{:.1e}", growth.step)),
        ("mean change per event", format!("{:.1e}", growth.bias)),
        ("error at the end", format!("{:.1} standard deviations from zero", growth.deviations)),
        ("elapsed time", format!("{:.1} s, {:.0} ns per event", walk.elapsed.as_secs_f64(), nanoseconds(walk))),
        ("verdict", verdict(growth)),
    ];
    let mut text =
        format!("# Energy over {events:.1e} events\n\n`{command}`\n\n| | |\n| --- | --- |\n", events = events as f64);
    for (what, value) in rows {
        text += &format!("| {what} | {value} |\n");
    }
    text + "\n![Energy error over events](energy.svg)\n"
}

/// `holds`, or the faults.
fn verdict(growth: &Growth) -> String {
    let faults = growth.faults();
    if faults.is_empty() { "holds".into() } else { faults.join("; ") }
}

/// The same results as JSON, with samples at increasing distances.
pub fn json(walk: &Walk, growth: &Growth, command: &str) -> serde_json::Value {
    let samples: Vec<_> = walk.spread().map(|i| json!([walk.events[i], walk.error[i]])).collect();
    json!({
        "command": command,
        "events": walk.total(),
        "reflections": walk.reflections,
        "model_time_s": walk.model_time,
        "limit": LIMIT,
        "growth": growth.json(),
        "faults": growth.faults(),
        "nanoseconds_per_event": nanoseconds(walk),
        "events_and_error": samples,
    })
}

/// The error over the number of events, with the limit and the standard deviation of a random walk.
pub fn figure(walk: &Walk, growth: &Growth) -> Figure {
    let n: Vec<f64> = walk.events.iter().map(|n| *n as f64).collect();
    let line = |f: &dyn Fn(f64) -> f64| n.iter().map(|n| f(*n)).collect::<Vec<_>>();
    let size = walk.error.iter().map(|e| e.abs()).collect();
    let random_walk = line(&|n| growth.step * n.sqrt());
    let limit = Series { style: Style::PLAIN, ..Series::new(0, "limit", n.clone(), line(&|_| LIMIT)) };
    let series = vec![
        Series::new(0, "|error|", n.clone(), size),
        Series::new(1, "standard deviation of a random walk", n, random_walk),
        limit,
    ];
    Figure {
        title: "Energy of an undamped, aperiodic gear pair".into(),
        subtitle: Some(format!("{} events, {} of them reflections", walk.total(), walk.reflections)),
        x: Axis::log10("events", ""),
        panels: vec![Panel { y: Axis::log10("error of T + V − W, relative to T + V at the start", ""), series }],
    }
}

fn nanoseconds(walk: &Walk) -> f64 {
    1e9 * walk.elapsed.as_secs_f64() / walk.total() as f64
}
