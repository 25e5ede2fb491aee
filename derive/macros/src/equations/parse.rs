//! Parses the blocks of `equations!` into the structs of `model`. Checks the syntax only.

use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Error, Ident, Result, Token};

use crate::equations::model::*;
use crate::equations::tokens::{list, parts, word};

impl Parse for Model {
    fn parse(input: ParseStream) -> Result<Self> {
        word(input, "model")?;
        let (name, title) = (input.parse()?, input.parse()?);
        input.parse::<Token![;]>()?;
        let mut m = Self::empty(name, title);
        let mut seen = Vec::new();
        while !input.is_empty() {
            let block = input.call(Ident::parse_any)?;
            // One `jump` for each law; every other block at most once.
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
            "nonlinear" => {
                self.nonlinear = Some(input.parse()?);
                input.parse::<Token![;]>()?;
            }
            "nonlinear_with" => self.nonlinear_with = list(input)?,
            "coordinates" => self.coordinates = list(input)?,
            "parameters" => self.parameters = list(input)?,
            "laws" => self.laws = list(input)?,
            "motions" => self.motions = list(input)?,
            "effects" => self.effects = list(input)?,
            "switching" => self.switching = list(input)?,
            "conditions" => self.conditions = list(input)?,
            "constants" => self.constants = list(input)?,
            "deflections" => self.deflections = list(input)?,
            "rates" => self.rates = list(input)?,
            "functions" => self.functions = list(input)?,
            "switches" => self.switches = list(input)?,
            "energies" => parts(input, &["kinetic", "potential", "dissipation"], |part, input| {
                *[&mut self.kinetic, &mut self.potential, &mut self.dissipation][part] = list(input)?;
                Ok(())
            })?,
            "forces" => self.forces = list(input)?,
            "partials" => self.partials = list(input)?,
            "torques" => self.torques = list(input)?,
            "work" => self.work = list(input)?,
            "outputs" => self.outputs = list(input)?,
            "mass" => self.mass = list(input)?,
            "mobility" => self.mobility = Some(list(input)?),
            "inertia" => self.inertia = list(input)?,
            "force" => self.force = Some(list(input)?),
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
            "text" => {
                self.text = Some(input.parse()?);
                input.parse::<Token![;]>()?;
            }
            "latex" => {
                self.latex = Some(input.parse()?);
                input.parse::<Token![;]>()?;
            }
            _ => {
                return Err(Error::new(block.span(), format!("there is no block `{block}`")));
            }
        }
        Ok(())
    }
}

impl Parse for Jump {
    fn parse(input: ParseStream) -> Result<Self> {
        let mut jump = Self { law: input.parse()?, normal: None, compliance: None, direction: None, step: None };
        parts(input, &["normal", "compliance", "direction", "step"], |part, input| {
            match part {
                0 => jump.normal = Some(list(input)?),
                1 => jump.compliance = Some(list(input)?),
                2 => jump.direction = Some(list(input)?),
                _ => jump.step = Some(list(input)?),
            }
            Ok(())
        })?;
        Ok(jump)
    }
}
