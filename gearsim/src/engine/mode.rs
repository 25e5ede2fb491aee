//! One mode of a linear cell: xi'' + 2 sigma xi' + omega² xi = g, propagated exactly.
//!
//! With S1 the response to a unit speed and S2 = ∫ S1 dt,
//!
//! ```text
//! xi(t)  - xi(0)  = v S1 + f S2                    f = g - omega² xi(0), v = xi'(0)
//! xi'(t) - xi'(0) = (f - 2 sigma v) S1 - omega² v S2
//! ```
//!
//! hold for every damping: S1, S2 are entire functions of t, sigma and omega². Increments, not values, so that what
//! does not change carries no rounding. The branches below are ways to evaluate these same two functions without
//! cancellation: oscillating, aperiodic, series for short times; they meet to rounding.

/// Constants of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// Half the damping, sigma [1/s].
    pub sigma: f64,
    /// Square of the undamped natural angular frequency, omega² [1/s²].
    pub omega2: f64,
    /// How it moves.
    kind: Kind,
}

/// How a mode moves.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// sigma = omega = 0: rigid-body motion.
    Rigid,
    /// sigma = 0 < omega = w: needs no exponential.
    Undamped { w: f64 },
    /// 0 < sigma < omega, w² = omega² - sigma².
    Under { w: f64 },
    /// |omega² - sigma²| too small for its root to be told from zero.
    Critical { d: f64 },
    /// sigma > omega: decay rates slow = sigma - kappa (may be 0), fast = sigma + kappa.
    Over { kappa: f64, slow: f64, fast: f64 },
}

/// S1 [s] and S2 [s²] at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Response to a unit initial speed.
    pub s1: f64,
    /// Response to a unit constant force.
    pub s2: f64,
}

/// Below this product of fastest rate and time the series is used.
const SHORT: f64 = 0.5;
/// Relative distance from critical damping within which the root of omega² - sigma² is expanded instead.
const NEAR_CRITICAL: f64 = 1e-10;

impl Mode {
    /// The mode with damping `sigma` >= 0 [1/s] and stiffness `omega2` >= 0 [1/s²].
    pub fn new(sigma: f64, omega2: f64) -> Mode {
        let omega = omega2.sqrt();
        let d = (omega - sigma) * (omega + sigma);
        let kind = if omega == 0.0 && sigma == 0.0 {
            Kind::Rigid
        } else if sigma == 0.0 {
            Kind::Undamped { w: omega }
        } else if d.abs() <= NEAR_CRITICAL * omega2 {
            Kind::Critical { d }
        } else if d > 0.0 {
            Kind::Under { w: d.sqrt() }
        } else {
            let kappa = (-d).sqrt();
            let fast = sigma + kappa;
            Kind::Over { kappa, slow: omega2 / fast, fast }
        };
        Mode { sigma, omega2, kind }
    }

    /// Whether it is a rigid-body motion: no stiffness, no damping.
    pub fn is_rigid(&self) -> bool {
        self.kind == Kind::Rigid
    }

    /// The damped angular frequency [rad/s], 0 where it does not oscillate.
    pub fn damped_frequency(&self) -> f64 {
        match self.kind {
            Kind::Undamped { w } | Kind::Under { w } => w,
            _ => 0.0,
        }
    }

    /// S1 and S2 after the time `t` >= 0 [s].
    #[inline]
    pub fn response(&self, t: f64) -> Response {
        match self.kind {
            Kind::Rigid => Response { s1: t, s2: 0.5 * t * t },
            Kind::Undamped { w } => {
                let (h, c) = (0.5 * w * t).sin_cos();
                let u = h / w;
                Response { s1: 2.0 * u * c, s2: 2.0 * u * u }
            }
            _ => self.damped(t),
        }
    }

    fn damped(&self, t: f64) -> Response {
        let Mode { sigma, omega2, kind } = *self;
        if (omega2.sqrt() + 2.0 * sigma) * t < SHORT {
            return self.series(t);
        }
        // The decayed cosine less one, and the decayed S1, give S2 = (1 - e^{-sigma t}(C + sigma S))/omega².
        let from_increments =
            |cosine_less_one: f64, s1: f64| Response { s1, s2: (-cosine_less_one - sigma * s1) / omega2 };
        match kind {
            Kind::Rigid | Kind::Undamped { .. } => self.response(t),
            Kind::Under { w } => {
                let e = (-sigma * t).exp_m1();
                let (h, c) = (0.5 * w * t).sin_cos();
                from_increments(e - 2.0 * h * h * (1.0 + e), (1.0 + e) * 2.0 * h * c / w)
            }
            Kind::Critical { d } => {
                let (e, dt2) = ((-sigma * t).exp_m1(), d * t * t);
                from_increments(e - 0.5 * dt2 * (1.0 + e), (1.0 + e) * t * (1.0 - dt2 / 6.0))
            }
            Kind::Over { kappa, slow, fast } => {
                let s1 = (-slow * t).exp() * -(-2.0 * kappa * t).exp_m1() / (2.0 * kappa);
                if kappa > 0.5 * sigma {
                    return Response { s1, s2: (decayed(slow, t) - decayed(fast, t)) / (2.0 * kappa) };
                }
                from_increments(0.5 * ((-slow * t).exp_m1() + (-fast * t).exp_m1()), s1)
            }
        }
    }

