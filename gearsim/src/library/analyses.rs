//! Analyses of a scene's equations, without a run.

use super::Error;
use crate::analysis::floquet::{Floquet, FloquetError};
use crate::analysis::modes::{self, CellModes, Parts};
use crate::engine::Refusal;
use crate::scene::Scene;

impl Scene {
    /// Natural frequencies, damping, mode shapes and shares of energy of the cell of the mid stiffnesses, (max + min)/2 of each law.
    /// Nonlinear terms are linearised about the equilibrium, or about the steady motion at the speeds of the start. If inertias change
    /// along the motion, they are linearised about the position of the start.
    ///
    /// # Errors
    /// If a mass matrix is not positive definite, or there is no equilibrium.
    pub fn modes(&self) -> Result<CellModes, Error> {
        let levels = self.mid_stiffnesses();
        self.modes_at(&levels)
    }

    /// As [`Scene::modes`], for the cell with the stiffnesses `levels` \[SI\], in the order of the model's laws.
    ///
    /// # Errors
    /// As [`Scene::modes`].
    pub fn modes_at(&self, levels: &[f64]) -> Result<CellModes, Error> {
        self.modes_watched(levels, &|| {})
    }

    /// As [`Scene::modes_at`]. `watch` is called many times during the analysis, and can end it by unwinding.
    ///
    /// # Errors
    /// As [`Scene::modes`].
    pub fn modes_watched(&self, levels: &[f64], watch: &dyn Fn()) -> Result<CellModes, Error> {
        let entry = self.entry()?;
        let laws = self.stiffnesses().count();
        if levels.len() != laws {
            let what = format!("{} stiffnesses are given, but the scene has {laws}", levels.len());
            return Err(Error::impossible(what, "give one number for each stiffness of the model"));
        }
        let system = entry.about_steady_motion(self).map_err(|refusal| self.refused(refusal))?;
        let parts = Parts::of(self, entry, &system, watch).map_err(|refusal| self.refused(refusal))?;
        modes::of(&system, levels, &parts, watch).map_err(|refusal| self.refused(refusal))
    }

    /// Stability of the steady rotation at the speeds of the start, by Floquet multipliers. If inertias change along the motion: stability
    /// of the motion that repeats after a turn.
    ///
    /// # Errors
    /// If a cell has no modes, the stiffnesses have no common period, no motion repeats, nothing vibrates, or the multipliers overflow.
    pub fn floquet(&self) -> Result<Floquet, Error> {
        self.floquet_watched(&|| {})
    }

    /// As [`Scene::floquet`]. `watch` is called many times during the analysis, and can end it by unwinding.
    ///
    /// # Errors
    /// As [`Scene::floquet`].
    pub fn floquet_watched(&self, watch: &dyn Fn()) -> Result<Floquet, Error> {
        let system = self.entry()?.about_steady_motion(self).map_err(|refusal| self.refused(refusal))?;
        Floquet::of(self, &system, watch).map_err(|error| match error {
            FloquetError::Refused(refusal) => self.refused(refusal),
            cause => Error::Floquet { scene: self.name.clone(), cause },
        })
    }

    /// Accelerations at a state [SI/s^2], in the order of the coordinates: to check a model against equations written by hand. `laws` are
    /// the values of the model's laws \[SI\]; laws that are left out are 0. Every switch is as without its effect: every play is closed.
    ///
    /// # Errors
    /// If the effects of the scene contradict one another, or a length does not match the model.
    pub fn acceleration(&self, q: &[f64], q_dot: &[f64], laws: &[f64]) -> Result<Vec<f64>, Error> {
        let (n, most) = (self.model.coordinates.len(), self.model.laws.len());
        if q.len() != n || q_dot.len() != n || laws.len() > most {
            let what = format!("{} coordinates, {} speeds, {} laws are given", q.len(), q_dot.len(), laws.len());
            return Err(Error::impossible(what, format!("the model has {n} coordinates and {most} laws")));
        }
        let equations = self.entry()?.equations(self).map_err(|refusal| self.refused(refusal))?;
        let laws = self.model.in_contact(laws.iter().copied());
        Ok(equations.acceleration(q, q_dot, &laws, &vec![0.0; most]).to_vec())
    }

    /// The error of a scene that cannot be simulated.
    pub(super) fn refused(&self, refusal: Refusal) -> Error {
        Error::Refused { scene: self.name.clone(), refusal }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

    use crate::Scene;

    /// A row of rotors on shafts with unequal dampers, which couple all modes.
    fn row(rotors: usize) -> Scene {
        let mut text = "model = \"train\"\neffects = [\"viscous_friction\"]\n".to_owned();
        for i in 0..rotors {
            text += &format!("[rotors.r{i}]\ninertia = \"{} kg*m^2\"\n", 0.01 + 0.001 * (i % 7) as f64);
        }
        for i in 1..rotors {
            let (k, c) = (10.0 + (i % 11) as f64, 1.0 + (i % 5) as f64);
            text += &format!("[shafts.s{i}]\nbetween = [\"r{}\", \"r{i}\"]\n", i - 1);
            text += &format!("stiffness = \"{k} kN*m/rad\"\ndamping = \"{c} N*m*s/rad\"\n");
        }
        Scene::from_toml("row", &text).unwrap()
    }

    /// The modes of many rotors. The eigenvalues of a large matrix are found by another method than those of a small one. Shares of
    /// energies add up to 1.
    #[test]
    fn many_rotors_have_coupled_modes() {
        let cell = row(40).modes().unwrap();
        assert!(cell.coupled && cell.modes.len() == 40);
        let first = cell.modes.iter().filter(|mode| mode.natural == 0.0).count();
        assert_eq!(first, 1);
        for mode in &cell.modes {
            assert!((mode.kinetic.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(mode.natural == 0.0 || (mode.springs.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }

    /// All parts of the analysis call `watch`, at least once for each parameter and each mode. The analysis ends when `watch` unwinds.
    #[test]
    fn modes_can_be_ended() {
        let scene = row(12);
        let calls = Cell::new(0);
        scene.modes_watched(&[], &|| calls.set(calls.get() + 1)).unwrap();
        let all = calls.get();
        assert!(all >= 12 + 11 + 2 * 12, "{all}");
        for most in [1, 20, all] {
            calls.set(0);
            let watch = || {
                calls.set(calls.get() + 1);
                if calls.get() == most {
                    resume_unwind(Box::new("ended"));
                }
            };
            assert!(catch_unwind(AssertUnwindSafe(|| scene.modes_watched(&[], &watch))).is_err());
            assert_eq!(calls.get(), most);
        }
    }
}
