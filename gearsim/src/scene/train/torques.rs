//! Drives and loads.

use super::draft::{Term, named};
use super::item::Item;
use super::read::Reader;
use super::{ELSEWHERE, ROTOR};
use crate::scene::keys::{Key, Kind, Named, REQUIRED, each, key};
use crate::scene::time_history::HISTORY;
use crate::scene::{field, keys, list};

impl Reader<'_> {
    /// A drive or a load.
    pub(super) fn torque(&mut self, item: &Item<'_>) {
        let (allowed, kinds) = if item.table == "drives" { (DRIVE, DRIVE_KINDS) } else { (LOAD, LOAD_KINDS) };
        self.known(item, allowed);
        let Some(rotor) = self.rotor_of(item) else { return };
        let given: Vec<_> = kinds.iter().filter(|kind| item.get(kind.key.name).is_some()).collect();
        let kind = match given[..] {
            [] => &kinds[0],
            [kind] => kind,
            _ => {
                let help = format!("give one of {}", list(&kinds.iter().map(|kind| kind.key.name).collect::<Vec<_>>()));
                self.report.add(item.place, format!("{} has several torques", item.title()), "one torque", help);
                return;
            }
        };
        let node = item.get(kind.key.name);
        match (kind.key.kind, node) {
            (Kind::Table([known]), Some(node)) => {
                let path = item.path(kind.key.name);
                let Some(entries) = field::table(&path, node, self.report) else { return };
                keys::known(entries, &format!("`{path}`"), &[known], self.report);
                let of_kind = Item { table: item.table, name: item.name, entries, place: &node.place };
                for (key, parameter) in known.iter().zip(kind.parameters) {
                    self.stated(named(parameter, item.name), &of_kind, key.name);
                }
            }
            (Kind::Table(_), None) => {}
            _ => self.stated(named(kind.parameters[0], item.name), item, kind.key.name),
        }
        self.part(item, kind.element, String::new(), vec![vec![Term::new(rotor, 1.0, &[])]]);
    }
}

/// A kind of drive or load.
struct TorqueKind {
    key: Key,
    /// The element that has its equations.
    element: &'static str,
    /// Its parameters: of the value, or of each key of the table.
    parameters: &'static [&'static str],
}

pub(super) const DRIVES: &[Named] = &[each("NAME", Kind::Table(&[DRIVE]), "none", "a drive: one of these torques")];
const DRIVE: &[Key] = &[AT, TORQUE, GOVERNOR, DC_MOTOR, INDUCTION_MOTOR, TRACTION_MOTOR];
const DRIVE_KINDS: &[TorqueKind] = &[
    TorqueKind { key: TORQUE, element: "element_drive", parameters: &["T"] },
    TorqueKind { key: GOVERNOR, element: "element_governor", parameters: &["c", "n"] },
    TorqueKind { key: DC_MOTOR, element: "element_dc_motor", parameters: &["Ts", "n0"] },
    TorqueKind { key: INDUCTION_MOTOR, element: "element_induction_motor", parameters: &["Tb", "sb", "ns"] },
    TorqueKind { key: TRACTION_MOTOR, element: "element_traction_motor", parameters: &["Tp", "Pp", "d", "round"] },
];

pub(super) const LOADS: &[Named] = &[each("NAME", Kind::Table(&[LOAD]), "none", "a load: one of these torques")];
const LOAD: &[Key] = &[AT, TORQUE, FAN];
const LOAD_KINDS: &[TorqueKind] = &[
    TorqueKind { key: TORQUE, element: "element_load", parameters: &["T"] },
    TorqueKind { key: FAN, element: "element_fan", parameters: &["cf", "w0"] },
];

const AT: Key = key("rotor", ROTOR, REQUIRED, "the rotor on which it acts");
const TORQUE: Key = key(
    "torque",
    Kind::Either(&[Kind::Quantity("N*m"), HISTORY]),
    ELSEWHERE,
    "a constant, or a function of time; with the effect torques",
)
.with("torques");
const SPEED: Kind = Kind::Quantity("rad/s");

const GOVERNOR: Key = key(
    "governor",
    Kind::Table(&[OF_GOVERNOR]),
    "none",
    "a speed governor: torque gain (set_point - speed), with the effect governor",
)
.with("governor");
const OF_GOVERNOR: &[Key] = &[
    key("gain", Kind::Quantity("N*m*s/rad"), ELSEWHERE, "torque per difference of speeds"),
    key("set_point", Kind::Either(&[SPEED, HISTORY]), ELSEWHERE, "the speed that it seeks"),
];

const DC_MOTOR: Key = key(
    "dc",
    Kind::Table(&[OF_DC_MOTOR]),
    "none",
    "a DC motor: torque that falls linearly with the speed, with the effect dc",
)
.with("dc");
const OF_DC_MOTOR: &[Key] = &[
    key("stall_torque", Kind::Quantity("N*m"), ELSEWHERE, "torque at rest"),
    key("no_load_speed", SPEED, ELSEWHERE, "speed without torque"),
];

const INDUCTION_MOTOR: Key = key(
    "induction",
    Kind::Table(&[OF_INDUCTION_MOTOR]),
    "none",
    "an induction motor: torque by Kloss's formula, with the effect induction",
)
.with("induction");
const OF_INDUCTION_MOTOR: &[Key] = &[
    key("breakdown_torque", Kind::Either(&[Kind::Quantity("N*m"), HISTORY]), ELSEWHERE, "largest torque"),
    key("breakdown_slip", Kind::Number, ELSEWHERE, "slip at the largest torque"),
    key("synchronous_speed", SPEED, ELSEWHERE, "speed without torque"),
];

const TRACTION_MOTOR: Key = key(
    "traction",
    Kind::Table(&[OF_TRACTION_MOTOR]),
    "none",
    "a traction motor: peak torque up to the base speed, constant power above it, with the effect traction",
)
.with("traction");
const OF_TRACTION_MOTOR: &[Key] = &[
    key("peak_torque", Kind::Quantity("N*m"), ELSEWHERE, "torque up to the base speed"),
    key("peak_power", Kind::Quantity("W"), ELSEWHERE, "power above the base speed"),
    key(
        "demand",
        Kind::Either(&[Kind::Number, HISTORY]),
        "1",
        "1 drives with the whole torque or power, -1 brakes with them",
    ),
    key("rounding", Kind::Number, "0.01", "of the corner at the base speed, relative to that speed"),
];

const FAN: Key = key(
    "fan",
    Kind::Table(&[OF_FAN]),
    "none",
    "a fan or pump: torque that grows with the square of the speed, with the effect fan",
)
.with("fan");
const OF_FAN: &[Key] = &[
    key(
        "coefficient",
        Kind::Either(&[Kind::Quantity("N*m*s^2/rad^2"), HISTORY]),
        ELSEWHERE,
        "torque over squared speed",
    ),
    key("corner_speed", SPEED, "0.01 rad/s", "below it the torque is nearly linear in the speed"),
];
