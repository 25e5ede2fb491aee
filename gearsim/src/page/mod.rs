//! Interactive pages: one HTML file that shows a result in any browser, without network and without other files.
//!
//! A [`Page`] has sections of text, tables and plots. The numbers of its plots are embedded as base64 typed arrays ([`data`]). The plots
//! are drawn by plotly.js, which the crate `plotly` brings, and by the scripts in `assets` ([`script`]). [`run`] makes the page of a run,
//! [`explore`] the page of `gearsim explore`, which shows many runs in turn. The page of any other command has its own file. [`shared`] has
//! the parts that several pages have in common.
//!
//! Any text of a scene stays text: [`html`] escapes it in HTML, [`data::json`] in scripts. A Content-Security-Policy allows only the
//! scripts of this module, by their hashes, and no network.

pub mod advise;
pub mod compare;
pub mod data;
pub mod explore;
pub mod floquet;
pub mod html;
pub mod modes;
mod pack;
pub mod plot;
pub mod response;
pub mod run;
mod script;
pub mod shared;
pub mod sweep;
#[cfg(test)]
mod tests;
pub mod work_precision;

use std::collections::HashMap;
use std::io::{self, Write};

use serde::Serialize;

use crate::output::belongs;
use html::{Html, escape};

/// Colours, type and layout.
const STYLE: &str = include_str!("assets/page.css");

/// A page.
pub struct Page {
    title: String,
    subtitle: String,
    /// The index file of the result to which it belongs.
    index: Option<&'static str>,
    /// Identifier and title of each section, for the table of contents.
    contents: Vec<(&'static str, &'static str)>,
    body: Html,
}

impl Page {
    /// A page without sections.
    pub fn new(title: impl Into<String>, subtitle: impl Into<String>) -> Self {
        Page { title: title.into(), subtitle: subtitle.into(), index: None, contents: vec![], body: Html::default() }
    }

    /// Sets the prefix of the identifiers of the page's arrays to `name`. A part of a page needs other identifiers than the other parts.
    pub fn named(self, name: String) -> Self {
        Page { body: Html::named(name), ..self }
    }

    /// Marks the page as part of the result with this index file, so that it is replaced together with this result.
    pub fn of(self, index: &'static str) -> Self {
        Page { index: Some(index), ..self }
    }

    /// Adds a section that `fill` writes. A section in which it writes nothing is left out.
    pub fn section(&mut self, id: &'static str, title: &'static str, fill: impl FnOnce(&mut Html)) {
        let mut html = Html::continuing(&mut self.body);
        fill(&mut html);
        if self.body.append_section(html, id, title) {
            self.contents.push((id, title));
        }
    }

    /// Writes the page as HTML. Errors: those of `sink`.
    pub fn write(&self, sink: &mut dyn Write) -> io::Result<()> {
        let own = script::of_file();
        let policy = script::policy(&[script::library()?, &own]);
        let meta = self.index.map_or(String::new(), belongs);
        let meta = format!("{meta}<meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">");
        let title = escape(&self.title);
        document(sink, &title, &meta, &own, &mut |sink| {
            writeln!(
                sink,
                "<body>\n<header><h1>{title}</h1>\n<p class=\"subtitle\">{}</p>\n<nav aria-label=\"Sections\"><ul>",
                escape(&self.subtitle)
            )?;
            for (id, title) in &self.contents {
                writeln!(sink, "<li><a href=\"#{id}\">{}</a></li>", escape(title))?;
            }
            writeln!(sink, "</ul></nav></header>\n<main>\n{}</main>", self.body.text())?;
            writeln!(sink, "<noscript><p class=\"note\">The plots of this page need JavaScript.</p></noscript>")?;
            for (id, array) in self.body.arrays() {
                writeln!(sink, "<script type=\"text/plain\" id=\"{id}\">{array}</script>")?;
            }
            Ok(())
        })
    }

    /// The parts with which a page that is already open shows this one. `order` has the identifiers of all sections from top to bottom,
    /// `of` those of the sections of this page.
    fn parts(self, order: Vec<&'static str>, of: Vec<&'static str>) -> Parts {
        let html = self.body.text().to_owned();
        Parts { order, of, html, arrays: self.body.into_arrays().into_iter().collect() }
    }
}

/// Some of the sections of a page.
#[derive(Debug, Serialize)]
pub struct Parts {
    /// The identifiers of all sections, from top to bottom.
    order: Vec<&'static str>,
    /// The identifiers of these sections. A section that is not in `html` is empty.
    of: Vec<&'static str>,
    /// The sections.
    html: String,
    /// The embedded arrays in base64, by their identifiers.
    arrays: HashMap<String, String>,
}

/// Writes a document: `title` and `meta` in its head, what `body` writes, then plotly.js and the script `own`.
fn document(
    sink: &mut dyn Write,
    title: &str,
    meta: &str,
    own: &str,
    body: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let library = script::library()?;
    writeln!(sink, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">{meta}")?;
    writeln!(sink, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">")?;
    writeln!(sink, "<meta name=\"color-scheme\" content=\"light dark\">")?;
    writeln!(sink, "<title>{title} - gearsim</title>\n<style>{STYLE}</style>\n</head>")?;
    body(sink)?;
    writeln!(sink, "<script>{library}</script>\n<script>{own}</script>\n</body>\n</html>")
}
