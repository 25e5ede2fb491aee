//! Computes constant factors once for each scene. A file has terms such as `-I1*alpha_M*theta_dot/N1.powi(2)`, as derived. In the
//! functions that are called at every step, one coefficient replaces all constant factors of a term, and terms that differ only in
//! their constant factors are merged.

use quote::quote;
use syn::{BinOp, Expr, ExprBinary, ExprParen, Index, Lit, Token, parse_quote};

/// Replaces the constant factors in expressions by `self.coefficients[i]`, and returns the coefficients in this order, as expressions
/// in parameters, mid values and constants.
pub fn hoist(mut expressions: Vec<&mut Expr>) -> Vec<Expr> {
    let mut hoist = Hoist::default();
    expressions.iter().for_each(|e| hoist.count(e));
    expressions.iter_mut().for_each(|e| hoist.replace(e));
    hoist.coefficients
}

#[derive(Default)]
struct Hoist {
    coefficients: Vec<Expr>,
    /// Factors, each with the number of products that contain it.
    counts: Vec<(Expr, usize)>,
}

/// A product: its sign, factors and divisors.
#[derive(Default)]
struct Product {
    negative: bool,
    above: Vec<Expr>,
    below: Vec<Expr>,
}

/// Terms that differ only in their constant factors.
struct Group {
    /// The product of the factors that vary; `None` if there are none.
    moving: Option<Expr>,
    /// The constant factors of each term.
    constants: Vec<Product>,
}

impl Hoist {
    fn replace(&mut self, e: &mut Expr) {
        *e = self.expression(e);
    }

    fn count(&mut self, e: &Expr) {
        let mut products = vec![];
        flatten(e, false, &mut products);
        for factor in products.into_iter().flat_map(|p| p.above) {
            match self.counts.iter_mut().find(|(counted, _)| *counted == factor) {
                Some((_, n)) => *n += 1,
                None => self.counts.push((factor, 1)),
            }
        }
    }

    fn expression(&mut self, e: &Expr) -> Expr {
        match e {
            Expr::MethodCall(call) => {
                let mut call = call.clone();
                *call.receiver = atom(self.expression(&call.receiver));
                Expr::MethodCall(call)
            }
            Expr::Paren(_) | Expr::Group(_) | Expr::Unary(_) | Expr::Binary(_) => self.terms(e),
            _ => e.clone(),
        }
    }

    /// A sum (or a single product) with its terms merged and their constant factors replaced.
    fn terms(&mut self, e: &Expr) -> Expr {
        let mut products = vec![];
        flatten(e, false, &mut products);
        products.retain(|p| !p.above.iter().any(is_zero));
        let mut groups: Vec<Group> = vec![];
        for p in products {
            let (moving, constants) = self.split(p);
            match groups.iter_mut().find(|group| group.moving == moving) {
                Some(group) => group.constants.push(constants),
                None => groups.push(Group { moving, constants: vec![constants] }),
            }
        }
        // A term with a minus is subtracted, not multiplied by a negative coefficient, so that rows share the product. Only the first
        // term has its sign in its coefficient; a positive term is made the first, if there is one.
        let first = groups.iter().position(|group| !group.is_subtracted()).unwrap_or(0);
        if let Some(front) = groups.get_mut(..=first) {
            front.rotate_right(1);
        }
        let mut whole: Option<Expr> = None;
        for group in groups {
            let minus = whole.is_some() && group.is_subtracted();
            let Group { moving, mut constants } = group;
            if minus {
                constants[0].negative = false;
            }
            let term = match moving {
                Some(moving) if matches!(&constants[..], [one] if one.is_one()) => moving,
                Some(moving) => {
                    let number = self.number(&constants);
                    binary(moving, BinOp::Mul(<Token![*]>::default()), number)
                }
                None => self.number(&constants),
            };
            whole = Some(match (whole, minus) {
                (None, _) => term,
                (Some(sum), false) => binary(sum, BinOp::Add(<Token![+]>::default()), term),
                (Some(sum), true) => binary(sum, BinOp::Sub(<Token![-]>::default()), term),
            });
        }
        whole.unwrap_or_else(|| parse_quote!(0.0))
    }

