//! Equations of motion of `two_stage`: a two-stage gearbox with a countershaft.
//!
//! Derived from the energies in `models/src/two_stage.rs` by `cargo xtask derive two_stage`. Do not edit: change the
//! energies and derive again.
//! Source: standard torsional model; phases as Oh, Grosh & Barber (2005)
//!
//! # Energies
//!
//! ```text
//! T = (I1*(s1_dot/(2*h1*N1) + theta1_dot/N1)^2 + I2*(theta1_dot/N2 - s1_dot/(2*h1*N2))^2 + I3*(s2_dot/(2*h2*N3) + theta2_dot/N3)^2 + I4*(theta2_dot/N4 - s2_dot/(2*h2*N4))^2 + I_l*(theta2_dot/N4 - psi_l_dot - s2_dot/(2*h2*N4))^2 + I_m*(psi_m_dot + s1_dot/(2*h1*N1) + theta1_dot/N1)^2)/2
//! V = (k_c*twist_c^2 + k_l*psi_l^2 + k_m*psi_m^2 + k12*touch12*over12^2 + k34*touch34*over34^2)/2
//! D = (I1*alpha_M*(s1_dot/(2*h1*N1) + theta1_dot/N1)^2 + I2*alpha_M*(theta1_dot/N2 - s1_dot/(2*h1*N2))^2 + I3*alpha_M*(s2_dot/(2*h2*N3) + theta2_dot/N3)^2 + I4*alpha_M*(theta2_dot/N4 - s2_dot/(2*h2*N4))^2 + I_l*alpha_M*(theta2_dot/N4 - psi_l_dot - s2_dot/(2*h2*N4))^2 + I_m*alpha_M*(psi_m_dot + s1_dot/(2*h1*N1) + theta1_dot/N1)^2 + beta_K*k_c*twist_c_dot^2 + beta_K*k_l*psi_l_dot^2 + beta_K*k_m*psi_m_dot^2 + beta_K*k12_mid*damp12*over12_dot^2 + beta_K*k34_mid*damp34*over34_dot^2)/2 [damping]
//! Q_theta1 = T_motor/N1 [torques]
//! Q_s1 = T_motor/(2*h1*N1) [torques]
//! Q_theta2 = -T_load/N4 [torques]
//! Q_s2 = T_load/(2*h2*N4) [torques]
//! Q_psi_m = T_motor [torques]
//! Q_psi_l = T_load [torques]
//! ```
//!
//! # Constants
//!
//! ```text
//! h1 = r1/N1
//! h2 = r3/N3
//! ```
//!
//! # Deflections
//!
//! ```text
//! twist_c = theta1/N2 - s1/(2*h1*N2) - s2/(2*h2*N3) - theta2/N3
//! over12 = s1 - edge12
//! over34 = s2 - edge34
//! touch12 = 1 in contact, beyond edge12 = b12/2 or -b12/2; touch12 = 0 between the edges; without backlash touch12 = 1 and edge12 = 0
//! damp12 = 1 and clip12 = 0 in contact while the damper force is less than the spring force, else damp12 = 0:
//!   clip12 = 1 if the damper would push more than the spring: its force is limited to the spring force
//!   clip12 = -1 if the damper would pull more than the spring pushes: the contact force is zero
//! touch34 = 1 in contact, beyond edge34 = b34/2 or -b34/2; touch34 = 0 between the edges; without backlash touch34 = 1 and edge34 = 0
//! damp34 = 1 and clip34 = 0 in contact while the damper force is less than the spring force, else damp34 = 0:
//!   clip34 = 1 if the damper would push more than the spring: its force is limited to the spring force
//!   clip34 = -1 if the damper would pull more than the spring pushes: the contact force is zero
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! (I1/N1^2 + I2/N2^2 + I_m/N1^2) theta1'' + ((I1/(h1*N1^2) - I2/(h1*N2^2) + I_m/(h1*N1^2))/2) s1'' + (I_m/N1) psi_m'' = -k_c*twist_c/N2 + T_motor/N1 [torques] + I2*alpha_M*s1_dot/(2*h1*N2^2) - I1*alpha_M*theta1_dot/N1^2 - I2*alpha_M*theta1_dot/N2^2 - I_m*alpha_M*theta1_dot/N1^2 - I_m*alpha_M*psi_m_dot/N1 - I1*alpha_M*s1_dot/(2*h1*N1^2) - I_m*alpha_M*s1_dot/(2*h1*N1^2) - beta_K*k_c*twist_c_dot/N2 [damping] - dk12*touch12*over12^2/2 [jump terms]
//! ((I1/(h1*N1^2) - I2/(h1*N2^2) + I_m/(h1*N1^2))/2) theta1'' + ((I1/(h1^2*N1^2) + I2/(h1^2*N2^2) + I_m/(h1^2*N1^2))/4) s1'' + (I_m/(2*h1*N1)) psi_m'' = k_c*twist_c/(2*h1*N2) - k12*touch12*over12 - k12*touch12*clip12*over12 [backlash] + T_motor/(2*h1*N1) [torques] + I2*alpha_M*theta1_dot/(2*h1*N2^2) - beta_K*k12_mid*damp12*over12_dot - I1*alpha_M*s1_dot/(4*h1^2*N1^2) - I2*alpha_M*s1_dot/(4*h1^2*N2^2) - I_m*alpha_M*s1_dot/(4*h1^2*N1^2) - I1*alpha_M*theta1_dot/(2*h1*N1^2) - I_m*alpha_M*theta1_dot/(2*h1*N1^2) - I_m*alpha_M*psi_m_dot/(2*h1*N1) + beta_K*k_c*twist_c_dot/(2*h1*N2) [damping]
//! (I3/N3^2 + I4/N4^2 + I_l/N4^2) theta2'' + ((I3/(h2*N3^2) - I4/(h2*N4^2) - I_l/(h2*N4^2))/2) s2'' + (-I_l/N4) psi_l'' = k_c*twist_c/N3 - T_load/N4 [torques] + I_l*alpha_M*psi_l_dot/N4 - I3*alpha_M*theta2_dot/N3^2 - I4*alpha_M*theta2_dot/N4^2 - I_l*alpha_M*theta2_dot/N4^2 - I3*alpha_M*s2_dot/(2*h2*N3^2) + I4*alpha_M*s2_dot/(2*h2*N4^2) + I_l*alpha_M*s2_dot/(2*h2*N4^2) + beta_K*k_c*twist_c_dot/N3 [damping] - dk34*touch34*over34^2/2 [jump terms]
//! ((I3/(h2*N3^2) - I4/(h2*N4^2) - I_l/(h2*N4^2))/2) theta2'' + ((I3/(h2^2*N3^2) + I4/(h2^2*N4^2) + I_l/(h2^2*N4^2))/4) s2'' + (I_l/(2*h2*N4)) psi_l'' = k_c*twist_c/(2*h2*N3) - k34*touch34*over34 - k34*touch34*clip34*over34 [backlash] + T_load/(2*h2*N4) [torques] + I4*alpha_M*theta2_dot/(2*h2*N4^2) - beta_K*k34_mid*damp34*over34_dot - I3*alpha_M*s2_dot/(4*h2^2*N3^2) - I4*alpha_M*s2_dot/(4*h2^2*N4^2) - I_l*alpha_M*s2_dot/(4*h2^2*N4^2) - I3*alpha_M*theta2_dot/(2*h2*N3^2) + I_l*alpha_M*theta2_dot/(2*h2*N4^2) - I_l*alpha_M*psi_l_dot/(2*h2*N4) + beta_K*k_c*twist_c_dot/(2*h2*N3) [damping]
//! (I_m/N1) theta1'' + (I_m/(2*h1*N1)) s1'' + (I_m) psi_m'' = -k_m*psi_m + T_motor [torques] - I_m*alpha_M*psi_m_dot - I_m*alpha_M*theta1_dot/N1 - beta_K*k_m*psi_m_dot - I_m*alpha_M*s1_dot/(2*h1*N1) [damping]
//! (-I_l/N4) theta2'' + (I_l/(2*h2*N4)) s2'' + (I_l) psi_l'' = -k_l*psi_l + T_load [torques] + I_l*alpha_M*theta2_dot/N4 - I_l*alpha_M*psi_l_dot - beta_K*k_l*psi_l_dot - I_l*alpha_M*s2_dot/(2*h2*N4) [damping]
//! ```
//!
//! # At a step of a stiffness
//!
//! ```text
//! at a step dk12 of k12 in theta1: v+^2 = v-^2 - 2*G*(dk12*touch12*over12^2/2)
//! at a step dk34 of k34 in theta2: v+^2 = v-^2 - 2*G*(dk34*touch34*over34^2/2)
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
//! T = \frac{1}{2} (I_{1}\, \left(\frac{\dot{s_{1}}}{2\, h_{1}\, N_{1}} + \frac{\dot{\theta_{1}}}{N_{1}}\right)^{2} + I_{2}\, \left(\frac{\dot{\theta_{1}}}{N_{2}} - \frac{\dot{s_{1}}}{2\, h_{1}\, N_{2}}\right)^{2} + I_{3}\, \left(\frac{\dot{s_{2}}}{2\, h_{2}\, N_{3}} + \frac{\dot{\theta_{2}}}{N_{3}}\right)^{2} + I_{4}\, \left(\frac{\dot{\theta_{2}}}{N_{4}} - \frac{\dot{s_{2}}}{2\, h_{2}\, N_{4}}\right)^{2} + I_{l}\, \left(\frac{\dot{\theta_{2}}}{N_{4}} - \dot{\psi_{l}} - \frac{\dot{s_{2}}}{2\, h_{2}\, N_{4}}\right)^{2} + I_{m}\, \left(\dot{\psi_{m}} + \frac{\dot{s_{1}}}{2\, h_{1}\, N_{1}} + \frac{\dot{\theta_{1}}}{N_{1}}\right)^{2})
//! V = \frac{1}{2} (k_{c}\, \mathrm{twist}_{c}^{2} + k_{l}\, \psi_{l}^{2} + k_{m}\, \psi_{m}^{2} + k_{12}\, \mathrm{touch}_{12}\, \mathrm{over}_{12}^{2} + k_{34}\, \mathrm{touch}_{34}\, \mathrm{over}_{34}^{2})
//! D = \frac{1}{2} (I_{1}\, \alpha_{M}\, \left(\frac{\dot{s_{1}}}{2\, h_{1}\, N_{1}} + \frac{\dot{\theta_{1}}}{N_{1}}\right)^{2} + I_{2}\, \alpha_{M}\, \left(\frac{\dot{\theta_{1}}}{N_{2}} - \frac{\dot{s_{1}}}{2\, h_{1}\, N_{2}}\right)^{2} + I_{3}\, \alpha_{M}\, \left(\frac{\dot{s_{2}}}{2\, h_{2}\, N_{3}} + \frac{\dot{\theta_{2}}}{N_{3}}\right)^{2} + I_{4}\, \alpha_{M}\, \left(\frac{\dot{\theta_{2}}}{N_{4}} - \frac{\dot{s_{2}}}{2\, h_{2}\, N_{4}}\right)^{2} + I_{l}\, \alpha_{M}\, \left(\frac{\dot{\theta_{2}}}{N_{4}} - \dot{\psi_{l}} - \frac{\dot{s_{2}}}{2\, h_{2}\, N_{4}}\right)^{2} + I_{m}\, \alpha_{M}\, \left(\dot{\psi_{m}} + \frac{\dot{s_{1}}}{2\, h_{1}\, N_{1}} + \frac{\dot{\theta_{1}}}{N_{1}}\right)^{2} + \beta_{K}\, k_{c}\, \dot{\mathrm{twist}_{c}}^{2} + \beta_{K}\, k_{l}\, \dot{\psi_{l}}^{2} + \beta_{K}\, k_{m}\, \dot{\psi_{m}}^{2} + \beta_{K}\, \bar{k_{12}}\, \mathrm{damp}_{12}\, \dot{\mathrm{over}_{12}}^{2} + \beta_{K}\, \bar{k_{34}}\, \mathrm{damp}_{34}\, \dot{\mathrm{over}_{34}}^{2})\ [\text{damping}]
//! Q_{\theta_{1}} = \frac{T_{motor}}{N_{1}}\ [\text{torques}]
//! Q_{s_{1}} = \frac{T_{motor}}{2\, h_{1}\, N_{1}}\ [\text{torques}]
//! Q_{\theta_{2}} = -\frac{T_{load}}{N_{4}}\ [\text{torques}]
//! Q_{s_{2}} = \frac{T_{load}}{2\, h_{2}\, N_{4}}\ [\text{torques}]
//! Q_{\psi_{m}} = T_{motor}\ [\text{torques}]
//! Q_{\psi_{l}} = T_{load}\ [\text{torques}]
//! h_{1} = \frac{r_{1}}{N_{1}}
//! h_{2} = \frac{r_{3}}{N_{3}}
//! \mathrm{twist}_{c} = \frac{\theta_{1}}{N_{2}} - \frac{s_{1}}{2\, h_{1}\, N_{2}} - \frac{s_{2}}{2\, h_{2}\, N_{3}} - \frac{\theta_{2}}{N_{3}}
//! \mathrm{over}_{12} = s_{1} - \mathrm{edge}_{12}
//! \mathrm{over}_{34} = s_{2} - \mathrm{edge}_{34}
//! (\frac{I_{1}}{N_{1}^{2}} + \frac{I_{2}}{N_{2}^{2}} + \frac{I_{m}}{N_{1}^{2}}) \ddot{\theta_{1}} + (\frac{1}{2} (\frac{I_{1}}{h_{1}\, N_{1}^{2}} - \frac{I_{2}}{h_{1}\, N_{2}^{2}} + \frac{I_{m}}{h_{1}\, N_{1}^{2}})) \ddot{s_{1}} + (\frac{I_{m}}{N_{1}}) \ddot{\psi_{m}} = -\frac{k_{c}\, \mathrm{twist}_{c}}{N_{2}} + \frac{T_{motor}}{N_{1}}\ [\text{torques}] + \frac{I_{2}\, \alpha_{M}\, \dot{s_{1}}}{2\, h_{1}\, N_{2}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta_{1}}}{N_{1}^{2}} - \frac{I_{2}\, \alpha_{M}\, \dot{\theta_{1}}}{N_{2}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\theta_{1}}}{N_{1}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\psi_{m}}}{N_{1}} - \frac{I_{1}\, \alpha_{M}\, \dot{s_{1}}}{2\, h_{1}\, N_{1}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{s_{1}}}{2\, h_{1}\, N_{1}^{2}} - \frac{\beta_{K}\, k_{c}\, \dot{\mathrm{twist}_{c}}}{N_{2}}\ [\text{damping}] - \frac{k_{12}'\, \mathrm{touch}_{12}\, \mathrm{over}_{12}^{2}}{2}\ [\text{jump terms}]
//! (\frac{1}{2} (\frac{I_{1}}{h_{1}\, N_{1}^{2}} - \frac{I_{2}}{h_{1}\, N_{2}^{2}} + \frac{I_{m}}{h_{1}\, N_{1}^{2}})) \ddot{\theta_{1}} + (\frac{1}{4} (\frac{I_{1}}{h_{1}^{2}\, N_{1}^{2}} + \frac{I_{2}}{h_{1}^{2}\, N_{2}^{2}} + \frac{I_{m}}{h_{1}^{2}\, N_{1}^{2}})) \ddot{s_{1}} + (\frac{I_{m}}{2\, h_{1}\, N_{1}}) \ddot{\psi_{m}} = \frac{k_{c}\, \mathrm{twist}_{c}}{2\, h_{1}\, N_{2}} - k_{12}\, \mathrm{touch}_{12}\, \mathrm{over}_{12} - k_{12}\, \mathrm{touch}_{12}\, \mathrm{clip}_{12}\, \mathrm{over}_{12}\ [\text{backlash}] + \frac{T_{motor}}{2\, h_{1}\, N_{1}}\ [\text{torques}] + \frac{I_{2}\, \alpha_{M}\, \dot{\theta_{1}}}{2\, h_{1}\, N_{2}^{2}} - \beta_{K}\, \bar{k_{12}}\, \mathrm{damp}_{12}\, \dot{\mathrm{over}_{12}} - \frac{I_{1}\, \alpha_{M}\, \dot{s_{1}}}{4\, h_{1}^{2}\, N_{1}^{2}} - \frac{I_{2}\, \alpha_{M}\, \dot{s_{1}}}{4\, h_{1}^{2}\, N_{2}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{s_{1}}}{4\, h_{1}^{2}\, N_{1}^{2}} - \frac{I_{1}\, \alpha_{M}\, \dot{\theta_{1}}}{2\, h_{1}\, N_{1}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\theta_{1}}}{2\, h_{1}\, N_{1}^{2}} - \frac{I_{m}\, \alpha_{M}\, \dot{\psi_{m}}}{2\, h_{1}\, N_{1}} + \frac{\beta_{K}\, k_{c}\, \dot{\mathrm{twist}_{c}}}{2\, h_{1}\, N_{2}}\ [\text{damping}]
//! (\frac{I_{3}}{N_{3}^{2}} + \frac{I_{4}}{N_{4}^{2}} + \frac{I_{l}}{N_{4}^{2}}) \ddot{\theta_{2}} + (\frac{1}{2} (\frac{I_{3}}{h_{2}\, N_{3}^{2}} - \frac{I_{4}}{h_{2}\, N_{4}^{2}} - \frac{I_{l}}{h_{2}\, N_{4}^{2}})) \ddot{s_{2}} + (-\frac{I_{l}}{N_{4}}) \ddot{\psi_{l}} = \frac{k_{c}\, \mathrm{twist}_{c}}{N_{3}} - \frac{T_{load}}{N_{4}}\ [\text{torques}] + \frac{I_{l}\, \alpha_{M}\, \dot{\psi_{l}}}{N_{4}} - \frac{I_{3}\, \alpha_{M}\, \dot{\theta_{2}}}{N_{3}^{2}} - \frac{I_{4}\, \alpha_{M}\, \dot{\theta_{2}}}{N_{4}^{2}} - \frac{I_{l}\, \alpha_{M}\, \dot{\theta_{2}}}{N_{4}^{2}} - \frac{I_{3}\, \alpha_{M}\, \dot{s_{2}}}{2\, h_{2}\, N_{3}^{2}} + \frac{I_{4}\, \alpha_{M}\, \dot{s_{2}}}{2\, h_{2}\, N_{4}^{2}} + \frac{I_{l}\, \alpha_{M}\, \dot{s_{2}}}{2\, h_{2}\, N_{4}^{2}} + \frac{\beta_{K}\, k_{c}\, \dot{\mathrm{twist}_{c}}}{N_{3}}\ [\text{damping}] - \frac{k_{34}'\, \mathrm{touch}_{34}\, \mathrm{over}_{34}^{2}}{2}\ [\text{jump terms}]
//! (\frac{1}{2} (\frac{I_{3}}{h_{2}\, N_{3}^{2}} - \frac{I_{4}}{h_{2}\, N_{4}^{2}} - \frac{I_{l}}{h_{2}\, N_{4}^{2}})) \ddot{\theta_{2}} + (\frac{1}{4} (\frac{I_{3}}{h_{2}^{2}\, N_{3}^{2}} + \frac{I_{4}}{h_{2}^{2}\, N_{4}^{2}} + \frac{I_{l}}{h_{2}^{2}\, N_{4}^{2}})) \ddot{s_{2}} + (\frac{I_{l}}{2\, h_{2}\, N_{4}}) \ddot{\psi_{l}} = \frac{k_{c}\, \mathrm{twist}_{c}}{2\, h_{2}\, N_{3}} - k_{34}\, \mathrm{touch}_{34}\, \mathrm{over}_{34} - k_{34}\, \mathrm{touch}_{34}\, \mathrm{clip}_{34}\, \mathrm{over}_{34}\ [\text{backlash}] + \frac{T_{load}}{2\, h_{2}\, N_{4}}\ [\text{torques}] + \frac{I_{4}\, \alpha_{M}\, \dot{\theta_{2}}}{2\, h_{2}\, N_{4}^{2}} - \beta_{K}\, \bar{k_{34}}\, \mathrm{damp}_{34}\, \dot{\mathrm{over}_{34}} - \frac{I_{3}\, \alpha_{M}\, \dot{s_{2}}}{4\, h_{2}^{2}\, N_{3}^{2}} - \frac{I_{4}\, \alpha_{M}\, \dot{s_{2}}}{4\, h_{2}^{2}\, N_{4}^{2}} - \frac{I_{l}\, \alpha_{M}\, \dot{s_{2}}}{4\, h_{2}^{2}\, N_{4}^{2}} - \frac{I_{3}\, \alpha_{M}\, \dot{\theta_{2}}}{2\, h_{2}\, N_{3}^{2}} + \frac{I_{l}\, \alpha_{M}\, \dot{\theta_{2}}}{2\, h_{2}\, N_{4}^{2}} - \frac{I_{l}\, \alpha_{M}\, \dot{\psi_{l}}}{2\, h_{2}\, N_{4}} + \frac{\beta_{K}\, k_{c}\, \dot{\mathrm{twist}_{c}}}{2\, h_{2}\, N_{3}}\ [\text{damping}]
//! (\frac{I_{m}}{N_{1}}) \ddot{\theta_{1}} + (\frac{I_{m}}{2\, h_{1}\, N_{1}}) \ddot{s_{1}} + (I_{m}) \ddot{\psi_{m}} = -k_{m}\, \psi_{m} + T_{motor}\ [\text{torques}] - I_{m}\, \alpha_{M}\, \dot{\psi_{m}} - \frac{I_{m}\, \alpha_{M}\, \dot{\theta_{1}}}{N_{1}} - \beta_{K}\, k_{m}\, \dot{\psi_{m}} - \frac{I_{m}\, \alpha_{M}\, \dot{s_{1}}}{2\, h_{1}\, N_{1}}\ [\text{damping}]
//! (-\frac{I_{l}}{N_{4}}) \ddot{\theta_{2}} + (\frac{I_{l}}{2\, h_{2}\, N_{4}}) \ddot{s_{2}} + (I_{l}) \ddot{\psi_{l}} = -k_{l}\, \psi_{l} + T_{load}\ [\text{torques}] + \frac{I_{l}\, \alpha_{M}\, \dot{\theta_{2}}}{N_{4}} - I_{l}\, \alpha_{M}\, \dot{\psi_{l}} - \beta_{K}\, k_{l}\, \dot{\psi_{l}} - \frac{I_{l}\, \alpha_{M}\, \dot{s_{2}}}{2\, h_{2}\, N_{4}}\ [\text{damping}]
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects; q'.dD/dq' includes the power of clipped damper forces
//! - M is symmetric
//! - T = q'.M q'/2, with M as written
//! - M is positive definite: T is a sum of squares that vanish together only at rest
//! - at a step of k12, k34: T+ - T- = (v+² - v²)/(2 G) for any v+, where M d = n/G; V+ - V- = dV as written; so T + V is unchanged in transmission (v+² = v² - 2 G dV) and in reflection (v+ = -v, dV = 0)
//! - V is the same on both sides of the edges of over12: no impulse there
//! - V is the same on both sides of the edges of over34: no impulse there
//! - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
//! - the damper of over12, clipped to the force F = dV/dover12 of its spring, takes energy or none: clip12 F over12_dot >= 0, since F over12 >= 0, over12_dot dD/dover12_dot >= 0 and, where it is clipped, clip12 over12 dD/dover12_dot >= F over12
//! - the damper of over34, clipped to the force F = dV/dover34 of its spring, takes energy or none: clip34 F over34_dot >= 0, since F over34 >= 0, over34_dot dD/dover34_dot >= 0 and, where it is clipped, clip34 over34 dD/dover34_dot >= F over34
//! - every deflection equals the linear form by which the equations differentiate it
//! - without the jump terms the balance fails: energy is created at the rate (dk12*touch12*over12^2*theta1_dot + dk34*touch34*over34^2*theta2_dot)/2
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | constants (once a scene) | 0 | 2 | 0 |
//! | force | 38 | 240 | 0 |
//! | energy step of k12 | 0 | 4 | 0 |
//! | energy step of k34 | 0 | 4 | 0 |

