//! A scene of any model with any effects, numbers, method and precision must pass `CHECKS`.

use std::sync::LazyLock;

use gearsim::Scene;

use crate::checks::{CHECKS, Checked};
use crate::draw;
use crate::random::Random;

static BASES: LazyLock<Vec<Scene>> = LazyLock::new(draw::bases);

/// The bytes are the random numbers by which the scene is drawn.
pub fn check(data: &[u8]) {
    let mut random = Random::of_bytes(data);
    let case = draw::drawn(draw::base(&BASES, &mut random), random);
    for (name, check) in CHECKS {
        if let Checked::Wrong(why) = check(&case) {
            panic!("{name}: {why}\n{}", case.command());
        }
    }
}
