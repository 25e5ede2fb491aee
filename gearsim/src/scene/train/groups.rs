//! Groups of gears that mesh with one another: one base pitch, one phase.

use super::draft::{DraftGear, DraftPart, GearGroup, Geometry, Term, Terms, named};
use super::item::Item;
use super::read::Reader;
use crate::gear::{Contact, Gears};
use crate::model::{Law, Role};
use crate::scene::document::{Node, Value};
use crate::scene::field;
use crate::scene::mistake::Report;
use crate::scene::teeth::TeethReader;

/// The law of teeth whose geometry alone is needed.
const ANY: Law = Law {
    name: "k",
    unit: "N/m",
    phase: "",
    period: std::f64::consts::TAU,
    rolling: false,
    held: &[],
    with: None,
    role: Role::Stiffness,
    doc: "",
};

impl Reader<'_> {
    /// Adds a mesh of two gears with the deflection h (Q_1 + sense Q_2), where Q are the pitch counts. The second gear of an `internal`
    /// mesh is a ring gear. `angle` is the parameter that is its working pressure angle; `None`: that of all meshes without one.
    pub(super) fn geared(
        &mut self,
        name: String,
        item: &Item<'_>,
        gears: [DraftGear; 2],
        radius: Geometry,
        internal: bool,
        angle: Option<String>,
    ) -> usize {
        let same = |a: &DraftGear, b: &DraftGear| a.rotor == b.rotor && a.carrier == b.carrier && a.teeth == b.teeth;
        let has =
            |group: &GearGroup, gear: &DraftGear| group.gears.iter().any(|g| gear.rotor.is_some() && same(g, gear));
        let found: Vec<usize> = (0..self.draft.groups.len())
            .filter(|&i| gears.iter().any(|gear| has(&self.draft.groups[i], gear)))
            .collect();
        let group = match found[..] {
            [] => {
                let mesh = name.clone();
                let (phases, gears, meshes, stated, parts) = (vec![], vec![], vec![], vec![], vec![]);
                let of_first = radius.name.clone();
                self.draft.groups.push(GearGroup { mesh, phases, gears, radius: of_first, meshes, stated, parts });
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
        of.stated.push((item.title(), internal));
        let [first, second] = [of.gears[0].teeth.clone(), of.radius.clone()];
        let count = |gear: &DraftGear, number: f64, powers: &[(&str, i32)]| {
            let all = [&[(gear.teeth.as_str(), 1)], powers].concat();
            let of =
                |rotor: Option<usize>, sign: f64| rotor.map(|rotor| Term::new(rotor, sign * number * gear.sense, &all));
            [of(gear.rotor, 1.0), of(gear.carrier, -1.0)].into_iter().flatten().collect::<Terms>()
        };
        let h = [(second.as_str(), 1), (first.as_str(), -1)];
        let s = [count(&gears[0], 1.0, &h), count(&gears[1], -1.0, &h)].concat();
        let mean = [count(&gears[0], 0.5, &[]), count(&gears[1], 0.5, &[])].concat();
        of.phases.push(mean);
        // The rotation of the first gear relative to the second. A carrier turns both alike.
        let turns = |gear: &DraftGear, sign: f64| gear.rotor.map(|rotor| Term::new(rotor, sign * gear.sense, &[]));
        let psi = [turns(&gears[0], 1.0), turns(&gears[1], if internal { -1.0 } else { 1.0 })];
        // The power is given by the gear that turns about a fixed axis: its flank moves by r theta. In a mesh with planets this is the sun,
        // which is the first gear, or the ring, which is the second.
        let given = usize::from(internal && gears[0].carrier.is_some());
        let flank = [&[(gears[given].teeth.as_str(), 1)], &h[..]].concat();
        let side = [1.0, -1.0][given] * gears[given].sense;
        let driving = gears[given].rotor.map(|rotor| Term::new(rotor, side, &flank));
        let driving = driving.into_iter().collect();
        // The phase is set when all meshes of the group are known.
        let rows = vec![vec![], s, psi.into_iter().flatten().collect()];
        of.parts.push(self.draft.parts.len());
        let (place, called) = (item.place.clone(), named("s", &name));
        let renamed = angle.map(|angle| ("alpha", angle)).into_iter().collect();
        let element = "element_mesh_with_friction";
        self.draft.parts.push(DraftPart {
            element,
            name,
            place,
            renamed,
            rows,
            driving,
            called,
            without: item.undamped(),
        });
        group
    }

    /// The base radius of the first gear of the group of the mesh, from its own key or from the module.
    pub(super) fn radius(&mut self, item: &Item<'_>, teeth: &str) {
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
            (Some(node), Some(_)) => self.stated_twice(item, &node),
            (Some(node), None) => self.value(radius, Some(&node)),
            (None, Some(node)) => {
                self.fixed(teeth, item.path("teeth.0"));
                if let Some(r) = self.radius_by_module(item, &node, teeth) {
                    let value = Value::Text(format!("{r} m"));
                    self.value(radius, Some(&Node { value, place: node.place }));
                }
            }
            (None, None) if leads => self.lacking(format!("parameters.{radius}"), item, "base_radius"),
            (None, None) => {}
        }
    }

    /// Refuses a base radius beside a module.
    pub(super) fn stated_twice(&mut self, item: &Item<'_>, base_radius: &Node) {
        let help = "leave out one of them: base radius = module teeth cos(pressure angle)/2, in the transverse plane";
        let message = format!("{} has `base_radius` and `module`", item.title());
        self.report.add(&base_radius.place, message, "twice", help);
    }

    /// The base radius of the gear whose number of teeth is called `teeth`, by the `module` of an item and its angles [m].
    pub(super) fn radius_by_module(&mut self, item: &Item<'_>, module: &Node, teeth: &str) -> Option<f64> {
        let module = field::quantity(&item.path("module"), module, "m", self.report);
        let teeth = self.draft.values.iter().find(|value| value.0 == teeth).map(|value| value.1.clone());
        let teeth = teeth.and_then(|node| field::quantity(&item.path("teeth"), &node, "1", self.report));
        Some(teeth? * self.basic_rack(item, module?)?.base_radius_per_tooth())
    }

    /// Notes that other values follow from a parameter, which the key `path` states.
    pub(super) fn fixed(&mut self, parameter: &str, path: String) {
        self.draft.fixed.push((parameter.into(), path));
    }

    /// The transverse pressure angle of an item that states an angle, as a value of the scene.
    pub(super) fn transverse_angle(&mut self, item: &Item<'_>) -> Option<Node> {
        if item.get("module").or(item.get("helix_angle")).is_some() {
            self.fixed(&named("alpha", item.name), item.path("pressure_angle"));
        }
        let Some(helix) = item.get("helix_angle") else { return item.get("pressure_angle").cloned() };
        let (_, angle) = self.basic_rack(item, 1.0)?.transverse();
        Some(Node { value: Value::Text(format!("{angle} rad")), place: helix.place.clone() })
    }

    /// The contact of the teeth of a stiffness, if it has teeth. Mistakes in them are reported when the law is read.
    pub(super) fn contact(&self, stiffness: Option<&Node>, internal: bool) -> Option<Contact> {
        let Node { value: Value::Table(entries), place } = stiffness? else { return None };
        let reader = TeethReader { law: &ANY, entries, place };
        let gears = reader.given().then(|| reader.gears(&mut Report::new())).flatten()?;
        Gears { internal, ..gears }.contact().ok()
    }

    /// The working pressure angle of the teeth of a stiffness, as a value of the scene; `None` if it has no teeth.
    pub(super) fn working_angle(&self, stiffness: Option<&Node>, internal: bool) -> Option<Node> {
        let contact = self.contact(stiffness, internal)?;
        Some(Node { value: Value::Text(format!("{} rad", contact.angle)), place: stiffness?.place.clone() })
    }

    /// Gears with the angles of an item and a normal module [m].
    pub(super) fn basic_rack(&mut self, item: &Item<'_>, module: f64) -> Option<Gears> {
        let mut angle = |key: &str, usual: f64| match item.get(key) {
            Some(node) => field::quantity(&item.path(key), node, "rad", self.report),
            None => Some(usual),
        };
        let (pressure, helix) = (angle("pressure_angle", 20f64.to_radians())?, angle("helix_angle", 0.0)?);
        // Numbers of teeth and the face width have no influence here.
        Some(Gears { helix_angle: helix, ..Gears::standard([1.0; 2], module, pressure, 1.0) })
    }
}
