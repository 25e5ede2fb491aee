//! The energy account of a flight: the energy that damping takes, and the work of torques that vary, as integrals of the speeds.
//!
//! They are the integrals of products of sums of exponentials ([`Speeds`]). Where the terms cancel (near critical damping, near resonance),
//! Gauss-Legendre quadrature is used instead.

use nalgebra::Complex;

use super::speeds::{Speed, Speeds, Sum, Term, at, derivative, product, rate_of};
use super::{Driven, Flight, Point, Varying};
use crate::engine::forcing::Onward;
use crate::engine::mode::GAUSS_16;
use crate::engine::vector::{Vector, dot};
use crate::tolerance::modes::{DECAYED, QUADRATURE_PANEL};

/// The account of a driven flight.
#[derive(Debug)]
pub struct Gains {
    /// `None` if the eigenvalues of a mode coincide.
    speeds: Option<Speeds>,
    /// All terms of the speed of each mode.
    terms: Vec<Sum>,
    works: Vec<Work>,
    /// Number of torques of the scene.
    torques: usize,
}

/// The work of a parameter that varies on one torque of the scene.
#[derive(Debug)]
struct Work {
    torque: usize,
    /// The parameter.
    value: Sum,
    /// The displacement that it acts on, as a function of displacements and speeds of the modes, and of the forces that vary.
    along: (Vector, Option<Vector>, Option<Varying>),
}

impl Gains {
    /// The account of `flight` under the torques `onward`, until the time `horizon` \[s\].
    pub fn new(flight: &Flight<'_>, driven: &Driven, onward: &[Onward<'_>], horizon: f64) -> Self {
        let works = onward.iter().flat_map(|of| {
            let rows = of.power.iter().enumerate().filter(|(_, row)| row.amax() > 0.0);
            rows.map(|(torque, row)| {
                let (on_moved, on_speed) = flight.cell.follow(row, None);
                let on_force = flight.cell.follow_force(row, None);
                let along = (on_moved, on_speed, on_force.map(|on_force| driven.force.along(&on_force)));
                Work { torque, value: value(of), along }
            })
        });
        let torques = onward.first().map_or(0, |of| of.power.len());
        let speeds = Speeds::new(flight, horizon);
        let terms = speeds.iter().flat_map(|speeds| &speeds.0).map(Speed::terms).collect();
        Gains { speeds, terms, works: works.collect(), torques }
    }

    /// Energy that damping has taken until a `point`, and the work of each torque beyond that of its value at the start of the run \[J\].
    pub fn until(&self, flight: &Flight<'_>, driven: &Driven, point: &Point) -> (f64, Vec<f64>) {
        let mut work = vec![0.0; self.torques];
        if point.t == 0.0 {
            return (0.0, work);
        }
        let speeds = self.speeds.as_ref().filter(|speeds| speeds.keep_digits(flight, point));
        let Some(lost) = speeds.and_then(|speeds| speeds.lost(flight, point.t)) else {
            let lost = by_quadrature(flight, point.t, |weight, point, (v, a)| {
                self.works.iter().for_each(|of| work[of.torque] += weight * of.power(driven, point, (v, a)));
            });
            return (lost, work);
        };
        self.works.iter().for_each(|of| work[of.torque] += of.until(&self.terms, driven, point.t));
        (lost, work)
    }
}

impl Work {
    /// The work until the time `t` \[s\].
    fn until(&self, terms: &[Sum], driven: &Driven, t: f64) -> f64 {
        let (on_moved, on_speed, direct) = &self.along;
        let mut work = direct.as_ref().map_or(0.0, |direct| product(&self.value, &rate_of(direct, driven, 0), t));
        for (i, sum) in terms.iter().enumerate() {
            if on_moved[i] != 0.0 {
                work += on_moved[i] * product(&self.value, sum, t);
            }
            if let Some(by) = on_speed.as_ref().map(|on_speed| on_speed[i]).filter(|by| *by != 0.0) {
                work += by * product(&self.value, &derivative(sum), t);
            }
        }
        work
    }

