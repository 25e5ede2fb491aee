//! Progress bars for long runs. They cost short runs almost no time.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// The clock is read once in this many events, a power of two: about every 0.1 ms.
const EVENTS: u32 = 1 << 12;
/// A run that takes less time than this has no bar.
const PATIENCE: Duration = Duration::from_secs(1);
/// Number of steps of a full bar.
const FULL: u64 = 1000;

/// The progress of a run.
pub(super) struct Progress {
    t_end: f64,
    events: u32,
    shown: bool,
    begin: Instant,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// For a run that ends at `t_end` [s]. There is no bar if `quiet`, or if stderr is not a terminal.
    pub(super) fn new(t_end: f64, quiet: bool) -> Progress {
        let shown = !quiet && std::io::stderr().is_terminal();
        Progress { t_end, events: 0, shown, begin: Instant::now(), bar: None }
    }

    /// Called at every event: the run has reached `t` [s].
    #[inline]
    pub(super) fn at(&mut self, t: f64) {
        self.events = self.events.wrapping_add(1);
        if self.shown && self.events.is_multiple_of(EVENTS) {
            self.show(t);
        }
    }

    #[cold]
    fn show(&mut self, t: f64) {
        if self.begin.elapsed() < PATIENCE {
            return;
        }
        let bar = self.bar.get_or_insert_with(|| {
            let style = ProgressStyle::with_template("{wide_bar} {percent:>3} %  {msg}, {eta} left");
            let bar = ProgressBar::new(FULL).with_elapsed(self.begin.elapsed());
            bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        });
        bar.set_message(format!("t = {t:.3} s of {} s", self.t_end));
        bar.set_position((t / self.t_end * FULL as f64) as u64);
    }
}

/// The progress of a sweep: the number of finished points, and the time left.
pub(super) struct PointsBar {
    bar: Option<ProgressBar>,
}

impl PointsBar {
    /// For a sweep of `points`. There is no bar if `quiet`, or if stderr is not a terminal.
    pub(super) fn new(points: usize, quiet: bool) -> PointsBar {
        let shown = !quiet && points > 0 && std::io::stderr().is_terminal();
        let template = "{wide_bar} {percent:>3} %  {pos} of {len} points, {per_sec}, {eta} left";
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        PointsBar { bar: shown.then(|| ProgressBar::new(points as u64).with_style(style)) }
    }

    /// `count` points are finished.
    pub(super) fn at(&mut self, count: usize) {
        if let Some(bar) = &self.bar {
            bar.set_position(count as u64);
        }
    }
}

impl Drop for PointsBar {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
