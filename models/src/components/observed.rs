//! The outputs of the components of a drivetrain: quantities that a run can record.

use gearsim_derive::{Expr, Model};

/// The name of an output of a part: `mesh_force_12` for `mesh_force` of part `12`, `mesh_force` if the part has no name.
pub fn of_part(quantity: &str, part: &str) -> String {
    if part.is_empty() { quantity.into() } else { format!("{quantity}_{part}") }
}

/// Force, loss, deflection and dynamic transmission error of a mesh. `x` \[m\] is its deflection in contact. A damper parallel to the
/// flanks acts on `beside` \[m\]. `dte` \[m\] is the relative displacement of the ideal positions of the flanks along the line of action,
/// from all coordinates. The deflection is `dte` minus the transmission error `error` \[m\]. `driving` \[m\] is the displacement of the
/// first gear's flank along the line of action: the power that this gear transmits to the mesh is the force times the speed of this flank.
/// A train gives no `driving`: it computes this power from its rotors.
pub fn mesh(
    m: &mut Model,
    part: &str,
    what: &str,
    (x, beside): (Expr, Option<Expr>),
    [dte, error]: [Expr; 2],
    driving: Option<Expr>,
) {
    let dampers = || [x].into_iter().chain(beside);
    let damped = dampers().fold(Expr::from(0), |sum, x| sum + m.damper(x));
    let doc = format!(
        "force of the {what} along the line of action, damper included: positive if it presses the drive flanks"
    );
    let force = m.output(&of_part("mesh_force", part), "N", m.spring(x) + damped, &doc);
    if let Some(driving) = driving {
        let doc = format!("power that the first gear gives to the {what}: force times the speed of its flank");
        m.output(&of_part("mesh_power", part), "W", force * driving.dot(), &doc);
    }
    let doc = format!("deflection of the {what} along the line of action, backlash not taken off");
    m.output(&of_part("mesh_deflection", part), "m", dte - error, &doc);
    let doc = format!(
        "dynamic transmission error of the {what} along the line of action: positive if the driving gear is ahead"
    );
    m.output(&of_part("dte", part), "m", dte, &doc);
    let doc = format!("power that the damper of the {what} takes");
    let taken = dampers().fold(Expr::from(0), |sum, x| sum + m.damper(x) * x.dot());
    m.output(&of_part("mesh_loss", part), "W", taken, &doc);
}

/// Twist, torque and loss of a shaft with the deflection `twist` \[rad\], and the power that enters it at its first end. This end has the
/// rotation `first` \[rad\], and leads if the twist is positive. A train gives no `first`: it computes this power from its rotors.
pub fn shaft(m: &mut Model, part: &str, what: &str, twist: Expr, first: Option<Expr>) {
    m.output(&of_part("shaft_twist", part), "rad", twist, &format!("twist of the {what}"));
    let doc = format!("torque in the {what}, damper included");
    let torque = m.output(&of_part("shaft_torque", part), "N*m", m.spring(twist) + m.damper(twist), &doc);
    if let Some(first) = first {
        let doc = format!("power that enters the {what} at its first end: torque times the speed of that end");
        m.output(&of_part("shaft_power", part), "W", torque * first.dot(), &doc);
    }
    let doc = format!("power that the damper of the {what} takes");
    m.output(&of_part("shaft_loss", part), "W", m.damper(twist) * twist.dot(), &doc);
}

/// Components and magnitude of the force of a bearing that deflects by the named deflections `x` and `y` \[m\].
pub fn bearing(m: &mut Model, part: &str, what: &str, [x, y]: [Expr; 2]) {
    let taken = m.damper(x) * x.dot() + m.damper(y) * y.dot();
    let [x, y] = [("x", x), ("y", y)].map(|(axis, x)| {
        let name = format!("{}_{axis}", of_part("bearing_force", part));
        m.output(&name, "N", m.spring(x) + m.damper(x), &format!("force on the {what} along {axis}"))
    });
    m.output(
        &of_part("bearing_force", part),
        "N",
        (x.sq() + y.sq()).sqrt(),
        &format!("magnitude of the force on the {what}"),
    );
    let doc = format!("power that the damper of the {what} takes");
    m.output(&of_part("bearing_loss", part), "W", taken, &doc);
}

