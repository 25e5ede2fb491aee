//! Driven flights of random cells: their motion against the power series of M q'' + C q' + K q = f(t) in 100 digits, their energy account
//! against that of the motion, and their first crossings against samples.

use gearsim_tests::precise::number::{Real, Scalar};
use nalgebra::{DMatrix, DVector};

use super::*;
use crate::engine::crossing::{Cost, Search, Side};
use crate::engine::forcing::Onward;
use crate::engine::modal::Matrices;
use crate::engine::signal::Signal;

type Many = Real<400>;

/// Coordinates of the cells.
const N: usize = 3;

struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn power(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(low + (high - low) * self.unit())
    }

    fn sign(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }
}

/// A cell, a state, and a parameter that varies.
struct Case {
    matrices: Matrices,
    q: Vector,
    v: Vector,
    /// Generalised forces per unit of the parameter.
    load: Vector,
    slope: f64,
    /// The angular frequency and the complex amplitude of each swing.
    swings: Vec<(f64, Complex<f64>)>,
    coupled: bool,
}

/// A chain of three rotors with stiffnesses and dampers over many decades, free or tied to the ground.
fn case(random: &mut Random, number: u64) -> Case {
    let coupled = number % 2 == 1;
    let inertia: Vec<f64> = (0..N).map(|_| random.power(-1.0, 1.0)).collect();
    let (mut stiffness, mut damping) = (DMatrix::zeros(N, N), DMatrix::zeros(N, N));
    let mut tie = |i: usize, j: Option<usize>, k: f64, c: f64| {
        for (a, x) in [(&mut stiffness, k), (&mut damping, c)] {
            let ends: Vec<(usize, f64)> = [(i, 1.0)].into_iter().chain(j.map(|j| (j, -1.0))).collect();
            for (p, by) in &ends {
                ends.iter().for_each(|(q, and)| a[(*p, *q)] += by * and * x);
            }
        }
    };
    let beta = random.power(-4.0, 0.0);
    for (i, j) in [(0, 1), (1, 2)] {
        let k = random.power(-2.0, 3.0);
        let own = if random.unit() < 0.7 { random.power(-3.0, 1.5) } else { 0.0 };
        tie(i, Some(j), k, if coupled { own } else { beta * k });
    }
    if number.is_multiple_of(3) {
        let k = random.power(-1.0, 2.0);
        tie(0, None, k, if coupled { 0.0 } else { beta * k });
    }
    if coupled && number.is_multiple_of(5) {
        tie(2, None, 0.0, random.power(-2.0, 1.0));
    }
    let mass = DMatrix::from_diagonal(&DVector::from_vec(inertia.clone()));
    let mobility = DMatrix::from_diagonal(&DVector::from_vec(inertia.iter().map(|m| 1.0 / m).collect()));
    let load = DVector::from_fn(N, |_, _| random.sign());
    let matrices = Matrices { mass, mobility, damping, stiffness, load };
    let frequencies: Vec<f64> = Cell::of(&matrices).unwrap().modes.iter().map(|mode| mode.omega2.sqrt()).collect();
    let swing = |random: &mut Random| {
        // On resonance, close to it, or anywhere.
        let near = frequencies[2] * (1.0 + [0.0, 1e-12, 1e-4][(number % 3) as usize]);
        let w = if random.unit() < 0.4 { near } else { random.power(-2.0, 1.5) };
        (w, Complex::new(random.sign(), random.sign()))
    };
    let swings = (0..number % 3).map(|_| swing(random)).collect();
    let [q, v, on] = [(); 3].map(|()| Vector::from_fn(N, |_| random.sign()));
    Case {
        matrices,
        q,
        v,
        load: on,
        slope: if number.is_multiple_of(4) { 0.0 } else { random.sign() },
        swings,
        coupled,
    }
}

impl Case {
    fn onward(&self) -> [Onward<'_>; 1] {
        [Onward {
            now: 0.3,
            slope: self.slope,
            swings: self.swings.iter().copied().collect(),
            load: &self.load,
            power: std::slice::from_ref(&self.load),
        }]
    }

