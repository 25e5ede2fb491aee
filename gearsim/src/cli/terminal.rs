//! The terminal: its width, its colours, and output to it. A closed pipe is not an error; any other failure to write is one, which ends
//! the program with exit code 1 ([`failed`]). Control characters from scenes are printed as visible text.

use std::io::{self, ErrorKind, IsTerminal, Write};
use std::sync::Mutex;

use crate::scene::shown;

/// Why stdout could not be written to, if it could not.
static FAILED: Mutex<Option<String>> = Mutex::new(None);

/// Width of text [columns] if that of the terminal is unknown; also the maximum.
const WIDTH: usize = 100;
/// Minimum width of text [columns].
const NARROWEST: usize = 40;

/// Width of the terminal [columns], whichever of the standard streams is connected to it.
pub(super) fn width() -> usize {
    terminal_size::terminal_size().map_or(WIDTH, |(width, _)| usize::from(width.0).clamp(NARROWEST, WIDTH))
}

/// Whether to use colours on stderr: if it is a terminal, and `NO_COLOR` is not set (https://no-color.org).
pub(super) fn colours() -> bool {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    io::stderr().is_terminal() && !refused && !dumb
}

/// Writes results to stdout. A closed pipe, as in `gearsim models | head -1`, is not an error.
pub(super) fn print_out(text: &str) {
    let mut out = io::stdout().lock();
    note(out.write_all(shown(text).as_bytes()).and_then(|()| out.flush()));
}

/// Notes the failure of a write to stdout.
pub(super) fn note(written: io::Result<()>) {
    if let Err(error) = written
        && error.kind() != ErrorKind::BrokenPipe
        && let Ok(mut failed) = FAILED.lock()
    {
        failed.get_or_insert(error.to_string());
    }
}

/// Why stdout could not be written to; `None` if it could.
pub(super) fn failed() -> Option<String> {
    FAILED.lock().ok().and_then(|failed| failed.clone())
}

/// Writes a message to stderr, with a line end. Control characters are written unchanged, because the message may have colours.
pub(super) fn print_err(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", text.trim_end());
}

/// Writes an error to stderr, its first word in red where the terminal has colours.
pub(super) fn error(text: &str) {
    let wrapped = wrap(&shown(&format!("error: {text}")), width());
    let rest = wrapped.strip_prefix("error:").unwrap_or(&wrapped);
    print_err(&if colours() { format!("\x1b[1;31merror:\x1b[0m{rest}") } else { wrapped });
}

/// Writes a warning to stderr.
pub(super) fn warn(text: &str) {
    print_err(&wrap(&shown(&format!("warning: {text}")), width()));
}

/// `text` with its lines broken at blanks to at most `width` columns. Continuation lines have the indent of their line.
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