/// Deflection, force and loss of a thrust bearing that deflects by the named deflection `z` \[m\].
pub fn thrust_bearing(m: &mut Model, part: &str, what: &str, z: Expr) {
    let doc = format!("axial displacement of the rotor on the {what}, along the positive axis");
    m.output(&of_part("thrust_deflection", part), "m", z, &doc);
    let doc = format!("axial force on the {what}, damper included");
    m.output(&of_part("thrust_force", part), "N", m.spring(z) + m.damper(z), &doc);
    let doc = format!("power that the damper of the {what} takes");
    m.output(&of_part("thrust_loss", part), "W", m.damper(z) * z.dot(), &doc);
}

/// Speed of a rotor with the rotation `theta` \[rad\].
pub fn rotor(m: &mut Model, part: &str, what: &str, theta: Expr) {
    m.output(&of_part("rotor_speed", part), "rad/s", theta.dot(), &format!("rotational speed of the {what}"));
}

/// Components and magnitude of the force of a planet's bearing, along the named deflections `radial` and `tangential` \[m\].
pub fn planet_bearing(m: &mut Model, planet: &str, [radial, tangential]: [Expr; 2]) {
    let taken = m.damper(radial) * radial.dot() + m.damper(tangential) * tangential.dot();
    let [r, t] = [("radial", radial), ("tangential", tangential)].map(|(axis, x)| {
        let doc = format!("{axis} force on the bearing of planet {planet}");
        m.output(&format!("planet_bearing_force_{planet}_{axis}"), "N", m.spring(x) + m.damper(x), &doc)
    });
    let doc = format!("magnitude of the force on the bearing of planet {planet}");
    m.output(&format!("planet_bearing_force_{planet}"), "N", (r.sq() + t.sq()).sqrt(), &doc);
    let doc = format!("power that the damper of the bearing of planet {planet} takes");
    m.output(&format!("planet_bearing_loss_{planet}"), "W", taken, &doc);
}

/// Torque or force [`unit`] and loss of dry friction over the slip `x`, in scenes with `effect`. At rest the force is the reaction.
pub fn friction(m: &mut Model, effect: &str, part: &str, [what, unit]: [&str; 2], x: Expr) {
    let quantity = if unit == "N" { "friction_force" } else { "friction_torque" };
    let doc = format!("dry friction of the {what}, at rest too: positive against positive motion");
    m.output_with(effect, &of_part(quantity, part), unit, m.damper(x) + m.reaction(x), &doc);
    let doc = format!("power that the dry friction of the {what} takes");
    m.output_with(effect, &of_part("friction_loss", part), "W", m.damper(x) * x.dot(), &doc);
}

/// Torque and loss of a clutch whose driving side leads by `x` \[rad\], in scenes with `effect`. While the clutch is locked, its torque is the
/// reaction.
pub fn clutch(m: &mut Model, effect: &str, part: &str, what: &str, x: Expr) {
    let doc = format!("torque that the {what} gives to its driven side, locked, slipping or overrunning");
    m.output_with(effect, &of_part("clutch_torque", part), "N*m", m.damper(x) + m.reaction(x), &doc);
    let doc = format!("power that the {what} takes as it slips or drags");
    m.output_with(effect, &of_part("clutch_loss", part), "W", m.damper(x) * x.dot(), &doc);
}

/// Force [`unit`] and loss of the stops of a displacement `x` beyond them, in scenes with `effect`.
pub fn end_stop(m: &mut Model, effect: &str, part: &str, [what, unit]: [&str; 2], x: Expr) {
    let doc =
        format!("force of the stops on the {what}, damper included: positive if it pushes back from the upper one");
    m.output_with(effect, &of_part("stop_force", part), unit, m.spring(x) + m.damper(x), &doc);
    let doc = format!("power that the dampers of the stops of the {what} take");
    m.output_with(effect, &of_part("stop_loss", part), "W", m.damper(x) * x.dot(), &doc);
}
