//! Processor time of child processes.

use anyhow::Context;

/// User and system time of all child processes that have ended, and of their child processes [s], each in steps of 0.01 s.
///
/// # Errors
/// If the system does not report it: only Linux does.
pub fn of_children() -> anyhow::Result<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat")
        .context("cannot read /proc/self/stat: processor times of child processes are measured on Linux only")?;
    // The second field, the name of the program, may hold spaces; it ends with a bracket.
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or("").split_whitespace().collect();
    // Fields 16 (cutime) and 17 (cstime) in proc(5), in ticks of 1/100 s; the first one here is field 3.
    let ticks = |i: usize| fields.get(i - 3).and_then(|field| field.parse::<f64>().ok());
    let sum = ticks(16).zip(ticks(17)).map(|(user, system)| (user + system) / 100.0);
    sum.context("/proc/self/stat does not hold the processor times of child processes")
}
