//! Any bytes as a scene with overrides: the scene is read, or its mistakes are reported. It never panics.

use gearsim::scene::{PLOTS, Scene};

/// The text up to the first zero byte is the scene; each text after a zero byte is an override.
pub fn check(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let mut parts = text.split('\0');
    let scene = parts.next().unwrap_or_default();
    let overrides: Vec<String> = parts.map(str::to_owned).collect();
    let models: Vec<_> = gearsim::models().iter().map(|entry| entry.model).collect();
    match Scene::parse("fuzz", "fuzz.toml", scene, &overrides, &models) {
        Ok(scene) => sound(&scene),
        Err(errors) => {
            assert!(!errors.mistakes().is_empty(), "refused without a reason");
            for (width, colour) in [(100, false), (20, true)] {
                assert!(!errors.render(width, colour).trim().is_empty(), "the report of the problems is empty");
            }
        }
    }
}

/// Checks that an accepted scene keeps the invariants in its documentation.
fn sound(scene: &Scene) {
    let model = scene.model;
    assert_eq!(scene.parameters.len(), model.parameters.len());
    for (value, parameter) in scene.parameters.iter().zip(model.parameters) {
        let idle = parameter.with.is_some_and(|effect| !scene.effects.names(model).contains(&effect));
        assert!(idle || parameter.range.contains(*value), "{} = {value:e}", parameter.name);
    }
    assert_eq!(scene.laws.len(), model.laws.len());
    for (stiffness, law) in scene.laws.iter().zip(model.laws) {
        let whole: f64 = stiffness.steps.iter().map(|step| step.width).sum();
        assert!(stiffness.steps.iter().all(|step| step.value.is_finite() && step.width > 0.0), "{stiffness:?}");
        assert!((whole - law.period).abs() < 1e-9 * law.period, "the widths of {} add up to {whole}", law.name);
    }
    // A scene without [run] has no end and no samples.
    let runs = scene.t_end.is_finite();
    assert!(scene.t_end > 0.0, "t_end = {}", scene.t_end);
    assert!(scene.output.rate.is_finite() && (scene.output.rate > 0.0 || !runs), "rate = {}", scene.output.rate);
    assert!(scene.output.plots.iter().all(|plot| PLOTS.contains(&plot.as_str())), "{:?}", scene.output.plots);
    assert!(scene.effects.agree(model), "effects {:?}", scene.effects.names(model));
    assert_eq!(scene.start.q.len(), model.coordinates.len());
    assert!(scene.start.q_dot.iter().flatten().chain(&scene.start.motions).all(|x| x.is_finite()));
}
