//! Long calls without Python's lock, which Ctrl-C ends and a function of the caller follows.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::time::{Duration, Instant};

use pyo3::prelude::*;

/// Interval at which Python is asked for signals and told the progress.
const EVERY: Duration = Duration::from_millis(50);
/// The clock is read once in this many calls.
const CALLS: u32 = 1 << 8;

/// What a long call tells as it goes.
pub struct Watch {
    progress: Option<Py<PyAny>>,
    calls: u32,
    last: Instant,
}

/// Payload of the unwinding that ends a call.
struct Interrupted(PyErr);

impl Watch {
    /// Where the call is. An error is that of a signal or of the caller's function, and ends the call.
    pub fn at(&mut self, place: f64) -> PyResult<()> {
        self.calls = self.calls.wrapping_add(1);
        if !self.calls.is_multiple_of(CALLS) {
            return Ok(());
        }
        self.now(place)
    }

    /// The same, for calls that are rare.
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

    /// The same; where the call cannot return an error, it unwinds to [`detached`].
    pub fn at_or_unwind(&mut self, place: f64) {
        if let Err(error) = self.at(place) {
            resume_unwind(Box::new(Interrupted(error)));
        }
    }
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
