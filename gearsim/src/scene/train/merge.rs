//! Adds the parameters, laws, effects and outputs of the element of a part to the description of a train, under the names of the part.

use std::f64::consts::TAU;

use super::compose::{Composer, element, leak, own, said, shown};
use super::draft::{DraftPart, named};
use crate::model::{Effect, Law, Model, Output, Parameter, Switch, Torque};
use crate::scene::mistake::Report;
use crate::train::Part;

fn names(names: impl Iterator<Item = &'static str>) -> &'static [&'static str] {
    Box::leak(names.collect::<Vec<_>>().into_boxed_slice())
}

/// The name of a torque of an element in the train.
fn torque_name(torque: &str, part: &DraftPart) -> String {
    if torque == "x" { part.name.clone() } else { own(torque, &part.name) }
}

/// The forces whose powers are outputs of a train: the output of the force, that of its power, and the doc of the power.
const POWERS: [(&str, &str, &str); 2] = [
    (
        "shaft_torque_x",
        "shaft_power",
        "power that enters the shaft {} at its first end: torque times the speed of that end",
    ),
    (
        "mesh_force_x",
        "mesh_power",
        "power that the first gear, or the ring of a planet set, gives to the mesh {}: force times the speed of its flank",
    ),
];

impl Composer<'_> {
    /// Adds the declarations of a part's element to the train.
    pub(super) fn part(&mut self, i: usize, symbols: &mut usize, report: &mut Report) -> Part {
        let part = &self.draft.parts[i];
        let (element, model) = element(self.bare, part);
        let parameters = model.parameters.iter().map(|p| self.parameter(part, p, report)).collect();
        let effects = model.effects.iter().map(|e| part.has(e.name).then(|| self.effect(part, e))).collect();
        let phase = self.basis.of_rows.get(&(i, 0)).map(|&j| &self.basis.coordinates[j]);
        for (j, law) in model.laws.iter().enumerate() {
            let chosen = phase.map_or((law.phase, law.rolling), |chosen| (leak(chosen.name.as_str()), chosen.rolling));
            let law = Law {
                name: leak(own(law.name, &part.name)),
                phase: chosen.0,
                rolling: chosen.1,
                held: &[],
                period: TAU,
                with: law.with.map(|with| self.renamed(part, with)),
                doc: said(law.doc, part),
                ..*law
            };
            self.laws.push((law, [i, j]));
        }
        let mut values = vec![0; model.laws.len()];
        for switch in model.switches {
            values.extend((0..switch.neutral.len()).map(|k| *symbols + k));
            *symbols += switch.neutral.len();
            let (name, with) = (leak(own(switch.name, &part.name)), self.renamed(part, switch.with));
            self.switches.push(Switch { name, with, doc: said(switch.doc, part), ..*switch });
        }
        let first = self.torques.len();
        for torque in model.torques {
            let with = names(torque.with.iter().map(|effect| self.renamed(part, effect)));
            self.torques.push(Torque { name: leak(torque_name(torque.name, part)), with, doc: said(torque.doc, part) });
        }
        for (effects, term) in model.nonlinear_with {
            let with = names(effects.iter().map(|effect| self.renamed(part, effect)));
            if !self.nonlinear_with.iter().any(|known| known.0 == with) {
                let joint = named("", &part.name);
                self.nonlinear_with.push((with, leak(term.replace("_x", &joint))));
            }
        }
        let torques = (first..self.torques.len()).collect();
        let outputs: Vec<usize> = model.outputs.iter().map(|output| self.output(part, output)).collect();
        self.power(part, model, &outputs);
        self.axial_force(part, model, &outputs);
        Part {
            element,
            rows: vec![],
            parameters,
            effects,
            values,
            laws: model.laws.len(),
            switches: model.switches.len(),
            torques,
            outputs,
        }
    }

    fn parameter(&mut self, part: &DraftPart, p: &Parameter, report: &mut Report) -> Option<usize> {
        if p.name.starts_with("J_") || !p.with.is_none_or(|effect| part.has(effect)) {
            return None;
        }
        let renamed = part.renamed.iter().find(|renamed| renamed.0 == p.name);
        let is_own = p.name.ends_with("_x") && renamed.is_none();
        let name = match renamed {
            Some((_, name)) => name.clone(),
            None if is_own => own(p.name, &part.name),
            None => p.name.into(),
        };
        let known = self.parameters.iter().position(|known| known.name == name);
        if let (true, Some(known)) = (is_own, known) {
            let other = self.owners.get(self.parameters[known].name).cloned().unwrap_or_default();
            let message = format!("{} and {other} would both have the parameter `{name}`", shown(part));
            report.add(&part.place, message, "a name used before", "give one of them another name");
        }
        known.or_else(|| {
            let (name, doc) = (leak(name), said(p.doc, part));
            let with = p.with.map(|with| self.renamed(part, with));
            let above = p.above.map(|lesser| leak(own(lesser, &part.name)));
            self.owners.insert(name, shown(part));
            self.parameters.push(Parameter { name, doc, with, above, ..*p });
            Some(self.parameters.len() - 1)
        })
    }

    /// The name of an effect of an element in the train.
    fn renamed(&self, part: &DraftPart, effect: &'static str) -> &'static str {
        match effect.strip_suffix("_x") {
            Some(of) => leak(format!("{of}_{}", part.name)),
            None => effect,
        }
    }

    fn effect(&mut self, part: &DraftPart, e: &Effect) -> usize {
        let name = self.renamed(part, e.name);
        let known = self.effects.iter().position(|known| known.name == name);
        known.unwrap_or_else(|| {
            let requires = names(e.requires.iter().map(|other| self.renamed(part, other)));
            let excludes = names(e.excludes.iter().map(|other| self.renamed(part, other)));
            self.effects.push(Effect { name, doc: said(e.doc, part), requires, excludes, ..*e });
            self.effects.len() - 1
        })
    }

    /// Adds the power that enters a part at its first end. `outputs` are the indices in the train of the outputs of its element `model`.
    fn power(&mut self, part: &DraftPart, model: &Model, outputs: &[usize]) {
        let forces = model.outputs.iter().zip(outputs);
        let found = forces.filter(|_| !part.driving.is_empty()).find_map(|(output, &index)| {
            let (_, name, doc) = POWERS.iter().find(|(force, ..)| *force == output.name)?;
            Some((index, name, doc))
        });
        let Some((of, name, doc)) = found else { return };
        let (name, doc) = (leak(format!("{name}_{}", part.name)), said(doc, part));
        self.products.push((self.outputs.len(), of, part.driving.clone()));
        self.outputs.push(Output { name, unit: "W", doc, ..self.outputs[of] });
    }

    /// Adds the axial force of a helical mesh.
    fn axial_force(&mut self, part: &DraftPart, model: &Model, outputs: &[usize]) {
        let draft = self.draft;
        let Some((_, tangent)) = draft.axial_forces.iter().find(|(mesh, _)| *mesh == part.name) else { return };
        let force = model.outputs.iter().zip(outputs).find(|(output, _)| output.name == "mesh_force_x");
        let Some((_, &of)) = force else { return };
        let name = leak(format!("axial_force_{}", part.name));
        let doc = "axial force of the mesh {}: mesh force times the tangent of the base helix angle";
        self.multiples.push((self.outputs.len(), of, tangent.clone()));
        self.outputs.push(Output { name, doc: said(doc, part), ..self.outputs[of] });
    }

    fn output(&mut self, part: &DraftPart, output: &Output) -> usize {
        let of_train = output.name == "inertia_damping_loss";
        let base = output.name.strip_suffix("_x").unwrap_or(output.name);
        let name = match output.name.strip_prefix("power_") {
            Some(torque) => format!("power_{}", torque_name(torque, part)),
            None if of_train => base.into(),
            None => format!("{base}_{}", part.name),
        };
        let known = self.outputs.iter().position(|known| known.name == name);
        known.unwrap_or_else(|| {
            let with = output.with.map(|with| self.renamed(part, with));
            self.outputs.push(Output { name: leak(name), with, doc: said(output.doc, part), ..*output });
            self.outputs.len() - 1
        })
    }
}
