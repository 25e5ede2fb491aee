//! Runs with state and time in double-double precision.

use xprec::Df64;

use super::Refusal;
use crate::engine::compensated::Given;
use crate::engine::equations::DerivedModel;
use crate::engine::simulate::Simulation;
use crate::model::Varies;
use crate::scene::Scene;

/// A simulation of `scene` with state and time in double-double precision.
///
/// # Errors
/// If its cells cannot be solved in double-double precision.
pub(super) fn compensate<'a>(
    derived: &DerivedModel,
    simulation: Simulation<'a>,
    scene: &'a Scene,
) -> Result<Simulation<'a>, Refusal> {
    let parameters: Vec<Df64> = scene.parameters.iter().copied().map(Df64::from).collect();
    let mids: Vec<Df64> = scene.laws.iter().map(|law| law.exact_mid()).collect();
    let k: Vec<Df64> = simulation.now.k.iter().copied().map(Df64::from).collect();
    let load = |parameters| derived.source.exactly(scene, parameters, mids.clone()).matrices(&k).load;
    let varies = scene.model.parameters.iter().map(|p| p.varies == Varies::AsLoad);
    let bare: Vec<Df64> = parameters.iter().zip(varies).map(|(x, v)| if v { Df64::from(0.0) } else { *x }).collect();
    // The forces are linear in a torque: subtract those at 0 from those at 1.
    let of_unit = |p: usize| {
        let mut unit = bare.clone();
        unit[p] = Df64::from(1.0);
        load(unit) - load(bare.clone())
    };
    let loads = simulation.now.forcing.iter().flat_map(|forcing| forcing.parameters()).map(of_unit).collect();
    let cells = derived.source.exactly(scene, parameters, mids);
    simulation.compensate(Given { cells, loads })
}
