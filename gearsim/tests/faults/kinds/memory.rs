//! The address space of the program has a limit.

use crate::fault::Fault;
use crate::prepared::Prepared;

/// Limits [MB]: from too small to start, to enough for some commands.
const LIMITS: [usize; 12] = [16, 24, 28, 32, 36, 40, 48, 56, 64, 96, 128, 256];

pub fn faults(_: &Prepared) -> Vec<Fault> {
    LIMITS.map(|limit| Fault::limit(&format!("ulimit -c 0; ulimit -v {}", limit * 1024))).into()
}
