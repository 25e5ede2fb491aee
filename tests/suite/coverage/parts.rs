//! Scenes of trains, one for each kind of part and effect that it may have. Other properties of the part are constant.

use gearsim::Scene;
use gearsim::model::Model;

/// A kind of part: its table and key, the effects of the scene, and its tables beside those of [`PAIR`] or [`PLANETS`].
type Part = (&'static str, &'static [&'static str], &'static str);

/// A motor, a pair of gears and a load. Most of the parts below are added at rotor `1`.
const PAIR: &str = r#"
[rotors]
1 = "0.02 kg*m^2"
2 = "0.3 kg*m^2"
[drives.motor]
rotor = "1"
torque = "30 N*m"
[loads.load]
rotor = "2"
torque = "90 N*m"
[start]
speed = "900 rpm"
"#;

/// The table of the mesh. The keys of a part of the mesh are appended to it.
const MESH: &str = r#"
[meshes.12]
between = ["1", "2"]
teeth = [20, 60]
module = "3 mm"
"#;
/// The text that replaces `TEETH` in the keys below. If the keys give no stiffness, the mesh has the stiffness of these teeth.
const TEETH: &str = "teeth = [20, 60], module = \"3 mm\", face_width = \"20 mm\"";
/// The text that replaces `DAMAGE` in the keys below.
const DAMAGE: &str = "damage = [{ tooth = 5, of = 20, loss = 0.3 }]";

/// A planet set with a driven sun and a loaded carrier. The keys of a part of the set are appended to its table.
const PLANETS: &str = r#"
[rotors]
1 = "6e-4 kg*m^2"
c = "0.06 kg*m^2"
r = "0.06 kg*m^2"
[supports.r]
rotor = "r"
stiffness = "20 MN*m/rad"
[drives.motor]
rotor = "1"
torque = "30 N*m"
[loads.load]
rotor = "c"
torque = "140 N*m"
[start]
speed = "900 rpm"
[planets.p]
sun = "1"
ring = "r"
carrier = "c"
teeth = [27, 99]
module = "3 mm"
count = 3
mass = "0.7 kg"
inertia = "2e-3 kg*m^2"
sun_stiffness = { teeth = [27, 36], module = "3 mm", face_width = "25 mm" }
ring_stiffness = { teeth = [36, 99], internal = true, addendum = [1, 0.8], module = "3 mm", face_width = "25 mm" }
"#;

const STEPS: &str = "stiffness_step";

/// Parts beside a pair of gears. The text before `|` is appended to the table of the mesh, the text after it to the scene.
const BESIDE_A_PAIR: &[Part] = &[
    ("rotors", &[STEPS, "torques"], "|"),
    ("rotors: damping", &[STEPS, "torques", "damping"], "|[parameters]\nalpha_M = \"2 1/s\"\nbeta_K = \"2 us\""),
    (
        "shafts",
        &[STEPS, "torques"],
        "|[rotors.m]\ninertia = \"0.05 kg*m^2\"\n[shafts.m]\nbetween = [\"m\", \"1\"]\nstiffness = \"20 kN*m/rad\"",
    ),
    (
        "shafts.damping",
        &[STEPS, "torques", "viscous_friction"],
        "|[rotors.m]\ninertia = \"0.05 kg*m^2\"\n[shafts.m]\nbetween = [\"m\", \"1\"]\nstiffness = \"20 kN*m/rad\"\n\
         damping = \"2 N*m*s/rad\"",
    ),
    ("meshes.stiffness: energy", &[STEPS, "torques"], "stiffness = { method = \"energy\", TEETH }|"),
    (
        "meshes.stiffness: curves",
        &[STEPS, "torques"],
        "stiffness = { method = \"energy\", course = \"curves\", TEETH }|",
    ),
    ("meshes.stiffness: damage", &[STEPS, "torques"], "stiffness = { DAMAGE, TEETH }|"),
    (
        "meshes.stiffness: damage of curves",
        &[STEPS, "torques"],
        "stiffness = { method = \"energy\", course = \"curves\", DAMAGE, TEETH }|",
    ),
    ("meshes.stiffness: ramp", &[STEPS, "torques"], "stiffness = { ramp = \"0.2 rad\", TEETH }|"),
    (
        "meshes.stiffness: harmonics",
        &[STEPS, "torques"],
        "stiffness = { mean = \"300 MN/m\", harmonics = [{ order = 1, amplitude = \"40 MN/m\" }] }|",
    ),
    (
        "meshes.stiffness: table",
        &[STEPS, "torques"],
        "stiffness = { table = [{ at = 0, value = \"300 MN/m\" }, { at = \"2 rad\", value = \"320 MN/m\" }, \
         { at = \"4 rad\", value = \"280 MN/m\" }] }|",
    ),
    (
        "meshes.stiffness: helical",
        &[STEPS, "torques"],
        "helix_angle = \"15 deg\"\nstiffness = { helix_angle = \"15 deg\", TEETH }|",
    ),
    (
        "meshes.stiffness: helical, damage",
        &[STEPS, "torques"],
        "helix_angle = \"15 deg\"\nstiffness = { helix_angle = \"15 deg\", DAMAGE, TEETH }|",
    ),
    ("meshes: rigid_kinematics", &[STEPS, "torques", "rigid_kinematics"], "|"),
    ("meshes: frozen_phase", &[STEPS, "torques", "frozen_phase"], "|"),
    ("meshes.error", &[STEPS, "torques", "transmission_error"], "error = { pitch_errors = [\"4 um\", \"-4 um\"] }|"),
    (
        "meshes.error: a curve",
        &[STEPS, "torques", "transmission_error"],
        "error = { harmonics = [{ order = 1, amplitude = \"3 um\" }] }|",
    ),
    ("meshes.backlash", &[STEPS, "torques", "backlash"], "backlash = \"50 um\"|"),
    ("meshes.damping", &[STEPS, "torques", "viscous_friction"], "damping = \"300 N*s/m\"|"),
    ("meshes.friction", &[STEPS, "torques", "sliding_friction"], "friction = 0.06|"),
    ("flank_stiction", &[STEPS, "torques", "sliding_friction", "flank_stiction"], "friction = 0.06|"),
    (
        "thrust_bearings",
        &[STEPS, "torques"],
        "helix_angle = \"15 deg\"\nstiffness = { steps = [{ value = \"250 MN/m\", width = \"3 rad\" }, { value = \"270 MN/m\" }] }|[thrust_bearings.p]\nrotor = \"1\"\nmass = \"3 kg\"\nstiffness = \"100 MN/m\"",
    ),
    (
        "thrust_bearings.damping",
        &[STEPS, "torques", "viscous_friction"],
        "helix_angle = \"15 deg\"\nstiffness = { steps = [{ value = \"250 MN/m\", width = \"3 rad\" }, { value = \"270 MN/m\" }] }|[thrust_bearings.p]\nrotor = \"1\"\nmass = \"3 kg\"\nstiffness = \"100 MN/m\"\n\
         damping = \"2 kN*s/m\"",
    ),
    (
        "bearings.viscous",
        &[STEPS, "torques", "viscous_friction"],
        "|[bearings.b]\nrotor = \"1\"\nviscous = \"0.02 N*m*s/rad\"",
    ),
    ("bearings.friction", &[STEPS, "torques", "dry_friction"], "|[bearings.b]\nrotor = \"1\"\nfriction = \"0.5 N*m\""),
    (
        "bearings.between",
        &[STEPS, "torques", "dry_friction"],
        "|[rotors.m]\ninertia = \"0.05 kg*m^2\"\n[bearings.b]\nbetween = [\"m\", \"1\"]\nfriction = \"20 N*m\"",
    ),
    (
        "clutches",
        &[STEPS, "torques", "overrunning_clutch"],
        "|[rotors.m]\ninertia = \"0.05 kg*m^2\"\n[clutches.f]\nbetween = [\"m\", \"1\"]\ncapacity = \"300 N*m\"\n\
         [drives.m]\nrotor = \"m\"\ntorque = \"10 N*m\"",
    ),
    (
        "end_stops",
        &[STEPS, "torques", "end_stop"],
        "|[rotors.arm]\ninertia = \"0.01 kg*m^2\"\n[shafts.a]\nbetween = [\"1\", \"arm\"]\nstiffness = \"500 N*m/rad\"\n\
         [end_stops.a]\nbetween = [\"1\", \"arm\"]\nupper = \"0.1 deg\"\nlower = \"-0.1 deg\"\nstiffness = \"40 kN*m/rad\"\ndamping = \"2 N*m*s/rad\"",
    ),
    ("drives.torque, loads.torque", &[STEPS, "torques"], "|"),
    (
        "drives.governor",
        &[STEPS, "torques", "governor"],
        "|[drives.g]\nrotor = \"1\"\ngovernor = { gain = \"1 N*m*s/rad\", set_point = \"900 rpm\" }",
    ),
    (
        "drives.dc",
        &[STEPS, "torques", "dc"],
        "|[drives.g]\nrotor = \"1\"\ndc = { stall_torque = \"40 N*m\", no_load_speed = \"1200 rpm\" }",
    ),
    (
        "drives.induction",
        &[STEPS, "torques", "induction"],
        "|[drives.g]\nrotor = \"1\"\ninduction = { breakdown_torque = \"60 N*m\", breakdown_slip = 0.2, \
         synchronous_speed = \"1000 rpm\" }",
    ),
    (
        "drives.traction",
        &[STEPS, "torques", "traction"],
        "|[drives.g]\nrotor = \"1\"\ntraction = { peak_torque = \"30 N*m\", peak_power = \"2 kW\", demand = 0.5 }",
    ),
    (
        "loads.fan",
        &[STEPS, "torques", "fan"],
        "|[loads.f]\nrotor = \"2\"\nfan = { coefficient = \"0.01 N*m*s^2/rad^2\" }",
    ),
];

/// Parts of a planetary stage. Keys without a table are those of its planet set.
const BESIDE_PLANETS: &[Part] = &[
    ("planets, supports", &[STEPS, "torques"], ""),
    ("planets: damping", &[STEPS, "torques", "damping"], "[parameters]\nbeta_K = \"2 us\""),
    (
        "planets.sun_error, planets.ring_error",
        &[STEPS, "torques", "transmission_error"],
        "sun_error = { pitch_errors = [\"4 um\", \"-4 um\"] }\nring_error = \"2 um\"",
    ),
    ("planets.damping", &[STEPS, "torques", "viscous_friction"], "damping = \"300 N*s/m\""),
    ("planets.backlash", &[STEPS, "torques", "backlash"], "backlash = \"50 um\""),
    ("planets.friction", &[STEPS, "torques", "sliding_friction"], "friction = 0.06"),
    (
        "supports.damping",
        &[STEPS, "torques", "viscous_friction"],
        "[supports.more]\nrotor = \"r\"\nstiffness = \"1 MN*m/rad\"\ndamping = \"50 N*m*s/rad\"",
    ),
];

/// The kinds of parts, each with a scene that runs for `t_end` [s]. Panics if an effect of an element does not occur.
pub fn scenes(t_end: f64) -> Vec<(&'static str, Scene)> {
    let scene = |name: &str, effects: &[&str], tables: &str| {
        let text = format!("model = \"train\"\neffects = {effects:?}\n{tables}\n[run]\nt_end = \"{t_end} s\"\n");
        Scene::from_toml(name, &text).unwrap_or_else(|mistakes| panic!("{name}: {mistakes}\n{text}"))
    };
    let pairs = BESIDE_A_PAIR.iter().map(|(name, effects, tables)| {
        let (of_mesh, others) = tables.split_once('|').expect("two parts");
        let of_mesh = match of_mesh.contains("stiffness") {
            true => of_mesh.replace("TEETH", TEETH).replace("DAMAGE", DAMAGE),
            false => format!("stiffness = {{ {TEETH} }}\n{of_mesh}"),
        };
        // Where only a clutch or friction connects rotors `m` and `1`, there are two rigid motions, each with a start speed.
        let speeds = "speed1 = \"900 rpm\"\nspeed_m = \"900 rpm\"";
        let pair = if ["clutches", "bearings.between"].contains(name) {
            PAIR.replace("speed = \"900 rpm\"", speeds)
        } else {
            PAIR.into()
        };
        (*name, scene(name, effects, &format!("{pair}{MESH}{of_mesh}\n{others}")))
    });
    let planets = BESIDE_PLANETS
        .iter()
        .map(|(name, effects, tables)| (*name, scene(name, effects, &format!("{PLANETS}{tables}"))));
    let bare = gearsim::models().iter().find(|entry| entry.model.name == "train").expect("trains").model;
    complete(bare);
    pairs.chain(planets).collect()
}

/// Checks that every effect of every element is in a scene.
fn complete(bare: &Model) {
    let all: Vec<&str> = BESIDE_A_PAIR.iter().chain(BESIDE_PLANETS).flat_map(|part| part.1).copied().collect();
    for effect in bare.elements.iter().flat_map(|element| element.effects) {
        let name = effect.name.strip_suffix("_x").unwrap_or(effect.name);
        assert!(all.contains(&name), "no part in tests/suite/coverage/parts.rs has the effect `{name}`");
    }
}
