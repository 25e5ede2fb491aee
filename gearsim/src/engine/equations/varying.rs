//! The equations of a scene with parameters that vary in time and whose factors depend on the state. Examples are the demand on a motor
//! whose torque falls with its speed, and the capacity of a clutch.
//!
//! Forces, guards, losses and outputs are linear in such a parameter p. With its value p_0 at the start and another one p_1,
//!
//! ```text
//! X(p) = X(p_0) + s (X(p_1) - X(p_0)),     s = (p - p_0)/(p_1 - p_0).
//! ```
//!
//! p_1 is the value of the time history that is farthest from p_0: then s is at most 1, and rounding errors do not grow. The shares s of
//! all such parameters follow the values of laws and symbols in `k`; those that are not given are 0. Everything else does not depend on p.

use super::{Affine, Deflection, Equations, Exit, Known, Source, Switching};
use crate::engine::vector::{Matrix, Vector};
use crate::scene::{Scene, TimeHistory};

/// The equations of a scene with such parameters.
pub struct Varying {
    /// The equations with p_0 of all parameters.
    start: Box<dyn Equations>,
    /// Those with p_1 of one parameter each.
    farthest: Vec<Box<dyn Equations>>,
    /// Number of the values of laws and symbols.
    values: usize,
}

/// The parameters of a scene that vary in time and make its cells nonlinear, in the order of their shares.
pub fn varying_by_steps(scene: &Scene) -> impl Iterator<Item = &(usize, TimeHistory)> {
    let varying = scene.time_histories.iter().filter(|(_, history)| !history.is_constant());
    varying.filter(|(p, _)| {
        let parameter = &scene.model.parameters[*p];
        parameter.varies.by_steps() && scene.effects.activate(parameter.with, scene.model)
    })
}

impl Varying {
    /// The equations of a scene, of which `start` are those at its start; `None` if its effects contradict one another.
    pub fn of(
        start: Box<dyn Equations>,
        source: &dyn Source,
        scene: &Scene,
        mids: &[f64],
    ) -> Option<Box<dyn Equations>> {
        let farthest = varying_by_steps(scene).map(|(p, history)| {
            let mut values = scene.parameters.clone();
            values[*p] = history.farthest();
            source.equations(scene, &values, mids)
        });
        let farthest: Vec<_> = farthest.collect::<Option<_>>()?;
        let values = scene.model.in_contact([]).len();
        Some(if farthest.is_empty() { start } else { Box::new(Varying { start, farthest, values }) })
    }

    /// The value of `of` with the present values of the parameters; `add(x, s, a, b)` adds s (a - b) to x.
    fn now<T: Clone>(&self, k: &[f64], of: impl Fn(&dyn Equations) -> T, add: impl Fn(&mut T, f64, &T, &T)) -> T {
        let start = of(&*self.start);
        let shares = k.get(self.values..).unwrap_or_default().iter();
        let present = shares.zip(&self.farthest).filter(|(share, _)| **share != 0.0);
        present.fold(start.clone(), |mut sum, (share, farthest)| {
            add(&mut sum, *share, &of(&**farthest), &start);
            sum
        })
    }

    fn number(&self, k: &[f64], of: impl Fn(&dyn Equations) -> f64) -> f64 {
        self.now(k, of, add)
    }

    fn vector(&self, k: &[f64], of: impl Fn(&dyn Equations) -> Vector) -> Vector {
        self.now(k, of, |sum, share, there, start| sum.add_times(share, &(there - start)))
    }
}

fn add(sum: &mut f64, share: f64, there: &f64, start: &f64) {
    *sum += share * (there - start);
}

fn add_all(sum: &mut [f64], share: f64, there: &[f64], start: &[f64]) {
    sum.iter_mut().zip(there).zip(start).for_each(|((sum, there), start)| add(sum, share, there, start));
}

/// Adds `share` times the difference of two guards. Both depend on the same transmission errors.
fn add_guard(sum: &mut Affine, share: f64, there: &Affine, start: &Affine) {
    add(&mut sum.constant, share, &there.constant, &start.constant);
    for ((sum, there), start) in sum.errors.iter_mut().zip(&there.errors).zip(&start.errors) {
        add(&mut sum.1, share, &there.1, &start.1);
    }
    add_all(&mut sum.on_q, share, &there.on_q, &start.on_q);
    add_all(&mut sum.on_speed, share, &there.on_speed, &start.on_speed);
    add(&mut sum.on_reaction, share, &there.on_reaction, &start.on_reaction);
}

