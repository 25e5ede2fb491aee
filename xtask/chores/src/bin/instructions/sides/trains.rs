//! Right-hand sides of trains: a chain of discs, an idler, a planetary stage.

use gearsim::__private::equations::Derived;
use gearsim::__private::models::{Chain5, Idler, Planetary3};

use super::{Side, derived};
use crate::by_hand::trains;

pub fn chain() -> Side<5> {
    let (alpha, beta, k) = (3.0, 1e-4, [1e3, 2e3, 3e3, 4e3]);
    let names = ["k1", "k2", "k3", "k4"];
    let mut numbers = vec![("alpha_M", alpha), ("beta_K", beta), ("T_motor", 5.0), ("T_load", 4.0)];
    numbers.extend(names.into_iter().zip(k));
    let by_hand = trains::Chain { k, c: k.map(|k| beta * k), drag: [alpha; 5], motor: 5.0, load: 4.0 };
    Side {
        generated: derived::<Chain5>("torques damping", &numbers, &[]),
        by_hand: Box::new(by_hand),
        q: [0.1, 0.09, 0.07, 0.06, 0.05],
        q_dot: [10.0, 9.0, 11.0, 10.5, 9.5],
        k: vec![],
        dk: vec![],
    }
}

pub fn idler() -> Side<3> {
    let (n1, n2, n3, r2, i, alpha, beta) = (28.0, 35.0, 56.0, 0.0411, [4e-3, 1.5e-3, 1.2e-2], 3.0, 1e-6);
    let numbers = [
        ("N1", n1),
        ("N2", n2),
        ("N3", n3),
        ("r2", r2),
        ("I1", i[0]),
        ("I2", i[1]),
        ("I3", i[2]),
        ("T_motor", 50.0),
        ("T_load", 100.0),
        ("alpha_M", alpha),
        ("beta_K", beta),
    ];
    let (h, mids) = (r2 / n2, [2.35e8, 2.5e8]);
    let [a, b, c] = [i[0] / (n1 * n1), i[1] / (n2 * n2), i[2] / (n3 * n3)].map(|i| alpha * i);
    let across = [beta * mids[0] + a / (h * h), beta * mids[1] + c / (h * h)];
    let by_hand = trains::Idler {
        c: [a + b + c, a / h, -c / h, across[0], across[1]],
        torque: [50.0 / n1 - 100.0 / n3, 50.0 / (h * n1), 100.0 / (h * n3)],
    };
    Side {
        generated: derived::<Idler>("stiffness_step torques damping", &numbers, &mids),
        by_hand: Box::new(by_hand),
        q: [0.1, 7e-6, 6e-6],
        q_dot: [1800.0, 3e-3, 2e-3],
        k: Idler::MODEL.in_contact([1.8e8, 3.1e8]),
        dk: Idler::MODEL.in_contact([1e6, 2e6]),
    }
}

pub fn planetary() -> Side<6> {
    let (z_s, z_r, r_s, k_r) = (30.0, 90.0, 0.04, 1e8);
    let numbers = [("Z_s", z_s), ("Z_r", z_r), ("r_s", r_s), ("k_r", k_r), ("T_motor", 300.0), ("T_load", 1200.0)];
    let by_hand = trains::Planetary {
        r_r: r_s / z_s * z_r,
        k_r,
        torque: [300.0 * (1.0 / z_s + 1.0 / z_r) - 1200.0 / z_r, 300.0 - 1200.0],
    };
    Side {
        generated: derived::<Planetary3>("stiffness_step torques", &numbers, &[4e8; 6]),
        by_hand: Box::new(by_hand),
        q: [0.1, 2e-5, 1e-5, 7e-6, 6e-6, 5e-6],
        q_dot: [1800.0, 3e-3, 2e-3, 1e-3, 2e-3, 3e-3],
        k: Planetary3::MODEL.in_contact([3.5e8, 6e8, 3.6e8, 5e8, 4e8, 4.5e8]),
        dk: Planetary3::MODEL.in_contact([1e6, 2e6, 3e6, 4e6, 5e6, 6e6]),
    }
}
