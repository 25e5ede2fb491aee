//! The run where torques vary in time: windows of a power series, breakpoints, and the account of what they do.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use super::{End, Simulation};
use crate::engine::clock::Clock;
use crate::engine::crossing::Side;
use crate::engine::equations::{Equations, Switching};
use crate::engine::error::{Refusal, Stop};
use crate::engine::forcing::Forcing;
use crate::engine::forcing::linear::Linear;
use crate::engine::forcing::window::{TERMS, Window};
use crate::engine::record::{Recorder, State};
use crate::engine::root;
use crate::engine::vector::Vector;
use crate::trajectory::Moment;

/// What varies, and the cells in which windows are opened.
#[derive(Debug, Clone)]
pub(super) struct Forced {
    forcing: Forcing,
    /// The cells that were met, by their numbers; the present one.
    cells: HashMap<usize, Linear>,
    present: usize,
}

impl Forced {
    pub fn new(forcing: Forcing) -> Self {
        Forced { forcing, cells: HashMap::new(), present: 0 }
    }

    /// Makes the cell of number `index`, with law values `k`, the present one.
    pub fn meet(&mut self, equations: &dyn Equations, index: usize, k: &[f64]) -> Result<(), Refusal> {
        self.present = index;
        if let Entry::Vacant(place) = self.cells.entry(index) {
            place.insert(Linear::new(equations, k)?);
        }
        Ok(())
    }

    pub fn is_flat(&self) -> bool {
        self.forcing.is_flat()
    }

    /// How a flight that would end at `horizon` \[s\] from now ends for what varies, and when.
    pub fn horizon(&self, clock: &Clock, horizon: f64) -> (End, f64) {
        let next = self.forcing.next();
        let next = if next.is_finite() { clock.until(next) } else { f64::INFINITY };
        if next < horizon { (End::Break, next.max(0.0)) } else { (End::Run, horizon) }
    }

    pub fn work(&self) -> &Vec<f64> {
        &self.forcing.work
    }

    pub fn work_after(&self, clock: &Clock, dq: &Vector) -> Vec<f64> {
        self.forcing.work_after(clock.now(), dq)
    }

    pub fn account(&mut self, clock: &Clock, dq: &Vector) {
        self.forcing.work = self.work_after(clock, dq);
    }
}

