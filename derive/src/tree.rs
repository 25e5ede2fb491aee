//! Expressions as sorted trees. They are printed and counted in this form, which does not depend on the order that Symbolica
//! keeps.

use symbolica::atom::{Atom, AtomView};
use symbolica::coefficient::CoefficientView;

use crate::expr::{Kind, kind_and_name};

/// An expression with sums and products sorted by the kind and name of their symbols.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Tree {
    /// A rational number: numerator, denominator > 0.
    Number(i64, i64),
    Symbol(Kind, String),
    /// Base to a rational power.
    Power(Box<Tree>, (i64, i64)),
    Call(String, Vec<Tree>),
    Sum(Vec<Tree>),
    Product(Vec<Tree>),
}

impl Tree {
    /// The tree of an atom.
    pub fn new(atom: &Atom) -> Tree {
        from_view(atom.as_view())
    }

    /// The rational coefficient (numerator, denominator), and the expression without it.
    pub fn coefficient(&self) -> ((i64, i64), Tree) {
        match self {
            Tree::Number(n, d) => ((*n, *d), Tree::Number(1, 1)),
            Tree::Product(factors) => match factors.first() {
                Some(Tree::Number(n, d)) => {
                    let rest = &factors[1..];
                    let rest = if rest.len() == 1 { rest[0].clone() } else { Tree::Product(rest.to_vec()) };
                    ((*n, *d), rest)
                }
                _ => ((1, 1), self.clone()),
            },
            _ => ((1, 1), self.clone()),
        }
    }

    /// Arithmetic operations of the expression as printed: (sums, products and quotients, functions and roots).
    pub fn operations(&self) -> [usize; 3] {
        let total = |parts: &[Tree]| {
            parts.iter().fold([0; 3], |sum, t| {
                let n = t.operations();
                [sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]]
            })
        };
        match self {
            Tree::Number(..) | Tree::Symbol(..) => [0; 3],
            Tree::Power(base, (n, d)) => {
                let mut count = base.operations();
                match (n.unsigned_abs() as usize, d) {
                    (n, 1) => count[1] += n - 1,
                    (n, _) => {
                        count[2] += 1;
                        count[1] += n - 1;
                    }
                }
                count
            }
            Tree::Call(_, arguments) => {
                let mut count = total(arguments);
                count[2] += 1;
                count
            }
            Tree::Sum(terms) => {
                let mut count = total(terms);
                count[0] += terms.len() - 1;
                count
            }
            Tree::Product(factors) => {
                let mut count = total(factors);
                let signs = usize::from(matches!(factors[0], Tree::Number(-1, 1)));
                let rational = usize::from(matches!(factors[0], Tree::Number(n, d) if n.abs() != 1 && d != 1));
                count[1] += factors.len() - 1 - signs + rational;
                count
            }
        }
    }
}

fn from_view(view: AtomView) -> Tree {
    match view {
        AtomView::Num(n) => match n.get_coeff_view() {
            CoefficientView::Natural(n, d, 0, _) => Tree::Number(n, d),
            other => Tree::Call(format!("{other:?}"), vec![]),
        },
        AtomView::Var(x) => {
            let (kind, name) = kind_and_name(x.get_symbol());
            Tree::Symbol(kind, name)
        }
        AtomView::Fun(f) => {
            Tree::Call(f.get_symbol().get_stripped_name().to_string(), f.iter().map(from_view).collect())
        }
        AtomView::Pow(p) => {
            let (base, exponent) = p.get_base_exp();
            match from_view(exponent) {
                Tree::Number(n, d) => Tree::Power(Box::new(from_view(base)), (n, d)),
                other => Tree::Call("pow".into(), vec![from_view(base), other]),
            }
        }
        AtomView::Mul(m) => {
            let mut factors: Vec<Tree> = m.iter().map(from_view).collect();
            factors.sort_by_cached_key(rank);
            Tree::Product(factors)
        }
        AtomView::Add(a) => {
            let mut terms: Vec<Tree> = a.iter().map(from_view).collect();
            terms.sort_by_cached_key(term_rank);
            Tree::Sum(terms)
        }
    }
}

/// Order of factors: numbers, then symbols and their powers by kind and name, then calls and other powers, then sums.
fn rank(factor: &Tree) -> (u8, Option<(Kind, String)>, Tree) {
    match factor {
        Tree::Number(..) => (0, None, factor.clone()),
        Tree::Symbol(kind, name) => (1, Some((*kind, name.clone())), factor.clone()),
        Tree::Power(base, _) if matches!(**base, Tree::Symbol(..)) => (1, rank(base).1, factor.clone()),
        Tree::Sum(_) => (3, None, factor.clone()),
        _ => (2, None, factor.clone()),
    }
}

/// Order of terms: by their factors without the coefficient; among equal ones the larger numerator first.
fn term_rank(term: &Tree) -> (Tree, (i64, i64)) {
    let ((n, d), rest) = term.coefficient();
    (rest, (-n, d))
}