    /// The power at a `point` with the speeds and accelerations of the modes.
    fn power(&self, driven: &Driven, point: &Point, (v, a): (&[f64], &[f64])) -> f64 {
        let (on_moved, on_speed, direct) = &self.along;
        let direct = direct.as_ref().map_or(0.0, |direct| rate_at(direct, 0, driven, point));
        at(&self.value, point.t) * (dot(on_moved, v) + on_speed.as_ref().map_or(0.0, |by| dot(by, a)) + direct)
    }
}

impl Flight<'_> {
    /// Energy that modes which damping couples have lost until a `point` \[J\].
    #[cold]
    pub(super) fn lost_by_coupled(&self, point: &Point) -> f64 {
        let speeds = Speeds::new(self, point.t).filter(|speeds| speeds.keep_digits(self, point));
        let lost = speeds.and_then(|speeds| speeds.lost(self, point.t));
        lost.unwrap_or_else(|| by_quadrature(self, point.t, |_, _, _| {}))
    }

    /// Power that damping takes at a `point` with the speeds and accelerations of the modes \[W\].
    fn damping_power(&self, point: &Point, (v, a): (&[f64], &[f64])) -> f64 {
        let Some(coupling) = &self.cell.coupling else {
            return (0..self.n()).map(|i| 2.0 * self.mode(i).sigma * v[i] * v[i]).sum();
        };
        let of_speed = self.driven().and_then(|driven| Some((driven, &driven.coupled.as_ref()?[0])));
        let by_forces = |i: usize| of_speed.map_or(0.0, |(driven, of_speed)| rate_at(of_speed, i, driven, point));
        coupling.power(v, &Vector::from_fn(self.n(), |i| a[i] - by_forces(i)))
    }
}

/// The rate of entry `i` of a vector that varies.
fn rate_at(of: &Varying, i: usize, driven: &Driven, point: &Point) -> f64 {
    of.derivatives(i, point.t, &driven.frequencies, &point.phases)[1]
}

/// Energy that damping takes until the time `t` \[s\], by quadrature over panels \[J\]. In each, the fastest mode that has not yet decayed and the
/// fastest load turn by at most two radians, so that the 16-point rule is exact to rounding. `also` is called with the weight of each node,
/// and the speeds and accelerations of the modes there.
fn by_quadrature(flight: &Flight<'_>, t: f64, mut also: impl FnMut(f64, &Point, (&[f64], &[f64]))) -> f64 {
    let (mut begin, mut lost) = (0.0, 0.0);
    while begin < t {
        let alive = flight.modes().iter().filter(|mode| mode.slowest() * begin < DECAYED);
        let fastest = alive.map(|mode| mode.rate).fold(flight.driven().map_or(0.0, Driven::fastest), f64::max);
        let end = if fastest > 0.0 { t.min(begin + QUADRATURE_PANEL / fastest) } else { t };
        if end <= begin {
            break;
        }
        let half = 0.5 * (end - begin);
        for (x, weight) in GAUSS_16.into_iter().flat_map(|(x, weight)| [(x, weight), (-x, weight)]) {
            let point = flight.at(begin + half * (1.0 + x));
            let (v, a): (Vec<f64>, Vec<f64>) = (0..flight.n()).map(|i| flight.rates(i, &point)).unzip();
            lost += weight * half * flight.damping_power(&point, (&v, &a));
            also(weight * half, &point, (&v, &a));
        }
        begin = end;
    }
    lost
}

/// A parameter beyond its value at the start of the run.
fn value(of: &Onward<'_>) -> Sum {
    let constant = of.now - of.swings.iter().map(|(_, swing)| swing.re).sum::<f64>();
    let term = |w: f64, power| Term { rate: Complex::new(0.0, w), power };
    let mut sum: Sum = [(term(0.0, 0), constant.into())].into_iter().collect();
    if of.slope != 0.0 {
        sum.push((term(0.0, 1), of.slope.into()));
    }
    for (w, swing) in &of.swings {
        sum.extend([(term(*w, 0), swing * 0.5), (term(-*w, 0), swing.conj() * 0.5)]);
    }
    sum
}
