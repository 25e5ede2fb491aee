//! The key `damage` of a stiffness: cracked or spalled teeth, whose pairs carry less. `damage = [{ tooth = 5, of = 24, loss = 0.3 }]`
//!
//! Each of n tooth pairs in contact has the stiffness k/n. The pair of the damaged tooth loses the part `loss` of this: once in `of`
//! pitches, from where it enters contact until it leaves. Compare Z. Chen, Y. Shao, Eng. Fail. Anal. 18 (2011), where the loss follows from
//! the length of a crack.

use super::document::{Node, Place};
use super::keys::{Key, Kind, REQUIRED, key};
use super::mistake::Report;
use super::{field, keys};
use crate::model::Law;
use crate::profile::{Profile, Step};
use crate::tolerance::scene::{DAMAGED_CELLS, TEETH};

/// The key.
pub(super) const DAMAGE: &str = "damage";
/// The key in the table of a law.
pub(super) const KEYS: &[Key] =
    &[key(DAMAGE, Kind::List(&Kind::Table(&[TOOTH])), "none", "cracked or spalled teeth, whose pairs carry less")];
/// Keys of a damaged tooth.
const TOOTH: &[Key] = &[
    key("tooth", Kind::Number, REQUIRED, "which tooth, counted from 1 in the order in which they enter contact"),
    key("of", Kind::Number, REQUIRED, "number of teeth of its gear"),
    key("loss", Kind::Number, REQUIRED, "lost part of the stiffness of its pair, from 0 to 1"),
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

/// Puts the damaged teeth that `node` lists into a law of one pitch.
pub(super) fn read(law: &Law, node: &Node, healthy: Profile, report: &mut Report) -> Option<Profile> {
    let path = format!("laws.{}.{DAMAGE}", law.name);
    let items = field::array(&path, node, EXAMPLE, report)?;
    let damages: Vec<_> =
        items.iter().enumerate().map(|(i, item)| tooth(&format!("{path}.{i}"), item, report)).collect();
    let damages: Vec<Damage> = damages.into_iter().collect::<Option<_>>()?;
    if damages.is_empty() {
        return Some(healthy);
    }
    damaged(&healthy, &damages).map_err(|(message, help)| refuse(&path, &node.place, message, help, report)).ok()
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

/// The law over as many pitches as it takes until the damaged teeth of all gears are at the same place again.
fn damaged(healthy: &Profile, damages: &[Damage]) -> Result<Profile, (&'static str, &'static str)> {
    if !healthy.steps_only() {
        return Err(("only a law of steps can have damaged teeth", "give steps, or teeth with course = \"levels\""));
    }
    let n = healthy.steps.len();
    let more: Vec<bool> = healthy.steps.iter().map(|step| step.value > healthy.mid()).collect();
    let rises: Vec<usize> = (0..n).filter(|&i| more[i] && !more[(i + n - 1) % n]).collect();
    let [rise] = rises[..] else {
        let help =
            "give a stiffness that rises once a pitch, where a pair enters contact, and falls once, where one leaves";
        return Err(("where pairs enter contact cannot be told from the steps", help));
    };
    let pitches = damages.iter().try_fold(1usize, |all, damage| all.checked_mul(damage.of / gcd(all, damage.of)));
    let pitches = pitches.filter(|pitches| pitches * n <= DAMAGED_CELLS);
    let pitches =
        pitches.ok_or(("the damaged teeth meet again only after too many pitches", "damage teeth of one gear only"))?;
    // The contact of a pair lasts from the rise to the fall in the next pitch.
    let single = (0..n).filter(|&i| !more[i]).count();
    let of_contact = n + (n - single);
    let mut steps: Vec<Step> = (0..pitches).flat_map(|_| healthy.steps.iter().copied()).collect();
    for damage in damages {
        for first in (damage.tooth..pitches).step_by(damage.of) {
            for i in 0..of_contact {
                let cell = first * n + rise + i;
                let pairs = if more[cell % n] { 2.0 } else { 1.0 };
                steps[cell % (pitches * n)].value -= damage.loss * healthy.steps[cell % n].value / pairs;
            }
        }
    }
    steps.iter_mut().for_each(|step| step.value = step.value.max(0.0));
    Ok(Profile::stepping(steps).with_origin(healthy.origin).with_pitches(pitches as u32))
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair() -> Profile {
        Profile::stepping(vec![Step { value: 10.0, width: 0.25 }, Step { value: 20.0, width: 0.75 }])
    }

    fn values(damages: &[Damage]) -> Vec<f64> {
        damaged(&pair(), damages).unwrap().steps.iter().map(|step| step.value).collect()
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
        assert_eq!([law[1], law[3], law[5], law[7]], [20.0 - 2.0 - 1.0, 17.0, 18.0, 17.0]);
    }

    #[test]
    fn a_constant_law_is_refused() {
        let constant = Profile::stepping(vec![Step { value: 1.0, width: 1.0 }]);
        assert!(damaged(&constant, &[Damage { tooth: 0, of: 2, loss: 0.2 }]).is_err());
    }
}
