//! An expansion without its implementations of these traits:
//!
//! - Conservative
//! - Autonomous
//! - DifferentialEquation
//! - CotangentSpace
//! - KeepsEnergy
//! - OfVelocities
//! - QuadraticKinetic
//! - ForceGradient
//! - PerturbedSystem
//! - PerturbedGradient
//! - ModifiedEnergy
//! - Keeping
//! - ImplicitMethod
//! - KeptMomenta
//! - FourthOrderField
//! - ImplicitMethod
//! - Collocation
//! - Jets

/// Planar pendulum.
pub fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}
#[allow(clippy::derive_partial_eq_without_eq, reason = "generated code")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
/// Planar pendulum.
/**
# What was derived

```text
H = p²/(2·(m·l²)) - m·l·g·cos(q)
∂H/∂q = m·l·g·sin(q)
∂H/∂p = p/(m·l²)
L = m·l·g·cos(q) + m·l²·v²/2, with v = ∂H/∂p

Structure
- H = T(p) + V(q): kick and drift are exact flows
- T = p²/(2·(m·l²))
- V = -m·l·g·cos(q)
- T is quadratic in p with a constant mass matrix
- H is not a polynomial in q and p
- H does not depend on time

Conserved by the flow, at least
- the energy

Discrete gradients
- `DiscreteGradient` and `FourthOrder(DiscreteGradient)` keep all of that, to rounding
- `MeanValue` has a closed form: it is `DiscreteGradient`

Operations (a sine with its cosine counts as two)
- gradient of H: sums and products 5, divisions and roots 1, functions 1
- kick: sums and products 2, functions 1
- drift: sums and products 2
- stage of a Newton iteration of collocation: sums and products 2, functions 2
- Newton iteration of the discrete gradient: sums and products 11, functions 4

Implicit steps
- `DiscreteGradient`, unknowns 1: Newton's iteration for one number

Skipped
- Newton's iteration in explicit methods: T and V have exact flows
- half of the unknowns of implicit methods: T is quadratic
- the clock: H does not depend on time
- recomputing what depends on parameters and the step size: prepared once
```*/
pub struct Pendulum<R = f64> {
    ///The parameter `m` of the energy.
    pub m: R,
    ///The parameter `l` of the energy.
    pub l: R,
    ///The parameter `g` of the energy.
    pub g: R,
}
#[allow(
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    clippy::restriction,
    private_bounds,
    unused_imports,
    unused_mut,
    unused_variables,
    reason = "generated code"
)]
const _: () = {
    use ::geoint_runtime::private::{
        ContactLeapfrog, DampedRattle, ExplicitLeapfrog, PieceComposition, SteppedAs,
        MultiplierStep, CanonicalStages, ContactEquation, ContactFieldStages,
        ContactGaussCollocation, ContactStep, FieldStages, GaussCollocation,
        GaussTableau, ImplicitMethod, Keeping, PolarisedStep, TreeStep, VelocityStages,
        Adaptive, Array, Autonomous, CanonicalForm, BodyState, Collocation,
        ConformalContact, Conservative, ConstrainedStep, ConstrainedSystem,
        ContactDiscreteGradient, ContactMidpoint, FlowPiece, FlowPieces, PieceSplitting,
        Placed, PlanarDiscreteGradient, PlanarItohAbe, PlanarSplitting, PolarisedForm,
        PoissonSplitting, ContactSplitting, VelocityStage, ContactStages, MassForm,
        MixedDerivatives, contact_gradient_of, ContactState, ContactSystem, Coordinates,
        CotangentSpace, QuadraticField, DifferentialEquation, DiscreteField,
        EquationOrder, DiscreteGradient, FirstIntegrals, SteadyIntegrals, FlowState,
        ForceGradient, FourthOrderField, Gradients, Hamiltonian, CanonicalEnergy,
        EnergyAndMomenta, KeptMomenta, Integral, KeptIntegrals, Integrator, KeepsEnergy,
        Inverted, Jets, LagrangianSystem, Mean, MechanicalContact, Method,
        ModifiedEnergy, NystromPieces, PerCoordinate, PerturbedGradient, PerturbedSystem,
        PhaseSpace, PieceClock, PrincipalAxes, Given, QuadraticKinetic, Rattle, Real,
        TaylorIntegrator, TaylorMethod, Separable, Snapshot, Span, Square, State,
        VelocityEnergy, StepError, Unmet, VelocityForm, canonical_rate, energy_of,
        from_positions, fourth_order, is_positive_semidefinite, modified_verlet,
        gradient_kick, planar_step, rate_of, recurrence, lagrangian_of,
        constrained_lagrangian_of, slope, state_on_constraint, unmet, velocity_of,
    };
    const _: fn() = || {
        let _ = pendulum;
    };
    impl Pendulum {
        /// What was derived from the energy: derivatives or pieces, structure, what is conserved, operations, and what is
        /// skipped and why.
        pub const REPORT: &'static str = "H = p²/(2·(m·l²)) - m·l·g·cos(q)\n∂H/∂q = m·l·g·sin(q)\n∂H/∂p = p/(m·l²)\nL = m·l·g·cos(q) + m·l²·v²/2, with v = ∂H/∂p\n\nStructure\n- H = T(p) + V(q): kick and drift are exact flows\n- T = p²/(2·(m·l²))\n- V = -m·l·g·cos(q)\n- T is quadratic in p with a constant mass matrix\n- H is not a polynomial in q and p\n- H does not depend on time\n\nConserved by the flow, at least\n- the energy\n\nDiscrete gradients\n- `DiscreteGradient` and `FourthOrder(DiscreteGradient)` keep all of that, to rounding\n- `MeanValue` has a closed form: it is `DiscreteGradient`\n\nOperations (a sine with its cosine counts as two)\n- gradient of H: sums and products 5, divisions and roots 1, functions 1\n- kick: sums and products 2, functions 1\n- drift: sums and products 2\n- stage of a Newton iteration of collocation: sums and products 2, functions 2\n- Newton iteration of the discrete gradient: sums and products 11, functions 4\n\nImplicit steps\n- `DiscreteGradient`, unknowns 1: Newton's iteration for one number\n\nSkipped\n- Newton's iteration in explicit methods: T and V have exact flows\n- half of the unknowns of implicit methods: T is quadratic\n- the clock: H does not depend on time\n- recomputing what depends on parameters and the step size: prepared once\n";
        /// The energy of a state.
        pub fn energy(&self, state: &State<f64>) -> f64 {
            PhaseSpace::energy(self, state)
        }
        /// Returns an `Integrator` of this system under a method, with step size `h` (negative to go back in time), from `state` on.
        ///
        /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
        pub fn integrator<M: Method<Self, f64, Proof = P>, P>(
            self,
            method: M,
            h: f64,
            state: State<f64>,
        ) -> Given<P, Integrator<Self, M, f64>> {
            Integrator::new(self, method, h, state)
        }
        /// Returns an `Adaptive` run of this system under a method, with steps as long as the tolerance of a step's error allows, from
        /// `state` on.
        ///
        /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
        pub fn adaptive<M: Method<Self, f64, Proof = P>, P>(
            self,
            method: M,
            tolerance: f64,
            state: State<f64>,
        ) -> Given<P, Adaptive<Self, M, f64>> {
            Adaptive::new(self, method, tolerance, state)
        }
    }
    impl<R: Real> PhaseSpace<R> for Pendulum<R> {
        type State = State<R>;
        type Phase = [[R; 1]; 2];
        type Action = ();
        #[inline]
        fn hamiltonian(&self, t: R, z: &[[R; 1]; 2], _: &()) -> R {
            let [q, p] = z;
            let (p0, a1, a0, k3, q0, a2, v0, v1, v2, v3, v4, v5, v6, v7, v8, v9);
            p0 = p[0];
            a1 = self.l;
            a0 = self.m;
            k3 = R::from_f64(0.5);
            q0 = q[0];
            a2 = self.g;
            v0 = p0 * p0;
            v1 = a1 * a1;
            v2 = a0 * v1;
            v3 = k3 * v0;
            v4 = v3 / v2;
            v5 = q0.cos();
            v6 = a1 * a0;
            v7 = v6 * a2;
            v8 = -v7;
            v9 = v8.multiply_add(v5, v4);
            v9
        }
        fn outside_domain(
            &self,
            t: R,
            z: &[[R; 1]; 2],
            s: &(),
        ) -> ::core::option::Option<&'static str> {
            let [q, p] = z;
            let (a1, a0, v0, v1);
            a1 = self.l;
            a0 = self.m;
            v0 = a1 * a1;
            v1 = a0 * v0;
            if v1.abs().any_not_positive() {
                return ::core::option::Option::Some("division by zero: m·l²");
            }
            ::core::option::Option::None
        }
        fn invalid_parameter(&self) -> ::core::option::Option<&'static str> {
            if self.m != self.m {
                return ::core::option::Option::Some("m");
            }
            if self.l != self.l {
                return ::core::option::Option::Some("l");
            }
            if self.g != self.g {
                return ::core::option::Option::Some("g");
            }
            ::core::option::Option::None
        }
    }
    impl<R: Real> Hamiltonian<R> for Pendulum<R> {
        type Proof = ();
        #[inline]
        fn gradient(&self, t: R, z: &[[R; 1]; 2], slopes: &mut [[R; 1]; 2]) {
            let [q, p] = z;
            let (q0, a1, a0, a2, p0, v0, v1, v2, v3, v4, v5, v6);
            q0 = q[0];
            a1 = self.l;
            a0 = self.m;
            a2 = self.g;
            p0 = p[0];
            v0 = q0.sin();
            v1 = a1 * a0;
            v2 = v1 * a2;
            v3 = v2 * v0;
            v4 = a1 * a1;
            v5 = a0 * v4;
            v6 = p0 / v5;
            slopes[0][0] = v3;
            slopes[1][0] = v6;
        }
    }
    impl Pendulum {
        /// The Lagrangian p·∂H/∂p − H of a state.
        pub fn lagrangian(&self, state: &State<f64>) -> f64 {
            lagrangian_of(self, state)
        }
    }
    trait OfVelocities<R: Real> {
        fn momentum(&self, t: R, q: &[R; 1], v: &[R; 1]) -> [R; 1];
    }
    impl Pendulum {
        /// The state with these positions and velocities, at t = 0.
        pub fn at(&self, q: f64, v: f64) -> State<f64> {
            self.at_time(0.0, q, v)
        }
        /// The state with these positions and velocities at a time.
        pub fn at_time(&self, t: f64, q: f64, v: f64) -> State<f64> {
            let [position, velocity] = [q, v].map(Coordinates::into_array);
            State::at(
                t,
                q,
                Coordinates::from_array(
                    OfVelocities::momentum(self, t, &position, &velocity),
                ),
            )
        }
    }
    impl<R: Real> Separable<R> for Pendulum<R> {
        type Proof = ();
        const KICK: ::geoint_runtime::private::FlowKind = ::geoint_runtime::private::FlowKind::ADDS
            .without_time()
            .showing_domain();
        const DRIFT: ::geoint_runtime::private::FlowKind = ::geoint_runtime::private::FlowKind::ADDS;
        type Kick = [R; 1];
        type Drift = [R; 1];
        #[inline]
        fn prepare_kick(&self, h: R) -> [R; 1] {
            let (a2, a0, a1, v0, v1, v2, v3);
            a2 = self.g;
            a0 = self.m;
            a1 = self.l;
            v0 = h * a2;
            v1 = v0 * a0;
            v2 = v1 * a1;
            v3 = -v2;
            [v3]
        }
        #[inline]
        fn prepare_drift(&self, h: R) -> [R; 1] {
            let (a1, a0, v0, v1, v2);
            a1 = self.l;
            a0 = self.m;
            v0 = a1 * a1;
            v1 = a0 * v0;
            v2 = h / v1;
            [v2]
        }
        #[inline(always)]
        fn kick(
            &self,
            prepared: &[R; 1],
            t: R,
            q: &mut [R; 1],
            p: &mut [R; 1],
            _: &mut (),
        ) {
            let (q0, prepared_0, p0, v0, v1);
            q0 = q[0];
            prepared_0 = prepared[0];
            p0 = p[0];
            v0 = q0.sin();
            v1 = prepared_0.multiply_add(v0, p0);
            p[0] = v1;
        }
        #[inline(always)]
        fn drift(
            &self,
            prepared: &[R; 1],
            t: R,
            q: &mut [R; 1],
            p: &mut [R; 1],
            _: &mut (),
        ) {
            let (prepared_0, p0, q0, v0);
            prepared_0 = prepared[0];
            p0 = p[0];
            q0 = q[0];
            v0 = prepared_0.multiply_add(p0, q0);
            q[0] = v0;
        }
    }
    #[diagnostic::on_unimplemented(
        message = "`Pendulum`: no part of this energy has an exact flow beside a rest that is a kick; for bodies that attract each other `coordinates = jacobi` makes one, and `split = \"A | B\"` names one",
        label = "the term is: -m·l·g·cos(q)"
    )]
    pub trait PartedPendulum {
        type Proof;
    }
    impl Pendulum {
        /// H + h²H₂, which steps of length `h` keep, or let decay as the flow of H + h²H₂ does, up to h⁴.
        pub fn modified_energy(&self, h: f64, state: &State<f64>) -> f64 {
            ModifiedEnergy::modified_energy(self, h, state)
        }
    }
    impl<R: Real> DiscreteField<R> for Pendulum<R> {
        type Proof = ();
        type Parameters = [R; 4];
        type Start = [R; 1];
        type Inverse = ();
        const MEAN: Mean = Mean::Parts(1);
        #[inline]
        fn parameters(&self, h: R) -> [R; 4] {
            let (
                a1,
                a0,
                a2,
                k3,
                k4,
                k5,
                v0,
                v1,
                v2,
                v3,
                v4,
                v5,
                v6,
                v7,
                v8,
                v9,
                v10,
                v11,
                v12,
                v13,
            );
            a1 = self.l;
            a0 = self.m;
            a2 = self.g;
            k3 = R::from_f64(1.0);
            k4 = R::from_f64(0.25);
            k5 = R::from_f64(0.5);
            v0 = a1 * a0;
            v1 = v0 * a2;
            v2 = -v1;
            v3 = h * v1;
            v4 = -v3;
            v5 = a1 * a1;
            v6 = a0 * v5;
            v7 = k3 / v6;
            v8 = h * h;
            v9 = k4 * v8;
            v10 = v9 * v1;
            v11 = v10 * v7;
            v12 = k5 * h;
            v13 = v12 * v7;
            [v2, v4, v11, v13]
        }
        #[inline(always)]
        fn begin(
            &self,
            prepared: &[R; 4],
            Span { start, middle: t, end }: Span<R>,
            y: &[R; 1],
        ) -> [R; 1] {
            let (q0,);
            q0 = y[0];
            [q0]
        }
        #[inline(always)]
        fn slope(
            &self,
            prepared: &[R; 4],
            start: &[R; 1],
            d: &[R; 1],
            f: &mut [R; 1],
            jacobian: &mut Square<[R; 1]>,
        ) {
            let (
                k0,
                dq0,
                start_0,
                prepared_0,
                v0,
                v1,
                v2,
                v3,
                v4,
                v5,
                v6,
                v7,
                v8,
                v9,
                v10,
                v11,
                v12,
            );
            k0 = R::from_f64(0.5);
            dq0 = d[0];
            start_0 = start[0];
            prepared_0 = prepared[0];
            v0 = k0 * dq0;
            v1 = slope::sinc(v0);
            v2 = slope::sinc_derivative(v0);
            v3 = k0.multiply_add(dq0, start_0);
            (v4, v5) = v3.sin_cos();
            v6 = prepared_0 * v1;
            v7 = v6 * v4;
            v8 = k0 * v4;
            v9 = k0 * v1;
            v10 = v8 * v2;
            v11 = v9.multiply_add(v5, v10);
            v12 = prepared_0 * v11;
            f[0] = v7;
            jacobian[0][0] = v12;
        }
        #[inline(always)]
        fn equation(
            &self,
            _: (&Self::Constants, R),
            prepared: &[R; 4],
            start: &[R; 1],
            d: &[R; 1],
            image: &mut [R; 1],
            matrix: &mut Square<[R; 1]>,
        ) {
            let (
                k0,
                dq0,
                start_0,
                prepared_1,
                prepared_2,
                k5,
                v0,
                v1,
                v2,
                v3,
                v4,
                v5,
                v6,
                v7,
                v8,
                v9,
                v10,
            );
            k0 = R::from_f64(0.5);
            dq0 = d[0];
            start_0 = start[0];
            prepared_1 = prepared[1];
            prepared_2 = prepared[2];
            k5 = R::from_f64(1.0);
            v0 = k0 * dq0;
            v1 = slope::sinc(v0);
            v2 = slope::sinc_derivative(v0);
            v3 = k0.multiply_add(dq0, start_0);
            (v4, v5) = v3.sin_cos();
            v6 = prepared_1 * v1;
            v7 = v6 * v4;
            v8 = v4 * v2;
            v9 = v1.multiply_add(v5, v8);
            v10 = prepared_2.multiply_add(v9, k5);
            image[0] = v7;
            matrix[0][0] = v10;
        }
        #[inline(always)]
        fn drift(&self, prepared: &[R; 4], sum: &[R; 1]) -> [R; 1] {
            let mut drift = <[R; 1] as Array>::zero();
            let (prepared_3, dp0, v0);
            prepared_3 = prepared[3];
            dp0 = sum[0];
            v0 = prepared_3 * dp0;
            drift[0] = v0;
            drift
        }
    }
    impl Pendulum {
        /// This system by Taylor series of its solution, from `state` on.
        ///
        /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
        pub fn taylor<M: TaylorMethod<Self, f64>>(
            self,
            method: M,
            state: State<f64>,
        ) -> TaylorIntegrator<Self, M, f64> {
            TaylorIntegrator::new(self, method, state)
        }
    }
};
