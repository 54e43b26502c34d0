//! Lagrangians that are linear in velocities, ϑ(q)·v − H(q).

use geoint_runtime::VectorField;
use geoint_runtime::prelude::*;
use geoint_runtime::space::{Array, Snapshot};

/// Lotka and Volterra in the numbers of animals themselves; ϑ is zero in y.
#[lagrangian]
fn lotka_volterra(q: [f64; 2], v: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    let [x, y] = q;
    y.ln() / x * v[0] + b * x - c * x.ln() + b * y - a * y.ln()
}

/// The same with another ϑ, no entry of which is zero: both differ by a gradient.
#[lagrangian]
fn lotka_volterra_symmetric(q: [f64; 2], v: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    let [x, y] = q;
    0.5 * (y.ln() / x * v[0] - x.ln() / y * v[1]) + b * x - c * x.ln() + b * y - a * y.ln()
}

/// Four kinds; ϑ has no zero half, and Ω vanishes on none.
#[lagrangian]
fn lotka_volterra_four(q: [f64; 4], v: [f64; 4], a: [f64; 4], b: [f64; 4]) -> f64 {
    let signs = [[0.0, -1.0, 1.0, -1.0], [1.0, 0.0, -1.0, 1.0], [-1.0, 1.0, 0.0, -1.0], [1.0, -1.0, 1.0, 0.0]];
    let mut sum = 0.0;
    for i in 0..4 {
        for j in 0..4 {
            sum += 0.5 * signs[i][j] * q[i].ln() * v[j] / q[j];
        }
        sum -= a[i] * q[i] + b[i] * q[i].ln();
    }
    sum
}

/// The same where the second and the fourth kind do not meet: there are canonical coordinates.
#[lagrangian]
fn lotka_volterra_apart(q: [f64; 4], v: [f64; 4], a: [f64; 4], b: [f64; 4]) -> f64 {
    let signs = [[0.0, -1.0, 1.0, -1.0], [1.0, 0.0, -1.0, 0.0], [-1.0, 1.0, 0.0, -1.0], [1.0, 0.0, 1.0, 0.0]];
    let mut sum = 0.0;
    for i in 0..4 {
        for j in 0..4 {
            sum += 0.5 * signs[i][j] * q[i].ln() * v[j] / q[j];
        }
        sum -= a[i] * q[i] + b[i] * q[i].ln();
    }
    sum
}

/// Three kinds on a level set of x₁x₂x₃ = c, by the first two: in all three Ω would be singular.
#[lagrangian]
fn lotka_volterra_three(q: [f64; 2], v: [f64; 2], a: [f64; 3], b: [f64; 3], c: f64) -> f64 {
    let [x, y] = q;
    let z = c / (x * y);
    -y.ln() / x * v[0] - (a[0] * x + a[1] * y + a[2] * z + b[0] * x.ln() + b[1] * y.ln() + b[2] * z.ln())
}

/// The same in all three.
#[hamiltonian(structure = [[0.0, -x[0] * x[1], x[0] * x[2]], [x[0] * x[1], 0.0, -x[1] * x[2]], [-x[0] * x[2], x[1] * x[2], 0.0]])]
fn three_kinds(x: [f64; 3], a: [f64; 3], b: [f64; 3]) -> f64 {
    let mut sum = 0.0;
    for i in 0..3 {
        sum += a[i] * x[i] + b[i] * x[i].ln();
    }
    sum
}

/// Vortices of given circulations in the plane.
#[lagrangian]
fn vortices(q: [[f64; 2]; 3], v: [[f64; 2]; 3], circulation: [f64; 3]) -> f64 {
    let mut sum = 0.0;
    for i in 0..3 {
        sum += 0.5 * circulation[i] * (q[i][0] * v[i][1] - q[i][1] * v[i][0]);
        for j in 0..i {
            let (dx, dy) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
            sum += circulation[i] * circulation[j] * (dx * dx + dy * dy).ln() / 8.0;
        }
    }
    sum
}

/// A massless charged particle in a magnetic field that grows outwards.
#[lagrangian]
fn massless_charge(q: [f64; 2], v: [f64; 2], field: f64, potential: f64) -> f64 {
    let [x, y] = q;
    let strength = 0.5 * field * (1.0 + x * x + y * y);
    strength * (x * v[1] - y * v[0]) - potential * (x.cos() + y.sin())
}

