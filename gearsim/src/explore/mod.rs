//! `gearsim explore`: a scene whose values a person changes in a browser, with the plots of each run.
//!
//!     choice --edit--> text of a scene --Scene::parse--> scene --run--> answer: sections of a page, end state, cost
//!
//! The page sends its whole state, a [`Choice`]. It is written into the text of the scene ([`text`]), and this text is read, run and saved.
//! A saved scene therefore gives the same bytes of results as the page. The server keeps only the last run.
//!
//! | request | answer | ends after |
//! | --- | --- | --- |
//! | `run` | [`run`]: controls, mistakes, the plots that are seen, end state, energy account; of a long run first the beginning of its plots over time | 10 s, or when a newer `run` comes |
//! | `rest` | [`run`]: the sections of its page that are not seen, or not whole; other static equilibria | 10 s, or with its run |
//! | `judge` | [`judge`]: cost relative to the exact method, error at the end, digits left | 20 s, or with its run |
//! | `advise` | [`advice`]: which effects matter | 60 s, or when a newer one comes |
//! | `save` | the text of the scene | |
//!
//! [`server`] serves them on 127.0.0.1 alone, [`guard`] says which requests are refused.

mod advice;
mod choice;
mod controls;
mod guard;
mod judge;
mod run;
mod server;
#[cfg(test)]
mod tests;
mod text;

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

pub use server::Service;

use crate::known;
use crate::library::{Error, Results};
use crate::scene::text::Text;
use crate::scene::{Scene, SceneMistakes};
use choice::Choice;

/// A scene that is explored.
pub struct Explorer {
    scene: Scene,
    /// Its text with the values set on the command line.
    text: Text,
    /// The numbers in this text, by key. They determine the ranges of the sliders.
    first: HashMap<String, f64>,
    /// The last run and its text.
    last: Mutex<Option<(String, Arc<Results>)>>,
}

impl Explorer {
    /// Explores `scene`. Errors: if its text cannot be edited.
    pub fn new(scene: Scene) -> Result<Explorer, Error> {
        let text = Text::parse(&scene.text).ok_or_else(|| {
            let what = format!("the text of scene {} cannot be edited", scene.name);
            Error::impossible(what, "write it in TOML 1.0: https://toml.io")
        })?;
        let first = text.leaves().into_iter().map(|leaf| (leaf.key(), leaf.number)).collect();
        Ok(Explorer { scene, text, first, last: Mutex::default() })
    }

    /// The name of the scenes that it runs and saves.
    pub fn name(&self) -> String {
        format!("{}_explored", self.scene.name)
    }

    /// The text of the scene with a choice. Without mistakes in the choice it is a scene that runs.
    fn edited(&self, choice: &Choice) -> Text {
        let mut text = self.text.clone();
        choice.write(&self.scene, &mut text);
        text
    }

    /// The scene of a text.
    fn read(&self, text: &str) -> Result<Scene, SceneMistakes> {
        Scene::parse(&self.name(), SOURCE, text, &[], &known::descriptions())
    }
}

/// The name of the text of the page's scene in messages.
const SOURCE: &str = "the scene of the page";
