//! The coordinates of a train: as many independent linear forms of the rotations as there are rotors that move independently.
//!
//! First the phases, one for each group of gears that mesh with one another, then the deflections of meshes, then twists. With them no
//! deflection of a group depends on its phase, so that it keeps all digits however far the gears have turned. Rotors without gears in
//! their part of the train have their rotations as coordinates.

use std::collections::HashMap;

use super::draft::{Draft, GearGroup, Term, Terms};
use crate::tolerance::scene::INDEPENDENT;

/// A coordinate.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chosen {
    pub form: Terms,
    pub name: String,
    pub unit: &'static str,
    pub doc: String,
    /// Whether it starts at zero. Otherwise it starts in static equilibrium.
    pub fixed: bool,
    /// Whether no deflection depends on it.
    pub rolling: bool,
}

/// The coordinates and rigid motions of a train.
#[derive(Debug)]
pub(super) struct Basis {
    /// The rotors that move independently.
    pub free: Vec<usize>,
    pub coordinates: Vec<Chosen>,
    /// The rows of parts that are coordinates: (part, row) and the index of the coordinate.
    pub of_rows: HashMap<(usize, usize), usize>,
    /// Rigid motions: the rotor whose speed is 1, and independent forms with their speeds.
    pub motions: Vec<(usize, Vec<(Terms, f64)>)>,
}

/// Chooses the coordinates and rigid motions of a train.
///
/// # Errors
/// The index of a group of gears whose phase depends on those of other groups.
pub(super) fn choose(draft: &Draft, values: &HashMap<String, f64>) -> Result<Basis, usize> {
    let free: Vec<usize> = (0..draft.rotors.len()).filter(|&i| draft.rotors[i].of.is_none()).collect();
    let dense = |form: &Terms| {
        let mut row = vec![0.0; free.len()];
        for term in form {
            let value = term.powers.iter().map(|(name, power)| values.get(name).copied().unwrap_or(1.0).powi(*power));
            let at = free.iter().position(|&i| i == term.rotor).unwrap_or(0);
            row[at] += term.number * value.product::<f64>();
        }
        row
    };
    let resolved = |form: &Terms| resolve(draft, form);
    let mut span = Span::default();
    let (mut coordinates, mut of_rows) = (vec![], HashMap::new());
    for (i, group) in draft.groups.iter().enumerate() {
        let phase = candidates(group).into_iter().map(|form| resolved(&form)).find(|form| span.add(&dense(form)));
        let Some(form) = phase else { return Err(i) };
        for &part in &group.parts {
            of_rows.insert((part, 0), coordinates.len());
        }
        let doc = match &group.parts[..] {
            [_] => format!("mean rotation of the gears of mesh {}, in which one pitch is 2 pi", group.mesh),
            _ => {
                format!("rotation of the gears that mesh with those of mesh {}, in which one pitch is 2 pi", group.mesh)
            }
        };
        let name = super::draft::named("phase", &group.mesh);
        coordinates.push(Chosen { form, name, unit: "rad", doc, fixed: false, rolling: false });
    }
    let geared = with_gears(draft);
    let mut elastic = vec![];
    for meshes in [true, false] {
        for (i, part) in draft.parts.iter().enumerate() {
            let row = match part.element {
                "element_mesh" | "element_mesh_with_friction" if meshes => 1,
                "element_shaft" | "element_support" | "element_thrust_bearing" if !meshes => 0,
                _ => continue,
            };
            let form = resolved(&part.rows[row]);
            let vector = dense(&form);
            elastic.push((form.clone(), vector.clone()));
            let axial = part.element == "element_thrust_bearing";
            let wanted = meshes || axial || form.iter().any(|term| geared[term.rotor]);
            if wanted && span.add(&vector) {
                of_rows.insert((i, row), coordinates.len());
                let (unit, doc) = match meshes {
                    true => ("m", format!("deflection of mesh {}", part.name)),
                    false if axial => ("m", format!("axial displacement on thrust bearing {}", part.name)),
                    false => ("rad", format!("twist of {}", part.name)),
                };
                coordinates.push(Chosen { form, name: part.called.clone(), unit, doc, fixed: false, rolling: false });
            }
        }
    }
    for &rotor in &free {
        let form = vec![Term::new(rotor, 1.0, &[])];
        if span.add(&dense(&form)) {
            let name = &draft.rotors[rotor].name;
            let doc = format!("rotation of rotor {name}");
            coordinates.push(Chosen {
                form,
                name: super::draft::named("theta", name),
                unit: "rad",
                doc,
                fixed: false,
                rolling: false,
            });
        }
    }
    // Springs determine all coordinates at the start except one for each rigid motion, which starts at zero.
    let mut held = Span::default();
    let independent: Vec<Terms> =
        elastic.into_iter().filter(|(_, vector)| held.add(vector)).map(|(form, _)| form).collect();
    let vectors: Vec<Vec<f64>> = coordinates.iter().map(|chosen: &Chosen| dense(&chosen.form)).collect();
    // End stops hold no rotor, but their forces depend on its rotation.
    let mut acting = held.clone();
    for part in draft.parts.iter().filter(|part| part.element == "element_end_stop") {
        acting.add(&dense(&resolved(&part.rows[0])));
    }
    for (i, chosen) in coordinates.iter_mut().enumerate().take(draft.groups.len()) {
        // A phase rolls if it can change while all other coordinates and all deflections stay the same.
        let mut others = acting.clone();
        vectors.iter().enumerate().filter(|(j, _)| *j != i).for_each(|(_, vector)| {
            others.add(vector);
        });
        chosen.rolling = others.add(&vectors[i]);
    }
    let mut placed = held.clone();
    for chosen in &mut coordinates {
        chosen.fixed = placed.add(&dense(&chosen.form));
    }
    let inputs: Vec<usize> =
        free.iter().copied().filter(|&rotor| held.add(&dense(&vec![Term::new(rotor, 1.0, &[])]))).collect();
    let motion = |&input: &usize| {
        let still = independent.iter().map(|form| (form.clone(), 0.0));
        let turning =
            inputs.iter().map(|&rotor| (vec![Term::new(rotor, 1.0, &[])], f64::from(u8::from(rotor == input))));
        (input, still.chain(turning).collect())
    };
    let motions = inputs.iter().map(motion).collect();
    Ok(Basis { free, coordinates, of_rows, motions })
}

