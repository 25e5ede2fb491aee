//! The equations of a train, put together from those of its parts.
//!
//! A part is an element with a few coordinates x = R q, where q are the coordinates of the train. All properties that the derivation has
//! proved for the element hold in the coordinates x. T, V and D of the train are sums, so that F = sum of Rᵀ f, K = sum of Rᵀ k R, and the
//! gradient of a deflection is Rᵀ n. An element may have several coordinates, laws, switches, torques and outputs; their numbers in the
//! train are in its [`Part`](crate::train::Part). This module contains no equation of an element.

mod exact;
mod geometry;
mod linear;
mod observed;
mod placed;

use xprec::Df64;

use self::geometry::Geometry;
use self::linear::{Balance, ConstantParts, Inertias, Sparse};
use self::observed::{Observed, Observer, OfPart};
use self::placed::Placed;
use crate::engine::equations::{
    Deflection, Equations, ExactCells, Exit, Functions, Known, Source, Switching, mobility,
};
use crate::engine::vector::{Matrix, Vector};
use crate::model::Model;
use crate::scene::{Effects, Scene};
use crate::train::{Part, Train};
use gearsim_equations::LinearForces;

/// The elements of trains: description and functions of each.
pub struct Elements(pub &'static [(&'static Model, Functions)]);

impl Elements {
    /// The effects of a part's element.
    fn effects(&self, part: &Part, scene: &Scene) -> Effects {
        let is_named = |of: &Option<usize>| of.is_some_and(|of| scene.effects.contains(of));
        let named = part.effects.iter().enumerate().filter(|(_, of)| is_named(of)).map(|(i, _)| i);
        Effects::numbered(self.0[part.element].0, named)
    }
}

impl Source for Elements {
    fn equations(&self, scene: &Scene, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>> {
        let train = scene.train.as_ref()?;
        if !scene.effects.agree(scene.model) {
            return None;
        }
        let geometry = Geometry::<f64>::of(train, parameters);
        let part = |(part, rows): (&Part, &Matrix)| {
            let given = |i: &Option<usize>| i.map_or(0.0, |i| parameters[i]);
            let own: Vec<f64> = part.parameters.iter().map(given).collect();
            let of_laws: Vec<f64> = part.values[..part.laws].iter().map(|&i| mids[i]).collect();
            let (model, functions) = &self.0[part.element];
            let effects = self.effects(part, scene);
            let equations = (functions.equations)(&effects, &own, &of_laws)?;
            Some(Placed::new(part.clone(), &effects, model, equations, rows))
        };
        let parts: Option<Vec<Placed>> = train.parts.iter().zip(&geometry.rows).map(part).collect();
        let needs = |part: &Part, output: usize| self.0[part.element].0.outputs[output].known;
        Some(Box::new(Assembly::new(train, parts?, geometry, needs)))
    }

    fn exactly<'a>(&'a self, scene: &'a Scene, parameters: Vec<Df64>, mids: Vec<Df64>) -> Box<dyn ExactCells + 'a> {
        Box::new(exact::Cells::new(self, scene, parameters, mids))
    }
}

/// The equations of a train.
struct Assembly {
    n: usize,
    parts: Vec<Placed>,
    /// Parts whose forces are not linear with constant factors.
    varying: Vec<usize>,
    /// The other parts.
    linear: ConstantParts,
    inertias: Inertias,
    /// For each law, each switch and each deflection: its part, and its number there.
    laws: Vec<[usize; 2]>,
    switches: Vec<[usize; 2]>,
    deflections: Vec<[usize; 2]>,
    /// For each torque the same, and its work per displacement, without the part that varies.
    torques: Vec<([usize; 2], Sparse)>,
    /// The sum of the works of all torques. Torques in balance thus cancel before they are multiplied by a displacement.
    work: Sparse,
    outputs: Vec<Observed>,
    mass: Matrix,
    mobility: Matrix,
    motions: Vec<Vector>,
}

impl Assembly {
    /// `known`: whether an output of a part depends on reactions and powers.
    fn new(
        train: &Train,
        mut parts: Vec<Placed>,
        geometry: Geometry<f64>,
        known: impl Fn(&Part, usize) -> bool,
    ) -> Assembly {
        let n = train.coordinates.len();
        let [laws, torques, outputs] = train.counts;
        let mut of_laws = vec![[0; 2]; laws];
        let mut of_torques = vec![([0; 2], Sparse::of(std::iter::empty())); torques];
        let mut sums: Vec<Vec<OfPart>> = (0..outputs).map(|_| vec![]).collect();
        let (mut switches, mut deflections) = (vec![], vec![]);
        let mut mass = Matrix::zeros(n, n);
        let mut numbers = 0;
        for (i, placed) in parts.iter_mut().enumerate() {
            placed.place = numbers;
            numbers += placed.numbers();
            let part = &placed.part;
            part.values[..part.laws].iter().enumerate().for_each(|(j, &law)| of_laws[law] = [i, j]);
            part.torques.iter().enumerate().for_each(|(j, &torque)| of_torques[torque] = ([i, j], placed.work(j, n)));
            for (j, &output) in part.outputs.iter().enumerate() {
                sums[output].push(OfPart { part: i, output: j, known: known(part, j) });
            }
            for j in 0..part.switches {
                switches.push([i, j]);
                deflections.push([i, placed.equations.switched(j)]);
            }
            geometry::add(&mut mass, &placed.mass(), &placed.matrix);
        }
        let mut work = Balance::zero(n);
        of_torques.iter().for_each(|(_, of)| work.add(1.0, of));
        let sum = |mut parts: Vec<OfPart>| match parts.len() {
            1 => Observed::One(parts.remove(0)),
            _ => Observed::Sum(parts),
        };
        let mut observed: Vec<Observed> = sums.into_iter().map(sum).collect();
        for ((output, of, _), speed) in train.products.iter().zip(geometry.products) {
            observed[*output] = Observed::Product(*of, Sparse::of(speed.into_iter()));
        }
        for ((output, of, _), factor) in train.multiples.iter().zip(geometry.multiples) {
            observed[*output] = Observed::Multiple(*of, factor);
        }
        Assembly {
            n,
            varying: (0..parts.len()).filter(|&i| !parts[i].is_constant).collect(),
            linear: ConstantParts::of(n, parts.iter().filter(|p| p.is_constant).map(|p| (&*p.equations, &p.rows[..]))),
            inertias: Inertias::of(parts.iter().map(|p| (p.mass(), &p.matrix))),
            laws: of_laws,
            switches,
            deflections,
            torques: of_torques,
            work: Sparse::of(work.total().iter().copied()),
            outputs: observed,
            mobility: mobility(&mass),
            mass,
            motions: geometry.motions,
            parts,
        }
    }