    fn flight<'a>(&self, cell: &'a Cell) -> Flight<'a> {
        let onward = self.onward();
        let flight = cell.pushed(cell.flight(&self.q, &self.v), &Onward::force(&onward, N));
        let (frequencies, force) = Onward::varying(&onward, N).expect("loads that vary");
        cell.driven(flight, frequencies, force)
    }

    /// q and q' after the time `t` by their power series, and the sizes of their terms.
    fn by_series(&self, t: f64) -> [Vec<f64>; 2] {
        let exact = |x: f64| Many::exact(x);
        let Matrices { mobility, damping, stiffness, load, .. } = &self.matrices;
        let mut terms: Vec<Vec<Many>> =
            vec![(0..N).map(|i| exact(self.q[i])).collect(), (0..N).map(|i| exact(self.v[i]) * exact(t)).collect()];
        let mut swings: Vec<(Many, Many, f64)> =
            self.swings.iter().map(|(w, c)| (exact(c.re), exact(c.im), *w)).collect();
        for n in 0..260u32 {
            let mut varying = exact(0.0);
            match n {
                0 => varying = exact(0.3),
                1 => varying = exact(self.slope) * exact(t),
                _ => {}
            }
            for (re, im, w) in &mut swings {
                if n > 0 {
                    let by = (exact(*w) * exact(t)).over(n);
                    (*re, *im) = (-(im.clone() * by.clone()), re.clone() * by);
                    varying = varying + re.clone();
                }
            }
            let next = (0..N).map(|i| {
                let mut force = varying.clone() * exact(self.load[i]);
                if n == 0 {
                    force = force + exact(load[i]);
                }
                for j in 0..N {
                    force = force - exact(stiffness[(i, j)]) * terms[n as usize][j].clone();
                    let drag = exact(damping[(i, j)]) * terms[n as usize + 1][j].clone();
                    force = force - (drag * exact(f64::from(n + 1))) / exact(t);
                }
                (force * exact(mobility[(i, i)]) * exact(t) * exact(t)).over((n + 1) * (n + 2))
            });
            let next: Vec<Many> = next.collect();
            terms.push(next);
        }
        let sum = |by: &dyn Fn(usize) -> f64, per: f64, i: usize| {
            let of = |(n, term): (usize, &Vec<Many>)| term[i].clone() * exact(by(n));
            (terms.iter().enumerate().map(of).fold(exact(0.0), |sum, x| sum + x) / exact(per)).approx()
        };
        [(0..N).map(|i| sum(&|_| 1.0, 1.0, i)).collect(), (0..N).map(|i| sum(&|n| n as f64, t, i)).collect()]
    }
}

/// Every second cell has modes that damping couples.
#[test]
fn driven_flights_match_their_series() {
    let mut random = Random(11);
    let (mut worst, mut coupled) = ((0.0, 0), 0);
    for number in 0..400 {
        let case = case(&mut random, number);
        let Ok(cell) = Cell::of(&case.matrices) else { continue };
        coupled += u64::from(cell.coupling.is_some());
        assert!(case.coupled || cell.coupling.is_none());
        if Onward::varying(&case.onward(), N).is_none() {
            continue;
        }
        let flight = case.flight(&cell);
        let t = random.power(-3.0, 1.2) / flight.rate();
        let (dq, dv) = flight.increments(&flight.at(t));
        let [q, v] = case.by_series(t);
        let condition = cell.coupling.as_ref().map_or(1.0, |coupling| coupling.condition);
        let size = |x: &[f64], start: &Vector| x.iter().chain(start.iter()).fold(1.0f64, |m, x| m.max(x.abs()));
        let (far, fast) = (size(&q, &case.q), size(&v, &case.v));
        for i in 0..N {
            let off = ((case.q[i] + dq[i] - q[i]) / far).abs().max(((case.v[i] + dv[i] - v[i]) / fast).abs());
            let off = off / (f64::EPSILON * condition * (1.0 + flight.rate() * t));
            if off.is_nan() || off > worst.0 {
                worst = (off, number);
            }
        }
    }
    assert!(coupled > 150 && worst.0 < 2e3, "{coupled}, {worst:?}");
}

