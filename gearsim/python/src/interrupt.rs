//! Long calls without Python's lock. Ctrl-C ends them, and a function of the caller receives their progress.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::time::{Duration, Instant};

use pyo3::prelude::*;

/// Interval between two checks for signals and reports of the progress.
const EVERY: Duration = Duration::from_millis(50);
/// The clock is read once in this many calls.
const CALLS: u32 = 1 << 8;

/// Progress reports and interruption of a long call.
pub struct Watch {
    progress: Option<Py<PyAny>>,
    calls: u32,
    last: Instant,
}

/// Payload of the unwinding that ends a call.
struct Interrupted(PyErr);

impl Watch {
    /// Reports how far the call is. An error comes from a signal or from the caller's function, and ends the call.
    pub fn at(&mut self, place: f64) -> PyResult<()> {
        self.calls = self.calls.wrapping_add(1);
        if !self.calls.is_multiple_of(CALLS) {
            return Ok(());
        }
        self.now(place)
    }

    /// The same as [`Watch::at`], but reads the clock at every call.
    pub fn now(&mut self, place: f64) -> PyResult<()> {
        if self.last.elapsed() < EVERY {
            return Ok(());
        }
        self.last = Instant::now();
        Python::attach(|py| {
            py.check_signals()?;
            self.progress.as_ref().map_or(Ok(()), |progress| progress.call1(py, (place,)).map(drop))
        })
    }

    /// The same as [`Watch::at`], for calls that cannot return an error: it unwinds to [`detached`].
    pub fn at_or_unwind(&mut self, place: f64) {
        self.at(place).unwrap_or_else(unwind);
    }

    /// The same as [`Watch::now`], without a place, for calls that cannot return an error.
    pub fn now_or_unwind(&mut self) {
        self.now(f64::NAN).unwrap_or_else(unwind);
    }
}

fn unwind(error: PyErr) {
    resume_unwind(Box::new(Interrupted(error)));
}

/// Calls `work` without Python's lock.
pub fn detached<T: Send>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    work: impl FnOnce(&mut Watch) -> T + Send,
) -> PyResult<T> {
    let mut watch = Watch { progress, calls: 0, last: Instant::now() };
    let ended = py.detach(|| {
        catch_unwind(AssertUnwindSafe(|| work(&mut watch))).map_err(|panic| match panic.downcast::<Interrupted>() {
            Ok(interrupted) => interrupted.0,
            Err(panic) => resume_unwind(panic),
        })
    });
    ended
}
