//! The description of a train, from those of its elements.

use std::collections::HashMap;
use std::f64::consts::TAU;
use std::sync::{Arc, Mutex, OnceLock};

use super::basis::{self, Basis, resolve};
use super::draft::{Draft, DraftPart, Terms, named};
use super::text;
use crate::model::{Coordinate, Effect, Law, Model, Motion, Output, Parameter, Range, Role, Start, Switch, Torque};
use crate::scene::mistake::Report;
use crate::train::{Factor, Form, Part, Row, Train};

/// Largest number of effects of a model.
const EFFECTS: usize = u64::BITS as usize;

type Composed = (&'static Model, Arc<Train>);

/// Models refer to their texts for as long as the program runs. A train that is read again, at another point of a sweep for example, has
/// the model that it had before.
static KNOWN: OnceLock<Mutex<HashMap<String, Composed>>> = OnceLock::new();

/// The model of a train. `bare` is the model without parts.
pub(super) fn model(
    bare: &'static Model,
    draft: &Draft,
    values: &HashMap<String, f64>,
    report: &mut Report,
) -> Option<Composed> {
    let basis = match basis::choose(draft, values) {
        Ok(basis) => basis,
        Err(group) => {
            let group = &draft.groups[group];
            let part = &draft.parts[group.parts[0]];
            let message = format!("the gears of mesh {} have no phase of their own", group.mesh);
            let help =
                "their rotation follows from that of other gears; leave out one of the meshes, or make a shaft elastic";
            report.add(&part.place, message, "no phase", help);
            return None;
        }
    };
    let parts = draft.parts.iter().map(|p| (p.element, &p.name, &p.renamed, &p.rows, &p.called));
    let rotors = draft.rotors.iter().map(|rotor| (&rotor.name, &rotor.of));
    let geometry = draft.geometry.iter().map(|g| (&g.name, &g.doc));
    let key = format!(
        "{:?} {:?} {:?} {:?} {:?}",
        parts.collect::<Vec<_>>(),
        rotors.collect::<Vec<_>>(),
        geometry.collect::<Vec<_>>(),
        basis.coordinates,
        basis.motions
    );
    let known = KNOWN.get_or_init(Mutex::default);
    let find = |key: &str| known.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).get(key).cloned();
    if let Some(found) = find(&key) {
        return Some(found);
    }
    let composed = Composer::new(bare, draft, &basis).compose(report)?;
    known.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).insert(key, composed.clone());
    Some(composed)
}

struct Composer<'a> {
    bare: &'static Model,
    draft: &'a Draft,
    basis: &'a Basis,
    parameters: Vec<Parameter>,
    /// The part that has brought a parameter.
    owners: HashMap<&'static str, String>,
    effects: Vec<Effect>,
    /// Whether effects of parts are one effect of the train, since there are too many of them.
    merged: bool,
    laws: Vec<(Law, [usize; 2])>,
    switches: Vec<Switch>,
    torques: Vec<Torque>,
    outputs: Vec<Output>,
    nonlinear_with: Vec<(&'static str, &'static str)>,
}

fn leak(text: impl Into<String>) -> &'static str {
    Box::leak(text.into().into_boxed_str())
}

