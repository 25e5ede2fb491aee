//! Lines of bounded length. A long line is broken before an operator, as far outside of parentheses as possible.

/// Longest line of a generated file, in characters. A test holds every generated file to it.
pub(crate) const WIDTH: usize = 140;
const INDENT: &str = "    ";
/// Where a line may be broken: before these. The first is the best place.
const BREAKS: [&[&str]; 2] = [&[" + ", " - "], &[" ", "*", "/"]];

/// A text, broken between words; its first line starts with `first`, the others with `rest`.
pub(crate) fn prose(text: &str, first: &str, rest: &str) -> String {
    let mut lines = vec![first.to_string()];
    for word in text.split(' ') {
        let line = lines.last().map_or(0, |line| line.chars().count());
        if line > rest.len().max(first.len()) && line + 1 + word.chars().count() > WIDTH {
            lines.push(rest.to_string());
        }
        let line = lines.last_mut().expect("never empty");
        if !line.ends_with(' ') {
            line.push(' ');
        }
        line.push_str(word);
    }
    lines.join("\n")
}

/// The line, broken into several if it is long; those after the first are indented once more.
pub(crate) fn wrap(line: &str) -> String {
    let indent: String = line.chars().take_while(|c| *c == ' ').chain(INDENT.chars()).collect();
    let mut lines = vec![];
    let mut rest = line.to_string();
    while rest.chars().count() > WIDTH {
        let start = rest.len() - rest.trim_start().len();
        let Some((at, in_text)) = place(&rest, start) else { break };
        let (head, tail) = rest.split_at(at);
        // In a string of Rust, a backslash at the end of a line removes the line break and all white space before the next word.
        lines.push(if in_text { format!("{head} \\") } else { head.trim_end().to_string() });
        rest = format!("{indent}{}", tail.trim_start());
    }
    lines.push(rest);
    lines.join("\n")
}

/// The best place to break a line after `start`, and whether it is within a string.
fn place(line: &str, start: usize) -> Option<(usize, bool)> {
    let fits = line.char_indices().nth(WIDTH - 2).map_or(line.len(), |(at, _)| at);
    let places: Vec<LineBreak> = places(line).into_iter().filter(|p| p.at > start && p.at <= fits).collect();
    // Places outside strings come first. A break in the first third leaves the line nearly empty, and is used only if there is no other
    // outside a string.
    for (in_text, least) in [(false, WIDTH / 3), (false, 0), (true, 0)] {
        let mut far = places.iter().filter(|p| p.in_text == in_text && p.at >= least);
        if let Some(best) = far.clone().map(|p| (p.depth, p.kind)).min() {
            return far.rfind(|p| (p.depth, p.kind) == best).map(|p| (p.at, in_text));
        }
    }
    None
}

/// A place at which a line may be broken.
struct LineBreak {
    at: usize,
    /// Whether it is within a string.
    in_text: bool,
    /// How deep it is in parentheses.
    depth: usize,
    /// Which of `BREAKS`.
    kind: usize,
}

fn places(line: &str) -> Vec<LineBreak> {
    let (mut depth, mut text, mut escaped) = (0usize, false, false);
    let mut all = vec![];
    for (at, c) in line.char_indices() {
        let kind = BREAKS.iter().position(|starts| starts.iter().any(|start| line[at..].starts_with(start)));
        if let Some(kind) = kind.map(|kind| if text { 1 } else { kind })
            && (!text || c == ' ')
        {
            all.push(LineBreak { at, in_text: text, depth, kind });
        }
        match c {
            '"' if !escaped => text = !text,
            '(' | '{' | '[' if !text => depth += 1,
            ')' | '}' | ']' if !text => depth = depth.saturating_sub(1),
            _ => {}
        }
        escaped = c == '\\' && !escaped;
    }
    all
}
