//! Processor time of a run, measured as in tests/peers/clock.py.

use cpu_time::ProcessTime;
use serde_json::{Value, json};

use crate::scene::Motion;

/// Largest number of samples.
const SAMPLES: usize = 5;
/// A sample repeats the run until this time has passed [s], because on a busy machine the clock advances in steps of 4 ms.
const SAMPLE: f64 = 0.2;
/// Total processor time [s] after which no further sample is taken, if there are at least three.
const ENOUGH: f64 = 1.0;
/// A run that takes longer than this [s] is not repeated.
const LONG: f64 = 3.0;

/// Solves several times. Returns the last result with the times [s] in `cpu`.
pub fn measure(solve: impl Fn() -> anyhow::Result<Motion>) -> anyhow::Result<Value> {
    let (mut times, mut total): (Vec<f64>, f64) = (vec![], 0.0);
    loop {
        let (begun, mut runs, mut took, mut motion) = (ProcessTime::now(), 0.0, 0.0, None);
        while took < SAMPLE {
            motion = Some(solve()?);
            (runs, took) = (runs + 1.0, begun.elapsed().as_secs_f64());
        }
        times.push(took / runs);
        total += took;
        let repeated = times.len() >= 3 && (total > ENOUGH || times.len() == SAMPLES);
        if let Some(motion) = motion.filter(|_| repeated || times[0] > LONG) {
            let mut result = motion.json();
            (result["prepare"], result["cpu"]) = (json!(0.0), json!(times));
            return Ok(result);
        }
    }
}
