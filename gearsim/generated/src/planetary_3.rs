//! Equations of motion of `planetary_3`: a planetary stage with 3 planets, torsional.
//!
//! Derived from the energies in `models/src/planetary.rs` by `cargo xtask derive planetary_3`.
//! Do not edit: change the energies and derive again.
//! For reading: `text/planetary_3.txt`, `latex/planetary_3.tex`. What is proved: at the end.

use gearsim::equations;

equations! {
    model planetary_3 "a planetary stage with 3 planets, torsional";
    source "Lin & Parker (1999), J. Vib. Acoust. 121(3), with centres held; phase on the sun";

    coordinates {
        theta "rad" start 0.0, "phase of the meshes, Z_s (theta_s - theta_c)";
        theta_c "rad" start static, "rotation of the carrier in excess of rigid rolling";
        theta_r "rad" start static, "rotation of the ring";
        u1 "m" start static, "rotation of planet 1 in excess of rigid rolling, times its base radius";
        u2 "m" start static, "rotation of planet 2 in excess of rigid rolling, times its base radius";
        u3 "m" start static, "rotation of planet 3 in excess of rigid rolling, times its base radius";
    }
    parameters {
        Z_s "1" teeth required, open 0.0 to inf, "number of teeth of the sun";
        Z_r "1" teeth required, open 0.0 to inf, "number of teeth of the ring";
        r_s "m" base_radius required, open 0.0 to inf, "base radius of the sun";
        alpha "rad" pressure_angle default 0.3490658503988659, open 0.0 to inf, "pressure angle";
        I_s "kg*m^2" required, open 0.0 to inf, "moment of inertia of the sun";
        I_c "kg*m^2" required, open 0.0 to inf, "moment of inertia of the carrier without planets";
        I_r "kg*m^2" required, open 0.0 to inf, "moment of inertia of the ring";
        k_r "N*m/rad" support required, from 0.0 to inf, "torsional stiffness of the ring's torsional support";
        k_s "N*m/rad" support required with torsional_support_s, from 0.0 to inf, "torsional stiffness of the sun's torsional support";
        k_c "N*m/rad" support required with torsional_support_c, from 0.0 to inf, "torsional stiffness of the carrier's torsional support";
        m_p "kg" required, open 0.0 to inf, "mass of a planet";
        I_p "kg*m^2" required, open 0.0 to inf, "moment of inertia of a planet";
        b_s1 "m" required with backlash_s1, open 0.0 to inf,
            "backlash of the mesh of sun and planet 1: no contact within b/2 to either side";
        mu_s1 "1" required with sliding_friction_s1, from 0.0 to inf, "coefficient of friction of the mesh of sun and planet 1";
        w_mix_s1 "rad/s" default 0.1 with sliding_friction_s1, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of sun and planet 1 below which friction decreases to zero (mixed film)";
        mu_rise_s1 "1" default 0.0 with flank_stiction_s1, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of sun and planet 1 over that of sliding, relative to that";
        b_r1 "m" required with backlash_r1, open 0.0 to inf,
            "backlash of the mesh of ring and planet 1: no contact within b/2 to either side";
        mu_r1 "1" required with sliding_friction_r1, from 0.0 to inf, "coefficient of friction of the mesh of ring and planet 1";
        w_mix_r1 "rad/s" default 0.1 with sliding_friction_r1, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of ring and planet 1 below which friction decreases to zero (mixed film)";
        mu_rise_r1 "1" default 0.0 with flank_stiction_r1, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of ring and planet 1 over that of sliding, relative to that";
        b_s2 "m" required with backlash_s2, open 0.0 to inf,
            "backlash of the mesh of sun and planet 2: no contact within b/2 to either side";
        mu_s2 "1" required with sliding_friction_s2, from 0.0 to inf, "coefficient of friction of the mesh of sun and planet 2";
        w_mix_s2 "rad/s" default 0.1 with sliding_friction_s2, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of sun and planet 2 below which friction decreases to zero (mixed film)";
        mu_rise_s2 "1" default 0.0 with flank_stiction_s2, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of sun and planet 2 over that of sliding, relative to that";
        b_r2 "m" required with backlash_r2, open 0.0 to inf,
            "backlash of the mesh of ring and planet 2: no contact within b/2 to either side";
        mu_r2 "1" required with sliding_friction_r2, from 0.0 to inf, "coefficient of friction of the mesh of ring and planet 2";
        w_mix_r2 "rad/s" default 0.1 with sliding_friction_r2, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of ring and planet 2 below which friction decreases to zero (mixed film)";
        mu_rise_r2 "1" default 0.0 with flank_stiction_r2, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of ring and planet 2 over that of sliding, relative to that";
        b_s3 "m" required with backlash_s3, open 0.0 to inf,
            "backlash of the mesh of sun and planet 3: no contact within b/2 to either side";
        mu_s3 "1" required with sliding_friction_s3, from 0.0 to inf, "coefficient of friction of the mesh of sun and planet 3";
        w_mix_s3 "rad/s" default 0.1 with sliding_friction_s3, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of sun and planet 3 below which friction decreases to zero (mixed film)";
        mu_rise_s3 "1" default 0.0 with flank_stiction_s3, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of sun and planet 3 over that of sliding, relative to that";
        b_r3 "m" required with backlash_r3, open 0.0 to inf,
            "backlash of the mesh of ring and planet 3: no contact within b/2 to either side";
        mu_r3 "1" required with sliding_friction_r3, from 0.0 to inf, "coefficient of friction of the mesh of ring and planet 3";
        w_mix_r3 "rad/s" default 0.1 with sliding_friction_r3, open 0.0 to inf,
            "rolling speed omega1 + omega2 of the mesh of ring and planet 3 below which friction decreases to zero (mixed film)";
        mu_rise_r3 "1" default 0.0 with flank_stiction_r3, from 0.0 to inf,
            "excess of the static coefficient of friction of the mesh of ring and planet 3 over that of sliding, relative to that";
        T_motor "N*m" required with torques, open -inf to inf, "driving torque of the sun";
        c_motor "N*m*s/rad" required with governor_motor, open 0.0 to inf,
            "gain of the governor of the sun: torque per difference of set point and speed";
        n_motor "rad/s" required with governor_motor, open -inf to inf, "set point of the speed governor of the sun";
        Ts_motor "N*m" required with dc_motor, open 0.0 to inf, "stall torque of the DC motor of the sun";
        n0_motor "rad/s" required with dc_motor, open 0.0 to inf, "no-load speed of the DC motor of the sun";
        Tb_motor "N*m" required with induction_motor, open 0.0 to inf,
            "breakdown torque of the induction motor of the sun, its largest torque";
        sb_motor "1" required with induction_motor, open 0.0 to inf,
            "slip at which the induction motor of the sun has its breakdown torque";
        ns_motor "rad/s" required with induction_motor, open 0.0 to inf, "synchronous speed of the induction motor of the sun";
        Tp_motor "N*m" required with traction_motor, open 0.0 to inf, "peak torque of the traction motor of the sun, up to its base speed";
        Pp_motor "W" required with traction_motor, open 0.0 to inf,
            "peak power of the traction motor of the sun, above its base speed Pp/Tp";
        d_motor "1" default 1.0 with traction_motor, open -inf to inf,
            "demand on the traction motor of the sun: 1 drives with its peak torque or power, -1 brakes with them";
        round_motor "1" default 0.01 with traction_motor, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the sun at its base speed, relative to that";
        cf_motor "N*m*s^2/rad^2" required with fan_motor, from 0.0 to inf,
            "torque of the fan of the sun divided by the square of its speed";
        w0_motor "rad/s" default 0.01 with fan_motor, open 0.0 to inf,
            "speed of the sun below which the torque of its fan is linear instead of quadratic in the speed";
        T_load "N*m" required with torques, open -inf to inf, "load torque of the carrier, against its rotation";
        c_load "N*m*s/rad" required with governor_load, open 0.0 to inf,
            "gain of the governor of the carrier: torque per difference of set point and speed";
        n_load "rad/s" required with governor_load, open -inf to inf, "set point of the speed governor of the carrier";
        Ts_load "N*m" required with dc_load, open 0.0 to inf, "stall torque of the DC motor of the carrier";
        n0_load "rad/s" required with dc_load, open 0.0 to inf, "no-load speed of the DC motor of the carrier";
        Tb_load "N*m" required with induction_load, open 0.0 to inf,
            "breakdown torque of the induction motor of the carrier, its largest torque";
        sb_load "1" required with induction_load, open 0.0 to inf,
            "slip at which the induction motor of the carrier has its breakdown torque";
        ns_load "rad/s" required with induction_load, open 0.0 to inf, "synchronous speed of the induction motor of the carrier";
        Tp_load "N*m" required with traction_load, open 0.0 to inf,
            "peak torque of the traction motor of the carrier, up to its base speed";
        Pp_load "W" required with traction_load, open 0.0 to inf,
            "peak power of the traction motor of the carrier, above its base speed Pp/Tp";
        d_load "1" default 1.0 with traction_load, open -inf to inf,
            "demand on the traction motor of the carrier: 1 drives with its peak torque or power, -1 brakes with them";
        round_load "1" default 0.01 with traction_load, open 0.0 to inf,
            "rounding of the corner of the torque of the traction motor of the carrier at its base speed, relative to that";
        cf_load "N*m*s^2/rad^2" required with fan_load, from 0.0 to inf,
            "torque of the fan of the carrier divided by the square of its speed";
        w0_load "rad/s" default 0.01 with fan_load, open 0.0 to inf,
            "speed of the carrier below which the torque of its fan is linear instead of quadratic in the speed";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k_s1 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of sun and planet 1 along the line of action";
        k_r1 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of ring and planet 1 along the line of action";
        k_s2 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of sun and planet 2 along the line of action";
        k_r2 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of ring and planet 2 along the line of action";
        k_s3 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of sun and planet 3 along the line of action";
        k_r3 "N/m" phase theta period 6.283185307179586 rolling unless(torsional_support),
            "stiffness of the mesh of ring and planet 3 along the line of action";
        e_s1 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_s1,
            "transmission error of the mesh of sun and planet 1 along the line of action";
        e_r1 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_r1,
            "transmission error of the mesh of ring and planet 1 along the line of action";
        e_s2 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_s2,
            "transmission error of the mesh of sun and planet 2 along the line of action";
        e_r2 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_r2,
            "transmission error of the mesh of ring and planet 2 along the line of action";
        e_s3 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_s3,
            "transmission error of the mesh of sun and planet 3 along the line of action";
        e_r3 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with transmission_error_r3,
            "transmission error of the mesh of ring and planet 3 along the line of action";
        side_s1 "1" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_s1 as side,
            "share of the force of the mesh of sun and planet 1 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm_s1 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_s1 as arm,
            "mean distance of the force of the mesh of sun and planet 1 from the pitch point along the line of action";
        side_r1 "1" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_r1 as side,
            "share of the force of the mesh of ring and planet 1 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm_r1 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_r1 as arm,
            "mean distance of the force of the mesh of ring and planet 1 from the pitch point along the line of action";
        side_s2 "1" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_s2 as side,
            "share of the force of the mesh of sun and planet 2 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm_s2 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_s2 as arm,
            "mean distance of the force of the mesh of sun and planet 2 from the pitch point along the line of action";
        side_r2 "1" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_r2 as side,
            "share of the force of the mesh of ring and planet 2 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm_r2 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_r2 as arm,
            "mean distance of the force of the mesh of ring and planet 2 from the pitch point along the line of action";
        side_s3 "1" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_s3 as side,
            "share of the force of the mesh of sun and planet 3 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm_s3 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_s3 as arm,
            "mean distance of the force of the mesh of sun and planet 3 from the pitch point along the line of action";
        side_r3 "1" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_r3 as side,
            "share of the force of the mesh of ring and planet 3 on tooth pairs beyond the pitch point, minus that on pairs before it";
        arm_r3 "m" phase theta period 6.283185307179586 rolling unless(torsional_support) with sliding_friction_r3 as arm,
            "mean distance of the force of the mesh of ring and planet 3 from the pitch point along the line of action";
    }
    motions { speed "rad/s" { theta_dot = Z_r*Z_s/(Z_r + Z_s); }, "rotational speed of the sun, ring at rest"; }
    effects {
        torsional_support_s of torsional_support "a torsional spring to the ground: it holds what else turns";
        torsional_support_c of torsional_support "a torsional spring to the ground: it holds what else turns";
        stiffness_step
            "the mesh stiffness steps as tooth pairs enter and leave, conserving energy by jump terms; else it has its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase)
            "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics)
            "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error_s1 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_s1 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_s1 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_s1 of flank_stiction requires(sliding_friction_s1)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        transmission_error_r1 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_r1 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_r1 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_r1 of flank_stiction requires(sliding_friction_r1)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        transmission_error_s2 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_s2 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_s2 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_s2 of flank_stiction requires(sliding_friction_s2)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        transmission_error_r2 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_r2 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_r2 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_r2 of flank_stiction requires(sliding_friction_r2)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        transmission_error_s3 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_s3 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_s3 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_s3 of flank_stiction requires(sliding_friction_s3)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        transmission_error_r3 of transmission_error requires(stiffness_step)
            "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        backlash_r3 of backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        sliding_friction_r3 of sliding_friction requires(stiffness_step)
            "Coulomb friction between the flanks, against their sliding, which turns as a tooth pair passes the pitch point";
        flank_stiction_r3 of flank_stiction requires(sliding_friction_r3)
            "flanks at rest stick, up to their static friction; sliding, their friction has its full size at any speed";
        torques "constant torques of motor and load";
        governor_motor of governor excludes(dc_motor, induction_motor, traction_motor)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_motor of dc excludes(induction_motor, traction_motor)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_motor of induction excludes(traction_motor) "an induction motor, its torque by the formula of Kloss";
        traction_motor of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_motor of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
        governor_load of governor excludes(dc_load, induction_load, traction_load)
            "a motor with a speed governor: its torque is proportional to the set point minus the speed";
        dc_load of dc excludes(induction_load, traction_load)
            "a DC motor at constant voltage: its torque falls linearly from stall to no load";
        induction_load of induction excludes(traction_load) "an induction motor, its torque by the formula of Kloss";
        traction_load of traction "a traction motor: its peak torque up to the base speed, constant power above it, times the demand";
        fan_load of fan "a fan as load: torque proportional to the square of the speed, against the rotation";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    switching {
        stiffness_step => with_jump;
        rigid_kinematics => without_jump;
        frozen_phase => by_time;
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        torsional_support_s_and_damping = torsional_support_s, damping;
        torsional_support_c_and_damping = torsional_support_c, damping;
        transmission_error_s1_and_jump_terms = transmission_error_s1, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r1_and_jump_terms = transmission_error_r1, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s2_and_jump_terms = transmission_error_s2, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r2_and_jump_terms = transmission_error_r2, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s3_and_jump_terms = transmission_error_s3, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_r3_and_jump_terms = transmission_error_r3, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_s1_and_sliding_friction_s1_and_moving_phase = transmission_error_s1, sliding_friction_s1, stiffness_step,
            !frozen_phase;
        sliding_friction_s1_and_moving_phase = sliding_friction_s1, stiffness_step, !frozen_phase;
        transmission_error_r1_and_sliding_friction_r1_and_moving_phase = transmission_error_r1, sliding_friction_r1, stiffness_step,
            !frozen_phase;
        sliding_friction_r1_and_moving_phase = sliding_friction_r1, stiffness_step, !frozen_phase;
        transmission_error_s2_and_sliding_friction_s2_and_moving_phase = transmission_error_s2, sliding_friction_s2, stiffness_step,
            !frozen_phase;
        sliding_friction_s2_and_moving_phase = sliding_friction_s2, stiffness_step, !frozen_phase;
        transmission_error_r2_and_sliding_friction_r2_and_moving_phase = transmission_error_r2, sliding_friction_r2, stiffness_step,
            !frozen_phase;
        sliding_friction_r2_and_moving_phase = sliding_friction_r2, stiffness_step, !frozen_phase;
        transmission_error_s3_and_sliding_friction_s3_and_moving_phase = transmission_error_s3, sliding_friction_s3, stiffness_step,
            !frozen_phase;
        sliding_friction_s3_and_moving_phase = sliding_friction_s3, stiffness_step, !frozen_phase;
        transmission_error_r3_and_sliding_friction_r3_and_moving_phase = transmission_error_r3, sliding_friction_r3, stiffness_step,
            !frozen_phase;
        sliding_friction_r3_and_moving_phase = sliding_friction_r3, stiffness_step, !frozen_phase;
        transmission_error_r1_and_backlash_r1_and_moving_phase = transmission_error_r1, backlash_r1, stiffness_step, !frozen_phase;
        transmission_error_r1_and_moving_phase = transmission_error_r1, stiffness_step, !frozen_phase;
        backlash_r1_and_moving_phase = backlash_r1, stiffness_step, !frozen_phase;
        transmission_error_r2_and_backlash_r2_and_moving_phase = transmission_error_r2, backlash_r2, stiffness_step, !frozen_phase;
        transmission_error_r2_and_moving_phase = transmission_error_r2, stiffness_step, !frozen_phase;
        backlash_r2_and_moving_phase = backlash_r2, stiffness_step, !frozen_phase;
        transmission_error_r3_and_backlash_r3_and_moving_phase = transmission_error_r3, backlash_r3, stiffness_step, !frozen_phase;
        transmission_error_r3_and_moving_phase = transmission_error_r3, stiffness_step, !frozen_phase;
        backlash_r3_and_moving_phase = backlash_r3, stiffness_step, !frozen_phase;
        transmission_error_s1_and_backlash_s1_and_moving_phase = transmission_error_s1, backlash_s1, stiffness_step, !frozen_phase;
        transmission_error_s1_and_moving_phase = transmission_error_s1, stiffness_step, !frozen_phase;
        backlash_s1_and_moving_phase = backlash_s1, stiffness_step, !frozen_phase;
        transmission_error_s2_and_backlash_s2_and_moving_phase = transmission_error_s2, backlash_s2, stiffness_step, !frozen_phase;
        transmission_error_s2_and_moving_phase = transmission_error_s2, stiffness_step, !frozen_phase;
        backlash_s2_and_moving_phase = backlash_s2, stiffness_step, !frozen_phase;
        transmission_error_s3_and_backlash_s3_and_moving_phase = transmission_error_s3, backlash_s3, stiffness_step, !frozen_phase;
        transmission_error_s3_and_moving_phase = transmission_error_s3, stiffness_step, !frozen_phase;
        backlash_s3_and_moving_phase = backlash_s3, stiffness_step, !frozen_phase;
    }

    constants {
        cos_a = alpha.cos();
        sin_a = alpha.sin();
        h = r_s/Z_s;
        r_p = (h*Z_r - h*Z_s)/2.0;
        a = (h*Z_r/cos_a + h*Z_s/cos_a)/2.0;
        roll_s = 1.0/Z_s + h/r_p;
        roll_r = h/r_p - 1.0/Z_r;
        tiny_s1 = 1.0/1000000000000.0;
        tiny_r1 = 1.0/1000000000000.0;
        tiny_s2 = 1.0/1000000000000.0;
        tiny_r2 = 1.0/1000000000000.0;
        tiny_s3 = 1.0/1000000000000.0;
        tiny_r3 = 1.0/1000000000000.0;
        per_wb_motor = Tp_motor/Pp_motor;
        per_wb_load = Tp_load/Pp_load;
    }
    deflections {
        twist_r = theta_r;
        twist_s = theta_c + theta/Z_r + theta/Z_s;
        twist_c = theta_c + theta/Z_r;
        overs1 = u1 - edges1 - e_s1;
        tau_s1 = sin_a*u1/cos_a;
        psi_s1 = roll_s*theta - u1/r_p;
        overr1 = h*Z_r*theta_r - u1 - edger1 - e_r1 - h*Z_r*theta_c;
        tau_r1 = h*sin_a*Z_r*theta_r/cos_a - h*sin_a*Z_r*theta_c/cos_a - sin_a*u1/cos_a;
        psi_r1 = theta_r - theta_c + roll_r*theta - u1/r_p;
        overs2 = u2 - edges2 - e_s2;
        tau_s2 = sin_a*u2/cos_a;
        psi_s2 = roll_s*theta - u2/r_p;
        overr2 = h*Z_r*theta_r - u2 - edger2 - e_r2 - h*Z_r*theta_c;
        tau_r2 = h*sin_a*Z_r*theta_r/cos_a - h*sin_a*Z_r*theta_c/cos_a - sin_a*u2/cos_a;
        psi_r2 = theta_r - theta_c + roll_r*theta - u2/r_p;
        overs3 = u3 - edges3 - e_s3;
        tau_s3 = sin_a*u3/cos_a;
        psi_s3 = roll_s*theta - u3/r_p;
        overr3 = h*Z_r*theta_r - u3 - edger3 - e_r3 - h*Z_r*theta_c;
        tau_r3 = h*sin_a*Z_r*theta_r/cos_a - h*sin_a*Z_r*theta_c/cos_a - sin_a*u3/cos_a;
        psi_r3 = theta_r - theta_c + roll_r*theta - u3/r_p;
        theta_motor = theta_c + theta/Z_r + theta/Z_s;
        theta_load = theta_c + theta/Z_r;
    }
    forces {
        F_mu_s1 {
            sliding_friction_s1 => mu_s1*k_s1*touchs1*psi_s1_dot*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                /(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt();
            flank_stiction_s1 => mu_s1*k_s1*slide_dir_s1*touchs1*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                - mu_s1*k_s1*touchs1*psi_s1_dot*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()/(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt();
        }
        F_tau_s1 { sliding_friction_s1 => F_mu_s1*overs1/(tiny_s1.powi(2) + overs1.powi(2)).sqrt(); }
        F_mu_r1 {
            sliding_friction_r1 => mu_r1*k_r1*touchr1*psi_r1_dot*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                /(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt();
            flank_stiction_r1 => mu_r1*k_r1*slide_dir_r1*touchr1*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                - mu_r1*k_r1*touchr1*psi_r1_dot*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()/(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt();
        }
        F_tau_r1 { sliding_friction_r1 => F_mu_r1*overr1/(tiny_r1.powi(2) + overr1.powi(2)).sqrt(); }
        F_mu_s2 {
            sliding_friction_s2 => mu_s2*k_s2*touchs2*psi_s2_dot*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                /(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt();
            flank_stiction_s2 => mu_s2*k_s2*slide_dir_s2*touchs2*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                - mu_s2*k_s2*touchs2*psi_s2_dot*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()/(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt();
        }
        F_tau_s2 { sliding_friction_s2 => F_mu_s2*overs2/(tiny_s2.powi(2) + overs2.powi(2)).sqrt(); }
        F_mu_r2 {
            sliding_friction_r2 => mu_r2*k_r2*touchr2*psi_r2_dot*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                /(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt();
            flank_stiction_r2 => mu_r2*k_r2*slide_dir_r2*touchr2*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                - mu_r2*k_r2*touchr2*psi_r2_dot*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()/(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt();
        }
        F_tau_r2 { sliding_friction_r2 => F_mu_r2*overr2/(tiny_r2.powi(2) + overr2.powi(2)).sqrt(); }
        F_mu_s3 {
            sliding_friction_s3 => mu_s3*k_s3*touchs3*psi_s3_dot*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                /(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt();
            flank_stiction_s3 => mu_s3*k_s3*slide_dir_s3*touchs3*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                - mu_s3*k_s3*touchs3*psi_s3_dot*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()/(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt();
        }
        F_tau_s3 { sliding_friction_s3 => F_mu_s3*overs3/(tiny_s3.powi(2) + overs3.powi(2)).sqrt(); }
        F_mu_r3 {
            sliding_friction_r3 => mu_r3*k_r3*touchr3*psi_r3_dot*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                /(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt();
            flank_stiction_r3 => mu_r3*k_r3*slide_dir_r3*touchr3*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                - mu_r3*k_r3*touchr3*psi_r3_dot*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()/(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt();
        }
        F_tau_r3 { sliding_friction_r3 => F_mu_r3*overr3/(tiny_r3.powi(2) + overr3.powi(2)).sqrt(); }
        T_induction_motor {
            induction_motor => 2.0*Tb_motor*sb_motor*(1.0 - theta_motor_dot/ns_motor)
                /(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2));
        }
        T_traction_motor {
            traction_motor => 2.0*Tp_motor*d_motor
                /((round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                + (round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt());
        }
        T_fan_motor { fan_motor => -cf_motor*theta_motor_dot*(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt(); }
        T_induction_load {
            induction_load => 2.0*Tb_load*sb_load*(1.0 - theta_load_dot/ns_load)/(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2));
        }
        T_traction_load {
            traction_load => 2.0*Tp_load*d_load
                /((round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt()
                + (round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt());
        }
        T_fan_load { fan_load => -cf_load*theta_load_dot*(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt(); }
    }
    partials {
        F_mu_s1_by_overs1 {
            sliding_friction_s1 => mu_s1*k_s1*touchs1*overs1*psi_s1_dot
                /((tiny_s1.powi(2) + overs1.powi(2)).sqrt()*(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt());
            flank_stiction_s1 => mu_s1*k_s1*slide_dir_s1*touchs1*overs1/(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                - mu_s1*k_s1*touchs1*overs1*psi_s1_dot
                /((tiny_s1.powi(2) + overs1.powi(2)).sqrt()*(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt());
        }
        F_mu_s1_by_psi_s1_dot {
            sliding_friction_s1 => mu_s1*k_s1*touchs1*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                /(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt()
                - mu_s1*k_s1*touchs1*psi_s1_dot.powi(2)*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                /(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_s1 => mu_s1*k_s1*touchs1*psi_s1_dot.powi(2)*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                /(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).powf(3.0/2.0)
                - mu_s1*k_s1*touchs1*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()/(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt();
        }
        F_mu_s1_by_k_s1 {
            sliding_friction_s1 => mu_s1*touchs1*psi_s1_dot*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                /(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt();
            flank_stiction_s1 => mu_s1*slide_dir_s1*touchs1*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                - mu_s1*touchs1*psi_s1_dot*(tiny_s1.powi(2) + overs1.powi(2)).sqrt()/(w_mix_s1.powi(2) + psi_s1_dot.powi(2)).sqrt();
        }
        F_tau_s1_by_overs1 {
            sliding_friction_s1 => F_mu_s1/(tiny_s1.powi(2) + overs1.powi(2)).sqrt()
                - F_mu_s1*overs1.powi(2)/(tiny_s1.powi(2) + overs1.powi(2)).powf(3.0/2.0);
        }
        F_tau_s1_by_F_mu_s1 { sliding_friction_s1 => overs1/(tiny_s1.powi(2) + overs1.powi(2)).sqrt(); }
        F_mu_r1_by_overr1 {
            sliding_friction_r1 => mu_r1*k_r1*touchr1*overr1*psi_r1_dot
                /((tiny_r1.powi(2) + overr1.powi(2)).sqrt()*(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt());
            flank_stiction_r1 => mu_r1*k_r1*slide_dir_r1*touchr1*overr1/(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                - mu_r1*k_r1*touchr1*overr1*psi_r1_dot
                /((tiny_r1.powi(2) + overr1.powi(2)).sqrt()*(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt());
        }
        F_mu_r1_by_psi_r1_dot {
            sliding_friction_r1 => mu_r1*k_r1*touchr1*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                /(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt()
                - mu_r1*k_r1*touchr1*psi_r1_dot.powi(2)*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                /(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_r1 => mu_r1*k_r1*touchr1*psi_r1_dot.powi(2)*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                /(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).powf(3.0/2.0)
                - mu_r1*k_r1*touchr1*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()/(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt();
        }
        F_mu_r1_by_k_r1 {
            sliding_friction_r1 => mu_r1*touchr1*psi_r1_dot*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                /(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt();
            flank_stiction_r1 => mu_r1*slide_dir_r1*touchr1*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                - mu_r1*touchr1*psi_r1_dot*(tiny_r1.powi(2) + overr1.powi(2)).sqrt()/(w_mix_r1.powi(2) + psi_r1_dot.powi(2)).sqrt();
        }
        F_tau_r1_by_overr1 {
            sliding_friction_r1 => F_mu_r1/(tiny_r1.powi(2) + overr1.powi(2)).sqrt()
                - F_mu_r1*overr1.powi(2)/(tiny_r1.powi(2) + overr1.powi(2)).powf(3.0/2.0);
        }
        F_tau_r1_by_F_mu_r1 { sliding_friction_r1 => overr1/(tiny_r1.powi(2) + overr1.powi(2)).sqrt(); }
        F_mu_s2_by_overs2 {
            sliding_friction_s2 => mu_s2*k_s2*touchs2*overs2*psi_s2_dot
                /((tiny_s2.powi(2) + overs2.powi(2)).sqrt()*(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt());
            flank_stiction_s2 => mu_s2*k_s2*slide_dir_s2*touchs2*overs2/(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                - mu_s2*k_s2*touchs2*overs2*psi_s2_dot
                /((tiny_s2.powi(2) + overs2.powi(2)).sqrt()*(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt());
        }
        F_mu_s2_by_psi_s2_dot {
            sliding_friction_s2 => mu_s2*k_s2*touchs2*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                /(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt()
                - mu_s2*k_s2*touchs2*psi_s2_dot.powi(2)*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                /(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_s2 => mu_s2*k_s2*touchs2*psi_s2_dot.powi(2)*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                /(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).powf(3.0/2.0)
                - mu_s2*k_s2*touchs2*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()/(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt();
        }
        F_mu_s2_by_k_s2 {
            sliding_friction_s2 => mu_s2*touchs2*psi_s2_dot*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                /(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt();
            flank_stiction_s2 => mu_s2*slide_dir_s2*touchs2*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                - mu_s2*touchs2*psi_s2_dot*(tiny_s2.powi(2) + overs2.powi(2)).sqrt()/(w_mix_s2.powi(2) + psi_s2_dot.powi(2)).sqrt();
        }
        F_tau_s2_by_overs2 {
            sliding_friction_s2 => F_mu_s2/(tiny_s2.powi(2) + overs2.powi(2)).sqrt()
                - F_mu_s2*overs2.powi(2)/(tiny_s2.powi(2) + overs2.powi(2)).powf(3.0/2.0);
        }
        F_tau_s2_by_F_mu_s2 { sliding_friction_s2 => overs2/(tiny_s2.powi(2) + overs2.powi(2)).sqrt(); }
        F_mu_r2_by_overr2 {
            sliding_friction_r2 => mu_r2*k_r2*touchr2*overr2*psi_r2_dot
                /((tiny_r2.powi(2) + overr2.powi(2)).sqrt()*(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt());
            flank_stiction_r2 => mu_r2*k_r2*slide_dir_r2*touchr2*overr2/(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                - mu_r2*k_r2*touchr2*overr2*psi_r2_dot
                /((tiny_r2.powi(2) + overr2.powi(2)).sqrt()*(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt());
        }
        F_mu_r2_by_psi_r2_dot {
            sliding_friction_r2 => mu_r2*k_r2*touchr2*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                /(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt()
                - mu_r2*k_r2*touchr2*psi_r2_dot.powi(2)*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                /(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_r2 => mu_r2*k_r2*touchr2*psi_r2_dot.powi(2)*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                /(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).powf(3.0/2.0)
                - mu_r2*k_r2*touchr2*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()/(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt();
        }
        F_mu_r2_by_k_r2 {
            sliding_friction_r2 => mu_r2*touchr2*psi_r2_dot*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                /(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt();
            flank_stiction_r2 => mu_r2*slide_dir_r2*touchr2*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                - mu_r2*touchr2*psi_r2_dot*(tiny_r2.powi(2) + overr2.powi(2)).sqrt()/(w_mix_r2.powi(2) + psi_r2_dot.powi(2)).sqrt();
        }
        F_tau_r2_by_overr2 {
            sliding_friction_r2 => F_mu_r2/(tiny_r2.powi(2) + overr2.powi(2)).sqrt()
                - F_mu_r2*overr2.powi(2)/(tiny_r2.powi(2) + overr2.powi(2)).powf(3.0/2.0);
        }
        F_tau_r2_by_F_mu_r2 { sliding_friction_r2 => overr2/(tiny_r2.powi(2) + overr2.powi(2)).sqrt(); }
        F_mu_s3_by_overs3 {
            sliding_friction_s3 => mu_s3*k_s3*touchs3*overs3*psi_s3_dot
                /((tiny_s3.powi(2) + overs3.powi(2)).sqrt()*(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt());
            flank_stiction_s3 => mu_s3*k_s3*slide_dir_s3*touchs3*overs3/(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                - mu_s3*k_s3*touchs3*overs3*psi_s3_dot
                /((tiny_s3.powi(2) + overs3.powi(2)).sqrt()*(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt());
        }
        F_mu_s3_by_psi_s3_dot {
            sliding_friction_s3 => mu_s3*k_s3*touchs3*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                /(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt()
                - mu_s3*k_s3*touchs3*psi_s3_dot.powi(2)*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                /(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_s3 => mu_s3*k_s3*touchs3*psi_s3_dot.powi(2)*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                /(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).powf(3.0/2.0)
                - mu_s3*k_s3*touchs3*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()/(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt();
        }
        F_mu_s3_by_k_s3 {
            sliding_friction_s3 => mu_s3*touchs3*psi_s3_dot*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                /(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt();
            flank_stiction_s3 => mu_s3*slide_dir_s3*touchs3*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                - mu_s3*touchs3*psi_s3_dot*(tiny_s3.powi(2) + overs3.powi(2)).sqrt()/(w_mix_s3.powi(2) + psi_s3_dot.powi(2)).sqrt();
        }
        F_tau_s3_by_overs3 {
            sliding_friction_s3 => F_mu_s3/(tiny_s3.powi(2) + overs3.powi(2)).sqrt()
                - F_mu_s3*overs3.powi(2)/(tiny_s3.powi(2) + overs3.powi(2)).powf(3.0/2.0);
        }
        F_tau_s3_by_F_mu_s3 { sliding_friction_s3 => overs3/(tiny_s3.powi(2) + overs3.powi(2)).sqrt(); }
        F_mu_r3_by_overr3 {
            sliding_friction_r3 => mu_r3*k_r3*touchr3*overr3*psi_r3_dot
                /((tiny_r3.powi(2) + overr3.powi(2)).sqrt()*(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt());
            flank_stiction_r3 => mu_r3*k_r3*slide_dir_r3*touchr3*overr3/(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                - mu_r3*k_r3*touchr3*overr3*psi_r3_dot
                /((tiny_r3.powi(2) + overr3.powi(2)).sqrt()*(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt());
        }
        F_mu_r3_by_psi_r3_dot {
            sliding_friction_r3 => mu_r3*k_r3*touchr3*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                /(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt()
                - mu_r3*k_r3*touchr3*psi_r3_dot.powi(2)*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                /(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).powf(3.0/2.0);
            flank_stiction_r3 => mu_r3*k_r3*touchr3*psi_r3_dot.powi(2)*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                /(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).powf(3.0/2.0)
                - mu_r3*k_r3*touchr3*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()/(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt();
        }
        F_mu_r3_by_k_r3 {
            sliding_friction_r3 => mu_r3*touchr3*psi_r3_dot*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                /(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt();
            flank_stiction_r3 => mu_r3*slide_dir_r3*touchr3*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                - mu_r3*touchr3*psi_r3_dot*(tiny_r3.powi(2) + overr3.powi(2)).sqrt()/(w_mix_r3.powi(2) + psi_r3_dot.powi(2)).sqrt();
        }
        F_tau_r3_by_overr3 {
            sliding_friction_r3 => F_mu_r3/(tiny_r3.powi(2) + overr3.powi(2)).sqrt()
                - F_mu_r3*overr3.powi(2)/(tiny_r3.powi(2) + overr3.powi(2)).powf(3.0/2.0);
        }
        F_tau_r3_by_F_mu_r3 { sliding_friction_r3 => overr3/(tiny_r3.powi(2) + overr3.powi(2)).sqrt(); }
        T_induction_motor_by_theta_motor_dot {
            induction_motor => 4.0*Tb_motor*sb_motor*(1.0 - theta_motor_dot/ns_motor).powi(2)
                /(ns_motor*(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2)).powi(2))
                - 2.0*Tb_motor*sb_motor/(ns_motor*(sb_motor.powi(2) + (1.0 - theta_motor_dot/ns_motor).powi(2)));
        }
        T_traction_motor_by_theta_motor_dot {
            traction_motor => -2.0*Tp_motor*d_motor
                *(per_wb_motor*(1.0 + per_wb_motor*theta_motor_dot)
                /(round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                - per_wb_motor*(1.0 - per_wb_motor*theta_motor_dot)
                /(round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt())
                /((round_motor.powi(2) + (1.0 - per_wb_motor*theta_motor_dot).powi(2)).sqrt()
                + (round_motor.powi(2) + (1.0 + per_wb_motor*theta_motor_dot).powi(2)).sqrt()).powi(2);
        }
        T_fan_motor_by_theta_motor_dot {
            fan_motor => -cf_motor*theta_motor_dot.powi(2)/(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt()
                - cf_motor*(w0_motor.powi(2) + theta_motor_dot.powi(2)).sqrt();
        }
        T_induction_load_by_theta_load_dot {
            induction_load => 4.0*Tb_load*sb_load*(1.0 - theta_load_dot/ns_load).powi(2)
                /(ns_load*(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2)).powi(2))
                - 2.0*Tb_load*sb_load/(ns_load*(sb_load.powi(2) + (1.0 - theta_load_dot/ns_load).powi(2)));
        }
        T_traction_load_by_theta_load_dot {
            traction_load => -2.0*Tp_load*d_load
                *(per_wb_load*(1.0 + per_wb_load*theta_load_dot)/(round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt()
                - per_wb_load*(1.0 - per_wb_load*theta_load_dot)/(round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt())
                /((round_load.powi(2) + (1.0 - per_wb_load*theta_load_dot).powi(2)).sqrt()
                + (round_load.powi(2) + (1.0 + per_wb_load*theta_load_dot).powi(2)).sqrt()).powi(2);
        }
        T_fan_load_by_theta_load_dot {
            fan_load => -cf_load*theta_load_dot.powi(2)/(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt()
                - cf_load*(w0_load.powi(2) + theta_load_dot.powi(2)).sqrt();
        }
    }
    switches {
        overs1 "m" (touchs1 1.0, edges1 0.0, damps1 1.0, clips1 0.0) with backlash_s1, "play of the mesh of sun and planet 1" {
            upper (1.0, b_s1/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overs1 { _ => 1.0; } }
                until upper_loose {
                    overs1 { _ => k_s1; }
                    overs1_dot { damping => beta_K*k_s1_mid; }
                }
                until upper_hit {
                    overs1 { _ => k_s1; }
                    overs1_dot { damping => -beta_K*k_s1_mid; }
                }
            }
            lower (1.0, -b_s1/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overs1 { _ => -1.0; } }
                until lower_loose {
                    overs1 { _ => -k_s1; }
                    overs1_dot { damping => -beta_K*k_s1_mid; }
                }
                until lower_hit {
                    overs1 { _ => -k_s1; }
                    overs1_dot { damping => beta_K*k_s1_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    overs1 { _ => -1.0; }
                    one { _ => b_s1/2.0; }
                }
                until lower {
                    overs1 { _ => 1.0; }
                    one { _ => b_s1/2.0; }
                }
            }
            upper_hit (1.0, b_s1/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overs1 { _ => 1.0; } }
                until upper {
                    overs1 { _ => -k_s1; }
                    overs1_dot { damping => beta_K*k_s1_mid; }
                }
            }
            lower_hit (1.0, -b_s1/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overs1 { _ => -1.0; } }
                until lower {
                    overs1 { _ => k_s1; }
                    overs1_dot { damping => -beta_K*k_s1_mid; }
                }
            }
            upper_loose (1.0, b_s1/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overs1 { _ => 1.0; } }
                until upper {
                    overs1 { _ => -k_s1; }
                    overs1_dot { damping => -beta_K*k_s1_mid; }
                }
            }
            lower_loose (1.0, -b_s1/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overs1 { _ => -1.0; } }
                until lower {
                    overs1 { _ => k_s1; }
                    overs1_dot { damping => beta_K*k_s1_mid; }
                }
            }
            loss { overs1 { _ => k_s1*clips1*touchs1; } }
        }
        psi_s1 "rad" (slide_dir_s1 0.0) with flank_stiction_s1, "whether the flanks of the mesh of sun and planet 1 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { overs1 { _ => 1.0; } }
                until forward {
                    overs1 { _ => mu_rise_s1*mu_s1*k_s1*touchs1 + mu_s1*k_s1*touchs1; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    overs1 { _ => mu_rise_s1*mu_s1*k_s1*touchs1 + mu_s1*k_s1*touchs1; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { overs1 { _ => -1.0; } }
                until forward_coast {
                    overs1 { _ => -mu_rise_s1*mu_s1*k_s1*touchs1 - mu_s1*k_s1*touchs1; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    overs1 { _ => -mu_rise_s1*mu_s1*k_s1*touchs1 - mu_s1*k_s1*touchs1; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { overs1 { _ => 1.0; } }
                until stuck {
                    psi_s1_dot { _ => arm_s1; }
                    tau_s1_dot { _ => side_s1; }
                }
            }
            backward (-1.0) {
                until backward_coast { overs1 { _ => 1.0; } }
                until stuck {
                    psi_s1_dot { _ => -arm_s1; }
                    tau_s1_dot { _ => -side_s1; }
                }
            }
            forward_coast (1.0) {
                until forward { overs1 { _ => -1.0; } }
                until stuck_coast {
                    psi_s1_dot { _ => arm_s1; }
                    tau_s1_dot { _ => -side_s1; }
                }
            }
            backward_coast (-1.0) {
                until backward { overs1 { _ => -1.0; } }
                until stuck_coast {
                    psi_s1_dot { _ => -arm_s1; }
                    tau_s1_dot { _ => side_s1; }
                }
            }
        }
        overr1 "m" (touchr1 1.0, edger1 0.0, dampr1 1.0, clipr1 0.0) with backlash_r1, "play of the mesh of ring and planet 1" {
            upper (1.0, b_r1/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overr1 { _ => 1.0; } }
                until upper_loose {
                    overr1 { _ => k_r1; }
                    overr1_dot { damping => beta_K*k_r1_mid; }
                }
                until upper_hit {
                    overr1 { _ => k_r1; }
                    overr1_dot { damping => -beta_K*k_r1_mid; }
                }
            }
            lower (1.0, -b_r1/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overr1 { _ => -1.0; } }
                until lower_loose {
                    overr1 { _ => -k_r1; }
                    overr1_dot { damping => -beta_K*k_r1_mid; }
                }
                until lower_hit {
                    overr1 { _ => -k_r1; }
                    overr1_dot { damping => beta_K*k_r1_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    overr1 { _ => -1.0; }
                    one { _ => b_r1/2.0; }
                }
                until lower {
                    overr1 { _ => 1.0; }
                    one { _ => b_r1/2.0; }
                }
            }
            upper_hit (1.0, b_r1/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overr1 { _ => 1.0; } }
                until upper {
                    overr1 { _ => -k_r1; }
                    overr1_dot { damping => beta_K*k_r1_mid; }
                }
            }
            lower_hit (1.0, -b_r1/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overr1 { _ => -1.0; } }
                until lower {
                    overr1 { _ => k_r1; }
                    overr1_dot { damping => -beta_K*k_r1_mid; }
                }
            }
            upper_loose (1.0, b_r1/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overr1 { _ => 1.0; } }
                until upper {
                    overr1 { _ => -k_r1; }
                    overr1_dot { damping => -beta_K*k_r1_mid; }
                }
            }
            lower_loose (1.0, -b_r1/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overr1 { _ => -1.0; } }
                until lower {
                    overr1 { _ => k_r1; }
                    overr1_dot { damping => beta_K*k_r1_mid; }
                }
            }
            loss { overr1 { _ => k_r1*clipr1*touchr1; } }
        }
        psi_r1 "rad" (slide_dir_r1 0.0) with flank_stiction_r1, "whether the flanks of the mesh of ring and planet 1 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { overr1 { _ => 1.0; } }
                until forward {
                    overr1 { _ => mu_r1*mu_rise_r1*k_r1*touchr1 + mu_r1*k_r1*touchr1; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    overr1 { _ => mu_r1*mu_rise_r1*k_r1*touchr1 + mu_r1*k_r1*touchr1; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { overr1 { _ => -1.0; } }
                until forward_coast {
                    overr1 { _ => -mu_r1*mu_rise_r1*k_r1*touchr1 - mu_r1*k_r1*touchr1; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    overr1 { _ => -mu_r1*mu_rise_r1*k_r1*touchr1 - mu_r1*k_r1*touchr1; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { overr1 { _ => 1.0; } }
                until stuck {
                    psi_r1_dot { _ => arm_r1; }
                    tau_r1_dot { _ => side_r1; }
                }
            }
            backward (-1.0) {
                until backward_coast { overr1 { _ => 1.0; } }
                until stuck {
                    psi_r1_dot { _ => -arm_r1; }
                    tau_r1_dot { _ => -side_r1; }
                }
            }
            forward_coast (1.0) {
                until forward { overr1 { _ => -1.0; } }
                until stuck_coast {
                    psi_r1_dot { _ => arm_r1; }
                    tau_r1_dot { _ => -side_r1; }
                }
            }
            backward_coast (-1.0) {
                until backward { overr1 { _ => -1.0; } }
                until stuck_coast {
                    psi_r1_dot { _ => -arm_r1; }
                    tau_r1_dot { _ => side_r1; }
                }
            }
        }
        overs2 "m" (touchs2 1.0, edges2 0.0, damps2 1.0, clips2 0.0) with backlash_s2, "play of the mesh of sun and planet 2" {
            upper (1.0, b_s2/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overs2 { _ => 1.0; } }
                until upper_loose {
                    overs2 { _ => k_s2; }
                    overs2_dot { damping => beta_K*k_s2_mid; }
                }
                until upper_hit {
                    overs2 { _ => k_s2; }
                    overs2_dot { damping => -beta_K*k_s2_mid; }
                }
            }
            lower (1.0, -b_s2/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overs2 { _ => -1.0; } }
                until lower_loose {
                    overs2 { _ => -k_s2; }
                    overs2_dot { damping => -beta_K*k_s2_mid; }
                }
                until lower_hit {
                    overs2 { _ => -k_s2; }
                    overs2_dot { damping => beta_K*k_s2_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    overs2 { _ => -1.0; }
                    one { _ => b_s2/2.0; }
                }
                until lower {
                    overs2 { _ => 1.0; }
                    one { _ => b_s2/2.0; }
                }
            }
            upper_hit (1.0, b_s2/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overs2 { _ => 1.0; } }
                until upper {
                    overs2 { _ => -k_s2; }
                    overs2_dot { damping => beta_K*k_s2_mid; }
                }
            }
            lower_hit (1.0, -b_s2/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overs2 { _ => -1.0; } }
                until lower {
                    overs2 { _ => k_s2; }
                    overs2_dot { damping => -beta_K*k_s2_mid; }
                }
            }
            upper_loose (1.0, b_s2/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overs2 { _ => 1.0; } }
                until upper {
                    overs2 { _ => -k_s2; }
                    overs2_dot { damping => -beta_K*k_s2_mid; }
                }
            }
            lower_loose (1.0, -b_s2/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overs2 { _ => -1.0; } }
                until lower {
                    overs2 { _ => k_s2; }
                    overs2_dot { damping => beta_K*k_s2_mid; }
                }
            }
            loss { overs2 { _ => k_s2*clips2*touchs2; } }
        }
        psi_s2 "rad" (slide_dir_s2 0.0) with flank_stiction_s2, "whether the flanks of the mesh of sun and planet 2 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { overs2 { _ => 1.0; } }
                until forward {
                    overs2 { _ => mu_rise_s2*mu_s2*k_s2*touchs2 + mu_s2*k_s2*touchs2; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    overs2 { _ => mu_rise_s2*mu_s2*k_s2*touchs2 + mu_s2*k_s2*touchs2; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { overs2 { _ => -1.0; } }
                until forward_coast {
                    overs2 { _ => -mu_rise_s2*mu_s2*k_s2*touchs2 - mu_s2*k_s2*touchs2; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    overs2 { _ => -mu_rise_s2*mu_s2*k_s2*touchs2 - mu_s2*k_s2*touchs2; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { overs2 { _ => 1.0; } }
                until stuck {
                    psi_s2_dot { _ => arm_s2; }
                    tau_s2_dot { _ => side_s2; }
                }
            }
            backward (-1.0) {
                until backward_coast { overs2 { _ => 1.0; } }
                until stuck {
                    psi_s2_dot { _ => -arm_s2; }
                    tau_s2_dot { _ => -side_s2; }
                }
            }
            forward_coast (1.0) {
                until forward { overs2 { _ => -1.0; } }
                until stuck_coast {
                    psi_s2_dot { _ => arm_s2; }
                    tau_s2_dot { _ => -side_s2; }
                }
            }
            backward_coast (-1.0) {
                until backward { overs2 { _ => -1.0; } }
                until stuck_coast {
                    psi_s2_dot { _ => -arm_s2; }
                    tau_s2_dot { _ => side_s2; }
                }
            }
        }
        overr2 "m" (touchr2 1.0, edger2 0.0, dampr2 1.0, clipr2 0.0) with backlash_r2, "play of the mesh of ring and planet 2" {
            upper (1.0, b_r2/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overr2 { _ => 1.0; } }
                until upper_loose {
                    overr2 { _ => k_r2; }
                    overr2_dot { damping => beta_K*k_r2_mid; }
                }
                until upper_hit {
                    overr2 { _ => k_r2; }
                    overr2_dot { damping => -beta_K*k_r2_mid; }
                }
            }
            lower (1.0, -b_r2/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overr2 { _ => -1.0; } }
                until lower_loose {
                    overr2 { _ => -k_r2; }
                    overr2_dot { damping => -beta_K*k_r2_mid; }
                }
                until lower_hit {
                    overr2 { _ => -k_r2; }
                    overr2_dot { damping => beta_K*k_r2_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    overr2 { _ => -1.0; }
                    one { _ => b_r2/2.0; }
                }
                until lower {
                    overr2 { _ => 1.0; }
                    one { _ => b_r2/2.0; }
                }
            }
            upper_hit (1.0, b_r2/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overr2 { _ => 1.0; } }
                until upper {
                    overr2 { _ => -k_r2; }
                    overr2_dot { damping => beta_K*k_r2_mid; }
                }
            }
            lower_hit (1.0, -b_r2/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overr2 { _ => -1.0; } }
                until lower {
                    overr2 { _ => k_r2; }
                    overr2_dot { damping => -beta_K*k_r2_mid; }
                }
            }
            upper_loose (1.0, b_r2/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overr2 { _ => 1.0; } }
                until upper {
                    overr2 { _ => -k_r2; }
                    overr2_dot { damping => -beta_K*k_r2_mid; }
                }
            }
            lower_loose (1.0, -b_r2/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overr2 { _ => -1.0; } }
                until lower {
                    overr2 { _ => k_r2; }
                    overr2_dot { damping => beta_K*k_r2_mid; }
                }
            }
            loss { overr2 { _ => k_r2*clipr2*touchr2; } }
        }
        psi_r2 "rad" (slide_dir_r2 0.0) with flank_stiction_r2, "whether the flanks of the mesh of ring and planet 2 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { overr2 { _ => 1.0; } }
                until forward {
                    overr2 { _ => mu_r2*mu_rise_r2*k_r2*touchr2 + mu_r2*k_r2*touchr2; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    overr2 { _ => mu_r2*mu_rise_r2*k_r2*touchr2 + mu_r2*k_r2*touchr2; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { overr2 { _ => -1.0; } }
                until forward_coast {
                    overr2 { _ => -mu_r2*mu_rise_r2*k_r2*touchr2 - mu_r2*k_r2*touchr2; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    overr2 { _ => -mu_r2*mu_rise_r2*k_r2*touchr2 - mu_r2*k_r2*touchr2; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { overr2 { _ => 1.0; } }
                until stuck {
                    psi_r2_dot { _ => arm_r2; }
                    tau_r2_dot { _ => side_r2; }
                }
            }
            backward (-1.0) {
                until backward_coast { overr2 { _ => 1.0; } }
                until stuck {
                    psi_r2_dot { _ => -arm_r2; }
                    tau_r2_dot { _ => -side_r2; }
                }
            }
            forward_coast (1.0) {
                until forward { overr2 { _ => -1.0; } }
                until stuck_coast {
                    psi_r2_dot { _ => arm_r2; }
                    tau_r2_dot { _ => -side_r2; }
                }
            }
            backward_coast (-1.0) {
                until backward { overr2 { _ => -1.0; } }
                until stuck_coast {
                    psi_r2_dot { _ => -arm_r2; }
                    tau_r2_dot { _ => side_r2; }
                }
            }
        }
        overs3 "m" (touchs3 1.0, edges3 0.0, damps3 1.0, clips3 0.0) with backlash_s3, "play of the mesh of sun and planet 3" {
            upper (1.0, b_s3/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overs3 { _ => 1.0; } }
                until upper_loose {
                    overs3 { _ => k_s3; }
                    overs3_dot { damping => beta_K*k_s3_mid; }
                }
                until upper_hit {
                    overs3 { _ => k_s3; }
                    overs3_dot { damping => -beta_K*k_s3_mid; }
                }
            }
            lower (1.0, -b_s3/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overs3 { _ => -1.0; } }
                until lower_loose {
                    overs3 { _ => -k_s3; }
                    overs3_dot { damping => -beta_K*k_s3_mid; }
                }
                until lower_hit {
                    overs3 { _ => -k_s3; }
                    overs3_dot { damping => beta_K*k_s3_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    overs3 { _ => -1.0; }
                    one { _ => b_s3/2.0; }
                }
                until lower {
                    overs3 { _ => 1.0; }
                    one { _ => b_s3/2.0; }
                }
            }
            upper_hit (1.0, b_s3/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overs3 { _ => 1.0; } }
                until upper {
                    overs3 { _ => -k_s3; }
                    overs3_dot { damping => beta_K*k_s3_mid; }
                }
            }
            lower_hit (1.0, -b_s3/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overs3 { _ => -1.0; } }
                until lower {
                    overs3 { _ => k_s3; }
                    overs3_dot { damping => -beta_K*k_s3_mid; }
                }
            }
            upper_loose (1.0, b_s3/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overs3 { _ => 1.0; } }
                until upper {
                    overs3 { _ => -k_s3; }
                    overs3_dot { damping => -beta_K*k_s3_mid; }
                }
            }
            lower_loose (1.0, -b_s3/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overs3 { _ => -1.0; } }
                until lower {
                    overs3 { _ => k_s3; }
                    overs3_dot { damping => beta_K*k_s3_mid; }
                }
            }
            loss { overs3 { _ => k_s3*clips3*touchs3; } }
        }
        psi_s3 "rad" (slide_dir_s3 0.0) with flank_stiction_s3, "whether the flanks of the mesh of sun and planet 3 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { overs3 { _ => 1.0; } }
                until forward {
                    overs3 { _ => mu_rise_s3*mu_s3*k_s3*touchs3 + mu_s3*k_s3*touchs3; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    overs3 { _ => mu_rise_s3*mu_s3*k_s3*touchs3 + mu_s3*k_s3*touchs3; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { overs3 { _ => -1.0; } }
                until forward_coast {
                    overs3 { _ => -mu_rise_s3*mu_s3*k_s3*touchs3 - mu_s3*k_s3*touchs3; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    overs3 { _ => -mu_rise_s3*mu_s3*k_s3*touchs3 - mu_s3*k_s3*touchs3; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { overs3 { _ => 1.0; } }
                until stuck {
                    psi_s3_dot { _ => arm_s3; }
                    tau_s3_dot { _ => side_s3; }
                }
            }
            backward (-1.0) {
                until backward_coast { overs3 { _ => 1.0; } }
                until stuck {
                    psi_s3_dot { _ => -arm_s3; }
                    tau_s3_dot { _ => -side_s3; }
                }
            }
            forward_coast (1.0) {
                until forward { overs3 { _ => -1.0; } }
                until stuck_coast {
                    psi_s3_dot { _ => arm_s3; }
                    tau_s3_dot { _ => -side_s3; }
                }
            }
            backward_coast (-1.0) {
                until backward { overs3 { _ => -1.0; } }
                until stuck_coast {
                    psi_s3_dot { _ => -arm_s3; }
                    tau_s3_dot { _ => side_s3; }
                }
            }
        }
        overr3 "m" (touchr3 1.0, edger3 0.0, dampr3 1.0, clipr3 0.0) with backlash_r3, "play of the mesh of ring and planet 3" {
            upper (1.0, b_r3/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overr3 { _ => 1.0; } }
                until upper_loose {
                    overr3 { _ => k_r3; }
                    overr3_dot { damping => beta_K*k_r3_mid; }
                }
                until upper_hit {
                    overr3 { _ => k_r3; }
                    overr3_dot { damping => -beta_K*k_r3_mid; }
                }
            }
            lower (1.0, -b_r3/2.0, 1.0, 0.0) rests counts "flanks met" {
                unless free { overr3 { _ => -1.0; } }
                until lower_loose {
                    overr3 { _ => -k_r3; }
                    overr3_dot { damping => -beta_K*k_r3_mid; }
                }
                until lower_hit {
                    overr3 { _ => -k_r3; }
                    overr3_dot { damping => beta_K*k_r3_mid; }
                }
            }
            free (0.0, 0.0, 0.0, 0.0) rests {
                until upper {
                    overr3 { _ => -1.0; }
                    one { _ => b_r3/2.0; }
                }
                until lower {
                    overr3 { _ => 1.0; }
                    one { _ => b_r3/2.0; }
                }
            }
            upper_hit (1.0, b_r3/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overr3 { _ => 1.0; } }
                until upper {
                    overr3 { _ => -k_r3; }
                    overr3_dot { damping => beta_K*k_r3_mid; }
                }
            }
            lower_hit (1.0, -b_r3/2.0, 0.0, 1.0) counts "flanks met" {
                unless free { overr3 { _ => -1.0; } }
                until lower {
                    overr3 { _ => k_r3; }
                    overr3_dot { damping => -beta_K*k_r3_mid; }
                }
            }
            upper_loose (1.0, b_r3/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overr3 { _ => 1.0; } }
                until upper {
                    overr3 { _ => -k_r3; }
                    overr3_dot { damping => -beta_K*k_r3_mid; }
                }
            }
            lower_loose (1.0, -b_r3/2.0, 0.0, -1.0) counts "flanks met" {
                until free { overr3 { _ => -1.0; } }
                until lower {
                    overr3 { _ => k_r3; }
                    overr3_dot { damping => beta_K*k_r3_mid; }
                }
            }
            loss { overr3 { _ => k_r3*clipr3*touchr3; } }
        }
        psi_r3 "rad" (slide_dir_r3 0.0) with flank_stiction_r3, "whether the flanks of the mesh of ring and planet 3 stick" {
            stuck (0.0) holds rests counts "stuck" {
                unless stuck_coast { overr3 { _ => 1.0; } }
                until forward {
                    overr3 { _ => mu_r3*mu_rise_r3*k_r3*touchr3 + mu_r3*k_r3*touchr3; }
                    reaction { _ => -1.0; }
                }
                until backward {
                    overr3 { _ => mu_r3*mu_rise_r3*k_r3*touchr3 + mu_r3*k_r3*touchr3; }
                    reaction { _ => 1.0; }
                }
            }
            stuck_coast (0.0) holds rests counts "stuck" {
                unless stuck { overr3 { _ => -1.0; } }
                until forward_coast {
                    overr3 { _ => -mu_r3*mu_rise_r3*k_r3*touchr3 - mu_r3*k_r3*touchr3; }
                    reaction { _ => -1.0; }
                }
                until backward_coast {
                    overr3 { _ => -mu_r3*mu_rise_r3*k_r3*touchr3 - mu_r3*k_r3*touchr3; }
                    reaction { _ => 1.0; }
                }
            }
            forward (1.0) {
                until forward_coast { overr3 { _ => 1.0; } }
                until stuck {
                    psi_r3_dot { _ => arm_r3; }
                    tau_r3_dot { _ => side_r3; }
                }
            }
            backward (-1.0) {
                until backward_coast { overr3 { _ => 1.0; } }
                until stuck {
                    psi_r3_dot { _ => -arm_r3; }
                    tau_r3_dot { _ => -side_r3; }
                }
            }
            forward_coast (1.0) {
                until forward { overr3 { _ => -1.0; } }
                until stuck_coast {
                    psi_r3_dot { _ => arm_r3; }
                    tau_r3_dot { _ => -side_r3; }
                }
            }
            backward_coast (-1.0) {
                until backward { overr3 { _ => -1.0; } }
                until stuck_coast {
                    psi_r3_dot { _ => -arm_r3; }
                    tau_r3_dot { _ => side_r3; }
                }
            }
        }
    }
    energies {
        kinetic {
            _ => I_c*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*theta_r_dot.powi(2)/2.0
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0
                + 3.0*a.powi(2)*m_p*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0;
        }
        potential {
            _ => (k_r*twist_r.powi(2) + k_r1*touchr1*overr1.powi(2) + k_r2*touchr2*overr2.powi(2) + k_r3*touchr3*overr3.powi(2)
                + k_s1*touchs1*overs1.powi(2) + k_s2*touchs2*overs2.powi(2) + k_s3*touchs3*overs3.powi(2))/2.0;
            torsional_support_s => k_s*twist_s.powi(2)/2.0;
            torsional_support_c => k_c*twist_c.powi(2)/2.0;
        }
        dissipation {
            torsional_support_s_and_damping => beta_K*k_s*twist_s_dot.powi(2)/2.0;
            torsional_support_c_and_damping => beta_K*k_c*twist_c_dot.powi(2)/2.0;
            governor_motor => c_motor*theta_motor_dot.powi(2)/2.0;
            dc_motor => Ts_motor*theta_motor_dot.powi(2)/(2.0*n0_motor);
            governor_load => c_load*theta_load_dot.powi(2)/2.0;
            dc_load => Ts_load*theta_load_dot.powi(2)/(2.0*n0_load);
            damping => I_c*alpha_M*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*alpha_M*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*alpha_M*theta_r_dot.powi(2)/2.0
                + I_s*alpha_M*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0 + beta_K*k_r*twist_r_dot.powi(2)/2.0
                + beta_K*k_r1_mid*dampr1*overr1_dot.powi(2)/2.0 + beta_K*k_r2_mid*dampr2*overr2_dot.powi(2)/2.0
                + beta_K*k_r3_mid*dampr3*overr3_dot.powi(2)/2.0 + beta_K*k_s1_mid*damps1*overs1_dot.powi(2)/2.0
                + beta_K*k_s2_mid*damps2*overs2_dot.powi(2)/2.0 + beta_K*k_s3_mid*damps3*overs3_dot.powi(2)/2.0
                + 3.0*a.powi(2)*alpha_M*m_p*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0;
        }
    }
    torques {
        slide_s1 "friction of the mesh of sun and planet 1, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_s1 => -side_s1*F_tau_s1*tau_s1_dot; }
        roll_s1 "friction of the mesh of sun and planet 1, through the rolling of the gears" {}
        power { sliding_friction_s1 => -arm_s1*F_mu_s1*psi_s1_dot; }
        slide_r1 "friction of the mesh of ring and planet 1, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_r1 => -side_r1*F_tau_r1*tau_r1_dot; }
        roll_r1 "friction of the mesh of ring and planet 1, through the rolling of the gears" {}
        power { sliding_friction_r1 => -arm_r1*F_mu_r1*psi_r1_dot; }
        slide_s2 "friction of the mesh of sun and planet 2, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_s2 => -side_s2*F_tau_s2*tau_s2_dot; }
        roll_s2 "friction of the mesh of sun and planet 2, through the rolling of the gears" {}
        power { sliding_friction_s2 => -arm_s2*F_mu_s2*psi_s2_dot; }
        slide_r2 "friction of the mesh of ring and planet 2, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_r2 => -side_r2*F_tau_r2*tau_r2_dot; }
        roll_r2 "friction of the mesh of ring and planet 2, through the rolling of the gears" {}
        power { sliding_friction_r2 => -arm_r2*F_mu_r2*psi_r2_dot; }
        slide_s3 "friction of the mesh of sun and planet 3, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_s3 => -side_s3*F_tau_s3*tau_s3_dot; }
        roll_s3 "friction of the mesh of sun and planet 3, through the rolling of the gears" {}
        power { sliding_friction_s3 => -arm_s3*F_mu_s3*psi_s3_dot; }
        slide_r3 "friction of the mesh of ring and planet 3, through the sliding of the flanks at the pitch point" {}
        power { sliding_friction_r3 => -side_r3*F_tau_r3*tau_r3_dot; }
        roll_r3 "friction of the mesh of ring and planet 3, through the rolling of the gears" {}
        power { sliding_friction_r3 => -arm_r3*F_mu_r3*psi_r3_dot; }
        motor "driving torque of the sun" { torques => T_motor*(theta_c + theta*(1.0/Z_r + 1.0/Z_s)); }
        governor_motor "torque c n of the governor of the sun; its part -c omega is in D" {
            governor_motor => c_motor*n_motor*(theta_c + theta*(1.0/Z_r + 1.0/Z_s));
        }
        dc_motor "torque Ts of the DC motor of the sun; its part -Ts omega/n0 is in D" {
            dc_motor => Ts_motor*(theta_c + theta*(1.0/Z_r + 1.0/Z_s));
        }
        induction_motor "torque of the induction motor of the sun" {}
        power { induction_motor => T_induction_motor*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)); }
        traction_motor "torque of the traction motor of the sun" {}
        power { traction_motor => T_traction_motor*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)); }
        fan_motor "torque of the fan of the sun, against the rotation" {}
        power { fan_motor => T_fan_motor*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)); }
        load "load torque of the carrier, against its rotation" { torques => T_load*(-theta_c - theta/Z_r); }
        governor_load "torque c n of the governor of the carrier; its part -c omega is in D" {
            governor_load => c_load*n_load*(theta_c + theta/Z_r);
        }
        dc_load "torque Ts of the DC motor of the carrier; its part -Ts omega/n0 is in D" { dc_load => Ts_load*(theta_c + theta/Z_r); }
        induction_load "torque of the induction motor of the carrier" {}
        power { induction_load => T_induction_load*(theta_c_dot + theta_dot/Z_r); }
        traction_load "torque of the traction motor of the carrier" {}
        power { traction_load => T_traction_load*(theta_c_dot + theta_dot/Z_r); }
        fan_load "torque of the fan of the carrier, against the rotation" {}
        power { fan_load => T_fan_load*(theta_c_dot + theta_dot/Z_r); }
    }
    work {
        theta {
            torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
            governor_motor => c_motor*n_motor/Z_r + c_motor*n_motor/Z_s;
            dc_motor => Ts_motor/Z_r + Ts_motor/Z_s;
            governor_load => c_load*n_load/Z_r;
            dc_load => Ts_load/Z_r;
        }
        theta_c {
            torques => T_motor - T_load;
            governor_motor => c_motor*n_motor;
            dc_motor => Ts_motor;
            governor_load => c_load*n_load;
            dc_load => Ts_load;
        }
    }
    mass {
        theta theta {
            _ => I_c/Z_r.powi(2) - 6.0*h*I_p/(r_p*Z_r) + 3.0*I_p/Z_r.powi(2) + I_s/Z_r.powi(2) + 2.0*I_s/(Z_r*Z_s) + I_s/Z_s.powi(2)
                + 3.0*a.powi(2)*m_p/Z_r.powi(2) + 3.0*h.powi(2)*I_p/r_p.powi(2);
        }
        theta theta_c { _ => I_c/Z_r - 3.0*h*I_p/r_p + 3.0*I_p/Z_r + I_s/Z_r + I_s/Z_s + 3.0*a.powi(2)*m_p/Z_r; }
        theta u1 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta u2 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta u3 { _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2); }
        theta_c theta_c { _ => I_c + 3.0*I_p + I_s + 3.0*a.powi(2)*m_p; }
        theta_c u1 { _ => I_p/r_p; }
        theta_c u2 { _ => I_p/r_p; }
        theta_c u3 { _ => I_p/r_p; }
        theta_r theta_r { _ => I_r; }
        u1 u1 { _ => I_p/r_p.powi(2); }
        u2 u2 { _ => I_p/r_p.powi(2); }
        u3 u3 { _ => I_p/r_p.powi(2); }
    }
    force {
        theta {
            torsional_support_s => -k_s*twist_s/Z_r - k_s*twist_s/Z_s;
            torsional_support_s_and_damping => -beta_K*k_s*twist_s_dot/Z_r - beta_K*k_s*twist_s_dot/Z_s;
            torsional_support_c => -k_c*twist_c/Z_r;
            torsional_support_c_and_damping => -beta_K*k_c*twist_c_dot/Z_r;
            transmission_error_s1_and_jump_terms => k_s1*de_s1*touchs1*overs1;
            sliding_friction_s1 => -roll_s*arm_s1*F_mu_s1;
            transmission_error_r1_and_jump_terms => k_r1*de_r1*touchr1*overr1;
            sliding_friction_r1 => -roll_r*arm_r1*F_mu_r1;
            transmission_error_s2_and_jump_terms => k_s2*de_s2*touchs2*overs2;
            sliding_friction_s2 => -roll_s*arm_s2*F_mu_s2;
            transmission_error_r2_and_jump_terms => k_r2*de_r2*touchr2*overr2;
            sliding_friction_r2 => -roll_r*arm_r2*F_mu_r2;
            transmission_error_s3_and_jump_terms => k_s3*de_s3*touchs3*overs3;
            sliding_friction_s3 => -roll_s*arm_s3*F_mu_s3;
            transmission_error_r3_and_jump_terms => k_r3*de_r3*touchr3*overr3;
            sliding_friction_r3 => -roll_r*arm_r3*F_mu_r3;
            torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
            governor_motor => c_motor*n_motor/Z_r - c_motor*theta_motor_dot/Z_r + c_motor*n_motor/Z_s - c_motor*theta_motor_dot/Z_s;
            dc_motor => Ts_motor/Z_r - Ts_motor*theta_motor_dot/(Z_r*n0_motor) + Ts_motor/Z_s - Ts_motor*theta_motor_dot/(Z_s*n0_motor);
            induction_motor => T_induction_motor/Z_r + T_induction_motor/Z_s;
            traction_motor => T_traction_motor/Z_r + T_traction_motor/Z_s;
            fan_motor => T_fan_motor/Z_r + T_fan_motor/Z_s;
            governor_load => c_load*n_load/Z_r - c_load*theta_load_dot/Z_r;
            dc_load => Ts_load/Z_r - Ts_load*theta_load_dot/(Z_r*n0_load);
            induction_load => T_induction_load/Z_r;
            traction_load => T_traction_load/Z_r;
            fan_load => T_fan_load/Z_r;
            damping => h*I_p*alpha_M*u1_dot/r_p.powi(2) + h*I_p*alpha_M*u2_dot/r_p.powi(2) + h*I_p*alpha_M*u3_dot/r_p.powi(2)
                + 3.0*h*I_p*alpha_M*theta_c_dot/r_p + 6.0*h*I_p*alpha_M*theta_dot/(r_p*Z_r) - I_c*alpha_M*theta_dot/Z_r.powi(2)
                - I_c*alpha_M*theta_c_dot/Z_r - 3.0*I_p*alpha_M*theta_dot/Z_r.powi(2) - 3.0*I_p*alpha_M*theta_c_dot/Z_r
                - I_s*alpha_M*theta_dot/Z_r.powi(2) - I_s*alpha_M*theta_c_dot/Z_r - 2.0*I_s*alpha_M*theta_dot/(Z_r*Z_s)
                - I_s*alpha_M*theta_dot/Z_s.powi(2) - I_s*alpha_M*theta_c_dot/Z_s - 3.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r.powi(2)
                - 3.0*a.powi(2)*alpha_M*m_p*theta_c_dot/Z_r - 3.0*h.powi(2)*I_p*alpha_M*theta_dot/r_p.powi(2)
                - I_p*alpha_M*u1_dot/(r_p*Z_r) - I_p*alpha_M*u2_dot/(r_p*Z_r) - I_p*alpha_M*u3_dot/(r_p*Z_r);
            jump_terms => (-dk_r1*touchr1*overr1.powi(2) - dk_r2*touchr2*overr2.powi(2) - dk_r3*touchr3*overr3.powi(2)
                - dk_s1*touchs1*overs1.powi(2) - dk_s2*touchs2*overs2.powi(2) - dk_s3*touchs3*overs3.powi(2))/2.0;
        }
        theta_c {
            _ => h*Z_r*k_r1*touchr1*overr1 + h*Z_r*k_r2*touchr2*overr2 + h*Z_r*k_r3*touchr3*overr3;
            torsional_support_s => -k_s*twist_s;
            torsional_support_s_and_damping => -beta_K*k_s*twist_s_dot;
            torsional_support_c => -k_c*twist_c;
            torsional_support_c_and_damping => -beta_K*k_c*twist_c_dot;
            backlash_r1 => h*Z_r*k_r1*clipr1*touchr1*overr1;
            sliding_friction_r1 => arm_r1*F_mu_r1 + h*sin_a*Z_r*side_r1*F_tau_r1/cos_a;
            backlash_r2 => h*Z_r*k_r2*clipr2*touchr2*overr2;
            sliding_friction_r2 => arm_r2*F_mu_r2 + h*sin_a*Z_r*side_r2*F_tau_r2/cos_a;
            backlash_r3 => h*Z_r*k_r3*clipr3*touchr3*overr3;
            sliding_friction_r3 => arm_r3*F_mu_r3 + h*sin_a*Z_r*side_r3*F_tau_r3/cos_a;
            torques => T_motor - T_load;
            governor_motor => c_motor*n_motor - c_motor*theta_motor_dot;
            dc_motor => Ts_motor - Ts_motor*theta_motor_dot/n0_motor;
            induction_motor => T_induction_motor;
            traction_motor => T_traction_motor;
            fan_motor => T_fan_motor;
            governor_load => c_load*n_load - c_load*theta_load_dot;
            dc_load => Ts_load - Ts_load*theta_load_dot/n0_load;
            induction_load => T_induction_load;
            traction_load => T_traction_load;
            fan_load => T_fan_load;
            damping => h*Z_r*beta_K*k_r1_mid*dampr1*overr1_dot + h*Z_r*beta_K*k_r2_mid*dampr2*overr2_dot
                + h*Z_r*beta_K*k_r3_mid*dampr3*overr3_dot + 3.0*h*I_p*alpha_M*theta_dot/r_p - I_c*alpha_M*theta_c_dot
                - I_c*alpha_M*theta_dot/Z_r - 3.0*I_p*alpha_M*theta_c_dot - 3.0*I_p*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_c_dot
                - I_s*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_dot/Z_s - 3.0*a.powi(2)*alpha_M*m_p*theta_c_dot
                - 3.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r - I_p*alpha_M*u1_dot/r_p - I_p*alpha_M*u2_dot/r_p - I_p*alpha_M*u3_dot/r_p;
        }
        theta_r {
            _ => -h*Z_r*k_r1*touchr1*overr1 - h*Z_r*k_r2*touchr2*overr2 - h*Z_r*k_r3*touchr3*overr3 - k_r*twist_r;
            backlash_r1 => -h*Z_r*k_r1*clipr1*touchr1*overr1;
            sliding_friction_r1 => -arm_r1*F_mu_r1 - h*sin_a*Z_r*side_r1*F_tau_r1/cos_a;
            backlash_r2 => -h*Z_r*k_r2*clipr2*touchr2*overr2;
            sliding_friction_r2 => -arm_r2*F_mu_r2 - h*sin_a*Z_r*side_r2*F_tau_r2/cos_a;
            backlash_r3 => -h*Z_r*k_r3*clipr3*touchr3*overr3;
            sliding_friction_r3 => -arm_r3*F_mu_r3 - h*sin_a*Z_r*side_r3*F_tau_r3/cos_a;
            damping => -h*Z_r*beta_K*k_r1_mid*dampr1*overr1_dot - h*Z_r*beta_K*k_r2_mid*dampr2*overr2_dot
                - h*Z_r*beta_K*k_r3_mid*dampr3*overr3_dot - I_r*alpha_M*theta_r_dot - beta_K*k_r*twist_r_dot;
        }
        u1 {
            _ => k_r1*touchr1*overr1 - k_s1*touchs1*overs1;
            backlash_s1 => -k_s1*clips1*touchs1*overs1;
            sliding_friction_s1 => arm_s1*F_mu_s1/r_p - sin_a*side_s1*F_tau_s1/cos_a;
            backlash_r1 => k_r1*clipr1*touchr1*overr1;
            sliding_friction_r1 => sin_a*side_r1*F_tau_r1/cos_a + arm_r1*F_mu_r1/r_p;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r1_mid*dampr1*overr1_dot - beta_K*k_s1_mid*damps1*overs1_dot
                - I_p*alpha_M*u1_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u2 {
            _ => k_r2*touchr2*overr2 - k_s2*touchs2*overs2;
            backlash_s2 => -k_s2*clips2*touchs2*overs2;
            sliding_friction_s2 => arm_s2*F_mu_s2/r_p - sin_a*side_s2*F_tau_s2/cos_a;
            backlash_r2 => k_r2*clipr2*touchr2*overr2;
            sliding_friction_r2 => sin_a*side_r2*F_tau_r2/cos_a + arm_r2*F_mu_r2/r_p;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r2_mid*dampr2*overr2_dot - beta_K*k_s2_mid*damps2*overs2_dot
                - I_p*alpha_M*u2_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u3 {
            _ => k_r3*touchr3*overr3 - k_s3*touchs3*overs3;
            backlash_s3 => -k_s3*clips3*touchs3*overs3;
            sliding_friction_s3 => arm_s3*F_mu_s3/r_p - sin_a*side_s3*F_tau_s3/cos_a;
            backlash_r3 => k_r3*clipr3*touchr3*overr3;
            sliding_friction_r3 => sin_a*side_r3*F_tau_r3/cos_a + arm_r3*F_mu_r3/r_p;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r3_mid*dampr3*overr3_dot - beta_K*k_s3_mid*damps3*overs3_dot
                - I_p*alpha_M*u3_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
    }
    jacobian {
        theta theta {
            transmission_error_s1_and_sliding_friction_s1_and_moving_phase => roll_s*de_s1*arm_s1*F_mu_s1_by_overs1;
            transmission_error_s1_and_jump_terms => k_s1*dde_s1*touchs1*overs1 - k_s1*de_s1.powi(2)*touchs1
                + 2.0*de_s1*dk_s1*touchs1*overs1;
            sliding_friction_s1_and_moving_phase => -roll_s*darm_s1*F_mu_s1 - roll_s*dk_s1*arm_s1*F_mu_s1_by_k_s1;
            transmission_error_r1_and_sliding_friction_r1_and_moving_phase => roll_r*de_r1*arm_r1*F_mu_r1_by_overr1;
            transmission_error_r1_and_jump_terms => k_r1*dde_r1*touchr1*overr1 - k_r1*de_r1.powi(2)*touchr1
                + 2.0*de_r1*dk_r1*touchr1*overr1;
            sliding_friction_r1_and_moving_phase => -roll_r*darm_r1*F_mu_r1 - roll_r*dk_r1*arm_r1*F_mu_r1_by_k_r1;
            transmission_error_s2_and_sliding_friction_s2_and_moving_phase => roll_s*de_s2*arm_s2*F_mu_s2_by_overs2;
            transmission_error_s2_and_jump_terms => k_s2*dde_s2*touchs2*overs2 - k_s2*de_s2.powi(2)*touchs2
                + 2.0*de_s2*dk_s2*touchs2*overs2;
            sliding_friction_s2_and_moving_phase => -roll_s*darm_s2*F_mu_s2 - roll_s*dk_s2*arm_s2*F_mu_s2_by_k_s2;
            transmission_error_r2_and_sliding_friction_r2_and_moving_phase => roll_r*de_r2*arm_r2*F_mu_r2_by_overr2;
            transmission_error_r2_and_jump_terms => k_r2*dde_r2*touchr2*overr2 - k_r2*de_r2.powi(2)*touchr2
                + 2.0*de_r2*dk_r2*touchr2*overr2;
            sliding_friction_r2_and_moving_phase => -roll_r*darm_r2*F_mu_r2 - roll_r*dk_r2*arm_r2*F_mu_r2_by_k_r2;
            transmission_error_s3_and_sliding_friction_s3_and_moving_phase => roll_s*de_s3*arm_s3*F_mu_s3_by_overs3;
            transmission_error_s3_and_jump_terms => k_s3*dde_s3*touchs3*overs3 - k_s3*de_s3.powi(2)*touchs3
                + 2.0*de_s3*dk_s3*touchs3*overs3;
            sliding_friction_s3_and_moving_phase => -roll_s*darm_s3*F_mu_s3 - roll_s*dk_s3*arm_s3*F_mu_s3_by_k_s3;
            transmission_error_r3_and_sliding_friction_r3_and_moving_phase => roll_r*de_r3*arm_r3*F_mu_r3_by_overr3;
            transmission_error_r3_and_jump_terms => k_r3*dde_r3*touchr3*overr3 - k_r3*de_r3.powi(2)*touchr3
                + 2.0*de_r3*dk_r3*touchr3*overr3;
            sliding_friction_r3_and_moving_phase => -roll_r*darm_r3*F_mu_r3 - roll_r*dk_r3*arm_r3*F_mu_r3_by_k_r3;
            jump_terms => (-ddk_r1*touchr1*overr1.powi(2) - ddk_r2*touchr2*overr2.powi(2) - ddk_r3*touchr3*overr3.powi(2)
                - ddk_s1*touchs1*overs1.powi(2) - ddk_s2*touchs2*overs2.powi(2) - ddk_s3*touchs3*overs3.powi(2))/2.0;
        }
        theta theta_dot {
            damping => 6.0*h*I_p*alpha_M/(r_p*Z_r) - I_c*alpha_M/Z_r.powi(2) - 3.0*I_p*alpha_M/Z_r.powi(2) - I_s*alpha_M/Z_r.powi(2)
                - 2.0*I_s*alpha_M/(Z_r*Z_s) - I_s*alpha_M/Z_s.powi(2) - 3.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2)
                - 3.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
        }
        theta theta_c_dot {
            damping => 3.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 3.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 3.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta u1_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta u2_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta u3_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        theta twist_s { torsional_support_s => -k_s/Z_r - k_s/Z_s; }
        theta twist_c { torsional_support_c => -k_c/Z_r; }
        theta overs1 {
            transmission_error_s1_and_jump_terms => k_s1*de_s1*touchs1;
            sliding_friction_s1 => -roll_s*arm_s1*F_mu_s1_by_overs1;
            jump_terms => -dk_s1*touchs1*overs1;
        }
        theta overr1 {
            transmission_error_r1_and_jump_terms => k_r1*de_r1*touchr1;
            sliding_friction_r1 => -roll_r*arm_r1*F_mu_r1_by_overr1;
            jump_terms => -dk_r1*touchr1*overr1;
        }
        theta overs2 {
            transmission_error_s2_and_jump_terms => k_s2*de_s2*touchs2;
            sliding_friction_s2 => -roll_s*arm_s2*F_mu_s2_by_overs2;
            jump_terms => -dk_s2*touchs2*overs2;
        }
        theta overr2 {
            transmission_error_r2_and_jump_terms => k_r2*de_r2*touchr2;
            sliding_friction_r2 => -roll_r*arm_r2*F_mu_r2_by_overr2;
            jump_terms => -dk_r2*touchr2*overr2;
        }
        theta overs3 {
            transmission_error_s3_and_jump_terms => k_s3*de_s3*touchs3;
            sliding_friction_s3 => -roll_s*arm_s3*F_mu_s3_by_overs3;
            jump_terms => -dk_s3*touchs3*overs3;
        }
        theta overr3 {
            transmission_error_r3_and_jump_terms => k_r3*de_r3*touchr3;
            sliding_friction_r3 => -roll_r*arm_r3*F_mu_r3_by_overr3;
            jump_terms => -dk_r3*touchr3*overr3;
        }
        theta twist_s_dot { torsional_support_s_and_damping => -beta_K*k_s/Z_r - beta_K*k_s/Z_s; }
        theta twist_c_dot { torsional_support_c_and_damping => -beta_K*k_c/Z_r; }
        theta psi_s1_dot { sliding_friction_s1 => -roll_s*arm_s1*F_mu_s1_by_psi_s1_dot; }
        theta psi_r1_dot { sliding_friction_r1 => -roll_r*arm_r1*F_mu_r1_by_psi_r1_dot; }
        theta psi_s2_dot { sliding_friction_s2 => -roll_s*arm_s2*F_mu_s2_by_psi_s2_dot; }
        theta psi_r2_dot { sliding_friction_r2 => -roll_r*arm_r2*F_mu_r2_by_psi_r2_dot; }
        theta psi_s3_dot { sliding_friction_s3 => -roll_s*arm_s3*F_mu_s3_by_psi_s3_dot; }
        theta psi_r3_dot { sliding_friction_r3 => -roll_r*arm_r3*F_mu_r3_by_psi_r3_dot; }
        theta theta_motor_dot {
            governor_motor => -c_motor/Z_r - c_motor/Z_s;
            dc_motor => -Ts_motor/(Z_r*n0_motor) - Ts_motor/(Z_s*n0_motor);
            induction_motor => T_induction_motor_by_theta_motor_dot/Z_r + T_induction_motor_by_theta_motor_dot/Z_s;
            traction_motor => T_traction_motor_by_theta_motor_dot/Z_r + T_traction_motor_by_theta_motor_dot/Z_s;
            fan_motor => T_fan_motor_by_theta_motor_dot/Z_r + T_fan_motor_by_theta_motor_dot/Z_s;
        }
        theta theta_load_dot {
            governor_load => -c_load/Z_r;
            dc_load => -Ts_load/(Z_r*n0_load);
            induction_load => T_induction_load_by_theta_load_dot/Z_r;
            traction_load => T_traction_load_by_theta_load_dot/Z_r;
            fan_load => T_fan_load_by_theta_load_dot/Z_r;
        }
        theta_c theta {
            transmission_error_r1_and_backlash_r1_and_moving_phase => -h*Z_r*k_r1*de_r1*clipr1*touchr1;
            transmission_error_r1_and_sliding_friction_r1_and_moving_phase => -de_r1*arm_r1*F_mu_r1_by_overr1
                - h*sin_a*Z_r*de_r1*side_r1*F_mu_r1_by_overr1*F_tau_r1_by_F_mu_r1/cos_a
                - h*sin_a*Z_r*de_r1*side_r1*F_tau_r1_by_overr1/cos_a;
            transmission_error_r1_and_moving_phase => -h*Z_r*k_r1*de_r1*touchr1;
            backlash_r1_and_moving_phase => h*Z_r*dk_r1*clipr1*touchr1*overr1;
            sliding_friction_r1_and_moving_phase => darm_r1*F_mu_r1 + dk_r1*arm_r1*F_mu_r1_by_k_r1
                + h*sin_a*Z_r*dk_r1*side_r1*F_mu_r1_by_k_r1*F_tau_r1_by_F_mu_r1/cos_a + h*sin_a*Z_r*dside_r1*F_tau_r1/cos_a;
            transmission_error_r2_and_backlash_r2_and_moving_phase => -h*Z_r*k_r2*de_r2*clipr2*touchr2;
            transmission_error_r2_and_sliding_friction_r2_and_moving_phase => -de_r2*arm_r2*F_mu_r2_by_overr2
                - h*sin_a*Z_r*de_r2*side_r2*F_mu_r2_by_overr2*F_tau_r2_by_F_mu_r2/cos_a
                - h*sin_a*Z_r*de_r2*side_r2*F_tau_r2_by_overr2/cos_a;
            transmission_error_r2_and_moving_phase => -h*Z_r*k_r2*de_r2*touchr2;
            backlash_r2_and_moving_phase => h*Z_r*dk_r2*clipr2*touchr2*overr2;
            sliding_friction_r2_and_moving_phase => darm_r2*F_mu_r2 + dk_r2*arm_r2*F_mu_r2_by_k_r2
                + h*sin_a*Z_r*dk_r2*side_r2*F_mu_r2_by_k_r2*F_tau_r2_by_F_mu_r2/cos_a + h*sin_a*Z_r*dside_r2*F_tau_r2/cos_a;
            transmission_error_r3_and_backlash_r3_and_moving_phase => -h*Z_r*k_r3*de_r3*clipr3*touchr3;
            transmission_error_r3_and_sliding_friction_r3_and_moving_phase => -de_r3*arm_r3*F_mu_r3_by_overr3
                - h*sin_a*Z_r*de_r3*side_r3*F_mu_r3_by_overr3*F_tau_r3_by_F_mu_r3/cos_a
                - h*sin_a*Z_r*de_r3*side_r3*F_tau_r3_by_overr3/cos_a;
            transmission_error_r3_and_moving_phase => -h*Z_r*k_r3*de_r3*touchr3;
            backlash_r3_and_moving_phase => h*Z_r*dk_r3*clipr3*touchr3*overr3;
            sliding_friction_r3_and_moving_phase => darm_r3*F_mu_r3 + dk_r3*arm_r3*F_mu_r3_by_k_r3
                + h*sin_a*Z_r*dk_r3*side_r3*F_mu_r3_by_k_r3*F_tau_r3_by_F_mu_r3/cos_a + h*sin_a*Z_r*dside_r3*F_tau_r3/cos_a;
            moving_phase => h*Z_r*dk_r1*touchr1*overr1 + h*Z_r*dk_r2*touchr2*overr2 + h*Z_r*dk_r3*touchr3*overr3;
        }
        theta_c theta_dot {
            damping => 3.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 3.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s
                - 3.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta_c theta_c_dot { damping => -I_c*alpha_M - 3.0*I_p*alpha_M - I_s*alpha_M - 3.0*a.powi(2)*alpha_M*m_p; }
        theta_c u1_dot { damping => -I_p*alpha_M/r_p; }
        theta_c u2_dot { damping => -I_p*alpha_M/r_p; }
        theta_c u3_dot { damping => -I_p*alpha_M/r_p; }
        theta_c twist_s { torsional_support_s => -k_s; }
        theta_c twist_c { torsional_support_c => -k_c; }
        theta_c overr1 {
            _ => h*Z_r*k_r1*touchr1;
            backlash_r1 => h*Z_r*k_r1*clipr1*touchr1;
            sliding_friction_r1 => arm_r1*F_mu_r1_by_overr1 + h*sin_a*Z_r*side_r1*F_mu_r1_by_overr1*F_tau_r1_by_F_mu_r1/cos_a
                + h*sin_a*Z_r*side_r1*F_tau_r1_by_overr1/cos_a;
        }
        theta_c overr2 {
            _ => h*Z_r*k_r2*touchr2;
            backlash_r2 => h*Z_r*k_r2*clipr2*touchr2;
            sliding_friction_r2 => arm_r2*F_mu_r2_by_overr2 + h*sin_a*Z_r*side_r2*F_mu_r2_by_overr2*F_tau_r2_by_F_mu_r2/cos_a
                + h*sin_a*Z_r*side_r2*F_tau_r2_by_overr2/cos_a;
        }
        theta_c overr3 {
            _ => h*Z_r*k_r3*touchr3;
            backlash_r3 => h*Z_r*k_r3*clipr3*touchr3;
            sliding_friction_r3 => arm_r3*F_mu_r3_by_overr3 + h*sin_a*Z_r*side_r3*F_mu_r3_by_overr3*F_tau_r3_by_F_mu_r3/cos_a
                + h*sin_a*Z_r*side_r3*F_tau_r3_by_overr3/cos_a;
        }
        theta_c twist_s_dot { torsional_support_s_and_damping => -beta_K*k_s; }
        theta_c twist_c_dot { torsional_support_c_and_damping => -beta_K*k_c; }
        theta_c overr1_dot { damping => h*Z_r*beta_K*k_r1_mid*dampr1; }
        theta_c psi_r1_dot {
            sliding_friction_r1 => arm_r1*F_mu_r1_by_psi_r1_dot + h*sin_a*Z_r*side_r1*F_mu_r1_by_psi_r1_dot*F_tau_r1_by_F_mu_r1/cos_a;
        }
        theta_c overr2_dot { damping => h*Z_r*beta_K*k_r2_mid*dampr2; }
        theta_c psi_r2_dot {
            sliding_friction_r2 => arm_r2*F_mu_r2_by_psi_r2_dot + h*sin_a*Z_r*side_r2*F_mu_r2_by_psi_r2_dot*F_tau_r2_by_F_mu_r2/cos_a;
        }
        theta_c overr3_dot { damping => h*Z_r*beta_K*k_r3_mid*dampr3; }
        theta_c psi_r3_dot {
            sliding_friction_r3 => arm_r3*F_mu_r3_by_psi_r3_dot + h*sin_a*Z_r*side_r3*F_mu_r3_by_psi_r3_dot*F_tau_r3_by_F_mu_r3/cos_a;
        }
        theta_c theta_motor_dot {
            governor_motor => -c_motor;
            dc_motor => -Ts_motor/n0_motor;
            induction_motor => T_induction_motor_by_theta_motor_dot;
            traction_motor => T_traction_motor_by_theta_motor_dot;
            fan_motor => T_fan_motor_by_theta_motor_dot;
        }
        theta_c theta_load_dot {
            governor_load => -c_load;
            dc_load => -Ts_load/n0_load;
            induction_load => T_induction_load_by_theta_load_dot;
            traction_load => T_traction_load_by_theta_load_dot;
            fan_load => T_fan_load_by_theta_load_dot;
        }
        theta_r theta {
            transmission_error_r1_and_backlash_r1_and_moving_phase => h*Z_r*k_r1*de_r1*clipr1*touchr1;
            transmission_error_r1_and_sliding_friction_r1_and_moving_phase => de_r1*arm_r1*F_mu_r1_by_overr1
                + h*sin_a*Z_r*de_r1*side_r1*F_mu_r1_by_overr1*F_tau_r1_by_F_mu_r1/cos_a
                + h*sin_a*Z_r*de_r1*side_r1*F_tau_r1_by_overr1/cos_a;
            transmission_error_r1_and_moving_phase => h*Z_r*k_r1*de_r1*touchr1;
            backlash_r1_and_moving_phase => -h*Z_r*dk_r1*clipr1*touchr1*overr1;
            sliding_friction_r1_and_moving_phase => -darm_r1*F_mu_r1 - dk_r1*arm_r1*F_mu_r1_by_k_r1
                - h*sin_a*Z_r*dk_r1*side_r1*F_mu_r1_by_k_r1*F_tau_r1_by_F_mu_r1/cos_a - h*sin_a*Z_r*dside_r1*F_tau_r1/cos_a;
            transmission_error_r2_and_backlash_r2_and_moving_phase => h*Z_r*k_r2*de_r2*clipr2*touchr2;
            transmission_error_r2_and_sliding_friction_r2_and_moving_phase => de_r2*arm_r2*F_mu_r2_by_overr2
                + h*sin_a*Z_r*de_r2*side_r2*F_mu_r2_by_overr2*F_tau_r2_by_F_mu_r2/cos_a
                + h*sin_a*Z_r*de_r2*side_r2*F_tau_r2_by_overr2/cos_a;
            transmission_error_r2_and_moving_phase => h*Z_r*k_r2*de_r2*touchr2;
            backlash_r2_and_moving_phase => -h*Z_r*dk_r2*clipr2*touchr2*overr2;
            sliding_friction_r2_and_moving_phase => -darm_r2*F_mu_r2 - dk_r2*arm_r2*F_mu_r2_by_k_r2
                - h*sin_a*Z_r*dk_r2*side_r2*F_mu_r2_by_k_r2*F_tau_r2_by_F_mu_r2/cos_a - h*sin_a*Z_r*dside_r2*F_tau_r2/cos_a;
            transmission_error_r3_and_backlash_r3_and_moving_phase => h*Z_r*k_r3*de_r3*clipr3*touchr3;
            transmission_error_r3_and_sliding_friction_r3_and_moving_phase => de_r3*arm_r3*F_mu_r3_by_overr3
                + h*sin_a*Z_r*de_r3*side_r3*F_mu_r3_by_overr3*F_tau_r3_by_F_mu_r3/cos_a
                + h*sin_a*Z_r*de_r3*side_r3*F_tau_r3_by_overr3/cos_a;
            transmission_error_r3_and_moving_phase => h*Z_r*k_r3*de_r3*touchr3;
            backlash_r3_and_moving_phase => -h*Z_r*dk_r3*clipr3*touchr3*overr3;
            sliding_friction_r3_and_moving_phase => -darm_r3*F_mu_r3 - dk_r3*arm_r3*F_mu_r3_by_k_r3
                - h*sin_a*Z_r*dk_r3*side_r3*F_mu_r3_by_k_r3*F_tau_r3_by_F_mu_r3/cos_a - h*sin_a*Z_r*dside_r3*F_tau_r3/cos_a;
            moving_phase => -h*Z_r*dk_r1*touchr1*overr1 - h*Z_r*dk_r2*touchr2*overr2 - h*Z_r*dk_r3*touchr3*overr3;
        }
        theta_r theta_r_dot { damping => -I_r*alpha_M; }
        theta_r twist_r { _ => -k_r; }
        theta_r overr1 {
            _ => -h*Z_r*k_r1*touchr1;
            backlash_r1 => -h*Z_r*k_r1*clipr1*touchr1;
            sliding_friction_r1 => -arm_r1*F_mu_r1_by_overr1 - h*sin_a*Z_r*side_r1*F_mu_r1_by_overr1*F_tau_r1_by_F_mu_r1/cos_a
                - h*sin_a*Z_r*side_r1*F_tau_r1_by_overr1/cos_a;
        }
        theta_r overr2 {
            _ => -h*Z_r*k_r2*touchr2;
            backlash_r2 => -h*Z_r*k_r2*clipr2*touchr2;
            sliding_friction_r2 => -arm_r2*F_mu_r2_by_overr2 - h*sin_a*Z_r*side_r2*F_mu_r2_by_overr2*F_tau_r2_by_F_mu_r2/cos_a
                - h*sin_a*Z_r*side_r2*F_tau_r2_by_overr2/cos_a;
        }
        theta_r overr3 {
            _ => -h*Z_r*k_r3*touchr3;
            backlash_r3 => -h*Z_r*k_r3*clipr3*touchr3;
            sliding_friction_r3 => -arm_r3*F_mu_r3_by_overr3 - h*sin_a*Z_r*side_r3*F_mu_r3_by_overr3*F_tau_r3_by_F_mu_r3/cos_a
                - h*sin_a*Z_r*side_r3*F_tau_r3_by_overr3/cos_a;
        }
        theta_r twist_r_dot { damping => -beta_K*k_r; }
        theta_r overr1_dot { damping => -h*Z_r*beta_K*k_r1_mid*dampr1; }
        theta_r psi_r1_dot {
            sliding_friction_r1 => -arm_r1*F_mu_r1_by_psi_r1_dot - h*sin_a*Z_r*side_r1*F_mu_r1_by_psi_r1_dot*F_tau_r1_by_F_mu_r1/cos_a;
        }
        theta_r overr2_dot { damping => -h*Z_r*beta_K*k_r2_mid*dampr2; }
        theta_r psi_r2_dot {
            sliding_friction_r2 => -arm_r2*F_mu_r2_by_psi_r2_dot - h*sin_a*Z_r*side_r2*F_mu_r2_by_psi_r2_dot*F_tau_r2_by_F_mu_r2/cos_a;
        }
        theta_r overr3_dot { damping => -h*Z_r*beta_K*k_r3_mid*dampr3; }
        theta_r psi_r3_dot {
            sliding_friction_r3 => -arm_r3*F_mu_r3_by_psi_r3_dot - h*sin_a*Z_r*side_r3*F_mu_r3_by_psi_r3_dot*F_tau_r3_by_F_mu_r3/cos_a;
        }
        u1 theta {
            transmission_error_s1_and_backlash_s1_and_moving_phase => k_s1*de_s1*clips1*touchs1;
            transmission_error_s1_and_sliding_friction_s1_and_moving_phase => sin_a*de_s1*side_s1*F_mu_s1_by_overs1*F_tau_s1_by_F_mu_s1
                /cos_a + sin_a*de_s1*side_s1*F_tau_s1_by_overs1/cos_a - de_s1*arm_s1*F_mu_s1_by_overs1/r_p;
            transmission_error_s1_and_moving_phase => k_s1*de_s1*touchs1;
            backlash_s1_and_moving_phase => -dk_s1*clips1*touchs1*overs1;
            sliding_friction_s1_and_moving_phase => darm_s1*F_mu_s1/r_p - sin_a*dk_s1*side_s1*F_mu_s1_by_k_s1*F_tau_s1_by_F_mu_s1/cos_a
                - sin_a*dside_s1*F_tau_s1/cos_a + dk_s1*arm_s1*F_mu_s1_by_k_s1/r_p;
            transmission_error_r1_and_backlash_r1_and_moving_phase => -k_r1*de_r1*clipr1*touchr1;
            transmission_error_r1_and_sliding_friction_r1_and_moving_phase => -sin_a*de_r1*side_r1*F_mu_r1_by_overr1*F_tau_r1_by_F_mu_r1
                /cos_a - sin_a*de_r1*side_r1*F_tau_r1_by_overr1/cos_a - de_r1*arm_r1*F_mu_r1_by_overr1/r_p;
            transmission_error_r1_and_moving_phase => -k_r1*de_r1*touchr1;
            backlash_r1_and_moving_phase => dk_r1*clipr1*touchr1*overr1;
            sliding_friction_r1_and_moving_phase => sin_a*dk_r1*side_r1*F_mu_r1_by_k_r1*F_tau_r1_by_F_mu_r1/cos_a
                + sin_a*dside_r1*F_tau_r1/cos_a + darm_r1*F_mu_r1/r_p + dk_r1*arm_r1*F_mu_r1_by_k_r1/r_p;
            moving_phase => dk_r1*touchr1*overr1 - dk_s1*touchs1*overs1;
        }
        u1 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u1 theta_c_dot { damping => -I_p*alpha_M/r_p; }
        u1 u1_dot { damping => -I_p*alpha_M/r_p.powi(2); }
        u1 overs1 {
            _ => -k_s1*touchs1;
            backlash_s1 => -k_s1*clips1*touchs1;
            sliding_friction_s1 => arm_s1*F_mu_s1_by_overs1/r_p - sin_a*side_s1*F_mu_s1_by_overs1*F_tau_s1_by_F_mu_s1/cos_a
                - sin_a*side_s1*F_tau_s1_by_overs1/cos_a;
        }
        u1 overr1 {
            _ => k_r1*touchr1;
            backlash_r1 => k_r1*clipr1*touchr1;
            sliding_friction_r1 => sin_a*side_r1*F_mu_r1_by_overr1*F_tau_r1_by_F_mu_r1/cos_a + sin_a*side_r1*F_tau_r1_by_overr1/cos_a
                + arm_r1*F_mu_r1_by_overr1/r_p;
        }
        u1 overs1_dot { damping => -beta_K*k_s1_mid*damps1; }
        u1 psi_s1_dot {
            sliding_friction_s1 => arm_s1*F_mu_s1_by_psi_s1_dot/r_p - sin_a*side_s1*F_mu_s1_by_psi_s1_dot*F_tau_s1_by_F_mu_s1/cos_a;
        }
        u1 overr1_dot { damping => beta_K*k_r1_mid*dampr1; }
        u1 psi_r1_dot {
            sliding_friction_r1 => sin_a*side_r1*F_mu_r1_by_psi_r1_dot*F_tau_r1_by_F_mu_r1/cos_a + arm_r1*F_mu_r1_by_psi_r1_dot/r_p;
        }
        u2 theta {
            transmission_error_s2_and_backlash_s2_and_moving_phase => k_s2*de_s2*clips2*touchs2;
            transmission_error_s2_and_sliding_friction_s2_and_moving_phase => sin_a*de_s2*side_s2*F_mu_s2_by_overs2*F_tau_s2_by_F_mu_s2
                /cos_a + sin_a*de_s2*side_s2*F_tau_s2_by_overs2/cos_a - de_s2*arm_s2*F_mu_s2_by_overs2/r_p;
            transmission_error_s2_and_moving_phase => k_s2*de_s2*touchs2;
            backlash_s2_and_moving_phase => -dk_s2*clips2*touchs2*overs2;
            sliding_friction_s2_and_moving_phase => darm_s2*F_mu_s2/r_p - sin_a*dk_s2*side_s2*F_mu_s2_by_k_s2*F_tau_s2_by_F_mu_s2/cos_a
                - sin_a*dside_s2*F_tau_s2/cos_a + dk_s2*arm_s2*F_mu_s2_by_k_s2/r_p;
            transmission_error_r2_and_backlash_r2_and_moving_phase => -k_r2*de_r2*clipr2*touchr2;
            transmission_error_r2_and_sliding_friction_r2_and_moving_phase => -sin_a*de_r2*side_r2*F_mu_r2_by_overr2*F_tau_r2_by_F_mu_r2
                /cos_a - sin_a*de_r2*side_r2*F_tau_r2_by_overr2/cos_a - de_r2*arm_r2*F_mu_r2_by_overr2/r_p;
            transmission_error_r2_and_moving_phase => -k_r2*de_r2*touchr2;
            backlash_r2_and_moving_phase => dk_r2*clipr2*touchr2*overr2;
            sliding_friction_r2_and_moving_phase => sin_a*dk_r2*side_r2*F_mu_r2_by_k_r2*F_tau_r2_by_F_mu_r2/cos_a
                + sin_a*dside_r2*F_tau_r2/cos_a + darm_r2*F_mu_r2/r_p + dk_r2*arm_r2*F_mu_r2_by_k_r2/r_p;
            moving_phase => dk_r2*touchr2*overr2 - dk_s2*touchs2*overs2;
        }
        u2 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u2 theta_c_dot { damping => -I_p*alpha_M/r_p; }
        u2 u2_dot { damping => -I_p*alpha_M/r_p.powi(2); }
        u2 overs2 {
            _ => -k_s2*touchs2;
            backlash_s2 => -k_s2*clips2*touchs2;
            sliding_friction_s2 => arm_s2*F_mu_s2_by_overs2/r_p - sin_a*side_s2*F_mu_s2_by_overs2*F_tau_s2_by_F_mu_s2/cos_a
                - sin_a*side_s2*F_tau_s2_by_overs2/cos_a;
        }
        u2 overr2 {
            _ => k_r2*touchr2;
            backlash_r2 => k_r2*clipr2*touchr2;
            sliding_friction_r2 => sin_a*side_r2*F_mu_r2_by_overr2*F_tau_r2_by_F_mu_r2/cos_a + sin_a*side_r2*F_tau_r2_by_overr2/cos_a
                + arm_r2*F_mu_r2_by_overr2/r_p;
        }
        u2 overs2_dot { damping => -beta_K*k_s2_mid*damps2; }
        u2 psi_s2_dot {
            sliding_friction_s2 => arm_s2*F_mu_s2_by_psi_s2_dot/r_p - sin_a*side_s2*F_mu_s2_by_psi_s2_dot*F_tau_s2_by_F_mu_s2/cos_a;
        }
        u2 overr2_dot { damping => beta_K*k_r2_mid*dampr2; }
        u2 psi_r2_dot {
            sliding_friction_r2 => sin_a*side_r2*F_mu_r2_by_psi_r2_dot*F_tau_r2_by_F_mu_r2/cos_a + arm_r2*F_mu_r2_by_psi_r2_dot/r_p;
        }
        u3 theta {
            transmission_error_s3_and_backlash_s3_and_moving_phase => k_s3*de_s3*clips3*touchs3;
            transmission_error_s3_and_sliding_friction_s3_and_moving_phase => sin_a*de_s3*side_s3*F_mu_s3_by_overs3*F_tau_s3_by_F_mu_s3
                /cos_a + sin_a*de_s3*side_s3*F_tau_s3_by_overs3/cos_a - de_s3*arm_s3*F_mu_s3_by_overs3/r_p;
            transmission_error_s3_and_moving_phase => k_s3*de_s3*touchs3;
            backlash_s3_and_moving_phase => -dk_s3*clips3*touchs3*overs3;
            sliding_friction_s3_and_moving_phase => darm_s3*F_mu_s3/r_p - sin_a*dk_s3*side_s3*F_mu_s3_by_k_s3*F_tau_s3_by_F_mu_s3/cos_a
                - sin_a*dside_s3*F_tau_s3/cos_a + dk_s3*arm_s3*F_mu_s3_by_k_s3/r_p;
            transmission_error_r3_and_backlash_r3_and_moving_phase => -k_r3*de_r3*clipr3*touchr3;
            transmission_error_r3_and_sliding_friction_r3_and_moving_phase => -sin_a*de_r3*side_r3*F_mu_r3_by_overr3*F_tau_r3_by_F_mu_r3
                /cos_a - sin_a*de_r3*side_r3*F_tau_r3_by_overr3/cos_a - de_r3*arm_r3*F_mu_r3_by_overr3/r_p;
            transmission_error_r3_and_moving_phase => -k_r3*de_r3*touchr3;
            backlash_r3_and_moving_phase => dk_r3*clipr3*touchr3*overr3;
            sliding_friction_r3_and_moving_phase => sin_a*dk_r3*side_r3*F_mu_r3_by_k_r3*F_tau_r3_by_F_mu_r3/cos_a
                + sin_a*dside_r3*F_tau_r3/cos_a + darm_r3*F_mu_r3/r_p + dk_r3*arm_r3*F_mu_r3_by_k_r3/r_p;
            moving_phase => dk_r3*touchr3*overr3 - dk_s3*touchs3*overs3;
        }
        u3 theta_dot { damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r); }
        u3 theta_c_dot { damping => -I_p*alpha_M/r_p; }
        u3 u3_dot { damping => -I_p*alpha_M/r_p.powi(2); }
        u3 overs3 {
            _ => -k_s3*touchs3;
            backlash_s3 => -k_s3*clips3*touchs3;
            sliding_friction_s3 => arm_s3*F_mu_s3_by_overs3/r_p - sin_a*side_s3*F_mu_s3_by_overs3*F_tau_s3_by_F_mu_s3/cos_a
                - sin_a*side_s3*F_tau_s3_by_overs3/cos_a;
        }
        u3 overr3 {
            _ => k_r3*touchr3;
            backlash_r3 => k_r3*clipr3*touchr3;
            sliding_friction_r3 => sin_a*side_r3*F_mu_r3_by_overr3*F_tau_r3_by_F_mu_r3/cos_a + sin_a*side_r3*F_tau_r3_by_overr3/cos_a
                + arm_r3*F_mu_r3_by_overr3/r_p;
        }
        u3 overs3_dot { damping => -beta_K*k_s3_mid*damps3; }
        u3 psi_s3_dot {
            sliding_friction_s3 => arm_s3*F_mu_s3_by_psi_s3_dot/r_p - sin_a*side_s3*F_mu_s3_by_psi_s3_dot*F_tau_s3_by_F_mu_s3/cos_a;
        }
        u3 overr3_dot { damping => beta_K*k_r3_mid*dampr3; }
        u3 psi_r3_dot {
            sliding_friction_r3 => sin_a*side_r3*F_mu_r3_by_psi_r3_dot*F_tau_r3_by_F_mu_r3/cos_a + arm_r3*F_mu_r3_by_psi_r3_dot/r_p;
        }
    }
    cell {
        stiffness {
            twist_r twist_r { _ => k_r; }
            twist_s twist_s { torsional_support_s => k_s; }
            twist_c twist_c { torsional_support_c => k_c; }
            overs1 overs1 {
                _ => k_s1*touchs1;
                backlash_s1 => k_s1*clips1*touchs1;
            }
            overr1 overr1 {
                _ => k_r1*touchr1;
                backlash_r1 => k_r1*clipr1*touchr1;
            }
            overs2 overs2 {
                _ => k_s2*touchs2;
                backlash_s2 => k_s2*clips2*touchs2;
            }
            overr2 overr2 {
                _ => k_r2*touchr2;
                backlash_r2 => k_r2*clipr2*touchr2;
            }
            overs3 overs3 {
                _ => k_s3*touchs3;
                backlash_s3 => k_s3*clips3*touchs3;
            }
            overr3 overr3 {
                _ => k_r3*touchr3;
                backlash_r3 => k_r3*clipr3*touchr3;
            }
        }
        damping {
            theta theta {
                damping => I_c*alpha_M/Z_r.powi(2) - 6.0*h*I_p*alpha_M/(r_p*Z_r) + 3.0*I_p*alpha_M/Z_r.powi(2) + I_s*alpha_M/Z_r.powi(2)
                    + 2.0*I_s*alpha_M/(Z_r*Z_s) + I_s*alpha_M/Z_s.powi(2) + 3.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2)
                    + 3.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
            }
            theta theta_c {
                damping => I_c*alpha_M/Z_r - 3.0*h*I_p*alpha_M/r_p + 3.0*I_p*alpha_M/Z_r + I_s*alpha_M/Z_r + I_s*alpha_M/Z_s
                    + 3.0*a.powi(2)*alpha_M*m_p/Z_r;
            }
            theta u1 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta u2 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta u3 { damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2); }
            theta_c theta_c { damping => I_c*alpha_M + 3.0*I_p*alpha_M + I_s*alpha_M + 3.0*a.powi(2)*alpha_M*m_p; }
            theta_c u1 { damping => I_p*alpha_M/r_p; }
            theta_c u2 { damping => I_p*alpha_M/r_p; }
            theta_c u3 { damping => I_p*alpha_M/r_p; }
            theta_r theta_r { damping => I_r*alpha_M; }
            u1 u1 { damping => I_p*alpha_M/r_p.powi(2); }
            u2 u2 { damping => I_p*alpha_M/r_p.powi(2); }
            u3 u3 { damping => I_p*alpha_M/r_p.powi(2); }
            twist_r twist_r { damping => beta_K*k_r; }
            twist_s twist_s { torsional_support_s_and_damping => beta_K*k_s; }
            twist_c twist_c { torsional_support_c_and_damping => beta_K*k_c; }
            overs1 overs1 { damping => beta_K*k_s1_mid*damps1; }
            overr1 overr1 { damping => beta_K*k_r1_mid*dampr1; }
            overs2 overs2 { damping => beta_K*k_s2_mid*damps2; }
            overr2 overr2 { damping => beta_K*k_r2_mid*dampr2; }
            overs3 overs3 { damping => beta_K*k_s3_mid*damps3; }
            overr3 overr3 { damping => beta_K*k_r3_mid*dampr3; }
            theta_motor theta_motor {
                governor_motor => c_motor;
                dc_motor => Ts_motor/n0_motor;
            }
            theta_load theta_load {
                governor_load => c_load;
                dc_load => Ts_load/n0_load;
            }
        }
        load {
            theta {
                torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
                governor_motor => c_motor*n_motor/Z_r + c_motor*n_motor/Z_s;
                dc_motor => Ts_motor/Z_r + Ts_motor/Z_s;
                governor_load => c_load*n_load/Z_r;
                dc_load => Ts_load/Z_r;
            }
            theta_c {
                torques => T_motor - T_load;
                governor_motor => c_motor*n_motor;
                dc_motor => Ts_motor;
                governor_load => c_load*n_load;
                dc_load => Ts_load;
            }
            overs1 {
                _ => k_s1*touchs1*edges1 + k_s1*touchs1*e_s1;
                backlash_s1 => k_s1*clips1*touchs1*edges1 + k_s1*clips1*touchs1*e_s1;
            }
            overr1 {
                _ => k_r1*touchr1*edger1 + k_r1*touchr1*e_r1;
                backlash_r1 => k_r1*clipr1*touchr1*edger1 + k_r1*clipr1*touchr1*e_r1;
            }
            overs2 {
                _ => k_s2*touchs2*edges2 + k_s2*touchs2*e_s2;
                backlash_s2 => k_s2*clips2*touchs2*edges2 + k_s2*clips2*touchs2*e_s2;
            }
            overr2 {
                _ => k_r2*touchr2*edger2 + k_r2*touchr2*e_r2;
                backlash_r2 => k_r2*clipr2*touchr2*edger2 + k_r2*clipr2*touchr2*e_r2;
            }
            overs3 {
                _ => k_s3*touchs3*edges3 + k_s3*touchs3*e_s3;
                backlash_s3 => k_s3*clips3*touchs3*edges3 + k_s3*clips3*touchs3*e_s3;
            }
            overr3 {
                _ => k_r3*touchr3*edger3 + k_r3*touchr3*e_r3;
                backlash_r3 => k_r3*clipr3*touchr3*edger3 + k_r3*clipr3*touchr3*e_r3;
            }
        }
    }
    nonlinear_with {
        sliding_friction_s1 "-side_s1*F_tau_s1 in the torque `slide_s1`";
        sliding_friction_s1 "-arm_s1*F_mu_s1 in the torque `roll_s1`";
        sliding_friction_r1 "-side_r1*F_tau_r1 in the torque `slide_r1`";
        sliding_friction_r1 "-arm_r1*F_mu_r1 in the torque `roll_r1`";
        sliding_friction_s2 "-side_s2*F_tau_s2 in the torque `slide_s2`";
        sliding_friction_s2 "-arm_s2*F_mu_s2 in the torque `roll_s2`";
        sliding_friction_r2 "-side_r2*F_tau_r2 in the torque `slide_r2`";
        sliding_friction_r2 "-arm_r2*F_mu_r2 in the torque `roll_r2`";
        sliding_friction_s3 "-side_s3*F_tau_s3 in the torque `slide_s3`";
        sliding_friction_s3 "-arm_s3*F_mu_s3 in the torque `roll_s3`";
        sliding_friction_r3 "-side_r3*F_tau_r3 in the torque `slide_r3`";
        sliding_friction_r3 "-arm_r3*F_mu_r3 in the torque `roll_r3`";
        induction_motor "T_induction_motor in the torque `induction_motor`";
        traction_motor "T_traction_motor in the torque `traction_motor`";
        fan_motor "T_fan_motor in the torque `fan_motor`";
        induction_load "T_induction_load in the torque `induction_load`";
        traction_load "T_traction_load in the torque `traction_load`";
        fan_load "T_fan_load in the torque `fan_load`";
    }
    jump k_s1 { step { _ => dk_s1*touchs1*overs1.powi(2)/2.0; } }
    jump k_r1 { step { _ => dk_r1*touchr1*overr1.powi(2)/2.0; } }
    jump k_s2 { step { _ => dk_s2*touchs2*overs2.powi(2)/2.0; } }
    jump k_r2 { step { _ => dk_r2*touchr2*overr2.powi(2)/2.0; } }
    jump k_s3 { step { _ => dk_s3*touchs3*overs3.powi(2)/2.0; } }
    jump k_r3 { step { _ => dk_r3*touchr3*overr3.powi(2)/2.0; } }
    jump e_s1 { step { _ => k_s1*de_s1.powi(2)*touchs1/2.0 - k_s1*de_s1*touchs1*overs1; } }
    jump e_r1 { step { _ => k_r1*de_r1.powi(2)*touchr1/2.0 - k_r1*de_r1*touchr1*overr1; } }
    jump e_s2 { step { _ => k_s2*de_s2.powi(2)*touchs2/2.0 - k_s2*de_s2*touchs2*overs2; } }
    jump e_r2 { step { _ => k_r2*de_r2.powi(2)*touchr2/2.0 - k_r2*de_r2*touchr2*overr2; } }
    jump e_s3 { step { _ => k_s3*de_s3.powi(2)*touchs3/2.0 - k_s3*de_s3*touchs3*overs3; } }
    jump e_r3 { step { _ => k_r3*de_r3.powi(2)*touchr3/2.0 - k_r3*de_r3*touchr3*overr3; } }
    jump side_s1 { step {} }
    jump arm_s1 { step {} }
    jump side_r1 { step {} }
    jump arm_r1 { step {} }
    jump side_s2 { step {} }
    jump arm_s2 { step {} }
    jump side_r2 { step {} }
    jump arm_r2 { step {} }
    jump side_s3 { step {} }
    jump arm_s3 { step {} }
    jump side_r3 { step {} }
    jump arm_r3 { step {} }
    outputs {
        rotor_speed_s "rad/s", "rotational speed of the sun" { _ => theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s); }
        rotor_speed_c "rad/s", "rotational speed of the carrier without planets" { _ => theta_c_dot + theta_dot/Z_r; }
        rotor_speed_r "rad/s", "rotational speed of the ring" { _ => theta_r_dot; }
        shaft_twist_r "rad", "twist of the ring's torsional support" { _ => twist_r; }
        shaft_torque_r "N*m", "torque in the ring's torsional support, damper included" {
            _ => k_r*twist_r;
            damping => beta_K*k_r*twist_r_dot;
        }
        shaft_power_r "W", "power that enters the ring's torsional support at its first end: torque times the speed of that end" {
            _ => theta_r_dot*shaft_torque_r;
        }
        shaft_loss_r "W", "power that the damper of the ring's torsional support takes" { damping => beta_K*k_r*twist_r_dot.powi(2); }
        shaft_twist_s "rad" with torsional_support_s, "twist of the sun's torsional support" { _ => twist_s; }
        shaft_torque_s "N*m" with torsional_support_s, "torque in the sun's torsional support, damper included" {
            torsional_support_s => k_s*twist_s;
            torsional_support_s_and_damping => beta_K*k_s*twist_s_dot;
        }
        shaft_power_s "W" with torsional_support_s,
            "power that enters the sun's torsional support at its first end: torque times the speed of that end" {
            _ => shaft_torque_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        shaft_loss_s "W" with torsional_support_s, "power that the damper of the sun's torsional support takes" {
            torsional_support_s_and_damping => beta_K*k_s*twist_s_dot.powi(2);
        }
        shaft_twist_c "rad" with torsional_support_c, "twist of the carrier's torsional support" { _ => twist_c; }
        shaft_torque_c "N*m" with torsional_support_c, "torque in the carrier's torsional support, damper included" {
            torsional_support_c => k_c*twist_c;
            torsional_support_c_and_damping => beta_K*k_c*twist_c_dot;
        }
        shaft_power_c "W" with torsional_support_c,
            "power that enters the carrier's torsional support at its first end: torque times the speed of that end" {
            _ => shaft_torque_c*(theta_c_dot + theta_dot/Z_r);
        }
        shaft_loss_c "W" with torsional_support_c, "power that the damper of the carrier's torsional support takes" {
            torsional_support_c_and_damping => beta_K*k_c*twist_c_dot.powi(2);
        }
        contact_loss_s1 "1" with backlash_s1,
            "1 while no force passes the mesh of sun and planet 1, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touchs1*(1.0 + clips1*(1.0 - clips1)/2.0);
        }
        mesh_force_s1 "N",
            "force of the mesh of sun and planet 1 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s1*touchs1*overs1;
            backlash_s1 => k_s1*clips1*touchs1*overs1;
            damping => beta_K*k_s1_mid*damps1*overs1_dot;
        }
        mesh_power_s1 "W", "power that the first gear gives to the mesh of sun and planet 1: force times the speed of its flank" {
            _ => mesh_force_s1*(h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        mesh_deflection_s1 "m", "deflection of the mesh of sun and planet 1 along the line of action, backlash not taken off" {
            _ => u1 - e_s1 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_s1 "m",
            "dynamic transmission error of the mesh of sun and planet 1 along the line of action: positive if the driving gear is ahead" {
            _ => u1 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_s1 "W", "power that the damper of the mesh of sun and planet 1 takes" {
            backlash_s1 => k_s1*clips1*touchs1*overs1*overs1_dot;
            damping => beta_K*k_s1_mid*damps1*overs1_dot.powi(2);
        }
        power_slide_s1 "W" with sliding_friction_s1,
            "power of the friction of the mesh of sun and planet 1, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide_s1_power;
        }
        power_roll_s1 "W" with sliding_friction_s1,
            "power of the friction of the mesh of sun and planet 1, through the rolling of the gears: positive if it drives" {
            _ => roll_s1_power;
        }
        contact_loss_r1 "1" with backlash_r1,
            "1 while no force passes the mesh of ring and planet 1, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touchr1*(1.0 + clipr1*(1.0 - clipr1)/2.0);
        }
        mesh_force_r1 "N",
            "force of the mesh of ring and planet 1 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r1*touchr1*overr1;
            backlash_r1 => k_r1*clipr1*touchr1*overr1;
            damping => beta_K*k_r1_mid*dampr1*overr1_dot;
        }
        mesh_power_r1 "W", "power that the first gear gives to the mesh of ring and planet 1: force times the speed of its flank" {
            _ => h*Z_r*theta_r_dot*mesh_force_r1;
        }
        mesh_deflection_r1 "m", "deflection of the mesh of ring and planet 1 along the line of action, backlash not taken off" {
            _ => h*Z_r*theta_r - e_r1 - (u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r1 "m",
            "dynamic transmission error of the mesh of ring and planet 1 along the line of action: positive if the driving gear is ahead" {
            _ => h*Z_r*theta_r - (u1 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r1 "W", "power that the damper of the mesh of ring and planet 1 takes" {
            backlash_r1 => k_r1*clipr1*touchr1*overr1*overr1_dot;
            damping => beta_K*k_r1_mid*dampr1*overr1_dot.powi(2);
        }
        power_slide_r1 "W" with sliding_friction_r1,
            "power of the friction of the mesh of ring and planet 1, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide_r1_power;
        }
        power_roll_r1 "W" with sliding_friction_r1,
            "power of the friction of the mesh of ring and planet 1, through the rolling of the gears: positive if it drives" {
            _ => roll_r1_power;
        }
        contact_loss_s2 "1" with backlash_s2,
            "1 while no force passes the mesh of sun and planet 2, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touchs2*(1.0 + clips2*(1.0 - clips2)/2.0);
        }
        mesh_force_s2 "N",
            "force of the mesh of sun and planet 2 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s2*touchs2*overs2;
            backlash_s2 => k_s2*clips2*touchs2*overs2;
            damping => beta_K*k_s2_mid*damps2*overs2_dot;
        }
        mesh_power_s2 "W", "power that the first gear gives to the mesh of sun and planet 2: force times the speed of its flank" {
            _ => mesh_force_s2*(h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        mesh_deflection_s2 "m", "deflection of the mesh of sun and planet 2 along the line of action, backlash not taken off" {
            _ => u2 - e_s2 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_s2 "m",
            "dynamic transmission error of the mesh of sun and planet 2 along the line of action: positive if the driving gear is ahead" {
            _ => u2 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_s2 "W", "power that the damper of the mesh of sun and planet 2 takes" {
            backlash_s2 => k_s2*clips2*touchs2*overs2*overs2_dot;
            damping => beta_K*k_s2_mid*damps2*overs2_dot.powi(2);
        }
        power_slide_s2 "W" with sliding_friction_s2,
            "power of the friction of the mesh of sun and planet 2, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide_s2_power;
        }
        power_roll_s2 "W" with sliding_friction_s2,
            "power of the friction of the mesh of sun and planet 2, through the rolling of the gears: positive if it drives" {
            _ => roll_s2_power;
        }
        contact_loss_r2 "1" with backlash_r2,
            "1 while no force passes the mesh of ring and planet 2, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touchr2*(1.0 + clipr2*(1.0 - clipr2)/2.0);
        }
        mesh_force_r2 "N",
            "force of the mesh of ring and planet 2 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r2*touchr2*overr2;
            backlash_r2 => k_r2*clipr2*touchr2*overr2;
            damping => beta_K*k_r2_mid*dampr2*overr2_dot;
        }
        mesh_power_r2 "W", "power that the first gear gives to the mesh of ring and planet 2: force times the speed of its flank" {
            _ => h*Z_r*theta_r_dot*mesh_force_r2;
        }
        mesh_deflection_r2 "m", "deflection of the mesh of ring and planet 2 along the line of action, backlash not taken off" {
            _ => h*Z_r*theta_r - e_r2 - (u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r2 "m",
            "dynamic transmission error of the mesh of ring and planet 2 along the line of action: positive if the driving gear is ahead" {
            _ => h*Z_r*theta_r - (u2 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r2 "W", "power that the damper of the mesh of ring and planet 2 takes" {
            backlash_r2 => k_r2*clipr2*touchr2*overr2*overr2_dot;
            damping => beta_K*k_r2_mid*dampr2*overr2_dot.powi(2);
        }
        power_slide_r2 "W" with sliding_friction_r2,
            "power of the friction of the mesh of ring and planet 2, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide_r2_power;
        }
        power_roll_r2 "W" with sliding_friction_r2,
            "power of the friction of the mesh of ring and planet 2, through the rolling of the gears: positive if it drives" {
            _ => roll_r2_power;
        }
        contact_loss_s3 "1" with backlash_s3,
            "1 while no force passes the mesh of sun and planet 3, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touchs3*(1.0 + clips3*(1.0 - clips3)/2.0);
        }
        mesh_force_s3 "N",
            "force of the mesh of sun and planet 3 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_s3*touchs3*overs3;
            backlash_s3 => k_s3*clips3*touchs3*overs3;
            damping => beta_K*k_s3_mid*damps3*overs3_dot;
        }
        mesh_power_s3 "W", "power that the first gear gives to the mesh of sun and planet 3: force times the speed of its flank" {
            _ => mesh_force_s3*(h*Z_s*theta_c_dot + h*Z_s*theta_dot*(1.0/Z_r + 1.0/Z_s));
        }
        mesh_deflection_s3 "m", "deflection of the mesh of sun and planet 3 along the line of action, backlash not taken off" {
            _ => u3 - e_s3 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_s3 "m",
            "dynamic transmission error of the mesh of sun and planet 3 along the line of action: positive if the driving gear is ahead" {
            _ => u3 + h*Z_s*(theta_c + theta/Z_r + theta/Z_s) - h*theta - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0
                + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_s3 "W", "power that the damper of the mesh of sun and planet 3 takes" {
            backlash_s3 => k_s3*clips3*touchs3*overs3*overs3_dot;
            damping => beta_K*k_s3_mid*damps3*overs3_dot.powi(2);
        }
        power_slide_s3 "W" with sliding_friction_s3,
            "power of the friction of the mesh of sun and planet 3, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide_s3_power;
        }
        power_roll_s3 "W" with sliding_friction_s3,
            "power of the friction of the mesh of sun and planet 3, through the rolling of the gears: positive if it drives" {
            _ => roll_s3_power;
        }
        contact_loss_r3 "1" with backlash_r3,
            "1 while no force passes the mesh of ring and planet 3, else 0: its mean is the share of time without contact" {
            _ => 1.0 - touchr3*(1.0 + clipr3*(1.0 - clipr3)/2.0);
        }
        mesh_force_r3 "N",
            "force of the mesh of ring and planet 3 along the line of action, damper included: positive if it presses the drive flanks" {
            _ => k_r3*touchr3*overr3;
            backlash_r3 => k_r3*clipr3*touchr3*overr3;
            damping => beta_K*k_r3_mid*dampr3*overr3_dot;
        }
        mesh_power_r3 "W", "power that the first gear gives to the mesh of ring and planet 3: force times the speed of its flank" {
            _ => h*Z_r*theta_r_dot*mesh_force_r3;
        }
        mesh_deflection_r3 "m", "deflection of the mesh of ring and planet 3 along the line of action, backlash not taken off" {
            _ => h*Z_r*theta_r - e_r3 - (u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        dte_r3 "m",
            "dynamic transmission error of the mesh of ring and planet 3 along the line of action: positive if the driving gear is ahead" {
            _ => h*Z_r*theta_r - (u3 - h*theta + h*(Z_r - Z_s)*(theta_c + theta/Z_r)/2.0) - h*(Z_r + Z_s)*(theta_c + theta/Z_r)/2.0;
        }
        mesh_loss_r3 "W", "power that the damper of the mesh of ring and planet 3 takes" {
            backlash_r3 => k_r3*clipr3*touchr3*overr3*overr3_dot;
            damping => beta_K*k_r3_mid*dampr3*overr3_dot.powi(2);
        }
        power_slide_r3 "W" with sliding_friction_r3,
            "power of the friction of the mesh of ring and planet 3, through the sliding of the flanks at the pitch point: positive if it \
            drives" {
            _ => slide_r3_power;
        }
        power_roll_r3 "W" with sliding_friction_r3,
            "power of the friction of the mesh of ring and planet 3, through the rolling of the gears: positive if it drives" {
            _ => roll_r3_power;
        }
        power_motor "W" with torques, "power of the driving torque of the sun: positive if it drives" { _ => motor_power; }
        braking_governor_motor "W" with governor_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_motor*theta_motor_dot.powi(2);
        }
        power_governor_motor "W" with governor_motor,
            "power of the torque c n of the governor of the sun; its part -c omega is in D: positive if it drives" {
            _ => governor_motor_power;
        }
        net_power_governor_motor "W" with governor_motor,
            "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_motor_power - braking_governor_motor;
        }
        braking_dc_motor "W" with dc_motor,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_motor*theta_motor_dot.powi(2)/n0_motor;
        }
        power_dc_motor "W" with dc_motor,
            "power of the torque Ts of the DC motor of the sun; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_motor_power;
        }
        net_power_dc_motor "W" with dc_motor, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_motor_power - braking_dc_motor;
        }
        power_induction_motor "W" with induction_motor, "power of the torque of the induction motor of the sun: positive if it drives" {
            _ => induction_motor_power;
        }
        power_traction_motor "W" with traction_motor, "power of the torque of the traction motor of the sun: positive if it drives" {
            _ => traction_motor_power;
        }
        power_fan_motor "W" with fan_motor, "power of the torque of the fan of the sun, against the rotation: positive if it drives" {
            _ => fan_motor_power;
        }
        power_load "W" with torques, "power of the load torque of the carrier, against its rotation: positive if it drives" {
            _ => load_power;
        }
        braking_governor_load "W" with governor_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => c_load*theta_load_dot.powi(2);
        }
        power_governor_load "W" with governor_load,
            "power of the torque c n of the governor of the carrier; its part -c omega is in D: positive if it drives" {
            _ => governor_load_power;
        }
        net_power_governor_load "W" with governor_load,
            "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => governor_load_power - braking_governor_load;
        }
        braking_dc_load "W" with dc_load,
            "power that the motor takes back: the part of its torque that is proportional to the speed, times the speed" {
            _ => Ts_load*theta_load_dot.powi(2)/n0_load;
        }
        power_dc_load "W" with dc_load,
            "power of the torque Ts of the DC motor of the carrier; its part -Ts omega/n0 is in D: positive if it drives" {
            _ => dc_load_power;
        }
        net_power_dc_load "W" with dc_load, "power that the motor gives: its whole torque times its speed, negative if it brakes" {
            _ => dc_load_power - braking_dc_load;
        }
        power_induction_load "W" with induction_load, "power of the torque of the induction motor of the carrier: positive if it drives" {
            _ => induction_load_power;
        }
        power_traction_load "W" with traction_load, "power of the torque of the traction motor of the carrier: positive if it drives" {
            _ => traction_load_power;
        }
        power_fan_load "W" with fan_load, "power of the torque of the fan of the carrier, against the rotation: positive if it drives" {
            _ => fan_load_power;
        }
        inertia_damping_loss "W" with damping, "power that the damping in proportion to inertia takes" {
            _ => 2.0*alpha_M*(I_c*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0
                + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*theta_r_dot.powi(2)/2.0
                + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0
                + 3.0*a.powi(2)*m_p*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0);
        }
    }

    text "text/planetary_3.txt";
    latex "latex/planetary_3.tex";
}

// Proved of these equations, symbolically:
//
// - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive
//   effects; q'.dD/dq' includes the power that switches take
// - M is symmetric
// - T = q'.M q'/2, with M as written
// - M is positive definite: T is a sum of squares that vanish together only at rest
// - at a step of k_s1, k_r1, k_s2, k_r2, k_s3, k_r3, e_s1, e_r1, e_s2, e_r2, e_s3, e_r3: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d =
//   n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
// - V is the same on both sides of a step of side_s1, arm_s1, side_r1, arm_r1, side_s2, arm_s2, side_r2, arm_r2, side_s3, arm_s3, side_r3,
//   arm_r3: no impulse there
// - V is the same on both sides of the exits of overs1: no impulse there
// - the force of the switch overs1 takes energy or none: f overs1_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dovers1 and c = 1 or -1, since F overs1 >= 0, overs1_dot dD/dovers1_dot >= 0 and c overs1
//   dD/dovers1_dot >= F overs1
// - V is the same on both sides of the exits of psi_s1: no impulse there
// - V is the same on both sides of the exits of overr1: no impulse there
// - the force of the switch overr1 takes energy or none: f overr1_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/doverr1 and c = 1 or -1, since F overr1 >= 0, overr1_dot dD/doverr1_dot >= 0 and c overr1
//   dD/doverr1_dot >= F overr1
// - V is the same on both sides of the exits of psi_r1: no impulse there
// - V is the same on both sides of the exits of overs2: no impulse there
// - the force of the switch overs2 takes energy or none: f overs2_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dovers2 and c = 1 or -1, since F overs2 >= 0, overs2_dot dD/dovers2_dot >= 0 and c overs2
//   dD/dovers2_dot >= F overs2
// - V is the same on both sides of the exits of psi_s2: no impulse there
// - V is the same on both sides of the exits of overr2: no impulse there
// - the force of the switch overr2 takes energy or none: f overr2_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/doverr2 and c = 1 or -1, since F overr2 >= 0, overr2_dot dD/doverr2_dot >= 0 and c overr2
//   dD/doverr2_dot >= F overr2
// - V is the same on both sides of the exits of psi_r2: no impulse there
// - V is the same on both sides of the exits of overs3: no impulse there
// - the force of the switch overs3 takes energy or none: f overs3_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/dovers3 and c = 1 or -1, since F overs3 >= 0, overs3_dot dD/dovers3_dot >= 0 and c overs3
//   dD/dovers3_dot >= F overs3
// - V is the same on both sides of the exits of psi_s3: no impulse there
// - V is the same on both sides of the exits of overr3: no impulse there
// - the force of the switch overr3 takes energy or none: f overr3_dot >= 0 in every mode, from the guards that hold in it; of a damper that
//   is clipped to f = c F, where F = dV/doverr3 and c = 1 or -1, since F overr3 >= 0, overr3_dot dD/doverr3_dot >= 0 and c overr3
//   dD/doverr3_dot >= F overr3
// - V is the same on both sides of the exits of psi_r3: no impulse there
// - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
// - the friction `roll_s1` takes energy or none: its power is never positive
// - the friction `roll_r1` takes energy or none: its power is never positive
// - the friction `roll_s2` takes energy or none: its power is never positive
// - the friction `roll_r2` takes energy or none: its power is never positive
// - the friction `roll_s3` takes energy or none: its power is never positive
// - the friction `roll_r3` takes energy or none: its power is never positive
// - the friction `slide_s1` is the force of `roll_s1` times at most 1, along its sign or against it
// - the friction `slide_s1` takes with `roll_s1` energy or none where psi_s1_dot and arm_s1 psi_s1_dot + side_s1 tau_s1_dot have one sign,
//   on the coast flank with -side_s1: where flanks slide as rolling makes them
// - the friction `slide_s1` takes with `roll_s1` energy or none in every mode of psi_s1, in scenes with flank_stiction_s1: from the guards
//   that hold in the mode
// - the friction `slide_r1` is the force of `roll_r1` times at most 1, along its sign or against it
// - the friction `slide_r1` takes with `roll_r1` energy or none where psi_r1_dot and arm_r1 psi_r1_dot + side_r1 tau_r1_dot have one sign,
//   on the coast flank with -side_r1: where flanks slide as rolling makes them
// - the friction `slide_r1` takes with `roll_r1` energy or none in every mode of psi_r1, in scenes with flank_stiction_r1: from the guards
//   that hold in the mode
// - the friction `slide_s2` is the force of `roll_s2` times at most 1, along its sign or against it
// - the friction `slide_s2` takes with `roll_s2` energy or none where psi_s2_dot and arm_s2 psi_s2_dot + side_s2 tau_s2_dot have one sign,
//   on the coast flank with -side_s2: where flanks slide as rolling makes them
// - the friction `slide_s2` takes with `roll_s2` energy or none in every mode of psi_s2, in scenes with flank_stiction_s2: from the guards
//   that hold in the mode
// - the friction `slide_r2` is the force of `roll_r2` times at most 1, along its sign or against it
// - the friction `slide_r2` takes with `roll_r2` energy or none where psi_r2_dot and arm_r2 psi_r2_dot + side_r2 tau_r2_dot have one sign,
//   on the coast flank with -side_r2: where flanks slide as rolling makes them
// - the friction `slide_r2` takes with `roll_r2` energy or none in every mode of psi_r2, in scenes with flank_stiction_r2: from the guards
//   that hold in the mode
// - the friction `slide_s3` is the force of `roll_s3` times at most 1, along its sign or against it
// - the friction `slide_s3` takes with `roll_s3` energy or none where psi_s3_dot and arm_s3 psi_s3_dot + side_s3 tau_s3_dot have one sign,
//   on the coast flank with -side_s3: where flanks slide as rolling makes them
// - the friction `slide_s3` takes with `roll_s3` energy or none in every mode of psi_s3, in scenes with flank_stiction_s3: from the guards
//   that hold in the mode
// - the friction `slide_r3` is the force of `roll_r3` times at most 1, along its sign or against it
// - the friction `slide_r3` takes with `roll_r3` energy or none where psi_r3_dot and arm_r3 psi_r3_dot + side_r3 tau_r3_dot have one sign,
//   on the coast flank with -side_r3: where flanks slide as rolling makes them
// - the friction `slide_r3` takes with `roll_r3` energy or none in every mode of psi_r3, in scenes with flank_stiction_r3: from the guards
//   that hold in the mode
// - every deflection equals the linear form by which the equations differentiate it
// - without the jump terms the balance fails: energy is created at the rate dk_r1*touchr1*overr1^2*theta_dot/2 -
//   k_r1*de_r1*touchr1*overr1*theta_dot - k_r2*de_r2*touchr2*overr2*theta_dot - k_r3*de_r3*touchr3*overr3*theta_dot -
//   k_s1*de_s1*touchs1*overs1*theta_dot - k_s2*de_s2*touchs2*overs2*theta_dot - k_s3*de_s3*touchs3*overs3*theta_dot +
//   dk_r2*touchr2*overr2^2*theta_dot/2 + dk_r3*touchr3*overr3^2*theta_dot/2 + dk_s1*touchs1*overs1^2*theta_dot/2 +
//   dk_s2*touchs2*overs2^2*theta_dot/2 + dk_s3*touchs3*overs3^2*theta_dot/2
//
// Operations, all effects present:
//
// | output | sums | products, quotients | functions, roots |
// | --- | --- | --- | --- |
// | constants (once a scene) | 4 | 15 | 2 |
// | named forces | 72 | 246 | 42 |
// | force | 98 | 508 | 0 |
// | energy steps, all laws | 6 | 66 | 0 |
