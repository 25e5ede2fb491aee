//! The data of a mesh stiffness that follow from its teeth: contact ratio, overlap ratio, and the levels of the law with their widths.

use crate::model::{Law, Role};
use crate::profile::{Profile, Step};
use crate::scene::Scene;

/// A stiffness that the scene gives by its teeth.
#[derive(Debug, Clone)]
pub struct FromTeeth<'a> {
    /// The law.
    pub law: &'static Law,
    /// Unit of the phase and of the widths.
    pub phase_unit: &'static str,
    /// Transverse contact ratio \[1\].
    pub contact_ratio: f64,
    /// Overlap ratio, 0 of spur gears \[1\].
    pub overlap_ratio: f64,
    /// The law over one period.
    pub profile: &'a Profile,
}

/// The stiffnesses of a scene that are given by their teeth.
pub fn of(scene: &Scene) -> Vec<FromTeeth<'_>> {
    let given = scene.model.laws.iter().zip(&scene.laws).zip(&scene.gears);
    let stiffnesses = given.filter(|((law, _), _)| law.role == Role::Stiffness);
    let from_teeth = stiffnesses.filter_map(|((law, profile), gears)| {
        let contact = gears.as_ref()?.contact().ok()?;
        let phase = scene.model.coordinates.iter().find(|coordinate| coordinate.name == law.phase);
        Some(FromTeeth {
            law,
            phase_unit: phase.map_or("rad", |coordinate| coordinate.unit),
            contact_ratio: contact.ratio(),
            overlap_ratio: contact.overlap,
            profile,
        })
    });
    from_teeth.collect()
}

/// Maximum number of levels that are listed one by one.
const MOST_LEVELS: usize = 6;

impl FromTeeth<'_> {
    /// The data in words; `short` formats numbers.
    pub fn words(&self, short: impl Fn(f64) -> String) -> String {
        let FromTeeth { law, phase_unit, profile, .. } = self;
        let level = |step: &Step| format!("{} {} over {} {phase_unit}", short(step.value), law.unit, short(step.width));
        let helical = match self.overlap_ratio {
            0.0 => String::new(),
            overlap => format!(", overlap ratio {}", short(overlap)),
        };
        let (low, high) = profile.extremes();
        let values = match profile.steps.len() {
            n if n > MOST_LEVELS || !profile.steps_only() => {
                format!("{n} pieces between {} and {} {}", short(low), short(high), law.unit)
            }
            _ => profile.steps.iter().map(level).collect::<Vec<_>>().join(", "),
        };
        format!(
            "contact ratio {}{helical}; {values}; mean {} {}",
            short(self.contact_ratio),
            short(profile.mean()),
            law.unit
        )
    }
}
