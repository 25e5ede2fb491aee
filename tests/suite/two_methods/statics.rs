//! The forces at a coordinate that starts `static` balance, except for those that accelerate rigid motions: K q + C q' + M R a = f in its
//! row. R has the rigid motions as columns, and a is their acceleration. The stiffness levels are those at the phases of the start. This
//! check finds the levels itself from the laws of the scene, and the matrices by the derived equations.

use std::f64::consts::TAU;

use gearsim::__private::Inside;
use gearsim::model::Start;
use gearsim::scene::{Profile, Scene};
use nalgebra::{DMatrix, DVector};

use crate::common;

/// Number of starts of each scene.
const STARTS: usize = 60;
/// Allowed residual of the balance, relative to the largest force in its row: the rounding error of an ill-conditioned balance.
const LEFT: f64 = 1e-9;

/// Checks the static starts of a scene at many positions of its phases.
///
/// # Errors
/// A text with the largest residual, if the forces do not balance.
pub fn balance(name: &str) -> Result<String, String> {
    let scene = common::scene(name, &[]);
    let is_static: Vec<bool> = scene.start.q.iter().map(|start| start.is_static()).collect();
    if !is_static.contains(&true) {
        return Ok(format!("{name}: no coordinate starts static"));
    }
    if !scene.effects.nonlinear(scene.model).is_empty() || scene.laws.iter().any(|law| !law.steps_only()) {
        return Ok(format!("{name}: not checked, its cells are not linear"));
    }
    if scene.model.switches.iter().any(|switch| scene.effects.has(switch.with, scene.model)) {
        return Ok(format!("{name}: not checked, the modes of its switches are not known beforehand"));
    }
    let (mut worst, mut boundaries) = (0.0f64, 0);
    for i in 0..STARTS {
        let mut scene = scene.clone();
        scene.output.rate = 1.0 / scene.t_end;
        scene.t_end *= 1e-9;
        for (j, start) in scene.start.q.iter_mut().enumerate() {
            let phase = scene.model.laws.iter().any(|law| law.phase == scene.model.coordinates[j].name);
            if let Start::At(x) = start
                && phase
            {
                *x = (i as f64 * 0.618_033_988_75 + j as f64 * 0.41) * TAU;
            }
        }
        match residual(&scene, &is_static)? {
            Some(left) => worst = worst.max(left),
            None => boundaries += 1,
        }
    }
    if boundaries > STARTS / 4 {
        return Err(format!("{boundaries} of {STARTS} starts are on a boundary"));
    }
    let text =
        format!("{name}: largest residual {worst:.1e} of a force, {boundaries} of {STARTS} starts on a boundary");
    if worst <= LEFT { Ok(text) } else { Err(text) }
}

/// The largest residual in a static row, relative to the largest force in that row. `None` if a static phase is on a boundary, which
/// holds it.
fn residual(scene: &Scene, is_static: &[bool]) -> Result<Option<f64>, String> {
    let entry = common::model(scene.model.name);
    let outcome = entry.run(scene, &mut |_| {}).map_err(|e| e.to_string())?;
    let at = |columns: &[Vec<f64>]| columns.iter().map(|column| column[0]).collect::<Vec<_>>();
    let (q, v) = (at(&outcome.trajectory.q), at(&outcome.trajectory.q_dot));
    let coordinate = |name: &str| scene.model.coordinates.iter().position(|c| c.name == name).expect("a phase");
    let mut levels = vec![];
    for (law, given) in scene.present() {
        let phase = coordinate(law.phase);
        let (level, gap) = level(given, law.period * f64::from(given.pitches), q[phase]);
        if is_static[phase] && gap < 1e-9 {
            return Ok(None);
        }
        levels.push(level);
    }
    let matrices = entry.system(scene).and_then(|system| system.matrices(&levels)).map_err(|e| e.to_string())?;
    let terms = |i: usize| {
        let springs = (0..q.len()).map(|j| matrices.stiffness[(i, j)] * q[j]);
        let dampers = (0..q.len()).map(|j| matrices.damping[(i, j)] * v[j]);
        springs.chain(dampers).chain([-matrices.load[i]]).collect::<Vec<f64>>()
    };
    // The rigid motions accelerate: coordinates without springs, or else those by which a scene states its speeds. RᵀM R a = RᵀF.
    let n = q.len();
    let rounding = 1e-13 * matrices.stiffness.amax();
    let alone = (0..n).filter(|i| !is_static[*i] && matrices.stiffness.row(*i).amax() <= rounding);
    let alone = alone.map(|i| DVector::from_fn(n, |j, _| f64::from(u8::from(i == j))));
    let mut rigid: Vec<DVector<f64>> = alone.collect();
    if rigid.is_empty() {
        let equations = entry.equations(scene).map_err(|e| e.to_string())?;
        let declared = (0..scene.model.motions.len()).map(|i| DVector::from_column_slice(&equations.motion(i)));
        rigid = declared
            .filter(|r| (&matrices.stiffness * r).amax() <= 1e-12 * matrices.stiffness.amax() * r.amax())
            .collect();
    }
    let along = |r: &DVector<f64>| {
        let (sum, size) = (0..n)
            .flat_map(|i| terms(i).into_iter().map(move |x| r[i] * x))
            .fold((0.0, 0.0), |(sum, size), x| (sum - x, size + x.abs()));
        if f64::abs(sum) > 1e-13 * size { sum } else { 0.0 }
    };
    let mut inertia = DVector::zeros(n);
    if !rigid.is_empty() {
        let force = DVector::from_iterator(rigid.len(), rigid.iter().map(along));
        let rigid = DMatrix::from_columns(&rigid);
        let acceleration = (rigid.transpose() * &matrices.mass * &rigid).lu().solve(&force).ok_or("M is singular")?;
        inertia = &matrices.mass * rigid * acceleration;
    }
    let mut worst = 0.0f64;
    for i in (0..q.len()).filter(|i| is_static[*i]) {
        let parts: Vec<f64> = terms(i).into_iter().chain([inertia[i]]).collect();
        let largest = parts.iter().fold(f64::MIN_POSITIVE, |m: f64, x| m.max(x.abs()));
        worst = worst.max(parts.iter().sum::<f64>().abs() / largest);
    }
    Ok(Some(worst))
}

/// The level of a law at a phase, and the distance of the phase from the nearest boundary.
fn level(law: &Profile, length: f64, phase: f64) -> (f64, f64) {
    let x = (phase - law.origin).rem_euclid(length);
    let (mut end, mut gap) = (0.0, x.min(length - x));
    let mut level = law.steps[law.steps.len() - 1].value;
    for step in law.steps.iter().rev().skip(1).rev() {
        let begin = end;
        end += step.width;
        gap = gap.min((x - end).abs());
        if x >= begin && x < end {
            level = step.value;
        }
    }
    (level, if law.steps.len() > 1 { gap } else { f64::INFINITY })
}
