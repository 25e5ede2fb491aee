//! Play at the meshes of planets.

use gearsim::run::Outcome;

use crate::{run, unaccounted};

const EFFECTS: &str = "effects=[\"stiffness_step\",\"torques\",\"damping\",\"backlash\"]";
const BETA: &str = "parameters.beta_K=\"3 us\"";
/// A motor torque that changes its sign.
const SWING: &str = "parameters.T_motor={mean=\"60 N*m\",harmonics=[{amplitude=\"500 N*m\",frequency=\"300 Hz\"}]}";
const LOAD: &str = "parameters.T_load=\"280 N*m\"";

/// Runs with the torque [`SWING`]. Where the damper of a mesh is clipped and those of the bearings are not, damping couples the modes.
/// Planets without contact have rigid motions.
fn swinging(model: &str, planets: usize, method: &str, t_end: &str) -> Outcome {
    let tolerance = if method == "exact" { "" } else { ",tolerance=1e-12" };
    let method = format!("run={{t_end=\"{t_end}\",method=\"{method}\"{tolerance}}}");
    let mut all = vec![EFFECTS, SWING, LOAD, BETA, &method, "output.rate=\"20 kHz\""];
    let further: Vec<String> = (7..=2 * planets)
        .map(|i| {
            format!("laws.k_{}{}.steps=[{{value=\"{} MN/m\"}}]", ["s", "r"][(i + 1) % 2], i.div_ceil(2), 400 + 10 * i)
        })
        .collect();
    all.extend(further.iter().map(String::as_str));
    run(model, planets, &all, &["parameters.b_{}=\"40 um\""])
}

/// In every model both flanks of every mesh come into contact, and the energy account closes.
#[test]
fn accounts_close_with_play() {
    for (model, planets) in
        [("planetary_3", 3), ("planar_planetary_3", 3), ("planar_planetary_4", 4), ("planar_planetary_5", 5)]
    {
        let run = swinging(model, planets, "exact", "3 ms");
        println!("{model}: {:?}, unaccounted for {:.1e}", run.counts, unaccounted(&run));
        assert_eq!(run.modes.len(), 2 * planets, "{model}");
        for (switch, times) in &run.modes {
            let time =
                |of: &str| times.iter().filter(|(mode, _)| mode.starts_with(of)).map(|(_, time)| time).sum::<f64>();
            assert!(["upper", "lower", "free"].iter().all(|of| time(of) > 0.0), "{model}, {switch}: {times:?}");
        }
        assert!(unaccounted(&run) < 1e-13, "{model}: {:e}", unaccounted(&run));
    }
}

/// Exact cells and a method by steps have the same impacts and the same end.
#[test]
fn exact_cells_agree_with_a_numerical_method() {
    for model in ["planetary_3", "planar_planetary_3"] {
        let [exact, steps] = ["exact", "dop853"].map(|method| swinging(model, 3, method, "2 ms"));
        assert_eq!(exact.counts.impacts, steps.counts.impacts, "{model}");
        let (t, u) = (&exact.trajectory, &steps.trajectory);
        let mut worst: f64 = 0.0;
        // theta and the elastic coordinates, each of the size of its largest value.
        for (a, b) in t.q.iter().zip(&u.q) {
            let size = a.iter().fold(1e-9, |m: f64, x| m.max(x.abs()));
            worst = worst.max((a[a.len() - 1] - b[b.len() - 1]).abs() / size);
        }
        println!("{model}: {:?}, {worst:.1e} apart", exact.counts);
        assert!(worst < 1e-7, "{model}: {worst:e}");
    }
}

/// A planet that touches the flanks of neither sun nor ring moves freely. No rounding error of a spring may act on it.
#[test]
fn a_planet_without_contact_moves_freely() {
    for model in ["planetary_3", "planar_planetary_3"] {
        let play = ["s1", "r1"].map(|mesh| format!("parameters.b_{mesh}=\"2 mm\""));
        let all = [
            "effects=[\"stiffness_step\",\"torques\",\"backlash_s1\",\"backlash_r1\"]",
            &play[0],
            &play[1],
            "start.u1=\"0.1 mm\"",
            "start.u1_dot=\"1 mm/s\"",
            "run.t_end=\"20 ms\"",
            "run.method=\"exact\"",
        ];
        let run = run(model, 3, &all, &[]);
        let open = run.modes.iter().all(|(_, times)| times.iter().all(|(mode, time)| *mode == "free" || *time == 0.0));
        println!("{model}: {:?}, unaccounted for {:.1e}", run.counts, unaccounted(&run));
        assert!(open && run.modes.len() == 2 && run.counts.impacts == 0, "{model}: {:?}", run.modes);
        assert!(run.counts.cell_changes > 20, "{:?}", run.counts);
        assert!(unaccounted(&run) < 1e-14, "{model}: {:e}", unaccounted(&run));
    }
}
