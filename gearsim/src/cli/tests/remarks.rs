//! Tests of the remarks on results: each is in the report, in `summary.json`, in sweeps, responses and pages.

use std::path::Path;

use clap::Parser;

use super::go;
use crate::Scene;
use crate::cli::Verb;
use crate::cli::failure::Failure;
use crate::cli::report;
use crate::cli::response::ResponseCommand;
use crate::cli::run::Run;
use crate::cli::sweep::SweepCommand;
use crate::output::{Summary, parquet};

/// Two rotors and a mesh of 200 to 320 MN/m; `more` ends its table.
fn pair(effects: &str, more: &str) -> String {
    format!(
        "model = \"train\"\neffects = [{effects}]\n[rotors]\n1 = \"3e-3 kg*m^2\"\n2 = \"2e-2 kg*m^2\"\n[meshes.12]\n\
         between = [\"1\", \"2\"]\nteeth = [24, 96]\nmodule = \"3 mm\"\n{more}\n\
         stiffness = {{ steps = [{{ value = \"200 MN/m\", width = \"2.5 rad\" }}, {{ value = \"320 MN/m\" }}] }}\n\
         [drives.m]\nrotor = \"1\"\ntorque = \"10 N*m\"\n[loads.l]\nrotor = \"2\"\ntorque = \"40 N*m\"\n\
         [parameters]\nbeta_K = \"1 us\"\n[start]\nspeed = \"1500 rpm\"\n[run]\nt_end = \"20 ms\"\n[output]\nrate = \"100 kHz\"\n"
    )
}

const BASE: &str = "\"stiffness_step\", \"damping\", \"torques\"";
/// An error of the teeth that throws them apart.
const ERROR: &str = "error = { steps = [{ value = \"8 um\", width = \"3 rad\" }, { value = \"-8 um\" }] }\n";

fn scene(text: &str) -> Scene {
    Scene::from_toml("pair", text).unwrap_or_else(|error| panic!("{error}"))
}

fn command<V: Verb + Parser>(file: &Path, arguments: &[&str]) -> Result<(), Failure> {
    let all = [&["gearsim", file.to_str().unwrap()], arguments].concat();
    V::try_parse_from(all).map_err(Failure::Usage).and_then(V::run)
}

#[test]
fn teeth_that_pull_are_named_in_every_result() {
    let root = tempfile::tempdir().unwrap();
    let [file, out] = ["pair.toml", "out"].map(|name| root.path().join(name));
    let effects = format!("{BASE}, \"transmission_error\"");
    std::fs::write(&file, pair(&effects, ERROR)).unwrap();
    let to = ["--out", out.to_str().unwrap(), "-q"];
    command::<Run>(&file, &to).unwrap();
    let summary: Summary = serde_json::from_slice(&std::fs::read(out.join("summary.json")).unwrap()).unwrap();
    let named = |remark: &String| remark.starts_with("the teeth pull: `mesh_force_12` for ");
    let remark = summary.remarks.iter().find(|remark| named(remark)).unwrap();
    assert!(remark.contains("Without the effect `backlash_12`"), "{remark}");
    // Share and forces are those of the recorded rows.
    let results = scene(&pair(&effects, ERROR)).run().unwrap();
    let force = results.column("mesh_force_12").unwrap();
    let mesh = &summary.meshes["k12"];
    assert_eq!(mesh.largest_pull.0, -force.iter().fold(0.0, |m: f64, x| m.min(*x)));
    let below = force.iter().filter(|x| **x < 0.0).count() as f64 / force.len() as f64;
    assert!((mesh.pulling_share.0 - below).abs() < 0.02 && mesh.mean.0 > 0.0, "{mesh:?} {below}");
    assert!(report::run(&results.scene, &summary, 1, 1000).contains(remark));
    #[cfg(feature = "html")]
    assert!(results.page().unwrap().contains("the teeth pull: "));

    let vary = ["--vary", "drives.m.torque=10 N*m,11 N*m", "--record", "meshes"];
    command::<SweepCommand>(&file, &[&to[..], &vary].concat()).unwrap();
    let (table, _) = parquet::read(&out.join("sweep.parquet")).unwrap();
    assert!(table.words("remarks").unwrap().iter().all(|remark| remark.starts_with("the teeth pull: ")));
    assert_eq!(table.numbers("k12_pulling_share").unwrap()[0], mesh.pulling_share.0);
    assert_eq!(table.numbers("k12_largest_pull").unwrap()[0], mesh.largest_pull.0);

    let over = ["--over", "start.speed=1500 rpm:1510 rpm:2", "--settle", "10 ms", "--up"];
    command::<ResponseCommand>(&file, &[&to[..], &over].concat()).unwrap();
    let (table, _) = parquet::read(&out.join("response.parquet")).unwrap();
    assert!(table.words("remarks").unwrap().iter().all(|remark| remark.starts_with("the teeth pull: ")));
    assert!(table.numbers("mesh_force_12_pulling_share").unwrap().iter().all(|share| *share > 0.0));
}

