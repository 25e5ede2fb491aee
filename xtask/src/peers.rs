//! `cargo xtask peers`: run other tools on our scenes; writes tests/peers.md.
//!
//! Makes a Python environment under target/ and installs the Python tools into it, writes the scenes and their references, builds
//! the Rust tools, and starts tests/peers/main.py, which runs all of them and writes the table.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, bail};

use crate::chore;

/// Run other tools on our scenes; write the table tests/peers.md.
#[derive(clap::Args)]
pub struct Peers {
    /// A tenth of the events, one tolerance per method, one derivation; the table goes to out/peers.md.
    #[arg(long)]
    quick: bool,
}

impl Peers {
    /// Prepares what the tools need, and runs them.
    pub fn run(&self) -> anyhow::Result<()> {
        let root = chore::root()?;
        let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |dir| root.join(dir));
        let (peers, place) = (root.join("tests/peers"), target.join("peers"));
        std::fs::create_dir_all(&place).with_context(|| format!("cannot make the folder {}", place.display()))?;

        let python = python(&peers, &place)?;
        let mut own = Command::new(env!("CARGO"));
        own.args(["build", "--quiet", "--release", "--package", "gearsim-chores", "--bin", "peers"]);
        run(own.current_dir(root), "building our own runs")?;
        let own = target.join("release/peers");
        let scenes = place.join(if self.quick { "quick.json" } else { "scenes.json" });
        let mut write = Command::new(&own);
        write.arg("scenes").args(self.quick.then_some("--quick")).arg("--out").arg(&scenes);
        run(&mut write, "writing the scenes")?;

        let mut rust = Command::new(env!("CARGO"));
        rust.args(["build", "--quiet", "--release", "--locked", "--target-dir"]).arg(place.join("rust"));
        run(rust.current_dir(peers.join("rust")).env_remove("CARGO_TARGET_DIR"), "building the Rust peers")?;

        let table = root.join(if self.quick { "out/peers.md" } else { "tests/peers.md" });
        std::fs::create_dir_all(table.parent().unwrap_or(root))?;
        let mut main = Command::new(&python);
        main.arg("main.py").arg(&scenes).arg(&table).args(self.quick.then_some("--quick")).current_dir(&peers);
        main.env("PEERS_OWN", own).env("PEERS_RUST", place.join("rust/release/gearsim-peers"));
        main.env("CARGO", env!("CARGO")).env("PYTHONPYCACHEPREFIX", place.join("pycache"));
        // Otherwise Python compiles its sources at every start, and that would count as a peer's time.
        main.env_remove("PYTHONDONTWRITEBYTECODE");
        // One thread each, because processor times add up over threads.
        main.envs([("OMP_NUM_THREADS", "1"), ("OPENBLAS_NUM_THREADS", "1")]);
        run(&mut main, "running the peers")?;
        println!("{}", table.display());
        Ok(())
    }
}

/// The interpreter of a Python environment in the folder `place`, with the Python tools installed.
fn python(peers: &Path, place: &Path) -> anyhow::Result<std::path::PathBuf> {
    let python = place.join("venv/bin/python");
    if !python.exists() {
        run(Command::new("python3").args(["-m", "venv"]).arg(place.join("venv")), "making a Python environment")?;
    }
    let mut pip = Command::new(&python);
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"]);
    run(pip.arg(peers.join("requirements.txt")), "installing the Python peers")?;
    Ok(python)
}

fn run(command: &mut Command, what: &str) -> anyhow::Result<()> {
    let status = command.status().with_context(|| format!("{what}: cannot start {:?}", command.get_program()))?;
    if !status.success() {
        bail!("{what} failed; its message is above");
    }
    Ok(())
}
