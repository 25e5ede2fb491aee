//! A small disk, on which there is no space left after some of the result.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::fault::Fault;
use crate::prepared::Prepared;
use crate::state::Files;

/// A page of memory, by which the disk counts [bytes].
const PAGE: usize = 4096;
/// Size at which every result has space, as `mount` wants it.
const LARGE: &str = "remount,size=64m";

/// A disk in memory; unmounted when dropped.
pub struct Disk(PathBuf);

impl Disk {
    /// Mounts a disk of `size` bytes at `place`.
    pub fn mount(place: &Path, size: usize) -> Disk {
        let output = mount(&format!("size={size}"), place);
        assert!(output.is_some_and(|output| output.status.success()), "cannot mount a disk at {}", place.display());
        Disk(place.to_owned())
    }

    /// Gives the disk space for every result.
    pub fn enlarge(&self) {
        assert!(mount(LARGE, &self.0).is_some_and(|output| output.status.success()));
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        // Lazily: a process that another thread starts holds the open files of this one for a moment, and the disk would be busy.
        let _ = Command::new("umount").arg("--lazy").arg(&self.0).output();
    }
}

/// `mount` with these options; `None` if there is no such program.
fn mount(options: &str, place: &Path) -> Option<Output> {
    Command::new("mount").args(["-t", "tmpfs", "-o", options, "none"]).arg(place).output().ok()
}

/// Whether this process may mount a disk.
fn may_mount() -> bool {
    let place = tempfile::tempdir().unwrap();
    let mounted = mount("size=4096", place.path()).is_some_and(|output| output.status.success());
    if mounted {
        drop(Disk(place.path().to_owned()));
    }
    mounted
}

/// Disks with space for some tenths of what the command adds to the files before it.
pub fn faults(prepared: &Prepared) -> Vec<Fault> {
    if !prepared.writes() {
        return vec![];
    }
    if !may_mount() {
        crate::say("no disk can be mounted here: the cases of a full disk are skipped\n");
        return vec![];
    }
    let (old, new) = (space(&prepared.old), space(&prepared.new));
    let disk = |tenth: usize| Fault {
        what: format!("a disk with space for {tenth} tenths of the result"),
        disk: Some(old + (new * tenth / 10).next_multiple_of(PAGE) + PAGE),
        says: Some("no space left"),
        ..Fault::default()
    };
    [0, 1, 2, 4, 6, 8].map(disk).into()
}

/// The space that files take on a disk [bytes], without their folders.
fn space(files: &Files) -> usize {
    files.values().map(|content| content.len().next_multiple_of(PAGE)).sum()
}
