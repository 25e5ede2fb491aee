//! sample header
use gearsim_macros::equations;

equations! {
    model gear_pair "Two spur gears on rigid shafts";
    source "Oh, Grosh & Barber (2005)";

    coordinates {
        theta "rad" start 0.0, "mean rotation of the mesh, (N1 theta1 + N2 theta2)/2";
        phi "rad" start static, "relative deflection at the mesh, (N1 theta1 - N2 theta2)/2";
    }
    parameters {
        N1 "1" default 24.0, open 0.0 to inf, "teeth of the driving gear";
        N2 "1" default 96.0, open 0.0 to inf, "teeth of the driven gear";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driving gear";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the driven gear";
        zeta "1" default 0.0, from 0.0 to inf, "damping factor, relative to the mid stiffness";
        T0 "N*m" default 10.0, open -inf to inf, "balanced torque";
    }
    laws {
        k "N*m" phase theta period 6.283185307179586, "mesh stiffness";
    }
    motions {
        speed "rad/s" { theta_dot = N1; }, "rotational speed of the driving gear";
    }
    effects {
        stiffness_step "k steps with the mesh phase";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "k(Omega0 t) for k(theta)";
        damping "Rayleigh damping";
        torques "drive and load";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
    }
    constants {
        M1 = (N1.powi(2)/I1 - N2.powi(2)/I2)/2.0;
        M2 = (N1.powi(2)/I1 + N2.powi(2)/I2)/2.0;
        C = 2.0*zeta*(k_mid/M2).sqrt();
    }
    energies {
        kinetic { _ => I1*(theta_dot + phi_dot).powi(2)/(2.0*N1.powi(2)) + I2*(theta_dot - phi_dot).powi(2)/(2.0*N2.powi(2)); }
        potential { _ => k*phi.powi(2); }
        dissipation { damping => C*phi_dot.powi(2); }
    }
    torques {
        drive "torque T0*N1 on the driving gear" { torques => T0*(theta + phi); }
        load "torque T0*N2 on the driven gear" { torques => -T0*(theta - phi); }
    }
    work {
        phi { torques => 2.0*T0; }
    }
    mass {
        theta theta { _ => I1/N1.powi(2) + I2/N2.powi(2); }
        theta phi { _ => I1/N1.powi(2) - I2/N2.powi(2); }
        phi phi { _ => I1/N1.powi(2) + I2/N2.powi(2); }
    }
    force {
        theta { jump_terms => -dk*phi.powi(2); }
        phi { _ => -2.0*k*phi; torques => 2.0*T0; damping => -2.0*C*phi_dot; }
    }
    acceleration {
        theta { _ => -M1*k*phi; torques => M1*T0; damping => -C*M1*phi_dot; jump_terms => -M2*dk*phi.powi(2)/2.0; }
        phi { _ => -M2*k*phi; torques => M2*T0; damping => -C*M2*phi_dot; jump_terms => -M1*dk*phi.powi(2)/2.0; }
    }
    jacobian {
        theta theta { jump_terms => -M1*dk*phi - M2*ddk*phi.powi(2)/2.0; }
        theta phi { _ => -M1*k; jump_terms => -M2*dk*phi; }
        theta phi_dot { damping => -C*M1; }
        phi theta { jump_terms => -M2*dk*phi - M1*ddk*phi.powi(2)/2.0; }
        phi phi { _ => -M2*k; jump_terms => -M1*dk*phi; }
        phi phi_dot { damping => -C*M2; }
    }
    cell {
        stiffness { phi phi { _ => 2.0*k; } }
        damping { phi phi { damping => 2.0*C; } }
        load { phi { torques => 2.0*T0; } }
    }
    jump k {
        normal { theta { _ => 1.0; } }
        compliance { _ => M2/2.0; }
        direction { theta { _ => 1.0; } phi { _ => M1/M2; } }
        step { _ => dk*phi.powi(2); }
    }
    text {
        "theta'' = M1*T0 - M1*k*phi - 2*..";
        "phi'' = ...";
    }
    latex {
        r"\ddot\theta = ...";
    }
}
