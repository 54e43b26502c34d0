//! A rigid body with two invariants, against figures of another program.
//!
//! The equations are no Hamiltonian system in (q, p), so there is no energy to annotate. The traits are implemented by hand, for a flow in three
//! coordinates. f = c ∇I₁ × ∇I₂ with both gradients replaced by discrete ones keeps both invariants. The invariants are quadratic, so this step is
//! the implicit midpoint rule.
//!
//! Two rows of the table of that program are left out. Both are explicit splittings of the field, into planes or along the three terms of the energy.
//! Splittings here are splittings of T(p) + V(q).

use geoint_runtime::method::implicit::ImplicitMethod;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{
    Collocation, DiscreteField, EquationOrder, FieldStages, GaussTableau, Keeping, QuadraticField, Span, TreeStep,
};
use geoint_runtime::space::Square;
use geoint_runtime::{Method, VectorField};
use geoint_tests::measure::distance;

const INERTIA: [f64; 3] = [1.0, 2.0, 3.0];
const START: [f64; 3] = [0.5, 0.8, -0.4];
/// Angular velocities at t = 10.
const END: [f64; 3] = [-0.85561253, 0.39740055, -0.5662958];

#[derive(Clone, Copy, Debug)]
struct RigidBody;

/// Returns the rates of the angular velocities.
fn field(w: &[f64; 3]) -> [f64; 3] {
    let [a, b, c] = INERTIA;
    [(b - c) / a * w[1] * w[2], (c - a) / b * w[2] * w[0], (a - b) / c * w[0] * w[1]]
}

fn derivative(w: &[f64; 3]) -> [[f64; 3]; 3] {
    let [a, b, c] = INERTIA;
    let [x, y, z] = [(b - c) / a, (c - a) / b, (a - b) / c];
    [[0.0, x * w[2], x * w[1]], [y * w[2], 0.0, y * w[0]], [z * w[1], z * w[0], 0.0]]
}

/// Σ Iᵏω²: k = 1 is twice the energy, k = 2 the square of angular momentum.
fn invariant(w: &[f64; 3], k: i32) -> f64 {
    (0..3).map(|i| INERTIA[i].powi(k) * w[i] * w[i]).sum()
}

impl PhaseSpace for RigidBody {
    type State = FlowState<[f64; 3]>;
    type Phase = [f64; 3];
    type Action = ();

    fn hamiltonian(&self, _: f64, w: &[f64; 3], (): &()) -> f64 {
        0.5 * invariant(w, 1)
    }
    fn outside_domain(&self, _: f64, _: &[f64; 3], (): &()) -> Option<&'static str> {
        None
    }
}

impl VectorField for RigidBody {
    type Proof = ();
    fn rate(&self, _: f64, w: &[f64; 3], dw: &mut [f64; 3]) {
        *dw = field(w);
    }
}

/// Kahan's method requires a quadratic field.
impl QuadraticField for RigidBody {
    type Proof = ();
}

impl<const S: usize> ImplicitMethod<RigidBody> for Gauss<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Proof = ();
    type Step = FieldStages<S>;

    fn step(self) -> FieldStages<S> {
        FieldStages
    }
}

impl Collocation for RigidBody {
    type Proof = ();
    type Unknown = [f64; 3];
    type Constants = ();
    const EQUATION_ORDER: EquationOrder = EquationOrder::First;

    fn constants(&self) {}
    fn start(w: &[f64; 3]) -> ([f64; 3], [f64; 3]) {
        (*w, *w)
    }
    fn velocity(&self, _: &(), _: &[f64; 3]) -> [f64; 3] {
        [0.0; 3]
    }
    fn field(&self, _: &(), _: f64, w: &[f64; 3], f: &mut [f64; 3], jacobian: &mut Square<[f64; 3]>) {
        (*f, *jacobian) = (field(w), derivative(w));
    }
    fn add(&self, _: &(), h: f64, f: &[f64; 3], w: &mut [f64; 3]) {
        for i in 0..3 {
            w[i] += h * f[i];
        }
    }
    fn increments(change: &[f64; 3], _: &[f64; 3]) -> [f64; 3] {
        *change
    }
}

