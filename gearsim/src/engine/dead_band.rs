//! Play: a deflection that is felt only beyond a dead band, and the flank that is in contact there.
//!
//! At the depth x >= 0 beyond an edge a spring kappa and a damper gamma are in contact. The damper never pulls, nor pushes
//! more than the spring (as in Modelica.Mechanics.Rotational.Components.ElastoBacklash2):
//!
//! | grip | while | force of the contact |
//! | --- | --- | --- |
//! | touch | -kappa x <= gamma x' <= kappa x | kappa x + gamma x' |
//! | hit | gamma x' > kappa x | 2 kappa x |
//! | loose | gamma x' < -kappa x | 0 |
//!
//! Each is a linear cell, and its end the first zero of a linear function of the state. Forces and energies pass from one to
//! the next without a step, so there is no impulse; and none of them feeds energy in.
//!
//! A transmission error e moves both edges. Where it steps, flanks may part or meet at once, and V steps with the regime: an
//! impulse like any other ([`law::barrier`](crate::engine::law::barrier)).

use smallvec::{SmallVec, smallvec};

use crate::engine::crossing::Side;
use crate::engine::equations::Equations;
use crate::engine::vector::{Matrix, Vector};
use crate::model::Model;
use crate::tolerance::events::EDGE_ROUNDING;

/// Where a dead band stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// Within the play.
    Free,
    /// In contact beyond an edge.
    Contact(Side, Grip),
}

/// What the damper of a contact does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grip {
    /// It acts.
    Touch,
    /// It would push more than the spring, and pushes as much.
    Hit,
    /// It would pull more than the spring pushes: there is no force.
    Loose,
}

use Grip::{Hit, Loose, Touch};
use Regime::{Contact, Free};

impl Grip {
    /// Whether the spring limits the force of the damper.
    pub fn is_clipped(self) -> bool {
        self != Touch
    }

    /// The force of a clipped damper, in units of the spring's.
    fn clip(self) -> f64 {
        match self {
            Touch => 0.0,
            Hit => 1.0,
            Loose => -1.0,
        }
    }
}

/// A dead band under way.
#[derive(Debug, Clone)]
pub struct DeadBand {
    /// Where its law values begin.
    at: usize,
    /// Gradient of its deflection (N).
    pub normal: Vector,
    /// Half its width.
    pub half: f64,
    /// The laws that move its deflection, and by how much a unit of each does.
    pub errors: Vec<(usize, f64)>,
    /// How far they move it now.
    offset: f64,
    /// Where it stands. State: not worked out from the deflection.
    pub regime: Regime,
}

/// Law values of a dead band: touch, edge, damp, clip.
pub const VALUES: usize = 4;
/// Every regime, by its number.
pub const REGIMES: [Regime; 7] = [
    Free,
    Contact(Side::Upper, Touch),
    Contact(Side::Lower, Touch),
    Contact(Side::Upper, Hit),
    Contact(Side::Lower, Hit),
    Contact(Side::Upper, Loose),
    Contact(Side::Lower, Loose),
];

/// Spring kappa and damper gamma of a contact, in the unit of its deflection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// kappa.
    pub spring: f64,
    /// gamma.
    pub damper: f64,
}

/// What ends a regime: a x + b x' = 0, with the depth x beyond the edge at a side and its rate x'.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exit {
    /// The regime after it.
    pub beyond: Regime,
    /// The side of the edge.
    pub side: Side,
    /// a.
    pub on_depth: f64,
    /// b.
    pub on_rate: f64,
    /// What the value may be below zero where rounding decides.
    pub slack: f64,
}

impl Exit {
    /// a x + b x' at the coordinates `q` and speeds `q_dot`.
    pub fn value(&self, band: &DeadBand, q: &[f64], q_dot: &[f64]) -> f64 {
        let [on_q, on_speed] = self.slopes(band);
        self.on_depth * band.depth_at_zero(self.side) + on_q.dot(q) + on_speed.dot(q_dot)
    }

    /// The slopes of that value along the coordinates and along the speeds (N each).
    pub fn slopes(&self, band: &DeadBand) -> [Vector; 2] {
        [self.on_depth, self.on_rate].map(|by| &band.normal * (self.side.sign() * by))
    }
}

impl DeadBand {
    /// The dead bands of a model that its effects ask for, free of contact.
    pub fn all(equations: &dyn Equations, model: &Model) -> Vec<DeadBand> {
        let band = |i| {
            let (band, at) = (equations.dead_band(i)?, model.laws.len() + VALUES * i);
            let (normal, half, errors) = (band.normal, band.half, band.errors);
            Some(DeadBand { at, normal, half, errors, offset: 0.0, regime: Free })
        };
        (0..model.dead_bands.len()).filter_map(band).collect()
    }

    /// The number of its regime.
    pub fn place(&self) -> usize {
        REGIMES.iter().position(|regime| *regime == self.regime).unwrap_or(0)
    }

    /// touch, edge, damp, clip in its regime.
    pub fn values(&self) -> [f64; VALUES] {
        let Contact(side, grip) = self.regime else { return [0.0; VALUES] };
        let damp = if grip == Touch { 1.0 } else { 0.0 };
        [1.0, side.sign() * self.half, damp, grip.clip()]
    }

    /// Puts its present values where they belong among the law values `k`.
    pub fn write(&self, k: &mut [f64]) {
        k[self.at..self.at + VALUES].copy_from_slice(&self.values());
    }

