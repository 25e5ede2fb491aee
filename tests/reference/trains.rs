//! Drivetrains that are stated twice: as a derived model, and as a train.

/// A derived model's scene, and the tables that list the same parts.
pub struct Pair<'a> {
    /// Name of the scene of the derived model in models/scenes.
    pub scene: &'static str,
    /// The tables of the train.
    pub tables: &'a str,
    /// Texts that differ: (text in the derived model's scene, text in the train's).
    pub renamed: &'a [(&'static str, &'static str)],
}

/// A chain of discs.
pub const CHAIN: Pair<'static> = Pair {
    scene: "chain_5",
    tables: "[rotors]\n1={}\n2={}\n3={}\n4={}\n5={}\n[shafts]\n1={between=['1','2']}\n2={between=['2','3']}\n\
             3={between=['3','4']}\n4={between=['4','5']}\n[drives]\nmotor={rotor='1'}\n[loads]\nload={rotor='5'}\n",
    renamed: &[],
};

/// Two branches on rigid gears.
pub const BRANCHES: Pair<'static> = Pair {
    scene: "geared_branches",
    tables: "[rotors]\n1={}\nm={}\na={}\nb={}\n2={}\n[shafts]\nm={between=['m','1']}\na={between=['1','a']}\n\
             b={between=['2','b']}\n[meshes]\n12={between=['1','2'],stiffness='rigid',teeth=[1,1]}\n\
             [drives]\nmotor={rotor='m'}\n[loads]\nload={rotor='b'}\n",
    renamed: &[],
};

/// A gear pair on shafts between motor and load.
pub const SHAFTS: Pair<'static> = Pair {
    scene: "gear_pair_shafts",
    tables: "[rotors]\n1={}\nm={}\n2={}\nl={}\n[shafts]\nm={between=['m','1']}\nl={between=['2','l']}\n\
             [meshes]\n12={between=['1','2']}\n[drives]\nmotor={rotor='m'}\n[loads]\nload={rotor='l'}\n",
    renamed: &[],
};

/// Two stages.
pub const TWO_STAGE: Pair<'static> = Pair {
    scene: "two_stage",
    tables: "[rotors]\n1={}\nm={}\n2={}\n3={}\n4={}\nl={}\n[shafts]\nm={between=['m','1']}\n\
             l={between=['4','l']}\nc={between=['2','3']}\n[meshes]\n12={between=['1','2']}\n34={between=['3','4']}\n\
             [drives]\nmotor={rotor='m'}\n[loads]\nload={rotor='l'}\n",
    renamed: &[],
};

/// A planetary stage.
pub const PLANETARY: Pair<'static> = Pair {
    scene: "planetary_3",
    tables: "[rotors]\ns={}\nc={}\nr={}\n[planets.p]\nsun='s'\ncarrier='c'\nring='r'\ncount=3\nteeth=[27,99]\n\
             [supports]\nr={rotor='r'}\n[drives]\nmotor={rotor='s'}\n[loads]\nload={rotor='c'}\n",
    renamed: &[
        ("Z_s = 27\n", ""),
        ("Z_r = 99\n", ""),
        ("r_s =", "rs_p ="),
        ("alpha =", "alpha_p ="),
        ("I_p =", "Ip_p ="),
        ("m_p =", "mp_p ="),
        ("k_s1.", "k_p_s1."),
        ("k_s2.", "k_p_s2."),
        ("k_s3.", "k_p_s3."),
        ("k_r1.", "k_p_r1."),
        ("k_r2.", "k_p_r2."),
        ("k_r3.", "k_p_r3."),
    ],
};

impl Pair<'_> {
    /// The text of the train's scene, from that of the derived model.
    ///
    /// # Panics
    /// If a text to be renamed does not occur in `derived`.
    pub fn listed(&self, derived: &str) -> String {
        let mut listed = derived.replace(&format!("model = {:?}", self.scene), "model = \"train\"");
        for (from, to) in self.renamed {
            assert!(listed.contains(from), "{}: {from}", self.scene);
            listed = listed.replace(from, to);
        }
        format!("{listed}\n{}", self.tables)
    }
}
