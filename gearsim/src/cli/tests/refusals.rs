//! Command lines and scenes that must be refused, with the words of the refusal; and results that refute themselves.

use std::path::Path;

use clap::Parser;

use super::{go, scene};
use crate::cli::Verb;
use crate::cli::advise::Advise;
use crate::cli::compare::Compare;
use crate::cli::failure::Failure;
use crate::cli::new::New;
use crate::cli::run::Run;
use crate::cli::sweep::SweepCommand;
use crate::output::Summary;

fn refused<V: Verb + Parser>(arguments: &[&str], said: &str) {
    let root = tempfile::tempdir().unwrap();
    let out = root.path().join("out");
    let failure = go::<V>(&out, arguments).expect_err(said);
    let text = match &failure {
        Failure::Scene(mistakes) => mistakes.render(200, false),
        Failure::Usage(error) => error.to_string(),
        other => other.to_string(),
    };
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains(said), "{arguments:?}: {text}");
    assert_eq!(failure.code(), 2, "{text}");
    assert!(!out.exists(), "{arguments:?}");
}

#[test]
fn steps_that_cannot_be_taken_are_refused() {
    refused::<Run>(&["-q", "--set", "run.step=1 us"], "no method with a fixed step");
    refused::<Run>(&["-q", "--set", "run.method=exact", "--set", "run.step=1 us"], "this method has no steps");
    let rk4 = |step: &'static str| ["-q", "--set", "run.method=rk4", "--set", step];
    refused::<Run>(&rk4("run.step=200 s"), "must be at most the run, 0.1 s");
    refused::<Run>(&rk4("run.step=1e-30 s"), "a run has at most 1e10 steps");
    refused::<Compare>(&rk4("run.step=200 s")[1..], "must be at most the run");
    let vary = ["--vary", "parameters.T0=1 N*m:2 N*m:2"];
    refused::<SweepCommand>(&[&vary[..], &rk4("run.step=200 s")[..]].concat(), "must be at most the run");
}

#[test]
fn more_rows_than_memory_are_refused() {
    refused::<Run>(&["-q", "--set", "output.rate=900 MHz"], "asks for 9.0e7 samples");
    refused::<Run>(&["-q", "--set", "output.most_rows=1e12"], "rows may take 16 GB");
    let both = ["-q", "--set", "output.rate=900 MHz", "--set", "output.most_rows=1e9"];
    refused::<Run>(&both, "rows may take 16 GB");
}

#[test]
fn numbers_of_threads_are_refused_in_plain_words() {
    let vary = ["--vary", "parameters.T0=1 N*m:2 N*m:2", "--threads"];
    for threads in ["0", "1025", "1000000"] {
        refused::<SweepCommand>(&[&vary[..], &[threads]].concat(), "is not in 1..=1024");
    }
}

/// The cause of an overflow is the overflow, not the step of a stiffness.
#[test]
fn a_speed_beyond_the_range_of_numbers_is_named() {
    refused::<Run>(&["-q", "--set", "start.speed=1e300 rpm"], "the energy of the start is beyond the range");
    let root = tempfile::tempdir().unwrap();
    let failure = go::<Run>(root.path(), &["-q", "--set", "start.speed=1e140 rpm"]).unwrap_err().to_string();
    assert!(failure.contains("check the speeds in [start]") && !failure.contains("0.0000000"), "{failure}");
}

const COARSE: [&str; 6] = ["--set", "run.method=rk4", "--set", "run.step=0.2 ms", "--set", "run.t_end=20 ms"];

/// Every command fails with exit code 3 where the energy account refutes a result, and the result says so.
#[test]
fn a_refuted_result_is_a_failure_of_every_command() {
    let root = tempfile::tempdir().unwrap();
    let out = |name: &str| root.path().join(name);
    let code = |result: Result<(), Failure>| result.expect_err("refuted").code();
    assert_eq!(code(go::<Run>(&out("run"), &[&COARSE[..], &["-q"]].concat())), 3);
    let summary = std::fs::read(out("run").join("summary.json")).unwrap();
    let summary: Summary = serde_json::from_slice(&summary).unwrap();
    assert!(summary.completed && summary.refuted.is_some_and(|why| why.contains("unaccounted for")));
    assert_eq!(code(go::<Compare>(&out("compare"), &COARSE)), 3);
    let vary = ["-q", "--vary", "parameters.T0=10 N*m:11 N*m:2"];
    let sweep = go::<SweepCommand>(&out("sweep"), &[&COARSE[..], &vary].concat()).unwrap_err();
    assert!(sweep.code() == 3 && sweep.to_string().contains("results of 2 points are wrong"), "{sweep}");
    let advise: Vec<String> =
        ["gearsim".into(), scene().display().to_string()].into_iter().chain(COARSE.map(Into::into)).collect();
    assert_eq!(code(Advise::try_parse_from(advise).map_err(Failure::Usage).and_then(Advise::run)), 3);
}

#[test]
fn advice_from_a_run_that_stopped_early_is_a_failure() {
    // The samples fit into the rows, but not the events.
    let few = ["--set", "output.most_rows=30", "--set", "output.rate=200 Hz", "--set", "run.t_end=0.1 s"];
    let arguments = ["gearsim".into(), scene().display().to_string()].into_iter().chain(few.map(String::from));
    let failure = Advise::try_parse_from(arguments).map_err(Failure::Usage).and_then(Advise::run).unwrap_err();
    assert_eq!(failure.code(), 3);
    assert!(failure.to_string().contains("stopped early"), "{failure}");
}

/// The model of a new crate has the name of the crate. It would hide a model of gearsim with this name, `train` included.
#[test]
fn a_crate_with_the_name_of_a_model_is_refused() {
    let root = tempfile::tempdir().unwrap();
    for (name, said) in
        [("train", "is a model of gearsim"), ("gear-pair", "is a model of gearsim"), ("async", "is reserved")]
    {
        let folder = root.path().join(name);
        let command = New::try_parse_from(["gearsim", &folder.display().to_string()]);
        let failure = command.map_err(Failure::Usage).and_then(New::run).unwrap_err();
        assert!(failure.to_string().contains(said) && !folder.exists(), "{failure}");
    }
}

/// A command that cannot print has failed.
#[test]
#[cfg(unix)]
fn a_full_standard_output_is_a_failure() {
    if !Path::new("/dev/full").exists() {
        return;
    }
    let error = std::io::Error::from(std::io::ErrorKind::StorageFull);
    crate::cli::terminal::note(Err(std::io::ErrorKind::BrokenPipe.into()));
    assert_eq!(crate::cli::terminal::failed(), None);
    crate::cli::terminal::note(Err(error));
    assert!(crate::cli::terminal::failed().is_some());
}
