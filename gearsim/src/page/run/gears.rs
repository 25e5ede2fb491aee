//! The gears: the outlines of their teeth, turned by the script with the recorded motion.

use serde::Serialize;

use super::{Report, motion};
use crate::analysis::engaged::{Engaged, ToothData, engaged};
use crate::gear::Outlines;
use crate::page::data::{Column, Counts};
use crate::page::html::Html;

/// What the script draws.
#[derive(Serialize)]
struct Drawing {
    /// The plots whose cursor it follows, and moves.
    group: &'static str,
    /// Times of the rows \[s\].
    t: Column,
    meshes: Vec<Mesh>,
}

/// A mesh. Lengths in `unit`; the frame is that of [`Outlines`].
#[derive(Serialize)]
struct Mesh {
    name: String,
    /// `m`, or `modules`.
    unit: &'static str,
    gears: [Gear; 2],
    internal: bool,
    /// Working pressure angle \[rad\].
    angle: f64,
    pitch: f64,
    approach: f64,
    recess: f64,
    /// Backlash of the teeth as they are drawn without play.
    clearance: f64,
    /// Play of the model; `None`: its flanks always touch.
    play: Option<f64>,
    /// X - r_b1 theta_1 of a pair of teeth, as in [`Engaged`].
    begin: f64,
    /// Rotation of the driving gear \[rad\].
    rotation: Column,
    /// Its lead along the line of action.
    lead: Column,
    /// The largest magnitude of the lead.
    largest_lead: f64,
    force: Option<Force>,
    /// Mesh cycles a second, for the speed of the animation \[Hz\].
    frequency: f64,
    /// What is assumed in the drawing, in words.
    note: String,
}

#[derive(Serialize)]
struct Gear {
    /// Its name, with its number of teeth.
    name: String,
    teeth: f64,
    base: f64,
    tip: f64,
    root: f64,
    half: Vec<[f64; 2]>,
    place: f64,
}

#[derive(Serialize)]
struct Force {
    name: &'static str,
    unit: &'static str,
    values: Column,
    /// The largest magnitude.
    largest: f64,
}

/// Writes the section.
pub(super) fn fill(report: &Report<'_>, html: &mut Html) {
    let run = &report.run.outcome.trajectory;
    let mut meshes = vec![];
    for found in engaged(report.run.scene, run) {
        match found.map(|engaged| mesh(report, html, &engaged)) {
            Ok(mesh) => meshes.extend(mesh),
            Err((law, why)) => html.note(&format!("The teeth of the mesh of {} are not drawn: {why}.", law.name)),
        }
    }
    if meshes.is_empty() {
        return;
    }
    let t = motion::times(report, &report.all, html).rows.clone();
    html.figure("gears", "Gears in mesh", &Drawing { group: motion::GROUP, t, meshes });
}

/// What is drawn of a mesh; `None` where its motion is not finite.
fn mesh(report: &Report<'_>, html: &mut Html, engaged: &Engaged<'_>) -> Option<Mesh> {
    let run = &report.run.outcome.trajectory;
    let Outlines { gears: [first, second], contact, clearance } = Outlines::of(&engaged.gears).ok()?;
    let largest = |values: &[f64]| values.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let largest_lead = largest(&engaged.lead);
    let (turned, duration) = (engaged.rotation.last()? - engaged.rotation.first()?, run.t.last()? - run.t.first()?);
    if !(turned.is_finite() && largest_lead.is_finite() && duration > 0.0) {
        return None;
    }
    let mut embed = |values: &[f64], counts| html.embed(&report.all.rows.values(values), counts);
    let (rotation, lead) = (embed(&engaged.rotation, Counts::Long), embed(&engaged.lead, Counts::Short));
    let force = engaged.force.map(|(output, values)| Force {
        name: output.name,
        unit: output.unit,
        values: embed(values, Counts::Short),
        largest: largest(values),
    });
    let what = ["driving gear", if engaged.gears.internal { "ring" } else { "driven gear" }];
    let gear = |i: usize, half, place| Gear {
        name: format!("{}, {} teeth", what[i], engaged.gears.teeth[i]),
        teeth: engaged.gears.teeth[i],
        base: contact.base[i],
        tip: contact.tip[i],
        root: contact.root[i],
        half,
        place,
    };
    Some(Mesh {
        name: engaged.law.name.trim_start_matches(['k', '_']).to_owned(),
        unit: if engaged.known == ToothData::Numbers { "modules" } else { "m" },
        gears: [gear(0, first.half, first.place), gear(1, second.half, second.place)],
        internal: engaged.gears.internal,
        angle: contact.angle,
        pitch: contact.base_pitch,
        approach: contact.approach,
        recess: contact.recess,
        clearance,
        play: engaged.play,
        begin: engaged.begin,
        rotation,
        lead,
        largest_lead,
        force,
        frequency: (turned * contact.base[0] / contact.base_pitch / duration).abs(),
        note: note(engaged, contact.ratio()),
    })
}

/// What is known of the teeth, and what is assumed.
fn note(engaged: &Engaged<'_>, ratio: f64) -> String {
    let (gears, name) = (&engaged.gears, engaged.law.name);
    let degrees = (1e4 * gears.pressure_angle.to_degrees()).round() / 1e4;
    let addenda = match gears.addendum {
        [a, b] if a == b => format!("an addendum of {a}"),
        [a, b] => format!("addenda of {a} and {b}"),
    };
    let heights = format!("teeth of the basic rack at {degrees} deg with {addenda}, in modules");
    let mut note = match engaged.known {
        ToothData::Teeth => format!("The teeth are those of laws.{name}."),
        ToothData::BaseRadius => {
            format!("The scene gives numbers of teeth and a base radius, not the teeth of {name}: these are {heights}.")
        }
        ToothData::Numbers => format!(
            "The scene gives only the numbers of teeth of {name}: these are {heights}, and all lengths are in modules."
        ),
    };
    note += &format!(" Their contact ratio is {ratio:.4}.");
    if engaged.known != ToothData::Teeth {
        note += " They stand so that a pair leaves contact where the stiffness falls most.";
    }
    if engaged.rotor.is_none() {
        note += " Rotations are relative to the line through both centres, as the mesh phase counts them.";
    }
    if engaged.has_error {
        note += " Its transmission error is not drawn: pairs touch when the lead is equal to this error.";
    }
    match engaged.force {
        Some(_) => note += " The force of the mesh is divided equally among the pairs in contact.",
        None => note += " The run did not record the force of the mesh, so contacts have no colour.",
    }
    note
}
