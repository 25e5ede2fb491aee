//! Messages for mistakes: as snapshots of the whole text, or by a characteristic part of it.

use super::fixture::{SCENE, parse};

fn rendered(text: &str, overrides: &[&str]) -> String {
    parse(text, overrides).expect_err("a mistake").render(100, false)
}

#[test]
fn five_mistakes_at_once() {
    let text = SCENE
        .replace("\"damping\"", "\"dampning\"")
        .replace("I1 = \"2890 kg*mm^2\"", "I1 = \"-2890 kg*mm^2\"")
        .replace("zeta = 0.1", "zetta = 0.1")
        .replace("300 rpm\"\ntheta", "5 Hz\"\ntheta")
        .replace("t_end = \"0.1 s\"", "t_end = 0.1");
    insta::assert_snapshot!(rendered(&text, &[]));
}

#[test]
fn a_syntax_error() {
    insta::assert_snapshot!(rendered(&SCENE.replace("width = \"1.73 rad\"", "width = 1.73 rad"), &[]));
}

#[test]
fn an_array_left_open() {
    insta::assert_snapshot!(rendered(&SCENE.replace("},\n]", "},\n"), &[]));
}

#[test]
fn a_wrong_dimension_on_the_command_line() {
    insta::assert_snapshot!(rendered(SCENE, &["parameters.T0=\"20 N\"", "run.t_end=1 sec", "novalue"]));
}

#[test]
fn missing_values() {
    insta::assert_snapshot!(rendered(
        "about = \"Nothing yet\"\nmodel = \"gear_pair\"\n\n[parameters]\nI1 = \"1 kg m^2\"\n",
        &[]
    ));
}

#[test]
fn an_empty_file() {
    insta::assert_snapshot!(rendered("", &[]));
}

#[test]
fn an_unknown_model() {
    insta::assert_snapshot!(rendered(&SCENE.replace("gear_pair", "gearpair"), &[]));
}

