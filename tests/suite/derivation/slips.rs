//! Mistakes of an author: what the derivation refuses, and which name its message must contain.

use gearsim_derive::{Boundary, Expr, Factor, Model, Range, Slip, Start, derive, half};
use gearsim_models::components::{friction_effect, mesh_stiffness, transmission_error};

/// A sound model that mistakes are put into: a mass `m` on a spring `s`, at `x`.
pub struct Oscillator {
    pub m: Expr,
    pub s: Expr,
    pub x: Expr,
}

pub fn oscillator(m: &mut Model) -> Oscillator {
    let mass = m.parameter("m", "kg", None, Range::Positive, "mass");
    let s = m.parameter("s", "N/m", None, Range::Positive, "spring");
    let x = m.coordinate("x", "m", Start::At(0.0), "deflection");
    m.kinetic(half(mass * x.dot().sq()));
    m.potential(half(s * x.sq()));
    Oscillator { m: mass, s, x }
}

fn friction_law(m: &mut Model, o: &Oscillator, what: Factor) -> Expr {
    let name = if what == Factor::Side { "side" } else { "arm" };
    m.factor_law(name, "1", o.x, 1.0, what, "")
}

/// Laws switch with the effect `fast`, and in another way with the effect `name`.
fn steps_with(m: &mut Model, name: &str, how: Boundary) {
    for (name, how) in [("fast", Boundary::WithJump), (name, how)] {
        m.effect(name, "", |_| {});
        m.boundaries(name, how);
    }
}

/// The mistake in words, the name that the message must contain, the code with the mistake.
type Row = (&'static str, &'static str, fn(&mut Model, Oscillator));

