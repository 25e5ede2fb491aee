//! Trains that scenes list: against the derived models of the same drivetrains, closed forms, and mistakes in their tables.

mod common;
#[path = "common/random.rs"]
mod random;

#[path = "train/same.rs"]
mod same;

#[path = "train/frequencies.rs"]
mod frequencies;

#[path = "train/mistakes.rs"]
mod mistakes;

#[path = "train/flanks.rs"]
mod flanks;

#[path = "train/axial.rs"]
mod axial;

#[path = "train/planets.rs"]
mod planets;

#[path = "train/effects.rs"]
mod effects;

#[path = "train/end_stops.rs"]
mod end_stops;

#[path = "train/damage.rs"]
mod damage;

#[path = "train/breakaway.rs"]
mod breakaway;

#[path = "train/losses.rs"]
mod losses;

#[path = "train/sets.rs"]
mod sets;
#[path = "train/starts.rs"]
mod starts;
#[path = "train/weakly.rs"]
mod weakly;
