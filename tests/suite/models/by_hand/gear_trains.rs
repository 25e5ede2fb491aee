//! Several gears in series or in parallel: two driven shafts, two stages, an idler between two gears.

use gearsim::__private::models::{GearedBranches, Idler, TwoStage};

use super::{ByHand, TORQUES, compare, of, pair, twist, with};

pub fn branches() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("I_m", 0.9),
            ("I1", 0.4),
            ("I2", 1.7),
            ("I_a", 2.3),
            ("I_b", 1.1),
            ("k_m", 3.1),
            ("k_a", 4.3),
            ("k_b", 5.7),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    // The inertia of the second gear is referred to the first shaft by the square of the ratio.
    let ratio = p("N1") / p("N2");
    let by_hand = ByHand {
        inertia: vec![p("I_m"), p("I1") + p("I2") * ratio * ratio, p("I_a"), p("I_b")],
        springs: vec![twist(p("k_m"), 0, 1), twist(p("k_a"), 1, 2), (p("k_b"), vec![(1, ratio), (3, -1.0)])],
    };
    compare::<GearedBranches>(&numbers, &by_hand, |q| ["theta_m", "theta1", "theta_a", "theta_b"].map(q).to_vec());
}

pub fn two_stages() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 67.0),
            ("r1", 0.7),
            ("N3", 19.0),
            ("N4", 71.0),
            ("r3", 0.9),
            ("I_m", 0.9),
            ("I1", 0.4),
            ("I2", 1.7),
            ("I3", 0.6),
            ("I4", 2.1),
            ("I_l", 2.3),
            ("k_m", 3.1),
            ("k_c", 7.3),
            ("k_l", 4.3),
            ("k12", 5.7),
            ("k34", 6.7),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let (r2, r4) = (p("r1") * p("N2") / p("N1"), p("r3") * p("N4") / p("N3"));
    let by_hand = ByHand {
        inertia: ["I_m", "I1", "I2", "I3", "I4", "I_l"].map(&p).to_vec(),
        springs: vec![
            twist(p("k_m"), 0, 1),
            (p("k12"), vec![(1, p("r1")), (2, -r2)]),
            twist(p("k_c"), 2, 3),
            (p("k34"), vec![(3, p("r3")), (4, -r4)]),
            twist(p("k_l"), 4, 5),
        ],
    };
    compare::<TwoStage>(&numbers, &by_hand, |q| {
        let (theta1, theta2) = pair(q("theta1"), q("s1"), p("N1"), p("N2"), p("r1"));
        let (theta3, theta4) = pair(q("theta2"), q("s2"), p("N3"), p("N4"), p("r3"));
        vec![theta1 + q("psi_m"), theta1, theta2, theta3, theta4, theta4 - q("psi_l")]
    });
}

pub fn idlers() {
    let numbers = with(
        &[
            ("N1", 23.0),
            ("N2", 31.0),
            ("N3", 67.0),
            ("r2", 0.7),
            ("I1", 0.4),
            ("I2", 0.8),
            ("I3", 1.7),
            ("k12", 5.7),
            ("k23", 4.9),
        ],
        &TORQUES,
    );
    let p = of(&numbers);
    let r = ["N1", "N2", "N3"].map(|teeth| p("r2") * p(teeth) / p("N2"));
    let by_hand = ByHand {
        inertia: ["I1", "I2", "I3"].map(&p).to_vec(),
        springs: vec![(p("k12"), vec![(0, r[0]), (1, -r[1])]), (p("k23"), vec![(1, r[1]), (2, -r[2])])],
    };
    compare::<Idler>(&numbers, &by_hand, |q| {
        let theta2 = q("theta") / p("N2");
        vec![(r[1] * theta2 + q("delta1")) / r[0], theta2, (r[1] * theta2 - q("delta2")) / r[2]]
    });
}
