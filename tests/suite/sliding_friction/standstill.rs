//! Gears at rest under load: friction of the flanks does not hold them, and they creep. While the moment Q of the torques along psi is less
//! than mu |F| arm, psi' = w_mix x/sqrt(1 - x²) with x = Q/(mu |F| arm). At a larger moment they accelerate, as flanks that stick would.
//!
//! The friction of a pair beyond or before the pitch point also acts along the line of action: side mu tan(alpha) |F| x. It is a part of
//! the balance from which F follows, so that the breakaway moment depends on the side.

use gearsim::Scene;

const MU: f64 = 0.1;
const ARM: f64 = 4e-3;
const W_MIX: f64 = 0.1;
const DRIVE: f64 = 1.0;
const RADIUS: f64 = 0.056;

/// The speeds of both gears at the end, in the direction of the drive \[rad/s\], of equal gears that begin to turn at 1 rad/s. `excess` is
/// the torque of the load minus that of the drive \[N m\]. `side` is 1 if a single pair touches beyond the pitch point, -1 if before it, 0 if
/// two pairs touch at the same distance from it.
fn speeds(excess: f64, side: f64) -> [f64; 2] {
    let text = format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"sliding_friction\", \"torques\", \"viscous_friction\"]\n\
         [rotors]\n1 = \"5e-4 kg*m^2\"\n2 = \"5e-4 kg*m^2\"\n\
         [meshes.12]\nbetween = [\"1\", \"2\"]\nteeth = [40, 40]\nbase_radius = \"56 mm\"\nstiffness = \"2 MN/m\"\n\
         friction = {MU}\ndamping = \"60 N*s/m\"\n\
         [laws.side12]\nsteps = [{{ value = {side} }}]\n[laws.arm12]\nsteps = [{{ value = \"{ARM} m\" }}]\n\
         [drives.motor]\nrotor = \"1\"\ntorque = \"{DRIVE} N*m\"\n[loads.load]\nrotor = \"2\"\ntorque = \"{} N*m\"\n\
         [parameters]\nw_mix12 = \"{W_MIX} rad/s\"\n[start]\nspeed = \"1 rad/s\"\n\
         [run]\nt_end = \"1.5 s\"\ntolerance = 1e-9\n[output]\nrate = \"1 kHz\"\n",
        DRIVE + excess
    );
    let scene = Scene::from_toml("standstill", &text).unwrap_or_else(|e| panic!("{e}"));
    let run = scene.run().unwrap_or_else(|e| panic!("{e}"));
    assert!(run.summary().refuted.is_none());
    ["rotor_speed_1", "rotor_speed_2"].map(|name| *run.column(name).unwrap().last().unwrap())
}

#[test]
fn a_loaded_pair_creeps_below_the_breakaway_moment_and_turns_back_beyond_it() {
    for (side, excess) in [(0.0, 2e-3), (0.0, 8e-3), (1.0, 8e-3), (-1.0, 8e-3)] {
        let speeds = speeds(excess, side);
        // At the end the torques are in balance with the mesh force F and the friction mu F x, x < 0:
        // -excess/2 = arm mu F x along psi, (T1 + T2)/(2 r) = F + side tan(alpha) mu F x along the line of action.
        let pressed = (2.0 * DRIVE + excess) / 2.0 / RADIUS;
        let without_side = -excess / 2.0 / (MU * pressed * ARM);
        let x = without_side / (1.0 - side * MU * 20f64.to_radians().tan() * without_side);
        let expected = W_MIX * x / (1.0 - x * x).sqrt();
        let psi_dot: f64 = speeds.iter().sum();
        println!("side {side}, x = {x:.4}: psi' = {psi_dot:.6e} rad/s, expected {expected:.6e}");
        assert!((psi_dot / expected - 1.0).abs() < 1e-4, "{psi_dot}, not {expected}");
    }
    // x = 2.8: faster than any creep.
    let psi_dot: f64 = speeds(4e-2, 0.0).iter().sum();
    assert!(psi_dot < -10.0 * W_MIX, "{psi_dot}");
}
