//! Generated derivatives, of every model with each of its effects and with as many effects as go together, in each mode of its switches:
//! the Jacobian and the derivatives of the inertia forces against differences of the generated functions, and the matrices of linear cells
//! and the linear forces against the generated force.

#[path = "derivatives/differences.rs"]
mod differences;
#[path = "derivatives/place.rs"]
mod place;
#[path = "common/effects.rs"]
mod scenes;

use std::cell::Cell;

use differences::{Difference, by_direction};
use gearsim::__private::equations::Equations;
use gearsim::__private::{Inside, Matrix, Vector};
use gearsim::Scene;
use place::Place;

/// Places for each scene, at least; more where a switch has more modes.
const PLACES: usize = 4;
/// Allowed error of an entry, relative to the largest one of its row.
const TOLERANCE: f64 = 1e-8;
/// Allowed rounding error of a force, relative to the largest term of a force.
const ROUNDING: f64 = 1e-13;

/// The scenes of a model: with each effect, and with as many effects as go together, taken from the first and from the last.
fn scenes_of(model: &str) -> Vec<(String, Scene)> {
    let alone: Vec<_> =
        scenes::of(model).into_iter().filter_map(|(effect, scene)| Some((effect, scene.ok()?))).collect();
    let base = &scenes::committed(model, scenes::T_END)[0];
    let together = |effects: &mut dyn Iterator<Item = &'static str>| {
        let mut names: Vec<&'static str> = vec![];
        for effect in effects {
            let needed = scenes::needed(base.model, effect);
            let goes =
                |with: &[&'static str]| needed.iter().all(|a| with.iter().all(|b| !scenes::exclude(base.model, a, b)));
            if goes(&names) && goes(&needed) {
                names.extend(needed.into_iter().filter(|name| !names.contains(name)).collect::<Vec<_>>());
            }
        }
        let scene = Scene::from_toml_with(&base.name, &base.text, &scenes::overrides(base, &names));
        (names.join(", "), scene.unwrap_or_else(|error| panic!("{model} with {names:?}: {error}")))
    };
    let all = || alone.iter().map(|(effect, _)| *effect);
    let both = [together(&mut all()), together(&mut all().rev())];
    alone.iter().map(|(effect, scene)| (effect.to_string(), scene.clone())).chain(both).collect()
}

/// Runs `check` at each place of each scene of all models.
fn everywhere(check: impl Fn(&Scene, &dyn Equations, &Place) -> Result<(), String>) {
    let mut places = 0;
    let mut wrong = vec![];
    for (model, _) in scenes::models() {
        for (effects, scene) in scenes_of(&model) {
            let entry = gearsim::models().iter().find(|entry| entry.model.name == model).expect("a known model");
            let equations = entry.equations(&scene).unwrap_or_else(|error| panic!("{model} with {effects}: {error}"));
            let modes = scene.model.switches.iter().map(|switch| switch.modes.len()).max().unwrap_or(1);
            for i in 0..PLACES.max(modes) {
                places += 1;
                let place = Place::new(&scene, &*equations, i);
                if let Err(error) = check(&scene, &*equations, &place) {
                    wrong.push(format!("{model} with {effects}, place {i}: {error}"));
                    break;
                }
            }
        }
    }
    println!("{places} places");
    assert!(places > 1000, "only {places} places");
    assert!(wrong.is_empty(), "{} scenes are wrong:\n{}", wrong.len(), wrong.join("\n"));
}

/// A matrix against differences, column by column. An entry may have an error of `TOLERANCE` times the largest entry of its row, plus the
/// error of the differences.
fn compare(what: &str, matrix: &Matrix, columns: &[Difference]) -> Result<(), String> {
    let n = matrix.nrows();
    for i in 0..n {
        let largest = (0..n).fold(0.0f64, |m, j| m.max(columns[j].value[i].abs()));
        for (j, column) in columns.iter().enumerate() {
            let (found, expected) = (matrix[(i, j)], column.value[i]);
            let allowed = TOLERANCE * largest + column.error[i];
            if !((found - expected).abs() <= allowed && allowed.is_finite()) {
                return Err(format!("{what} ({i}, {j}) is {found:e}, not {expected:e} +- {allowed:.1e}"));
            }
        }
    }
    Ok(())
}

/// The derivatives of the force by q and by q', from differences.
fn derivatives_of_force(equations: &dyn Equations, place: &Place) -> [Vec<Difference>; 2] {
    let force = |q: &[f64], v: &[f64]| {
        let (k, dk) = place.laws_at(q);
        equations.force(q, v, &k, &dk)
    };
    let along_q = by_direction(&place.q, &place.lengths, |q| force(q, &place.v));
    [along_q, by_direction(&place.v, &place.speeds, |v| force(&place.q, v))]
}

