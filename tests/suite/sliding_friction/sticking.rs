//! Flanks that stick (`flank_stiction`), against closed forms: rest under load, the breakaway torque, coming to rest and turning back, the
//! energy account, two methods, and the limit of the smoothed law as its mixing speed goes to zero.
//!
//! Two equal gears, with psi = theta1 + theta2 and s = r (theta1 - theta2), have the inertias I/2 along psi and I/(2 r²) along s.

use gearsim::Results;
use gearsim::Scene;

use crate::{common, run, state, stuck, unaccounted};

const INERTIA: f64 = 5e-4;
const RADIUS: f64 = 0.056;
const MU: f64 = 0.1;
const ARM: f64 = 4e-3;
const DRIVE: f64 = 1.0;
const TEETH: f64 = 40.0;

/// A pair of equal gears between a drive and a load.
struct Pair<'a> {
    sticks: bool,
    /// 1 if a single pair of teeth touches beyond the pitch point, -1 if before it, 0 for two pairs at the same distance from it.
    side: f64,
    drive: &'a str,
    load: &'a str,
    /// Speed of each gear \[rad/s\].
    speed: f64,
    t_end: f64,
    method: &'a str,
    /// The phase at the start \[rad\].
    phase: &'a str,
    parameters: &'a str,
    /// The stiffness of the mesh over its phase.
    stiffness: &'a str,
}

const REST: Pair<'static> = Pair {
    sticks: true,
    side: 0.0,
    drive: "\"1 N*m\"",
    load: "\"1 N*m\"",
    speed: 0.0,
    t_end: 1.0,
    method: "dop853",
    phase: "3",
    parameters: "",
    stiffness: "\"2 MN/m\"",
};

impl Pair<'_> {
    fn run(&self) -> Results {
        let Pair { sticks, side, drive, load, speed, t_end, method, phase, parameters, stiffness } = self;
        let sticks = if *sticks { ", \"flank_stiction\"" } else { "" };
        let text = format!(
            "model = \"train\"\neffects = [\"stiffness_step\", \"sliding_friction\", \"torques\", \"viscous_friction\"{sticks}]\n\
             [rotors]\n1 = \"{INERTIA} kg*m^2\"\n2 = \"{INERTIA} kg*m^2\"\n\
             [meshes.12]\nbetween = [\"1\", \"2\"]\nteeth = [{TEETH}, {TEETH}]\nbase_radius = \"{RADIUS} m\"\nstiffness = {stiffness}\n\
             friction = {MU}\ndamping = \"60 N*s/m\"\n\
             [laws.side12]\nsteps = [{{ value = {side} }}]\n[laws.arm12]\nsteps = [{{ value = \"{ARM} m\" }}]\n\
             [drives.motor]\nrotor = \"1\"\ntorque = {drive}\n[loads.load]\nrotor = \"2\"\ntorque = {load}\n\
             [parameters]\n{parameters}\n[start]\nphase12 = \"{phase} rad\"\nspeed = \"{speed} rad/s\"\n\
             [run]\nt_end = \"{t_end} s\"\nmethod = \"{method}\"\ntolerance = 1e-11\n[output]\nrate = \"1 kHz\"\n",
        );
        let scene = Scene::from_toml("sticking", &text).unwrap_or_else(|e| panic!("{e}"));
        scene.run().unwrap_or_else(|e| panic!("{e}"))
    }
}

fn newton_metres(torque: f64) -> String {
    format!("\"{torque:?} N*m\"")
}

/// psi at each row \[rad\].
fn psi(run: &Results) -> Vec<f64> {
    run.trajectory().q[0].iter().map(|theta| 2.0 * (theta - 3.0) / TEETH).collect()
}

/// psi' at the end \[rad/s\].
fn final_speed(run: &Results) -> f64 {
    2.0 * run.trajectory().q_dot[0].last().unwrap() / TEETH
}

/// The largest residual of the energy account, relative to `energy` \[J\].
fn residual(run: &Results, energy: f64) -> f64 {
    run.trajectory().residual.iter().fold(0.0f64, |most, r| most.max(r.abs())) / energy
}

