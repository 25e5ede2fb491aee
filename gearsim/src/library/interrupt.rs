//! Work that ends early when it is no longer wanted.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// Payload of the unwinding that ends the work.
struct Interrupted;

/// The result of `work`; `None` if `go_on` returned false while it ran. `work` gets a function that runs call with the time reached \[s\],
/// as in [`Scene::run_watched`](crate::Scene::run_watched). A run cannot return early from there, so the function unwinds to here.
pub(crate) fn interruptible<T>(go_on: &dyn Fn() -> bool, work: impl FnOnce(&dyn Fn(f64)) -> T) -> Option<T> {
    let watch = |_: f64| {
        if !go_on() {
            resume_unwind(Box::new(Interrupted));
        }
    };
    match catch_unwind(AssertUnwindSafe(|| work(&watch))) {
        Ok(done) => Some(done),
        Err(payload) if payload.is::<Interrupted>() => None,
        Err(payload) => resume_unwind(payload),
    }
}

#[test]
fn a_run_ends_when_it_is_no_longer_wanted() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/oh2005/energy_300rpm.toml");
    let scene = crate::Scene::load(path).unwrap();
    let (calls, most) = (std::cell::Cell::new(0), std::cell::Cell::new(u64::MAX));
    let go_on = || {
        calls.set(calls.get() + 1);
        calls.get() < most.get()
    };
    let run = || interruptible(&go_on, |watch| scene.run_alone(&mut |t| watch(t)).unwrap());
    let whole = run().unwrap();
    assert_eq!(whole.trajectory().t.last(), Some(&scene.t_end));
    assert!(calls.get() > 20, "{} calls", calls.get());
    calls.set(0);
    most.set(10);
    assert!(run().is_none());
    assert_eq!(calls.get(), 10);
}
