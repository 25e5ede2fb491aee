//! The path of contact against published gears, closed forms and limits.

use std::f64::consts::{PI, TAU};

use crate::gear::Gears;
use crate::gear::involute::involute;
use crate::gear::pair::iso_6336_30;

fn standard(z1: f64, z2: f64) -> Gears {
    Gears::standard([z1, z2], 6.35e-3, 20f64.to_radians(), 7e-3)
}

/// The gears of Oh, Grosh & Barber (2005), computed independently: contact ratio 1.72491, one pair over 1.728 rad, two over 4.555 rad.
#[test]
fn contact_ratio_of_the_gears_of_oh_2005() {
    let contact = standard(24.0, 96.0).contact().unwrap();
    assert!((contact.ratio() - 1.724_91).abs() < 5e-6, "{}", contact.ratio());
    let (pairs, more) = contact.pairs();
    assert_eq!(pairs, 1);
    assert!(((1.0 - more) * TAU - 1.728).abs() < 5e-4 && (more * TAU - 4.555).abs() < 5e-4);
    assert!((contact.reference[0] - 76.2e-3).abs() < 1e-12 && (contact.centre_distance - 0.381).abs() < 1e-12);
}

/// If the two gears are exchanged, so are approach and recess. Contact begins at the tip of gear 2 and ends at the tip of gear 1.
#[test]
fn the_contact_is_symmetric_in_the_gears() {
    let (one, two) = (standard(24.0, 96.0).contact().unwrap(), standard(96.0, 24.0).contact().unwrap());
    assert!((one.ratio() - two.ratio()).abs() < 1e-14 && (one.approach - two.recess).abs() < 1e-15);
    let (begin, end) = (one.radii(-one.approach), one.radii(one.recess));
    assert!((begin[1] - one.tip[1]).abs() < 1e-15 && (end[0] - one.tip[0]).abs() < 1e-15);
    let pitch = one.radii(0.0);
    assert!((pitch[0] - one.reference[0]).abs() < 1e-15 && (pitch[1] - one.reference[1]).abs() < 1e-15);
}

/// Profile shifts with the sum 0 do not change the pressure angle. With another sum the gears still mesh without backlash: the tooth
/// thicknesses at the working pitch circles add up to the pitch.
#[test]
fn shifted_gears_mesh_without_backlash() {
    let shifted = |x: [f64; 2]| Gears { profile_shift: x, ..standard(20.0, 40.0) };
    let zero = shifted([0.3, -0.3]).contact().unwrap();
    assert!((zero.angle - 20f64.to_radians()).abs() < 1e-12);
    let gears = Gears { addendum: [0.95; 2], ..shifted([0.5, 0.2]) };
    let contact = gears.contact().unwrap();
    let thickness = |i: usize| {
        let (z, x, alpha) = (gears.teeth[i], gears.profile_shift[i], gears.pressure_angle);
        let working = contact.base[i] / contact.angle.cos();
        let angle = (PI / 2.0 + 2.0 * x * alpha.tan()) / z + involute(alpha) - involute(contact.angle);
        (2.0 * working * angle, TAU * working / z)
    };
    let ((s1, pitch), (s2, same)) = (thickness(0), thickness(1));
    assert!((pitch - same).abs() < 1e-15 && (s1 + s2 - pitch).abs() < 1e-12, "{s1} {s2} {pitch}");
    // If this centre distance is given explicitly, the contact is the same.
    let told = Gears { centre_distance: Some(contact.centre_distance), ..gears }.contact().unwrap();
    assert!((told.ratio() - contact.ratio()).abs() < 1e-9);
}

/// With very many teeth, a ring and an external gear both become a rack: a planet has the same contact ratio with each.
#[test]
fn a_ring_with_many_teeth_is_a_rack() {
    let ring = |z2: f64| Gears { internal: true, addendum: [1.0, 0.8], ..standard(36.0, z2) };
    let external = |z2: f64| Gears { addendum: [1.0, 0.8], ..standard(36.0, z2) };
    let (inside, outside) = (ring(1e7).contact().unwrap().ratio(), external(1e7).contact().unwrap().ratio());
    assert!((inside - outside).abs() < 1e-4, "{inside} {outside}");
    let near = ring(99.0).contact().unwrap();
    assert!(near.ratio() > outside && near.tip[1] < near.reference[1] && near.root[1] > near.reference[1]);
    assert!((near.centre_distance - 6.35e-3 * 31.5).abs() < 1e-12);
    assert!(ring(30.0).contact().unwrap_err().what.contains("too small"));
}

/// Example 1 of ISO/TR 6336-30: 17 and 103 teeth, 8 mm, helix angle 15.8 deg, face width 100 mm, centre distance 500 mm. The transverse
/// contact ratio follows from its c_gamma_alpha/c' = 17.46485/12.37047 = 0.75 eps_alpha + 0.25.
#[test]
fn contact_of_the_helical_gears_of_iso_6336_30() {
    let contact = iso_6336_30().contact().unwrap();
    assert!((contact.ratio() - 1.549_09).abs() < 2e-3, "{}", contact.ratio());
    assert!((contact.overlap - 100.0 * 15.8f64.to_radians().sin() / (8.0 * PI)).abs() < 1e-14);
    assert!((contact.reference[0] - 17.0 * 8e-3 / 15.8f64.to_radians().cos() / 2.0).abs() < 1e-15);
}

/// As the helix angle goes to zero, the gears become spur gears.
#[test]
fn a_small_helix_angle_changes_little() {
    let (spur, helical) = (standard(24.0, 96.0), Gears { helix_angle: 1e-6, ..standard(24.0, 96.0) });
    let (spur, helical) = (spur.contact().unwrap(), helical.contact().unwrap());
    assert!((spur.ratio() - helical.ratio()).abs() < 1e-11 && helical.overlap > 0.0 && spur.overlap == 0.0);
}

#[test]
fn gears_that_do_not_mesh_are_refused() {
    let cases = [
        (standard(6.0, 96.0), "below its base circle"),
        (Gears { centre_distance: Some(0.3), ..standard(24.0, 96.0) }, "overlap"),
        (Gears { centre_distance: Some(0.392), ..standard(24.0, 96.0) }, "the contact ratio is"),
        (Gears { addendum: [1.1; 2], dedendum: [1.0; 2], ..standard(60.0, 96.0) }, "tips and roots overlap"),
        (Gears { profile_shift: [-3.0, -3.0], ..standard(24.0, 96.0) }, "no working pressure angle"),
        (Gears { addendum: [-4.0, 1.0], ..standard(24.0, 96.0) }, "within its base circle"),
    ];
    for (gears, said) in cases {
        let error = gears.contact().expect_err(said);
        assert!(error.what.contains(said), "{error}");
    }
}