/// The torque \[N m\] by which the load exceeds the drive when the flanks break away and the gears turn back. Along psi
/// excess/2 = arm mu F; along the line of action (2 T + excess)/(2 r) = F - side tan(alpha) mu F.
fn breakaway(mu: f64, side: f64) -> f64 {
    let ratio = mu * ARM / (2.0 * RADIUS * (1.0 - side * mu * 20f64.to_radians().tan()));
    2.0 * DRIVE * ratio / (0.5 - ratio)
}

#[test]
fn gears_at_rest_under_load_do_not_creep() {
    let load = newton_metres(DRIVE + 0.95 * breakaway(MU, 0.0));
    let run = Pair { load: &load, ..REST }.run();
    let worst = psi(&run).iter().fold(0.0f64, |most, psi| most.max(psi.abs()));
    println!("psi within {worst:e} rad");
    assert!(worst < 1e-14, "{worst:e}");
    assert_eq!(run.events().count(), 0);
}

/// A slowly rising load releases the flanks at the torque of statics: on drive and coast flanks, for a tooth pair before and beyond the
/// pitch point, and with static friction above sliding friction. After the release the flanks slide and do not stick again.
#[test]
fn the_breakaway_torque_is_that_of_statics() {
    for (side, rise, flank) in
        [(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (-1.0, 0.0, 1.0), (0.0, 0.3, 1.0), (1.0, 0.0, -1.0), (-1.0, 0.0, -1.0)]
    {
        // In the mirror image of a pair that coasts, a place beyond the pitch point is one before it.
        let expected = breakaway(MU * (1.0 + rise), flank * side);
        let (from, to) = (flank * DRIVE, flank * (DRIVE + 2.0 * expected));
        let load = format!("{{ ramp = {{ from = \"{from} N*m\", to = \"{to:?} N*m\", duration = \"1 s\" }} }}");
        let (drive, parameters) = (newton_metres(from), format!("mu_rise12 = {rise}"));
        let run = Pair { side, drive: &drive, load: &load, parameters: &parameters, t_end: 0.6, ..REST }.run();
        let events: Vec<_> = run.events().collect();
        let released = 2.0 * expected * run.trajectory().t[events[0].0];
        let off = released / expected - 1.0;
        println!(
            "side {side}, rise {rise}, flank {flank}: {released:.6e} N m, off by {off:.1e}; {} events",
            events.len()
        );
        // While the torque rises, the mesh force follows it with a delay if the friction has a part along the line of action.
        assert!(off.abs() < if side == 0.0 { 1e-6 } else { 3e-5 }, "{released}, not {expected}");
        // Until the torque has risen by more than its rounding error, rounding errors decide whether the flanks stick once more.
        let last = run.trajectory().t[events[events.len() - 1].0] - run.trajectory().t[events[0].0];
        assert!(last < 1e-8, "they stick again after {last} s");
        assert!(flank * psi(&run).last().unwrap() < -1e-3);
    }
}

/// The breakaway torque with a stiffness that varies along the phase. As the mesh yields under the rising load, stuck flanks turn about
/// their point of contact. So the phase and the stiffness change, and with them the bound of the friction.
#[test]
fn the_bound_of_stuck_flanks_follows_a_curved_stiffness() {
    let (mean, swing, excess) = (1e6, 8e5, 0.011);
    // k = mean + swing sin(theta - 3 rad), which is steepest where the gears start.
    let stiffness = "{ mean = \"1 MN/m\", harmonics = [{ order = 1, amplitude = \"0.8 MN/m\", phase = \"-4.570796326794897 rad\" }] }";
    let tangent = 20f64.to_radians().tan();
    for side in [1.0, -1.0] {
        // Equilibrium of stuck flanks under a load that exceeds the drive by `excess`: psi, s and the friction R, where
        // arm psi + side tan(alpha) s is as at the start. Returns the friction minus its bound, R - mu k s. The bound has the present
        // stiffness if `follows`, or else the mean stiffness.
        let from = DRIVE / (RADIUS * mean);
        let left = |excess: f64, follows: bool| {
            let (mut s, mut psi, mut r, mut k) = (from, 0.0, 0.0, mean);
            for _ in 0..200 {
                let phase: f64 = TEETH / 2.0 * psi;
                k = mean + swing * phase.sin();
                r = (excess / 2.0 + swing * phase.cos() * TEETH / 4.0 * s * s) / ARM;
                s = ((2.0 * DRIVE + excess) / (2.0 * RADIUS) + side * tangent * r) / k;
                psi = -side * tangent / ARM * (s - from);
            }
            r - MU * s * if follows { k } else { mean }
        };
        let released = |follows: bool| {
            let (mut low, mut high) = (0.0, excess);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if left(middle, follows) < 0.0 { low = middle } else { high = middle }
            }
            low
        };
        let load =
            format!("{{ ramp = {{ from = \"{DRIVE} N*m\", to = \"{} N*m\", duration = \"1 s\" }} }}", DRIVE + excess);
        let run = Pair { side, load: &load, stiffness, ..REST }.run();
        let found = excess * run.trajectory().t[run.events().next().unwrap().0];
        println!(
            "side {side}: {found:.6e} N m, expected {:.6e}, with the first bound {:.6e}",
            released(true),
            released(false)
        );
        // Vibrations of the start, whose amplitude falls by a factor e in 70 ms, have ended.
        assert!((found / released(true) - 1.0).abs() < 2e-5);
        assert!((found / released(false) - 1.0).abs() > 1e-3);
    }
}

