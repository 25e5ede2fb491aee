//! Tests of sweeps without the command line.

mod mistakes;
mod points;
mod response;

use std::path::{Path, PathBuf};

use super::{Error, Request, Sweep};
use crate::known::MODELS;

pub(super) fn scene() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes/oh2005/energy_300rpm.toml")
}

pub(super) fn request(vary: &[&str]) -> Request {
    Request {
        vary: vary.iter().map(|text| text.to_string()).collect(),
        overrides: vec!["run.t_end=0.02 s".into(), "output.rate=20 kHz".into()],
        record: ["events", "state", "energy", "extremes"].map(Into::into).into(),
        ..Request::default()
    }
}

pub(super) fn load(request: &Request) -> Result<Sweep, Error> {
    Sweep::load(&scene(), MODELS, request)
}