    fn varying(&self) -> impl Iterator<Item = &Placed> {
        self.varying.iter().map(|&i| &self.parts[i])
    }

    fn nonlinear(&self) -> impl Iterator<Item = &Placed> {
        self.parts.iter().filter(|part| !part.is_linear)
    }

    /// The sum over `parts` of the matrices `of`, in the coordinates of the train.
    fn total<'a>(&self, parts: impl Iterator<Item = &'a Placed>, of: impl Fn(&Placed) -> Matrix) -> Matrix {
        let mut sum = Matrix::zeros(self.n, self.n);
        parts.for_each(|placed| geometry::add(&mut sum, &of(placed), &placed.matrix));
        sum
    }

    /// The sum of the constant loads of `parts`.
    fn load_of<'a>(&self, parts: impl Iterator<Item = &'a Placed>, k: &[f64]) -> Vector {
        let mut sum = Balance::zero(self.n);
        for p in parts {
            let own = p.equations.load(&p.values(k));
            p.rows.iter().zip(own.iter()).for_each(|(row, f)| sum.add(*f, row));
        }
        sum.total()
    }
}

impl Equations for Assembly {
    fn coordinates(&self) -> usize {
        self.n
    }

    fn kinetic(&self, _: &[f64], q_dot: &[f64]) -> f64 {
        self.inertias.kinetic(q_dot)
    }

    fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        let of = |part: &Placed| part.at_state([q, q, k], |equations, [x, _, k]| equations.potential(x, k));
        self.linear.potential(q) + self.varying().map(of).sum::<f64>()
    }

    fn dissipation(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        self.linear.dissipation(q_dot) + self.varying().map(|p| p.dissipation([q, q_dot, k])).sum::<f64>()
    }

    fn torque_work(&self, i: usize, dq: &[f64]) -> f64 {
        self.torques[i].1.dot(dq)
    }

    fn torque_power(&self, i: usize, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        let [part, torque] = self.torques[i].0;
        let p = &self.parts[part];
        p.equations.torque_power(torque, &p.at(q), &p.at(q_dot), &p.values(k))
    }

    fn has_power(&self, i: usize) -> bool {
        let [part, torque] = self.torques[i].0;
        self.parts[part].equations.has_power(torque)
    }

    fn output(&self, i: usize, q: &[f64], q_dot: &[f64], k: &[f64], known: &Known) -> f64 {
        Observer::new(self, [q, q_dot, k], known).output(i)
    }

    fn write_outputs(&self, which: &[usize], q: &[f64], q_dot: &[f64], k: &[f64], known: &Known, values: &mut [f64]) {
        if which.is_empty() {
            return;
        }
        let mut observer = Observer::new(self, [q, q_dot, k], known);
        which.iter().zip(values).for_each(|(&i, value)| *value = observer.output(i));
    }

    fn work(&self, dq: &[f64]) -> f64 {
        self.work.dot(dq)
    }

    fn write_force(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]) {
        self.linear.write_force(q, q_dot, force);
        for p in self.varying() {
            p.add_force([q, q_dot, k, dk], force);
        }
    }

    fn linear_forces(&self, k: &[f64]) -> Option<LinearForces> {
        let linear = || self.parts.iter().filter(|part| part.is_linear);
        let stiffness = self.total(linear(), |p| p.equations.stiffness(&p.values(k)));
        let damping = self.total(linear(), |p| p.equations.damping(&p.values(k)));
        Some(LinearForces::new(&self.load_of(linear(), k), &stiffness, &damping))
    }

    fn add_other_forces(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], force: &mut [f64]) {
        self.nonlinear().for_each(|part| part.add_force([q, q_dot, k, dk], force));
    }

    fn other_dissipation(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        self.nonlinear().map(|p| p.dissipation([q, q_dot, k])).sum()
    }

    fn jacobian(&self, q: &[f64], q_dot: &[f64], k: &[f64], dk: &[f64], ddk: &[f64]) -> [Matrix; 2] {
        let mut sums = [Matrix::zeros(self.n, self.n), Matrix::zeros(self.n, self.n)];
        for p in &self.parts {
            let (x, x_dot, values) = (p.at(q), p.at(q_dot), p.values(k));
            let own = p.equations.jacobian(&x, &x_dot, &values, &p.slopes(dk), &p.slopes(ddk));
            sums.iter_mut().zip(&own).for_each(|(sum, own)| geometry::add(sum, own, &p.matrix));
        }
        sums
    }

    fn mass(&self, _: &[f64]) -> Matrix {
        self.mass.clone()
    }

    fn mobility(&self, _: &[f64]) -> Matrix {
        self.mobility.clone()
    }

    fn damping(&self, k: &[f64]) -> Matrix {
        self.total(self.parts.iter(), |p| p.equations.damping(&p.values(k)))
    }

    fn stiffness(&self, k: &[f64]) -> Matrix {
        self.total(self.parts.iter(), |p| p.equations.stiffness(&p.values(k)))
    }

    fn load(&self, k: &[f64]) -> Vector {
        self.load_of(self.parts.iter(), k)
    }

    fn motion(&self, i: usize) -> Vector {
        self.motions[i].clone()
    }

    fn switching(&self, law: usize) -> Switching {
        let [part, own] = self.laws[law];
        self.parts[part].equations.switching(own)
    }

    fn normal(&self, law: usize) -> Vector {
        let [part, own] = self.laws[law];
        let p = &self.parts[part];
        p.spread(&p.equations.normal(own), self.n)
    }

    fn compliance(&self, law: usize, _: &[f64]) -> f64 {
        let n = self.normal(law);
        n.dot(&(&self.mobility * &n))
    }

    fn direction(&self, law: usize, _: &[f64]) -> Vector {
        let n = self.normal(law);
        let d = &self.mobility * &n;
        let g = n.dot(&d);
        d.map(|x| x / g)
    }

    fn step(&self, law: usize, q: &[f64], k: &[f64], dk: f64) -> f64 {
        let [part, own] = self.laws[law];
        let p = &self.parts[part];
        p.equations.step(own, &p.at(q), &p.values(k), dk)
    }

    fn mode(&self, i: usize, mode: usize) -> Option<Vec<f64>> {
        let [part, own] = self.switches[i];
        self.parts[part].equations.mode(own, mode)
    }

    fn exits(&self, i: usize, mode: usize, q: &[f64], k: &[f64]) -> Vec<Exit> {
        let [part, own] = self.switches[i];
        let p = &self.parts[part];
        let exits = p.equations.exits(own, mode, &p.at(q), &p.values(k));
        exits.into_iter().map(|exit| Exit { guard: p.affine(exit.guard, self.n), ..exit }).collect()
    }

    fn lost(&self, i: usize, k: &[f64]) -> [f64; 2] {
        let [part, own] = self.switches[i];
        let p = &self.parts[part];
        p.equations.lost(own, &p.values(k))
    }

    fn switched(&self, i: usize) -> usize {
        i
    }

    fn deflection(&self, i: usize, q: &[f64], k: &[f64]) -> Deflection {
        let [part, own] = self.deflections[i];
        let p = &self.parts[part];
        let of = p.equations.deflection(own, &p.at(q), &p.values(k));
        let errors = of.errors.iter().map(|&(law, unit)| (p.part.values[law], unit)).collect();
        Deflection { normal: p.spread(&of.normal, self.n), errors, ..of }
    }
}
