//! The key `damage` of a stiffness: cracked or spalled teeth, whose pairs carry less. `damage = [{ tooth = 5, of = 24, loss = 0.3 }]`
//!
//! Each of n tooth pairs in contact has the stiffness k/n. The pair of the damaged tooth loses the part `loss` of this
//! stiffness. It does so once in `of` pitches, from where it enters contact until it leaves. Compare Z. Chen, Y. Shao, Eng. Fail. Anal. 18
//! (2011), where the loss follows from the length of a crack. Where both teeth of a pair are damaged, their flexibilities add: with the
//! losses a and b, 1/k of the pair becomes (1 + a/(1 - a) + b/(1 - b))/k, so that a pair never loses more than its stiffness.
//!
//! The number of pairs in contact follows from the teeth of the law. Along the face of helical gears each transverse section has its own law.
//! A law that is given by steps alone has one pair in contact at its low level, and two at its high level.

use num_integer::Integer;

use super::document::{KeyEntry, Node, Place, Value};
use super::keys::{Key, Kind, REQUIRED, key};
use super::mistake::Report;
use super::{field, keys};
use crate::model::Law;
use crate::profile::{Profile, Step};
use crate::tolerance::scene::{DAMAGED_CELLS, TEETH};

/// The key.
pub(super) const DAMAGE: &str = "damage";
/// The key in the table of a law.
pub(super) const KEYS: &[Key] = &[key(
    DAMAGE,
    Kind::List(&Kind::Table(&[TOOTH])),
    "none",
    "cracked or spalled teeth, whose pairs carry less; steps without teeth are of one pair and two",
)];
/// Keys of a damaged tooth.
const TOOTH: &[Key] = &[
    key("tooth", Kind::Number, REQUIRED, "which tooth, counted from 1 in the order in which they enter contact"),
    key("of", Kind::Number, REQUIRED, "number of teeth of its gear"),
    key(
        "loss",
        Kind::Number,
        REQUIRED,
        "lost part of the stiffness of its pair, 0 to 1; flexibilities of two damaged teeth add",
    ),
];
/// What to write.
const EXAMPLE: &str = "[{ tooth = 1, of = 24, loss = 0.3 }]";

/// A damaged tooth.
struct Damage {
    /// Which tooth, counted from 0 in the order in which they enter contact.
    tooth: usize,
    /// Number of teeth of its gear.
    of: usize,
    /// Part of the stiffness of its pair that is lost.
    loss: f64,
}

/// Applies the damaged teeth that `node` lists to the law `healthy` of one pitch. `pairs` is the smallest number of pairs in contact.
pub(super) fn read(law: &Law, node: &Node, healthy: Profile, pairs: usize, report: &mut Report) -> Option<Profile> {
    let path = format!("laws.{}.{DAMAGE}", law.name);
    let items = field::array(&path, node, EXAMPLE, report)?;
    let damages: Vec<_> =
        items.iter().enumerate().map(|(i, item)| tooth(&format!("{path}.{i}"), item, report)).collect();
    let damages: Vec<Damage> = damages.into_iter().collect::<Option<_>>()?;
    if damages.is_empty() {
        return Some(healthy);
    }
    damaged(&healthy, &damages, pairs).map_err(|(message, help)| refuse(&path, &node.place, message, help, report)).ok()
}

/// Refuses damaged teeth in a law over several pitches.
pub(super) fn refuse_pitches(law: &Law, node: &Node, report: &mut Report) -> Option<Profile> {
    let message = "a law over several pitches has the damage that its steps have";
    refuse(&format!("laws.{}.{DAMAGE}", law.name), &node.place, message, "leave out damage or pitches", report);
    None
}

/// Refuses damaged teeth in a law that is a series or a table.
pub(super) fn refuse_curve(law: &Law, node: &Node, report: &mut Report) -> Option<Profile> {
    let message = "a series or a table does not say where tooth pairs enter contact";
    let help = "give steps, with ramp for smooth ones, or teeth";
    refuse(&format!("laws.{}.{DAMAGE}", law.name), &node.place, message, help, report);
    None
}

fn refuse(path: &str, place: &Place, message: &str, help: &str, report: &mut Report) {
    report.add(place, format!("`{path}`: {message}"), "not possible", help);
}

