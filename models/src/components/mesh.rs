//! A gear mesh: V = k(phase) delta^2/2, with delta along the line of action.

use std::f64::consts::TAU;

use gearsim_derive::{Expr, Model, Stiffness, half};

use super::{Bend, damper, named, observed, play, play_in_plane, steps, transmission_error};

/// The two factors of the spring force of a mesh.
#[derive(Clone, Copy)]
pub struct Mesh {
    /// Stiffness while the flanks are in contact, 0 while they are not.
    pub stiffness: Expr,
    /// Deflection in contact: the relative displacement minus the transmission error and the edge of the backlash, if the mesh has them.
    pub delta: Expr,
    /// In a plane mesh 1 while its drive flanks are in contact, -1 while its coast flanks are, else 0. `None` in other meshes.
    pub flank: Option<Expr>,
}

impl Mesh {
    /// A quantity of a plane mesh, linear in the coordinates, that has one form on the drive flanks and another one on the coast flanks.
    pub fn on_flanks(&self, drive: Expr, coast: Expr) -> Expr {
        match self.flank {
            Some(flank) => half(drive + coast) + flank * half(drive - coast),
            None => drive,
        }
    }
}

/// The deflections of the flanks of a mesh \[m\] without play and transmission error: `mean` - `open` of the drive flanks, `mean` + `open` of the
/// coast flanks.
#[derive(Clone, Copy)]
pub struct Flanks {
    /// The mean of both.
    pub mean: Expr,
    /// Half the opening of the play by the motion of the gears' centres; `None` if these do not move.
    pub open: Option<Expr>,
}

impl Flanks {
    /// Both flanks have the same deflection.
    pub fn alike(delta: Expr) -> Flanks {
        Flanks { mean: delta, open: None }
    }

    /// The flanks have different lines of action. Their deflections along these lines are linear in the coordinates.
    pub fn of(drive: Expr, coast: Expr) -> Flanks {
        Flanks { mean: half(drive + coast), open: Some(half(coast - drive)) }
    }

    /// The same flanks with lines of action that turn, and a play that opens, as described in
    /// [`moving_centres`](mod@super::moving_centres).
    pub fn bent(self, bend: Bend) -> Flanks {
        Flanks { mean: self.mean - bend.turn, open: self.open.map(|open| open + bend.open) }
    }

    /// The deflection of the drive flanks.
    fn drive(self) -> Expr {
        self.open.map_or(self.mean, |open| self.mean - open)
    }
}

/// A mesh of two gears. `delta` \[m\] is their relative displacement along the line of action; it is linear in the coordinates. Declares the
/// stiffness law `k` [N/m] and the transmission error `e` \[m\], which are periodic in `phase` \[rad\] (one tooth pitch is 2 pi). Declares the
/// backlash `b` \[m\] along the line of action, and the effects `stiffness_step`, `rigid_kinematics`, `frozen_phase`, `transmission_error` and
/// `backlash`. `driving` \[m\] is the displacement of the first gear's flank, a part of `delta`. It gives the output of the power that the first
/// gear transmits to the mesh; without `driving` there is no such output.
pub fn mesh_with_play(
    m: &mut Model,
    part: &str,
    what: &str,
    phase: Expr,
    delta: Expr,
    driving: impl Into<Option<Expr>>,
) -> Mesh {
    meshing(m, part, what, phase, delta, [driving.into(), None])
}

/// A mesh as [`mesh_with_play`] with a viscous damper along the line of action, in the effect `viscous_friction`. The damper is parallel to
/// the flanks: it acts in contact and out of it. It acts on the rate of `delta`, not of `delta` minus the transmission error. Declares its
/// coefficient `c` \[N s/m\].
pub fn damped_mesh(m: &mut Model, part: &str, what: &str, phase: Expr, delta: Expr) -> Mesh {
    let beside = m.deflection(&named("beside", part), delta);
    let doc = format!("viscous damping of the {what} along the line of action: force per speed");
    damper(m, part, ["c", "N*s/m", &doc], &[beside]);
    meshing(m, part, what, phase, delta, [None, Some(beside)])
}

fn meshing(
    m: &mut Model,
    part: &str,
    what: &str,
    phase: Expr,
    delta: Expr,
    [driving, beside]: [Option<Expr>; 2],
) -> Mesh {
    let k = stiffness(m, part, what, phase);
    let error = error(m, part, what, phase);
    let gap = play(m, part, what, "m", delta - error);
    m.potential(half(k * gap.touch * gap.over.sq()));
    observed::mesh(m, part, what, (gap.over, beside), [delta, error], driving);
    Mesh { stiffness: k * gap.touch, delta: gap.over, flank: None }
}

/// A mesh as [`mesh_with_play`] whose gears' centres move in the plane, so that the drive flanks and the coast flanks have different lines
/// of action. `driving` \[m\] are the displacements of the first gear's drive flank and of its coast flank along these lines.
pub fn mesh_in_plane(m: &mut Model, part: &str, what: &str, phase: Expr, flanks: Flanks, driving: [Expr; 2]) -> Mesh {
    let k = stiffness(m, part, what, phase);
    let error = error(m, part, what, phase);
    let gap = play_in_plane(m, part, what, Flanks { mean: flanks.mean - error, ..flanks });
    m.potential(half(k * gap.touch * gap.over.sq()));
    let mesh = Mesh { stiffness: k * gap.touch, delta: gap.over, flank: gap.flank };
    let driving = mesh.on_flanks(driving[0], driving[1]);
    observed::mesh(m, part, what, (gap.over, None), [flanks.drive(), error], Some(driving));
    if let Some(open) = flanks.open {
        let doc = format!("half the opening of the play of the {what} by the motion of the gears' centres");
        m.output_with(&observed::of_part("backlash", part), &observed::of_part("play_opening", part), "m", open, &doc);
    }
    mesh
}

fn error(m: &mut Model, part: &str, what: &str, phase: Expr) -> Expr {
    let doc = format!("transmission error of the {what} along the line of action");
    transmission_error(m, [&named("e", part), part], "m", phase, TAU, &doc)
}

fn stiffness(m: &mut Model, part: &str, what: &str, phase: Expr) -> Expr {
    let doc = format!("stiffness of the {what} along the line of action");
    mesh_stiffness(m, &named("k", part), "N/m", phase, TAU, &doc).value
}

/// The law of a mesh stiffness [unit], periodic with one `pitch` of `phase`, and the effects that decide how it steps.
pub fn mesh_stiffness(m: &mut Model, name: &str, unit: &str, phase: Expr, pitch: f64, doc: &str) -> Stiffness {
    steps(m);
    m.stiffness_law(name, unit, phase, pitch, doc)
}
