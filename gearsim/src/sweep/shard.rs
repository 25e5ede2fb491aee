//! A part of a sweep for one machine: shard i of n has every n-th point, from the i-th on.

use std::fmt;
use std::str::FromStr;

/// Shard `i` of `n`, 1 <= i <= n.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    i: usize,
    n: usize,
}

impl Shard {
    /// The whole sweep.
    pub const WHOLE: Shard = Shard { i: 1, n: 1 };

    /// Whether a point is in this shard. Neighbouring points take about the same time, so they are in different shards.
    pub fn has(self, point: usize) -> bool {
        point % self.n == self.i - 1
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Shard, String> {
        if text == "auto" || text.starts_with("auto/") {
            return of_job(text, &|name| std::env::var(name).ok());
        }
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.trim().parse().ok()?, n.trim().parse().ok()?)));
        match parts {
            Some((i, n)) if (1..=n).contains(&i) => Ok(Shard { i, n }),
            _ => Err("write I/N with I from 1 to N, e.g. 2/8; or auto in a job array".into()),
        }
    }
}

/// The shard of a task in a job array, from the variables that its scheduler sets. `text` is `auto`, or `auto/8` with the number of tasks.
/// Kubernetes does not state this number. Slurm states the first number and the count of the tasks that were submitted together. For a task
/// that is submitted again alone these describe only this task. Therefore `auto` refuses an array of one task, and `auto/8` takes the tasks
/// to be numbered from 1 to 8.
fn of_job(text: &str, variable: &dyn Fn(&str) -> Option<String>) -> Result<Shard, String> {
    let number = |name: &str| variable(name).and_then(|value| value.parse::<usize>().ok());
    let stated = text.strip_prefix("auto/").map(|n| n.parse::<usize>().map_err(|_| format!("`{text}` is not auto/N")));
    let stated = stated.transpose()?;
    let (first, index, n) = match (number("SLURM_ARRAY_TASK_ID"), number("JOB_COMPLETION_INDEX")) {
        (Some(index), _) if stated.is_some() => (1, index, stated),
        (Some(index), _) => {
            let count = number("SLURM_ARRAY_TASK_COUNT");
            if count == Some(1) {
                let why = "the job array has one task, perhaps of a sweep of several that is submitted again";
                return Err(format!("{why}: write auto/N with the number N of all tasks, or I/N"));
            }
            (number("SLURM_ARRAY_TASK_MIN").unwrap_or(0), index, count)
        }
        (None, Some(index)) => (0, index, stated),
        (None, None) => return Err("this is no task of a job array of Slurm or Kubernetes: write I/N, e.g. 2/8".into()),
    };
    let Some(n) = n else { return Err("the number of tasks is not known: write auto/N, e.g. auto/8".into()) };
    match index.checked_sub(first) {
        Some(i) if i < n => Ok(Shard { i: i + 1, n }),
        _ => Err(format!(
            "task {index} is not one of {n} tasks from {first} on: number them without gaps, for auto/N from 1 to N"
        )),
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.i, self.n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn auto(text: &str, variables: &[(&str, &str)]) -> Result<String, String> {
        let variable = |name: &str| variables.iter().find(|(n, _)| *n == name).map(|(_, value)| value.to_string());
        of_job(text, &variable).map(|shard| shard.to_string())
    }

    #[test]
    fn tasks_of_job_arrays_know_their_shard() {
        let slurm = [("SLURM_ARRAY_TASK_ID", "12"), ("SLURM_ARRAY_TASK_MIN", "10"), ("SLURM_ARRAY_TASK_COUNT", "4")];
        assert_eq!(auto("auto", &slurm).as_deref(), Ok("3/4"));
        assert_eq!(auto("auto/8", &[("JOB_COMPLETION_INDEX", "0")]).as_deref(), Ok("1/8"));
        // Task 2 of 3, submitted again alone.
        let again = [("SLURM_ARRAY_TASK_ID", "2"), ("SLURM_ARRAY_TASK_MIN", "2"), ("SLURM_ARRAY_TASK_COUNT", "1")];
        assert_eq!(auto("auto/3", &again).as_deref(), Ok("2/3"));
        assert!(auto("auto", &again).unwrap_err().contains("submitted again"));
        // With the number of tasks they count from 1.
        assert!(auto("auto/3", &[("SLURM_ARRAY_TASK_ID", "0")]).unwrap_err().contains("from 1 to N"));
        assert!(auto("auto", &[("JOB_COMPLETION_INDEX", "0")]).unwrap_err().contains("auto/N"));
        assert!(auto("auto/8", &[("JOB_COMPLETION_INDEX", "8")]).unwrap_err().contains("without gaps"));
        assert!(auto("auto", &[]).unwrap_err().contains("no task of a job array"));
        // Every third task of a Slurm array has gaps.
        let gaps = [("SLURM_ARRAY_TASK_ID", "6"), ("SLURM_ARRAY_TASK_MIN", "0"), ("SLURM_ARRAY_TASK_COUNT", "3")];
        assert!(auto("auto", &gaps).is_err());
    }
}
