//! Tests of the texts that the program prints.

use insta::assert_snapshot;

use super::scene;
use crate::cli::{models, program, report, simulate, terminal};
use crate::known::MODELS;
use crate::library::equation_sets;
use crate::output::summary::Number;
use crate::scene::Scene;

/// Width of the texts [columns].
const WIDTH: usize = 100;

fn help(command: &str) -> String {
    let mut program = program().term_width(WIDTH);
    program.build();
    let command = program.find_subcommand_mut(command).unwrap();
    command.render_long_help().to_string()
}

fn load() -> Scene {
    Scene::load_with(&scene(), &[], &MODELS.iter().map(|entry| entry.model).collect::<Vec<_>>()).unwrap()
}

#[test]
fn help_texts_equal_their_snapshots() {
    assert_snapshot!("help", program().term_width(WIDTH).render_long_help());
    for command in ["run", "compare", "advise", "sweep", "response", "merge", "modes", "floquet", "models"] {
        assert_snapshot!(format!("help_{command}"), help(command));
    }
}

/// A longer line would be broken in the middle of a paragraph.
#[test]
fn the_lines_of_help_texts_fit() {
    let mut long = vec![];
    for command in program().get_subcommands() {
        let help = command.get_after_help().map(ToString::to_string).unwrap_or_default();
        long.extend(help.lines().filter(|line| line.chars().count() > WIDTH).map(str::to_owned));
    }
    assert!(long.is_empty(), "{long:#?}");
}

/// The words of a command line, as a shell splits it.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut quote, mut gap) = (vec![String::new()], None, false);
    for c in line.chars() {
        match c {
            _ if quote == Some(c) => quote = None,
            '"' | '\'' if quote.is_none() => quote = Some(c),
            ' ' if quote.is_none() => gap = true,
            _ => {
                if std::mem::take(&mut gap) {
                    words.push(String::new());
                }
                words.last_mut().unwrap().push(c);
            }
        }
    }
    words
}

#[test]
fn the_examples_of_help_texts_are_command_lines() {
    let mut found = 0;
    for command in program().get_subcommands() {
        let help = command.get_after_help().map(ToString::to_string).unwrap_or_default().replace("\\\n     ", "");
        for line in help.lines().filter_map(|line| line.strip_prefix("  ")).filter(|line| line.starts_with("gearsim "))
        {
            // Removes the redirection to a file and the description behind the command.
            let line = line.split(" > ").next().unwrap().split("    ").next().unwrap();
            let parsed = program().try_get_matches_from(words(line));
            assert!(parsed.is_ok(), "{line}: {}", parsed.unwrap_err());
            found += 1;
        }
    }
    assert!(found > 30, "{found}");
}

#[test]
fn quiet_is_an_option_of_all_commands() {
    let commands = [
        "run s",
        "compare s",
        "explore s",
        "advise s",
        "sweep s --vary a=1:2:2",
        "merge d --out o",
        "response s --over a=1:2:2 --settle 1",
        "modes s",
        "floquet s",
        "work-precision s",
        "check s",
        "scene m",
        "models",
        "new d",
        "completions bash",
        "man d",
    ];
    assert_eq!(commands.len(), program().get_subcommands().count());
    for command in commands {
        for line in
            [format!("gearsim -q {command}"), format!("gearsim {command} -q"), format!("gearsim {command} --quiet")]
        {
            let matches =
                program().try_get_matches_from(words(&line)).unwrap_or_else(|error| panic!("{line}: {error}"));
            assert!(matches.subcommand().unwrap().1.get_flag("quiet"), "{line}");
        }
    }
}

#[test]
fn the_list_and_the_description_of_models_equal_their_snapshots() {
    assert_snapshot!("models", models::all());
    assert_snapshot!("models_gear_pair", models::detail::of(models::find("gear_pair").unwrap(), WIDTH));
}

#[test]
fn a_misspelt_model_name_gets_a_suggestion() {
    let failure = models::find("gear-pair").unwrap_err();
    assert_eq!(failure.code(), 2);
    assert!(failure.to_string().contains("did you mean `gear_pair`?"), "{failure}");
}

/// A stage of planets that no model has is a train; `gearsim models` and a scene say so.
#[test]
fn a_number_of_planets_is_that_of_a_train() {
    let said = "`model = \"train\"` and `[planets.NAME]` with `count = 5`";
    let failure = models::find("planetary_5").unwrap_err().to_string();
    assert!(failure.contains(said) && !failure.contains("did you mean"), "{failure}");
    let mistakes = Scene::from_toml("five", "model = \"planetary_5\"\neffects = []\n").unwrap_err().to_string();
    assert!(mistakes.contains(said) && !mistakes.contains("did you mean"), "{mistakes}");
    for name in ["planetary_0", "planetary_x", "planar_planetary_6"] {
        let failure = models::find(name).unwrap_err().to_string();
        assert!(!failure.contains("count ="), "{failure}");
    }
}

#[test]
fn the_report_of_a_run_equals_its_snapshot() {
    let scene = load();
    let results = simulate::simulate(&scene, true).unwrap();
    let mut summary = results.summary();
    let residual = summary.energy.residual.0.abs();
    assert!(residual < 1e-12, "{residual} J");
    // Times differ between runs, and the last digits between machines.
    (summary.cpu_seconds, summary.energy.residual) = (Number(23e-6), Number(1e-15));
    for entry in &mut summary.state.0 {
        *entry.1 = Number((entry.1.0 * 1e6).round() / 1e6);
    }
    let text = report::scene(&scene, WIDTH) + &report::run(&scene, &summary, results.trajectory().len(), WIDTH);
    assert_snapshot!("summary", text);

    summary.completed = false;
    summary.t_end = Number(0.05);
    assert!(report::run(&scene, &summary, 1, WIDTH).contains("0.05 s of 0.1 s: stopped early"));
}

#[test]
fn a_comparison_needs_the_effects_that_drop_terms() {
    let scene = load();
    let sets = equation_sets::all(&scene).unwrap();
    let names: Vec<_> = sets.iter().map(|(_, scene)| scene.effects.names(scene.model).join(" ")).collect();
    assert_eq!(names[0], "stiffness_step damping torques");
    assert_eq!(names[1], "stiffness_step rigid_kinematics damping torques");
    assert_eq!(names[2], "stiffness_step frozen_phase damping torques");

    let bare = Scene { effects: crate::scene::Effects::none(scene.model), ..scene };
    let failure = equation_sets::all(&bare).err().unwrap();
    assert!(failure.to_string().contains("lacks the effect `stiffness_step`"), "{failure}");

    // A model without the effects that drop terms.
    let failure = equation_sets::all(&Scene { model: &crate::output::fixture::MODEL, ..bare }).err().unwrap();
    assert!(failure.to_string().contains("has no effect that leaves out the impulses of steps"), "{failure}");
}

#[test]
fn long_lines_are_broken_at_blanks() {
    assert_eq!(terminal::wrap("  help: a bc def\nx", 10), "  help: a\n  bc def\nx\n");
}

/// A torque of 10 N m a tooth is one of 240 N m on the gear with 24 teeth.
#[test]
fn the_report_names_the_torques_on_the_gears() {
    let text = report::scene(&load(), WIDTH).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("240 N*m on the driving gear (T0 N1), -960 N*m on the driven gear (-T0 N2)"), "{text}");
}
