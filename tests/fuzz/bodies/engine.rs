//! A gear pair with any finite numbers: the run ends after a bounded number of steps, with finite states or a named error.

use std::f64::consts::TAU;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

use gearsim::__private::equations::{Derived, DerivedModel};
use gearsim::__private::models::GearPair;
use gearsim::__private::{Recorder, Simulation};
use gearsim::scene::Scene;

/// The scene in which every number is replaced.
const SCENE: &str = r#"
model = "gear_pair"
effects = []
parameters = { I1 = "1 kg*m^2", I2 = "1 kg*m^2", T0 = "1 N*m" }
laws.k.steps = [{ value = "1 N*m" }]
run.t_end = "1 s"
"#;
/// Sets of effects that do not contradict one another; damping and torques are added to them.
const SETS: [&str; 4] =
    ["\"stiffness_step\"", "\"stiffness_step\", \"rigid_kinematics\"", "\"stiffness_step\", \"frozen_phase\"", ""];
/// Number of events after which a run is stopped, if its time still advances. Some runs have more: a pressed phase may bounce a
/// million times before it is held, and without jumps a phase that is pushed against a step from both sides crosses it for ever.
const EVENTS: u32 = 200_000;
/// Largest mean number of steps of a search for the next event, over a run. A run has one search at its start and one after every event.
const STEPS: u64 = 1000;
/// Largest damping factor of a cell for which the mean number of steps must not exceed `STEPS`. Larger damping may stop the phase near
/// a boundary, or keep a contact force near zero, for a long time. One search then takes many steps: 91,018 at 1e12 times the critical
/// damping, 301,336 at 3e15 times. After a million steps a search stops with a named error.
const MOST_DAMPING: f64 = 1e3;
/// Largest mean number of steps of a search beyond that damping.
const STEPS_OVERDAMPED: u64 = 1_000_000;

/// The panic payload that stops a run after `EVENTS` events.
struct Enough;

/// Numbers read from bytes; the bytes are zero after the end.
struct Numbers<'a>(&'a [u8]);

impl Numbers<'_> {
    fn byte(&mut self) -> u8 {
        let (first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        *first
    }

    /// A fraction in (0, 1).
    fn part(&mut self) -> f64 {
        (f64::from(self.byte()) * 256.0 + f64::from(self.byte()) + 0.5) / 65536.0
    }

    /// A number that is not negative: mostly between 1e-4 and 1e4, often extreme, sometimes zero, 1, or next to 1.
    fn size(&mut self) -> f64 {
        let (kind, part) = (self.byte(), self.part());
        match kind % 16 {
            0 => 0.0,
            1 => 1.0,
            2 => 1.0 + f64::EPSILON * (part * 64.0).round(),
            3..=5 => 10f64.powf(616.0 * part - 308.0),
            6 | 7 => 10f64.powf(36.0 * part - 18.0),
            _ => 10f64.powf(8.0 * part - 4.0),
        }
    }

    fn signed(&mut self) -> f64 {
        if self.byte().is_multiple_of(2) { self.size() } else { -self.size() }
    }
}

/// Runs the gear pair that the bytes describe.
pub fn check(data: &[u8]) {
    let mut numbers = Numbers(data);
    let Some(scene) = scene(&mut numbers) else { return };
    let equations =
        DerivedModel::of::<GearPair>().equations(&scene).expect("the effects do not contradict one another");
    let Ok(mut simulation) = Simulation::new(&*equations, &scene) else { return };
    let lengths = simulation.turn_lengths();
    let mut recorder = Recorder::new(&scene, &*equations, lengths, simulation.now.state.clone(), &simulation.now.k);
    let (mut events, mut half) = (0, 0.0);
    let run = AssertUnwindSafe(|| {
        simulation.run(Some((&mut recorder, scene.output.rate, true)), &mut |t| {
            events += 1;
            half = if events == EVENTS / 2 { t } else { half };
            if events == EVENTS {
                assert!(t > half, "events without end: time does not advance");
                resume_unwind(Box::new(Enough));
            }
        })
    });
    let done = match catch_unwind(run) {
        Err(reason) if reason.is::<Enough>() => None,
        Err(reason) => resume_unwind(reason),
        Ok(done) => Some(done),
    };
    let counts = &simulation.now.counts;
    // The damping factor of the softest cell: `zeta` is that at the mean stiffness.
    let law = &scene.laws[0];
    let softest = law.steps.iter().map(|step| step.value).fold(f64::INFINITY, f64::min);
    let damping = scene.parameter("zeta").unwrap_or(0.0) * (law.mid() / softest).sqrt();
    let overdamped = scene.effects.names(scene.model).contains(&"damping") && damping > MOST_DAMPING;
    let most = if overdamped { STEPS_OVERDAMPED } else { STEPS };
    assert!(counts.cost.steps <= most * (u64::from(events) + 1), "{events} events, {counts:?}");
    let Some(done) = done else { return };
    if let Err(stop) = done {
        assert!(!stop.to_string().is_empty());
        return;
    }
    let state = &simulation.now.state;
    assert!(state.q.iter().chain(state.q_dot.iter()).all(|x| x.is_finite()), "{state:?}");
    // Energies are squares and may overflow where no state does, so only states and times must be finite.
    let rows = recorder.trajectory;
    let columns = rows.q.iter().chain(&rows.q_dot).chain([&rows.t]);
    assert!(columns.flatten().all(|x| x.is_finite()), "a state or a time in a row is not finite");
    assert!(rows.t.is_sorted(), "time runs backwards");
    // The loss over a short time is a difference of large terms. If it is below the rounding error of the energies, it may have
    // either sign.
    let largest = rows.kinetic.iter().chain(&rows.strain).fold(0.0, |m: f64, x| m.max(*x));
    let overflows = rows.kinetic.iter().chain(&rows.strain).any(|x| !x.is_finite()) || largest > 1e290;
    // A deflection is known to the rounding error of phi, which is large at the edge of a large play.
    let stiffest = scene.laws[0].steps.iter().fold(0.0, |m: f64, step| m.max(step.value));
    let farthest = rows.q[1].iter().fold(0.0, |m: f64, phi| m.max(phi.abs()));
    let rounding = stiffest * (f64::EPSILON * farthest).powi(2);
    assert!(
        overflows || simulation.now.dissipated >= -1e-12 * largest - rounding,
        "damping adds {:e} J",
        -simulation.now.dissipated
    );
}

