//! Mistakes in a scene file, shown with the marked line: what is wrong, where, what is allowed, and what to do.

use std::fmt;
use std::sync::Arc;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, NamedSource, SourceSpan, ThemeCharacters, ThemeStyles,
};

use super::document::Place;

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

/// All mistakes in a scene, in the order of its text; those in overrides come last.
#[derive(Debug, Clone, Diagnostic)]
pub struct SceneMistakes {
    scene: String,
    #[related]
    mistakes: Vec<Mistake>,
}

impl SceneMistakes {
    /// The error of a file that could not be read.
    pub(super) fn unreadable(scene: &str, message: String, help: &str) -> SceneMistakes {
        let mistake = Mistake { message, label: String::new(), help: help.to_string(), span: None, text: None };
        SceneMistakes { scene: scene.to_string(), mistakes: vec![mistake] }
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
            1 => write!(f, "scene {} has a mistake", self.scene),
            n => write!(f, "scene {} has {n} mistakes", self.scene),
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
}

impl Report {
    pub(crate) fn new() -> Report {
        Report { sources: Vec::new(), mistakes: Vec::new(), warnings: Vec::new() }
    }

    /// Adds a warning: the scene is allowed, but a reader may have meant something else.
    pub(crate) fn warn(&mut self, warning: String) {
        self.warnings.push(warning);
    }

    pub(crate) fn into_warnings(self) -> Vec<String> {
        self.warnings
    }

    /// Adds a text that mistakes can refer to, and returns its index.
    pub(crate) fn source(&mut self, name: &str, text: &str) -> usize {
        self.sources.push(NamedSource::new(name, Arc::from(text)));
        self.sources.len() - 1
    }

    /// The text at a place.
    pub(crate) fn text(&self, place: &Place) -> &str {
        self.sources.get(place.source).and_then(|s| s.inner().get(place.span.clone())).unwrap_or_default()
    }

    /// Adds a mistake: `message` says what is wrong, `label` is shown at the place, `help` says what to do.
    pub(crate) fn add(
        &mut self,
        place: &Place,
        message: impl Into<String>,
        label: impl Into<String>,
        help: impl Into<String>,
    ) {
        let mistake = Mistake {
            message: message.into(),
            label: label.into(),
            help: help.into(),
            span: Some(place.span.clone().into()),
            text: self.sources.get(place.source).cloned(),
        };
        self.mistakes.push((place.clone(), mistake));
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.mistakes.is_empty()
    }

    pub(crate) fn into_mistakes(mut self, scene: &str) -> SceneMistakes {
        self.mistakes.sort_by_key(|(place, _)| (place.source, place.span.start));
        SceneMistakes { scene: scene.to_string(), mistakes: self.mistakes.into_iter().map(|(_, p)| p).collect() }
    }
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
