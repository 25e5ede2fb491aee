//! Equations of motion of `planetary_6`: a planetary stage with 6 planets, torsional.
//!
//! Derived from the energies in `models/src/planetary.rs` by `cargo xtask derive planetary_6`. Do not edit: change the
//! energies and derive again.
//! Source: Lin & Parker (1999), J. Vib. Acoust. 121(3), with centres held; phase on the sun
//!
//! # Energies
//!
//! ```text
//! T = I_c*(theta_c_dot + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u5_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u6_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_r*theta_r_dot^2/2 + I_s*(theta_c_dot + theta_dot*(1/Z_r + 1/Z_s))^2/2 + 3*a^2*m_p*(theta_c_dot + theta_dot/Z_r)^2
//! V = (k_r*theta_r^2 + k_r1*delta_r1^2 + k_r2*delta_r2^2 + k_r3*delta_r3^2 + k_r4*delta_r4^2 + k_r5*delta_r5^2 + k_r6*delta_r6^2 + k_s1*delta_s1^2 + k_s2*delta_s2^2 + k_s3*delta_s3^2 + k_s4*delta_s4^2 + k_s5*delta_s5^2 + k_s6*delta_s6^2)/2
//! D = I_c*alpha_M*(theta_c_dot + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u5_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u6_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_r*alpha_M*theta_r_dot^2/2 + I_s*alpha_M*(theta_c_dot + theta_dot*(1/Z_r + 1/Z_s))^2/2 + beta_K*k_r*theta_r_dot^2/2 + beta_K*k_r1_mid*delta_r1_dot^2/2 + beta_K*k_r2_mid*delta_r2_dot^2/2 + beta_K*k_r3_mid*delta_r3_dot^2/2 + beta_K*k_r4_mid*delta_r4_dot^2/2 + beta_K*k_r5_mid*delta_r5_dot^2/2 + beta_K*k_r6_mid*delta_r6_dot^2/2 + beta_K*k_s1_mid*delta_s1_dot^2/2 + beta_K*k_s2_mid*delta_s2_dot^2/2 + beta_K*k_s3_mid*delta_s3_dot^2/2 + beta_K*k_s4_mid*delta_s4_dot^2/2 + beta_K*k_s5_mid*delta_s5_dot^2/2 + beta_K*k_s6_mid*delta_s6_dot^2/2 + 3*a^2*alpha_M*m_p*(theta_c_dot + theta_dot/Z_r)^2 [damping]
//! Q_theta = T_motor/Z_r - T_load/Z_r + T_motor/Z_s [torques]
//! Q_theta_c = T_motor - T_load [torques]
//! Q_theta_r = 0
//! Q_u1 = 0
//! Q_u2 = 0
//! Q_u3 = 0
//! Q_u4 = 0
//! Q_u5 = 0
//! Q_u6 = 0
//! ```
//!
//! # Constants
//!
//! ```text
//! cos_a = cos(alpha)
//! sin_a = sin(alpha)
//! h = r_s/Z_s
//! r_p = (h*Z_r - h*Z_s)/2
//! a = (h*Z_r/cos_a + h*Z_s/cos_a)/2
//! ```
//!
//! # Deflections
//!
//! ```text
//! delta_s1 = u1 - e_s1
//! delta_r1 = h*Z_r*theta_r - u1 - e_r1 - h*Z_r*theta_c
//! delta_s2 = u2 - e_s2
//! delta_r2 = h*Z_r*theta_r - u2 - e_r2 - h*Z_r*theta_c
//! delta_s3 = u3 - e_s3
//! delta_r3 = h*Z_r*theta_r - u3 - e_r3 - h*Z_r*theta_c
//! delta_s4 = u4 - e_s4
//! delta_r4 = h*Z_r*theta_r - u4 - e_r4 - h*Z_r*theta_c
//! delta_s5 = u5 - e_s5
//! delta_r5 = h*Z_r*theta_r - u5 - e_r5 - h*Z_r*theta_c
//! delta_s6 = u6 - e_s6
//! delta_r6 = h*Z_r*theta_r - u6 - e_r6 - h*Z_r*theta_c
//! e_s1 = 0 without transmission error; the rates of deflections do not contain that of e_s1
//! e_r1 = 0 without transmission error; the rates of deflections do not contain that of e_r1
//! e_s2 = 0 without transmission error; the rates of deflections do not contain that of e_s2
//! e_r2 = 0 without transmission error; the rates of deflections do not contain that of e_r2
//! e_s3 = 0 without transmission error; the rates of deflections do not contain that of e_s3
//! e_r3 = 0 without transmission error; the rates of deflections do not contain that of e_r3
//! e_s4 = 0 without transmission error; the rates of deflections do not contain that of e_s4
//! e_r4 = 0 without transmission error; the rates of deflections do not contain that of e_r4
//! e_s5 = 0 without transmission error; the rates of deflections do not contain that of e_s5
//! e_r5 = 0 without transmission error; the rates of deflections do not contain that of e_r5
//! e_s6 = 0 without transmission error; the rates of deflections do not contain that of e_s6
//! e_r6 = 0 without transmission error; the rates of deflections do not contain that of e_r6
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! (I_c/Z_r^2 - 12*h*I_p/(r_p*Z_r) + 6*I_p/Z_r^2 + I_s/Z_r^2 + 2*I_s/(Z_r*Z_s) + I_s/Z_s^2 + 6*a^2*m_p/Z_r^2 + 6*h^2*I_p/r_p^2) theta'' + (I_c/Z_r - 6*h*I_p/r_p + 6*I_p/Z_r + I_s/Z_r + I_s/Z_s + 6*a^2*m_p/Z_r) theta_c'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u1'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u2'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u3'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u4'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u5'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u6'' = k_r1*de_r1*delta_r1 + k_r2*de_r2*delta_r2 + k_r3*de_r3*delta_r3 + k_r4*de_r4*delta_r4 + k_r5*de_r5*delta_r5 + k_r6*de_r6*delta_r6 + k_s1*de_s1*delta_s1 + k_s2*de_s2*delta_s2 + k_s3*de_s3*delta_s3 + k_s4*de_s4*delta_s4 + k_s5*de_s5*delta_s5 + k_s6*de_s6*delta_s6 [transmission error, jump terms] + T_motor/Z_r - T_load/Z_r + T_motor/Z_s [torques] + h*I_p*alpha_M*u1_dot/r_p^2 + h*I_p*alpha_M*u2_dot/r_p^2 + h*I_p*alpha_M*u3_dot/r_p^2 + h*I_p*alpha_M*u4_dot/r_p^2 + h*I_p*alpha_M*u5_dot/r_p^2 + h*I_p*alpha_M*u6_dot/r_p^2 + 6*h*I_p*alpha_M*theta_c_dot/r_p + 12*h*I_p*alpha_M*theta_dot/(r_p*Z_r) - I_c*alpha_M*theta_dot/Z_r^2 - I_c*alpha_M*theta_c_dot/Z_r - 6*I_p*alpha_M*theta_dot/Z_r^2 - 6*I_p*alpha_M*theta_c_dot/Z_r - I_s*alpha_M*theta_dot/Z_r^2 - I_s*alpha_M*theta_c_dot/Z_r - 2*I_s*alpha_M*theta_dot/(Z_r*Z_s) - I_s*alpha_M*theta_dot/Z_s^2 - I_s*alpha_M*theta_c_dot/Z_s - 6*a^2*alpha_M*m_p*theta_dot/Z_r^2 - 6*a^2*alpha_M*m_p*theta_c_dot/Z_r - 6*h^2*I_p*alpha_M*theta_dot/r_p^2 - I_p*alpha_M*u1_dot/(r_p*Z_r) - I_p*alpha_M*u2_dot/(r_p*Z_r) - I_p*alpha_M*u3_dot/(r_p*Z_r) - I_p*alpha_M*u4_dot/(r_p*Z_r) - I_p*alpha_M*u5_dot/(r_p*Z_r) - I_p*alpha_M*u6_dot/(r_p*Z_r) [damping] + (-dk_r1*delta_r1^2 - dk_r2*delta_r2^2 - dk_r3*delta_r3^2 - dk_r4*delta_r4^2 - dk_r5*delta_r5^2 - dk_r6*delta_r6^2 - dk_s1*delta_s1^2 - dk_s2*delta_s2^2 - dk_s3*delta_s3^2 - dk_s4*delta_s4^2 - dk_s5*delta_s5^2 - dk_s6*delta_s6^2)/2 [jump terms]
//! (I_c/Z_r - 6*h*I_p/r_p + 6*I_p/Z_r + I_s/Z_r + I_s/Z_s + 6*a^2*m_p/Z_r) theta'' + (I_c + 6*I_p + I_s + 6*a^2*m_p) theta_c'' + (I_p/r_p) u1'' + (I_p/r_p) u2'' + (I_p/r_p) u3'' + (I_p/r_p) u4'' + (I_p/r_p) u5'' + (I_p/r_p) u6'' = h*Z_r*k_r1*delta_r1 + h*Z_r*k_r2*delta_r2 + h*Z_r*k_r3*delta_r3 + h*Z_r*k_r4*delta_r4 + h*Z_r*k_r5*delta_r5 + h*Z_r*k_r6*delta_r6 + T_motor - T_load [torques] + h*Z_r*beta_K*k_r1_mid*delta_r1_dot + h*Z_r*beta_K*k_r2_mid*delta_r2_dot + h*Z_r*beta_K*k_r3_mid*delta_r3_dot + h*Z_r*beta_K*k_r4_mid*delta_r4_dot + h*Z_r*beta_K*k_r5_mid*delta_r5_dot + h*Z_r*beta_K*k_r6_mid*delta_r6_dot + 6*h*I_p*alpha_M*theta_dot/r_p - I_c*alpha_M*theta_c_dot - I_c*alpha_M*theta_dot/Z_r - 6*I_p*alpha_M*theta_c_dot - 6*I_p*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_c_dot - I_s*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_dot/Z_s - 6*a^2*alpha_M*m_p*theta_c_dot - 6*a^2*alpha_M*m_p*theta_dot/Z_r - I_p*alpha_M*u1_dot/r_p - I_p*alpha_M*u2_dot/r_p - I_p*alpha_M*u3_dot/r_p - I_p*alpha_M*u4_dot/r_p - I_p*alpha_M*u5_dot/r_p - I_p*alpha_M*u6_dot/r_p [damping]
//! (I_r) theta_r'' = -h*Z_r*k_r1*delta_r1 - h*Z_r*k_r2*delta_r2 - h*Z_r*k_r3*delta_r3 - h*Z_r*k_r4*delta_r4 - h*Z_r*k_r5*delta_r5 - h*Z_r*k_r6*delta_r6 - k_r*theta_r - h*Z_r*beta_K*k_r1_mid*delta_r1_dot - h*Z_r*beta_K*k_r2_mid*delta_r2_dot - h*Z_r*beta_K*k_r3_mid*delta_r3_dot - h*Z_r*beta_K*k_r4_mid*delta_r4_dot - h*Z_r*beta_K*k_r5_mid*delta_r5_dot - h*Z_r*beta_K*k_r6_mid*delta_r6_dot - I_r*alpha_M*theta_r_dot - beta_K*k_r*theta_r_dot [damping]
//! (I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u1'' = k_r1*delta_r1 - k_s1*delta_s1 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r1_mid*delta_r1_dot - beta_K*k_s1_mid*delta_s1_dot - I_p*alpha_M*u1_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]
//! (I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u2'' = k_r2*delta_r2 - k_s2*delta_s2 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r2_mid*delta_r2_dot - beta_K*k_s2_mid*delta_s2_dot - I_p*alpha_M*u2_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]
//! (I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u3'' = k_r3*delta_r3 - k_s3*delta_s3 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r3_mid*delta_r3_dot - beta_K*k_s3_mid*delta_s3_dot - I_p*alpha_M*u3_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]
//! (I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u4'' = k_r4*delta_r4 - k_s4*delta_s4 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r4_mid*delta_r4_dot - beta_K*k_s4_mid*delta_s4_dot - I_p*alpha_M*u4_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]
//! (I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u5'' = k_r5*delta_r5 - k_s5*delta_s5 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r5_mid*delta_r5_dot - beta_K*k_s5_mid*delta_s5_dot - I_p*alpha_M*u5_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]
//! (I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u6'' = k_r6*delta_r6 - k_s6*delta_s6 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r6_mid*delta_r6_dot - beta_K*k_s6_mid*delta_s6_dot - I_p*alpha_M*u6_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]
//! ```
//!
//! # At a step of a stiffness or a transmission error
//!
//! ```text
//! at a step dk_s1 of k_s1 in theta: v+^2 = v-^2 - 2*G*(dk_s1*delta_s1^2/2)
//! at a step dk_r1 of k_r1 in theta: v+^2 = v-^2 - 2*G*(dk_r1*delta_r1^2/2)
//! at a step dk_s2 of k_s2 in theta: v+^2 = v-^2 - 2*G*(dk_s2*delta_s2^2/2)
//! at a step dk_r2 of k_r2 in theta: v+^2 = v-^2 - 2*G*(dk_r2*delta_r2^2/2)
//! at a step dk_s3 of k_s3 in theta: v+^2 = v-^2 - 2*G*(dk_s3*delta_s3^2/2)
//! at a step dk_r3 of k_r3 in theta: v+^2 = v-^2 - 2*G*(dk_r3*delta_r3^2/2)
//! at a step dk_s4 of k_s4 in theta: v+^2 = v-^2 - 2*G*(dk_s4*delta_s4^2/2)
//! at a step dk_r4 of k_r4 in theta: v+^2 = v-^2 - 2*G*(dk_r4*delta_r4^2/2)
//! at a step dk_s5 of k_s5 in theta: v+^2 = v-^2 - 2*G*(dk_s5*delta_s5^2/2)
//! at a step dk_r5 of k_r5 in theta: v+^2 = v-^2 - 2*G*(dk_r5*delta_r5^2/2)
//! at a step dk_s6 of k_s6 in theta: v+^2 = v-^2 - 2*G*(dk_s6*delta_s6^2/2)
//! at a step dk_r6 of k_r6 in theta: v+^2 = v-^2 - 2*G*(dk_r6*delta_r6^2/2)
//! at a step de_s1 of e_s1 in theta: v+^2 = v-^2 - 2*G*(k_s1*de_s1^2/2 - k_s1*de_s1*delta_s1)
//! at a step de_r1 of e_r1 in theta: v+^2 = v-^2 - 2*G*(k_r1*de_r1^2/2 - k_r1*de_r1*delta_r1)
//! at a step de_s2 of e_s2 in theta: v+^2 = v-^2 - 2*G*(k_s2*de_s2^2/2 - k_s2*de_s2*delta_s2)
//! at a step de_r2 of e_r2 in theta: v+^2 = v-^2 - 2*G*(k_r2*de_r2^2/2 - k_r2*de_r2*delta_r2)
//! at a step de_s3 of e_s3 in theta: v+^2 = v-^2 - 2*G*(k_s3*de_s3^2/2 - k_s3*de_s3*delta_s3)
//! at a step de_r3 of e_r3 in theta: v+^2 = v-^2 - 2*G*(k_r3*de_r3^2/2 - k_r3*de_r3*delta_r3)
//! at a step de_s4 of e_s4 in theta: v+^2 = v-^2 - 2*G*(k_s4*de_s4^2/2 - k_s4*de_s4*delta_s4)
//! at a step de_r4 of e_r4 in theta: v+^2 = v-^2 - 2*G*(k_r4*de_r4^2/2 - k_r4*de_r4*delta_r4)
//! at a step de_s5 of e_s5 in theta: v+^2 = v-^2 - 2*G*(k_s5*de_s5^2/2 - k_s5*de_s5*delta_s5)
//! at a step de_r5 of e_r5 in theta: v+^2 = v-^2 - 2*G*(k_r5*de_r5^2/2 - k_r5*de_r5*delta_r5)
//! at a step de_s6 of e_s6 in theta: v+^2 = v-^2 - 2*G*(k_s6*de_s6^2/2 - k_s6*de_s6*delta_s6)
//! at a step de_r6 of e_r6 in theta: v+^2 = v-^2 - 2*G*(k_r6*de_r6^2/2 - k_r6*de_r6*delta_r6)
//! ```
//!
//! # Between two steps
//!
//! ```text
//! M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly
//! ```
//!
//! # LaTeX
//!
//! ```latex
//! T = \frac{I_{c}\, \left(\dot{\theta_{c}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{1}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{2}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{3}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{4}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{5}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{6}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{r}\, \dot{\theta_{r}}^{2}}{2} + \frac{I_{s}\, \left(\dot{\theta_{c}} + \dot{\theta}\, \left(\frac{1}{Z_{r}} + \frac{1}{Z_{s}}\right)\right)^{2}}{2} + 3\, a^{2}\, m_{p}\, \left(\dot{\theta_{c}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}
//! V = \frac{1}{2} (k_{r}\, \theta_{r}^{2} + k_{r1}\, \delta_{r1}^{2} + k_{r2}\, \delta_{r2}^{2} + k_{r3}\, \delta_{r3}^{2} + k_{r4}\, \delta_{r4}^{2} + k_{r5}\, \delta_{r5}^{2} + k_{r6}\, \delta_{r6}^{2} + k_{s1}\, \delta_{s1}^{2} + k_{s2}\, \delta_{s2}^{2} + k_{s3}\, \delta_{s3}^{2} + k_{s4}\, \delta_{s4}^{2} + k_{s5}\, \delta_{s5}^{2} + k_{s6}\, \delta_{s6}^{2})
//! D = \frac{I_{c}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{1}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{2}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{3}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{4}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{5}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{p}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \frac{\left(\dot{u_{6}} - h\, \dot{\theta}\right)}{r_{p}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}}{2} + \frac{I_{r}\, \alpha_{M}\, \dot{\theta_{r}}^{2}}{2} + \frac{I_{s}\, \alpha_{M}\, \left(\dot{\theta_{c}} + \dot{\theta}\, \left(\frac{1}{Z_{r}} + \frac{1}{Z_{s}}\right)\right)^{2}}{2} + \frac{\beta_{K}\, k_{r}\, \dot{\theta_{r}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{r1}}\, \dot{\delta_{r1}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{r2}}\, \dot{\delta_{r2}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{r3}}\, \dot{\delta_{r3}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{r4}}\, \dot{\delta_{r4}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{r5}}\, \dot{\delta_{r5}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{r6}}\, \dot{\delta_{r6}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{s1}}\, \dot{\delta_{s1}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{s2}}\, \dot{\delta_{s2}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{s3}}\, \dot{\delta_{s3}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{s4}}\, \dot{\delta_{s4}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{s5}}\, \dot{\delta_{s5}}^{2}}{2} + \frac{\beta_{K}\, \bar{k_{s6}}\, \dot{\delta_{s6}}^{2}}{2} + 3\, a^{2}\, \alpha_{M}\, m_{p}\, \left(\dot{\theta_{c}} + \frac{\dot{\theta}}{Z_{r}}\right)^{2}\ [\text{damping}]
//! Q_{\theta} = \frac{T_{motor}}{Z_{r}} - \frac{T_{load}}{Z_{r}} + \frac{T_{motor}}{Z_{s}}\ [\text{torques}]
//! Q_{\theta_{c}} = T_{motor} - T_{load}\ [\text{torques}]
//! Q_{\theta_{r}} = 0
//! Q_{u_{1}} = 0
//! Q_{u_{2}} = 0
//! Q_{u_{3}} = 0
//! Q_{u_{4}} = 0
//! Q_{u_{5}} = 0
//! Q_{u_{6}} = 0
//! \mathrm{cos}_{a} = \cos\left(\alpha\right)
//! \mathrm{sin}_{a} = \sin\left(\alpha\right)
//! h = \frac{r_{s}}{Z_{s}}
//! r_{p} = \frac{1}{2} (h\, Z_{r} - h\, Z_{s})
//! a = \frac{1}{2} (\frac{h\, Z_{r}}{\mathrm{cos}_{a}} + \frac{h\, Z_{s}}{\mathrm{cos}_{a}})
//! \delta_{s1} = u_{1} - e_{s1}
//! \delta_{r1} = h\, Z_{r}\, \theta_{r} - u_{1} - e_{r1} - h\, Z_{r}\, \theta_{c}
//! \delta_{s2} = u_{2} - e_{s2}
//! \delta_{r2} = h\, Z_{r}\, \theta_{r} - u_{2} - e_{r2} - h\, Z_{r}\, \theta_{c}
//! \delta_{s3} = u_{3} - e_{s3}
//! \delta_{r3} = h\, Z_{r}\, \theta_{r} - u_{3} - e_{r3} - h\, Z_{r}\, \theta_{c}
//! \delta_{s4} = u_{4} - e_{s4}
//! \delta_{r4} = h\, Z_{r}\, \theta_{r} - u_{4} - e_{r4} - h\, Z_{r}\, \theta_{c}
//! \delta_{s5} = u_{5} - e_{s5}
//! \delta_{r5} = h\, Z_{r}\, \theta_{r} - u_{5} - e_{r5} - h\, Z_{r}\, \theta_{c}
//! \delta_{s6} = u_{6} - e_{s6}
//! \delta_{r6} = h\, Z_{r}\, \theta_{r} - u_{6} - e_{r6} - h\, Z_{r}\, \theta_{c}
//! (\frac{I_{c}}{Z_{r}^{2}} - \frac{12\, h\, I_{p}}{r_{p}\, Z_{r}} + \frac{6\, I_{p}}{Z_{r}^{2}} + \frac{I_{s}}{Z_{r}^{2}} + \frac{2\, I_{s}}{Z_{r}\, Z_{s}} + \frac{I_{s}}{Z_{s}^{2}} + \frac{6\, a^{2}\, m_{p}}{Z_{r}^{2}} + \frac{6\, h^{2}\, I_{p}}{r_{p}^{2}}) \ddot{\theta} + (\frac{I_{c}}{Z_{r}} - \frac{6\, h\, I_{p}}{r_{p}} + \frac{6\, I_{p}}{Z_{r}} + \frac{I_{s}}{Z_{r}} + \frac{I_{s}}{Z_{s}} + \frac{6\, a^{2}\, m_{p}}{Z_{r}}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{u_{1}} + (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{u_{2}} + (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{u_{3}} + (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{u_{4}} + (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{u_{5}} + (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{u_{6}} = k_{r1}\, e_{r1}'\, \delta_{r1} + k_{r2}\, e_{r2}'\, \delta_{r2} + k_{r3}\, e_{r3}'\, \delta_{r3} + k_{r4}\, e_{r4}'\, \delta_{r4} + k_{r5}\, e_{r5}'\, \delta_{r5} + k_{r6}\, e_{r6}'\, \delta_{r6} + k_{s1}\, e_{s1}'\, \delta_{s1} + k_{s2}\, e_{s2}'\, \delta_{s2} + k_{s3}\, e_{s3}'\, \delta_{s3} + k_{s4}\, e_{s4}'\, \delta_{s4} + k_{s5}\, e_{s5}'\, \delta_{s5} + k_{s6}\, e_{s6}'\, \delta_{s6}\ [\text{transmission error, jump terms}] + \frac{T_{motor}}{Z_{r}} - \frac{T_{load}}{Z_{r}} + \frac{T_{motor}}{Z_{s}}\ [\text{torques}] + \frac{h\, I_{p}\, \alpha_{M}\, \dot{u_{1}}}{r_{p}^{2}} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{u_{2}}}{r_{p}^{2}} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{u_{3}}}{r_{p}^{2}} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{u_{4}}}{r_{p}^{2}} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{u_{5}}}{r_{p}^{2}} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{u_{6}}}{r_{p}^{2}} + \frac{6\, h\, I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{r_{p}} + \frac{12\, h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}\, Z_{r}} - \frac{I_{c}\, \alpha_{M}\, \dot{\theta}}{Z_{r}^{2}} - \frac{I_{c}\, \alpha_{M}\, \dot{\theta_{c}}}{Z_{r}} - \frac{6\, I_{p}\, \alpha_{M}\, \dot{\theta}}{Z_{r}^{2}} - \frac{6\, I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{Z_{r}} - \frac{I_{s}\, \alpha_{M}\, \dot{\theta}}{Z_{r}^{2}} - \frac{I_{s}\, \alpha_{M}\, \dot{\theta_{c}}}{Z_{r}} - \frac{2\, I_{s}\, \alpha_{M}\, \dot{\theta}}{Z_{r}\, Z_{s}} - \frac{I_{s}\, \alpha_{M}\, \dot{\theta}}{Z_{s}^{2}} - \frac{I_{s}\, \alpha_{M}\, \dot{\theta_{c}}}{Z_{s}} - \frac{6\, a^{2}\, \alpha_{M}\, m_{p}\, \dot{\theta}}{Z_{r}^{2}} - \frac{6\, a^{2}\, \alpha_{M}\, m_{p}\, \dot{\theta_{c}}}{Z_{r}} - \frac{6\, h^{2}\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}^{2}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{1}}}{r_{p}\, Z_{r}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{2}}}{r_{p}\, Z_{r}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{3}}}{r_{p}\, Z_{r}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{4}}}{r_{p}\, Z_{r}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{5}}}{r_{p}\, Z_{r}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{6}}}{r_{p}\, Z_{r}}\ [\text{damping}] + \frac{1}{2} (-k_{r1}'\, \delta_{r1}^{2} - k_{r2}'\, \delta_{r2}^{2} - k_{r3}'\, \delta_{r3}^{2} - k_{r4}'\, \delta_{r4}^{2} - k_{r5}'\, \delta_{r5}^{2} - k_{r6}'\, \delta_{r6}^{2} - k_{s1}'\, \delta_{s1}^{2} - k_{s2}'\, \delta_{s2}^{2} - k_{s3}'\, \delta_{s3}^{2} - k_{s4}'\, \delta_{s4}^{2} - k_{s5}'\, \delta_{s5}^{2} - k_{s6}'\, \delta_{s6}^{2})\ [\text{jump terms}]
//! (\frac{I_{c}}{Z_{r}} - \frac{6\, h\, I_{p}}{r_{p}} + \frac{6\, I_{p}}{Z_{r}} + \frac{I_{s}}{Z_{r}} + \frac{I_{s}}{Z_{s}} + \frac{6\, a^{2}\, m_{p}}{Z_{r}}) \ddot{\theta} + (I_{c} + 6\, I_{p} + I_{s} + 6\, a^{2}\, m_{p}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}}) \ddot{u_{1}} + (\frac{I_{p}}{r_{p}}) \ddot{u_{2}} + (\frac{I_{p}}{r_{p}}) \ddot{u_{3}} + (\frac{I_{p}}{r_{p}}) \ddot{u_{4}} + (\frac{I_{p}}{r_{p}}) \ddot{u_{5}} + (\frac{I_{p}}{r_{p}}) \ddot{u_{6}} = h\, Z_{r}\, k_{r1}\, \delta_{r1} + h\, Z_{r}\, k_{r2}\, \delta_{r2} + h\, Z_{r}\, k_{r3}\, \delta_{r3} + h\, Z_{r}\, k_{r4}\, \delta_{r4} + h\, Z_{r}\, k_{r5}\, \delta_{r5} + h\, Z_{r}\, k_{r6}\, \delta_{r6} + T_{motor} - T_{load}\ [\text{torques}] + h\, Z_{r}\, \beta_{K}\, \bar{k_{r1}}\, \dot{\delta_{r1}} + h\, Z_{r}\, \beta_{K}\, \bar{k_{r2}}\, \dot{\delta_{r2}} + h\, Z_{r}\, \beta_{K}\, \bar{k_{r3}}\, \dot{\delta_{r3}} + h\, Z_{r}\, \beta_{K}\, \bar{k_{r4}}\, \dot{\delta_{r4}} + h\, Z_{r}\, \beta_{K}\, \bar{k_{r5}}\, \dot{\delta_{r5}} + h\, Z_{r}\, \beta_{K}\, \bar{k_{r6}}\, \dot{\delta_{r6}} + \frac{6\, h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}} - I_{c}\, \alpha_{M}\, \dot{\theta_{c}} - \frac{I_{c}\, \alpha_{M}\, \dot{\theta}}{Z_{r}} - 6\, I_{p}\, \alpha_{M}\, \dot{\theta_{c}} - \frac{6\, I_{p}\, \alpha_{M}\, \dot{\theta}}{Z_{r}} - I_{s}\, \alpha_{M}\, \dot{\theta_{c}} - \frac{I_{s}\, \alpha_{M}\, \dot{\theta}}{Z_{r}} - \frac{I_{s}\, \alpha_{M}\, \dot{\theta}}{Z_{s}} - 6\, a^{2}\, \alpha_{M}\, m_{p}\, \dot{\theta_{c}} - \frac{6\, a^{2}\, \alpha_{M}\, m_{p}\, \dot{\theta}}{Z_{r}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{1}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{2}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{3}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{4}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{5}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{6}}}{r_{p}}\ [\text{damping}]
//! (I_{r}) \ddot{\theta_{r}} = -h\, Z_{r}\, k_{r1}\, \delta_{r1} - h\, Z_{r}\, k_{r2}\, \delta_{r2} - h\, Z_{r}\, k_{r3}\, \delta_{r3} - h\, Z_{r}\, k_{r4}\, \delta_{r4} - h\, Z_{r}\, k_{r5}\, \delta_{r5} - h\, Z_{r}\, k_{r6}\, \delta_{r6} - k_{r}\, \theta_{r} - h\, Z_{r}\, \beta_{K}\, \bar{k_{r1}}\, \dot{\delta_{r1}} - h\, Z_{r}\, \beta_{K}\, \bar{k_{r2}}\, \dot{\delta_{r2}} - h\, Z_{r}\, \beta_{K}\, \bar{k_{r3}}\, \dot{\delta_{r3}} - h\, Z_{r}\, \beta_{K}\, \bar{k_{r4}}\, \dot{\delta_{r4}} - h\, Z_{r}\, \beta_{K}\, \bar{k_{r5}}\, \dot{\delta_{r5}} - h\, Z_{r}\, \beta_{K}\, \bar{k_{r6}}\, \dot{\delta_{r6}} - I_{r}\, \alpha_{M}\, \dot{\theta_{r}} - \beta_{K}\, k_{r}\, \dot{\theta_{r}}\ [\text{damping}]
//! (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{\theta} + (\frac{I_{p}}{r_{p}}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}^{2}}) \ddot{u_{1}} = k_{r1}\, \delta_{r1} - k_{s1}\, \delta_{s1} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}^{2}} + \beta_{K}\, \bar{k_{r1}}\, \dot{\delta_{r1}} - \beta_{K}\, \bar{k_{s1}}\, \dot{\delta_{s1}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{1}}}{r_{p}^{2}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}\, Z_{r}}\ [\text{damping}]
//! (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{\theta} + (\frac{I_{p}}{r_{p}}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}^{2}}) \ddot{u_{2}} = k_{r2}\, \delta_{r2} - k_{s2}\, \delta_{s2} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}^{2}} + \beta_{K}\, \bar{k_{r2}}\, \dot{\delta_{r2}} - \beta_{K}\, \bar{k_{s2}}\, \dot{\delta_{s2}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{2}}}{r_{p}^{2}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}\, Z_{r}}\ [\text{damping}]
//! (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{\theta} + (\frac{I_{p}}{r_{p}}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}^{2}}) \ddot{u_{3}} = k_{r3}\, \delta_{r3} - k_{s3}\, \delta_{s3} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}^{2}} + \beta_{K}\, \bar{k_{r3}}\, \dot{\delta_{r3}} - \beta_{K}\, \bar{k_{s3}}\, \dot{\delta_{s3}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{3}}}{r_{p}^{2}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}\, Z_{r}}\ [\text{damping}]
//! (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{\theta} + (\frac{I_{p}}{r_{p}}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}^{2}}) \ddot{u_{4}} = k_{r4}\, \delta_{r4} - k_{s4}\, \delta_{s4} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}^{2}} + \beta_{K}\, \bar{k_{r4}}\, \dot{\delta_{r4}} - \beta_{K}\, \bar{k_{s4}}\, \dot{\delta_{s4}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{4}}}{r_{p}^{2}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}\, Z_{r}}\ [\text{damping}]
//! (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{\theta} + (\frac{I_{p}}{r_{p}}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}^{2}}) \ddot{u_{5}} = k_{r5}\, \delta_{r5} - k_{s5}\, \delta_{s5} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}^{2}} + \beta_{K}\, \bar{k_{r5}}\, \dot{\delta_{r5}} - \beta_{K}\, \bar{k_{s5}}\, \dot{\delta_{s5}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{5}}}{r_{p}^{2}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}\, Z_{r}}\ [\text{damping}]
//! (\frac{I_{p}}{r_{p}\, Z_{r}} - \frac{h\, I_{p}}{r_{p}^{2}}) \ddot{\theta} + (\frac{I_{p}}{r_{p}}) \ddot{\theta_{c}} + (\frac{I_{p}}{r_{p}^{2}}) \ddot{u_{6}} = k_{r6}\, \delta_{r6} - k_{s6}\, \delta_{s6} + \frac{h\, I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}^{2}} + \beta_{K}\, \bar{k_{r6}}\, \dot{\delta_{r6}} - \beta_{K}\, \bar{k_{s6}}\, \dot{\delta_{s6}} - \frac{I_{p}\, \alpha_{M}\, \dot{u_{6}}}{r_{p}^{2}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta_{c}}}{r_{p}} - \frac{I_{p}\, \alpha_{M}\, \dot{\theta}}{r_{p}\, Z_{r}}\ [\text{damping}]
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects
//! - M is symmetric
//! - T = q'.M q'/2, with M as written
//! - M is positive definite: T is a sum of squares that vanish together only at rest
//! - at a step of k_s1, k_r1, k_s2, k_r2, k_s3, k_r3, k_s4, k_r4, k_s5, k_r5, k_s6, k_r6, e_s1, e_r1, e_s2, e_r2, e_s3, e_r3, e_s4, e_r4, e_s5, e_r5, e_s6, e_r6: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
//! - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
//! - every deflection equals the linear form by which the equations differentiate it
//! - without the jump terms the balance fails: energy is created at the rate dk_r1*delta_r1^2*theta_dot/2 - k_r1*de_r1*delta_r1*theta_dot - k_r2*de_r2*delta_r2*theta_dot - k_r3*de_r3*delta_r3*theta_dot - k_r4*de_r4*delta_r4*theta_dot - k_r5*de_r5*delta_r5*theta_dot - k_r6*de_r6*delta_r6*theta_dot - k_s1*de_s1*delta_s1*theta_dot - k_s2*de_s2*delta_s2*theta_dot - k_s3*de_s3*delta_s3*theta_dot - k_s4*de_s4*delta_s4*theta_dot - k_s5*de_s5*delta_s5*theta_dot - k_s6*de_s6*delta_s6*theta_dot + dk_r2*delta_r2^2*theta_dot/2 + dk_r3*delta_r3^2*theta_dot/2 + dk_r4*delta_r4^2*theta_dot/2 + dk_r5*delta_r5^2*theta_dot/2 + dk_r6*delta_r6^2*theta_dot/2 + dk_s1*delta_s1^2*theta_dot/2 + dk_s2*delta_s2^2*theta_dot/2 + dk_s3*delta_s3^2*theta_dot/2 + dk_s4*delta_s4^2*theta_dot/2 + dk_s5*delta_s5^2*theta_dot/2 + dk_s6*delta_s6^2*theta_dot/2
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | constants (once a scene) | 2 | 11 | 2 |
//! | force | 125 | 458 | 0 |
//! | energy step of k_s1 | 0 | 3 | 0 |
//! | energy step of k_r1 | 0 | 3 | 0 |
//! | energy step of k_s2 | 0 | 3 | 0 |
//! | energy step of k_r2 | 0 | 3 | 0 |
//! | energy step of k_s3 | 0 | 3 | 0 |
//! | energy step of k_r3 | 0 | 3 | 0 |
//! | energy step of k_s4 | 0 | 3 | 0 |
//! | energy step of k_r4 | 0 | 3 | 0 |
//! | energy step of k_s5 | 0 | 3 | 0 |
//! | energy step of k_r5 | 0 | 3 | 0 |
//! | energy step of k_s6 | 0 | 3 | 0 |
//! | energy step of k_r6 | 0 | 3 | 0 |
//! | energy step of e_s1 | 1 | 5 | 0 |
//! | energy step of e_r1 | 1 | 5 | 0 |
//! | energy step of e_s2 | 1 | 5 | 0 |
//! | energy step of e_r2 | 1 | 5 | 0 |
//! | energy step of e_s3 | 1 | 5 | 0 |
//! | energy step of e_r3 | 1 | 5 | 0 |
//! | energy step of e_s4 | 1 | 5 | 0 |
//! | energy step of e_r4 | 1 | 5 | 0 |
//! | energy step of e_s5 | 1 | 5 | 0 |
//! | energy step of e_r5 | 1 | 5 | 0 |
//! | energy step of e_s6 | 1 | 5 | 0 |
//! | energy step of e_r6 | 1 | 5 | 0 |

