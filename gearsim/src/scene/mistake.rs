//! Mistakes in a scene file, shown with the marked line: what is wrong, where, what is allowed, and what to do.

mod stated;

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan, ThemeCharacters, ThemeStyles,
};

use super::document::Place;
use crate::tolerance::scene::{QUOTED, SHOWN_MISTAKES};
pub(crate) use stated::{Home, Stated};

/// One mistake in a scene.
#[derive(Debug, Clone, thiserror::Error, Diagnostic)]
#[error("{message}")]
pub struct Mistake {
    message: String,
    label: String,
    #[help]
    help: String,
    #[label("{label}")]
    span: Option<SourceSpan>,
    #[source_code]
    text: Option<NamedSource<Arc<str>>>,
}

impl Mistake {
    /// What is wrong.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What to do.
    pub fn help(&self) -> &str {
        &self.help
    }

    /// The byte at which it is in the text of the scene `source`; `None` if it is elsewhere, or only a part of the text is quoted.
    #[cfg(feature = "html")]
    pub(crate) fn offset_in(&self, source: &str) -> Option<usize> {
        let quoted = self.text.as_ref()?;
        (**quoted.inner() == *source).then(|| Some(self.span?.offset()))?
    }
}

/// All mistakes in a scene, in the order of its text; those in overrides come last.
#[derive(Debug, Clone, Diagnostic)]
pub struct SceneMistakes {
    scene: String,
    #[related]
    mistakes: Vec<Mistake>,
    /// Number of further mistakes.
    more: usize,
}

impl SceneMistakes {
    /// The error of a file that could not be read.
    pub(super) fn unreadable(scene: &str, message: String, help: &str) -> SceneMistakes {
        let mistake =
            Mistake { message: brief(&message), label: String::new(), help: help.to_string(), span: None, text: None };
        SceneMistakes { scene: scene.to_string(), mistakes: vec![mistake], more: 0 }
    }

    /// The mistakes, in the order in which they are shown.
    pub fn mistakes(&self) -> &[Mistake] {
        &self.mistakes
    }

    /// The messages in one line, separated by semicolons.
    pub fn brief(&self) -> String {
        self.mistakes.iter().map(|mistake| mistake.message.as_str()).collect::<Vec<_>>().join("; ")
    }

    /// The mistakes as text with the marked lines, at most `width` columns wide where possible, with terminal colours if `color`.
    pub fn render(&self, width: usize, color: bool) -> String {
        let theme = GraphicalTheme {
            characters: ThemeCharacters::unicode(),
            styles: if color { ThemeStyles::ansi() } else { ThemeStyles::none() },
        };
        let handler = GraphicalReportHandler::new_themed(theme).with_width(width).with_links(false);
        let mut text = format!("{self}\n");
        for mistake in &self.mistakes {
            text.push('\n');
            let start = text.len();
            if handler.render_report(&mut text, mistake).is_err() {
                text.truncate(start);
                text.push_str(&format!("  {}\n  help: {}\n", mistake.message, mistake.help));
            }
        }
        text
    }
}

impl fmt::Display for SceneMistakes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.mistakes.len() {
            n if self.more > 0 => {
                write!(f, "scene {} has {} mistakes, of which {n} are shown", shown(&self.scene), n + self.more)
            }
            1 => write!(f, "scene {} has a mistake", shown(&self.scene)),
            n => write!(f, "scene {} has {n} mistakes", shown(&self.scene)),
        }
    }
}

impl std::error::Error for SceneMistakes {}

/// Collects mistakes while a scene is read.
#[derive(Debug, Clone)]
pub(crate) struct Report {
    sources: Vec<NamedSource<Arc<str>>>,
    mistakes: Vec<(Place, Mistake)>,
    warnings: Vec<String>,
    /// Number of mistakes that were found, but are not kept.
    more: usize,
    /// The keys that messages name for values from the tables of a train.
    pub(super) stated: Stated,
}

impl Report {
    pub(crate) fn new() -> Report {
        Report { sources: Vec::new(), mistakes: Vec::new(), warnings: Vec::new(), more: 0, stated: Stated::default() }
    }

    /// Adds a warning: the scene is allowed, but a reader may have meant something else.
    pub(crate) fn warn(&mut self, warning: String) {
        let warning = self.stated.renamed(warning);
        // The meshes of a planet set have one table.
        if !self.warnings.contains(&warning) {
            self.warnings.push(warning);
        }
    }

    pub(crate) fn into_warnings(self) -> Vec<String> {
        self.warnings
    }

    /// Adds a text that mistakes can refer to, and returns its index.
    pub(crate) fn source(&mut self, name: &str, text: &str) -> usize {
        self.sources.push(NamedSource::new(shown(name), Arc::from(text)));
        self.sources.len() - 1
    }

