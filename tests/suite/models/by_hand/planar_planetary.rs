//! Planetary stages with 3 to 5 planets whose bodies also move in the plane.

use gearsim::__private::equations::Derived;
use gearsim::__private::models::{PlanarPlanetary3, PlanarPlanetary4, PlanarPlanetary5};

use super::stage::{FURTHER, STAGE, SUPPORTS, radii, rotations};
use super::{ByHand, TORQUES, compare_with, of, with};

const PLANE: [(&str, f64); 7] =
    [("m_s", 1.3), ("m_c", 4.1), ("m_r", 3.3), ("kb_s", 7.1), ("kb_c", 7.3), ("kb_r", 7.7), ("kb_p", 8.3)];

/// Eqs. (1)-(5) of Lin & Parker as printed, in absolute coordinates: x, y, u of sun, carrier and ring; zeta, eta, u of each
/// planet; u = r theta. Each mesh and each bearing is a spring.
pub fn stages() {
    fn check<D: Derived>(n: usize) {
        [&[][..], &["torsional_support_s"], &["torsional_support"]].into_iter().for_each(|held| stage::<D>(n, held));
    }
    fn stage<D: Derived>(n: usize, held: &[&str]) {
        // The planets are not evenly spaced.
        let places = [("psi1", 0.0), ("psi2", 1.1), ("psi3", 2.9), ("psi4", 4.4), ("psi5", 5.2)];
        let numbers =
            with(STAGE, &[&TORQUES, &SUPPORTS[..], &PLANE[..], &places[..n], &FURTHER[..2 * (n - 3)]].concat());
        let p = of(&numbers);
        let [r_s, r_p, r_r, a] = radii(&p);
        let (sin, cos) = p("alpha").sin_cos();
        let (s, c, r) = (0, 3, 6);
        let bodies = [("m_s", "I_s", r_s), ("m_c", "I_c", a), ("m_r", "I_r", r_r)];
        let mut by_hand = ByHand {
            inertia: bodies.iter().flat_map(|(m, i, r)| [p(m), p(m), p(i) / (r * r)]).collect(),
            springs: vec![(p("k_r") / (r_r * r_r), vec![(r + 2, 1.0)])],
        };
        let [on_sun, on_carrier] = [!held.is_empty(), held == ["torsional_support"]];
        by_hand.springs.extend(on_sun.then(|| (p("k_s") / (r_s * r_s), vec![(s + 2, 1.0)])));
        by_hand.springs.extend(on_carrier.then(|| (p("k_c") / (a * a), vec![(c + 2, 1.0)])));
        for (body, kb) in [(s, "kb_s"), (c, "kb_c"), (r, "kb_r")] {
            by_hand.springs.extend([(p(kb), vec![(body, 1.0)]), (p(kb), vec![(body + 1, 1.0)])]);
        }
        for (i, &(_, psi)) in places.iter().take(n).enumerate() {
            let at = 9 + 3 * i;
            let (psi_s, psi_r) = (psi - p("alpha"), psi + p("alpha"));
            by_hand.inertia.extend([p("m_p"), p("m_p"), p("I_p") / (r_p * r_p)]);
            let planet = |zeta, eta, u| [(at, zeta), (at + 1, eta), (at + 2, u)];
            let central = |body, psi: f64, u| [(body, -psi.sin()), (body + 1, psi.cos()), (body + 2, u)];
            let sun = [central(s, psi_s, 1.0), planet(-sin, -cos, 1.0)].concat();
            let ring = [central(r, psi_r, 1.0), planet(sin, -cos, -1.0)].concat();
            let tangential = [central(c, psi, 1.0), planet(0.0, -1.0, 0.0)].concat();
            let radial = vec![(c, psi.cos()), (c + 1, psi.sin()), (at, -1.0)];
            let (k_s, k_r) = (p(&format!("k_s{}", i + 1)), p(&format!("k_r{}", i + 1)));
            by_hand.springs.extend([(k_s, sun), (k_r, ring), (p("kb_p"), radial), (p("kb_p"), tangential)]);
        }
        compare_with::<D>(held, &numbers, &by_hand, |q| {
            let (sun, carrier, planet) = rotations(&p, q("theta"), q("theta_c"));
            let mut x = vec![q("x_s"), q("y_s"), r_s * sun, q("x_c"), q("y_c"), a * carrier];
            x.extend([q("x_r"), q("y_r"), r_r * q("theta_r")]);
            for i in 1..=n {
                let [zeta, eta, u] = ["zeta", "eta", "u"].map(|name| q(&format!("{name}{i}")));
                x.extend([zeta, a * carrier + eta, r_p * planet(u)]);
            }
            x
        });
    }
    check::<PlanarPlanetary3>(3);
    check::<PlanarPlanetary4>(4);
    check::<PlanarPlanetary5>(5);
}
