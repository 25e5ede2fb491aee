//! The measurements of a scene as tables and in words: time at equal error, and all points.

use super::WorkPrecision;
use super::ladder::Kind;
use super::measure::MeasuredFamily;
use super::reference::By;
use crate::tolerance::analysis::CHAOTIC;

/// The errors at which times are compared.
pub const TARGETS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// The time that a method needs for a given error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Price {
    /// Processor time \[s\].
    Seconds(f64),
    /// No setting is accurate enough.
    Never,
    /// No setting that was run is accurate enough, and finer ones were not run. The slowest took this long \[s\].
    Over(f64),
    /// The error is below that of the reference, so it cannot be measured.
    Unknown,
}

impl MeasuredFamily {
    /// Processor time for an error `target` along the path, interpolated between settings in the logarithms of error and time.
    /// `floor` is the error of the reference. Settings that failed or have other events than the reference are not used.
    pub fn price(&self, target: f64, floor: f64) -> Price {
        if target < floor {
            return Price::Unknown;
        }
        let usable = self.points.iter().filter(|point| point.right_events);
        let usable: Vec<(f64, f64)> =
            usable.filter_map(|point| Some((point.error()?.max(floor), point.seconds.0))).collect();
        // The cheapest setting that is accurate enough, or an interpolated one between a setting that is not and the next.
        let good = |&&(error, _): &&(f64, f64)| error <= target;
        let at = usable.iter().filter(good).map(|p| p.1);
        let between = usable.windows(2).filter_map(|pair| {
            let ((e0, t0), (e1, t1)) = (pair[0], pair[1]);
            let part = (e0 / target).ln() / (e0 / e1).ln();
            (e0 > target && e1 <= target).then(|| t0 * (t1 / t0).powf(part))
        });
        let cheapest = at.chain(between).fold(f64::INFINITY, f64::min);
        match (cheapest.is_finite(), self.points.iter().all(|point| point.tried)) {
            (true, _) => Price::Seconds(cheapest),
            (false, true) => Price::Never,
            (false, false) => Price::Over(self.points.iter().map(|point| point.seconds.0).fold(0.0, f64::max)),
        }
    }

    /// Number of settings that failed: they stopped early, or have other events than the reference.
    pub fn failures(&self) -> usize {
        self.points.iter().filter(|point| point.failed()).count()
    }
}

/// The main results in words.
pub fn words(measured: &WorkPrecision) -> String {
    let floor = measured.floor;
    let mut said = vec![];
    let methods = || measured.curves.iter().filter(|curve| curve.kind == Kind::Method);
    let single = |curve: &&MeasuredFamily| curve.points.len() == 1;
    if let By::Steps(_) = measured.reference {
        said.push("Cells are not linear here: there is no exact solution.".into());
    }
    if floor > CHAOTIC {
        let grown = "Before the end a rounding error grows to the size of the motion itself; then errors mean nothing:";
        said.push(format!("{grown} use a shorter run, with --set run.t_end, or the errors in energy."));
        return said.join(" ");
    }
    if let Some(point) = methods().find(single).and_then(|curve| curve.points.first()) {
        let error = point.error().map_or("nothing".into(), |e| format!("an error of {:.0e}", e.max(floor)));
        said.push(format!("Exact cells cost {} for {error}.", time(point.seconds.0)));
    }
    for target in [1e-6, 1e-9] {
        let others = methods().filter(|curve| !single(curve));
        let priced = others.filter_map(|curve| match curve.price(target, floor) {
            Price::Seconds(seconds) => Some((seconds, curve.label)),
            _ => None,
        });
        said.push(match priced.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((seconds, label)) => {
                format!("With time steps, an error of {target:e} costs at least {} ({label}).", time(seconds))
            }
            None => format!("No method with time steps reaches an error of {target:e}."),
        });
    }
    for curve in measured.curves.iter().filter(|curve| curve.kind == Kind::Equations) {
        if let Some((point, error)) = curve.points.first().and_then(|point| Some((point, point.error()?))) {
            let percent = 100.0 * error;
            let wrong = match percent {
                p if p < 0.1 => format!("{p:.0e} %"),
                p if p < 100.0 => format!("{p:.1} %"),
                p => format!("{:.1} times the motion itself", p / 100.0),
            };
            said.push(format!("The {} cost {} and are wrong by {wrong}.", curve.label, time(point.seconds.0)));
        }
    }
    for curve in methods().filter(|curve| curve.failures() > 0) {
        said.push(format!("{} of {} settings of {} fail.", curve.failures(), curve.points.len(), curve.label));
    }
    said.join(" ")
}

