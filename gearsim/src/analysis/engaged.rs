//! The gears of each mesh of a run: their teeth and their rotation, for drawings.
//!
//! X is the position of a pair of teeth on the line of action, measured from the pitch point. It increases by r_b1 times the rotation of
//! the driving gear. The mesh stiffness gives its value: where the stiffness falls by a step, a pair leaves contact at X = g_a, the end of
//! the path of contact. So
//!
//! ```text
//! X = r_b1 theta_1 + begin  (modulo p_b),    X of the phase s:  p_b (s - s_end)/period + g_a
//! ```
//!
//! with s_end the phase of that step. For a stiffness computed from teeth, s_end is the beginning of the first cell.

use crate::engine::equations::Equations;
use crate::gear::{Contact, Gears};
use crate::known;
use crate::model::{Law, Output, Role};
use crate::profile::Profile;
use crate::scene::{Scene, of_mesh};
use crate::trajectory::Trajectory;

use super::orders::force;

mod train;

/// The data that the scene has of the teeth of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToothData {
    /// The scene has the teeth of the mesh.
    Teeth,
    /// The scene has numbers of teeth and a base radius. The heights of the teeth are standard.
    BaseRadius,
    /// The scene has only numbers of teeth. Lengths are in modules.
    Numbers,
}

/// A mesh of a run, and its gears.
#[derive(Debug, Clone)]
pub struct Engaged<'a> {
    /// The stiffness law of the mesh.
    pub law: &'static Law,
    /// The gears, the driving one first. Lengths in metres, or in modules if only the numbers of teeth are known.
    pub gears: Gears,
    /// The data that the scene has of their teeth.
    pub known: ToothData,
    /// The output that is the speed of the driving gear. If it is `None`, the rotation is computed from the mesh phase, relative to the
    /// carrier.
    pub rotor: Option<&'static str>,
    /// Rotation of the driving gear in each row \[rad\].
    pub rotation: Vec<f64>,
    /// Lead of the driving gear along the line of action in each row [length of `gears`]: the dynamic transmission error.
    pub lead: Vec<f64>,
    /// Play along the line of action [length of `gears`]; `None` without the effect.
    pub play: Option<f64>,
    /// Whether the scene has a transmission error of the mesh.
    pub has_error: bool,
    /// X - r_b1 theta_1 of a pair of teeth, modulo the base pitch [length of `gears`].
    pub begin: f64,
    /// The force of the mesh, if it is recorded.
    pub force: Option<(&'static Output, &'a [f64])>,
}

/// The teeth of a mesh, and the data from which their rotation follows.
struct Teeth {
    gears: Gears,
    known: ToothData,
    /// The number of the output that is the speed of the driving gear.
    rotor: Option<usize>,
}

/// The meshes of a run whose numbers of teeth the scene states, in the order of their laws. If the teeth of a mesh cannot be drawn, the
/// error has its law and the reason.
pub fn engaged<'a>(scene: &Scene, run: &'a Trajectory) -> Vec<Result<Engaged<'a>, (&'static Law, String)>> {
    let Some(equations) = known::of(scene).and_then(|entry| entry.equations(scene).ok()) else { return vec![] };
    let mut all = vec![];
    for (i, (law, profile)) in scene.present().enumerate() {
        if law.role != Role::Stiffness || run.is_empty() {
            continue;
        }
        let teeth = match &scene.train {
            Some(of) => train::teeth(scene, of, i),
            None => teeth(scene, i),
        };
        let Some(teeth) = teeth else { continue };
        let contact = teeth.gears.contact();
        match contact.map_err(|error| (law, error.to_string())) {
            Ok(contact) => all.extend(follow(scene, run, &*equations, (law, profile), teeth, &contact).map(Ok)),
            Err(refused) => all.push(Err(refused)),
        }
    }
    all
}

/// The teeth of the mesh with law `i` of a derived model; `None` if the scene does not state their numbers.
fn teeth(scene: &Scene, i: usize) -> Option<Teeth> {
    let names = of_mesh(scene.model.laws[i].name);
    let rotor = scene.model.outputs.iter().position(|o| o.name == format!("rotor_speed_{}", names[0]));
    if let Some(gears) = &scene.gears[i] {
        return Some(Teeth { gears: gears.clone(), known: ToothData::Teeth, rotor });
    }
    let (first, second) = (scene.teeth_of(&names[0])?.0, scene.teeth_of(&names[1])?.0);
    let radius = |gear: &str, z: f64| scene.parameter(&format!("r{gear}")).map(|r| r / z);
    // All gears that mesh with each other have the same base radius per tooth.
    let per_tooth = radius(&names[0], first).or_else(|| radius(&names[1], second)).or_else(|| {
        let sun = scene.teeth_of("_s")?.0;
        names.iter().any(|name| name == "_p").then(|| radius("_s", sun))?
    });
    Some(standard(scene, [first, second], names[1] == "_r", per_tooth, rotor))
}

/// Standard teeth with the base radius `per_tooth` per tooth \[m\], at the pressure angle of the scene or at 20 deg. The tips are lower if
/// the teeth would not mesh otherwise.
fn standard(scene: &Scene, teeth: [f64; 2], internal: bool, per_tooth: Option<f64>, rotor: Option<usize>) -> Teeth {
    let angle = scene.pressure_angle().unwrap_or(20f64.to_radians());
    let (module, known) = match per_tooth.filter(|h| *h > 0.0) {
        Some(h) => (2.0 * h / angle.cos(), ToothData::BaseRadius),
        None => (1.0, ToothData::Numbers),
    };
    let with = |addendum| Gears { internal, addendum, ..Gears::standard(teeth, module, angle, 10.0 * module) };
    let tips = [[1.0; 2], [1.0, 0.8], [0.8; 2], [0.6; 2]].map(with);
    let gears = tips.iter().find(|gears| gears.contact().is_ok()).unwrap_or(&tips[0]).clone();
    Teeth { gears, known, rotor }
}