fn tooth(path: &str, node: &Node, report: &mut Report) -> Option<Damage> {
    let entries = field::table(path, node, report)?;
    keys::known(entries, &format!("`{path}`"), &[TOOTH], report);
    let lines = [("tooth", "tooth = 1"), ("of", "of = 24  # teeth of the gear"), ("loss", "loss = 0.3")];
    let lacking = lines.iter().filter(|(key, _)| keys::get(entries, key).is_none());
    keys::missing(
        &lacking.map(|(key, line)| (*key, line.to_string())).collect::<Vec<_>>(),
        &format!("`{path}`"),
        &node.place,
        report,
    );
    let mut within = |key: &str, range: (f64, f64), whole: bool, must: String, what: &str| {
        let node = keys::get(entries, key)?;
        let path = format!("{path}.{key}");
        let x = field::quantity(&path, node, "1", report)?;
        if !(range.0..=range.1).contains(&x) || (whole && x.fract() != 0.0) {
            field::out_of_range(&path, node, &must, what, report);
            return None;
        }
        Some(x)
    };
    let whole = |most: f64| format!("must be a whole number from 1 to {most}");
    let of = within("of", (1.0, TEETH), true, whole(TEETH), "it is the number of teeth of the damaged gear");
    let most = of.unwrap_or(TEETH);
    let tooth =
        within("tooth", (1.0, most), true, whole(most), "teeth are counted in the order in which they enter contact");
    let loss = within(
        "loss",
        (0.0, 1.0),
        false,
        "must lie between 0 and 1".into(),
        "it is the lost part of the stiffness of a pair",
    );
    Some(Damage { tooth: tooth? as usize - 1, of: of? as usize, loss: loss? })
}

/// Checks that damaged teeth are those of a gear of the mesh, whose numbers of teeth are `teeth`.
pub(super) fn check(law: &Law, entries: &[KeyEntry], teeth: [f64; 2], report: &mut Report) {
    let Some(Value::Array(items)) = keys::get(entries, DAMAGE).map(|node| &node.value) else { return };
    for (i, item) in items.iter().enumerate() {
        let Value::Table(tooth) = &item.value else { continue };
        let of =
            keys::get(tooth, "of").and_then(|node| Some((field::quantity("", node, "1", &mut Report::new())?, node)));
        let Some((of, node)) = of.filter(|(of, _)| !teeth.contains(of)) else { continue };
        let path = format!("laws.{}.{DAMAGE}.{i}.of", law.name);
        let what = format!("`{path}` is {of}, but the gears of this mesh have {} and {} teeth", teeth[0], teeth[1]);
        report.add(&node.place, what, "no gear of this mesh", "give the number of teeth of the damaged gear");
    }
}

/// The law over as many pitches as it takes until the damaged teeth of all gears are at the same place again. At least `pairs` pairs are in
/// contact, and one more where the law is higher.
fn damaged(healthy: &Profile, damages: &[Damage], pairs: usize) -> Result<Profile, (&'static str, &'static str)> {
    let n = healthy.steps.len();
    let more: Vec<bool> = healthy.steps.iter().map(|step| step.value > healthy.mid()).collect();
    let rises: Vec<usize> = (0..n).filter(|&i| more[i] && !more[(i + n - 1) % n]).collect();
    let [rise] = rises[..] else {
        let help =
            "give a stiffness that rises once a pitch, where a pair enters contact, and falls once, where one leaves";
        return Err(("where pairs enter contact cannot be told from the steps", help));
    };
    let pitches = damages.iter().try_fold(1usize, |all, damage| all.checked_mul(damage.of / all.gcd(&damage.of)));
    let pitches = pitches.filter(|pitches| pitches * n <= DAMAGED_CELLS);
    let pitches =
        pitches.ok_or(("the damaged teeth meet again only after too many pitches", "damage teeth of one gear only"))?;
    // A pair enters contact at a rise of the law, stays in contact through `pairs` falls, and leaves at the next fall.
    let single = (0..n).filter(|&i| !more[i]).count();
    let of_contact = pairs * n + (n - single);
    let mut steps: Vec<Step> = (0..pitches).flat_map(|_| healthy.steps.iter().copied()).collect();
    for pair in 0..pitches {
        let teeth = damages.iter().filter(|damage| pair % damage.of == damage.tooth);
        let loss = teeth.fold(0.0, |loss, damage| together(loss, damage.loss));
        for cell in (0..of_contact).map(|i| pair * n + rise + i) {
            let pairs = pairs + usize::from(more[cell % n]);
            steps[cell % (pitches * n)].value -= loss * healthy.steps[cell % n].value / pairs as f64;
        }
    }
    steps.iter_mut().for_each(|step| step.value = step.value.max(0.0));
    // A curve is scaled with its cell.
    let part = |i: usize| steps[i].value / healthy.steps[i % n].value;
    let curves = (0..steps.len()).filter_map(|i| Some(healthy.curves.get(i % n)?.times(part(i)))).collect();
    Ok(Profile { steps, curves, origin: healthy.origin, pitches: pitches as u32 })
}

