//! Reads the tables of a train.

use super::TABLES;
use super::draft::{Draft, DraftPart, Gear, Geometry, Group, Joint, Rotor, Term, Terms, named};
use crate::scene::document::{Entry, Node, Place, Value};
use crate::scene::mistake::Report;
use crate::scene::{field, keys};

/// The name of what does not turn.
pub(super) const GROUND: &str = "ground";

/// Reads all tables. `None` if a mistake was reported that leaves no train.
pub(super) fn draft(entries: &[Entry], root: &Node, report: &mut Report) -> Option<Draft> {
    let before = report.len();
    if keys::get(entries, "rotors").is_none() {
        let lines = "[rotors]\nmotor = \"... kg*m^2\"  # name = moment of inertia".to_string();
        keys::missing(&[("[rotors]", lines)], "a scene of the model `train`", &root.place, report);
        return None;
    }
    let mut reader = Reader { draft: Draft::default(), report };
    for table in TABLES {
        let Some(node) = keys::get(entries, table) else { continue };
        let Some(items) = field::table(table, node, reader.report) else { continue };
        let mut items: Vec<&Entry> = items.iter().collect();
        // In the order of the text: a table of TOML has none of its own.
        items.sort_by_key(|item| (item.place.source, item.place.span.start));
        for item in items {
            if reader.is_name(table, item) {
                reader.item(table, item);
            }
        }
    }
    let draft = reader.draft;
    (report.len() == before).then_some(draft)
}

pub(super) struct Reader<'a> {
    pub draft: Draft,
    pub report: &'a mut Report,
}

/// A table of one part: its path, keys and place.
pub(super) struct Item<'a> {
    pub table: &'static str,
    pub name: &'a str,
    pub entries: &'a [Entry],
    pub place: &'a Place,
}

impl Item<'_> {
    fn path(&self, key: &str) -> String {
        format!("{}.{}.{key}", self.table, self.name)
    }

    pub fn title(&self) -> String {
        format!("[{}.{}]", self.table, self.name)
    }

    pub fn get(&self, key: &str) -> Option<&Node> {
        keys::get(self.entries, key)
    }
}