/// The rotation of the gears of a mesh. `None` if the model has no linear output that is the lead of the mesh.
fn follow<'a>(
    scene: &Scene,
    run: &'a Trajectory,
    equations: &dyn Equations,
    (law, profile): (&'static Law, &Profile),
    Teeth { gears, known, rotor }: Teeth,
    contact: &Contact,
) -> Option<Engaged<'a>> {
    let model = scene.model;
    let force = force(model, law.name);
    let part = law.name.strip_prefix('k')?;
    let dte = model.outputs.iter().position(|o| o.name == format!("dte{}", suffix(part)))?;
    let base = contact.base[0];
    // A lead in rad is a rotation of the driving gear. Its base radius converts it to a length.
    let length = if model.outputs[dte].unit == "rad" { base } else { 1.0 };
    let state: Vec<f64> = coefficients(scene, equations, dte, false)?;
    let lead: Vec<f64> = sum(&state, &run.q).map(|x| length * x).collect();
    let phase = model.coordinates.iter().position(|c| c.name == law.phase)?;
    let pitches = |row: usize| run.q[phase][row] / law.period;
    let turned = rotor.and_then(|rotor| coefficients(scene, equations, rotor, true));
    let rotor = rotor.filter(|_| turned.is_some()).map(|rotor| model.outputs[rotor].name);
    let rotation: Vec<f64> = match &turned {
        Some(turned) => sum(turned, &run.q).collect(),
        None => (0..run.len()).map(|row| contact.base_pitch * pitches(row) / base).collect(),
    };
    // The phase of the law is that of the mean rotation of both gears: half of the lead belongs to each.
    let half = if turned.is_some() { 0.5 * lead[0] } else { 0.0 };
    let end = if known == ToothData::Teeth { profile.origin } else { fall(profile) };
    let at_start = contact.base_pitch * (pitches(0) - end / law.period) + contact.recess;
    let begin = (at_start + half - base * rotation[0]) % contact.base_pitch;
    let play = model
        .parameters
        .iter()
        .position(|p| p.name == format!("b{part}"))
        .filter(|&i| model.parameters[i].with.is_some_and(|effect| scene.effects.has(effect, model)));
    // In gear_pair the play b is a value of the coordinate phi [rad]. As a length it is b_t = 2 r_b1/N1 b.
    let play_length = match play.map(|i| model.parameters[i].unit) {
        Some("rad") => 2.0 * base / gears.teeth[0],
        _ => 1.0,
    };
    let play = play.map(|i| play_length * scene.parameters[i]);
    let error = format!("e{part}");
    let has_error = scene.present().any(|(law, error_of)| law.name == error && error_of.extremes() != (0.0, 0.0));
    let force = force.and_then(|output| Some((output, run.output(output.name)?)));
    Some(Engaged { law, gears, known, rotor, rotation, lead, play, has_error, begin, force })
}

/// The suffix of the names of a part's outputs: `_12` for the part `12` or `_12`, empty if there is no part.
fn suffix(part: &str) -> String {
    let part = part.trim_start_matches('_');
    if part.is_empty() { String::new() } else { format!("_{part}") }
}

/// The coefficients of an output that is a linear function of the coordinates, or with `rates` of their speeds; `None` if it is not linear.
fn coefficients(scene: &Scene, equations: &dyn Equations, output: usize, rates: bool) -> Option<Vec<f64>> {
    let n = scene.model.coordinates.len();
    let k = scene.model.in_contact(scene.laws.iter().map(Profile::mid));
    let zero = vec![0.0; n];
    let at = |x: &[f64]| match rates {
        true => equations.output(output, &zero, x, &k, &Default::default()),
        false => equations.output(output, x, &zero, &k, &Default::default()),
    };
    let unit = |i: usize| (0..n).map(|j| f64::from(u8::from(i == j))).collect::<Vec<_>>();
    let found: Vec<f64> = (0..n).map(|i| at(&unit(i))).collect();
    let probe: Vec<f64> = (0..n).map(|i| 1.0 + 0.5 * i as f64).collect();
    let (direct, added) = (at(&probe), found.iter().zip(&probe).map(|(c, x)| c * x).sum::<f64>());
    let size = found.iter().zip(&probe).map(|(c, x)| (c * x).abs()).sum::<f64>();
    (at(&zero) == 0.0 && size.is_finite() && (direct - added).abs() <= LINEAR * size).then_some(found)
}

/// An output is linear if it differs from the sum of its terms by at most this fraction of their magnitudes: a rounding error.
const LINEAR: f64 = 1e-12;

/// The sum of the columns with these factors, row by row.
fn sum(factors: &[f64], columns: &[Vec<f64>]) -> impl Iterator<Item = f64> {
    let rows = columns.first().map_or(0, Vec::len);
    (0..rows).map(move |row| factors.iter().zip(columns).filter(|(c, _)| **c != 0.0).map(|(c, x)| c * x[row]).sum())
}

/// The phase at which a law falls most from one cell to the next; the beginning of its first cell, if it has only one.
fn fall(profile: &Profile) -> f64 {
    let n = profile.steps.len();
    let step = |i: usize| profile.steps[i].value - profile.steps[(i + n - 1) % n].value;
    let lowest = (0..n).min_by(|a, b| step(*a).total_cmp(&step(*b))).unwrap_or(0);
    profile.origin + profile.steps[..lowest].iter().map(|step| step.width).sum::<f64>()
}

#[cfg(test)]
mod tests;
