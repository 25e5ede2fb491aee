//! Where models are described, and how they are derived, as stated at the head of a generated file.

/// The place of models.
#[derive(Debug, Clone, Copy)]
pub struct Home<'a> {
    /// The folder of the Rust files with the energies, from the root of the repository.
    pub energies: &'a str,
    /// The command that derives a model, without the name of the model after it.
    pub command: &'a str,
}

impl Default for Home<'_> {
    /// The place of gearsim's own models.
    fn default() -> Self {
        Home { energies: "models/src", command: "cargo xtask derive" }
    }
}

impl Home<'_> {
    /// The file that describes the model `name`: `planetary_3` is the function of `planetary.rs` with 3 planets.
    pub(crate) fn described_in(self, name: &str) -> String {
        let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let stem = if stem.len() < name.len() { stem.strip_suffix('_').unwrap_or(name) } else { name };
        format!("{}/{stem}.rs", self.energies)
    }
}