impl Keeping for RigidBody {
    type Kept = ();
}

impl ImplicitMethod<RigidBody> for DiscreteGradient {
    type Proof = ();
    type Step = TreeStep;

    fn step(self) -> TreeStep {
        TreeStep
    }
}

/// c g₁ × g₂ with the discrete gradients g of the energy and of half the square of angular momentum, 1/c = the product of all
/// moments of inertia.
impl DiscreteField for RigidBody {
    type Proof = ();
    type Parameters = ();
    type Start = [f64; 3];
    type Inverse = ();

    fn parameters(&self, _: f64) {}
    fn drift(&self, _: &(), _: &[f64; 3]) -> [f64; 3] {
        [0.0; 3]
    }
    fn begin(&self, _: &(), _: Span<f64>, w: &[f64; 3]) -> [f64; 3] {
        *w
    }
    fn slope(&self, _: &(), start: &[f64; 3], d: &[f64; 3], f: &mut [f64; 3], jacobian: &mut Square<[f64; 3]>) {
        let mean = [0, 1, 2].map(|i| start[i] + 0.5 * d[i]);
        let [momentum, energy] = [2, 1].map(|k| [0, 1, 2].map(|i| INERTIA[i].powi(k) * mean[i]));
        let c = 1.0 / INERTIA.iter().product::<f64>();
        *f = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| c * (momentum[i] * energy[j] - momentum[j] * energy[i]));
        *jacobian = derivative(&mean).map(|row| row.map(|x| 0.5 * x));
    }
}

/// Largest changes of T and |m|² in 1000 steps of 0.1, and errors at t = 10 with three step sizes.
fn figures<M: Method<RigidBody>>(method: M) -> ([f64; 2], [f64; 3]) {
    let start = FlowState::new(START);
    let values = |w: &[f64; 3]| [0.5 * invariant(w, 1), invariant(w, 2)];
    let drift = RigidBody.integrator(method, 0.1, start).sampled(1).take(1000).fold([0.0_f64; 2], |largest, state| {
        let now = values(&state.unwrap().x);
        [0, 1].map(|i| largest[i].max((now[i] - values(&START)[i]).abs()))
    });
    let error = |h: f64| distance(&RigidBody.integrator(method, h, start).until(10.0).last().unwrap().unwrap().x, &END);
    (drift, [0.1, 0.05, 0.025].map(error))
}

#[test]
fn rows_of_another_program() {
    // No more than this is rounding, relative to T and |m|²: of 200 starts the worst walks 8e-15 in 1000 steps.
    const KEPT: f64 = 1e-14;
    let sizes = [0.5 * invariant(&START, 1), invariant(&START, 2)];
    let midpoint = Some([1.02e-3, 2.54e-4, 6.36e-5]);
    let table = [
        ("DiscreteGradient", figures(DiscreteGradient), [0.0, 0.0], midpoint),
        ("ImplicitMidpoint", figures(ImplicitMidpoint), [0.0, 0.0], midpoint),
        ("Kahan", figures(Kahan), [5.4e-4, 2.3e-3], Some([6.40e-4, 1.60e-4, 4.00e-5])),
        ("RK4", figures(RK4), [3.1e-7, 1.2e-6], None),
    ];
    for (name, (drift, errors), lost, expected) in table {
        println!("{name:20} {drift:?} {errors:?}");
        for ((drift, lost), size) in drift.into_iter().zip(lost).zip(sizes) {
            assert!(
                if lost == 0.0 { drift <= KEPT * size } else { (drift / lost - 1.0).abs() < 0.05 },
                "{name}: {drift:.2e}"
            );
        }
        let Some(expected) = expected else { continue };
        for (error, expected) in errors.iter().zip(expected) {
            assert!((error / expected - 1.0).abs() < 0.05, "{name}: {errors:?}, expected {expected:.3e}");
        }
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((order - 2.0).abs() < 0.05, "{name}: order {order:.3}");
        }
    }
}
