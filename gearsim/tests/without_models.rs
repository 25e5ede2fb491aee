//! Trains need no feature: `cargo test -p gearsim --no-default-features --test without_models`. A crate of a user leaves gearsim's own
//! models out, and scenes with `model = "train"` run there all the same.

use gearsim::Scene;

fn scene(name: &str) -> Scene {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes");
    Scene::load(format!("{folder}/{name}.toml")).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn trains_need_no_feature() {
    let names: Vec<_> = gearsim::models().iter().map(|entry| entry.model.name).collect();
    assert!(names.contains(&"train"));
    assert_eq!(names.contains(&"gear_pair"), cfg!(feature = "models"), "{names:?}");
    for name in ["train_turbine", "train_branches", "train_helical"] {
        let results = scene(name).with("run.t_end", "5 ms").unwrap().run().unwrap_or_else(|e| panic!("{name}: {e}"));
        results.check().unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(results.trajectory().len() > 10, "{name}");
    }
}

#[test]
fn there_is_a_train_to_start_from() {
    let train = gearsim::models().iter().find(|entry| entry.model.name == "train").expect("a train");
    let results = Scene::from_toml("starter", &gearsim::starter(train.model)).unwrap().run().unwrap();
    results.check().unwrap();
}