/// The lost part of the stiffness of a pair with two damaged teeth, which would lose the parts `a` and `b` alone.
fn together(a: f64, b: f64) -> f64 {
    if a.max(b) < 1.0 { (a + b - 2.0 * a * b) / (1.0 - a * b) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Curve;

    fn pair() -> Profile {
        Profile::stepping(vec![Step { value: 10.0, width: 0.25 }, Step { value: 20.0, width: 0.75 }])
    }

    fn values(damages: &[Damage]) -> Vec<f64> {
        damaged(&pair(), damages, 1).unwrap().steps.iter().map(|step| step.value).collect()
    }

    #[test]
    fn the_pair_of_a_damaged_tooth_carries_less_from_its_entry_to_its_exit() {
        let law = values(&[Damage { tooth: 1, of: 3, loss: 0.5 }]);
        // Pitch by pitch: one pair, two pairs. The damaged pair enters at the rise in the second pitch.
        assert_eq!(law, [10.0, 20.0, 10.0, 15.0, 5.0, 15.0]);
    }

    #[test]
    fn the_last_tooth_reaches_into_the_first_pitch() {
        assert_eq!(values(&[Damage { tooth: 2, of: 3, loss: 1.0 }]), [0.0, 10.0, 10.0, 20.0, 10.0, 10.0]);
    }

    #[test]
    fn teeth_of_both_gears_repeat_after_the_common_multiple() {
        let law = values(&[Damage { tooth: 0, of: 2, loss: 0.2 }, Damage { tooth: 0, of: 3, loss: 0.1 }]);
        assert_eq!(law.len(), 12);
        // Both teeth of the first pair are damaged: 1/k becomes (1 + 1/4 + 1/9)/k.
        let both = 10.0 - 10.0 / (1.0 + 0.25 + 1.0 / 9.0);
        assert!((law[1] - (20.0 - both)).abs() < 1e-14 && (law[3] - (20.0 - both)).abs() < 1e-14, "{law:?}");
        assert_eq!([law[5], law[7]], [18.0, 17.0]);
    }

    #[test]
    fn a_pair_of_two_damaged_teeth_keeps_a_part_of_its_stiffness() {
        assert_eq!(
            [together(0.0, 0.3), together(0.3, 0.0), together(1.0, 0.3), together(1.0, 1.0)],
            [0.3, 0.3, 1.0, 1.0]
        );
        assert!((together(0.6, 0.6) - 0.75).abs() < 1e-15);
        let law = values(&[Damage { tooth: 0, of: 3, loss: 0.6 }, Damage { tooth: 0, of: 3, loss: 0.6 }]);
        // The damaged pair keeps 1/4 of its stiffness. The other pairs are healthy.
        let apart = law.iter().zip([10.0, 12.5, 2.5, 12.5, 10.0, 20.0]).map(|(a, b)| (a - b).abs());
        assert!(apart.into_iter().all(|apart| apart < 1e-14), "{law:?}");
    }

    /// With a contact ratio of 2.25 a pair is in contact for 2.25 pitches. During this time three, two, three, two and three pairs are in
    /// contact, one after the other.
    #[test]
    fn a_pair_of_three_loses_a_third() {
        let law = Profile::stepping(vec![Step { value: 20.0, width: 0.75 }, Step { value: 30.0, width: 0.25 }]);
        let law = damaged(&law, &[Damage { tooth: 0, of: 4, loss: 1.0 }], 2).unwrap();
        let values: Vec<_> = law.steps.iter().map(|step| step.value).collect();
        assert_eq!(values, [20.0, 20.0, 10.0, 20.0, 10.0, 20.0, 20.0, 30.0]);
    }

    /// Curves keep their shape: a cell of two pairs of which one is lost has half of its curve.
    #[test]
    fn curves_of_a_damaged_pair_are_scaled() {
        let curve = |value| Curve::Cubic([value, 0.1 * value, 0.0, 0.0]);
        let law = Profile::curved(vec![(curve(10.0), 0.25), (curve(20.0), 0.75)]);
        let law = damaged(&law, &[Damage { tooth: 0, of: 2, loss: 1.0 }], 1).unwrap();
        assert_eq!(law.curves, [10.0, 10.0, 0.0, 10.0].map(curve));
        assert!((law.steps[1].value - 0.5 * curve(20.0).mean(0.75)).abs() < 1e-15);
    }

    #[test]
    fn a_constant_law_is_refused() {
        let constant = Profile::stepping(vec![Step { value: 1.0, width: 1.0 }]);
        assert!(damaged(&constant, &[Damage { tooth: 0, of: 2, loss: 0.2 }], 1).is_err());
    }
}