impl Equations for Varying {
    fn write_force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]) {
        force.copy_from_slice(&self.vector(k, |e| e.force(q, q_dot, k, dk)));
    }

    fn jacobian(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], ddk: &[f64]) -> [Matrix; 2] {
        self.now(
            k,
            |e| e.jacobian(q, q_dot, k, dk, ddk),
            |sum, share, there, start| {
                for i in 0..2 {
                    sum[i] += (&there[i] - &start[i]) * share;
                }
            },
        )
    }

    fn torque_power(&self, i: usize, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        self.number(k, |e| e.torque_power(i, q, q_dot, k))
    }

    fn output(&self, i: usize, q: &[f64], q_dot: &[f64], k: &[f64], known: &Known) -> f64 {
        self.number(k, |e| e.output(i, q, q_dot, k, known))
    }

    fn load(&self, k: &[f64]) -> Vector {
        self.vector(k, |e| e.load(k))
    }

    fn exits(&self, i: usize, mode: usize, q: &[f64], k: &[f64]) -> Vec<Exit> {
        self.now(
            k,
            |e| e.exits(i, mode, q, k),
            |sum, share, there, start| {
                for ((sum, there), start) in sum.iter_mut().zip(there).zip(start) {
                    add_guard(&mut sum.guard, share, &there.guard, &start.guard);
                }
            },
        )
    }

    fn lost(&self, i: usize, k: &[f64]) -> [f64; 2] {
        self.now(k, |e| e.lost(i, k), |sum, share, there, start| add_all(sum, share, there, start))
    }

    // The following quantities do not depend on these parameters.

    fn coordinates(&self) -> usize {
        self.start.coordinates()
    }
    fn kinetic(&self, q: &[f64], q_dot: &[f64]) -> f64 {
        self.start.kinetic(q, q_dot)
    }
    fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        self.start.potential(q, k)
    }
    fn dissipation(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        self.start.dissipation(q, q_dot, k)
    }
    fn torque_work(&self, i: usize, dq: &[f64]) -> f64 {
        self.start.torque_work(i, dq)
    }
    fn has_power(&self, i: usize) -> bool {
        self.start.has_power(i)
    }
    fn work(&self, dq: &[f64]) -> f64 {
        self.start.work(dq)
    }
    fn is_inertia_constant(&self) -> bool {
        self.start.is_inertia_constant()
    }
    fn mass(&self, q: &[f64]) -> Matrix {
        self.start.mass(q)
    }
    fn inertia(&self, q: &[f64], q_ddot: &[f64]) -> Matrix {
        self.start.inertia(q, q_ddot)
    }
    fn mobility(&self, q: &[f64]) -> Matrix {
        self.start.mobility(q)
    }
    fn damping(&self, k: &[f64]) -> Matrix {
        self.start.damping(k)
    }
    fn stiffness(&self, k: &[f64]) -> Matrix {
        self.start.stiffness(k)
    }
    fn motion(&self, i: usize) -> Vector {
        self.start.motion(i)
    }
    fn switching(&self, law: usize) -> Switching {
        self.start.switching(law)
    }
    fn normal(&self, law: usize) -> Vector {
        self.start.normal(law)
    }
    fn compliance(&self, law: usize, q: &[f64]) -> f64 {
        self.start.compliance(law, q)
    }
    fn direction(&self, law: usize, q: &[f64]) -> Vector {
        self.start.direction(law, q)
    }
    fn step(&self, law: usize, q: &[f64], k: &[f64], dk: f64) -> f64 {
        self.start.step(law, q, k, dk)
    }
    fn mode(&self, i: usize, mode: usize) -> Option<Vec<f64>> {
        self.start.mode(i, mode)
    }
    fn switched(&self, i: usize) -> usize {
        self.start.switched(i)
    }
    fn deflection(&self, i: usize, q: &[f64], k: &[f64]) -> Deflection {
        self.start.deflection(i, q, k)
    }
    fn bends(&self) -> bool {
        self.start.bends()
    }
}
