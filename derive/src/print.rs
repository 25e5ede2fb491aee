//! Printing trees: as plain text, as Rust, as LaTeX.

use crate::expr::Kind;
use crate::tree::Tree;

/// The output format.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Style {
    /// `M2*dk*phi^2/2`
    Plain,
    /// `M2*dk*phi.powi(2)/2.0`
    Rust,
    /// `\frac{M_2\, k'\, \varphi^{2}}{2}`
    Latex,
}

/// The expression in a style.
pub(crate) fn print(tree: &Tree, style: Style) -> String {
    match tree {
        Tree::Sum(terms) => sum(terms, style),
        _ => {
            let (negative, body) = term(tree, style);
            if negative { format!("-{body}") } else { body }
        }
    }
}

fn sum(terms: &[Tree], style: Style) -> String {
    if let Some((n, d)) = common_coefficient(terms) {
        let bare: Vec<Tree> = terms.iter().map(with_sign_of).collect();
        let inner = format!("({})", sum(&bare, style));
        return match (n, d, style) {
            (1, d, Style::Latex) => format!("\\frac{{1}}{{{d}}} {inner}"),
            (n, 1, Style::Latex) => format!("{n} {inner}"),
            (n, d, Style::Latex) => format!("\\frac{{{n}}}{{{d}}} {inner}"),
            (1, d, _) => format!("{inner}/{}", integer(d, style)),
            (n, 1, _) => format!("{}*{inner}", integer(n, style)),
            (n, d, _) => format!("{}*{inner}/{}", integer(n, style), integer(d, style)),
        };
    }
    let mut out = String::new();
    // A positive term comes first, if there is one: `a - b`, not `-b + a`.
    let first = terms.iter().position(|t| t.coefficient().0.0 > 0).unwrap_or(0);
    let order = std::iter::once(first).chain((0..terms.len()).filter(|&i| i != first));
    for (i, index) in order.enumerate() {
        let (negative, body) = term(&terms[index], style);
        match (i, negative) {
            (0, true) => out.push('-'),
            (0, false) => {}
            (_, true) => out.push_str(" - "),
            (_, false) => out.push_str(" + "),
        }
        out.push_str(&body);
    }
    out
}

/// The rational factor that all terms share up to their sign, if it is not 1.
fn common_coefficient(terms: &[Tree]) -> Option<(i64, i64)> {
    let size = |t: &Tree| {
        let ((n, d), _) = t.coefficient();
        (n.abs(), d)
    };
    let first = size(terms.first()?);
    (first != (1, 1) && terms.iter().all(|t| size(t) == first)).then_some(first)
}

/// The term with the coefficient 1 or -1.
fn with_sign_of(t: &Tree) -> Tree {
    let ((n, _), rest) = t.coefficient();
    match (n < 0, rest) {
        (false, rest) => rest,
        (true, Tree::Product(mut factors)) => {
            factors.insert(0, Tree::Number(-1, 1));
            Tree::Product(factors)
        }
        (true, rest) => Tree::Product(vec![Tree::Number(-1, 1), rest]),
    }
}

/// One term: whether it is negative, and its magnitude.
fn term(tree: &Tree, style: Style) -> (bool, String) {
    let ((n, d), rest) = tree.coefficient();
    let factors = match rest {
        Tree::Product(factors) => factors,
        Tree::Number(1, 1) => vec![],
        other => vec![other],
    };
    let (mut above, mut below) = (vec![], vec![]);
    for factor in &factors {
        match factor {
            Tree::Power(base, (p, q)) if *p < 0 => below.push(inverse(base, (-p, *q))),
            _ => above.push(factor.clone()),
        }
    }
    let mut top: Vec<String> = above.iter().map(|f| factor_text(f, style)).collect();
    let mut bottom: Vec<String> = below.iter().map(|f| factor_text(f, style)).collect();
    if n.abs() != 1 || top.is_empty() {
        top.insert(0, integer(n.abs(), style));
    }
    if d != 1 {
        bottom.insert(0, integer(d, style));
    }
    let body = match (style, bottom.len()) {
        (Style::Latex, 0) => top.join("\\, "),
        (Style::Latex, _) => format!("\\frac{{{}}}{{{}}}", top.join("\\, "), bottom.join("\\, ")),
        (_, 0) => top.join("*"),
        (_, 1) => format!("{}/{}", top.join("*"), bottom[0]),
        _ => format!("{}/({})", top.join("*"), bottom.join("*")),
    };
    (n < 0, body)
}