/// The guiding centre of a charged particle in a torus: a strong field 1/r about an axis with a twisting part; q = (r, φ, z, u), u along
/// the field.
#[lagrangian]
fn guiding_centre(q: [f64; 4], v: [f64; 4], field: f64, twist: f64, moment: f64) -> f64 {
    let [r, _, z, u] = q;
    let (x, y) = (r - 1.0, z);
    let poloidal = (x * x + y * y) / (2.0 * twist);
    let [b_r, b_z] = [y / (twist * r), -x / (twist * r)];
    let toroidal = field / r;
    let strength = (toroidal * toroidal + b_r * b_r + b_z * b_z).sqrt();
    // A with an entry in r, φ and z, and u·b.
    let a = [-field * z / (2.0 * r), poloidal, 0.5 * field * r.ln()];
    let along = u / strength;
    (a[0] + along * b_r) * v[0] + (a[1] + along * toroidal * r) * v[1] + (a[2] + along * b_z) * v[2]
        - u * u / 2.0
        - moment * strength
}

const PLANE: LotkaVolterra = LotkaVolterra { a: 1.0, b: 0.7, c: 0.5 };
const SYMMETRIC: LotkaVolterraSymmetric = LotkaVolterraSymmetric { a: 1.0, b: 0.7, c: 0.5 };
const FOUR: LotkaVolterraFour = LotkaVolterraFour { a: [1.0; 4], b: [-1.0, -2.0, -1.0, -1.0] };
const APART: LotkaVolterraApart = LotkaVolterraApart { a: [1.0, 0.8, 1.1, 0.9], b: [-1.0, -2.0, -1.0, -1.0] };
const VORTICES: Vortices = Vortices { circulation: [1.0, -0.7, 0.4] };
const CHARGE: MasslessCharge = MasslessCharge { field: 1.3, potential: 0.8 };
const GUIDED: GuidingCentre = GuidingCentre { field: 1.2, twist: 2.0, moment: 0.02 };

/// The end of a run, and by how much H strayed.
fn run<S: VectorField, M: Method<S>>(system: S, method: M, start: S::State, h: f64, time: f64) -> (Vec<f64>, f64) {
    let mut sim = Integrator::new(system, method, h, start);
    let (mut strayed, before) = (0.0, sim.energy());
    for _ in 0..(time / h).round() as u64 {
        sim.step().expect("a step");
        strayed = f64::max(strayed, (sim.energy() - before).abs());
    }
    (sim.state().parts().1.as_slice().to_vec(), strayed)
}

fn far(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |far, (a, b)| f64::max(far, (a - b).abs()))
}

/// Returns the errors at three step sizes. Each step size is half of the one before.
fn errors<S: VectorField, M: Method<S>>(system: S, method: M, start: S::State, first: f64, time: f64) -> [f64; 3]
where
    Gauss<6>: Method<S>,
{
    let (exact, _) = run(system, Gauss::<6>, start, first / 4.0, time);
    [first, first / 2.0, first / 4.0].map(|h| far(&run(system, method, start, h, time).0, &exact))
}

fn has_order(errors: [f64; 3], order: f64) {
    for pair in errors.windows(2) {
        let found = (pair[0] / pair[1]).log2();
        assert!((found - order).abs() < 0.1, "order {found:.2} of {errors:?}");
    }
}

/// Errors and defects of H as they were found by another program.
#[test]
fn animals_have_the_published_errors() {
    let start = PLANE.at([1.0, 1.5]);
    let same = |found: [f64; 3], expected: [f64; 3]| {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 0.05 * expected, "{found:.3e} in place of {expected:.3e}");
        }
    };
    same(errors(PLANE, ImplicitMidpoint, start, 0.2, 10.0), [2.45e-3, 6.13e-4, 1.53e-4]);
    same(errors(PLANE, Gauss::<2>, start, 0.2, 10.0), [5.71e-7, 3.55e-8, 2.22e-9]);
    same(errors(PLANE, DiscreteGradient, start, 0.2, 10.0), [3.22e-3, 8.07e-4, 2.02e-4]);
    let strayed = [0.2, 0.05].map(|h| run(PLANE, Gauss::<1>, start, h, 10.0).1);
    assert!((strayed[0] - 5.5e-5).abs() < 1e-6 && (strayed[1] - 3.5e-6).abs() < 1e-7, "{strayed:?}");
    let strayed = [0.2, 0.05].map(|h| run(PLANE, Gauss::<2>, start, h, 10.0).1);
    assert!((strayed[0] - 6.1e-8).abs() < 1e-9 && (strayed[1] - 2.4e-10).abs() < 1e-11, "{strayed:?}");
    assert!(run(PLANE, DiscreteGradient, start, 0.2, 10.0).1 < 2e-15);
}