#[test]
fn teeth_with_play_do_not_pull() {
    let more = format!("{ERROR}backlash = \"60 um\"");
    let summary =
        scene(&pair(&format!("{BASE}, \"transmission_error\", \"backlash\""), &more)).run().unwrap().summary();
    assert_eq!((summary.meshes["k12"].pulling_share.0, summary.remarks), (0.0, vec![]));
}

/// Advice adds play to a mesh that pulls: the play that the scene states, or an assumed one.
#[test]
fn advice_tries_effects_that_the_scene_leaves_out() {
    let effects = format!("{BASE}, \"transmission_error\"");
    for (more, how) in
        [("backlash = \"60 um\"\n", "add `backlash`"), ("", "add `backlash`, with an assumed play of b12 = ")]
    {
        let advice = scene(&pair(&effects, &format!("{ERROR}{more}"))).advise().unwrap();
        let play: Vec<_> =
            advice.verdicts.iter().filter(|v| v.candidate.without == "nothing, and with backlash").collect();
        assert!(matches!(&play[..], [one] if one.candidate.how.starts_with(how)), "{more}");
        assert_eq!(play[0].negligible().1, Some(false), "the teeth part");
    }
}

/// The mesh frequency is 24 x 25 Hz = 600 Hz, but for vibrations, the torque has a harmonic of 900 Hz. Samples at 800 Hz show them at 200 and 100 Hz.
#[test]
fn frequencies_above_half_the_rate_are_named_with_a_rate_that_suffices() {
    let text = pair(BASE, "").replace(
        "\"10 N*m\"",
        "{ mean = \"10 N*m\", harmonics = [{ amplitude = \"1 N*m\", frequency = \"900 Hz\" }] }",
    );
    let coarse = scene(&text).with_all([("output.rate", "800 Hz".into()), ("run.t_end", "0.5 s".into())]).unwrap();
    let said = coarse.run().unwrap().summary().remarks.into_iter().find(|remark| remark.starts_with("too few samples"));
    let said = said.unwrap();
    for part in ["`k12` of 599.9 Hz shows at 200.1 Hz", "`T_m` of 900 Hz shows at 100 Hz", "for example \"9000 Hz\""] {
        assert!(said.contains(part), "{said}");
    }
    let fine = scene(&text).run().unwrap().summary().remarks;
    assert!(!fine.iter().any(|remark| remark.starts_with("too few")), "{fine:?}");
}

/// An overdamped shaft follows the corners of its torque within a sample, but does not vibrate.
#[test]
fn an_overdamped_mode_is_no_vibration() {
    let remarks = |damping: &str| {
        let text = format!(
            "model = \"train\"\neffects = [\"torques\", \"viscous_friction\"]\n[rotors]\na = \"1e-5 kg*m^2\"\n[shafts.s]\n\
             between = [\"a\", \"ground\"]\nstiffness = \"100 kN*m/rad\"\ndamping = \"{damping} N*m*s/rad\"\n[drives.m]\nrotor = \"a\"\n\
             torque = {{ steps = [{{ value = \"1 N*m\", until = \"0.5 s\" }}, {{ value = \"5 N*m\" }}] }}\n\
             [run]\nt_end = \"1 s\"\n[output]\nrate = \"1 kHz\"\nplots = []\n"
        );
        scene(&text).run().unwrap().summary().remarks
    };
    assert_eq!(remarks("3"), [""; 0]);
    assert!(remarks("1e-6").iter().any(|remark| remark.contains("vibrates faster than they can show")));
}

