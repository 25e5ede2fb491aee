//! A damaged tooth of a sun or a ring passes the planets one after the other, in the direction in which its gear turns. The stiffness of the
//! mesh with a planet falls when the tooth is at the place of this planet.

use std::f64::consts::TAU;

use gearsim::scene::Scene;

use crate::common;

/// Places of the planets \[deg\]: planets of 36 teeth fit between 27 and 99 teeth at multiples of 360/126 deg.
const PLACES: [f64; 3] = [0.0, 100.0, 240.0];

/// One turn of a planet set with a damaged tooth of the `gear`, from a speed of the sun \[rpm\]. Each mesh is softest once a turn, while the
/// damaged pair is alone in contact. Returns by how much the gear has turned against the carrier between this moment in the mesh of the first
/// planet and in that of each planet \[turns\].
fn turned(gear: &str, rpm: f64) -> Vec<f64> {
    let (mesh, of, held) = if gear == "sun" { ("s", 27, ["ground", "c"]) } else { ("r", 99, ["r", "ground"]) };
    let law = |damage: String| {
        format!("{{ steps = [{{ value = \"300 MN/m\", width = \"2 rad\" }}, {{ value = \"500 MN/m\" }}]{damage} }}")
    };
    let damage = format!(", damage = [{{ tooth = 1, of = {of}, loss = 0.8 }}]");
    let laws = [("sun", "s"), ("ring", "r")].map(|(name, with)| {
        format!("{name}_stiffness = {}\n", law(if with == mesh { damage.clone() } else { String::new() }))
    });
    let [ring, carrier] = held;
    let other = if gear == "sun" { "c" } else { "r" };
    let (torque, load) = (rpm.signum() * 10.0, rpm.signum() * if gear == "sun" { 140.0 / 3.0 } else { 110.0 / 3.0 });
    let load = if gear == "sun" { load } else { -load };
    let text = format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"torques\"]\n[rotors]\nsun = \"2e-3 kg*m^2\"\n\
         {other} = \"0.2 kg*m^2\"\n[planets.p]\nsun = \"sun\"\nring = \"{ring}\"\ncarrier = \"{carrier}\"\nteeth = [27, 99]\n\
         module = \"2 mm\"\nat = [\"{} deg\", \"{} deg\", \"{} deg\"]\nmass = \"0.7 kg\"\ninertia = \"1.6e-3 kg*m^2\"\n{}{}\
         [drives.m]\nrotor = \"sun\"\ntorque = \"{torque} N*m\"\n[loads.l]\nrotor = \"{other}\"\ntorque = \"{load} N*m\"\n\
         [start]\nspeed = \"{rpm} rpm\"\n[run]\nt_end = \"0.7 s\"\n[output]\nrate = \"20 kHz\"\n",
        PLACES[0], PLACES[1], PLACES[2], laws[0], laws[1]
    );
    let scene = Scene::parse("damage", "damage.toml", &text, &[], &common::models())
        .unwrap_or_else(|mistakes| panic!("{}", mistakes.render(100, false)));
    let run = common::run(&scene);
    let column = |name: &str| run.trajectory.output(name).unwrap_or_else(|| panic!("no output `{name}`"));
    let t = &run.trajectory.t;
    let speed = |rotor: &str| match rotor {
        "ground" => vec![0.0; t.len()],
        rotor => column(&format!("rotor_speed_{rotor}")).to_vec(),
    };
    let (own, of_carrier) = (speed(if gear == "sun" { "sun" } else { ring }), speed(carrier));
    let mut angle = vec![0.0; t.len()];
    for i in 1..t.len() {
        let mean = (own[i] - of_carrier[i] + own[i - 1] - of_carrier[i - 1]) / 2.0;
        angle[i] = angle[i - 1] + mean * (t[i] - t[i - 1]);
    }
    // Where the damaged pair is alone: k = 300 MN/m (1 - 0.8). Without damping, k is the force over the deflection.
    let middle = |planet: usize| {
        let (force, deflection) =
            (column(&format!("mesh_force_p_{mesh}{planet}")), column(&format!("mesh_deflection_p_{mesh}{planet}")));
        let soft: Vec<usize> = (0..t.len()).filter(|&i| (force[i] / deflection[i] / 60e6 - 1.0).abs() < 1e-6).collect();
        let first = soft.iter().zip(&soft[1..]).position(|(a, b)| b - a > 100).unwrap_or(soft.len() - 1);
        (angle[soft[0]] + angle[soft[first]]) / 2.0
    };
    (1..=3).map(|planet| (middle(planet) - middle(1)) / TAU).collect()
}

#[test]
fn a_damaged_tooth_meets_one_planet_after_the_other() {
    for gear in ["sun", "ring"] {
        for rpm in [400.0, -400.0] {
            for (turned, place) in turned(gear, rpm).into_iter().zip(PLACES) {
                let apart = turned - place / 360.0;
                assert!((apart - apart.round()).abs() < 1e-3, "{gear} at {rpm} rpm: {turned} turns to {place} deg");
            }
        }
    }
}
