//! What a reader expects of the generated files: short lines, the code at the beginning, and the proofs that README and ARCHITECTURE claim.

use std::path::{Path, PathBuf};

/// Longest line of a generated file, in characters.
const WIDTH: usize = 160;

/// The files beside the generated ones that are written by hand.
const BY_HAND: [&str; 2] = ["lib", "train"];

/// The file in which the proof cannot decide whether M is positive definite: M contains the square of a distance over cos(alpha).
const UNDECIDED: &str = "element_planets";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Every generated file with this ending: name and text.
fn generated(ending: &str) -> Vec<(String, String)> {
    let folder = root().join("gearsim/generated/src");
    let folders = [folder.clone(), folder.join("text"), folder.join("latex")];
    let entries = folders.iter().flat_map(|f| std::fs::read_dir(f).expect("a folder of generated files"));
    let paths = entries.map(|entry| entry.expect("a readable folder").path()).filter(|path| path.is_file());
    let mut files: Vec<(String, String)> = paths
        .filter(|path| path.extension().is_some_and(|e| e == ending))
        .filter(|path| path.file_stem().is_some_and(|stem| !BY_HAND.iter().any(|name| stem == *name)))
        .map(|path| (path.file_stem().expect("a file").to_string_lossy().into_owned(), read(&path)))
        .collect();
    files.sort();
    assert!(files.len() >= 20, "{} files that end in {ending}", files.len());
    files
}

#[test]
fn no_line_is_too_long() {
    for ending in ["rs", "txt", "tex"] {
        for (name, text) in generated(ending) {
            let long = text.lines().find(|line| line.chars().count() > WIDTH);
            assert!(long.is_none(), "{name}.{ending}: longer than {WIDTH} characters: {}", long.unwrap_or_default());
        }
    }
}

#[test]
fn running_code_comes_first_and_equations_are_written_once() {
    for (name, text) in generated("rs") {
        let before = text.lines().take_while(|line| *line != "equations! {").count();
        assert!(before <= 8, "{name}: {before} lines before what runs");
        let runs = &text[..text.find("\n}\n").expect("an end of what runs")];
        assert!(!runs.contains("\\frac") && !runs.contains("''"), "{name}: equations for reading");
        assert!(text.contains(&format!("text \"text/{name}.txt\";")), "{name}");
        assert!(text.contains(&format!("latex \"latex/{name}.tex\";")), "{name}");
    }
}

/// A row of the table of proofs in ARCHITECTURE.md.
struct Claim {
    /// Its name in README.
    what: String,
    /// The block that a file with the proof has; `every file` if the proof is in all files.
    of: String,
    /// How the line in the file begins.
    begins: String,
}

fn claims() -> Vec<Claim> {
    let text = read(&root().join("ARCHITECTURE.md"));
    let table = text.split("| proved | in | its line in the file begins with |").nth(1).expect("the table of proofs");
    let rows = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    let claims: Vec<Claim> = rows
        .map(|row| {
            let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
            let [what, of, begins] = cells[..] else { panic!("not three cells: {row}") };
            let bare = |cell: &str| cell.trim_matches('`').to_string();
            Claim { what: what.into(), of: bare(of), begins: bare(begins) }
        })
        .collect();
    assert!(claims.len() >= 9, "{} proofs are claimed", claims.len());
    claims
}

/// The statements in the comment at the end of a file, each in one line.
fn proofs(file: &str) -> Vec<String> {
    let comment = file.split("// Proved of these equations, symbolically:").nth(1).expect("a list of proofs");
    let mut all: Vec<String> = vec![];
    for line in comment.lines().skip(2).take_while(|line| *line != "//") {
        match (line.strip_prefix("// - "), line.strip_prefix("//   "), all.last_mut()) {
            (Some(first), ..) => all.push(first.into()),
            (_, Some(more), Some(last)) => *last += &format!(" {more}"),
            _ => panic!("neither a proof nor the rest of one: {line}"),
        }
    }
    all
}

/// Each proof is in the files that ARCHITECTURE names and in no others, and README names each.
#[test]
fn readme_and_architecture_claim_what_the_files_say() {
    let readme = read(&root().join("README.md")).split_whitespace().collect::<Vec<_>>().join(" ");
    let (claims, files) = (claims(), generated("rs"));
    for Claim { what, of, begins } in &claims {
        assert!(readme.contains(what.as_str()), "README does not name what is proved: {what}");
        let mut met = 0;
        for (name, file) in &files {
            let expected = of == "every file" || file.lines().any(|line| line.trim_start().contains(of.as_str()));
            let proved = proofs(file).iter().any(|proof| proof.starts_with(begins.as_str()));
            assert_eq!(proved, expected, "{name}: {what}: `{begins}` where there is `{of}`");
            met += usize::from(proved);
        }
        assert!(met > 0, "no file has the proof: {what}");
    }
    for (name, file) in &files {
        for proof in proofs(file) {
            let note = proof.starts_with("without the jump terms the balance fails");
            let claimed = claims.iter().any(|claim| proof.starts_with(claim.begins.as_str()));
            assert!(claimed || note, "{name}: not in the table of ARCHITECTURE.md: {proof}");
            assert_eq!(
                proof.contains("not decided"),
                name == UNDECIDED && proof.contains("positive definite"),
                "{name}: {proof}"
            );
        }
    }
}

/// Every law is named in a proof about its steps, and every switch in the proof about its exits.
#[test]
fn every_law_and_every_switch_has_its_proof() {
    for (name, file) in generated("rs") {
        let proofs = proofs(&file);
        let named = |begins: &str, what: &str| {
            let of = |proof: &String| {
                let names = proof.strip_prefix(begins)?.split(':').next()?.split(", ").map(String::from);
                Some(names.collect::<Vec<_>>())
            };
            assert!(proofs.iter().filter_map(of).any(|names| names.iter().any(|n| n == what)), "{name}: {what}");
        };
        for law in file.lines().filter_map(|line| line.strip_prefix("    jump ")) {
            let law_name = law.split(' ').next().expect("a name");
            let smooth = law.ends_with("{ step {} }");
            named(if smooth { "V is the same on both sides of a step of " } else { "at a step of " }, law_name);
        }
        let switches =
            file.lines().skip_while(|line| *line != "    switches {").skip(1).take_while(|line| *line != "    }");
        for line in switches
            .filter(|line| line.starts_with("        ") && !line.starts_with("         ") && *line != "        }")
        {
            let over = line.trim_start().split(' ').next().expect("a name");
            named("V is the same on both sides of the exits of ", over);
        }
    }
}

/// README states how many models there are. Models that differ in the number of their parts are of one kind.
#[test]
fn readme_counts_the_models() {
    let readme = read(&root().join("README.md"));
    let names: Vec<&str> = gearsim_models::MODELS.iter().map(|entry| entry.0).collect();
    let mut kinds: Vec<&str> =
        names.iter().map(|name| name.trim_end_matches(|c: char| c == '_' || c.is_ascii_digit())).collect();
    kinds.dedup();
    let claim = format!("{} derived models of {} kinds", names.len(), kinds.len());
    assert!(readme.contains(&claim), "README does not say: {claim}");
}
