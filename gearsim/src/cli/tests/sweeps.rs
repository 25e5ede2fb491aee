//! Tests of `gearsim sweep` and `gearsim merge`: results that do not depend on threads, shards and interruptions, and refusals.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::Path;

use clap::Parser;

use super::{go, scene};
use crate::cli::Verb;
use crate::cli::failure::Failure;
use crate::cli::merge::Merge;
use crate::cli::provenance;
use crate::cli::sweep::SweepCommand;
use crate::known::MODELS;
use crate::output::parquet;
use crate::sweep::folder::Folder;
use crate::sweep::{Manifest, Request, Sweep};

/// Points whose run times differ; those with the second value of I1 are refused.
const VARY: [&str; 2] = ["start.speed=100 rpm:900 rpm:5", "parameters.I1=2890 kg*mm^2,1e-300 kg*m^2,3000 kg*mm^2"];
const SET: [&str; 2] = ["run.t_end=0.02 s", "output.rate=20 kHz"];

fn arguments<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let vary = VARY.iter().flat_map(|axis| ["--vary", axis]);
    let set = SET.iter().flat_map(|value| ["--set", value]);
    vary.chain(set).chain(["-q"]).chain(more.iter().copied()).collect()
}

fn sweep(out: &Path, more: &[&str]) -> Result<(), Failure> {
    go::<SweepCommand>(out, &arguments(more))
}

fn merge(from: &[&Path], out: &Path) -> Result<(), Failure> {
    let from = from.iter().map(|path| path.display().to_string());
    let all = ["gearsim".to_owned()].into_iter().chain(from);
    let all = all.chain(["--out".into(), out.display().to_string(), "-q".into()]);
    Merge::try_parse_from(all).map_err(Failure::Usage).and_then(Merge::run)
}

/// The names and bytes of all files in a folder.
fn content(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let mut files: Vec<_> =
        entries.map(|e| (e.file_name().into_string().unwrap(), std::fs::read(e.path()).unwrap_or_default())).collect();
    files.sort();
    files
}

fn assert_same(a: &Path, b: &Path) {
    let names = |folder: &Path| content(folder).into_iter().map(|(name, _)| name).collect::<Vec<_>>();
    assert_eq!(names(a), names(b));
    for (a, b) in content(a).iter().zip(content(b)) {
        assert!(a.1 == b.1, "{} differs", a.0);
    }
}

#[test]
fn results_do_not_depend_on_threads_and_shards() {
    let root = tempfile::tempdir().unwrap();
    let at = |name: &str| root.path().join(name);
    sweep(&at("one"), &["--threads", "1"]).unwrap();
    let names: Vec<_> = content(&at("one")).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["map_phi_max.png", "map_phi_max.svg", "sweep.json", "sweep.parquet"]);
    sweep(&at("two"), &["--threads", "2"]).unwrap();
    assert_same(&at("one"), &at("two"));

    for shard in 1..=3 {
        sweep(&at(&format!("s{shard}")), &["--shard", &format!("{shard}/3")]).unwrap();
    }
    merge(&[&at("s2"), &at("s3"), &at("s1")], &at("merged")).unwrap();
    assert_same(&at("one"), &at("merged"));

    // Shards written into one folder, one after the other, give the same files.
    for shard in ["2/2", "1/2"] {
        sweep(&at("together"), &["--shard", shard]).unwrap();
    }
    assert_same(&at("one"), &at("together"));
}

#[test]
fn the_table_has_one_row_per_point_in_order() {
    let root = tempfile::tempdir().unwrap();
    sweep(root.path(), &[]).unwrap();
    let (table, provenance) = parquet::read(&root.path().join("sweep.parquet")).unwrap();
    let points: Vec<f64> = (0..15).map(f64::from).collect();
    assert_eq!(table.numbers("point").unwrap(), points);
    let speed = table.numbers("start.speed").unwrap();
    // In rad/s; the tolerance allows for the rounding of a product and a quotient.
    for (i, rpm) in [(0, 100.0), (14, 900.0)] {
        assert!((speed[i] / (rpm * std::f64::consts::PI / 30.0) - 1.0).abs() < 1e-15, "{}", speed[i]);
    }
    assert_eq!(table.numbers("parameters.I1").unwrap()[2], 3e-3);
    let status = table.words("status").unwrap();
    let refused: Vec<usize> = (0..15).filter(|&i| status[i] == "refused").collect();
    assert_eq!(refused, [1, 4, 7, 10, 13]);
    assert!(table.words("reason").unwrap()[1].contains("mass matrix"));
    assert!(table.numbers("phi_max").unwrap()[1].is_nan() && table.numbers("phi_max").unwrap()[2] > 0.0);
    assert!(provenance.iter().any(|(name, value)| name == "sweep" && value.contains("100 rpm:900 rpm:5")));
}

