//! Checks how the rotors of a train are joined: a part acts on each rotor, and along every loop of shafts and meshes the directions of
//! rotation agree.

use super::draft::{Draft, DraftPart};
use crate::scene::mistake::Report;

/// Reports rotors on which nothing acts but their own inertia.
pub(super) fn joined(draft: &Draft, report: &mut Report) {
    for part in draft.parts.iter().filter(|part| part.element == "element_rotor") {
        let Some(rotor) = draft.rotors.iter().position(|rotor| rotor.name == part.name) else { continue };
        let acts = |other: &DraftPart| {
            other.element != "element_rotor" && other.rows.iter().flatten().any(|term| term.rotor == rotor)
        };
        let rigid = draft.joints.iter().any(|joint| joint.ends.contains(&rotor));
        if draft.rotors.len() > 1 && !rigid && !draft.parts.iter().any(acts) {
            let message = format!("rotor `{}` is joined to nothing", part.name);
            let help = "name it in a shaft, mesh, clutch, end stop, support, bearing, drive or load, or leave it out";
            report.add(&part.place, message, "no part acts on it", help);
        }
    }
}

/// The direction in which each rotor turns: 1 if it is that of the first rotor connected with it, -1 if it is the opposite one.
pub(super) fn of(draft: &Draft) -> Vec<f64> {
    let (senses, _) = follow(draft);
    senses.into_iter().map(|same| if same { 1.0 } else { -1.0 }).collect()
}

/// Reports loops in which a rotor would turn in both directions at once.
pub(super) fn check(draft: &Draft, report: &mut Report) -> Option<()> {
    let (_, closing) = follow(draft);
    let Some(joint) = closing.map(|i| &draft.joints[i]) else { return Some(()) };
    let message = format!("{} closes a loop in which the rotors block one another", joint.part);
    let help = "along the loop an odd number of external meshes reverses the rotation; leave out one part, or set internal = true";
    report.add(&joint.place, message, "turns against itself", help);
    None
}

/// Whether each rotor turns in the direction of the first rotor connected with it, and the first joint that contradicts these directions.
fn follow(draft: &Draft) -> (Vec<bool>, Option<usize>) {
    let n = draft.rotors.len();
    let mut sense: Vec<Option<bool>> = vec![None; n];
    let mut closing = None;
    for root in 0..n {
        if sense[root].is_some() {
            continue;
        }
        sense[root] = Some(true);
        let mut open = vec![root];
        while let Some(at) = open.pop() {
            for (i, joint) in draft.joints.iter().enumerate().filter(|(_, joint)| joint.ends.contains(&at)) {
                let other = if joint.ends[0] == at { joint.ends[1] } else { joint.ends[0] };
                let turned = sense[at].map(|s| s != joint.turns);
                match sense[other] {
                    None => {
                        sense[other] = turned;
                        open.push(other);
                    }
                    known if known == turned => {}
                    _ => closing = closing.or(Some(i)),
                }
            }
        }
    }
    (sense.into_iter().map(|s| s.unwrap_or(true)).collect(), closing)
}
