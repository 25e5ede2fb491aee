//! The reference of all keys, in Markdown.

use std::fmt::Write;

use super::key::{Key, Kind, Named};
use crate::scene::{check, train};

const INTRO: &str = "\
# Keys of a scene

A scene is a TOML file. A quantity is a text with a unit of the right dimension, `\"10 N*m\"` or `\"0.3 mm\"`; 0 needs no unit. A number
without unit may be a text too. Names in capitals stand for names that the model or the scene has: `gearsim models MODEL` lists them.
";

/// Keys of all tables that a scene may have, in Markdown.
pub(crate) fn reference() -> String {
    let mut all = Reference { text: INTRO.into(), written: vec![] };
    all.section("Top level", "", &[check::KEYS]);
    all.section("Top level of `model = \"train\"`", "", &[train::KEYS]);
    all.text
}

struct Reference {
    text: String,
    /// Tables written so far: heading and keys.
    written: Vec<(String, Vec<Key>)>,
}

/// A row: name, value, default, meaning.
type Row = (&'static str, Kind, &'static str, &'static str);

impl Reference {
    /// Writes the keys of a table, then those of the tables in it. `path` is the key of the table.
    fn section(&mut self, title: &str, path: &str, keys: &[&[Key]]) {
        let keys: Vec<Key> = keys.concat();
        if let Some((known, _)) = self.written.iter().find(|(_, written)| *written == keys) {
            let _ = write!(self.text, "\n## {title}\n\nAs {known}.\n");
            return;
        }
        self.written.push((title.into(), keys.clone()));
        self.rows(title, path, keys.iter().map(|key| (key.name, key.kind, key.default, key.doc)).collect());
    }

    /// Writes a heading and the rows of a table, then the tables in it.
    fn rows(&mut self, title: &str, path: &str, rows: Vec<Row>) {
        let _ = write!(self.text, "\n## {title}\n");
        self.table(&rows);
        self.below(path, &rows);
    }

    fn table(&mut self, rows: &[Row]) {
        self.text += "\n| key | value | without it | meaning |\n| --- | --- | --- | --- |\n";
        for (name, kind, default, doc) in rows {
            let _ = writeln!(self.text, "| `{name}` | {} | {default} | {doc} |", words(*kind));
        }
    }

    fn below(&mut self, path: &str, rows: &[Row]) {
        for (name, kind, ..) in rows {
            let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
            self.inside(*kind, &path, &format!("`[{path}]`"));
        }
    }

    /// Writes the tables for a value that may be one of several tables, below one heading.
    fn one_of(&mut self, title: &str, path: &str, tables: &[&[&[Key]]]) {
        let _ = write!(self.text, "\n## {title}\n\nOne of {} tables.\n", tables.len());
        let mut all = vec![];
        for (i, keys) in tables.iter().enumerate() {
            let keys: Vec<Key> = keys.concat();
            let rows: Vec<Row> = keys.iter().map(|key| (key.name, key.kind, key.default, key.doc)).collect();
            self.table(&rows);
            self.written.push((format!("table {} of {title}", i + 1), keys));
            all.extend(rows);
        }
        self.below(path, &all);
    }

    /// Writes the tables that a value may have.
    fn inside(&mut self, kind: Kind, path: &str, title: &str) {
        match kind {
            Kind::Table(keys) => self.section(title, path, keys),
            Kind::List(Kind::Table(keys)) => self.section(&format!("An entry of `{path}`"), path, keys),
            Kind::Either(kinds) => {
                let table = |kind: &Kind| if let Kind::Table(keys) = kind { Some(*keys) } else { None };
                let tables: Vec<&[&[Key]]> = kinds.iter().filter_map(table).collect();
                if tables.len() > 1 {
                    self.one_of(title, path, &tables);
                }
                let several = |kind: &&Kind| tables.len() < 2 || table(kind).is_none();
                kinds.iter().filter(several).for_each(|kind| self.inside(*kind, path, title));
            }
            Kind::Named(all) => self.rows(title, path, all.iter().map(row).collect()),
            _ => {}
        }
    }
}

fn row(named: &Named) -> Row {
    (named.name, named.kind, named.default, named.doc)
}

/// What a value may be, in words.
fn words(kind: Kind) -> String {
    match kind {
        Kind::Text => "text".into(),
        Kind::Flag => "`true` or `false`".into(),
        Kind::Number => "number".into(),
        Kind::Quantity(unit) => format!("quantity in `{unit}`"),
        Kind::ValueIn(unit) => format!("quantity ({unit})"),
        Kind::Choice(names) => names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "),
        Kind::Name(what) => what.into(),
        Kind::List(kind) => format!("list: {}", words(*kind)),
        Kind::Table(_) | Kind::Named(_) => "table".into(),
        Kind::Either(kinds) => kinds.iter().map(|kind| words(*kind)).collect::<Vec<_>>().join("; or "),
    }
}

#[test]
fn each_heading_occurs_once() {
    let text = reference();
    let headings: Vec<&str> = text.lines().filter(|line| line.starts_with("## ")).collect();
    for heading in &headings {
        assert_eq!(headings.iter().filter(|other| *other == heading).count(), 1, "{heading}");
    }
}
