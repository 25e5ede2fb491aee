//! A cache of the laws that were computed last. To compute the strain energy of teeth takes some 10 ms. Sweeps, and pages whose user
//! changes another number, request the law of the same teeth again.

use std::sync::{Mutex, PoisonError};

use super::friction::{self, FrictionLaw};
use super::mesh_stiffness::{self, CellShape, StiffnessMethod};
use super::pair::{GearError, Gears};
use crate::profile::Profile;

/// Largest number of laws in the cache.
const MOST: usize = 16;

/// The arguments of a law.
#[derive(Debug, Clone, PartialEq)]
struct Asked {
    gears: Gears,
    method: StiffnessMethod,
    law: AskedLaw,
    period: f64,
    scale: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum AskedLaw {
    Stiffness(CellShape),
    Friction(FrictionLaw),
}

static RECENT: Mutex<Vec<(Asked, Profile)>> = Mutex::new(vec![]);

/// The mesh stiffness of `gears` over a phase of the given period, times `scale`, which is 1 for a law in N/m.
///
/// # Errors
/// If the gears do not mesh or are outside the range of the method, or for curves of spur gears with [`StiffnessMethod::Iso6336`].
pub fn stiffness(
    gears: &Gears,
    method: StiffnessMethod,
    shape: CellShape,
    period: f64,
    scale: f64,
) -> Result<Profile, GearError> {
    known(Asked { gears: gears.clone(), method, law: AskedLaw::Stiffness(shape), period, scale })
}

/// The friction law `what` of `gears` over a phase of the given period, times `scale`. The stiffness method decides the shares: equal
/// for [`StiffnessMethod::Iso6336`], proportional to the stiffnesses of the pairs for [`StiffnessMethod::Energy`].
///
/// # Errors
/// If the gears do not mesh, or are outside the range of the method: the method "energy" needs external teeth.
pub fn friction(
    gears: &Gears,
    method: StiffnessMethod,
    what: FrictionLaw,
    period: f64,
    scale: f64,
) -> Result<Profile, GearError> {
    known(Asked { gears: gears.clone(), method, law: AskedLaw::Friction(what), period, scale })
}

/// The law, from the cache if it is there, otherwise computed.
fn known(asked: Asked) -> Result<Profile, GearError> {
    let recent = || RECENT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, profile)) = recent().iter().find(|(other, _)| *other == asked) {
        return Ok(profile.clone());
    }
    let Asked { ref gears, method, law, period, scale } = asked;
    let profile = match law {
        AskedLaw::Stiffness(shape) => mesh_stiffness::stiffness(gears, method, shape, period, scale),
        AskedLaw::Friction(what) => friction::friction(gears, method, what, period, scale),
    }?;
    let mut laws = recent();
    laws.truncate(MOST - 1);
    laws.insert(0, (asked, profile.clone()));
    Ok(profile)
}

#[test]
fn the_cache_returns_the_law_of_the_requested_teeth() {
    let gears = |module: f64| Gears::standard([24.0, 96.0], module, 20f64.to_radians(), 7e-3);
    let of = |module| stiffness(&gears(module), StiffnessMethod::Energy, CellShape::Levels, 1.0, 1.0).unwrap();
    let (first, other) = (of(2e-3), of(2.5e-3));
    assert_eq!(
        first,
        mesh_stiffness::stiffness(&gears(2e-3), StiffnessMethod::Energy, CellShape::Levels, 1.0, 1.0).unwrap()
    );
    assert_eq!(first, of(2e-3));
    assert_ne!(first, other);
    let arm = friction(&gears(2e-3), StiffnessMethod::Energy, FrictionLaw::Arm, 1.0, 1.0).unwrap();
    assert_ne!(arm, friction(&gears(2e-3), StiffnessMethod::Energy, FrictionLaw::Side, 1.0, 1.0).unwrap());
}
