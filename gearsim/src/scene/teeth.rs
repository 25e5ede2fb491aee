//! A mesh stiffness or a friction law, computed from the teeth of its gears.
//!
//! The unit of the law decides how the stiffness is scaled, so that no key states the scale. One pitch of the phase is one base
//! pitch p_b on the line of action. A stiffness
//! - in N/m is the stiffness kt along the line of action, V = kt delta²/2, delta in metres (`components::mesh_with_play`, used by most models);
//! - in N·m is that of Oh, Grosh & Barber, V = k phi², with the relative rotation N1 theta1 - N2 theta2 = 2 phi of the gears,
//!   hence delta = 2 h phi with h = r_b1/N1, for spur gears m cos(alpha)/2, and k = 2 kt h² (`gear_pair`).
//!
//! A stiffness in another unit cannot be computed from teeth.

use std::f64::consts::PI;

use super::document::{KeyEntry, Node, Place, Value};
use super::keys::{Key, Kind, key};
use super::mistake::Report;
use super::{field, keys};
use crate::gear::{self, CellShape, FrictionLaw, GearError, Gears, LINE_LOADS, Material, StiffnessMethod};
use crate::model::{Law, Role};
use crate::profile::Profile;
use crate::tolerance::scene;

/// Keys of the gears of a law that is computed from teeth.
pub(super) const GEARS: &[Key] = &[
    key(
        "teeth",
        Kind::List(&Kind::Number),
        "none",
        "numbers of teeth, driving gear first: the law is computed from them",
    ),
    key("module", Kind::Quantity("m"), "required with teeth", "normal module"),
    key("face_width", Kind::Quantity("m"), "required with teeth", "width of the common face"),
    key("pressure_angle", Kind::Quantity("rad"), "20 deg", "pressure angle of the basic rack"),
    key("helix_angle", Kind::Quantity("rad"), "0 deg", "helix angle at the reference cylinder"),
    key("addendum", BOTH, "1", "height of the addendum of the basic rack, in modules"),
    key("dedendum", BOTH, "1.25", "depth of the dedendum of the basic rack, in modules"),
    key("fillet", Kind::Number, "0.38", "radius of the root fillet of the basic rack, in modules"),
    key("profile_shift", BOTH, "0", "profile shift, in modules"),
    key("centre_distance", Kind::Quantity("m"), "that without backlash", "working centre distance"),
    key("internal", Kind::Flag, "false", "whether the second gear is a ring gear"),
    key("young", BOTH_IN_PASCAL, "206 GPa", "Young's modulus"),
    key("poisson", BOTH, "0.3", "Poisson's ratio"),
    key("bore", BOTH_IN_METRES, "half the root diameter", "diameter of the bore"),
];
/// How tooth pairs share the force.
pub(super) const SHARED: &[Key] = &[key(
    "method",
    Kind::Choice(&METHODS),
    "iso6336",
    "or energy: bending, shear and compression of the teeth, contact, gear bodies",
)];
/// Keys that only a stiffness from teeth has.
pub(super) const STIFFNESS: &[Key] = &[
    key(
        "course",
        Kind::Choice(&CELL_SHAPES),
        "levels",
        "curves: varies between the steps too, method energy only; helical gears always have ramps",
    ),
    key(
        "line_load",
        Kind::Quantity("N/m"),
        "at least 100 N/mm",
        "tangential force per face width, method iso6336 only",
    ),
];

/// One number for both gears, or two.
const BOTH: Kind = Kind::Either(&[Kind::Number, Kind::List(&Kind::Number)]);
const BOTH_IN_PASCAL: Kind = Kind::Either(&[Kind::Quantity("Pa"), Kind::List(&Kind::Quantity("Pa"))]);
const BOTH_IN_METRES: Kind = Kind::Either(&[Kind::Quantity("m"), Kind::List(&Kind::Quantity("m"))]);

const METHODS: [&str; 2] = ["iso6336", "energy"];
const CELL_SHAPES: [&str; 2] = ["levels", "curves"];
/// Range of a positive quantity: what messages say of it, the smallest and the largest value.
const POSITIVE: (&str, f64, f64) = ("must be positive", f64::MIN_POSITIVE, f64::INFINITY);

/// Reads a law that is computed from teeth.
pub(super) struct TeethReader<'a> {
    pub(super) law: &'a Law,
    /// The table of the law.
    pub(super) entries: &'a [KeyEntry],
    pub(super) place: &'a Place,
}

