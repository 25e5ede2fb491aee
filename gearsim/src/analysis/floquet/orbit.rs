//! Stability of a motion along which M and F change: a crank, a universal joint, a moving line of action.
//!
//! There is no steady motion. The reference is the motion that repeats after a turn ([`Turn`]) at the speeds of the scene. After a turn
//! every coordinate has moved by its part of the turn. Every speed has its first value again, except that of the reference coordinate. The
//! relative change of this speed in a turn is [`Orbit::drift`]; unbalanced torques and losses cause it. The motion is found by shooting:
//! Newton's method on the state at the start, with the exact derivatives of the flow ([`variational`]). The search begins at the speeds of
//! the scene, with the elastic coordinates in static equilibrium at the mean laws.
//!
//! The multipliers are the eigenvalues of the derivative of the map from turn to turn, P = (1 - f grad g/(grad g . f)) Phi on the section
//! g = const of the reference coordinate (F. Verhulst, Nonlinear Differential Equations and Dynamical Systems, 1996, Ch. 4). This leaves
//! out the multiplier of a shift along the motion exactly. One of the remaining multipliers belongs to a change of the rotational speed, as
//! that of a rigid motion does in a linear system. It is the one in whose eigenvector the rotation has the largest share of the kinetic
//! energy. It is reported separately, and the verdict is on the other multipliers.

mod saltation;
mod variational;

use std::cell::RefCell;
use std::rc::Rc;

use nalgebra::{Complex, DMatrix, DVector};

use super::{Aperiodic, Floquet, FloquetError, leave_out, of_all};
use crate::analysis::modes;
use crate::analysis::steady::{self, SteadyLaw};
use crate::analysis::turn::Turn;
use crate::engine::hybrid::Hybrid;
use crate::engine::simulate::Simulation;
use crate::engine::start;
use crate::engine::system::{Steady, System};
use crate::engine::vector::Vector;
use crate::methods::choice::{self, Choice};
use crate::methods::steps::BySteps;
use crate::model::Start;
use crate::scene::Scene;
use crate::scene::solver::Method;
use crate::tolerance::analysis::{
    MAGNUS_ERROR, MAGNUS_FIRST_ERROR, MULTIPLIER_ROUNDING, ORBIT_ACCEPTED, ORBIT_CLOSED, ORBIT_FIRST_TOLERANCE,
    ORBIT_NEAR, ORBIT_RANK, ORBIT_ROUNDS, ORBIT_SPEED_STEP, ORBIT_TOLERANCE,
};

use variational::{Carried, Variational};

/// A motion that repeats.
#[derive(Debug, Clone)]
pub struct Orbit {
    /// Name of the reference coordinate.
    pub reference: &'static str,
    /// Advance of the reference coordinate in a turn \[SI\].
    pub turn: f64,
    /// Coordinates and speeds at the start of the turn (n each) \[SI\].
    pub start: [Vec<f64>; 2],
    /// Relative change of the speed of the reference coordinate in a turn.
    pub drift: f64,
    /// Residual of the turn [relative to the rotation].
    pub gap: f64,
    /// The multiplier of a change of the speed of the rotation.
    pub speed: Complex<f64>,
}

/// A shot: the end of a run over the nominal time of a turn.
struct Shot {
    q: Vector,
    v: Vector,
    acceleration: Vector,
    /// Phi, not scaled (2n x 2n).
    phi: DMatrix<f64>,
    trouble: Option<&'static str>,
}

/// The accuracy of a shot.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Digits {
    /// Tolerance of the run [relative].
    run: f64,
    /// Error of a step of the propagator of disturbances [1].
    disturbances: f64,
}

impl Digits {
    /// Used far from the motion that repeats, where low accuracy suffices. These shots take a fraction of the time.
    const FEW: Digits = Digits { run: ORBIT_FIRST_TOLERANCE, disturbances: MAGNUS_FIRST_ERROR };
    const ALL: Digits = Digits { run: ORBIT_TOLERANCE, disturbances: MAGNUS_ERROR };
}