#[test]
fn every_order_is_there() {
    has_order(errors(SYMMETRIC, Gauss::<2>, SYMMETRIC.at([1.0, 1.5]), 0.2, 10.0), 4.0);
    has_order(errors(PLANE, Gauss::<3>, PLANE.at([1.0, 1.5]), 0.4, 10.0), 6.0);
    has_order(errors(APART, Gauss::<2>, APART.at([2.0, 1.0, 1.3, 1.0]), 0.05, 2.0), 4.0);
    has_order(errors(CHARGE, Gauss::<2>, CHARGE.at([1.0, 1.0]), 0.4, 8.0), 4.0);
    has_order(errors(CHARGE, DiscreteGradient, CHARGE.at([1.0, 1.0]), 0.2, 8.0), 2.0);
    let start = VORTICES.at([[0.5, 0.1], [-0.4, 0.3], [0.2, -0.6]]);
    has_order(errors(VORTICES, Gauss::<2>, start, 0.1, 4.0), 4.0);
    let start = GUIDED.at([1.3, 0.0, 0.1, 0.4]);
    has_order(errors(GUIDED, Gauss::<2>, start, 0.4, 8.0), 4.0);
    has_order(errors(GUIDED, DiscreteGradient, start, 0.2, 8.0), 2.0);
    has_order(errors(FOUR, DiscreteGradient, FOUR.at([2.0, 1.0, 1.0, 1.0]), 0.02, 2.0), 2.0);
}

/// With ϑ and with ϑ + ∇f: the same canonical coordinates are found.
#[test]
fn gauge_changes_nothing() {
    let one = run(PLANE, Gauss::<2>, PLANE.at([1.0, 1.5]), 0.2, 10.0).0;
    let other = run(SYMMETRIC, Gauss::<2>, SYMMETRIC.at([1.0, 1.5]), 0.2, 10.0).0;
    assert!(far(&one, &other) < 1e-13, "{one:?} {other:?}");
}

/// Ends of runs as GeometricProblems.jl gives them for its Lotka–Volterra systems in three and four dimensions.
#[test]
fn three_and_four_kinds_end_where_others_say() {
    let four = run(FOUR, Gauss::<4>, FOUR.at([2.0, 1.0, 1.0, 1.0]), 0.01, 10.0).0;
    assert!(
        far(&four, &[0.598_869_523_909_691_6, 2.068_567_531_039_674, 0.280_435_145_864_553_4, 1.258_449_091_830_993])
            < 1e-12,
        "{four:?}"
    );
    let (a, b) = ([1.0; 3], [0.0, 1.0, 1.0]);
    let expected = [1.242_931_331_023_023_7, 2.263_720_576_035_246, 0.710_820_659_393_2];
    let system = LotkaVolterraThree { a, b, c: 2.0 };
    let plane = run(system, Gauss::<4>, system.at([1.0, 1.0]), 0.01, 10.0).0;
    assert!(far(&plane, &expected[..2]) < 1e-12, "{plane:?}");
    assert!((2.0 / (plane[0] * plane[1]) - expected[2]).abs() < 1e-12);
    let system = ThreeKinds { a, b };
    let space = run(system, Gauss::<4>, FlowState::new([1.0, 1.0, 2.0]), 0.01, 10.0).0;
    assert!(far(&space, &expected) < 1e-12, "{space:?}");
}

/// Asserts Ω v = ∇H by differences of the functions that users call.
#[test]
fn velocities_are_those_of_lagranges_equations() {
    fn holds<const N: usize>(
        q: [f64; N],
        momentum: impl Fn([f64; N]) -> [f64; N],
        lagrangian: impl Fn([f64; N], [f64; N]) -> f64,
        velocity: [f64; N],
    ) {
        let h = 1e-5;
        let moved = |i: usize, by: f64| {
            let mut q = q;
            q[i] += by;
            q
        };
        for i in 0..N {
            // d/dt ϑᵢ = ∂L/∂qᵢ.
            let along = |by: f64| std::array::from_fn(|j| q[j] + by * velocity[j]);
            let rate = (momentum(along(h))[i] - momentum(along(-h))[i]) / (2.0 * h);
            let force = (lagrangian(moved(i, h), velocity) - lagrangian(moved(i, -h), velocity)) / (2.0 * h);
            assert!((rate - force).abs() < 1e-7, "{rate} {force}");
        }
    }
    let q = [1.1, 0.6];
    holds(q, |q| PLANE.momentum(0.0, q), |q, v| PLANE.lagrangian(0.0, q, v), PLANE.velocity(&PLANE.at(q)));
    holds(q, |q| CHARGE.momentum(0.0, q), |q, v| CHARGE.lagrangian(0.0, q, v), CHARGE.velocity(&CHARGE.at(q)));
    let q = [1.3, 0.2, 0.1, 0.4];
    holds(q, |q| FOUR.momentum(0.0, q), |q, v| FOUR.lagrangian(0.0, q, v), FOUR.velocity(&FOUR.at(q)));
    holds(q, |q| APART.momentum(0.0, q), |q, v| APART.lagrangian(0.0, q, v), APART.velocity(&APART.at(q)));
    holds(q, |q| GUIDED.momentum(0.0, q), |q, v| GUIDED.lagrangian(0.0, q, v), GUIDED.velocity(&GUIDED.at(q)));
}

