//! The grammar of `equations!`: tokens to the structs of `model`, nothing checked beyond the syntax.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Error, Ident, Lit, LitStr, Result, Token, braced, parenthesized};

use crate::model::*;

impl Parse for Model {
    fn parse(input: ParseStream) -> Result<Self> {
        word(input, "model")?;
        let (name, title) = (input.parse()?, input.parse()?);
        input.parse::<Token![;]>()?;
        let mut m = Self::empty(name, title);
        let mut seen = Vec::new();
        while !input.is_empty() {
            let block = input.call(Ident::parse_any)?;
            // Laws have a `jump` each; every other block stands once.
            if block != "jump" && seen.contains(&block) {
                return Err(Error::new(block.span(), format!("a second `{block}`")));
            }
            m.block(&block, input)?;
            seen.push(block);
        }
        Ok(m)
    }
}

impl Model {
    fn block(&mut self, block: &Ident, input: ParseStream) -> Result<()> {
        match block.to_string().as_str() {
            "source" => {
                self.source = Some(input.parse()?);
                input.parse::<Token![;]>()?;
            }
            "coordinates" => self.coordinates = list(input)?,
            "parameters" => self.parameters = list(input)?,
            "laws" => self.laws = list(input)?,
            "motions" => self.motions = list(input)?,
            "effects" => self.effects = list(input)?,
            "conditions" => self.conditions = list(input)?,
            "constants" => self.constants = list(input)?,
            "energies" => parts(
                input,
                &["kinetic", "potential", "dissipation"],
                |part, input| {
                    *[
                        &mut self.kinetic,
                        &mut self.potential,
                        &mut self.dissipation,
                    ][part] = list(input)?;
                    Ok(())
                },
            )?,
            "torques" => self.torques = list(input)?,
            "work" => self.work = list(input)?,
            "mass" => self.mass = list(input)?,
            "force" => self.force = Some(list(input)?),
            "acceleration" => self.acceleration = Some(list(input)?),
            "jacobian" => self.jacobian = Some(list(input)?),
            "cell" => parts(input, &["stiffness", "damping", "load"], |part, input| {
                match part {
                    0 => self.stiffness = list(input)?,
                    1 => self.damping = list(input)?,
                    _ => self.load = list(input)?,
                }
                Ok(())
            })?,
            "jump" => self.jumps.push(input.parse()?),
            "text" => self.text = lines(input)?,
            "latex" => self.latex = lines(input)?,
            _ => {
                return Err(Error::new(
                    block.span(),
                    format!("no block is called `{block}`"),
                ));
            }
        }
        Ok(())
    }
}

impl Parse for Jump {
    fn parse(input: ParseStream) -> Result<Self> {
        let mut jump = Self {
            law: input.parse()?,
            normal: None,
            compliance: None,
            direction: None,
            step: None,
        };
        parts(
            input,
            &["normal", "compliance", "direction", "step"],
            |part, input| {
                match part {
                    0 => jump.normal = Some(list(input)?),
                    1 => jump.compliance = Some(list(input)?),
                    2 => jump.direction = Some(list(input)?),
                    _ => jump.step = Some(list(input)?),
                }
                Ok(())
            },
        )?;
        Ok(jump)
    }
}

impl Parse for Coordinate {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, unit) = (input.parse()?, input.parse()?);
        word(input, "start")?;
        let start = if input.parse::<Option<Token![static]>>()?.is_some() {
            None
        } else {
            Some(number(input)?)
        };
        Ok(Self {
            name,
            unit,
            start,
            doc: doc(input)?,
        })
    }
}

impl Parse for Parameter {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, unit) = (input.parse()?, input.parse()?);
        let default = match choice(input, &["default", "required"])? {
            0 => Some(number(input)?),
            _ => None,
        };
        input.parse::<Token![,]>()?;
        let low_included = choice(input, &["open", "from"])? == 1;
        let low = number(input)?;
        word(input, "to")?;
        let high_included = input.peek(Ident) && !peek_word(input, "inf");
        if high_included {
            word(input, "included")?;
        }
        let high = number(input)?;
        Ok(Self {
            name,
            unit,
            default,
            low,
            low_included,
            high,
            high_included,
            doc: doc(input)?,
        })
    }
}

impl Parse for Law {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, unit) = (input.parse()?, input.parse()?);
        word(input, "phase")?;
        let phase = input.parse()?;
        word(input, "period")?;
        Ok(Self {
            name,
            unit,
            phase,
            period: number(input)?,
            doc: doc(input)?,
        })
    }
}

impl Parse for Motion {
    fn parse(input: ParseStream) -> Result<Self> {
        Ok(Self {
            name: input.parse()?,
            unit: input.parse()?,
            speeds: list(input)?,
            doc: doc(input)?,
        })
    }
}