/// Gears that turn forward against a constant excess come to rest after the way psi'²/(2 a); there they stay, or turn back with another
/// acceleration. The friction takes its constant moment times the way.
#[test]
fn gears_come_to_rest_and_stay_or_turn_back() {
    let speed = 1.0;
    for method in ["dop853", "radau"] {
        for part in [0.6, 1.8] {
            let excess = part * breakaway(MU, 0.0);
            let moment = ARM * MU * (2.0 * DRIVE + excess) / (2.0 * RADIUS);
            let (slowed, turned) =
                ((excess / 2.0 + moment) / (INERTIA / 2.0), (excess / 2.0 - moment) / (INERTIA / 2.0));
            let (stop, way) = (2.0 * speed / slowed, 2.0 * speed * speed / slowed);
            let load = newton_metres(DRIVE + excess);
            let run = Pair { load: &load, speed, t_end: 0.2, method, ..REST }.run();
            let back = turned.max(0.0) * (0.2 - stop);
            let off = [
                (psi(&run).last().unwrap() - (way - 0.5 * back * (0.2 - stop))).abs() / way,
                (final_speed(&run) + back).abs() / speed,
                (run.trajectory().t[run.events().next().unwrap().0] / stop - 1.0).abs(),
            ];
            let lost = run.trajectory().torque_work.iter().map(|(_, w)| *w.last().unwrap()).fold(0.0f64, f64::min);
            println!("{method}, {part} of the breakaway torque: off by {off:?}, least work {lost:.4e} J");
            assert!(off.iter().all(|off| *off < 2e-9), "{off:?}");
            let account = residual(&run, INERTIA * speed * speed);
            assert!(account < 1e-9, "{account:e}");
        }
    }
}

/// A load that oscillates about the drive moves the gears to and fro, through sticking. Between two phases of sticking the mesh force is in
/// balance with the torques, and psi follows from one integral over the time.
#[test]
fn a_harmonic_load_moves_the_gears_to_and_fro_with_sticking_between() {
    let (amplitude, omega) = (0.02, std::f64::consts::TAU * 5.0);
    let load =
        "{ mean = \"1 N*m\", harmonics = [{ amplitude = \"0.02 N*m\", frequency = \"5 Hz\", phase = \"-90 deg\" }] }";
    let run = Pair { load, t_end: 0.12, ..REST }.run();
    let ratio = MU * ARM / (2.0 * RADIUS);
    // Released where the excess is that of statics; at rest again where the integral of the moment is zero.
    let released = (breakaway(MU, 0.0) / amplitude).asin() / omega;
    let speed = |t: f64| {
        let swept = amplitude * ((omega * released).cos() - (omega * t).cos()) / omega;
        (-(0.5 - ratio) * swept + 2.0 * DRIVE * ratio * (t - released)) / (INERTIA / 2.0)
    };
    let (mut low, mut high) = (0.05, 0.12);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if speed(middle) < 0.0 { low = middle } else { high = middle }
    }
    let mut times: Vec<f64> = run.events().map(|(before, _)| run.trajectory().t[before]).collect();
    // Rounding errors may make the flanks stick and slip once more in the instant of their release.
    times.dedup_by(|later, earlier| *later - *earlier < 1e-9);
    println!("released at {} s, expected {released}; at rest at {} s, expected {low}", times[0], times[1]);
    assert_eq!(times.len(), 2, "{times:?}");
    assert!((times[0] / released - 1.0).abs() < 1e-4 && (times[1] / low - 1.0).abs() < 1e-4);

    for side in [0.0, 1.0, -1.0] {
        let ends = ["dop853", "radau"].map(|method| {
            let run = Pair { side, load, t_end: 0.6, method, parameters: "mu_rise12 = 0.05", ..REST }.run();
            let account = residual(
                &run,
                INERTIA * run.trajectory().q_dot[0].iter().fold(0.0f64, |m, v| m.max((v / TEETH).powi(2))),
            );
            println!("side {side}, {method}: {} events, account {account:.1e}", run.events().count());
            assert!(account < 1e-6, "{account:e}");
            (*psi(&run).last().unwrap(), run.events().count())
        });
        println!("side {side}: {ends:?}");
        assert_eq!(ends[0].1, ends[1].1);
        assert!((ends[0].0 / ends[1].0 - 1.0).abs() < 1e-6, "{ends:?}");
    }
}

