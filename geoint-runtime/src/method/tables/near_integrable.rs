//! Tables for H = A + B. The part A has an exact flow, and the rest B is small. The outer flows are flows of A.
//!
//! A table of orders (s₁, s₂, …) has the error O(ε hˢ¹ + ε² hˢ² + …), if B is smaller than A by ε.

use crate::method::flows::perturbed::Perturbation;
use crate::method::flows::{DriftFirst, Nystrom, ProcessedSplitting, Splitting, WithGradient};

/// Half of A, B, half of A. Orders (2, 2), 1 force. J. Wisdom & M. Holman, Astron. J. 102 (1991) 1528.
///
/// The step is at most an eighth of the innermost period, because longer steps resonate with it. This is the same map as
/// `Perturbation(PositionVerlet)`, and has the same compositions.
#[doc(alias("Wisdom-Holman", "WHFast", "mixed variable symplectic", "MVS"))]
pub const WisdomHolman: Perturbation<Splitting<1>> =
    Perturbation(Splitting::drift_first("WisdomHolman", 2, [0.5], [1.0]).near_integrable(&[2, 2]));

/// Kicks at Gauss's nodes. Orders (8, 2), 4 forces. J. Laskar & P. Robutel, Celest. Mech. Dyn. Astron. 80 (2001) 39, (23).
#[doc(alias = "Laskar-Robutel")]
pub const Saba4: Perturbation<Splitting<4>> = Perturbation(
    Splitting::drift_first(
        "Saba4",
        2,
        [
            0.069431844202973712388026755553595247452137310185141,
            0.2605776340045981552106403648947824089475747549294,
            0.33998104358485626480266575910324468720057586977091,
        ],
        [0.17392742256872692868653197461099970361767434791695, 0.32607257743127307131346802538900029638232565208305],
    )
    .near_integrable(&[8, 2]),
);

/// Orders (8, 4), 5 forces. R. I. McLachlan, BIT 35 (1995) 258.
pub const Aba8_4: Perturbation<Splitting<5>> = Perturbation(
    Splitting::drift_first(
        "Aba8_4",
        4,
        [
            0.075346960269892888416527803683474464372652664554079,
            0.51791685468825678230077397849631564432384744782198,
            -0.09326381495814967071730178217979010869650011237606,
        ],
        [
            0.19022593937367661924523076273845389746120361990487,
            0.84652407044352625705508054464677583417711374239468,
            -1.0735000196344057526006226147704594632766347245991,
        ],
    )
    .near_integrable(&[8, 4]),
);

/// Orders (8, 6, 4), 7 forces. S. Blanes, F. Casas, A. Farrés, J. Laskar, J. Makazaga & A. Murua, Appl. Numer. Math. 68 (2013) 58; A.
/// Farrés et al., Celest. Mech. Dyn. Astron. 116 (2013) 141, table 3.
pub const Aba8_6_4: Perturbation<Splitting<7>> = Perturbation(
    Splitting::drift_first(
        "Aba8_6_4",
        4,
        [
            0.07113342649822311777793873000615499641740229592374,
            0.24115342795664009873648779532628964961781467804934,
            0.52141176177281478921213607806799422999143647885026,
            -0.33369861622767800572656260340043887602665345282334,
        ],
        [
            0.1830836874721972219617037571664302910726241265516,
            0.31078285989857486950752229105426279637515732111626,
            -0.026564618511958800697212137916498759266329772852548,
            0.065396142282373418455972179391611343637096650369384,
        ],
    )
    .near_integrable(&[8, 6, 4]),
);

/// Orders (10, 6, 4), 8 forces. For long runs of planets with errors of 10⁻⁹ and less, and steps up to a fifth of the innermost period.
/// The sources are those of [`Aba8_6_4`].
#[doc(alias = "SABA(10,6,4)")]
pub const Aba10_6_4: Perturbation<Splitting<8>> = Perturbation(
    Splitting::drift_first(
        "Aba10_6_4",
        4,
        [
            0.038094497422412195456975322308637565340660060395807,
            0.14529871611691374929402007266066374974430888514613,
            0.20762769572554125071620561132498820651583696844616,
            0.43590970365152615922315486240106518440068879649433,
            -0.65386122583278670938071173739070941200298942096484,
        ],
        [
            0.095858880837075210610771503771458847769342226040715,
            0.20444615314299878068050778391643447797632995861737,
            0.21707034797899110171433859243063367145297598204211,
            -0.017375381959065093005617880118526997198648166700194,
        ],
    )
    .near_integrable(&[10, 6, 4]),
);