const SLIPS: &[Row] = &[
    ("a symbol in V that nobody declared", "`kk`", |m, o| m.potential(Expr::symbol("kk") * o.x.sq())),
    ("an undeclared symbol within an effect", "`c2`", |m, o| {
        m.effect("damping", "", |m| m.dissipation(Expr::symbol("c2") * o.x.dot().sq()))
    }),
    ("an undeclared symbol in a constant", "`g`", |m, o| {
        m.constant("W", o.m * Expr::symbol("g"));
    }),
    ("an undeclared symbol that is no word", "`a b`", |m, _| m.potential(Expr::symbol("a b"))),
    ("a coordinate of another model", "`y`", |m, o| {
        let mut y = o.x;
        Model::new("other", |other| y = other.coordinate("y", "m", Start::Static, ""));
        m.potential(half(o.s * (o.x - y).sq()));
    }),
    ("a coordinate under the name of a parameter of this model", "`s`", |m, _| {
        let mut s = 1.into();
        Model::new("other", |other| s = other.coordinate("s", "m", Start::Static, ""));
        m.potential(s.sq());
    }),
    ("two parameters of one name", "`s`", |m, _| {
        m.parameter("s", "N/m", None, Range::Positive, "");
    }),
    ("a parameter called like a speed", "`x_dot`", |m, _| {
        m.parameter("x_dot", "m/s", None, Range::Any, "");
    }),
    ("a parameter called like a coordinate", "`x`", |m, _| {
        m.parameter("x", "m", None, Range::Any, "");
    }),
    ("two motions of one name", "`speed`", |m, o| {
        m.motion("speed", "m/s", &[(o.x, 1.into())], "");
        m.motion("speed", "m/s", &[(o.x, 2.into())], "");
    }),
    ("a name with a space", "`my spring`", |m, _| {
        m.parameter("my spring", "N/m", None, Range::Any, "");
    }),
    ("a name that is a word of Rust", "`while`", |m, _| {
        m.parameter("while", "1", None, Range::Any, "");
    }),
    ("a speed in V", "`x_dot`", |m, o| m.potential(o.m * o.x * o.x.dot())),
    ("the mesh in T", "`k`", |m, o| {
        let k = mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.kinetic(k.value * o.x.dot().sq());
    }),
    ("a slope in V", "`dk`", |m, o| {
        let k = mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.potential(k.slope * o.x.pow(3));
    }),
    ("a transmission error in V, not by way of a deflection", "`e`", |m, o| {
        let e = transmission_error(m, ["e", ""], "m", o.x, 1.0, "");
        m.potential(o.s * (o.x - e).sq());
    }),
    ("a transmission error squared in a deflection", "the deflection `delta`", |m, o| {
        let e = transmission_error(m, ["e", ""], "m", o.x, 1.0, "");
        m.deflection("delta", o.x - e.sq());
    }),
    ("a stiffness in a deflection", "`k`", |m, o| {
        let k = mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.deflection("delta", o.x - k.value);
    }),
    ("a torque that depends on the position", "the torque `wind`", |m, o| m.torque("wind", o.s * o.x, o.x, "")),
    ("a law of friction in V", "`side`", |m, o| {
        friction_effect(m, "", |m| {
            let side = friction_law(m, &o, Factor::Side);
            m.potential(side * o.x.sq());
        });
    }),
    ("friction outside its effect", "`side`", |m, o| {
        let side = friction_law(m, &o, Factor::Side);
        friction_effect(m, "", |_| {});
        m.torque("slide", side * o.s, o.x, "");
    }),
    ("a torque that is friction only in part", "`side`", |m, o| {
        friction_effect(m, "", |m| {
            let side = friction_law(m, &o, Factor::Side);
            let delta = m.deflection("delta", 2 * o.x);
            m.torque("slide", o.s * (delta + side), o.x, "");
        });
    }),
    ("friction of rolling that feeds energy", "`roll`", |m, o| {
        friction_effect(m, "", |m| {
            let arm = friction_law(m, &o, Factor::Arm);
            m.torque("roll", o.m * arm * o.x.dot(), o.x, "");
        });
    }),
    ("friction of rolling with an arm of any sign", "`roll`", |m, o| {
        friction_effect(m, "", |m| {
            let [arm, side] = [Factor::Arm, Factor::Side].map(|what| friction_law(m, &o, what));
            m.torque("roll", -o.m * arm * side * o.x.dot(), o.x, "");
        });
    }),
    ("a constant that moves", "the constant `F`", |m, o| {
        m.constant("F", o.s * o.x);
    }),
    ("a piecewise function", "`abs`", |m, o| m.potential(o.s * Expr::function("abs", o.x))),
    ("a piecewise function deep in a smooth one", "`heaviside`", |m, o| {
        m.potential(Expr::function("cos", 1 + Expr::function("heaviside", o.x)))
    }),
    ("a T linear in a speed", "m*x_dot", |m, o| m.kinetic(o.m * o.x.dot())),
    ("a T of fourth degree in a speed", "m*x_dot^4", |m, o| m.kinetic(o.m * o.x.dot().pow(4))),
    ("a T without a speed", "s", |m, o| m.kinetic(o.s)),
    ("a T that depends on the mesh", "`k`", |m, o| {
        let k = mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.kinetic(o.m * (k.value * o.x.dot()).sq());
    }),
    ("a function of a sum that has no name", "`f`", |m, o| {
        let f = m.function("f", o.x + 1, |u| u.sin());
        m.potential(o.s * f);
    }),
    ("a function of another coordinate", "`f`", |m, o| {
        let y = m.coordinate("y", "m", Start::Static, "");
        let f = m.function("f", o.x, |u| u * y);
        m.potential(o.s * f);
    }),
    ("a coordinate without inertia on a spring and a damper", "`y`", |m, o| {
        let y = m.coordinate("y", "m", Start::Static, "");
        m.potential(half(o.s * (o.x - y).sq()));
        m.dissipation(half(o.m * y.dot().sq()));
    }),
    ("a coordinate without inertia on a torque", "`push`", |m, o| {
        let y = m.coordinate("y", "m", Start::Static, "");
        m.potential(half(o.s * (o.x - y).sq()));
        m.torque("push", o.s, y, "");
    }),
    ("a coordinate without inertia on a spring that varies", "`k`", |m, o| {
        let y = m.coordinate("y", "m", Start::Static, "");
        let k = mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.potential(half(k.value * (o.x - y).sq()));
        m.potential(half(o.s * y.sq()));
    }),
    ("a coordinate without inertia on a spring that is not linear", "proportional", |m, o| {
        let y = m.coordinate("y", "m", Start::Static, "");
        m.potential(o.s * (o.x - y).pow(4));
    }),
    ("a coordinate without inertia and without a spring", "no spring", |m, o| {
        let y = m.coordinate("y", "m", Start::Static, "");
        m.dissipation(half(o.m * y.dot().sq()));
    }),
    ("two coordinates with one inertia between them", "(x, y)", |m, o| {
        let y = m.coordinate("y", "m", Start::Static, "");
        m.kinetic(half(o.m * (2 * o.x.dot() * y.dot() + y.dot().sq())));
    }),
    ("three coordinates with two inertias between them", "(x, y, z)", |m, o| {
        let [y, z] = ["y", "z"].map(|name| m.coordinate(name, "m", Start::Static, ""));
        m.kinetic(half(o.m * (y.dot() - z.dot()).sq()));
    }),
    ("six coordinates with five inertias between them", "(x6)", |m, o| {
        let q: Vec<Expr> = (1..6).map(|i| m.coordinate(&format!("x{}", i + 1), "m", Start::Static, "")).collect();
        q.windows(2).for_each(|x| m.kinetic(half(o.m * (x[0].dot() - x[1].dot()).sq())));
    }),
    ("a deflection that is no sum of coordinates", "`delta`", |m, o| {
        let delta = m.deflection("delta", o.x.sq());
        m.potential(o.s * delta.sq());
    }),
    ("a deflection that is not zero at the start of coordinates", "`delta`", |m, o| {
        let delta = m.deflection("delta", o.x - o.s);
        m.potential(o.s * delta.sq());
    }),
    ("a deflection in T", "`delta_dot`", |m, o| {
        let delta = m.deflection("delta", 2 * o.x);
        m.kinetic(o.m * delta.dot().sq());
    }),
    ("two torques with the name of an effect", "`brake`", |m, o| {
        m.effect("brake", "", |m| (0..2).for_each(|_| m.torque("brake", o.s, o.x, "")));
    }),
    ("an effect declared twice, and not as one", "`damping`", |m, o| {
        m.effect("damping", "of the spring", |m| m.dissipation(o.m * o.x.dot().sq()));
        m.effect("damping", "of the mass", |m| m.dissipation(o.s * o.x.dot().sq()));
    }),
    ("a negative damper", "-m*x_dot^2", |m, o| m.dissipation(-o.m * o.x.dot().sq())),
    ("a damper that a scene could make negative", "c*x_dot^2", |m, o| {
        let c = m.parameter("c", "N*s/m", None, Range::Any, "");
        m.dissipation(c * o.x.dot().sq());
    }),
    ("damping that is no square", "m*x_dot", |m, o| m.dissipation(o.m * o.x.dot())),
    ("damping that depends on the mesh", "`k`", |m, o| {
        let k = mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.dissipation(half(k.value * o.x.dot().sq()));
    }),
    ("a function of two positions with a wrong gradient", "the gradient that is written", |m, o| {
        let y = m.coordinate("y", "m", Start::At(0.0), "");
        m.kinetic(half(o.m * y.dot().sq()));
        let bend = m.function_of("bend", [o.x, y], |[x, y]| x * y, |[x, y]| [y, 2 * x]);
        m.potential(half(o.s * (bend / o.x).sq()));
    }),
    ("T with a function of two positions", "`bend`", |m, o| {
        let y = m.coordinate("y", "m", Start::At(0.0), "");
        let bend = m.function_of("bend", [o.x, y], |[x, y]| x * y, |[x, y]| [y, x]);
        m.kinetic(half(o.m * y.dot().sq()));
        m.kinetic(half(o.m * bend.dot().sq()));
    }),
    ("a deflection with a square of a function", "the deflection `delta`", |m, o| {
        let y = m.coordinate("y", "m", Start::At(0.0), "");
        m.kinetic(half(o.m * y.dot().sq()));
        let bend = m.function_of("bend", [o.x, y], |[x, y]| x * y, |[x, y]| [y, x]);
        m.deflection("delta", o.x - bend.sq());
    }),
    ("a torque along a square of a speed", "the torque `lift`", |m, o| m.torque_along("lift", o.s, o.x.dot().sq(), "")),
    ("a torque along a displacement", "the torque `lift`", |m, o| m.torque_along("lift", o.s, o.x + o.x.dot(), "")),
    ("a phase that is no coordinate", "`k`", |m, o| {
        mesh_stiffness(m, "k", "N/m", 2 * o.x, 1.0, "");
    }),
    ("a pitch of no length", "`k`", |m, o| {
        mesh_stiffness(m, "k", "N/m", o.x, 0.0, "");
    }),
    ("a law that no effect makes switch", "`k`", |m, o| {
        m.stiffness_law("k", "N/m", o.x, 1.0, "");
    }),
    ("an offset outside of an effect", "`e`", |m, o| {
        mesh_stiffness(m, "k", "N/m", o.x, 1.0, "");
        m.offset_law("e", "m", o.x, 1.0, "");
    }),
    ("boundaries of an effect that is not there", "`fast`", |m, _| m.boundaries("fast", Boundary::WithJump)),
    ("two effects that make laws switch", "`slow`", |m, _| {
        for name in ["fast", "slow"] {
            m.effect(name, "", |_| {});
            m.boundaries(name, Boundary::WithJump);
        }
    }),
    ("an effect that makes laws switch in two ways", "`fast`", |m, _| {
        m.effect("fast", "", |_| {});
        m.require("fast", &["fast"]);
        m.boundaries("fast", Boundary::WithJump);
        m.boundaries("fast", Boundary::ByTime);
    }),
    ("boundaries that go by time where laws are constant", "`late`", |m, _| {
        steps_with(m, "late", Boundary::ByTime);
    }),
    ("boundaries that go by time and have no impulse", "`soft`", |m, _| {
        for (name, how) in [("late", Boundary::ByTime), ("soft", Boundary::WithoutJump)] {
            steps_with(m, name, how);
            m.require(name, &["fast"]);
        }
    }),
    ("a default out of its range", "`c`", |m, _| {
        m.parameter("c", "1", Some(-1.0), Range::NotNegative, "");
    }),
    ("a parameter above what is no parameter", "must exceed x", |m, o| {
        m.parameter("l", "m", None, Range::Above(o.x), "");
    }),
    ("a parameter above one that may be negative", "must exceed r", |m, _| {
        let r = m.parameter("r", "m", None, Range::Any, "");
        m.parameter("l", "m", None, Range::Above(r), "");
    }),
    ("a parameter of an effect in a term of another", "`c`", |m, o| {
        let mut c = o.m;
        m.effect("damping", "", |m| c = m.parameter("c", "N*s/m", Some(1.0), Range::NotNegative, ""));
        m.effect("brake", "", |m| m.dissipation(half(c * o.x.dot().sq())));
    }),
    ("a constant of a parameter of an effect, without the effect", "`c`", |m, o| {
        let mut d = o.s;
        m.effect("damping", "", |m| {
            let c = m.parameter("c", "N/m", None, Range::NotNegative, "");
            d = m.constant("d", c / o.s);
        });
        m.potential(d * o.x.sq());
    }),
    ("the inverse mass of three coordinates", "m.inverse_mass(...)", |m, o| {
        let [y, z] = ["y", "z"].map(|name| m.coordinate(name, "m", Start::Static, ""));
        m.kinetic(half(o.m * (y.dot().sq() + z.dot().sq())));
        let w = m.inverse_mass(y, z);
        m.constant("W", w);
    }),
    ("the inverse mass of what is no coordinate", "m.inverse_mass(...)", |m, o| {
        let w = m.inverse_mass(o.x, o.s);
        m.constant("W", w);
    }),
    ("a mode without a value for a symbol", "`free`", |m, o| {
        let mut gap = m.switch("over", "m", o.x, "backlash", "");
        gap.factor("touch", 1);
        gap.mode("free", &[]);
    }),
    ("an exit to a mode that is not there", "`gone`", |m, o| {
        let mut gap = m.switch("over", "m", o.x, "backlash", "");
        let over = gap.over();
        gap.mode("free", &[]).until("gone", over);
    }),
    ("a guard that is not linear", "`free`", |m, o| {
        let mut gap = m.switch("over", "m", o.x, "backlash", "");
        let over = gap.over();
        gap.mode("free", &[]).until("free", over.sq());
    }),
    ("a reaction where nothing is held", "`reaction`", |m, o| {
        let mut gap = m.switch("over", "m", o.x, "backlash", "");
        let reaction = gap.reaction();
        gap.mode("free", &[]).until("free", reaction);
    }),
    ("a hold that begins in motion", "`free`", |m, o| {
        let mut gap = m.switch("over", "m", o.x, "backlash", "");
        let over = gap.over();
        gap.mode("free", &[]).until("stuck", over);
        gap.mode("stuck", &[]).holds();
    }),
    ("an output in a symbol that nobody declared", "`rate`", |m, _| {
        m.output("loss", "W", Expr::symbol("rate").sq(), "");
    }),
    ("an output called like a parameter", "`s`", |m, o| {
        m.output("s", "m", o.x, "");
    }),
    ("an output before one in which it is written", "`second`", |m, o| {
        let mut second = o.x;
        Model::new("other", |other| second = other.output("second", "m", 1.into(), ""));
        m.output("first", "m", second, "");
        m.output("second", "m", o.x, "");
    }),
    ("the spring of what is no named deflection", "not a named deflection", |m, o| {
        let spring = m.spring(o.x);
        m.output("force", "N", spring, "");
    }),
    ("terms of an effect inside a root", "`damping`", |m, o| {
        let x = m.deflection("y", o.x);
        m.potential(half(o.s * x.sq()));
        m.effect("damping", "", |m| m.dissipation(half(o.s * x.dot().sq())));
        let force = m.spring(x) + m.damper(x);
        m.output("size", "N", (force.sq() + o.s.sq()).sqrt(), "");
    }),
    ("a division by zero", "the potential energy", |m, o| m.potential(o.s * o.x / 0)),
];

