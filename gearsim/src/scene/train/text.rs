//! The equations of a train as text: the definition of each coordinate, the displacements of its parts, and the derived terms of each kind
//! of part.

use super::basis::{Basis, resolve};
use super::compose::element;
use super::draft::{Draft, Terms, named};
use crate::model::{Coordinate, Model};

/// The text.
pub(super) fn equations(bare: &'static Model, draft: &Draft, basis: &Basis) -> String {
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
    text += "\nParts, with their displacements\n";
    for (i, part) in draft.parts.iter().enumerate() {
        let displacement = |(j, coordinate): (usize, &Coordinate)| match basis.of_rows.get(&(i, j)) {
            Some(&known) => format!("{} = {}", coordinate.name, basis.coordinates[known].name),
            None => format!("{} = {}", coordinate.name, show(&resolve(draft, &part.rows[j]))),
        };
        let model = element(bare, part).1;
        let its = model.coordinates.iter().enumerate().map(displacement).collect::<Vec<_>>().join(", ");
        let renamed: String = part.renamed.iter().map(|(own, name)| format!("; {own} is {name}")).collect();
        let absent = model.parameters.iter().filter(|p| p.with.is_some_and(|effect| !part.has(effect)));
        let absent: String = absent.map(|p| format!("; {} is 0", p.name)).collect();
        text += &format!("  {} {}: {its}{renamed}{absent}\n", title(part.element), part.name);
    }
    text += "\nWhat each kind of part adds: energies T, V and D, or forces F at its displacements. The end x of a name stands for the name of the part\n";
    let mut kinds: Vec<&Model> = vec![];
    for part in &draft.parts {
        let model = element(bare, part).1;
        if !kinds.iter().any(|known| known.name == model.name) {
            kinds.push(model);
        }
    }
    for model in kinds {
        let lines: String = kind(model).iter().map(|line| format!("    {line}\n")).collect();
        text += &format!("  {}\n{lines}", title(model.name));
    }
    text + "\nWith theta = A q, a displacement is x = R q, and M is the matrix of the sum of all T\n  \
        M q'' = sum R F, where F = -dV/dx - dD/dx' if it is not written\n\
        At a step of k or e, with v the speed of its phase, n the gradient of the phase, G = n.M⁻¹n, and dV the step of V\n  \
        v+^2 = v-^2 - 2*G*dV, q'+ = q' + M⁻¹n/G*(v+ - v-); if v+^2 < 0, reflection: v+ = -v-, and nothing steps\n"
}

/// The name of an element in a text: `mesh with friction`.
fn title(element: &str) -> String {
    element.trim_start_matches("element_").replace('_', " ")
}

/// The terms that an element adds to the equations, from its derived text, without the inertias `J_` of its coordinates, which trains do
/// not have.
fn kind(model: &Model) -> Vec<String> {
    let mut lines = vec![];
    for block in model.equations.split("\n\n") {
        if block.starts_with("at a step") || block.starts_with("between two steps") {
            continue;
        }
        // These accelerations follow from T, V and D.
        if block.contains("'' =") && !block.contains("J_") {
            continue;
        }
        let mut left_out = false;
        for line in block.lines() {
            if !line.starts_with(' ') {
                let of_coordinates = line.starts_with("T = ") && line.contains("J_");
                left_out = of_coordinates || line == "V = 0" || line == "D = 0" || line.starts_with("Q_");
            }
            if !left_out {
                lines.push(force(&line.replace("{}", "x"), model));
            }
        }
    }
    lines
}

/// A line about accelerations as one about forces: `s'' = -k*x/J_s` becomes `F_s = -k*x`.
fn force(line: &str, model: &Model) -> String {
    model.coordinates.iter().fold(line.to_owned(), |line, Coordinate { name, .. }| {
        let [with, without] = [format!("J_{name} {name}'' ="), format!("{name}'' =")];
        let rest = line.strip_prefix(&with).or_else(|| line.strip_prefix(&without));
        let line = rest.map_or(line.clone(), |rest| format!("F_{name} ={rest}"));
        let line = line.replace(&format!("/J_{name}"), "").replace(&format!("*J_{name}"), "");
        line.replace(&format!("J_{name}*"), "").replace("/(2)", "/2")
    })
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
        text += &factors.join("*");
        for (name, power) in powers.iter().filter(|p| p.1 < 0) {
            text += &format!("/{name}").repeat(-power as usize);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use gearsim_generated::TRAIN;

    /// The text names each parameter and law of an element. A missing term would be a missing name.
    #[test]
    fn the_text_of_each_element_names_all_parameters_and_laws() {
        for model in TRAIN.elements {
            let text = kind(model).join("\n");
            let words: Vec<&str> = text.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
            let parameters = model.parameters.iter().map(|p| p.name).filter(|name| !name.starts_with("J_"));
            for name in parameters.chain(model.laws.iter().map(|law| law.name)) {
                assert!(words.contains(&name), "{}: no {name} in\n{text}", model.name);
            }
            assert!(!text.contains("J_") && !text.contains("''"), "{}:\n{text}", model.name);
        }
    }
}