use gearsim_macros::equations;

equations! {
    model planetary_6 "a planetary stage with 6 planets, torsional";
    source "Lin & Parker (1999), J. Vib. Acoust. 121(3), with centres held; phase on the sun";

    coordinates {
        theta "rad" start 0.0, "phase of the meshes, Z_s (theta_s - theta_c)";
        theta_c "rad" start static, "rotation of the carrier in excess of rigid rolling";
        theta_r "rad" start static, "rotation of the ring";
        u1 "m" start static, "rotation of planet 1 in excess of rigid rolling, times its base radius";
        u2 "m" start static, "rotation of planet 2 in excess of rigid rolling, times its base radius";
        u3 "m" start static, "rotation of planet 3 in excess of rigid rolling, times its base radius";
        u4 "m" start static, "rotation of planet 4 in excess of rigid rolling, times its base radius";
        u5 "m" start static, "rotation of planet 5 in excess of rigid rolling, times its base radius";
        u6 "m" start static, "rotation of planet 6 in excess of rigid rolling, times its base radius";
    }
    parameters {
        Z_s "1" required, open 0.0 to inf, "number of teeth of the sun";
        Z_r "1" required, open 0.0 to inf, "number of teeth of the ring";
        r_s "m" required, open 0.0 to inf, "base radius of the sun";
        alpha "rad" default 0.3490658503988659, open 0.0 to inf, "pressure angle";
        I_s "kg*m^2" required, open 0.0 to inf, "moment of inertia of the sun";
        I_c "kg*m^2" required, open 0.0 to inf, "moment of inertia of the carrier without planets";
        I_r "kg*m^2" required, open 0.0 to inf, "moment of inertia of the ring";
        k_r "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the ring's torsional support";
        m_p "kg" required, open 0.0 to inf, "mass of a planet";
        I_p "kg*m^2" required, open 0.0 to inf, "moment of inertia of a planet";
        T_motor "N*m" required, open -inf to inf, "driving torque of the sun";
        T_load "N*m" required, open -inf to inf, "load torque of the carrier, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k_s1 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of sun and planet 1 along the line of action";
        k_r1 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of ring and planet 1 along the line of action";
        k_s2 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of sun and planet 2 along the line of action";
        k_r2 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of ring and planet 2 along the line of action";
        k_s3 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of sun and planet 3 along the line of action";
        k_r3 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of ring and planet 3 along the line of action";
        k_s4 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of sun and planet 4 along the line of action";
        k_r4 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of ring and planet 4 along the line of action";
        k_s5 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of sun and planet 5 along the line of action";
        k_r5 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of ring and planet 5 along the line of action";
        k_s6 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of sun and planet 6 along the line of action";
        k_r6 "N/m" phase theta period 6.283185307179586 rolling, "stiffness of the mesh of ring and planet 6 along the line of action";
        e_s1 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of sun and planet 1 along the line of action";
        e_r1 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of ring and planet 1 along the line of action";
        e_s2 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of sun and planet 2 along the line of action";
        e_r2 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of ring and planet 2 along the line of action";
        e_s3 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of sun and planet 3 along the line of action";
        e_r3 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of ring and planet 3 along the line of action";
        e_s4 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of sun and planet 4 along the line of action";
        e_r4 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of ring and planet 4 along the line of action";
        e_s5 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of sun and planet 5 along the line of action";
        e_r5 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of ring and planet 5 along the line of action";
        e_s6 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of sun and planet 6 along the line of action";
        e_r6 "m" phase theta period 6.283185307179586 rolling with transmission_error, "transmission error of the mesh of ring and planet 6 along the line of action";
    }
    motions {
        speed "rad/s" { theta_dot = Z_r*Z_s/(Z_r + Z_s); }, "rotational speed of the sun, ring at rest";
    }
    effects {
        stiffness_step "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; without it the stiffness is constant at its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        transmission_error requires(stiffness_step) "flanks deviate from their ideal position: V = k (delta - e)^2/2, with the jump terms of e where it steps";
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        transmission_error_and_jump_terms = transmission_error, stiffness_step, !rigid_kinematics, !frozen_phase;
        transmission_error_and_moving_phase = transmission_error, stiffness_step, !frozen_phase;
    }

    constants {
        cos_a = alpha.cos();
        sin_a = alpha.sin();
        h = r_s/Z_s;
        r_p = (h*Z_r - h*Z_s)/2.0;
        a = (h*Z_r/cos_a + h*Z_s/cos_a)/2.0;
    }
    deflections {
        delta_s1 = u1 - e_s1;
        delta_r1 = h*Z_r*theta_r - u1 - e_r1 - h*Z_r*theta_c;
        delta_s2 = u2 - e_s2;
        delta_r2 = h*Z_r*theta_r - u2 - e_r2 - h*Z_r*theta_c;
        delta_s3 = u3 - e_s3;
        delta_r3 = h*Z_r*theta_r - u3 - e_r3 - h*Z_r*theta_c;
        delta_s4 = u4 - e_s4;
        delta_r4 = h*Z_r*theta_r - u4 - e_r4 - h*Z_r*theta_c;
        delta_s5 = u5 - e_s5;
        delta_r5 = h*Z_r*theta_r - u5 - e_r5 - h*Z_r*theta_c;
        delta_s6 = u6 - e_s6;
        delta_r6 = h*Z_r*theta_r - u6 - e_r6 - h*Z_r*theta_c;
    }
    energies {
        kinetic {
            _ => I_c*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0 + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*(theta_c_dot + (u5_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*(theta_c_dot + (u6_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*theta_r_dot.powi(2)/2.0 + I_s*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0 + 3.0*a.powi(2)*m_p*(theta_c_dot + theta_dot/Z_r).powi(2);
        }
        potential {
            _ => (k_r*theta_r.powi(2) + k_r1*delta_r1.powi(2) + k_r2*delta_r2.powi(2) + k_r3*delta_r3.powi(2) + k_r4*delta_r4.powi(2) + k_r5*delta_r5.powi(2) + k_r6*delta_r6.powi(2) + k_s1*delta_s1.powi(2) + k_s2*delta_s2.powi(2) + k_s3*delta_s3.powi(2) + k_s4*delta_s4.powi(2) + k_s5*delta_s5.powi(2) + k_s6*delta_s6.powi(2))/2.0;
        }
        dissipation {
            damping => I_c*alpha_M*(theta_c_dot + theta_dot/Z_r).powi(2)/2.0 + I_p*alpha_M*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*alpha_M*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*alpha_M*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*alpha_M*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*alpha_M*(theta_c_dot + (u5_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_p*alpha_M*(theta_c_dot + (u6_dot - h*theta_dot)/r_p + theta_dot/Z_r).powi(2)/2.0 + I_r*alpha_M*theta_r_dot.powi(2)/2.0 + I_s*alpha_M*(theta_c_dot + theta_dot*(1.0/Z_r + 1.0/Z_s)).powi(2)/2.0 + beta_K*k_r*theta_r_dot.powi(2)/2.0 + beta_K*k_r1_mid*delta_r1_dot.powi(2)/2.0 + beta_K*k_r2_mid*delta_r2_dot.powi(2)/2.0 + beta_K*k_r3_mid*delta_r3_dot.powi(2)/2.0 + beta_K*k_r4_mid*delta_r4_dot.powi(2)/2.0 + beta_K*k_r5_mid*delta_r5_dot.powi(2)/2.0 + beta_K*k_r6_mid*delta_r6_dot.powi(2)/2.0 + beta_K*k_s1_mid*delta_s1_dot.powi(2)/2.0 + beta_K*k_s2_mid*delta_s2_dot.powi(2)/2.0 + beta_K*k_s3_mid*delta_s3_dot.powi(2)/2.0 + beta_K*k_s4_mid*delta_s4_dot.powi(2)/2.0 + beta_K*k_s5_mid*delta_s5_dot.powi(2)/2.0 + beta_K*k_s6_mid*delta_s6_dot.powi(2)/2.0 + 3.0*a.powi(2)*alpha_M*m_p*(theta_c_dot + theta_dot/Z_r).powi(2);
        }
    }
    torques {
        motor "driving torque of the sun" {
            torques => T_motor*(theta_c + theta*(1.0/Z_r + 1.0/Z_s));
        }
        load "load torque of the carrier, against its rotation" {
            torques => T_load*(-theta_c - theta/Z_r);
        }
    }
    work {
        theta {
            torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
        }
        theta_c {
            torques => T_motor - T_load;
        }
        theta_r {}
        u1 {}
        u2 {}
        u3 {}
        u4 {}
        u5 {}
        u6 {}
    }
    mass {
        theta theta {
            _ => I_c/Z_r.powi(2) - 12.0*h*I_p/(r_p*Z_r) + 6.0*I_p/Z_r.powi(2) + I_s/Z_r.powi(2) + 2.0*I_s/(Z_r*Z_s) + I_s/Z_s.powi(2) + 6.0*a.powi(2)*m_p/Z_r.powi(2) + 6.0*h.powi(2)*I_p/r_p.powi(2);
        }
        theta theta_c {
            _ => I_c/Z_r - 6.0*h*I_p/r_p + 6.0*I_p/Z_r + I_s/Z_r + I_s/Z_s + 6.0*a.powi(2)*m_p/Z_r;
        }
        theta u1 {
            _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2);
        }
        theta u2 {
            _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2);
        }
        theta u3 {
            _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2);
        }
        theta u4 {
            _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2);
        }
        theta u5 {
            _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2);
        }
        theta u6 {
            _ => I_p/(r_p*Z_r) - h*I_p/r_p.powi(2);
        }
        theta_c theta_c {
            _ => I_c + 6.0*I_p + I_s + 6.0*a.powi(2)*m_p;
        }
        theta_c u1 {
            _ => I_p/r_p;
        }
        theta_c u2 {
            _ => I_p/r_p;
        }
        theta_c u3 {
            _ => I_p/r_p;
        }
        theta_c u4 {
            _ => I_p/r_p;
        }
        theta_c u5 {
            _ => I_p/r_p;
        }
        theta_c u6 {
            _ => I_p/r_p;
        }
        theta_r theta_r {
            _ => I_r;
        }
        u1 u1 {
            _ => I_p/r_p.powi(2);
        }
        u2 u2 {
            _ => I_p/r_p.powi(2);
        }
        u3 u3 {
            _ => I_p/r_p.powi(2);
        }
        u4 u4 {
            _ => I_p/r_p.powi(2);
        }
        u5 u5 {
            _ => I_p/r_p.powi(2);
        }
        u6 u6 {
            _ => I_p/r_p.powi(2);
        }
    }
    force {
        theta {
            transmission_error_and_jump_terms => k_r1*de_r1*delta_r1 + k_r2*de_r2*delta_r2 + k_r3*de_r3*delta_r3 + k_r4*de_r4*delta_r4 + k_r5*de_r5*delta_r5 + k_r6*de_r6*delta_r6 + k_s1*de_s1*delta_s1 + k_s2*de_s2*delta_s2 + k_s3*de_s3*delta_s3 + k_s4*de_s4*delta_s4 + k_s5*de_s5*delta_s5 + k_s6*de_s6*delta_s6;
            torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
            damping => h*I_p*alpha_M*u1_dot/r_p.powi(2) + h*I_p*alpha_M*u2_dot/r_p.powi(2) + h*I_p*alpha_M*u3_dot/r_p.powi(2) + h*I_p*alpha_M*u4_dot/r_p.powi(2) + h*I_p*alpha_M*u5_dot/r_p.powi(2) + h*I_p*alpha_M*u6_dot/r_p.powi(2) + 6.0*h*I_p*alpha_M*theta_c_dot/r_p + 12.0*h*I_p*alpha_M*theta_dot/(r_p*Z_r) - I_c*alpha_M*theta_dot/Z_r.powi(2) - I_c*alpha_M*theta_c_dot/Z_r - 6.0*I_p*alpha_M*theta_dot/Z_r.powi(2) - 6.0*I_p*alpha_M*theta_c_dot/Z_r - I_s*alpha_M*theta_dot/Z_r.powi(2) - I_s*alpha_M*theta_c_dot/Z_r - 2.0*I_s*alpha_M*theta_dot/(Z_r*Z_s) - I_s*alpha_M*theta_dot/Z_s.powi(2) - I_s*alpha_M*theta_c_dot/Z_s - 6.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r.powi(2) - 6.0*a.powi(2)*alpha_M*m_p*theta_c_dot/Z_r - 6.0*h.powi(2)*I_p*alpha_M*theta_dot/r_p.powi(2) - I_p*alpha_M*u1_dot/(r_p*Z_r) - I_p*alpha_M*u2_dot/(r_p*Z_r) - I_p*alpha_M*u3_dot/(r_p*Z_r) - I_p*alpha_M*u4_dot/(r_p*Z_r) - I_p*alpha_M*u5_dot/(r_p*Z_r) - I_p*alpha_M*u6_dot/(r_p*Z_r);
            jump_terms => (-dk_r1*delta_r1.powi(2) - dk_r2*delta_r2.powi(2) - dk_r3*delta_r3.powi(2) - dk_r4*delta_r4.powi(2) - dk_r5*delta_r5.powi(2) - dk_r6*delta_r6.powi(2) - dk_s1*delta_s1.powi(2) - dk_s2*delta_s2.powi(2) - dk_s3*delta_s3.powi(2) - dk_s4*delta_s4.powi(2) - dk_s5*delta_s5.powi(2) - dk_s6*delta_s6.powi(2))/2.0;
        }
        theta_c {
            _ => h*Z_r*k_r1*delta_r1 + h*Z_r*k_r2*delta_r2 + h*Z_r*k_r3*delta_r3 + h*Z_r*k_r4*delta_r4 + h*Z_r*k_r5*delta_r5 + h*Z_r*k_r6*delta_r6;
            torques => T_motor - T_load;
            damping => h*Z_r*beta_K*k_r1_mid*delta_r1_dot + h*Z_r*beta_K*k_r2_mid*delta_r2_dot + h*Z_r*beta_K*k_r3_mid*delta_r3_dot + h*Z_r*beta_K*k_r4_mid*delta_r4_dot + h*Z_r*beta_K*k_r5_mid*delta_r5_dot + h*Z_r*beta_K*k_r6_mid*delta_r6_dot + 6.0*h*I_p*alpha_M*theta_dot/r_p - I_c*alpha_M*theta_c_dot - I_c*alpha_M*theta_dot/Z_r - 6.0*I_p*alpha_M*theta_c_dot - 6.0*I_p*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_c_dot - I_s*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_dot/Z_s - 6.0*a.powi(2)*alpha_M*m_p*theta_c_dot - 6.0*a.powi(2)*alpha_M*m_p*theta_dot/Z_r - I_p*alpha_M*u1_dot/r_p - I_p*alpha_M*u2_dot/r_p - I_p*alpha_M*u3_dot/r_p - I_p*alpha_M*u4_dot/r_p - I_p*alpha_M*u5_dot/r_p - I_p*alpha_M*u6_dot/r_p;
        }
        theta_r {
            _ => -h*Z_r*k_r1*delta_r1 - h*Z_r*k_r2*delta_r2 - h*Z_r*k_r3*delta_r3 - h*Z_r*k_r4*delta_r4 - h*Z_r*k_r5*delta_r5 - h*Z_r*k_r6*delta_r6 - k_r*theta_r;
            damping => -h*Z_r*beta_K*k_r1_mid*delta_r1_dot - h*Z_r*beta_K*k_r2_mid*delta_r2_dot - h*Z_r*beta_K*k_r3_mid*delta_r3_dot - h*Z_r*beta_K*k_r4_mid*delta_r4_dot - h*Z_r*beta_K*k_r5_mid*delta_r5_dot - h*Z_r*beta_K*k_r6_mid*delta_r6_dot - I_r*alpha_M*theta_r_dot - beta_K*k_r*theta_r_dot;
        }
        u1 {
            _ => k_r1*delta_r1 - k_s1*delta_s1;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r1_mid*delta_r1_dot - beta_K*k_s1_mid*delta_s1_dot - I_p*alpha_M*u1_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u2 {
            _ => k_r2*delta_r2 - k_s2*delta_s2;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r2_mid*delta_r2_dot - beta_K*k_s2_mid*delta_s2_dot - I_p*alpha_M*u2_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u3 {
            _ => k_r3*delta_r3 - k_s3*delta_s3;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r3_mid*delta_r3_dot - beta_K*k_s3_mid*delta_s3_dot - I_p*alpha_M*u3_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u4 {
            _ => k_r4*delta_r4 - k_s4*delta_s4;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r4_mid*delta_r4_dot - beta_K*k_s4_mid*delta_s4_dot - I_p*alpha_M*u4_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u5 {
            _ => k_r5*delta_r5 - k_s5*delta_s5;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r5_mid*delta_r5_dot - beta_K*k_s5_mid*delta_s5_dot - I_p*alpha_M*u5_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
        u6 {
            _ => k_r6*delta_r6 - k_s6*delta_s6;
            damping => h*I_p*alpha_M*theta_dot/r_p.powi(2) + beta_K*k_r6_mid*delta_r6_dot - beta_K*k_s6_mid*delta_s6_dot - I_p*alpha_M*u6_dot/r_p.powi(2) - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r);
        }
    }
    jacobian {
        theta theta {
            transmission_error_and_jump_terms => k_r1*dde_r1*delta_r1 - k_r1*de_r1.powi(2) + k_r2*dde_r2*delta_r2 - k_r2*de_r2.powi(2) + k_r3*dde_r3*delta_r3 - k_r3*de_r3.powi(2) + k_r4*dde_r4*delta_r4 - k_r4*de_r4.powi(2) + k_r5*dde_r5*delta_r5 - k_r5*de_r5.powi(2) + k_r6*dde_r6*delta_r6 - k_r6*de_r6.powi(2) + k_s1*dde_s1*delta_s1 - k_s1*de_s1.powi(2) + k_s2*dde_s2*delta_s2 - k_s2*de_s2.powi(2) + k_s3*dde_s3*delta_s3 - k_s3*de_s3.powi(2) + k_s4*dde_s4*delta_s4 - k_s4*de_s4.powi(2) + k_s5*dde_s5*delta_s5 - k_s5*de_s5.powi(2) + k_s6*dde_s6*delta_s6 - k_s6*de_s6.powi(2) + 2.0*de_r1*dk_r1*delta_r1 + 2.0*de_r2*dk_r2*delta_r2 + 2.0*de_r3*dk_r3*delta_r3 + 2.0*de_r4*dk_r4*delta_r4 + 2.0*de_r5*dk_r5*delta_r5 + 2.0*de_r6*dk_r6*delta_r6 + 2.0*de_s1*dk_s1*delta_s1 + 2.0*de_s2*dk_s2*delta_s2 + 2.0*de_s3*dk_s3*delta_s3 + 2.0*de_s4*dk_s4*delta_s4 + 2.0*de_s5*dk_s5*delta_s5 + 2.0*de_s6*dk_s6*delta_s6;
            jump_terms => (-ddk_r1*delta_r1.powi(2) - ddk_r2*delta_r2.powi(2) - ddk_r3*delta_r3.powi(2) - ddk_r4*delta_r4.powi(2) - ddk_r5*delta_r5.powi(2) - ddk_r6*delta_r6.powi(2) - ddk_s1*delta_s1.powi(2) - ddk_s2*delta_s2.powi(2) - ddk_s3*delta_s3.powi(2) - ddk_s4*delta_s4.powi(2) - ddk_s5*delta_s5.powi(2) - ddk_s6*delta_s6.powi(2))/2.0;
        }
        theta theta_c {
            transmission_error_and_jump_terms => -h*Z_r*k_r1*de_r1 - h*Z_r*k_r2*de_r2 - h*Z_r*k_r3*de_r3 - h*Z_r*k_r4*de_r4 - h*Z_r*k_r5*de_r5 - h*Z_r*k_r6*de_r6;
            jump_terms => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3 + h*Z_r*dk_r4*delta_r4 + h*Z_r*dk_r5*delta_r5 + h*Z_r*dk_r6*delta_r6;
        }
        theta theta_r {
            transmission_error_and_jump_terms => h*Z_r*k_r1*de_r1 + h*Z_r*k_r2*de_r2 + h*Z_r*k_r3*de_r3 + h*Z_r*k_r4*de_r4 + h*Z_r*k_r5*de_r5 + h*Z_r*k_r6*de_r6;
            jump_terms => -h*Z_r*dk_r1*delta_r1 - h*Z_r*dk_r2*delta_r2 - h*Z_r*dk_r3*delta_r3 - h*Z_r*dk_r4*delta_r4 - h*Z_r*dk_r5*delta_r5 - h*Z_r*dk_r6*delta_r6;
        }
        theta u1 {
            transmission_error_and_jump_terms => k_s1*de_s1 - k_r1*de_r1;
            jump_terms => dk_r1*delta_r1 - dk_s1*delta_s1;
        }
        theta u2 {
            transmission_error_and_jump_terms => k_s2*de_s2 - k_r2*de_r2;
            jump_terms => dk_r2*delta_r2 - dk_s2*delta_s2;
        }
        theta u3 {
            transmission_error_and_jump_terms => k_s3*de_s3 - k_r3*de_r3;
            jump_terms => dk_r3*delta_r3 - dk_s3*delta_s3;
        }
        theta u4 {
            transmission_error_and_jump_terms => k_s4*de_s4 - k_r4*de_r4;
            jump_terms => dk_r4*delta_r4 - dk_s4*delta_s4;
        }
        theta u5 {
            transmission_error_and_jump_terms => k_s5*de_s5 - k_r5*de_r5;
            jump_terms => dk_r5*delta_r5 - dk_s5*delta_s5;
        }
        theta u6 {
            transmission_error_and_jump_terms => k_s6*de_s6 - k_r6*de_r6;
            jump_terms => dk_r6*delta_r6 - dk_s6*delta_s6;
        }
        theta theta_dot {
            damping => 12.0*h*I_p*alpha_M/(r_p*Z_r) - I_c*alpha_M/Z_r.powi(2) - 6.0*I_p*alpha_M/Z_r.powi(2) - I_s*alpha_M/Z_r.powi(2) - 2.0*I_s*alpha_M/(Z_r*Z_s) - I_s*alpha_M/Z_s.powi(2) - 6.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2) - 6.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
        }
        theta theta_c_dot {
            damping => 6.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 6.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s - 6.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta u1_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        theta u2_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        theta u3_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        theta u4_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        theta u5_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        theta u6_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        theta_c theta {
            transmission_error_and_moving_phase => -h*Z_r*k_r1*de_r1 - h*Z_r*k_r2*de_r2 - h*Z_r*k_r3*de_r3 - h*Z_r*k_r4*de_r4 - h*Z_r*k_r5*de_r5 - h*Z_r*k_r6*de_r6;
            moving_phase => h*Z_r*dk_r1*delta_r1 + h*Z_r*dk_r2*delta_r2 + h*Z_r*dk_r3*delta_r3 + h*Z_r*dk_r4*delta_r4 + h*Z_r*dk_r5*delta_r5 + h*Z_r*dk_r6*delta_r6;
        }
        theta_c theta_c {
            _ => -h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3 - h.powi(2)*Z_r.powi(2)*k_r4 - h.powi(2)*Z_r.powi(2)*k_r5 - h.powi(2)*Z_r.powi(2)*k_r6;
        }
        theta_c theta_r {
            _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3 + h.powi(2)*Z_r.powi(2)*k_r4 + h.powi(2)*Z_r.powi(2)*k_r5 + h.powi(2)*Z_r.powi(2)*k_r6;
        }
        theta_c u1 {
            _ => -h*Z_r*k_r1;
        }
        theta_c u2 {
            _ => -h*Z_r*k_r2;
        }
        theta_c u3 {
            _ => -h*Z_r*k_r3;
        }
        theta_c u4 {
            _ => -h*Z_r*k_r4;
        }
        theta_c u5 {
            _ => -h*Z_r*k_r5;
        }
        theta_c u6 {
            _ => -h*Z_r*k_r6;
        }
        theta_c theta_dot {
            damping => 6.0*h*I_p*alpha_M/r_p - I_c*alpha_M/Z_r - 6.0*I_p*alpha_M/Z_r - I_s*alpha_M/Z_r - I_s*alpha_M/Z_s - 6.0*a.powi(2)*alpha_M*m_p/Z_r;
        }
        theta_c theta_c_dot {
            damping => -I_c*alpha_M - 6.0*I_p*alpha_M - I_s*alpha_M - 6.0*a.powi(2)*alpha_M*m_p - h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r5_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r6_mid;
        }
        theta_c theta_r_dot {
            damping => h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r5_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r6_mid;
        }
        theta_c u1_dot {
            damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p;
        }
        theta_c u2_dot {
            damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p;
        }
        theta_c u3_dot {
            damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p;
        }
        theta_c u4_dot {
            damping => -h*Z_r*beta_K*k_r4_mid - I_p*alpha_M/r_p;
        }
        theta_c u5_dot {
            damping => -h*Z_r*beta_K*k_r5_mid - I_p*alpha_M/r_p;
        }
        theta_c u6_dot {
            damping => -h*Z_r*beta_K*k_r6_mid - I_p*alpha_M/r_p;
        }
        theta_r theta {
            transmission_error_and_moving_phase => h*Z_r*k_r1*de_r1 + h*Z_r*k_r2*de_r2 + h*Z_r*k_r3*de_r3 + h*Z_r*k_r4*de_r4 + h*Z_r*k_r5*de_r5 + h*Z_r*k_r6*de_r6;
            moving_phase => -h*Z_r*dk_r1*delta_r1 - h*Z_r*dk_r2*delta_r2 - h*Z_r*dk_r3*delta_r3 - h*Z_r*dk_r4*delta_r4 - h*Z_r*dk_r5*delta_r5 - h*Z_r*dk_r6*delta_r6;
        }
        theta_r theta_c {
            _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3 + h.powi(2)*Z_r.powi(2)*k_r4 + h.powi(2)*Z_r.powi(2)*k_r5 + h.powi(2)*Z_r.powi(2)*k_r6;
        }
        theta_r theta_r {
            _ => -k_r - h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3 - h.powi(2)*Z_r.powi(2)*k_r4 - h.powi(2)*Z_r.powi(2)*k_r5 - h.powi(2)*Z_r.powi(2)*k_r6;
        }
        theta_r u1 {
            _ => h*Z_r*k_r1;
        }
        theta_r u2 {
            _ => h*Z_r*k_r2;
        }
        theta_r u3 {
            _ => h*Z_r*k_r3;
        }
        theta_r u4 {
            _ => h*Z_r*k_r4;
        }
        theta_r u5 {
            _ => h*Z_r*k_r5;
        }
        theta_r u6 {
            _ => h*Z_r*k_r6;
        }
        theta_r theta_c_dot {
            damping => h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r5_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r6_mid;
        }
        theta_r theta_r_dot {
            damping => -I_r*alpha_M - beta_K*k_r - h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r5_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r6_mid;
        }
        theta_r u1_dot {
            damping => h*Z_r*beta_K*k_r1_mid;
        }
        theta_r u2_dot {
            damping => h*Z_r*beta_K*k_r2_mid;
        }
        theta_r u3_dot {
            damping => h*Z_r*beta_K*k_r3_mid;
        }
        theta_r u4_dot {
            damping => h*Z_r*beta_K*k_r4_mid;
        }
        theta_r u5_dot {
            damping => h*Z_r*beta_K*k_r5_mid;
        }
        theta_r u6_dot {
            damping => h*Z_r*beta_K*k_r6_mid;
        }
        u1 theta {
            transmission_error_and_moving_phase => k_s1*de_s1 - k_r1*de_r1;
            moving_phase => dk_r1*delta_r1 - dk_s1*delta_s1;
        }
        u1 theta_c {
            _ => -h*Z_r*k_r1;
        }
        u1 theta_r {
            _ => h*Z_r*k_r1;
        }
        u1 u1 {
            _ => -k_r1 - k_s1;
        }
        u1 theta_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        u1 theta_c_dot {
            damping => -h*Z_r*beta_K*k_r1_mid - I_p*alpha_M/r_p;
        }
        u1 theta_r_dot {
            damping => h*Z_r*beta_K*k_r1_mid;
        }
        u1 u1_dot {
            damping => -beta_K*k_r1_mid - beta_K*k_s1_mid - I_p*alpha_M/r_p.powi(2);
        }
        u2 theta {
            transmission_error_and_moving_phase => k_s2*de_s2 - k_r2*de_r2;
            moving_phase => dk_r2*delta_r2 - dk_s2*delta_s2;
        }
        u2 theta_c {
            _ => -h*Z_r*k_r2;
        }
        u2 theta_r {
            _ => h*Z_r*k_r2;
        }
        u2 u2 {
            _ => -k_r2 - k_s2;
        }
        u2 theta_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        u2 theta_c_dot {
            damping => -h*Z_r*beta_K*k_r2_mid - I_p*alpha_M/r_p;
        }
        u2 theta_r_dot {
            damping => h*Z_r*beta_K*k_r2_mid;
        }
        u2 u2_dot {
            damping => -beta_K*k_r2_mid - beta_K*k_s2_mid - I_p*alpha_M/r_p.powi(2);
        }
        u3 theta {
            transmission_error_and_moving_phase => k_s3*de_s3 - k_r3*de_r3;
            moving_phase => dk_r3*delta_r3 - dk_s3*delta_s3;
        }
        u3 theta_c {
            _ => -h*Z_r*k_r3;
        }
        u3 theta_r {
            _ => h*Z_r*k_r3;
        }
        u3 u3 {
            _ => -k_r3 - k_s3;
        }
        u3 theta_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        u3 theta_c_dot {
            damping => -h*Z_r*beta_K*k_r3_mid - I_p*alpha_M/r_p;
        }
        u3 theta_r_dot {
            damping => h*Z_r*beta_K*k_r3_mid;
        }
        u3 u3_dot {
            damping => -beta_K*k_r3_mid - beta_K*k_s3_mid - I_p*alpha_M/r_p.powi(2);
        }
        u4 theta {
            transmission_error_and_moving_phase => k_s4*de_s4 - k_r4*de_r4;
            moving_phase => dk_r4*delta_r4 - dk_s4*delta_s4;
        }
        u4 theta_c {
            _ => -h*Z_r*k_r4;
        }
        u4 theta_r {
            _ => h*Z_r*k_r4;
        }
        u4 u4 {
            _ => -k_r4 - k_s4;
        }
        u4 theta_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        u4 theta_c_dot {
            damping => -h*Z_r*beta_K*k_r4_mid - I_p*alpha_M/r_p;
        }
        u4 theta_r_dot {
            damping => h*Z_r*beta_K*k_r4_mid;
        }
        u4 u4_dot {
            damping => -beta_K*k_r4_mid - beta_K*k_s4_mid - I_p*alpha_M/r_p.powi(2);
        }
        u5 theta {
            transmission_error_and_moving_phase => k_s5*de_s5 - k_r5*de_r5;
            moving_phase => dk_r5*delta_r5 - dk_s5*delta_s5;
        }
        u5 theta_c {
            _ => -h*Z_r*k_r5;
        }
        u5 theta_r {
            _ => h*Z_r*k_r5;
        }
        u5 u5 {
            _ => -k_r5 - k_s5;
        }
        u5 theta_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        u5 theta_c_dot {
            damping => -h*Z_r*beta_K*k_r5_mid - I_p*alpha_M/r_p;
        }
        u5 theta_r_dot {
            damping => h*Z_r*beta_K*k_r5_mid;
        }
        u5 u5_dot {
            damping => -beta_K*k_r5_mid - beta_K*k_s5_mid - I_p*alpha_M/r_p.powi(2);
        }
        u6 theta {
            transmission_error_and_moving_phase => k_s6*de_s6 - k_r6*de_r6;
            moving_phase => dk_r6*delta_r6 - dk_s6*delta_s6;
        }
        u6 theta_c {
            _ => -h*Z_r*k_r6;
        }
        u6 theta_r {
            _ => h*Z_r*k_r6;
        }
        u6 u6 {
            _ => -k_r6 - k_s6;
        }
        u6 theta_dot {
            damping => h*I_p*alpha_M/r_p.powi(2) - I_p*alpha_M/(r_p*Z_r);
        }
        u6 theta_c_dot {
            damping => -h*Z_r*beta_K*k_r6_mid - I_p*alpha_M/r_p;
        }
        u6 theta_r_dot {
            damping => h*Z_r*beta_K*k_r6_mid;
        }
        u6 u6_dot {
            damping => -beta_K*k_r6_mid - beta_K*k_s6_mid - I_p*alpha_M/r_p.powi(2);
        }
    }
    cell {
        stiffness {
            theta_c theta_c {
                _ => h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3 + h.powi(2)*Z_r.powi(2)*k_r4 + h.powi(2)*Z_r.powi(2)*k_r5 + h.powi(2)*Z_r.powi(2)*k_r6;
            }
            theta_c theta_r {
                _ => -h.powi(2)*Z_r.powi(2)*k_r1 - h.powi(2)*Z_r.powi(2)*k_r2 - h.powi(2)*Z_r.powi(2)*k_r3 - h.powi(2)*Z_r.powi(2)*k_r4 - h.powi(2)*Z_r.powi(2)*k_r5 - h.powi(2)*Z_r.powi(2)*k_r6;
            }
            theta_c u1 {
                _ => h*Z_r*k_r1;
            }
            theta_c u2 {
                _ => h*Z_r*k_r2;
            }
            theta_c u3 {
                _ => h*Z_r*k_r3;
            }
            theta_c u4 {
                _ => h*Z_r*k_r4;
            }
            theta_c u5 {
                _ => h*Z_r*k_r5;
            }
            theta_c u6 {
                _ => h*Z_r*k_r6;
            }
            theta_r theta_r {
                _ => k_r + h.powi(2)*Z_r.powi(2)*k_r1 + h.powi(2)*Z_r.powi(2)*k_r2 + h.powi(2)*Z_r.powi(2)*k_r3 + h.powi(2)*Z_r.powi(2)*k_r4 + h.powi(2)*Z_r.powi(2)*k_r5 + h.powi(2)*Z_r.powi(2)*k_r6;
            }
            theta_r u1 {
                _ => -h*Z_r*k_r1;
            }
            theta_r u2 {
                _ => -h*Z_r*k_r2;
            }
            theta_r u3 {
                _ => -h*Z_r*k_r3;
            }
            theta_r u4 {
                _ => -h*Z_r*k_r4;
            }
            theta_r u5 {
                _ => -h*Z_r*k_r5;
            }
            theta_r u6 {
                _ => -h*Z_r*k_r6;
            }
            u1 u1 {
                _ => k_r1 + k_s1;
            }
            u2 u2 {
                _ => k_r2 + k_s2;
            }
            u3 u3 {
                _ => k_r3 + k_s3;
            }
            u4 u4 {
                _ => k_r4 + k_s4;
            }
            u5 u5 {
                _ => k_r5 + k_s5;
            }
            u6 u6 {
                _ => k_r6 + k_s6;
            }
        }
        damping {
            theta theta {
                damping => I_c*alpha_M/Z_r.powi(2) - 12.0*h*I_p*alpha_M/(r_p*Z_r) + 6.0*I_p*alpha_M/Z_r.powi(2) + I_s*alpha_M/Z_r.powi(2) + 2.0*I_s*alpha_M/(Z_r*Z_s) + I_s*alpha_M/Z_s.powi(2) + 6.0*a.powi(2)*alpha_M*m_p/Z_r.powi(2) + 6.0*h.powi(2)*I_p*alpha_M/r_p.powi(2);
            }
            theta theta_c {
                damping => I_c*alpha_M/Z_r - 6.0*h*I_p*alpha_M/r_p + 6.0*I_p*alpha_M/Z_r + I_s*alpha_M/Z_r + I_s*alpha_M/Z_s + 6.0*a.powi(2)*alpha_M*m_p/Z_r;
            }
            theta u1 {
                damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2);
            }
            theta u2 {
                damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2);
            }
            theta u3 {
                damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2);
            }
            theta u4 {
                damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2);
            }
            theta u5 {
                damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2);
            }
            theta u6 {
                damping => I_p*alpha_M/(r_p*Z_r) - h*I_p*alpha_M/r_p.powi(2);
            }
            theta_c theta_c {
                damping => I_c*alpha_M + 6.0*I_p*alpha_M + I_s*alpha_M + 6.0*a.powi(2)*alpha_M*m_p + h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r5_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r6_mid;
            }
            theta_c theta_r {
                damping => -h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r5_mid - h.powi(2)*Z_r.powi(2)*beta_K*k_r6_mid;
            }
            theta_c u1 {
                damping => h*Z_r*beta_K*k_r1_mid + I_p*alpha_M/r_p;
            }
            theta_c u2 {
                damping => h*Z_r*beta_K*k_r2_mid + I_p*alpha_M/r_p;
            }
            theta_c u3 {
                damping => h*Z_r*beta_K*k_r3_mid + I_p*alpha_M/r_p;
            }
            theta_c u4 {
                damping => h*Z_r*beta_K*k_r4_mid + I_p*alpha_M/r_p;
            }
            theta_c u5 {
                damping => h*Z_r*beta_K*k_r5_mid + I_p*alpha_M/r_p;
            }
            theta_c u6 {
                damping => h*Z_r*beta_K*k_r6_mid + I_p*alpha_M/r_p;
            }
            theta_r theta_r {
                damping => I_r*alpha_M + beta_K*k_r + h.powi(2)*Z_r.powi(2)*beta_K*k_r1_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r2_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r3_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r4_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r5_mid + h.powi(2)*Z_r.powi(2)*beta_K*k_r6_mid;
            }
            theta_r u1 {
                damping => -h*Z_r*beta_K*k_r1_mid;
            }
            theta_r u2 {
                damping => -h*Z_r*beta_K*k_r2_mid;
            }
            theta_r u3 {
                damping => -h*Z_r*beta_K*k_r3_mid;
            }
            theta_r u4 {
                damping => -h*Z_r*beta_K*k_r4_mid;
            }
            theta_r u5 {
                damping => -h*Z_r*beta_K*k_r5_mid;
            }
            theta_r u6 {
                damping => -h*Z_r*beta_K*k_r6_mid;
            }
            u1 u1 {
                damping => beta_K*k_r1_mid + beta_K*k_s1_mid + I_p*alpha_M/r_p.powi(2);
            }
            u2 u2 {
                damping => beta_K*k_r2_mid + beta_K*k_s2_mid + I_p*alpha_M/r_p.powi(2);
            }
            u3 u3 {
                damping => beta_K*k_r3_mid + beta_K*k_s3_mid + I_p*alpha_M/r_p.powi(2);
            }
            u4 u4 {
                damping => beta_K*k_r4_mid + beta_K*k_s4_mid + I_p*alpha_M/r_p.powi(2);
            }
            u5 u5 {
                damping => beta_K*k_r5_mid + beta_K*k_s5_mid + I_p*alpha_M/r_p.powi(2);
            }
            u6 u6 {
                damping => beta_K*k_r6_mid + beta_K*k_s6_mid + I_p*alpha_M/r_p.powi(2);
            }
        }
        load {
            theta {
                torques => T_motor/Z_r - T_load/Z_r + T_motor/Z_s;
            }
            theta_c {
                _ => -h*Z_r*k_r1*e_r1 - h*Z_r*k_r2*e_r2 - h*Z_r*k_r3*e_r3 - h*Z_r*k_r4*e_r4 - h*Z_r*k_r5*e_r5 - h*Z_r*k_r6*e_r6;
                torques => T_motor - T_load;
            }
            theta_r {
                _ => h*Z_r*k_r1*e_r1 + h*Z_r*k_r2*e_r2 + h*Z_r*k_r3*e_r3 + h*Z_r*k_r4*e_r4 + h*Z_r*k_r5*e_r5 + h*Z_r*k_r6*e_r6;
            }
            u1 {
                _ => k_s1*e_s1 - k_r1*e_r1;
            }
            u2 {
                _ => k_s2*e_s2 - k_r2*e_r2;
            }
            u3 {
                _ => k_s3*e_s3 - k_r3*e_r3;
            }
            u4 {
                _ => k_s4*e_s4 - k_r4*e_r4;
            }
            u5 {
                _ => k_s5*e_s5 - k_r5*e_r5;
            }
            u6 {
                _ => k_s6*e_s6 - k_r6*e_r6;
            }
        }
    }
    jump k_s1 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_s1*delta_s1.powi(2)/2.0;
        }
    }
    jump k_r1 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_r1*delta_r1.powi(2)/2.0;
        }
    }
    jump k_s2 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_s2*delta_s2.powi(2)/2.0;
        }
    }
    jump k_r2 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_r2*delta_r2.powi(2)/2.0;
        }
    }
    jump k_s3 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_s3*delta_s3.powi(2)/2.0;
        }
    }
    jump k_r3 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_r3*delta_r3.powi(2)/2.0;
        }
    }
    jump k_s4 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_s4*delta_s4.powi(2)/2.0;
        }
    }
    jump k_r4 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_r4*delta_r4.powi(2)/2.0;
        }
    }
    jump k_s5 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_s5*delta_s5.powi(2)/2.0;
        }
    }
    jump k_r5 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_r5*delta_r5.powi(2)/2.0;
        }
    }
    jump k_s6 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_s6*delta_s6.powi(2)/2.0;
        }
    }
    jump k_r6 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => dk_r6*delta_r6.powi(2)/2.0;
        }
    }
    jump e_s1 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_s1*de_s1.powi(2)/2.0 - k_s1*de_s1*delta_s1;
        }
    }
    jump e_r1 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_r1*de_r1.powi(2)/2.0 - k_r1*de_r1*delta_r1;
        }
    }
    jump e_s2 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_s2*de_s2.powi(2)/2.0 - k_s2*de_s2*delta_s2;
        }
    }
    jump e_r2 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_r2*de_r2.powi(2)/2.0 - k_r2*de_r2*delta_r2;
        }
    }
    jump e_s3 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_s3*de_s3.powi(2)/2.0 - k_s3*de_s3*delta_s3;
        }
    }
    jump e_r3 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_r3*de_r3.powi(2)/2.0 - k_r3*de_r3*delta_r3;
        }
    }
    jump e_s4 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_s4*de_s4.powi(2)/2.0 - k_s4*de_s4*delta_s4;
        }
    }
    jump e_r4 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_r4*de_r4.powi(2)/2.0 - k_r4*de_r4*delta_r4;
        }
    }
    jump e_s5 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_s5*de_s5.powi(2)/2.0 - k_s5*de_s5*delta_s5;
        }
    }
    jump e_r5 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_r5*de_r5.powi(2)/2.0 - k_r5*de_r5*delta_r5;
        }
    }
    jump e_s6 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_s6*de_s6.powi(2)/2.0 - k_s6*de_s6*delta_s6;
        }
    }
    jump e_r6 {
        normal {
            theta {
                _ => 1.0;
            }
        }
        step {
            _ => k_r6*de_r6.powi(2)/2.0 - k_r6*de_r6*delta_r6;
        }
    }

    text {
        "T = I_c*(theta_c_dot + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u5_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*(theta_c_dot + (u6_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_r*theta_r_dot^2/2 + I_s*(theta_c_dot + theta_dot*(1/Z_r + 1/Z_s))^2/2 + 3*a^2*m_p*(theta_c_dot + theta_dot/Z_r)^2";
        "V = (k_r*theta_r^2 + k_r1*delta_r1^2 + k_r2*delta_r2^2 + k_r3*delta_r3^2 + k_r4*delta_r4^2 + k_r5*delta_r5^2 + k_r6*delta_r6^2 + k_s1*delta_s1^2 + k_s2*delta_s2^2 + k_s3*delta_s3^2 + k_s4*delta_s4^2 + k_s5*delta_s5^2 + k_s6*delta_s6^2)/2";
        "D = I_c*alpha_M*(theta_c_dot + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u1_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u2_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u3_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u4_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u5_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_p*alpha_M*(theta_c_dot + (u6_dot - h*theta_dot)/r_p + theta_dot/Z_r)^2/2 + I_r*alpha_M*theta_r_dot^2/2 + I_s*alpha_M*(theta_c_dot + theta_dot*(1/Z_r + 1/Z_s))^2/2 + beta_K*k_r*theta_r_dot^2/2 + beta_K*k_r1_mid*delta_r1_dot^2/2 + beta_K*k_r2_mid*delta_r2_dot^2/2 + beta_K*k_r3_mid*delta_r3_dot^2/2 + beta_K*k_r4_mid*delta_r4_dot^2/2 + beta_K*k_r5_mid*delta_r5_dot^2/2 + beta_K*k_r6_mid*delta_r6_dot^2/2 + beta_K*k_s1_mid*delta_s1_dot^2/2 + beta_K*k_s2_mid*delta_s2_dot^2/2 + beta_K*k_s3_mid*delta_s3_dot^2/2 + beta_K*k_s4_mid*delta_s4_dot^2/2 + beta_K*k_s5_mid*delta_s5_dot^2/2 + beta_K*k_s6_mid*delta_s6_dot^2/2 + 3*a^2*alpha_M*m_p*(theta_c_dot + theta_dot/Z_r)^2 [damping]";
        "Q_theta = T_motor/Z_r - T_load/Z_r + T_motor/Z_s [torques]";
        "Q_theta_c = T_motor - T_load [torques]";
        "Q_theta_r = 0";
        "Q_u1 = 0";
        "Q_u2 = 0";
        "Q_u3 = 0";
        "Q_u4 = 0";
        "Q_u5 = 0";
        "Q_u6 = 0";
        "cos_a = cos(alpha)";
        "sin_a = sin(alpha)";
        "h = r_s/Z_s";
        "r_p = (h*Z_r - h*Z_s)/2";
        "a = (h*Z_r/cos_a + h*Z_s/cos_a)/2";
        "delta_s1 = u1 - e_s1";
        "delta_r1 = h*Z_r*theta_r - u1 - e_r1 - h*Z_r*theta_c";
        "delta_s2 = u2 - e_s2";
        "delta_r2 = h*Z_r*theta_r - u2 - e_r2 - h*Z_r*theta_c";
        "delta_s3 = u3 - e_s3";
        "delta_r3 = h*Z_r*theta_r - u3 - e_r3 - h*Z_r*theta_c";
        "delta_s4 = u4 - e_s4";
        "delta_r4 = h*Z_r*theta_r - u4 - e_r4 - h*Z_r*theta_c";
        "delta_s5 = u5 - e_s5";
        "delta_r5 = h*Z_r*theta_r - u5 - e_r5 - h*Z_r*theta_c";
        "delta_s6 = u6 - e_s6";
        "delta_r6 = h*Z_r*theta_r - u6 - e_r6 - h*Z_r*theta_c";
        "e_s1 = 0 without transmission error; the rates of deflections do not contain that of e_s1";
        "e_r1 = 0 without transmission error; the rates of deflections do not contain that of e_r1";
        "e_s2 = 0 without transmission error; the rates of deflections do not contain that of e_s2";
        "e_r2 = 0 without transmission error; the rates of deflections do not contain that of e_r2";
        "e_s3 = 0 without transmission error; the rates of deflections do not contain that of e_s3";
        "e_r3 = 0 without transmission error; the rates of deflections do not contain that of e_r3";
        "e_s4 = 0 without transmission error; the rates of deflections do not contain that of e_s4";
        "e_r4 = 0 without transmission error; the rates of deflections do not contain that of e_r4";
        "e_s5 = 0 without transmission error; the rates of deflections do not contain that of e_s5";
        "e_r5 = 0 without transmission error; the rates of deflections do not contain that of e_r5";
        "e_s6 = 0 without transmission error; the rates of deflections do not contain that of e_s6";
        "e_r6 = 0 without transmission error; the rates of deflections do not contain that of e_r6";
        "(I_c/Z_r^2 - 12*h*I_p/(r_p*Z_r) + 6*I_p/Z_r^2 + I_s/Z_r^2 + 2*I_s/(Z_r*Z_s) + I_s/Z_s^2 + 6*a^2*m_p/Z_r^2 + 6*h^2*I_p/r_p^2) theta'' + (I_c/Z_r - 6*h*I_p/r_p + 6*I_p/Z_r + I_s/Z_r + I_s/Z_s + 6*a^2*m_p/Z_r) theta_c'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u1'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u2'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u3'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u4'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u5'' + (I_p/(r_p*Z_r) - h*I_p/r_p^2) u6'' = k_r1*de_r1*delta_r1 + k_r2*de_r2*delta_r2 + k_r3*de_r3*delta_r3 + k_r4*de_r4*delta_r4 + k_r5*de_r5*delta_r5 + k_r6*de_r6*delta_r6 + k_s1*de_s1*delta_s1 + k_s2*de_s2*delta_s2 + k_s3*de_s3*delta_s3 + k_s4*de_s4*delta_s4 + k_s5*de_s5*delta_s5 + k_s6*de_s6*delta_s6 [transmission error, jump terms] + T_motor/Z_r - T_load/Z_r + T_motor/Z_s [torques] + h*I_p*alpha_M*u1_dot/r_p^2 + h*I_p*alpha_M*u2_dot/r_p^2 + h*I_p*alpha_M*u3_dot/r_p^2 + h*I_p*alpha_M*u4_dot/r_p^2 + h*I_p*alpha_M*u5_dot/r_p^2 + h*I_p*alpha_M*u6_dot/r_p^2 + 6*h*I_p*alpha_M*theta_c_dot/r_p + 12*h*I_p*alpha_M*theta_dot/(r_p*Z_r) - I_c*alpha_M*theta_dot/Z_r^2 - I_c*alpha_M*theta_c_dot/Z_r - 6*I_p*alpha_M*theta_dot/Z_r^2 - 6*I_p*alpha_M*theta_c_dot/Z_r - I_s*alpha_M*theta_dot/Z_r^2 - I_s*alpha_M*theta_c_dot/Z_r - 2*I_s*alpha_M*theta_dot/(Z_r*Z_s) - I_s*alpha_M*theta_dot/Z_s^2 - I_s*alpha_M*theta_c_dot/Z_s - 6*a^2*alpha_M*m_p*theta_dot/Z_r^2 - 6*a^2*alpha_M*m_p*theta_c_dot/Z_r - 6*h^2*I_p*alpha_M*theta_dot/r_p^2 - I_p*alpha_M*u1_dot/(r_p*Z_r) - I_p*alpha_M*u2_dot/(r_p*Z_r) - I_p*alpha_M*u3_dot/(r_p*Z_r) - I_p*alpha_M*u4_dot/(r_p*Z_r) - I_p*alpha_M*u5_dot/(r_p*Z_r) - I_p*alpha_M*u6_dot/(r_p*Z_r) [damping] + (-dk_r1*delta_r1^2 - dk_r2*delta_r2^2 - dk_r3*delta_r3^2 - dk_r4*delta_r4^2 - dk_r5*delta_r5^2 - dk_r6*delta_r6^2 - dk_s1*delta_s1^2 - dk_s2*delta_s2^2 - dk_s3*delta_s3^2 - dk_s4*delta_s4^2 - dk_s5*delta_s5^2 - dk_s6*delta_s6^2)/2 [jump terms]";
        "(I_c/Z_r - 6*h*I_p/r_p + 6*I_p/Z_r + I_s/Z_r + I_s/Z_s + 6*a^2*m_p/Z_r) theta'' + (I_c + 6*I_p + I_s + 6*a^2*m_p) theta_c'' + (I_p/r_p) u1'' + (I_p/r_p) u2'' + (I_p/r_p) u3'' + (I_p/r_p) u4'' + (I_p/r_p) u5'' + (I_p/r_p) u6'' = h*Z_r*k_r1*delta_r1 + h*Z_r*k_r2*delta_r2 + h*Z_r*k_r3*delta_r3 + h*Z_r*k_r4*delta_r4 + h*Z_r*k_r5*delta_r5 + h*Z_r*k_r6*delta_r6 + T_motor - T_load [torques] + h*Z_r*beta_K*k_r1_mid*delta_r1_dot + h*Z_r*beta_K*k_r2_mid*delta_r2_dot + h*Z_r*beta_K*k_r3_mid*delta_r3_dot + h*Z_r*beta_K*k_r4_mid*delta_r4_dot + h*Z_r*beta_K*k_r5_mid*delta_r5_dot + h*Z_r*beta_K*k_r6_mid*delta_r6_dot + 6*h*I_p*alpha_M*theta_dot/r_p - I_c*alpha_M*theta_c_dot - I_c*alpha_M*theta_dot/Z_r - 6*I_p*alpha_M*theta_c_dot - 6*I_p*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_c_dot - I_s*alpha_M*theta_dot/Z_r - I_s*alpha_M*theta_dot/Z_s - 6*a^2*alpha_M*m_p*theta_c_dot - 6*a^2*alpha_M*m_p*theta_dot/Z_r - I_p*alpha_M*u1_dot/r_p - I_p*alpha_M*u2_dot/r_p - I_p*alpha_M*u3_dot/r_p - I_p*alpha_M*u4_dot/r_p - I_p*alpha_M*u5_dot/r_p - I_p*alpha_M*u6_dot/r_p [damping]";
        "(I_r) theta_r'' = -h*Z_r*k_r1*delta_r1 - h*Z_r*k_r2*delta_r2 - h*Z_r*k_r3*delta_r3 - h*Z_r*k_r4*delta_r4 - h*Z_r*k_r5*delta_r5 - h*Z_r*k_r6*delta_r6 - k_r*theta_r - h*Z_r*beta_K*k_r1_mid*delta_r1_dot - h*Z_r*beta_K*k_r2_mid*delta_r2_dot - h*Z_r*beta_K*k_r3_mid*delta_r3_dot - h*Z_r*beta_K*k_r4_mid*delta_r4_dot - h*Z_r*beta_K*k_r5_mid*delta_r5_dot - h*Z_r*beta_K*k_r6_mid*delta_r6_dot - I_r*alpha_M*theta_r_dot - beta_K*k_r*theta_r_dot [damping]";
        "(I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u1'' = k_r1*delta_r1 - k_s1*delta_s1 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r1_mid*delta_r1_dot - beta_K*k_s1_mid*delta_s1_dot - I_p*alpha_M*u1_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]";
        "(I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u2'' = k_r2*delta_r2 - k_s2*delta_s2 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r2_mid*delta_r2_dot - beta_K*k_s2_mid*delta_s2_dot - I_p*alpha_M*u2_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]";
        "(I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u3'' = k_r3*delta_r3 - k_s3*delta_s3 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r3_mid*delta_r3_dot - beta_K*k_s3_mid*delta_s3_dot - I_p*alpha_M*u3_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]";
        "(I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u4'' = k_r4*delta_r4 - k_s4*delta_s4 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r4_mid*delta_r4_dot - beta_K*k_s4_mid*delta_s4_dot - I_p*alpha_M*u4_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]";
        "(I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u5'' = k_r5*delta_r5 - k_s5*delta_s5 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r5_mid*delta_r5_dot - beta_K*k_s5_mid*delta_s5_dot - I_p*alpha_M*u5_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]";
        "(I_p/(r_p*Z_r) - h*I_p/r_p^2) theta'' + (I_p/r_p) theta_c'' + (I_p/r_p^2) u6'' = k_r6*delta_r6 - k_s6*delta_s6 + h*I_p*alpha_M*theta_dot/r_p^2 + beta_K*k_r6_mid*delta_r6_dot - beta_K*k_s6_mid*delta_s6_dot - I_p*alpha_M*u6_dot/r_p^2 - I_p*alpha_M*theta_c_dot/r_p - I_p*alpha_M*theta_dot/(r_p*Z_r) [damping]";
        "at a step dk_s1 of k_s1 in theta: v+^2 = v-^2 - 2*G*(dk_s1*delta_s1^2/2)";
        "at a step dk_r1 of k_r1 in theta: v+^2 = v-^2 - 2*G*(dk_r1*delta_r1^2/2)";
        "at a step dk_s2 of k_s2 in theta: v+^2 = v-^2 - 2*G*(dk_s2*delta_s2^2/2)";
        "at a step dk_r2 of k_r2 in theta: v+^2 = v-^2 - 2*G*(dk_r2*delta_r2^2/2)";
        "at a step dk_s3 of k_s3 in theta: v+^2 = v-^2 - 2*G*(dk_s3*delta_s3^2/2)";
        "at a step dk_r3 of k_r3 in theta: v+^2 = v-^2 - 2*G*(dk_r3*delta_r3^2/2)";
        "at a step dk_s4 of k_s4 in theta: v+^2 = v-^2 - 2*G*(dk_s4*delta_s4^2/2)";
        "at a step dk_r4 of k_r4 in theta: v+^2 = v-^2 - 2*G*(dk_r4*delta_r4^2/2)";
        "at a step dk_s5 of k_s5 in theta: v+^2 = v-^2 - 2*G*(dk_s5*delta_s5^2/2)";
        "at a step dk_r5 of k_r5 in theta: v+^2 = v-^2 - 2*G*(dk_r5*delta_r5^2/2)";
        "at a step dk_s6 of k_s6 in theta: v+^2 = v-^2 - 2*G*(dk_s6*delta_s6^2/2)";
        "at a step dk_r6 of k_r6 in theta: v+^2 = v-^2 - 2*G*(dk_r6*delta_r6^2/2)";
        "at a step de_s1 of e_s1 in theta: v+^2 = v-^2 - 2*G*(k_s1*de_s1^2/2 - k_s1*de_s1*delta_s1)";
        "at a step de_r1 of e_r1 in theta: v+^2 = v-^2 - 2*G*(k_r1*de_r1^2/2 - k_r1*de_r1*delta_r1)";
        "at a step de_s2 of e_s2 in theta: v+^2 = v-^2 - 2*G*(k_s2*de_s2^2/2 - k_s2*de_s2*delta_s2)";
        "at a step de_r2 of e_r2 in theta: v+^2 = v-^2 - 2*G*(k_r2*de_r2^2/2 - k_r2*de_r2*delta_r2)";
        "at a step de_s3 of e_s3 in theta: v+^2 = v-^2 - 2*G*(k_s3*de_s3^2/2 - k_s3*de_s3*delta_s3)";
        "at a step de_r3 of e_r3 in theta: v+^2 = v-^2 - 2*G*(k_r3*de_r3^2/2 - k_r3*de_r3*delta_r3)";
        "at a step de_s4 of e_s4 in theta: v+^2 = v-^2 - 2*G*(k_s4*de_s4^2/2 - k_s4*de_s4*delta_s4)";
        "at a step de_r4 of e_r4 in theta: v+^2 = v-^2 - 2*G*(k_r4*de_r4^2/2 - k_r4*de_r4*delta_r4)";
        "at a step de_s5 of e_s5 in theta: v+^2 = v-^2 - 2*G*(k_s5*de_s5^2/2 - k_s5*de_s5*delta_s5)";
        "at a step de_r5 of e_r5 in theta: v+^2 = v-^2 - 2*G*(k_r5*de_r5^2/2 - k_r5*de_r5*delta_r5)";
        "at a step de_s6 of e_s6 in theta: v+^2 = v-^2 - 2*G*(k_s6*de_s6^2/2 - k_s6*de_s6*delta_s6)";
        "at a step de_r6 of e_r6 in theta: v+^2 = v-^2 - 2*G*(k_r6*de_r6^2/2 - k_r6*de_r6*delta_r6)";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
    }
    latex {
        "T = \\frac{I_{c}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{1}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{2}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{3}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{4}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{5}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{6}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{r}\\, \\dot{\\theta_{r}}^{2}}{2} + \\frac{I_{s}\\, \\left(\\dot{\\theta_{c}} + \\dot{\\theta}\\, \\left(\\frac{1}{Z_{r}} + \\frac{1}{Z_{s}}\\right)\\right)^{2}}{2} + 3\\, a^{2}\\, m_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}";
        "V = \\frac{1}{2} (k_{r}\\, \\theta_{r}^{2} + k_{r1}\\, \\delta_{r1}^{2} + k_{r2}\\, \\delta_{r2}^{2} + k_{r3}\\, \\delta_{r3}^{2} + k_{r4}\\, \\delta_{r4}^{2} + k_{r5}\\, \\delta_{r5}^{2} + k_{r6}\\, \\delta_{r6}^{2} + k_{s1}\\, \\delta_{s1}^{2} + k_{s2}\\, \\delta_{s2}^{2} + k_{s3}\\, \\delta_{s3}^{2} + k_{s4}\\, \\delta_{s4}^{2} + k_{s5}\\, \\delta_{s5}^{2} + k_{s6}\\, \\delta_{s6}^{2})";
        "D = \\frac{I_{c}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{1}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{2}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{3}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{4}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{5}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{p}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\left(\\dot{u_{6}} - h\\, \\dot{\\theta}\\right)}{r_{p}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}}{2} + \\frac{I_{r}\\, \\alpha_{M}\\, \\dot{\\theta_{r}}^{2}}{2} + \\frac{I_{s}\\, \\alpha_{M}\\, \\left(\\dot{\\theta_{c}} + \\dot{\\theta}\\, \\left(\\frac{1}{Z_{r}} + \\frac{1}{Z_{s}}\\right)\\right)^{2}}{2} + \\frac{\\beta_{K}\\, k_{r}\\, \\dot{\\theta_{r}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{r1}}\\, \\dot{\\delta_{r1}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{r2}}\\, \\dot{\\delta_{r2}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{r3}}\\, \\dot{\\delta_{r3}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{r4}}\\, \\dot{\\delta_{r4}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{r5}}\\, \\dot{\\delta_{r5}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{r6}}\\, \\dot{\\delta_{r6}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{s1}}\\, \\dot{\\delta_{s1}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{s2}}\\, \\dot{\\delta_{s2}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{s3}}\\, \\dot{\\delta_{s3}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{s4}}\\, \\dot{\\delta_{s4}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{s5}}\\, \\dot{\\delta_{s5}}^{2}}{2} + \\frac{\\beta_{K}\\, \\bar{k_{s6}}\\, \\dot{\\delta_{s6}}^{2}}{2} + 3\\, a^{2}\\, \\alpha_{M}\\, m_{p}\\, \\left(\\dot{\\theta_{c}} + \\frac{\\dot{\\theta}}{Z_{r}}\\right)^{2}\\ [\\text{damping}]";
        "Q_{\\theta} = \\frac{T_{motor}}{Z_{r}} - \\frac{T_{load}}{Z_{r}} + \\frac{T_{motor}}{Z_{s}}\\ [\\text{torques}]";
        "Q_{\\theta_{c}} = T_{motor} - T_{load}\\ [\\text{torques}]";
        "Q_{\\theta_{r}} = 0";
        "Q_{u_{1}} = 0";
        "Q_{u_{2}} = 0";
        "Q_{u_{3}} = 0";
        "Q_{u_{4}} = 0";
        "Q_{u_{5}} = 0";
        "Q_{u_{6}} = 0";
        "\\mathrm{cos}_{a} = \\cos\\left(\\alpha\\right)";
        "\\mathrm{sin}_{a} = \\sin\\left(\\alpha\\right)";
        "h = \\frac{r_{s}}{Z_{s}}";
        "r_{p} = \\frac{1}{2} (h\\, Z_{r} - h\\, Z_{s})";
        "a = \\frac{1}{2} (\\frac{h\\, Z_{r}}{\\mathrm{cos}_{a}} + \\frac{h\\, Z_{s}}{\\mathrm{cos}_{a}})";
        "\\delta_{s1} = u_{1} - e_{s1}";
        "\\delta_{r1} = h\\, Z_{r}\\, \\theta_{r} - u_{1} - e_{r1} - h\\, Z_{r}\\, \\theta_{c}";
        "\\delta_{s2} = u_{2} - e_{s2}";
        "\\delta_{r2} = h\\, Z_{r}\\, \\theta_{r} - u_{2} - e_{r2} - h\\, Z_{r}\\, \\theta_{c}";
        "\\delta_{s3} = u_{3} - e_{s3}";
        "\\delta_{r3} = h\\, Z_{r}\\, \\theta_{r} - u_{3} - e_{r3} - h\\, Z_{r}\\, \\theta_{c}";
        "\\delta_{s4} = u_{4} - e_{s4}";
        "\\delta_{r4} = h\\, Z_{r}\\, \\theta_{r} - u_{4} - e_{r4} - h\\, Z_{r}\\, \\theta_{c}";
        "\\delta_{s5} = u_{5} - e_{s5}";
        "\\delta_{r5} = h\\, Z_{r}\\, \\theta_{r} - u_{5} - e_{r5} - h\\, Z_{r}\\, \\theta_{c}";
        "\\delta_{s6} = u_{6} - e_{s6}";
        "\\delta_{r6} = h\\, Z_{r}\\, \\theta_{r} - u_{6} - e_{r6} - h\\, Z_{r}\\, \\theta_{c}";
        "(\\frac{I_{c}}{Z_{r}^{2}} - \\frac{12\\, h\\, I_{p}}{r_{p}\\, Z_{r}} + \\frac{6\\, I_{p}}{Z_{r}^{2}} + \\frac{I_{s}}{Z_{r}^{2}} + \\frac{2\\, I_{s}}{Z_{r}\\, Z_{s}} + \\frac{I_{s}}{Z_{s}^{2}} + \\frac{6\\, a^{2}\\, m_{p}}{Z_{r}^{2}} + \\frac{6\\, h^{2}\\, I_{p}}{r_{p}^{2}}) \\ddot{\\theta} + (\\frac{I_{c}}{Z_{r}} - \\frac{6\\, h\\, I_{p}}{r_{p}} + \\frac{6\\, I_{p}}{Z_{r}} + \\frac{I_{s}}{Z_{r}} + \\frac{I_{s}}{Z_{s}} + \\frac{6\\, a^{2}\\, m_{p}}{Z_{r}}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{u_{1}} + (\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{u_{2}} + (\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{u_{3}} + (\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{u_{4}} + (\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{u_{5}} + (\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{u_{6}} = k_{r1}\\, e_{r1}'\\, \\delta_{r1} + k_{r2}\\, e_{r2}'\\, \\delta_{r2} + k_{r3}\\, e_{r3}'\\, \\delta_{r3} + k_{r4}\\, e_{r4}'\\, \\delta_{r4} + k_{r5}\\, e_{r5}'\\, \\delta_{r5} + k_{r6}\\, e_{r6}'\\, \\delta_{r6} + k_{s1}\\, e_{s1}'\\, \\delta_{s1} + k_{s2}\\, e_{s2}'\\, \\delta_{s2} + k_{s3}\\, e_{s3}'\\, \\delta_{s3} + k_{s4}\\, e_{s4}'\\, \\delta_{s4} + k_{s5}\\, e_{s5}'\\, \\delta_{s5} + k_{s6}\\, e_{s6}'\\, \\delta_{s6}\\ [\\text{transmission error, jump terms}] + \\frac{T_{motor}}{Z_{r}} - \\frac{T_{load}}{Z_{r}} + \\frac{T_{motor}}{Z_{s}}\\ [\\text{torques}] + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{u_{1}}}{r_{p}^{2}} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{u_{2}}}{r_{p}^{2}} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{u_{3}}}{r_{p}^{2}} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{u_{4}}}{r_{p}^{2}} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{u_{5}}}{r_{p}^{2}} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{u_{6}}}{r_{p}^{2}} + \\frac{6\\, h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{r_{p}} + \\frac{12\\, h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}\\, Z_{r}} - \\frac{I_{c}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{r}^{2}} - \\frac{I_{c}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{Z_{r}} - \\frac{6\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{r}^{2}} - \\frac{6\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{Z_{r}} - \\frac{I_{s}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{r}^{2}} - \\frac{I_{s}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{Z_{r}} - \\frac{2\\, I_{s}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{r}\\, Z_{s}} - \\frac{I_{s}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{s}^{2}} - \\frac{I_{s}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{Z_{s}} - \\frac{6\\, a^{2}\\, \\alpha_{M}\\, m_{p}\\, \\dot{\\theta}}{Z_{r}^{2}} - \\frac{6\\, a^{2}\\, \\alpha_{M}\\, m_{p}\\, \\dot{\\theta_{c}}}{Z_{r}} - \\frac{6\\, h^{2}\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}^{2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{1}}}{r_{p}\\, Z_{r}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{2}}}{r_{p}\\, Z_{r}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{3}}}{r_{p}\\, Z_{r}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{4}}}{r_{p}\\, Z_{r}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{5}}}{r_{p}\\, Z_{r}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{6}}}{r_{p}\\, Z_{r}}\\ [\\text{damping}] + \\frac{1}{2} (-k_{r1}'\\, \\delta_{r1}^{2} - k_{r2}'\\, \\delta_{r2}^{2} - k_{r3}'\\, \\delta_{r3}^{2} - k_{r4}'\\, \\delta_{r4}^{2} - k_{r5}'\\, \\delta_{r5}^{2} - k_{r6}'\\, \\delta_{r6}^{2} - k_{s1}'\\, \\delta_{s1}^{2} - k_{s2}'\\, \\delta_{s2}^{2} - k_{s3}'\\, \\delta_{s3}^{2} - k_{s4}'\\, \\delta_{s4}^{2} - k_{s5}'\\, \\delta_{s5}^{2} - k_{s6}'\\, \\delta_{s6}^{2})\\ [\\text{jump terms}]";
        "(\\frac{I_{c}}{Z_{r}} - \\frac{6\\, h\\, I_{p}}{r_{p}} + \\frac{6\\, I_{p}}{Z_{r}} + \\frac{I_{s}}{Z_{r}} + \\frac{I_{s}}{Z_{s}} + \\frac{6\\, a^{2}\\, m_{p}}{Z_{r}}) \\ddot{\\theta} + (I_{c} + 6\\, I_{p} + I_{s} + 6\\, a^{2}\\, m_{p}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}}) \\ddot{u_{1}} + (\\frac{I_{p}}{r_{p}}) \\ddot{u_{2}} + (\\frac{I_{p}}{r_{p}}) \\ddot{u_{3}} + (\\frac{I_{p}}{r_{p}}) \\ddot{u_{4}} + (\\frac{I_{p}}{r_{p}}) \\ddot{u_{5}} + (\\frac{I_{p}}{r_{p}}) \\ddot{u_{6}} = h\\, Z_{r}\\, k_{r1}\\, \\delta_{r1} + h\\, Z_{r}\\, k_{r2}\\, \\delta_{r2} + h\\, Z_{r}\\, k_{r3}\\, \\delta_{r3} + h\\, Z_{r}\\, k_{r4}\\, \\delta_{r4} + h\\, Z_{r}\\, k_{r5}\\, \\delta_{r5} + h\\, Z_{r}\\, k_{r6}\\, \\delta_{r6} + T_{motor} - T_{load}\\ [\\text{torques}] + h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r1}}\\, \\dot{\\delta_{r1}} + h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r2}}\\, \\dot{\\delta_{r2}} + h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r3}}\\, \\dot{\\delta_{r3}} + h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r4}}\\, \\dot{\\delta_{r4}} + h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r5}}\\, \\dot{\\delta_{r5}} + h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r6}}\\, \\dot{\\delta_{r6}} + \\frac{6\\, h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}} - I_{c}\\, \\alpha_{M}\\, \\dot{\\theta_{c}} - \\frac{I_{c}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{r}} - 6\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}} - \\frac{6\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{r}} - I_{s}\\, \\alpha_{M}\\, \\dot{\\theta_{c}} - \\frac{I_{s}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{r}} - \\frac{I_{s}\\, \\alpha_{M}\\, \\dot{\\theta}}{Z_{s}} - 6\\, a^{2}\\, \\alpha_{M}\\, m_{p}\\, \\dot{\\theta_{c}} - \\frac{6\\, a^{2}\\, \\alpha_{M}\\, m_{p}\\, \\dot{\\theta}}{Z_{r}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{1}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{2}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{3}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{4}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{5}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{6}}}{r_{p}}\\ [\\text{damping}]";
        "(I_{r}) \\ddot{\\theta_{r}} = -h\\, Z_{r}\\, k_{r1}\\, \\delta_{r1} - h\\, Z_{r}\\, k_{r2}\\, \\delta_{r2} - h\\, Z_{r}\\, k_{r3}\\, \\delta_{r3} - h\\, Z_{r}\\, k_{r4}\\, \\delta_{r4} - h\\, Z_{r}\\, k_{r5}\\, \\delta_{r5} - h\\, Z_{r}\\, k_{r6}\\, \\delta_{r6} - k_{r}\\, \\theta_{r} - h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r1}}\\, \\dot{\\delta_{r1}} - h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r2}}\\, \\dot{\\delta_{r2}} - h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r3}}\\, \\dot{\\delta_{r3}} - h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r4}}\\, \\dot{\\delta_{r4}} - h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r5}}\\, \\dot{\\delta_{r5}} - h\\, Z_{r}\\, \\beta_{K}\\, \\bar{k_{r6}}\\, \\dot{\\delta_{r6}} - I_{r}\\, \\alpha_{M}\\, \\dot{\\theta_{r}} - \\beta_{K}\\, k_{r}\\, \\dot{\\theta_{r}}\\ [\\text{damping}]";
        "(\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{\\theta} + (\\frac{I_{p}}{r_{p}}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}^{2}}) \\ddot{u_{1}} = k_{r1}\\, \\delta_{r1} - k_{s1}\\, \\delta_{s1} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}^{2}} + \\beta_{K}\\, \\bar{k_{r1}}\\, \\dot{\\delta_{r1}} - \\beta_{K}\\, \\bar{k_{s1}}\\, \\dot{\\delta_{s1}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{1}}}{r_{p}^{2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}\\, Z_{r}}\\ [\\text{damping}]";
        "(\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{\\theta} + (\\frac{I_{p}}{r_{p}}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}^{2}}) \\ddot{u_{2}} = k_{r2}\\, \\delta_{r2} - k_{s2}\\, \\delta_{s2} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}^{2}} + \\beta_{K}\\, \\bar{k_{r2}}\\, \\dot{\\delta_{r2}} - \\beta_{K}\\, \\bar{k_{s2}}\\, \\dot{\\delta_{s2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{2}}}{r_{p}^{2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}\\, Z_{r}}\\ [\\text{damping}]";
        "(\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{\\theta} + (\\frac{I_{p}}{r_{p}}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}^{2}}) \\ddot{u_{3}} = k_{r3}\\, \\delta_{r3} - k_{s3}\\, \\delta_{s3} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}^{2}} + \\beta_{K}\\, \\bar{k_{r3}}\\, \\dot{\\delta_{r3}} - \\beta_{K}\\, \\bar{k_{s3}}\\, \\dot{\\delta_{s3}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{3}}}{r_{p}^{2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}\\, Z_{r}}\\ [\\text{damping}]";
        "(\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{\\theta} + (\\frac{I_{p}}{r_{p}}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}^{2}}) \\ddot{u_{4}} = k_{r4}\\, \\delta_{r4} - k_{s4}\\, \\delta_{s4} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}^{2}} + \\beta_{K}\\, \\bar{k_{r4}}\\, \\dot{\\delta_{r4}} - \\beta_{K}\\, \\bar{k_{s4}}\\, \\dot{\\delta_{s4}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{4}}}{r_{p}^{2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}\\, Z_{r}}\\ [\\text{damping}]";
        "(\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{\\theta} + (\\frac{I_{p}}{r_{p}}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}^{2}}) \\ddot{u_{5}} = k_{r5}\\, \\delta_{r5} - k_{s5}\\, \\delta_{s5} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}^{2}} + \\beta_{K}\\, \\bar{k_{r5}}\\, \\dot{\\delta_{r5}} - \\beta_{K}\\, \\bar{k_{s5}}\\, \\dot{\\delta_{s5}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{5}}}{r_{p}^{2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}\\, Z_{r}}\\ [\\text{damping}]";
        "(\\frac{I_{p}}{r_{p}\\, Z_{r}} - \\frac{h\\, I_{p}}{r_{p}^{2}}) \\ddot{\\theta} + (\\frac{I_{p}}{r_{p}}) \\ddot{\\theta_{c}} + (\\frac{I_{p}}{r_{p}^{2}}) \\ddot{u_{6}} = k_{r6}\\, \\delta_{r6} - k_{s6}\\, \\delta_{s6} + \\frac{h\\, I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}^{2}} + \\beta_{K}\\, \\bar{k_{r6}}\\, \\dot{\\delta_{r6}} - \\beta_{K}\\, \\bar{k_{s6}}\\, \\dot{\\delta_{s6}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{u_{6}}}{r_{p}^{2}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta_{c}}}{r_{p}} - \\frac{I_{p}\\, \\alpha_{M}\\, \\dot{\\theta}}{r_{p}\\, Z_{r}}\\ [\\text{damping}]";
    }
}
