//! A torsional chain of n discs on a shaft.

use gearsim_derive::{Expr, Model, Start};

use crate::components::{damping, driven, loaded, rotor, shaft};

/// `n` discs, driven at the first and loaded at the last. Coordinates: the rotations of the discs.
pub fn chain(m: &mut Model, n: usize) {
    m.title(&format!("a torsional chain of {n} discs"));
    m.source("e.g. Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9");

    let theta: Vec<Expr> = (1..=n)
        .map(|i| {
            let start = if i == 1 { Start::At(0.0) } else { Start::Static };
            m.coordinate(&format!("theta{i}"), "rad", start, &format!("rotation of disc {i}"))
        })
        .collect();
    for (i, theta) in (1..).zip(&theta) {
        rotor(m, &i.to_string(), &format!("disc {i}"), *theta);
    }
    for (i, ends) in (1..).zip(theta.windows(2)) {
        shaft(m, &i.to_string(), &format!("shaft between discs {i} and {}", i + 1), ends[0] - ends[1], ends[0]);
    }
    driven(m, "motor", "first disc", theta[0]);
    loaded(m, "load", "last disc", theta[n - 1]);
    damping(m);
    let speeds: Vec<_> = theta.iter().map(|theta| (*theta, 1.into())).collect();
    m.motion("speed", "rad/s", &speeds, "rotational speed of the shaft");
}