/// Orders (10, 8, 6), 12 forces, for an A of degree 2 in the momenta. For oscillators with a small rest and errors of 10⁻⁶ and less.
/// A. Escorihuela-Tomàs, S. Blanes & F. Casas. The digits were computed from the order conditions.
pub const Rnia10_8_6: Perturbation<Nystrom<12, DriftFirst>> = Perturbation(
    Nystrom::drift_first(
        "Rnia10_8_6",
        6,
        [
            0.037424188242624325968368262247184297021237374012019,
            0.26561064604365719378697580612416164525446242780896,
            -0.11898009697238293107756923215408457878013090047804,
            0.2593429559795568375007620483757755314665595494919,
            -0.050487109506873995190790509011672541937495296128551,
            -0.1757970916894682379393580359200237698476160386687,
            0.56577301580577361390322332067731883364596576792482,
        ],
        [
            0.094620465621870873233062722996722200767844396348324,
            -0.083113003302747655954235747407470735195774138352586,
            0.1708689632241170212948043845736803288402338443833,
            -0.098522326906392763838537508515299488479056180636178,
            0.37047037569665758912919684348299686266946557692867,
            0.045675525666494936135709304869370831397286501328473,
        ],
    )
    .near_integrable(&[10, 8, 6]),
);

/// Gauss's nodes, and a force gradient in the two inner kicks. Orders (4, 4), 2 forces. After J. Laskar & P. Robutel, Celest. Mech. Dyn.
/// Astron. 80 (2001) 39, whose corrector is at both ends.
pub const Saba2Gradient: Perturbation<Splitting<2, WithGradient>> = Perturbation(
    Splitting::<2, WithGradient>::drift_first(
        "Saba2Gradient",
        4,
        [0.21132486540518711774542560974902127217619912436494, 0.57735026918962576450914878050195745564760175127013],
        [0.5],
    )
    .with_gradients([0.0055822748423150563848448678852943256886915572122837])
    .near_integrable(&[4, 4]),
);

/// Gauss's nodes, and a force gradient in the middle. Orders (6, 4), 3 forces. After J. Laskar & P. Robutel, Celest. Mech. Dyn.
/// Astron. 80 (2001) 39, whose corrector is at both ends.
pub const Saba3Gradient: Perturbation<Splitting<3, WithGradient>> = Perturbation(
    Splitting::<3, WithGradient>::drift_first(
        "Saba3Gradient",
        4,
        [0.11270166537925831148207346002176003891670782947084, 0.38729833462074168851792653997823996108329217052916],
        [0.27777777777777777777777777777777777777777777777778, 0.44444444444444444444444444444444444444444444444444],
    )
    .with_gradients([0.0, 0.0056345933631228094022678237697975386715617559123601])
    .near_integrable(&[6, 4]),
);

/// Gauss's nodes, and a force gradient in the two inner kicks. Orders (8, 4), 4 forces. After J. Laskar & P. Robutel, Celest. Mech. Dyn.
/// Astron. 80 (2001) 39, whose corrector is at both ends.
pub const Saba4Gradient: Perturbation<Splitting<4, WithGradient>> = Perturbation(
    Splitting::<4, WithGradient>::drift_first(
        "Saba4Gradient",
        4,
        [
            0.069431844202973712388026755553595247452137310185141,
            0.2605776340045981552106403648947824089475747549294,
            0.33998104358485626480266575910324468720057586977091,
        ],
        [0.17392742256872692868653197461099970361767434791695, 0.32607257743127307131346802538900029638232565208305],
    )
    .with_gradients([0.0, 0.0016983875241043006657660788917460718985107066250374])
    .near_integrable(&[8, 4]),
);

