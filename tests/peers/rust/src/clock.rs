//! Processor time of a run, as tests/peers/clock.py takes it.

use cpu_time::ProcessTime;
use serde_json::{Value, json};

use crate::scene::Motion;

/// Times taken at most.
const SAMPLES: usize = 5;
/// A sample runs again until it has taken as long [s]: on a busy machine the clock advances by ticks of 4 ms.
const SAMPLE: f64 = 0.2;
/// Processor time after which no further sample is begun, once there are three [s].
const ENOUGH: f64 = 1.0;
/// A run that takes as long is not repeated [s].
const LONG: f64 = 3.0;

/// Solves several times: what the last run gave, with the times in `cpu`.
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
