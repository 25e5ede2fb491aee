//! The equations of a train for reading: energies and torques of its parts, and what each coordinate is.

use super::basis::{Basis, resolve};
use super::draft::{Draft, Terms, named};

/// The text.
pub(super) fn equations(draft: &Draft, basis: &Basis) -> String {
    let rotation = |rotor: usize| match draft.rotors[rotor].along {
        None => named("theta", &draft.rotors[rotor].name),
        Some(_) => draft.rotors[rotor].name.clone(),
    };
    let show = |form: &Terms| shown(form, &rotation);
    let mut text = String::from("Coordinates, in the rotations theta of the rotors\n");
    for chosen in &basis.coordinates {
        text += &format!("  {} = {}\n", chosen.name, show(&chosen.form));
    }
    let geared = draft.rotors.iter().enumerate().filter(|(_, rotor)| rotor.of.is_some());
    for (i, rotor) in geared {
        let form = resolve(draft, &vec![super::draft::Term::new(i, 1.0, &[])]);
        text += &format!("  {} = {}\n", named("theta", &rotor.name), show(&form));
    }
    text += "\nParts: each adds its energy or its torque at its displacement\n";
    for (i, part) in draft.parts.iter().enumerate() {
        let name = &part.name;
        let of = |quantity: &str| named(quantity, name);
        let row = |j: usize| show(&resolve(draft, &part.rows[j]));
        let moment = part.renamed.iter().find(|r| r.0 == "I_x").map_or_else(|| of("I"), |r| r.1.clone());
        text += &match part.element {
            "element_rotor" => format!("  T = {moment} x'^2/2,  x = {}\n", row(0)),
            "element_planets" => format!("  T = {} {} (a x')^2/2,  x = {}\n", of("np"), of("mp"), row(0)),
            "element_shaft" | "element_support" => format!("  V = {} x^2/2,  x = {}\n", of("k"), row(0)),
            "element_mesh" | "element_mesh_with_friction" => {
                let phase = basis.of_rows.get(&(i, 0)).map_or("", |&j| &basis.coordinates[j].name);
                format!("  V = {}({phase}) (x - {}({phase}))^2/2,  x = {}\n", of("k"), of("e"), row(1))
            }
            "element_thrust_bearing" => {
                format!("  T = {} x'^2/2,  V = {} x^2/2,  x = {}\n", of("ma"), of("ka"), row(0))
            }
            "element_viscous" => format!("  D = {} x'^2/2,  x = {}\n", of("c"), row(0)),
            "element_drive" => format!("  Q = {},  x = {}\n", of("T"), row(0)),
            "element_load" => format!("  Q = -{},  x = {}\n", of("T"), row(0)),
            other => format!("  {} {name},  x = {}\n", other.trim_start_matches("element_").replace('_', " "), row(0)),
        };
    }
    text += "\nWith theta = A q, a displacement is x = R q. For each coordinate q\n";
    text += "  d/dt dT/dq' = - sum R dV/dx - sum R dD/dx' + sum R Q\n";
    text + "and speeds jump where k or e step as in the model of one mesh (`gearsim models gear_pair`).\n"
}

fn shown(form: &Terms, rotation: &dyn Fn(usize) -> String) -> String {
    let mut text = String::new();
    for term in form {
        text += match (term.number < 0.0, text.is_empty()) {
            (true, true) => "-",
            (true, false) => " - ",
            (false, true) => "",
            (false, false) => " + ",
        };
        let size = term.number.abs();
        let mut powers: Vec<(&str, i32)> = vec![];
        for (name, power) in &term.powers {
            match powers.iter_mut().find(|known| known.0 == name) {
                Some(known) => known.1 += power,
                None => powers.push((name, *power)),
            }
        }
        let above = powers.iter().filter(|p| p.1 > 0).flat_map(|p| vec![p.0.to_string(); p.1 as usize]);
        let number = (size != 1.0).then(|| size.to_string());
        let factors: Vec<String> = number.into_iter().chain(above).chain([rotation(term.rotor)]).collect();
        text += &factors.join(" ");
        for (name, power) in powers.iter().filter(|p| p.1 < 0) {
            text += &format!("/{name}").repeat(-power as usize);
        }
    }
    text
}
