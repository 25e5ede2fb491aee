//! Saltation matrices: the effect of an event on a small disturbance z = (dq, dq').
//!
//! At an event the state x changes by a map R, x+ = R(x-), where the guard g(x) is zero. With the rates f- and f+ of x on both sides
//!
//! ```text
//! S = DR + (f+ - DR f-) grad g / (grad g . f-)
//! ```
//!
//! (M. di Bernardo et al., Piecewise-smooth Dynamical Systems, 2008, Sec. 2.5). R is the identity at exits of switches and where a law
//! steps without an impulse. At a step of a stiffness it is the jump rule, v+ = v- + d (w - n.v-) with m = M⁻¹n, G = n.m, d = m/G and w² =
//! (n.v-)² - 2 G dV. All of these depend on q: dG = n.dm, dm = -M⁻¹ d(M m), dw = (n.v- n.dv- - dV dG - G d(dV))/w.

use nalgebra::{DMatrix, DVector, RowDVector};

use crate::engine::equations::Switching;
use crate::engine::hybrid::Hybrid;
use crate::engine::motion::End;
use crate::engine::switch::Guards;
use crate::engine::vector::{Vector, dot};

/// The event at which a motion ends.
#[derive(Debug, Clone)]
pub struct Event {
    /// Gradient of the guard by coordinates and speeds (n each).
    guard: [Vector; 2],
    /// Whether the speeds change.
    impulse: bool,
    /// Coordinates, speeds and accelerations before it (n each).
    before: [Vector; 3],
    /// Values of laws and switches, and slopes of the laws, before it.
    values: [Vec<f64>; 2],
}

impl Event {
    /// The event at the end of a motion, in the state (q, v, a) = `before` with these values and slopes of laws. `None` if the state and
    /// its rate do not change at the event, or if the event is at a given time.
    ///
    /// # Errors
    /// In words, if the event holds or releases a phase or a deflection.
    pub fn at(
        now: &Hybrid<'_>,
        end: End,
        before: [Vector; 3],
        values: [Vec<f64>; 2],
    ) -> Result<Option<Event>, &'static str> {
        match end {
            End::Open | End::Run | End::Breakpoint => Ok(None),
            End::Hold(..) | End::Loose(..) => Err("a phase or a deflection is held"),
            End::Step(i, _) if now.laws[i].next_switch().is_some() => Ok(None),
            End::Step(i, _) => {
                let law = &now.laws[i];
                let guard = [law.surface.normal.clone(), Vector::zeros(law.surface.normal.len())];
                let impulse = law.switching == Switching::WithJump;
                Ok(Some(Event { guard, impulse, before, values }))
            }
            End::Exit(i, which) => {
                let guards = Guards::of(now.equations, &now.switches, &before[0], &values[0]);
                let exit = &guards.exits[i][which].guard;
                let mut on_q = exit.on_q.clone();
                // A transmission error that is a curve moves the guard with its phase.
                for (law, unit) in &exit.errors {
                    on_q.add_times(unit * values[1][*law], &now.laws[*law].surface.normal);
                }
                Ok(Some(Event { guard: [on_q, exit.on_speed.clone()], impulse: false, before, values }))
            }
        }
    }

    /// S (2n x 2n); `now` is the state after the event, with these slopes of the laws and accelerations.
    ///
    /// # Errors
    /// In words, if the motion only grazes the guard.
    pub fn saltation(
        &self,
        now: &Hybrid<'_>,
        slopes: &[f64],
        acceleration: &Vector,
        frictions: &[usize],
    ) -> Result<DMatrix<f64>, &'static str> {
        let [q, v, a] = &self.before;
        let n = q.len();
        let after = &now.state.q_dot;
        let mut map = DMatrix::identity(2 * n, 2 * n);
        if self.impulse {
            let [by_q, by_speed] = self.impulse_by(now, slopes, frictions);
            map.view_mut((n, 0), (n, n)).copy_from(&by_q);
            map.view_mut((n, n), (n, n)).copy_from(&by_speed);
        }
        let joined = |a: &Vector, b: &Vector| DVector::from_fn(2 * n, |i, _| if i < n { a[i] } else { b[i - n] });
        let (gradient, rate) = (joined(&self.guard[0], &self.guard[1]), joined(v, a));
        let along = gradient.dot(&rate);
        if along == 0.0 || !along.is_finite() {
            return Err("the motion only grazes a step or a flank");
        }
        let apart = (joined(after, acceleration) - &map * &rate) / along;
        Ok(map + apart * gradient.transpose())
    }

    /// The derivatives of the speeds after an impulse by coordinates and by speeds before it (n x n each).
    fn impulse_by(&self, now: &Hybrid<'_>, slopes: &[f64], frictions: &[usize]) -> [DMatrix<f64>; 2] {
        let (equations, [q, v, _]) = (now.equations, &self.before);
        let n = q.len();
        let normal = &self.guard[0];
        let mobility = equations.mobility(q);
        let m = &mobility * normal;
        let g = dot(normal, &m);
        let column = |x: &Vector| DVector::from(x);
        let (normal_column, direction) = (column(normal), column(&m) / g);
        let (before, after) = (dot(normal, v), dot(normal, &now.state.q_dot));
        let dv = (before * before - after * after) / (2.0 * g);
        // dm/dq, dG/dq (a row), and the gradient of dV (a row).
        let m_by = -&mobility * equations.inertia(q, &m);
        let g_by = normal_column.transpose() * &m_by;
        let near = potential_force(now, q, (&self.values[0], &self.values[1]), frictions);
        let far = potential_force(now, q, (&now.k, slopes), frictions);
        let dv_by = (column(&near) - column(&far)).transpose();
        let direction_by = (m_by - &direction * &g_by) / g;
        // The derivatives of w by coordinates and by speeds. In a transmission w² = (n.v-)² - 2 G dV, in a reflection w = -n.v-.
        let (w_by_q, w_by_v) = if before * after < 0.0 {
            (RowDVector::zeros(n), -normal_column.transpose())
        } else {
            ((&g_by * -dv - dv_by * g) / after, normal_column.transpose() * (before / after))
        };
        let by_q = direction_by * (after - before) + &direction * w_by_q;
        let by_speed = DMatrix::identity(n, n) + &direction * (w_by_v - normal_column.transpose());
        [by_q, by_speed]
    }
}

/// The forces that have a potential at `q` (n): those at rest, without the laws of friction and without dissipative forces of switches.
fn potential_force(now: &Hybrid<'_>, q: &Vector, (k, slopes): (&[f64], &[f64]), frictions: &[usize]) -> Vector {
    let equations = now.equations;
    let (mut k, at_rest) = (k.to_vec(), Vector::zeros(q.len()));
    frictions.iter().for_each(|law| k[*law] = 0.0);
    let mut force = equations.force(q, &at_rest, &k, slopes);
    for switch in &now.switches {
        let [constant, slope] = equations.lost(switch.index, &k);
        let x = equations.deflection(equations.switched(switch.index), q, &k);
        force.add_times(constant + slope * x.value(q, &k), &x.normal);
    }
    force
}
