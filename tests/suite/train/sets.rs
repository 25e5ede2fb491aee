//! Friction within a ring, friction between two rotors, and errors and dampers of planet sets.

use gearsim::{Results, Scene};

fn run(text: &str) -> Results {
    let scene = Scene::from_toml("parts", text).unwrap_or_else(|mistakes| panic!("{mistakes}\n{text}"));
    let results = scene.run().unwrap_or_else(|e| panic!("{e}"));
    assert!(results.summary().refuted.is_none(), "{:?}", results.summary().refuted);
    results
}

/// The mean loss of a pinion in a ring, against the loss factor pi (1/z_1 - 1/z_2) (1 - eps + eps_f² + eps_a²) (H. Ohlendorf, 1958). The path
/// of contact is computed here, from the tips.
#[test]
fn loss_within_a_ring_agrees_with_its_loss_factor() {
    let (z, module, alpha) = ([36.0f64, 99.0], 3e-3, 20f64.to_radians());
    let r = z.map(|z| z * module / 2.0);
    let base = r.map(|r| r * alpha.cos());
    let along = |tip: f64, base: f64| (tip * tip - base * base).sqrt();
    let after = along(r[0] + module, base[0]) - base[0] * alpha.tan();
    let before = base[1] * alpha.tan() - along(r[1] - 0.8 * module, base[1]);
    let [e1, e2] = [before, after].map(|length| length / (std::f64::consts::PI * module * alpha.cos()));
    let factor = std::f64::consts::PI * (1.0 / z[0] - 1.0 / z[1]) * (1.0 - e1 - e2 + e1 * e1 + e2 * e2);

    let teeth = "teeth = [36, 99], internal = true, addendum = [1, 0.8], module = \"3 mm\", face_width = \"25 mm\"";
    let mu = 1e-3;
    // One revolution of the pinion: 36 pitches.
    let text = format!(
        "model = \"train\"\neffects = [\"stiffness_step\", \"sliding_friction\", \"torques\", \"viscous_friction\"]\n\
         [rotors]\n1 = \"0.02 kg*m^2\"\nring = \"0.3 kg*m^2\"\n\
         [meshes.12]\nbetween = [\"1\", \"ring\"]\ninternal = true\nteeth = [36, 99]\nmodule = \"3 mm\"\n\
         stiffness = \"300 MN/m\"\nfriction = {mu}\ndamping = \"60 kN*s/m\"\n\
         [laws]\nside12 = {{ {teeth} }}\narm12 = {{ teeth_of = \"side12\" }}\n\
         [drives.motor]\nrotor = \"1\"\ntorque = \"36 N*m\"\n[loads.load]\nrotor = \"ring\"\ntorque = \"99 N*m\"\n\
         [start]\nspeed = \"600 rpm\"\n[run]\nt_end = \"0.1 s\"\ntolerance = 1e-11\n[output]\nrate = \"1 kHz\"\nevents = false"
    );
    let run = run(&text);
    let work_of =
        |torque: &str| run.trajectory().work_of(torque).and_then(|work| work.last().copied()).expect("a torque");
    let lost = -(work_of("slide12") + work_of("roll12"));
    let work = 36.0 * std::f64::consts::TAU * 600.0 / 60.0 * 0.1;
    assert!((lost / (mu * work) / factor - 1.0).abs() < 2e-3, "lost {lost} J, {} of H_V", lost / (mu * work) / factor);
}

/// Two rotors with friction between them: the speeds change linearly until they are equal, and then the rotors turn together.
#[test]
fn friction_between_two_rotors_brings_them_to_one_speed() {
    let (a, b, torque, speed) = (0.02, 0.03, 4.0, 30.0);
    let text = format!(
        "model = \"train\"\neffects = [\"dry_friction\"]\n[rotors]\na = \"{a} kg*m^2\"\nb = \"{b} kg*m^2\"\n\
         [bearings.c]\nbetween = [\"a\", \"b\"]\nfriction = \"{torque} N*m\"\n\
         [start]\nspeed_a = \"{speed} rad/s\"\nspeed_b = \"0 rad/s\"\n[run]\nt_end = \"0.2 s\"\n[output]\nrate = \"1 kHz\""
    );
    let run = run(&text);
    let t = &run.outcome.trajectory;
    let together = speed / (torque / a + torque / b);
    let common = a * speed / (a + b);
    let [of_a, of_b] = ["rotor_speed_a", "rotor_speed_b"].map(|name| t.output(name).expect("rotor speeds"));
    for (i, &now) in t.t.iter().enumerate() {
        let slips = now < together;
        let expected = if slips { [speed - torque / a * now, torque / b * now] } else { [common; 2] };
        let off = (of_a[i] - expected[0]).abs().max((of_b[i] - expected[1]).abs());
        assert!(off < 1e-12 * speed, "at {now} s: {} and {}, not {expected:?}", of_a[i], of_b[i]);
    }
    let lost = 0.5 * a * b / (a + b) * speed * speed;
    assert!((t.dissipated.last().expect("rows") / lost - 1.0).abs() < 1e-12);
    assert_eq!(run.outcome.counts.sticks, 1);
}

