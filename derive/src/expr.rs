//! Symbolic expressions over declared symbols; energies are written in them.
//!
//! [`Expr`] is a `Copy` index into a thread-local arena, so that energies read like formulas
//! (`half(I1 * (q1.dot() / N1).sq())`) without `&` or `clone`. The namespace of a symbol gives its [`Kind`].

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::LazyLock;

use symbolica::atom::{Atom, AtomCore, AtomView, Symbol};

thread_local! {
    static ARENA: RefCell<Vec<Atom>> = const { RefCell::new(Vec::new()) };
    /// The rates of the named functions of the model that is being described.
    static RATES: RefCell<HashMap<String, Expr>> = RefCell::new(HashMap::new());
    /// The symbols of each kind asked for so far: Symbolica parses a name each time.
    static SYMBOLS: RefCell<BTreeMap<Kind, HashMap<String, Symbol>>> = const { RefCell::new(BTreeMap::new()) };
}

/// A symbolic expression.
#[derive(Clone, Copy, Debug)]
pub struct Expr(usize);

/// What a symbol stands for. Factors of a printed product are in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Marker of an effect: 0 or 1, never printed.
    Marker,
    /// Entry of the inverse mass matrix; replaced by its value before anything is printed.
    Mobility,
    /// Named constant.
    Constant,
    /// Parameter.
    Parameter,
    /// Mid value of a law, `k_mid`.
    Mid,
    /// Value of a stiffness at the present phase.
    Law,
    /// First derivative of a law by its phase, `dk`.
    Slope,
    /// Second derivative of a law by its phase, `ddk`.
    Curvature,
    /// Value of a friction law at the present phase.
    Friction,
    /// Named force, a factor in torques.
    Force,
    /// Partial derivative of a named force, `F_mu_by_over`.
    Partial,
    /// Factor that is constant in each mode of a switch.
    Switched,
    /// Named function of one position, or one of its derivatives: `x_p`, `dx_p`, `ddx_p`, `dddx_p`.
    Function,
    /// Named deflection, linear in the coordinates.
    Deflection,
    /// Generalised coordinate.
    Coordinate,
    /// Offset of a deflection that is constant in each mode of a switch, e.g. the edge of a play.
    Edge,
    /// Value of a transmission error at the present phase.
    Error,
    /// Rate of a deflection.
    Rate,
    /// Generalised speed.
    Speed,
    /// Generalised acceleration; only where M depends on the coordinates.
    Acceleration,
    /// The force that the hold of a deflection resists.
    Reaction,
    /// What a run can record.
    Output,
    /// Quantity for outputs that only the engine knows: the reaction of a held deflection, the power of a torque.
    Known,
    /// The force of the springs of a deflection; replaced by its value before anything is derived.
    Spring,
    /// The force of the dampers of a deflection; replaced in the same way.
    Damper,
    /// Anything not declared.
    Free,
}

const KINDS: [(Kind, &str); 26] = [
    (Kind::Marker, "marker"),
    (Kind::Mobility, "mobility"),
    (Kind::Constant, "constant"),
    (Kind::Parameter, "parameter"),
    (Kind::Mid, "mid"),
    (Kind::Law, "law"),
    (Kind::Slope, "slope"),
    (Kind::Curvature, "curvature"),
    (Kind::Friction, "friction"),
    (Kind::Force, "force"),
    (Kind::Partial, "partial"),
    (Kind::Switched, "switched"),
    (Kind::Function, "function"),
    (Kind::Deflection, "deflection"),
    (Kind::Coordinate, "coordinate"),
    (Kind::Edge, "edge"),
    (Kind::Error, "error"),
    (Kind::Rate, "rate"),
    (Kind::Speed, "speed"),
    (Kind::Acceleration, "acceleration"),
    (Kind::Reaction, "reaction"),
    (Kind::Output, "output"),
    (Kind::Known, "known"),
    (Kind::Spring, "spring"),
    (Kind::Damper, "damper"),
    (Kind::Free, "free"),
];

/// Namespace of invalid names. Symbolica would not accept them, so they are encoded in hexadecimal digits; `check` can still
/// quote the original name.
const ODD: &str = "odd";

/// The symbol `name` of a kind. If `name` is not a valid name, the symbol reads back as [`Kind::Free`] and is refused.
pub(crate) fn symbol(kind: Kind, name: &str) -> Symbol {
    SYMBOLS.with_borrow_mut(|symbols| {
        let known = symbols.entry(kind).or_default();
        match known.get(name) {
            Some(symbol) => *symbol,
            None => *known.entry(name.to_string()).or_insert(new_symbol(kind, name)),
        }
    })
}

