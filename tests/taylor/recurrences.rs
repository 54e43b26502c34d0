//! Every recurrence against a table of 50 digits (Cauchy's integral with 110 digits), at t = 0 for
//! u = 2/5 + sin(t)/3 + t²/7 and v = 13/10 + cos(2t)/5 − t/4; and every kind of system against truncated series as a scalar.

use geoint_runtime::prelude::*;
use geoint_runtime::scalar::{Real, Series};
use geoint_runtime::space::Array;
use geoint_runtime::system::{Contact, Jets, PhaseSpace, VectorField};

/// x' = F(t) for every function of the table, with u and v by their coefficients: those of products with t are exact.
#[vector_field]
#[allow(unused_variables, reason = "the field depends on time alone")]
fn functions(x: [f64; 24], t: f64) -> [f64; 24] {
    const U: [f64; 32] = [
        0.4,
        0.3333333333333333,
        0.14285714285714285,
        -0.05555555555555555,
        0.0,
        0.002777777777777778,
        0.0,
        -6.613756613756614e-05,
        0.0,
        9.185773074661964e-07,
        0.0,
        -8.35070279514724e-09,
        0.0,
        5.3530146122738715e-11,
        0.0,
        -2.5490545772732723e-13,
        0.0,
        9.371524181151737e-16,
        0.0,
        -2.7402117488747765e-18,
        0.0,
        6.524313687797087e-21,
        0.0,
        -1.2893900568768947e-23,
        0.0,
        2.1489834281281578e-26,
        0.0,
        -3.0612299545985155e-29,
        0.0,
        3.7699876288159057e-32,
        0.0,
        -4.0537501385117263e-35,
    ];
    const V: [f64; 32] = [
        1.5,
        -0.25,
        -0.4,
        0.0,
        0.13333333333333333,
        0.0,
        -0.017777777777777778,
        0.0,
        0.0012698412698412698,
        0.0,
        -5.6437389770723105e-05,
        0.0,
        1.7102239324461546e-06,
        0.0,
        -3.758733917464076e-08,
        0.0,
        6.264556529106794e-10,
        0.0,
        -8.188962783146136e-12,
        0.0,
        8.619960824364354e-14,
        0.0,
        -7.463169544904202e-16,
        0.0,
        5.408093873118987e-18,
        0.0,
        -3.328057768073223e-20,
        0.0,
        1.7608771259646682e-22,
        0.0,
        -8.095986786044451e-25,
        0.0,
    ];
    let (mut u, mut v) = (0.0, 0.0);
    for k in (0..32).rev() {
        u = U[k] + t * u;
        v = V[k] + t * v;
    }
    [
        u * v,
        u * u,
        u / v,
        u.sqrt(),
        u.powf(-1.5),
        u.powf(0.7),
        u.cbrt(),
        u.exp(),
        u.ln(),
        u.sin(),
        u.cos(),
        u.sinh(),
        u.cosh(),
        u.tan(),
        u.tanh(),
        u.asin(),
        u.acos(),
        u.atan(),
        u.asinh(),
        (u + 2.0).acosh(),
        u.atanh(),
        u.atan2(v),
        u.hypot(v),
        u.powf(v),
    ]
}