impl TeethReader<'_> {
    /// Whether the law has keys of teeth.
    pub(super) fn given(&self) -> bool {
        let keys = keys::names(&[GEARS, SHARED, STIFFNESS]);
        self.entries.iter().any(|entry| keys.contains(&entry.key.as_str()))
    }

    /// Reads a stiffness.
    pub(super) fn read(&self, report: &mut Report) -> Option<Profile> {
        self.stiffness(gear::stiffness, report)
    }

    /// Reads the stiffness of a transverse section, and the width of the window over which helical gears average it [unit of the phase].
    pub(super) fn of_section(&self, report: &mut Report) -> Option<(Profile, f64)> {
        self.stiffness(gear::of_section, report)
    }

    fn stiffness<T>(
        &self,
        compute: fn(&Gears, StiffnessMethod, CellShape, f64, f64) -> Result<T, GearError>,
        report: &mut Report,
    ) -> Option<T> {
        let scale = self.scale(report);
        let (gears, method) = (self.gears(report), self.stiffness_method(report));
        let shape = match self.get("course") {
            None => Some(CellShape::Levels),
            Some(node) => field::choice(&self.path("course"), node, "course", &CELL_SHAPES, report)
                .map(|i| if i == 0 { CellShape::Levels } else { CellShape::Curves }),
        };
        let (gears, scale) = (gears?, scale?);
        let per = scale(&gears);
        let law = compute(&gears, method?, shape?, self.law.period, per);
        law.map_err(|e| self.refused(self.at(), e, report)).ok()
    }

    /// Computes a friction law from these teeth.
    pub(super) fn friction_law(&self, report: &mut Report) -> Option<Result<Profile, GearError>> {
        let (gears, method) = (self.gears(report), self.stiffness_method(report));
        let gears = gears?;
        let (what, scale) = match (self.law.role, self.law.unit) {
            (Role::Side, _) => (FrictionLaw::Side, 1.0),
            (_, "m") => (FrictionLaw::Arm, 1.0),
            // The deflection is a phase: one base pitch is one period of the phase.
            _ => (FrictionLaw::Arm, self.law.period / (2.0 * PI * gears.base_radius_per_tooth())),
        };
        Some(gear::friction(&gears, method?, what, self.law.period, scale))
    }

    /// The factor from a stiffness in N/m to the unit of the law.
    fn scale(&self, report: &mut Report) -> Option<fn(&Gears) -> f64> {
        match self.law.unit {
            "N/m" => Some(|_| 1.0),
            "N*m" => Some(|gears| 2.0 * gears.base_radius_per_tooth().powi(2)),
            other => {
                let message =
                    format!("`laws.{}` is measured in {other} and cannot be computed from teeth", self.law.name);
                let help =
                    "teeth give stiffnesses in N/m (along the line of action) and in N*m (as in gear_pair); give steps";
                report.add(self.place, message, "no teeth allowed", help);
                None
            }
        }
    }

    /// Reads the gears.
    pub(super) fn gears(&self, report: &mut Report) -> Option<Gears> {
        let lines = [
            ("teeth", "teeth = [24, 96]"),
            ("module", "module = \"... mm\""),
            ("face_width", "face_width = \"... mm\""),
        ];
        let lacking = lines.iter().filter(|(key, _)| self.get(key).is_none());
        let lacking: Vec<_> = lacking.map(|(key, line)| (*key, line.to_string())).collect();
        keys::missing(&lacking, &format!("[laws.{}]", self.law.name), self.place, report);
        let internal =
            self.get("internal").map_or(Some(false), |node| field::flag(&self.path("internal"), node, report));
        let teeth = self.teeth(report);
        let one = |key: &str, unit: &str, range: (&str, f64, f64), default: Option<f64>, report: &mut Report| {
            self.get(key).map_or(default, |node| within(&self.path(key), node, unit, range, report))
        };
        let modules = ("must lie between 0.01 and 100 mm", *scene::MODULES.start(), *scene::MODULES.end());
        let module = one("module", "m", modules, None, report);
        let widths = ("must lie between 0.01 mm and 10 m", *scene::FACE_WIDTHS.start(), *scene::FACE_WIDTHS.end());
        let face_width = one("face_width", "m", widths, None, report);
        let angles = ("must lie between 5 and 45 deg", 5f64.to_radians(), 45f64.to_radians());
        let pressure_angle = one("pressure_angle", "rad", angles, Some(20f64.to_radians()), report);
        let helices = ("must lie between 0 and 45 deg", 0.0, 45f64.to_radians());
        let helix_angle = one("helix_angle", "rad", helices, Some(0.0), report);
        let rounds = ("must lie between 0 and 1, in modules", 0.0, 1.0);
        let fillet = one("fillet", "1", rounds, Some(0.38), report);
        let centre_distance =
            self.get("centre_distance").map(|node| within(&self.path("centre_distance"), node, "m", POSITIVE, report));
        let heights = ("must lie between 0 and 5, in modules", 0.0, 5.0);
        let addendum = self.both("addendum", "1", heights, 1.0, report);
        let dedendum = self.both("dedendum", "1", heights, 1.25, report);
        let shift = self.both("profile_shift", "1", ("must lie between -5 and 5, in modules", -5.0, 5.0), 0.0, report);
        let moduli = ("must lie between 1 MPa and 2000 GPa", *scene::YOUNG.start(), *scene::YOUNG.end());
        let young = self.both("young", "Pa", moduli, Material::STEEL.young, report);
        let poisson =
            self.both("poisson", "1", ("must lie between 0 and 0.5", 0.0, 0.5), Material::STEEL.poisson, report);
        let bore = self.get("bore").map(|_| self.both("bore", "m", POSITIVE, 0.0, report));
        let (young, poisson) = (young?, poisson?);
        Some(Gears {
            teeth: teeth?,
            internal: internal?,
            module: module?,
            pressure_angle: pressure_angle?,
            helix_angle: helix_angle?,
            addendum: addendum?,
            dedendum: dedendum?,
            fillet: fillet?,
            profile_shift: shift?,
            centre_distance: centre_distance.map_or(Some(None), |read| read.map(Some))?,
            face_width: face_width?,
            material: [0, 1].map(|i| Material { young: young[i], poisson: poisson[i] }),
            bore: bore.map_or(Some([None; 2]), |read| read.map(|both| both.map(|diameter| Some(diameter / 2.0))))?,
        })
    }

    fn teeth(&self, report: &mut Report) -> Option<[f64; 2]> {
        let (node, path) = (self.get("teeth")?, self.path("teeth"));
        let items = field::array(&path, node, "[24, 96]", report)?;
        let range = ("must be a whole number from 4 to 10000", 4.0, scene::TEETH);
        let read = |i: usize, report: &mut Report| {
            let (path, node) = (format!("{path}.{i}"), items.get(i)?);
            let z = within(&path, node, "1", range, report)?;
            if z.fract() != 0.0 {
                field::out_of_range(&path, node, range.0, "it is a number of teeth", report);
                return None;
            }
            Some(z)
        };
        if items.len() != 2 {
            let message = format!("`{path}` has {} numbers", items.len());
            report.add(
                &node.place,
                message,
                "not two gears",
                "give the teeth of both, the driving gear first: [24, 96]",
            );
            return None;
        }
        let (a, b) = (read(0, report), read(1, report));
        Some([a?, b?])
    }

    fn stiffness_method(&self, report: &mut Report) -> Option<StiffnessMethod> {
        let method = match self.get("method") {
            None => Some(0),
            Some(node) => field::choice(&self.path("method"), node, "method", &METHODS, report),
        };
        let Some(node) = self.get("line_load") else {
            return method.map(|i| if i == 0 { StiffnessMethod::Iso6336(None) } else { StiffnessMethod::Energy });
        };
        let load = within(&self.path("line_load"), node, "N/m", POSITIVE, report);
        if method? == 1 {
            let help = format!("leave it out: only ISO 6336-1 uses it, below {} N/mm", LINE_LOADS[0] / 1e3);
            let message = format!("`{}` has no effect with the method \"energy\"", self.path("line_load"));
            report.add(&node.place, message, "out of place", help);
            return None;
        }
        Some(StiffnessMethod::Iso6336(Some(load?)))
    }

    /// Reads one number for both gears, or two numbers.
    fn both(
        &self,
        key: &str,
        unit: &str,
        range: (&str, f64, f64),
        default: f64,
        report: &mut Report,
    ) -> Option<[f64; 2]> {
        let Some(node) = self.get(key) else { return Some([default; 2]) };
        let path = self.path(key);
        let Value::Array(items) = &node.value else {
            return within(&path, node, unit, range, report).map(|x| [x; 2]);
        };
        if items.len() != 2 {
            let message = format!("`{path}` has {} numbers", items.len());
            report.add(&node.place, message, "not two gears", "give one for both gears, or two: [first, second]");
            return None;
        }
        let read = |i: usize, report: &mut Report| within(&format!("{path}.{i}"), &items[i], unit, range, report);
        let (a, b) = (read(0, report), read(1, report));
        Some([a?, b?])
    }

    fn get(&self, key: &str) -> Option<&Node> {
        keys::get(self.entries, key)
    }

    fn path(&self, key: &str) -> String {
        format!("laws.{}.{key}", self.law.name)
    }

    /// The place of `teeth`.
    pub(super) fn at(&self) -> &Place {
        self.get("teeth").map_or(self.place, |node| &node.place)
    }

    /// The place of `internal`.
    pub(super) fn internal_at(&self) -> &Place {
        self.get("internal").map_or(self.at(), |node| &node.place)
    }

    /// Reports an error of the gear geometry or of the stiffness method.
    pub(super) fn refused(&self, at: &Place, error: GearError, report: &mut Report) {
        report.add(at, format!("`laws.{}`: {}", self.law.name, error.what), "these gears", error.advice);
    }
}

/// Reads a quantity within a range, both ends included.
fn within(
    path: &str,
    node: &Node,
    unit: &str,
    (must, low, high): (&str, f64, f64),
    report: &mut Report,
) -> Option<f64> {
    let x = field::quantity(path, node, unit, report)?;
    if !(low..=high).contains(&x) {
        field::out_of_range(path, node, must, "no gear has this value", report);
        return None;
    }
    Some(x)
}