    /// Depth beyond an edge, negative within the play.
    pub fn depth(&self, side: Side, q: &[f64]) -> f64 {
        side.sign() * (self.normal.dot(q) + self.offset) - self.half
    }

    /// The same where all coordinates are zero.
    fn depth_at_zero(&self, side: Side) -> f64 {
        side.sign() * self.offset - self.half
    }

    /// Follows the transmission errors among the law values `k`.
    pub fn follow(&mut self, k: &[f64]) {
        self.offset = self.errors.iter().map(|&(law, unit)| unit * k[law]).sum();
    }

    /// Follows them over a step: where it has moved the edges, to the flank that is then in contact in `state`. Tells whether
    /// flanks have met.
    pub fn displace(&mut self, k: &[f64], q: &[f64]) -> bool {
        let (offset, regime) = (self.offset, self.regime);
        self.follow(k);
        if self.offset != offset {
            self.regime = self.met(q);
        }
        regime == Free && self.regime != Free
    }

    /// Its regime by where the deflection is; the grip is kept by a contact that lasts.
    pub fn met(&self, q: &[f64]) -> Regime {
        let beyond = [Side::Upper, Side::Lower].into_iter().find(|side| self.depth(*side, q) > 0.0);
        match (self.regime, beyond) {
            (_, None) => Free,
            (Contact(side, grip), Some(beyond)) if side == beyond => Contact(side, grip),
            (_, Some(side)) => Contact(side, Touch),
        }
    }

    /// Spring and damper of its contact where the law values are `k`: what K and C are more in contact than free, along n.
    pub fn elastic(&self, equations: &dyn Equations, k: &[f64]) -> Elastic {
        let with = |contact: bool| {
            let mut band = self.clone();
            band.regime = if contact { Contact(Side::Upper, Touch) } else { Free };
            let mut k = k.to_vec();
            band.write(&mut k);
            (equations.stiffness(&k), equations.damping(&k))
        };
        let ((k1, c1), (k0, c0)) = (with(true), with(false));
        let n = &self.normal * (1.0 / self.normal.dot(&self.normal));
        let along = |a: Matrix, b: Matrix| n.dot(&(&(a - b) * &n));
        Elastic { spring: along(k1, k0), damper: along(c1, c0) }
    }

    /// Its regime with the grip that the forces at `state` ask for; where they are equal, it keeps its grip.
    pub fn gripped(&self, elastic: Elastic, q: &[f64], q_dot: &[f64]) -> Regime {
        self.gripped_at(self.regime, elastic, q, q_dot)
    }

    /// The same of another regime than its own.
    pub fn gripped_at(&self, regime: Regime, Elastic { spring, damper }: Elastic, q: &[f64], q_dot: &[f64]) -> Regime {
        let Contact(side, grip) = regime else { return Free };
        if damper == 0.0 {
            return Contact(side, Touch);
        }
        let (spring, damper) = (spring * self.depth(side, q), damper * side.sign() * self.normal.dot(q_dot));
        Contact(
            side,
            match (damper - spring, damper + spring) {
                (more, _) if more > 0.0 => Hit,
                (_, left) if left < 0.0 => Loose,
                (more, _) if more == 0.0 && grip == Hit => Hit,
                (_, left) if left == 0.0 && grip == Loose => Loose,
                _ => Touch,
            },
        )
    }

    /// What can end its present regime. Each value is >= 0 until then.
    pub fn exits(&self, Elastic { spring, damper }: Elastic) -> SmallVec<[Exit; 2]> {
        let exit = |beyond, side, on_depth: f64, on_rate| {
            let slack = on_depth.abs() * EDGE_ROUNDING * (self.half + self.offset.abs());
            Exit { beyond, side, on_depth, on_rate, slack }
        };
        let enter = |side| {
            let grip = if damper > 0.0 { Hit } else { Touch };
            exit(Contact(side, grip), side, -1.0, 0.0)
        };
        match self.regime {
            Free => smallvec![enter(Side::Upper), enter(Side::Lower)],
            Contact(side, _) if damper == 0.0 => smallvec![exit(Free, side, 1.0, 0.0)],
            Contact(side, Touch) => smallvec![
                exit(Contact(side, Loose), side, spring, damper),
                exit(Contact(side, Hit), side, spring, -damper),
            ],
            Contact(side, Hit) => smallvec![exit(Contact(side, Touch), side, -spring, damper)],
            Contact(side, Loose) => {
                smallvec![exit(Free, side, 1.0, 0.0), exit(Contact(side, Touch), side, -spring, -damper)]
            }
        }
    }

    /// What the clipped damper takes where the deflection moves on from `q` by `dq` [J].
    pub fn clipped(&self, elastic: Elastic, q: &[f64], dq: &[f64]) -> f64 {
        let Contact(side, grip) = self.regime else { return 0.0 };
        let (x, dx) = (self.depth(side, q), side.sign() * self.normal.dot(dq));
        grip.clip() * elastic.spring * dx * (x + 0.5 * dx)
    }

    /// The power that the clipped damper takes [W].
    pub fn clipped_power(&self, elastic: Elastic, q: &[f64], q_dot: &[f64]) -> f64 {
        let Contact(side, grip) = self.regime else { return 0.0 };
        grip.clip() * elastic.spring * self.depth(side, q) * side.sign() * self.normal.dot(q_dot)
    }
}
