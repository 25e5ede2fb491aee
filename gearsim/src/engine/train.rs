//! The equations of a train, put together from those of its parts.
//!
//! A part is an element with a few coordinates x = R q, where q are the coordinates of the train. All that the derivation has proved of
//! the element holds along these: T, V and D are sums, so that F = sum of Rᵀ f, K = sum of Rᵀ k R, and the gradient of a deflection is Rᵀ n.
//! An element may have several coordinates, laws, switches, torques and outputs; their numbers in the train are in its
//! [`Part`](crate::train::Part). This module contains no equation of an element.

mod exact;
mod geometry;
mod linear;

use xprec::Df64;

use self::geometry::Geometry;
use self::linear::{Linear, Sparse};
use crate::engine::equations::{
    Affine, Deflection, Equations, ExactCells, Exit, Functions, Known, Source, Switching, mobility,
};
use crate::engine::linear_forces::LinearForces;
use crate::engine::vector::{Matrix, Vector};
use crate::model::Model;
use crate::scene::{Effects, Scene};
use crate::train::{Part, Train};

/// The elements of trains: description and functions of each.
pub struct Elements(pub &'static [(&'static Model, Functions)]);

impl Elements {
    /// The bits of an element's effects.
    fn effects(part: &Part, scene: &Scene) -> Effects {
        Effects(part.effects.iter().enumerate().map(|(i, &of)| u64::from(scene.effects.contains(of)) << i).sum())
    }
}

impl Source for Elements {
    fn equations(&self, scene: &Scene, parameters: &[f64], mids: &[f64]) -> Option<Box<dyn Equations>> {
        let train = scene.train.as_ref()?;
        if !scene.model.admits(scene.effects.0) {
            return None;
        }
        let geometry = Geometry::<f64>::of(train, parameters);
        let part = |(part, rows): (&Part, &Matrix)| {
            let given = |i: &Option<usize>| i.map_or(0.0, |i| parameters[i]);
            let own: Vec<f64> = part.parameters.iter().map(given).collect();
            let of_laws: Vec<f64> = part.values[..part.laws].iter().map(|&i| mids[i]).collect();
            let (model, functions) = &self.0[part.element];
            let effects = Elements::effects(part, scene);
            let equations = (functions.equations)(effects.0, &own, &of_laws)?;
            Some(Placed::new(part.clone(), effects, model, equations, rows))
        };
        let parts: Option<Vec<Placed>> = train.parts.iter().zip(&geometry.rows).map(part).collect();
        Some(Box::new(Assembly::new(train, parts?, geometry)))
    }

    fn exactly<'a>(&'a self, scene: &'a Scene, parameters: Vec<Df64>, mids: Vec<Df64>) -> Box<dyn ExactCells + 'a> {
        Box::new(exact::Cells::new(self, scene, parameters, mids))
    }
}

/// Largest numbers of coordinates and values of an element whose forces are computed in arrays of fixed length.
const COORDINATES: usize = 3;
const VALUES: usize = 8;

/// A part with its equations.
struct Placed {
    part: Part,
    equations: Box<dyn Equations>,
    /// R.
    rows: Vec<Sparse>,
    /// R as a matrix, for sums of matrices.
    matrix: Matrix,
    /// Whether its forces are linear in x and x', with constant factors.
    is_constant: bool,
    /// Whether they are linear while the values of its laws and switches do not change.
    is_linear: bool,
}

impl Placed {
    fn new(part: Part, effects: Effects, model: &Model, equations: Box<dyn Equations>, rows: &Matrix) -> Placed {
        let is_linear = effects.nonlinear(model).is_empty();
        let is_constant = is_linear && model.laws.is_empty() && model.switches.is_empty();
        let of_row = |i| Sparse::of(rows.row(i).iter().copied());
        let sparse = (0..rows.nrows()).map(of_row).collect();
        Placed { part, equations, rows: sparse, matrix: rows.clone(), is_constant, is_linear }
    }

    /// Its coordinates, or their rates.
    #[inline]
    fn at(&self, q: &[f64]) -> Vector {
        Vector::from_fn(self.rows.len(), |i| self.rows[i].dot(q))
    }

    /// The values of its laws and symbols.
    #[inline]
    fn values(&self, k: &[f64]) -> Vector {
        Vector::from_fn(self.part.values.len(), |i| k[self.part.values[i]])
    }