impl Parse for Effect {
    fn parse(input: ParseStream) -> Result<Self> {
        let mut effect = Self {
            name: input.parse()?,
            requires: vec![],
            excludes: vec![],
            doc: LitStr::new("", input.span()),
        };
        while input.peek(Ident) {
            let names = match choice(input, &["requires", "excludes"])? {
                0 => &mut effect.requires,
                _ => &mut effect.excludes,
            };
            let inner;
            parenthesized!(inner in input);
            names.extend(Punctuated::<Ident, Token![,]>::parse_terminated(&inner)?);
        }
        effect.doc = input.parse()?;
        input.parse::<Token![;]>()?;
        Ok(effect)
    }
}

impl Parse for Condition {
    fn parse(input: ParseStream) -> Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![=]>()?;
        let effect = |input: ParseStream| {
            Ok((
                input.parse::<Option<Token![!]>>()?.is_none(),
                input.parse()?,
            ))
        };
        let effects = Punctuated::<_, Token![,]>::parse_separated_nonempty_with(input, effect)?;
        input.parse::<Token![;]>()?;
        Ok(Self {
            name,
            effects: effects.into_iter().collect(),
        })
    }
}

impl Parse for Assignment {
    fn parse(input: ParseStream) -> Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![=]>()?;
        let value = input.parse()?;
        input.parse::<Token![;]>()?;
        Ok(Self { name, value })
    }
}

impl Parse for Torque {
    fn parse(input: ParseStream) -> Result<Self> {
        Ok(Self {
            name: input.parse()?,
            doc: input.parse()?,
            work: list(input)?,
        })
    }
}

impl Parse for Term {
    fn parse(input: ParseStream) -> Result<Self> {
        let always = input.parse::<Option<Token![_]>>()?.is_some();
        let condition = if always { None } else { Some(input.parse()?) };
        input.parse::<Token![=>]>()?;
        let value = input.parse()?;
        input.parse::<Token![;]>()?;
        Ok(Self { condition, value })
    }
}

impl Parse for Row {
    fn parse(input: ParseStream) -> Result<Self> {
        Ok(Self {
            name: input.parse()?,
            sum: list(input)?,
        })
    }
}

impl Parse for Entry {
    fn parse(input: ParseStream) -> Result<Self> {
        Ok(Self {
            row: input.parse()?,
            column: input.parse()?,
            sum: list(input)?,
        })
    }
}

/// `{ ITEM ITEM .. }`
fn list<T: Parse>(input: ParseStream) -> Result<Vec<T>> {
    let inner;
    braced!(inner in input);
    let mut items = vec![];
    while !inner.is_empty() {
        items.push(inner.parse()?);
    }
    Ok(items)
}

/// `{ "line"; "line"; }`
fn lines(input: ParseStream) -> Result<Vec<LitStr>> {
    let inner;
    braced!(inner in input);
    Ok(Punctuated::<LitStr, Token![;]>::parse_terminated(&inner)?
        .into_iter()
        .collect())
}

/// `{ NAME {..} NAME {..} }`, each name one of `names` and at most once; `store` takes what stands behind it.
fn parts(
    input: ParseStream,
    names: &[&str],
    mut store: impl FnMut(usize, ParseStream) -> Result<()>,
) -> Result<()> {
    let inner;
    braced!(inner in input);
    let mut seen = vec![];
    while !inner.is_empty() {
        let span = inner.span();
        let part = choice(&inner, names)?;
        if seen.contains(&part) {
            return Err(Error::new(span, format!("a second `{}`", names[part])));
        }
        seen.push(part);
        store(part, &inner)?;
    }
    Ok(())
}

/// `, "doc";`
fn doc(input: ParseStream) -> Result<LitStr> {
    input.parse::<Token![,]>()?;
    let doc = input.parse()?;
    input.parse::<Token![;]>()?;
    Ok(doc)
}

/// A number, `inf`, or either with a minus.
fn number(input: ParseStream) -> Result<f64> {
    let sign = if input.parse::<Option<Token![-]>>()?.is_some() {
        -1.0
    } else {
        1.0
    };
    if peek_word(input, "inf") {
        word(input, "inf")?;
        return Ok(sign * f64::INFINITY);
    }
    match input.parse()? {
        Lit::Float(x) => Ok(sign * x.base10_parse::<f64>()?),
        Lit::Int(x) => Ok(sign * x.base10_parse::<f64>()?),
        other => Err(Error::new(other.span(), "expected a number or `inf`")),
    }
}

/// The word `expected`, which is a keyword here alone.
fn word(input: ParseStream, expected: &str) -> Result<()> {
    choice(input, &[expected]).map(drop)
}

/// Which of `words` comes next.
fn choice(input: ParseStream, words: &[&str]) -> Result<usize> {
    let expected = || format!("expected `{}`", words.join("` or `"));
    let found = input
        .call(Ident::parse_any)
        .map_err(|e| Error::new(e.span(), expected()))?;
    words
        .iter()
        .position(|w| found == w)
        .ok_or_else(|| Error::new(found.span(), expected()))
}

fn peek_word(input: ParseStream, expected: &str) -> bool {
    input
        .fork()
        .parse::<Ident>()
        .is_ok_and(|found| found == expected)
}
