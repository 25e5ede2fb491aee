//! The commands under test.

/// The words of a command line.
type Words = &'static [&'static str];

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/oh2005/energy_300rpm.toml");
const TWO_STAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/response.toml");
const SHORT: &str = "run.t_end=1 ms";
const LONGER: &str = "run.t_end=2 ms";

/// A command and the state of its folder before it. Its words are relative to the folder of a case; its results go to the folder `out`.
pub struct Command {
    /// Its name in the table.
    pub name: &'static str,
    /// The commands that run first. They make the earlier result, and the files that the command reads.
    pub before: &'static [Words],
    /// The words of the command.
    pub words: Words,
    /// Whether two runs write the same bytes, apart from the processor time in JSON.
    pub repeatable: bool,
    /// Whether the command replaces its earlier result. Otherwise it refuses a folder that exists.
    pub replaces: bool,
}

const fn command(name: &'static str, before: &'static [Words], words: Words) -> Command {
    Command { name, before, words, repeatable: true, replaces: true }
}

const PLOT: &str = "output.plots=[\"energy\"]";
const NO_PLOT: &str = "output.plots=[]";
const SPEEDS: &str = "start.speed=300 rpm:600 rpm:3";
const STABILITY: &str = "start.speed=4000 rpm:8000 rpm:4";
const RUN: Words = &["run", SCENE, "--out", "out", "--csv", "--set", LONGER, "--set", PLOT];
const RUN_AGAIN: Words =
    &["run", SCENE, "--out", "out", "--set", SHORT, "--set", NO_PLOT, "--set", "output.rate=200 kHz"];
const COMPARE: Words = &["compare", SCENE, "--out", "out", "--set", LONGER, "--set", PLOT];
const COMPARE_AGAIN: Words = &["compare", SCENE, "--out", "out", "--set", SHORT, "--set", NO_PLOT];
const SWEEP: Words = &["sweep", SCENE, "--out", "out", "--set", SHORT, "--vary", SPEEDS, "--csv"];
const SWEEP_AGAIN: Words = &["sweep", SCENE, "--out", "out", "--set", SHORT, "--vary", SPEEDS, "--map", "cell_changes"];
const SHARD_1: Words = &["sweep", SCENE, "--out", "one", "--set", SHORT, "--vary", SPEEDS, "--shard", "1/2"];
const SHARD_2: Words = &["sweep", SCENE, "--out", "two", "--set", SHORT, "--vary", SPEEDS, "--shard", "2/2"];
const MERGE: Words = &["merge", "one", "two", "--out", "out", "--csv"];
const MERGE_AGAIN: Words = &["merge", "one", "two", "--out", "out", "--map", "cell_changes"];
const MODES: Words = &["modes", SCENE, "--out", "out"];
const MODES_AGAIN: Words = &["modes", SCENE, "--out", "out", "--cell", "1"];
const FLOQUET: Words = &["floquet", SCENE, "--out", "out", "--vary", STABILITY];
const FLOQUET_AGAIN: Words = &["floquet", SCENE, "--out", "out"];
const RESPONSE: Words = &[
    "response",
    TWO_STAGE,
    "--out",
    "out",
    "--over",
    "start.speed=2200 rpm,2300 rpm",
    "--output",
    "dte_12",
    "--settle",
    "1 ms",
    "--set",
    LONGER,
];
const RESPONSE_AGAIN: Words = &[
    "response",
    TWO_STAGE,
    "--out",
    "out",
    "--over",
    "start.speed=2200 rpm,2400 rpm",
    "--output",
    "dte_12",
    "--settle",
    "1 ms",
    "--set",
    LONGER,
    "--up",
];
const WORK_PRECISION: Words =
    &["work-precision", SCENE, "--out", "out", "--set", "run.t_end=0.1 ms", "--repetitions", "1"];
const WORK_PRECISION_AGAIN: Words =
    &["work-precision", SCENE, "--out", "out", "--set", "run.t_end=0.2 ms", "--repetitions", "1"];

/// All of them. Those without a folder only print.
pub const COMMANDS: &[Command] = &[
    command("run", &[], RUN),
    command("run again", &[RUN], RUN_AGAIN),
    command("compare", &[COMPARE], COMPARE_AGAIN),
    command("sweep", &[], SWEEP),
    command("sweep again", &[SWEEP], SWEEP_AGAIN),
    command("merge", &[SHARD_1, SHARD_2], MERGE),
    command("merge again", &[SHARD_1, SHARD_2, MERGE], MERGE_AGAIN),
    command("modes", &[MODES], MODES_AGAIN),
    command("floquet", &[FLOQUET], FLOQUET_AGAIN),
    command("response", &[RESPONSE], RESPONSE_AGAIN),
    Command { repeatable: false, ..command("work-precision", &[WORK_PRECISION], WORK_PRECISION_AGAIN) },
    Command { replaces: false, ..command("new", &[], &["new", "out"]) },
    command("man", &[], &["man", "out"]),
    command("advise", &[], &["advise", SCENE, "--set", SHORT]),
    command("check", &[], &["check", SCENE]),
    command("scene", &[], &["scene", "gear_pair"]),
    command("models", &[], &["models"]),
    command("model", &[], &["models", "gear_pair"]),
    command("help", &[], &["--help"]),
    command("completions", &[], &["completions", "bash"]),
];
