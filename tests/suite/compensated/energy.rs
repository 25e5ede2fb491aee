//! The energy of an undamped gear pair with transmission errors and play, summed in 50 digits.

use gearsim::__private::{Hybrid, Inside};
use gearsim::scene::Scene;
use gearsim_tests::precise::number::Scalar;

use crate::digits::{Digits, exact, in_both, judge, of, scene};

/// T + V - W with T = (theta' + phi')²/(2 a) + (theta' - phi')²/(2 b), a, b = N²/I, V = k touch (phi - edge - e)² and W = 2 T0 phi.
fn energy(scene: &Scene, now: &Hybrid<'_>) -> Digits {
    let parameter =
        |name: &str| exact(scene.parameters[scene.model.parameters.iter().position(|p| p.name == name).unwrap()]);
    let [q, v] = of(&now.state);
    let law = |name: &str| now.laws[scene.model.laws.iter().position(|law| law.name == name).unwrap()].level();
    let [first, second] = [v[0].clone() + v[1].clone(), v[0].clone() - v[1].clone()];
    let per = |n: &str, i: &str| parameter(n) * parameter(n) / parameter(i);
    let kinetic = first.clone() * first / per("N1", "I1") + second.clone() * second / per("N2", "I2");
    let (mut x, mut touch) = (q[1].clone(), 1.0);
    if scene.effects.names(scene.model).contains(&"transmission_error") {
        x = x - exact(law("e"));
    }
    if let [play] = &now.switches[..] {
        // The mode tells which flank is in contact. Its edge is at half the play; halving a number is exact.
        let mode = play.here().name;
        let half = parameter("b").scaled(-1);
        match mode {
            "upper" | "upper_hit" | "upper_loose" => x = x - half,
            "lower" | "lower_hit" | "lower_loose" => x = x + half,
            _ => touch = 0.0,
        }
    }
    let strain = exact(law("k") * touch) * x.clone() * x;
    kinetic.scaled(-1) + strain - (parameter("T0") * q[1].clone()).scaled(1)
}

fn drift(scene: &Scene, least: impl Fn(&Hybrid<'_>) -> bool) -> [f64; 2] {
    let mut begun = scene.clone();
    begun.t_end = 1e-12;
    let entry = crate::common::model(scene.model.name);
    let equations = entry.equations(&begun).unwrap();
    let start = energy(scene, &entry.simulation(&begun, &*equations).unwrap().now);
    in_both(scene, |now| {
        println!("{:?}", now.counts);
        assert!(least(now), "{:?}", now.counts);
        ((energy(scene, now) - start.clone()) / start.clone()).approx().abs()
    })
}

const TEETH: &str = "laws.e={pitch_errors=[\"2e-3 rad\", \"-1e-3 rad\", \"5e-4 rad\", \"0 rad\"]}";

#[test]
fn steps_of_transmission_errors_keep_the_energy() {
    let effects = "effects=[\"stiffness_step\", \"transmission_error\", \"torques\"]";
    let scene = scene("oh2005/energy_300rpm", &[effects, TEETH, "run.t_end=\"0.3 s\"", "start.speed=\"600 rpm\""]);
    judge("errors", drift(&scene, |now| now.counts.cell_changes > 100), 1e3);
}

#[test]
fn play_keeps_the_energy_where_stiffness_and_errors_step() {
    for (effects, more) in [
        ("[\"stiffness_step\", \"backlash\", \"torques\"]", "run.t_end=\"40 ms\""),
        ("[\"stiffness_step\", \"backlash\", \"transmission_error\", \"torques\"]", TEETH),
    ] {
        let scene = scene(
            "backlash",
            &[&format!("effects={effects}"), more, "start.speed=\"3000 rpm\"", "run.t_end=\"40 ms\""],
        );
        let impacts = |now: &Hybrid<'_>| now.counts.impacts > 3 && now.counts.cell_changes > 20;
        judge(&format!("play, {effects}"), drift(&scene, impacts), 1e4);
    }
}
