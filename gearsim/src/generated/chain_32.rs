//! Equations of motion of `chain_32`: a torsional chain of 32 discs.
//!
//! Derived from the energies in `models/src/chain.rs` by `cargo xtask derive chain_32`. Do not edit: change the
//! energies and derive again.
//! Source: e.g. Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9
//!
//! # Energies
//!
//! ```text
//! T = (I1*theta1_dot^2 + I10*theta10_dot^2 + I11*theta11_dot^2 + I12*theta12_dot^2 + I13*theta13_dot^2 + I14*theta14_dot^2 + I15*theta15_dot^2 + I16*theta16_dot^2 + I17*theta17_dot^2 + I18*theta18_dot^2 + I19*theta19_dot^2 + I2*theta2_dot^2 + I20*theta20_dot^2 + I21*theta21_dot^2 + I22*theta22_dot^2 + I23*theta23_dot^2 + I24*theta24_dot^2 + I25*theta25_dot^2 + I26*theta26_dot^2 + I27*theta27_dot^2 + I28*theta28_dot^2 + I29*theta29_dot^2 + I3*theta3_dot^2 + I30*theta30_dot^2 + I31*theta31_dot^2 + I32*theta32_dot^2 + I4*theta4_dot^2 + I5*theta5_dot^2 + I6*theta6_dot^2 + I7*theta7_dot^2 + I8*theta8_dot^2 + I9*theta9_dot^2)/2
//! V = (k1*twist1^2 + k10*twist10^2 + k11*twist11^2 + k12*twist12^2 + k13*twist13^2 + k14*twist14^2 + k15*twist15^2 + k16*twist16^2 + k17*twist17^2 + k18*twist18^2 + k19*twist19^2 + k2*twist2^2 + k20*twist20^2 + k21*twist21^2 + k22*twist22^2 + k23*twist23^2 + k24*twist24^2 + k25*twist25^2 + k26*twist26^2 + k27*twist27^2 + k28*twist28^2 + k29*twist29^2 + k3*twist3^2 + k30*twist30^2 + k31*twist31^2 + k4*twist4^2 + k5*twist5^2 + k6*twist6^2 + k7*twist7^2 + k8*twist8^2 + k9*twist9^2)/2
//! D = (I1*alpha_M*theta1_dot^2 + I10*alpha_M*theta10_dot^2 + I11*alpha_M*theta11_dot^2 + I12*alpha_M*theta12_dot^2 + I13*alpha_M*theta13_dot^2 + I14*alpha_M*theta14_dot^2 + I15*alpha_M*theta15_dot^2 + I16*alpha_M*theta16_dot^2 + I17*alpha_M*theta17_dot^2 + I18*alpha_M*theta18_dot^2 + I19*alpha_M*theta19_dot^2 + I2*alpha_M*theta2_dot^2 + I20*alpha_M*theta20_dot^2 + I21*alpha_M*theta21_dot^2 + I22*alpha_M*theta22_dot^2 + I23*alpha_M*theta23_dot^2 + I24*alpha_M*theta24_dot^2 + I25*alpha_M*theta25_dot^2 + I26*alpha_M*theta26_dot^2 + I27*alpha_M*theta27_dot^2 + I28*alpha_M*theta28_dot^2 + I29*alpha_M*theta29_dot^2 + I3*alpha_M*theta3_dot^2 + I30*alpha_M*theta30_dot^2 + I31*alpha_M*theta31_dot^2 + I32*alpha_M*theta32_dot^2 + I4*alpha_M*theta4_dot^2 + I5*alpha_M*theta5_dot^2 + I6*alpha_M*theta6_dot^2 + I7*alpha_M*theta7_dot^2 + I8*alpha_M*theta8_dot^2 + I9*alpha_M*theta9_dot^2 + beta_K*k1*twist1_dot^2 + beta_K*k10*twist10_dot^2 + beta_K*k11*twist11_dot^2 + beta_K*k12*twist12_dot^2 + beta_K*k13*twist13_dot^2 + beta_K*k14*twist14_dot^2 + beta_K*k15*twist15_dot^2 + beta_K*k16*twist16_dot^2 + beta_K*k17*twist17_dot^2 + beta_K*k18*twist18_dot^2 + beta_K*k19*twist19_dot^2 + beta_K*k2*twist2_dot^2 + beta_K*k20*twist20_dot^2 + beta_K*k21*twist21_dot^2 + beta_K*k22*twist22_dot^2 + beta_K*k23*twist23_dot^2 + beta_K*k24*twist24_dot^2 + beta_K*k25*twist25_dot^2 + beta_K*k26*twist26_dot^2 + beta_K*k27*twist27_dot^2 + beta_K*k28*twist28_dot^2 + beta_K*k29*twist29_dot^2 + beta_K*k3*twist3_dot^2 + beta_K*k30*twist30_dot^2 + beta_K*k31*twist31_dot^2 + beta_K*k4*twist4_dot^2 + beta_K*k5*twist5_dot^2 + beta_K*k6*twist6_dot^2 + beta_K*k7*twist7_dot^2 + beta_K*k8*twist8_dot^2 + beta_K*k9*twist9_dot^2)/2 [damping]
//! Q_theta1 = T_motor [torques]
//! Q_theta2 = 0
//! Q_theta3 = 0
//! Q_theta4 = 0
//! Q_theta5 = 0
//! Q_theta6 = 0
//! Q_theta7 = 0
//! Q_theta8 = 0
//! Q_theta9 = 0
//! Q_theta10 = 0
//! Q_theta11 = 0
//! Q_theta12 = 0
//! Q_theta13 = 0
//! Q_theta14 = 0
//! Q_theta15 = 0
//! Q_theta16 = 0
//! Q_theta17 = 0
//! Q_theta18 = 0
//! Q_theta19 = 0
//! Q_theta20 = 0
//! Q_theta21 = 0
//! Q_theta22 = 0
//! Q_theta23 = 0
//! Q_theta24 = 0
//! Q_theta25 = 0
//! Q_theta26 = 0
//! Q_theta27 = 0
//! Q_theta28 = 0
//! Q_theta29 = 0
//! Q_theta30 = 0
//! Q_theta31 = 0
//! Q_theta32 = -T_load [torques]
//! ```
//!
//! # Deflections
//!
//! ```text
//! twist1 = theta1 - theta2
//! twist2 = theta2 - theta3
//! twist3 = theta3 - theta4
//! twist4 = theta4 - theta5
//! twist5 = theta5 - theta6
//! twist6 = theta6 - theta7
//! twist7 = theta7 - theta8
//! twist8 = theta8 - theta9
//! twist9 = theta9 - theta10
//! twist10 = theta10 - theta11
//! twist11 = theta11 - theta12
//! twist12 = theta12 - theta13
//! twist13 = theta13 - theta14
//! twist14 = theta14 - theta15
//! twist15 = theta15 - theta16
//! twist16 = theta16 - theta17
//! twist17 = theta17 - theta18
//! twist18 = theta18 - theta19
//! twist19 = theta19 - theta20
//! twist20 = theta20 - theta21
//! twist21 = theta21 - theta22
//! twist22 = theta22 - theta23
//! twist23 = theta23 - theta24
//! twist24 = theta24 - theta25
//! twist25 = theta25 - theta26
//! twist26 = theta26 - theta27
//! twist27 = theta27 - theta28
//! twist28 = theta28 - theta29
//! twist29 = theta29 - theta30
//! twist30 = theta30 - theta31
//! twist31 = theta31 - theta32
//! ```
//!
//! # Equations of motion
//!
//! ```text
//! (I1) theta1'' = -k1*twist1 + T_motor [torques] - I1*alpha_M*theta1_dot - beta_K*k1*twist1_dot [damping]
//! (I2) theta2'' = k1*twist1 - k2*twist2 + beta_K*k1*twist1_dot - I2*alpha_M*theta2_dot - beta_K*k2*twist2_dot [damping]
//! (I3) theta3'' = k2*twist2 - k3*twist3 + beta_K*k2*twist2_dot - I3*alpha_M*theta3_dot - beta_K*k3*twist3_dot [damping]
//! (I4) theta4'' = k3*twist3 - k4*twist4 + beta_K*k3*twist3_dot - I4*alpha_M*theta4_dot - beta_K*k4*twist4_dot [damping]
//! (I5) theta5'' = k4*twist4 - k5*twist5 + beta_K*k4*twist4_dot - I5*alpha_M*theta5_dot - beta_K*k5*twist5_dot [damping]
//! (I6) theta6'' = k5*twist5 - k6*twist6 + beta_K*k5*twist5_dot - I6*alpha_M*theta6_dot - beta_K*k6*twist6_dot [damping]
//! (I7) theta7'' = k6*twist6 - k7*twist7 + beta_K*k6*twist6_dot - I7*alpha_M*theta7_dot - beta_K*k7*twist7_dot [damping]
//! (I8) theta8'' = k7*twist7 - k8*twist8 + beta_K*k7*twist7_dot - I8*alpha_M*theta8_dot - beta_K*k8*twist8_dot [damping]
//! (I9) theta9'' = k8*twist8 - k9*twist9 + beta_K*k8*twist8_dot - I9*alpha_M*theta9_dot - beta_K*k9*twist9_dot [damping]
//! (I10) theta10'' = k9*twist9 - k10*twist10 + beta_K*k9*twist9_dot - I10*alpha_M*theta10_dot - beta_K*k10*twist10_dot [damping]
//! (I11) theta11'' = k10*twist10 - k11*twist11 + beta_K*k10*twist10_dot - I11*alpha_M*theta11_dot - beta_K*k11*twist11_dot [damping]
//! (I12) theta12'' = k11*twist11 - k12*twist12 + beta_K*k11*twist11_dot - I12*alpha_M*theta12_dot - beta_K*k12*twist12_dot [damping]
//! (I13) theta13'' = k12*twist12 - k13*twist13 + beta_K*k12*twist12_dot - I13*alpha_M*theta13_dot - beta_K*k13*twist13_dot [damping]
//! (I14) theta14'' = k13*twist13 - k14*twist14 + beta_K*k13*twist13_dot - I14*alpha_M*theta14_dot - beta_K*k14*twist14_dot [damping]
//! (I15) theta15'' = k14*twist14 - k15*twist15 + beta_K*k14*twist14_dot - I15*alpha_M*theta15_dot - beta_K*k15*twist15_dot [damping]
//! (I16) theta16'' = k15*twist15 - k16*twist16 + beta_K*k15*twist15_dot - I16*alpha_M*theta16_dot - beta_K*k16*twist16_dot [damping]
//! (I17) theta17'' = k16*twist16 - k17*twist17 + beta_K*k16*twist16_dot - I17*alpha_M*theta17_dot - beta_K*k17*twist17_dot [damping]
//! (I18) theta18'' = k17*twist17 - k18*twist18 + beta_K*k17*twist17_dot - I18*alpha_M*theta18_dot - beta_K*k18*twist18_dot [damping]
//! (I19) theta19'' = k18*twist18 - k19*twist19 + beta_K*k18*twist18_dot - I19*alpha_M*theta19_dot - beta_K*k19*twist19_dot [damping]
//! (I20) theta20'' = k19*twist19 - k20*twist20 + beta_K*k19*twist19_dot - I20*alpha_M*theta20_dot - beta_K*k20*twist20_dot [damping]
//! (I21) theta21'' = k20*twist20 - k21*twist21 + beta_K*k20*twist20_dot - I21*alpha_M*theta21_dot - beta_K*k21*twist21_dot [damping]
//! (I22) theta22'' = k21*twist21 - k22*twist22 + beta_K*k21*twist21_dot - I22*alpha_M*theta22_dot - beta_K*k22*twist22_dot [damping]
//! (I23) theta23'' = k22*twist22 - k23*twist23 + beta_K*k22*twist22_dot - I23*alpha_M*theta23_dot - beta_K*k23*twist23_dot [damping]
//! (I24) theta24'' = k23*twist23 - k24*twist24 + beta_K*k23*twist23_dot - I24*alpha_M*theta24_dot - beta_K*k24*twist24_dot [damping]
//! (I25) theta25'' = k24*twist24 - k25*twist25 + beta_K*k24*twist24_dot - I25*alpha_M*theta25_dot - beta_K*k25*twist25_dot [damping]
//! (I26) theta26'' = k25*twist25 - k26*twist26 + beta_K*k25*twist25_dot - I26*alpha_M*theta26_dot - beta_K*k26*twist26_dot [damping]
//! (I27) theta27'' = k26*twist26 - k27*twist27 + beta_K*k26*twist26_dot - I27*alpha_M*theta27_dot - beta_K*k27*twist27_dot [damping]
//! (I28) theta28'' = k27*twist27 - k28*twist28 + beta_K*k27*twist27_dot - I28*alpha_M*theta28_dot - beta_K*k28*twist28_dot [damping]
//! (I29) theta29'' = k28*twist28 - k29*twist29 + beta_K*k28*twist28_dot - I29*alpha_M*theta29_dot - beta_K*k29*twist29_dot [damping]
//! (I30) theta30'' = k29*twist29 - k30*twist30 + beta_K*k29*twist29_dot - I30*alpha_M*theta30_dot - beta_K*k30*twist30_dot [damping]
//! (I31) theta31'' = k30*twist30 - k31*twist31 + beta_K*k30*twist30_dot - I31*alpha_M*theta31_dot - beta_K*k31*twist31_dot [damping]
//! (I32) theta32'' = k31*twist31 - T_load [torques] + beta_K*k31*twist31_dot - I32*alpha_M*theta32_dot [damping]
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
//! T = \frac{1}{2} (I_{1}\, \dot{\theta_{1}}^{2} + I_{10}\, \dot{\theta_{10}}^{2} + I_{11}\, \dot{\theta_{11}}^{2} + I_{12}\, \dot{\theta_{12}}^{2} + I_{13}\, \dot{\theta_{13}}^{2} + I_{14}\, \dot{\theta_{14}}^{2} + I_{15}\, \dot{\theta_{15}}^{2} + I_{16}\, \dot{\theta_{16}}^{2} + I_{17}\, \dot{\theta_{17}}^{2} + I_{18}\, \dot{\theta_{18}}^{2} + I_{19}\, \dot{\theta_{19}}^{2} + I_{2}\, \dot{\theta_{2}}^{2} + I_{20}\, \dot{\theta_{20}}^{2} + I_{21}\, \dot{\theta_{21}}^{2} + I_{22}\, \dot{\theta_{22}}^{2} + I_{23}\, \dot{\theta_{23}}^{2} + I_{24}\, \dot{\theta_{24}}^{2} + I_{25}\, \dot{\theta_{25}}^{2} + I_{26}\, \dot{\theta_{26}}^{2} + I_{27}\, \dot{\theta_{27}}^{2} + I_{28}\, \dot{\theta_{28}}^{2} + I_{29}\, \dot{\theta_{29}}^{2} + I_{3}\, \dot{\theta_{3}}^{2} + I_{30}\, \dot{\theta_{30}}^{2} + I_{31}\, \dot{\theta_{31}}^{2} + I_{32}\, \dot{\theta_{32}}^{2} + I_{4}\, \dot{\theta_{4}}^{2} + I_{5}\, \dot{\theta_{5}}^{2} + I_{6}\, \dot{\theta_{6}}^{2} + I_{7}\, \dot{\theta_{7}}^{2} + I_{8}\, \dot{\theta_{8}}^{2} + I_{9}\, \dot{\theta_{9}}^{2})
//! V = \frac{1}{2} (k_{1}\, \mathrm{twist}_{1}^{2} + k_{10}\, \mathrm{twist}_{10}^{2} + k_{11}\, \mathrm{twist}_{11}^{2} + k_{12}\, \mathrm{twist}_{12}^{2} + k_{13}\, \mathrm{twist}_{13}^{2} + k_{14}\, \mathrm{twist}_{14}^{2} + k_{15}\, \mathrm{twist}_{15}^{2} + k_{16}\, \mathrm{twist}_{16}^{2} + k_{17}\, \mathrm{twist}_{17}^{2} + k_{18}\, \mathrm{twist}_{18}^{2} + k_{19}\, \mathrm{twist}_{19}^{2} + k_{2}\, \mathrm{twist}_{2}^{2} + k_{20}\, \mathrm{twist}_{20}^{2} + k_{21}\, \mathrm{twist}_{21}^{2} + k_{22}\, \mathrm{twist}_{22}^{2} + k_{23}\, \mathrm{twist}_{23}^{2} + k_{24}\, \mathrm{twist}_{24}^{2} + k_{25}\, \mathrm{twist}_{25}^{2} + k_{26}\, \mathrm{twist}_{26}^{2} + k_{27}\, \mathrm{twist}_{27}^{2} + k_{28}\, \mathrm{twist}_{28}^{2} + k_{29}\, \mathrm{twist}_{29}^{2} + k_{3}\, \mathrm{twist}_{3}^{2} + k_{30}\, \mathrm{twist}_{30}^{2} + k_{31}\, \mathrm{twist}_{31}^{2} + k_{4}\, \mathrm{twist}_{4}^{2} + k_{5}\, \mathrm{twist}_{5}^{2} + k_{6}\, \mathrm{twist}_{6}^{2} + k_{7}\, \mathrm{twist}_{7}^{2} + k_{8}\, \mathrm{twist}_{8}^{2} + k_{9}\, \mathrm{twist}_{9}^{2})
//! D = \frac{1}{2} (I_{1}\, \alpha_{M}\, \dot{\theta_{1}}^{2} + I_{10}\, \alpha_{M}\, \dot{\theta_{10}}^{2} + I_{11}\, \alpha_{M}\, \dot{\theta_{11}}^{2} + I_{12}\, \alpha_{M}\, \dot{\theta_{12}}^{2} + I_{13}\, \alpha_{M}\, \dot{\theta_{13}}^{2} + I_{14}\, \alpha_{M}\, \dot{\theta_{14}}^{2} + I_{15}\, \alpha_{M}\, \dot{\theta_{15}}^{2} + I_{16}\, \alpha_{M}\, \dot{\theta_{16}}^{2} + I_{17}\, \alpha_{M}\, \dot{\theta_{17}}^{2} + I_{18}\, \alpha_{M}\, \dot{\theta_{18}}^{2} + I_{19}\, \alpha_{M}\, \dot{\theta_{19}}^{2} + I_{2}\, \alpha_{M}\, \dot{\theta_{2}}^{2} + I_{20}\, \alpha_{M}\, \dot{\theta_{20}}^{2} + I_{21}\, \alpha_{M}\, \dot{\theta_{21}}^{2} + I_{22}\, \alpha_{M}\, \dot{\theta_{22}}^{2} + I_{23}\, \alpha_{M}\, \dot{\theta_{23}}^{2} + I_{24}\, \alpha_{M}\, \dot{\theta_{24}}^{2} + I_{25}\, \alpha_{M}\, \dot{\theta_{25}}^{2} + I_{26}\, \alpha_{M}\, \dot{\theta_{26}}^{2} + I_{27}\, \alpha_{M}\, \dot{\theta_{27}}^{2} + I_{28}\, \alpha_{M}\, \dot{\theta_{28}}^{2} + I_{29}\, \alpha_{M}\, \dot{\theta_{29}}^{2} + I_{3}\, \alpha_{M}\, \dot{\theta_{3}}^{2} + I_{30}\, \alpha_{M}\, \dot{\theta_{30}}^{2} + I_{31}\, \alpha_{M}\, \dot{\theta_{31}}^{2} + I_{32}\, \alpha_{M}\, \dot{\theta_{32}}^{2} + I_{4}\, \alpha_{M}\, \dot{\theta_{4}}^{2} + I_{5}\, \alpha_{M}\, \dot{\theta_{5}}^{2} + I_{6}\, \alpha_{M}\, \dot{\theta_{6}}^{2} + I_{7}\, \alpha_{M}\, \dot{\theta_{7}}^{2} + I_{8}\, \alpha_{M}\, \dot{\theta_{8}}^{2} + I_{9}\, \alpha_{M}\, \dot{\theta_{9}}^{2} + \beta_{K}\, k_{1}\, \dot{\mathrm{twist}_{1}}^{2} + \beta_{K}\, k_{10}\, \dot{\mathrm{twist}_{10}}^{2} + \beta_{K}\, k_{11}\, \dot{\mathrm{twist}_{11}}^{2} + \beta_{K}\, k_{12}\, \dot{\mathrm{twist}_{12}}^{2} + \beta_{K}\, k_{13}\, \dot{\mathrm{twist}_{13}}^{2} + \beta_{K}\, k_{14}\, \dot{\mathrm{twist}_{14}}^{2} + \beta_{K}\, k_{15}\, \dot{\mathrm{twist}_{15}}^{2} + \beta_{K}\, k_{16}\, \dot{\mathrm{twist}_{16}}^{2} + \beta_{K}\, k_{17}\, \dot{\mathrm{twist}_{17}}^{2} + \beta_{K}\, k_{18}\, \dot{\mathrm{twist}_{18}}^{2} + \beta_{K}\, k_{19}\, \dot{\mathrm{twist}_{19}}^{2} + \beta_{K}\, k_{2}\, \dot{\mathrm{twist}_{2}}^{2} + \beta_{K}\, k_{20}\, \dot{\mathrm{twist}_{20}}^{2} + \beta_{K}\, k_{21}\, \dot{\mathrm{twist}_{21}}^{2} + \beta_{K}\, k_{22}\, \dot{\mathrm{twist}_{22}}^{2} + \beta_{K}\, k_{23}\, \dot{\mathrm{twist}_{23}}^{2} + \beta_{K}\, k_{24}\, \dot{\mathrm{twist}_{24}}^{2} + \beta_{K}\, k_{25}\, \dot{\mathrm{twist}_{25}}^{2} + \beta_{K}\, k_{26}\, \dot{\mathrm{twist}_{26}}^{2} + \beta_{K}\, k_{27}\, \dot{\mathrm{twist}_{27}}^{2} + \beta_{K}\, k_{28}\, \dot{\mathrm{twist}_{28}}^{2} + \beta_{K}\, k_{29}\, \dot{\mathrm{twist}_{29}}^{2} + \beta_{K}\, k_{3}\, \dot{\mathrm{twist}_{3}}^{2} + \beta_{K}\, k_{30}\, \dot{\mathrm{twist}_{30}}^{2} + \beta_{K}\, k_{31}\, \dot{\mathrm{twist}_{31}}^{2} + \beta_{K}\, k_{4}\, \dot{\mathrm{twist}_{4}}^{2} + \beta_{K}\, k_{5}\, \dot{\mathrm{twist}_{5}}^{2} + \beta_{K}\, k_{6}\, \dot{\mathrm{twist}_{6}}^{2} + \beta_{K}\, k_{7}\, \dot{\mathrm{twist}_{7}}^{2} + \beta_{K}\, k_{8}\, \dot{\mathrm{twist}_{8}}^{2} + \beta_{K}\, k_{9}\, \dot{\mathrm{twist}_{9}}^{2})\ [\text{damping}]
//! Q_{\theta_{1}} = T_{motor}\ [\text{torques}]
//! Q_{\theta_{2}} = 0
//! Q_{\theta_{3}} = 0
//! Q_{\theta_{4}} = 0
//! Q_{\theta_{5}} = 0
//! Q_{\theta_{6}} = 0
//! Q_{\theta_{7}} = 0
//! Q_{\theta_{8}} = 0
//! Q_{\theta_{9}} = 0
//! Q_{\theta_{10}} = 0
//! Q_{\theta_{11}} = 0
//! Q_{\theta_{12}} = 0
//! Q_{\theta_{13}} = 0
//! Q_{\theta_{14}} = 0
//! Q_{\theta_{15}} = 0
//! Q_{\theta_{16}} = 0
//! Q_{\theta_{17}} = 0
//! Q_{\theta_{18}} = 0
//! Q_{\theta_{19}} = 0
//! Q_{\theta_{20}} = 0
//! Q_{\theta_{21}} = 0
//! Q_{\theta_{22}} = 0
//! Q_{\theta_{23}} = 0
//! Q_{\theta_{24}} = 0
//! Q_{\theta_{25}} = 0
//! Q_{\theta_{26}} = 0
//! Q_{\theta_{27}} = 0
//! Q_{\theta_{28}} = 0
//! Q_{\theta_{29}} = 0
//! Q_{\theta_{30}} = 0
//! Q_{\theta_{31}} = 0
//! Q_{\theta_{32}} = -T_{load}\ [\text{torques}]
//! \mathrm{twist}_{1} = \theta_{1} - \theta_{2}
//! \mathrm{twist}_{2} = \theta_{2} - \theta_{3}
//! \mathrm{twist}_{3} = \theta_{3} - \theta_{4}
//! \mathrm{twist}_{4} = \theta_{4} - \theta_{5}
//! \mathrm{twist}_{5} = \theta_{5} - \theta_{6}
//! \mathrm{twist}_{6} = \theta_{6} - \theta_{7}
//! \mathrm{twist}_{7} = \theta_{7} - \theta_{8}
//! \mathrm{twist}_{8} = \theta_{8} - \theta_{9}
//! \mathrm{twist}_{9} = \theta_{9} - \theta_{10}
//! \mathrm{twist}_{10} = \theta_{10} - \theta_{11}
//! \mathrm{twist}_{11} = \theta_{11} - \theta_{12}
//! \mathrm{twist}_{12} = \theta_{12} - \theta_{13}
//! \mathrm{twist}_{13} = \theta_{13} - \theta_{14}
//! \mathrm{twist}_{14} = \theta_{14} - \theta_{15}
//! \mathrm{twist}_{15} = \theta_{15} - \theta_{16}
//! \mathrm{twist}_{16} = \theta_{16} - \theta_{17}
//! \mathrm{twist}_{17} = \theta_{17} - \theta_{18}
//! \mathrm{twist}_{18} = \theta_{18} - \theta_{19}
//! \mathrm{twist}_{19} = \theta_{19} - \theta_{20}
//! \mathrm{twist}_{20} = \theta_{20} - \theta_{21}
//! \mathrm{twist}_{21} = \theta_{21} - \theta_{22}
//! \mathrm{twist}_{22} = \theta_{22} - \theta_{23}
//! \mathrm{twist}_{23} = \theta_{23} - \theta_{24}
//! \mathrm{twist}_{24} = \theta_{24} - \theta_{25}
//! \mathrm{twist}_{25} = \theta_{25} - \theta_{26}
//! \mathrm{twist}_{26} = \theta_{26} - \theta_{27}
//! \mathrm{twist}_{27} = \theta_{27} - \theta_{28}
//! \mathrm{twist}_{28} = \theta_{28} - \theta_{29}
//! \mathrm{twist}_{29} = \theta_{29} - \theta_{30}
//! \mathrm{twist}_{30} = \theta_{30} - \theta_{31}
//! \mathrm{twist}_{31} = \theta_{31} - \theta_{32}
//! (I_{1}) \ddot{\theta_{1}} = -k_{1}\, \mathrm{twist}_{1} + T_{motor}\ [\text{torques}] - I_{1}\, \alpha_{M}\, \dot{\theta_{1}} - \beta_{K}\, k_{1}\, \dot{\mathrm{twist}_{1}}\ [\text{damping}]
//! (I_{2}) \ddot{\theta_{2}} = k_{1}\, \mathrm{twist}_{1} - k_{2}\, \mathrm{twist}_{2} + \beta_{K}\, k_{1}\, \dot{\mathrm{twist}_{1}} - I_{2}\, \alpha_{M}\, \dot{\theta_{2}} - \beta_{K}\, k_{2}\, \dot{\mathrm{twist}_{2}}\ [\text{damping}]
//! (I_{3}) \ddot{\theta_{3}} = k_{2}\, \mathrm{twist}_{2} - k_{3}\, \mathrm{twist}_{3} + \beta_{K}\, k_{2}\, \dot{\mathrm{twist}_{2}} - I_{3}\, \alpha_{M}\, \dot{\theta_{3}} - \beta_{K}\, k_{3}\, \dot{\mathrm{twist}_{3}}\ [\text{damping}]
//! (I_{4}) \ddot{\theta_{4}} = k_{3}\, \mathrm{twist}_{3} - k_{4}\, \mathrm{twist}_{4} + \beta_{K}\, k_{3}\, \dot{\mathrm{twist}_{3}} - I_{4}\, \alpha_{M}\, \dot{\theta_{4}} - \beta_{K}\, k_{4}\, \dot{\mathrm{twist}_{4}}\ [\text{damping}]
//! (I_{5}) \ddot{\theta_{5}} = k_{4}\, \mathrm{twist}_{4} - k_{5}\, \mathrm{twist}_{5} + \beta_{K}\, k_{4}\, \dot{\mathrm{twist}_{4}} - I_{5}\, \alpha_{M}\, \dot{\theta_{5}} - \beta_{K}\, k_{5}\, \dot{\mathrm{twist}_{5}}\ [\text{damping}]
//! (I_{6}) \ddot{\theta_{6}} = k_{5}\, \mathrm{twist}_{5} - k_{6}\, \mathrm{twist}_{6} + \beta_{K}\, k_{5}\, \dot{\mathrm{twist}_{5}} - I_{6}\, \alpha_{M}\, \dot{\theta_{6}} - \beta_{K}\, k_{6}\, \dot{\mathrm{twist}_{6}}\ [\text{damping}]
//! (I_{7}) \ddot{\theta_{7}} = k_{6}\, \mathrm{twist}_{6} - k_{7}\, \mathrm{twist}_{7} + \beta_{K}\, k_{6}\, \dot{\mathrm{twist}_{6}} - I_{7}\, \alpha_{M}\, \dot{\theta_{7}} - \beta_{K}\, k_{7}\, \dot{\mathrm{twist}_{7}}\ [\text{damping}]
//! (I_{8}) \ddot{\theta_{8}} = k_{7}\, \mathrm{twist}_{7} - k_{8}\, \mathrm{twist}_{8} + \beta_{K}\, k_{7}\, \dot{\mathrm{twist}_{7}} - I_{8}\, \alpha_{M}\, \dot{\theta_{8}} - \beta_{K}\, k_{8}\, \dot{\mathrm{twist}_{8}}\ [\text{damping}]
//! (I_{9}) \ddot{\theta_{9}} = k_{8}\, \mathrm{twist}_{8} - k_{9}\, \mathrm{twist}_{9} + \beta_{K}\, k_{8}\, \dot{\mathrm{twist}_{8}} - I_{9}\, \alpha_{M}\, \dot{\theta_{9}} - \beta_{K}\, k_{9}\, \dot{\mathrm{twist}_{9}}\ [\text{damping}]
//! (I_{10}) \ddot{\theta_{10}} = k_{9}\, \mathrm{twist}_{9} - k_{10}\, \mathrm{twist}_{10} + \beta_{K}\, k_{9}\, \dot{\mathrm{twist}_{9}} - I_{10}\, \alpha_{M}\, \dot{\theta_{10}} - \beta_{K}\, k_{10}\, \dot{\mathrm{twist}_{10}}\ [\text{damping}]
//! (I_{11}) \ddot{\theta_{11}} = k_{10}\, \mathrm{twist}_{10} - k_{11}\, \mathrm{twist}_{11} + \beta_{K}\, k_{10}\, \dot{\mathrm{twist}_{10}} - I_{11}\, \alpha_{M}\, \dot{\theta_{11}} - \beta_{K}\, k_{11}\, \dot{\mathrm{twist}_{11}}\ [\text{damping}]
//! (I_{12}) \ddot{\theta_{12}} = k_{11}\, \mathrm{twist}_{11} - k_{12}\, \mathrm{twist}_{12} + \beta_{K}\, k_{11}\, \dot{\mathrm{twist}_{11}} - I_{12}\, \alpha_{M}\, \dot{\theta_{12}} - \beta_{K}\, k_{12}\, \dot{\mathrm{twist}_{12}}\ [\text{damping}]
//! (I_{13}) \ddot{\theta_{13}} = k_{12}\, \mathrm{twist}_{12} - k_{13}\, \mathrm{twist}_{13} + \beta_{K}\, k_{12}\, \dot{\mathrm{twist}_{12}} - I_{13}\, \alpha_{M}\, \dot{\theta_{13}} - \beta_{K}\, k_{13}\, \dot{\mathrm{twist}_{13}}\ [\text{damping}]
//! (I_{14}) \ddot{\theta_{14}} = k_{13}\, \mathrm{twist}_{13} - k_{14}\, \mathrm{twist}_{14} + \beta_{K}\, k_{13}\, \dot{\mathrm{twist}_{13}} - I_{14}\, \alpha_{M}\, \dot{\theta_{14}} - \beta_{K}\, k_{14}\, \dot{\mathrm{twist}_{14}}\ [\text{damping}]
//! (I_{15}) \ddot{\theta_{15}} = k_{14}\, \mathrm{twist}_{14} - k_{15}\, \mathrm{twist}_{15} + \beta_{K}\, k_{14}\, \dot{\mathrm{twist}_{14}} - I_{15}\, \alpha_{M}\, \dot{\theta_{15}} - \beta_{K}\, k_{15}\, \dot{\mathrm{twist}_{15}}\ [\text{damping}]
//! (I_{16}) \ddot{\theta_{16}} = k_{15}\, \mathrm{twist}_{15} - k_{16}\, \mathrm{twist}_{16} + \beta_{K}\, k_{15}\, \dot{\mathrm{twist}_{15}} - I_{16}\, \alpha_{M}\, \dot{\theta_{16}} - \beta_{K}\, k_{16}\, \dot{\mathrm{twist}_{16}}\ [\text{damping}]
//! (I_{17}) \ddot{\theta_{17}} = k_{16}\, \mathrm{twist}_{16} - k_{17}\, \mathrm{twist}_{17} + \beta_{K}\, k_{16}\, \dot{\mathrm{twist}_{16}} - I_{17}\, \alpha_{M}\, \dot{\theta_{17}} - \beta_{K}\, k_{17}\, \dot{\mathrm{twist}_{17}}\ [\text{damping}]
//! (I_{18}) \ddot{\theta_{18}} = k_{17}\, \mathrm{twist}_{17} - k_{18}\, \mathrm{twist}_{18} + \beta_{K}\, k_{17}\, \dot{\mathrm{twist}_{17}} - I_{18}\, \alpha_{M}\, \dot{\theta_{18}} - \beta_{K}\, k_{18}\, \dot{\mathrm{twist}_{18}}\ [\text{damping}]
//! (I_{19}) \ddot{\theta_{19}} = k_{18}\, \mathrm{twist}_{18} - k_{19}\, \mathrm{twist}_{19} + \beta_{K}\, k_{18}\, \dot{\mathrm{twist}_{18}} - I_{19}\, \alpha_{M}\, \dot{\theta_{19}} - \beta_{K}\, k_{19}\, \dot{\mathrm{twist}_{19}}\ [\text{damping}]
//! (I_{20}) \ddot{\theta_{20}} = k_{19}\, \mathrm{twist}_{19} - k_{20}\, \mathrm{twist}_{20} + \beta_{K}\, k_{19}\, \dot{\mathrm{twist}_{19}} - I_{20}\, \alpha_{M}\, \dot{\theta_{20}} - \beta_{K}\, k_{20}\, \dot{\mathrm{twist}_{20}}\ [\text{damping}]
//! (I_{21}) \ddot{\theta_{21}} = k_{20}\, \mathrm{twist}_{20} - k_{21}\, \mathrm{twist}_{21} + \beta_{K}\, k_{20}\, \dot{\mathrm{twist}_{20}} - I_{21}\, \alpha_{M}\, \dot{\theta_{21}} - \beta_{K}\, k_{21}\, \dot{\mathrm{twist}_{21}}\ [\text{damping}]
//! (I_{22}) \ddot{\theta_{22}} = k_{21}\, \mathrm{twist}_{21} - k_{22}\, \mathrm{twist}_{22} + \beta_{K}\, k_{21}\, \dot{\mathrm{twist}_{21}} - I_{22}\, \alpha_{M}\, \dot{\theta_{22}} - \beta_{K}\, k_{22}\, \dot{\mathrm{twist}_{22}}\ [\text{damping}]
//! (I_{23}) \ddot{\theta_{23}} = k_{22}\, \mathrm{twist}_{22} - k_{23}\, \mathrm{twist}_{23} + \beta_{K}\, k_{22}\, \dot{\mathrm{twist}_{22}} - I_{23}\, \alpha_{M}\, \dot{\theta_{23}} - \beta_{K}\, k_{23}\, \dot{\mathrm{twist}_{23}}\ [\text{damping}]
//! (I_{24}) \ddot{\theta_{24}} = k_{23}\, \mathrm{twist}_{23} - k_{24}\, \mathrm{twist}_{24} + \beta_{K}\, k_{23}\, \dot{\mathrm{twist}_{23}} - I_{24}\, \alpha_{M}\, \dot{\theta_{24}} - \beta_{K}\, k_{24}\, \dot{\mathrm{twist}_{24}}\ [\text{damping}]
//! (I_{25}) \ddot{\theta_{25}} = k_{24}\, \mathrm{twist}_{24} - k_{25}\, \mathrm{twist}_{25} + \beta_{K}\, k_{24}\, \dot{\mathrm{twist}_{24}} - I_{25}\, \alpha_{M}\, \dot{\theta_{25}} - \beta_{K}\, k_{25}\, \dot{\mathrm{twist}_{25}}\ [\text{damping}]
//! (I_{26}) \ddot{\theta_{26}} = k_{25}\, \mathrm{twist}_{25} - k_{26}\, \mathrm{twist}_{26} + \beta_{K}\, k_{25}\, \dot{\mathrm{twist}_{25}} - I_{26}\, \alpha_{M}\, \dot{\theta_{26}} - \beta_{K}\, k_{26}\, \dot{\mathrm{twist}_{26}}\ [\text{damping}]
//! (I_{27}) \ddot{\theta_{27}} = k_{26}\, \mathrm{twist}_{26} - k_{27}\, \mathrm{twist}_{27} + \beta_{K}\, k_{26}\, \dot{\mathrm{twist}_{26}} - I_{27}\, \alpha_{M}\, \dot{\theta_{27}} - \beta_{K}\, k_{27}\, \dot{\mathrm{twist}_{27}}\ [\text{damping}]
//! (I_{28}) \ddot{\theta_{28}} = k_{27}\, \mathrm{twist}_{27} - k_{28}\, \mathrm{twist}_{28} + \beta_{K}\, k_{27}\, \dot{\mathrm{twist}_{27}} - I_{28}\, \alpha_{M}\, \dot{\theta_{28}} - \beta_{K}\, k_{28}\, \dot{\mathrm{twist}_{28}}\ [\text{damping}]
//! (I_{29}) \ddot{\theta_{29}} = k_{28}\, \mathrm{twist}_{28} - k_{29}\, \mathrm{twist}_{29} + \beta_{K}\, k_{28}\, \dot{\mathrm{twist}_{28}} - I_{29}\, \alpha_{M}\, \dot{\theta_{29}} - \beta_{K}\, k_{29}\, \dot{\mathrm{twist}_{29}}\ [\text{damping}]
//! (I_{30}) \ddot{\theta_{30}} = k_{29}\, \mathrm{twist}_{29} - k_{30}\, \mathrm{twist}_{30} + \beta_{K}\, k_{29}\, \dot{\mathrm{twist}_{29}} - I_{30}\, \alpha_{M}\, \dot{\theta_{30}} - \beta_{K}\, k_{30}\, \dot{\mathrm{twist}_{30}}\ [\text{damping}]
//! (I_{31}) \ddot{\theta_{31}} = k_{30}\, \mathrm{twist}_{30} - k_{31}\, \mathrm{twist}_{31} + \beta_{K}\, k_{30}\, \dot{\mathrm{twist}_{30}} - I_{31}\, \alpha_{M}\, \dot{\theta_{31}} - \beta_{K}\, k_{31}\, \dot{\mathrm{twist}_{31}}\ [\text{damping}]
//! (I_{32}) \ddot{\theta_{32}} = k_{31}\, \mathrm{twist}_{31} - T_{load}\ [\text{torques}] + \beta_{K}\, k_{31}\, \dot{\mathrm{twist}_{31}} - I_{32}\, \alpha_{M}\, \dot{\theta_{32}}\ [\text{damping}]
//! ```
//!
//! # Proved
//!
//! - d/dt (q'.dT/dq' - T + V) = Q.q' - q'.dD/dq' along the motion, for every value and slope of every law, with any set of the additive effects
//! - M is symmetric
//! - T = q'.M q'/2, with M as written
//! - M is positive definite: T is a sum of squares that vanish together only at rest
//! - every damper takes energy or none: each term of D has a power q'.dD/dq' that is never negative
//! - every deflection equals the linear form by which the equations differentiate it
//!
//! # Operations, all effects present
//!
//! | output | sums | products, quotients | functions, roots |
//! | --- | --- | --- | --- |
//! | force | 92 | 250 | 0 |