fn new_symbol(kind: Kind, name: &str) -> Symbol {
    let namespace = KINDS.iter().find(|k| k.0 == kind).map_or("free", |k| k.1);
    let symbol = if is_word(name) {
        symbolica::try_symbol!(format!("{namespace}::{name}"))
    } else {
        let digits: String = name.bytes().map(|byte| format!("{byte:02x}")).collect();
        symbolica::try_symbol!(format!("{ODD}::x{digits}"))
    };
    symbol.unwrap_or_else(|error| unreachable!("Symbolica refuses the symbol {namespace}::{name}: {error:?}"))
}

/// The arc tangent, with its derivative 1/(1 + x²), which Symbolica does not have.
fn arc_tangent() -> Symbol {
    static ATAN: LazyLock<Symbol> = LazyLock::new(|| {
        symbolica::symbol!(
            "smooth::atan",
            der = |f, _, out| {
                if let AtomView::Fun(f) = f
                    && let Some(x) = f.iter().next()
                {
                    let x = x.to_owned();
                    **out = number(1) / (number(1) + &x * &x);
                }
            }
        )
    });
    *ATAN
}

/// The kind and the name of a symbol.
pub(crate) fn kind_and_name(symbol: Symbol) -> (Kind, String) {
    let (namespace, name) = (symbol.get_namespace(), symbol.get_stripped_name());
    let kind = KINDS.iter().find(|k| k.1 == namespace).map_or(Kind::Free, |k| k.0);
    let name = if namespace == ODD { from_digits(&name[1..]) } else { name.to_string() };
    (kind, name)
}

fn from_digits(digits: &str) -> String {
    let bytes = (0..digits.len()).step_by(2).filter_map(|i| u8::from_str_radix(&digits[i..i + 2], 16).ok());
    String::from_utf8_lossy(&bytes.collect::<Vec<u8>>()).into_owned()
}

/// Whether a name starts with a letter and continues with letters, digits and `_`.
pub(crate) fn is_word(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic()) && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// All symbols of an expression with their kinds, sorted by kind and name.
pub(crate) fn symbols(e: &Atom) -> Vec<(Kind, String)> {
    let mut all: Vec<_> = e.get_all_symbols(false).into_iter().map(kind_and_name).collect();
    all.sort();
    all
}

/// A number as an atom.
pub(crate) fn number(n: i64) -> Atom {
    Atom::num(n)
}

/// The expression with a symbol replaced by a value.
pub(crate) fn set(e: &Atom, symbol: Symbol, value: &Atom) -> Atom {
    match e.contains_symbol(symbol) {
        true => e.replace(Atom::var(symbol).to_pattern()).with(value.to_pattern()),
        // The search for a symbol is faster than the search for a pattern.
        false => e.clone(),
    }
}

/// The derivative by a symbol. Of a sum, only the terms that contain the symbol are differentiated: in a long sum they are few.
pub(crate) fn derivative(e: &Atom, by: Symbol) -> Atom {
    match e.as_view() {
        AtomView::Add(sum) => {
            total(sum.iter().filter(|term| term.contains_symbol(by)).map(|term| term.derivative(by)).collect())
        }
        _ => e.derivative(by),
    }
}

/// The sum of many atoms, added in pairs. To add one after another would copy the growing sum each time.
pub(crate) fn total(mut parts: Vec<Atom>) -> Atom {
    while parts.len() > 1 {
        parts = parts.chunks(2).map(|pair| pair.iter().skip(1).fold(pair[0].clone(), |a, b| a + b)).collect();
    }
    parts.pop().unwrap_or_else(|| number(0))
}

impl Expr {
    pub(crate) fn new(atom: Atom) -> Expr {
        ARENA.with_borrow_mut(|arena| {
            arena.push(atom);
            Expr(arena.len() - 1)
        })
    }

    pub(crate) fn var(kind: Kind, name: &str) -> Expr {
        Expr::new(Atom::var(symbol(kind, name)))
    }

    pub(crate) fn atom(self) -> Atom {
        ARENA.with_borrow(|arena| arena[self.0].clone())
    }

    /// A symbol by name, undeclared: a model that contains it is refused. Declared symbols come from the methods of
    /// [`crate::Model`].
    pub fn symbol(name: &str) -> Expr {
        Expr::var(Kind::Free, name)
    }

    /// A function by name: `sin`, `cos`, `exp`, `log` or `atan`. A model that contains any other function is refused. For a piecewise
    /// function (`abs`, `max`, `heaviside`, ...) declare a law instead.
    pub fn function(name: &str, argument: Expr) -> Expr {
        let symbol = match name {
            "sin" => Symbol::SIN,
            "cos" => Symbol::COS,
            "exp" => Symbol::EXP,
            "log" => Symbol::LOG,
            "atan" => arc_tangent(),
            _ => symbol(Kind::Free, name),
        };
        Expr::new(symbolica::function!(symbol, argument.atom()))
    }

