//! The energy account of random trains whose dampers couple the modes.

use gearsim::{Results, Scene};

use crate::random::Random;

fn run(text: &str) -> Results {
    Scene::from_toml("losses", text)
        .unwrap_or_else(|e| panic!("{e}\n{text}"))
        .run()
        .unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// A mesh, a damped shaft behind it, and dry friction or a clutch between two rotors at its end, under constant torques. While the two
/// rotors stick, the train has a rigid motion on which no damper acts, beside modes that are damped. The loss of the damper is an integral
/// of the speeds, and must close the energy account.
#[test]
fn the_account_of_a_damped_shaft_behind_a_mesh_closes() {
    let mut random = Random::new(7);
    let mut stuck = 0;
    for scene in 0..60 {
        let mut between = |low: f64, high: f64| low * (high / low).powf(random.unit());
        let inertias: [f64; 4] = std::array::from_fn(|_| between(0.02, 2.0));
        let (stiffness, shaft, damping) = (between(1e6, 1e9), between(1e2, 1e5), between(1e-2, 1e1));
        let (capacity, torque, speed, t_end) =
            (between(10.0, 1e3), between(1.0, 100.0), between(10.0, 400.0), between(1e-3, 0.1));
        let teeth = [17 + random.below(50), 17 + random.below(50)];
        let joint = match scene % 3 {
            0 => format!("[bearings.k]\nbetween = [\"c\", \"d\"]\nfriction = \"{capacity} N*m\"\nbreakaway = 1.2"),
            1 => format!("[bearings.k]\nbetween = [\"c\", \"d\"]\nfriction = \"{capacity} N*m\""),
            _ => format!("[clutches.k]\nbetween = [\"c\", \"d\"]\ncapacity = \"{capacity} N*m\""),
        };
        let effect = if scene % 3 == 2 { "overrunning_clutch" } else { "dry_friction" };
        let [a, b, c, d] = inertias;
        let text = format!(
            "model = \"train\"\neffects = [\"torques\", \"stiffness_step\", \"viscous_friction\", \"{effect}\"]\n\
             [rotors]\na = \"{a} kg*m^2\"\nb = \"{b} kg*m^2\"\nc = \"{c} kg*m^2\"\nd = \"{d} kg*m^2\"\n\
             [meshes.12]\nbetween = [\"a\", \"b\"]\nteeth = {teeth:?}\nbase_radius = \"0.06 m\"\nstiffness = \"{stiffness} N/m\"\n\
             [shafts.s]\nbetween = [\"b\", \"c\"]\nstiffness = \"{shaft} N*m/rad\"\ndamping = \"{damping} N*m*s/rad\"\n\
             {joint}\n[drives.d]\nrotor = \"a\"\ntorque = \"{torque} N*m\"\n[start]\nphase12_dot = \"{speed} rad/s\"\n\
             [run]\nt_end = \"{t_end} s\"\n[output]\nplots = []\nrate = \"{} Hz\"\n",
            100.0 / t_end
        );
        let results = run(&text);
        stuck += usize::from(results.outcome.counts.sticks > 0);
        let t = &results.outcome.trajectory;
        let largest = |columns: [&[f64]; 3]| columns.into_iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let (energies, residual) = (largest([&t.kinetic, &t.strain, &t.work]), largest([&t.residual, &[], &[]]));
        assert!(residual < 1e-11 * energies, "scene {scene}: {residual:e} J of {energies:e} J\n{text}");
        // It falls by rounding errors at most.
        let falls = t.dissipated.windows(2).map(|w| w[0] - w[1]).fold(0.0, f64::max);
        assert!(falls < 1e-14 * energies, "scene {scene}: the dissipated energy falls by {falls:e} J\n{text}");
    }
    assert!(stuck > 30, "only {stuck} scenes stick");
}
