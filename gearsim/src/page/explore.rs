//! The page of `gearsim explore`: places for controls, cost and plots, which its scripts fill.

use std::io::{self, Write};

use super::html::escape;
use super::{document, script};

/// Its layout, after that of all pages.
const STYLE: &str = include_str!("assets/explore.css");

/// Writes the page of a scene called `name`. Returns its Content-Security-Policy, which allows only its own scripts and requests to its own
/// server.
///
/// # Errors
/// Those of `sink`.
pub fn write(name: &str, sink: &mut dyn Write) -> io::Result<String> {
    let own = script::of_explorer();
    let name = escape(name);
    let style = format!("<style>{STYLE}</style>");
    document(sink, &name, &style, &own, &mut |sink| write!(sink, include_str!("assets/explore.html"), name = name))?;
    let policy = script::policy(&[script::library()?, &own]);
    Ok(format!("{policy}; connect-src 'self'; frame-ancestors 'none'"))
}
