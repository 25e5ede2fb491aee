//! Parses the items inside a block: coordinates, parameters, terms.

use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Ident, LitStr, Result, Token, braced, parenthesized};

use crate::equations::model::*;
use crate::equations::tokens::{choice, doc, list, number, peek_word, with, word};

impl Parse for Coordinate {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, unit) = (input.parse()?, input.parse()?);
        word(input, "start")?;
        let start = if input.parse::<Option<Token![static]>>()?.is_some() { None } else { Some(number(input)?) };
        Ok(Self { name, unit, start, doc: doc(input)? })
    }
}

impl Parse for Parameter {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, unit) = (input.parse()?, input.parse()?);
        let gear_data = GEAR_DATA.iter().position(|(word, _)| peek_word(input, word));
        if let Some(gear_data) = gear_data {
            word(input, GEAR_DATA[gear_data].0)?;
        }
        let default = match choice(input, &["default", "required"])? {
            0 => Some(number(input)?),
            _ => None,
        };
        let with = with(input)?;
        input.parse::<Token![,]>()?;
        let low_included = choice(input, &["open", "from"])? == 1;
        let low = number(input)?;
        word(input, "to")?;
        let high_included = input.peek(Ident) && !peek_word(input, "inf");
        if high_included {
            word(input, "included")?;
        }
        let high = number(input)?;
        let above = match peek_word(input, "above") {
            true => {
                word(input, "above")?;
                Some(input.parse()?)
            }
            false => None,
        };
        let doc = doc(input)?;
        Ok(Self { name, unit, gear_data, default, with, low, low_included, high, high_included, above, doc })
    }
}

impl Parse for Law {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, unit) = (input.parse()?, input.parse()?);
        word(input, "phase")?;
        let phase = input.parse()?;
        word(input, "period")?;
        let period = number(input)?;
        let rolling = peek_word(input, "rolling");
        let mut held = vec![];
        if rolling {
            word(input, "rolling")?;
            if peek_word(input, "unless") {
                word(input, "unless")?;
                let inner;
                parenthesized!(inner in input);
                held.extend(Punctuated::<Ident, Token![,]>::parse_terminated(&inner)?);
            }
        }
        let with = with(input)?;
        let role = match (&with, input.parse::<Option<Token![as]>>()?) {
            (None, _) => Role::Stiffness,
            (_, None) => Role::Error,
            _ => [Role::Side, Role::Arm][choice(input, &["side", "arm"])?],
        };
        Ok(Self { name, unit, phase, period, rolling, held, with, role, doc: doc(input)? })
    }
}

impl Parse for RigidMotion {
    fn parse(input: ParseStream) -> Result<Self> {
        Ok(Self { name: input.parse()?, unit: input.parse()?, speeds: list(input)?, doc: doc(input)? })
    }
}

impl Parse for Effect {
    fn parse(input: ParseStream) -> Result<Self> {
        let mut effect = Self {
            name: input.parse()?,
            of: None,
            requires: vec![],
            excludes: vec![],
            doc: LitStr::new("", input.span()),
        };
        while input.peek(Ident) {
            let names = match choice(input, &["of", "requires", "excludes"])? {
                0 => {
                    effect.of = Some(input.parse()?);
                    continue;
                }
                1 => &mut effect.requires,
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

impl Parse for Boundary {
    fn parse(input: ParseStream) -> Result<Self> {
        let effect = input.parse()?;
        input.parse::<Token![=>]>()?;
        let (_, how) = How::WORDS[choice(input, &How::WORDS.map(|(word, _)| word))?];
        input.parse::<Token![;]>()?;
        Ok(Self { effect, how })
    }
}

impl Parse for Condition {
    fn parse(input: ParseStream) -> Result<Self> {
        let name = input.parse()?;
        input.parse::<Token![=]>()?;
        let effect = |input: ParseStream| Ok((input.parse::<Option<Token![!]>>()?.is_none(), input.parse()?));
        let effects = Punctuated::<_, Token![,]>::parse_separated_nonempty_with(input, effect)?;
        input.parse::<Token![;]>()?;
        Ok(Self { name, effects: effects.into_iter().collect() })
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

impl Parse for Function {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, with) = (input.parse()?, with(input)?);
        input.parse::<Token![=]>()?;
        let value = input.parse()?;
        input.parse::<Token![;]>()?;
        Ok(Self { name, with, value })
    }
}

impl Parse for Switch {
    fn parse(input: ParseStream) -> Result<Self> {
        let (over, unit) = (input.parse()?, input.parse()?);
        let inner;
        parenthesized!(inner in input);
        let symbol = |input: ParseStream| Ok((input.parse()?, number(input)?));
        let symbols = Punctuated::<_, Token![,]>::parse_terminated_with(&inner, symbol)?;
        word(input, "with")?;
        let effect = input.parse()?;
        input.parse::<Token![,]>()?;
        let doc = input.parse()?;
        let mut switch =
            Self { over, unit, symbols: symbols.into_iter().collect(), effect, doc, modes: vec![], loss: vec![] };
        let inner;
        braced!(inner in input);
        while !inner.is_empty() {
            if peek_word(&inner, "loss") {
                word(&inner, "loss")?;
                switch.loss = list(&inner)?;
            } else {
                switch.modes.push(inner.parse()?);
            }
        }
        Ok(switch)
    }
}

impl Parse for SwitchMode {
    fn parse(input: ParseStream) -> Result<Self> {
        let name = input.parse()?;
        let inner;
        parenthesized!(inner in input);
        let values = Punctuated::<_, Token![,]>::parse_terminated(&inner)?.into_iter().collect();
        let mut mode = Self { name, values, held: false, rests: false, counts: None, exits: vec![] };
        while input.peek(Ident) {
            match choice(input, &["holds", "rests", "counts"])? {
                0 => mode.held = true,
                1 => mode.rests = true,
                _ => mode.counts = Some(input.parse()?),
            }
        }
        mode.exits = list(input)?;
        Ok(mode)
    }
}

impl Parse for Exit {
    fn parse(input: ParseStream) -> Result<Self> {
        let sudden = choice(input, &["until", "unless"])? == 1;
        Ok(Self { to: input.parse()?, sudden, guard: list(input)? })
    }
}

impl Parse for Torque {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, doc, work) = (input.parse()?, input.parse()?, list(input)?);
        let power = if peek_word(input, "power") {
            word(input, "power")?;
            list(input)?
        } else {
            vec![]
        };
        Ok(Self { name, doc, work, power })
    }
}

impl Parse for Output {
    fn parse(input: ParseStream) -> Result<Self> {
        let (name, unit) = (input.parse()?, input.parse()?);
        let with = with(input)?;
        input.parse::<Token![,]>()?;
        let doc = input.parse()?;
        Ok(Self { unit, with, doc, value: Row { name, sum: list(input)? } })
    }
}

impl Parse for NonlinearWith {
    fn parse(input: ParseStream) -> Result<Self> {
        let effects = Punctuated::<Ident, Token![,]>::parse_separated_nonempty(input)?.into_iter().collect();
        let text = input.parse()?;
        input.parse::<Token![;]>()?;
        Ok(Self { effects, text })
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
        Ok(Self { name: input.parse()?, sum: list(input)? })
    }
}

impl Parse for Entry {
    fn parse(input: ParseStream) -> Result<Self> {
        Ok(Self { row: input.parse()?, column: input.parse()?, sum: list(input)? })
    }
}
