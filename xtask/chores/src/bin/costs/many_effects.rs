//! Models of many effects, for the compile time against the number of effects: a chain whose springs have a transmission error and a
//! damper each, every one an effect of its own. All 2^n sets of the n effects are admissible.

use std::fmt::Write;

/// The name of the model with `n` effects.
pub fn name(n: usize) -> String {
    format!("effects_{n}")
}

/// The file of the model with `n` effects, as derived files are: one macro call.
pub fn file(n: usize) -> String {
    let each = |of: &dyn Fn(usize) -> String| (0..n).map(of).collect::<String>();
    let masses = |of: &dyn Fn(usize) -> String| (0..=n).map(of).collect::<String>();
    let blocks = [
        ("coordinates", masses(&|i| format!("x{i} \"m\" start 0.0, \"mass {i}\";\n"))),
        (
            "parameters",
            ["m", "k", "c"].map(|name| format!("{name} \"1\" required, open 0.0 to inf, \"number\";\n")).concat(),
        ),
        ("laws", each(&|i| format!("e{i} \"m\" phase x{i} period 1.0 with effect{i}, \"error\";\n"))),
        ("effects", each(&|i| format!("effect{i} \"error and damper of spring {i}\";\n"))),
        ("deflections", each(&|i| format!("d{i} = x{i} - x{} - e{i};\n", i + 1))),
        ("energies", energies(n)),
        ("mass", masses(&|i| format!("x{i} x{i} {{ _ => m; }}\n"))),
        ("force", masses(&|i| format!("x{i} {{ {} {} }}\n", row(i, n, "-", i), row(i.wrapping_sub(1), n, "", i)))),
        ("jacobian", String::new()),
    ];
    let mut text = format!("gearsim::equations! {{\nmodel {} \"springs with errors\";\n", name(n));
    for (block, lines) in blocks {
        writeln!(text, "{block} {{\n{lines}}}").expect("a string takes all");
    }
    text + "}\n"
}

fn energies(n: usize) -> String {
    let sum = |of: &dyn Fn(usize) -> String| (0..n).map(of).collect::<String>();
    let kinetic = sum(&|i| format!("_ => m*x{i}_dot.powi(2)/2.0;\n"));
    let potential = sum(&|i| format!("_ => k*d{i}.powi(2)/2.0;\n"));
    let dissipation = sum(&|i| format!("effect{i} => c*d{i}_dot.powi(2)/2.0;\n"));
    format!("kinetic {{ {kinetic} }}\npotential {{ {potential} }}\ndissipation {{ {dissipation} }}\n")
}

/// The terms of spring `i` in the force on mass `on`, if there is such a spring.
fn row(i: usize, n: usize, sign: &str, on: usize) -> String {
    if i >= n {
        return String::new();
    }
    let slope = if on == i { format!("effect{i} => k*de{i}*d{i};") } else { String::new() };
    format!("_ => {sign}k*d{i}; effect{i} => {sign}c*d{i}_dot; {slope}")
}
