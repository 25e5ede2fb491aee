//! A folder of a sweep with changed bytes: its rows are read as they were written, or the folder is refused with a message.

use std::fs;
use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::{LazyLock, Mutex, PoisonError};

use gearsim::__private::{Folder, Manifest, Request, Sweep, Template, gather};

const SCENE: &str = include_str!("../../../models/scenes/oh2005/energy_300rpm.toml");
/// The files that are changed.
const FILES: [&str; 2] = ["sweep.json", "parts/rows-00000000.parquet"];

/// A folder that holds all points of a small sweep.
struct Sound {
    folder: tempfile::TempDir,
    /// What [`FILES`] hold.
    files: [Vec<u8>; 2],
    rows: String,
}

static SOUND: LazyLock<Mutex<Sound>> = LazyLock::new(|| Mutex::new(Sound::new()));

impl Sound {
    fn new() -> Sound {
        let request = Request {
            vary: vec!["parameters.T0=1 N*m,2 N*m,3 N*m".into()],
            overrides: vec!["run.t_end=1 ms".into()],
            record: vec!["events".into(), "state".into()],
            ..Request::default()
        };
        let template = Template::parse("fuzz", "fuzz.toml", SCENE, &request.overrides).unwrap();
        let sweep = Sweep::of(template, gearsim::models(), &request).unwrap();
        let manifest = Manifest::new(&sweep, &request, None);
        let layout = manifest.layout(gearsim::models()).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let mut kept = Folder::open(folder.path(), manifest, layout).unwrap();
        let mut rows = vec![];
        let keep = |new| {
            rows.extend(new);
            Ok(())
        };
        sweep.run(&[0, 1, 2], NonZeroUsize::MIN, keep, |_| ControlFlow::Continue(())).unwrap();
        kept.keep(&rows).unwrap();
        drop(kept);
        let path = folder.path().to_owned();
        let files = FILES.map(|file| fs::read(path.join(file)).unwrap());
        let rows = read(&path).expect("the folder is whole");
        Sound { folder, files, rows }
    }
}

/// The rows in a folder as text that shows all bits of their numbers. The error is the reason why the folder is refused.
fn read(folder: &PathBuf) -> Result<String, String> {
    let gathered = gather(std::slice::from_ref(folder), gearsim::models());
    gathered.map(|(_, _, rows)| format!("{rows:?}")).map_err(|error| error.to_string())
}

/// Each change takes four bytes: the file, a place in it (two bytes), and the new byte. If the first byte of the case is odd, the first
/// change instead cuts its file off at its place.
pub fn check(data: &[u8]) {
    let Some((kind, changes)) = data.split_first() else { return };
    let sound = SOUND.lock().unwrap_or_else(PoisonError::into_inner);
    let mut files = sound.files.clone();
    for (i, change) in changes.chunks_exact(4).enumerate() {
        let file = &mut files[usize::from(change[0]) % FILES.len()];
        if file.is_empty() {
            continue;
        }
        // Places are spread over the file, which is smaller than 2^16 bytes.
        let at = usize::from(u16::from_le_bytes([change[1], change[2]])) % file.len();
        match i == 0 && kind % 2 == 1 {
            true => file.truncate(at),
            false => file[at] = change[3],
        }
    }
    let path = sound.folder.path().to_owned();
    for (name, content) in FILES.iter().zip(&files) {
        fs::write(path.join(name), content).unwrap();
    }
    match read(&path) {
        // The manifest also records the origin and the time of the scene. A change of these texts does not change the rows.
        Ok(rows) => assert_eq!(rows, sound.rows, "changed files give other rows"),
        Err(why) => assert!(!why.trim().is_empty(), "refused without a reason"),
    }
}