/// Areas weighted with Ω = −1/(xy) stay: det ∂x₁/∂x₀ = x₁y₁/(x₀y₀) for collocation in canonical coordinates, and not for the
/// discrete gradient.
#[test]
fn collocation_is_symplectic() {
    fn defect<M: Method<LotkaVolterra>>(method: M) -> f64 {
        let (q, d) = ([1.0, 1.5], 1e-4);
        let end = |q: [f64; 2]| run(PLANE, method, PLANE.at(q), 0.4, 0.8).0;
        let slope = |i: usize| {
            let at = |by: f64| {
                let mut q = q;
                q[i] += by;
                end(q)
            };
            let [a, b, c, e] = [at(-2.0 * d), at(-d), at(d), at(2.0 * d)];
            [0, 1].map(|j| (a[j] - 8.0 * b[j] + 8.0 * c[j] - e[j]) / (12.0 * d))
        };
        let ([a, c], [b, e], end) = (slope(0), slope(1), end(q));
        (a * e - b * c - end[0] * end[1] / (q[0] * q[1])).abs()
    }
    assert!(
        defect(Gauss::<1>) < 1e-10 && defect(Gauss::<2>) < 1e-10,
        "{:e} {:e}",
        defect(Gauss::<1>),
        defect(Gauss::<2>)
    );
    assert!(defect(DiscreteGradient) > 1e-4, "{:e}", defect(DiscreteGradient));
}

/// To rounding, for large steps, whatever Ω is.
#[test]
fn discrete_gradients_keep_the_energy() {
    assert!(run(CHARGE, DiscreteGradient, CHARGE.at([1.0, 1.0]), 0.5, 200.0).1 < 1e-14);
    assert!(run(FOUR, DiscreteGradient, FOUR.at([2.0, 1.0, 1.0, 1.0]), 0.1, 50.0).1 < 1e-12);
    assert!(run(GUIDED, DiscreteGradient, GUIDED.at([1.3, 0.0, 0.1, 0.4]), 0.5, 200.0).1 < 1e-14);
    let start = VORTICES.at([[0.5, 0.1], [-0.4, 0.3], [0.2, -0.6]]);
    assert!(run(VORTICES, DiscreteGradient, start, 0.1, 50.0).1 < 1e-14);
}

/// Vortices keep the centre and the moment of their circulations, which are of degree 2.
#[test]
fn vortices_keep_their_centre() {
    let moments = |q: [[f64; 2]; 3]| {
        let sum = |of: &dyn Fn([f64; 2]) -> f64| (0..3).map(|i| VORTICES.circulation[i] * of(q[i])).sum::<f64>();
        [sum(&|q| q[0]), sum(&|q| q[1]), sum(&|q| q[0] * q[0] + q[1] * q[1])]
    };
    let start = VORTICES.at([[0.5, 0.1], [-0.4, 0.3], [0.2, -0.6]]);
    let mut sim = VORTICES.integrator(Gauss::<2>, 0.1, start);
    let before = moments(start.x);
    sim.advance(500).expect("steps");
    assert!(far(&moments(sim.state().x), &before) < 1e-13);
}

#[test]
fn reports_say_what_was_found() {
    assert!(
        LotkaVolterra::REPORT.contains("canonical coordinates: q[0] and, in the place of q[1], "),
        "{}",
        LotkaVolterra::REPORT
    );
    assert!(MasslessCharge::REPORT.contains("gauge: ϑ + ∇f with f = "), "{}", MasslessCharge::REPORT);
    assert!(LotkaVolterraApart::REPORT.contains("canonical coordinates: "), "{}", LotkaVolterraApart::REPORT);
    assert!(LotkaVolterraFour::REPORT.contains("no canonical coordinates"), "{}", LotkaVolterraFour::REPORT);
    assert!(GuidingCentre::REPORT.contains("no canonical coordinates"), "{}", GuidingCentre::REPORT);
}
