//! The interface between the hybrid loop and a solver: the motion between two events.
//!
//! There are two kinds of motion: a flight in closed form through a linear cell ([`exact`](crate::engine::exact)), and a step of a numerical
//! method with its dense output ([`steps`](crate::methods::steps)). The loop ([`simulate`](crate::engine::simulate)) is the same for both.

use xprec::Df64;

use crate::engine::cells::Cells;
use crate::engine::contact::Ending;
use crate::engine::crossing::{Cost, SearchError, Side};
use crate::engine::error::{Refusal, Stop};
use crate::engine::hybrid::Hybrid;
use crate::engine::jump::Passage;
use crate::engine::record::State;
use crate::tolerance::events::RELEASE;

/// A method that computes the motion in a mode.
pub trait Solver {
    /// Prepares the solver for the mode of `now`: its laws, switches, holds and torques. Sets the guards of the switches of `now`.
    ///
    /// # Errors
    /// If the equations of the mode cannot be solved.
    fn enter(&mut self, now: &mut Hybrid<'_>) -> Result<(), Refusal>;

    /// The motion from the state of `now`, for at most the time `horizon` \[s\].
    ///
    /// # Errors
    /// If the motion cannot be computed.
    fn solve<'s>(&'s mut self, now: &'s Hybrid<'_>, horizon: f64) -> Result<Box<dyn Motion + 's>, Stop>;

    /// A bound on the rates of the motion in the present mode \[1/s\].
    fn rate(&self) -> f64;

    /// Changes the speeds at the step of `law` that is met at `side`.
    fn jump(&mut self, now: &mut Hybrid<'_>, law: usize, side: Side) -> Passage {
        now.jump(law, side)
    }

    /// Whether events are located. If not, they are handled after the step in which they happened.
    fn locates(&self) -> bool {
        true
    }

    /// How accurately reactions are known where a motion ends [relative to the forces they consist of].
    fn release(&self) -> f64 {
        RELEASE
    }

    /// The linear cells, if the solver has them in plain precision.
    fn cells(&self) -> Option<&Cells> {
        None
    }

    /// What the solver did so far.
    fn effort(&self) -> Effort {
        Effort::default()
    }
}

/// The motion from one state of a run, in one mode.
pub trait Motion {
    /// Length of time over which the motion is known \[s\]; may be infinite.
    fn length(&self) -> f64;

    /// The first time \[s\] before `until` at which `guard` is met, and at which side.
    ///
    /// # Errors
    /// If the search does not end, or a number overflows.
    fn first(&mut self, guard: Guard, until: f64, cost: &mut Cost) -> Result<Option<(f64, Side)>, SearchError>;

    /// The state after the time `t` \[s\], which is at most its length.
    fn at(&mut self, t: f64) -> Reached;

    /// The state at the end `end`, at about the time `t` \[s\], and that time as exactly as it is known.
    fn arrive(&mut self, t: f64, end: End, cost: &mut Cost) -> (Df64, Reached);
}

/// A function of the state whose first zero ends a motion.
#[derive(Debug, Clone, Copy)]
pub enum Guard {
    /// The distances of the phase of a law to the two boundaries of its cell.
    Phase(usize),
    /// The guard of an exit of a switch: the switch, and which of the exits.
    Exit(usize, usize),
    /// A function that ends a hold: its index in [`Contact::watches`](crate::engine::contact::Contact::watches).
    Hold(usize),
}

/// How a motion ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// The motion is not known any further; there is no event.
    Open,
    /// A law meets a boundary of its cell.
    Step(usize, Side),
    /// The hold of a law ends: the law leaves, or slips through.
    Hold(usize, Ending),
    /// A switch takes an exit: the switch, and which of the exits of its mode.
    Exit(usize, usize),
    /// A switch no longer holds its deflection: the switch, and the mode that follows.
    Loose(usize, usize),
    /// The time history of a torque has a breakpoint.
    Breakpoint,
    /// The run is over.
    Run,
}

/// The state that a motion has reached.
#[derive(Debug, Clone)]
pub struct Reached {
    /// The state.
    pub state: State,
    /// Energy that damping has taken since the motion began \[J\].
    pub dissipated: f64,
    /// Work of the varying part of each torque since then \[J\]; empty if all torques are constant.
    pub work: Vec<f64>,
}

/// What a method by steps did.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Effort {
    /// Steps taken.
    pub steps: u64,
    /// Steps that were rejected.
    pub rejected: u64,
    /// When the method was replaced by an implicit one \[s\], and by which.
    pub replaced: Option<(f64, &'static str)>,
}
