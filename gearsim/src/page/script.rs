//! The scripts of a page: plotly.js as the crate `plotly` embeds it, and our own.

use std::io;
use std::sync::LazyLock;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

/// The scripts of all pages, in the order in which they run.
const COMMON: [&str; 7] = [
    include_str!("assets/data.js"),
    include_str!("assets/plot.js"),
    include_str!("assets/group.js"),
    include_str!("assets/table.js"),
    include_str!("assets/mesh.js"),
    include_str!("assets/picture.js"),
    include_str!("assets/gears.js"),
];

/// The script elements of the crate: plotly.js first, then MathJax, which pages do not need.
static SOURCES: LazyLock<String> = LazyLock::new(plotly::Plot::offline_js_sources);

/// The text of plotly.js. Errors: if the crate embeds it in another form than the one known here.
pub(super) fn library() -> io::Result<&'static str> {
    let first =
        SOURCES.split_once("<script type=\"text/javascript\">").and_then(|(_, rest)| rest.split_once("</script>"));
    match first {
        Some((text, _)) if text.contains("plotly.js v") => Ok(text),
        _ => Err(io::Error::other("the crate `plotly` does not embed plotly.js as a first script element")),
    }
}

/// The scripts of a page that is a file.
pub(super) fn of_file() -> String {
    own(&[include_str!("assets/heat.js"), include_str!("assets/page.js")])
}

/// The scripts of the page of `gearsim explore`.
pub(super) fn of_explorer() -> String {
    own(&[include_str!("assets/controls.js"), include_str!("assets/sections.js"), include_str!("assets/explore.js")])
}

/// Our own scripts as one text: the common ones, then `rest`.
fn own(rest: &[&str]) -> String {
    format!("\"use strict\";\n{}{}", COMMON.concat(), rest.concat())
}

/// A Content-Security-Policy that allows `scripts`, inline styles and images made by the page itself, and nothing else: no network.
pub(super) fn policy(scripts: &[&str]) -> String {
    let hashes = scripts.iter().map(|text| format!(" 'sha256-{}'", STANDARD.encode(Sha256::digest(text))));
    let hashes: String = hashes.collect();
    format!(
        "default-src 'none'; script-src{hashes}; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'"
    )
}

/// Scripts of one page share their global names: a second function of a name would replace the first one, for all of them.
#[test]
fn no_name_is_declared_twice() {
    for text in [of_file(), of_explorer()] {
        let mut seen = std::collections::HashSet::new();
        for line in text.lines() {
            let mut words = line.trim_start_matches("async ").split([' ', '(', ',', ';']);
            if let (Some("function" | "class" | "const" | "let"), Some(name)) = (words.next(), words.next()) {
                assert!(seen.insert(name), "`{name}` is declared twice");
            }
        }
        assert!(seen.contains("outline") && seen.contains("Panel"), "{seen:?}");
    }
}
