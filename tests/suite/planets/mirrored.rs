//! A planar stage and its mirror image.

use crate::{common, meshes, run};

/// A mirror on the line through the centre of planet 1 reverses all rotations, exchanges planets 2 and 3, and turns drive flanks into coast
/// flanks. Motions along this line (x), and of planets away from the sun (zeta), keep their sign. All other motions change it.
#[test]
fn a_mirror_exchanges_the_flanks_of_planets() {
    let of = |mirrored: bool| {
        let sign = if mirrored { -1.0 } else { 1.0 };
        let mut all = vec![
            "effects=[\"stiffness_step\",\"torques\",\"damping\",\"backlash\"]".to_string(),
            "parameters.beta_K=\"3 us\"".into(),
            format!(
                "parameters.T_motor={{mean=\"{} N*m\",harmonics=[{{amplitude=\"{} N*m\",frequency=\"300 Hz\"}}]}}",
                60.0 * sign,
                500.0 * sign
            ),
            format!("parameters.T_load=\"{} N*m\"", 280.0 * sign),
            format!("start.speed=\"{} rpm\"", 800.0 * sign),
            "run={t_end=\"3 ms\",method=\"exact\"}".into(),
            "output.rate=\"20 kHz\"".into(),
        ];
        for (i, mesh) in meshes(3).iter().enumerate() {
            let at = if mirrored { [0, 1, 4, 5, 2, 3][i] } else { i };
            all.push(format!("laws.k_{mesh}={{steps=[{{value=\"{} MN/m\"}}]}}", 300 + 40 * at));
            all.push(format!("parameters.b_{mesh}=\"{} um\"", 30 + 4 * at));
        }
        run("planar_planetary_3", 3, &all.iter().map(String::as_str).collect::<Vec<_>>(), &[])
    };
    let (drives, coasts) = (of(false), of(true));
    assert!(drives.counts.impacts > 10, "{:?}", drives.counts);
    assert_eq!(drives.counts.impacts, coasts.counts.impacts);
    let model = common::model("planar_planetary_3").model;
    let names: Vec<&str> = model.coordinates.iter().map(|c| c.name).collect();
    for (i, name) in names.iter().enumerate() {
        let image = match name.split_at(name.len() - 1) {
            (of, "2") => format!("{of}3"),
            (of, "3") => format!("{of}2"),
            _ => name.to_string(),
        };
        let stays = name.starts_with("x_") || name.starts_with("zeta");
        let j = names.iter().position(|other| *other == image).unwrap_or_else(|| panic!("no {image}"));
        let (a, b) = (&drives.trajectory.q[i], &coasts.trajectory.q[j]);
        assert_eq!(a.len(), b.len());
        let size = a.iter().fold(1e-9, |m: f64, x| m.max(x.abs()));
        let apart = a.iter().zip(b).map(|(a, b)| (if stays { a - b } else { a + b }).abs()).fold(0.0, f64::max);
        println!("{name} and {image}: {apart:.1e} of {size:.1e}");
        assert!(apart < 1e-8 * size, "{name} and {image}: {apart:e} of {size:e}");
    }
}