#[test]
fn jacobians_equal_differences_of_the_force() {
    everywhere(|_, equations, place| {
        let [by_q, by_v] = equations.jacobian(&place.q, &place.v, &place.k, &place.dk, &place.ddk);
        let [along_q, along_v] = derivatives_of_force(equations, place);
        compare("dF/dq", &by_q, &along_q)?;
        compare("dF/dq'", &by_v, &along_v)
    });
}

#[test]
fn derivatives_of_inertia_equal_differences_of_mass_times_acceleration() {
    everywhere(|_, equations, place| {
        let a = Vector::from_fn(place.v.len(), |i| 1.0 + place.v[i]);
        let columns = by_direction(&place.q, &place.lengths, |q| &equations.mass(q) * &a);
        compare("d(M q'')/dq", &equations.inertia(&place.q, &a), &columns)?;
        let constant = columns.iter().all(|column| column.value.iter().all(|x| *x == 0.0));
        match constant == equations.is_inertia_constant() {
            true => Ok(()),
            false => Err(format!("M is {} constant", if constant { "" } else { "not" })),
        }
    });
}

#[test]
fn forces_of_linear_cells_are_those_of_their_matrices() {
    everywhere(|scene, equations, place| {
        if !scene.effects.nonlinear(scene.model).is_empty() {
            return Ok(());
        }
        let flat = vec![0.0; place.dk.len()];
        let found = equations.force(&place.q, &place.v, &place.k, &flat);
        let (damping, stiffness) = (equations.damping(&place.k), equations.stiffness(&place.k));
        let (q, v) = (Vector::from(&place.q[..]), Vector::from(&place.v[..]));
        let expected = equations.load(&place.k) - &(&damping * &v) - &(&stiffness * &q);
        let scale = stiffness.amax() * q.amax() + damping.amax() * v.amax() + found.amax();
        match (0..found.len()).find(|&i| (found[i] - expected[i]).abs() > ROUNDING * scale) {
            Some(i) => Err(format!("F ({i}) is {:e}, not f - C q' - K q = {:e}", found[i], expected[i])),
            None => Ok(()),
        }
    });
}

#[test]
fn linear_and_other_forces_sum_to_the_force() {
    everywhere(|_, equations, place| {
        let flat = vec![0.0; place.dk.len()];
        let Some(linear) = equations.linear_forces(&place.k) else { return Ok(()) };
        let mut sum = linear.force(&place.q, &place.v);
        equations.add_other_forces(&place.q, &place.v, &place.k, &flat, &mut sum);
        let found = equations.force(&place.q, &place.v, &place.k, &flat);
        let scale = found.amax();
        match (0..found.len()).find(|&i| (found[i] - sum[i]).abs() > ROUNDING * scale) {
            Some(i) => Err(format!("F ({i}) is {:e}, its parts {:e}", found[i], sum[i])),
            None => Ok(()),
        }
    });
}

/// The comparison can fail: an error of 0.1 % in one entry is detected, if the entry has a share of 1e-7 in the forces and is not small
/// in its row.
#[test]
fn a_wrong_entry_is_detected() {
    let tested = Cell::new(0);
    everywhere(|_, equations, place| {
        let [by_q, by_v] = equations.jacobian(&place.q, &place.v, &place.k, &place.dk, &place.ddk);
        let [along_q, along_v] = derivatives_of_force(equations, place);
        let largest_force = equations.force(&place.q, &place.v, &place.k, &place.dk).amax();
        for (matrix, columns, sizes) in [(by_q, along_q, &place.lengths), (by_v, along_v, &place.speeds)] {
            for i in 0..matrix.nrows() {
                let largest = matrix.row(i).amax();
                let tells = |j: usize, x: f64| x.abs() > 1e-2 * largest && x.abs() * sizes[j] > 1e-7 * largest_force;
                for j in (0..matrix.ncols()).filter(|&j| tells(j, matrix[(i, j)])) {
                    let mut wrong = matrix.clone();
                    wrong[(i, j)] *= 1.001;
                    tested.set(tested.get() + 1);
                    if compare("", &wrong, &columns).is_ok() {
                        return Err(format!("the wrong entry ({i}, {j}) {:e} is not detected", wrong[(i, j)]));
                    }
                }
            }
        }
        Ok(())
    });
    println!("{} entries", tested.get());
    assert!(tested.get() > 50_000, "only {} entries", tested.get());
}
