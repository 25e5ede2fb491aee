//! Colours of curves: apart from each other for people who see red or green weakly, and visible on their ground.

/// Linear red, green and blue as seen without the cones for red, or for green: Machado, Oliveira & Fernandes (2009), IEEE Trans. Vis.
/// Comput. Graph. 15(6), severity 1.
const SEEN: [(&str, [[f64; 3]; 3]); 3] = [
    ("all", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    ("no red", [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]),
    ("no green", [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]),
];
/// Least distance of two colours in CIELAB. A distance of 2.3 is just noticeable where the colours touch.
const APART: f64 = 17.0;
/// Least contrast of a line to its ground, as WCAG 2.1 (1.4.11) asks of graphics.
const CONTRAST: f64 = 3.0;

type Colour = [f64; 3];

/// A colour `#rrggbb` in linear light.
fn linear(text: &str) -> Colour {
    std::array::from_fn(|i| {
        let c = f64::from(u8::from_str_radix(&text[1 + 2 * i..3 + 2 * i], 16).unwrap()) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    })
}

fn dot(a: &Colour, b: &Colour) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn lab(colour: &Colour) -> Colour {
    const XYZ: [Colour; 3] = [[0.43394, 0.37621, 0.18983], [0.21267, 0.71515, 0.07218], [0.01776, 0.10947, 0.87294]];
    let [x, y, z] = XYZ.map(|row| {
        let c = dot(&row, colour);
        if c > 0.008856 { c.cbrt() } else { 7.787 * c + 16.0 / 116.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn luminance(colour: &Colour) -> f64 {
    dot(&[0.2126, 0.7152, 0.0722], colour)
}

/// The grounds of the style sheet, light and dark, each with its colours of curves.
fn palettes() -> Vec<(Colour, Vec<Colour>)> {
    let css = include_str!("../assets/page.css");
    let after = |line: &str, name: &str| linear(line.split_once(name).unwrap().1.split(';').next().unwrap().trim());
    let grounds = css.lines().filter(|line| line.contains("--ground: #")).map(|line| after(line, "--ground:"));
    let curves = css.lines().filter(|line| line.contains("--curve-0: #"));
    grounds.zip(curves.map(|line| (0..7).map(|i| after(line, &format!("--curve-{i}:"))).collect())).collect()
}

#[test]
fn curves_differ_for_all_eyes_and_from_their_ground() {
    let palettes = palettes();
    assert_eq!(palettes.len(), 2);
    for (ground, curves) in palettes {
        for (i, curve) in curves.iter().enumerate() {
            let (a, b) = (luminance(curve), luminance(&ground));
            let contrast = (a.max(b) + 0.05) / (a.min(b) + 0.05);
            assert!(contrast >= CONTRAST, "curve {i} has contrast {contrast:.1}");
            for (eyes, seen) in SEEN {
                let seen = |colour: &Colour| lab(&seen.map(|row| dot(&row, colour).clamp(0.0, 1.0)));
                for (j, other) in curves.iter().enumerate().skip(i + 1) {
                    let (a, b) = (seen(curve), seen(other));
                    let apart = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
                    assert!(apart >= APART, "{eyes}: curves {i} and {j} are {apart:.1} apart");
                }
            }
        }
    }
}