/// Gauss's nodes, and a force gradient in the middle. Orders (10, 4), 5 forces. After J. Laskar & P. Robutel, Celest. Mech. Dyn.
/// Astron. 80 (2001) 39, whose corrector is at both ends.
pub const Saba5Gradient: Perturbation<Splitting<5, WithGradient>> = Perturbation(
    Splitting::<5, WithGradient>::drift_first(
        "Saba5Gradient",
        4,
        [
            0.046910077030668003601186560850303517437174044618735,
            0.18385526791649045088065622879959208007918265192849,
            0.26923465505284154551815721035010440248364330345278,
        ],
        [
            0.11846344252809454375713202035995868132163000110621,
            0.23931433524968323402064575741781909645614777667157,
            0.28444444444444444444444444444444444444444444444444,
        ],
    )
    .with_gradients([0.0, 0.0, 0.0022705431214192648194349550500391298792644087408074])
    .near_integrable(&[10, 4]),
);

/// [`WisdomHolman`] with a processor of 4 nodes. Orders (10, 2), 1 force. For planets with errors of 10⁻⁶.
#[doc(alias = "symplectic corrector")]
///
/// The processor costs 12 kicks and 13 flows of A before the first step of a run, and again for every state that is read. Read states
/// seldom. To first order in B, the kernel differs from the exact flow by a derivative along A, D = h{·, A}. The processor
/// χ = 1/(2 sinh D/2) − 1/D removes this difference up to O(h¹⁰).
/// J. Wisdom, M. Holman & J. Touma, Fields Inst. Comm. 10 (1996) 217; J. Wisdom, Astron. J. 131 (2006) 2294.
pub const WisdomHolmanProcessed: Perturbation<ProcessedSplitting<1, 13>> = Perturbation(ProcessedSplitting::new(
    2,
    Splitting::drift_first("WisdomHolmanProcessed", 2, [0.5], [1.0]).near_integrable(&[10, 2]),
    wisdom_processor(),
));

/// [`WisdomHolmanProcessed`] with a force gradient in the kick. Orders (10, 4), 1 force. For planets with errors of 10⁻⁹ and less.
///
/// rustc 1.95 compiled programs with four bodies wrongly at `opt-level = 3`, until one function was moved out of line. Compare the energies of a release
/// build and a debug build. If they differ, use `-C no-vectorize-slp`.
pub const WisdomHolmanGradient: Perturbation<ProcessedSplitting<1, 13, WithGradient>> =
    Perturbation(ProcessedSplitting::new(
        4,
        Splitting::<1, WithGradient>::drift_first("WisdomHolmanGradient", 2, [0.5], [1.0])
            .with_gradients([1.0 / 24.0])
            .near_integrable(&[10, 4]),
        wisdom_processor(),
    ));

/// Nodes of the processor.
const NODES: usize = 4;

/// Shifts aᵢ along the flow of A in units of h, aᵢ = i √(7/40): the spacing of J. Wisdom, M. Holman & J. Touma, Fields Inst. Comm. 10 (1996) 217.
const SHIFTS: [f64; NODES] = [
    0.41833001326703777398908601289259374469640768464934,
    0.83666002653407555479817202578518748939281536929867,
    1.254990039801113321967258038677781234089223053948,
    1.6733200530681510959563440515703749787856307385973,
];

/// Fractions bᵢ of h for the kicks at these shifts: 2 Σ bᵢ aᵢ^(2k−1)/(2k−1)! = B₂ₖ(½)/(2k)! for k = 1, …, 4 with Bernoulli's polynomials B₂ₖ.
const KICKS: [f64; NODES] = [
    -0.12808306259348757025513493471379760181733964159608,
    0.056696110900636835767727720496846376435738556601966,
    -0.013622904174198380932207407388173612926865242680775,
    0.0014395903148023266294002147662697033394595734940552,
];

/// Returns the flows A(aᵢ) B(bᵢ/2) A(−2aᵢ) B(−bᵢ) A(2aᵢ) B(bᵢ/2) A(−aᵢ) of all nodes. The last flow of a node is merged with the first of the next.
const fn wisdom_processor() -> [[f64; 3]; 3 * NODES + 1] {
    let (mut flows, mut back, mut i) = ([[0.0; 3]; 3 * NODES + 1], 0.0, 0);
    while i < NODES {
        let (a, b) = (SHIFTS[i], KICKS[i]);
        flows[3 * i] = [a - back, 0.5 * b, 0.0];
        flows[3 * i + 1] = [-2.0 * a, -b, 0.0];
        flows[3 * i + 2] = [2.0 * a, 0.5 * b, 0.0];
        (back, i) = (a, i + 1);
    }
    flows[3 * NODES] = [-back, 0.0, 0.0];
    flows
}