impl Simulation<'_> {
    /// Generalised forces of what varies, beyond those of the start (N).
    #[cold]
    pub(super) fn further_load(&self) -> Vector {
        let none = || Vector::zeros(self.state.q.len());
        self.forcing.as_ref().map_or_else(none, |forced| forced.forcing.load(self.clock.now()))
    }

    /// The accelerations that they give (N).
    #[cold]
    pub(super) fn further_acceleration(&self) -> Vector {
        &self.equations.mobility() * &self.further_load()
    }

    /// Goes on into the next pieces of the courses.
    #[cold]
    pub(super) fn enter_course(&mut self) -> Result<(), Stop> {
        if let Some(forced) = &mut self.forcing {
            let t = forced.forcing.next();
            self.clock.set(t);
            forced.forcing.enter(t);
        }
        // What is held may be pulled off by the new torque.
        let held = self.contact.take().map_or(vec![], |contact| contact.laws);
        self.hold(held)
    }

    /// One window, or as far into it as the next event: solve, locate, propagate.
    #[cold]
    pub(super) fn step_in_window(
        &mut self,
        recorder: &mut Option<(&mut Recorder<'_>, f64, bool)>,
        sample: &mut u64,
    ) -> Result<bool, Stop> {
        let Some(forced) = &self.forcing else { return Ok(true) };
        // Solve.
        let (mut end, mut left) = forced.horizon(&self.clock, self.clock.until(self.t_end));
        for (i, law) in self.laws.iter().enumerate() {
            if let Some((t, side)) = law.next_switch().filter(|_| law.switching != Switching::Never) {
                let t = self.clock.until(t).max(0.0);
                if t < left {
                    (end, left) = (End::Step(i, side), t);
                }
            }
        }
        let linear = match &self.contact {
            Some(contact) => &contact.linear,
            None => &forced.cells[&forced.present],
        };
        let State { q, q_dot, .. } = &self.state;
        let mut window = Window::begin(linear, &forced.forcing, &self.clock, q, q_dot, left);
        self.shorten(&mut window);
        // Locate.
        let (mut x, mut met, mut cost) = (1.0, None, self.counts.cost);
        cost.evaluations += 1;
        for (i, law) in self.laws.iter().enumerate() {
            let held = self.contact.as_ref().is_some_and(|contact| contact.holds(i));
            if law.switching == Switching::Never || law.next_switch().is_some() || held {
                continue;
            }
            let mut course = window.along(&law.surface.normal);
            // The rate as the state has it: the sum over the modes is known to roundings of these only.
            course[1] = law.surface.normal.dot(q_dot) * window.width;
            for side in [Side::Upper, Side::Lower] {
                let gap = side.sign() * (law.boundary(side) - q[law.phase]);
                let gap: [f64; TERMS] = std::array::from_fn(|n| if n == 0 { gap } else { -side.sign() * course[n] });
                let found = root::first_of::<TERMS>(&gap, 4.0 * law.rounding());
                (cost.steps, cost.grazes) = (cost.steps + found.steps, cost.grazes + found.grazes);
                if let Some(root) = found.root.filter(|root| met.is_none() || *root < x) {
                    (x, met) = (root, Some(End::Step(i, side)));
                }
            }
        }
        let here = self.here();
        for (i, banded) in here.bands.iter().enumerate() {
            for (beyond, watch) in &banded.exits {
                let value = self.left_to(watch);
                let zero = watch.first_zero_in(value, &Vector::zeros(self.state.q.len()), &window, &mut cost);
                if let Some(root) = zero.filter(|root| met.is_none() || *root < x) {
                    (x, met) = (root, Some(End::Flank(i, *beyond)));
                }
            }
        }
        if let Some(contact) = &self.contact {
            let load = self.further_load();
            let until = if met.is_some() { x } else { f64::INFINITY };
            if let Some((at, law, ending)) = contact.first_in(&window, &self.state, &load, until, &mut cost) {
                (x, met) = (at, Some(End::Hold(law, ending)));
            }
        }
        if let Some((recorder, rate, _)) = recorder {
            self.samples_in(&window, x, *rate, sample, recorder);
        }
        // Propagate.
        let (dq, dv) = window.increments(x);
        let gains = window.gains(&forced.forcing, x);
        let lost = gains.lost + self.clipped(here, &dq);
        let passed = x * window.width;
        // The window ended before anything else did.
        let open = met.is_none() && window.width < left;
        self.counts.cost = cost;
        self.dissipated += lost;
        self.state.q += &dq;
        self.state.gain(&dv);
        if let Some(forced) = &mut self.forcing {
            forced.forcing.work.iter_mut().zip(gains.work).for_each(|(work, more)| *work += more);
        }
        self.clock.advance(passed);
        if open {
            self.demand_numbers()?;
            return Ok(false);
        }
        self.finish(met.unwrap_or(end), recorder)
    }

    /// Shortens a window in which a phase would go far beyond its cell: its polynomial keeps its digits.
    fn shorten(&self, window: &mut Window<'_>) {
        for law in &self.laws {
            let (lower, upper) = law.bounds();
            for _ in 0..4 {
                let course = window.along(&law.surface.normal);
                let far = course[1].abs() + course[2].abs() + course[3].abs();
                let part = 2.0 * (upper - lower) / far;
                if part.is_nan() || part >= 1.0 {
                    break;
                }
                window.shorten(part.max(1e-3));
            }
        }
    }

    fn samples_in(&self, window: &Window<'_>, x: f64, rate: f64, next: &mut u64, recorder: &mut Recorder<'_>) {
        let Some(forced) = &self.forcing else { return };
        loop {
            let at = *next as f64 / rate;
            let tau = self.clock.until(at);
            if tau > x * window.width || at >= self.t_end {
                return;
            }
            let part = if window.width > 0.0 { (tau / window.width).clamp(0.0, x) } else { 0.0 };
            let (dq, dv) = window.increments(part);
            let gains = window.gains(&forced.forcing, part);
            let state = self.state.moved(&dq, &dv);
            recorder.beyond = forced.forcing.work.iter().zip(gains.work).map(|(work, more)| work + more).collect();
            let lost = self.dissipated + gains.lost + self.clipped(self.here(), &dq);
            recorder.row(at, Moment::Sample, &state, &self.k, (lost, self.ignored));
            *next += 1;
        }
    }
}
