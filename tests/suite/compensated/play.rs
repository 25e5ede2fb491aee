//! A rotor between the flanks of its play: half vibrations in contact, free flights between them.

use gearsim_tests::precise::number::Scalar;

use crate::digits::{Digits, apart, exact, floor, in_both, judge, of, pi, scene};

/// phi and phi' after the time `t` from rest at `phi`.
fn closed_form([inertia, stiffness, play, phi, t]: [f64; 5]) -> [Digits; 2] {
    let omega = (exact(stiffness) / exact(inertia)).root();
    let edge = exact(play).scaled(-1);
    let size = exact(phi) - edge.clone();
    let speed = size.clone() * omega.clone();
    let (quarter, free) = (pi().scaled(-1) / omega.clone(), exact(play) / speed.clone());
    let half = quarter.scaled(1) + free.clone();
    let halves = floor(&(exact(t) / half.clone()));
    // Each half is the mirror image of the one before.
    let mut s = exact(t) - half.clone() * exact(halves);
    let sign = exact(if halves % 2.0 == 0.0 { 1.0 } else { -1.0 });
    let (x, v) = if s <= quarter {
        let (sine, cosine) = (omega * s).sine_cosine();
        (edge + size * cosine, -speed * sine)
    } else if s <= quarter.clone() + free.clone() {
        (edge - speed.clone() * (s - quarter), -speed)
    } else {
        s = s - quarter - free;
        let (sine, cosine) = (omega * s).sine_cosine();
        (-edge - size * sine, -speed * cosine)
    };
    [sign.clone() * x, sign * v]
}

#[test]
fn a_rotor_between_its_flanks_has_a_closed_form() {
    let [inertia, stiffness, play, phi] = [5.0, 2e4, 0.75, 1.5];
    for t in [0.02, 0.04, 0.3, 1.0, 20.0] {
        let scene = scene(
            "backlash_oscillator",
            &[
                "effects=[\"backlash\"]",
                "parameters.b=\"0.75 rad\"",
                "start.phi=\"1.5 rad\"",
                &format!("run.t_end=\"{t:?} s\""),
                "output.rate=\"100 Hz\"",
            ],
        );
        let [x, v] = closed_form([inertia, stiffness, play, phi, t]);
        let size = phi * (stiffness / inertia).sqrt();
        let errors = in_both(&scene, |now| {
            let [q, q_dot] = of(&now.state);
            apart(&q[0], &x, phi).max(apart(&q_dot[0], &v, size))
        });
        judge(&format!("play, t = {t} s"), errors, 100.0 * (1.0 + 100.0 * t));
    }
}

/// A damped rotor that starts in contact with a flank moves as the closed form says.
#[test]
fn a_damped_rotor_in_contact_follows_the_closed_form() {
    // The motion is a damped vibration until the contact force would pull. The run ends before this.
    let [inertia, stiffness, damping, play, phi] = [5.0, 2e4, 50.0, 0.75, 1.5];
    let t = 0.015;
    let scene = scene(
        "backlash_oscillator",
        &["parameters.b=\"0.75 rad\"", "start.phi=\"1.5 rad\"", "run.t_end=\"15 ms\"", "output.rate=\"100 Hz\""],
    );
    let sigma = exact(damping).scaled(-1) / exact(inertia);
    let omega = (exact(stiffness) / exact(inertia) - sigma.clone() * sigma.clone()).root();
    let size = exact(phi) - exact(play).scaled(-1);
    let (sine, cosine) = (omega.clone() * exact(t)).sine_cosine();
    let decay = (-(sigma.clone() * exact(t))).exponential();
    let x = exact(play).scaled(-1) + size * decay * (cosine + sigma / omega * sine);
    let errors = in_both(&scene, |now| apart(&of(&now.state)[0][0], &x, phi));
    judge("a damped flank", errors, 100.0);
}
