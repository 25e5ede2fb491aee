//! Any bytes as the axes of a sweep. The sweep is refused with a message, or each of its points gives a scene or a message.

use gearsim::__private::{Request, Sweep, Template};
use gearsim::Design;
use gearsim::sweep::Error;

const SCENE: &str = include_str!("../../../models/scenes/oh2005/energy_300rpm.toml");
/// Largest number of points of a sweep that are checked.
const POINTS: usize = 5;
/// The designs from which a case chooses.
const DESIGNS: [Design; 4] = [Design::Random, Design::LatinHypercube, Design::Sobol, Design::Saltelli];

/// The first byte chooses the design, the second is the number of samples. The rest is text, split into the axes at zero bytes.
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

/// Checks points of an accepted sweep: the first, the last and some between. Each has the same values every time, and gives a scene or
/// a message.
fn sound(sweep: &Sweep, template: &Template) {
    assert_eq!(Some(sweep.points), sweep.plan.points());
    for i in 0..POINTS.min(sweep.points) {
        let point = i * (sweep.points - 1) / (POINTS - 1).min(sweep.points - 1).max(1);
        let overrides = sweep.plan.overrides(point);
        assert_eq!(overrides, sweep.plan.overrides(point), "a point depends on more than its number");
        assert_eq!(overrides.len(), sweep.plan.axes.len());
        // Values between the ends of an axis may be refused, but only with a message.
        if let Err(mistakes) = template.scene(&overrides, &[sweep.entry.model]) {
            assert!(!mistakes.mistakes().is_empty(), "refused without a reason");
        }
    }
}
