//! A scene: the equations of Oh, Grosh & Barber (2005) within a cell, Eqs. (2), (3), and their jump, Eqs. (9), (11).
//!
//! y = [theta, theta', phi, phi'], theta from the lower end of the cell. The same as tests/peers/scene.py.

use anyhow::Context;
use serde_json::{Value, json};

/// The numbers of a scene, in SI units.
pub struct Scene {
    pub m1: f64,
    pub m2: f64,
    pub c: f64,
    pub t0: f64,
    pub k: [f64; 2],
    pub width: [f64; 2],
    pub start: [f64; 4],
    pub sizes: [f64; 4],
    pub t_end: f64,
}

/// A motion: the present time, cell and state, and the events so far.
pub struct Motion {
    pub t: f64,
    pub cell: i64,
    pub y: [f64; 4],
    events: Vec<(f64, &'static str, i64)>,
}

impl Scene {
    /// Reads a scene from the file that `cargo xtask peers` wrote.
    pub fn read(file: &str, name: &str) -> anyhow::Result<Scene> {
        let scenes: Value = serde_json::from_str(&std::fs::read_to_string(file)?)?;
        let scenes = scenes.as_array().context("scenes are a list")?;
        let scene = scenes.iter().find(|s| s["name"] == name).with_context(|| format!("no scene `{name}`"))?;
        let number = |key: &str| scene[key].as_f64().with_context(|| format!("no number `{key}`"));
        Ok(Scene {
            m1: number("m1")?,
            m2: number("m2")?,
            c: number("c")?,
            t0: number("t0")?,
            k: serde_json::from_value(scene["k"].clone())?,
            width: serde_json::from_value(scene["width"].clone())?,
            start: serde_json::from_value(scene["start"].clone())?,
            sizes: serde_json::from_value(scene["sizes"].clone())?,
            t_end: number("t_end")?,
        })
    }

    /// Stiffness [N m] and extent [rad] of a cell.
    pub fn cell(&self, cell: i64) -> (f64, f64) {
        let side = cell.rem_euclid(2) as usize;
        (self.k[side], self.width[side])
    }

    /// y' within a cell of stiffness `k`.
    pub fn slope(&self, k: f64, y: &[f64], out: &mut [f64]) {
        let pull = self.t0 - k * y[2] - self.c * y[3];
        out.copy_from_slice(&[y[1], self.m1 * pull, y[3], self.m2 * pull]);
    }

    /// The directional derivative of y' along `v`.
    pub fn slope_along(&self, k: f64, v: &[f64], out: &mut [f64]) {
        let pull = -k * v[2] - self.c * v[3];
        out.copy_from_slice(&[v[1], self.m1 * pull, v[3], self.m2 * pull]);
    }

    /// Absolute tolerances: `tolerance` times the size of each coordinate.
    pub fn atol(&self, tolerance: f64) -> Vec<f64> {
        self.sizes.iter().map(|size| tolerance * size).collect()
    }

    /// The motion at its start.
    pub fn begin(&self) -> Motion {
        Motion { t: 0.0, cell: 0, y: self.start, events: vec![] }
    }
}

impl Motion {
    /// Applies the jump rule at an end of the cell, which was met at `t` in the state `y`.
    pub fn jump(&mut self, scene: &Scene, t: f64, y: &[f64], upwards: bool) {
        let beyond = if upwards { self.cell + 1 } else { self.cell - 1 };
        let ((k, width), (k_beyond, width_beyond)) = (scene.cell(self.cell), scene.cell(beyond));
        let (theta_dot, phi, phi_dot) = (y[1], y[2], y[3]);
        let step = scene.m2 * (k_beyond - k) * phi * phi;
        let (square, ratio) = (theta_dot * theta_dot - step, scene.m1 / scene.m2);
        self.t = t;
        if square < 0.0 {
            self.y = [if upwards { width } else { 0.0 }, -theta_dot, phi, phi_dot - 2.0 * ratio * theta_dot];
            self.events.push((t, "reflect", self.cell));
            return;
        }
        let after = square.sqrt().copysign(theta_dot);
        let total = after + theta_dot;
        let change = if total == 0.0 { 0.0 } else { -step / total };
        self.y = [if upwards { 0.0 } else { width_beyond }, after, phi, phi_dot + ratio * change];
        self.cell = beyond;
        self.events.push((t, "transmit", self.cell));
    }

    /// The JSON that every peer prints.
    pub fn json(&self) -> Value {
        json!({ "events": self.events, "cell": self.cell, "end": self.y })
    }
}
