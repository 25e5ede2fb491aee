//! The committed plots of some scenes against those that are drawn now.

use std::path::Path;

use resvg::tiny_skia::Pixmap;

use crate::scene::Scene;

/// Scenes that run in some milliseconds, with the plots that `cargo xtask gallery` keeps of them: many curves, marked lines.
const SCENES: [(&str, &str); 3] = [("damaged_tooth", "orders"), ("backlash", "motion"), ("geared_branches", "motion")];
/// Share of the pixels that rounding errors of another processor may change. Another colour of a curve or another place of a label changes
/// more.
const OTHER: f64 = 1e-3;

/// A change of colours, dashes or layout needs `cargo xtask gallery`.
#[test]
fn the_gallery_is_what_is_drawn_now() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    for (name, plot) in SCENES {
        let committed = std::fs::read(scenes.join("plots").join(name).with_extension("png")).unwrap();
        let results = Scene::load(scenes.join(name).with_extension("toml")).unwrap().run().unwrap();
        let drawn = results.plot(plot).unwrap().png().unwrap();
        let [committed, drawn] = [&committed, &drawn].map(|png| Pixmap::decode_png(png).unwrap());
        assert_eq!((committed.width(), committed.height()), (drawn.width(), drawn.height()), "{name}: another size");
        let other = committed.pixels().iter().zip(drawn.pixels()).filter(|(a, b)| a != b).count();
        let share = other as f64 / drawn.pixels().len() as f64;
        assert!(share <= OTHER, "{name}: {share:.1e} of the pixels differ; run `cargo xtask gallery`");
    }
}
