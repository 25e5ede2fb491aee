//! The committed generated files equal a new derivation, in this process and in fresh ones, in any order of derivation.

use std::path::PathBuf;
use std::process::Command;

use gearsim_derive::{Expr, Home, Model, Range, Start, derive};
use gearsim_models::{ELEMENTS, MODELS};

/// Environment variable that makes this program derive the gear pair, print its file and end. Its value, one of `CHILDREN`, says what the
/// program does before the derivation.
const CHILD: &str = "GEARSIM_DERIVES_IN_CHILD";
/// The line in a child's output between the text that Symbolica prints at its start and the file.
const HERE: &str = "=== file ===\n";
const CHILDREN: [&str; 3] = ["at once", "at once", "after other symbols"];

/// Does a child's work if this process is a child; returns whether it is.
pub fn in_child() -> bool {
    let Ok(how) = std::env::var(CHILD) else { return false };
    if how == CHILDREN[2] {
        // Declares the names of the gear pair and others first, in the opposite order, some of them as another kind of symbol.
        let other = Model::new("other", |m| {
            let _ = (Expr::symbol("zz"), Expr::function("f", Expr::symbol("M2")));
            let phi = m.coordinate("phi", "rad", Start::Static, "");
            let theta = m.coordinate("theta", "rad", Start::Static, "");
            for name in ["k", "T0", "zeta", "I2", "I1", "N2", "N1", "C"] {
                let p = m.parameter(name, "1", None, Range::Positive, "");
                m.kinetic(p * (theta - phi).dot().sq());
            }
            m.kinetic(phi.dot().sq());
        });
        derive(&other).expect("a sound model");
    }
    let gear_pair = Model::new("gear_pair", gearsim_models::gear_pair::gear_pair);
    print!("{HERE}{}", derive(&gear_pair).expect("the gear pair is sound").file());
    true
}

/// The files that fresh processes derive, one after another. Call this before this process first calls Symbolica.
pub fn derive_in_children() -> Vec<String> {
    let this = std::env::current_exe().expect("this program has a path");
    let derive = |how: &str| {
        let child = Command::new(&this).env(CHILD, how).output().expect("this program can be run");
        let errors = String::from_utf8_lossy(&child.stderr);
        assert!(
            child.status.success(),
            "a child that derives {how} failed ({}): is Symbolica running elsewhere on this machine?\n{errors}",
            child.status
        );
        let printed = String::from_utf8(child.stdout).expect("a file is text");
        printed.split_once(HERE).expect("a child prints its file").1.to_string()
    };
    CHILDREN.map(derive).into()
}

pub fn fresh_processes_agree(afresh: &[String]) {
    let committed = std::fs::read_to_string(generated("gear_pair.rs")).expect("the file of the gear pair is committed");
    for (how, text) in CHILDREN.iter().zip(afresh) {
        assert!(text.contains("equations! {"), "derived {how}: not a file of equations: {text}");
        if let Some((line, (a, b))) = first_difference(text, &afresh[0]) {
            panic!("a process that derives {how} gives another file than the first; line {line}:\n{a}\nfirst:\n{b}");
        }
        if let Some((line, (a, b))) = first_difference(text, &committed) {
            panic!("derived {how}, line {line} is:\n{a}\ncommitted is:\n{b}\nMend with: cargo xtask derive gear_pair");
        }
    }
}

pub fn committed_files_are_current() {
    for (name, describe) in MODELS.iter().chain(ELEMENTS) {
        let model = Model::new(name, describe);
        let files = derive(&model).unwrap_or_else(|slip| panic!("{slip}")).files(Home::default());
        for (path, derived) in &files {
            let committed = std::fs::read_to_string(generated(path)).unwrap_or_default();
            if let Some((line, (a, b))) = first_difference(derived, &committed) {
                panic!(
                    "gearsim/generated/src/{path} is not what its energies give; line {line}, derived:\n{a}\n\
                     committed:\n{b}\nMend with: cargo xtask derive {name}"
                );
            }
        }
        syn::parse_file(&files[0].1).unwrap_or_else(|e| panic!("{name}: not Rust: {e}"));
    }
}

/// The number (from 1) and the text of the first line in which two texts differ.
pub fn first_difference<'a>(a: &'a str, b: &'a str) -> Option<(usize, (&'a str, &'a str))> {
    if a == b {
        return None;
    }
    let lines = a.lines().zip(b.lines()).position(|(a, b)| a != b).unwrap_or(a.lines().count().min(b.lines().count()));
    let line = |text: &'a str| text.lines().nth(lines).unwrap_or("(nothing)");
    Some((lines + 1, (line(a), line(b))))
}

fn generated(path: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "../gearsim/generated/src", path].iter().collect()
}
