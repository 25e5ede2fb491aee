//! Mistakes in derived formulas, for the tests of the proofs: each must be refused.

use symbolica::atom::{Atom, AtomCore};

use crate::derivation::{Derivation, Formulas, derive_with};
use crate::expr::{Kind, number, set};
use crate::model::Model;
use crate::slip::Slip;

/// The formula with the mistake. It has twice its correct value unless another mistake is stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// The first entry of M.
    Mass,
    /// An entry of M beside the diagonal, but not the one that mirrors it.
    Mirror,
    /// M⁻¹.
    Inverse,
    /// The last row of F.
    Force,
    /// The last row of F: without its centrifugal and gyroscopic forces.
    Centrifugal,
    /// F: with gyroscopic forces that do no work.
    Gyroscopic,
    /// The force of clipped dampers: of the opposite sign.
    Clip,
    /// The gradient of the phase of the first law.
    Normal,
    /// M⁻¹n/G of the first law.
    Direction,
    /// dV at a step of the first law.
    Step,
    /// dV at a step of the last law: larger by one.
    LastStep,
    /// The slopes of the first deflection.
    Deflection,
}

/// Derives a model with a mistake in it.
///
/// # Errors
/// The proof that fails, or an error of the model itself.
pub fn derive_wrong(model: &Model, wrong: Wrong) -> Result<Derivation<'_>, Slip> {
    derive_with(model, |formulas| formulas.spoil(wrong))
}

impl Formulas {
    fn spoil(&mut self, wrong: Wrong) {
        let Formulas { symbols, motion, jumps } = self;
        let double = |e: &mut Atom| *e = &*e * number(2);
        match wrong {
            Wrong::Mass => double(&mut motion.mass[0][0]),
            Wrong::Mirror => motion.mass[0][1] = &motion.mass[0][1] + number(1),
            Wrong::Inverse => motion.mobility.iter_mut().flatten().flatten().for_each(double),
            Wrong::Force => motion.force.last_mut().into_iter().for_each(double),
            Wrong::Centrifugal => {
                motion.force.last_mut().zip(motion.applied.last()).into_iter().for_each(|(f, a)| *f = a.clone());
            }
            Wrong::Gyroscopic => {
                let [v, w] = [symbols.v[0], symbols.v[1]].map(Atom::var);
                motion.force[0] = &motion.force[0] + &v * &w;
                motion.force[1] = &motion.force[1] - &v * &v;
            }
            Wrong::Clip => motion.force.iter_mut().for_each(|force| *force = with_clips_turned(force)),
            Wrong::Normal => jumps[0].normal.iter_mut().for_each(double),
            Wrong::Direction => jumps[0].direction.iter_mut().flatten().for_each(double),
            Wrong::Step => double(&mut jumps[0].step),
            Wrong::LastStep => jumps.last_mut().into_iter().for_each(|jump| jump.step = &jump.step + number(1)),
            Wrong::Deflection => symbols.deflections[0].slopes.iter_mut().for_each(|(_, slope)| double(slope)),
        }
    }
}

fn with_clips_turned(force: &Atom) -> Atom {
    let clips = force
        .get_all_symbols(false)
        .into_iter()
        .filter(|s| crate::expr::kind_and_name(*s) == (Kind::Switched, "clip".into()));
    clips.fold(force.clone(), |force, clip| set(&force, clip, &-Atom::var(clip)))
}