/// Name, coefficients of orders 5, 10 and 30, and the error in roundings of the scale, in which the roundings of u and v count
/// (up to twelve with exact arithmetic behind them). What is divided by at every order, √u₀ or √(1 − u₀²), is rounded once, and that counts n
/// times: hence the larger ones.
const TABLE: [(&str, [f64; 3], f64); 24] = [
    (
        "u*v",
        [
            0.070833333333333333333333333333333,
            0.00015860129545645418661291677164693,
            2.4831548032914225553567986331264e-23,
        ],
        12.0,
    ),
    (
        "u^2",
        [
            -0.013650793650793650793650793650794,
            0.000015677052714089751126788163825201,
            2.2488852183456808256902946370423e-25,
        ],
        12.0,
    ),
    (
        "u/v",
        [
            0.0039435626102292768959435626102293,
            -0.00029131841784114956758499772413157,
            -3.1145721684450159351437116552778e-10,
        ],
        12.0,
    ),
    (
        "sqrt u",
        [
            -0.0022683153853996182826748137110944,
            0.00093089496217550939572085475341489,
            -0.000001468723940676868430766992706787,
        ],
        16.0,
    ),
    (
        "u^(-3/2)",
        [2.7100483319606511803511600399398, 0.44086067205099009700854280605441, 0.0041297070861406171459697250247466],
        12.0,
    ),
    (
        "u^0.7",
        [
            0.0010170193407569459541984465192901,
            0.00055109129647107775443671178832703,
            -0.0000005780052905974942524617385568232,
        ],
        12.0,
    ),
    (
        "cbrt u",
        [
            -0.0049609703521984315333946912153605,
            0.0010578532330979063926158914186831,
            -0.000002361675933564780437064544627529,
        ],
        12.0,
    ),
    (
        "exp u",
        [
            -0.0058593825782892479379308213455128,
            -0.0000091415584608746413006956665747291,
            -8.750755908934832792603891782164e-18,
        ],
        12.0,
    ),
    (
        "ln u",
        [
            -0.05991486100613084740068867052994,
            0.0067410990759822124466047598974799,
            -0.000031721298163517609225498038373443,
        ],
        12.0,
    ),
    (
        "sin u",
        [
            0.00573403371944464752555966484392,
            0.000029131547651690210478484823049283,
            2.3133986405553304099263262285582e-16,
        ],
        12.0,
    ),
    (
        "cos u",
        [
            0.0071498025524754955691302290498626,
            -0.000011763295090928410846414364449561,
            4.8884159752504728131420331305159e-17,
        ],
        12.0,
    ),
    (
        "sinh u",
        [
            0.00048280277237607833053278723430478,
            -0.000015267949374639536737147878543951,
            -4.9027258393561930632710846301756e-17,
        ],
        12.0,
    ),
    (
        "cosh u",
        [
            -0.0063421853506653262684636085798176,
            0.0000061263909137648954364522119692216,
            4.0276502484627097840106954519592e-17,
        ],
        12.0,
    ),
    (
        "tan u",
        [
            0.0070902896758433978608143714613328,
            0.000053505119826283241426723861406996,
            2.2209052169758397153573746112095e-13,
        ],
        12.0,
    ),
    (
        "tanh u",
        [
            0.010859759668376482623660861038495,
            0.00013952903721035485402567857727165,
            1.9125351732533052835931225091646e-11,
        ],
        12.0,
    ),
    (
        "asin u",
        [
            0.0076058374184659866929261960060652,
            0.00040999109229448347443721313476035,
            0.00000011999431900698813505677469399519,
        ],
        20.0,
    ),
    (
        "acos u",
        [
            -0.0076058374184659866929261960060652,
            -0.00040999109229448347443721313476035,
            -0.00000011999431900698813505677469399519,
        ],
        20.0,
    ),
    (
        "atan u",
        [
            0.010645734855311110334697440948468,
            0.000089519298332532409470753463353094,
            6.7010326348339139582247787967286e-10,
        ],
        12.0,
    ),
    (
        "asinh u",
        [
            0.0066257476135485909250704698967335,
            0.000052365597312228507287346071921587,
            1.5911173874378008206047460926246e-10,
        ],
        16.0,
    ),
    (
        "acosh(u+2)",
        [
            0.0028326448849306246955465318161365,
            0.00000024214914999537933552857330996129,
            -2.3051648038113286309474248158644e-13,
        ],
        19.0,
    ),
    (
        "atanh u",
        [
            0.020974317725219031963840130381011,
            0.0019910714595075352467773593662851,
            0.0000010277700286129749470413309950325,
        ],
        16.0,
    ),
    (
        "atan2(u,v)",
        [
            -0.016226197393718006634058239088871,
            0.0013933201505030957115895299275504,
            -0.000000061522261255570686769167681138777,
        ],
        12.0,
    ),
    (
        "hypot(u,v)",
        [
            -0.00093160189608974669097169610085081,
            0.00020581217099312202604576563307393,
            0.0000000075047307522597700111237627606801,
        ],
        12.0,
    ),
    (
        "u^v",
        [
            -0.085637835842096991527213639188576,
            -0.0094126044953896448772036885834685,
            0.00000015195507219878467611827240851922,
        ],
        200.0,
    ),
];

#[test]
fn every_recurrence() {
    const P: usize = 32;
    let zero = geoint_runtime::space::PerCoordinate { z: [0.0; 24], s: () };
    let (mut jet, mut switches) = ([zero; P], [[0.0; 0]; P]);
    Functions.jet(1.0, 0.0, &[0.0; 24], &(), &mut jet, &mut switches);
    for (i, (name, expected, bar)) in TABLE.iter().enumerate() {
        let f = |n: usize| jet[n].z[i] * (n + 1) as f64;
        let radius = (20..=30).map(|n| f(n).abs().powf(-1.0 / n as f64)).fold(f64::INFINITY, f64::min);
        for (n, expected) in [5, 10, 30].into_iter().zip(expected) {
            let scale = (0..=n).map(|j| f(j).abs() * radius.powi(j as i32 - n as i32)).fold(0.0, f64::max);
            let error = (f(n) - expected).abs() / (f64::EPSILON * scale);
            assert!(error <= *bar, "{name}, order {n}: {error}");
        }
    }
}

