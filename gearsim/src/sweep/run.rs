//! Runs the points of a sweep on all cores. The result of a point depends on its number alone, not on the number of threads or on the
//! order in which points finish.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::record::Ended;
use super::row::{Row, Status};
use super::{Error, Sweep, record, spectra};
use crate::analysis::digits;
use crate::engine::Refusal;
use crate::output::remarks;
use crate::run::Outcome;
use crate::scene::Scene;

/// Shortest and longest interval between two writes of results [s]. In between, the interval is 1/50 of the time since the start of the
/// sweep. Rows that are not yet written are lost if the sweep is interrupted.
const KEEP_EVERY: (f64, f64) = (2.0, 60.0);
/// This many rows are written at once, before the interval is over.
const KEEP_ROWS: usize = 1 << 14;
/// Number of points that a thread takes at once if it runs them side by side: a few per SIMD lane.
const SIDE_BY_SIDE: usize = 32;
/// Interval at which rows are taken from the workers. Waking up for every row would cost as much as a short run.
const LOOK_EVERY: Duration = Duration::from_millis(2);

impl Sweep {
    /// Runs `points` on `threads` threads, in any order. From time to time it calls `keep` with the new rows, and `watch` with the
    /// number of finished points. `watch` ends the sweep by returning `Break`.
    ///
    /// # Errors
    /// An error of `keep`, which ends the sweep; and if the threads cannot be started.
    pub fn run(
        &self,
        points: &[usize],
        threads: NonZeroUsize,
        mut keep: impl FnMut(Vec<Row>) -> Result<(), Error>,
        mut watch: impl FnMut(usize) -> ControlFlow<()>,
    ) -> Result<(), Error> {
        let cannot_start = |error: &dyn std::fmt::Display| Error::Impossible {
            what: format!("cannot start {threads} threads: {error}"),
            help: "use fewer threads".into(),
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build();
        let pool = pool.map_err(|error| cannot_start(&error))?;
        let over = AtomicBool::new(false);
        let (send, receive) = mpsc::channel();
        std::thread::scope(|scope| {
            let over = &over;
            let work = move || {
                // Only a few points at once, because their run times differ by orders of magnitude.
                let few = if self.needs_only_ends() { SIDE_BY_SIDE } else { 1 };
                let each = points.par_chunks(few).with_max_len(1);
                pool.install(|| {
                    each.for_each_with(send, |send, points| {
                        if !over.load(Ordering::Relaxed) {
                            // Sending fails only after the sweep is over, when the row is not needed.
                            self.points(points).into_iter().for_each(|row| drop(send.send(row)));
                        }
                    });
                });
            };
            // `Scope::spawn` would panic where the system starts no further thread.
            let worker = std::thread::Builder::new().spawn_scoped(scope, work).map_err(|error| cannot_start(&error))?;
            let mut gather = || {
                let (begin, mut kept, mut rows, mut count) = (Instant::now(), Instant::now(), vec![], 0);
                loop {
                    // Ask before the rows are taken: if the worker has ended by now, these rows are the last ones.
                    let ended = worker.is_finished();
                    let before = rows.len();
                    rows.extend(receive.try_iter());
                    count += rows.len() - before;
                    let broken = watch(count).is_break();
                    let often = (0.02 * begin.elapsed().as_secs_f64()).clamp(KEEP_EVERY.0, KEEP_EVERY.1);
                    if ended || broken || rows.len() >= KEEP_ROWS || kept.elapsed().as_secs_f64() > often {
                        if !rows.is_empty() {
                            keep(std::mem::take(&mut rows))?;
                        }
                        kept = Instant::now();
                    }
                    if ended || broken {
                        return Ok(());
                    }
                    std::thread::sleep(LOOK_EVERY);
                }
            };
            let result = gather();
            over.store(true, Ordering::Relaxed);
            result
        })
    }

    /// Runs one point. An error at the point is noted in its row.
    pub fn point(&self, point: usize) -> Row {
        self.points(&[point]).remove(0)
    }

    /// Runs points, side by side if only their end states are recorded. Each row is bit-identical to that of the point run alone.
    fn points(&self, points: &[usize]) -> Vec<Row> {
        // A panic (a bug in gearsim) at one point must not lose the results of the others: then run each point alone.
        let run = |points: &[usize]| catch_unwind(AssertUnwindSafe(|| self.attempt(points))).ok();
        let failed = |point| self.refused(point, "gearsim failed at this point: this is a bug in gearsim".into());
        let alone = |&point: &usize| run(&[point]).and_then(|mut rows| rows.pop()).unwrap_or_else(|| failed(point));
        run(points).unwrap_or_else(|| points.iter().map(alone).collect())
    }

    fn attempt(&self, points: &[usize]) -> Vec<Row> {
        let scene = |&point: &usize| {
            let scene = self.template.scene(&self.plan.overrides(point), &[self.entry.model]);
            let mut scene = scene.map_err(|errors| self.refused(point, errors.brief()))?;
            self.record_only_what_is_needed(&mut scene);
            Ok((point, scene))
        };
        let (mut rows, mut wanted, mut scenes) = (vec![], vec![], vec![]);
        for scene in points.iter().map(scene) {
            match scene {
                Ok((point, scene)) => {
                    wanted.push(point);
                    scenes.push(scene);
                }
                Err(row) => rows.push(row),
            }
        }
        let mut outcomes = match self.needs_only_ends() {
            true => self.entry.ends(&scenes),
            false => scenes.iter().map(|scene| self.entry.run(scene, &mut |_| {})).collect(),
        };
        if self.groups.iter().any(|group| group.digits) {
            self.note_digits(&scenes, &mut outcomes);
        }
        rows.extend(wanted.into_iter().zip(&scenes).zip(outcomes).map(|((point, scene), outcome)| match outcome {
            Ok(outcome) => self.row(point, scene, &outcome),
            Err(refusal) => self.refused(point, refusal.to_string()),
        }));
        rows
    }

    /// Sets the number of digits left at the end of each run, from companion runs of which only the end states are computed.
    fn note_digits(&self, scenes: &[Scene], outcomes: &mut [Result<Outcome, Refusal>]) {
        let both =
            || scenes.iter().zip(&*outcomes).filter_map(|(scene, outcome)| Some((scene, outcome.as_ref().ok()?)));
        let companions: Vec<Scene> = both().map(|(scene, outcome)| digits::companion(scene, outcome, true)).collect();
        let ends = self.entry.ends(&companions);
        let noted: Vec<_> =
            both().zip(ends).map(|((scene, run), end)| Some(digits::left(scene, run, &end.ok()?))).collect();
        outcomes.iter_mut().flatten().zip(noted).for_each(|(outcome, noted)| outcome.digits = noted);
    }

    /// Whether a recorded quantity needs samples at the recording rate.
    fn needs_samples(&self) -> bool {
        self.spectra || self.groups.iter().any(|group| group.samples)
    }

    /// Whether the recorded quantities need only the start and the end of a run.
    fn needs_only_ends(&self) -> bool {
        !self.needs_samples() && !self.groups.iter().any(|group| group.limits)
    }

    /// Switches off samples and event rows that no recorded quantity needs. Samples take longer than the motion itself.
    fn record_only_what_is_needed(&self, scene: &mut Scene) {
        if !self.needs_samples() {
            scene.output.rate = 0.5 / scene.t_end;
        }
        scene.output.events = self.groups.iter().any(|group| group.limits);
        if !self.groups.iter().any(|group| group.outputs) {
            scene.output.record.clear();
        }
    }

    fn row(&self, point: usize, scene: &Scene, outcome: &Outcome) -> Row {
        let run = &outcome.trajectory;
        let ended = Ended { scene, entry: &self.entry, outcome, from: self.from, outputs: &self.outputs };
        let named = |i: usize| {
            let spectrum = spectra::of(run, i, self.from)?;
            let coordinate = run.model.coordinates[i].name.into();
            Some(spectra::NamedSpectrum { coordinate, frequency: spectrum.frequency, density: spectrum.density })
        };
        let (status, reason) = match (&outcome.stopped_by, &outcome.refuted) {
            (Some(stop), _) => (Status::Stopped, stop.to_string()),
            (None, Some(account)) => (Status::Refuted, account.to_string()),
            (None, None) => (Status::Done, String::new()),
        };
        // Without samples there are no spectra, and no outputs.
        let of_rows = if self.needs_samples() { remarks::of(scene, run, self.from) } else { vec![] };
        Row {
            point,
            status,
            reason,
            remarks: scene.warnings.iter().chain(&outcome.remarks).cloned().chain(of_rows).collect(),
            numbers: self.groups.iter().flat_map(|group| (group.values)(&ended)).collect(),
            spectra: match self.spectra {
                true => record::elastic(run.model).into_iter().filter_map(named).collect(),
                false => vec![],
            },
        }
    }

    fn refused(&self, point: usize, reason: String) -> Row {
        let numbers = vec![f64::NAN; self.columns().len()];
        Row { point, status: Status::Refused, reason, remarks: vec![], numbers, spectra: vec![] }
    }
}