/// The scene that the bytes describe, if it is valid.
fn scene(numbers: &mut Numbers<'_>) -> Option<Scene> {
    let kind = numbers.byte();
    let mut effects = vec![SETS[usize::from(kind % 4)]];
    effects
        .extend((kind & 4 != 0).then_some("\"damping\"").into_iter().chain((kind & 8 != 0).then_some("\"torques\"")));
    effects.retain(|effect| !effect.is_empty());
    let [i1, i2, zeta] = [0; 3].map(|_| numbers.size());
    let t0 = numbers.signed();
    let levels: Vec<f64> = (0..1 + kind / 16 % 4).map(|_| numbers.size()).collect();
    let widths: Vec<f64> = levels.iter().map(|_| numbers.part()).collect();
    let whole: f64 = widths.iter().sum();
    let step = |(level, width): (&f64, &f64)| {
        format!("{{ value = \"{level:e} N*m\", width = \"{:e} rad\" }}", width / whole * TAU)
    };
    let steps: Vec<String> = levels[1..].iter().zip(&widths[1..]).map(step).collect();
    let steps = [steps, vec![format!("{{ value = \"{:e} N*m\" }}", levels[0])]].concat().join(", ");
    let [theta, theta_dot, phi_dot] = [0; 3].map(|_| numbers.signed());
    let phi = numbers.byte().is_multiple_of(2).then(|| numbers.signed());

    // A run has at most a hundred pitches or a hundred periods, whichever ends first, so that its cost can be bounded. The rates
    // include a swing of phi by many pitches, which moves theta too, and the acceleration by a torque.
    let stiffest = levels.iter().fold(0.0, |m: f64, k| m.max(*k));
    let m2 = 0.5 * (24.0f64.powi(2) / i1 + 96.0f64.powi(2) / i2);
    let rate = (m2 * stiffest).sqrt().max((m2 * t0.abs()).sqrt());
    let speed = theta_dot.abs().max(phi_dot.abs()).max(rate * phi.unwrap_or(0.0).abs());
    let fastest = (speed / TAU).max(rate);
    let t_end = (100.0 * numbers.part() / fastest).min(1e300);
    // Read last, so that older cases of the corpus keep their meaning.
    let play = (numbers.byte() % 2 == 1).then(|| format!(", b = \"{:e} rad\"", numbers.size()));
    effects.extend(play.is_some().then_some("\"backlash\""));
    let play = play.unwrap_or_default();
    let phi = phi.map_or(String::new(), |phi| format!(", phi = \"{phi:e} rad\""));
    if t_end < 1e-300 {
        return None; // a scene refuses so short a run
    }
    let overrides = [
        format!("effects=[{}]", effects.join(", ")),
        format!(
            "parameters={{ I1 = \"{i1:e} kg*m^2\", I2 = \"{i2:e} kg*m^2\", zeta = {zeta:e}, T0 = \"{t0:e} N*m\"{play} }}"
        ),
        format!("laws.k.steps=[{steps}]"),
        format!(
            "start={{ theta = \"{theta:e} rad\", theta_dot = \"{theta_dot:e} rad/s\", phi_dot = \"{phi_dot:e} rad/s\"{phi} }}"
        ),
        format!("run.t_end={t_end:e} s"),
        format!("output.rate={:e} Hz", 20.0 / t_end),
    ];
    Scene::parse("fuzz", "fuzz.toml", SCENE, &overrides, &[&GearPair::MODEL]).ok()
}