/// The coefficients of a solution by the field over series: each evaluation makes one more of them known.
fn by_series<const N: usize>(
    x: &[f64],
    mut field: impl FnMut(&[Series<f64, N>], Series<f64, N>) -> Vec<Series<f64, N>>,
    t: f64,
) -> Vec<[f64; N]> {
    let mut solution: Vec<Series<f64, N>> = x.iter().map(|x| Series::constant(*x)).collect();
    let mut time = Series::constant(t);
    time.0[1] = 1.0;
    for n in 1..N {
        let rates = field(&solution, time);
        for (x, rate) in solution.iter_mut().zip(rates) {
            x.0[n] = rate.0[n - 1] / n as f64;
        }
    }
    solution.into_iter().map(|x| x.0).collect()
}

const N: usize = 25;

/// Errors of a kernel's coefficients in units of the largest of their order, as far as their growth allows.
fn compare(name: &str, of_kernel: &[Vec<f64>], of_series: &[[f64; N]]) {
    let largest = |n: usize| of_series.iter().map(|x| x[n].abs()).fold(0.0, f64::max);
    let radius = (N - 8..N).map(|n| largest(n).powf(-1.0 / n as f64)).fold(f64::INFINITY, f64::min);
    for n in 1..N {
        let scale = (0..=n).map(|j| largest(j) * radius.powi(j as i32 - n as i32)).fold(0.0, f64::max);
        for (kernel, series) in of_kernel.iter().zip(of_series) {
            let error = (kernel[n - 1] - series[n]).abs() / scale;
            assert!(error <= 1e-13, "{name}, order {n}: {} is not {}, {error:.1e}", kernel[n - 1], series[n]);
        }
    }
}

/// The kernel of a system without parameters.
fn kernel<S: Jets>(system: &S, t: f64, z: S::Phase, s: S::Action) -> Vec<Vec<f64>> {
    let mut jet = [geoint_runtime::space::PerCoordinate { z, s }; N - 1];
    let mut switches = [S::Switches::zero(); N - 1];
    system.jet(1.0, t, &z, &s, &mut jet, &mut switches);
    use geoint_runtime::space::Action;
    let numbers = |i: usize| {
        let of = |x: &geoint_runtime::space::PerCoordinate<S::Phase, S::Action>| {
            *x.z.as_slice().iter().chain(x.s.numbers()).nth(i).unwrap()
        };
        jet.iter().map(of).collect()
    };
    (0..S::Phase::LEN + s.numbers().len()).map(numbers).collect()
}

type OverSeries = Series<f64, N>;

/// A field, or an energy without action.
fn check_field<S>(name: &str, system: S, t: f64, x: &[f64])
where
    S: Jets<f64, Action = ()> + VectorField<OverSeries>,
    <S as PhaseSpace<f64>>::Phase: Array<Real = f64>,
    <S as PhaseSpace<OverSeries>>::Phase: Array<Real = OverSeries>,
{
    let mut z = <S as PhaseSpace<f64>>::Phase::zero();
    z.as_mut_slice().copy_from_slice(x);
    let field = |x: &[Series<f64, N>], t: Series<f64, N>| {
        let mut z = <S as PhaseSpace<Series<f64, N>>>::Phase::zero();
        z.as_mut_slice().copy_from_slice(x);
        let mut dz = z;
        system.rate(t, &z, &mut dz);
        dz.as_slice().to_vec()
    };
    compare(name, &kernel(&system, t, z, ()), &by_series(x, field, t));
}

fn check_contact<S>(name: &str, system: S, t: f64, x: &[f64])
where
    S: Jets<f64, Action = f64> + Contact<OverSeries>,
    <S as PhaseSpace<f64>>::Phase: Array<Real = f64>,
    <S as PhaseSpace<OverSeries>>::Phase: Array<Real = OverSeries>,
{
    let (coordinates, action) = x.split_at(x.len() - 1);
    let mut z = <S as PhaseSpace<f64>>::Phase::zero();
    z.as_mut_slice().copy_from_slice(coordinates);
    let field = |x: &[Series<f64, N>], t: Series<f64, N>| {
        let (coordinates, action) = x.split_at(x.len() - 1);
        let mut z = <S as PhaseSpace<Series<f64, N>>>::Phase::zero();
        Array::as_mut_slice(&mut z).copy_from_slice(coordinates);
        let (mut dz, mut ds) = (z, action[0]);
        system.rate(t, &z, &action[0], &mut dz, &mut ds);
        [Array::as_slice(&dz), &[ds]].concat()
    };
    compare(name, &kernel(&system, t, z, action[0]), &by_series(x, field, t));
}

