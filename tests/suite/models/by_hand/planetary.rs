//! Torsional planetary stages: the derived model with 3 planets, and trains with 1 to 7.

use gearsim::__private::models::Planetary3;
use gearsim::Scene;

use super::stage::{FURTHER, STAGE, SUPPORTS, radii, rotations};
use super::{ByHand, TORQUES, assert_frequencies, compare_with, of, with};

/// Supports of neither sun nor carrier, of the sun, of both.
const HELD: [&[&str]; 3] = [&[], &["torsional_support_s"], &["torsional_support"]];

/// A stage with `n` planets. Coordinates: the rotations of sun, carrier, ring, planets.
fn stage(p: &impl Fn(&str) -> f64, n: usize, held: &[&str]) -> ByHand {
    let [r_s, r_p, r_r, a] = radii(p);
    // The masses of the planets add to the inertia of the carrier. r_s + r_p = r_r - r_p = a cos(alpha).
    let mut by_hand = ByHand {
        inertia: vec![p("I_s"), p("I_c") + n as f64 * p("m_p") * a * a, p("I_r")],
        springs: vec![(p("k_r"), vec![(2, 1.0)])],
    };
    let [sun, carrier] = [!held.is_empty(), held == ["torsional_support"]];
    by_hand.springs.extend(sun.then(|| (p("k_s"), vec![(0, 1.0)])));
    by_hand.springs.extend(carrier.then(|| (p("k_c"), vec![(1, 1.0)])));
    for i in 0..n {
        by_hand.inertia.push(p("I_p"));
        let (sun, ring) = (p(&format!("k_s{}", i + 1)), p(&format!("k_r{}", i + 1)));
        by_hand.springs.push((sun, vec![(0, r_s), (3 + i, r_p), (1, -(r_s + r_p))]));
        by_hand.springs.push((ring, vec![(2, r_r), (3 + i, -r_p), (1, -(r_r - r_p))]));
    }
    by_hand
}

/// Energies and frequencies of the derived model.
pub fn derived() {
    for held in HELD {
        let numbers = with(STAGE, &[&TORQUES[..], &SUPPORTS].concat());
        let p = of(&numbers);
        compare_with::<Planetary3>(held, &numbers, &stage(&p, 3, held), |q| {
            let (sun, carrier, planet) = rotations(&p, q("theta"), q("theta_c"));
            let planets = (1..=3).map(|i| planet(q(&format!("u{i}"))));
            [sun, carrier, q("theta_r")].into_iter().chain(planets).collect()
        });
    }
}

/// Frequencies of trains.
pub fn trains() {
    let numbers = with(STAGE, &[&SUPPORTS[..], &FURTHER].concat());
    let p = of(&numbers);
    for (n, held) in (1..=7).flat_map(|n| HELD.map(|held| (n, held))) {
        let mut text = format!(
            "model = \"train\"\neffects = []\n[rotors]\ns = \"{} kg*m^2\"\nc = \"{} kg*m^2\"\nr = \"{} kg*m^2\"\n\
             [planets.p]\nsun = \"s\"\ncarrier = \"c\"\nring = \"r\"\ncount = {n}\nteeth = [{}, {}]\nbase_radius = \"{} m\"\n\
             pressure_angle = \"{} rad\"\nmass = \"{} kg\"\ninertia = \"{} kg*m^2\"\n",
            p("I_s"),
            p("I_c"),
            p("I_r"),
            p("Z_s"),
            p("Z_r"),
            p("r_s"),
            p("alpha"),
            p("m_p"),
            p("I_p"),
        );
        let supports = [("r", true), ("s", !held.is_empty()), ("c", held == ["torsional_support"])];
        for (rotor, _) in supports.iter().filter(|support| support.1) {
            text += &format!(
                "[supports.{rotor}]\nrotor = \"{rotor}\"\nstiffness = \"{} N*m/rad\"\n",
                p(&format!("k_{rotor}"))
            );
        }
        text += "[laws]\n";
        for mesh in (1..=n).flat_map(|i| [format!("s{i}"), format!("r{i}")]) {
            text += &format!("k_p_{mesh} = {{ steps = [{{ value = \"{} N/m\" }}] }}\n", p(&format!("k_{mesh}")));
        }
        let scene = Scene::from_toml("stage", &text).unwrap_or_else(|e| panic!("{e}"));
        let modes = scene.modes().expect("a linear cell").modes;
        let found: Vec<f64> = modes.iter().map(|mode| mode.natural).collect();
        assert_frequencies(&format!("train of {n} planets"), &found, &stage(&p, n, held));
    }
}
