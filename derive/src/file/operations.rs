//! How many arithmetic operations the equations take.

use symbolica::atom::Atom;

use crate::derivation::Derivation;
use crate::markers::grouped;

/// The lines of a Markdown table, one row for each output.
pub(super) fn table(d: &Derivation) -> Vec<String> {
    let mut lines = vec![
        "| output | sums | products, quotients | functions, roots |".to_string(),
        "| --- | --- | --- | --- |".to_string(),
    ];
    lines.extend(counts(d).iter().map(|(name, [a, m, f])| format!("| {name} | {a} | {m} | {f} |")));
    lines
}

fn counts(d: &Derivation) -> Vec<(String, [usize; 3])> {
    let count = |atoms: &[Atom]| {
        atoms.iter().flat_map(|a| grouped(a, &d.order())).fold([0; 3], |sum, group| {
            let n = group.sum.operations();
            [sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]]
        })
    };
    let constants: Vec<Atom> = d.motion.constants.iter().map(|c| c.1.clone()).collect();
    let mut rows = vec![];
    if !constants.is_empty() {
        rows.push(("constants (once a scene)".to_string(), count(&constants)));
    }
    let forces: Vec<Atom> = d.model.forces.iter().map(|force| force.value.atom()).collect();
    if !forces.is_empty() {
        rows.push(("named forces".into(), count(&forces)));
    }
    rows.push(("force".into(), count(&d.motion.force)));
    if let Some(a) = &d.motion.acceleration {
        rows.push(("acceleration".into(), count(a)));
    }
    let steps: Vec<Atom> = d.jumps.iter().map(|jump| jump.step.clone()).collect();
    if !steps.is_empty() {
        rows.push(("energy steps, all laws".into(), count(&steps)));
    }
    rows
}
