//! Fig. 3: the energy U = T + V - W at 300 rpm, with the jump terms and without them.

use gearsim::run::Outcome;
use gearsim::trajectory::Moment;

use crate::paper::{self, Set};
use crate::text::{Part, fixed, number, table, which};

/// T0 of the table [N m].
const TORQUES: [f64; 10] = [1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 50.0, 100.0, 200.0, 500.0];
/// Rises of U up to this value count as rounding errors [J].
const ROUNDING: f64 = 1e-12;
/// Changes of U over a tooth pitch up to this fraction of U count as none.
const LEVEL: f64 = 1e-4;

/// The energy balance of a run.
pub struct Balance {
    /// T + V at the start [J].
    pub start: f64,
    /// Largest rise from one row to the next [J].
    pub largest_rise: f64,
    /// Sum of the changes of U where a tooth pair enters contact [J].
    pub entering: f64,
    /// Sum of the changes of U where a tooth pair leaves contact [J].
    pub leaving: f64,
    /// Energy lost to damping [J].
    pub dissipated: f64,
    /// Mean change of U over a tooth pitch, from entry to entry, without the first three [J]; NaN if the gear is reflected.
    pub a_cycle: f64,
}

impl Balance {
    /// The balance of a run that records events.
    pub fn of(outcome: &Outcome) -> Balance {
        let run = &outcome.trajectory;
        let (mut largest_rise, mut entering, mut leaving) = (0.0_f64, 0.0, 0.0);
        let mut entries = vec![];
        for i in 1..run.len() {
            let change = run.energy(i) - run.energy(i - 1);
            largest_rise = largest_rise.max(change);
            if run.moment[i] == Moment::After {
                if (run.q[0][i].rem_euclid(std::f64::consts::TAU) - 1.73).abs() < 1e-9 {
                    entering += change;
                    entries.push(run.energy(i));
                } else {
                    leaving += change;
                }
            }
        }
        let a_cycle = match entries.get(3..) {
            Some([first, .., last]) if outcome.counts.reflections == 0 => (last - first) / (entries.len() - 4) as f64,
            _ => f64::NAN,
        };
        let dissipated = run.dissipated[run.len() - 1];
        Balance { start: run.energy(0), largest_rise, entering, leaving, dissipated, a_cycle }
    }
}

/// The energy balances of Fig. 3 for each T0, with the exact and with the rigid kinematic equations.
pub struct Energies(Vec<(f64, [Balance; 2])>);

impl Energies {
    /// Runs all cases.
    pub fn run() -> anyhow::Result<Energies> {
        let balance = |set, t0| anyhow::Ok(Balance::of(&paper::energy(set, t0)?));
        let both = |t0| anyhow::Ok((t0, [balance(Set::Exact, t0)?, balance(Set::Rigid, t0)?]));
        Ok(Energies(TORQUES.into_iter().map(both).collect::<Result<_, _>>()?))
    }

    /// The balances at the T0 of the committed scenes.
    pub fn committed(&self) -> Option<&[Balance; 2]> {
        self.0.iter().find(|(t0, _)| *t0 == paper::T0).map(|(_, balances)| balances)
    }

    /// The values of T0 at which a statement about the two balances holds.
    fn when(&self, holds: impl Fn(&Balance, &Balance) -> bool) -> String {
        which(&TORQUES, |t0| self.0.iter().any(|(t, [exact, rigid])| *t == t0 && holds(exact, rigid)))
    }

    /// The claims of Fig. 3, and at which T0 each holds.
    pub fn claims(&self) -> Vec<Vec<String>> {
        let row = |claim: &str, t0: String, evidence: &str| vec![claim.into(), t0, evidence.into()];
        vec![
            row(
                "Fig. 3: with the jump terms U falls monotonically",
                self.when(|exact, _| exact.largest_rise < ROUNDING),
                "U never rises by more than 1e-12 J from one row to the next, limits at the steps included",
            ),
            row(
                "Fig. 3: without them, Eqs. (4), (5), U jumps up where a tooth pair enters",
                self.when(|_, rigid| rigid.entering > ROUNDING && rigid.leaving < 0.0),
                "and falls, by less, where one leaves: see the table below",
            ),
            row(
                "Fig. 3: so that there is no overall loss per cycle although damping is present",
                self.when(|_, rigid| rigid.a_cycle.abs() < LEVEL * rigid.start),
                "from one entry to the next U changes by less than 1e-4 of its value, because U depends on the state \
                 alone, and the motion with (4), (5) soon becomes periodic. With the exact equations it cannot become periodic",
            ),
        ]
    }

    /// The table of Fig. 3.
    pub fn table(&self) -> Part {
        let head = [
            "T0 [N m]",
            "U(0) [J]",
            "lost to damping, exact [J]",
            "change of U a cycle, exact [J]",
            "created where teeth enter, (4)/(5) [J]",
            "taken where they leave [J]",
            "lost to damping, (4)/(5) [J]",
            "change of U a cycle, (4)/(5) [J]",
        ];
        let rows = self.0.iter().map(|(t0, [exact, rigid])| {
            let level = |x: f64| if x.abs() < LEVEL * exact.start { fixed(x, 3) } else { number(x, 3) };
            let moving = |x: f64| if x.is_nan() { "turned back".into() } else { number(x, 3) };
            vec![
                t0.to_string(),
                number(exact.start, 4),
                number(exact.dissipated, 3),
                moving(exact.a_cycle),
                number(rigid.entering, 3),
                number(rigid.leaving, 3),
                number(rigid.dissipated, 3),
                level(rigid.a_cycle),
            ]
        });
        ("energy", table(&head, &rows.collect::<Vec<_>>()))
    }
}