    /// The text at a place.
    pub(crate) fn text(&self, place: &Place) -> &str {
        self.sources.get(place.source).and_then(|s| s.inner().get(place.span.clone())).unwrap_or_default()
    }

    /// Adds a mistake: `message` says what is wrong, `label` is shown at the place, `help` says what to do. A mistake that several parts
    /// of a train share, the planets of a set for example, is kept once.
    pub(crate) fn add(
        &mut self,
        place: &Place,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) {
        let (message, label) = (brief(&self.stated.renamed(message.into())), brief(&label.into()));
        let again = |(at, known): &(Place, Mistake)| at == place && known.message == message && known.label == label;
        if self.mistakes.iter().any(again) {
            return;
        }
        if self.mistakes.len() >= SHOWN_MISTAKES {
            self.more += 1;
            return;
        }
        let (text, span) = match self.sources.get(place.source) {
            Some(source) => {
                let (text, span) = excerpt(source, place.span.clone());
                (Some(text), span)
            }
            None => (None, place.span.clone()),
        };
        let mistake =
            Mistake { message, label, help: brief(&self.stated.explained(help.into())), span: Some(span.into()), text };
        self.mistakes.push((place.clone(), mistake));
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.mistakes.is_empty()
    }

    /// Number of mistakes found so far.
    pub(crate) fn len(&self) -> usize {
        self.mistakes.len() + self.more
    }

    pub(crate) fn into_mistakes(mut self, scene: &str) -> SceneMistakes {
        self.mistakes.sort_by_key(|(place, _)| (place.source, place.span.start));
        let more = self.more;
        SceneMistakes { scene: scene.to_string(), more, mistakes: self.mistakes.into_iter().map(|(_, p)| p).collect() }
    }
}

/// The text round a mistake, and the span of the mistake in it. A line that is too long to be shown is cut on both sides. Control
/// characters, which a terminal would obey, become question marks.
fn excerpt(source: &NamedSource<Arc<str>>, span: Range<usize>) -> (NamedSource<Arc<str>>, Range<usize>) {
    let text = source.inner();
    let start = text[..floor(text, span.start)].rfind('\n').map_or(0, |at| at + 1);
    let end = text[floor(text, span.start)..].find('\n').map_or(text.len(), |at| floor(text, span.start) + at);
    let plain = !text.contains(is_control);
    if end - start <= QUOTED && plain {
        return (source.clone(), span);
    }
    let tame = |part: &str| -> String {
        // As many bytes as before, so that spans stay right.
        part.chars()
            .map(|c| {
                if c == '\r' {
                    " ".into()
                } else if is_control(c) {
                    "?".repeat(c.len_utf8())
                } else {
                    c.into()
                }
            })
            .collect()
    };
    if end - start <= QUOTED {
        return (NamedSource::new(source.name(), Arc::from(tame(text))), span);
    }
    let (from, to) = (
        floor(text, span.start.saturating_sub(QUOTED / 4).max(start)),
        floor(text, (span.start + QUOTED / 4).min(end)),
    );
    let line = text[..start].matches('\n').count() + 1;
    let name = format!("{}, a part of line {line}, from byte {}", source.name(), from - start);
    let span = span.start.clamp(from, to) - from..span.end.clamp(from, to) - from;
    (NamedSource::new(name, Arc::from(tame(&text[from..to]))), span)
}

/// The largest place up to `at` at which a character begins.
fn floor(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}

/// A text for a message: not longer than can be read, and with its control characters shown.
fn brief(text: &str) -> String {
    match text.char_indices().nth(4 * QUOTED) {
        Some((at, _)) => shown(&text[..at]) + " ...",
        None => shown(text),
    }
}

/// Whether a character is a control character that a terminal would act on. Line ends and tabs are allowed.
fn is_control(c: char) -> bool {
    c.is_control() && c != '\n' && c != '\t'
}

/// A text in which control characters are shown as in Rust: `\u{1b}`.
pub(crate) fn shown(text: &str) -> String {
    let show = |c: char| if is_control(c) { c.escape_default().to_string() } else { c.to_string() };
    text.chars().map(show).collect()
}

/// The candidate nearest to `word`: the smallest Damerau-Levenshtein distance without case, if at most a third of the word's length.
pub(crate) fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let distance = |candidate: &str| strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
    let (distance, candidate) = candidates.into_iter().map(|c| (distance(c), c)).min_by_key(|(d, _)| *d)?;
    (distance <= word.chars().count() / 3).then_some(candidate)
}

/// The names in backquotes, as in "`a`, `b` and `c`".
pub(crate) fn list(names: &[&str]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}
