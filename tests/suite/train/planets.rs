//! The meshes of a derived planetary stage and of the same train, with play and with friction of the flanks.

use gearsim::run::Outcome;
use gearsim_tests::trains::{PLANETARY, Pair};

use crate::common;
use crate::same::{Compared, events};

/// The meshes of the derived model; the train has them as `p_s1`, ...
const MESHES: [&str; 6] = ["s1", "r1", "s2", "r2", "s3", "r3"];

/// Overrides of the derived model, and of the train: `{}` in `each` is a mesh.
fn overrides(all: &[&str], each: &[&str]) -> [Vec<String>; 2] {
    ["", "p_"].map(|of| {
        let meshes =
            MESHES.iter().flat_map(|mesh| each.iter().map(move |text| text.replace("{}", &format!("{of}{mesh}"))));
        all.iter().map(|text| text.to_string()).chain(meshes).collect()
    })
}

/// Runs both, and compares the counts of events and the last values of the columns that both have: outputs except losses, and the energies.
/// Returns the largest difference, relative to the largest value of its column, and the derived model's run.
fn compare(pair: &Pair, overrides: &[Vec<String>; 2]) -> (f64, Outcome) {
    let of = |i: usize| overrides[i].iter().map(String::as_str).collect::<Vec<_>>();
    let [derived, listed] = pair.scenes_of([&of(0), &of(1)]).map(|scene| common::run(&scene));
    assert_eq!(events(&derived), events(&listed), "{overrides:?}");
    let (t, u) = (&derived.trajectory, &listed.trajectory);
    let mut columns = vec![("kinetic", &t.kinetic[..], &u.kinetic[..]), ("strain", &t.strain, &u.strain)];
    for (output, values) in t.outputs.iter().filter(|(output, _)| !output.name.contains("loss")) {
        let of_train =
            MESHES.iter().fold(output.name.to_string(), |name, mesh| match name.strip_suffix(&format!("_{mesh}")) {
                Some(quantity) => format!("{quantity}_p_{mesh}"),
                None => name,
            });
        columns.extend(u.output(&of_train).map(|other| (output.name, &values[..], other)));
    }
    // At least the two energies, of each mesh force, power, deflection and transmission error, and the speeds of three rotors.
    assert!(columns.len() >= 2 + 4 * MESHES.len() + 3, "{} columns", columns.len());
    let mut worst: (f64, &str) = (0.0, "");
    for (name, a, b) in columns {
        let size = a.iter().fold(1e-300, |most: f64, x| most.max(x.abs()));
        let off = (a[a.len() - 1] - b[b.len() - 1]).abs() / size;
        worst = if off > worst.0 { (off, name) } else { worst };
    }
    println!("{:?}: at most {:.1e} apart ({})", derived.counts, worst.0, worst.1);
    (worst.0, derived)
}

const PLAY: &str = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"backlash\"]";

/// A motor torque that changes its sign.
const SWING: &str = "parameters.T_motor={mean=\"60 N*m\",harmonics=[{amplitude=\"500 N*m\",frequency=\"300 Hz\"}]}";

/// All planets leave sun and ring at the same instant, and meet them again.
#[test]
fn planets_leave_the_ring_together_and_come_back() {
    for method in ["exact", "dop853"] {
        let tolerance = if method == "exact" { "" } else { ",tolerance=1e-12" };
        let method = format!("run={{t_end=\"6 ms\",method=\"{method}\"{tolerance}}}");
        let all = [PLAY, SWING, "parameters.T_load=\"280 N*m\"", &method];
        let (off, run) = compare(&PLANETARY, &overrides(&all, &["parameters.b_{}=\"40 um\""]));
        assert!(run.counts.impacts >= 12 && run.counts.impacts % 3 == 0, "{:?}", run.counts);
        for (switch, times) in &run.modes {
            assert!(times.iter().any(|(mode, time)| *mode == "free" && *time > 0.0), "{switch} never opens");
        }
        assert!(off < 1e-8, "{off:e}");
    }
}

