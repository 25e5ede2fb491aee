//! The parts of a chapter: lines, fenced blocks, and notes to this program.

/// A part of a chapter.
#[derive(Debug, PartialEq)]
pub enum Part<'a> {
    /// A line of Markdown.
    Line(&'a str),
    /// A fenced block: the words after its fence, and its lines.
    Block(&'a str, Vec<&'a str>),
    /// `<!-- key: value -->`, alone in its line.
    Note(&'a str, &'a str),
}

/// The parts of the text of a chapter, in order.
pub fn of(text: &str) -> Vec<Part<'_>> {
    let (mut parts, mut block) = (vec![], None::<(&str, Vec<&str>)>);
    for line in text.lines() {
        match (&mut block, line.strip_prefix("```")) {
            (None, Some(info)) => block = Some((info, vec![])),
            (Some(_), Some("")) => parts.extend(block.take().map(|(info, lines)| Part::Block(info, lines))),
            (Some((_, lines)), _) => lines.push(line),
            (None, None) => parts.push(note(line).unwrap_or(Part::Line(line))),
        }
    }
    parts
}

fn note(line: &str) -> Option<Part<'_>> {
    let (key, value) = line.strip_prefix("<!-- ")?.strip_suffix(" -->")?.split_once(": ")?;
    Some(Part::Note(key, value))
}

#[test]
fn lines_blocks_and_notes_are_found_in_order() {
    let text = "text\n<!-- file: a.toml -->\n```toml\na = 1\n\n```\n<!-- a remark -->";
    let expected = [
        Part::Line("text"),
        Part::Note("file", "a.toml"),
        Part::Block("toml", vec!["a = 1", ""]),
        Part::Line("<!-- a remark -->"),
    ];
    assert_eq!(of(text), expected);
}
