//! Planetary stages from the derived models, with evenly spaced mesh phases: two laws per planet, all on one phase.

use std::f64::consts::TAU;

use anyhow::bail;
use gearsim::__private::equations::{Derived, DerivedModel};
use gearsim::__private::models::{Planetary3, Planetary4, Planetary5, Planetary6, Planetary7};
use gearsim::scene::{Profile, Scene, Step};

use crate::row::Row;

/// Measures the stage with `planets` planets.
///
/// # Errors
/// If there is no such model, or if it does not run.
pub fn planetary(planets: usize) -> anyhow::Result<Row> {
    match planets {
        3 => of::<Planetary3>(planets),
        4 => of::<Planetary4>(planets),
        5 => of::<Planetary5>(planets),
        6 => of::<Planetary6>(planets),
        7 => of::<Planetary7>(planets),
        _ => bail!("no model of a planetary stage with {planets} planets"),
    }
}

/// The scene with three planets, changed to `planets` planets. The mesh phases of planet i lag by (i - 1)/planets of a pitch.
fn of<D: Derived>(planets: usize) -> anyhow::Result<Row> {
    let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/scenes/planetary_3.toml"));
    let text = text.replace("planetary_3", &format!("planetary_{planets}"));
    let laws: String = (1..=planets)
        .map(|i| format!("k_s{i}.steps = [{{ value = \"1 N/m\" }}]\nk_r{i}.steps = [{{ value = \"1 N/m\" }}]\n"))
        .collect();
    let (before, after) = (text.find("[laws]"), text.find("[start]"));
    let text = match (before, after) {
        (Some(before), Some(after)) => format!("{}[laws]\n{laws}\n{}", &text[..before], &text[after..]),
        _ => bail!("models/scenes/planetary_3.toml has no section [laws] or no section [start]"),
    };
    let mut scene = Scene::parse("planetary", "planetary_3.toml", &text, &[], &[&D::MODEL])
        .map_err(|e| anyhow::anyhow!("{}", e.render(100, false)))?;
    for (law, stiffness) in D::MODEL.laws.iter().zip(&mut scene.laws) {
        let planet: f64 = law.name[3..].parse()?;
        let offset = TAU * (planet - 1.0) / planets as f64;
        *stiffness = if law.name.starts_with("k_s") {
            shifted(offset, 2.6, [3.5e8, 6e8])
        } else {
            shifted(offset + 1.0, 4.4, [6e8, 4e8])
        };
    }
    Row::of(&scene, &*DerivedModel::of::<D>().equations(&scene)?)
}

/// A law of two levels [N/m]: the first from `offset` [rad] over `width` [rad], the second over the rest of the pitch of 2 pi.
fn shifted(offset: f64, width: f64, [first, second]: [f64; 2]) -> Profile {
    let offset = offset.rem_euclid(TAU);
    let step = |value, width| Step { value, width };
    let steps = match offset + width - TAU {
        over if over > 0.0 => vec![step(first, over), step(second, TAU - width), step(first, width - over)],
        _ if offset == 0.0 => vec![step(first, width), step(second, TAU - width)],
        _ => vec![step(second, offset), step(first, width), step(second, TAU - offset - width)],
    };
    Profile::stepping(steps)
}