/// T + V - work + loss is constant: the loss and the work are integrals of the speeds, T and V are values of the state.
#[test]
fn the_account_of_a_driven_flight_closes() {
    let mut random = Random(12);
    let mut worst = (0.0, 0);
    for number in 0..2000 {
        let case = case(&mut random, number);
        let Ok(cell) = Cell::of(&case.matrices) else { continue };
        let onward = case.onward();
        if Onward::varying(&onward, N).is_none() {
            continue;
        }
        let flight = case.flight(&cell);
        let t = random.power(-3.0, 3.0) / flight.rate();
        let gains = crate::engine::cell::Gains::new(&flight, flight.driven().unwrap(), &onward, t);
        let point = flight.at(t);
        let ((dq, dv), (lost, work)) =
            (flight.increments(&point), gains.until(&flight, flight.driven().unwrap(), &point));
        let Matrices { mass, stiffness, load, .. } = &case.matrices;
        let energy = |q: &Vector, v: &Vector| {
            let (q, v) = (DVector::from(q), DVector::from(v));
            [0.5 * v.dot(&(mass * &v)), 0.5 * q.dot(&(stiffness * &q)), -q.dot(load)]
        };
        let (before, after) = (energy(&case.q, &case.v), energy(&(&case.q + &dq), &(&case.v + &dv)));
        let size: f64 = before.iter().chain(&after).chain(&[lost, work[0]]).map(|x| x.abs()).sum();
        let off = after.iter().sum::<f64>() - before.iter().sum::<f64>() - work[0] + lost;
        let condition = cell.coupling.as_ref().map_or(1.0, |coupling| coupling.condition);
        let off = (off / size).abs() / (condition * (1.0 + flight.rate() * t));
        if off.is_nan() || off > worst.0 {
            worst = (off, number);
        }
    }
    assert!(worst.0 < 3e-12, "{worst:?}");
}

/// The first crossing of a boundary by a coordinate is found, and found where the sampled motion has it.
#[test]
fn the_first_crossing_of_a_driven_flight_is_found() {
    let mut random = Random(13);
    let mut found = 0;
    for number in 0..1500 {
        let case = case(&mut random, number);
        let Ok(cell) = Cell::of(&case.matrices) else { continue };
        if Onward::varying(&case.onward(), N).is_none() {
            continue;
        }
        let flight = case.flight(&cell);
        let horizon = random.power(-1.0, 2.0) / flight.rate();
        let gap = random.power(-4.0, 1.0);
        let row = Vector::from([1.0, 0.0, 0.0]);
        let (on_moved, on_speed) = cell.follow(&row, None);
        let direct = cell.follow_force(&row, None).map(|on_force| flight.driven().unwrap().force.along(&on_force));
        let signal =
            Signal { flight: &flight, on_moved: &on_moved, on_speed: on_speed.as_deref(), direct: direct.as_ref() };
        let search = Search { signal, rate: case.v[0], down: gap, up: gap, horizon };
        let (mut point, mut cost) = (flight.begin(), Cost::default());
        let side = search.first(&mut point, &mut cost).unwrap();
        let moved = |t: f64| flight.increments(&flight.at(t)).0[0];
        let until = if side.is_some() { point.t } else { horizon };
        let beyond = (0..4000).map(|i| until * f64::from(i) / 4000.0).find(|t| moved(*t).abs() > gap * (1.0 + 1e-12));
        assert!(beyond.is_none(), "{number}: at {beyond:?} s, found {side:?} at {:e} s", point.t);
        if let Some(side) = side {
            found += 1;
            let off = moved(point.t) - if side == Side::Upper { gap } else { -gap };
            assert!(off.abs() < 1e-9 * gap.max(case.q[0].abs() * 1e-3), "{number}: {off:e} beyond {gap:e}");
        }
    }
    assert!(found > 400, "{found}");
}
