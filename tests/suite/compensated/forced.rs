//! Torques that vary in time.

use gearsim_tests::precise::number::Scalar;

use crate::digits::{apart, exact, in_both, judge, of, scene};

/// phi'' + w² phi = M2 a cos(W t) from rest: phi = M2 a (cos W t - cos w t)/(w² - W²).
#[test]
fn a_harmonic_torque_has_a_closed_form() {
    let [first, second, stiffness, size, frequency, t] = [2.0, 8.0, 3000.0, 7.0, 40.0, 0.25];
    let scene = scene(
        "oh2005/energy_300rpm",
        &[
            "effects=[\"stiffness_step\", \"torques\"]",
            "parameters.I1=\"2 kg*m^2\"",
            "parameters.I2=\"8 kg*m^2\"",
            "parameters.N1=16",
            "parameters.N2=64",
            "laws.k.steps=[{value=\"3 kN*m\", width=\"1.75 rad\"}, {value=\"3 kN*m\"}]",
            "parameters.T0={harmonics=[{amplitude=\"7 N*m\", frequency=\"40 Hz\"}]}",
            "start={theta=0, theta_dot=\"100 rad/s\", phi=0, phi_dot=0}",
            "run.t_end=\"0.25 s\"",
        ],
    );
    let m2 = (exact(256.0) / exact(first) + exact(4096.0) / exact(second)).scaled(-1);
    let (square, drive) = (m2.clone() * exact(stiffness), exact(std::f64::consts::TAU * frequency));
    let omega = square.root();
    let (s, c) = (omega.clone() * exact(t)).sine_cosine();
    let (sine, cosine) = (drive.clone() * exact(t)).sine_cosine();
    let factor = m2 * exact(size) / (square - drive.clone() * drive.clone());
    let (x, v) = (factor.clone() * (cosine - c), factor.clone() * (omega.clone() * s - drive * sine));
    let sizes = [factor.approx().abs(), (factor * omega).approx().abs()];
    let errors = in_both(&scene, |now| {
        assert!(now.counts.cell_changes > 5);
        let [q, q_dot] = of(&now.state);
        apart(&q[1], &x, sizes[0]).max(apart(&q_dot[1], &v, sizes[1]))
    });
    judge("a harmonic torque", errors, 1e3);
}

/// Without a spring, and with an inertia of 1 kg m², phi'' = T_motor(t). Where the torque rises linearly, phi is a cubic. The torque has
/// breakpoints.
#[test]
fn a_ramp_moves_a_free_rotor_along_a_cubic() {
    let scene = scene(
        "friction_oscillator",
        &[
            "effects=[\"torques\"]",
            "parameters.k=\"0 N*m/rad\"",
            "start.phi=0",
            "parameters.T_motor={table=[{at=\"0 s\", value=\"1 N*m\"}, {at=\"0.7 s\", value=\"3 N*m\"}, {at=\"1.9 s\", value=\"3 N*m\"}]}",
            "run.t_end=\"2 s\"",
        ],
    );
    let (a, t, value) = (exact(0.7), exact(2.0), [exact(1.0), exact(3.0)]);
    let slope = (value[1].clone() - value[0].clone()) / a.clone();
    let six = exact(6.0);
    let first =
        value[0].clone() * a.clone() * a.clone() / exact(2.0) + slope.clone() * a.clone() * a.clone() * a.clone() / six;
    let speed = value[0].clone() * a.clone() + slope * a.clone() * a.clone() / exact(2.0);
    let rest = t - a;
    let x = first + speed.clone() * rest.clone() + value[1].clone() * rest.clone() * rest.clone() / exact(2.0);
    let v = speed + value[1].clone() * rest;
    let errors = in_both(&scene, |now| {
        let [q, q_dot] = of(&now.state);
        apart(&q[0], &x, x.approx()).max(apart(&q_dot[0], &v, v.approx()))
    });
    judge("a ramp", errors, 10.0);
}