/// Lists the names of all variants. The `match` makes the compiler check that none is missing.
macro_rules! variants {
    ($($name:ident)*) => {
        const VARIANTS: &[&str] = &[$(stringify!($name)),*];

        fn variant(slip: &Slip) -> &'static str {
            match slip { $(Slip::$name { .. } => stringify!($name),)* }
        }
    };
}
variants! {
    Undeclared Twice Name Misplaced Function Number NotQuadratic NotLinear NotADeflection Massless Singular NegativeDissipation
    Switch Phase Pitch WithoutEffect NeverSwitches Boundary Default Above InverseMass Unproved OfAnEffect Empty
}

pub fn every_mistake_is_refused() {
    let mut messages = vec![];
    let mut refuse = |what: &str, culprit: &str, slip: Slip| {
        let message = slip.to_string();
        assert!(message.contains(culprit), "{what}: the message does not name {culprit}: {message}");
        messages.push((variant(&slip), format!("{what}\n    {message}\n")));
    };
    for (what, culprit, slip) in SLIPS {
        let model = Model::new("train", |m| {
            let sound = oscillator(m);
            slip(m, sound);
        });
        let refused = derive(&model).err().unwrap_or_else(|| panic!("{what}: not refused"));
        refuse(what, culprit, refused);
    }
    let empty = Model::new("void", |_| {});
    refuse("no coordinates", "void", derive(&empty).err().expect("a model without coordinates is refused"));
    // The models and the wrong formulas that fail a proof are in the module `proofs`. Here only the message is tested.
    let unproved = Slip::Unproved { model: "train".into(), what: "M is symmetric".into(), rest: "m - s".into() };
    refuse("a proof that fails", "m - s", unproved);

    let met = |name: &str| messages.iter().any(|m| m.0 == name);
    let unmet: Vec<_> = VARIANTS.iter().filter(|name| !met(name)).collect();
    assert!(unmet.is_empty(), "no model in this file is refused with {unmet:?}");
    let text: String = messages.into_iter().map(|(_, text)| text + "\n").collect();
    insta::assert_snapshot!("slips", text);
}
