//! The kernel with one lane: plain events of a single simulation.

use pulp::NullaryFnOnce;

use crate::engine::lanes::jump::Attempt;
use crate::engine::lanes::kind::Kind;
use crate::engine::lanes::pack::Mask;
use crate::engine::lanes::vectors::Vectors;
use crate::engine::lanes::{LARGEST, Lanes};
use crate::engine::record::State;
use crate::engine::simulate::Simulation;

/// The kernel for one simulation, for any number of coordinates.
pub trait Alone: Send + Sync {
    /// The time to the next event [s]; `None` if the event is not plain.
    fn locate(&mut self, simulation: &Simulation<'_>) -> Option<f64>;

    /// Sets `state` to the state just before the located event; returns the time of the event [s], and the energy dissipated
    /// until then [J].
    fn arrive(&self, state: &mut State) -> (f64, f64);

    /// Moves the simulation past the located event, and counts the evaluations of the motion.
    fn pass(&mut self, simulation: &mut Simulation<'_>);

    /// Moves the simulation past its plain events before the time `until` \[s\], at most some thousand.
    fn advance(&mut self, simulation: &mut Simulation<'_>, until: f64) -> Stopped;
}

/// Why [`Alone::advance`] returned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stopped {
    /// It has passed the maximum number of events of one call.
    Enough,
    /// The next event is plain, but it is not before the given time.
    Due,
    /// The next event is not plain.
    General,
}

/// Maximum number of events in one call of [`Alone::advance`]: about ten microseconds of computing time.
const AT_ONCE: u64 = 1024;

/// The kernel for a simulation; `None` if none of its events can be plain.
pub fn of(simulation: &Simulation<'_>) -> Option<Box<dyn Alone>> {
    let kind = Kind::of(simulation)?;
    Some(match kind.rigid.len() {
        0..=2 => Box::new(Lane::<2>::new(&kind, simulation)),
        3..=4 => Box::new(Lane::<4>::new(&kind, simulation)),
        _ => Box::new(Lane::<LARGEST>::new(&kind, simulation)),
    })
}

struct Lane<const N: usize> {
    lanes: Lanes<N, 1>,
    next: Option<Attempt<N, 1>>,
    vectors: Vectors,
}

impl<const N: usize> Lane<N> {
    fn new(kind: &Kind, simulation: &Simulation<'_>) -> Self {
        let mut lanes = Lanes::new(kind);
        lanes.load(0, simulation, true);
        Lane { lanes, next: None, vectors: kind.vectors }
    }
}

impl<const N: usize> Alone for Lane<N> {
    #[inline]
    fn locate(&mut self, simulation: &Simulation<'_>) -> Option<f64> {
        self.lanes.load(0, simulation, false);
        let attempt = self.vectors.run(Try(&self.lanes));
        self.next = attempt.sure.is_set(0).then_some(attempt);
        self.next.map(|attempt| attempt.t.0[0])
    }

    fn arrive(&self, state: &mut State) -> (f64, f64) {
        let Some(Attempt { t, arrival: [q, q_dot], dissipated, .. }) = &self.next else { return (f64::NAN, f64::NAN) };
        for i in 0..state.q.len() {
            (state.q[i], state.q_dot[i]) = (q[i].0[0], q_dot[i].0[0]);
        }
        (self.lanes.clock_after(*t)[0].0[0], dissipated.0[0])
    }

    #[inline]
    fn pass(&mut self, simulation: &mut Simulation<'_>) {
        let Some(attempt) = self.next.take() else { return };
        self.lanes.take(&attempt);
        self.lanes.unload(0, simulation);
        simulation.now.counts.cost.evaluations += attempt.evaluations as u64;
        simulation.now.counts.cost.steps += attempt.evaluations as u64;
    }

    fn advance(&mut self, simulation: &mut Simulation<'_>, until: f64) -> Stopped {
        self.lanes.load(0, simulation, false);
        let (stopped, evaluations) = self.vectors.run(Advance { lanes: &mut self.lanes, until });
        if evaluations > 0 {
            self.lanes.unload(0, simulation);
            simulation.now.counts.cost.evaluations += evaluations;
            simulation.now.counts.cost.steps += evaluations;
        }
        stopped
    }
}

/// The job of [`Alone::advance`].
struct Advance<'l, const N: usize> {
    lanes: &'l mut Lanes<N, 1>,
    until: f64,
}

impl<const N: usize> NullaryFnOnce for Advance<'_, N> {
    /// Why it stopped, and the number of evaluations of the motion.
    type Output = (Stopped, u64);

    #[inline(always)]
    fn call(self) -> (Stopped, u64) {
        let Advance { lanes, until } = self;
        let mut evaluations = 0;
        for _ in 0..AT_ONCE {
            let attempt = lanes.attempt(Mask::of(|_| true));
            if !attempt.sure.is_set(0) {
                return (Stopped::General, evaluations);
            }
            if lanes.clock_after(attempt.t)[0].0[0] >= until {
                return (Stopped::Due, evaluations);
            }
            lanes.take(&attempt);
            evaluations += attempt.evaluations as u64;
        }
        (Stopped::Enough, evaluations)
    }
}

/// The job of [`Alone::locate`].
struct Try<'l, const N: usize>(&'l Lanes<N, 1>);

impl<const N: usize> NullaryFnOnce for Try<'_, N> {
    type Output = Attempt<N, 1>;

    #[inline(always)]
    fn call(self) -> Attempt<N, 1> {
        self.0.attempt(Mask::of(|_| true))
    }
}
