//! Long calls without Python's lock. Ctrl-C ends them, and a function of the caller receives their progress.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

use crate::argument::Function;

/// Interval between two checks for signals and reports of the progress.
const EVERY: Duration = Duration::from_millis(50);
/// The clock is read once in this many calls.
const CALLS: u32 = 1 << 8;

/// Progress reports and interruption of a long call.
pub struct Watch {
    progress: Option<Function>,
    calls: u32,
    last: Instant,
}

/// Payload of the unwinding that ends a call.
struct Interrupted(PyErr);
/// Payload of the unwinding that ends a thread whose result nobody waits for.
struct Left;
/// Stack size of a thread of [`left`] [bytes]: that of a main thread.
const STACK: usize = 8 << 20;

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
            self.progress.as_ref().map_or(Ok(()), |progress| progress.0.call1(py, (place,)).map(drop))
        })
    }

    /// The same as [`Watch::at`], for calls that cannot return an error: it unwinds to [`detached`].
    pub fn at_or_unwind(&mut self, place: f64) {
        self.at(place).unwrap_or_else(unwind);
    }
}

fn unwind(error: PyErr) {
    resume_unwind(Box::new(Interrupted(error)));
}

/// Calls `work` without Python's lock.
pub fn detached<T: Send>(
    py: Python<'_>,
    progress: Option<Function>,
    work: impl FnOnce(&mut Watch) -> T + Send,
) -> PyResult<T> {
    let mut watch = Watch { progress, calls: 0, last: Instant::now() };
    py.detach(|| {
        catch_unwind(AssertUnwindSafe(|| work(&mut watch))).map_err(|panic| match panic.downcast::<Interrupted>() {
            Ok(interrupted) => interrupted.0,
            Err(panic) => resume_unwind(panic),
        })
    })
}

/// Calls `work` without Python's lock on a separate thread. This is for work with long steps: the eigenvalues of one large matrix take
/// seconds. Ctrl-C ends the call at once. The thread ends when `work` next calls its argument; the result of the thread is dropped.
pub fn left<T: Send + 'static>(py: Python<'_>, work: impl FnOnce(&dyn Fn()) -> T + Send + 'static) -> PyResult<T> {
    let wanted = Arc::new(AtomicBool::new(true));
    let asked = Arc::clone(&wanted);
    let (sender, receiver) = mpsc::channel();
    let run = move || {
        let watch = || {
            if !asked.load(Ordering::Relaxed) {
                resume_unwind(Box::new(Left));
            }
        };
        // Nobody receives the result of a thread that was left.
        let _ = sender.send(catch_unwind(AssertUnwindSafe(|| work(&watch))));
    };
    thread::Builder::new().stack_size(STACK).spawn(run)?;
    let ended = py.detach(move || {
        loop {
            match receiver.recv_timeout(EVERY) {
                Ok(ended) => return Ok(ended),
                Err(RecvTimeoutError::Timeout) => Python::attach(|py| py.check_signals())?,
                Err(RecvTimeoutError::Disconnected) => return Err(PyRuntimeError::new_err("the thread ended early")),
            }
        }
    });
    if ended.is_err() {
        wanted.store(false, Ordering::Relaxed);
    }
    Ok(ended?.unwrap_or_else(|panic| resume_unwind(panic)))
}