/// Static friction above sliding friction holds while the load rises in steps, up to the breakaway torque. Stuck flanks have no direction: a
/// rounding error of their sliding speed must not choose one at a step, because they would then slide against the smaller friction.
#[test]
fn steps_of_the_load_do_not_release_stuck_flanks() {
    for side in [0.0, 0.4, -1.0] {
        let expected = breakaway(MU * 1.2, side);
        let steps = (86..=98).enumerate().map(|(i, part)| {
            let load = DRIVE + f64::from(part) / 100.0 * expected;
            format!("{{ value = \"{load:?} N*m\", until = \"{} s\" }}", 0.05 * (i + 1) as f64)
        });
        let last = format!("{{ value = \"{:?} N*m\" }}", DRIVE + 1.02 * expected);
        let load = format!("{{ steps = [{}] }}", steps.chain([last]).collect::<Vec<_>>().join(", "));
        let run = Pair { side, load: &load, parameters: "mu_rise12 = 0.2", t_end: 0.7, ..REST }.run();
        let held = psi(&run)
            .iter()
            .zip(&run.trajectory().t)
            .filter(|(_, t)| **t <= 0.65)
            .map(|(psi, _)| psi.abs())
            .fold(0.0, f64::max);
        let end = *psi(&run).last().unwrap();
        println!("side {side}: psi within {held:e} rad, at the end {end:e} rad");
        // Stuck flanks turn about their point of contact as the mesh yields.
        assert!(held < 1e-5 && end < -1e-3, "side {side}: psi within {held:e} rad, at the end {end:e} rad");
    }
}

/// The same at a boundary of the pitch, which stuck flanks pass as the mesh yields under a load that rises from 0.9 to 0.99 of the
/// breakaway torque: they turn about their point of contact, so that the phase moves by some microradians.
#[test]
fn a_boundary_of_the_pitch_does_not_release_stuck_flanks() {
    let mut passed = 0;
    for side in [1.0, -1.0] {
        let expected = breakaway(MU * 1.2, side);
        let [from, to] = [0.9, 0.99].map(|part| DRIVE + part * expected);
        let load = format!("{{ ramp = {{ from = \"{from:?} N*m\", to = \"{to:?} N*m\", duration = \"1 s\" }} }}");
        for phase in ["4e-6", "-4e-6", "6.2831893", "6.2831813"] {
            let run = Pair { side, load: &load, parameters: "mu_rise12 = 0.2", phase, ..REST }.run();
            passed += run.outcome.counts.cell_changes;
            assert_eq!(stuck(&run.outcome), [1.0], "side {side}, from {phase} rad");
        }
    }
    assert!(passed >= 4, "only {passed} boundaries are passed");
}