/// The table of times at equal error in Markdown, one line per method.
pub fn prices(measured: &WorkPrecision) -> String {
    let width = measured.curves.iter().map(|curve| curve.label.len()).max().unwrap_or(0);
    let line = |label: &str, entries: [String; 4], failures: &str| {
        let [a, b, c, d] = entries;
        format!("| {label:width$} | {a:>8} | {b:>8} | {c:>8} | {d:>8} | {failures:>8} |\n")
    };
    let mut text = line("time at error", TARGETS.map(|target| format!("{target:e}")), "failures");
    text += &format!("| {:-<width$} | -------: | -------: | -------: | -------: | -------: |\n", "");
    for curve in &measured.curves {
        let prices = TARGETS.map(|target| match curve.price(target, measured.floor) {
            Price::Seconds(seconds) => time(seconds),
            Price::Never => "never".into(),
            Price::Over(seconds) => format!("> {}", time(seconds)),
            Price::Unknown => "?".into(),
        });
        text += &line(curve.label, prices, &format!("{} of {}", curve.failures(), curve.points.len()));
    }
    text
}

/// The report in Markdown: the results in words, a table with one line per method, and a table with one line per point.
pub fn markdown(measured: &WorkPrecision) -> String {
    let mut text = format!(
        "# Error against processor time: {}\n\n![Error against processor time](work_precision.png)\n\n{}\n\n",
        measured.scene,
        words(measured)
    );
    let reference = match &measured.reference {
        By::Compensated => "exact cells in twice the digits".to_string(),
        By::Steps(why) => format!("dop853, since cells are not linear ({why}); its error is its distance from radau"),
    };
    text += &format!(
        "Errors are the largest along the path. The unit of each coordinate and speed is its size, that of a rotating coordinate is \
         one pitch. The run has {} events. The reference is {reference}. Its own error is {:.0e}; errors below this are not \
         resolved. Times are processor times of one core without recording, the minimum of several.\n\n",
        measured.events, measured.floor
    );
    let by_steps = matches!(measured.reference, By::Steps(_));
    if let Some((label, setting, error)) = nearest(measured).filter(|_| !by_steps) {
        text += &format!(
            "The nearest to it is {label} at {setting}, which shares no formula with it: its error is {error:.0e}.\n\n"
        );
    }
    text += &prices(measured);
    text += "\nA ? stands for errors below that of the reference.\n\n";
    text += "| method | setting | time, least | median | evaluations | steps | events | error at the end | along the path | \
             in event times \\[s\\] | energy unaccounted for | remarks |\n";
    text += &format!("|{}\n", " --- |".repeat(12));
    for (curve, point) in measured.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, point)))
    {
        let (least, median) = point.seconds;
        let errors = match &point.errors {
            Err(_) => "- | - | - | -".to_string(),
            Ok(e) => {
                let times = e.times.map_or("-".into(), |t| format!("{t:.1e}"));
                format!("{:.1e} | {:.1e} | {times} | {:.1e}", e.end, e.path, e.energy)
            }
        };
        let remark = match &point.errors {
            Err(why) if !point.tried => why.clone(),
            Err(why) => format!("failed: {why}"),
            Ok(e) if !point.right_events => format!("failed: {:+} events", e.events),
            Ok(_) => String::new(),
        };
        text += &format!(
            "| {} | {} | {} | {} | {} | {} | {} | {errors} | {} |\n",
            curve.label,
            point.setting,
            time(least),
            time(median),
            point.evaluations,
            point.steps,
            point.events,
            remark.replace('|', "\\|")
        );
    }
    text
}

/// The method and setting with time steps that is nearest to the reference, and its error.
fn nearest(measured: &WorkPrecision) -> Option<(&'static str, &str, f64)> {
    let ladders = measured.curves.iter().filter(|curve| curve.kind == Kind::Method && curve.points.len() > 1);
    let points = ladders.flat_map(|curve| curve.points.iter().map(move |point| (curve.label, point)));
    let errors = points.filter_map(|(label, point)| Some((label, &point.setting[..], point.error()?)));
    errors.min_by(|a, b| a.2.total_cmp(&b.2))
}

/// All points as CSV, with all digits of times and errors.
pub fn csv(measured: &WorkPrecision) -> String {
    let mut text = String::from(
        "method,setting,cpu_min_s,cpu_median_s,evaluations,steps,events,error_end,error_path,error_times_s,event_count_error,energy_error,failure\n",
    );
    for (curve, point) in measured.curves.iter().flat_map(|curve| curve.points.iter().map(move |point| (curve, point)))
    {
        let (least, median) = point.seconds;
        let errors = match &point.errors {
            Err(_) => ",,,,".to_string(),
            Ok(e) => {
                let times = e.times.map_or(String::new(), |t| format!("{t:e}"));
                format!("{:e},{:e},{times},{},{:e}", e.end, e.path, e.events, e.energy)
            }
        };
        let why = match &point.errors {
            Err(why) => why.clone(),
            Ok(_) if !point.right_events => "other events than the reference".into(),
            Ok(_) => String::new(),
        };
        text += &format!(
            "\"{}\",\"{}\",{least:e},{median:e},{},{},{},{errors},\"{}\"\n",
            curve.label,
            point.setting,
            point.evaluations,
            point.steps,
            point.events,
            why.replace('"', "'")
        );
    }
    text
}

/// A time [s] in µs, ms or s.
fn time(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        s if s < 1e-3 => (1e6, "µs"),
        s if s < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    let x = seconds * scale;
    if x.is_nan() { "-".into() } else { format!("{x:.*} {unit}", if x < 9.95 { 1 } else { 0 }) }
}