use gearsim_macros::equations;

equations! {
    model two_stage "a two-stage gearbox with a countershaft";
    source "standard torsional model; phases as Oh, Grosh & Barber (2005)";

    coordinates {
        theta1 "rad" start 0.0, "mean rotation of gears 1 and 2; one pitch is 2 pi";
        s1 "m" start static, "motion of gear 1 relative to gear 2 along the line of action";
        theta2 "rad" start static, "mean rotation of gears 3 and 4; one pitch is 2 pi";
        s2 "m" start static, "motion of gear 3 relative to gear 4 along the line of action";
        psi_m "rad" start static, "twist of the motor's shaft";
        psi_l "rad" start static, "twist of the load's shaft";
    }
    parameters {
        N1 "1" required, open 0.0 to inf, "number of teeth of gear 1";
        N2 "1" required, open 0.0 to inf, "number of teeth of gear 2";
        r1 "m" required, open 0.0 to inf, "base radius of gear 1";
        N3 "1" required, open 0.0 to inf, "number of teeth of gear 3";
        N4 "1" required, open 0.0 to inf, "number of teeth of gear 4";
        r3 "m" required, open 0.0 to inf, "base radius of gear 3";
        I_m "kg*m^2" required, open 0.0 to inf, "moment of inertia of the motor";
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the gear 1";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the gear 2";
        I3 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the gear 3";
        I4 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the gear 4";
        I_l "kg*m^2" required, open 0.0 to inf, "moment of inertia of the load";
        k_m "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the motor's shaft";
        k_c "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the countershaft";
        k_l "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the load's shaft";
        b12 "m" required with backlash, open 0.0 to inf, "backlash of the mesh of gears 1 and 2: no contact within b/2 to either side";
        b34 "m" required with backlash, open 0.0 to inf, "backlash of the mesh of gears 3 and 4: no contact within b/2 to either side";
        T_motor "N*m" required, open -inf to inf, "driving torque of the motor";
        T_load "N*m" required, open -inf to inf, "load torque of the load, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
        k12 "N/m" phase theta1 period 6.283185307179586, "stiffness of the mesh of gears 1 and 2 along the line of action";
        k34 "N/m" phase theta2 period 6.283185307179586, "stiffness of the mesh of gears 3 and 4 along the line of action";
    }
    motions {
        speed "rad/s" { theta1_dot = N1; theta2_dot = N1*N3/N2; }, "rotational speed of the first gear";
    }
    effects {
        stiffness_step "the mesh stiffness steps as tooth pairs enter and leave, with the jump terms that conserve energy; without it the stiffness is constant at its mid value";
        rigid_kinematics requires(stiffness_step) excludes(frozen_phase) "drops the jump terms: speeds pass a step unchanged, and energy is not conserved";
        frozen_phase requires(stiffness_step) excludes(rigid_kinematics) "steps at the times of a steady rotation, k(Omega0 t) instead of k(theta): the classical equations";
        backlash "play between the flanks: contact on the drive or coast flank, free motion between";
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
        jump_terms = stiffness_step, !rigid_kinematics, !frozen_phase;
        moving_phase = stiffness_step, !frozen_phase;
        backlash_and_moving_phase = backlash, stiffness_step, !frozen_phase;
    }

    constants {
        h1 = r1/N1;
        h2 = r3/N3;
    }
    deflections {
        twist_c = theta1/N2 - s1/(2.0*h1*N2) - s2/(2.0*h2*N3) - theta2/N3;
        over12 = s1 - edge12;
        over34 = s2 - edge34;
    }
    dead_bands {
        over12 "m" (touch12, edge12, damp12, clip12) half b12/2.0 with backlash, "play of the mesh of gears 1 and 2";
        over34 "m" (touch34, edge34, damp34, clip34) half b34/2.0 with backlash, "play of the mesh of gears 3 and 4";
    }
    energies {
        kinetic {
            _ => (I1*(s1_dot/(2.0*h1*N1) + theta1_dot/N1).powi(2) + I2*(theta1_dot/N2 - s1_dot/(2.0*h1*N2)).powi(2) + I3*(s2_dot/(2.0*h2*N3) + theta2_dot/N3).powi(2) + I4*(theta2_dot/N4 - s2_dot/(2.0*h2*N4)).powi(2) + I_l*(theta2_dot/N4 - psi_l_dot - s2_dot/(2.0*h2*N4)).powi(2) + I_m*(psi_m_dot + s1_dot/(2.0*h1*N1) + theta1_dot/N1).powi(2))/2.0;
        }
        potential {
            _ => (k_c*twist_c.powi(2) + k_l*psi_l.powi(2) + k_m*psi_m.powi(2) + k12*touch12*over12.powi(2) + k34*touch34*over34.powi(2))/2.0;
        }
        dissipation {
            damping => (I1*alpha_M*(s1_dot/(2.0*h1*N1) + theta1_dot/N1).powi(2) + I2*alpha_M*(theta1_dot/N2 - s1_dot/(2.0*h1*N2)).powi(2) + I3*alpha_M*(s2_dot/(2.0*h2*N3) + theta2_dot/N3).powi(2) + I4*alpha_M*(theta2_dot/N4 - s2_dot/(2.0*h2*N4)).powi(2) + I_l*alpha_M*(theta2_dot/N4 - psi_l_dot - s2_dot/(2.0*h2*N4)).powi(2) + I_m*alpha_M*(psi_m_dot + s1_dot/(2.0*h1*N1) + theta1_dot/N1).powi(2) + beta_K*k_c*twist_c_dot.powi(2) + beta_K*k_l*psi_l_dot.powi(2) + beta_K*k_m*psi_m_dot.powi(2) + beta_K*k12_mid*damp12*over12_dot.powi(2) + beta_K*k34_mid*damp34*over34_dot.powi(2))/2.0;
        }
    }
    torques {
        motor "driving torque of the motor" {
            torques => T_motor*(psi_m + s1/(2.0*h1*N1) + theta1/N1);
        }
        load "load torque of the load, against its rotation" {
            torques => T_load*(psi_l + s2/(2.0*h2*N4) - theta2/N4);
        }
    }
    work {
        theta1 {
            torques => T_motor/N1;
        }
        s1 {
            torques => T_motor/(2.0*h1*N1);
        }
        theta2 {
            torques => -T_load/N4;
        }
        s2 {
            torques => T_load/(2.0*h2*N4);
        }
        psi_m {
            torques => T_motor;
        }
        psi_l {
            torques => T_load;
        }
    }
    mass {
        theta1 theta1 {
            _ => I1/N1.powi(2) + I2/N2.powi(2) + I_m/N1.powi(2);
        }
        theta1 s1 {
            _ => (I1/(h1*N1.powi(2)) - I2/(h1*N2.powi(2)) + I_m/(h1*N1.powi(2)))/2.0;
        }
        theta1 psi_m {
            _ => I_m/N1;
        }
        s1 s1 {
            _ => (I1/(h1.powi(2)*N1.powi(2)) + I2/(h1.powi(2)*N2.powi(2)) + I_m/(h1.powi(2)*N1.powi(2)))/4.0;
        }
        s1 psi_m {
            _ => I_m/(2.0*h1*N1);
        }
        theta2 theta2 {
            _ => I3/N3.powi(2) + I4/N4.powi(2) + I_l/N4.powi(2);
        }
        theta2 s2 {
            _ => (I3/(h2*N3.powi(2)) - I4/(h2*N4.powi(2)) - I_l/(h2*N4.powi(2)))/2.0;
        }
        theta2 psi_l {
            _ => -I_l/N4;
        }
        s2 s2 {
            _ => (I3/(h2.powi(2)*N3.powi(2)) + I4/(h2.powi(2)*N4.powi(2)) + I_l/(h2.powi(2)*N4.powi(2)))/4.0;
        }
        s2 psi_l {
            _ => I_l/(2.0*h2*N4);
        }
        psi_m psi_m {
            _ => I_m;
        }
        psi_l psi_l {
            _ => I_l;
        }
    }
    force {
        theta1 {
            _ => -k_c*twist_c/N2;
            torques => T_motor/N1;
            damping => I2*alpha_M*s1_dot/(2.0*h1*N2.powi(2)) - I1*alpha_M*theta1_dot/N1.powi(2) - I2*alpha_M*theta1_dot/N2.powi(2) - I_m*alpha_M*theta1_dot/N1.powi(2) - I_m*alpha_M*psi_m_dot/N1 - I1*alpha_M*s1_dot/(2.0*h1*N1.powi(2)) - I_m*alpha_M*s1_dot/(2.0*h1*N1.powi(2)) - beta_K*k_c*twist_c_dot/N2;
            jump_terms => -dk12*touch12*over12.powi(2)/2.0;
        }
        s1 {
            _ => k_c*twist_c/(2.0*h1*N2) - k12*touch12*over12;
            backlash => -k12*touch12*clip12*over12;
            torques => T_motor/(2.0*h1*N1);
            damping => I2*alpha_M*theta1_dot/(2.0*h1*N2.powi(2)) - beta_K*k12_mid*damp12*over12_dot - I1*alpha_M*s1_dot/(4.0*h1.powi(2)*N1.powi(2)) - I2*alpha_M*s1_dot/(4.0*h1.powi(2)*N2.powi(2)) - I_m*alpha_M*s1_dot/(4.0*h1.powi(2)*N1.powi(2)) - I1*alpha_M*theta1_dot/(2.0*h1*N1.powi(2)) - I_m*alpha_M*theta1_dot/(2.0*h1*N1.powi(2)) - I_m*alpha_M*psi_m_dot/(2.0*h1*N1) + beta_K*k_c*twist_c_dot/(2.0*h1*N2);
        }
        theta2 {
            _ => k_c*twist_c/N3;
            torques => -T_load/N4;
            damping => I_l*alpha_M*psi_l_dot/N4 - I3*alpha_M*theta2_dot/N3.powi(2) - I4*alpha_M*theta2_dot/N4.powi(2) - I_l*alpha_M*theta2_dot/N4.powi(2) - I3*alpha_M*s2_dot/(2.0*h2*N3.powi(2)) + I4*alpha_M*s2_dot/(2.0*h2*N4.powi(2)) + I_l*alpha_M*s2_dot/(2.0*h2*N4.powi(2)) + beta_K*k_c*twist_c_dot/N3;
            jump_terms => -dk34*touch34*over34.powi(2)/2.0;
        }
        s2 {
            _ => k_c*twist_c/(2.0*h2*N3) - k34*touch34*over34;
            backlash => -k34*touch34*clip34*over34;
            torques => T_load/(2.0*h2*N4);
            damping => I4*alpha_M*theta2_dot/(2.0*h2*N4.powi(2)) - beta_K*k34_mid*damp34*over34_dot - I3*alpha_M*s2_dot/(4.0*h2.powi(2)*N3.powi(2)) - I4*alpha_M*s2_dot/(4.0*h2.powi(2)*N4.powi(2)) - I_l*alpha_M*s2_dot/(4.0*h2.powi(2)*N4.powi(2)) - I3*alpha_M*theta2_dot/(2.0*h2*N3.powi(2)) + I_l*alpha_M*theta2_dot/(2.0*h2*N4.powi(2)) - I_l*alpha_M*psi_l_dot/(2.0*h2*N4) + beta_K*k_c*twist_c_dot/(2.0*h2*N3);
        }
        psi_m {
            _ => -k_m*psi_m;
            torques => T_motor;
            damping => -I_m*alpha_M*psi_m_dot - I_m*alpha_M*theta1_dot/N1 - beta_K*k_m*psi_m_dot - I_m*alpha_M*s1_dot/(2.0*h1*N1);
        }
        psi_l {
            _ => -k_l*psi_l;
            torques => T_load;
            damping => I_l*alpha_M*theta2_dot/N4 - I_l*alpha_M*psi_l_dot - beta_K*k_l*psi_l_dot - I_l*alpha_M*s2_dot/(2.0*h2*N4);
        }
    }
    jacobian {
        theta1 theta1 {
            _ => -k_c/N2.powi(2);
            jump_terms => -ddk12*touch12*over12.powi(2)/2.0;
        }
        theta1 s1 {
            _ => k_c/(2.0*h1*N2.powi(2));
            jump_terms => -dk12*touch12*over12;
        }
        theta1 theta2 {
            _ => k_c/(N2*N3);
        }
        theta1 s2 {
            _ => k_c/(2.0*h2*N2*N3);
        }
        theta1 theta1_dot {
            damping => -I1*alpha_M/N1.powi(2) - I2*alpha_M/N2.powi(2) - I_m*alpha_M/N1.powi(2) - beta_K*k_c/N2.powi(2);
        }
        theta1 s1_dot {
            damping => (I2*alpha_M/(h1*N2.powi(2)) - I1*alpha_M/(h1*N1.powi(2)) - I_m*alpha_M/(h1*N1.powi(2)) + beta_K*k_c/(h1*N2.powi(2)))/2.0;
        }
        theta1 theta2_dot {
            damping => beta_K*k_c/(N2*N3);
        }
        theta1 s2_dot {
            damping => beta_K*k_c/(2.0*h2*N2*N3);
        }
        theta1 psi_m_dot {
            damping => -I_m*alpha_M/N1;
        }
        s1 theta1 {
            _ => k_c/(2.0*h1*N2.powi(2));
            backlash_and_moving_phase => -dk12*touch12*clip12*over12;
            moving_phase => -dk12*touch12*over12;
        }
        s1 s1 {
            _ => -k12*touch12 - k_c/(4.0*h1.powi(2)*N2.powi(2));
            backlash => -k12*touch12*clip12;
        }
        s1 theta2 {
            _ => -k_c/(2.0*h1*N2*N3);
        }
        s1 s2 {
            _ => -k_c/(4.0*h1*h2*N2*N3);
        }
        s1 theta1_dot {
            damping => (I2*alpha_M/(h1*N2.powi(2)) - I1*alpha_M/(h1*N1.powi(2)) - I_m*alpha_M/(h1*N1.powi(2)) + beta_K*k_c/(h1*N2.powi(2)))/2.0;
        }
        s1 s1_dot {
            damping => -beta_K*k12_mid*damp12 - I1*alpha_M/(4.0*h1.powi(2)*N1.powi(2)) - I2*alpha_M/(4.0*h1.powi(2)*N2.powi(2)) - I_m*alpha_M/(4.0*h1.powi(2)*N1.powi(2)) - beta_K*k_c/(4.0*h1.powi(2)*N2.powi(2));
        }
        s1 theta2_dot {
            damping => -beta_K*k_c/(2.0*h1*N2*N3);
        }
        s1 s2_dot {
            damping => -beta_K*k_c/(4.0*h1*h2*N2*N3);
        }
        s1 psi_m_dot {
            damping => -I_m*alpha_M/(2.0*h1*N1);
        }
        theta2 theta1 {
            _ => k_c/(N2*N3);
        }
        theta2 s1 {
            _ => -k_c/(2.0*h1*N2*N3);
        }
        theta2 theta2 {
            _ => -k_c/N3.powi(2);
            jump_terms => -ddk34*touch34*over34.powi(2)/2.0;
        }
        theta2 s2 {
            _ => -k_c/(2.0*h2*N3.powi(2));
            jump_terms => -dk34*touch34*over34;
        }
        theta2 theta1_dot {
            damping => beta_K*k_c/(N2*N3);
        }
        theta2 s1_dot {
            damping => -beta_K*k_c/(2.0*h1*N2*N3);
        }
        theta2 theta2_dot {
            damping => -I3*alpha_M/N3.powi(2) - I4*alpha_M/N4.powi(2) - I_l*alpha_M/N4.powi(2) - beta_K*k_c/N3.powi(2);
        }
        theta2 s2_dot {
            damping => (I4*alpha_M/(h2*N4.powi(2)) - I3*alpha_M/(h2*N3.powi(2)) + I_l*alpha_M/(h2*N4.powi(2)) - beta_K*k_c/(h2*N3.powi(2)))/2.0;
        }
        theta2 psi_l_dot {
            damping => I_l*alpha_M/N4;
        }
        s2 theta1 {
            _ => k_c/(2.0*h2*N2*N3);
        }
        s2 s1 {
            _ => -k_c/(4.0*h1*h2*N2*N3);
        }
        s2 theta2 {
            _ => -k_c/(2.0*h2*N3.powi(2));
            backlash_and_moving_phase => -dk34*touch34*clip34*over34;
            moving_phase => -dk34*touch34*over34;
        }
        s2 s2 {
            _ => -k34*touch34 - k_c/(4.0*h2.powi(2)*N3.powi(2));
            backlash => -k34*touch34*clip34;
        }
        s2 theta1_dot {
            damping => beta_K*k_c/(2.0*h2*N2*N3);
        }
        s2 s1_dot {
            damping => -beta_K*k_c/(4.0*h1*h2*N2*N3);
        }
        s2 theta2_dot {
            damping => (I4*alpha_M/(h2*N4.powi(2)) - I3*alpha_M/(h2*N3.powi(2)) + I_l*alpha_M/(h2*N4.powi(2)) - beta_K*k_c/(h2*N3.powi(2)))/2.0;
        }
        s2 s2_dot {
            damping => -beta_K*k34_mid*damp34 - I3*alpha_M/(4.0*h2.powi(2)*N3.powi(2)) - I4*alpha_M/(4.0*h2.powi(2)*N4.powi(2)) - I_l*alpha_M/(4.0*h2.powi(2)*N4.powi(2)) - beta_K*k_c/(4.0*h2.powi(2)*N3.powi(2));
        }
        s2 psi_l_dot {
            damping => -I_l*alpha_M/(2.0*h2*N4);
        }
        psi_m psi_m {
            _ => -k_m;
        }
        psi_m theta1_dot {
            damping => -I_m*alpha_M/N1;
        }
        psi_m s1_dot {
            damping => -I_m*alpha_M/(2.0*h1*N1);
        }
        psi_m psi_m_dot {
            damping => -I_m*alpha_M - beta_K*k_m;
        }
        psi_l psi_l {
            _ => -k_l;
        }
        psi_l theta2_dot {
            damping => I_l*alpha_M/N4;
        }
        psi_l s2_dot {
            damping => -I_l*alpha_M/(2.0*h2*N4);
        }
        psi_l psi_l_dot {
            damping => -I_l*alpha_M - beta_K*k_l;
        }
    }
    cell {
        stiffness {
            theta1 theta1 {
                _ => k_c/N2.powi(2);
            }
            theta1 s1 {
                _ => -k_c/(2.0*h1*N2.powi(2));
            }
            theta1 theta2 {
                _ => -k_c/(N2*N3);
            }
            theta1 s2 {
                _ => -k_c/(2.0*h2*N2*N3);
            }
            s1 s1 {
                _ => k12*touch12 + k_c/(4.0*h1.powi(2)*N2.powi(2));
                backlash => k12*touch12*clip12;
            }
            s1 theta2 {
                _ => k_c/(2.0*h1*N2*N3);
            }
            s1 s2 {
                _ => k_c/(4.0*h1*h2*N2*N3);
            }
            theta2 theta2 {
                _ => k_c/N3.powi(2);
            }
            theta2 s2 {
                _ => k_c/(2.0*h2*N3.powi(2));
            }
            s2 s2 {
                _ => k34*touch34 + k_c/(4.0*h2.powi(2)*N3.powi(2));
                backlash => k34*touch34*clip34;
            }
            psi_m psi_m {
                _ => k_m;
            }
            psi_l psi_l {
                _ => k_l;
            }
        }
        damping {
            theta1 theta1 {
                damping => I1*alpha_M/N1.powi(2) + I2*alpha_M/N2.powi(2) + I_m*alpha_M/N1.powi(2) + beta_K*k_c/N2.powi(2);
            }
            theta1 s1 {
                damping => (I1*alpha_M/(h1*N1.powi(2)) - I2*alpha_M/(h1*N2.powi(2)) + I_m*alpha_M/(h1*N1.powi(2)) - beta_K*k_c/(h1*N2.powi(2)))/2.0;
            }
            theta1 theta2 {
                damping => -beta_K*k_c/(N2*N3);
            }
            theta1 s2 {
                damping => -beta_K*k_c/(2.0*h2*N2*N3);
            }
            theta1 psi_m {
                damping => I_m*alpha_M/N1;
            }
            s1 s1 {
                damping => beta_K*k12_mid*damp12 + I1*alpha_M/(4.0*h1.powi(2)*N1.powi(2)) + I2*alpha_M/(4.0*h1.powi(2)*N2.powi(2)) + I_m*alpha_M/(4.0*h1.powi(2)*N1.powi(2)) + beta_K*k_c/(4.0*h1.powi(2)*N2.powi(2));
            }
            s1 theta2 {
                damping => beta_K*k_c/(2.0*h1*N2*N3);
            }
            s1 s2 {
                damping => beta_K*k_c/(4.0*h1*h2*N2*N3);
            }
            s1 psi_m {
                damping => I_m*alpha_M/(2.0*h1*N1);
            }
            theta2 theta2 {
                damping => I3*alpha_M/N3.powi(2) + I4*alpha_M/N4.powi(2) + I_l*alpha_M/N4.powi(2) + beta_K*k_c/N3.powi(2);
            }
            theta2 s2 {
                damping => (I3*alpha_M/(h2*N3.powi(2)) - I4*alpha_M/(h2*N4.powi(2)) - I_l*alpha_M/(h2*N4.powi(2)) + beta_K*k_c/(h2*N3.powi(2)))/2.0;
            }
            theta2 psi_l {
                damping => -I_l*alpha_M/N4;
            }
            s2 s2 {
                damping => beta_K*k34_mid*damp34 + I3*alpha_M/(4.0*h2.powi(2)*N3.powi(2)) + I4*alpha_M/(4.0*h2.powi(2)*N4.powi(2)) + I_l*alpha_M/(4.0*h2.powi(2)*N4.powi(2)) + beta_K*k_c/(4.0*h2.powi(2)*N3.powi(2));
            }
            s2 psi_l {
                damping => I_l*alpha_M/(2.0*h2*N4);
            }
            psi_m psi_m {
                damping => I_m*alpha_M + beta_K*k_m;
            }
            psi_l psi_l {
                damping => I_l*alpha_M + beta_K*k_l;
            }
        }
        load {
            theta1 {
                torques => T_motor/N1;
            }
            s1 {
                _ => k12*touch12*edge12;
                backlash => k12*touch12*clip12*edge12;
                torques => T_motor/(2.0*h1*N1);
            }
            theta2 {
                torques => -T_load/N4;
            }
            s2 {
                _ => k34*touch34*edge34;
                backlash => k34*touch34*clip34*edge34;
                torques => T_load/(2.0*h2*N4);
            }
            psi_m {
                torques => T_motor;
            }
            psi_l {
                torques => T_load;
            }
        }
    }
    jump k12 {
        normal {
            theta1 {
                _ => 1.0;
            }
        }
        step {
            _ => dk12*touch12*over12.powi(2)/2.0;
        }
    }
    jump k34 {
        normal {
            theta2 {
                _ => 1.0;
            }
        }
        step {
            _ => dk34*touch34*over34.powi(2)/2.0;
        }
    }

    text {
        "T = (I1*(s1_dot/(2*h1*N1) + theta1_dot/N1)^2 + I2*(theta1_dot/N2 - s1_dot/(2*h1*N2))^2 + I3*(s2_dot/(2*h2*N3) + theta2_dot/N3)^2 + I4*(theta2_dot/N4 - s2_dot/(2*h2*N4))^2 + I_l*(theta2_dot/N4 - psi_l_dot - s2_dot/(2*h2*N4))^2 + I_m*(psi_m_dot + s1_dot/(2*h1*N1) + theta1_dot/N1)^2)/2";
        "V = (k_c*twist_c^2 + k_l*psi_l^2 + k_m*psi_m^2 + k12*touch12*over12^2 + k34*touch34*over34^2)/2";
        "D = (I1*alpha_M*(s1_dot/(2*h1*N1) + theta1_dot/N1)^2 + I2*alpha_M*(theta1_dot/N2 - s1_dot/(2*h1*N2))^2 + I3*alpha_M*(s2_dot/(2*h2*N3) + theta2_dot/N3)^2 + I4*alpha_M*(theta2_dot/N4 - s2_dot/(2*h2*N4))^2 + I_l*alpha_M*(theta2_dot/N4 - psi_l_dot - s2_dot/(2*h2*N4))^2 + I_m*alpha_M*(psi_m_dot + s1_dot/(2*h1*N1) + theta1_dot/N1)^2 + beta_K*k_c*twist_c_dot^2 + beta_K*k_l*psi_l_dot^2 + beta_K*k_m*psi_m_dot^2 + beta_K*k12_mid*damp12*over12_dot^2 + beta_K*k34_mid*damp34*over34_dot^2)/2 [damping]";
        "Q_theta1 = T_motor/N1 [torques]";
        "Q_s1 = T_motor/(2*h1*N1) [torques]";
        "Q_theta2 = -T_load/N4 [torques]";
        "Q_s2 = T_load/(2*h2*N4) [torques]";
        "Q_psi_m = T_motor [torques]";
        "Q_psi_l = T_load [torques]";
        "h1 = r1/N1";
        "h2 = r3/N3";
        "twist_c = theta1/N2 - s1/(2*h1*N2) - s2/(2*h2*N3) - theta2/N3";
        "over12 = s1 - edge12";
        "over34 = s2 - edge34";
        "touch12 = 1 in contact, beyond edge12 = b12/2 or -b12/2; touch12 = 0 between the edges; without backlash touch12 = 1 and edge12 = 0";
        "damp12 = 1 and clip12 = 0 in contact while the damper force is less than the spring force, else damp12 = 0:";
        "  clip12 = 1 if the damper would push more than the spring: its force is limited to the spring force";
        "  clip12 = -1 if the damper would pull more than the spring pushes: the contact force is zero";
        "touch34 = 1 in contact, beyond edge34 = b34/2 or -b34/2; touch34 = 0 between the edges; without backlash touch34 = 1 and edge34 = 0";
        "damp34 = 1 and clip34 = 0 in contact while the damper force is less than the spring force, else damp34 = 0:";
        "  clip34 = 1 if the damper would push more than the spring: its force is limited to the spring force";
        "  clip34 = -1 if the damper would pull more than the spring pushes: the contact force is zero";
        "(I1/N1^2 + I2/N2^2 + I_m/N1^2) theta1'' + ((I1/(h1*N1^2) - I2/(h1*N2^2) + I_m/(h1*N1^2))/2) s1'' + (I_m/N1) psi_m'' = -k_c*twist_c/N2 + T_motor/N1 [torques] + I2*alpha_M*s1_dot/(2*h1*N2^2) - I1*alpha_M*theta1_dot/N1^2 - I2*alpha_M*theta1_dot/N2^2 - I_m*alpha_M*theta1_dot/N1^2 - I_m*alpha_M*psi_m_dot/N1 - I1*alpha_M*s1_dot/(2*h1*N1^2) - I_m*alpha_M*s1_dot/(2*h1*N1^2) - beta_K*k_c*twist_c_dot/N2 [damping] - dk12*touch12*over12^2/2 [jump terms]";
        "((I1/(h1*N1^2) - I2/(h1*N2^2) + I_m/(h1*N1^2))/2) theta1'' + ((I1/(h1^2*N1^2) + I2/(h1^2*N2^2) + I_m/(h1^2*N1^2))/4) s1'' + (I_m/(2*h1*N1)) psi_m'' = k_c*twist_c/(2*h1*N2) - k12*touch12*over12 - k12*touch12*clip12*over12 [backlash] + T_motor/(2*h1*N1) [torques] + I2*alpha_M*theta1_dot/(2*h1*N2^2) - beta_K*k12_mid*damp12*over12_dot - I1*alpha_M*s1_dot/(4*h1^2*N1^2) - I2*alpha_M*s1_dot/(4*h1^2*N2^2) - I_m*alpha_M*s1_dot/(4*h1^2*N1^2) - I1*alpha_M*theta1_dot/(2*h1*N1^2) - I_m*alpha_M*theta1_dot/(2*h1*N1^2) - I_m*alpha_M*psi_m_dot/(2*h1*N1) + beta_K*k_c*twist_c_dot/(2*h1*N2) [damping]";
        "(I3/N3^2 + I4/N4^2 + I_l/N4^2) theta2'' + ((I3/(h2*N3^2) - I4/(h2*N4^2) - I_l/(h2*N4^2))/2) s2'' + (-I_l/N4) psi_l'' = k_c*twist_c/N3 - T_load/N4 [torques] + I_l*alpha_M*psi_l_dot/N4 - I3*alpha_M*theta2_dot/N3^2 - I4*alpha_M*theta2_dot/N4^2 - I_l*alpha_M*theta2_dot/N4^2 - I3*alpha_M*s2_dot/(2*h2*N3^2) + I4*alpha_M*s2_dot/(2*h2*N4^2) + I_l*alpha_M*s2_dot/(2*h2*N4^2) + beta_K*k_c*twist_c_dot/N3 [damping] - dk34*touch34*over34^2/2 [jump terms]";
        "((I3/(h2*N3^2) - I4/(h2*N4^2) - I_l/(h2*N4^2))/2) theta2'' + ((I3/(h2^2*N3^2) + I4/(h2^2*N4^2) + I_l/(h2^2*N4^2))/4) s2'' + (I_l/(2*h2*N4)) psi_l'' = k_c*twist_c/(2*h2*N3) - k34*touch34*over34 - k34*touch34*clip34*over34 [backlash] + T_load/(2*h2*N4) [torques] + I4*alpha_M*theta2_dot/(2*h2*N4^2) - beta_K*k34_mid*damp34*over34_dot - I3*alpha_M*s2_dot/(4*h2^2*N3^2) - I4*alpha_M*s2_dot/(4*h2^2*N4^2) - I_l*alpha_M*s2_dot/(4*h2^2*N4^2) - I3*alpha_M*theta2_dot/(2*h2*N3^2) + I_l*alpha_M*theta2_dot/(2*h2*N4^2) - I_l*alpha_M*psi_l_dot/(2*h2*N4) + beta_K*k_c*twist_c_dot/(2*h2*N3) [damping]";
        "(I_m/N1) theta1'' + (I_m/(2*h1*N1)) s1'' + (I_m) psi_m'' = -k_m*psi_m + T_motor [torques] - I_m*alpha_M*psi_m_dot - I_m*alpha_M*theta1_dot/N1 - beta_K*k_m*psi_m_dot - I_m*alpha_M*s1_dot/(2*h1*N1) [damping]";
        "(-I_l/N4) theta2'' + (I_l/(2*h2*N4)) s2'' + (I_l) psi_l'' = -k_l*psi_l + T_load [torques] + I_l*alpha_M*theta2_dot/N4 - I_l*alpha_M*psi_l_dot - beta_K*k_l*psi_l_dot - I_l*alpha_M*s2_dot/(2*h2*N4) [damping]";
        "at a step dk12 of k12 in theta1: v+^2 = v-^2 - 2*G*(dk12*touch12*over12^2/2)";
        "at a step dk34 of k34 in theta2: v+^2 = v-^2 - 2*G*(dk34*touch34*over34^2/2)";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
    }
    latex {
        "T = \\frac{1}{2} (I_{1}\\, \\left(\\frac{\\dot{s_{1}}}{2\\, h_{1}\\, N_{1}} + \\frac{\\dot{\\theta_{1}}}{N_{1}}\\right)^{2} + I_{2}\\, \\left(\\frac{\\dot{\\theta_{1}}}{N_{2}} - \\frac{\\dot{s_{1}}}{2\\, h_{1}\\, N_{2}}\\right)^{2} + I_{3}\\, \\left(\\frac{\\dot{s_{2}}}{2\\, h_{2}\\, N_{3}} + \\frac{\\dot{\\theta_{2}}}{N_{3}}\\right)^{2} + I_{4}\\, \\left(\\frac{\\dot{\\theta_{2}}}{N_{4}} - \\frac{\\dot{s_{2}}}{2\\, h_{2}\\, N_{4}}\\right)^{2} + I_{l}\\, \\left(\\frac{\\dot{\\theta_{2}}}{N_{4}} - \\dot{\\psi_{l}} - \\frac{\\dot{s_{2}}}{2\\, h_{2}\\, N_{4}}\\right)^{2} + I_{m}\\, \\left(\\dot{\\psi_{m}} + \\frac{\\dot{s_{1}}}{2\\, h_{1}\\, N_{1}} + \\frac{\\dot{\\theta_{1}}}{N_{1}}\\right)^{2})";
        "V = \\frac{1}{2} (k_{c}\\, \\mathrm{twist}_{c}^{2} + k_{l}\\, \\psi_{l}^{2} + k_{m}\\, \\psi_{m}^{2} + k_{12}\\, \\mathrm{touch}_{12}\\, \\mathrm{over}_{12}^{2} + k_{34}\\, \\mathrm{touch}_{34}\\, \\mathrm{over}_{34}^{2})";
        "D = \\frac{1}{2} (I_{1}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{s_{1}}}{2\\, h_{1}\\, N_{1}} + \\frac{\\dot{\\theta_{1}}}{N_{1}}\\right)^{2} + I_{2}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\theta_{1}}}{N_{2}} - \\frac{\\dot{s_{1}}}{2\\, h_{1}\\, N_{2}}\\right)^{2} + I_{3}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{s_{2}}}{2\\, h_{2}\\, N_{3}} + \\frac{\\dot{\\theta_{2}}}{N_{3}}\\right)^{2} + I_{4}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\theta_{2}}}{N_{4}} - \\frac{\\dot{s_{2}}}{2\\, h_{2}\\, N_{4}}\\right)^{2} + I_{l}\\, \\alpha_{M}\\, \\left(\\frac{\\dot{\\theta_{2}}}{N_{4}} - \\dot{\\psi_{l}} - \\frac{\\dot{s_{2}}}{2\\, h_{2}\\, N_{4}}\\right)^{2} + I_{m}\\, \\alpha_{M}\\, \\left(\\dot{\\psi_{m}} + \\frac{\\dot{s_{1}}}{2\\, h_{1}\\, N_{1}} + \\frac{\\dot{\\theta_{1}}}{N_{1}}\\right)^{2} + \\beta_{K}\\, k_{c}\\, \\dot{\\mathrm{twist}_{c}}^{2} + \\beta_{K}\\, k_{l}\\, \\dot{\\psi_{l}}^{2} + \\beta_{K}\\, k_{m}\\, \\dot{\\psi_{m}}^{2} + \\beta_{K}\\, \\bar{k_{12}}\\, \\mathrm{damp}_{12}\\, \\dot{\\mathrm{over}_{12}}^{2} + \\beta_{K}\\, \\bar{k_{34}}\\, \\mathrm{damp}_{34}\\, \\dot{\\mathrm{over}_{34}}^{2})\\ [\\text{damping}]";
        "Q_{\\theta_{1}} = \\frac{T_{motor}}{N_{1}}\\ [\\text{torques}]";
        "Q_{s_{1}} = \\frac{T_{motor}}{2\\, h_{1}\\, N_{1}}\\ [\\text{torques}]";
        "Q_{\\theta_{2}} = -\\frac{T_{load}}{N_{4}}\\ [\\text{torques}]";
        "Q_{s_{2}} = \\frac{T_{load}}{2\\, h_{2}\\, N_{4}}\\ [\\text{torques}]";
        "Q_{\\psi_{m}} = T_{motor}\\ [\\text{torques}]";
        "Q_{\\psi_{l}} = T_{load}\\ [\\text{torques}]";
        "h_{1} = \\frac{r_{1}}{N_{1}}";
        "h_{2} = \\frac{r_{3}}{N_{3}}";
        "\\mathrm{twist}_{c} = \\frac{\\theta_{1}}{N_{2}} - \\frac{s_{1}}{2\\, h_{1}\\, N_{2}} - \\frac{s_{2}}{2\\, h_{2}\\, N_{3}} - \\frac{\\theta_{2}}{N_{3}}";
        "\\mathrm{over}_{12} = s_{1} - \\mathrm{edge}_{12}";
        "\\mathrm{over}_{34} = s_{2} - \\mathrm{edge}_{34}";
        "(\\frac{I_{1}}{N_{1}^{2}} + \\frac{I_{2}}{N_{2}^{2}} + \\frac{I_{m}}{N_{1}^{2}}) \\ddot{\\theta_{1}} + (\\frac{1}{2} (\\frac{I_{1}}{h_{1}\\, N_{1}^{2}} - \\frac{I_{2}}{h_{1}\\, N_{2}^{2}} + \\frac{I_{m}}{h_{1}\\, N_{1}^{2}})) \\ddot{s_{1}} + (\\frac{I_{m}}{N_{1}}) \\ddot{\\psi_{m}} = -\\frac{k_{c}\\, \\mathrm{twist}_{c}}{N_{2}} + \\frac{T_{motor}}{N_{1}}\\ [\\text{torques}] + \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{s_{1}}}{2\\, h_{1}\\, N_{2}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}}{N_{1}^{2}} - \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}}{N_{2}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}}{N_{1}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\psi_{m}}}{N_{1}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{s_{1}}}{2\\, h_{1}\\, N_{1}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{s_{1}}}{2\\, h_{1}\\, N_{1}^{2}} - \\frac{\\beta_{K}\\, k_{c}\\, \\dot{\\mathrm{twist}_{c}}}{N_{2}}\\ [\\text{damping}] - \\frac{k_{12}'\\, \\mathrm{touch}_{12}\\, \\mathrm{over}_{12}^{2}}{2}\\ [\\text{jump terms}]";
        "(\\frac{1}{2} (\\frac{I_{1}}{h_{1}\\, N_{1}^{2}} - \\frac{I_{2}}{h_{1}\\, N_{2}^{2}} + \\frac{I_{m}}{h_{1}\\, N_{1}^{2}})) \\ddot{\\theta_{1}} + (\\frac{1}{4} (\\frac{I_{1}}{h_{1}^{2}\\, N_{1}^{2}} + \\frac{I_{2}}{h_{1}^{2}\\, N_{2}^{2}} + \\frac{I_{m}}{h_{1}^{2}\\, N_{1}^{2}})) \\ddot{s_{1}} + (\\frac{I_{m}}{2\\, h_{1}\\, N_{1}}) \\ddot{\\psi_{m}} = \\frac{k_{c}\\, \\mathrm{twist}_{c}}{2\\, h_{1}\\, N_{2}} - k_{12}\\, \\mathrm{touch}_{12}\\, \\mathrm{over}_{12} - k_{12}\\, \\mathrm{touch}_{12}\\, \\mathrm{clip}_{12}\\, \\mathrm{over}_{12}\\ [\\text{backlash}] + \\frac{T_{motor}}{2\\, h_{1}\\, N_{1}}\\ [\\text{torques}] + \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}}{2\\, h_{1}\\, N_{2}^{2}} - \\beta_{K}\\, \\bar{k_{12}}\\, \\mathrm{damp}_{12}\\, \\dot{\\mathrm{over}_{12}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{s_{1}}}{4\\, h_{1}^{2}\\, N_{1}^{2}} - \\frac{I_{2}\\, \\alpha_{M}\\, \\dot{s_{1}}}{4\\, h_{1}^{2}\\, N_{2}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{s_{1}}}{4\\, h_{1}^{2}\\, N_{1}^{2}} - \\frac{I_{1}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}}{2\\, h_{1}\\, N_{1}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}}{2\\, h_{1}\\, N_{1}^{2}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\psi_{m}}}{2\\, h_{1}\\, N_{1}} + \\frac{\\beta_{K}\\, k_{c}\\, \\dot{\\mathrm{twist}_{c}}}{2\\, h_{1}\\, N_{2}}\\ [\\text{damping}]";
        "(\\frac{I_{3}}{N_{3}^{2}} + \\frac{I_{4}}{N_{4}^{2}} + \\frac{I_{l}}{N_{4}^{2}}) \\ddot{\\theta_{2}} + (\\frac{1}{2} (\\frac{I_{3}}{h_{2}\\, N_{3}^{2}} - \\frac{I_{4}}{h_{2}\\, N_{4}^{2}} - \\frac{I_{l}}{h_{2}\\, N_{4}^{2}})) \\ddot{s_{2}} + (-\\frac{I_{l}}{N_{4}}) \\ddot{\\psi_{l}} = \\frac{k_{c}\\, \\mathrm{twist}_{c}}{N_{3}} - \\frac{T_{load}}{N_{4}}\\ [\\text{torques}] + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\psi_{l}}}{N_{4}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}}{N_{3}^{2}} - \\frac{I_{4}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}}{N_{4}^{2}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}}{N_{4}^{2}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{s_{2}}}{2\\, h_{2}\\, N_{3}^{2}} + \\frac{I_{4}\\, \\alpha_{M}\\, \\dot{s_{2}}}{2\\, h_{2}\\, N_{4}^{2}} + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{s_{2}}}{2\\, h_{2}\\, N_{4}^{2}} + \\frac{\\beta_{K}\\, k_{c}\\, \\dot{\\mathrm{twist}_{c}}}{N_{3}}\\ [\\text{damping}] - \\frac{k_{34}'\\, \\mathrm{touch}_{34}\\, \\mathrm{over}_{34}^{2}}{2}\\ [\\text{jump terms}]";
        "(\\frac{1}{2} (\\frac{I_{3}}{h_{2}\\, N_{3}^{2}} - \\frac{I_{4}}{h_{2}\\, N_{4}^{2}} - \\frac{I_{l}}{h_{2}\\, N_{4}^{2}})) \\ddot{\\theta_{2}} + (\\frac{1}{4} (\\frac{I_{3}}{h_{2}^{2}\\, N_{3}^{2}} + \\frac{I_{4}}{h_{2}^{2}\\, N_{4}^{2}} + \\frac{I_{l}}{h_{2}^{2}\\, N_{4}^{2}})) \\ddot{s_{2}} + (\\frac{I_{l}}{2\\, h_{2}\\, N_{4}}) \\ddot{\\psi_{l}} = \\frac{k_{c}\\, \\mathrm{twist}_{c}}{2\\, h_{2}\\, N_{3}} - k_{34}\\, \\mathrm{touch}_{34}\\, \\mathrm{over}_{34} - k_{34}\\, \\mathrm{touch}_{34}\\, \\mathrm{clip}_{34}\\, \\mathrm{over}_{34}\\ [\\text{backlash}] + \\frac{T_{load}}{2\\, h_{2}\\, N_{4}}\\ [\\text{torques}] + \\frac{I_{4}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}}{2\\, h_{2}\\, N_{4}^{2}} - \\beta_{K}\\, \\bar{k_{34}}\\, \\mathrm{damp}_{34}\\, \\dot{\\mathrm{over}_{34}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{s_{2}}}{4\\, h_{2}^{2}\\, N_{3}^{2}} - \\frac{I_{4}\\, \\alpha_{M}\\, \\dot{s_{2}}}{4\\, h_{2}^{2}\\, N_{4}^{2}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{s_{2}}}{4\\, h_{2}^{2}\\, N_{4}^{2}} - \\frac{I_{3}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}}{2\\, h_{2}\\, N_{3}^{2}} + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}}{2\\, h_{2}\\, N_{4}^{2}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\psi_{l}}}{2\\, h_{2}\\, N_{4}} + \\frac{\\beta_{K}\\, k_{c}\\, \\dot{\\mathrm{twist}_{c}}}{2\\, h_{2}\\, N_{3}}\\ [\\text{damping}]";
        "(\\frac{I_{m}}{N_{1}}) \\ddot{\\theta_{1}} + (\\frac{I_{m}}{2\\, h_{1}\\, N_{1}}) \\ddot{s_{1}} + (I_{m}) \\ddot{\\psi_{m}} = -k_{m}\\, \\psi_{m} + T_{motor}\\ [\\text{torques}] - I_{m}\\, \\alpha_{M}\\, \\dot{\\psi_{m}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}}{N_{1}} - \\beta_{K}\\, k_{m}\\, \\dot{\\psi_{m}} - \\frac{I_{m}\\, \\alpha_{M}\\, \\dot{s_{1}}}{2\\, h_{1}\\, N_{1}}\\ [\\text{damping}]";
        "(-\\frac{I_{l}}{N_{4}}) \\ddot{\\theta_{2}} + (\\frac{I_{l}}{2\\, h_{2}\\, N_{4}}) \\ddot{s_{2}} + (I_{l}) \\ddot{\\psi_{l}} = -k_{l}\\, \\psi_{l} + T_{load}\\ [\\text{torques}] + \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}}{N_{4}} - I_{l}\\, \\alpha_{M}\\, \\dot{\\psi_{l}} - \\beta_{K}\\, k_{l}\\, \\dot{\\psi_{l}} - \\frac{I_{l}\\, \\alpha_{M}\\, \\dot{s_{2}}}{2\\, h_{2}\\, N_{4}}\\ [\\text{damping}]";
    }
}
