//! The search for the peak at 3.2 wd: a scan over T0, damping factors, both forms of damping, and window lengths.

use crate::measure::{Bands, PEAK as NEAR};
use crate::paper::{self, RATE, Set, TORQUES};
use crate::printed;
use crate::text::{Part, fixed, number, table};

/// The paper's damping factors, and half of the smaller one: D = C phi'^2 and D = C phi'^2/2 differ by a factor of two in zeta.
const ZETAS: [f64; 3] = [0.025, 0.05, 0.1];
/// Window lengths, from the start of the run [s].
const WINDOWS: [f64; 6] = [0.02, 0.05, 0.1, 0.2, 0.5, 1.0];
/// Forms of damping: Rayleigh damping, and as printed.
const FORMS: [&str; 2] = ["Rayleigh", "in (2) only"];
/// A band with this many times the power of its neighbours counts as a peak.
const PEAK: f64 = 3.0;
/// The ratio of amplitudes that the paper reports.
const REPORTED: f64 = 400.0;

/// One run and one window.
struct Row {
    zeta: f64,
    form: &'static str,
    window: f64,
    t0: f64,
    /// Whether theta' is negative somewhere in the window.
    turned: bool,
    /// Frequency of the highest density near 3.2 wd [wd].
    highest: f64,
    /// Power in the band of the peak over that in the bands beside it.
    height: f64,
    /// Power and highest density in the band of the peak, over the classical ones.
    power: f64,
    line: f64,
    /// Largest ratio of the densities at the same frequency to the classical ones.
    at_one: f64,
}

/// The rows of all runs and windows.
pub struct Scan(Vec<Row>);

impl Scan {
    /// Runs all cases.
    pub fn run() -> anyhow::Result<Scan> {
        let mut rows = vec![];
        for zeta in ZETAS {
            for t0 in TORQUES {
                let longest = WINDOWS[WINDOWS.len() - 1];
                let pair = paper::pair(zeta, t0);
                let exact = paper::spectrum(Set::Exact, 600, zeta, t0, longest)?;
                let classical = paper::spectrum(Set::Classical, 600, zeta, t0, longest)?;
                let as_printed = printed::run(&pair, 600.0, longest, RATE);
                let forms = [
                    (&exact.trajectory.q[1], paper::turned(&exact.trajectory.q_dot[0])),
                    (&as_printed.phi, paper::turned(&as_printed.theta_dot)),
                ];
                for window in WINDOWS {
                    let reference = Bands::of(&classical.trajectory.q[1], RATE, window, pair.wd())?;
                    for (form, (phi, turned)) in FORMS.into_iter().zip(forms) {
                        let bands = Bands::of(phi, RATE, window, pair.wd())?;
                        let (highest, height) = (bands.highest(), bands.height());
                        let (power, line) = (bands.ratio(&reference), bands.peaks(NEAR, &reference));
                        let turned = turned < window;
                        let at_one = bands.ratio_at_one_frequency(&reference);
                        rows.push(Row { zeta, form, window, t0, turned, highest, height, power, line, at_one });
                    }
                }
            }
        }
        Ok(Scan(rows))
    }

    /// The number of rows with a peak at 3.2 wd, the number of rows, and the largest height.
    pub fn peaks(&self) -> (usize, usize, f64) {
        let count = self.0.iter().filter(|row| row.height >= PEAK).count();
        (count, self.0.len(), self.0.iter().map(|row| row.height).fold(0.0, f64::max))
    }

    /// The largest ratio of powers to the classical spectrum: in rows that are not turned back, and in all rows.
    pub fn largest(&self) -> [f64; 2] {
        let of = |any: bool| self.0.iter().filter(|r| any || !r.turned).map(|r| r.power).fold(0.0, f64::max);
        [of(false), of(true)]
    }

    /// The table by T0, at the damping of Fig. 4 and one window; each cell holds Rayleigh damping, then damping as printed.
    pub fn by_torque(&self) -> Part {
        let head = [
            "T0 [N m]",
            "turned back",
            "a peak?",
            "highest density at [wd]",
            "height over the bands beside it",
            "power / classical",
            "highest density / classical",
        ];
        let of = |t0: f64, form| self.0.iter().find(move |r| (r.t0, r.form, r.zeta, r.window) == (t0, form, 0.05, 0.1));
        let rows = TORQUES.into_iter().filter_map(|t0| of(t0, FORMS[0]).zip(of(t0, FORMS[1]))).map(|(a, b)| {
            let both = |text: &dyn Fn(&Row) -> String| format!("{}; {}", text(a), text(b));
            let yes = |x: bool| if x { "yes".to_owned() } else { "no".into() };
            let ratio = |x: f64, row: &Row| number(x, if row.turned { 2 } else { 3 });
            vec![
                a.t0.to_string(),
                both(&|r| yes(r.turned)),
                both(&|r| yes(r.height >= PEAK)),
                both(&|r| fixed(r.highest, 2)),
                both(&|r| number(r.height, 2)),
                both(&|r| ratio(r.power, r)),
                both(&|r| ratio(r.line, r)),
            ]
        });
        ("scan", table(&head, &rows.collect::<Vec<_>>()))
    }

    /// The table of the largest values over T0, for each damping and window.
    pub fn by_window(&self) -> Part {
        let head = [
            "zeta",
            "damping",
            "window [s]",
            "peaks",
            "largest height (T0)",
            "largest power / classical (T0)",
            "the same, never turned back",
            "ratio at one frequency over 400 from T0 [N m]",
        ];
        let mut rows = vec![];
        for (zeta, form, window) in
            ZETAS.iter().flat_map(|z| FORMS.iter().flat_map(move |f| WINDOWS.iter().map(move |w| (*z, *f, *w))))
        {
            let chosen = || self.0.iter().filter(move |r| (r.zeta, r.form, r.window) == (zeta, form, window));
            let largest = |any: bool, of: fn(&Row) -> f64| {
                let row = chosen().filter(|r| any || !r.turned).max_by(|a, b| of(a).total_cmp(&of(b)));
                row.map_or("-".into(), |r| format!("{} ({})", number(of(r), 2), r.t0))
            };
            let over = chosen().find(|r| r.at_one > REPORTED).map_or("-".into(), |r| r.t0.to_string());
            rows.push(vec![
                zeta.to_string(),
                form.into(),
                window.to_string(),
                chosen().filter(|r| r.height >= PEAK).count().to_string(),
                largest(true, |r| r.height),
                largest(true, |r| r.power),
                largest(false, |r| r.power),
                over,
            ]);
        }
        ("scan largest", table(&head, &rows))
    }
}
