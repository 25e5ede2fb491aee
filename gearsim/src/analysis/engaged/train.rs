//! The teeth of a mesh of a train, from the linear forms of its parts.

use super::{Teeth, ToothData, standard};
use crate::model::{GearData, Parameter};
use crate::scene::Scene;
use crate::train::{Factor, Part, RotationForm, Row, Train};

/// The element of a mesh. Its rows are the phase, the lead h (N_1 theta_1 - N_2 theta_2), and theta_1 + theta_2 (with a ring: theta_1 -
/// theta_2). h is the base radius per tooth.
const MESH: &str = "element_mesh_with_friction";
const ROTOR: &str = "element_rotor";
const THRUST_BEARING: &str = "element_thrust_bearing";

/// The teeth of the mesh with law `i`; `None` if the law is not that of two gears on rotors.
pub(super) fn teeth(scene: &Scene, train: &Train, i: usize) -> Option<Teeth> {
    let is = |part: &Part, name: &str| scene.model.elements[part.element].name == name;
    let part = train.parts.iter().find(|part| is(part, MESH) && part.values.first() == Some(&i))?;
    let form = |row: &'_ Row| -> RotationForm {
        match row {
            Row::Coordinate(j) => train.coordinates[*j].clone(),
            Row::Form(form) => form.clone(),
        }
    };
    let [mut lead, turn] = [form(part.rows.get(1)?), form(part.rows.get(2)?)];
    // Motions along the axes are not drawn.
    let bearings = train.parts.iter().filter(|part| is(part, THRUST_BEARING));
    let axial: Vec<usize> = bearings.flat_map(|part| form(&part.rows[0])).map(|(along, _)| along).collect();
    lead.retain(|(at, _)| !axial.contains(at));
    let [(rotor, first), (_, second)] = &lead[..] else { return None };
    // If a rotor is geared rigidly to another one, its rotation is that of the other one times further factors.
    let own = first.powers.len() == 3;
    let of_rotor = |part: &&Part| {
        let alone =
            |form: &RotationForm| matches!(&form[..], [(at, factor)] if at == rotor && factor.powers.is_empty());
        is(part, ROTOR) && part.rows.first().is_some_and(|row| alone(&form(row)))
    };
    let speed = train.parts.iter().filter(|_| own).find(of_rotor).and_then(|part| part.outputs.first().copied());
    if let Some(gears) = &scene.gears[i] {
        return Some(Teeth { gears: gears.clone(), known: ToothData::Teeth, rotor: speed });
    }
    let internal = turn.get(1).is_some_and(|(_, factor)| factor.number < 0.0);
    let per_tooth: f64 = first.powers.get(1..3)?.iter().map(|&(p, power)| scene.parameters[p].powi(power)).product();
    let numbers = [number_of_teeth(scene, first)?, number_of_teeth(scene, second)?];
    Some(standard(scene, numbers, internal, Some(per_tooth), speed))
}

/// The number of teeth in a factor N h.
fn number_of_teeth(scene: &Scene, factor: &Factor) -> Option<f64> {
    let is_teeth = |parameter: &Parameter| parameter.gear_data == Some(GearData::Teeth);
    let (parameter, _) =
        factor.powers.iter().find(|(p, power)| *power == 1 && is_teeth(&scene.model.parameters[*p]))?;
    Some(scene.parameters[*parameter]).filter(|z| z.is_finite())
}
