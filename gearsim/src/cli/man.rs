//! `gearsim man`: the manual pages.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Parser;
use clap_mangen::Man;

use super::failure::Failure;
use super::printing::Quiet;
use super::{Verb, program, terminal};
use crate::output::{OutputError, OutputFolder};

/// Write manual pages for `man`: one of the program, one a command
#[derive(Parser)]
#[command(
    name = "man",
    after_help = "\
Examples:
  gearsim man ~/.local/share/man/man1"
)]
pub(super) struct ManCommand {
    /// Folder for the pages; created if missing
    folder: PathBuf,
    #[command(flatten)]
    quiet: Quiet,
}

impl Verb for ManCommand {
    fn run(self) -> Result<(), Failure> {
        let mut program = program();
        program.build();
        let mut files = OutputFolder::create(&self.folder)?;
        page(&mut files, "gearsim".into(), &program)?;
        for command in program.get_subcommands() {
            page(&mut files, format!("gearsim-{}", command.get_name()), command)?;
        }
        files.commit("gearsim.1")?;
        if !self.quiet.quiet {
            terminal::print_out(&format!("{} pages in {}\n", files.files().len(), self.folder.display()));
        }
        Ok(())
    }
}

/// Writes the page of a command.
fn page(files: &mut OutputFolder, name: String, command: &clap::Command) -> Result<(), OutputError> {
    files.write(&format!("{name}.1"), |sink| Ok(render(&name, command, sink)?))
}

/// Renders the page. Its synopsis is the usage line of the help. The help text after the options becomes the section DETAILS.
fn render(name: &str, command: &clap::Command, sink: &mut dyn Write) -> io::Result<()> {
    let man = Man::new(command.clone()).title(name);
    man.render_title(sink)?;
    man.render_name_section(sink)?;
    let usage = command.clone().render_usage().to_string();
    writeln!(sink, ".SH SYNOPSIS\n{}", escaped(usage.trim_start_matches("Usage:").trim()))?;
    man.render_description_section(sink)?;
    man.render_options_section(sink)?;
    if command.has_subcommands() {
        man.render_subcommands_section(sink)?;
    }
    if let Some(more) = command.get_after_help() {
        write!(sink, ".SH DETAILS\n{}", details(&more.to_string()))?;
    }
    if name != "gearsim" {
        writeln!(sink, ".SH SEE ALSO\n.BR gearsim (1)")?;
    }
    Ok(())
}

/// A text as roff. Indented lines, which are tables and commands, are kept; other lines are filled to paragraphs.
fn details(text: &str) -> String {
    let mut page = String::new();
    let mut stays = false;
    for line in text.lines() {
        let indented = line.starts_with(' ');
        if indented != stays && !line.is_empty() {
            page += if indented { ".nf\n" } else { ".fi\n" };
            stays = indented;
        }
        page += &if line.is_empty() { ".sp".into() } else { escaped(line) };
        page.push('\n');
    }
    page + if stays { ".fi\n" } else { "" }
}

/// A line in which the characters are escaped that roff would interpret.
fn escaped(line: &str) -> String {
    let line = line.replace('\\', "\\e").replace('-', "\\-");
    if line.starts_with(['.', '\'']) { format!("\\&{line}") } else { line }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(name: &str) -> String {
        let mut program = program();
        program.build();
        let mut page = vec![];
        render(&format!("gearsim-{name}"), program.find_subcommand(name).unwrap(), &mut page).unwrap();
        String::from_utf8(page).unwrap()
    }

    /// Lines of tables and commands stay lines, sentences after them do not join them, and the synopsis names the values of options.
    #[test]
    fn tables_and_commands_keep_their_lines() {
        let page = of("sweep");
        assert!(page.contains(".SH SYNOPSIS\ngearsim sweep [OPTIONS] \\-\\-vary <KEY=VALUES> <SCENE>\n"), "{page}");
        assert!(page.contains("Values of an axis:\n.nf\n  KEY=A:B:N "), "{page}");
        assert!(page.contains("but only between A and B\n.fi\nNumbers have units"), "{page}");
        assert!(page.contains("first_reflection \\e\n"), "{page}");
        assert_eq!(page.matches(".nf\n").count(), page.matches(".fi\n").count());
        assert!(!page.contains(".SH EXTRA"));
    }
}