#[test]
fn an_interrupted_sweep_that_is_continued_equals_an_uninterrupted_one() {
    let root = tempfile::tempdir().unwrap();
    let (whole, cut) = (root.path().join("whole"), root.path().join("cut"));
    sweep(&whole, &[]).unwrap();
    {
        let request = Request {
            vary: VARY.map(Into::into).into(),
            overrides: SET.map(Into::into).into(),
            record: ["events", "state", "digits", "energy", "extremes"].map(Into::into).into(),
            ..Request::default()
        };
        let sweep = Sweep::load(&scene(), MODELS, &request).unwrap();
        let manifest = Manifest::new(&sweep, &request, provenance::COMMIT);
        let layout = manifest.layout(MODELS).unwrap();
        let mut folder = Folder::open(&cut, manifest.clone(), layout.clone()).unwrap();
        for points in [&[3, 1, 2][..], &[14], &[7, 9, 12]] {
            sweep
                .run(points, NonZeroUsize::MIN, |rows| Ok(folder.keep(&rows)?), |_| ControlFlow::Continue(()))
                .unwrap();
        }
        assert_eq!(folder.rows().unwrap().len(), 7);
        // While the folder is open, another process is refused.
        let failure = super::sweeps::sweep(&cut, &[]).unwrap_err();
        assert!(failure.to_string().contains("another gearsim process writes to"), "{failure}");
    }
    let parts: Vec<_> = content(&cut.join("parts")).into_iter().map(|(name, _)| name).collect();
    assert_eq!(parts, ["lock", "rows-00000001.parquet", "rows-00000007.parquet", "rows-00000014.parquet"]);
    std::fs::remove_file(cut.join("parts/rows-00000007.parquet")).unwrap();
    // A temporary file that a crash may leave behind.
    std::fs::write(cut.join("parts/.gearsim-x"), "half").unwrap();
    sweep(&cut, &[]).unwrap();
    assert_same(&whole, &cut);
    // Run again: no points are left to run, and no file changes.
    sweep(&cut, &[]).unwrap();
    assert_same(&whole, &cut);
}

#[test]
fn spectra_are_stored_and_merged() {
    let root = tempfile::tempdir().unwrap();
    let at = |name: &str| root.path().join(name);
    let run = |out: &Path, more: &[&str]| {
        let all = [
            "--vary",
            VARY[0],
            "--set",
            SET[0],
            "--set",
            SET[1],
            "-q",
            "--waterfall",
            "--record",
            "peak",
            "--from",
            "5 ms",
        ];
        go::<SweepCommand>(out, &[&all, more].concat())
    };
    run(&at("whole"), &["--map", "phi_peak_frequency"]).unwrap();
    let names: Vec<_> = content(&at("whole")).into_iter().map(|(name, _)| name).collect();
    assert!(names.contains(&"waterfall_phi.png".into()) && names.contains(&"spectra.parquet".into()), "{names:?}");
    run(&at("a"), &["--shard", "1/2"]).unwrap();
    run(&at("b"), &["--shard", "2/2"]).unwrap();
    merge(&[&at("a"), &at("b")], &at("merged")).unwrap();
    for file in ["sweep.json", "sweep.parquet", "spectra.parquet"] {
        let read = |folder: &str| std::fs::read(at(folder).join(file)).unwrap();
        assert!(read("whole") == read("merged"), "{file} differs");
    }
}

