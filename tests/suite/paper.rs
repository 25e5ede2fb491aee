//! The equations of Oh, Grosh & Barber (2005), written by hand as symbolic expressions, with their equation numbers.
//!
//! Everything is written in the parameters; nothing here uses the derivation's own M1, M2 or C. Damping is Rayleigh's, D = C phi'^2,
//! so it is in Eq. (3) too. The paper prints it in Eq. (2) alone, which would change the total momentum.

#![allow(non_snake_case)] // the paper's symbols

use gearsim_derive::{Expr, Model, Range, Start};

/// The symbols of the gear pair, as its model declares them.
pub struct Paper {
    N1: Expr,
    N2: Expr,
    I1: Expr,
    I2: Expr,
    zeta: Expr,
    T0: Expr,
    phi: Expr,
    k: Expr,
    /// Slope of k within a cell, or its step between two cells.
    dk: Expr,
    /// k0 = (k1 + k2)/2, Eq. (14)
    k0: Expr,
}

impl Paper {
    /// Declares the symbols.
    pub fn new() -> Self {
        let mut paper = None;
        Model::new("paper", |m| {
            let mut parameter = |name: &str| m.parameter(name, "1", None, Range::Any, "");
            let [N1, N2, I1, I2, zeta, T0] = ["N1", "N2", "I1", "I2", "zeta", "T0"].map(&mut parameter);
            let theta = m.coordinate("theta", "rad", Start::Static, "");
            let phi = m.coordinate("phi", "rad", Start::Static, "");
            let k = m.stiffness_law("k", "N*m", theta, 1.0, "");
            paper = Some(Paper { N1, N2, I1, I2, zeta, T0, phi, k: k.value, dk: k.slope, k0: k.mid });
        });
        paper.expect("the model was described")
    }

    /// M1 = (N1^2/I1 - N2^2/I2)/2
    pub fn M1(&self) -> Expr {
        (self.N1 * self.N1 / self.I1 - self.N2 * self.N2 / self.I2) / 2
    }

    /// M2 = (N1^2/I1 + N2^2/I2)/2
    pub fn M2(&self) -> Expr {
        (self.N1 * self.N1 / self.I1 + self.N2 * self.N2 / self.I2) / 2
    }

    /// C of D = C phi'^2: M2 C = 2 zeta w0 with w0 = sqrt(M2 k0), Eqs. (14), (16)
    pub fn C(&self) -> Expr {
        2 * self.zeta * (self.k0 / self.M2()).sqrt()
    }

    /// (2 zeta w0)^2, to which (M2 C)^2 must be equal.
    pub fn damping_squared(&self) -> Expr {
        4 * self.zeta * self.zeta * self.M2() * self.k0
    }

    /// The term of the torques in phi'', the right side of Eqs. (2), (4), (6)
    pub fn eq4_of_torque(&self) -> Expr {
        self.M2() * self.T0
    }

    /// The term of damping in phi'' in Eqs. (2), (4), (6)
    pub fn eq4_of_damping(&self) -> Expr {
        -self.M2() * self.C() * self.phi.dot()
    }

    /// phi'' of Eq. (2): phi'' + M2 C phi' + M2 k phi + (M1/2) (dk/dtheta) phi^2 = M2 T0
    pub fn eq2(&self) -> Expr {
        self.eq4() - self.M1() / 2 * self.dk * self.phi * self.phi
    }

    /// theta'' of Eq. (3): theta'' + M1 C phi' + M1 k phi + (M2/2) (dk/dtheta) phi^2 = M1 T0
    pub fn eq3(&self) -> Expr {
        self.eq5() - self.M2() / 2 * self.dk * self.phi * self.phi
    }

    /// phi'' of Eq. (4), rigid kinematics: phi'' + M2 C phi' + M2 k phi = M2 T0
    pub fn eq4(&self) -> Expr {
        self.M2() * self.T0 - self.M2() * self.k * self.phi - self.M2() * self.C() * self.phi.dot()
    }

    /// theta'' of Eq. (5), rigid kinematics: theta'' + M1 C phi' + M1 k phi = M1 T0
    pub fn eq5(&self) -> Expr {
        self.M1() * self.T0 - self.M1() * self.k * self.phi - self.M1() * self.C() * self.phi.dot()
    }

    /// phi'' of Eq. (6), classical: phi'' + M2 C phi' + M2 k(Omega0 t) phi = M2 T0; here k is a function of time.
    pub fn eq6(&self) -> Expr {
        self.M2() * (self.T0 - self.k * self.phi - self.C() * self.phi.dot())
    }

    /// The amount by which a step dk lowers theta'^2, Eq. (9): theta'+^2 - theta'-^2 + M2 dk phi^2 = 0
    pub fn eq9(&self) -> Expr {
        self.M2() * self.dk * self.phi * self.phi
    }

    /// (phi'+ - phi'-)/(theta'+ - theta'-), Eq. (11)
    pub fn eq11(&self) -> Expr {
        self.M1() / self.M2()
    }

    /// phi'' and theta'' of Eqs. (2), (3), each with one error; `true` stands for phi''.
    pub fn wrong(&self) -> [(&'static str, bool, Expr); 6] {
        let (squared, speed) = (self.phi * self.phi, self.phi.dot());
        [
            ("the jump term of (2) without its half", true, self.eq4() - self.M1() * self.dk * squared),
            ("the jump term of (2) with M2 for M1", true, self.eq4() - self.M2() / 2 * self.dk * squared),
            ("the jump term of (3) with M1 for M2", false, self.eq5() - self.M1() / 2 * self.dk * squared),
            ("the jump term of (3) with phi for phi^2", false, self.eq5() - self.M2() / 2 * self.dk * self.phi),
            ("(3) without damping, as printed", false, self.eq3() + self.M1() * self.C() * speed),
            ("(2) with the opposite sign of N2^2/I2 in M2", true, self.eq2() - self.N2 * self.N2 / self.I2 * self.T0),
        ]
    }
}
