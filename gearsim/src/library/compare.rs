//! Several runs side by side: scenes, or one scene under several sets of equations.

use super::equation_sets;
use super::{Error, Results};
use crate::plot::{self, Figure};
use crate::scene::Scene;

/// Runs that are compared, each with its name.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Name in legends, and results.
    pub runs: Vec<(String, Results)>,
}

impl Scene {
    /// The scene with the exact equations, with those without jump terms (`rigid kinematic`), and with those whose stiffnesses step at the
    /// times of a steady rotation (`classical`), each with its name, as in `gearsim compare`. It does not matter which of them the scene
    /// names.
    ///
    /// # Errors
    /// If the model has no such effects, or no stiffness of the scene steps, so that all sets are the same.
    pub fn equation_sets(&self) -> Result<Vec<(&'static str, Scene)>, Error> {
        Ok(equation_sets::all(self)?.into_iter().map(|(set, scene)| (set.label, scene)).collect())
    }

    /// Runs of the scene with each of its [`Scene::equation_sets`].
    ///
    /// # Errors
    /// As [`Scene::equation_sets`], and those of the runs.
    pub fn compare(&self) -> Result<Comparison, Error> {
        Comparison::of(self.equation_sets()?, &mut |_| {})
    }
}

impl Comparison {
    /// Runs scenes, each with its name. `watch` is called during the runs with the time that the present run has reached \[s\].
    ///
    /// # Errors
    /// Those of the runs.
    pub fn of(
        scenes: impl IntoIterator<Item = (impl Into<String>, Scene)>,
        watch: &mut dyn FnMut(f64),
    ) -> Result<Comparison, Error> {
        let run = |(name, scene): (_, Scene)| Ok((Into::<String>::into(name), scene.run_watched(watch)?));
        Ok(Comparison { runs: scenes.into_iter().map(run).collect::<Result<_, Error>>()? })
    }

    /// Draws the curves of all runs over each other: `outputs`, `energy`, `spectrum`, ...
    ///
    /// # Errors
    /// If there is no such plot, or the runs have nothing to show in it.
    pub fn plot(&self, name: &str) -> Result<Figure, Error> {
        let runs: Vec<_> = self.runs.iter().map(|(label, run)| plot::Run { label, ..run.drawn() }).collect();
        Ok((plot::find(name)?.draw)(&runs)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sets differ by their effects. The text of each scene has these effects too.
    #[test]
    fn a_scene_is_compared_under_three_sets_of_equations() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/oh2005/energy_300rpm.toml");
        let scene = Scene::load(path).unwrap().with("run.t_end", "20 ms").unwrap();
        let compared = scene.compare().unwrap();
        let names: Vec<_> = compared.runs.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["exact", "rigid kinematic", "classical"]);
        for (_, run) in &compared.runs {
            let again = Scene::from_toml("again", &run.scene.to_toml().unwrap()).unwrap();
            assert_eq!(again.effects, run.scene.effects);
        }
        let figure = compared.plot("energy").unwrap();
        let labels: Vec<_> = figure.panels.iter().flat_map(|panel| &panel.series).map(|s| s.label.as_str()).collect();
        assert!(names.iter().all(|name| labels.iter().any(|label| label.contains(name))), "{labels:?}");
    }
}