fn names(names: impl Iterator<Item = &'static str>) -> &'static [&'static str] {
    Box::leak(names.collect::<Vec<_>>().into_boxed_slice())
}

impl<'a> Composer<'a> {
    fn new(bare: &'static Model, draft: &'a Draft, basis: &'a Basis) -> Self {
        let of_parts = |part: &DraftPart| element(bare, part).1.effects.iter().filter(|e| e.of.is_some()).count();
        let merged = draft.parts.iter().map(of_parts).sum::<usize>() > EFFECTS - 12;
        let (parameters, owners, effects, laws) = (vec![], HashMap::new(), vec![], vec![]);
        let (switches, torques, outputs, nonlinear_with) = (vec![], vec![], vec![], vec![]);
        Composer {
            bare,
            draft,
            basis,
            parameters,
            owners,
            effects,
            merged,
            laws,
            switches,
            torques,
            outputs,
            nonlinear_with,
        }
    }

    fn compose(mut self, report: &mut Report) -> Option<Composed> {
        let before = report.len();
        for g in &self.draft.geometry {
            let range = Range { low: 0.0, high: f64::INFINITY, low_included: false, high_included: false };
            let (name, doc) = (leak(g.name.as_str()), leak(g.doc.as_str()));
            self.parameters.push(Parameter {
                name,
                unit: g.unit,
                default: None,
                with: None,
                varies: false,
                range,
                doc,
            });
        }
        let mut parts = vec![];
        let mut symbols = 0;
        for i in 0..self.draft.parts.len() {
            parts.push(self.part(i, &mut symbols, report));
        }
        if report.len() > before {
            return None;
        }
        // Stiffnesses first, then transmission errors, then friction; the parts count them in their own order.
        let rank = |law: &Law| match law.role {
            Role::Stiffness => 0,
            Role::Error => 1,
            Role::Side | Role::Arm => 2,
        };
        self.laws.sort_by_key(|(law, at)| (rank(law), *at));
        for (i, (_, [part, law])) in self.laws.iter().enumerate() {
            parts[*part].values[*law] = i;
        }
        for part in &mut parts {
            part.values[part.laws..].iter_mut().for_each(|symbol| *symbol += self.laws.len());
        }
        let index = |name: &str| self.parameters.iter().position(|p| p.name == name).unwrap_or(0);
        let form = |terms: &Terms| -> Form {
            let at = |rotor| self.basis.free.iter().position(|&i| i == rotor).unwrap_or(0);
            let factor = |number, powers: &[(String, i32)]| Factor {
                number,
                powers: powers.iter().map(|(name, power)| (index(name), *power)).collect(),
            };
            terms.iter().map(|term| (at(term.rotor), factor(term.number, &term.powers))).collect()
        };
        for (i, part) in parts.iter_mut().enumerate() {
            let rows = self.draft.parts[i].rows.iter().enumerate();
            let row = |(j, terms): (usize, &Terms)| match self.basis.of_rows.get(&(i, j)) {
                Some(coordinate) => Row::Coordinate(*coordinate),
                None => Row::Form(form(&resolve(self.draft, terms))),
            };
            part.rows = rows.map(row).collect();
        }
        let motions = self.basis.motions.iter().map(|(_, forms)| forms.iter().map(|(f, x)| (form(f), *x)).collect());
        let train = Train {
            coordinates: self.basis.coordinates.iter().map(|chosen| form(&chosen.form)).collect(),
            motions: motions.collect(),
            parts,
            counts: [self.laws.len(), self.torques.len(), self.outputs.len()],
        };
        Some((Box::leak(Box::new(self.described())), Arc::new(train)))
    }

    fn described(self) -> Model {
        let coordinate = |chosen: &basis::Chosen| Coordinate {
            name: leak(chosen.name.as_str()),
            unit: chosen.unit,
            doc: leak(chosen.doc.as_str()),
            start: if chosen.fixed { Start::At(0.0) } else { Start::Static },
        };
        let rotor = |i: usize| &self.draft.rotors[i].name;
        let several = self.basis.motions.len() > 1;
        let motion = |(i, _): &(usize, Vec<(Terms, f64)>)| {
            let doc = format!("rotational speed of rotor {}, the rest turning with it", rotor(*i));
            let name = if several { named("speed", rotor(*i)) } else { "speed".into() };
            Motion { name: leak(name), unit: "rad/s", doc: leak(doc) }
        };
        Model {
            coordinates: self.basis.coordinates.iter().map(coordinate).collect::<Vec<_>>().leak(),
            parameters: self.parameters.leak(),
            laws: self.laws.into_iter().map(|(law, _)| law).collect::<Vec<_>>().leak(),
            motions: self.basis.motions.iter().map(motion).collect::<Vec<_>>().leak(),
            effects: self.effects.leak(),
            torques: self.torques.leak(),
            outputs: self.outputs.leak(),
            switches: self.switches.leak(),
            nonlinear_with: self.nonlinear_with.leak(),
            equations: leak(text::equations(self.draft, self.basis)),
            ..*self.bare
        }
    }

    /// Adds what the element of a part has to the train.
    fn part(&mut self, i: usize, symbols: &mut usize, report: &mut Report) -> Part {
        let part = &self.draft.parts[i];
        let (element, model) = element(self.bare, part);
        let parameters = model.parameters.iter().map(|p| self.parameter(part, p, report)).collect();
        let effects = model.effects.iter().map(|e| self.effect(part, e)).collect();
        let phase = self.basis.of_rows.get(&(i, 0)).map(|&j| &self.basis.coordinates[j]);
        for (j, law) in model.laws.iter().enumerate() {
            let chosen = phase.map_or((law.phase, law.rolling), |chosen| (leak(chosen.name.as_str()), chosen.rolling));
            let law = Law {
                name: leak(own(law.name, &part.name)),
                phase: chosen.0,
                rolling: chosen.1,
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
            let name = if torque.name == "x" { part.name.clone() } else { own(torque.name, &part.name) };
            self.torques.push(Torque { name: leak(name), doc: said(torque.doc, part) });
        }
        for (effect, term) in model.nonlinear_with {
            let with = self.renamed(part, effect);
            if !self.nonlinear_with.iter().any(|known| known.0 == with) {
                self.nonlinear_with.push((with, term));
            }
        }
        let torques = (first..self.torques.len()).collect();
        let outputs = model.outputs.iter().map(|output| self.output(part, output)).collect();
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
        if p.name.starts_with("J_") {
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
            self.owners.insert(name, shown(part));
            self.parameters.push(Parameter { name, doc, with, ..*p });
            Some(self.parameters.len() - 1)
        })
    }

    /// The name of an effect of an element in the train.
    fn renamed(&self, part: &DraftPart, effect: &'static str) -> &'static str {
        match effect.strip_suffix("_x") {
            Some(of) if self.merged => of,
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
            let of = e.of.filter(|_| !self.merged);
            self.effects.push(Effect { name, of, doc: said(e.doc, part), requires, excludes });
            self.effects.len() - 1
        })
    }

    fn output(&mut self, part: &DraftPart, output: &Output) -> usize {
        let of_train = output.name == "inertia_damping_loss";
        let base = output.name.strip_suffix("_x").unwrap_or(output.name);
        let name = if of_train { base.into() } else { format!("{base}_{}", part.name) };
        let known = self.outputs.iter().position(|known| known.name == name);
        known.unwrap_or_else(|| {
            let with = output.with.map(|with| self.renamed(part, with));
            self.outputs.push(Output { name: leak(name), with, doc: said(output.doc, part), ..*output });
            self.outputs.len() - 1
        })
    }
}

/// The element of a part: its index and description.
fn element(bare: &'static Model, part: &DraftPart) -> (usize, &'static Model) {
    let found = bare.elements.iter().position(|model| model.name == part.element).unwrap_or(0);
    (found, bare.elements[found])
}

/// The name of a quantity of an element in the train: `k_x` and `overx` are those of the part `x`.
fn own(name: &str, part: &str) -> String {
    match name.strip_suffix("_x") {
        Some(of) => named(of, part),
        None => match name.strip_suffix('x') {
            Some(of) => format!("{of}{part}"),
            None => named(name, part),
        },
    }
}

/// What a description says of a part.
fn said(doc: &str, part: &DraftPart) -> &'static str {
    leak(doc.replace("{}", &part.name))
}

fn shown(part: &DraftPart) -> String {
    format!("{} {}", part.element.trim_start_matches("element_").replace('_', " "), part.name)
}