/// Candidates for the phase of a group of gears, in order of preference.
fn candidates(group: &GearGroup) -> Vec<Terms> {
    let meshes = |i: usize| group.meshes.iter().filter(|mesh| mesh.contains(&i)).count();
    let turns = |i: &usize| group.gears[*i].rotor.is_some();
    let mut gears: Vec<usize> = (0..group.gears.len()).filter(turns).collect();
    gears.sort_by_key(|&i| std::cmp::Reverse(meshes(i)));
    let count = |&i: &usize| {
        let gear = &group.gears[i];
        let term =
            |rotor: Option<usize>, sign: f64| rotor.map(|r| Term::new(r, sign * gear.sense, &[(&gear.teeth, 1)]));
        [term(gear.rotor, 1.0), term(gear.carrier, -1.0)].into_iter().flatten().collect::<Terms>()
    };
    let counts = gears.iter().map(count);
    if group.parts.len() == 1 && gears.len() == 2 {
        group.phases.iter().cloned().chain(counts).collect()
    } else {
        counts.chain(group.phases.iter().cloned()).collect()
    }
}

/// A form in the rotors that move independently.
pub(super) fn resolve(draft: &Draft, form: &Terms) -> Terms {
    let resolve = |term: &Term| {
        let mut term = term.clone();
        while let Some(of) = &draft.rotors[term.rotor].of {
            term.rotor = of.rotor;
            term.number *= of.number;
            term.powers.extend(of.powers.iter().cloned());
        }
        term
    };
    form.iter().map(resolve).collect()
}

/// For each rotor, whether shafts and meshes join it to a gear with an elastic mesh.
fn with_gears(draft: &Draft) -> Vec<bool> {
    let mut geared = vec![false; draft.rotors.len()];
    let mut open: Vec<usize> = draft.groups.iter().flat_map(|g| &g.gears).filter_map(|gear| gear.rotor).collect();
    while let Some(rotor) = open.pop() {
        if std::mem::replace(&mut geared[rotor], true) {
            continue;
        }
        open.extend(draft.joints.iter().filter(|j| j.ends.contains(&rotor)).flat_map(|j| j.ends));
    }
    geared
}

/// The space that vectors span.
#[derive(Debug, Clone, Default)]
struct Span(Vec<Vec<f64>>);

impl Span {
    /// Adds a vector and returns true if it is independent of those before.
    fn add(&mut self, vector: &[f64]) -> bool {
        let unit = |x: &[f64]| {
            let size = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            (size, x.iter().map(|x| x / size).collect::<Vec<f64>>())
        };
        let (size, mut rest) = unit(vector);
        if size == 0.0 || !size.is_finite() {
            return false;
        }
        // The vector is orthogonalised twice: one pass leaves rounding errors along the vectors before.
        for basis in self.0.iter().chain(&self.0) {
            let along: f64 = basis.iter().zip(&rest).map(|(a, b)| a * b).sum();
            rest.iter_mut().zip(basis).for_each(|(x, b)| *x -= along * b);
        }
        let (left, rest) = unit(&rest);
        let independent = left > INDEPENDENT;
        if independent {
            self.0.push(rest);
        }
        independent
    }
}
