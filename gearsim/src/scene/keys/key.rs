//! What a scene may state: the keys of its tables, each with the kind of its value, its default and its meaning.
//!
//! Each reader has the keys that it reads as a constant beside it, and refuses all others. The reference (`gearsim scene --keys`) and
//! the schema for editors (`gearsim scene --schema`) are written from the same constants.

/// A key of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Key {
    pub name: &'static str,
    /// Kind of its value.
    pub kind: Kind,
    /// Its default; [`REQUIRED`] if it has none.
    pub default: &'static str,
    /// Its meaning.
    pub doc: &'static str,
    /// The effect without which it does nothing.
    pub effect: Option<&'static str>,
}

impl Key {
    /// The same key, which does nothing without `effect`.
    pub(in crate::scene) const fn with(self, effect: &'static str) -> Key {
        Key { effect: Some(effect), ..self }
    }
}

/// The default of a key that a table must always have.
pub(crate) const REQUIRED: &str = "required";

/// Kind of a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    /// Any text.
    Text,
    /// `true` or `false`.
    Flag,
    /// A number without unit.
    Number,
    /// A number with a unit of the same dimension as this one.
    Quantity(&'static str),
    /// A number with a unit that depends on the model; in words.
    ValueIn(&'static str),
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A name that the model or the scene has; in words, what it names.
    Name(&'static str),
    /// An array of values of one kind.
    List(&'static Kind),
    /// A table with the keys of these lists.
    Table(&'static [&'static [Key]]),
    /// A table whose keys the model or the scene names.
    Named(&'static [Named]),
    /// A value of one of these kinds.
    Either(&'static [Kind]),
}

/// The keys of a table that the model or the scene names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Named {
    /// Placeholder of the name in the reference, e.g. `COORDINATE_dot`.
    pub name: &'static str,
    pub kind: Kind,
    pub default: &'static str,
    pub doc: &'static str,
}

/// A key, with its `default`.
pub(in crate::scene) const fn key(name: &'static str, kind: Kind, default: &'static str, doc: &'static str) -> Key {
    Key { name, kind, default, doc, effect: None }
}

/// Keys that the model or the scene names.
pub(in crate::scene) const fn each(name: &'static str, kind: Kind, default: &'static str, doc: &'static str) -> Named {
    Named { name, kind, default, doc }
}
