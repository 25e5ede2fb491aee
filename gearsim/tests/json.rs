//! `--json`: each command prints one JSON document, and `check` one for each scene. The document conforms to the schema of its format, and
//! has the numbers of the files. `-q` prints nothing.

#[path = "../src/output/conforms.rs"]
mod conforms;

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

use conforms::conforms;

/// A short scene with every result that commands need.
const SCENE: &str = "models/scenes/oh2005/energy_300rpm.toml";
const SHORT: [&str; 4] = ["--set", "run.t_end=5 ms", "--set", "output.rate=20 kHz"];

fn gearsim(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    Command::new(env!("CARGO_BIN_EXE_gearsim")).args(arguments).current_dir(root).output().unwrap()
}

fn document(arguments: &[&str], format: &str) -> Value {
    let output = gearsim(&[arguments, &["--json"]].concat());
    let text = String::from_utf8(output.stdout).unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    let value: Value = serde_json::from_str(&text).unwrap_or_else(|e| panic!("{arguments:?}: {e}\n{text}\n{errors}"));
    // The schema has the format and its version.
    conforms(&value, &schema(format), "").unwrap_or_else(|wrong| panic!("{arguments:?}: {wrong}"));
    value
}

fn schema(format: &str) -> Value {
    let schemas = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/output/schemas");
    serde_json::from_str(&std::fs::read_to_string(schemas.join(format!("{format}.schema.json"))).unwrap()).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn commands_print_their_results_as_json() {
    let root = tempfile::tempdir().unwrap();
    let out = |name: &str| root.path().join(name).display().to_string();
    let with = |command: &'static str, scene: &'static str, folder: &str, more: &[&str]| {
        let mut all = vec![command.to_owned(), scene.to_owned(), "--out".to_owned(), out(folder)];
        all.extend(more.iter().map(|text| (*text).to_owned()));
        all
    };
    let print = |arguments: Vec<String>, format: &str| {
        document(&arguments.iter().map(String::as_str).collect::<Vec<_>>(), format)
    };
    let file = |folder: &str, name: &str| -> Value {
        serde_json::from_str(&std::fs::read_to_string(root.path().join(folder).join(name)).unwrap()).unwrap()
    };

    let run = print(with("run", SCENE, "run", &SHORT), "summary");
    assert_eq!(run, file("run", "summary.json"));
    let compare = print(with("compare", SCENE, "compare", &SHORT), "compare");
    assert_eq!(compare, file("compare", "compare.json"));
    for run in compare["runs"].as_array().unwrap() {
        conforms(&run["summary"], &schema("summary"), "").unwrap();
    }
    // The paper's point: the classical equations do not keep the energy that the exact ones keep.
    let residual = |i: usize| number(&compare["runs"][i]["summary"]["energy"]["residual"]).abs();
    assert!(residual(2) > 1e3 * residual(0), "{compare}");
    let modes = print(with("modes", SCENE, "modes", &[]), "modes");
    assert_eq!(modes, file("modes", "modes.json"));
    let floquet = print(with("floquet", SCENE, "floquet", &[]), "floquet");
    assert_eq!(floquet, file("floquet", "floquet.json"));
    // Only some scenes have a steady motion about which terms are linearised, an orbit, or ranges over a turn.
    let friction = "models/scenes/sliding_friction.toml";
    assert!(print(with("modes", friction, "modes", &[]), "modes")["linearised"].is_object());
    assert!(print(with("floquet", friction, "floquet", &[]), "floquet")["linearised"].is_object());
    let crank = "models/scenes/crank_drive.toml";
    assert!(print(with("modes", crank, "modes", &[]), "modes")["natural_frequencies_over_a_turn"].is_array());
    assert!(print(with("floquet", crank, "floquet", &[]), "floquet")["orbit"].is_object());

    let sweep = ["--vary", "run.t_end=normal:4 ms:0.1 ms", "--samples", "8", "--limit", "t_end < 1 s", "--csv"];
    let sweep = print(with("sweep", SCENE, "sweep", &sweep), "sweep");
    assert_eq!(
        (sweep["points"]["done"].as_u64(), sweep["answers"]["limits"][0]["broken"].as_f64()),
        (Some(8), Some(0.0))
    );
    let manifest = file("sweep", "sweep.json");
    conforms(&manifest, &schema("sweep_manifest"), "").unwrap();
    assert_eq!(sweep["sweep"], manifest);
    let csv = std::fs::read_to_string(root.path().join("sweep/sweep.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + 8);
    let statistics = sweep["answers"]["statistics"].as_array().unwrap();
    let t_end = statistics.iter().find(|row| row["quantity"] == "t_end").unwrap();
    assert!((number(&t_end["mean"]) - 4e-3).abs() < 0.2e-3);
    let merged = gearsim(&["merge", &out("sweep"), "--out", &out("merged"), "--json"]);
    let merged: Value = serde_json::from_slice(&merged.stdout).unwrap();
    assert_eq!(merged["answers"]["statistics"], sweep["answers"]["statistics"]);

    let over = [
        "--over",
        "start.speed=2200 rpm,2300 rpm",
        "--output",
        "dte_12",
        "--settle",
        "1 ms",
        "--set",
        "run.t_end=2 ms",
    ];
    let response = print(with("response", "models/scenes/response.toml", "response", &over), "response");
    assert_eq!(response["points"].as_array().unwrap().len(), 4);
    let short = [&SHORT[..], &["--repetitions", "1", "--set", "run.t_end=1 ms"]].concat();
    let measured = print(with("work-precision", SCENE, "work_precision", &short), "work-precision");
    assert_eq!(measured["methods"][0]["name"], "exact cells");

    let advice = document(&[&["advise", SCENE][..], &SHORT[..2]].concat(), "advise");
    let candidates = advice["candidates"].as_array().unwrap();
    assert!(candidates.iter().any(|c| c["without"] == "damping" && c["truth"]["rms"].is_number()), "{advice}");
    let check = document(&["check", SCENE], "check");
    assert_eq!(check["start"].as_object().unwrap().len(), check["start_speeds"].as_object().unwrap().len());
    let others = ["models/scenes/two_stage.toml", "models/scenes/planetary_3.toml"];
    let lines = gearsim(&[&["check", "--json", SCENE][..], &others].concat()).stdout;
    let lines: Vec<Value> = lines
        .split(|byte| *byte == b'\n')
        .filter(|line| !line.is_empty())
        .map(|line| serde_json::from_slice(line).unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(line))))
        .collect();
    assert_eq!(
        lines.iter().map(|line| &line["scene"]).collect::<Vec<_>>(),
        ["energy_300rpm", "two_stage", "planetary_3"]
    );
    let models = document(&["models", "gear_pair"], "models");
    assert_eq!(models["models"][0]["coordinates"].as_array().unwrap().len(), 2);
    assert!(document(&["models"], "models")["models"].as_array().unwrap().len() > 20);
}

/// One position of a cycle does not tell whether the motion is stable.
#[test]
fn modes_at_a_position_have_no_verdict() {
    let root = tempfile::tempdir().unwrap();
    let out = root.path().display().to_string();
    for (scene, has) in [("cardan_drive", true), ("crank_drive", true), ("two_stage", false)] {
        let text = gearsim(&["modes", &format!("models/scenes/{scene}.toml"), "--out", &out]).stdout;
        let text = String::from_utf8(text).unwrap();
        assert!(!text.contains("unstable") && text.contains("at this position of the cycle") == has, "{text}");
        assert_eq!(text.contains("at this position a disturbance grows"), has, "{text}");
    }
}

#[test]
fn quiet_commands_print_nothing() {
    let root = tempfile::tempdir().unwrap();
    let out = root.path().display().to_string();
    for command in ["run", "compare", "modes", "floquet"] {
        let output = gearsim(&[&[command, SCENE, "--out", &out, "-q"][..], &SHORT].concat());
        let (printed, errors) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(output.status.success() && printed.is_empty() && errors.is_empty(), "{command}: {printed}{errors}");
    }
    let advise = gearsim(&[&["advise", SCENE, "-q"][..], &SHORT[..2]].concat());
    assert!(advise.status.success() && advise.stdout.is_empty());
}

/// The manual has the descriptions of all keys from each schema, and each schema belongs to a format in use.
#[test]
fn every_format_has_a_schema_that_describes_its_keys() {
    let schemas = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/output/schemas");
    let manual = Path::new(env!("CARGO_MANIFEST_DIR")).join("manual/src/outputs.md");
    let manual = std::fs::read_to_string(manual).unwrap();
    let mut formats = vec![];
    for entry in std::fs::read_dir(schemas).unwrap() {
        let file = entry.unwrap().file_name().into_string().unwrap();
        let format = file.strip_suffix(".schema.json").unwrap().to_owned();
        assert_eq!(schema(&format)["properties"]["format"]["const"], format!("gearsim.{format}"));
        described(&schema(&format), &file);
        assert!(manual.contains(&format!("<!-- keys of: gearsim/src/output/schemas/{file} -->")), "{file}");
        formats.push(format);
    }
    formats.sort();
    let used = "advise check compare floquet models modes response summary sweep sweep_manifest work-precision";
    assert_eq!(formats.join(" "), used);
}

fn described(schema: &Value, path: &str) {
    for (key, inner) in schema["properties"].as_object().into_iter().flatten() {
        let path = format!("{path}: {key}");
        assert!(inner["description"].as_str().is_some_and(|text| text.len() > 5), "{path}");
        described(inner, &path);
        described(&inner["items"], &path);
        described(&inner["additionalProperties"], &path);
    }
}
