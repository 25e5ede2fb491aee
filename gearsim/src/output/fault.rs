//! Faults on purpose: in tests every operation on a file can be made to fail, one after the other. In the program these functions
//! are empty.

use std::io::{self, Write};

/// A place where an operation on a file may fail.
#[cfg(not(test))]
#[inline]
pub(super) fn point() -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
pub(crate) use tests::{Fault, point, with};

/// A writer each of whose writes may fail.
pub(super) struct Faulty<W>(pub(super) W);

impl<W: Write> Write for Faulty<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        point()?;
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::io;

    /// What fails.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub(crate) enum Fault {
        /// This one operation, as on a full disk that is freed again.
        Once(usize),
        /// This operation and all after it, clearing up included: as if the process were killed here.
        From(usize),
    }

    thread_local! {
        static FAULT: Cell<(Option<Fault>, usize)> = const { Cell::new((None, 0)) };
    }

    /// Runs `work` on this thread with a fault. Returns its result, and the number of operations on files.
    pub(crate) fn with<T>(fault: Option<Fault>, work: impl FnOnce() -> T) -> (T, usize) {
        FAULT.set((fault, 0));
        let result = work();
        (result, FAULT.replace((None, 0)).1)
    }

    pub(crate) fn point() -> io::Result<()> {
        let (fault, n) = FAULT.get();
        FAULT.set((fault, n + 1));
        match fault {
            Some(Fault::Once(at)) if n == at => Err(io::ErrorKind::StorageFull.into()),
            Some(Fault::From(at)) if n >= at => Err(io::Error::other("killed")),
            _ => Ok(()),
        }
    }
}
