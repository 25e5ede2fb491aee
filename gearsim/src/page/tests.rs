//! Tests of pages: what they embed, and that texts stay texts.

mod palette;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::data::{self, BLOCK, Counts};
use super::html::{TableCell, escape};
use super::pack::unpack;
use super::{Page, script};
use crate::scene::Scene;

const HOSTILE: &str = "</script><script>alert(1)</script><img src=x onerror='alert(2)'>\" & \u{2028}\u{1b}]0;";

/// Decodes a column as `assets/data.js` does.
fn decoded(column: &data::Column, base64: &str) -> Vec<f64> {
    let bytes = STANDARD.decode(base64).unwrap();
    let (head, packed) = bytes.split_at(16 * column.length.div_ceil(BLOCK));
    let number = |i: usize| f64::from_le_bytes(head[8 * i..8 * i + 8].try_into().unwrap());
    let none = (1_u64 << column.bits) - 1;
    let value = |(i, count): (usize, u32)| match count {
        _ if u64::from(count) == none => f64::NAN,
        count => number(2 * (i / BLOCK)) + number(2 * (i / BLOCK) + 1) * f64::from(count),
    };
    unpack(packed, column.length).into_iter().enumerate().map(value).collect()
}

#[test]
fn columns_keep_five_or_nine_digits_of_the_range_of_a_block() {
    // A rotation of a million radians with an oscillation of 1e-3 rad on it.
    let values: Vec<f64> = (0..20_000).map(|i| 50.0 * f64::from(i) + 1e-3 * f64::from(i).sin()).collect();
    let range = 50.0 * BLOCK as f64;
    for (counts, digits) in [(Counts::Short, 1.0 / 131_000.0), (Counts::Long, 1.0 / 8.5e9)] {
        let (column, base64) = data::encode("a".into(), &values, counts);
        let back = decoded(&column, &base64);
        assert_eq!(back.len(), values.len());
        assert!(back.iter().zip(&values).all(|(a, b)| (a - b).abs() < digits * range), "{counts:?}");
    }
}

#[test]
fn numbers_that_are_large_small_equal_or_not_finite_do_not_spoil_others() {
    let back = |values: &[f64]| {
        let (column, base64) = data::encode("a".into(), values, Counts::Short);
        decoded(&column, &base64)
    };
    let ends = back(&[8e307, f64::INFINITY, -8e307, f64::NAN, 0.0]);
    assert!(ends[1].is_nan() && ends[3].is_nan() && ends[2] == -8e307, "{ends:?}");
    assert!((ends[0] / 8e307 - 1.0).abs() < 1e-12 && (ends[4] / 8e307).abs() < 1e-4, "{ends:?}");
    assert_eq!(back(&[3.25e-40; 3]), [3.25e-40; 3]);
    assert!(back(&[f64::NAN; 2]).iter().all(|x| x.is_nan()));
    assert!(back(&[]).is_empty());
}

#[test]
fn texts_end_neither_elements_nor_scripts() {
    let json = data::json(&HOSTILE);
    assert!(!json.contains(['<', '>', '&', '\u{2028}', '\u{1b}']), "{json}");
    assert_eq!(serde_json::from_str::<String>(&json).unwrap(), HOSTILE);
    let html = escape(HOSTILE);
    assert!(!html.contains(['<', '>', '"', '\'', '\u{1b}']) && html.contains("&lt;script&gt;"), "{html}");
}

#[test]
fn a_page_has_its_sections_and_allows_only_its_own_scripts() {
    let mut page = Page::new(HOSTILE, HOSTILE);
    page.section("first", "First", |html| {
        html.pairs([(HOSTILE, HOSTILE)]);
        html.code(HOSTILE, HOSTILE, true);
        html.table(HOSTILE, &[HOSTILE], &[vec![TableCell::text(HOSTILE)], vec![TableCell::Number(f64::NAN)]]);
        let (a, b) = (html.embed(&[1.0, 2.0], Counts::Long), html.embed(&[1.0, 2.0], Counts::Long));
        assert_eq!(a, b);
    });
    page.section("empty", "Empty", |_| {});
    let mut bytes = vec![];
    page.write(&mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    assert!(text.contains("<section id=\"first\"") && !text.contains("id=\"empty\""));
    assert_eq!(text.matches("<script").count() - library_mentions(), 3, "the array and the two scripts");
    assert!(!text.contains("<img"));

    let policy = script::policy(&[script::library().unwrap(), &script::of_file()]);
    assert!(text.contains(&format!("content=\"{policy}\"")));
    let allowed: Vec<_> = policy.split(';').map(str::trim).collect();
    assert_eq!(allowed[0], "default-src 'none'");
    assert!(allowed[1].matches("sha256-").count() == 2 && !allowed[1].contains("unsafe"), "{policy}");
    assert!(!policy.contains("http"));
}

/// The samples before `output.spectrum.from` are in neither the spectra nor the orders of the page.
#[test]
fn spectra_and_orders_leave_out_the_samples_before_their_first_time() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/damaged_tooth.toml");
    let scene = Scene::load(path).unwrap();
    let page = |scene: &Scene| scene.run().unwrap().page().unwrap();
    let number = |page: &str, before: &str, after: &str| -> f64 {
        let end = page.find(after).unwrap();
        let begin = page[..end].rfind(before).unwrap() + before.len();
        page[begin..end].trim().parse().unwrap()
    };
    // 30 revolutions in 0.4 s.
    for (from, revolutions) in [(0.0, 29.0..=30.0), (0.2, 14.0..=15.0)] {
        let page = page(&scene.with("output.spectrum.from", format!("{from} s")).unwrap());
        assert_eq!(page.matches("Samples before t = 0.2 s are left out.").count(), if from > 0.0 { 2 } else { 0 });
        let found = number(&page, ": ", " whole revolutions");
        assert!(revolutions.contains(&found), "{found} revolutions from {from} s on");
        let (rate, segment) = (50e3, number(&page, "in segments of ", " with a Hann window"));
        let resolution = number(&page, "resolution ", " Hz. ");
        assert!((resolution * segment / rate - 1.0).abs() < 1e-3 && segment <= rate * (0.4 - from), "{segment}");
    }
}

/// How often plotly.js has the beginning of a script element among its strings.
fn library_mentions() -> usize {
    script::library().unwrap().matches("<script").count()
}
