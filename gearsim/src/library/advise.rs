//! Which effects a scene needs: estimates, and runs with and without each.

mod json;

use std::cell::OnceCell;

use super::Error;
use crate::analysis::advise::groups::Groups;
use crate::analysis::advise::measures::coordinates;
use crate::analysis::advise::orbit::{Steady, Unknown};
use crate::analysis::advise::{self, Apart, Bands, Candidate, LIMITS, Measures, Way, expected, short_run};
use crate::analysis::pulling;
use crate::run::{Account, Outcome};
use crate::scene::Scene;

/// The result for a candidate.
pub struct Verdict {
    /// What is left out.
    pub candidate: Candidate,
    /// The estimated deviation from the scene.
    pub estimate: Estimate,
    /// The deviation between the two full runs, or why the candidate cannot be run.
    pub truth: Result<Apart, String>,
    /// Processor time of the run without the effect, over that of the scene.
    pub time: f64,
}

/// The estimated deviation of a candidate from the scene, without full runs of both.
pub enum Estimate {
    /// From the settled motion.
    Settled(Apart),
    /// From short runs.
    Short(Apart),
    /// Steps will reflect the motion. Only the full equations describe that.
    TurnedBack,
    /// There is no estimate, for this reason.
    None(String),
}

impl Estimate {
    /// The estimated deviation, if there is one.
    pub(crate) fn deviation(&self) -> Option<&Apart> {
        match self {
            Estimate::Settled(apart) | Estimate::Short(apart) => Some(apart),
            Estimate::TurnedBack | Estimate::None(_) => None,
        }
    }

    /// Why there is no deviation.
    pub(crate) fn why_not(&self) -> Option<&str> {
        match self {
            Estimate::Settled(_) | Estimate::Short(_) => None,
            Estimate::TurnedBack => Some("steps reflect the motion"),
            Estimate::None(why) => Some(why),
        }
    }
}

impl Verdict {
    /// The change of the computing time without the effect: `-30 %`.
    pub(crate) fn time_in_words(&self) -> String {
        if self.time.is_finite() { format!("{:+.0} %", 100.0 * (self.time - 1.0)) } else { "-".into() }
    }

    /// Whether the effect is negligible: by the estimate, and by the full runs; `None` where that is unknown.
    pub fn negligible(&self) -> (Option<bool>, Option<bool>) {
        let within = |apart: &Apart| apart.within(&LIMITS);
        let estimate = match &self.estimate {
            Estimate::Settled(apart) | Estimate::Short(apart) => Some(within(apart)),
            Estimate::TurnedBack => Some(false),
            Estimate::None(_) => None,
        };
        (estimate, self.truth.as_ref().ok().map(within))
    }
}

/// The results for a scene.
pub struct Advice {
    /// Its dimensionless groups, or why there are none.
    pub groups: Result<Groups, String>,
    /// Why there is no settled motion, so that the estimates come from short runs.
    pub no_orbit: Option<String>,
    /// The result for each candidate.
    pub verdicts: Vec<Verdict>,
    /// Processor time of the scene \[s\].
    pub seconds: f64,
    /// The frequency bands in which spectra are compared.
    pub bands: Bands,
    /// Why its run stopped early, if it did.
    pub stopped: Option<String>,
    /// The energy account of its run, if the account does not close.
    pub refuted: Option<Account>,
    /// Number of reflections in its run.
    pub reflections: u64,
    /// End of its run \[s\].
    pub t_end: f64,
}

impl Advice {
    /// Why the advice is not valid: the run of the scene stopped early, or its energy account does not close.
    pub(crate) fn wrong(&self) -> Option<String> {
        self.stopped.clone().or_else(|| self.refuted.map(|account| account.to_string()))
    }

    /// What each candidate leaves out, and whether that is negligible: by the estimate, and by the full runs.
    pub fn negligible(&self) -> Vec<(&str, Option<bool>, Option<bool>)> {
        let each = |v: &'_ Verdict| v.negligible();
        self.verdicts.iter().map(|v| (v.candidate.without.as_str(), each(v).0, each(v).1)).collect()
    }