    /// The derivatives of its laws; absent ones are zero.
    #[inline]
    fn slopes(&self, dk: &[f64]) -> Vector {
        Vector::from_fn(self.part.laws, |i| dk.get(self.part.values[i]).copied().unwrap_or(0.0))
    }

    /// Adds its forces. It is called at every step; small elements therefore use arrays of fixed length.
    #[inline]
    fn add_force(&self, [q, q_dot, k, dk]: [&[f64]; 4], force: &mut [f64]) {
        let (n, values, laws) = (self.rows.len(), &self.part.values[..], self.part.laws);
        if n > COORDINATES || values.len() > VALUES {
            let mut own = Vector::zeros(n);
            self.equations.write_force(&self.at(q), &self.at(q_dot), &self.values(k), &self.slopes(dk), &mut own);
            self.rows.iter().zip(own.iter()).for_each(|(row, f)| row.add_to(*f, force));
            return;
        }
        let (mut x, mut x_dot, mut own) = ([0.0; COORDINATES], [0.0; COORDINATES], [0.0; COORDINATES]);
        let (mut of_k, mut of_dk) = ([0.0; VALUES], [0.0; VALUES]);
        for (i, row) in self.rows.iter().enumerate() {
            (x[i], x_dot[i]) = row.dot_both(q, q_dot);
        }
        values.iter().zip(&mut of_k).for_each(|(&i, x)| *x = k[i]);
        values[..laws].iter().zip(&mut of_dk).for_each(|(&i, x)| *x = dk.get(i).copied().unwrap_or(0.0));
        self.equations.write_force(&x[..n], &x_dot[..n], &of_k[..values.len()], &of_dk[..laws], &mut own[..n]);
        for (row, f) in self.rows.iter().zip(own).filter(|(_, f)| *f != 0.0) {
            row.add_to(f, force);
        }
    }

    /// Converts a gradient from its coordinates to those of the train.
    fn spread(&self, gradient: &Vector, n: usize) -> Vector {
        let mut sum = Vector::zeros(n);
        self.rows.iter().zip(gradient.iter()).for_each(|(row, x)| row.add_to(*x, &mut sum));
        sum
    }

    fn affine(&self, of: Affine, n: usize) -> Affine {
        let errors = of.errors.iter().map(|&(law, unit)| (self.part.values[law], unit)).collect();
        let (on_q, on_speed) = (self.spread(&of.on_q, n), self.spread(&of.on_speed, n));
        Affine { errors, on_q, on_speed, ..of }
    }
}

/// The equations of a train.
struct Assembly {
    n: usize,
    parts: Vec<Placed>,
    /// Parts whose forces are not linear with constant factors.
    varying: Vec<usize>,
    /// The other parts.
    linear: Linear,
    /// For each law, each switch, each deflection and each torque: its part, and its number there.
    laws: Vec<[usize; 2]>,
    switches: Vec<[usize; 2]>,
    deflections: Vec<[usize; 2]>,
    torques: Vec<[usize; 2]>,
    /// For each output, the outputs of parts of which it is the sum.
    outputs: Vec<Vec<[usize; 2]>>,
    /// The outputs that are products: the output, another output, and the form of the speeds with which that is multiplied.
    products: Vec<(usize, usize, Vector)>,
    /// The outputs that are multiples: the output, another output, and the factor.
    multiples: Vec<(usize, usize, f64)>,
    mass: Matrix,
    mobility: Matrix,
    motions: Vec<Vector>,
}