/// One planet has play; the others do not.
#[test]
fn play_of_one_planet_alone() {
    let effects = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"backlash_{1}\",\"backlash_{2}\"]";
    let both = ["", "p_"].map(|of| {
        let effects = effects.replace("{1}", &format!("{of}s2")).replace("{2}", &format!("{of}r2"));
        let play = [("s2", 40), ("r2", 60)].map(|(mesh, b)| format!("parameters.b_{of}{mesh}=\"{b} um\""));
        let all = [&effects[..], SWING, "parameters.T_load=\"280 N*m\"", "run.t_end=\"6 ms\"", "run.method=\"exact\""];
        all.iter().map(|text| text.to_string()).chain(play).collect::<Vec<_>>()
    });
    let (off, run) = compare(&PLANETARY, &both);
    assert!(run.counts.impacts > 4 && run.modes.len() == 2, "{:?} {:?}", run.counts, run.modes);
    assert!(off < 1e-8, "{off:e}");
}

/// Each mesh has its own transmission error, and play with damping that does not pull.
#[test]
fn errors_and_play_of_every_mesh() {
    let effects = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"backlash\",\"transmission_error\"]";
    let all = [
        effects,
        "run.t_end=\"6 ms\"",
        "run.method=\"exact\"",
        SWING,
        "parameters.T_load=\"280 N*m\"",
        "parameters.beta_K=\"1 us\"",
    ];
    let mut both = overrides(&all, &["parameters.b_{}=\"20 um\""]);
    for (of, overrides) in ["", "p_"].into_iter().zip(&mut both) {
        overrides.extend(MESHES.iter().enumerate().map(|(i, mesh)| {
            let (value, width) = (3 * i + 4, 1.0 + 0.3 * i as f64);
            format!("laws.e_{of}{mesh}={{steps=[{{value=\"{value} um\",width=\"{width} rad\"}},{{value=\"-5 um\"}}]}}")
        }));
    }
    let (off, run) = compare(&PLANETARY, &both);
    assert!(run.counts.impacts > 10, "{:?}", run.counts);
    assert!(off < 1e-8, "{off:e}");
}

/// Friction of the flanks at all meshes, with the pressure angle of the set.
#[test]
fn friction_of_the_flanks_of_every_mesh() {
    let tables = PLANETARY.tables.replace("teeth=[27,99]\n", "teeth=[27,99]\npressure_angle='24.6 deg'\n");
    let renamed: Vec<_> = PLANETARY.renamed.iter().filter(|(from, _)| *from != "alpha =").copied().collect();
    let pair =
        Pair { tables: &tables, renamed: &[&renamed[..], &[("alpha = \"24.6 deg\"\n", "")]].concat(), ..PLANETARY };
    for effects in [
        "effects=[\"stiffness_step\",\"torques\",\"sliding_friction\"]",
        "effects=[\"stiffness_step\",\"torques\",\"damping\",\"sliding_friction\",\"backlash\"]",
    ] {
        let all = [effects, "run.t_end=\"5 ms\"", "run.method=\"dop853\"", "run.tolerance=1e-12"];
        let each = [
            "parameters.mu_{}=0.08",
            "parameters.b_{}=\"30 um\"",
            "laws.side_{}={steps=[{value=-1,width=\"3 rad\"},{value=1}]}",
            "laws.arm_{}={steps=[{value=\"2 mm\",width=\"3 rad\"},{value=\"3 mm\"}]}",
        ];
        let (off, run) = compare(&pair, &overrides(&all, &each));
        assert!(off < 1e-8, "{effects}: {off:e}");
        let t = &run.trajectory;
        let of = |name: String| t.work_of(&name).expect("a torque of the scene");
        for mesh in MESHES {
            let roll = of(format!("roll_{mesh}"));
            assert!(roll.windows(2).all(|w| w[1] <= w[0]) && roll[roll.len() - 1] < 0.0, "{mesh}");
            assert!(of(format!("slide_{mesh}")).iter().any(|w| *w != 0.0), "{mesh}");
        }
    }
}
