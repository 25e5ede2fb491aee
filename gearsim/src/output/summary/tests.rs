//! Tests of the format of `summary.json`.

use serde_json::Value;

use super::*;
use crate::output::conforms::conforms;
use crate::output::fixture::oscillator;

fn summary() -> Summary {
    let run = oscillator(1000);
    let [largest, at_rest, dynamic_factor, kv_iso6336] = [13.0, 10.0, 1.3, 1.25].map(Number);
    let (force, unit) = ("mesh_force_12".into(), "N".into());
    let [mean, pulling_share, largest_pull] = [9.9, 0.1, 2.0].map(Number);
    let mesh = Mesh { force, unit, largest, at_rest, dynamic_factor, kv_iso6336, mean, pulling_share, largest_pull };
    let [contact_ratio, overlap_ratio, mean, min, max] = [1.5, 0.0, 1.5e8, 1e8, 2e8].map(Number);
    let levels = [1e8, 2e8].map(|value| Level { value: Number(value), width: Number(3.0) }).to_vec();
    let (unit, phase_unit) = ("N/m".into(), "rad".into());
    let law = LawFromTeeth { contact_ratio, overlap_ratio, unit, phase_unit, mean, min, max, levels };
    let load = LoadSpectrum { unit: "rad".into(), cycles: Number(12.5), largest_range: Number(1e-3) };
    let (file, unit) = ("sound_dte.wav".into(), "rad".into());
    let sound = Sound { file, stretch: Number(1.0), unit, full_scale: Number(1e-3), mean: Number(0.0) };
    Summary {
        format: FORMAT.into(),
        version: VERSION,
        scene: "energy_300rpm".into(),
        model: run.model.name.into(),
        effects: vec!["damping".into()],
        t_end: Number(0.1),
        state: Named::state(&run),
        cell_changes: 12,
        reflections: 0,
        energy: Energy::at_end(&run).unwrap(),
        outputs: IndexMap::new(),
        rows: Rows::of(&run),
        meshes: [("k12".to_owned(), mesh)].into_iter().collect(),
        laws_from_teeth: [("k12".to_owned(), law)].into_iter().collect(),
        load_spectra: [("dte".to_owned(), load)].into_iter().collect(),
        sounds: [("dte".to_owned(), sound)].into_iter().collect(),
        modes: BTreeMap::new(),
        impacts: [("flanks met".to_owned(), 3), ("stop met".to_owned(), 2)].into_iter().collect(),
        method: Method { name: "exact".into(), why: "linear cells".into(), steps: 0, rejected: 0 },
        counts: Counts {
            function_evaluations: 1,
            root_steps: 2,
            grazes: 3,
            holds: 4,
            impacts: 5,
            sticks: 7,
            ignored: Number(5e-12),
            ambiguous: 6,
        },
        digits: Some(Digits { at_end: Number(11.5), none_from: None }),
        remarks: vec!["one of two equilibria".into()],
        cpu_seconds: Number(0.01),
        completed: false,
        stopped_by: Some("stalled".into()),
        refuted: None,
        parameters: [("T0", 10.0), ("I1", 1.0 / 3.0)].into_iter().collect(),
        missing: BTreeMap::new(),
        files: vec!["trajectory.parquet".into()],
        provenance: Provenance {
            program: "gearsim".into(),
            version: "0.1.0".into(),
            commit: None,
            scene_sha256: "00".into(),
            solver: "closed form".into(),
            overrides: vec![],
        },
    }
}

#[test]
fn a_summary_reads_back_as_written_and_in_order() {
    let written = summary();
    let text = written.json().unwrap();
    assert_eq!(serde_json::from_str::<Summary>(&text).unwrap(), written);
    let place = |key: &str| text.find(&format!("\"{key}\"")).unwrap();
    assert!(place("theta") < place("theta_dot") && place("theta_dot") < place("phi"));
    assert!(place("T0") < place("I1"));
}

#[test]
fn a_number_that_is_not_finite_is_null_and_has_a_reason() {
    let mut odd = summary();
    odd.cpu_seconds = Number(f64::NEG_INFINITY);
    odd.energy.residual = Number(f64::NAN);
    odd.meshes["k12"].kv_iso6336 = Number(f64::NAN);
    odd.parameters = [("T0", 1.0), ("b", f64::NAN)].into_iter().collect();
    odd.note_missing();
    let text = odd.json().unwrap();
    assert!(text.contains(r#""cpu_seconds": null"#) && !text.contains("\"nan\""), "{text}");
    let paths: Vec<_> = odd.missing.keys().map(String::as_str).collect();
    assert_eq!(paths, ["cpu_seconds", "energy.residual", "meshes.k12.kv_iso6336", "parameters.b"]);
    assert!(odd.missing["parameters.b"].contains("no effect of the scene needs it"), "{text}");
    assert_eq!(
        nulls(&serde_json::from_str(&text).unwrap(), ""),
        paths,
        "every null has a reason, or the schema allows it"
    );
    let back: Summary = serde_json::from_str(&text).unwrap();
    assert!(back.parameters.get("b").unwrap().is_nan());
    assert!(serde_json::from_str::<Number>("\"nan\"").is_err());
}

/// The paths of numbers that are `null`; texts and `digits` may be `null` without a reason.
fn nulls(value: &Value, path: &str) -> Vec<String> {
    const MAY: [&str; 4] = ["digits.none_from", "stopped_by", "refuted", "provenance.commit"];
    match value {
        Value::Null if !MAY.contains(&path) => vec![path.to_owned()],
        Value::Object(map) => {
            let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
            map.iter().flat_map(|(key, value)| nulls(value, &below(key))).collect()
        }
        _ => vec![],
    }
}

fn schema() -> Value {
    serde_json::from_str(include_str!("../schemas/summary.schema.json")).unwrap()
}

#[test]
fn the_summary_is_as_its_schema_says() {
    let schema = schema();
    assert_eq!(schema["properties"]["format"]["const"], FORMAT);
    assert_eq!(schema["properties"]["version"]["const"], VERSION);
    let written: Value = serde_json::from_str(&summary().json().unwrap()).unwrap();
    conforms(&written, &schema, "").unwrap();
    let mut without_digits = summary();
    (without_digits.digits, without_digits.energy.largest) = (None, Number(f64::NAN));
    conforms(&serde_json::from_str(&without_digits.json().unwrap()).unwrap(), &schema, "").unwrap();
}

/// A schema that allows anything would pass the test above.
#[test]
fn the_schema_refuses_other_content() {
    let written: Value = serde_json::from_str(&summary().json().unwrap()).unwrap();
    let wrong = |change: fn(&mut Value)| {
        let mut wrong = written.clone();
        change(&mut wrong);
        conforms(&wrong, &schema(), "").unwrap_err()
    };
    assert!(wrong(|v| v["t_end"] = "inf".into()).contains("t_end"));
    assert!(wrong(|v| v["state"]["theta"] = "nan".into()).contains("state.theta"));
    assert!(wrong(|v| v["energy"]["heat"] = 1.into()).contains("energy.heat"));
    assert!(wrong(|v| v["version"] = 1.into()).contains("version"));
    assert!(wrong(|v| drop(v.as_object_mut().unwrap().remove("refuted"))).contains("refuted"));
}
