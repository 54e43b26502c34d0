//! Tables of kicks and drifts for every T(p) + V(q).

use crate::method::splitting::{DriftFirst, KickFirst, Splitting};

/// Drift first: the triple jump of position Verlet, γ₁ = 1/(2 − ∛2). Order 4, 3 forces. For comparison only:
/// [`PEFRL`] reaches the same error with fewer forces. E. Forest & R. D. Ruth, Physica D 43 (1990) 105, (4.8); J.
/// Candy & W. Rozmus, J. Comput. Phys. 92 (1991) 230. Closed form.
#[doc(alias("Forest-Ruth", "Ruth"))]
pub const ForestRuth4: Splitting<3, DriftFirst> = Splitting::palindrome(
    "ForestRuth4",
    4,
    [0.67560359597982881702384390448573041346099968810857, -0.17560359597982881702384390448573041346099968810857],
    [1.3512071919596576340476878089714608269219993762171, -1.7024143839193152680953756179429216538439987524343],
);

/// Drift first, "position extended Forest–Ruth-like". Order 4, 4 forces. A good choice if stability limits the
/// step. I. P. Omelyan, I. M. Mryglod & R. Folk, Comput. Phys. Commun. 146 (2002) 188, (20), (22). 1 free
/// parameter.
#[doc(alias = "Omelyan")]
pub const PEFRL: Splitting<4, DriftFirst> = Splitting::palindrome(
    "PEFRL",
    4,
    [
        0.17861789584480906806090424619759054303677229820293,
        -0.066264582669818488316670940075704280041326053337393,
        0.77529337365001884051153338775622747400910751026893,
    ],
    [0.71234183106260542548034291278593833249072592455729, -0.21234183106260542548034291278593833249072592455729],
);

/// Kick first. Order 4, 6 forces. The order-4 table for a general T(p) + V(q). S. Blanes & P. C. Moan, J. Comput.
/// Appl. Math. 142 (2002) 313, table 2, S₆. 3 free parameters.
#[doc(alias("Order4", "Blanes-Moan"))]
pub const BlanesMoan4: Splitting<6, KickFirst> = Splitting::palindrome(
    "BlanesMoan4",
    4,
    [
        0.079203696431195674197649623763222600151721661209021,
        0.35317290604977403681866555730303956224987518967716,
        -0.042065080357719529215171580876570732967175264248617,
        0.21937695575349963639771279962061714113115682672487,
    ],
    [
        0.20951510661336205297244998609371269086300803981848,
        -0.14385177317981803796409629923280489821528601450999,
        0.43433666656645598499164631313909220735227797469151,
    ],
);

/// Kick first. Order 6, 10 forces. The default for a general T(p) + V(q) and errors of about 10⁻⁷ and less. S. Blanes &
/// P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313, table 2, S₁₀. 1 free parameter.
#[doc(alias = "Order6")]
pub const BlanesMoan6: Splitting<10, KickFirst> = Splitting::palindrome(
    "BlanesMoan6",
    6,
    [
        0.050262764400392722764635017045126956496782598115552,
        0.41351430042834347745413671523642699038356000256959,
        0.045079889794398111489861084473028991371983798887163,
        -0.18805485381956861849042528342091260521880127275005,
        0.54196067845078001236689219192959744887443789139475,
        -0.72552555850869141117019945052653556381592603643401,
    ],
    [
        0.14881644790104328045733825033550335816777424955983,
        -0.13238586576778375614934696581611399013947966805019,
        0.067307604692184399240771485922556259690405910210081,
        0.43266640257817371163358331394979268974485840581036,
        -0.016404589403617635182346084391738317463558897530075,
    ],
);
