//! How a motion ends: at the first guard that becomes zero, or at a known time.

use crate::engine::crossing::Cost;
use crate::engine::equations::Switching;
use crate::engine::error::Stop;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::{End, Guard, Motion};

/// Time until the next known end of the motion \[s\], and its kind: the end of the run, a breakpoint of a torque, or the step of a law that
/// switches by time.
pub fn horizon(now: &Hybrid<'_>) -> (f64, End) {
    let mut first = (now.clock.until_about(now.t_end), End::Run);
    if let Some(forcing) = &now.forcing {
        let left = now.clock.until(forcing.next());
        if left < first.0 {
            first = (left.max(0.0), End::Breakpoint);
        }
    }
    for (i, law) in now.laws.iter().enumerate().filter(|(_, law)| law.switching != Switching::Never) {
        if let Some((t, side)) = law.next_switch() {
            let left = now.clock.until(t).max(0.0);
            if left < first.0 {
                first = (left, End::Step(i, side));
            }
        }
    }
    first
}

/// How and when \[s\] a motion ends. It ends at the `horizon` at the latest.
///
/// # Errors
/// If a search does not end, or a number overflows.
pub fn first(
    now: &Hybrid<'_>,
    motion: &mut dyn Motion,
    horizon: (f64, End),
    cost: &mut Cost,
) -> Result<(f64, End), Stop> {
    let mut first = if motion.length() < horizon.0 { (motion.length(), End::Open) } else { horizon };
    let mut look = |guard, end: &dyn Fn(_) -> End| -> Result<(), Stop> {
        if let Some((t, side)) = motion.first(guard, first.0, cost).map_err(|lost| now.lost(lost))? {
            first = (t, end(side));
        }
        Ok(())
    };
    for i in (0..now.laws.len()).filter(|&i| now.watches(i)) {
        look(Guard::Phase(i), &|side| End::Step(i, side))?;
    }
    for (i, exits) in now.guards.exits.iter().enumerate().filter(|(i, _)| !now.is_locked(*i)) {
        for which in 0..exits.len() {
            look(Guard::Exit(i, which), &|_| End::Exit(i, which))?;
        }
    }
    for (i, watch) in now.contact.iter().flat_map(|contact| &contact.watches).enumerate() {
        look(Guard::Hold(i), &|_| watch.end)?;
    }
    Ok(first)
}