impl Assembly {
    fn new(train: &Train, parts: Vec<Placed>, geometry: Geometry<f64>) -> Assembly {
        let n = train.coordinates.len();
        let [laws, torques, outputs] = train.counts;
        let (mut of_laws, mut of_torques) = (vec![[0; 2]; laws], vec![[0; 2]; torques]);
        let mut of_outputs = vec![vec![]; outputs];
        let (mut switches, mut deflections) = (vec![], vec![]);
        let mut mass = Matrix::zeros(n, n);
        for (i, placed) in parts.iter().enumerate() {
            let part = &placed.part;
            part.values[..part.laws].iter().enumerate().for_each(|(j, &law)| of_laws[law] = [i, j]);
            part.torques.iter().enumerate().for_each(|(j, &torque)| of_torques[torque] = [i, j]);
            part.outputs.iter().enumerate().for_each(|(j, &output)| of_outputs[output].push([i, j]));
            for j in 0..part.switches {
                switches.push([i, j]);
                deflections.push([i, placed.equations.switched(j)]);
            }
            geometry::add(&mut mass, &placed.equations.mass(&Vector::zeros(placed.rows.len())), &placed.matrix);
        }
        let linear = Linear::of(n, parts.iter().filter(|p| p.is_constant).map(|p| (&*p.equations, &p.rows[..])));
        let varying = (0..parts.len()).filter(|&i| !parts[i].is_constant).collect();
        let mobility = mobility(&mass);
        let speeds = geometry.products.into_iter().map(|row| Vector::from_fn(n, |i| row[i]));
        let products =
            train.products.iter().zip(speeds).map(|((output, of, _), speed)| (*output, *of, speed)).collect();
        let multiples = train.multiples.iter().zip(&geometry.multiples);
        let multiples = multiples.map(|((output, of, _), factor)| (*output, *of, *factor)).collect();
        Assembly {
            n,
            parts,
            varying,
            linear,
            laws: of_laws,
            switches,
            deflections,
            torques: of_torques,
            outputs: of_outputs,
            products,
            multiples,
            mass,
            mobility,
            motions: geometry.motions,
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
        parts.fold(Vector::zeros(self.n), |mut sum, p| {
            let own = p.equations.load(&p.values(k));
            p.rows.iter().zip(own.iter()).for_each(|(row, f)| row.add_to(*f, &mut sum));
            sum
        })
    }
}

impl Equations for Assembly {
    fn coordinates(&self) -> usize {
        self.n
    }

    fn kinetic(&self, q: &[f64], q_dot: &[f64]) -> f64 {
        self.parts.iter().map(|p| p.equations.kinetic(&p.at(q), &p.at(q_dot))).sum()
    }

    fn potential(&self, q: &[f64], k: &[f64]) -> f64 {
        self.linear.potential(q) + self.varying().map(|p| p.equations.potential(&p.at(q), &p.values(k))).sum::<f64>()
    }

    fn dissipation(&self, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        let varying = self.varying().map(|p| p.equations.dissipation(&p.at(q), &p.at(q_dot), &p.values(k)));
        self.linear.dissipation(q_dot) + varying.sum::<f64>()
    }

    fn torque_work(&self, i: usize, dq: &[f64]) -> f64 {
        let [part, torque] = self.torques[i];
        self.parts[part].equations.torque_work(torque, &self.parts[part].at(dq))
    }

    fn torque_power(&self, i: usize, q: &[f64], q_dot: &[f64], k: &[f64]) -> f64 {
        let [part, torque] = self.torques[i];
        let p = &self.parts[part];
        p.equations.torque_power(torque, &p.at(q), &p.at(q_dot), &p.values(k))
    }

    fn has_powers(&self) -> bool {
        self.parts.iter().any(|p| p.equations.has_powers())
    }

    fn output(&self, i: usize, q: &[f64], q_dot: &[f64], k: &[f64], known: &Known) -> f64 {
        if let Some((_, of, speed)) = self.products.iter().find(|product| product.0 == i) {
            return self.output(*of, q, q_dot, k, known) * speed.dot(q_dot);
        }
        if let Some((_, of, factor)) = self.multiples.iter().find(|multiple| multiple.0 == i) {
            return factor * self.output(*of, q, q_dot, k, known);
        }
        let of = |&[part, output]: &[usize; 2]| {
            let p = &self.parts[part];
            let switches = self.switches.iter().enumerate().filter(|(_, of)| of[0] == part);
            let own = Known {
                reactions: switches.map(|(switch, _)| known.reaction(switch)).collect(),
                powers: p.part.torques.iter().map(|&torque| known.power(torque)).collect(),
            };
            p.equations.output(output, &p.at(q), &p.at(q_dot), &p.values(k), &own)
        };
        self.outputs[i].iter().map(of).sum()
    }

    fn work(&self, dq: &[f64]) -> f64 {
        let driven = self.parts.iter().filter(|p| !p.part.torques.is_empty());
        driven.map(|p| p.equations.work(&p.at(dq))).sum()
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
        self.nonlinear().map(|p| p.equations.dissipation(&p.at(q), &p.at(q_dot), &p.values(k))).sum()
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