    /// Taylor series: S1'' + 2 sigma S1' + omega² S1 = 0 term by term.
    fn series(&self, t: f64) -> Response {
        let (a, b) = (2.0 * self.sigma * t, self.omega2 * t * t);
        let (mut previous, mut term) = (0.0, t); // c_{k-1} t^{k-1}, c_k t^k
        let (mut s1, mut s2) = (t, 0.5 * t * t);
        for k in 1..24 {
            let k = f64::from(k);
            let next = -(a * k * term + b * previous) / ((k + 1.0) * k);
            (previous, term) = (term, next);
            s1 += term;
            s2 += term * t / (k + 2.0);
            if term.abs() + previous.abs() <= 1e-19 * t {
                break;
            }
        }
        Response { s1, s2 }
    }

    /// A bound on |y(t)| for all t >= 0, where y'' + 2 sigma y' + omega² y = 0, y(0) = `y`, y'(0) = `y_dot`.
    /// Infinite where a rigid motion grows without bound.
    #[inline]
    pub fn bound(&self, y: f64, y_dot: f64) -> f64 {
        match self.kind {
            Kind::Rigid => {
                if y_dot == 0.0 {
                    y.abs()
                } else {
                    f64::INFINITY
                }
            }
            Kind::Undamped { w } | Kind::Under { w } => {
                let b = (y_dot + self.sigma * y) / w;
                let (envelope, simple) = ((y * y + b * b).sqrt(), y.abs() + y_dot.abs() / self.omega2.sqrt());
                envelope.min(simple)
            }
            Kind::Critical { .. } => y.abs() + y_dot.abs() / self.sigma,
            Kind::Over { fast, .. } => y.abs() + y_dot.abs() / fast,
        }
    }

    /// ∫ xi'² dt over [0, `t`] from initial speed `v` and acceleration `a`: twice sigma times it is the energy lost.
    pub fn speed_squared(&self, v: f64, a: f64, t: f64) -> f64 {
        let Mode { sigma, omega2, kind } = *self;
        match kind {
            Kind::Under { w } if w > 0.1 * sigma => {
                let b = (a + sigma * v) / w;
                let (s, c) = (2.0 * w * t).sin_cos();
                let e = (-2.0 * sigma * t).exp();
                let flat = decayed(2.0 * sigma, t);
                let cosine = (sigma + e * (w * s - sigma * c)) / (2.0 * omega2);
                let sine = (w - e * (w * c + sigma * s)) / (2.0 * omega2);
                0.5 * (v * v + b * b) * flat + 0.5 * (v * v - b * b) * cosine + v * b * sine
            }
            Kind::Over { kappa, slow, fast } if kappa > 0.1 * sigma => {
                let p = (fast * v + a) / (2.0 * kappa);
                let q = -(slow * v + a) / (2.0 * kappa);
                p * p * decayed(2.0 * slow, t) + 2.0 * p * q * decayed(slow + fast, t) + q * q * decayed(2.0 * fast, t)
            }
            Kind::Rigid | Kind::Undamped { .. } => 0.0, // nothing is lost, nobody asks
            _ => self.speed_squared_by_quadrature(v, a, t),
        }
    }

    /// The same near critical damping, where the closed forms cancel: Gauss-Legendre on panels of one decay time.
    fn speed_squared_by_quadrature(&self, v: f64, a: f64, t: f64) -> f64 {
        // Beyond 40 decay times what is left of the square is below 1e-30.
        let t = t.min(40.0 / self.sigma);
        let panels = (self.sigma * t).ceil().max(1.0);
        let width = t / panels;
        let mut sum = 0.0;
        for panel in 0..panels as usize {
            for (x, weight) in GAUSS_16 {
                for x in [-x, x] {
                    let r = self.response((panel as f64 + 0.5 * (1.0 + x)) * width);
                    let speed = v + a * r.s1 - self.omega2 * v * r.s2;
                    sum += 0.5 * width * weight * speed * speed;
                }
            }
        }
        sum
    }
}

/// ∫ e^{-rate s} ds over [0, t].
fn decayed(rate: f64, t: f64) -> f64 {
    if rate * t == 0.0 { t } else { -(-rate * t).exp_m1() / rate }
}

/// Nodes and weights of the 16-point Gauss-Legendre rule on [-1, 1], positive half (Abramowitz & Stegun, Table 25.4).
const GAUSS_16: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];