#[test]
fn laws_that_do_not_fill_the_pitch() {
    insta::assert_snapshot!(rendered(SCENE, &[r#"laws.k.steps.1.width="4.5 rad""#]));
}

/// Each mistake in a function of time is shown at its place.
#[test]
fn time_histories_with_mistakes() {
    let history = r#"
[parameters.T0]
steps = [{ value = "5 N*m", until = "2 s" }, { value = "8 N", until = "1 s" }, { value = "9 N*m", till = "4 s" }]
harmonics = [{ amplitude = "1 N*m", frequency = "50 rpm" }]
"#;
    insta::assert_snapshot!(rendered(&SCENE.replace("\n[laws.k]", &format!("{history}\n[laws.k]")), &[]));
    insta::assert_snapshot!(rendered(
        SCENE,
        &["parameters.I1={ramp={to=\"1 kg*m^2\", duration=\"1 s\"}}", "parameters.T0={}"]
    ));
}

/// Each override is refused; the message contains the text beside it.
#[test]
fn messages_name_the_mistake() {
    let cases = [
        ("parameters.I1=nan", "not a finite number"),
        ("parameters.zeta=inf", "not a finite number"),
        ("parameters.T0=1e999 N*m", "not a finite number"),
        ("parameters.I1=0", "must be positive"),
        ("parameters.zeta=-1e-9", "must not be negative"),
        ("parameters.zeta=5 deg", "is an angle"),
        ("parameters.T0=true", "not true or false"),
        ("parameters.T0=[1]", "not an array"),
        ("parameters.T0=12", "give a unit"),
        ("parameters.T0=12 N*\u{20ac}", "does not belong in a unit"),
        ("parameters.T0=\"12 N\\u0020q\"", "unknown unit"),
        ("parameters=3", "must be a table"),
        ("effects=[\"damping\", \"damping\"]", "named twice"),
        ("effects=[\"frozen_phase\"]", "needs `stiffness_step`"),
        ("effects=[\"stiffness_step\", \"frozen_phase\", \"rigid_kinematics\"]", "contradict each other"),
        ("effects=damping", "must be an array"),
        ("effects=[1]", "must be text"),
        ("effects=[\"dampning\"]", "there is no effect `dampning`"),
        ("model=7", "must be text"),
        ("run.t_end=0", "`run.t_end` must be positive"),
        ("run.t_end=1e-320 s", "`run.t_end` must be at least 1e-300 s"),
        ("run.t_end=-1 s", "`run.t_end` must be positive"),
        ("output.rate=0", "`output.rate` must be positive"),
        ("output.rate=20 rpm", "write Hz"),
        ("output.rate=1e10 Hz", "samples"),
        ("output.plots=[\"energie\"]", "did you mean `energy`"),
        ("output.events=1", "must be true or false"),
        ("start.speed=static", "cannot be \"static\""),
        ("start.theta_dot=static", "cannot be \"static\""),
        ("start.phi=statc", "write \"static\""),
        ("start.theta=0.1", "give a unit"),
        ("start.speed=\"50 Hz\"", "rpm"),
        ("laws.k.steps=[]", "is empty"),
        ("laws.k.ramp=0", "must be positive"),
        ("laws.k.ramp=2 rad", "must be narrower than every level"),
        ("laws.k.ramp=1 m", "is an angle, but"),
        ("laws.k.table=[]", "has both steps and table"),
        ("laws.k={mean=\"1 N*m\"}", "lacks `harmonics`"),
        ("laws.k={mean=\"1 N*m\", ramp=\"1 rad\", harmonics=[]}", "has no steps to join"),
        ("laws.k={mean=\"1 N*m\", harmonics=[{order=1, amplitude=\"2 N*m\"}]}", "falls to -1"),
        ("laws.k={mean=\"1 N*m\", harmonics=[{order=1.5, amplitude=\"1 N*m\"}]}", "must be a whole number"),
        ("laws.k={mean=\"1 N*m\", harmonics=[{amplitude=\"1 N*m\"}]}", "lacks `order`"),
        ("laws.k={table=[{at=0, value=\"1 N*m\"}]}", "has 1 points"),
        ("laws.k={table=[{at=0, value=0}, {at=\"3 rad\", value=0}, {at=\"2 rad\", value=0}]}", "is out of order"),
        ("laws.k={table=[{at=0, value=0}, {at=\"3 rad\", value=0}, {at=\"7 rad\", value=0}]}", "is out of order"),
        ("run.method=rk5", "there is no method `rk5`"),
        ("run.method=rk4", "lacks `step`"),
        ("run={t_end=\"1 s\", method=\"rk4\", step=0}", "must be positive"),
        ("run={t_end=\"1 s\", method=\"rk4\", step=\"1 s\", tolerance=1e-3}", "has no tolerance"),
        ("run={t_end=\"1 s\", method=\"exact\", tolerance=1e-3}", "has no tolerance"),
        ("run={t_end=\"1 s\", method=\"radau\", step=\"1 s\"}", "has no fixed step"),
        ("run.tolerance=1e-20", "must lie between 1e-14 and 1e-2"),
        ("parameters.zeta={mean=0.1}", "cannot vary in time"),
        ("parameters.T0={}", "has no values"),
        ("parameters.T0={mean=\"1 N\"}", "is a torque or energy, but"),
        ("parameters.T0={men=\"1 N*m\"}", "did you mean `mean`"),
        ("parameters.T0={mean=\"1 N*m\", steps=[{value=0}]}", "has both steps and mean"),
        ("parameters.T0={ramp=\"1 N*m\"}", "`parameters.T0.ramp` must be a table"),
        ("parameters.T0={ramp={to=\"1 N*m\"}}", "lacks `duration`"),
        ("parameters.T0={ramp={to=\"1 N*m\", duration=0}}", "`parameters.T0.ramp.duration` must be positive"),
        ("parameters.T0={ramp={to=\"1 N*m\", duration=\"1 s\", start=\"-1 s\"}}", "must not be negative"),
        ("parameters.T0={ramp={to=\"1e300 N*m\", duration=\"1e-300 s\"}}", "too large for a floating-point number"),
        ("parameters.T0={steps=[]}", "has 0 entries"),
        ("parameters.T0={steps=[{value=0, until=\"1 s\"}]}", "nothing follows"),
        ("parameters.T0={steps=[{value=0}, {value=0}]}", "lacks `until`"),
        ("parameters.T0={steps=[{value=0, until=\"1 s\"}, {value=0, until=\"1 s\"}, {value=0}]}", "is out of order"),
        ("parameters.T0={steps=[{value=0, until=\"1 N\"}, {value=0}]}", "is a time, but"),
        ("parameters.T0={table=[{at=\"1 s\"}]}", "lacks `value`"),
        ("parameters.T0={table=[{at=\"-1 s\", value=0}]}", "is out of order"),
        ("parameters.T0={table=3}", "must be an array"),
        (
            "parameters.T0={harmonics=[{amplitude=\"1 N*m\", frequency=0}]}",
            "the frequency of `parameters.T0.harmonics.0` must be positive",
        ),
        ("parameters.T0={harmonics=[{amplitude=\"1 N*m\", frequency=\"9 rad/s\"}]}", "write Hz"),
        ("parameters.T0={harmonics=[{frequency=\"1 Hz\"}]}", "lacks `amplitude`"),
        ("parameters.T0.mean=\"1 N\"", "is a torque or energy, but"),
        ("laws.k.steps=3", "must be an array"),
        ("laws.k.steps.0.value=-1 N*m", "must not be negative"),
        ("laws.k.steps.0.width=0", "must be positive"),
        ("laws.k.steps.0.width=7 rad", "leaves nothing"),
        ("laws.k.steps=[{value=\"1 N*m\"},{value=\"2 N*m\"}]", "lacks `width`"),
        ("laws.k.steps.9.value=1 N*m", "no entry `9`"),
        ("laws.k=1", "must be a table"),
        ("laws.q.steps=[]", "has no `q`"),
        ("zeta.x.y=1", "`parameters.zeta`"),
        ("speed=300 rpm", "`start.speed`"),
        ("zetta=1", "allowed: `about`"),
        ("model.name=1", "inside a single value"),
        ("=1", "an override with an invalid key"),
        ("a..b=1", "an override with an invalid key"),
        ("run.t_end=", "without a value"),
        ("effects=[\"damping\"", "not valid TOML"),
    ];
    for (text, expected) in cases {
        let shown = parse(SCENE, &[text]).expect_err(text).render(200, false);
        assert!(shown.contains(expected), "{text}: {shown}");
    }
}

#[test]
fn deep_nesting_is_refused() {
    let deep = "a.".repeat(100_000);
    assert!(rendered(&format!("{deep}a = 1"), &[]).contains("recursion limit"));
    assert!(rendered(&"[".repeat(100_000), &[]).contains("not valid TOML"));
    assert!(rendered(SCENE, &[&format!("{deep}a=1")]).contains("an override with an invalid key"));
    assert!(rendered(SCENE, &[&format!("about={}", "[".repeat(100_000))]).contains("not valid TOML"));
}

/// A text cut off anywhere, or with anything inserted, gives a scene or mistakes that can be shown.
#[test]
fn no_text_panics() {
    for cut in (0..=SCENE.len()).filter(|cut| SCENE.is_char_boundary(*cut)) {
        for insert in ["", "\"", "[", "µ", "\n[[laws]]\n", " = 1\n"] {
            let text = format!("{}{insert}{}", &SCENE[..cut], if insert.is_empty() { "" } else { &SCENE[cut..] });
            if let Err(errors) = parse(&text, &[]) {
                assert!(!errors.mistakes().is_empty(), "{text}");
                assert!(!errors.render(80, true).is_empty());
            }
        }
    }
}
