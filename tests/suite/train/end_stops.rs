//! End stops of trains: a rotor on a spring against the derived model, and a gear that turns through many pitches before it meets its stop.

use gearsim::{Results, Scene};

use crate::common;
use crate::same::difference;

fn run(text: &str) -> Results {
    Scene::from_toml("stops", text).unwrap_or_else(|e| panic!("{e}")).run().unwrap_or_else(|e| panic!("{e}"))
}

const STOPS: &str = "upper = \"6 deg\"\nlower = \"-2 deg\"\nstiffness = \"900 N*m/rad\"\ndamping = \"3 N*m*s/rad\"\n";

/// A rotor on a spring whose speed takes it beyond both stops.
#[test]
fn a_rotor_meets_its_stops_as_the_derived_model() {
    let effects = "\"end_stop\", \"torques\"";
    let rest = "[run]\nt_end = \"0.6 s\"\nmethod = \"METHOD\"\n[output]\nrate = \"2 kHz\"\n";
    let derived = format!(
        "model = \"friction_oscillator\"\neffects = [{effects}]\n[parameters]\nI = \"1 kg*m^2\"\nk = \"400 N*m/rad\"\nhi = \"6 deg\"\n\
         lo = \"-2 deg\"\nks = \"900 N*m/rad\"\ncs = \"3 N*m*s/rad\"\nT_motor = \"5 N*m\"\n[start]\nphi = \"1 deg\"\n\
         speed = \"4 rad/s\"\n{rest}"
    );
    let listed = format!(
        "model = \"train\"\neffects = [{effects}]\n[rotors]\na = \"1 kg*m^2\"\n[supports.s]\nrotor = \"a\"\nstiffness = \"400 N*m/rad\"\n\
         [end_stops.e]\nbetween = [\"a\", \"ground\"]\n{STOPS}[drives.m]\nrotor = \"a\"\ntorque = \"5 N*m\"\n\
         [start]\ntheta_a = \"1 deg\"\ntheta_a_dot = \"4 rad/s\"\n{rest}"
    );
    for (method, allowed) in [("exact", 1e-12), ("dop853", 1e-8)] {
        let [derived, listed] = [&derived, &listed].map(|text| run(&text.replace("METHOD", method)));
        assert!(derived.outcome.counts.impacts >= 4);
        assert_eq!(derived.outcome.counts.impacts, listed.outcome.counts.impacts);
        for (own, of_train) in [("stop_force", "stop_force_e"), ("stop_loss", "stop_loss_e"), ("kinetic", "kinetic")] {
            let [a, b] = [(&derived, own), (&listed, of_train)].map(|(run, name)| run.column(name).unwrap().to_vec());
            let off = difference(&a, &b);
            println!("{method}: {own} differs by {off:e}");
            assert!(off < allowed, "{method}: {own} differs by {off:e}");
        }
    }
}

/// The second gear turns freely through 400 deg to its stop, at the speed w. The stop brings it to rest in a quarter of a period of
/// vibration, after the angle sqrt(I/k) w, where I is the inertia of both gears at its shaft. Then both gears turn back. On the way to the
/// stop they pass about 45 pitches. The mesh is stiff but not rigid and vibrates after the contact with the stop, so the speed afterwards
/// is not exactly -w.
#[test]
fn a_gear_meets_its_stop_after_many_pitches() {
    let (upper, w, k) = (400f64.to_radians(), 30.0f64, 2e4);
    let inertia: f64 = 0.02 + 0.005 * 4.0;
    let beyond = (inertia / k).sqrt();
    let t_end = 2.0 * upper / w + std::f64::consts::PI * beyond;
    let text = format!(
        "model = \"train\"\neffects = [\"end_stop\", \"stiffness_step\"]\n[rotors]\n1 = \"0.005 kg*m^2\"\n2 = \"0.02 kg*m^2\"\n\
         [meshes.12]\nbetween = [\"1\", \"2\"]\nteeth = [20, 40]\nmodule = \"3 mm\"\n\
         stiffness = {{ steps = [{{ value = \"400 MN/m\", width = \"3 rad\" }}, {{ value = \"600 MN/m\" }}] }}\n\
         [end_stops.e]\nbetween = [\"2\", \"ground\"]\nupper = \"{upper} rad\"\nlower = \"-20 rad\"\nstiffness = \"{k} N*m/rad\"\n\
         [start]\nspeed = \"{} rad/s\"\n[run]\nt_end = \"{t_end} s\"\n[output]\nrate = \"20 kHz\"\n",
        2.0 * w
    );
    let results = run(&text);
    assert_eq!(results.outcome.counts.impacts, 1);
    assert!(results.outcome.counts.cell_changes > 150, "the gears pass pitches on the way there and back");
    let [t, speed, force] = ["t", "rotor_speed_2", "stop_force_e"].map(|name| results.column(name).unwrap().to_vec());
    let first = force.iter().position(|force| *force > 0.0).expect("the stop is met");
    println!("met before {} s, expected {} s; {} rad/s at the end", t[first], upper / w, speed[speed.len() - 1]);
    assert!((t[first] - upper / w).abs() < 1e-4);
    let most = force.iter().fold(0.0, |most: f64, x| most.max(*x));
    assert!((most / (k * w * beyond) - 1.0).abs() < 1e-2, "{most} N m");
    assert!((speed[speed.len() - 1] / -w - 1.0).abs() < 1e-2);
}

#[test]
fn mistakes_name_the_keys_of_the_table() {
    let text = |stops: &str, effects: &str| {
        format!(
            "model = \"train\"\neffects = [{effects}]\n[rotors]\na = \"1 kg*m^2\"\n[end_stops.e]\nbetween = [\"a\", \"ground\"]\n{stops}"
        )
    };
    let refused = |text: &str| {
        let Err(mistakes) = Scene::parse("stops", "stops.toml", text, &[], &common::models()) else {
            panic!("no mistake is found")
        };
        mistakes.render(100, false)
    };
    let shown = refused(&text("upper = \"1 deg\"\nlower = \"-1 N*m\"\n", "\"end_stop\""));
    assert!(shown.contains("`end_stops.e.lower`") && shown.contains("stiffness = \"..."), "{shown}");
    let without =
        Scene::from_toml("stops", &(text(STOPS, "") + "[run]\nt_end = \"1 s\"\n")).unwrap_or_else(|e| panic!("{e}"));
    let warned = without.warnings.join("\n");
    assert!(warned.contains("end_stops.e.upper") && warned.contains("without the effect `end_stop`"), "{warned}");
}