impl Reader<'_> {
    /// Whether the name of a part can be part of the names of parameters.
    fn is_name(&mut self, table: &str, item: &Entry) -> bool {
        let fits = |name: &str| {
            name.len() <= 32 && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') && name != GROUND
        };
        if fits(&item.key) && !item.key.is_empty() {
            return true;
        }
        let message = format!("`{}` cannot be a name in [{table}]", item.key);
        let help = format!("use letters, digits and `_`, at most 32; `{GROUND}` is what does not turn");
        self.report.add(&item.place, message, "not a name", help);
        false
    }

    fn item(&mut self, table: &'static str, entry: &Entry) {
        if table == "rotors" {
            return self.rotor(entry);
        }
        let Some(entries) = field::table(&format!("{table}.{}", entry.key), &entry.node, self.report) else { return };
        let item = Item { table, name: &entry.key, entries, place: &entry.place };
        match table {
            "shafts" => self.shaft(&item),
            "supports" => self.support(&item),
            "meshes" => self.mesh(&item),
            "planets" => self.planets(&item),
            "bearings" => self.bearing(&item),
            "clutches" => self.clutch(&item),
            _ => self.torque(&item),
        }
    }

    /// Reports unknown keys of an item.
    pub fn known(&mut self, item: &Item<'_>, allowed: &[&str]) {
        keys::known(item.entries, &item.title(), allowed, self.report);
    }

    /// A key of an item that it must have.
    pub fn needed<'a>(&mut self, item: &'a Item<'_>, key: &'static str, example: &str) -> Option<&'a Node> {
        let node = item.get(key);
        if node.is_none() {
            keys::missing(&[(key, format!("{key} = {example}"))], &item.title(), item.place, self.report);
        }
        node
    }

    /// A value that is a parameter: it is read with `[parameters]`.
    pub fn value(&mut self, parameter: String, node: Option<&Node>) {
        self.draft.values.extend(node.map(|node| (parameter, node.clone())));
    }

    /// The rotor that a key names; `Some(None)` for the ground, if that is allowed.
    pub fn end(&mut self, path: &str, node: &Node, ground: bool) -> Option<Option<usize>> {
        let mut names: Vec<&str> = self.draft.rotors.iter().map(|rotor| rotor.name.as_str()).collect();
        if ground {
            names.push(GROUND);
        }
        let i = field::choice(path, node, "rotor", &names, self.report)?;
        Some((i < self.draft.rotors.len()).then_some(i))
    }

    /// The rotor of an item.
    fn rotor_of(&mut self, item: &Item<'_>) -> Option<usize> {
        let node = self.needed(item, "rotor", "\"...\"")?;
        self.end(&item.path("rotor"), node, false)?
    }

    /// The two rotors of an item.
    fn between(&mut self, item: &Item<'_>, ground: bool) -> Option<[Option<usize>; 2]> {
        let node = self.needed(item, "between", "[\"...\", \"...\"]")?;
        let path = item.path("between");
        let items = field::array(&path, node, "[\"motor\", \"1\"]", self.report)?;
        let [a, b] = items else {
            let help = "a part is between two rotors: between = [\"motor\", \"1\"]";
            self.report.add(
                &node.place,
                format!("`{path}` must have two names, not {}", items.len()),
                "two names",
                help,
            );
            return None;
        };
        let ends = [self.end(&path, a, ground), self.end(&path, b, ground)];
        let [Some(a), Some(b)] = ends else { return None };
        if a == b {
            let help = "name two different rotors";
            self.report.add(&node.place, format!("{} joins a rotor with itself", item.title()), "twice the same", help);
            return None;
        }
        Some([a, b])
    }

    /// Adds a part with one coordinate.
    pub fn part(&mut self, item: &Item<'_>, element: &'static str, called: String, rows: Vec<Terms>) {
        let (name, place) = (item.name.to_string(), item.place.clone());
        self.draft.parts.push(DraftPart { element, name, place, renamed: vec![], rows, called });
    }

    /// Notes that a part joins two rotors.
    pub fn join(&mut self, item: &Item<'_>, ends: [Option<usize>; 2], turns: bool) {
        if let [Some(a), Some(b)] = ends {
            let (place, part) = (item.place.clone(), item.title());
            self.draft.joints.push(Joint { ends: [a, b], turns, place, part });
        }
    }

    fn rotor(&mut self, entry: &Entry) {
        let name = entry.key.clone();
        let inertia = match &entry.node.value {
            Value::Table(entries) => {
                let item = Item { table: "rotors", name: &name, entries, place: &entry.place };
                self.known(&item, &["inertia"]);
                item.get("inertia").cloned()
            }
            _ => Some(entry.node.clone()),
        };
        self.value(named("I", &name), inertia.as_ref());
        let rotor = self.draft.rotors.len();
        let place = entry.place.clone();
        let (rows, called) = (vec![vec![Term::new(rotor, 1.0, &[])]], String::new());
        self.draft.rotors.push(Rotor { name: name.clone(), of: None });
        self.draft.parts.push(DraftPart { element: "element_rotor", name, place, renamed: vec![], rows, called });
    }

    fn shaft(&mut self, item: &Item<'_>) {
        self.known(item, &["between", "stiffness", "damping"]);
        let Some(ends) = self.between(item, true) else { return };
        self.join(item, ends, false);
        self.spring(item, "element_shaft", ends);
    }

    fn support(&mut self, item: &Item<'_>) {
        self.known(item, &["rotor", "stiffness", "damping"]);
        let Some(rotor) = self.rotor_of(item) else { return };
        self.spring(item, "element_support", [Some(rotor), None]);
    }

    fn spring(&mut self, item: &Item<'_>, element: &'static str, ends: [Option<usize>; 2]) {
        self.value(named("k", item.name), item.get("stiffness"));
        let row = difference(ends);
        self.part(item, element, named("psi", item.name), vec![row.clone()]);
        if let Some(node) = item.get("damping") {
            self.value(named("c", item.name), Some(node));
            self.part(item, "element_viscous", String::new(), vec![row]);
        }
    }

    fn bearing(&mut self, item: &Item<'_>) {
        self.known(item, &["rotor", "viscous", "friction", "breakaway"]);
        let Some(rotor) = self.rotor_of(item) else { return };
        let row = vec![Term::new(rotor, 1.0, &[])];
        let [viscous, friction] = ["viscous", "friction"].map(|key| item.get(key));
        if viscous.is_none() && friction.is_none() {
            let help = "add viscous = \"... N*m*s/rad\", or friction = \"... N*m\", or both";
            self.report.add(item.place, format!("{} has no friction", item.title()), "nothing given", help);
        }
        if viscous.is_some() {
            self.value(named("c", item.name), viscous);
            self.part(item, "element_viscous", String::new(), vec![row.clone()]);
        }
        if friction.is_some() {
            self.value(named("Tc", item.name), friction);
            self.value(named("rise", item.name), item.get("breakaway"));
            self.part(item, "element_dry_friction", String::new(), vec![row]);
        }
    }

    fn clutch(&mut self, item: &Item<'_>) {
        self.known(item, &["between", "capacity", "drag"]);
        let Some(ends) = self.between(item, true) else { return };
        self.join(item, ends, false);
        self.value(named("Tmax", item.name), item.get("capacity"));
        self.value(named("Tdrag", item.name), item.get("drag"));
        self.part(item, "element_clutch", String::new(), vec![difference(ends)]);
    }

    /// A drive or a load.
    fn torque(&mut self, item: &Item<'_>) {
        let kinds = if item.table == "drives" { DRIVES } else { LOADS };
        let allowed: Vec<_> = std::iter::once("rotor").chain(kinds.iter().map(|kind| kind.0)).collect();
        self.known(item, &allowed);
        let Some(rotor) = self.rotor_of(item) else { return };
        let given: Vec<_> = kinds.iter().filter(|kind| item.get(kind.0).is_some()).collect();
        let kind = match given[..] {
            [] => &kinds[0],
            [kind] => kind,
            _ => {
                let help = format!("give one of {}", crate::scene::list(&allowed[1..]));
                self.report.add(item.place, format!("{} has several torques", item.title()), "one torque", help);
                return;
            }
        };
        let (key, element, parameters) = kind;
        match (parameters, item.get(key)) {
            ([(_, parameter)], node) => self.value(named(parameter, item.name), node),
            (_, None) => {}
            (several, Some(node)) => {
                let Some(entries) = field::table(&item.path(key), node, self.report) else { return };
                let known: Vec<_> = several.iter().map(|(key, _)| *key).collect();
                keys::known(entries, &format!("`{}`", item.path(key)), &known, self.report);
                for (key, parameter) in *several {
                    self.value(named(parameter, item.name), keys::get(entries, key));
                }
            }
        }
        self.part(item, element, String::new(), vec![vec![Term::new(rotor, 1.0, &[])]]);
    }

    fn mesh(&mut self, item: &Item<'_>) {
        let allowed = ["between", "internal", "teeth", "base_radius", "module", "pressure_angle", "stiffness", "error"];
        self.known(item, &[&allowed[..], &["backlash", "friction"]].concat());
        let Some(ends) = self.between(item, true) else { return };
        let internal = match item.get("internal") {
            Some(node) => field::flag(&item.path("internal"), node, self.report) == Some(true),
            None => false,
        };
        self.join(item, ends, !internal);
        let Some(teeth) = self.teeth(item, ends) else { return };
        let rigid = matches!(item.get("stiffness").map(|node| &node.value), Some(Value::Text(text)) if text == "rigid");
        if rigid {
            return self.rigid(item, ends, teeth);
        }
        let law = |name: &str, key: &str| item.get(key).map(|node| (named(name, item.name), node.clone()));
        let laws = [law("k", "stiffness"), law("e", "error")];
        self.draft.laws.extend(laws.into_iter().flatten());
        self.value(named("b", item.name), item.get("backlash"));
        self.value(named("mu", item.name), item.get("friction"));
        let gears = [0, 1].map(|i| Gear { rotor: ends[i], carrier: None, teeth: teeth[i].clone(), sense: 1.0 });
        let psi = gears.iter().filter_map(|gear| gear.rotor).map(|rotor| Term::new(rotor, 1.0, &[])).collect();
        let element = if internal { "element_mesh" } else { "element_mesh_with_friction" };
        let first = ends[0].map_or(GROUND, |i| &self.draft.rotors[i].name);
        let radius = named("r", if teeth[0] == named("N", first) { first } else { item.name });
        let radius = Geometry { name: radius, unit: "m", doc: format!("base radius of gear {first}") };
        self.geared(item.name.to_string(), item, element, gears, radius, (!internal).then_some(psi));
        self.radius(item, &teeth[0]);
    }

    /// The names of the numbers of teeth of the gears of a mesh.
    fn teeth(&mut self, item: &Item<'_>, ends: [Option<usize>; 2]) -> Option<[String; 2]> {
        let given = match item.get("teeth") {
            None => None,
            Some(node) => {
                let items = field::array(&item.path("teeth"), node, "[20, 40]", self.report)?;
                let [a, b] = items else {
                    let message = format!("`{}` must have two numbers, not {}", item.path("teeth"), items.len());
                    self.report.add(&node.place, message, "two numbers", "one for each gear: teeth = [20, 40]");
                    return None;
                };
                Some([a, b])
            }
        };
        let names = [0, 1].map(|i| {
            let rotor =
                ends[i].map_or_else(|| format!("{}_{GROUND}", item.name), |i| self.draft.rotors[i].name.clone());
            let own = named("N", &rotor);
            let (Some(given), Some(before)) = (given, self.draft.values.iter().find(|value| value.0 == own)) else {
                return own;
            };
            // A second gear on the rotor, with another number of teeth, has a name of its own.
            if same(&before.1, given[i]) { own } else { named("N", &format!("{rotor}_{}", item.name)) }
        });
        for (i, name) in names.iter().enumerate() {
            if !self.draft.geometry.iter().any(|known| known.name == *name) {
                let gear = name.trim_start_matches('N').trim_start_matches('_');
                let doc = format!("number of teeth of gear {gear}");
                self.draft.geometry.push(Geometry { name: name.clone(), unit: "1", doc });
            }
            if !self.draft.values.iter().any(|value| value.0 == *name) {
                self.value(name.clone(), given.map(|given| given[i]));
            }
        }
        Some(names)
    }

    /// The rotor of one gear turns with that of the other.
    fn rigid(&mut self, item: &Item<'_>, ends: [Option<usize>; 2], teeth: [String; 2]) {
        let keys = ["base_radius", "module", "error", "backlash", "friction"];
        for key in keys.into_iter().filter(|key| item.get(key).is_some()) {
            let message = format!("{} has `stiffness = \"rigid\"` and `{key}`", item.title());
            let help = "leave it out, or give a stiffness";
            self.report.add(item.place, message, "rigid gears do not have it", help);
        }
        let [Some(a), Some(b)] = ends else {
            let message = format!("{} gears a rotor rigidly to the ground", item.title());
            self.report.add(item.place, message, "it could not turn", "give the mesh a stiffness");
            return;
        };
        let root = |mut i: usize, rotors: &[Rotor]| {
            while let Some(of) = &rotors[i].of {
                i = of.rotor;
            }
            i
        };
        let (of_a, of_b) = (root(a, &self.draft.rotors), root(b, &self.draft.rotors));
        if of_a == of_b {
            let message = format!("{} closes a loop of rigid gears", item.title());
            self.report.add(item.place, message, "a second ratio", "give one mesh of the loop a stiffness");
            return;
        }
        // theta_b = N_a/N_b theta_a: so the root of b turns with a.
        let [na, nb] = &teeth;
        let mut powers = vec![(na.clone(), 1), (nb.clone(), -1)];
        let mut at = b;
        while let Some(of) = &self.draft.rotors[at].of {
            powers.extend(of.powers.iter().map(|(name, power)| (name.clone(), -power)));
            at = of.rotor;
        }
        self.draft.rotors[of_b].of = Some(Term { rotor: a, number: 1.0, powers });
    }

    /// Adds a mesh of two gears with the deflection h (Q_1 + sense Q_2), where Q are the pitch counts.
    pub fn geared(
        &mut self,
        name: String,
        item: &Item<'_>,
        element: &'static str,
        gears: [Gear; 2],
        radius: Geometry,
        psi: Option<Terms>,
    ) -> usize {
        let same = |a: &Gear, b: &Gear| a.rotor == b.rotor && a.carrier == b.carrier && a.teeth == b.teeth;
        let has = |group: &Group, gear: &Gear| group.gears.iter().any(|g| gear.rotor.is_some() && same(g, gear));
        let found: Vec<usize> = (0..self.draft.groups.len())
            .filter(|&i| gears.iter().any(|gear| has(&self.draft.groups[i], gear)))
            .collect();
        let group = match found[..] {
            [] => {
                let mesh = name.clone();
                let (phases, gears, meshes, parts) = (vec![], vec![], vec![], vec![]);
                self.draft.groups.push(Group { mesh, phases, gears, radius: radius.name.clone(), meshes, parts });
                self.draft.geometry.push(radius);
                self.draft.groups.len() - 1
            }
            [only] => only,
            [into, from, ..] => {
                let gone = self.draft.groups[from].mesh.clone();
                let message = format!("{} joins the gears of mesh {gone} with other gears", item.title());
                let help = format!("list this mesh before mesh {gone}: gears that mesh have one base pitch");
                self.report.add(item.place, message, "listed too late", help);
                into
            }
        };
        let of = &mut self.draft.groups[group];
        let mut index = [0; 2];
        for (i, gear) in gears.iter().enumerate() {
            index[i] = of.gears.iter().position(|g| same(g, gear)).unwrap_or_else(|| {
                of.gears.push(gear.clone());
                of.gears.len() - 1
            });
        }
        of.meshes.push(index);
        let [first, second] = [of.gears[0].teeth.clone(), of.radius.clone()];
        let count = |gear: &Gear, number: f64, powers: &[(&str, i32)]| {
            let all = [&[(gear.teeth.as_str(), 1)], powers].concat();
            let of =
                |rotor: Option<usize>, sign: f64| rotor.map(|rotor| Term::new(rotor, sign * number * gear.sense, &all));
            [of(gear.rotor, 1.0), of(gear.carrier, -1.0)].into_iter().flatten().collect::<Terms>()
        };
        let h = [(second.as_str(), 1), (first.as_str(), -1)];
        let s = [count(&gears[0], 1.0, &h), count(&gears[1], -1.0, &h)].concat();
        let mean = [count(&gears[0], 0.5, &[]), count(&gears[1], 0.5, &[])].concat();
        of.phases.push(mean);
        // The phase is set when all meshes of the group are known.
        let rows = [Some(vec![]), Some(s), psi].into_iter().flatten().collect();
        of.parts.push(self.draft.parts.len());
        let (place, called) = (item.place.clone(), named("s", &name));
        self.draft.parts.push(DraftPart { element, name, place, renamed: vec![], rows, called });
        group
    }

    /// The base radius of the first gear of the group of the mesh, from its own key or from the module.
    pub fn radius(&mut self, item: &Item<'_>, teeth: &str) {
        let Some(group) = self.draft.groups.iter().rfind(|group| group.parts.contains(&(self.draft.parts.len() - 1)))
        else {
            return;
        };
        let (radius, leads) = (group.radius.clone(), group.gears[0].teeth == teeth && group.parts.len() == 1);
        let [base, module] = ["base_radius", "module"].map(|key| item.get(key).cloned());
        if !leads && let Some(node) = base.as_ref().or(module.as_ref()) {
            let message = format!("{} states its base pitch again", item.title());
            let help = format!("gears that mesh have one base pitch: that of mesh {}; leave it out here", group.mesh);
            return self.report.add(&node.place, message, "stated before", help);
        }
        match (base, module) {
            (Some(node), Some(_)) => {
                let help = "leave out one of them: base radius = module teeth cos(pressure angle)/2";
                self.report.add(&node.place, format!("{} has `base_radius` and `module`", item.title()), "twice", help);
            }
            (Some(node), None) => self.value(radius, Some(&node)),
            (None, Some(node)) => {
                let m = field::quantity(&item.path("module"), &node, "m", self.report);
                let angle = match item.get("pressure_angle") {
                    Some(node) => field::quantity(&item.path("pressure_angle"), node, "rad", self.report),
                    None => Some(20f64.to_radians()),
                };
                let teeth = self.draft.values.iter().find(|value| value.0 == teeth).cloned();
                let teeth = teeth.map(|(_, node)| field::quantity(&item.path("teeth"), &node, "1", self.report));
                if let (Some(m), Some(angle), Some(Some(teeth))) = (m, angle, teeth) {
                    let value = Value::Text(format!("{} m", m * teeth * angle.cos() / 2.0));
                    self.value(radius, Some(&Node { value, place: node.place }));
                }
            }
            (None, None) => {}
        }
    }
}

