//! The data of a pair of involute gears, spur or helical.

/// Data of two gears, as on a drawing. The first gear drives.
#[derive(Debug, Clone, PartialEq)]
pub struct Gears {
    /// Numbers of teeth.
    pub teeth: [f64; 2],
    /// Whether the second gear is a ring with internal teeth.
    pub internal: bool,
    /// Normal module \[m\].
    pub module: f64,
    /// Pressure angle of the basic rack, in the normal section \[rad\].
    pub pressure_angle: f64,
    /// Helix angle at the reference cylinder, 0 for spur gears \[rad\].
    pub helix_angle: f64,
    /// Addendum \[modules\], without the profile shift.
    pub addendum: [f64; 2],
    /// Dedendum \[modules\], without the profile shift.
    pub dedendum: [f64; 2],
    /// Tip radius of the basic rack, which cuts the fillet \[modules\].
    pub fillet: f64,
    /// Profile shift \[modules\].
    pub profile_shift: [f64; 2],
    /// Centre distance \[m\]; `None`: the distance without backlash.
    pub centre_distance: Option<f64>,
    /// Face width \[m\].
    pub face_width: f64,
    /// Material of each gear.
    pub material: [Material; 2],
    /// Radius of the bore \[m\]; `None`: not known.
    pub bore: [Option<f64>; 2],
}

/// An elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E \[Pa\].
    pub young: f64,
    /// Poisson's ratio nu.
    pub poisson: f64,
}

impl Material {
    /// Steel, with the values of ISO 6336-1.
    pub const STEEL: Material = Material { young: 206e9, poisson: 0.3 };
}

/// Why gears do not mesh, or are outside the range of a method; and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what}; {advice}")]
pub struct GearError {
    /// What is wrong, with the numbers.
    pub what: String,
    /// What to do about it.
    pub advice: String,
}

impl GearError {
    pub(super) fn new(what: impl Into<String>, advice: impl Into<String>) -> GearError {
        GearError { what: what.into(), advice: advice.into() }
    }
}

impl Gears {
    /// Two standard external gears of steel: addendum 1, dedendum 1.25, fillet 0.38 (ISO 53, profile A).
    pub fn standard(teeth: [f64; 2], module: f64, pressure_angle: f64, face_width: f64) -> Gears {
        Gears {
            teeth,
            internal: false,
            module,
            pressure_angle,
            helix_angle: 0.0,
            addendum: [1.0; 2],
            dedendum: [1.25; 2],
            fillet: 0.38,
            profile_shift: [0.0; 2],
            centre_distance: None,
            face_width,
            material: [Material::STEEL; 2],
            bore: [None; 2],
        }
    }

    /// Transverse module \[m\] and transverse pressure angle \[rad\].
    pub fn transverse(&self) -> (f64, f64) {
        let cos = self.helix_angle.cos();
        (self.module / cos, (self.pressure_angle.tan() / cos).atan())
    }

    /// Spur gears with the transverse section of these gears: the same circles and the same path of contact. Their heights are given in
    /// transverse modules.
    pub fn transverse_section(&self) -> Gears {
        let ((module, pressure_angle), cos) = (self.transverse(), self.helix_angle.cos());
        Gears {
            module,
            pressure_angle,
            helix_angle: 0.0,
            addendum: self.addendum.map(|x| x * cos),
            dedendum: self.dedendum.map(|x| x * cos),
            fillet: self.fillet * cos,
            profile_shift: self.profile_shift.map(|x| x * cos),
            ..self.clone()
        }
    }

    /// Base helix angle \[rad\]: tan(beta_b) = tan(beta) cos(alpha_t).
    pub fn base_helix_angle(&self) -> f64 {
        let (_, angle) = self.transverse();
        (self.helix_angle.tan() * angle.cos()).atan()
    }

    /// Base radius divided by the number of teeth, m_t cos(alpha_t)/2 \[m\]. It is the length along the line of action per radian of a
    /// phase with the period 2 pi.
    pub fn base_radius_per_tooth(&self) -> f64 {
        let (module, angle) = self.transverse();
        module * angle.cos() / 2.0
    }
}

/// Example 1 of ISO/TR 6336-30 (2017): 17 and 103 teeth, basic rack D of ISO 53, helix angle 15.8 deg.
#[cfg(test)]
pub(super) fn iso_6336_30() -> Gears {
    Gears {
        helix_angle: 15.8f64.to_radians(),
        dedendum: [1.4; 2],
        fillet: 0.39,
        profile_shift: [0.145, 0.0],
        centre_distance: Some(0.5),
        ..Gears::standard([17.0, 103.0], 8e-3, 20f64.to_radians(), 0.1)
    }
}
