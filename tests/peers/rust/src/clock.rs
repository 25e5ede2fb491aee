//! Processor time of a run, as tests/peers/clock.py takes it.

use cpu_time::ProcessTime;
use serde_json::{Value, json};

use crate::scene::Motion;

/// Runs at most.
const SAMPLES: usize = 15;
/// Processor time after which no further run is begun, once there are three [s].
const ENOUGH: f64 = 1.0;
/// A run that takes as long is not repeated [s].
const LONG: f64 = 3.0;

/// Solves several times: what the last run gave, with the times in `cpu`.
pub fn measure(solve: impl Fn() -> anyhow::Result<Motion>) -> anyhow::Result<Value> {
    let mut times: Vec<f64> = vec![];
    loop {
        let begun = ProcessTime::now();
        let motion = solve()?;
        times.push(begun.elapsed().as_secs_f64());
        let repeated = times.len() >= 3 && (times.iter().sum::<f64>() > ENOUGH || times.len() == SAMPLES);
        if repeated || times[0] > LONG {
            let mut result = motion.json();
            (result["prepare"], result["cpu"]) = (json!(0.0), json!(times));
            return Ok(result);
        }
    }
}
