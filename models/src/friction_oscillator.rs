//! A rotor on a torsional spring with dry friction: free vibration that ends at rest, stick-slip, self-locking.

use gearsim_derive::{Model, Start};

use crate::components::{driven, dry_friction, end_stop, rotor, shaft};

/// Coordinate: the rotation phi of the rotor. A torque acts on it, which may vary in time.
pub fn friction_oscillator(m: &mut Model) {
    m.title("a rotor on a spring with dry friction");
    m.source("J. P. Den Hartog, Trans. ASME 53 (1931), 107-115");

    let phi = m.coordinate("phi", "rad", Start::At(0.0), "rotation");
    rotor(m, "", "rotor", phi);
    shaft(m, "", "spring", phi, phi);
    dry_friction(m, "", "bearing", ["rad", "N*m"], phi);
    end_stop(m, "", "rotor", ["rad", "N*m"], phi);
    driven(m, "motor", "rotor", phi);
    m.motion("speed", "rad/s", &[(phi, 1.into())], "rotational speed");
}
