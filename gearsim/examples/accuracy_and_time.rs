//! Runs a scene by a numerical method at several tolerances; prints the error against the exact solution, and the steps it took.
//!
//! `cargo run --release --example accuracy_and_time`, from the root of the repository.

use gearsim::{Error, Scene};

fn main() -> Result<(), Error> {
    for (tolerance, error, steps) in errors("models/scenes/oh2005/spectrum_4500rpm_exact.toml", &[1e-4, 1e-7, 1e-10])? {
        println!("tolerance {tolerance:.0e}: error {error:.1e} of the largest phi, {steps} steps");
    }
    Ok(())
}

/// For each tolerance: the tolerance, the largest error of phi in the first 20 ms relative to the largest phi, and the number of steps.
pub fn errors(path: &str, tolerances: &[f64]) -> Result<Vec<(f64, f64, u64)>, Error> {
    // Samples only, so that the rows of all runs are at the same times.
    let scene = Scene::load(path)?.with("run.t_end", "20 ms")?.with("output.events", false)?;
    let exact = scene.run()?.column("phi")?;
    let largest = exact.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let by_steps = scene.with("run.method", "dop853")?;
    let error = |&tolerance: &f64| {
        let results = by_steps.with("run.tolerance", tolerance)?.run()?;
        let differences = results.column("phi")?.into_iter().zip(&exact).map(|(x, exact)| (x - exact).abs());
        Ok((tolerance, differences.fold(0.0, f64::max) / largest, results.outcome.solver.steps))
    };
    tolerances.iter().map(error).collect()
}