    /// The relative deviation of the speed of candidate `i`: by the settled motion, and by the full runs. `None` if one of them is missing.
    pub fn speeds(&self, i: usize) -> Option<(f64, f64)> {
        match (&self.verdicts[i].estimate, &self.verdicts[i].truth) {
            (Estimate::Settled(estimate), Ok(truth)) => Some((estimate.speed, truth.speed)),
            _ => None,
        }
    }
}

impl Scene {
    /// Which effects the scene needs: the deviation without each is estimated, then measured by runs with and without it. Effects that
    /// drop terms are removed from the scene first. To add one of them is also a candidate.
    ///
    /// # Errors
    /// If the scene has no effects, or cannot be run.
    pub fn advise(&self) -> Result<Advice, Error> {
        self.advise_watched(&|_| {})
    }

    /// As [`Scene::advise`]; each of its runs calls `watch` with the time reached \[s\].
    ///
    /// # Errors
    /// As [`Scene::advise`].
    pub fn advise_watched(&self, watch: &dyn Fn(f64)) -> Result<Advice, Error> {
        of(&advise::base(self), watch)
    }
}

/// The advice on `base`, a scene without effects that drop terms.
fn of(base: &Scene, watch: &dyn Fn(f64)) -> Result<Advice, Error> {
    let mut candidates = advise::candidates(base);
    if candidates.is_empty() {
        let what = format!("scene {} has no effects: there is nothing to leave out", base.name);
        return Err(Error::impossible(what, "add effects to its list `effects`"));
    }
    let (outcome, seconds) = timed(base, watch)?;
    candidates.extend(advise::with_play(base, &pulling::of(base, &outcome.trajectory, 0.0)));
    let system = base.entry()?.system(base).map_err(|refusal| refusal.to_string());
    let groups = system.as_ref().map_err(Clone::clone);
    let groups = groups.and_then(|system| Groups::of(base, system).map_err(|e| e.to_string()));
    let steady = match &system {
        Ok(system) => Steady::of(base, system),
        Err(_) => Err(Unknown::Rigid),
    };
    let bands = bands(base, &outcome, groups.as_ref().ok());
    let no_orbit = match (&system, &steady) {
        (Err(why), _) => Some(why.clone()),
        (_, Err(why)) => Some(why.to_string()),
        _ => None,
    };
    let context = Context {
        base,
        here: Measures::of(&outcome, base, &bands),
        mesh: groups.as_ref().map_or(0.0, Groups::mesh),
        expected: steady.as_ref().ok().and_then(|s| expected(base, s, &bands, None).ok()),
        steady: steady.ok(),
        short: OnceCell::new(),
        bands: &bands,
        seconds,
        watch,
    };
    let verdicts = candidates.into_iter().map(|candidate| context.verdict(candidate)).collect::<Result<_, _>>()?;
    Ok(Advice {
        groups,
        no_orbit,
        verdicts,
        seconds,
        stopped: outcome.stopped_by.as_ref().map(ToString::to_string),
        refuted: outcome.refuted,
        reflections: outcome.counts.reflections,
        t_end: base.t_end,
        bands,
    })
}

/// The scene that candidates are compared with.
struct Context<'a> {
    base: &'a Scene,
    here: Measures,
    mesh: f64,
    expected: Option<advise::expect::Expected>,
    steady: Option<Steady<'a>>,
    /// The measures of a short run of the scene. The run is made when an estimate first needs it.
    short: OnceCell<Result<Measures, String>>,
    bands: &'a Bands,
    seconds: f64,
    watch: &'a dyn Fn(f64),
}

