//! No file may be larger than a limit. The kernel reports this, or ends the program in the middle of a file.

use crate::fault::Fault;
use crate::prepared::Prepared;

/// Limits [blocks of 512 bytes].
const LIMITS: [usize; 6] = [0, 1, 8, 32, 128, 512];

pub fn faults(prepared: &Prepared) -> Vec<Fault> {
    let reported = LIMITS.map(|blocks| Fault {
        says: Some("larger than"),
        ..Fault::limit(&format!("trap '' XFSZ; ulimit -f {blocks}"))
    });
    let ended = LIMITS.map(|blocks| Fault::limit(&format!("ulimit -c 0; ulimit -f {blocks}")));
    if prepared.writes() { reported.into_iter().chain(ended).collect() } else { vec![] }
}
