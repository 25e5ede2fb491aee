//! The command is killed at every tenth of its time.

use crate::fault::Fault;
use crate::prepared::Prepared;

pub fn faults(prepared: &Prepared) -> Vec<Fault> {
    let at = |tenth| Fault {
        what: format!("killed after {tenth} tenths of its time"),
        killed_after: Some(prepared.duration * tenth / 10),
        ..Fault::default()
    };
    if prepared.writes() { (1..=10).map(at).collect() } else { vec![] }
}