const PLANETS: &str = r#"
model = "train"
effects = ["stiffness_step", "torques", "transmission_error", "viscous_friction"]
[rotors]
1 = "6e-4 kg*m^2"
c = "0.06 kg*m^2"
r = "0.06 kg*m^2"
[supports.r]
rotor = "r"
stiffness = "20 MN*m/rad"
[drives.motor]
rotor = "1"
torque = "30 N*m"
[loads.load]
rotor = "c"
torque = "140 N*m"
[start]
speed = "900 rpm"
[run]
t_end = "10 ms"
[planets.p]
sun = "1"
ring = "r"
carrier = "c"
teeth = [27, 99]
module = "3 mm"
count = 3
mass = "0.7 kg"
inertia = "2e-3 kg*m^2"
sun_stiffness = { teeth = [27, 36], module = "3 mm", face_width = "25 mm" }
ring_stiffness = { teeth = [36, 99], addendum = [1, 0.8], module = "3 mm", face_width = "25 mm" }
"#;

/// The loss of a planetary stage is mu (H_s + H_r) times its rolling power T_s (omega_s - omega_c), which passes through the meshes of the
/// sun and then through those of the ring (H. W. Müller, Epicyclic Drive Trains, 1982). H_s and H_r are the loss factors of Ohlendorf.
#[test]
fn loss_of_a_planetary_stage_is_that_of_its_rolling_power() {
    // Whole pitches: the mesh frequency is 27 (n_s - n_c), with n_c = 27/126 n_s.
    let (mu, duration) = (1e-3, 35.0 / (27.0 * 15.0 * 99.0 / 126.0));
    let scene =
        PLANETS.replace("\"transmission_error\"", "\"sliding_friction\"").replace("10 ms", &format!("{duration} s"));
    let run = run(&format!("{scene}friction = {mu}\ndamping = \"20 kN*s/m\"\n"));
    let t = run.trajectory();
    let lost: f64 = ["s1", "s2", "s3", "r1", "r2", "r3"]
        .iter()
        .flat_map(|mesh| ["slide", "roll"].map(|part| format!("{part}_p_{mesh}")))
        .map(|torque| t.work_of(&torque).and_then(|work| work.last().copied()).expect("a torque"))
        .sum();
    let (alpha, module) = (20f64.to_radians(), 3.0);
    let along = |z: f64, addendum: f64| {
        let (tip, base) = (module * (z / 2.0 + addendum), module * z / 2.0 * alpha.cos());
        (tip * tip - base * base).sqrt() - base * alpha.tan()
    };
    let factor = |[z1, z2]: [f64; 2], sign: f64, addendum: f64| {
        let [e1, e2] = [along(z1, 1.0), sign * along(z2, sign * addendum)]
            .map(|length| length / (std::f64::consts::PI * module * alpha.cos()));
        std::f64::consts::PI * (1.0 / z1 + sign / z2) * (1.0 - e1 - e2 + e1 * e1 + e2 * e2)
    };
    let factors = factor([27.0, 36.0], 1.0, 1.0) + factor([36.0, 99.0], -1.0, 0.8);
    let [of_sun, of_carrier] = ["rotor_speed_1", "rotor_speed_c"].map(|name| {
        let column = t.output(name).expect("rotor speeds");
        column.iter().sum::<f64>() / column.len() as f64
    });
    let rolling = 30.0 * (of_sun - of_carrier) * duration;
    println!("{} of the loss factors", -lost / (mu * rolling) / factors);
    assert!((-lost / (mu * rolling) / factors - 1.0).abs() < 0.01, "{} of H", -lost / (mu * rolling) / factors);
}

/// Errors and dampers that a planet set states give the same motion as the same ones stated for each of its meshes.
#[test]
fn errors_and_dampers_of_a_set_are_those_of_its_meshes() {
    let damping = "damping = \"400 N*s/m\"\n";
    let mut each = format!("{damping}[laws]\n");
    for (i, at) in ["0 rad", "2.0943951023931953 rad", "4.1887902047863905 rad"].into_iter().enumerate() {
        let sun = format!("phase = {{ sun = 27, at = \"{at}\" }}");
        let ring = format!("phase = {{ ring = 99, planet = 36, at = \"{at}\" }}");
        each += &format!("e_p_s{} = {{ pitch_errors = [\"5 um\", \"-2 um\", \"-3 um\"], {sun} }}\n", i + 1);
        each += &format!("e_p_r{} = {{ harmonics = [{{ order = 1, amplitude = \"3 um\" }}], {ring} }}\n", i + 1);
    }
    let of_set = "sun_error = { pitch_errors = [\"5 um\", \"-2 um\", \"-3 um\"] }\n\
                  ring_error = { harmonics = [{ order = 1, amplitude = \"3 um\" }] }\n";
    let of_set = format!("{damping}{of_set}");
    let of_set = run(&format!("{PLANETS}{of_set}"));
    for mesh in ["s1", "s2", "s3", "r1", "r2", "r3"] {
        assert_eq!(of_set.scene.parameter(&format!("c_p_{mesh}")), Some(400.0));
    }
    let [a, b] = [of_set.outcome, run(&format!("{PLANETS}{each}")).outcome].map(|outcome| outcome.trajectory);
    assert_eq!(a.t, b.t);
    assert_eq!((&a.q, &a.q_dot, &a.dissipated), (&b.q, &b.q_dot, &b.dissipated));
    assert!(a.dissipated.last().is_some_and(|lost| *lost > 0.0));
}