/// The multipliers of a scene whose equations change along the motion. `watch` is called at each step of the runs.
///
/// # Errors
/// If the equations do not repeat, no motion repeats, or nothing vibrates.
pub fn of(scene: &Scene, system: &System, about: &Steady, watch: &dyn Fn()) -> Result<Floquet, FloquetError> {
    let turn = Turn::of(scene, system)?.ok_or(Aperiodic::NoTurn)?;
    let shooting = Shooting { scene, system, turn: &turn, watch };
    let (orbit, shot) = shooting.close(about)?;
    let n = about.q.len();
    let Multipliers { others: mut multipliers, speed, size } = shooting.multipliers(&orbit, &shot)?;
    if n == 1 {
        return Err(FloquetError::Rigid);
    }
    let levels: Vec<f64> = scene.stiffnesses().map(|(_, law)| law.mean()).collect();
    let natural = modes::of(system, &levels, &modes::Parts::default(), watch)?
        .modes
        .iter()
        .map(|m| m.natural)
        .find(|f| *f > 0.0)
        .unwrap_or(0.0);
    let courses = steady::courses(scene, system)?;
    let mesh = courses.iter().find(|c| c.varies).map_or(0.0, SteadyLaw::mesh_frequency);
    let start = [orbit.0.to_vec(), orbit.1.to_vec()];
    let reference = scene.model.coordinates[turn.reference].name;
    let drift = shot.v[turn.reference] / orbit.1[turn.reference] - 1.0;
    let gap = shooting.gap(&orbit, &shot);
    let orbit = Orbit { reference, turn: turn.shift[turn.reference], start, drift, gap, speed };
    let verdict = of_all(&multipliers);
    let rounding = MULTIPLIER_ROUNDING * size;
    let unresolved = leave_out(&mut multipliers, rounding);
    Ok(Floquet {
        period: turn.time,
        multipliers,
        unresolved,
        rounding,
        rigid: 1,
        verdict,
        natural,
        mesh,
        steady: Some(about.clone()),
        orbit: Some(orbit),
        is_integrated: true,
    })
}

/// The multipliers of the map from turn to turn.
struct Multipliers {
    /// All multipliers except `speed`, by descending absolute value.
    others: Vec<Complex<f64>>,
    /// The multiplier of a change of the speed of the rotation.
    speed: Complex<f64>,
    /// The largest entry of the map.
    size: f64,
}

/// The search for the motion that repeats.
struct Shooting<'a> {
    scene: &'a Scene,
    system: &'a System,
    turn: &'a Turn,
    /// Is called at each step.
    watch: &'a dyn Fn(),
}

/// Coordinates and speeds.
type OrbitPoint = (Vector, Vector);

