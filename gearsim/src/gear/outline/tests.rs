//! Outlines against closed forms; flanks touch on the line of action.

use std::f64::consts::PI;

use super::*;

fn standard(z1: f64, z2: f64) -> Gears {
    Gears::standard([z1, z2], 6.35e-3, 20f64.to_radians(), 7e-3)
}

fn ring() -> Gears {
    Gears { internal: true, addendum: [1.0, 0.8], ..standard(36.0, 99.0) }
}

fn shifted() -> Gears {
    Gears { profile_shift: [0.3, 0.1], addendum: [0.95; 2], ..standard(22.0, 41.0) }
}

/// The angle of an outline at a radius \[rad\], by linear interpolation between its points.
fn between(half: &[[f64; 2]], radius: f64) -> f64 {
    let i = half.iter().rposition(|point| point[0] <= radius).unwrap().min(half.len() - 2);
    let ([r0, a0], [r1, a1]) = (half[i], half[i + 1]);
    a0 + (a1 - a0) * (radius - r0) / (r1 - r0)
}

/// Every normal of an involute is tangent to its base circle: r² dpsi/dr = -r sqrt(r² - r_b²)/r_b, so the distance of the normal from
/// the centre is r_b.
#[test]
fn normals_of_flanks_are_tangent_to_the_base_circle() {
    for gears in [standard(24.0, 96.0), shifted(), ring()] {
        let contact = gears.contact().unwrap();
        for i in 0..2 {
            let (low, high) = (contact.base[i] * 1.005, contact.tip[i].max(contact.root[i]));
            for k in 0..=10 {
                let (r, h) = (low + (high - low) * f64::from(k) / 10.0, 1e-6 * low);
                let psi = |r| half_angle(&gears, &contact, i, r);
                let turn = (psi(r + h) - psi(r - h)) / (2.0 * h);
                // Tangent (1, r psi') in radial and circumferential parts; its normal passes the centre at r/|tangent|.
                let distance = r / 1f64.hypot(r * turn);
                assert!((distance / contact.base[i] - 1.0).abs() < 1e-8, "{i} {r}: {distance} {}", contact.base[i]);
            }
        }
    }
}

/// At the reference circle a standard tooth takes half a pitch: s = pi m/2.
#[test]
fn teeth_are_half_a_pitch_thick_at_the_reference_circle() {
    let outlines = Outlines::of(&standard(24.0, 96.0)).unwrap();
    for (i, z) in [24.0, 96.0].into_iter().enumerate() {
        let r = outlines.contact.reference[i];
        let drawn = 2.0 * r * between(&outlines.gears[i].half, r);
        assert!((drawn / (PI * 6.35e-3 / 2.0) - 1.0).abs() < 1e-3, "{i}: {drawn}");
        let exact = half_angle(&standard(24.0, 96.0), &outlines.contact, i, r);
        assert!((exact - PI / (2.0 * z)).abs() < 1e-15);
    }
    assert!(outlines.clearance.abs() < 1e-15);
}

/// 24 and 96 teeth at 20 deg, from the tips of the outlines alone: the contact ratio is 1.72491.
#[test]
fn outlines_of_24_and_96_teeth_have_their_contact_ratio() {
    let outlines = Outlines::of(&standard(24.0, 96.0)).unwrap();
    let Contact { base, angle, base_pitch, centre_distance, .. } = outlines.contact;
    let beyond = |i: usize| {
        let tip = outlines.gears[i].half.last().unwrap()[0];
        (tip * tip - base[i] * base[i]).sqrt()
    };
    let ratio = (beyond(0) + beyond(1) - centre_distance * angle.sin()) / base_pitch;
    assert!((ratio - 1.724_91).abs() < 5e-6, "{ratio}");
}

/// If a pair touches at X, its flanks pass through the point of the line of action at X: the pitch point plus X (sin, cos) of the working
/// pressure angle. This is tested for external gears with and without profile shift, and for a ring.
#[test]
fn flanks_touch_on_the_line_of_action() {
    for gears in
        [standard(24.0, 96.0), shifted(), Gears { centre_distance: Some(0.382), ..standard(24.0, 96.0) }, ring()]
    {
        let Outlines { gears: outlines, contact, .. } = Outlines::of(&gears).unwrap();
        let (sin, cos) = contact.angle.sin_cos();
        let working = contact.base.map(|base| base / cos);
        let centre = if gears.internal { working[0] - working[1] } else { working[0] + working[1] };
        for k in 0..=20 {
            let x = -contact.approach + (contact.approach + contact.recess) * f64::from(k) / 20.0;
            let point = [working[0] + x * sin, x * cos];
            for (i, outline) in outlines.iter().enumerate() {
                // Angle from the line through both centres, in the direction in which the gear turns.
                let from = [point[0] - if i == 0 { 0.0 } else { centre }, point[1]];
                let external = i == 1 && !gears.internal;
                let angle = from[1].atan2(if external { -from[0] } else { from[0] });
                let radius = from[0].hypot(from[1]);
                let psi = half_angle(&gears, &contact, i, radius);
                let flank = outline.place + x / contact.base[i] + if external { -psi } else { psi };
                assert!((flank - angle).abs() < 1e-12, "gear {i} at {x}: {flank} {angle}");
                let drawn = between(&outline.half, radius.min(outline.half.last().unwrap()[0]));
                assert!(radius * (drawn - psi).abs() < 1e-3 * gears.module, "gear {i} at {x}");
            }
        }
    }
}

/// At a larger centre distance the teeth have play: 2 da sin(alpha) to first order.
#[test]
fn a_larger_centre_distance_gives_clearance() {
    let wider = Gears { centre_distance: Some(0.3811), ..standard(24.0, 96.0) };
    let clearance = Outlines::of(&wider).unwrap().clearance;
    assert!((clearance / (2.0 * 1e-4 * 20f64.to_radians().sin()) - 1.0).abs() < 1e-2, "{clearance}");
    let closer = Gears { centre_distance: Some(6.35e-3 * 31.5 - 1e-4), ..ring() };
    let clearance = Outlines::of(&closer).unwrap().clearance;
    assert!((clearance / (2.0 * 1e-4 * 20f64.to_radians().sin()) - 1.0).abs() < 2e-2, "{clearance}");
}

/// From root to tip the radius grows, a tooth becomes narrower and a space of a ring too; a pointed tooth ends on its centre line.
#[test]
fn outlines_go_from_root_to_tip() {
    for gears in [standard(24.0, 96.0), standard(17.0, 60.0), shifted(), ring()] {
        let Ok(outlines) = Outlines::of(&gears) else { panic!("{gears:?}") };
        for (i, outline) in outlines.gears.iter().enumerate() {
            let (first, last) = (outline.half[0], outline.half[outline.half.len() - 1]);
            let (low, high) = (
                outlines.contact.root[i].min(outlines.contact.tip[i]),
                outlines.contact.tip[i].max(outlines.contact.root[i]),
            );
            assert!((first[0] / low - 1.0).abs() < 1e-12 && (last[0] / high - 1.0).abs() < 1e-12, "{i}");
            assert!(
                outline.half.windows(2).all(|pair| pair[1][0] >= pair[0][0] && pair[1][1] <= pair[0][1] + 1e-12),
                "{i}"
            );
        }
    }
    let pointed =
        Gears { profile_shift: [0.9, 0.0], addendum: [1.2, 1.0], dedendum: [1.25, 1.6], ..standard(14.0, 60.0) };
    assert_eq!(Outlines::of(&pointed).unwrap().gears[0].half.last().unwrap()[1], 0.0);
}
