//! The crate ivp, a Rust version of SciPy's solve_ivp, restarted at terminal events.
//!
//! For a fair comparison: two events with directions, no dense output, absolute tolerances proportional to the sizes of the coordinates.

use anyhow::{anyhow, bail};
use ivp::prelude::*;

use crate::scene::{Motion, Scene};

/// A cell as a system of the crate.
struct Cell<'a> {
    scene: &'a Scene,
    k: f64,
    width: f64,
}

impl FirstOrderSystem for Cell<'_> {
    fn derivative(&self, _t: f64, y: &[f64], out: &mut [f64]) {
        self.scene.slope(self.k, y, out);
    }

    fn events(&self, _t: f64, y: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[y[0] - self.width, y[0]]);
    }

    fn n_events(&self) -> usize {
        2
    }

    fn event_config(&self, index: usize) -> EventConfig {
        let direction = if index == 0 { Direction::Positive } else { Direction::Negative };
        EventConfig { direction, terminal_count: Some(1) }
    }
}

/// A whole run.
pub fn run(scene: &Scene, method: Method, tolerance: f64) -> anyhow::Result<Motion> {
    let mut motion = scene.begin();
    loop {
        let (k, width) = scene.cell(motion.cell);
        let cell = Cell { scene, k, width };
        let solution = Ivp::first_order(&cell, motion.t, scene.t_end, &motion.y)
            .method(method)
            .rtol(tolerance)
            .atol(scene.atol(tolerance))
            .max_steps(10_000_000)
            .solve()
            .map_err(|error| anyhow!("{error:?}"))?;
        let met = (0..2).find(|&i| !solution.t_events[i].is_empty());
        if let Some(i) = met {
            motion.jump(scene, solution.t_events[i][0], &solution.y_events[i][0], i == 0);
            continue;
        }
        let (Some(t), Some(y)) = (solution.t.last(), solution.y.last()) else { bail!("no solution") };
        if *t < scene.t_end {
            bail!("stopped at {t} s: {:?}", solution.status);
        }
        motion.y.copy_from_slice(y);
        return Ok(motion);
    }
}