impl Shooting<'_> {
    /// The motion that repeats: its start, and the end of its turn.
    fn close(&self, about: &Steady) -> Result<(OrbitPoint, Shot), FloquetError> {
        let n = about.q.len();
        let mut digits = Digits::FEW;
        let mut place = (self.aside(about)?, about.q_dot.clone());
        let mut shot = self.shoot(&place, digits)?;
        let mut gap = self.gap(&place, &shot);
        'rounds: for _ in 0..ORBIT_ROUNDS {
            if gap <= ORBIT_NEAR && digits == Digits::FEW {
                digits = Digits::ALL;
                shot = self.shoot(&place, digits)?;
                gap = self.gap(&place, &shot);
            }
            if gap <= ORBIT_CLOSED {
                break;
            }
            // Far from the solution, the end of a turn is closer to it if vibrations decay.
            if gap > ORBIT_NEAR {
                let next = self.onwards(&place, &shot);
                let tried = self.shoot(&next, digits).ok().map(|shot| (self.gap(&next, &shot), shot));
                if let Some((next_gap, tried)) = tried.filter(|(next_gap, _)| *next_gap < 0.7 * gap) {
                    (place, shot, gap) = (next, tried, next_gap);
                    continue;
                }
            }
            let step = self.newton(&place, &shot).ok_or(FloquetError::NoOrbit)?;
            // Halve a step that is too long: it leaves the range in which the flow is nearly linear.
            let mut part = 1.0;
            loop {
                let moved = |x: &Vector, from: usize| Vector::from_fn(n, |i| x[i] + part * step[from + i]);
                let next = (moved(&place.0, 0), moved(&place.1, n));
                let tried = self.shoot(&next, digits).ok();
                let next_gap = tried.as_ref().map_or(f64::INFINITY, |shot| self.gap(&next, shot));
                match tried {
                    Some(tried) if next_gap < gap || (part < 0.1 && gap > ORBIT_ACCEPTED) => {
                        (place, shot, gap) = (next, tried, next_gap);
                        break;
                    }
                    // Rounding errors keep the gap from falling further.
                    Some(_) if gap <= ORBIT_ACCEPTED => break 'rounds,
                    None if part < 1e-3 => return Err(FloquetError::NoOrbit),
                    _ => part *= 0.5,
                }
            }
        }
        match shot.trouble {
            // A search that ends with `Digits::FEW` has not come near the solution.
            _ if digits == Digits::FEW || gap.is_nan() || gap > ORBIT_ACCEPTED => Err(FloquetError::NoOrbit),
            Some(why) => Err(FloquetError::NotSmooth { why }),
            None => Ok((place, shot)),
        }
    }

    /// The start of the next turn: the end of the turn from `place`, with the reference coordinate set back. One step of Newton's method on
    /// the speed of the reference coordinate alone makes this coordinate advance by the turn.
    fn onwards(&self, (q, v): &OrbitPoint, shot: &Shot) -> OrbitPoint {
        let (n, reference) = (q.len(), self.turn.reference);
        let mut next = (&shot.q - &self.turn.shift, shot.v.clone());
        let by_speed = shot.phi[(reference, n + reference)];
        let newton = (q[reference] - next.0[reference]) / by_speed;
        // Far from the solution, or if the end hardly depends on the speed at the start, scale the speed by the ratio of the turn to the
        // distance covered.
        let moved = (shot.q[reference] - q[reference]) / self.turn.shift[reference];
        let is_near = by_speed > 0.0 && newton.abs() <= ORBIT_SPEED_STEP * v[reference].abs();
        let speed = if is_near { v[reference] + newton } else { v[reference] / moved };
        (next.0[reference], next.1[reference]) = (q[reference], speed);
        next
    }

    /// The coordinates at a later point of the motion, where all laws are as far from steps as possible, so that turns begin and end within
    /// the same cells.
    fn aside(&self, about: &Steady) -> Result<Vector, FloquetError> {
        let courses: Vec<_> = steady::all_courses(self.scene, self.system)?;
        let courses: Vec<_> = courses.iter().filter(|course| course.turns()).collect();
        let Some(first) = courses.first() else { return Ok(about.q.clone()) };
        const PLACES: u32 = 512;
        let span = 1.0 / first.frequency();
        let distance = |t: f64| {
            let of = |course: &&SteadyLaw| {
                let phase = (course.start + course.speed * t).rem_euclid(course.period);
                let to = |end: f64| (phase - end).abs().min(course.period - (phase - end).abs());
                let nearest = course.levels.iter().map(|level| to(level.1)).fold(f64::INFINITY, f64::min);
                nearest / course.period
            };
            courses.iter().map(of).fold(f64::INFINITY, f64::min)
        };
        let times = (0..PLACES).map(|i| span * f64::from(i) / f64::from(PLACES));
        let t = times.max_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or(0.0);
        Ok(&about.q + &(&about.q_dot * t))
    }

    /// A run of a turn from a place.
    fn shoot(&self, (q, v): &OrbitPoint, digits: Digits) -> Result<Shot, FloquetError> {
        let mut scene = self.scene.clone();
        scene.t_end = self.turn.time;
        scene.solver.tolerance = scene.solver.tolerance.min(digits.run);
        for i in 0..q.len() {
            (scene.start.q[i], scene.start.q_dot[i]) = (Start::At(q[i]), Some(v[i]));
        }
        let equations = self.system.equations();
        let now = Hybrid::new(equations, &scene, start::begin(equations, &scene)?, None);
        let by_steps = |method| choice::numerical(&Choice { method, give_way: true, why: String::new() }, &scene);
        let named = scene.solver.method.filter(|method| !method.has_fixed_steps());
        let chosen = by_steps(named.unwrap_or(Method::Dop853)).or_else(|| by_steps(Method::Dop853));
        let (method, settings) = chosen.ok_or(FloquetError::Rigid)?;
        let solver = BySteps::new(&now, method, settings);
        let carried = Carried::new(&now, crate::engine::motion::Solver::rate(&solver));
        let frictions = (0..scene.model.laws.len()).filter(|&i| scene.model.laws[i].role.is_friction()).collect();
        let solver = Variational::new(&now, solver, Rc::clone(&carried), frictions, digits.disturbances);
        let mut simulation = Simulation::with(now, Box::new(solver))?;
        simulation
            .run(None, &mut |_| (self.watch)())
            .map_err(|stop| FloquetError::Stopped { why: stop.to_string() })?;
        let lengths = simulation.turn_lengths();
        let now = &simulation.now;
        let acceleration = &now.mobility() * &now.force();
        let (q, v) = (now.state.unwrapped(&lengths), now.state.q_dot.clone());
        let Carried { phi, units, trouble, .. } = &*RefCell::borrow(&carried);
        if phi.iter().any(|x| !x.is_finite()) {
            return Err(FloquetError::Overflow);
        }
        let phi = DMatrix::from_fn(phi.nrows(), phi.ncols(), |i, j| phi[(i, j)] * units[i] / units[j]);
        Ok(Shot { q, v, acceleration, phi, trouble: *trouble })
    }

    /// The norm of the residual of a turn [1]. Residuals of the speeds (except that of the reference), and of the elastic coordinates times
    /// the fastest rate, are relative to the rotation in the norm of the kinetic energy. The residual of the reference coordinate is
    /// relative to its advance in a turn.
    fn gap(&self, (q, v): &OrbitPoint, shot: &Shot) -> f64 {
        let ((rate, units), n, reference) = (self.units(), q.len(), self.turn.reference);
        let open = self.open((q, v), shot);
        let energy = |x: &dyn Fn(usize) -> f64| (0..n).map(|i| (x(i) / units[n + i]).powi(2)).sum::<f64>().sqrt();
        let elastic = |from: usize| energy(&|i| if i == reference { 0.0 } else { open[from + i] });
        let (speeds, places) = (elastic(n), rate * elastic(0));
        speeds.max(places) / energy(&|i| v[i]) + (open[reference] / self.turn.shift[reference]).abs()
    }

    /// The residual of a turn: changes of the coordinates less the turn, and changes of the speeds (2n).
    fn open(&self, (q, v): (&Vector, &Vector), shot: &Shot) -> DVector<f64> {
        let n = q.len();
        DVector::from_fn(
            2 * n,
            |i, _| {
                if i < n { shot.q[i] - q[i] - self.turn.shift[i] } else { shot.v[i - n] - v[i - n] }
            },
        )
    }

    /// The fastest rate of the linearised equations \[1/s\].
    fn rate(&self) -> f64 {
        let levels = self.scene.mid_stiffnesses();
        let Ok(m) = self.system.linearised(&levels) else { return 1.0 };
        (&m.mobility * &m.stiffness).amax().sqrt().max(1.0 / self.turn.time)
    }

    /// The fastest rate \[1/s\], and units of the coordinates and speeds (2n) \[SI\]. A unit of speed has the kinetic energy 1/2; a unit of
    /// a coordinate is that unit of speed over the rate.
    fn units(&self) -> (f64, DVector<f64>) {
        let rate = self.rate();
        let q = self.system.steady().map_or_else(|| Vector::zeros(0), |about| about.q.clone());
        let mass = self.system.equations().mass(&q);
        let n = mass.nrows();
        let unit = |i: usize| 1.0 / mass[(i % n, i % n)].sqrt() / if i < n { rate } else { 1.0 };
        (rate, DVector::from_fn(2 * n, |i, _| unit(i)))
    }

    /// Newton's step of coordinates and speeds (2n): the coordinate of the reference stays, and its speed at the end is free. `None` if the
    /// matrix has no decomposition.
    fn newton(&self, place: &OrbitPoint, shot: &Shot) -> Option<DVector<f64>> {
        let (n, reference) = (place.0.len(), self.turn.reference);
        let rows: Vec<usize> = (0..2 * n).filter(|i| *i != n + reference).collect();
        let columns: Vec<usize> = (0..2 * n).filter(|i| *i != reference).collect();
        let (_, units) = self.units();
        let open = self.open((&place.0, &place.1), shot);
        let matrix = DMatrix::from_fn(rows.len(), columns.len(), |r, c| {
            let at = (rows[r], columns[c]);
            (shot.phi[at] - f64::from(u8::from(at.0 == at.1))) * units[at.1] / units[at.0]
        });
        let right = DVector::from_fn(rows.len(), |r, _| -open[rows[r]] / units[rows[r]]);
        // Scale the unknowns to effects of similar size: the rotation is large, deflections are small.
        let sizes: Vec<f64> = matrix.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
        let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / sizes[j]);
        let svd = scaled.svd(true, true);
        let solved = svd.solve(&right, ORBIT_RANK * svd.singular_values.amax()).ok()?;
        let mut step = DVector::zeros(2 * n);
        columns.iter().enumerate().for_each(|(c, &column)| step[column] = solved[c] / sizes[c] * units[column]);
        step.iter().all(|x| x.is_finite()).then_some(step)
    }

    /// The multipliers of the map from turn to turn.
    fn multipliers(&self, place: &OrbitPoint, shot: &Shot) -> Result<Multipliers, FloquetError> {
        let n = place.0.len();
        let (_, units) = self.units();
        let rest: Vec<usize> = (0..2 * n).filter(|i| *i != self.turn.reference).collect();
        let rate = |i: usize| if i < n { shot.v[i] } else { shot.acceleration[i - n] };
        let speed = rate(self.turn.reference);
        let map = DMatrix::from_fn(rest.len(), rest.len(), |r, c| {
            let (row, column) = (rest[r], rest[c]);
            let along = shot.phi[(self.turn.reference, column)] / speed;
            (shot.phi[(row, column)] - rate(row) * along) * units[column] / units[row]
        });
        if map.iter().any(|x| !x.is_finite()) {
            return Err(FloquetError::Overflow);
        }
        let mut all: Vec<Complex<f64>> = map.complex_eigenvalues().iter().copied().collect();
        // Share of the rotation in the kinetic energy of the speeds of an eigenvector.
        let momentum = &self.system.equations().mass(&place.0) * &place.1;
        let rolling = self.rolling(place);
        let share = |z: &Complex<f64>| {
            let shifted = map.map(Complex::from) - DMatrix::from_diagonal_element(rest.len(), rest.len(), *z);
            let Some(v_t) = shifted.svd(false, true).v_t else { return 0.0 };
            let last = v_t.row(rest.len() - 1).map(|x| x.conj());
            let speeds: Vec<Complex<f64>> = (0..n)
                .map(|i| rest.iter().position(|r| *r == n + i).map_or(Complex::from(0.0), |at| last[at] * units[n + i]))
                .collect();
            let onto: Complex<f64> = (0..n).map(|i| speeds[i] * momentum[i]).sum();
            let mass = self.system.equations().mass(&place.0);
            let of: Complex<f64> = (0..n)
                .flat_map(|i| (0..n).map(move |j| (i, j)))
                .map(|(i, j)| speeds[i].conj() * speeds[j] * mass[(i, j)])
                .sum();
            // An eigenvector has coordinates and speeds. One without speeds is not the rotation.
            let places: f64 = rest.iter().zip(last.iter()).filter(|(r, _)| **r < n).map(|(_, x)| x.norm_sqr()).sum();
            onto.norm_sqr() / (2.0 * rolling * (of.re + places)).max(f64::MIN_POSITIVE)
        };
        let which = (0..all.len()).max_by(|&i, &j| share(&all[i]).total_cmp(&share(&all[j]))).unwrap_or(0);
        let speed = all.remove(which);
        all.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        Ok(Multipliers { others: all, speed, size: map.amax() })
    }

    /// The kinetic energy at a place \[J\].
    fn rolling(&self, (q, v): &OrbitPoint) -> f64 {
        self.system.equations().kinetic(q, v)
    }
}