    /// Whether the expression is identically zero, decided for rational functions of symbols and of roots.
    pub fn is_zero(self) -> bool {
        crate::mobility::is_zero(&self.atom())
    }

    /// The square.
    pub fn sq(self) -> Expr {
        self.pow(2)
    }

    /// An integer power.
    pub fn pow(self, n: i64) -> Expr {
        Expr::new(self.atom().pow(number(n)))
    }

    /// The square root.
    pub fn sqrt(self) -> Expr {
        Expr::new(self.atom().pow(&(number(1) / number(2))))
    }

    /// The sine.
    pub fn sin(self) -> Expr {
        Expr::function("sin", self)
    }

    /// The cosine.
    pub fn cos(self) -> Expr {
        Expr::function("cos", self)
    }

    /// The arc tangent.
    pub fn atan(self) -> Expr {
        Expr::function("atan", self)
    }

    /// Declares the rate of the named function `name` for [`Expr::dot`].
    pub(crate) fn set_rate(name: &str, rate: Expr) {
        RATES.with_borrow_mut(|rates| rates.insert(name.into(), rate));
    }

    /// Forgets the named functions of the model described before.
    pub(crate) fn forget_rates() {
        RATES.with_borrow_mut(HashMap::clear);
    }

    /// The expression multiplied out.
    pub(crate) fn expand(self) -> Expr {
        Expr::new(self.atom().expand())
    }

    /// The expression with the first symbol replaced by the second.
    pub(crate) fn with(self, (kind, name): (Kind, &str), (new_kind, new_name): (Kind, &str)) -> Expr {
        Expr::new(set(&self.atom(), symbol(kind, name), &Atom::var(symbol(new_kind, new_name))))
    }

    /// The time derivative, by the chain rule over coordinates, deflections and named functions; all other symbols are constant.
    pub fn dot(self) -> Expr {
        let e = self.atom();
        let mut rate = number(0);
        for (kind, name) in symbols(&e) {
            if kind == Kind::Function {
                let of_function = RATES.with_borrow(|rates| rates.get(&name).copied());
                let of_function = of_function.unwrap_or_else(|| Expr::symbol(&speed_name(&name)));
                rate += derivative(&e, symbol(kind, &name)) * of_function.atom();
            }
            let rate_of = match kind {
                Kind::Coordinate => Kind::Speed,
                Kind::Deflection => Kind::Rate,
                _ => continue,
            };
            rate += derivative(&e, symbol(kind, &name)) * Atom::var(symbol(rate_of, &speed_name(&name)));
        }
        Expr::new(rate)
    }
}

/// The kinds of symbols that change along a motion, by which a force is differentiated.
pub(crate) const MOVING: [Kind; 7] =
    [Kind::Coordinate, Kind::Speed, Kind::Deflection, Kind::Rate, Kind::Law, Kind::Friction, Kind::Force];

/// The name of the partial derivative of a force by one of its symbols.
pub(crate) fn partial_name(force: &str, by: &str) -> String {
    format!("{force}_by_{by}")
}

/// The name of the speed of a coordinate.
pub(crate) fn speed_name(coordinate: &str) -> String {
    format!("{coordinate}_dot")
}

/// The name of the reaction that holds the deflection of a switch, in outputs.
pub(crate) fn reaction_name(over: &str) -> String {
    format!("{over}_reaction")
}

/// The name of the power of a torque, in outputs.
pub(crate) fn power_name(torque: &str) -> String {
    format!("{torque}_power")
}

/// The name of the acceleration of a coordinate.
pub(crate) fn acceleration_name(coordinate: &str) -> String {
    format!("{coordinate}_ddot")
}

impl std::fmt::Display for Expr {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&crate::print::print(&crate::tree::Tree::new(&self.atom()), crate::print::Style::Plain))
    }
}

/// Half of an expression.
pub fn half(e: impl Into<Expr>) -> Expr {
    e.into() / 2
}

impl From<i64> for Expr {
    fn from(n: i64) -> Expr {
        Expr::new(number(n))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<R: Into<Expr>> $trait<R> for Expr {
            type Output = Expr;
            fn $method(self, right: R) -> Expr {
                Expr::new(self.atom() $op right.into().atom())
            }
        }
        impl $trait<Expr> for i64 {
            type Output = Expr;
            fn $method(self, right: Expr) -> Expr {
                Expr::new(number(self) $op right.atom())
            }
        }
    };
}
operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl Neg for Expr {
    type Output = Expr;
    fn neg(self) -> Expr {
        Expr::new(-self.atom())
    }
}
