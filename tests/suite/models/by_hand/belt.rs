//! A belt drive with a tensioner.

use gearsim::__private::models::BeltDrive;

use super::{ByHand, compare, of, with};

pub fn drive() {
    let numbers = with(
        &[
            ("r1", 0.9),
            ("r2", 0.4),
            ("a", 1.3),
            ("I1", 0.4),
            ("I2", 0.8),
            ("I_t", 0.3),
            ("k_p", 5.7),
            ("k_s", 4.9),
            ("k_t", 1.9),
        ],
        &[("T_crank", 0.0), ("T_load", 0.0)],
    );
    let p = of(&numbers);
    let by_hand = ByHand {
        inertia: ["I1", "I2", "I_t"].map(&p).to_vec(),
        springs: vec![
            (p("k_p"), vec![(0, p("r1")), (1, -p("r2"))]),
            (p("k_s"), vec![(0, -p("r1")), (1, p("r2")), (2, p("a"))]),
            (p("k_t"), vec![(2, 1.0)]),
        ],
    };
    compare::<BeltDrive>(&numbers, &by_hand, |q| vec![q("theta"), (p("r1") * q("theta") - q("s")) / p("r2"), q("psi")]);
}
