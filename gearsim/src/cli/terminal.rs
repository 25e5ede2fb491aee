//! The terminal: its width, its colours, and writing to it although nobody may be reading.

use std::io::{IsTerminal, Write};

/// Columns of text where the terminal does not say, and at most.
const WIDTH: usize = 100;
/// Columns below which nothing is legible anyway.
const NARROWEST: usize = 40;

/// Columns of the terminal, whichever stream it is at.
pub(super) fn width() -> usize {
    terminal_size::terminal_size().map_or(WIDTH, |(width, _)| usize::from(width.0).clamp(NARROWEST, WIDTH))
}

/// Whether stderr shows colours: a terminal does, unless asked not to (https://no-color.org).
pub(super) fn colours() -> bool {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    std::io::stderr().is_terminal() && !refused && !dumb
}

/// Writes results. A reader that has gone away, as in `gearsim models | head -1`, is no failure.
pub(super) fn say(text: &str) {
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// Writes what is wrong to stderr, with a line end.
pub(super) fn complain(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{}", text.trim_end());
}

/// Writes what is missing but does no harm to stderr.
pub(super) fn warn(text: &str) {
    complain(&wrap(&format!("warning: {text}"), width()));
}

/// `text` with its lines broken at blanks, `width` columns at most; what continues a line is indented as it is.
pub(super) fn wrap(text: &str, width: usize) -> String {
    let mut wrapped = String::new();
    for line in text.lines() {
        let indent = " ".repeat(line.len() - line.trim_start().len());
        let mut columns = 0;
        for word in line.split_whitespace() {
            let length = word.chars().count();
            if columns > 0 && columns + 1 + length > width {
                wrapped.push('\n');
                columns = 0;
            }
            wrapped.push_str(if columns == 0 { &indent } else { " " });
            columns += length + if columns == 0 { indent.len() } else { 1 };
            wrapped.push_str(word);
        }
        wrapped.push('\n');
    }
    wrapped
}
