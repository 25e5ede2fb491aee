//! Chains of 2, 5 and 32 discs, each coupled to the next by a shaft.

use gearsim::__private::equations::Derived;
use gearsim::__private::models::{Chain2, Chain5, Chain32};

use super::{ByHand, TORQUES, compare, of, twist};

pub fn discs() {
    fn check<D: Derived>(n: usize) {
        let number = |name: &str, i: usize| (&*format!("{name}{i}").leak(), 1.0 + 0.1 * (i % 7) as f64);
        let mut numbers: Vec<(&'static str, f64)> = (1..=n).map(|i| number("I", i)).collect();
        numbers.extend((1..n).map(|i| number("k", i)));
        numbers.extend(TORQUES);
        let p = of(&numbers);
        let by_hand = ByHand {
            inertia: (1..=n).map(|i| p(&format!("I{i}"))).collect(),
            springs: (1..n).map(|i| twist(p(&format!("k{i}")), i - 1, i)).collect(),
        };
        compare::<D>(&numbers, &by_hand, |q| (1..=n).map(|i| q(&format!("theta{i}"))).collect());
    }
    check::<Chain2>(2);
    check::<Chain5>(5);
    check::<Chain32>(32);
}