/// Gears vibrate about the unloaded mesh, with a tooth pair beyond the pitch point. When the mesh force changes its sign, the line of action
/// becomes that of the other flank, and the flanks slide the other way. Friction therefore works against the vibration on both flanks:
/// with the stiffness k (1 -+ mu tan(alpha)) the first swing is sqrt((1 - mu tan(alpha))/(1 + mu tan(alpha))) of the start.
#[test]
fn friction_opposes_the_vibration_on_both_flanks() {
    let (start, loss) = (1e-3, 0.2 * 20f64.to_radians().tan());
    for side in [1.0, -1.0] {
        let text = format!(
            "model = \"gear_pair\"\neffects = [\"stiffness_step\", \"torques\", \"sliding_friction\", \"flank_stiction\"]\n\
             [parameters]\nN1 = 20\nN2 = 20\nI1 = \"1e-3 kg*m^2\"\nI2 = \"1e-3 kg*m^2\"\nT0 = \"0 N*m\"\nalpha = \"20 deg\"\nmu = 0.2\n\
             [laws.k]\nsteps = [{{ value = \"500 N*m\" }}]\n[laws.side]\nsteps = [{{ value = {side} }}]\n\
             [laws.arm]\nsteps = [{{ value = \"0.1 rad\" }}]\n\
             [start]\nspeed = \"0 rpm\"\ntheta = \"1 rad\"\nphi = \"{start} rad\"\n\
             [run]\nt_end = \"5e-4 s\"\ntolerance = 1e-12\n[output]\nplots = []\nrate = \"100 kHz\"\n"
        );
        let scene = Scene::from_toml("flanks", &text).unwrap_or_else(|e| panic!("{e}"));
        let run = scene.run().unwrap_or_else(|e| panic!("{e}"));
        let t = run.trajectory();
        // The flanks change their direction where phi turns: there the rolling of the gears is 1e-4 of the sliding.
        let turns = run.events().map(|(before, _)| before).filter(|&row| t.q_dot[1][row].abs() < 1e-3 * start * 1e4);
        let turns: Vec<f64> = turns.map(|row| t.q[1][row]).collect();
        let factor = -((1.0 - loss) / (1.0 + loss)).sqrt();
        for (i, swing) in turns.iter().enumerate() {
            let expected = start * factor.powi(i as i32 + 1);
            println!("side {side}: swing {i} is {swing:e} rad, expected {expected:e}");
            assert!((swing / expected - 1.0).abs() < 1e-10, "swing {i}: {swing:e}, not {expected:e}");
        }
        assert!(turns.len() >= 2, "only {} swings", turns.len());
        let [slide, roll] = ["power_slide", "power_roll"].map(|name| run.column(name).unwrap());
        let most = slide.iter().zip(roll.iter()).map(|(slide, roll)| slide + roll).fold(f64::MIN, f64::max);
        println!("side {side}: friction drives by at most {most:e} W");
        assert!(most < 1e-6, "friction drives by {most:e} W");
    }
}

/// The smoothed law creeps in proportion to its mixing speed, and tends to the law that sticks: psi -> w_mix t x/sqrt(1 - x²).
#[test]
fn the_smoothed_law_tends_to_sticking() {
    let part = 0.8;
    let excess = part * breakaway(MU, 0.0);
    let load = newton_metres(DRIVE + excess);
    let x = excess / 2.0 / (ARM * MU * (2.0 * DRIVE + excess) / (2.0 * RADIUS));
    let slope = x / (1.0 - x * x).sqrt();
    for w_mix in [0.1, 0.02, 0.004] {
        let parameters = format!("w_mix12 = \"{w_mix} rad/s\"");
        let run = Pair { sticks: false, load: &load, parameters: &parameters, ..REST }.run();
        let measured = -psi(&run).last().unwrap() / w_mix;
        println!("w_mix = {w_mix} rad/s: psi = -{measured:.5} s w_mix, expected {slope:.5}");
        // It takes the time I/2 w_mix/(arm mu F), 35 ms at 0.1 rad/s, to reach the speed of creep.
        assert!((measured / slope - 1.0).abs() < w_mix, "{measured}, not {slope}");
    }
}

/// Hard case: teeth with curved laws start at the pitch point and stick there for a moment while they turn. Their friction stops them
/// before a step of the stiffness. There they bounce with falling amplitude and then stick. The mesh stiffness still turns the stuck flanks
/// to and fro about their point of contact.
#[test]
fn a_pair_of_teeth_is_stopped_by_its_friction() {
    let stopped = |method: &str| {
        run(&[
            r#"effects=["stiffness_step", "sliding_friction", "flank_stiction", "damping", "torques", "backlash"]"#,
            "parameters.b=\"1e-3 rad\"",
            "parameters.mu=0.15",
            "parameters.zeta=0.1",
            "start={speed=\"6 rpm\"}",
            "output={rate=\"2 kHz\"}",
            &format!("run={{t_end=\"0.5 s\", method=\"{method}\", tolerance=1e-11}}"),
        ])
    };
    let [a, b] = ["dop853", "radau"].map(stopped);
    for run in [&a, &b] {
        let last = run.trajectory.len() - 1;
        println!("at the end {:?}; unaccounted {:.1e}", state(run, last), unaccounted(run));
        assert!(unaccounted(run) < 1e-8);
    }
    let [end_a, end_b] = [&a, &b].map(|run| state(run, run.trajectory.len() - 1)[0]);
    assert!((end_a - end_b).abs() < 1e-7, "{end_a} {end_b}");
}

