//! Quantities that outputs use and only the engine knows: the reactions of held deflections and the powers of the external torques.

use smallvec::SmallVec;

/// Reactions and powers. A value that was not requested is not computed; it is returned as zero.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Known {
    /// For each switch of the model, the force along the deflection that its hold resists [N or N m].
    pub reactions: SmallVec<[f64; 4]>,
    /// For each external torque of the model, up to the last one that the scene has: its power \[W\]; zero for a torque that the scene does
    /// not have.
    pub powers: SmallVec<[f64; 4]>,
}

impl Known {
    /// The reaction of the deflection of a switch [N or N m]; zero where it is not held.
    #[inline]
    pub fn reaction(&self, switch: usize) -> f64 {
        self.reactions.get(switch).copied().unwrap_or(0.0)
    }

    /// The power of an external torque \[W\].
    #[inline]
    pub fn power(&self, torque: usize) -> f64 {
        self.powers.get(torque).copied().unwrap_or(0.0)
    }
}