#[hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2]) -> f64 {
    let mass = 1.7 + q[0].cos() * q[1].sin();
    (p[0] * p[0] + 0.6 * p[1] * p[1] + 0.3 * p[0] * p[1]) / (2.0 * mass) + (q[0] * q[1]).exp() + q[1].atan2(q[0])
}

#[hamiltonian]
fn driven(q: f64, p: f64, t: f64) -> f64 {
    p * p / (1.4 + t * t) + q.powi(4) / 4.0 - 0.3 * q * (1.3 * t + 0.2).cos() + (-0.4 * t).exp() * q.tanh()
}

#[hamiltonian(damping = 0.2 + q * q)]
fn damped(q: f64, p: f64) -> f64 {
    p * p / 2.6 - 1.7 * q.cos()
}

#[contact_hamiltonian]
fn twice_damped(q: [f64; 2], p: [f64; 2], s: f64, t: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.4 - (q[0] - q[1]).cos() + (0.2 + 0.1 * s.sin()) * s + 0.1 * t * q[0]
}

#[hamiltonian(structure = so3)]
fn top(x: [f64; 3]) -> f64 {
    x[0] * x[0] / 1.4 + x[1] * x[1] / 2.3 + x[2] * x[2] / 3.9 + 0.2 * x[0].powi(3)
}

#[vector_field]
fn van_der_pol(x: [f64; 2]) -> [f64; 2] {
    [x[1], 5.0 * (1.0 - x[0] * x[0]) * x[1] - x[0]]
}

#[lagrangian]
fn double_pendulum(q: [f64; 2], v: [f64; 2]) -> f64 {
    v[0] * v[0] + v[1] * v[1] / 2.0 + v[0] * v[1] * (q[0] - q[1]).cos() + 9.81 * (2.0 * q[0].cos() + q[1].cos())
}

#[hamiltonian]
fn branches(q: f64, p: f64) -> f64 {
    let wall = if q > 1.0 { (q - 1.0).powi(2) } else { 0.3 * (q - 1.0).powi(3) };
    p * p / 2.6 + wall + (q - 0.3).abs() * p.max(q) + (p * q).min(0.1)
}

#[hamiltonian]
fn powers(q: f64, p: f64) -> f64 {
    let r = 1.0 + q * q;
    p.powi(3) / 3.0
        + r.powf(-1.5)
        + r.powf(-2.5)
        + r.sqrt()
        + 1.0 / r
        + q.powi(7)
        + (2.0 + q).powf(p)
        + (3.0 + p).cbrt()
        + 2.0_f64.powf(q)
        + (q / 9.0).asin()
        + (q / 7.0).acos()
        + (q / 8.0).atanh()
        + q.asinh()
        + (2.0 + r).acosh()
        + r.ln()
        + r.log10()
        + q.ln_1p() * p.exp_m1()
        + q.tan()
        + p.sinh()
        + q.cosh()
        + q.hypot(p)
        + r.log2()
}

#[test]
fn every_kind_of_system() {
    check_field("coupled", Coupled, 0.0, &[0.7, -0.4, 0.3, 1.1]);
    check_field("driven", Driven, 0.3, &[0.7, -0.4]);
    check_field("damped", Damped, 0.0, &[0.7, -0.4]);
    check_field("top", Top, 0.0, &[0.7, -0.4, 0.9]);
    check_field("van der pol", VanDerPol, 0.0, &[1.9, -0.4]);
    check_field("double pendulum", DoublePendulum, 0.0, &[1.0, 1.2, 0.3, -0.8]);
    check_field("branches", Branches, 0.0, &[0.7, -0.4]);
    check_field("branches", Branches, 0.0, &[1.3, 0.4]);
    check_field("powers", Powers, 0.0, &[0.4, 0.3]);
    check_contact("contact", TwiceDamped, 0.2, &[0.7, -0.4, 0.3, 1.1, 0.6]);
}

#[test]
fn a_recurrence_that_is_wrong_is_seen() {
    let right = by_series::<N>(&[0.7, -0.4], |x, _| vec![x[1], -Real::sin(x[0])], 0.0);
    let mut wrong: Vec<Vec<f64>> = right.iter().map(|x| x[1..].to_vec()).collect();
    compare("pendulum", &wrong, &right);
    wrong[1][12] *= 1.0 + 1e-11;
    assert!(std::panic::catch_unwind(|| compare("pendulum", &wrong, &right)).is_err());
}
