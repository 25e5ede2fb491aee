//! A gear pair on elastic bearings: x, y and rotation of each gear.

use gearsim_derive::{GearData, Model, Start};

use crate::components::{
    Direction, Flanks, Gear, Sliding, bearing, damping, driven, external, external_sliding, loaded, mesh_in_plane,
    moving_centres, pair, planar_rotor, sliding_friction,
};

/// The line of centres, from the driving to the driven gear, is the x axis. The driving gear turns counterclockwise.
pub fn gear_pair_bearings(m: &mut Model) {
    m.title("a gear pair on bearings, with x, y and rotation of each gear");
    m.source(
        "standard plane model, e.g. Kahraman & Singh (1991), J. Sound Vib. 146(1); phase as Oh, Grosh & Barber (2005)",
    );

    let gears = pair(m, "", "1", "2");
    let angle = m.gear_data(GearData::PressureAngle, "alpha", Some(20f64.to_radians()), "pressure angle");
    let alpha = Direction { cos: m.constant("cos_a", angle.cos()), sin: m.constant("sin_a", angle.sin()) };
    let centre = |m: &mut Model, part: &str| {
        ["x", "y"].map(|axis| {
            m.coordinate(&format!("{axis}{part}"), "m", Start::Static, &format!("{axis} of the centre of gear {part}"))
        })
    };
    let (c1, c2) = (centre(m, "1"), centre(m, "2"));

    planar_rotor(m, "1", "driving gear", c1, gears.theta1);
    planar_rotor(m, "2", "driven gear", c2, gears.theta2);
    bearing(m, "1", "bearing of gear 1", c1);
    bearing(m, "2", "bearing of gear 2", c2);
    // Rolling does not deflect the mesh. Of the rotations only the relative motion s does, so u is s for the first gear and 0 for the
    // second. The lines of action are at the angles -alpha and alpha.
    let (one, two) = (Gear { x: c1[0], y: c1[1], u: gears.s }, Gear { x: c2[0], y: c2[1], u: 0.into() });
    let lines = [alpha.mirrored(), alpha];
    let apart = [c2[0] - c1[0], c2[1] - c1[1]];
    let bend = moving_centres(m, "12", apart, gears.sum_of_base_radii(), (angle, alpha));
    let [drive, coast] = lines.map(|line| external(one, line, two, line));
    let driving = lines.map(|line| one.across(line) + gears.u1);
    let mesh = mesh_in_plane(m, "12", "mesh", gears.theta, Flanks::of(drive, coast).bent(bend), driving);
    // The flanks slide when the gears turn relative to each other, and when their centres move across the line of action.
    let tangent = alpha.sin / alpha.cos;
    let [drive, coast] = [(lines[0], tangent), (lines[1], -tangent)].map(|(l, t)| external_sliding(one, l, two, l, t));
    let tau = mesh.on_flanks(drive, coast);
    let psi = gears.theta1 + gears.theta2;
    sliding_friction(m, "12", "mesh", "m", mesh, Sliding { phase: gears.theta, tau, psi });
    driven(m, "motor", "driving gear", gears.theta1);
    loaded(m, "load", "driven gear", gears.theta2);
    damping(m);
    m.motion("speed", "rad/s", &[(gears.theta, gears.n1)], "rotational speed of the driving gear");
}