/// Kinds of drives and loads: key, element, and its parameters by the keys in its table.
type Kinds = &'static [(&'static str, &'static str, &'static [(&'static str, &'static str)])];

const DRIVES: Kinds = &[
    ("torque", "element_drive", &[("", "T")]),
    ("governor", "element_governor", &[("gain", "c"), ("set_point", "n")]),
    ("dc_motor", "element_dc_motor", &[("stall_torque", "Ts"), ("no_load_speed", "n0")]),
    (
        "induction_motor",
        "element_induction_motor",
        &[("breakdown_torque", "Tb"), ("breakdown_slip", "sb"), ("synchronous_speed", "ns")],
    ),
];
const LOADS: Kinds = &[
    ("torque", "element_load", &[("", "T")]),
    ("fan", "element_fan", &[("coefficient", "cf"), ("corner_speed", "w0")]),
];

/// The rotation of the first rotor relative to the second.
fn difference([a, b]: [Option<usize>; 2]) -> Terms {
    [(a, 1.0), (b, -1.0)].into_iter().filter_map(|(end, sign)| end.map(|rotor| Term::new(rotor, sign, &[]))).collect()
}

/// Whether two values are written with the same number.
fn same(a: &Node, b: &Node) -> bool {
    match (&a.value, &b.value) {
        (Value::Number(a), Value::Number(b)) => a == b,
        (Value::Text(a), Value::Text(b)) => a == b,
        _ => false,
    }
}