#[test]
fn a_folder_of_another_sweep_and_shards_that_do_not_match_are_refused_with_the_difference() {
    let root = tempfile::tempdir().unwrap();
    let at = |name: &str| root.path().join(name);
    for shard in ["1/3", "2/3"] {
        sweep(&at(&shard[..1]), &["--shard", shard]).unwrap();
    }
    let before = content(&at("1"));
    for (more, named) in [
        (["--set", "parameters.zeta=0.2"], "values set"),
        (["--vary", "parameters.zeta=0.2,0.3"], "axes"),
        (["--from", "1 ms"], "from [s]: 0.001 here, 0 there"),
        (["--record", "energy"], "recorded"),
        (["--seed", "5"], "seed"),
    ] {
        let failure = sweep(&at("1"), &more).unwrap_err();
        assert!(failure.code() == 2 && failure.to_string().contains("holds another sweep"), "{failure}");
        assert!(failure.to_string().contains(named), "{failure}");
    }
    assert!(before == content(&at("1")));

    let failure = merge(&[&at("1"), &at("2")], &at("out")).unwrap_err().to_string();
    assert!(failure.contains("5 of 15 points are missing: 2, 5, 8, 11, 14"), "{failure}");
    let failure = merge(&[&at("1"), &at("2"), &at("1")], &at("out")).unwrap_err().to_string();
    assert!(failure.contains("points 0, 3, 6, 9, 12 are in") && failure.contains("every shard once"), "{failure}");
    sweep(&at("other"), &["--shard", "3/3", "--seed", "1"]).unwrap();
    let failure = merge(&[&at("1"), &at("2"), &at("other")], &at("out")).unwrap_err().to_string();
    assert!(failure.contains("different sweeps") && failure.contains("seed: 1 here, 0 there"), "{failure}");
    let failure = merge(&[root.path()], &at("out")).unwrap_err().to_string();
    assert!(failure.contains("holds no sweep"), "{failure}");
    assert!(!at("out").exists());
}

#[test]
fn a_refused_sweep_writes_nothing() {
    let root = tempfile::tempdir().unwrap();
    let out = root.path().join("out");
    let cases: [(&[&str], &str); 7] = [
        (&["--vary", "parameters.T0=1:x:3"], "a mistake"),
        (&["--map", "phi_maxx"], "did you mean `phi_max`?"),
        (&["--waterfall"], "exactly one --vary"),
        (&["--from", "3 m"], "a time is required"),
        (&["--from", "1 s"], "the run ends at 0.02 s"),
        (&["--shard", "4/3"], "I/N"),
        (&["--threads", "0"], "threads"),
    ];
    for (more, expected) in cases {
        let failure = sweep(&out, more).unwrap_err();
        assert_eq!(failure.code(), 2, "{more:?}");
        assert!(failure.to_string().contains(expected), "{more:?}: {failure}");
    }
    assert!(content(root.path()).is_empty());
}

/// If three bytes anywhere in a part are changed, the merge never has other numbers: it is refused, or it does not read these bytes.
#[test]
fn a_damaged_part_is_not_merged() {
    let root = tempfile::tempdir().unwrap();
    let at = |name: &str| root.path().join(name);
    for shard in ["1/2", "2/2"] {
        sweep(&at(&format!("s{}", &shard[..1])), &["--shard", shard]).unwrap();
    }
    merge(&[&at("s1"), &at("s2")], &at("whole")).unwrap();
    let part = at("s2").join("sweep.parquet");
    let bytes = std::fs::read(&part).unwrap();
    let (mut refused, places) = (0, 61);
    for i in 0..places {
        let mut damaged = bytes.clone();
        let at_byte = i * (bytes.len() - 3) / places;
        damaged[at_byte..at_byte + 3].iter_mut().for_each(|byte| *byte ^= 0x5a);
        std::fs::write(&part, damaged).unwrap();
        let out = at(&format!("merged{i}"));
        match merge(&[&at("s1"), &at("s2")], &out) {
            Ok(()) => assert_same(&at("whole"), &out),
            Err(_) => refused += 1,
        }
    }
    assert!(refused > places / 2, "{refused} of {places}");
}

#[test]
fn a_merge_does_not_overwrite_its_input() {
    let root = tempfile::tempdir().unwrap();
    let at = |name: &str| root.path().join(name);
    for shard in ["1/2", "2/2"] {
        sweep(&at(&format!("s{}", &shard[..1])), &["--shard", shard]).unwrap();
    }
    let before = content(&at("s1"));
    let failure = merge(&[&at("s1"), &at("s2")], &at("s2").join("../s1")).unwrap_err();
    assert!(failure.code() == 2 && failure.to_string().contains("one of the folders to merge"), "{failure}");
    assert!(content(&at("s1")) == before);
}
