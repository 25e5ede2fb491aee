//! Drives and loads.

use super::draft::{Term, named};
use super::read::{Item, Reader};
use crate::scene::{field, keys, list};

impl Reader<'_> {
    /// A drive or a load.
    pub(super) fn torque(&mut self, item: &Item<'_>) {
        let kinds = if item.table == "drives" { DRIVES } else { LOADS };
        let allowed: Vec<_> = std::iter::once("rotor").chain(kinds.iter().map(|kind| kind.0)).collect();
        self.known(item, &allowed);
        let Some(rotor) = self.rotor_of(item) else { return };
        let given: Vec<_> = kinds.iter().filter(|kind| item.get(kind.0).is_some()).collect();
        let kind = match given[..] {
            [] => &kinds[0],
            [kind] => kind,
            _ => {
                let help = format!("give one of {}", list(&allowed[1..]));
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