/// 10 kN m on a base radius of 33.8 mm press 296 kN on 200 MN/m: 1.5 mm, half a module of 3 mm.
#[test]
fn absurd_deflections_and_plays_are_named() {
    let heavy = pair(BASE, "").replace("\"10 N*m\"", "\"10 kN*m\"").replace("\"40 N*m\"", "\"40 kN*m\"");
    let remarks = scene(&heavy).run().unwrap().summary().remarks;
    assert!(
        remarks.iter().any(|remark| remark.starts_with("absurd deflections: `mesh_force_12` bends")),
        "{remarks:?}"
    );
    let warnings = scene(&pair(&format!("{BASE}, \"backlash\""), "backlash = \"60 m\"")).warnings;
    assert_eq!(warnings, ["`meshes.12.backlash` is a play of 20000.0 modules: the teeth would not mesh"]);
    let soft = "model = \"train\"\neffects = [\"torques\"]\n[rotors]\na = \"1 kg*m^2\"\n[shafts.s]\nbetween = [\"a\", \"ground\"]\n\
                stiffness = \"1 N*m/rad\"\n[drives.m]\nrotor = \"a\"\ntorque = \"10 N*m\"\n[run]\nt_end = \"1 s\"\n[output]\nplots = []\n";
    let remarks = scene(soft).run().unwrap().summary().remarks;
    assert_eq!(
        remarks,
        [
            "absurd deflections: `shaft_twist_s` reaches 1.592 turns. Real parts break before: check torques, stiffnesses and their units"
        ]
    );
}

/// A pair that accelerates evenly: the rate of its deflection is zero but for errors, and has no digits of its own. The phase is
/// 20 (11 - 5) N m/(2 kg m^2) t^2/2 = 120 rad after 2 s.
#[test]
fn a_rate_that_is_zero_but_for_rounding_takes_no_digits() {
    let text = "model = \"train\"\neffects = [\"stiffness_step\", \"torques\"]\n[rotors]\n1 = \"1 kg*m^2\"\n2 = \"1 kg*m^2\"\n[meshes.12]\n\
                between = [\"1\", \"2\"]\nteeth = [20, 20]\nbase_radius = \"50 mm\"\nstiffness = \"1 MN/m\"\n[drives.m]\nrotor = \"1\"\n\
                torque = \"11 N*m\"\n[loads.l]\nrotor = \"2\"\ntorque = \"5 N*m\"\n[start]\nspeed = \"0 rpm\"\n[run]\nt_end = \"2 s\"\n\
                [output]\nplots = []\n";
    for method in ["dop853", "dopri5"] {
        let results = scene(text).with("run.method", method).unwrap().run().unwrap();
        let digits = results.outcome.digits.unwrap();
        let phase = *results.column("phase12").unwrap().last().unwrap();
        let right = -(phase / 120.0 - 1.0).abs().log10();
        assert!(
            digits.none_from.is_none() && digits.at_end > 6.0 && digits.at_end < right + 1.0,
            "{method}: {digits:?} {right}"
        );
    }
}

/// A warning about the scene is in the summary of a run too.
#[test]
fn warnings_about_the_scene_are_remarks_on_its_run() {
    let root = tempfile::tempdir().unwrap();
    go::<Run>(root.path(), &["-q", "--set", "laws.e={steps=[{value=\"1e-3 rad\"}]}"]).unwrap();
    let summary: Summary = serde_json::from_slice(&std::fs::read(root.path().join("summary.json")).unwrap()).unwrap();
    let said = "`laws.e` does nothing without the effect `transmission_error`: add it to `effects`, or leave it out";
    assert!(summary.remarks.contains(&said.to_owned()), "{:?}", summary.remarks);
}
