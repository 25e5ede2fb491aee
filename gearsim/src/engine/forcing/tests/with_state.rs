//! Parameters whose factors depend on the state, against the equations with the value that the parameter has at the time.

use super::*;
use crate::engine::equations::Equations;
use crate::engine::vector::Vector;

/// Each parameter, its time history, and its value at 0.4 s.
const VARYING: [(&str, &str, &str, f64); 3] = [
    ("traction_motor", "d_motor", "{ramp={from=-0.2, to=0.8, duration=\"1 s\"}}", 0.2),
    ("induction_motor", "Tb_motor", "{table=[{at=0, value=\"50 kN*m\"}, {at=\"1 s\", value=\"25 kN*m\"}]}", 40e3),
    (
        "fan_load",
        "cf_load",
        "{mean=\"1e-3 kg*m^2\", harmonics=[{amplitude=\"5e-4 kg*m^2\", frequency=\"1.25 Hz\"}]}",
        5e-4,
    ),
];

fn varying(effect: &str, parameter: &str, history: &str) -> Scene {
    scene(&[
        &format!("effects=[\"stiffness_step\", \"damping\", \"torques\", \"{effect}\"]"),
        "parameters={I1=\"2890 kg*mm^2\", I2=\"740200 kg*mm^2\", T0=\"10 N*m\", zeta=0.1, Tp_motor=\"250 N*m\", Pp_motor=\"50 kW\", \
         sb_motor=0.1, ns_motor=\"120 rad/s\"}",
        &format!("parameters.{parameter}={history}"),
    ])
}

#[test]
fn forces_jacobian_and_powers_are_those_of_the_present_value() {
    for (effect, parameter, history, value) in VARYING {
        let scene = varying(effect, parameter, history);
        let derived = DerivedModel::of::<GearPair>();
        let equations = derived.equations(&scene).unwrap();
        let forcing = Forcing::of(&derived, &scene).unwrap();
        let mut present = scene.clone();
        present.parameters[scene.model.parameters.iter().position(|p| p.name == parameter).unwrap()] = value;
        let expected = derived.equations(&present).unwrap();
        let (q, q_dot) = (Vector::from([0.3, 0.02]), Vector::from([2900.0, -35.0]));
        let k = scene.model.in_contact(scene.mids());
        let (dk, ddk) = (vec![0.5; k.len()], vec![0.25; k.len()]);
        let at = (&q[..], &q_dot[..], &k[..], &dk[..]);
        let of = |e: &dyn Equations| (e.force(&q, &q_dot, &k, &dk), e.jacobian(&q, &q_dot, &k, &dk, &ddk));
        let ((at_start, slopes_at_start), (force, slopes)) = (of(&*equations), of(&*expected));
        let (mut sum, mut jacobian) = (at_start.clone(), slopes_at_start.clone());
        forcing.add_force(0.4, at, &mut sum);
        forcing.add_jacobian(0.4, at, &ddk, &mut jacobian);
        assert!((&force - &at_start).amax() > 1e-6 * force.amax(), "{parameter} has no effect");
        assert!((&sum - &force).amax() < 1e-15 * force.amax().max(at_start.amax()), "{parameter}: {sum:?} {force:?}");
        assert!((&slopes[1] - &slopes_at_start[1]).amax() > 0.0, "{parameter} has no slope");
        for (sum, expected) in jacobian.iter().zip(&slopes) {
            assert!((sum - expected).amax() < 1e-14 * expected.amax().max(1e-300), "{parameter}: {sum} {expected}");
        }
        let power = |e: &dyn Equations, i: usize| e.torque_work(i, &q_dot) + e.torque_power(i, &q, &q_dot, &k);
        let torques = scene.torques();
        let further = forcing.all_power(0.4, at, &*equations, &torques);
        for (&i, further) in torques.iter().zip(further) {
            let (at_start, expected) = (power(&*equations, i), power(&*expected, i));
            assert!(
                (at_start + further - expected).abs() < 1e-14 * at_start.abs().max(expected.abs()),
                "{parameter} {i}"
            );
        }
    }
}