    /// Splits a product into the product of its varying factors and that of its constant ones.
    fn split(&mut self, mut p: Product) -> (Option<Expr>, Product) {
        // Factors of many products come first: such products then begin with the same factors, and the compiler computes that part
        // once.
        p.above.sort_by_key(|e| {
            self.counts.iter().find(|(counted, _)| counted == e).map_or(usize::MAX, |(_, n)| usize::MAX - n)
        });
        let mut of = |factors: Vec<Expr>| -> (Vec<Expr>, Vec<Expr>) {
            let (still, moving): (Vec<_>, Vec<_>) = factors.into_iter().partition(constant);
            (still, moving.iter().map(|e| atom(self.expression(e))).collect())
        };
        let ((above, moving), (below, divisors)) = (of(p.above), of(p.below));
        let product = moving.into_iter().reduce(|a, b| binary(a, BinOp::Mul(<Token![*]>::default()), b));
        let product = product.or_else(|| (!divisors.is_empty()).then(|| parse_quote!(1.0)));
        let divided =
            |product| divisors.into_iter().fold(product, |a, b| binary(a, BinOp::Div(<Token![/]>::default()), b));
        let moving = product.map(divided);
        (moving, Product { negative: p.negative, above, below })
    }

    /// A sum of constant products: unchanged if it is a single name or has only literals, else a coefficient.
    fn number(&mut self, constants: &[Product]) -> Expr {
        if let [Product { negative: false, above, below }] = constants
            && let ([one @ Expr::Field(_)], []) = (&above[..], &below[..])
        {
            return one.clone();
        }
        let products = constants.iter().map(|p| {
            let sign = p.negative.then(|| quote!(-));
            let below = p.below.iter().map(in_numbers);
            match &p.above.iter().map(in_numbers).collect::<Vec<_>>()[..] {
                [] => quote!(#sign 1.0 #(/ #below)*),
                [first, rest @ ..] => quote!(#sign #first #(* #rest)* #(/ #below)*),
            }
        });
        let value: Expr = parse_quote!(#(#products)+*);
        if constants.iter().all(|p| p.above.iter().chain(&p.below).all(|e| matches!(e, Expr::Lit(_)))) {
            return parse_quote!((#value));
        }
        let i = self.coefficients.iter().position(|c| *c == value).unwrap_or_else(|| {
            self.coefficients.push(value);
            self.coefficients.len() - 1
        });
        let i = Index::from(i);
        parse_quote!(self.coefficients[#i])
    }
}

/// Whether an expression has only literals and numbers of the scene (`self.I1`) in it.
fn constant(e: &Expr) -> bool {
    match e {
        Expr::Lit(_) | Expr::Field(_) => true,
        Expr::Paren(e) => constant(&e.expr),
        Expr::Group(e) => constant(&e.expr),
        Expr::Unary(e) => constant(&e.expr),
        Expr::Binary(e) => constant(&e.left) && constant(&e.right),
        Expr::MethodCall(e) => constant(&e.receiver) && e.args.iter().all(constant),
        _ => false,
    }
}

fn is_zero(e: &Expr) -> bool {
    matches!(e, Expr::Lit(lit) if matches!(&lit.lit, Lit::Float(x) if x.base10_parse::<f64>().is_ok_and(|x| x == 0.0)))
}

/// Appends the terms of a sum, as products, to `products`.
fn flatten(e: &Expr, negative: bool, products: &mut Vec<Product>) {
    match e {
        Expr::Paren(e) => flatten(&e.expr, negative, products),
        Expr::Group(e) => flatten(&e.expr, negative, products),
        Expr::Binary(e) if matches!(e.op, BinOp::Add(_) | BinOp::Sub(_)) => {
            flatten(&e.left, negative, products);
            flatten(&e.right, negative ^ matches!(e.op, BinOp::Sub(_)), products);
        }
        _ => {
            let mut product = Product { negative, ..Product::default() };
            product.take(e, false);
            products.push(product);
        }
    }
}

impl Group {
    /// Whether it is a single product with a minus.
    fn is_subtracted(&self) -> bool {
        matches!(&self.constants[..], [one] if one.negative)
    }
}

impl Product {
    /// Whether it has no factor, no divisor and no minus.
    fn is_one(&self) -> bool {
        !self.negative && self.above.is_empty() && self.below.is_empty()
    }

    /// Multiplies by an expression, or divides by it if `inverse`.
    fn take(&mut self, e: &Expr, inverse: bool) {
        match bare(e) {
            Expr::Unary(e) => {
                self.negative ^= true;
                self.take(&e.expr, inverse);
            }
            Expr::Binary(e) if matches!(e.op, BinOp::Mul(_) | BinOp::Div(_)) => {
                self.take(&e.left, inverse);
                self.take(&e.right, inverse ^ matches!(e.op, BinOp::Div(_)));
            }
            e => if inverse { &mut self.below } else { &mut self.above }.push(atom(e.clone())),
        }
    }
}

/// The expression without enclosing parentheses.
fn bare(e: &Expr) -> &Expr {
    match e {
        Expr::Paren(e) => bare(&e.expr),
        Expr::Group(e) => bare(&e.expr),
        _ => e,
    }
}

/// The expression as a factor: in parentheses if it is a binary or unary operation.
fn atom(e: Expr) -> Expr {
    if !matches!(e, Expr::Binary(_) | Expr::Unary(_)) {
        return e;
    }
    Expr::Paren(ExprParen { attrs: vec![], paren_token: Default::default(), expr: Box::new(e) })
}

/// `left op right`. It is built without parsing, because files have thousands of products.
fn binary(left: Expr, op: BinOp, right: Expr) -> Expr {
    Expr::Binary(ExprBinary { attrs: vec![], left: Box::new(left), op, right: Box::new(right) })
}

/// The expression with plain names of numbers, `I1` for `self.I1`, as in the function that computes the coefficients.
fn in_numbers(e: &Expr) -> Expr {
    let mut e = e.clone();
    match &mut e {
        Expr::Field(field) => {
            let name = &field.member;
            return parse_quote!(#name);
        }
        Expr::Paren(e) => *e.expr = in_numbers(&e.expr),
        Expr::Group(e) => *e.expr = in_numbers(&e.expr),
        Expr::Unary(e) => *e.expr = in_numbers(&e.expr),
        Expr::Binary(e) => (*e.left, *e.right) = (in_numbers(&e.left), in_numbers(&e.right)),
        Expr::MethodCall(call) => {
            *call.receiver = in_numbers(&call.receiver);
            call.args = call.args.iter().map(in_numbers).collect();
        }
        _ => {}
    }
    e
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The text of an expression after hoisting, and its coefficients.
    fn hoisted(e: &str) -> (String, Vec<String>) {
        let mut hoist = Hoist::default();
        let mut e: Expr = syn::parse_str(e).expect("an expression");
        hoist.count(&e);
        hoist.replace(&mut e);
        let text = |e: &Expr| quote!(#e).to_string().replace(' ', "");
        (text(&e), hoist.coefficients.iter().map(text).collect())
    }

    #[test]
    fn constant_factors_become_one_coefficient() {
        let (e, c) = hoisted("-self.I*self.a*v[0]/self.N.powi(2) - self.J*v[0] + q[0]/self.N");
        assert_eq!((e.as_str(), c.len()), ("v[0]*self.coefficients[0]+q[0]*self.coefficients[1]", 2));
        assert_eq!(c, ["-I*a/N.powi(2)+-J", "1.0/N"]);
    }

    #[test]
    fn a_single_name_is_no_coefficient_and_a_later_minus_is_a_subtraction() {
        assert_eq!(hoisted("self.k1*d[0] - self.k2*d[1]"), ("d[0]*self.k1-d[1]*self.k2".into(), vec![]));
        assert_eq!(hoisted("-self.k1*d[0]"), ("d[0]*self.coefficients[0]".into(), vec!["-k1".into()]));
    }

    #[test]
    fn hoisting_handles_signs_zeros_literals_and_roots() {
        assert_eq!(hoisted("q[0] - edge - 0.0").0, "q[0]-edge");
        assert_eq!(hoisted("-q[0]").0, "q[0]*(-1.0)");
        assert_eq!(hoisted("(-k[0]*q[0] - k[1]*q[1])/2.0").0, "(k[0]*q[0]*(-1.0)-k[1]*q[1])*(1.0/2.0)");
        let (e, c) = hoisted("q[0]*(self.t.powi(2) + d[0].powi(2)).sqrt()");
        assert_eq!(
            (e.as_str(), &c[..]),
            ("q[0]*(self.coefficients[0]+d[0].powi(2)).sqrt()", &["t.powi(2)".to_string()][..])
        );
    }

    #[test]
    fn factors_of_many_products_come_first() {
        let (e, _) = hoisted("a*x*y*self.c + x*y*b*self.d");
        assert_eq!(e, "x*y*a*self.c+x*y*b*self.d");
    }
}
