//! A wind turbine: a planetary stage with a fixed ring, then a gear pair.

use gearsim::__private::models::WindTurbine;

use super::stage::{STAGE, radii, rotations};
use super::{ByHand, compare, of, pair, twist};

pub fn turbine() {
    let of_stage: Vec<_> = STAGE.iter().copied().filter(|n| !["I_r", "k_r"].contains(&n.0)).collect();
    let more = [
        ("N1", 83.0),
        ("N2", 19.0),
        ("r1", 1.1),
        ("I_b", 9.7),
        ("I1", 1.9),
        ("I2", 0.5),
        ("I_g", 1.3),
        ("k_l", 8.7),
        ("k_i", 7.9),
        ("k_h", 4.7),
        ("k12", 5.9),
        ("T_wind", 0.0),
        ("T_generator", 0.0),
    ];
    let numbers = [&of_stage[..], &more].concat();
    let p = of(&numbers);
    let [r_s, r_p, r_r, a] = radii(&p);
    let r2 = p("r1") * p("N2") / p("N1");
    // Blades, carrier, sun, wheel, pinion, generator, planets.
    let mut by_hand = ByHand {
        inertia: vec![p("I_b"), p("I_c") + 3.0 * p("m_p") * a * a, p("I_s"), p("I1"), p("I2"), p("I_g")],
        springs: vec![
            twist(p("k_l"), 0, 1),
            twist(p("k_i"), 2, 3),
            (p("k12"), vec![(3, p("r1")), (4, -r2)]),
            twist(p("k_h"), 4, 5),
        ],
    };
    for i in 0..3 {
        by_hand.inertia.push(p("I_p"));
        let (sun, ring) = (p(&format!("k_s{}", i + 1)), p(&format!("k_r{}", i + 1)));
        by_hand.springs.push((sun, vec![(2, r_s), (6 + i, r_p), (1, -(r_s + r_p))]));
        by_hand.springs.push((ring, vec![(6 + i, -r_p), (1, -(r_r - r_p))]));
    }
    compare::<WindTurbine>(&numbers, &by_hand, |q| {
        let (sun, carrier, planet) = rotations(&p, q("theta"), q("theta_c"));
        let (wheel, pinion) = pair(q("theta2"), q("s2"), p("N1"), p("N2"), p("r1"));
        let x = [carrier + q("psi_l"), carrier, sun, wheel, pinion, pinion - q("psi_h")];
        x.into_iter().chain((1..=3).map(|i| planet(q(&format!("u{i}"))))).collect()
    });
}
