//! Planetary stages with 3 to 7 planets; torsion only.

use gearsim::__private::equations::Derived;
use gearsim::__private::models::{Planetary3, Planetary4, Planetary5, Planetary6, Planetary7};

use super::stage::{FURTHER, STAGE, SUPPORTS, radii, rotations};
use super::{ByHand, TORQUES, compare_with, of, with};

pub fn stages() {
    fn check<D: Derived>(n: usize) {
        [&[][..], &["torsional_support_s"], &["torsional_support"]].into_iter().for_each(|held| stage::<D>(n, held));
    }
    fn stage<D: Derived>(n: usize, held: &[&str]) {
        let numbers = with(STAGE, &[&TORQUES, &SUPPORTS[..], &FURTHER[..2 * (n - 3)]].concat());
        let p = of(&numbers);
        let [r_s, r_p, r_r, a] = radii(&p);
        // Sun, carrier, ring, planets. The masses of the planets add to the inertia of the carrier.
        // r_s + r_p = r_r - r_p = a cos(alpha).
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
        compare_with::<D>(held, &numbers, &by_hand, |q| {
            let (sun, carrier, planet) = rotations(&p, q("theta"), q("theta_c"));
            let planets = (1..=n).map(|i| planet(q(&format!("u{i}"))));
            [sun, carrier, q("theta_r")].into_iter().chain(planets).collect()
        });
    }
    check::<Planetary3>(3);
    check::<Planetary4>(4);
    check::<Planetary5>(5);
    check::<Planetary6>(6);
    check::<Planetary7>(7);
}