use gearsim_macros::equations;

equations! {
    model chain_32 "a torsional chain of 32 discs";
    source "e.g. Friswell, Penny, Garvey & Lees (2010), Dynamics of Rotating Machines, Ch. 9";

    coordinates {
        theta1 "rad" start 0.0, "rotation of disc 1";
        theta2 "rad" start static, "rotation of disc 2";
        theta3 "rad" start static, "rotation of disc 3";
        theta4 "rad" start static, "rotation of disc 4";
        theta5 "rad" start static, "rotation of disc 5";
        theta6 "rad" start static, "rotation of disc 6";
        theta7 "rad" start static, "rotation of disc 7";
        theta8 "rad" start static, "rotation of disc 8";
        theta9 "rad" start static, "rotation of disc 9";
        theta10 "rad" start static, "rotation of disc 10";
        theta11 "rad" start static, "rotation of disc 11";
        theta12 "rad" start static, "rotation of disc 12";
        theta13 "rad" start static, "rotation of disc 13";
        theta14 "rad" start static, "rotation of disc 14";
        theta15 "rad" start static, "rotation of disc 15";
        theta16 "rad" start static, "rotation of disc 16";
        theta17 "rad" start static, "rotation of disc 17";
        theta18 "rad" start static, "rotation of disc 18";
        theta19 "rad" start static, "rotation of disc 19";
        theta20 "rad" start static, "rotation of disc 20";
        theta21 "rad" start static, "rotation of disc 21";
        theta22 "rad" start static, "rotation of disc 22";
        theta23 "rad" start static, "rotation of disc 23";
        theta24 "rad" start static, "rotation of disc 24";
        theta25 "rad" start static, "rotation of disc 25";
        theta26 "rad" start static, "rotation of disc 26";
        theta27 "rad" start static, "rotation of disc 27";
        theta28 "rad" start static, "rotation of disc 28";
        theta29 "rad" start static, "rotation of disc 29";
        theta30 "rad" start static, "rotation of disc 30";
        theta31 "rad" start static, "rotation of disc 31";
        theta32 "rad" start static, "rotation of disc 32";
    }
    parameters {
        I1 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 1";
        I2 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 2";
        I3 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 3";
        I4 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 4";
        I5 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 5";
        I6 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 6";
        I7 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 7";
        I8 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 8";
        I9 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 9";
        I10 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 10";
        I11 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 11";
        I12 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 12";
        I13 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 13";
        I14 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 14";
        I15 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 15";
        I16 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 16";
        I17 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 17";
        I18 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 18";
        I19 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 19";
        I20 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 20";
        I21 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 21";
        I22 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 22";
        I23 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 23";
        I24 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 24";
        I25 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 25";
        I26 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 26";
        I27 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 27";
        I28 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 28";
        I29 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 29";
        I30 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 30";
        I31 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 31";
        I32 "kg*m^2" required, open 0.0 to inf, "moment of inertia of the disc 32";
        k1 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 1 and 2";
        k2 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 2 and 3";
        k3 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 3 and 4";
        k4 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 4 and 5";
        k5 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 5 and 6";
        k6 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 6 and 7";
        k7 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 7 and 8";
        k8 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 8 and 9";
        k9 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 9 and 10";
        k10 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 10 and 11";
        k11 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 11 and 12";
        k12 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 12 and 13";
        k13 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 13 and 14";
        k14 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 14 and 15";
        k15 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 15 and 16";
        k16 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 16 and 17";
        k17 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 17 and 18";
        k18 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 18 and 19";
        k19 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 19 and 20";
        k20 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 20 and 21";
        k21 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 21 and 22";
        k22 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 22 and 23";
        k23 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 23 and 24";
        k24 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 24 and 25";
        k25 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 25 and 26";
        k26 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 26 and 27";
        k27 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 27 and 28";
        k28 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 28 and 29";
        k29 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 29 and 30";
        k30 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 30 and 31";
        k31 "N*m/rad" required, from 0.0 to inf, "torsional stiffness of the shaft between discs 31 and 32";
        T_motor "N*m" required, open -inf to inf, "driving torque of the first disc";
        T_load "N*m" required, open -inf to inf, "load torque of the last disc, against its rotation";
        alpha_M "1/s" default 0.0, from 0.0 to inf, "damping in proportion to inertia";
        beta_K "s" default 0.0, from 0.0 to inf, "damping in proportion to stiffness";
    }
    laws {
    }
    motions {
        speed "rad/s" { theta1_dot = 1.0; theta2_dot = 1.0; theta3_dot = 1.0; theta4_dot = 1.0; theta5_dot = 1.0; theta6_dot = 1.0; theta7_dot = 1.0; theta8_dot = 1.0; theta9_dot = 1.0; theta10_dot = 1.0; theta11_dot = 1.0; theta12_dot = 1.0; theta13_dot = 1.0; theta14_dot = 1.0; theta15_dot = 1.0; theta16_dot = 1.0; theta17_dot = 1.0; theta18_dot = 1.0; theta19_dot = 1.0; theta20_dot = 1.0; theta21_dot = 1.0; theta22_dot = 1.0; theta23_dot = 1.0; theta24_dot = 1.0; theta25_dot = 1.0; theta26_dot = 1.0; theta27_dot = 1.0; theta28_dot = 1.0; theta29_dot = 1.0; theta30_dot = 1.0; theta31_dot = 1.0; theta32_dot = 1.0; }, "rotational speed of the shaft";
    }
    effects {
        torques "constant torques of motor and load";
        damping "Rayleigh damping, C = alpha_M M + beta_K K at the mid stiffness";
    }
    conditions {
    }

    deflections {
        twist1 = theta1 - theta2;
        twist2 = theta2 - theta3;
        twist3 = theta3 - theta4;
        twist4 = theta4 - theta5;
        twist5 = theta5 - theta6;
        twist6 = theta6 - theta7;
        twist7 = theta7 - theta8;
        twist8 = theta8 - theta9;
        twist9 = theta9 - theta10;
        twist10 = theta10 - theta11;
        twist11 = theta11 - theta12;
        twist12 = theta12 - theta13;
        twist13 = theta13 - theta14;
        twist14 = theta14 - theta15;
        twist15 = theta15 - theta16;
        twist16 = theta16 - theta17;
        twist17 = theta17 - theta18;
        twist18 = theta18 - theta19;
        twist19 = theta19 - theta20;
        twist20 = theta20 - theta21;
        twist21 = theta21 - theta22;
        twist22 = theta22 - theta23;
        twist23 = theta23 - theta24;
        twist24 = theta24 - theta25;
        twist25 = theta25 - theta26;
        twist26 = theta26 - theta27;
        twist27 = theta27 - theta28;
        twist28 = theta28 - theta29;
        twist29 = theta29 - theta30;
        twist30 = theta30 - theta31;
        twist31 = theta31 - theta32;
    }
    energies {
        kinetic {
            _ => (I1*theta1_dot.powi(2) + I10*theta10_dot.powi(2) + I11*theta11_dot.powi(2) + I12*theta12_dot.powi(2) + I13*theta13_dot.powi(2) + I14*theta14_dot.powi(2) + I15*theta15_dot.powi(2) + I16*theta16_dot.powi(2) + I17*theta17_dot.powi(2) + I18*theta18_dot.powi(2) + I19*theta19_dot.powi(2) + I2*theta2_dot.powi(2) + I20*theta20_dot.powi(2) + I21*theta21_dot.powi(2) + I22*theta22_dot.powi(2) + I23*theta23_dot.powi(2) + I24*theta24_dot.powi(2) + I25*theta25_dot.powi(2) + I26*theta26_dot.powi(2) + I27*theta27_dot.powi(2) + I28*theta28_dot.powi(2) + I29*theta29_dot.powi(2) + I3*theta3_dot.powi(2) + I30*theta30_dot.powi(2) + I31*theta31_dot.powi(2) + I32*theta32_dot.powi(2) + I4*theta4_dot.powi(2) + I5*theta5_dot.powi(2) + I6*theta6_dot.powi(2) + I7*theta7_dot.powi(2) + I8*theta8_dot.powi(2) + I9*theta9_dot.powi(2))/2.0;
        }
        potential {
            _ => (k1*twist1.powi(2) + k10*twist10.powi(2) + k11*twist11.powi(2) + k12*twist12.powi(2) + k13*twist13.powi(2) + k14*twist14.powi(2) + k15*twist15.powi(2) + k16*twist16.powi(2) + k17*twist17.powi(2) + k18*twist18.powi(2) + k19*twist19.powi(2) + k2*twist2.powi(2) + k20*twist20.powi(2) + k21*twist21.powi(2) + k22*twist22.powi(2) + k23*twist23.powi(2) + k24*twist24.powi(2) + k25*twist25.powi(2) + k26*twist26.powi(2) + k27*twist27.powi(2) + k28*twist28.powi(2) + k29*twist29.powi(2) + k3*twist3.powi(2) + k30*twist30.powi(2) + k31*twist31.powi(2) + k4*twist4.powi(2) + k5*twist5.powi(2) + k6*twist6.powi(2) + k7*twist7.powi(2) + k8*twist8.powi(2) + k9*twist9.powi(2))/2.0;
        }
        dissipation {
            damping => (I1*alpha_M*theta1_dot.powi(2) + I10*alpha_M*theta10_dot.powi(2) + I11*alpha_M*theta11_dot.powi(2) + I12*alpha_M*theta12_dot.powi(2) + I13*alpha_M*theta13_dot.powi(2) + I14*alpha_M*theta14_dot.powi(2) + I15*alpha_M*theta15_dot.powi(2) + I16*alpha_M*theta16_dot.powi(2) + I17*alpha_M*theta17_dot.powi(2) + I18*alpha_M*theta18_dot.powi(2) + I19*alpha_M*theta19_dot.powi(2) + I2*alpha_M*theta2_dot.powi(2) + I20*alpha_M*theta20_dot.powi(2) + I21*alpha_M*theta21_dot.powi(2) + I22*alpha_M*theta22_dot.powi(2) + I23*alpha_M*theta23_dot.powi(2) + I24*alpha_M*theta24_dot.powi(2) + I25*alpha_M*theta25_dot.powi(2) + I26*alpha_M*theta26_dot.powi(2) + I27*alpha_M*theta27_dot.powi(2) + I28*alpha_M*theta28_dot.powi(2) + I29*alpha_M*theta29_dot.powi(2) + I3*alpha_M*theta3_dot.powi(2) + I30*alpha_M*theta30_dot.powi(2) + I31*alpha_M*theta31_dot.powi(2) + I32*alpha_M*theta32_dot.powi(2) + I4*alpha_M*theta4_dot.powi(2) + I5*alpha_M*theta5_dot.powi(2) + I6*alpha_M*theta6_dot.powi(2) + I7*alpha_M*theta7_dot.powi(2) + I8*alpha_M*theta8_dot.powi(2) + I9*alpha_M*theta9_dot.powi(2) + beta_K*k1*twist1_dot.powi(2) + beta_K*k10*twist10_dot.powi(2) + beta_K*k11*twist11_dot.powi(2) + beta_K*k12*twist12_dot.powi(2) + beta_K*k13*twist13_dot.powi(2) + beta_K*k14*twist14_dot.powi(2) + beta_K*k15*twist15_dot.powi(2) + beta_K*k16*twist16_dot.powi(2) + beta_K*k17*twist17_dot.powi(2) + beta_K*k18*twist18_dot.powi(2) + beta_K*k19*twist19_dot.powi(2) + beta_K*k2*twist2_dot.powi(2) + beta_K*k20*twist20_dot.powi(2) + beta_K*k21*twist21_dot.powi(2) + beta_K*k22*twist22_dot.powi(2) + beta_K*k23*twist23_dot.powi(2) + beta_K*k24*twist24_dot.powi(2) + beta_K*k25*twist25_dot.powi(2) + beta_K*k26*twist26_dot.powi(2) + beta_K*k27*twist27_dot.powi(2) + beta_K*k28*twist28_dot.powi(2) + beta_K*k29*twist29_dot.powi(2) + beta_K*k3*twist3_dot.powi(2) + beta_K*k30*twist30_dot.powi(2) + beta_K*k31*twist31_dot.powi(2) + beta_K*k4*twist4_dot.powi(2) + beta_K*k5*twist5_dot.powi(2) + beta_K*k6*twist6_dot.powi(2) + beta_K*k7*twist7_dot.powi(2) + beta_K*k8*twist8_dot.powi(2) + beta_K*k9*twist9_dot.powi(2))/2.0;
        }
    }
    torques {
        motor "driving torque of the first disc" {
            torques => T_motor*theta1;
        }
        load "load torque of the last disc, against its rotation" {
            torques => -T_load*theta32;
        }
    }
    work {
        theta1 {
            torques => T_motor;
        }
        theta2 {}
        theta3 {}
        theta4 {}
        theta5 {}
        theta6 {}
        theta7 {}
        theta8 {}
        theta9 {}
        theta10 {}
        theta11 {}
        theta12 {}
        theta13 {}
        theta14 {}
        theta15 {}
        theta16 {}
        theta17 {}
        theta18 {}
        theta19 {}
        theta20 {}
        theta21 {}
        theta22 {}
        theta23 {}
        theta24 {}
        theta25 {}
        theta26 {}
        theta27 {}
        theta28 {}
        theta29 {}
        theta30 {}
        theta31 {}
        theta32 {
            torques => -T_load;
        }
    }
    mass {
        theta1 theta1 {
            _ => I1;
        }
        theta2 theta2 {
            _ => I2;
        }
        theta3 theta3 {
            _ => I3;
        }
        theta4 theta4 {
            _ => I4;
        }
        theta5 theta5 {
            _ => I5;
        }
        theta6 theta6 {
            _ => I6;
        }
        theta7 theta7 {
            _ => I7;
        }
        theta8 theta8 {
            _ => I8;
        }
        theta9 theta9 {
            _ => I9;
        }
        theta10 theta10 {
            _ => I10;
        }
        theta11 theta11 {
            _ => I11;
        }
        theta12 theta12 {
            _ => I12;
        }
        theta13 theta13 {
            _ => I13;
        }
        theta14 theta14 {
            _ => I14;
        }
        theta15 theta15 {
            _ => I15;
        }
        theta16 theta16 {
            _ => I16;
        }
        theta17 theta17 {
            _ => I17;
        }
        theta18 theta18 {
            _ => I18;
        }
        theta19 theta19 {
            _ => I19;
        }
        theta20 theta20 {
            _ => I20;
        }
        theta21 theta21 {
            _ => I21;
        }
        theta22 theta22 {
            _ => I22;
        }
        theta23 theta23 {
            _ => I23;
        }
        theta24 theta24 {
            _ => I24;
        }
        theta25 theta25 {
            _ => I25;
        }
        theta26 theta26 {
            _ => I26;
        }
        theta27 theta27 {
            _ => I27;
        }
        theta28 theta28 {
            _ => I28;
        }
        theta29 theta29 {
            _ => I29;
        }
        theta30 theta30 {
            _ => I30;
        }
        theta31 theta31 {
            _ => I31;
        }
        theta32 theta32 {
            _ => I32;
        }
    }
    force {
        theta1 {
            _ => -k1*twist1;
            torques => T_motor;
            damping => -I1*alpha_M*theta1_dot - beta_K*k1*twist1_dot;
        }
        theta2 {
            _ => k1*twist1 - k2*twist2;
            damping => beta_K*k1*twist1_dot - I2*alpha_M*theta2_dot - beta_K*k2*twist2_dot;
        }
        theta3 {
            _ => k2*twist2 - k3*twist3;
            damping => beta_K*k2*twist2_dot - I3*alpha_M*theta3_dot - beta_K*k3*twist3_dot;
        }
        theta4 {
            _ => k3*twist3 - k4*twist4;
            damping => beta_K*k3*twist3_dot - I4*alpha_M*theta4_dot - beta_K*k4*twist4_dot;
        }
        theta5 {
            _ => k4*twist4 - k5*twist5;
            damping => beta_K*k4*twist4_dot - I5*alpha_M*theta5_dot - beta_K*k5*twist5_dot;
        }
        theta6 {
            _ => k5*twist5 - k6*twist6;
            damping => beta_K*k5*twist5_dot - I6*alpha_M*theta6_dot - beta_K*k6*twist6_dot;
        }
        theta7 {
            _ => k6*twist6 - k7*twist7;
            damping => beta_K*k6*twist6_dot - I7*alpha_M*theta7_dot - beta_K*k7*twist7_dot;
        }
        theta8 {
            _ => k7*twist7 - k8*twist8;
            damping => beta_K*k7*twist7_dot - I8*alpha_M*theta8_dot - beta_K*k8*twist8_dot;
        }
        theta9 {
            _ => k8*twist8 - k9*twist9;
            damping => beta_K*k8*twist8_dot - I9*alpha_M*theta9_dot - beta_K*k9*twist9_dot;
        }
        theta10 {
            _ => k9*twist9 - k10*twist10;
            damping => beta_K*k9*twist9_dot - I10*alpha_M*theta10_dot - beta_K*k10*twist10_dot;
        }
        theta11 {
            _ => k10*twist10 - k11*twist11;
            damping => beta_K*k10*twist10_dot - I11*alpha_M*theta11_dot - beta_K*k11*twist11_dot;
        }
        theta12 {
            _ => k11*twist11 - k12*twist12;
            damping => beta_K*k11*twist11_dot - I12*alpha_M*theta12_dot - beta_K*k12*twist12_dot;
        }
        theta13 {
            _ => k12*twist12 - k13*twist13;
            damping => beta_K*k12*twist12_dot - I13*alpha_M*theta13_dot - beta_K*k13*twist13_dot;
        }
        theta14 {
            _ => k13*twist13 - k14*twist14;
            damping => beta_K*k13*twist13_dot - I14*alpha_M*theta14_dot - beta_K*k14*twist14_dot;
        }
        theta15 {
            _ => k14*twist14 - k15*twist15;
            damping => beta_K*k14*twist14_dot - I15*alpha_M*theta15_dot - beta_K*k15*twist15_dot;
        }
        theta16 {
            _ => k15*twist15 - k16*twist16;
            damping => beta_K*k15*twist15_dot - I16*alpha_M*theta16_dot - beta_K*k16*twist16_dot;
        }
        theta17 {
            _ => k16*twist16 - k17*twist17;
            damping => beta_K*k16*twist16_dot - I17*alpha_M*theta17_dot - beta_K*k17*twist17_dot;
        }
        theta18 {
            _ => k17*twist17 - k18*twist18;
            damping => beta_K*k17*twist17_dot - I18*alpha_M*theta18_dot - beta_K*k18*twist18_dot;
        }
        theta19 {
            _ => k18*twist18 - k19*twist19;
            damping => beta_K*k18*twist18_dot - I19*alpha_M*theta19_dot - beta_K*k19*twist19_dot;
        }
        theta20 {
            _ => k19*twist19 - k20*twist20;
            damping => beta_K*k19*twist19_dot - I20*alpha_M*theta20_dot - beta_K*k20*twist20_dot;
        }
        theta21 {
            _ => k20*twist20 - k21*twist21;
            damping => beta_K*k20*twist20_dot - I21*alpha_M*theta21_dot - beta_K*k21*twist21_dot;
        }
        theta22 {
            _ => k21*twist21 - k22*twist22;
            damping => beta_K*k21*twist21_dot - I22*alpha_M*theta22_dot - beta_K*k22*twist22_dot;
        }
        theta23 {
            _ => k22*twist22 - k23*twist23;
            damping => beta_K*k22*twist22_dot - I23*alpha_M*theta23_dot - beta_K*k23*twist23_dot;
        }
        theta24 {
            _ => k23*twist23 - k24*twist24;
            damping => beta_K*k23*twist23_dot - I24*alpha_M*theta24_dot - beta_K*k24*twist24_dot;
        }
        theta25 {
            _ => k24*twist24 - k25*twist25;
            damping => beta_K*k24*twist24_dot - I25*alpha_M*theta25_dot - beta_K*k25*twist25_dot;
        }
        theta26 {
            _ => k25*twist25 - k26*twist26;
            damping => beta_K*k25*twist25_dot - I26*alpha_M*theta26_dot - beta_K*k26*twist26_dot;
        }
        theta27 {
            _ => k26*twist26 - k27*twist27;
            damping => beta_K*k26*twist26_dot - I27*alpha_M*theta27_dot - beta_K*k27*twist27_dot;
        }
        theta28 {
            _ => k27*twist27 - k28*twist28;
            damping => beta_K*k27*twist27_dot - I28*alpha_M*theta28_dot - beta_K*k28*twist28_dot;
        }
        theta29 {
            _ => k28*twist28 - k29*twist29;
            damping => beta_K*k28*twist28_dot - I29*alpha_M*theta29_dot - beta_K*k29*twist29_dot;
        }
        theta30 {
            _ => k29*twist29 - k30*twist30;
            damping => beta_K*k29*twist29_dot - I30*alpha_M*theta30_dot - beta_K*k30*twist30_dot;
        }
        theta31 {
            _ => k30*twist30 - k31*twist31;
            damping => beta_K*k30*twist30_dot - I31*alpha_M*theta31_dot - beta_K*k31*twist31_dot;
        }
        theta32 {
            _ => k31*twist31;
            torques => -T_load;
            damping => beta_K*k31*twist31_dot - I32*alpha_M*theta32_dot;
        }
    }
    jacobian {
        theta1 theta1 {
            _ => -k1;
        }
        theta1 theta2 {
            _ => k1;
        }
        theta1 theta1_dot {
            damping => -I1*alpha_M - beta_K*k1;
        }
        theta1 theta2_dot {
            damping => beta_K*k1;
        }
        theta2 theta1 {
            _ => k1;
        }
        theta2 theta2 {
            _ => -k1 - k2;
        }
        theta2 theta3 {
            _ => k2;
        }
        theta2 theta1_dot {
            damping => beta_K*k1;
        }
        theta2 theta2_dot {
            damping => -I2*alpha_M - beta_K*k1 - beta_K*k2;
        }
        theta2 theta3_dot {
            damping => beta_K*k2;
        }
        theta3 theta2 {
            _ => k2;
        }
        theta3 theta3 {
            _ => -k2 - k3;
        }
        theta3 theta4 {
            _ => k3;
        }
        theta3 theta2_dot {
            damping => beta_K*k2;
        }
        theta3 theta3_dot {
            damping => -I3*alpha_M - beta_K*k2 - beta_K*k3;
        }
        theta3 theta4_dot {
            damping => beta_K*k3;
        }
        theta4 theta3 {
            _ => k3;
        }
        theta4 theta4 {
            _ => -k3 - k4;
        }
        theta4 theta5 {
            _ => k4;
        }
        theta4 theta3_dot {
            damping => beta_K*k3;
        }
        theta4 theta4_dot {
            damping => -I4*alpha_M - beta_K*k3 - beta_K*k4;
        }
        theta4 theta5_dot {
            damping => beta_K*k4;
        }
        theta5 theta4 {
            _ => k4;
        }
        theta5 theta5 {
            _ => -k4 - k5;
        }
        theta5 theta6 {
            _ => k5;
        }
        theta5 theta4_dot {
            damping => beta_K*k4;
        }
        theta5 theta5_dot {
            damping => -I5*alpha_M - beta_K*k4 - beta_K*k5;
        }
        theta5 theta6_dot {
            damping => beta_K*k5;
        }
        theta6 theta5 {
            _ => k5;
        }
        theta6 theta6 {
            _ => -k5 - k6;
        }
        theta6 theta7 {
            _ => k6;
        }
        theta6 theta5_dot {
            damping => beta_K*k5;
        }
        theta6 theta6_dot {
            damping => -I6*alpha_M - beta_K*k5 - beta_K*k6;
        }
        theta6 theta7_dot {
            damping => beta_K*k6;
        }
        theta7 theta6 {
            _ => k6;
        }
        theta7 theta7 {
            _ => -k6 - k7;
        }
        theta7 theta8 {
            _ => k7;
        }
        theta7 theta6_dot {
            damping => beta_K*k6;
        }
        theta7 theta7_dot {
            damping => -I7*alpha_M - beta_K*k6 - beta_K*k7;
        }
        theta7 theta8_dot {
            damping => beta_K*k7;
        }
        theta8 theta7 {
            _ => k7;
        }
        theta8 theta8 {
            _ => -k7 - k8;
        }
        theta8 theta9 {
            _ => k8;
        }
        theta8 theta7_dot {
            damping => beta_K*k7;
        }
        theta8 theta8_dot {
            damping => -I8*alpha_M - beta_K*k7 - beta_K*k8;
        }
        theta8 theta9_dot {
            damping => beta_K*k8;
        }
        theta9 theta8 {
            _ => k8;
        }
        theta9 theta9 {
            _ => -k8 - k9;
        }
        theta9 theta10 {
            _ => k9;
        }
        theta9 theta8_dot {
            damping => beta_K*k8;
        }
        theta9 theta9_dot {
            damping => -I9*alpha_M - beta_K*k8 - beta_K*k9;
        }
        theta9 theta10_dot {
            damping => beta_K*k9;
        }
        theta10 theta9 {
            _ => k9;
        }
        theta10 theta10 {
            _ => -k10 - k9;
        }
        theta10 theta11 {
            _ => k10;
        }
        theta10 theta9_dot {
            damping => beta_K*k9;
        }
        theta10 theta10_dot {
            damping => -I10*alpha_M - beta_K*k10 - beta_K*k9;
        }
        theta10 theta11_dot {
            damping => beta_K*k10;
        }
        theta11 theta10 {
            _ => k10;
        }
        theta11 theta11 {
            _ => -k10 - k11;
        }
        theta11 theta12 {
            _ => k11;
        }
        theta11 theta10_dot {
            damping => beta_K*k10;
        }
        theta11 theta11_dot {
            damping => -I11*alpha_M - beta_K*k10 - beta_K*k11;
        }
        theta11 theta12_dot {
            damping => beta_K*k11;
        }
        theta12 theta11 {
            _ => k11;
        }
        theta12 theta12 {
            _ => -k11 - k12;
        }
        theta12 theta13 {
            _ => k12;
        }
        theta12 theta11_dot {
            damping => beta_K*k11;
        }
        theta12 theta12_dot {
            damping => -I12*alpha_M - beta_K*k11 - beta_K*k12;
        }
        theta12 theta13_dot {
            damping => beta_K*k12;
        }
        theta13 theta12 {
            _ => k12;
        }
        theta13 theta13 {
            _ => -k12 - k13;
        }
        theta13 theta14 {
            _ => k13;
        }
        theta13 theta12_dot {
            damping => beta_K*k12;
        }
        theta13 theta13_dot {
            damping => -I13*alpha_M - beta_K*k12 - beta_K*k13;
        }
        theta13 theta14_dot {
            damping => beta_K*k13;
        }
        theta14 theta13 {
            _ => k13;
        }
        theta14 theta14 {
            _ => -k13 - k14;
        }
        theta14 theta15 {
            _ => k14;
        }
        theta14 theta13_dot {
            damping => beta_K*k13;
        }
        theta14 theta14_dot {
            damping => -I14*alpha_M - beta_K*k13 - beta_K*k14;
        }
        theta14 theta15_dot {
            damping => beta_K*k14;
        }
        theta15 theta14 {
            _ => k14;
        }
        theta15 theta15 {
            _ => -k14 - k15;
        }
        theta15 theta16 {
            _ => k15;
        }
        theta15 theta14_dot {
            damping => beta_K*k14;
        }
        theta15 theta15_dot {
            damping => -I15*alpha_M - beta_K*k14 - beta_K*k15;
        }
        theta15 theta16_dot {
            damping => beta_K*k15;
        }
        theta16 theta15 {
            _ => k15;
        }
        theta16 theta16 {
            _ => -k15 - k16;
        }
        theta16 theta17 {
            _ => k16;
        }
        theta16 theta15_dot {
            damping => beta_K*k15;
        }
        theta16 theta16_dot {
            damping => -I16*alpha_M - beta_K*k15 - beta_K*k16;
        }
        theta16 theta17_dot {
            damping => beta_K*k16;
        }
        theta17 theta16 {
            _ => k16;
        }
        theta17 theta17 {
            _ => -k16 - k17;
        }
        theta17 theta18 {
            _ => k17;
        }
        theta17 theta16_dot {
            damping => beta_K*k16;
        }
        theta17 theta17_dot {
            damping => -I17*alpha_M - beta_K*k16 - beta_K*k17;
        }
        theta17 theta18_dot {
            damping => beta_K*k17;
        }
        theta18 theta17 {
            _ => k17;
        }
        theta18 theta18 {
            _ => -k17 - k18;
        }
        theta18 theta19 {
            _ => k18;
        }
        theta18 theta17_dot {
            damping => beta_K*k17;
        }
        theta18 theta18_dot {
            damping => -I18*alpha_M - beta_K*k17 - beta_K*k18;
        }
        theta18 theta19_dot {
            damping => beta_K*k18;
        }
        theta19 theta18 {
            _ => k18;
        }
        theta19 theta19 {
            _ => -k18 - k19;
        }
        theta19 theta20 {
            _ => k19;
        }
        theta19 theta18_dot {
            damping => beta_K*k18;
        }
        theta19 theta19_dot {
            damping => -I19*alpha_M - beta_K*k18 - beta_K*k19;
        }
        theta19 theta20_dot {
            damping => beta_K*k19;
        }
        theta20 theta19 {
            _ => k19;
        }
        theta20 theta20 {
            _ => -k19 - k20;
        }
        theta20 theta21 {
            _ => k20;
        }
        theta20 theta19_dot {
            damping => beta_K*k19;
        }
        theta20 theta20_dot {
            damping => -I20*alpha_M - beta_K*k19 - beta_K*k20;
        }
        theta20 theta21_dot {
            damping => beta_K*k20;
        }
        theta21 theta20 {
            _ => k20;
        }
        theta21 theta21 {
            _ => -k20 - k21;
        }
        theta21 theta22 {
            _ => k21;
        }
        theta21 theta20_dot {
            damping => beta_K*k20;
        }
        theta21 theta21_dot {
            damping => -I21*alpha_M - beta_K*k20 - beta_K*k21;
        }
        theta21 theta22_dot {
            damping => beta_K*k21;
        }
        theta22 theta21 {
            _ => k21;
        }
        theta22 theta22 {
            _ => -k21 - k22;
        }
        theta22 theta23 {
            _ => k22;
        }
        theta22 theta21_dot {
            damping => beta_K*k21;
        }
        theta22 theta22_dot {
            damping => -I22*alpha_M - beta_K*k21 - beta_K*k22;
        }
        theta22 theta23_dot {
            damping => beta_K*k22;
        }
        theta23 theta22 {
            _ => k22;
        }
        theta23 theta23 {
            _ => -k22 - k23;
        }
        theta23 theta24 {
            _ => k23;
        }
        theta23 theta22_dot {
            damping => beta_K*k22;
        }
        theta23 theta23_dot {
            damping => -I23*alpha_M - beta_K*k22 - beta_K*k23;
        }
        theta23 theta24_dot {
            damping => beta_K*k23;
        }
        theta24 theta23 {
            _ => k23;
        }
        theta24 theta24 {
            _ => -k23 - k24;
        }
        theta24 theta25 {
            _ => k24;
        }
        theta24 theta23_dot {
            damping => beta_K*k23;
        }
        theta24 theta24_dot {
            damping => -I24*alpha_M - beta_K*k23 - beta_K*k24;
        }
        theta24 theta25_dot {
            damping => beta_K*k24;
        }
        theta25 theta24 {
            _ => k24;
        }
        theta25 theta25 {
            _ => -k24 - k25;
        }
        theta25 theta26 {
            _ => k25;
        }
        theta25 theta24_dot {
            damping => beta_K*k24;
        }
        theta25 theta25_dot {
            damping => -I25*alpha_M - beta_K*k24 - beta_K*k25;
        }
        theta25 theta26_dot {
            damping => beta_K*k25;
        }
        theta26 theta25 {
            _ => k25;
        }
        theta26 theta26 {
            _ => -k25 - k26;
        }
        theta26 theta27 {
            _ => k26;
        }
        theta26 theta25_dot {
            damping => beta_K*k25;
        }
        theta26 theta26_dot {
            damping => -I26*alpha_M - beta_K*k25 - beta_K*k26;
        }
        theta26 theta27_dot {
            damping => beta_K*k26;
        }
        theta27 theta26 {
            _ => k26;
        }
        theta27 theta27 {
            _ => -k26 - k27;
        }
        theta27 theta28 {
            _ => k27;
        }
        theta27 theta26_dot {
            damping => beta_K*k26;
        }
        theta27 theta27_dot {
            damping => -I27*alpha_M - beta_K*k26 - beta_K*k27;
        }
        theta27 theta28_dot {
            damping => beta_K*k27;
        }
        theta28 theta27 {
            _ => k27;
        }
        theta28 theta28 {
            _ => -k27 - k28;
        }
        theta28 theta29 {
            _ => k28;
        }
        theta28 theta27_dot {
            damping => beta_K*k27;
        }
        theta28 theta28_dot {
            damping => -I28*alpha_M - beta_K*k27 - beta_K*k28;
        }
        theta28 theta29_dot {
            damping => beta_K*k28;
        }
        theta29 theta28 {
            _ => k28;
        }
        theta29 theta29 {
            _ => -k28 - k29;
        }
        theta29 theta30 {
            _ => k29;
        }
        theta29 theta28_dot {
            damping => beta_K*k28;
        }
        theta29 theta29_dot {
            damping => -I29*alpha_M - beta_K*k28 - beta_K*k29;
        }
        theta29 theta30_dot {
            damping => beta_K*k29;
        }
        theta30 theta29 {
            _ => k29;
        }
        theta30 theta30 {
            _ => -k29 - k30;
        }
        theta30 theta31 {
            _ => k30;
        }
        theta30 theta29_dot {
            damping => beta_K*k29;
        }
        theta30 theta30_dot {
            damping => -I30*alpha_M - beta_K*k29 - beta_K*k30;
        }
        theta30 theta31_dot {
            damping => beta_K*k30;
        }
        theta31 theta30 {
            _ => k30;
        }
        theta31 theta31 {
            _ => -k30 - k31;
        }
        theta31 theta32 {
            _ => k31;
        }
        theta31 theta30_dot {
            damping => beta_K*k30;
        }
        theta31 theta31_dot {
            damping => -I31*alpha_M - beta_K*k30 - beta_K*k31;
        }
        theta31 theta32_dot {
            damping => beta_K*k31;
        }
        theta32 theta31 {
            _ => k31;
        }
        theta32 theta32 {
            _ => -k31;
        }
        theta32 theta31_dot {
            damping => beta_K*k31;
        }
        theta32 theta32_dot {
            damping => -I32*alpha_M - beta_K*k31;
        }
    }
    cell {
        stiffness {
            theta1 theta1 {
                _ => k1;
            }
            theta1 theta2 {
                _ => -k1;
            }
            theta2 theta2 {
                _ => k1 + k2;
            }
            theta2 theta3 {
                _ => -k2;
            }
            theta3 theta3 {
                _ => k2 + k3;
            }
            theta3 theta4 {
                _ => -k3;
            }
            theta4 theta4 {
                _ => k3 + k4;
            }
            theta4 theta5 {
                _ => -k4;
            }
            theta5 theta5 {
                _ => k4 + k5;
            }
            theta5 theta6 {
                _ => -k5;
            }
            theta6 theta6 {
                _ => k5 + k6;
            }
            theta6 theta7 {
                _ => -k6;
            }
            theta7 theta7 {
                _ => k6 + k7;
            }
            theta7 theta8 {
                _ => -k7;
            }
            theta8 theta8 {
                _ => k7 + k8;
            }
            theta8 theta9 {
                _ => -k8;
            }
            theta9 theta9 {
                _ => k8 + k9;
            }
            theta9 theta10 {
                _ => -k9;
            }
            theta10 theta10 {
                _ => k10 + k9;
            }
            theta10 theta11 {
                _ => -k10;
            }
            theta11 theta11 {
                _ => k10 + k11;
            }
            theta11 theta12 {
                _ => -k11;
            }
            theta12 theta12 {
                _ => k11 + k12;
            }
            theta12 theta13 {
                _ => -k12;
            }
            theta13 theta13 {
                _ => k12 + k13;
            }
            theta13 theta14 {
                _ => -k13;
            }
            theta14 theta14 {
                _ => k13 + k14;
            }
            theta14 theta15 {
                _ => -k14;
            }
            theta15 theta15 {
                _ => k14 + k15;
            }
            theta15 theta16 {
                _ => -k15;
            }
            theta16 theta16 {
                _ => k15 + k16;
            }
            theta16 theta17 {
                _ => -k16;
            }
            theta17 theta17 {
                _ => k16 + k17;
            }
            theta17 theta18 {
                _ => -k17;
            }
            theta18 theta18 {
                _ => k17 + k18;
            }
            theta18 theta19 {
                _ => -k18;
            }
            theta19 theta19 {
                _ => k18 + k19;
            }
            theta19 theta20 {
                _ => -k19;
            }
            theta20 theta20 {
                _ => k19 + k20;
            }
            theta20 theta21 {
                _ => -k20;
            }
            theta21 theta21 {
                _ => k20 + k21;
            }
            theta21 theta22 {
                _ => -k21;
            }
            theta22 theta22 {
                _ => k21 + k22;
            }
            theta22 theta23 {
                _ => -k22;
            }
            theta23 theta23 {
                _ => k22 + k23;
            }
            theta23 theta24 {
                _ => -k23;
            }
            theta24 theta24 {
                _ => k23 + k24;
            }
            theta24 theta25 {
                _ => -k24;
            }
            theta25 theta25 {
                _ => k24 + k25;
            }
            theta25 theta26 {
                _ => -k25;
            }
            theta26 theta26 {
                _ => k25 + k26;
            }
            theta26 theta27 {
                _ => -k26;
            }
            theta27 theta27 {
                _ => k26 + k27;
            }
            theta27 theta28 {
                _ => -k27;
            }
            theta28 theta28 {
                _ => k27 + k28;
            }
            theta28 theta29 {
                _ => -k28;
            }
            theta29 theta29 {
                _ => k28 + k29;
            }
            theta29 theta30 {
                _ => -k29;
            }
            theta30 theta30 {
                _ => k29 + k30;
            }
            theta30 theta31 {
                _ => -k30;
            }
            theta31 theta31 {
                _ => k30 + k31;
            }
            theta31 theta32 {
                _ => -k31;
            }
            theta32 theta32 {
                _ => k31;
            }
        }
        damping {
            theta1 theta1 {
                damping => I1*alpha_M + beta_K*k1;
            }
            theta1 theta2 {
                damping => -beta_K*k1;
            }
            theta2 theta2 {
                damping => I2*alpha_M + beta_K*k1 + beta_K*k2;
            }
            theta2 theta3 {
                damping => -beta_K*k2;
            }
            theta3 theta3 {
                damping => I3*alpha_M + beta_K*k2 + beta_K*k3;
            }
            theta3 theta4 {
                damping => -beta_K*k3;
            }
            theta4 theta4 {
                damping => I4*alpha_M + beta_K*k3 + beta_K*k4;
            }
            theta4 theta5 {
                damping => -beta_K*k4;
            }
            theta5 theta5 {
                damping => I5*alpha_M + beta_K*k4 + beta_K*k5;
            }
            theta5 theta6 {
                damping => -beta_K*k5;
            }
            theta6 theta6 {
                damping => I6*alpha_M + beta_K*k5 + beta_K*k6;
            }
            theta6 theta7 {
                damping => -beta_K*k6;
            }
            theta7 theta7 {
                damping => I7*alpha_M + beta_K*k6 + beta_K*k7;
            }
            theta7 theta8 {
                damping => -beta_K*k7;
            }
            theta8 theta8 {
                damping => I8*alpha_M + beta_K*k7 + beta_K*k8;
            }
            theta8 theta9 {
                damping => -beta_K*k8;
            }
            theta9 theta9 {
                damping => I9*alpha_M + beta_K*k8 + beta_K*k9;
            }
            theta9 theta10 {
                damping => -beta_K*k9;
            }
            theta10 theta10 {
                damping => I10*alpha_M + beta_K*k10 + beta_K*k9;
            }
            theta10 theta11 {
                damping => -beta_K*k10;
            }
            theta11 theta11 {
                damping => I11*alpha_M + beta_K*k10 + beta_K*k11;
            }
            theta11 theta12 {
                damping => -beta_K*k11;
            }
            theta12 theta12 {
                damping => I12*alpha_M + beta_K*k11 + beta_K*k12;
            }
            theta12 theta13 {
                damping => -beta_K*k12;
            }
            theta13 theta13 {
                damping => I13*alpha_M + beta_K*k12 + beta_K*k13;
            }
            theta13 theta14 {
                damping => -beta_K*k13;
            }
            theta14 theta14 {
                damping => I14*alpha_M + beta_K*k13 + beta_K*k14;
            }
            theta14 theta15 {
                damping => -beta_K*k14;
            }
            theta15 theta15 {
                damping => I15*alpha_M + beta_K*k14 + beta_K*k15;
            }
            theta15 theta16 {
                damping => -beta_K*k15;
            }
            theta16 theta16 {
                damping => I16*alpha_M + beta_K*k15 + beta_K*k16;
            }
            theta16 theta17 {
                damping => -beta_K*k16;
            }
            theta17 theta17 {
                damping => I17*alpha_M + beta_K*k16 + beta_K*k17;
            }
            theta17 theta18 {
                damping => -beta_K*k17;
            }
            theta18 theta18 {
                damping => I18*alpha_M + beta_K*k17 + beta_K*k18;
            }
            theta18 theta19 {
                damping => -beta_K*k18;
            }
            theta19 theta19 {
                damping => I19*alpha_M + beta_K*k18 + beta_K*k19;
            }
            theta19 theta20 {
                damping => -beta_K*k19;
            }
            theta20 theta20 {
                damping => I20*alpha_M + beta_K*k19 + beta_K*k20;
            }
            theta20 theta21 {
                damping => -beta_K*k20;
            }
            theta21 theta21 {
                damping => I21*alpha_M + beta_K*k20 + beta_K*k21;
            }
            theta21 theta22 {
                damping => -beta_K*k21;
            }
            theta22 theta22 {
                damping => I22*alpha_M + beta_K*k21 + beta_K*k22;
            }
            theta22 theta23 {
                damping => -beta_K*k22;
            }
            theta23 theta23 {
                damping => I23*alpha_M + beta_K*k22 + beta_K*k23;
            }
            theta23 theta24 {
                damping => -beta_K*k23;
            }
            theta24 theta24 {
                damping => I24*alpha_M + beta_K*k23 + beta_K*k24;
            }
            theta24 theta25 {
                damping => -beta_K*k24;
            }
            theta25 theta25 {
                damping => I25*alpha_M + beta_K*k24 + beta_K*k25;
            }
            theta25 theta26 {
                damping => -beta_K*k25;
            }
            theta26 theta26 {
                damping => I26*alpha_M + beta_K*k25 + beta_K*k26;
            }
            theta26 theta27 {
                damping => -beta_K*k26;
            }
            theta27 theta27 {
                damping => I27*alpha_M + beta_K*k26 + beta_K*k27;
            }
            theta27 theta28 {
                damping => -beta_K*k27;
            }
            theta28 theta28 {
                damping => I28*alpha_M + beta_K*k27 + beta_K*k28;
            }
            theta28 theta29 {
                damping => -beta_K*k28;
            }
            theta29 theta29 {
                damping => I29*alpha_M + beta_K*k28 + beta_K*k29;
            }
            theta29 theta30 {
                damping => -beta_K*k29;
            }
            theta30 theta30 {
                damping => I30*alpha_M + beta_K*k29 + beta_K*k30;
            }
            theta30 theta31 {
                damping => -beta_K*k30;
            }
            theta31 theta31 {
                damping => I31*alpha_M + beta_K*k30 + beta_K*k31;
            }
            theta31 theta32 {
                damping => -beta_K*k31;
            }
            theta32 theta32 {
                damping => I32*alpha_M + beta_K*k31;
            }
        }
        load {
            theta1 {
                torques => T_motor;
            }
            theta32 {
                torques => -T_load;
            }
        }
    }

    text {
        "T = (I1*theta1_dot^2 + I10*theta10_dot^2 + I11*theta11_dot^2 + I12*theta12_dot^2 + I13*theta13_dot^2 + I14*theta14_dot^2 + I15*theta15_dot^2 + I16*theta16_dot^2 + I17*theta17_dot^2 + I18*theta18_dot^2 + I19*theta19_dot^2 + I2*theta2_dot^2 + I20*theta20_dot^2 + I21*theta21_dot^2 + I22*theta22_dot^2 + I23*theta23_dot^2 + I24*theta24_dot^2 + I25*theta25_dot^2 + I26*theta26_dot^2 + I27*theta27_dot^2 + I28*theta28_dot^2 + I29*theta29_dot^2 + I3*theta3_dot^2 + I30*theta30_dot^2 + I31*theta31_dot^2 + I32*theta32_dot^2 + I4*theta4_dot^2 + I5*theta5_dot^2 + I6*theta6_dot^2 + I7*theta7_dot^2 + I8*theta8_dot^2 + I9*theta9_dot^2)/2";
        "V = (k1*twist1^2 + k10*twist10^2 + k11*twist11^2 + k12*twist12^2 + k13*twist13^2 + k14*twist14^2 + k15*twist15^2 + k16*twist16^2 + k17*twist17^2 + k18*twist18^2 + k19*twist19^2 + k2*twist2^2 + k20*twist20^2 + k21*twist21^2 + k22*twist22^2 + k23*twist23^2 + k24*twist24^2 + k25*twist25^2 + k26*twist26^2 + k27*twist27^2 + k28*twist28^2 + k29*twist29^2 + k3*twist3^2 + k30*twist30^2 + k31*twist31^2 + k4*twist4^2 + k5*twist5^2 + k6*twist6^2 + k7*twist7^2 + k8*twist8^2 + k9*twist9^2)/2";
        "D = (I1*alpha_M*theta1_dot^2 + I10*alpha_M*theta10_dot^2 + I11*alpha_M*theta11_dot^2 + I12*alpha_M*theta12_dot^2 + I13*alpha_M*theta13_dot^2 + I14*alpha_M*theta14_dot^2 + I15*alpha_M*theta15_dot^2 + I16*alpha_M*theta16_dot^2 + I17*alpha_M*theta17_dot^2 + I18*alpha_M*theta18_dot^2 + I19*alpha_M*theta19_dot^2 + I2*alpha_M*theta2_dot^2 + I20*alpha_M*theta20_dot^2 + I21*alpha_M*theta21_dot^2 + I22*alpha_M*theta22_dot^2 + I23*alpha_M*theta23_dot^2 + I24*alpha_M*theta24_dot^2 + I25*alpha_M*theta25_dot^2 + I26*alpha_M*theta26_dot^2 + I27*alpha_M*theta27_dot^2 + I28*alpha_M*theta28_dot^2 + I29*alpha_M*theta29_dot^2 + I3*alpha_M*theta3_dot^2 + I30*alpha_M*theta30_dot^2 + I31*alpha_M*theta31_dot^2 + I32*alpha_M*theta32_dot^2 + I4*alpha_M*theta4_dot^2 + I5*alpha_M*theta5_dot^2 + I6*alpha_M*theta6_dot^2 + I7*alpha_M*theta7_dot^2 + I8*alpha_M*theta8_dot^2 + I9*alpha_M*theta9_dot^2 + beta_K*k1*twist1_dot^2 + beta_K*k10*twist10_dot^2 + beta_K*k11*twist11_dot^2 + beta_K*k12*twist12_dot^2 + beta_K*k13*twist13_dot^2 + beta_K*k14*twist14_dot^2 + beta_K*k15*twist15_dot^2 + beta_K*k16*twist16_dot^2 + beta_K*k17*twist17_dot^2 + beta_K*k18*twist18_dot^2 + beta_K*k19*twist19_dot^2 + beta_K*k2*twist2_dot^2 + beta_K*k20*twist20_dot^2 + beta_K*k21*twist21_dot^2 + beta_K*k22*twist22_dot^2 + beta_K*k23*twist23_dot^2 + beta_K*k24*twist24_dot^2 + beta_K*k25*twist25_dot^2 + beta_K*k26*twist26_dot^2 + beta_K*k27*twist27_dot^2 + beta_K*k28*twist28_dot^2 + beta_K*k29*twist29_dot^2 + beta_K*k3*twist3_dot^2 + beta_K*k30*twist30_dot^2 + beta_K*k31*twist31_dot^2 + beta_K*k4*twist4_dot^2 + beta_K*k5*twist5_dot^2 + beta_K*k6*twist6_dot^2 + beta_K*k7*twist7_dot^2 + beta_K*k8*twist8_dot^2 + beta_K*k9*twist9_dot^2)/2 [damping]";
        "Q_theta1 = T_motor [torques]";
        "Q_theta2 = 0";
        "Q_theta3 = 0";
        "Q_theta4 = 0";
        "Q_theta5 = 0";
        "Q_theta6 = 0";
        "Q_theta7 = 0";
        "Q_theta8 = 0";
        "Q_theta9 = 0";
        "Q_theta10 = 0";
        "Q_theta11 = 0";
        "Q_theta12 = 0";
        "Q_theta13 = 0";
        "Q_theta14 = 0";
        "Q_theta15 = 0";
        "Q_theta16 = 0";
        "Q_theta17 = 0";
        "Q_theta18 = 0";
        "Q_theta19 = 0";
        "Q_theta20 = 0";
        "Q_theta21 = 0";
        "Q_theta22 = 0";
        "Q_theta23 = 0";
        "Q_theta24 = 0";
        "Q_theta25 = 0";
        "Q_theta26 = 0";
        "Q_theta27 = 0";
        "Q_theta28 = 0";
        "Q_theta29 = 0";
        "Q_theta30 = 0";
        "Q_theta31 = 0";
        "Q_theta32 = -T_load [torques]";
        "twist1 = theta1 - theta2";
        "twist2 = theta2 - theta3";
        "twist3 = theta3 - theta4";
        "twist4 = theta4 - theta5";
        "twist5 = theta5 - theta6";
        "twist6 = theta6 - theta7";
        "twist7 = theta7 - theta8";
        "twist8 = theta8 - theta9";
        "twist9 = theta9 - theta10";
        "twist10 = theta10 - theta11";
        "twist11 = theta11 - theta12";
        "twist12 = theta12 - theta13";
        "twist13 = theta13 - theta14";
        "twist14 = theta14 - theta15";
        "twist15 = theta15 - theta16";
        "twist16 = theta16 - theta17";
        "twist17 = theta17 - theta18";
        "twist18 = theta18 - theta19";
        "twist19 = theta19 - theta20";
        "twist20 = theta20 - theta21";
        "twist21 = theta21 - theta22";
        "twist22 = theta22 - theta23";
        "twist23 = theta23 - theta24";
        "twist24 = theta24 - theta25";
        "twist25 = theta25 - theta26";
        "twist26 = theta26 - theta27";
        "twist27 = theta27 - theta28";
        "twist28 = theta28 - theta29";
        "twist29 = theta29 - theta30";
        "twist30 = theta30 - theta31";
        "twist31 = theta31 - theta32";
        "(I1) theta1'' = -k1*twist1 + T_motor [torques] - I1*alpha_M*theta1_dot - beta_K*k1*twist1_dot [damping]";
        "(I2) theta2'' = k1*twist1 - k2*twist2 + beta_K*k1*twist1_dot - I2*alpha_M*theta2_dot - beta_K*k2*twist2_dot [damping]";
        "(I3) theta3'' = k2*twist2 - k3*twist3 + beta_K*k2*twist2_dot - I3*alpha_M*theta3_dot - beta_K*k3*twist3_dot [damping]";
        "(I4) theta4'' = k3*twist3 - k4*twist4 + beta_K*k3*twist3_dot - I4*alpha_M*theta4_dot - beta_K*k4*twist4_dot [damping]";
        "(I5) theta5'' = k4*twist4 - k5*twist5 + beta_K*k4*twist4_dot - I5*alpha_M*theta5_dot - beta_K*k5*twist5_dot [damping]";
        "(I6) theta6'' = k5*twist5 - k6*twist6 + beta_K*k5*twist5_dot - I6*alpha_M*theta6_dot - beta_K*k6*twist6_dot [damping]";
        "(I7) theta7'' = k6*twist6 - k7*twist7 + beta_K*k6*twist6_dot - I7*alpha_M*theta7_dot - beta_K*k7*twist7_dot [damping]";
        "(I8) theta8'' = k7*twist7 - k8*twist8 + beta_K*k7*twist7_dot - I8*alpha_M*theta8_dot - beta_K*k8*twist8_dot [damping]";
        "(I9) theta9'' = k8*twist8 - k9*twist9 + beta_K*k8*twist8_dot - I9*alpha_M*theta9_dot - beta_K*k9*twist9_dot [damping]";
        "(I10) theta10'' = k9*twist9 - k10*twist10 + beta_K*k9*twist9_dot - I10*alpha_M*theta10_dot - beta_K*k10*twist10_dot [damping]";
        "(I11) theta11'' = k10*twist10 - k11*twist11 + beta_K*k10*twist10_dot - I11*alpha_M*theta11_dot - beta_K*k11*twist11_dot [damping]";
        "(I12) theta12'' = k11*twist11 - k12*twist12 + beta_K*k11*twist11_dot - I12*alpha_M*theta12_dot - beta_K*k12*twist12_dot [damping]";
        "(I13) theta13'' = k12*twist12 - k13*twist13 + beta_K*k12*twist12_dot - I13*alpha_M*theta13_dot - beta_K*k13*twist13_dot [damping]";
        "(I14) theta14'' = k13*twist13 - k14*twist14 + beta_K*k13*twist13_dot - I14*alpha_M*theta14_dot - beta_K*k14*twist14_dot [damping]";
        "(I15) theta15'' = k14*twist14 - k15*twist15 + beta_K*k14*twist14_dot - I15*alpha_M*theta15_dot - beta_K*k15*twist15_dot [damping]";
        "(I16) theta16'' = k15*twist15 - k16*twist16 + beta_K*k15*twist15_dot - I16*alpha_M*theta16_dot - beta_K*k16*twist16_dot [damping]";
        "(I17) theta17'' = k16*twist16 - k17*twist17 + beta_K*k16*twist16_dot - I17*alpha_M*theta17_dot - beta_K*k17*twist17_dot [damping]";
        "(I18) theta18'' = k17*twist17 - k18*twist18 + beta_K*k17*twist17_dot - I18*alpha_M*theta18_dot - beta_K*k18*twist18_dot [damping]";
        "(I19) theta19'' = k18*twist18 - k19*twist19 + beta_K*k18*twist18_dot - I19*alpha_M*theta19_dot - beta_K*k19*twist19_dot [damping]";
        "(I20) theta20'' = k19*twist19 - k20*twist20 + beta_K*k19*twist19_dot - I20*alpha_M*theta20_dot - beta_K*k20*twist20_dot [damping]";
        "(I21) theta21'' = k20*twist20 - k21*twist21 + beta_K*k20*twist20_dot - I21*alpha_M*theta21_dot - beta_K*k21*twist21_dot [damping]";
        "(I22) theta22'' = k21*twist21 - k22*twist22 + beta_K*k21*twist21_dot - I22*alpha_M*theta22_dot - beta_K*k22*twist22_dot [damping]";
        "(I23) theta23'' = k22*twist22 - k23*twist23 + beta_K*k22*twist22_dot - I23*alpha_M*theta23_dot - beta_K*k23*twist23_dot [damping]";
        "(I24) theta24'' = k23*twist23 - k24*twist24 + beta_K*k23*twist23_dot - I24*alpha_M*theta24_dot - beta_K*k24*twist24_dot [damping]";
        "(I25) theta25'' = k24*twist24 - k25*twist25 + beta_K*k24*twist24_dot - I25*alpha_M*theta25_dot - beta_K*k25*twist25_dot [damping]";
        "(I26) theta26'' = k25*twist25 - k26*twist26 + beta_K*k25*twist25_dot - I26*alpha_M*theta26_dot - beta_K*k26*twist26_dot [damping]";
        "(I27) theta27'' = k26*twist26 - k27*twist27 + beta_K*k26*twist26_dot - I27*alpha_M*theta27_dot - beta_K*k27*twist27_dot [damping]";
        "(I28) theta28'' = k27*twist27 - k28*twist28 + beta_K*k27*twist27_dot - I28*alpha_M*theta28_dot - beta_K*k28*twist28_dot [damping]";
        "(I29) theta29'' = k28*twist28 - k29*twist29 + beta_K*k28*twist28_dot - I29*alpha_M*theta29_dot - beta_K*k29*twist29_dot [damping]";
        "(I30) theta30'' = k29*twist29 - k30*twist30 + beta_K*k29*twist29_dot - I30*alpha_M*theta30_dot - beta_K*k30*twist30_dot [damping]";
        "(I31) theta31'' = k30*twist30 - k31*twist31 + beta_K*k30*twist30_dot - I31*alpha_M*theta31_dot - beta_K*k31*twist31_dot [damping]";
        "(I32) theta32'' = k31*twist31 - T_load [torques] + beta_K*k31*twist31_dot - I32*alpha_M*theta32_dot [damping]";
        "M q'' + C q' + K q = f with constant M, C, K, f: linear, solved exactly";
    }
    latex {
        "T = \\frac{1}{2} (I_{1}\\, \\dot{\\theta_{1}}^{2} + I_{10}\\, \\dot{\\theta_{10}}^{2} + I_{11}\\, \\dot{\\theta_{11}}^{2} + I_{12}\\, \\dot{\\theta_{12}}^{2} + I_{13}\\, \\dot{\\theta_{13}}^{2} + I_{14}\\, \\dot{\\theta_{14}}^{2} + I_{15}\\, \\dot{\\theta_{15}}^{2} + I_{16}\\, \\dot{\\theta_{16}}^{2} + I_{17}\\, \\dot{\\theta_{17}}^{2} + I_{18}\\, \\dot{\\theta_{18}}^{2} + I_{19}\\, \\dot{\\theta_{19}}^{2} + I_{2}\\, \\dot{\\theta_{2}}^{2} + I_{20}\\, \\dot{\\theta_{20}}^{2} + I_{21}\\, \\dot{\\theta_{21}}^{2} + I_{22}\\, \\dot{\\theta_{22}}^{2} + I_{23}\\, \\dot{\\theta_{23}}^{2} + I_{24}\\, \\dot{\\theta_{24}}^{2} + I_{25}\\, \\dot{\\theta_{25}}^{2} + I_{26}\\, \\dot{\\theta_{26}}^{2} + I_{27}\\, \\dot{\\theta_{27}}^{2} + I_{28}\\, \\dot{\\theta_{28}}^{2} + I_{29}\\, \\dot{\\theta_{29}}^{2} + I_{3}\\, \\dot{\\theta_{3}}^{2} + I_{30}\\, \\dot{\\theta_{30}}^{2} + I_{31}\\, \\dot{\\theta_{31}}^{2} + I_{32}\\, \\dot{\\theta_{32}}^{2} + I_{4}\\, \\dot{\\theta_{4}}^{2} + I_{5}\\, \\dot{\\theta_{5}}^{2} + I_{6}\\, \\dot{\\theta_{6}}^{2} + I_{7}\\, \\dot{\\theta_{7}}^{2} + I_{8}\\, \\dot{\\theta_{8}}^{2} + I_{9}\\, \\dot{\\theta_{9}}^{2})";
        "V = \\frac{1}{2} (k_{1}\\, \\mathrm{twist}_{1}^{2} + k_{10}\\, \\mathrm{twist}_{10}^{2} + k_{11}\\, \\mathrm{twist}_{11}^{2} + k_{12}\\, \\mathrm{twist}_{12}^{2} + k_{13}\\, \\mathrm{twist}_{13}^{2} + k_{14}\\, \\mathrm{twist}_{14}^{2} + k_{15}\\, \\mathrm{twist}_{15}^{2} + k_{16}\\, \\mathrm{twist}_{16}^{2} + k_{17}\\, \\mathrm{twist}_{17}^{2} + k_{18}\\, \\mathrm{twist}_{18}^{2} + k_{19}\\, \\mathrm{twist}_{19}^{2} + k_{2}\\, \\mathrm{twist}_{2}^{2} + k_{20}\\, \\mathrm{twist}_{20}^{2} + k_{21}\\, \\mathrm{twist}_{21}^{2} + k_{22}\\, \\mathrm{twist}_{22}^{2} + k_{23}\\, \\mathrm{twist}_{23}^{2} + k_{24}\\, \\mathrm{twist}_{24}^{2} + k_{25}\\, \\mathrm{twist}_{25}^{2} + k_{26}\\, \\mathrm{twist}_{26}^{2} + k_{27}\\, \\mathrm{twist}_{27}^{2} + k_{28}\\, \\mathrm{twist}_{28}^{2} + k_{29}\\, \\mathrm{twist}_{29}^{2} + k_{3}\\, \\mathrm{twist}_{3}^{2} + k_{30}\\, \\mathrm{twist}_{30}^{2} + k_{31}\\, \\mathrm{twist}_{31}^{2} + k_{4}\\, \\mathrm{twist}_{4}^{2} + k_{5}\\, \\mathrm{twist}_{5}^{2} + k_{6}\\, \\mathrm{twist}_{6}^{2} + k_{7}\\, \\mathrm{twist}_{7}^{2} + k_{8}\\, \\mathrm{twist}_{8}^{2} + k_{9}\\, \\mathrm{twist}_{9}^{2})";
        "D = \\frac{1}{2} (I_{1}\\, \\alpha_{M}\\, \\dot{\\theta_{1}}^{2} + I_{10}\\, \\alpha_{M}\\, \\dot{\\theta_{10}}^{2} + I_{11}\\, \\alpha_{M}\\, \\dot{\\theta_{11}}^{2} + I_{12}\\, \\alpha_{M}\\, \\dot{\\theta_{12}}^{2} + I_{13}\\, \\alpha_{M}\\, \\dot{\\theta_{13}}^{2} + I_{14}\\, \\alpha_{M}\\, \\dot{\\theta_{14}}^{2} + I_{15}\\, \\alpha_{M}\\, \\dot{\\theta_{15}}^{2} + I_{16}\\, \\alpha_{M}\\, \\dot{\\theta_{16}}^{2} + I_{17}\\, \\alpha_{M}\\, \\dot{\\theta_{17}}^{2} + I_{18}\\, \\alpha_{M}\\, \\dot{\\theta_{18}}^{2} + I_{19}\\, \\alpha_{M}\\, \\dot{\\theta_{19}}^{2} + I_{2}\\, \\alpha_{M}\\, \\dot{\\theta_{2}}^{2} + I_{20}\\, \\alpha_{M}\\, \\dot{\\theta_{20}}^{2} + I_{21}\\, \\alpha_{M}\\, \\dot{\\theta_{21}}^{2} + I_{22}\\, \\alpha_{M}\\, \\dot{\\theta_{22}}^{2} + I_{23}\\, \\alpha_{M}\\, \\dot{\\theta_{23}}^{2} + I_{24}\\, \\alpha_{M}\\, \\dot{\\theta_{24}}^{2} + I_{25}\\, \\alpha_{M}\\, \\dot{\\theta_{25}}^{2} + I_{26}\\, \\alpha_{M}\\, \\dot{\\theta_{26}}^{2} + I_{27}\\, \\alpha_{M}\\, \\dot{\\theta_{27}}^{2} + I_{28}\\, \\alpha_{M}\\, \\dot{\\theta_{28}}^{2} + I_{29}\\, \\alpha_{M}\\, \\dot{\\theta_{29}}^{2} + I_{3}\\, \\alpha_{M}\\, \\dot{\\theta_{3}}^{2} + I_{30}\\, \\alpha_{M}\\, \\dot{\\theta_{30}}^{2} + I_{31}\\, \\alpha_{M}\\, \\dot{\\theta_{31}}^{2} + I_{32}\\, \\alpha_{M}\\, \\dot{\\theta_{32}}^{2} + I_{4}\\, \\alpha_{M}\\, \\dot{\\theta_{4}}^{2} + I_{5}\\, \\alpha_{M}\\, \\dot{\\theta_{5}}^{2} + I_{6}\\, \\alpha_{M}\\, \\dot{\\theta_{6}}^{2} + I_{7}\\, \\alpha_{M}\\, \\dot{\\theta_{7}}^{2} + I_{8}\\, \\alpha_{M}\\, \\dot{\\theta_{8}}^{2} + I_{9}\\, \\alpha_{M}\\, \\dot{\\theta_{9}}^{2} + \\beta_{K}\\, k_{1}\\, \\dot{\\mathrm{twist}_{1}}^{2} + \\beta_{K}\\, k_{10}\\, \\dot{\\mathrm{twist}_{10}}^{2} + \\beta_{K}\\, k_{11}\\, \\dot{\\mathrm{twist}_{11}}^{2} + \\beta_{K}\\, k_{12}\\, \\dot{\\mathrm{twist}_{12}}^{2} + \\beta_{K}\\, k_{13}\\, \\dot{\\mathrm{twist}_{13}}^{2} + \\beta_{K}\\, k_{14}\\, \\dot{\\mathrm{twist}_{14}}^{2} + \\beta_{K}\\, k_{15}\\, \\dot{\\mathrm{twist}_{15}}^{2} + \\beta_{K}\\, k_{16}\\, \\dot{\\mathrm{twist}_{16}}^{2} + \\beta_{K}\\, k_{17}\\, \\dot{\\mathrm{twist}_{17}}^{2} + \\beta_{K}\\, k_{18}\\, \\dot{\\mathrm{twist}_{18}}^{2} + \\beta_{K}\\, k_{19}\\, \\dot{\\mathrm{twist}_{19}}^{2} + \\beta_{K}\\, k_{2}\\, \\dot{\\mathrm{twist}_{2}}^{2} + \\beta_{K}\\, k_{20}\\, \\dot{\\mathrm{twist}_{20}}^{2} + \\beta_{K}\\, k_{21}\\, \\dot{\\mathrm{twist}_{21}}^{2} + \\beta_{K}\\, k_{22}\\, \\dot{\\mathrm{twist}_{22}}^{2} + \\beta_{K}\\, k_{23}\\, \\dot{\\mathrm{twist}_{23}}^{2} + \\beta_{K}\\, k_{24}\\, \\dot{\\mathrm{twist}_{24}}^{2} + \\beta_{K}\\, k_{25}\\, \\dot{\\mathrm{twist}_{25}}^{2} + \\beta_{K}\\, k_{26}\\, \\dot{\\mathrm{twist}_{26}}^{2} + \\beta_{K}\\, k_{27}\\, \\dot{\\mathrm{twist}_{27}}^{2} + \\beta_{K}\\, k_{28}\\, \\dot{\\mathrm{twist}_{28}}^{2} + \\beta_{K}\\, k_{29}\\, \\dot{\\mathrm{twist}_{29}}^{2} + \\beta_{K}\\, k_{3}\\, \\dot{\\mathrm{twist}_{3}}^{2} + \\beta_{K}\\, k_{30}\\, \\dot{\\mathrm{twist}_{30}}^{2} + \\beta_{K}\\, k_{31}\\, \\dot{\\mathrm{twist}_{31}}^{2} + \\beta_{K}\\, k_{4}\\, \\dot{\\mathrm{twist}_{4}}^{2} + \\beta_{K}\\, k_{5}\\, \\dot{\\mathrm{twist}_{5}}^{2} + \\beta_{K}\\, k_{6}\\, \\dot{\\mathrm{twist}_{6}}^{2} + \\beta_{K}\\, k_{7}\\, \\dot{\\mathrm{twist}_{7}}^{2} + \\beta_{K}\\, k_{8}\\, \\dot{\\mathrm{twist}_{8}}^{2} + \\beta_{K}\\, k_{9}\\, \\dot{\\mathrm{twist}_{9}}^{2})\\ [\\text{damping}]";
        "Q_{\\theta_{1}} = T_{motor}\\ [\\text{torques}]";
        "Q_{\\theta_{2}} = 0";
        "Q_{\\theta_{3}} = 0";
        "Q_{\\theta_{4}} = 0";
        "Q_{\\theta_{5}} = 0";
        "Q_{\\theta_{6}} = 0";
        "Q_{\\theta_{7}} = 0";
        "Q_{\\theta_{8}} = 0";
        "Q_{\\theta_{9}} = 0";
        "Q_{\\theta_{10}} = 0";
        "Q_{\\theta_{11}} = 0";
        "Q_{\\theta_{12}} = 0";
        "Q_{\\theta_{13}} = 0";
        "Q_{\\theta_{14}} = 0";
        "Q_{\\theta_{15}} = 0";
        "Q_{\\theta_{16}} = 0";
        "Q_{\\theta_{17}} = 0";
        "Q_{\\theta_{18}} = 0";
        "Q_{\\theta_{19}} = 0";
        "Q_{\\theta_{20}} = 0";
        "Q_{\\theta_{21}} = 0";
        "Q_{\\theta_{22}} = 0";
        "Q_{\\theta_{23}} = 0";
        "Q_{\\theta_{24}} = 0";
        "Q_{\\theta_{25}} = 0";
        "Q_{\\theta_{26}} = 0";
        "Q_{\\theta_{27}} = 0";
        "Q_{\\theta_{28}} = 0";
        "Q_{\\theta_{29}} = 0";
        "Q_{\\theta_{30}} = 0";
        "Q_{\\theta_{31}} = 0";
        "Q_{\\theta_{32}} = -T_{load}\\ [\\text{torques}]";
        "\\mathrm{twist}_{1} = \\theta_{1} - \\theta_{2}";
        "\\mathrm{twist}_{2} = \\theta_{2} - \\theta_{3}";
        "\\mathrm{twist}_{3} = \\theta_{3} - \\theta_{4}";
        "\\mathrm{twist}_{4} = \\theta_{4} - \\theta_{5}";
        "\\mathrm{twist}_{5} = \\theta_{5} - \\theta_{6}";
        "\\mathrm{twist}_{6} = \\theta_{6} - \\theta_{7}";
        "\\mathrm{twist}_{7} = \\theta_{7} - \\theta_{8}";
        "\\mathrm{twist}_{8} = \\theta_{8} - \\theta_{9}";
        "\\mathrm{twist}_{9} = \\theta_{9} - \\theta_{10}";
        "\\mathrm{twist}_{10} = \\theta_{10} - \\theta_{11}";
        "\\mathrm{twist}_{11} = \\theta_{11} - \\theta_{12}";
        "\\mathrm{twist}_{12} = \\theta_{12} - \\theta_{13}";
        "\\mathrm{twist}_{13} = \\theta_{13} - \\theta_{14}";
        "\\mathrm{twist}_{14} = \\theta_{14} - \\theta_{15}";
        "\\mathrm{twist}_{15} = \\theta_{15} - \\theta_{16}";
        "\\mathrm{twist}_{16} = \\theta_{16} - \\theta_{17}";
        "\\mathrm{twist}_{17} = \\theta_{17} - \\theta_{18}";
        "\\mathrm{twist}_{18} = \\theta_{18} - \\theta_{19}";
        "\\mathrm{twist}_{19} = \\theta_{19} - \\theta_{20}";
        "\\mathrm{twist}_{20} = \\theta_{20} - \\theta_{21}";
        "\\mathrm{twist}_{21} = \\theta_{21} - \\theta_{22}";
        "\\mathrm{twist}_{22} = \\theta_{22} - \\theta_{23}";
        "\\mathrm{twist}_{23} = \\theta_{23} - \\theta_{24}";
        "\\mathrm{twist}_{24} = \\theta_{24} - \\theta_{25}";
        "\\mathrm{twist}_{25} = \\theta_{25} - \\theta_{26}";
        "\\mathrm{twist}_{26} = \\theta_{26} - \\theta_{27}";
        "\\mathrm{twist}_{27} = \\theta_{27} - \\theta_{28}";
        "\\mathrm{twist}_{28} = \\theta_{28} - \\theta_{29}";
        "\\mathrm{twist}_{29} = \\theta_{29} - \\theta_{30}";
        "\\mathrm{twist}_{30} = \\theta_{30} - \\theta_{31}";
        "\\mathrm{twist}_{31} = \\theta_{31} - \\theta_{32}";
        "(I_{1}) \\ddot{\\theta_{1}} = -k_{1}\\, \\mathrm{twist}_{1} + T_{motor}\\ [\\text{torques}] - I_{1}\\, \\alpha_{M}\\, \\dot{\\theta_{1}} - \\beta_{K}\\, k_{1}\\, \\dot{\\mathrm{twist}_{1}}\\ [\\text{damping}]";
        "(I_{2}) \\ddot{\\theta_{2}} = k_{1}\\, \\mathrm{twist}_{1} - k_{2}\\, \\mathrm{twist}_{2} + \\beta_{K}\\, k_{1}\\, \\dot{\\mathrm{twist}_{1}} - I_{2}\\, \\alpha_{M}\\, \\dot{\\theta_{2}} - \\beta_{K}\\, k_{2}\\, \\dot{\\mathrm{twist}_{2}}\\ [\\text{damping}]";
        "(I_{3}) \\ddot{\\theta_{3}} = k_{2}\\, \\mathrm{twist}_{2} - k_{3}\\, \\mathrm{twist}_{3} + \\beta_{K}\\, k_{2}\\, \\dot{\\mathrm{twist}_{2}} - I_{3}\\, \\alpha_{M}\\, \\dot{\\theta_{3}} - \\beta_{K}\\, k_{3}\\, \\dot{\\mathrm{twist}_{3}}\\ [\\text{damping}]";
        "(I_{4}) \\ddot{\\theta_{4}} = k_{3}\\, \\mathrm{twist}_{3} - k_{4}\\, \\mathrm{twist}_{4} + \\beta_{K}\\, k_{3}\\, \\dot{\\mathrm{twist}_{3}} - I_{4}\\, \\alpha_{M}\\, \\dot{\\theta_{4}} - \\beta_{K}\\, k_{4}\\, \\dot{\\mathrm{twist}_{4}}\\ [\\text{damping}]";
        "(I_{5}) \\ddot{\\theta_{5}} = k_{4}\\, \\mathrm{twist}_{4} - k_{5}\\, \\mathrm{twist}_{5} + \\beta_{K}\\, k_{4}\\, \\dot{\\mathrm{twist}_{4}} - I_{5}\\, \\alpha_{M}\\, \\dot{\\theta_{5}} - \\beta_{K}\\, k_{5}\\, \\dot{\\mathrm{twist}_{5}}\\ [\\text{damping}]";
        "(I_{6}) \\ddot{\\theta_{6}} = k_{5}\\, \\mathrm{twist}_{5} - k_{6}\\, \\mathrm{twist}_{6} + \\beta_{K}\\, k_{5}\\, \\dot{\\mathrm{twist}_{5}} - I_{6}\\, \\alpha_{M}\\, \\dot{\\theta_{6}} - \\beta_{K}\\, k_{6}\\, \\dot{\\mathrm{twist}_{6}}\\ [\\text{damping}]";
        "(I_{7}) \\ddot{\\theta_{7}} = k_{6}\\, \\mathrm{twist}_{6} - k_{7}\\, \\mathrm{twist}_{7} + \\beta_{K}\\, k_{6}\\, \\dot{\\mathrm{twist}_{6}} - I_{7}\\, \\alpha_{M}\\, \\dot{\\theta_{7}} - \\beta_{K}\\, k_{7}\\, \\dot{\\mathrm{twist}_{7}}\\ [\\text{damping}]";
        "(I_{8}) \\ddot{\\theta_{8}} = k_{7}\\, \\mathrm{twist}_{7} - k_{8}\\, \\mathrm{twist}_{8} + \\beta_{K}\\, k_{7}\\, \\dot{\\mathrm{twist}_{7}} - I_{8}\\, \\alpha_{M}\\, \\dot{\\theta_{8}} - \\beta_{K}\\, k_{8}\\, \\dot{\\mathrm{twist}_{8}}\\ [\\text{damping}]";
        "(I_{9}) \\ddot{\\theta_{9}} = k_{8}\\, \\mathrm{twist}_{8} - k_{9}\\, \\mathrm{twist}_{9} + \\beta_{K}\\, k_{8}\\, \\dot{\\mathrm{twist}_{8}} - I_{9}\\, \\alpha_{M}\\, \\dot{\\theta_{9}} - \\beta_{K}\\, k_{9}\\, \\dot{\\mathrm{twist}_{9}}\\ [\\text{damping}]";
        "(I_{10}) \\ddot{\\theta_{10}} = k_{9}\\, \\mathrm{twist}_{9} - k_{10}\\, \\mathrm{twist}_{10} + \\beta_{K}\\, k_{9}\\, \\dot{\\mathrm{twist}_{9}} - I_{10}\\, \\alpha_{M}\\, \\dot{\\theta_{10}} - \\beta_{K}\\, k_{10}\\, \\dot{\\mathrm{twist}_{10}}\\ [\\text{damping}]";
        "(I_{11}) \\ddot{\\theta_{11}} = k_{10}\\, \\mathrm{twist}_{10} - k_{11}\\, \\mathrm{twist}_{11} + \\beta_{K}\\, k_{10}\\, \\dot{\\mathrm{twist}_{10}} - I_{11}\\, \\alpha_{M}\\, \\dot{\\theta_{11}} - \\beta_{K}\\, k_{11}\\, \\dot{\\mathrm{twist}_{11}}\\ [\\text{damping}]";
        "(I_{12}) \\ddot{\\theta_{12}} = k_{11}\\, \\mathrm{twist}_{11} - k_{12}\\, \\mathrm{twist}_{12} + \\beta_{K}\\, k_{11}\\, \\dot{\\mathrm{twist}_{11}} - I_{12}\\, \\alpha_{M}\\, \\dot{\\theta_{12}} - \\beta_{K}\\, k_{12}\\, \\dot{\\mathrm{twist}_{12}}\\ [\\text{damping}]";
        "(I_{13}) \\ddot{\\theta_{13}} = k_{12}\\, \\mathrm{twist}_{12} - k_{13}\\, \\mathrm{twist}_{13} + \\beta_{K}\\, k_{12}\\, \\dot{\\mathrm{twist}_{12}} - I_{13}\\, \\alpha_{M}\\, \\dot{\\theta_{13}} - \\beta_{K}\\, k_{13}\\, \\dot{\\mathrm{twist}_{13}}\\ [\\text{damping}]";
        "(I_{14}) \\ddot{\\theta_{14}} = k_{13}\\, \\mathrm{twist}_{13} - k_{14}\\, \\mathrm{twist}_{14} + \\beta_{K}\\, k_{13}\\, \\dot{\\mathrm{twist}_{13}} - I_{14}\\, \\alpha_{M}\\, \\dot{\\theta_{14}} - \\beta_{K}\\, k_{14}\\, \\dot{\\mathrm{twist}_{14}}\\ [\\text{damping}]";
        "(I_{15}) \\ddot{\\theta_{15}} = k_{14}\\, \\mathrm{twist}_{14} - k_{15}\\, \\mathrm{twist}_{15} + \\beta_{K}\\, k_{14}\\, \\dot{\\mathrm{twist}_{14}} - I_{15}\\, \\alpha_{M}\\, \\dot{\\theta_{15}} - \\beta_{K}\\, k_{15}\\, \\dot{\\mathrm{twist}_{15}}\\ [\\text{damping}]";
        "(I_{16}) \\ddot{\\theta_{16}} = k_{15}\\, \\mathrm{twist}_{15} - k_{16}\\, \\mathrm{twist}_{16} + \\beta_{K}\\, k_{15}\\, \\dot{\\mathrm{twist}_{15}} - I_{16}\\, \\alpha_{M}\\, \\dot{\\theta_{16}} - \\beta_{K}\\, k_{16}\\, \\dot{\\mathrm{twist}_{16}}\\ [\\text{damping}]";
        "(I_{17}) \\ddot{\\theta_{17}} = k_{16}\\, \\mathrm{twist}_{16} - k_{17}\\, \\mathrm{twist}_{17} + \\beta_{K}\\, k_{16}\\, \\dot{\\mathrm{twist}_{16}} - I_{17}\\, \\alpha_{M}\\, \\dot{\\theta_{17}} - \\beta_{K}\\, k_{17}\\, \\dot{\\mathrm{twist}_{17}}\\ [\\text{damping}]";
        "(I_{18}) \\ddot{\\theta_{18}} = k_{17}\\, \\mathrm{twist}_{17} - k_{18}\\, \\mathrm{twist}_{18} + \\beta_{K}\\, k_{17}\\, \\dot{\\mathrm{twist}_{17}} - I_{18}\\, \\alpha_{M}\\, \\dot{\\theta_{18}} - \\beta_{K}\\, k_{18}\\, \\dot{\\mathrm{twist}_{18}}\\ [\\text{damping}]";
        "(I_{19}) \\ddot{\\theta_{19}} = k_{18}\\, \\mathrm{twist}_{18} - k_{19}\\, \\mathrm{twist}_{19} + \\beta_{K}\\, k_{18}\\, \\dot{\\mathrm{twist}_{18}} - I_{19}\\, \\alpha_{M}\\, \\dot{\\theta_{19}} - \\beta_{K}\\, k_{19}\\, \\dot{\\mathrm{twist}_{19}}\\ [\\text{damping}]";
        "(I_{20}) \\ddot{\\theta_{20}} = k_{19}\\, \\mathrm{twist}_{19} - k_{20}\\, \\mathrm{twist}_{20} + \\beta_{K}\\, k_{19}\\, \\dot{\\mathrm{twist}_{19}} - I_{20}\\, \\alpha_{M}\\, \\dot{\\theta_{20}} - \\beta_{K}\\, k_{20}\\, \\dot{\\mathrm{twist}_{20}}\\ [\\text{damping}]";
        "(I_{21}) \\ddot{\\theta_{21}} = k_{20}\\, \\mathrm{twist}_{20} - k_{21}\\, \\mathrm{twist}_{21} + \\beta_{K}\\, k_{20}\\, \\dot{\\mathrm{twist}_{20}} - I_{21}\\, \\alpha_{M}\\, \\dot{\\theta_{21}} - \\beta_{K}\\, k_{21}\\, \\dot{\\mathrm{twist}_{21}}\\ [\\text{damping}]";
        "(I_{22}) \\ddot{\\theta_{22}} = k_{21}\\, \\mathrm{twist}_{21} - k_{22}\\, \\mathrm{twist}_{22} + \\beta_{K}\\, k_{21}\\, \\dot{\\mathrm{twist}_{21}} - I_{22}\\, \\alpha_{M}\\, \\dot{\\theta_{22}} - \\beta_{K}\\, k_{22}\\, \\dot{\\mathrm{twist}_{22}}\\ [\\text{damping}]";
        "(I_{23}) \\ddot{\\theta_{23}} = k_{22}\\, \\mathrm{twist}_{22} - k_{23}\\, \\mathrm{twist}_{23} + \\beta_{K}\\, k_{22}\\, \\dot{\\mathrm{twist}_{22}} - I_{23}\\, \\alpha_{M}\\, \\dot{\\theta_{23}} - \\beta_{K}\\, k_{23}\\, \\dot{\\mathrm{twist}_{23}}\\ [\\text{damping}]";
        "(I_{24}) \\ddot{\\theta_{24}} = k_{23}\\, \\mathrm{twist}_{23} - k_{24}\\, \\mathrm{twist}_{24} + \\beta_{K}\\, k_{23}\\, \\dot{\\mathrm{twist}_{23}} - I_{24}\\, \\alpha_{M}\\, \\dot{\\theta_{24}} - \\beta_{K}\\, k_{24}\\, \\dot{\\mathrm{twist}_{24}}\\ [\\text{damping}]";
        "(I_{25}) \\ddot{\\theta_{25}} = k_{24}\\, \\mathrm{twist}_{24} - k_{25}\\, \\mathrm{twist}_{25} + \\beta_{K}\\, k_{24}\\, \\dot{\\mathrm{twist}_{24}} - I_{25}\\, \\alpha_{M}\\, \\dot{\\theta_{25}} - \\beta_{K}\\, k_{25}\\, \\dot{\\mathrm{twist}_{25}}\\ [\\text{damping}]";
        "(I_{26}) \\ddot{\\theta_{26}} = k_{25}\\, \\mathrm{twist}_{25} - k_{26}\\, \\mathrm{twist}_{26} + \\beta_{K}\\, k_{25}\\, \\dot{\\mathrm{twist}_{25}} - I_{26}\\, \\alpha_{M}\\, \\dot{\\theta_{26}} - \\beta_{K}\\, k_{26}\\, \\dot{\\mathrm{twist}_{26}}\\ [\\text{damping}]";
        "(I_{27}) \\ddot{\\theta_{27}} = k_{26}\\, \\mathrm{twist}_{26} - k_{27}\\, \\mathrm{twist}_{27} + \\beta_{K}\\, k_{26}\\, \\dot{\\mathrm{twist}_{26}} - I_{27}\\, \\alpha_{M}\\, \\dot{\\theta_{27}} - \\beta_{K}\\, k_{27}\\, \\dot{\\mathrm{twist}_{27}}\\ [\\text{damping}]";
        "(I_{28}) \\ddot{\\theta_{28}} = k_{27}\\, \\mathrm{twist}_{27} - k_{28}\\, \\mathrm{twist}_{28} + \\beta_{K}\\, k_{27}\\, \\dot{\\mathrm{twist}_{27}} - I_{28}\\, \\alpha_{M}\\, \\dot{\\theta_{28}} - \\beta_{K}\\, k_{28}\\, \\dot{\\mathrm{twist}_{28}}\\ [\\text{damping}]";
        "(I_{29}) \\ddot{\\theta_{29}} = k_{28}\\, \\mathrm{twist}_{28} - k_{29}\\, \\mathrm{twist}_{29} + \\beta_{K}\\, k_{28}\\, \\dot{\\mathrm{twist}_{28}} - I_{29}\\, \\alpha_{M}\\, \\dot{\\theta_{29}} - \\beta_{K}\\, k_{29}\\, \\dot{\\mathrm{twist}_{29}}\\ [\\text{damping}]";
        "(I_{30}) \\ddot{\\theta_{30}} = k_{29}\\, \\mathrm{twist}_{29} - k_{30}\\, \\mathrm{twist}_{30} + \\beta_{K}\\, k_{29}\\, \\dot{\\mathrm{twist}_{29}} - I_{30}\\, \\alpha_{M}\\, \\dot{\\theta_{30}} - \\beta_{K}\\, k_{30}\\, \\dot{\\mathrm{twist}_{30}}\\ [\\text{damping}]";
        "(I_{31}) \\ddot{\\theta_{31}} = k_{30}\\, \\mathrm{twist}_{30} - k_{31}\\, \\mathrm{twist}_{31} + \\beta_{K}\\, k_{30}\\, \\dot{\\mathrm{twist}_{30}} - I_{31}\\, \\alpha_{M}\\, \\dot{\\theta_{31}} - \\beta_{K}\\, k_{31}\\, \\dot{\\mathrm{twist}_{31}}\\ [\\text{damping}]";
        "(I_{32}) \\ddot{\\theta_{32}} = k_{31}\\, \\mathrm{twist}_{31} - T_{load}\\ [\\text{torques}] + \\beta_{K}\\, k_{31}\\, \\dot{\\mathrm{twist}_{31}} - I_{32}\\, \\alpha_{M}\\, \\dot{\\theta_{32}}\\ [\\text{damping}]";
    }
}