fn inverse(base: &Tree, power: (i64, i64)) -> Tree {
    if power == (1, 1) { base.clone() } else { Tree::Power(Box::new(base.clone()), power) }
}

fn factor_text(tree: &Tree, style: Style) -> String {
    match tree {
        Tree::Number(..) => print(tree, style),
        Tree::Symbol(kind, name) => symbol_text(*kind, name, style),
        Tree::Power(base, power) => power_text(base, *power, style),
        Tree::Call(name, arguments) => call_text(name, arguments, style),
        Tree::Sum(_) | Tree::Product(_) => match style {
            Style::Latex => format!("\\left({}\\right)", print(tree, style)),
            _ => format!("({})", print(tree, style)),
        },
    }
}

fn power_text(base: &Tree, (n, d): (i64, i64), style: Style) -> String {
    let inner = factor_text(base, style);
    match (style, n, d) {
        (Style::Latex, 1, 2) => format!("\\sqrt{{{}}}", print(base, style)),
        (Style::Latex, n, 1) => format!("{inner}^{{{n}}}"),
        (Style::Latex, n, d) => format!("{inner}^{{{n}/{d}}}"),
        (Style::Plain, 1, 2) => format!("sqrt({})", print(base, style)),
        (Style::Plain, n, 1) => format!("{inner}^{n}"),
        (Style::Plain, n, d) => format!("{inner}^({n}/{d})"),
        (Style::Rust, 1, 2) => format!("{inner}.sqrt()"),
        (Style::Rust, n, 1) => format!("{inner}.powi({n})"),
        (Style::Rust, n, d) => format!("{inner}.powf({n}.0/{d}.0)"),
    }
}

fn call_text(name: &str, arguments: &[Tree], style: Style) -> String {
    match (style, arguments) {
        (Style::Rust, [x]) => format!("{}.{}()", factor_text(x, style), if name == "log" { "ln" } else { name }),
        (Style::Latex, [x]) => format!("\\{name}\\left({}\\right)", print(x, style)),
        _ => {
            let arguments: Vec<String> = arguments.iter().map(|a| print(a, style)).collect();
            format!("{name}({})", arguments.join(", "))
        }
    }
}

fn integer(n: i64, style: Style) -> String {
    if style == Style::Rust { format!("{n}.0") } else { n.to_string() }
}

/// A single symbol.
pub(crate) fn symbol_text(kind: Kind, name: &str, style: Style) -> String {
    if style != Style::Latex {
        return name.to_string();
    }
    match kind {
        Kind::Speed | Kind::Rate => format!("\\dot{{{}}}", latex_name(name.trim_end_matches("_dot"))),
        Kind::Acceleration => format!("\\ddot{{{}}}", latex_name(name.trim_end_matches("_ddot"))),
        Kind::Slope => format!("{}'", latex_name(&name[1..])),
        Kind::Curvature => format!("{}''", latex_name(&name[2..])),
        Kind::Mid => format!("\\bar{{{}}}", latex_name(name.trim_end_matches("_mid"))),
        _ => latex_name(name),
    }
}

/// `theta` -> `\theta`, `I1` -> `I_{1}`, `theta_motor` -> `\theta_{motor}`.
pub(crate) fn latex_name(name: &str) -> String {
    let cut = name.find(|c: char| c == '_' || c.is_ascii_digit()).unwrap_or(name.len());
    let (head, tail) = (&name[..cut], name[cut..].trim_start_matches('_'));
    let head = match head {
        "phi" => "\\varphi".to_string(),
        "alpha" | "beta" | "gamma" | "delta" | "epsilon" | "zeta" | "eta" | "theta" | "kappa" | "lambda" | "mu"
        | "nu" | "xi" | "rho" | "sigma" | "tau" | "psi" | "omega" => format!("\\{head}"),
        _ if head.len() > 1 => format!("\\mathrm{{{head}}}"),
        _ => head.to_string(),
    };
    if tail.is_empty() { head } else { format!("{head}_{{{}}}", tail.replace('_', ",")) }
}
