//! One gear pair: with shafts and rotors, and on bearings.

use gearsim::__private::models::{GearPairBearings, GearPairShafts};

use super::{ByHand, TORQUES, compare, of, pair, twist, with};

pub fn shafts() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("r1", 0.7),
            ("I_m", 0.9),
            ("I1", 0.4),
            ("I2", 1.7),
            ("I_l", 2.3),
            ("k_m", 3.1),
            ("k_l", 4.3),
            ("k12", 5.7),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let r2 = p("r1") * p("N2") / p("N1");
    let by_hand = ByHand {
        inertia: vec![p("I_m"), p("I1"), p("I2"), p("I_l")],
        springs: vec![twist(p("k_m"), 0, 1), (p("k12"), vec![(1, p("r1")), (2, -r2)]), twist(p("k_l"), 2, 3)],
    };
    compare::<GearPairShafts>(&numbers, &by_hand, |q| {
        let (theta1, theta2) = pair(q("theta"), q("s"), p("N1"), p("N2"), p("r1"));
        vec![theta1 + q("psi_m"), theta1, theta2, theta2 - q("psi_l")]
    });
}

pub fn bearings() {
    let alpha = 0.41f64;
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("r1", 0.7),
            ("I1", 0.4),
            ("I2", 1.7),
            ("m1", 1.3),
            ("m2", 2.9),
            ("kb1", 3.7),
            ("kb2", 6.1),
            ("k12", 5.7),
            ("alpha", 0.41),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let r2 = p("r1") * p("N2") / p("N1");
    let mesh = vec![(0, alpha.sin()), (1, alpha.cos()), (2, p("r1")), (3, -alpha.sin()), (4, -alpha.cos()), (5, -r2)];
    let by_hand = ByHand {
        inertia: vec![p("m1"), p("m1"), p("I1"), p("m2"), p("m2"), p("I2")],
        springs: [(p("k12"), mesh)]
            .into_iter()
            .chain([(0, "kb1"), (1, "kb1"), (3, "kb2"), (4, "kb2")].map(|(i, kb)| (p(kb), vec![(i, 1.0)])))
            .collect(),
    };
    compare::<GearPairBearings>(&numbers, &by_hand, |q| {
        let (theta1, theta2) = pair(q("theta"), q("s"), p("N1"), p("N2"), p("r1"));
        vec![q("x1"), q("y1"), theta1, q("x2"), q("y2"), theta2]
    });
}
