//! `--html`: the interactive page of a result. A program built without the feature `html` says how to add it.

use super::failure::Failure;

/// Name of the page in the folder of a result.
#[cfg(feature = "html")]
const FILE: &str = "page.html";

/// The page asked for on the command line.
#[cfg(feature = "html")]
pub(super) struct Asked;

/// There is no value of this type: this program writes no pages.
#[cfg(not(feature = "html"))]
pub(super) enum Asked {}

/// The page, if `html` asks for it. Errors: [`Failure::Impossible`] if this program cannot write pages.
#[cfg(not(feature = "html"))]
pub(super) fn asked(html: bool) -> Result<Option<Asked>, Failure> {
    if !html {
        return Ok(None);
    }
    Err(Failure::Impossible {
        what: "this program was built without interactive pages".into(),
        help: "build it with them: cargo build --release --features html".into(),
    })
}

/// The page, if `html` asks for it. Errors: none with the feature `html`.
#[cfg(feature = "html")]
pub(super) fn asked(html: bool) -> Result<Option<Asked>, Failure> {
    Ok(html.then_some(Asked))
}

impl Asked {
    /// Writes the page of a run.
    #[cfg(feature = "html")]
    pub(super) fn run(
        self,
        folder: &mut crate::output::OutputFolder,
        results: &crate::library::Results,
        summary: &crate::output::Summary,
    ) -> Result<(), Failure> {
        use crate::page;
        let page = page::run::page(&page::run::Run { scene: &results.scene, outcome: &results.outcome, summary })?;
        folder.write(FILE, |sink| Ok(page.write(sink)?))?;
        Ok(())
    }

    /// Not reached, because there is no value to call it on.
    #[cfg(not(feature = "html"))]
    pub(super) fn run(
        self,
        _folder: &mut crate::output::OutputFolder,
        _results: &crate::library::Results,
        _summary: &crate::output::Summary,
    ) -> Result<(), Failure> {
        match self {}
    }
}
