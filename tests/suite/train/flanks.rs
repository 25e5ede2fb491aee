//! Friction of the flanks at every kind of mesh of a train, against the loss mu |F| arm |omega_1 - omega_2| of constant laws.

use gearsim::scene::Scene;

use crate::common;

const MU: f64 = 0.06;

/// A mesh: its name, the distance of its force from the pitch point [m], and the rotors that slide on each other.
type Mesh = (&'static str, f64, [&'static str; 2]);

/// Runs a train with constant stiffnesses and arms and without damping. Returns the friction loss of the account, and that computed from
/// the forces of the meshes and the speeds of the rotors alone. The flanks slide with turns\[0\] times the speed of the first rotor plus
/// turns\[1\] times that of the second.
fn losses(tables: &str, meshes: &[Mesh], turns: [f64; 2]) -> [f64; 2] {
    let mut text = format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"torques\", \"sliding_friction\"]\n{tables}\n\
         [start]\nspeed = \"900 rpm\"\n[run]\nt_end = \"20 ms\"\n[output]\nrate = \"100 kHz\"\n[parameters]\n"
    );
    meshes.iter().for_each(|(name, ..)| text += &format!("{} = \"1e-3 rad/s\"\n", named("w_mix", name)));
    for (name, arm, _) in meshes {
        text += &format!("[laws.{}]\nsteps = [{{ value = 0 }}]\n", named("side", name));
        text += &format!("[laws.{}]\nsteps = [{{ value = \"{arm} m\" }}]\n", named("arm", name));
    }
    let scene = Scene::parse("flanks", "flanks.toml", &text, &[], &common::models())
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render(100, false)));
    let run = common::run(&scene);
    let column = |name: &str| run.trajectory.output(name).unwrap_or_else(|| panic!("no output `{name}`"));
    let mut expected = 0.0;
    for (name, arm, [first, second]) in meshes {
        let force = column(&format!("mesh_force_{name}"));
        let [a, b] = [first, second].map(|rotor| column(&format!("rotor_speed_{rotor}")));
        let power: Vec<f64> =
            (0..force.len()).map(|i| MU * arm * (force[i] * (turns[0] * a[i] + turns[1] * b[i])).abs()).collect();
        let t = &run.trajectory.t;
        expected += (1..t.len()).map(|i| (t[i] - t[i - 1]) * (power[i] + power[i - 1]) / 2.0).sum::<f64>();
    }
    let works = run.trajectory.torque_work.iter();
    let friction = works.filter(|(torque, _)| ["slide", "roll"].iter().any(|of| torque.name.starts_with(of)));
    [-friction.map(|(_, work)| work.last().expect("rows")).sum::<f64>(), expected]
}

fn named(quantity: &str, part: &str) -> String {
    let joint = if part.starts_with(|c: char| c.is_ascii_digit()) { "" } else { "_" };
    format!("{quantity}{joint}{part}")
}

fn assert_equal([account, meshes]: [f64; 2]) {
    assert!(account > 0.0 && (account - meshes).abs() < 1e-4 * account, "account {account} J, meshes {meshes} J");
}

const PAIR: &str = "
[rotors]
a = \"0.02 kg*m^2\"
b = \"0.3 kg*m^2\"
[drives.m]
rotor = \"a\"
torque = \"40 N*m\"
[loads.l]
rotor = \"b\"
torque = \"110 N*m\"
[meshes.12]
between = [\"a\", \"b\"]
teeth = [25, 75]
module = \"3 mm\"
stiffness = \"300 MN/m\"
friction = 0.06
";

/// The flanks of an external mesh slide with the sum of both speeds.
#[test]
fn external_gears_lose_the_work_of_the_sum_of_their_speeds() {
    assert_equal(losses(PAIR, &[("12", 3e-3, ["a", "b"])], [1.0, 1.0]));
}

/// The flanks of a pinion and its ring gear slide with the difference of their speeds.
#[test]
fn internal_gears_lose_the_work_of_the_difference_of_their_speeds() {
    let tables = PAIR.to_string() + "internal = true\n";
    assert_equal(losses(&tables, &[("12", 3e-3, ["a", "b"])], [1.0, -1.0]));
}

/// All meshes of a planet set, sun and planet, planet and ring, with a carrier that turns.
#[test]
fn planets_lose_the_work_of_all_their_meshes() {
    let tables = "
[rotors]
s = \"2e-3 kg*m^2\"
c = \"0.02 kg*m^2\"
r = \"0.05 kg*m^2\"
[planets.p]
sun = \"s\"
carrier = \"c\"
ring = \"r\"
teeth = [27, 99]
module = \"2 mm\"
count = 2
mass = \"0.4 kg\"
inertia = \"2e-4 kg*m^2\"
sun_stiffness = \"400 MN/m\"
ring_stiffness = \"500 MN/m\"
friction = 0.06
[supports.r]
rotor = \"r\"
stiffness = \"50 MN*m/rad\"
[drives.m]
rotor = \"s\"
torque = \"30 N*m\"
[loads.l]
rotor = \"c\"
torque = \"120 N*m\"
";
    let meshes = [
        ("p_s1", 2e-3, ["s", "p_1"]),
        ("p_s2", 2e-3, ["s", "p_2"]),
        ("p_r1", 1e-3, ["p_1", "r"]),
        ("p_r2", 1e-3, ["p_2", "r"]),
    ];
    assert_equal(losses(tables, &meshes, [1.0, -1.0]));
}
