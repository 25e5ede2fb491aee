//! `gearsim scene` and `gearsim check`.

use clap::Parser;

use crate::Scene;
use crate::cli::Verb;
use crate::cli::check::Check;
use crate::cli::failure::Failure;
use crate::library::starter;

/// The printed scene of each model is complete: it can be run as it is. Each effect can be added, or what is missing is named.
#[test]
fn a_scene_to_start_from_runs_for_each_model() {
    for entry in crate::models() {
        let text = starter(entry.model);
        let scene = Scene::from_toml("starter", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert!(scene.warnings.is_empty(), "{}: {:?}", entry.model.name, scene.warnings);
        let results = scene.with("run.t_end", "1 ms").unwrap().run().unwrap_or_else(|error| panic!("{error}\n{text}"));
        results.check().unwrap_or_else(|error| panic!("{error}\n{text}"));
    }
}

/// A scene stays valid if all commented parameters and laws are made active and one more effect is added.
#[test]
fn commented_lines_of_starters_are_valid() {
    for entry in crate::models() {
        let model = entry.model;
        let text: String =
            starter(model).lines().map(|line| line.strip_prefix("# ").unwrap_or(line).to_string() + "\n").collect();
        for effect in model.effects.iter().filter(|effect| effect.of.is_none()) {
            let mut names = vec![effect.name];
            // An effect that is required may require others.
            let mut next = 0;
            while let Some(&name) = names.get(next) {
                let of = model.effects.iter().find(|effect| effect.name == name).unwrap();
                let new: Vec<_> = of.requires.iter().copied().filter(|name| !names.contains(name)).collect();
                names.extend(new);
                next += 1;
            }
            let set = [format!("effects={names:?}"), "run.t_end=0.1 ms".into(), "run.method=dop853".into()];
            let scene = Scene::from_toml_with("starter", &text, &set);
            scene.unwrap_or_else(|error| panic!("{} with {}: {error}", model.name, effect.name));
        }
    }
}

fn check(arguments: &[&str]) -> Result<(), Failure> {
    let arguments = ["check", "-q"].iter().chain(arguments);
    Check::try_parse_from(arguments).map_err(Failure::Usage).and_then(Check::run)
}

#[test]
fn scenes_are_checked_without_a_run() {
    let scene = super::scene().display().to_string();
    check(&[&scene, "--set", "run.t_end=1e6 s", "--set", "output.rate=1 Hz"]).unwrap();
    assert!(matches!(check(&[&scene, "--set", "run.t_end=1 m"]), Err(Failure::Scene(_))));
    let failure = check(&[&scene, "--set", "run.precision=compensated", "--set", "parameters.I1=1e-320 kg*m^2"]);
    assert_eq!(failure.unwrap_err().code(), 2);
    assert_eq!(check(&["no_such_file.toml", &scene]).unwrap_err().code(), 2);
}

#[test]
fn there_is_a_manual_page_and_a_completion_for_each_command() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["man".into(), folder.path().display().to_string()];
    crate::cli::man::ManCommand::try_parse_from(arguments).map_err(Failure::Usage).and_then(Verb::run).unwrap();
    let mut script = vec![];
    clap_complete::generate(clap_complete::Shell::Bash, &mut crate::cli::program(), "gearsim", &mut script);
    let script = String::from_utf8(script).unwrap();
    for command in crate::cli::COMMANDS {
        let name = (command.describe)().get_name().to_string();
        let page = std::fs::read_to_string(folder.path().join(format!("gearsim-{name}.1"))).unwrap();
        assert!(page.contains(&format!("gearsim\\-{name}")) || page.contains(&format!("gearsim-{name}")), "{page}");
        assert!(script.contains(&format!("gearsim,{name})")), "{name}");
    }
}

/// The tolerance of a scene whose cells are linear is not used, and the result says so.
#[test]
fn an_unused_tolerance_gives_a_remark() {
    let scene = Scene::load(super::scene()).unwrap().with("run.t_end", "1 ms").unwrap();
    let remarks = |scene: &Scene| scene.run().unwrap().summary().remarks;
    assert!(remarks(&scene).is_empty());
    let stated = scene.with("run.tolerance", 1e-6).unwrap();
    assert!(remarks(&stated)[0].contains("run.tolerance is not used"));
    assert!(remarks(&stated.with("run.method", "dop853").unwrap()).is_empty());
}
