//! The rotations of the gears of planet sets relative to their carriers.

use super::compose::leak;
use super::draft::{Draft, PlanetSet, named};
use crate::model::Relative;

/// The relative rotations of all planet sets of a train. The planets of a set turn alike, so only the first one is listed.
pub(super) fn of(draft: &Draft) -> Vec<Relative> {
    draft.planet_sets.iter().flat_map(|set| of_set(draft, set)).collect()
}

fn of_set(draft: &Draft, set: &PlanetSet) -> Vec<Relative> {
    let speed = |rotor: usize| leak(format!("rotor_speed_{}", draft.rotors[rotor].name));
    let (carrier, law) = (set.carrier.map(speed), leak(named("k", &format!("{}_s1", set.name))));
    let count = set.planets.len() as u32;
    // A tooth of a planet meets the sun and the ring.
    let gears = [(Some(set.sun), count), (set.ring, count), (set.planets.first().copied(), 2)];
    let relative = |(gear, meets): (Option<usize>, u32)| {
        let gear = gear.map(speed);
        Relative { name: leak(name(gear, carrier)), law, gear, carrier, meets }
    };
    gears.into_iter().map(relative).collect()
}

/// The name of a relative speed. The sign does not matter: it is that of a frequency.
fn name(gear: Option<&str>, carrier: Option<&str>) -> String {
    match (gear, carrier) {
        (Some(gear), Some(carrier)) => format!("{gear} - {carrier}"),
        (one, other) => one.or(other).unwrap_or_default().to_owned(),
    }
}