impl Context<'_> {
    fn verdict(&self, candidate: Candidate) -> Result<Verdict, Error> {
        let estimate = self.estimate(&candidate)?;
        let (truth, time) = match timed(&candidate.scene, self.watch) {
            Ok((outcome, seconds)) => {
                let there = Measures::of(&outcome, self.base, self.bands);
                (Ok(self.here.apart(&there, &self.units())), seconds / self.seconds)
            }
            Err(Error::Refused { refusal, .. }) => (Err(refusal.to_string()), f64::NAN),
            Err(other) => return Err(other),
        };
        Ok(Verdict { candidate, estimate, truth, time })
    }

    fn estimate(&self, candidate: &Candidate) -> Result<Estimate, Error> {
        if let (Some(steady), Some(here), true) = (&self.steady, &self.expected, candidate.way != Way::Run) {
            let there = expected(self.base, steady, self.bands, Some(candidate.way));
            return Ok(match there {
                _ if here.turned_back => Estimate::TurnedBack,
                Ok(there) => Estimate::Settled(here.measures.apart(&there.measures, &self.units())),
                Err(why) => Estimate::None(why.to_string()),
            });
        }
        let short = short_run(self.base, self.mesh);
        let here = match self.short.get() {
            Some(here) => here,
            None => {
                let here = self.run_until(short, self.base)?;
                self.short.get_or_init(|| here)
            }
        };
        let there = self.run_until(short, &candidate.scene)?;
        Ok(match (here, there) {
            (Ok(here), Ok(there)) => Estimate::Short(here.apart(&there, &self.units()).over(short, self.base.t_end)),
            (Err(refusal), _) => Estimate::None(refusal.clone()),
            (_, Err(refusal)) => Estimate::None(refusal),
        })
    }

    /// What a scene records until `t_end` [s], or why it cannot be run.
    fn run_until(&self, t_end: f64, scene: &Scene) -> Result<Result<Measures, String>, Error> {
        let shortened = Scene { t_end, ..scene.clone() };
        match shortened.run_alone(&mut |t| (self.watch)(t)) {
            Ok(results) => Ok(Ok(Measures::of(&results.outcome, self.base, self.bands))),
            Err(Error::Refused { refusal, .. }) => Ok(Err(refusal.to_string())),
            Err(other) => Err(other),
        }
    }

    /// SI units of the elastic coordinates.
    fn units(&self) -> Vec<&'static str> {
        let model = self.base.model;
        coordinates(self.base).0.into_iter().map(|i| model.coordinates[i].unit).collect()
    }
}

/// Frequency bands of whole mesh orders. They end at four times the lowest natural frequency or above the highest one, whichever is
/// more, but at most at 0.4 of the sampling rate.
fn bands(base: &Scene, outcome: &Outcome, groups: Option<&Groups>) -> Bands {
    let limit = 0.4 * base.output.rate;
    let natural: Vec<f64> = groups.map_or(vec![], |g| g.modes.iter().map(|m| m.0).filter(|f| *f > 0.0).collect());
    let low = natural.first().copied().or(outcome.reference_frequency.map(|w| w / std::f64::consts::TAU));
    let low = low.unwrap_or(limit / 4.0);
    let high = natural.last().copied().unwrap_or(low);
    let mesh = groups.map_or(0.0, Groups::mesh);
    let mesh = if mesh > 0.0 { mesh } else { low };
    Bands::of(mesh, low, limit.min((4.0 * low).max(1.2 * high)))
}

/// Runs shorter than this [s] are timed three times, and the smallest time counts.
const QUICK: f64 = 0.2;

/// Runs a scene; the outcome, and its processor time [s].
pub(crate) fn timed(scene: &Scene, watch: &dyn Fn(f64)) -> Result<(Outcome, f64), Error> {
    let run = || scene.run_alone(&mut |t| watch(t));
    let outcome = run()?.outcome;
    let mut seconds = outcome.cpu_seconds;
    if seconds < QUICK {
        for _ in 0..2 {
            seconds = seconds.min(run()?.outcome.cpu_seconds);
        }
    }
    Ok((outcome, seconds))
}