/// With a frozen phase the laws follow the time, so that their values also change while flanks stick. Gears on bearings that turn backward
/// stick at the start and are released. If the right-hand side of stuck flanks used other rates than the condition of their release, the
/// run would need steps without end.
#[test]
fn stuck_flanks_are_released_while_the_phase_is_frozen() {
    let ends = ["dop853", "radau"].map(|method| {
        let outcome = common::run(&common::scene(
            "sliding_friction",
            &[
                r#"effects=["frozen_phase", "stiffness_step", "torques", "flank_stiction_12", "sliding_friction_12"]"#,
                "run.t_end=5e-4 s",
                "start.speed=-600 rpm",
                "parameters.T_motor=141 N*m",
                // Deflections from which the gears vibrate.
                "start.s=68.58246 um",
                "start.x1=-9.099838 um",
                "start.y1=-25.0016 um",
                "start.x2=4.549919 um",
                "start.y2=12.5008 um",
                &format!("run.method={method}"),
            ]
            .map(str::to_owned),
        ));
        let (share, cost) = (stuck(&outcome)[0], outcome.counts.cost);
        println!("{method}: stuck for {share} of the time, {cost:?}, {:e} unaccounted for", unaccounted(&outcome));
        assert!((0.17..0.19).contains(&share) && unaccounted(&outcome) < 1e-12);
        assert!(cost.evaluations < 10_000);
        state(&outcome, outcome.trajectory.len() - 1)
    });
    let off = (0..4).map(|i| (ends[0][i] / ends[1][i] - 1.0).abs()).fold(0.0, f64::max);
    println!("two methods differ by {off:e}");
    assert!(off < 1e-8, "{ends:?}");
}

/// Hard case: gears roll without load. The deflection, and so the friction, is zero except for rounding errors, which have the sign of the
/// flank in contact. They must not separate the flanks, and a start at the edge of the play must not stop the sliding.
#[test]
fn gears_roll_without_load() {
    let base = [
        "parameters.mu12=0.05",
        r#"laws.side12.steps=[{ value = "1", width = "3.7699 rad" }, { value = "-1" }]"#,
        r#"laws.arm12.steps=[{ value = "1 mm", width = "3.7699 rad" }, { value = "2 mm" }]"#,
        "run.t_end=0.5 ms",
        "start.speed=1500 rpm",
    ];
    let damped = r#"effects=["damping", "flank_stiction", "sliding_friction", "stiffness_step", "viscous_friction"]"#;
    let with_play = r#"effects=["backlash", "flank_stiction", "sliding_friction", "stiffness_step"]"#;
    let cases = [
        // The second run, from a start that differs by rounding errors, has deflections of 1e-26 m.
        [damped, "start.phase12=2.8661686156550483 rad", "parameters.r1=0.09246142744027494 m"],
        // The base radii do not fit the numbers of teeth: the gears slide along the line of action too.
        [with_play, "start.phase12=-0.44 rad", "parameters.r1=0.04 m"],
    ];
    for case in cases {
        let overrides: Vec<String> = base.iter().chain(&case).map(|s| (*s).to_owned()).collect();
        let results = common::scene("train_kahraman_singh", &overrides).run().unwrap_or_else(|e| panic!("{e}"));
        let (outcome, changes) = (&results.outcome, results.outcome.trajectory.q_dot[0].iter());
        let off = changes.map(|v| (v / 6283.185307179586 - 1.0).abs()).fold(0.0, f64::max);
        println!("{:?}: speed off by {off:e}, {:e} unaccounted for", outcome.modes, unaccounted(outcome));
        assert!(off < 1e-9 && unaccounted(outcome) < 1e-12 && stuck(outcome).iter().all(|share| *share == 0.0));
        assert!(outcome.digits.is_some());
    }
}
