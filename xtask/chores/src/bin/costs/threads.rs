//! The gain of a second core: elapsed times of the same sweeps on one thread and on two.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

use gearsim::__private::{Request, Sweep};

/// A sweep on one thread and on two.
pub struct Gain {
    pub what: &'static str,
    pub points: usize,
    /// Elapsed time on one thread and on two [s].
    pub elapsed: [f64; 2],
}

/// Repetitions of each sweep, alternately on one thread and on two; the time is that of the fastest.
const TURNS: usize = 5;

/// Measures a sweep that records only the final states, which runs in SIMD lanes, and one that needs samples.
///
/// # Errors
/// If one does not run.
pub fn all() -> anyhow::Result<Vec<Gain>> {
    let sweeps: [(_, &[&str]); 2] = [
        ("state at the end only, in SIMD lanes", &["events", "state"]),
        ("extremes over the samples", &["events", "extremes"]),
    ];
    sweeps.into_iter().map(|(what, record)| gain(what, record)).collect()
}

fn gain(what: &'static str, record: &[&str]) -> anyhow::Result<Gain> {
    let points = if record.contains(&"extremes") { 400 } else { 12_000 };
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/scenes/oh2005/spectrum_4500rpm_exact.toml");
    let request = Request {
        vary: vec![format!("parameters.T0=1 N*m:50 N*m:{points}")],
        overrides: vec!["run.t_end=0.1 s".into(), "output.rate=50 kHz".into()],
        record: record.iter().map(|name| name.to_string()).collect(),
        ..Request::default()
    };
    let sweep = Sweep::load(Path::new(scene), gearsim::models(), &request)?;
    let all: Vec<usize> = (0..points).collect();
    let mut elapsed = [f64::INFINITY; 2];
    for _ in 0..TURNS {
        for (threads, least) in (1..).zip(&mut elapsed) {
            let begun = Instant::now();
            sweep.run(
                &all,
                NonZeroUsize::new(threads).unwrap_or(NonZeroUsize::MIN),
                |_| Ok(()),
                |_| ControlFlow::Continue(()),
            )?;
            *least = least.min(begun.elapsed().as_secs_f64());
        }
    }
    eprintln!("sweep, {what}: {elapsed:?}");
    Ok(Gain { what, points, elapsed })
}
