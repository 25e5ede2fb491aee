//! The content of a page: escaped text, lists, tables and plots.

use std::fmt::Write;

use serde::Serialize;

use super::data::{self, Column, Counts};
use super::plot::{Map, Plot};
use crate::output::number::short;
use crate::scene::shown;

/// Content, written from top to bottom. All texts are escaped; an empty text or list writes nothing.
#[derive(Debug, Default)]
pub struct Html {
    text: String,
    /// The embedded arrays: identifier and base64.
    arrays: Vec<(String, String)>,
    /// Prefix of the identifiers of its arrays.
    name: String,
}

/// A cell of a table.
#[derive(Debug, Clone)]
pub enum TableCell {
    /// Text.
    Text(String),
    /// A number, shown with few digits and sorted by its value.
    Number(f64),
}

impl Html {
    /// Empty content whose arrays have identifiers that begin with `name`.
    pub(super) fn named(name: String) -> Self {
        Html { name, ..Html::default() }
    }

    /// Empty content that takes the arrays of `before`, so that their numbering continues.
    pub(super) fn continuing(before: &mut Html) -> Self {
        Html { text: String::new(), arrays: std::mem::take(&mut before.arrays), name: before.name.clone() }
    }

    /// Appends `inner` as a section; returns false, and leaves it out, if it has no text.
    pub(super) fn append_section(&mut self, inner: Html, id: &str, title: &str) -> bool {
        let has_text = !inner.text.is_empty();
        if has_text {
            let (title, text) = (escape(title), &inner.text);
            let _ = write!(
                self.text,
                "<section id=\"{id}\" aria-labelledby=\"{id}-title\">\n<h2 id=\"{id}-title\">{title}</h2>\n{text}</section>\n"
            );
        }
        self.arrays = inner.arrays;
        has_text
    }

    /// The text so far.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The embedded arrays: identifier and base64.
    pub(super) fn arrays(&self) -> &[(String, String)] {
        &self.arrays
    }

    /// The embedded arrays, taken out of the content.
    pub(super) fn into_arrays(self) -> Vec<(String, String)> {
        self.arrays
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.element("p", "", text);
    }

    /// A paragraph that a reader must not miss.
    pub fn note(&mut self, text: &str) {
        self.element("p", " class=\"note\"", text);
    }

    /// A heading below that of the section.
    pub fn heading(&mut self, text: &str) {
        let _ = writeln!(self.text, "<h3>{}</h3>", symbols(text));
    }

    /// Program text, e.g. a scene, behind a line that opens it.
    pub fn code(&mut self, summary: &str, text: &str, open: bool) {
        let open = if open { " open" } else { "" };
        let (summary, text) = (escape(summary), escape(text));
        let _ = writeln!(
            self.text,
            "<details{open}><summary>{summary}</summary><pre tabindex=\"0\"><code>{text}</code></pre></details>"
        );
    }

    /// Pairs of a name and what it stands for.
    pub fn pairs<N: AsRef<str>, T: AsRef<str>>(&mut self, pairs: impl IntoIterator<Item = (N, T)>) {
        let pairs = pairs.into_iter().map(|(name, text)| (escape(name.as_ref()), escape(text.as_ref())));
        let lines: String = pairs.map(|(name, text)| format!("<dt>{name}</dt><dd>{text}</dd>\n")).collect();
        if !lines.is_empty() {
            let _ = write!(self.text, "<dl>\n{lines}</dl>\n");
        }
    }

    /// A table that a reader can sort by each column.
    pub fn table(&mut self, caption: &str, head: &[&str], rows: &[Vec<TableCell>]) {
        if rows.is_empty() {
            return;
        }
        let head = head.iter().zip(&rows[0]).map(|(name, cell)| {
            let class = if matches!(cell, TableCell::Number(_)) { " class=\"number\"" } else { "" };
            format!("<th scope=\"col\"{class}><button type=\"button\">{}</button></th>", escape(name))
        });
        let head: String = head.collect();
        let rows: String = rows
            .iter()
            .map(|row| format!("<tr>{}</tr>\n", row.iter().map(TableCell::html).collect::<String>()))
            .collect();
        let caption = escape(caption);
        let _ = write!(
            self.text,
            "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"{caption}\"><table class=\"sortable\"><caption>{caption}</caption>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
        );
    }

    /// The place of a table that follows with the next answer; until then the page keeps the one that it has.
    pub fn later(&mut self, caption: &str) {
        let _ = writeln!(self.text, "<div data-later=\"{}\"></div>", escape(caption));
    }

    /// Embeds a column, and returns the reference to it that plots need. Equal columns are embedded once.
    pub fn embed(&mut self, values: &[f64], counts: Counts) -> Column {
        let (mut column, base64) = data::encode(format!("{}array-{}", self.name, self.arrays.len()), values, counts);
        match self.arrays.iter().find(|(_, known)| *known == base64) {
            Some((id, _)) => column.id.clone_from(id),
            None => self.arrays.push((column.id.clone(), base64)),
        }
        column
    }

    /// Lines of text, each a paragraph.
    pub fn lines(&mut self, text: &str) {
        text.lines().for_each(|line| self.paragraph(line));
    }

    /// A plot. The script draws it in the place of its title.
    pub fn plot(&mut self, plot: &Plot) {
        self.figure("plot", &plot.title, plot);
    }

    /// A map, drawn in the same way.
    pub fn map(&mut self, map: &Map) {
        self.figure("map", &map.title, map);
    }

    /// A figure that the script of its class draws in the place of its title.
    pub(super) fn figure(&mut self, class: &str, title: &str, specification: &impl Serialize) {
        let (title, specification) = (symbols(title), data::json(specification));
        let _ = writeln!(
            self.text,
            "<figure class=\"{class}\"><figcaption>{title}</figcaption><script type=\"application/json\">{specification}</script></figure>"
        );
    }

    fn element(&mut self, name: &str, attributes: &str, text: &str) {
        if !text.is_empty() {
            let _ = writeln!(self.text, "<{name}{attributes}>{}</{name}>", escape(text));
        }
    }
}

impl TableCell {
    /// A cell of text.
    pub fn text(text: impl Into<String>) -> Self {
        TableCell::Text(text.into())
    }

    fn html(&self) -> String {
        match self {
            TableCell::Text(text) => format!("<td>{}</td>", escape(text)),
            TableCell::Number(x) if x.is_nan() => "<td class=\"number\" data-value=\"NaN\">-</td>".into(),
            // Adding 0 turns -0 into 0.
            TableCell::Number(x) => {
                format!("<td class=\"number\" data-value=\"{x:e}\">{}</td>", short(x + 0.0))
            }
        }
    }
}

/// `text`, escaped, with the content of `_{...}` as a subscript.
fn symbols(text: &str) -> String {
    let escaped = escape(text);
    let mut parts = escaped.split("_{");
    let mut html = parts.next().unwrap_or("").to_owned();
    for part in parts {
        match part.split_once('}') {
            Some((index, rest)) => html += &format!("<sub>{index}</sub>{rest}"),
            None => html += &format!("_{{{part}"),
        }
    }
    html
}

/// `text` with the special characters of HTML, in elements and in attributes, as character references. Control characters other than tabs
/// and line ends are shown as in Rust's literals.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            '\n' | '\t' => escaped.push(c),
            c => escaped.push_str(&shown(c.encode_utf8(&mut [0; 4]))),
        }
    }
    escaped
}
