//! Any bytes as the axes of a sweep: it is refused in words, or each of its points is a scene whose values are those of the plan.

use gearsim::__private::{Request, Sweep, Template};
use gearsim::Design;
use gearsim::sweep::Error;

const SCENE: &str = include_str!("../../../models/scenes/oh2005/energy_300rpm.toml");
/// Number of points that are compared with their scenes.
const POINTS: usize = 5;
/// Designs by their numbers in a case.
const DESIGNS: [Design; 4] = [Design::Random, Design::LatinHypercube, Design::Sobol, Design::Saltelli];

/// The first byte chooses the design, the second the number of samples; the texts between zero bytes are the axes.
pub fn check(data: &[u8]) {
    let [design, samples, text @ ..] = data else { return };
    let text = String::from_utf8_lossy(text);
    let request = Request {
        vary: text.split('\0').map(str::to_owned).collect(),
        design: DESIGNS[usize::from(*design) % DESIGNS.len()],
        samples: (*samples > 0).then_some(usize::from(*samples)),
        record: vec!["events".into()],
        ..Request::default()
    };
    let read = || Template::parse("fuzz", "fuzz.toml", SCENE, &[]).expect("the scene is valid");
    match Sweep::of(read(), gearsim::models(), &request) {
        Err(Error::Scene(mistakes)) => {
            assert!(!mistakes.render(80, false).trim().is_empty(), "refused without a reason");
        }
        Err(error) => assert!(!error.to_string().trim().is_empty(), "refused without a reason"),
        Ok(sweep) => sound(&sweep, &read()),
    }
}

/// Checks that the points of an accepted sweep are scenes: those at both ends and some between.
fn sound(sweep: &Sweep, template: &Template) {
    assert_eq!(Some(sweep.points), sweep.plan.points());
    for i in 0..POINTS.min(sweep.points) {
        let point = i * (sweep.points - 1) / (POINTS - 1).min(sweep.points - 1).max(1);
        let overrides = sweep.plan.overrides(point);
        assert_eq!(overrides, sweep.plan.overrides(point), "a point depends on more than its number");
        assert_eq!(overrides.len(), sweep.plan.axes.len());
        // Values between the ends may be refused, in words.
        if let Err(mistakes) = template.scene(&overrides, &[sweep.entry.model]) {
            assert!(!mistakes.mistakes().is_empty(), "refused without a reason");
        }
    }
}
