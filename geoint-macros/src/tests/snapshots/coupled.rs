fn coupled(q: [f64; 2], p: [f64; 2]) -> f64 {
    (1.0 + q[0] * q[0]) * p[0] * p[0] + p[1] * q[1]
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
H = p[0]²·(q[0]² + 1) + q[1]·p[1]
∂H/∂q[0] = 2·q[0]·p[0]²
∂H/∂q[1] = p[1]
∂H/∂p[0] = 2·p[0]·(q[0]² + 1)
∂H/∂p[1] = q[1]

Structure
- not separable, q and p are coupled by: p[0]²·(q[0]² + 1)
- H is a polynomial of degree 4 in q and p
- H does not depend on time

Conserved by the flow, at least
- the energy

Discrete gradients
- `DiscreteGradient` and `FourthOrder(DiscreteGradient)` keep all of that, to rounding
- `MeanValue::<2>` is exact: Gauss points for a polynomial

Pieces with flows in closed form, in the order of half a step of `PieceSplitting`
- q[0]²·p[0]²
  geodesic: f(qᵢ) pᵢ² (separation of variables)
  exact in time; sums and products 6, functions 2
- p[0]² + q[1]·p[1]
  oscillators: Σ (a p² + 2e q p + b q²)/2, damped by c s (A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17)
  exact in time; sums and products 6
- tables of Runge–Kutta–Nyström type keep their order, `BlanesMoanSrkn14a.of(PieceSplitting)`

Operations (a sine with its cosine counts as two)
- gradient of H: sums and products 7
- stage of a Newton iteration of collocation: sums and products 15
- Newton iteration of the discrete gradient: sums and products 25

Implicit steps
- `DiscreteGradient`, unknowns 4: Newton's iteration with elimination

Skipped
- the clock: H does not depend on time
- recomputing what depends on parameters and the step size: prepared once
- kick and drift: they do not exist for this H
```*/
struct Coupled;
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
        let _ = coupled;
    };
    impl Coupled {
        /// What was derived from the energy: derivatives or pieces, structure, what is conserved, operations, and what is
        /// skipped and why.
        pub const REPORT: &'static str = "H = p[0]²·(q[0]² + 1) + q[1]·p[1]\n∂H/∂q[0] = 2·q[0]·p[0]²\n∂H/∂q[1] = p[1]\n∂H/∂p[0] = 2·p[0]·(q[0]² + 1)\n∂H/∂p[1] = q[1]\n\nStructure\n- not separable, q and p are coupled by: p[0]²·(q[0]² + 1)\n- H is a polynomial of degree 4 in q and p\n- H does not depend on time\n\nConserved by the flow, at least\n- the energy\n\nDiscrete gradients\n- `DiscreteGradient` and `FourthOrder(DiscreteGradient)` keep all of that, to rounding\n- `MeanValue::<2>` is exact: Gauss points for a polynomial\n\nPieces with flows in closed form, in the order of half a step of `PieceSplitting`\n- q[0]²·p[0]²\n  geodesic: f(qᵢ) pᵢ² (separation of variables)\n  exact in time; sums and products 6, functions 2\n- p[0]² + q[1]·p[1]\n  oscillators: Σ (a p² + 2e q p + b q²)/2, damped by c s (A. Bravetti, H. Cruz & D. Tapias, Ann. Phys. 376 (2017) 17)\n  exact in time; sums and products 6\n- tables of Runge–Kutta–Nyström type keep their order, `BlanesMoanSrkn14a.of(PieceSplitting)`\n\nOperations (a sine with its cosine counts as two)\n- gradient of H: sums and products 7\n- stage of a Newton iteration of collocation: sums and products 15\n- Newton iteration of the discrete gradient: sums and products 25\n\nImplicit steps\n- `DiscreteGradient`, unknowns 4: Newton's iteration with elimination\n\nSkipped\n- the clock: H does not depend on time\n- recomputing what depends on parameters and the step size: prepared once\n- kick and drift: they do not exist for this H\n";
        /// The energy of a state.
        pub fn energy(&self, state: &State<[f64; 2]>) -> f64 {
            PhaseSpace::energy(self, state)
        }
        /// This system under a method, with step size `h` (negative to go back in time), from `state` on.
        ///
        /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
        pub fn integrator<M: Method<Self, f64, Proof = P>, P>(
            self,
            method: M,
            h: f64,
            state: State<[f64; 2]>,
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
            state: State<[f64; 2]>,
        ) -> <P as ProofAnd<Adaptive<Self, M, f64>>>::Both {
            Adaptive::new(self, method, tolerance, state)
        }
    }
    impl<R: Real> Conservative<R> for Coupled {
        type Proof = ();
    }
    impl<R: Real> Autonomous<R> for Coupled {
        type Proof = ();
    }
    impl<R: Real> NystromPieces<R> for Coupled {
        type Proof = ();
    }
    impl<R: Real> PhaseSpace<R> for Coupled {
        type State = State<[R; 2]>;
        type Phase = [[R; 2]; 2];
        type Action = ();
        #[inline]
        fn hamiltonian(&self, t: R, z: &[[R; 2]; 2], _: &()) -> R {
            let [q, p] = z;
            let (q0, k1, p0, q1, p1, v0, v1, v2, v3, v4);
            q0 = q[0];
            k1 = R::from_f64(1.0);
            p0 = p[0];
            q1 = q[1];
            p1 = p[1];
            v0 = q0 * q0;
            v1 = k1 + v0;
            v2 = p0 * p0;
            v3 = q1 * p1;
            v4 = v2.multiply_add(v1, v3);
            v4
        }
        fn outside_domain(
            &self,
            t: R,
            z: &[[R; 2]; 2],
            s: &(),
        ) -> ::core::option::Option<&'static str> {
            let [q, p] = z;
            ::core::option::Option::None
        }
    }
    impl<R: Real> DifferentialEquation<R> for Coupled {
        type Proof = ();
        #[inline(always)]
        fn rate(&self, t: R, z: &[[R; 2]; 2], slopes: &mut [[R; 2]; 2]) {
            let [q, p] = z;
            canonical_rate(self, t, z, slopes);
        }
    }
    impl<R: Real> CotangentSpace<R> for Coupled {
        type Coordinates = [R; 2];
        type Array = [R; 2];
    }
    impl<R: Real> Hamiltonian<R> for Coupled {
        type Proof = ();
        #[inline]
        fn gradient(&self, t: R, z: &[[R; 2]; 2], slopes: &mut [[R; 2]; 2]) {
            let [q, p] = z;
            let (p0, k1, q0, k3, p1, q1, v0, v1, v2, v3, v4, v5, v6);
            p0 = p[0];
            k1 = R::from_f64(2.0);
            q0 = q[0];
            k3 = R::from_f64(1.0);
            p1 = p[1];
            q1 = q[1];
            v0 = p0 * p0;
            v1 = k1 * q0;
            v2 = v1 * v0;
            v3 = q0 * q0;
            v4 = k3 + v3;
            v5 = k1 * p0;
            v6 = v5 * v4;
            slopes[0][0] = v2;
            slopes[0][1] = p1;
            slopes[1][0] = v6;
            slopes[1][1] = q1;
        }
    }
    impl<R: Real> KeepsEnergy<R> for Coupled {
        type Proof = ();
        type Kept = CanonicalEnergy;
    }
    impl<R: Real> FlowPieces<PieceSplitting, R> for Coupled {
        const PIECES: &'static [FlowPiece] = &[
            FlowPiece {
                name: "q[0]²·p[0]²",
                clock: PieceClock::Own,
                solved: false,
                may_end: false,
            },
            FlowPiece {
                name: "p[0]² + q[1]·p[1]",
                clock: PieceClock::Own,
                solved: false,
                may_end: false,
            },
        ];
        const SYMPLECTIC: bool = true;
        const CONSERVES_ENERGY: bool = false;
        type Proof = ();
        type Flows = ([R; 2], [R; 3]);
        type Frozen = ([R; 0], [R; 0]);
        #[inline]
        fn prepare_flows(&self, outer: R, last: R) -> ([R; 2], [R; 3]) {
            (
                {
                    let h = outer;
                    let (k0, v0, v1);
                    k0 = R::from_f64(2.0);
                    v0 = k0 * h;
                    v1 = -v0;
                    [v0, v1]
                },
                {
                    let h = last;
                    let (
                        k0,
                        k1,
                        k2,
                        k3,
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
                    k0 = R::from_f64(0.0);
                    k1 = R::from_f64(2.0);
                    k2 = R::from_f64(0.25);
                    k3 = R::from_f64(0.5);
                    v0 = slope::stumpff_c1(k0);
                    v1 = k1 * h;
                    v2 = v1 * v0;
                    v3 = h * h;
                    v4 = -v3;
                    v5 = slope::stumpff_c1(v4);
                    v6 = k2 * v3;
                    v7 = -v6;
                    v8 = slope::stumpff_c1(v7);
                    v9 = v8 * v8;
                    v10 = k3 * v3;
                    v11 = h * v5;
                    v12 = v10.multiply_add(v9, v11);
                    v13 = v10 * v9;
                    v14 = -h;
                    v15 = v14.multiply_add(v5, v13);
                    [v2, v12, v15]
                },
            )
        }
        #[inline(always)]
        fn freeze(&self, flows: &([R; 2], [R; 3]), t: R) -> ([R; 0], [R; 0]) {
            (
                {
                    let prepared = &flows.0;
                    []
                },
                {
                    let prepared = &flows.1;
                    []
                },
            )
        }
        #[inline(always)]
        fn flow(
            &self,
            piece: usize,
            flows: &([R; 2], [R; 3]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            z: &mut [[R; 2]; 2],
            s: &mut (),
        ) {
            let [q, p] = z;
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let (prepared_0, p0, q0, prepared_1, v0, v1, v2, v3, v4, v5, v6, v7);
                    prepared_0 = prepared[0];
                    p0 = p[0];
                    q0 = q[0];
                    prepared_1 = prepared[1];
                    v0 = prepared_0 * p0;
                    v1 = v0 * q0;
                    v2 = v1.exp();
                    v3 = q0 * v2;
                    v4 = prepared_1 * p0;
                    v5 = v4 * q0;
                    v6 = v5.exp();
                    v7 = p0 * v6;
                    q[0] = v3;
                    p[0] = v7;
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let (prepared_0, p0, q0, prepared_1, q1, prepared_2, p1, v0, v1, v2);
                    prepared_0 = prepared[0];
                    p0 = p[0];
                    q0 = q[0];
                    prepared_1 = prepared[1];
                    q1 = q[1];
                    prepared_2 = prepared[2];
                    p1 = p[1];
                    v0 = prepared_0.multiply_add(p0, q0);
                    v1 = prepared_1.multiply_add(q1, q1);
                    v2 = prepared_2.multiply_add(p1, p1);
                    q[0] = v0;
                    q[1] = v1;
                    p[0] = p0;
                    p[1] = v2;
                }
                _ => {}
            }
        }
        #[inline(always)]
        fn increments(
            &self,
            piece: usize,
            flows: &([R; 2], [R; 3]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            x: &PerCoordinate<[[R; 2]; 2], ()>,
        ) -> PerCoordinate<[[R; 2]; 2], ()> {
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let PerCoordinate { z: [q, p], s } = x;
                    let mut d: PerCoordinate<[[R; 2]; 2], ()> = PerCoordinate::nothing();
                    let (prepared_0, p0, q0, prepared_1, v0, v1, v2, v3, v4, v5, v6, v7);
                    prepared_0 = prepared[0];
                    p0 = p[0];
                    q0 = q[0];
                    prepared_1 = prepared[1];
                    v0 = prepared_0 * p0;
                    v1 = v0 * q0;
                    v2 = v1.exp_m1();
                    v3 = q0 * v2;
                    v4 = prepared_1 * p0;
                    v5 = v4 * q0;
                    v6 = v5.exp_m1();
                    v7 = p0 * v6;
                    d.z[0][0] = v3;
                    d.z[1][0] = v7;
                    d
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let PerCoordinate { z: [q, p], s } = x;
                    let mut d: PerCoordinate<[[R; 2]; 2], ()> = PerCoordinate::nothing();
                    let (prepared_0, p0, prepared_1, q1, prepared_2, p1, k6, v0, v1, v2);
                    prepared_0 = prepared[0];
                    p0 = p[0];
                    prepared_1 = prepared[1];
                    q1 = q[1];
                    prepared_2 = prepared[2];
                    p1 = p[1];
                    k6 = R::from_f64(0.0);
                    v0 = prepared_0 * p0;
                    v1 = prepared_1 * q1;
                    v2 = prepared_2 * p1;
                    d.z[0][0] = v0;
                    d.z[0][1] = v1;
                    d.z[1][0] = k6;
                    d.z[1][1] = v2;
                    d
                }
                _ => PerCoordinate::nothing(),
            }
        }
    }
    #[diagnostic::on_unimplemented(
        message = "`Coupled`: this term couples positions and momenta, so kick and drift do not exist; its flow is known: use `PieceSplitting`, or one of its compositions such as `KahanLi8_17a.of(PieceSplitting)`",
        label = "the term is: p[0]²·(q[0]² + 1)"
    )]
    pub trait UncoupledCoupled {
        type Proof;
    }
    impl<R: Real + UncoupledCoupled> Separable<R> for Coupled {
        type Proof = <R as UncoupledCoupled>::Proof;
        type Kick = ::core::convert::Infallible;
        type Drift = ::core::convert::Infallible;
        fn prepare_kick(&self, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn prepare_drift(&self, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn kick(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 2],
            _: &mut [R; 2],
            _: &mut (),
        ) {
            match *never {}
        }
        fn drift(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 2],
            _: &mut [R; 2],
            _: &mut (),
        ) {
            match *never {}
        }
    }
    impl<R: Real + UncoupledCoupled> QuadraticKinetic<R> for Coupled {
        type Proof = <R as UncoupledCoupled>::Proof;
    }
    impl<R: Real + UncoupledCoupled> ForceGradient<R> for Coupled {
        type GradientKick = ::core::convert::Infallible;
        fn prepare_gradient_kick(&self, _: R, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn gradient_kick(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 2],
            _: &mut [R; 2],
            _: &mut (),
        ) {
            match *never {}
        }
    }
    #[diagnostic::on_unimplemented(
        message = "`Coupled`: no part of this energy has an exact flow beside a rest that is a kick; for bodies that attract each other `coordinates = jacobi` makes one, and `split = \"A | B\"` names one",
        label = "the term is: p[0]²·(q[0]² + 1)"
    )]
    pub trait PartedCoupled {
        type Proof;
    }
    impl<R: Real + PartedCoupled> PerturbedSystem<R> for Coupled {
        type Proof = <R as PartedCoupled>::Proof;
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
            _: &mut [R; 2],
            _: &mut [R; 2],
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
            _: &mut [R; 2],
            _: &mut [R; 2],
            _: &mut (),
        ) {
            match *never {}
        }
    }
    impl<R: Real + PartedCoupled> PerturbedGradient<R> for Coupled {
        type Proof = <R as PartedCoupled>::Proof;
        type GradientKick = ::core::convert::Infallible;
        fn prepare_gradient_kick(&self, _: R, _: R) -> ::core::convert::Infallible {
            ::core::unreachable!()
        }
        fn gradient_kick(
            &self,
            never: &::core::convert::Infallible,
            _: R,
            _: &mut [R; 2],
            _: &mut [R; 2],
        ) {
            match *never {}
        }
    }
    impl<R: Real> Graded<R> for Coupled {
        type Proof = ();
        type Gradient = ByTree;
        type Kept = CanonicalEnergy;
    }
    impl<R: Real> DiscreteField<R> for Coupled {
        type Proof = ();
        type Parameters = [R; 0];
        type Start = [R; 8];
        type Inverse = ();
        const MEAN: Mean = Mean::Gauss(2);
        #[inline]
        fn parameters(&self, h: R) -> [R; 0] {
            []
        }
        #[inline(always)]
        fn begin(
            &self,
            prepared: &[R; 0],
            Span { start, middle: t, end }: Span<R>,
            y: &[[R; 2]; 2],
        ) -> [R; 8] {
            let (q0, k1, k2, p0, q1, p1, v0, v1, v2, v3, v4);
            q0 = y[0][0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(2.0);
            p0 = y[1][0];
            q1 = y[0][1];
            p1 = y[1][1];
            v0 = q0 * q0;
            v1 = k1 + v0;
            v2 = k2 * p0;
            v3 = p0 * p0;
            v4 = k2 * q0;
            [v1, q0, v2, q1, v3, p0, v4, p1]
        }
        #[inline(always)]
        fn slope(
            &self,
            prepared: &[R; 0],
            start: &[R; 8],
            d: &[[R; 2]; 2],
            f: &mut [[R; 2]; 2],
            jacobian: &mut Square<[[R; 2]; 2]>,
        ) {
            let (
                start_1,
                dq0,
                k2,
                start_0,
                start_2,
                dp0,
                k6,
                dq1,
                start_3,
                start_5,
                start_4,
                start_6,
                dp1,
                start_7,
                k14,
                k15,
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
                v16,
                v17,
                v18,
                v19,
                v20,
                v21,
                v22,
            );
            start_1 = start[1];
            dq0 = d[0][0];
            k2 = R::from_f64(1.0);
            start_0 = start[0];
            start_2 = start[2];
            dp0 = d[1][0];
            k6 = R::from_f64(0.5);
            dq1 = d[0][1];
            start_3 = start[3];
            start_5 = start[5];
            start_4 = start[4];
            start_6 = start[6];
            dp1 = d[1][1];
            start_7 = start[7];
            k14 = R::from_f64(0.0);
            k15 = R::from_f64(-0.5);
            v0 = start_1 + dq0;
            v1 = v0 * v0;
            v2 = k2 + v1;
            v3 = start_0 + v2;
            v4 = start_2 + dp0;
            v5 = k6 * v4;
            v6 = v5 * v3;
            v7 = k6.multiply_add(dq1, start_3);
            v8 = start_5 + dp0;
            v9 = v8 * v8;
            v10 = start_4 + v9;
            v11 = start_6 + dq0;
            v12 = k6 * v11;
            v13 = v12 * v10;
            v14 = -v13;
            v15 = k6.multiply_add(dp1, start_7);
            v16 = -v15;
            v17 = v0 * v4;
            v18 = k6 * v3;
            v19 = k6 * v10;
            v20 = -v19;
            v21 = v8 * v11;
            v22 = -v21;
            f[0][0] = v6;
            f[0][1] = v7;
            f[1][0] = v14;
            f[1][1] = v16;
            jacobian[0][0][0][0] = v17;
            jacobian[0][0][0][1] = k14;
            jacobian[0][0][1][0] = v18;
            jacobian[0][0][1][1] = k14;
            jacobian[0][1][0][0] = k14;
            jacobian[0][1][0][1] = k6;
            jacobian[0][1][1][0] = k14;
            jacobian[0][1][1][1] = k14;
            jacobian[1][0][0][0] = v20;
            jacobian[1][0][0][1] = k14;
            jacobian[1][0][1][0] = v22;
            jacobian[1][0][1][1] = k14;
            jacobian[1][1][0][0] = k14;
            jacobian[1][1][0][1] = k14;
            jacobian[1][1][1][0] = k14;
            jacobian[1][1][1][1] = k15;
        }
        #[inline(always)]
        fn drift(&self, prepared: &[R; 0], sum: &[[R; 2]; 2]) -> [[R; 2]; 2] {
            let mut drift = <[[R; 2]; 2] as Array>::zero();
            drift
        }
    }
    impl<R: Real> KeptMomenta<R> for Coupled {
        type Values = [R; 1];
        #[inline(always)]
        fn momenta(&self, z: &[[R; 2]; 2]) -> [[[R; 2]; 2]; 1] {
            let mut slopes = [<[[R; 2]; 2] as Array>::zero(); 1];
            let [q, p] = z;
            slopes
        }
    }
    impl<R: Real> FourthOrderField<R> for Coupled {
        type Proof = ();
        type FourthParameters = fourth_order::ParametersOf<Self, R>;
        type FourthStart = fourth_order::Begun<[R; 2]>;
        #[inline]
        fn fourth_parameters(&self, h: R) -> Self::FourthParameters {
            fourth_order::parameters(self, h)
        }
        #[inline(always)]
        fn fourth_begin(
            &self,
            parameters: &Self::FourthParameters,
            span: Span<R>,
            z: &[[R; 2]; 2],
        ) -> Self::FourthStart {
            fourth_order::begin(self, parameters, span, z)
        }
        #[inline(always)]
        fn fourth_slope<const NEARLY: bool>(
            &self,
            parameters: &Self::FourthParameters,
            start: &Self::FourthStart,
            d: &[[R; 2]; 2],
            image: &mut [[R; 2]; 2],
            matrix: &mut Square<[[R; 2]; 2]>,
        ) {
            let momenta = |z: &[[R; 2]; 2]| self.momenta(z);
            fourth_order::slope::<
                NEARLY,
                true,
                1,
                _,
                _,
            >(self, parameters, start, momenta, d, (image, matrix));
        }
    }
    impl<R: Real> Collocated<R> for Coupled {
        type Proof = ();
        type Stages = ByField;
    }
    impl<R: Real> Collocation<R> for Coupled {
        type Proof = ();
        type Unknown = [[R; 2]; 2];
        type Constants = [R; 0];
        const DERIVATIVE: usize = 1;
        #[inline]
        fn constants(&self) -> [R; 0] {
            []
        }
        #[inline(always)]
        fn start(z: &[[R; 2]; 2]) -> ([[R; 2]; 2], [[R; 2]; 2]) {
            (*z, *z)
        }
        #[inline(always)]
        fn velocity(&self, prepared: &[R; 0], p: &[[R; 2]; 2]) -> [[R; 2]; 2] {
            let mut velocity = <[[R; 2]; 2] as Array>::zero();
            velocity
        }
        #[inline(always)]
        fn field(
            &self,
            prepared: &[R; 0],
            t: R,
            y: &[[R; 2]; 2],
            f: &mut [[R; 2]; 2],
            jacobian: &mut Square<[[R; 2]; 2]>,
        ) {
            let (
                q0,
                k1,
                k2,
                p0,
                p1,
                k5,
                q1,
                k7,
                k8,
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
            );
            q0 = y[0][0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(2.0);
            p0 = y[1][0];
            p1 = y[1][1];
            k5 = R::from_f64(4.0);
            q1 = y[0][1];
            k7 = R::from_f64(0.0);
            k8 = R::from_f64(-1.0);
            v0 = q0 * q0;
            v1 = k1 + v0;
            v2 = k2 * p0;
            v3 = v2 * v1;
            v4 = p0 * p0;
            v5 = k2 * q0;
            v6 = v5 * v4;
            v7 = -v6;
            v8 = -p1;
            v9 = k5 * q0;
            v10 = v9 * p0;
            v11 = k2 * v1;
            v12 = k2 * v4;
            v13 = -v12;
            v14 = -v10;
            f[0][0] = v3;
            f[0][1] = q1;
            f[1][0] = v7;
            f[1][1] = v8;
            jacobian[0][0][0][0] = v10;
            jacobian[0][0][0][1] = k7;
            jacobian[0][0][1][0] = v11;
            jacobian[0][0][1][1] = k7;
            jacobian[0][1][0][0] = k7;
            jacobian[0][1][0][1] = k1;
            jacobian[0][1][1][0] = k7;
            jacobian[0][1][1][1] = k7;
            jacobian[1][0][0][0] = v13;
            jacobian[1][0][0][1] = k7;
            jacobian[1][0][1][0] = v14;
            jacobian[1][0][1][1] = k7;
            jacobian[1][1][0][0] = k7;
            jacobian[1][1][0][1] = k7;
            jacobian[1][1][1][0] = k7;
            jacobian[1][1][1][1] = k8;
        }
        #[inline(always)]
        fn add(&self, prepared: &[R; 0], w: R, f: &[[R; 2]; 2], y: &mut [[R; 2]; 2]) {
            y[0][0] = w.multiply_add(f[0][0], y[0][0]);
            y[0][1] = w.multiply_add(f[0][1], y[0][1]);
            y[1][0] = w.multiply_add(f[1][0], y[1][0]);
            y[1][1] = w.multiply_add(f[1][1], y[1][1]);
        }
        #[inline(always)]
        fn increments(change: &[[R; 2]; 2], impulse: &[[R; 2]; 2]) -> [[R; 2]; 2] {
            *change
        }
    }
    impl<R: Real> Jets<R> for Coupled {
        type Proof = ();
        type Switches = [R; 0];
        type Over<T: Real> = State<[T; 2]>;
        const CONVOLUTIONS: usize = 3;
        #[inline]
        fn jet<const P: usize>(
            &self,
            unit: R,
            t: R,
            z: &[[R; 2]; 2],
            _: &(),
            jet: &mut [PerCoordinate<[[R; 2]; 2], ()>; P],
            switches: &mut [[R; 0]; P],
        ) {
            struct Coefficients<'a, R: Real, const P: usize> {
                k: [R; 5],
                coordinates: [R; 4],
                masks: [R::Mask; 0],
                u1: &'a mut [R; P],
                u6: &'a mut [R; P],
                u7: &'a mut [R; P],
                u8: &'a mut [R; P],
                u9: &'a mut [R; P],
                u10: &'a mut [R; P],
                jet: &'a mut [PerCoordinate<[[R; 2]; 2], ()>; P],
                switches: &'a mut [[R; 0]; P],
            }
            impl<R: Real, const P: usize> recurrence::Series for Coefficients<'_, R, P> {
                #[inline(always)]
                fn order(&mut self, n: usize) {
                    let Self {
                        k,
                        coordinates,
                        masks,
                        u1,
                        u6,
                        u7,
                        u8,
                        u9,
                        u10,
                        jet,
                        switches,
                    } = self;
                    let (whole, next) = (
                        recurrence::whole::<R>(n),
                        k[0] * recurrence::inverse::<R>(n + 1),
                    );
                    let (c9, c8, c7, c4, c0, c1, c10, c5, c2, c6, c3);
                    c9 = coordinates[0];
                    c8 = recurrence::squares(
                        [k[1]],
                        [c9],
                        recurrence::sum_of_squares([&*u9], n),
                    );
                    u8[n] = c8;
                    c7 = coordinates[2];
                    c4 = recurrence::product(
                        [k[2], k[3]],
                        [c7, c8],
                        recurrence::sum(u7, u8, n),
                    );
                    c0 = R::from_f64(2.0) * c4;
                    c1 = coordinates[1];
                    c10 = recurrence::squares(
                        [k[2]],
                        [c7],
                        recurrence::sum_of_squares([&*u7], n),
                    );
                    u10[n] = c10;
                    c5 = recurrence::product(
                        [k[1], k[4]],
                        [c9, c10],
                        recurrence::sum(u9, u10, n),
                    );
                    c2 = R::from_f64(-2.0) * c5;
                    c6 = coordinates[3];
                    c3 = -c6;
                    jet[n].z[0][0] = (next) * R::from_f64(2.0) * c4;
                    coordinates[0] = jet[n].z[0][0];
                    if n + 1 < P {
                        u9[n + 1] = jet[n].z[0][0];
                    }
                    jet[n].z[0][1] = next * c1;
                    coordinates[1] = jet[n].z[0][1];
                    if n + 1 < P {
                        u1[n + 1] = jet[n].z[0][1];
                    }
                    jet[n].z[1][0] = (next) * R::from_f64(-2.0) * c5;
                    coordinates[2] = jet[n].z[1][0];
                    if n + 1 < P {
                        u7[n + 1] = jet[n].z[1][0];
                    }
                    jet[n].z[1][1] = -(next) * c6;
                    coordinates[3] = jet[n].z[1][1];
                    if n + 1 < P {
                        u6[n + 1] = jet[n].z[1][1];
                    }
                }
            }
            let [q, p] = z;
            let (q0, k1, k2, p0, p1, q1, v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10);
            q0 = q[0];
            k1 = R::from_f64(1.0);
            k2 = R::from_f64(2.0);
            p0 = p[0];
            p1 = p[1];
            q1 = q[1];
            v0 = q0 * q0;
            v1 = k1 + v0;
            v2 = k2 * p0;
            v3 = v2 * v1;
            v4 = p0 * p0;
            v5 = k2 * q0;
            v6 = v5 * v4;
            v7 = -v6;
            v8 = -p1;
            v9 = p0 * v1;
            v10 = q0 * v4;
            let (u1, u6, u7, u8, u9, u10) = (
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
                &mut [R::from_f64(0.0); P],
            );
            u1[0] = q1;
            u6[0] = p1;
            u7[0] = p0;
            u8[0] = v1;
            u9[0] = q0;
            u10[0] = v4;
            jet[0].z[0][0] = unit * (v3);
            if P > 1 {
                u9[1] = jet[0].z[0][0];
            }
            jet[0].z[0][1] = unit * (q1);
            if P > 1 {
                u1[1] = jet[0].z[0][1];
            }
            jet[0].z[1][0] = unit * (v7);
            if P > 1 {
                u7[1] = jet[0].z[1][0];
            }
            jet[0].z[1][1] = unit * (v8);
            if P > 1 {
                u6[1] = jet[0].z[1][1];
            }
            recurrence::orders::<
                25,
                P,
            >(
                &mut Coefficients {
                    k: [unit, q0, p0, v1, v4],
                    coordinates: [
                        jet[0].z[0][0],
                        jet[0].z[0][1],
                        jet[0].z[1][0],
                        jet[0].z[1][1],
                    ],
                    masks: [],
                    u1,
                    u6,
                    u7,
                    u8,
                    u9,
                    u10,
                    jet,
                    switches,
                },
            );
        }
    }
    impl Coupled {
        /// This system by Taylor series of its solution, from `state` on.
        ///
        /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
        pub fn taylor<M: TaylorMethod<Self, f64>>(
            self,
            method: M,
            state: State<[f64; 2]>,
        ) -> TaylorIntegrator<Self, M, f64> {
            TaylorIntegrator::new(self, method, state)
        }
    }
};
