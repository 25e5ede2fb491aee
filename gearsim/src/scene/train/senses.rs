//! The directions of rotation in a train: along every loop of shafts and meshes they must agree.

use super::draft::Draft;
use crate::scene::mistake::Report;

/// Reports loops in which a rotor would turn in both directions at once.
pub(super) fn check(draft: &Draft, report: &mut Report) -> Option<()> {
    let n = draft.rotors.len();
    let mut sense: Vec<Option<bool>> = vec![None; n];
    for root in 0..n {
        if sense[root].is_some() {
            continue;
        }
        sense[root] = Some(true);
        let mut open = vec![root];
        while let Some(at) = open.pop() {
            for joint in draft.joints.iter().filter(|joint| joint.ends.contains(&at)) {
                let other = if joint.ends[0] == at { joint.ends[1] } else { joint.ends[0] };
                let turned = sense[at].map(|s| s != joint.turns);
                match sense[other] {
                    None => {
                        sense[other] = turned;
                        open.push(other);
                    }
                    known if known == turned => {}
                    _ => {
                        let message = format!("{} closes a loop in which the rotors block one another", joint.part);
                        let help = "along the loop an odd number of external meshes reverses the rotation; leave out one part, or set internal = true";
                        report.add(&joint.place, message, "turns against itself", help);
                        return None;
                    }
                }
            }
        }
    }
    Some(())
}
