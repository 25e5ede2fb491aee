//! A damaged tooth of a sun or a ring meets the planets with the speed of its gear relative to the carrier. This speed is the distance of
//! its sidebands.

use super::*;
use crate::scene::Scene;

/// A planet set with three planets and a shaft behind its carrier. `sun_damage` and `ring_damage` end the laws of stiffness; each may state a
/// damaged tooth. The sun has 29 teeth and the ring 97. These numbers have no common factor, so that the sidebands of the sun and of the ring have
/// different orders.
fn scene([sun_damage, ring_damage]: [&str; 2]) -> Scene {
    let law = |levels: [u32; 2], damage: &str| {
        let [low, high] = levels;
        format!(
            "{{ steps = [{{ value = \"{low} MN/m\", width = \"2 rad\" }}, {{ value = \"{high} MN/m\" }}]{damage} }}"
        )
    };
    let (sun, ring) = (law([300, 330], sun_damage), law([400, 430], ring_damage));
    let text = format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"damping\", \"torques\"]\n[rotors]\nsun = \"2e-3 kg*m^2\"\n\
         c = \"0.05 kg*m^2\"\nout = \"2 kg*m^2\"\n[planets.p]\nsun = \"sun\"\nring = \"ground\"\ncarrier = \"c\"\n\
         teeth = [29, 97]\ncount = 3\nmodule = \"2 mm\"\nmass = \"0.7 kg\"\ninertia = \"1.6e-3 kg*m^2\"\n\
         sun_stiffness = {sun}\nring_stiffness = {ring}\n[shafts.s]\nbetween = [\"c\", \"out\"]\nstiffness = \"0.5 MN*m/rad\"\n\
         [drives.m]\nrotor = \"sun\"\ntorque = \"50 N*m\"\n[loads.l]\nrotor = \"out\"\ntorque = \"{} N*m\"\n[parameters]\n\
         beta_K = \"20 us\"\n[start]\nspeed = \"600 rpm\"\n[run]\nt_end = \"4 s\"\n[output]\nrate = \"20 kHz\"\n",
        50.0 * 126.0 / 29.0
    );
    Scene::from_toml("sidebands", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// The largest sidebands of an output: rotor, distance in turns of it, and frequency [Hz], the largest first.
fn largest(lines: &Lines, output: &str) -> Vec<(&'static str, i32, f64)> {
    let output = *lines.outputs.iter().find(|known| known.name == output).unwrap();
    let all = lines.largest(output, usize::MAX).into_iter();
    all.filter_map(|Listed { line, .. }| Some((line.rotor?, line.sideband, line.frequency))).collect()
}

/// At 600 rpm of the sun the carrier turns with 10 Hz 29/126, and the mesh frequency is 97 times that. A tooth of the sun meets each planet
/// (10 - 10 29/126) Hz = 7.698 times a second, and a planet three times as often; a tooth of the ring 10 Hz 29/126 = 2.302 times.
#[test]
fn sidebands_of_a_planet_set_are_those_of_speeds_relative_to_the_carrier() {
    let damage = |of: u32| format!(", damage = [{{ tooth = 1, of = {of}, loss = 0.8 }}]");
    let cases = [
        ([&damage(29), ""], "mesh_force_p_s1", "rotor_speed_sun - rotor_speed_c", 97.0),
        (["", &damage(97)], "mesh_force_p_r1", "rotor_speed_c", 29.0),
    ];
    for (damages, force, gear, teeth_of_other) in cases {
        let scene = scene(damages);
        let run = scene.run().unwrap().outcome.trajectory;
        let lines = Lines::of(&run, &scene.output.spectrum).unwrap().unwrap();
        let apart = 10.0 * teeth_of_other / 126.0;
        // In the sum over the three planets only multiples of three passages remain.
        for (output, step) in [(force, 1.0), ("shaft_torque_s", 3.0)] {
            let found = largest(&lines, output);
            // A window of 4 s does not separate the tenth sideband of the ring from the third of the sun: they are 0.1 Hz apart.
            let named = found[..4].iter().filter(|(rotor, ..)| *rotor == gear).count();
            assert!(named >= 3, "{output}: {found:?}");
            for (.., frequency) in &found[..4] {
                let multiples = frequency / (step * apart);
                let off = (multiples - multiples.round()).abs() * step * apart;
                assert!(off < 0.1, "{output}: {multiples} times {step} x {apart} Hz");
            }
        }
    }
}

/// Teeth of the gears relative to the carrier, in trains and in a stage that is derived as a whole.
#[test]
fn gears_of_planet_sets_turn_relative_to_the_carrier() {
    let derived = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/planetary_3.toml");
    for (scene, names, [sun, ring, planet]) in [
        (
            scene(["", ""]),
            ["rotor_speed_sun - rotor_speed_c", "rotor_speed_c", "rotor_speed_p_1 - rotor_speed_c"],
            [29.0, 97.0, 34.0],
        ),
        (
            Scene::load(derived).unwrap(),
            ["rotor_speed_s - rotor_speed_c", "rotor_speed_r - rotor_speed_c", "planets - rotor_speed_c"],
            [27.0, 99.0, 36.0],
        ),
    ] {
        let run = scene.run().unwrap().outcome.trajectory;
        let mesh = &meshes(&run, 0.0)[0];
        let found: Vec<_> = mesh.rotors.iter().map(|rotor| (rotor.name, rotor.teeth, rotor.meets)).collect();
        assert_eq!(found, [(names[0], sun, 3), (names[1], ring, 3), (names[2], planet, 2)]);
        for rotor in &mesh.rotors {
            assert!((rotor.frequency * rotor.teeth / mesh.frequency - 1.0).abs() < 1e-3, "{rotor:?}");
        }
    }
}
