//! Fig. 4: spectra of phi with the three sets of equations, at 600 and at 4500 rpm.

use crate::measure::Bands;
use crate::paper::{self, Set, TORQUES};
use crate::text::{Part, fixed, number, table, which};

/// Damping factor of Fig. 4.
pub const ZETA: f64 = 0.05;
/// Length of the runs [s].
const WINDOW: f64 = 0.5;
/// Spectra agree if their band powers differ by no more than this [dB].
const AGREE: f64 = 1.0;

/// One speed and one torque.
struct Row {
    t0: f64,
    /// Mean speed at the end over the speed at the start, with the exact equations.
    speed: f64,
    reflections: u64,
    /// Largest absolute differences of band powers to the classical spectrum [dB].
    exact: f64,
    rigid: f64,
    /// Highest density beyond 2.6 wd over the classical one, with the exact equations.
    line: f64,
}

/// The spectra from one speed, for each T0.
pub struct Spectra {
    rpm: u32,
    rows: Vec<Row>,
}

/// N1 Omega1/wd at `rpm`.
pub fn mesh(rpm: u32) -> f64 {
    let pair = paper::pair(ZETA, paper::T0);
    pair.start(f64::from(rpm)).theta_dot / pair.wd()
}

impl Spectra {
    /// Runs all cases from `rpm`.
    pub fn run(rpm: u32) -> anyhow::Result<Spectra> {
        let rows = TORQUES.into_iter().map(|t0| row(rpm, t0)).collect::<Result<_, _>>()?;
        Ok(Spectra { rpm, rows })
    }

    fn when(&self, holds: impl Fn(&Row) -> bool) -> String {
        which(&TORQUES, |t0| self.rows.iter().any(|row| row.t0 == t0 && holds(row)))
    }

    /// The values of T0 at which the exact spectrum agrees with the classical one.
    pub fn exact_agrees(&self) -> String {
        self.when(|row| row.exact <= AGREE)
    }

    /// The values of T0 at which the exact spectrum differs from the classical one.
    pub fn exact_differs(&self) -> String {
        self.when(|row| row.exact > AGREE)
    }

    /// Highest density beyond 2.6 wd over the classical one, at the T0 of the scenes.
    pub fn line(&self) -> f64 {
        self.rows.iter().find(|row| row.t0 == paper::T0).map_or(f64::NAN, |row| row.line)
    }

    /// The values of T0 at which the rigid kinematic spectrum agrees with the classical one.
    pub fn rigid_agrees(&self) -> String {
        self.when(|row| row.rigid <= AGREE)
    }

    /// The values of T0 at which the exact and the rigid kinematic spectrum both agree with the classical one.
    pub fn all_agree(&self) -> String {
        self.when(|row| row.exact <= AGREE && row.rigid <= AGREE)
    }

    /// The values of T0 at which the gear is turned back at a step.
    pub fn reflects(&self) -> String {
        self.when(|row| row.reflections > 0)
    }

    /// The table.
    pub fn table(&self, name: &'static str) -> Part {
        let head = [
            "T0 [N m]",
            "J at the start",
            "mean speed after 0.5 s / at the start",
            "exact − classical [dB]",
            "rigid − classical [dB]",
            "highest density beyond 2.6 wd, exact / classical",
        ];
        let rows = self.rows.iter().map(|row| {
            vec![
                row.t0.to_string(),
                number(paper::strength(self.rpm, row.t0), 3),
                if row.reflections > 0 { "turned back".into() } else { fixed(row.speed, 3) },
                // The motion after a reflection is more sensitive to rounding errors, so fewer digits are given.
                fixed(row.exact, if row.reflections > 0 { 0 } else { 2 }),
                fixed(row.rigid, 2),
                number(row.line, if row.reflections > 0 { 1 } else { 3 }),
            ]
        });
        (name, table(&head, &rows.collect::<Vec<_>>()))
    }
}

fn row(rpm: u32, t0: f64) -> anyhow::Result<Row> {
    let run = |set| paper::spectrum(set, rpm, ZETA, t0, WINDOW);
    let (exact, rigid, classical) = (run(Set::Exact)?, run(Set::Rigid)?, run(Set::Classical)?);
    let pair = paper::pair(ZETA, t0);
    let bands = [&exact, &rigid, &classical].map(|o| Bands::of(&o.trajectory.q[1], paper::RATE, WINDOW, pair.wd()));
    let [of_exact, of_rigid, of_classical] = bands;
    let (of_exact, of_rigid, of_classical) = (of_exact?, of_rigid?, of_classical?);
    // Bands of whole mesh orders, at least 0.4 wd wide.
    let orders = (0.4 / mesh(rpm)).ceil() as usize;
    Ok(Row {
        t0,
        speed: paper::mean_speed(&exact) / pair.start(f64::from(rpm)).theta_dot,
        reflections: exact.counts.reflections,
        exact: of_exact.difference(&of_classical, mesh(rpm), orders),
        rigid: of_rigid.difference(&of_classical, mesh(rpm), orders),
        line: of_exact.peaks((2.6, 5.0), &of_classical),
    })
}
