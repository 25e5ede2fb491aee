//! The description of a train, from those of its elements.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock};

use super::basis::{self, Basis, resolve};
use super::draft::{Draft, DraftPart, Terms, named};
use super::{relative, text};
use crate::model::{
    Coordinate, Effect, Law, Model, Output, Parameter, Range, RigidMotion, Role, Start, Switch, Torque, Varies,
};
use crate::scene::mistake::Report;
use crate::train::{Factor, RotationForm, Row, Train};

type Composed = (&'static Model, Arc<Train>);

/// The models composed so far, by their content. Models are never freed. A train that is read again, for example at another point of a
/// sweep, gets the model that it had before.
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
    let parts = draft.parts.iter().map(|p| (p.element, &p.name, &p.renamed, &p.rows, &p.called, p.without));
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

pub(super) struct Composer<'a> {
    pub(super) bare: &'static Model,
    pub(super) draft: &'a Draft,
    pub(super) basis: &'a Basis,
    pub(super) parameters: Vec<Parameter>,
    /// The part from which a parameter comes.
    pub(super) owners: HashMap<&'static str, String>,
    pub(super) effects: Vec<Effect>,
    pub(super) laws: Vec<(Law, [usize; 2])>,
    pub(super) switches: Vec<Switch>,
    pub(super) torques: Vec<Torque>,
    pub(super) outputs: Vec<Output>,
    /// Outputs that are products: the output, and its two factors, another output and the rate of a displacement.
    pub(super) products: Vec<(usize, usize, Terms)>,
    /// Outputs that are multiples: the output, and its two factors, another output and a parameter.
    pub(super) multiples: Vec<(usize, usize, String)>,
    pub(super) nonlinear_with: Vec<(&'static [&'static str], &'static str)>,
}

pub(super) fn leak(text: impl Into<String>) -> &'static str {
    Box::leak(text.into().into_boxed_str())
}

impl<'a> Composer<'a> {
    fn new(bare: &'static Model, draft: &'a Draft, basis: &'a Basis) -> Self {
        let (parameters, owners, effects, laws) = (vec![], HashMap::new(), vec![], vec![]);
        let (switches, torques, outputs, products, multiples) = (vec![], vec![], vec![], vec![], vec![]);
        let nonlinear_with = vec![];
        Composer {
            bare,
            draft,
            basis,
            parameters,
            owners,
            effects,
            laws,
            switches,
            torques,
            outputs,
            products,
            multiples,
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
                gear_data: g.gear_data,
                varies: Varies::Never,
                range,
                above: None,
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
        // Stiffnesses first, then transmission errors, then friction. The parts have their laws in another order, and get these indices.
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
        let form = |terms: &Terms| -> RotationForm {
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
        let products = self.products.iter();
        let products = products.map(|(output, of, speed)| (*output, *of, form(&resolve(self.draft, speed)))).collect();
        let multiples = self.multiples.iter().map(|(output, of, name)| {
            (*output, *of, Factor { number: 1.0, powers: [(index(name), 1)].into_iter().collect() })
        });
        let train = Train {
            products,
            multiples: multiples.collect(),
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
            RigidMotion { name: leak(name), unit: "rad/s", doc: leak(doc) }
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
            relative: relative::of(self.draft).leak(),
            equations: leak(text::equations(self.bare, self.draft, self.basis)),
            ..*self.bare
        }
    }
}

/// The element of a part: its index and description.
pub(super) fn element(bare: &'static Model, part: &DraftPart) -> (usize, &'static Model) {
    let found = bare.elements.iter().position(|model| model.name == part.element);
    let found = found.expect("`train` has the elements of all parts");
    (found, bare.elements[found])
}

/// The name of a quantity of an element in the train: `k_x` and `overx` are those of the part `x`.
pub(super) fn own(name: &str, part: &str) -> String {
    match name.strip_suffix("_x") {
        Some(of) => named(of, part),
        None => match name.strip_suffix('x') {
            Some(of) => format!("{of}{part}"),
            None => named(name, part),
        },
    }
}

/// A description with the name of a part in place of `{}`.
pub(super) fn said(doc: &str, part: &DraftPart) -> &'static str {
    leak(doc.replace("{}", &part.name))
}

pub(super) fn shown(part: &DraftPart) -> String {
    format!("{} {}", part.element.trim_start_matches("element_").replace('_', " "), part.name)
}
