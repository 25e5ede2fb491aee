//! Tests of the explorer and its server.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::Arc;

use serde_json::{Value, json};

use super::choice::Choice;
use super::guard::MOST_BYTES;
use super::{Explorer, Service};
use crate::library::Results;
use crate::scene::Scene;

fn scene(name: &str) -> Scene {
    Scene::load(format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn explorer(name: &str) -> Explorer {
    Explorer::new(scene(name)).unwrap()
}

fn choice(value: Value) -> Choice {
    serde_json::from_value(value).unwrap()
}

/// The answer to a choice with the whole run, as the page gets it.
fn answer(explorer: &Explorer, value: Value) -> Value {
    first_answer(explorer, Choice { whole: true, ..choice(value) })
}

fn first_answer(explorer: &Explorer, choice: Choice) -> Value {
    serde_json::to_value(explorer.run(&choice, &|| true).unwrap()).unwrap()
}

/// The end state that the page shows.
fn state(answer: &Value) -> Vec<f64> {
    let entries = answer["run"]["state"].as_array().unwrap_or_else(|| panic!("no run: {}", answer["mistakes"]));
    entries.iter().map(|entry| entry[2].as_f64().unwrap()).collect()
}

fn end(results: &Results) -> Vec<f64> {
    results.summary().state.0.values().map(|x| x.0).collect()
}

/// The keys of the mistakes.
fn wrong(answer: &Value) -> Vec<String> {
    assert!(answer["run"].is_null());
    let mistakes = answer["mistakes"].as_array().unwrap().iter();
    mistakes.map(|mistake| mistake["key"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_change_gives_the_end_state_of_the_same_change_in_the_library() {
    let (scene, explorer) = (scene("oh2005/energy_300rpm"), explorer("oh2005/energy_300rpm"));
    assert_eq!(state(&answer(&explorer, json!({}))), end(&scene.run().unwrap()));

    // In the units in which the scene writes them.
    let values = json!({ "parameters.T0": 12.5, "start.speed": 450, "laws.k.steps.1.value": 2.5, "run.t_end": 0.05 });
    let changed = [
        ("parameters.T0", "12.5 N*m".into()),
        ("start.speed", "450 rpm".into()),
        ("laws.k.steps.1.value", "2.5 kN*m".into()),
        ("run.t_end", 0.05.into()),
    ];
    let expected = end(&scene.with_all(changed).unwrap().run().unwrap());
    assert_eq!(state(&answer(&explorer, json!({ "values": values }))), expected);

    let effects = json!(["stiffness_step", "torques"]);
    let expected = end(&scene.with("effects", &["stiffness_step", "torques"][..]).unwrap().run().unwrap());
    assert_eq!(state(&answer(&explorer, json!({ "effects": effects }))), expected);

    let solver = json!({ "method": "dop853", "tolerance": 1e-6 });
    let expected = scene.with_all([("run.method", "dop853".into()), ("run.tolerance", 1e-6.into())]).unwrap();
    assert_eq!(state(&answer(&explorer, json!({ "solver": solver }))), end(&expected.run().unwrap()));
}

/// The visible sections come with the run, the others with `rest`; each section once, with its own arrays.
#[test]
fn visible_sections_come_first_and_the_others_after_them() {
    let explorer = explorer("oh2005/energy_300rpm");
    let value = json!({ "seen": ["motion", "energy"], "number": 7 });
    let first = answer(&explorer, value.clone())["run"]["page"].clone();
    let rest = serde_json::to_value(explorer.rest(&choice(value), &|| true).unwrap()).unwrap();
    let ids = |part: &Value, of: &str| -> Vec<String> { serde_json::from_value(part[of].clone()).unwrap() };
    assert_eq!(ids(&first, "of"), ["motion", "energy"]);
    let mut all = ids(&first, "of");
    all.extend(ids(&rest, "of"));
    let mut order: Vec<String> = ids(&rest, "order").into_iter().filter(|id| id != "method").collect();
    all.sort();
    order.sort();
    assert_eq!(all, order);
    for (part, name) in [(&first, "run7-array-"), (&rest, "rest7-array-")] {
        let arrays = part["arrays"].as_object().unwrap();
        assert!(!arrays.is_empty() && arrays.keys().all(|id| id.starts_with(name)));
        let html = part["html"].as_str().unwrap();
        assert!(ids(part, "of").iter().filter(|id| html.contains(&format!("<section id=\"{id}\""))).count() > 1);
    }
    // If the request names no visible sections, one answer has all of them. A cancelled run gives no answer.
    assert_eq!(ids(&answer(&explorer, json!({}))["run"]["page"], "of"), ids(&rest, "order")[1..]);
    assert!(explorer.rest(&choice(json!({ "seen": ["motion"] })), &|| false).is_none());
}

/// The first answer to a long run has the beginning of its plots over time, which is the beginning of the whole run.
#[test]
fn a_long_run_first_shows_its_beginning() {
    let explorer = explorer("oh2005/energy_300rpm");
    let choice = choice(json!({ "values": { "run.t_end": 20 }, "seen": ["motion", "orders"], "number": 3 }));
    let first = first_answer(&explorer, choice.clone());
    assert!(first["run"].is_null() && first["mistakes"].as_array().unwrap().is_empty());
    let beginning = &first["beginning"];
    assert_eq!(beginning["page"]["of"], json!(["motion"]));
    let (reached, length) = (beginning["reached"].as_f64().unwrap(), beginning["length"].as_f64().unwrap());
    assert!(0.0 < reached && reached < length && length == 20.0, "{reached} of {length} s");
    assert!(explorer.last.lock().unwrap().is_none(), "the beginning is not kept as the run");
    // A run that ends in time, and sections without plots over time, have no beginning.
    let short = Choice { values: [("run.t_end".to_owned(), 1e-3)].into(), ..choice.clone() };
    let elsewhere = Choice { seen: vec!["scene".into()], ..choice.clone() };
    let whole = Choice { whole: true, ..choice };
    for choice in [short, elsewhere, whole] {
        let answer = first_answer(&explorer, choice);
        assert!(answer["run"].is_object() && answer["beginning"].is_null());
    }
}

/// With a view the first answer has only the curves that are seen, in few rows; `rest` has all.
#[test]
fn visible_curves_are_sent_in_few_rows() {
    let explorer = explorer("oh2005/energy_300rpm");
    let seen = ["Torques", "Torques: amplitudes of orders", "Torques: power spectral density"];
    let view = json!({ "range": [0.01, 0.02], "parts": 50, "curves": seen.map(|title| [title, "mesh_torque"]) });
    // Orders need whole revolutions.
    let values = json!({ "run.t_end": 0.5 });
    let value = json!({ "values": values, "seen": ["motion", "orders", "spectra"], "view": view, "number": 7 });
    let first = answer(&explorer, value.clone())["run"]["page"].clone();
    let rest = serde_json::to_value(explorer.rest(&choice(value), &|| true).unwrap()).unwrap();
    let (_, results) = explorer.last.lock().unwrap().clone().unwrap();
    let rows = results.outcome.trajectory.len();
    // The title of each plot, and the name and the numbers of times and values of each of its curves.
    let curves = |page: &Value, group: &str| -> Vec<(String, String, [u64; 2])> {
        let html = page["html"].as_str().unwrap();
        let plots = html.split("<figure class=\"plot\">").skip(1).map(|plot| {
            let text = plot.split_once("json\">").unwrap().1.split_once("</script>").unwrap().0;
            serde_json::from_str::<Value>(text).unwrap()
        });
        let of = |plot: Value| {
            let name = |curve: &Value| curve["name"].as_str().unwrap().to_owned();
            let lengths = |curve: &Value| ["x", "y"].map(|axis| curve[axis]["length"].as_u64().unwrap());
            let title = plot["title"].as_str().unwrap().to_owned();
            plot["curves"].as_array().unwrap().iter().map(|c| (title.clone(), name(c), lengths(c))).collect::<Vec<_>>()
        };
        plots.filter(|plot| plot["group"] == group).flat_map(of).collect()
    };
    let (some, all) = (curves(&first, "time"), curves(&rest, "time"));
    assert!(some.len() > 5 && all.len() > some.len());
    assert!(some.iter().any(|(title, name, _)| (&**title, &**name) == ("Torques", "mesh_torque")));
    for (title, name, [times, values]) in some {
        // Two for each part, and one for each end of the run.
        assert!(times <= 2 * 50 + 2, "{times}");
        let is_seen = (&*title, &*name) == ("Torques", "mesh_torque");
        assert_eq!(values, if is_seen { times } else { 0 }, "{title}: {name}");
    }
    assert!(all.iter().all(|(_, _, lengths)| *lengths == [rows as u64; 2]));
    // The table of orders is not on the screen; without a steady mesh there is none.
    let has = |part: &Value, text: &str| part["html"].as_str().unwrap().contains(text);
    assert_eq!(has(&first, "<div data-later=\"Mesh orders"), has(&rest, "<caption>Mesh orders"));
    assert!(!has(&first, "<caption>Mesh orders") && !has(&rest, "data-later"));
    for group in ["order", "frequency"] {
        let (some, all) = (curves(&first, group), curves(&rest, group));
        assert!(some.len() > 3, "{some:?}");
        for ((title, name, [x, y]), whole) in some.iter().zip(&all) {
            assert_eq!((title, name, [*x, *x]), (&whole.0, &whole.1, whole.2));
            let is_seen = seen.contains(&&**title) && name == "mesh_torque";
            assert_eq!(*y, if is_seen { *x } else { 0 }, "{title}: {name}");
        }
    }
}

#[test]
fn a_saved_scene_has_the_bytes_of_the_page_and_keeps_its_comments() {
    let explorer = explorer("backlash");
    let value = json!({
        "values": { "parameters.zeta": 0.041, "start.speed": 5800.5, "parameters.b": 0.02 },
        "effects": ["stiffness_step", "backlash", "damping", "torques", "transmission_error"],
        "solver": { "method": "dopri5", "tolerance": 1e-8, "step": null },
    });
    let text = explorer.saved(&choice(value.clone())).unwrap();
    assert!(text.contains("# The gear set of Oh, Grosh & Barber (2005), Table 1"), "{text}");
    assert!(text.contains("zeta = 0.041\n") && text.contains("speed = \"5800.5 rpm\"\n"), "{text}");
    let bytes = |results: &Results| {
        let root = tempfile::tempdir().unwrap();
        results.write(root.path().join("out")).unwrap();
        std::fs::read(root.path().join("out/trajectory.parquet")).unwrap()
    };
    // As the command line runs it: from a file of the name that the page proposes.
    let root = tempfile::tempdir().unwrap();
    let path = root.path().join("backlash_explored.toml");
    std::fs::write(&path, &text).unwrap();
    let saved = Scene::load(&path).unwrap().run().unwrap();
    assert!(answer(&explorer, value)["run"].is_object());
    let (_, of_page) = explorer.last.lock().unwrap().clone().unwrap();
    assert_eq!(bytes(&saved), bytes(&of_page));
    // Without a choice the text is that of the scene.
    assert_eq!(explorer.saved(&Choice::default()).unwrap(), &*explorer.scene.text);
}

#[test]
fn mistakes_name_their_controls_and_all_controls_stay() {
    let explorer = explorer("oh2005/energy_300rpm");
    let of = |value: Value| wrong(&answer(&explorer, value));
    assert_eq!(of(json!({ "values": { "parameters.zeta": -1 } })), ["parameters.zeta"]);
    assert_eq!(of(json!({ "effects": ["rigid_kinematics", "torques"] })), ["effects"]);
    assert_eq!(of(json!({ "effects": ["<script>"] })), ["effects.0"]);
    assert_eq!(of(json!({ "solver": { "method": "rk4", "step": 1.0 } })), ["run.step"]);
    assert_eq!(of(json!({ "solver": { "method": "rk5" } })), ["run.method"]);
    assert!(explorer.saved(&choice(json!({ "values": { "parameters.zeta": -1 } }))).is_err());
    // A key without a control changes nothing.
    let same = json!({ "values": { "output.most_rows": 1, "model": 3, "parameters.nothing": 3 } });
    assert_eq!(explorer.saved(&choice(same)).unwrap(), &*explorer.scene.text);
}

/// Every effect of these models can be ticked: the values that it needs are added with usual sizes.
#[test]
fn effects_bring_the_values_that_they_need() {
    for name in ["oh2005/energy_300rpm", "gear_pair_teeth", "two_stage", "planetary_3", "chain_5"] {
        let explorer = explorer(name);
        let (model, present) = (explorer.scene.model, &explorer.scene.effects);
        for (i, effect) in model.effects.iter().enumerate() {
            let with = present.clone().with(i);
            if !with.agree(model) {
                continue;
            }
            let text = explorer.saved(&choice(json!({ "effects": with.names(model) })));
            assert!(text.is_ok(), "{name}, {}: {:?}", effect.name, text.err());
        }
    }
}

#[test]
fn every_scene_can_be_explored() {
    for name in
        ["train_turbine", "drives/torque_ripple", "wind_turbine", "damaged_tooth", "crank_drive", "friction_oscillator"]
    {
        let explorer = explorer(name);
        assert_eq!(explorer.saved(&Choice::default()).unwrap(), &*explorer.scene.text, "{name}");
        let controls =
            serde_json::to_value(super::controls::controls(&explorer.scene, &explorer.text, &explorer.first));
        for control in controls.unwrap().as_array().unwrap() {
            let number = |key: &str| control[key].as_f64().unwrap();
            let inside = number("low") <= number("value") && number("value") <= number("high");
            assert!(inside && number("low") < number("high"), "{name}: {control}");
        }
    }
}

#[test]
fn a_choice_is_judged_and_advised() {
    let explorer = explorer("oh2005/energy_300rpm");
    let judged = |value: Value| serde_json::to_value(explorer.judge(&choice(value), &|| true).unwrap()).unwrap();
    let error = |judged: &Value| judged["error"].as_str().unwrap().parse::<f64>().unwrap();
    let exact = judged(json!({}));
    assert!(error(&exact) < 1e-12, "{exact}");
    assert_eq!(exact["ratio"], "exact cells");
    let steps = judged(json!({ "solver": { "method": "dopri5", "tolerance": 1e-5 } }));
    assert!((1e-9..1e-1).contains(&error(&steps)), "{steps}");
    assert!(steps["ratio"].as_str().unwrap().ends_with(" x exact cells"), "{steps}");
    let advice = serde_json::to_value(explorer.advise(&Choice::default(), &|| true).unwrap()).unwrap();
    let effects: Vec<_> =
        advice["rows"].as_array().unwrap().iter().map(|row| row["effect"].as_str().unwrap()).collect();
    assert_eq!(effects, ["rigid_kinematics", "frozen_phase", "stiffness_step", "damping", "torques"]);
    assert!(explorer.advise(&Choice::default(), &|| false).is_none());
}

/// A server and what a client reads from it.
struct Served(Arc<Service>, Option<std::thread::JoinHandle<()>>);

impl Served {
    fn new(scene: &str) -> Served {
        let service = Service::new(explorer(scene), 0).unwrap();
        let serving = service.clone();
        Served(service, Some(std::thread::spawn(move || serving.serve())))
    }

    /// Host and port, and the path with the token.
    fn parts(&self) -> (String, String) {
        let url = self.0.url();
        let (host, path) = url.strip_prefix("http://").unwrap().split_once('/').unwrap();
        (host.to_owned(), format!("/{path}"))
    }

    /// The whole answer to a request.
    fn ask(&self, request: &str, headers: &str, body: &str) -> String {
        let host = self.parts().0;
        let mut stream = TcpStream::connect(&host).unwrap();
        let length = body.len();
        // A server that refuses a body may close before it has read it.
        let _ = write!(
            stream,
            "{request} HTTP/1.1\r\n{headers}Connection: close\r\nContent-Length: {length}\r\n\r\n{body}"
        );
        let mut answer = vec![];
        let _ = stream.read_to_end(&mut answer);
        String::from_utf8_lossy(&answer).into_owned()
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.0.stop();
        self.1.take().unwrap().join().unwrap();
    }
}

#[test]
fn the_server_answers_its_own_page_alone() {
    let served = Served::new("oh2005/energy_300rpm");
    let (host, path) = served.parts();
    let port = host.rsplit(':').next().unwrap();
    let json = "Content-Type: application/json\r\n";
    let (run, good) = (format!("POST {path}run"), format!("Host: {host}\r\n{json}"));
    let starts = |answer: String, status: u16| {
        let head = answer.lines().next().unwrap_or_default().to_owned();
        assert!(head.starts_with(&format!("HTTP/1.1 {status} ")), "{head:?}, not {status}");
        assert!(!answer.to_lowercase().contains("access-control-"), "{answer}");
        answer
    };
    let answer = starts(served.ask(&run, &good, "{}"), 200);
    assert!(answer.contains("X-Content-Type-Options: nosniff") && answer.contains("\"mistakes\":[]"));
    starts(served.ask(&run, &format!("{good}Origin: http://{host}\r\n"), "{}"), 200);
    starts(served.ask(&format!("POST /{}/run", "0".repeat(32)), &good, "{}"), 403);
    starts(served.ask("POST /run", &good, "{}"), 403);
    starts(served.ask(&run, &format!("Host: evil.example:{port}\r\n{json}"), "{}"), 403);
    starts(served.ask(&run, &format!("{good}Origin: http://127.0.0.1:1\r\n"), "{}"), 403);
    starts(served.ask(&run, &format!("{good}Origin: null\r\n"), "{}"), 403);
    starts(served.ask(&run, &good, &"x".repeat(MOST_BYTES + 1)), 413);
    starts(served.ask(&run, &good, "{\"value\": 1}"), 400);
    starts(served.ask(&run, &format!("Host: {host}\r\n"), "{}"), 415);
    starts(served.ask(&format!("OPTIONS {path}run"), &good, ""), 405);

    let page = starts(served.ask(&format!("GET {path}"), &format!("Host: {host}\r\n"), ""), 200);
    let policy = page.lines().find(|line| line.starts_with("Content-Security-Policy: ")).unwrap();
    assert!(
        policy.contains("default-src 'none'; script-src 'sha256-") && policy.contains("connect-src 'self'"),
        "{policy}"
    );
    assert!(page.contains("Referrer-Policy: no-referrer") && page.contains("<h1>energy_300rpm</h1>"));
}

#[test]
fn a_new_run_ends_the_advice_on_the_one_before() {
    let served = Served::new("wind_turbine");
    let (host, path) = served.parts();
    let head = format!("Host: {host}\r\nContent-Type: application/json\r\n");
    let post = |what: &str| served.ask(&format!("POST {path}{what}"), &head, "{}");
    std::thread::scope(|scope| {
        let advice = scope.spawn(|| post("advise"));
        std::thread::sleep(std::time::Duration::from_millis(100));
        assert!(post("run").contains("\"mistakes\":[]"));
        assert!(advice.join().unwrap().ends_with("{\"superseded\":false}"));
    });
}

#[test]
fn the_page_escapes_markup_in_the_name_of_a_scene() {
    let mut bytes = vec![];
    crate::page::explore::write("</h1><script>alert(1)</script>", &mut bytes).unwrap();
    let page = String::from_utf8_lossy(&bytes);
    assert!(page.contains("&lt;/h1&gt;&lt;script&gt;alert(1)") && !page.contains("<script>alert"));
}
