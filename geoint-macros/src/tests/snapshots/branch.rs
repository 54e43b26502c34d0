fn half_spring(q: f64, p: f64, t: f64) -> f64 {
    (1.0 + p * p).sqrt() + if q > 0.0 { q.powi(4) * t.cos() } else { 0.0 }
}
#[allow(clippy::derive_partial_eq_without_eq, reason = "generated code")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
/**
# What was derived

```text
H = √(p² + 1) + (if 0 < q { q⁴·cos(t) } else { 0 })
∂H/∂q = if 0 < q { 4·q³·cos(t) } else { 0 }
∂H/∂p = p/√(p² + 1)

Structure
- H = T(p) + V(q): kick and drift are exact flows
- T = √(p² + 1)
- V = if 0 < q { q⁴·cos(t) } else { 0 }
- T is not quadratic in p: √(p² + 1)
- H is not a polynomial in q and p
- H depends on time

Conserved by the flow, at least
- nothing that was found

Discrete gradients
- across an `if` that is on different sides at both ends of a step they take the secant of the whole `if`
- `MeanValue` has a closed form: it is `DiscreteGradient`

Operations (a sine with its cosine counts as two)
- gradient of H: sums and products 6, divisions and roots 2, functions 1
- kick: sums and products 6, functions 1
- drift: sums and products 4, divisions and roots 2
- stage of a Newton iteration of collocation: sums and products 16, divisions and roots 2, functions 1
- Newton iteration of the discrete gradient: sums and products 39, divisions and roots 4

Implicit steps
- `DiscreteGradient`, unknowns 2: Newton's iteration with elimination

Skipped
- Newton's iteration in explicit methods: T and V have exact flows
- recomputing what depends on parameters and the step size: prepared once
- Runge–Kutta–Nyström tables: they need a quadratic T
```*/
struct Spring;
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
        Adaptive, Array, Autonomous, ByCanonical, ByConstraint, ByField, CanonicalForm,
        ByPolarisation, ByTree, ByVelocities, Collocated, BodyState, Collocation,
        ConformalContact, Conservative, ConstrainedStep, ConstrainedSystem,
        ContactDiscreteGradient, ContactMidpoint, FlowPiece, FlowPieces, PieceSplitting,
        Placed, PlanarDiscreteGradient, PlanarItohAbe, PlanarSplitting, PolarisedForm,
        PoissonSplitting, ContactSplitting, ContactCollocated, ContactGraded,
        ContactPolarised, ContactStage, ContactStages, ContactVelocities, MassForm,
        contact_gradient_of, ContactState, ContactSystem, Coordinates, CotangentSpace,
        QuadraticField, DifferentialEquation, DiscreteField, DiscreteGradient,
        FirstIntegrals, SteadyIntegrals, FlowState, ForceGradient, FourthOrderField,
        Graded, Gradients, Hamiltonian, ImplicitStep, CanonicalEnergy, EnergyAndMomenta,
        KeptMomenta, Integral, KeptIntegrals, Integrator, KeepsEnergy, Inverted, Jets,
        LagrangianSystem, Mean, MechanicalContact, Method, ModifiedEnergy, NystromPieces,
        PerCoordinate, PerturbedGradient, PerturbedSystem, PhaseSpace, PieceClock,
        PrincipalAxes, ProofAnd, QuadraticKinetic, Rattle, Real, TaylorIntegrator,
        TaylorMethod, Separable, Snapshot, Span, Square, State, VelocityEnergy,
        StepError, Unmet, VelocityForm, canonical_rate, energy_of, from_positions,
        fourth_order, is_positive_semidefinite, modified_verlet, gradient_kick,
        planar_step, rate_of, recurrence, slope, state_on_constraint, unmet, velocity_of,
    };
    const _: fn() = || {
        let _ = half_spring;
    };
    impl Spring {
        /// What was derived from the energy: derivatives or pieces, structure, what is conserved, operations, and what is
        /// skipped and why.
        pub const REPORT: &'static str = "H = √(p² + 1) + (if 0 < q { q⁴·cos(t) } else { 0 })\n∂H/∂q = if 0 < q { 4·q³·cos(t) } else { 0 }\n∂H/∂p = p/√(p² + 1)\n\nStructure\n- H = T(p) + V(q): kick and drift are exact flows\n- T = √(p² + 1)\n- V = if 0 < q { q⁴·cos(t) } else { 0 }\n- T is not quadratic in p: √(p² + 1)\n- H is not a polynomial in q and p\n- H depends on time\n\nConserved by the flow, at least\n- nothing that was found\n\nDiscrete gradients\n- across an `if` that is on different sides at both ends of a step they take the secant of the whole `if`\n- `MeanValue` has a closed form: it is `DiscreteGradient`\n\nOperations (a sine with its cosine counts as two)\n- gradient of H: sums and products 6, divisions and roots 2, functions 1\n- kick: sums and products 6, functions 1\n- drift: sums and products 4, divisions and roots 2\n- stage of a Newton iteration of collocation: sums and products 16, divisions and roots 2, functions 1\n- Newton iteration of the discrete gradient: sums and products 39, divisions and roots 4\n\nImplicit steps\n- `DiscreteGradient`, unknowns 2: Newton's iteration with elimination\n\nSkipped\n- Newton's iteration in explicit methods: T and V have exact flows\n- recomputing what depends on parameters and the step size: prepared once\n- Runge–Kutta–Nyström tables: they need a quadratic T\n";
        /// The energy of a state.
        pub fn energy(&self, state: &State<f64>) -> f64 {
            PhaseSpace::energy(self, state)
        }
        /// This system under a method, with step size `h` (negative to go back in time), from `state` on.
        ///
        /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
        pub fn integrator<M: Method<Self, f64, Proof = P>, P>(
            self,
            method: M,
            h: f64,
            state: State<f64>,
        ) -> <P as ProofAnd<Integrator<Self, M, f64>>>::Both {
            Integrator::new(self, method, h, state)
        }
        /// This system under a method with steps as long as the tolerance of a step's error allows, from `state` on.
        ///
        /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
        pub fn adaptive<M: Method<Self, f64, Proof = P>, P>(
            self,
            method: M,
            tolerance: f64,
            state: State<f64>,
        ) -> <P as ProofAnd<Adaptive<Self, M, f64>>>::Both {
            Adaptive::new(self, method, tolerance, state)
        }
    }
    impl<R: Real> Conservative<R> for Spring {
        type Proof = ();
    }
    impl<R: Real> PhaseSpace<R> for Spring {
        type State = State<R>;
        type Phase = [[R; 1]; 2];
        type Action = ();
        #[inline]
        fn hamiltonian(&self, t: R, z: &[[R; 1]; 2], _: &()) -> R {
            let [q, p] = z;
            let (p0, k1, k2, q0, v0, v1, v2, v3, v8, v9);
            p0 = p[0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(0.0);
            q0 = q[0];
            v0 = p0 * p0;
            v1 = k1 + v0;
            v2 = v1.sqrt();
            v3 = k2.less(q0);
            [v8] = R::choose(
                v3,
                || {
                    let (v4, v5, v6, v7);
                    v4 = q0 * q0;
                    v5 = v4 * v4;
                    v6 = t.cos();
                    v7 = v5 * v6;
                    [v7]
                },
                || { [k2] },
            );
            v9 = v2 + v8;
            v9
        }
        fn outside_domain(
            &self,
            t: R,
            z: &[[R; 1]; 2],
            s: &(),
        ) -> ::core::option::Option<&'static str> {
            let [q, p] = z;
            ::core::option::Option::None
        }
        fn edge(
            &self,
            t: R,
            z: &[[R; 1]; 2],
            s: &(),
        ) -> ::core::option::Option<&'static str> {
            let [q, p] = z;
            let (p0, k1, v0, v1);
            p0 = p[0];
            k1 = R::from_f64(1.0);
            v0 = p0 * p0;
            v1 = k1 + v0;
            if v1.any_not_positive() {
                return ::core::option::Option::Some(
                    "a derivative that is not a number: √(p² + 1)",
                );
            }
            ::core::option::Option::None
        }
        const POWERS: bool = true;
        fn powers(
            &self,
            t: R,
            z: &[[R; 1]; 2],
            s: &(),
            mut visit: impl ::core::ops::FnMut(&'static str, R),
        ) {
            let [q, p] = z;
            let (p0, k1, v0, v1);
            p0 = p[0];
            k1 = R::from_f64(1.0);
            v0 = p0 * p0;
            v1 = k1 + v0;
            visit("a power has no Taylor series where it vanishes: √(p² + 1)", v1);
        }
        const JUMPS: &'static [&'static str] = &[
            "the energy jumps where a condition changes, by q⁴·cos(t): shift one side so that both meet, or take a method that keeps the energy, such as `DiscreteGradient`",
        ];
        #[inline]
        fn same_sides(&self, t: R, z: [&[[R; 1]; 2]; 2], s: [&(); 2]) -> bool {
            let sides = |z: &[[R; 1]; 2], s: &()| -> [R; 1] {
                let [q, p] = z;
                let (k0, q0, k2, k3, v0, v1);
                k0 = R::from_f64(0.0);
                q0 = q[0];
                k2 = R::from_f64(1.0);
                k3 = R::from_f64(-1.0);
                v0 = k0.less(q0);
                [v1] = R::choose(v0, || { [k2] }, || { [k3] });
                [v1]
            };
            sides(z[0], s[0]) == sides(z[1], s[1])
        }
        fn jump<Scalar: Real>(
            &self,
            index: usize,
            lift: impl Fn(R) -> Scalar,
            t: Scalar,
            z: &[Scalar],
            s: Scalar,
        ) -> [Scalar; 2] {
            fn values<R: Real>(
                index: usize,
                parameters: &[R],
                t: R,
                z: &[R],
                s: R,
            ) -> [R; 2] {
                match index {
                    _ => {
                        let (k0, q0, k2, k3, v0, v1, v2, v3, v4, v5, v6);
                        k0 = R::from_f64(0.0);
                        q0 = z[0];
                        k2 = R::from_f64(1.0);
                        k3 = R::from_f64(-1.0);
                        v0 = k0.less(q0);
                        [v1] = R::choose(v0, || { [k2] }, || { [k3] });
                        v2 = t.cos();
                        v3 = q0.abs();
                        v4 = v3 * v3;
                        v5 = v4 * v4;
                        v6 = v2 * v5;
                        [v1, v6]
                    }
                }
            }
            values(index, &[], t, z, s)
        }
    }
    impl<R: Real> DifferentialEquation<R> for Spring {
        type Proof = ();
        #[inline(always)]
        fn rate(&self, t: R, z: &[[R; 1]; 2], slopes: &mut [[R; 1]; 2]) {
            let [q, p] = z;
            canonical_rate(self, t, z, slopes);
        }
    }
    impl<R: Real> CotangentSpace<R> for Spring {
        type Coordinates = R;
        type Array = [R; 1];
    }
    impl<R: Real> Hamiltonian<R> for Spring {
        type Proof = ();
        #[inline]
        fn gradient(&self, t: R, z: &[[R; 1]; 2], slopes: &mut [[R; 1]; 2]) {
            let [q, p] = z;
            let (k0, q0, k2, p0, k4, v0, v6, v7, v8, v9, v10);
            k0 = R::from_f64(0.0);
            q0 = q[0];
            k2 = R::from_f64(4.0);
            p0 = p[0];
            k4 = R::from_f64(1.0);
            v0 = k0.less(q0);
            [v6] = R::choose(
                v0,
                || {
                    let (v1, v2, v3, v4, v5);
                    v1 = t.cos();
                    v2 = q0 * q0;
                    v3 = v2 * q0;
                    v4 = k2 * v3;
                    v5 = v4 * v1;
                    [v5]
                },
                || { [k0] },
            );
            v7 = p0 * p0;
            v8 = k4 + v7;
            v9 = v8.sqrt();
            v10 = p0 / v9;
            slopes[0][0] = v6;
            slopes[1][0] = v10;
        }
    }
    impl<R: Real> Separable<R> for Spring {
        type Proof = ();
        const KICKS_REPEAT: bool = false;
        type Kick = [R; 1];
        type Drift = [R; 1];
        #[inline]
        fn prepare_kick(&self, h: R) -> [R; 1] {
            let (v0,);
            v0 = -h;
            [v0]
        }
        #[inline]
        fn prepare_drift(&self, h: R) -> [R; 1] {
            [h]
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
            let (k0, q0, k2, prepared_0, p0, v0, v6, v7);
            k0 = R::from_f64(0.0);
            q0 = q[0];
            k2 = R::from_f64(4.0);
            prepared_0 = prepared[0];
            p0 = p[0];
            v0 = k0.less(q0);
            [v6] = R::choose(
                v0,
                || {
                    let (v1, v2, v3, v4, v5);
                    v1 = t.cos();
                    v2 = q0 * q0;
                    v3 = v2 * q0;
                    v4 = k2 * v3;
                    v5 = v4 * v1;
                    [v5]
                },
                || { [k0] },
            );
            v7 = prepared_0.multiply_add(v6, p0);
            p[0] = v7;
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
            let (p0, k1, prepared_0, q0, v0, v1, v2, v3, v4, v5);
            p0 = p[0];
            k1 = R::from_f64(1.0);
            prepared_0 = prepared[0];
            q0 = q[0];
            v0 = p0 * p0;
            v1 = k1 + v0;
            v2 = v1.sqrt();
            v3 = prepared_0 * p0;
            v4 = v3 / v2;
            v5 = q0 + v4;
            q[0] = v5;
        }
    }
    #[diagnostic::on_unimplemented(
        message = "`Spring`: this term is not quadratic in the momenta with constant coefficients, so Runge–Kutta–Nyström tables, and those with force gradients, would lose their order; use a table for every separable energy, such as `BlanesMoan6`",
        label = "the term is: √(p² + 1)"
    )]
    pub trait QuadraticInSpring {
        type Proof;
    }
    impl<R: Real + QuadraticInSpring> QuadraticKinetic<R> for Spring {
        type Proof = <R as QuadraticInSpring>::Proof;
    }
    impl<R: Real + QuadraticInSpring> ForceGradient<R> for Spring {
        type GradientKick = ::core::convert::Infallible;
        fn prepare_gradient_kick(&self, _: R, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn gradient_kick(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 1],
            _: &mut [R; 1],
            _: &mut (),
        ) {
            match *never {}
        }
    }
    #[diagnostic::on_unimplemented(
        message = "`Spring`: no part of this energy has an exact flow beside a rest that is a kick; for bodies that attract each other `coordinates = jacobi` makes one, and `split = \"A | B\"` names one",
        label = "the term is: if 0 < q | q⁴·cos(t) | else | 0 |"
    )]
    pub trait PartedSpring {
        type Proof;
    }
    impl<R: Real + PartedSpring> PerturbedSystem<R> for Spring {
        type Proof = <R as PartedSpring>::Proof;
        type Exact = ::core::convert::Infallible;
        type After = ();
        type Rest = ::core::convert::Infallible;
        fn prepare_after(&self, _: R) {}
        fn prepare_exact(&self, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn exact(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 1],
            _: &mut [R; 1],
            _: &mut (),
        ) {
            match *never {}
        }
        fn prepare_rest(&self, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn rest(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 1],
            _: &mut [R; 1],
            _: &mut (),
        ) {
            match *never {}
        }
    }
    impl<R: Real + PartedSpring> PerturbedGradient<R> for Spring {
        type Proof = <R as PartedSpring>::Proof;
        type GradientKick = ::core::convert::Infallible;
        fn prepare_gradient_kick(&self, _: R, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn gradient_kick(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 1],
            _: &mut [R; 1],
        ) {
            match *never {}
        }
    }
    impl<R: Real> ModifiedEnergy<R> for Spring {
        fn modified_hamiltonian(
            &self,
            h: R,
            t: R,
            z: &[[R; 1]; 2],
            s: &Self::Action,
        ) -> R {
            let [q, p] = z;
            let (
                p0,
                k1,
                k2,
                q0,
                k4,
                k5,
                k6,
                k7,
                v0,
                v1,
                v2,
                v3,
                v12,
                v13,
                v23,
                v24,
                v25,
                v26,
                v27,
                v28,
                v29,
                v30,
                v31,
                v32,
                v33,
                v34,
                v35,
                v36,
                v37,
                v38,
            );
            p0 = p[0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(0.0);
            q0 = q[0];
            k4 = R::from_f64(4.0);
            k5 = R::from_f64(3.0);
            k6 = R::from_f64(0.041666666666666664);
            k7 = R::from_f64(0.08333333333333333);
            v0 = p0 * p0;
            v1 = k1 + v0;
            v2 = v1.sqrt();
            v3 = k2.less(q0);
            v12 = k1 / v2;
            v13 = p0 * v12;
            [v23, v24, v25, v26] = R::choose(
                v3,
                || {
                    let (
                        v4,
                        v5,
                        v6,
                        v7,
                        v8,
                        v9,
                        v10,
                        v11,
                        v14,
                        v15,
                        v16,
                        v17,
                        v18,
                        v19,
                        v20,
                        v21,
                        v22,
                    );
                    v4 = q0 * q0;
                    v5 = v4 * v4;
                    (v6, v7) = t.sin_cos();
                    v8 = v5 * v7;
                    v9 = v4 * q0;
                    v10 = k4 * v9;
                    v11 = v10 * v7;
                    v14 = k5 * v4;
                    v15 = v14 * v7;
                    v16 = v15 * v13;
                    v17 = -v9;
                    v18 = v17.multiply_add(v6, v16);
                    v19 = k4 * v18;
                    v20 = v10 * v6;
                    v21 = v20.multiply_add(v13, v8);
                    v22 = -v21;
                    [v8, v11, v19, v22]
                },
                || { [k2, k2, k2, k2] },
            );
            v27 = v13.multiply_add(v25, v26);
            v28 = v12 * v12;
            v29 = v28 * v12;
            v30 = v0 * v29;
            v31 = v30 - v12;
            v32 = v24 * v31;
            v33 = k6 * v24;
            v34 = k7 * v27;
            v35 = v33.multiply_add(v32, v34);
            v36 = h * h;
            v37 = v2 + v23;
            v38 = v36.multiply_add(v35, v37);
            v38
        }
    }
    impl Spring {
        /// H + h²H₂, which steps of length `h` keep, or let decay as the flow of H + h²H₂ does, up to h⁴.
        pub fn modified_energy(&self, h: f64, state: &State<f64>) -> f64 {
            ModifiedEnergy::modified_energy(self, h, state)
        }
    }
    impl<R: Real> Graded<R> for Spring {
        type Proof = ();
        type Gradient = ByTree;
        type Kept = ();
    }
    impl<R: Real> DiscreteField<R> for Spring {
        type Proof = ();
        type Parameters = [R; 0];
        type Start = [R; 11];
        type Inverse = ();
        const MEAN: Mean = Mean::Parts(1);
        #[inline]
        fn parameters(&self, h: R) -> [R; 0] {
            []
        }
        #[inline(always)]
        fn begin(
            &self,
            prepared: &[R; 0],
            Span { start, middle: t, end }: Span<R>,
            y: &[[R; 1]; 2],
        ) -> [R; 11] {
            let (
                p0,
                k1,
                k2,
                q0,
                k4,
                k5,
                k6,
                v0,
                v1,
                v2,
                v3,
                v4,
                v5,
                v6,
                v7,
                v13,
                v14,
                v15,
                v16,
            );
            p0 = y[1][0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(2.0);
            q0 = y[0][0];
            k4 = R::from_f64(0.0);
            k5 = R::from_f64(4.0);
            k6 = R::from_f64(12.0);
            v0 = p0 * p0;
            v1 = k1 + v0;
            v2 = v1.sqrt();
            v3 = k2 * p0;
            v4 = t.cos();
            v5 = k2 * q0;
            v6 = q0 * q0;
            v7 = k4.less(q0);
            [v13, v14] = R::choose(
                v7,
                || {
                    let (v8, v9, v10, v11, v12);
                    v8 = v6 * q0;
                    v9 = k5 * v8;
                    v10 = v9 * v4;
                    v11 = v6 * v6;
                    v12 = v11 * v4;
                    [v10, v12]
                },
                || { [k4, k4] },
            );
            v15 = k5 * v4;
            v16 = k6 * v4;
            [v2, p0, v3, q0, v4, v5, v6, v13, v15, v16, v14]
        }
        #[inline(always)]
        fn slope(
            &self,
            prepared: &[R; 0],
            start: &[R; 11],
            d: &[[R; 1]; 2],
            f: &mut [[R; 1]; 2],
            jacobian: &mut Square<[[R; 1]; 2]>,
        ) {
            let (
                start_1,
                dp0,
                k2,
                start_0,
                start_2,
                k5,
                start_3,
                dq0,
                start_5,
                start_6,
                start_4,
                k11,
                start_8,
                start_9,
                start_7,
                k15,
                start_10,
                k17,
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
                v14,
                v15,
                v50,
                v51,
                v52,
                v53,
                v54,
                v55,
                v56,
                v57,
                v58,
            );
            start_1 = start[1];
            dp0 = d[1][0];
            k2 = R::from_f64(1.0);
            start_0 = start[0];
            start_2 = start[2];
            k5 = R::from_f64(0.0);
            start_3 = start[3];
            dq0 = d[0][0];
            start_5 = start[5];
            start_6 = start[6];
            start_4 = start[4];
            k11 = R::from_f64(2.0);
            start_8 = start[8];
            start_9 = start[9];
            start_7 = start[7];
            k15 = R::from_f64(0.5);
            start_10 = start[10];
            k17 = R::from_f64(-0.5);
            v0 = start_1 + dp0;
            v1 = v0 * v0;
            v2 = k2 + v1;
            v3 = v2.sqrt();
            v4 = start_0 + v3;
            v5 = k2 / v4;
            v6 = start_2 + dp0;
            v7 = v6 * v5;
            v8 = k5.less(start_3);
            v9 = start_3 + dq0;
            v10 = k5.less(v9);
            v11 = v8 & v10;
            v12 = !v8;
            v13 = !v10;
            v14 = v12 & v13;
            v15 = v11 | v14;
            [v50, v51] = R::choose(
                v15,
                || {
                    let (v24, v25);
                    [v24, v25] = R::choose(
                        v8,
                        || {
                            let (v16, v17, v18, v19, v20, v21, v22, v23);
                            v16 = start_5 + dq0;
                            v17 = v9 * v9;
                            v18 = start_6 + v17;
                            v19 = start_4 * v16;
                            v20 = v19 * v18;
                            v21 = k11 * v9;
                            v22 = v21.multiply_add(v16, v18);
                            v23 = start_4 * v22;
                            [v20, v23]
                        },
                        || { [k5, k5] },
                    );
                    [v24, v25]
                },
                || {
                    let (
                        v32,
                        v33,
                        v34,
                        v35,
                        v36,
                        v37,
                        v38,
                        v39,
                        v40,
                        v41,
                        v42,
                        v43,
                        v44,
                        v45,
                        v46,
                        v47,
                        v48,
                        v49,
                    );
                    [v32, v33, v34] = R::choose(
                        v10,
                        || {
                            let (v26, v27, v28, v29, v30, v31);
                            v26 = v9 * v9;
                            v27 = v26 * v9;
                            v28 = start_8 * v27;
                            v29 = v26 * v26;
                            v30 = start_4 * v29;
                            v31 = start_9 * v26;
                            [v28, v30, v31]
                        },
                        || { [k5, k5, k5] },
                    );
                    v35 = start_7 + v32;
                    v36 = k15 * dq0;
                    v37 = v33 - start_10;
                    v38 = -v36;
                    v39 = v38.multiply_add(v35, v37);
                    v40 = k2 / dq0;
                    v41 = k15 * v35;
                    v42 = v40.multiply_add(v39, v41);
                    v43 = v40 * v40;
                    v44 = dq0.multiply_add(v34, v35);
                    v45 = k17.multiply_add(v44, v32);
                    v46 = v40 * v45;
                    v47 = -v43;
                    v48 = v47.multiply_add(v39, v46);
                    v49 = k15.multiply_add(v34, v48);
                    [v42, v49]
                },
            );
            v52 = -v50;
            v53 = v5 * v5;
            v54 = v6 * v0;
            v55 = v54 * v53;
            v56 = v55 / v3;
            v57 = v5 - v56;
            v58 = -v51;
            f[0][0] = v7;
            f[1][0] = v52;
            jacobian[0][0][0][0] = k5;
            jacobian[0][0][1][0] = v57;
            jacobian[1][0][0][0] = v58;
            jacobian[1][0][1][0] = k5;
        }
        #[inline(always)]
        fn drift(&self, prepared: &[R; 0], sum: &[[R; 1]; 2]) -> [[R; 1]; 2] {
            let mut drift = <[[R; 1]; 2] as Array>::zero();
            drift
        }
    }
    impl<R: Real> KeptMomenta<R> for Spring {
        type Values = [R; 1];
        #[inline(always)]
        fn momenta(&self, z: &[[R; 1]; 2]) -> [[[R; 1]; 2]; 1] {
            let mut slopes = [<[[R; 1]; 2] as Array>::zero(); 1];
            let [q, p] = z;
            slopes
        }
    }
    impl<R: Real> FourthOrderField<R> for Spring {
        type Proof = ();
        type FourthParameters = fourth_order::ParametersOf<Self, R>;
        type FourthStart = fourth_order::Begun<[R; 1]>;
        #[inline]
        fn fourth_parameters(&self, h: R) -> Self::FourthParameters {
            fourth_order::parameters(self, h)
        }
        #[inline(always)]
        fn fourth_begin(
            &self,
            parameters: &Self::FourthParameters,
            span: Span<R>,
            z: &[[R; 1]; 2],
        ) -> Self::FourthStart {
            fourth_order::begin(self, parameters, span, z)
        }
        #[inline(always)]
        fn fourth_slope<const NEARLY: bool>(
            &self,
            parameters: &Self::FourthParameters,
            start: &Self::FourthStart,
            d: &[[R; 1]; 2],
            image: &mut [[R; 1]; 2],
            matrix: &mut Square<[[R; 1]; 2]>,
        ) {
            let momenta = |z: &[[R; 1]; 2]| self.momenta(z);
            fourth_order::slope::<
                NEARLY,
                false,
                1,
                _,
                _,
            >(self, parameters, start, momenta, d, (image, matrix));
        }
    }
    impl<R: Real> Collocated<R> for Spring {
        type Proof = ();
        type Stages = ByField;
    }
    impl<R: Real> Collocation<R> for Spring {
        type Proof = ();
        type Unknown = [[R; 1]; 2];
        type Constants = [R; 0];
        const DERIVATIVE: usize = 1;
        #[inline]
        fn constants(&self) -> [R; 0] {
            []
        }
        #[inline(always)]
        fn start(z: &[[R; 1]; 2]) -> ([[R; 1]; 2], [[R; 1]; 2]) {
            (*z, *z)
        }
        #[inline(always)]
        fn velocity(&self, prepared: &[R; 0], p: &[[R; 1]; 2]) -> [[R; 1]; 2] {
            let mut velocity = <[[R; 1]; 2] as Array>::zero();
            velocity
        }
        #[inline(always)]
        fn field(
            &self,
            prepared: &[R; 0],
            t: R,
            y: &[[R; 1]; 2],
            f: &mut [[R; 1]; 2],
            jacobian: &mut Square<[[R; 1]; 2]>,
        ) {
            let (
                p0,
                k1,
                k2,
                q0,
                k4,
                k5,
                v0,
                v1,
                v2,
                v3,
                v4,
                v5,
                v13,
                v14,
                v15,
                v16,
                v17,
                v18,
                v19,
                v20,
            );
            p0 = y[1][0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(0.0);
            q0 = y[0][0];
            k4 = R::from_f64(4.0);
            k5 = R::from_f64(12.0);
            v0 = p0 * p0;
            v1 = k1 + v0;
            v2 = v1.sqrt();
            v3 = k1 / v2;
            v4 = p0 * v3;
            v5 = k2.less(q0);
            [v13, v14] = R::choose(
                v5,
                || {
                    let (v6, v7, v8, v9, v10, v11, v12);
                    v6 = t.cos();
                    v7 = q0 * q0;
                    v8 = v7 * q0;
                    v9 = k4 * v8;
                    v10 = v9 * v6;
                    v11 = k5 * v7;
                    v12 = v11 * v6;
                    [v10, v12]
                },
                || { [k2, k2] },
            );
            v15 = -v13;
            v16 = v3 * v3;
            v17 = v16 * v3;
            v18 = -v0;
            v19 = v18.multiply_add(v17, v3);
            v20 = -v14;
            f[0][0] = v4;
            f[1][0] = v15;
            jacobian[0][0][0][0] = k2;
            jacobian[0][0][1][0] = v19;
            jacobian[1][0][0][0] = v20;
            jacobian[1][0][1][0] = k2;
        }
        #[inline(always)]
        fn add(&self, prepared: &[R; 0], w: R, f: &[[R; 1]; 2], y: &mut [[R; 1]; 2]) {
            y[0][0] = w.multiply_add(f[0][0], y[0][0]);
            y[1][0] = w.multiply_add(f[1][0], y[1][0]);
        }
        #[inline(always)]
        fn increments(change: &[[R; 1]; 2], impulse: &[[R; 1]; 2]) -> [[R; 1]; 2] {
            *change
        }
    }
    impl<R: Real> Jets<R> for Spring {
        type Proof = ();
        type Switches = [R; 1];
        type Over<T: Real> = State<T>;
        const CONVOLUTIONS: usize = 6;
        #[inline]
        fn jet<const P: usize>(
            &self,
            unit: R,
            t: R,
            z: &[[R; 1]; 2],
            _: &(),
            jet: &mut [PerCoordinate<[[R; 1]; 2], ()>; P],
            switches: &mut [[R; 1]; P],
        ) {
            struct Coefficients<'a, R: Real, const P: usize> {
                k: [R; 12],
                coordinates: [R; 2],
                masks: [R::Mask; 1],
                u2: &'a mut [R; P],
                u3: &'a mut [R; P],
                u5: &'a mut [R; P],
                u8: &'a mut [R; P],
                u10: &'a mut [R; P],
                u11: &'a mut [R; P],
                u12: &'a mut [R; P],
                u13: &'a mut [R; P],
                jet: &'a mut [PerCoordinate<[[R; 1]; 2], ()>; P],
                switches: &'a mut [[R; 1]; P],
            }
            impl<R: Real, const P: usize> recurrence::Series for Coefficients<'_, R, P> {
                #[inline(always)]
                fn order(&mut self, n: usize) {
                    let Self {
                        k,
                        coordinates,
                        masks,
                        u2,
                        u3,
                        u5,
                        u8,
                        u10,
                        u11,
                        u12,
                        u13,
                        jet,
                        switches,
                    } = self;
                    let (whole, next) = (
                        recurrence::whole::<R>(n),
                        k[0] * recurrence::inverse::<R>(n + 1),
                    );
                    let (c2, c5, c3, c0, c8, c13, c11, c10, c9, c7, c4, c1, c6, c12);
                    c2 = coordinates[1];
                    c5 = recurrence::squares(
                        [k[1]],
                        [c2],
                        recurrence::sum_of_squares([&*u2], n),
                    );
                    u5[n] = c5;
                    c3 = recurrence::power(
                        [k[3], k[2]],
                        c5,
                        recurrence::sum_of_power(u5, u3, k[4], n),
                        n,
                    );
                    u3[n] = c3;
                    c0 = recurrence::product(
                        [k[1], k[5]],
                        [c2, c3],
                        recurrence::sum(u2, u3, n),
                    );
                    c8 = coordinates[0];
                    c13 = recurrence::squares(
                        [k[6]],
                        [c8],
                        recurrence::sum_of_squares([&*u8], n),
                    );
                    u13[n] = c13;
                    c11 = recurrence::product(
                        [k[6], k[7]],
                        [c8, c13],
                        recurrence::sum(u8, u13, n),
                    );
                    u11[n] = c11;
                    c10 = k[8] * u12[n - 1] * recurrence::inverse::<R>(n);
                    u10[n] = c10;
                    c9 = recurrence::product(
                        [k[9], k[10]],
                        [c10, c11],
                        recurrence::sum(u10, u11, n),
                    );
                    c7 = R::from_f64(4.0) * c9;
                    c4 = {
                        let [chosen] = R::choose(
                            masks[0],
                            || [c7],
                            || [R::from_f64(0.0)],
                        );
                        chosen
                    };
                    c1 = -c4;
                    c6 = -c8;
                    c12 = k[11] * u10[n - 1] * recurrence::inverse::<R>(n);
                    u12[n] = c12;
                    jet[n].z[0][0] = next * c0;
                    coordinates[0] = jet[n].z[0][0];
                    if n + 1 < P {
                        u8[n + 1] = jet[n].z[0][0];
                    }
                    jet[n].z[1][0] = -(next) * c4;
                    coordinates[1] = jet[n].z[1][0];
                    if n + 1 < P {
                        u2[n + 1] = jet[n].z[1][0];
                    }
                    switches[n][0] = c6;
                }
            }
            let [q, p] = z;
            let (
                p0,
                k1,
                k2,
                q0,
                k4,
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
                v14,
                v15,
            );
            p0 = p[0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(0.0);
            q0 = q[0];
            k4 = R::from_f64(4.0);
            v0 = p0 * p0;
            v1 = k1 + v0;
            v2 = v1.sqrt();
            v3 = k1 / v2;
            v4 = p0 * v3;
            v5 = k2.less(q0);
            (v6, v7) = t.sin_cos();
            v8 = q0 * q0;
            v9 = v8 * q0;
            v10 = k4 * v9;
            v11 = v10 * v7;
            [v12] = R::choose(v5, || { [v11] }, || { [k2] });
            v13 = -v12;
            v14 = -q0;
            v15 = v9 * v7;
            let (u2, u3, u5, u8, u10, u11, u12, u13) = (
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
            );
            u2[0] = p0;
            u3[0] = v3;
            u5[0] = v1;
            u8[0] = q0;
            u10[0] = v7;
            u11[0] = v9;
            u12[0] = v6;
            u13[0] = v8;
            jet[0].z[0][0] = unit * (v4);
            if P > 1 {
                u8[1] = jet[0].z[0][0];
            }
            jet[0].z[1][0] = unit * (v13);
            if P > 1 {
                u2[1] = jet[0].z[1][0];
            }
            switches[0][0] = v14;
            recurrence::orders::<
                18,
                P,
            >(
                &mut Coefficients {
                    k: [
                        unit,
                        p0,
                        R::from_f64(-0.5) * v3 / v1,
                        v1,
                        R::from_f64(0.5),
                        v3,
                        q0,
                        v8,
                        unit * (-k1),
                        v7,
                        v9,
                        unit * (k1),
                    ],
                    coordinates: [jet[0].z[0][0], jet[0].z[1][0]],
                    masks: [v5],
                    u2,
                    u3,
                    u5,
                    u8,
                    u10,
                    u11,
                    u12,
                    u13,
                    jet,
                    switches,
                },
            );
        }
    }
    impl Spring {
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
