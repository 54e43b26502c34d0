fn turning(x: [f64; 2], w: f64) -> [f64; 2] {
    let _ = || {
        let _ = x[0] * x[0] + x[1] * x[1];
    };
    [-w * x[1], w * x[0]]
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
x[0]' = -x[1]·w
x[1]' = x[0]·w

Divergence
- div f = 0, proven by multiplying out
- canonical, H = -x[1]²·w/2 - x[0]²·w/2, proven by multiplying out: write it with `#[hamiltonian]` for kicks and drifts

Structure
- x' = S ∇I with I = x[0]² + x[1]² and skew S, found
- {x[0], x[1]} = -w/2
- a Poisson structure: Jacobi's identity holds

Integrals
- radius = x[0]² + x[1]²: kept, proven by multiplying out

Operations (a sine with its cosine counts as two)
- x': sums and products 3
- stage of a Newton iteration of collocation: sums and products 2
- Newton iteration of `DiscreteGradient`: sums and products 45, functions 8
- Newton iteration of `FourthOrder`: sums and products 67, functions 8

Implicit steps
- unknowns 2: Newton's iteration with elimination
- `DiscreteGradient` and `FourthOrder` keep radius, to rounding

Pieces of `PoissonSplitting`, in the order of half a step
- x[0]², moves x[1]
  single equations: x' = g(x), all else at rest
  exact in time; sums and products 2
- x[1]², moves x[0]
  single equations: x' = g(x), all else at rest
  exact in time; sums and products 2
- a Poisson map: Casimirs are kept to rounding, radius to the order

Pieces of `PlanarSplitting`, in the order of half a step
- the plane of x[0], x[1]
  linear field: x' = g·(Mx + b), M³ = −κM, M²b = −κb, g constant along the flow
  exact in time; sums and products 8
- radius is kept to rounding, Casimirs to the order
- `PlanarDiscreteGradient`: 1 equation of two unknowns
- `PlanarItohAbe`: 2 equations of two unknowns
```*/
struct Turning<R = f64> {
    ///The parameter `w` of the energy.
    pub w: R,
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
        let _ = turning;
    };
    impl Turning {
        /// What was derived from the energy: derivatives or pieces, structure, what is conserved, operations, and what is
        /// skipped and why.
        pub const REPORT: &'static str = "x[0]' = -x[1]·w\nx[1]' = x[0]·w\n\nDivergence\n- div f = 0, proven by multiplying out\n- canonical, H = -x[1]²·w/2 - x[0]²·w/2, proven by multiplying out: write it with `#[hamiltonian]` for kicks and drifts\n\nStructure\n- x' = S ∇I with I = x[0]² + x[1]² and skew S, found\n- {x[0], x[1]} = -w/2\n- a Poisson structure: Jacobi's identity holds\n\nIntegrals\n- radius = x[0]² + x[1]²: kept, proven by multiplying out\n\nOperations (a sine with its cosine counts as two)\n- x': sums and products 3\n- stage of a Newton iteration of collocation: sums and products 2\n- Newton iteration of `DiscreteGradient`: sums and products 45, functions 8\n- Newton iteration of `FourthOrder`: sums and products 67, functions 8\n\nImplicit steps\n- unknowns 2: Newton's iteration with elimination\n- `DiscreteGradient` and `FourthOrder` keep radius, to rounding\n\nPieces of `PoissonSplitting`, in the order of half a step\n- x[0]², moves x[1]\n  single equations: x' = g(x), all else at rest\n  exact in time; sums and products 2\n- x[1]², moves x[0]\n  single equations: x' = g(x), all else at rest\n  exact in time; sums and products 2\n- a Poisson map: Casimirs are kept to rounding, radius to the order\n\nPieces of `PlanarSplitting`, in the order of half a step\n- the plane of x[0], x[1]\n  linear field: x' = g·(Mx + b), M³ = −κM, M²b = −κb, g constant along the flow\n  exact in time; sums and products 8\n- radius is kept to rounding, Casimirs to the order\n- `PlanarDiscreteGradient`: 1 equation of two unknowns\n- `PlanarItohAbe`: 2 equations of two unknowns\n";
        /// The energy of a state.
        pub fn energy(&self, state: &FlowState<[f64; 2]>) -> f64 {
            PhaseSpace::energy(self, state)
        }
        /// x' at a state.
        pub fn field(&self, state: &FlowState<[f64; 2]>) -> [f64; 2] {
            let (t, z, ()) = Snapshot::parts(*state);
            let mut slopes = <<Turning as PhaseSpace<f64>>::Phase as Array>::zero();
            DifferentialEquation::rate(self, t, &z, &mut slopes);
            <FlowState<[f64; 2]> as Snapshot>::of(t, slopes, ()).x
        }
        ///The integral `radius` of a state.
        pub fn radius(&self, state: &FlowState<[f64; 2]>) -> f64 {
            let (t, z, ()) = Snapshot::parts(*state);
            NamedFunctions::values(self, t, &z)[0]
        }
        /// This system under a method, with step size `h` (negative to go back in time), from `state` on.
        ///
        /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
        pub fn integrator<M: Method<Self, f64, Proof = P>, P>(
            self,
            method: M,
            h: f64,
            state: FlowState<[f64; 2]>,
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
            state: FlowState<[f64; 2]>,
        ) -> <P as ProofAnd<Adaptive<Self, M, f64>>>::Both {
            Adaptive::new(self, method, tolerance, state)
        }
    }
    impl<R: Real> QuadraticField<R> for Turning<R> {
        type Proof = ();
    }
    impl<R: Real> PhaseSpace<R> for Turning<R> {
        type State = FlowState<[R; 2]>;
        type Phase = [R; 2];
        type Action = ();
        #[inline]
        fn hamiltonian(&self, t: R, z: &[R; 2], _: &()) -> R {
            let q = z;
            let (q0, q1, k2, k3, a0, v0, v1, v2, v3, v4, v5);
            q0 = q[0];
            q1 = q[1];
            k2 = R::from_f64(0.5);
            k3 = R::from_f64(-0.5);
            a0 = self.w;
            v0 = q0 * q0;
            v1 = q1 * q1;
            v2 = k2 * v0;
            v3 = -v2;
            v4 = k3.multiply_add(v1, v3);
            v5 = a0 * v4;
            v5
        }
        fn outside_domain(
            &self,
            t: R,
            z: &[R; 2],
            s: &(),
        ) -> ::core::option::Option<&'static str> {
            let q = z;
            ::core::option::Option::None
        }
    }
    impl<R: Real> DifferentialEquation<R> for Turning<R> {
        type Proof = ();
        #[inline(always)]
        fn rate(&self, t: R, z: &[R; 2], slopes: &mut [R; 2]) {
            let q = z;
            let (q1, a0, q0, v0, v1, v2);
            q1 = q[1];
            a0 = self.w;
            q0 = q[0];
            v0 = q1 * a0;
            v1 = -v0;
            v2 = q0 * a0;
            slopes[0] = v1;
            slopes[1] = v2;
        }
    }
    trait NamedFunctions<R: Real>: PhaseSpace<R> {
        fn values(&self, t: R, z: &Self::Phase) -> [R; 1];
    }
    impl<R: Real> NamedFunctions<R> for Turning<R> {
        #[inline]
        fn values(&self, t: R, z: &[R; 2]) -> [R; 1] {
            let q = z;
            let (q0, q1, v0, v1, v2);
            q0 = q[0];
            q1 = q[1];
            v0 = q0 * q0;
            v1 = q1 * q1;
            v2 = v0 + v1;
            [v2]
        }
    }
    impl<R: Real> FirstIntegrals<R> for Turning<R> {
        type Values = [R; 1];
        const NAMES: &'static [&'static str] = &["radius"];
        #[inline]
        fn integrals(&self, t: R, z: &[R; 2]) -> [R; 1] {
            let all = NamedFunctions::values(self, t, z);
            [all[0]]
        }
    }
    impl<R: Real> SteadyIntegrals<R> for Turning<R> {
        type Proof = ();
        type Steady = [R; 1];
        #[inline]
        fn slopes(&self, z: &[R; 2]) -> [[R; 2]; 1] {
            let q = z;
            let mut slopes = [<[R; 2] as Array>::zero(); 1];
            let (k0, q0, q1, v0, v1);
            k0 = R::from_f64(2.0);
            q0 = q[0];
            q1 = q[1];
            v0 = k0 * q0;
            v1 = k0 * q1;
            slopes[0][0] = v0;
            slopes[0][1] = v1;
            slopes
        }
        #[inline]
        fn changes(&self, z: &[R; 2], dz: &[R; 2]) -> [R; 1] {
            let q = z;
            let (k0, q0, dq0, q1, dq1, v0, v1, v2, v3);
            k0 = R::from_f64(2.0);
            q0 = q[0];
            dq0 = dz[0];
            q1 = q[1];
            dq1 = dz[1];
            v0 = k0.multiply_add(q0, dq0);
            v1 = k0.multiply_add(q1, dq1);
            v2 = dq0 * v0;
            v3 = dq1.multiply_add(v1, v2);
            [v3]
        }
    }
    impl<R: Real> KeepsEnergy<R> for Turning<R> {
        type Proof = ();
        type Kept = Integral<0>;
        #[inline]
        fn kept_energy(&self, t: R, z: &[R; 2]) -> R {
            NamedFunctions::values(self, t, z)[0]
        }
    }
    impl<R: Real> FlowPieces<PoissonSplitting, R> for Turning<R> {
        const PIECES: &'static [FlowPiece] = &[
            FlowPiece {
                name: "x[0]²",
                clock: PieceClock::Own,
                solved: false,
                may_end: false,
            },
            FlowPiece {
                name: "x[1]²",
                clock: PieceClock::Own,
                solved: false,
                may_end: false,
            },
        ];
        const SYMPLECTIC: bool = true;
        const CONSERVES_ENERGY: bool = false;
        type Proof = ();
        type Flows = ([R; 1], [R; 1]);
        type Frozen = ([R; 0], [R; 0]);
        #[inline]
        fn prepare_flows(&self, outer: R, last: R) -> ([R; 1], [R; 1]) {
            (
                {
                    let h = outer;
                    let (a0, v0);
                    a0 = self.w;
                    v0 = a0 * h;
                    [v0]
                },
                {
                    let h = last;
                    let (a0, v0, v1);
                    a0 = self.w;
                    v0 = a0 * h;
                    v1 = -v0;
                    [v1]
                },
            )
        }
        #[inline(always)]
        fn freeze(&self, flows: &([R; 1], [R; 1]), t: R) -> ([R; 0], [R; 0]) {
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
            flows: &([R; 1], [R; 1]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            z: &mut [R; 2],
            s: &mut (),
        ) {
            let q = z;
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let (prepared_0, q0, q1, v0);
                    prepared_0 = prepared[0];
                    q0 = q[0];
                    q1 = q[1];
                    v0 = prepared_0.multiply_add(q0, q1);
                    q[1] = v0;
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let (prepared_0, q1, q0, v0);
                    prepared_0 = prepared[0];
                    q1 = q[1];
                    q0 = q[0];
                    v0 = prepared_0.multiply_add(q1, q0);
                    q[0] = v0;
                }
                _ => {}
            }
        }
        #[inline(always)]
        fn increments(
            &self,
            piece: usize,
            flows: &([R; 1], [R; 1]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            x: &PerCoordinate<[R; 2], ()>,
        ) -> PerCoordinate<[R; 2], ()> {
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let PerCoordinate { z: q, s } = x;
                    let mut d: PerCoordinate<[R; 2], ()> = PerCoordinate::nothing();
                    let (prepared_0, q0, v0);
                    prepared_0 = prepared[0];
                    q0 = q[0];
                    v0 = prepared_0 * q0;
                    d.z[1] = v0;
                    d
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let PerCoordinate { z: q, s } = x;
                    let mut d: PerCoordinate<[R; 2], ()> = PerCoordinate::nothing();
                    let (prepared_0, q1, v0);
                    prepared_0 = prepared[0];
                    q1 = q[1];
                    v0 = prepared_0 * q1;
                    d.z[0] = v0;
                    d
                }
                _ => PerCoordinate::nothing(),
            }
        }
    }
    impl<R: Real> FlowPieces<PlanarSplitting, R> for Turning<R> {
        const PIECES: &'static [FlowPiece] = &[
            FlowPiece {
                name: "-x[1]·w",
                clock: PieceClock::Own,
                solved: false,
                may_end: false,
            },
        ];
        const SYMPLECTIC: bool = false;
        const CONSERVES_ENERGY: bool = true;
        type Proof = ();
        type Flows = ([R; 3],);
        type Frozen = ([R; 0],);
        #[inline]
        fn prepare_flows(&self, outer: R, last: R) -> ([R; 3],) {
            (
                {
                    let h = last;
                    let (a0, k1, k2, v0, v1, v2, v3, v4, v5, v6, v7, v8);
                    a0 = self.w;
                    k1 = R::from_f64(0.5);
                    k2 = R::from_f64(2.0);
                    v0 = a0 * h;
                    v1 = v0.sin();
                    v2 = -v1;
                    v3 = k1 * a0;
                    v4 = v3 * h;
                    v5 = v4.sin();
                    v6 = v5 * v5;
                    v7 = k2 * v6;
                    v8 = -v7;
                    [v2, v8, v1]
                },
            )
        }
        #[inline(always)]
        fn freeze(&self, flows: &([R; 3],), t: R) -> ([R; 0],) {
            (
                {
                    let prepared = &flows.0;
                    []
                },
            )
        }
        #[inline(always)]
        fn flow(
            &self,
            piece: usize,
            flows: &([R; 3],),
            frozen: &([R; 0],),
            t: R,
            z: &mut [R; 2],
            s: &mut (),
        ) {
            let q = z;
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let (
                        prepared_0,
                        q1,
                        prepared_1,
                        q0,
                        prepared_2,
                        v0,
                        v1,
                        v2,
                        v3,
                        v4,
                        v5,
                    );
                    prepared_0 = prepared[0];
                    q1 = q[1];
                    prepared_1 = prepared[1];
                    q0 = q[0];
                    prepared_2 = prepared[2];
                    v0 = prepared_0 * q1;
                    v1 = prepared_1.multiply_add(q0, v0);
                    v2 = q0 + v1;
                    v3 = prepared_2 * q0;
                    v4 = prepared_1.multiply_add(q1, v3);
                    v5 = q1 + v4;
                    q[0] = v2;
                    q[1] = v5;
                }
                _ => {}
            }
        }
        #[inline(always)]
        fn increments(
            &self,
            piece: usize,
            flows: &([R; 3],),
            frozen: &([R; 0],),
            t: R,
            x: &PerCoordinate<[R; 2], ()>,
        ) -> PerCoordinate<[R; 2], ()> {
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let PerCoordinate { z: q, s } = x;
                    let mut d: PerCoordinate<[R; 2], ()> = PerCoordinate::nothing();
                    let (prepared_0, q1, prepared_1, q0, prepared_2, v0, v1, v2, v3);
                    prepared_0 = prepared[0];
                    q1 = q[1];
                    prepared_1 = prepared[1];
                    q0 = q[0];
                    prepared_2 = prepared[2];
                    v0 = prepared_0 * q1;
                    v1 = prepared_1.multiply_add(q0, v0);
                    v2 = prepared_2 * q0;
                    v3 = prepared_1.multiply_add(q1, v2);
                    d.z[0] = v1;
                    d.z[1] = v3;
                    d
                }
                _ => PerCoordinate::nothing(),
            }
        }
    }
    impl<R: Real> FlowPieces<PlanarDiscreteGradient, R> for Turning<R> {
        const PIECES: &'static [FlowPiece] = &[
            FlowPiece {
                name: "x[0], x[1]",
                clock: PieceClock::Own,
                solved: true,
                may_end: true,
            },
        ];
        const SYMPLECTIC: bool = false;
        const CONSERVES_ENERGY: bool = true;
        type Proof = ();
        type Flows = ([R; 2],);
        type Frozen = ([R; 0],);
        #[inline]
        fn prepare_flows(&self, outer: R, last: R) -> ([R; 2],) {
            (
                {
                    let h = last;
                    let (k0, a0, v0, v1, v2);
                    k0 = R::from_f64(0.5);
                    a0 = self.w;
                    v0 = k0 * a0;
                    v1 = v0 * h;
                    v2 = -v1;
                    [v2, v1]
                },
            )
        }
        #[inline(always)]
        fn freeze(&self, flows: &([R; 2],), t: R) -> ([R; 0],) {
            (
                {
                    let prepared = &flows.0;
                    []
                },
            )
        }
        #[inline(always)]
        fn flow(
            &self,
            piece: usize,
            flows: &([R; 2],),
            frozen: &([R; 0],),
            t: R,
            z: &mut [R; 2],
            s: &mut (),
        ) {
            let q = z;
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let step = planar_step(
                        [q[0], q[1]],
                        |increment: &[R; 2]| -> ([R; 2], [[R; 2]; 2]) {
                            let (
                                k0,
                                q1,
                                dq1,
                                prepared_0,
                                q0,
                                dq0,
                                prepared_1,
                                k7,
                                v0,
                                v1,
                                v2,
                                v3,
                            );
                            k0 = R::from_f64(2.0);
                            q1 = q[1];
                            dq1 = increment[1];
                            prepared_0 = prepared[0];
                            q0 = q[0];
                            dq0 = increment[0];
                            prepared_1 = prepared[1];
                            k7 = R::from_f64(1.0);
                            v0 = k0.multiply_add(q1, dq1);
                            v1 = prepared_0 * v0;
                            v2 = k0.multiply_add(q0, dq0);
                            v3 = prepared_1 * v2;
                            ([v1, v3], [[k7, prepared_1], [prepared_0, k7]])
                        },
                    );
                    q[0] = q[0] + step[0];
                    q[1] = q[1] + step[1];
                }
                _ => {}
            }
        }
        #[inline(always)]
        fn increments(
            &self,
            piece: usize,
            flows: &([R; 2],),
            frozen: &([R; 0],),
            t: R,
            x: &PerCoordinate<[R; 2], ()>,
        ) -> PerCoordinate<[R; 2], ()> {
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let PerCoordinate { z: q, s } = x;
                    let mut d: PerCoordinate<[R; 2], ()> = PerCoordinate::nothing();
                    let step = planar_step(
                        [q[0], q[1]],
                        |increment: &[R; 2]| -> ([R; 2], [[R; 2]; 2]) {
                            let (
                                k0,
                                q1,
                                dq1,
                                prepared_0,
                                q0,
                                dq0,
                                prepared_1,
                                k7,
                                v0,
                                v1,
                                v2,
                                v3,
                            );
                            k0 = R::from_f64(2.0);
                            q1 = q[1];
                            dq1 = increment[1];
                            prepared_0 = prepared[0];
                            q0 = q[0];
                            dq0 = increment[0];
                            prepared_1 = prepared[1];
                            k7 = R::from_f64(1.0);
                            v0 = k0.multiply_add(q1, dq1);
                            v1 = prepared_0 * v0;
                            v2 = k0.multiply_add(q0, dq0);
                            v3 = prepared_1 * v2;
                            ([v1, v3], [[k7, prepared_1], [prepared_0, k7]])
                        },
                    );
                    d.z[0] = d.z[0] + step[0];
                    d.z[1] = d.z[1] + step[1];
                    d
                }
                _ => PerCoordinate::nothing(),
            }
        }
    }
    impl<R: Real> FlowPieces<PlanarItohAbe, R> for Turning<R> {
        const PIECES: &'static [FlowPiece] = &[
            FlowPiece {
                name: "x[0], x[1]",
                clock: PieceClock::Own,
                solved: true,
                may_end: true,
            },
            FlowPiece {
                name: "x[0], x[1]",
                clock: PieceClock::Own,
                solved: true,
                may_end: true,
            },
        ];
        const SYMPLECTIC: bool = false;
        const CONSERVES_ENERGY: bool = true;
        type Proof = ();
        type Flows = ([R; 2], [R; 2]);
        type Frozen = ([R; 0], [R; 0]);
        #[inline]
        fn prepare_flows(&self, outer: R, last: R) -> ([R; 2], [R; 2]) {
            (
                {
                    let h = outer;
                    let (k0, a0, v0, v1, v2);
                    k0 = R::from_f64(0.5);
                    a0 = self.w;
                    v0 = k0 * a0;
                    v1 = v0 * h;
                    v2 = -v1;
                    [v2, v1]
                },
                {
                    let h = last;
                    let (k0, a0, v0, v1, v2);
                    k0 = R::from_f64(0.5);
                    a0 = self.w;
                    v0 = k0 * a0;
                    v1 = v0 * h;
                    v2 = -v1;
                    [v2, v1]
                },
            )
        }
        #[inline(always)]
        fn freeze(&self, flows: &([R; 2], [R; 2]), t: R) -> ([R; 0], [R; 0]) {
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
            flows: &([R; 2], [R; 2]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            z: &mut [R; 2],
            s: &mut (),
        ) {
            let q = z;
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let step = planar_step(
                        [q[0], q[1]],
                        |increment: &[R; 2]| -> ([R; 2], [[R; 2]; 2]) {
                            let (
                                k0,
                                q1,
                                dq1,
                                prepared_0,
                                q0,
                                dq0,
                                prepared_1,
                                k7,
                                v0,
                                v1,
                                v2,
                                v3,
                            );
                            k0 = R::from_f64(2.0);
                            q1 = q[1];
                            dq1 = increment[1];
                            prepared_0 = prepared[0];
                            q0 = q[0];
                            dq0 = increment[0];
                            prepared_1 = prepared[1];
                            k7 = R::from_f64(1.0);
                            v0 = k0.multiply_add(q1, dq1);
                            v1 = prepared_0 * v0;
                            v2 = k0.multiply_add(q0, dq0);
                            v3 = prepared_1 * v2;
                            ([v1, v3], [[k7, prepared_1], [prepared_0, k7]])
                        },
                    );
                    q[0] = q[0] + step[0];
                    q[1] = q[1] + step[1];
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let step = planar_step(
                        [q[0], q[1]],
                        |increment: &[R; 2]| -> ([R; 2], [[R; 2]; 2]) {
                            let (
                                k0,
                                q1,
                                dq1,
                                prepared_0,
                                q0,
                                dq0,
                                prepared_1,
                                k7,
                                v0,
                                v1,
                                v2,
                                v3,
                            );
                            k0 = R::from_f64(2.0);
                            q1 = q[1];
                            dq1 = increment[1];
                            prepared_0 = prepared[0];
                            q0 = q[0];
                            dq0 = increment[0];
                            prepared_1 = prepared[1];
                            k7 = R::from_f64(1.0);
                            v0 = k0.multiply_add(q1, dq1);
                            v1 = prepared_0 * v0;
                            v2 = k0.multiply_add(q0, dq0);
                            v3 = prepared_1 * v2;
                            ([v1, v3], [[k7, prepared_1], [prepared_0, k7]])
                        },
                    );
                    q[0] = q[0] + step[0];
                    q[1] = q[1] + step[1];
                }
                _ => {}
            }
        }
        #[inline(always)]
        fn increments(
            &self,
            piece: usize,
            flows: &([R; 2], [R; 2]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            x: &PerCoordinate<[R; 2], ()>,
        ) -> PerCoordinate<[R; 2], ()> {
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let PerCoordinate { z: q, s } = x;
                    let mut d: PerCoordinate<[R; 2], ()> = PerCoordinate::nothing();
                    let step = planar_step(
                        [q[0], q[1]],
                        |increment: &[R; 2]| -> ([R; 2], [[R; 2]; 2]) {
                            let (
                                k0,
                                q1,
                                dq1,
                                prepared_0,
                                q0,
                                dq0,
                                prepared_1,
                                k7,
                                v0,
                                v1,
                                v2,
                                v3,
                            );
                            k0 = R::from_f64(2.0);
                            q1 = q[1];
                            dq1 = increment[1];
                            prepared_0 = prepared[0];
                            q0 = q[0];
                            dq0 = increment[0];
                            prepared_1 = prepared[1];
                            k7 = R::from_f64(1.0);
                            v0 = k0.multiply_add(q1, dq1);
                            v1 = prepared_0 * v0;
                            v2 = k0.multiply_add(q0, dq0);
                            v3 = prepared_1 * v2;
                            ([v1, v3], [[k7, prepared_1], [prepared_0, k7]])
                        },
                    );
                    d.z[0] = d.z[0] + step[0];
                    d.z[1] = d.z[1] + step[1];
                    d
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let PerCoordinate { z: q, s } = x;
                    let mut d: PerCoordinate<[R; 2], ()> = PerCoordinate::nothing();
                    let step = planar_step(
                        [q[0], q[1]],
                        |increment: &[R; 2]| -> ([R; 2], [[R; 2]; 2]) {
                            let (
                                k0,
                                q1,
                                dq1,
                                prepared_0,
                                q0,
                                dq0,
                                prepared_1,
                                k7,
                                v0,
                                v1,
                                v2,
                                v3,
                            );
                            k0 = R::from_f64(2.0);
                            q1 = q[1];
                            dq1 = increment[1];
                            prepared_0 = prepared[0];
                            q0 = q[0];
                            dq0 = increment[0];
                            prepared_1 = prepared[1];
                            k7 = R::from_f64(1.0);
                            v0 = k0.multiply_add(q1, dq1);
                            v1 = prepared_0 * v0;
                            v2 = k0.multiply_add(q0, dq0);
                            v3 = prepared_1 * v2;
                            ([v1, v3], [[k7, prepared_1], [prepared_0, k7]])
                        },
                    );
                    d.z[0] = d.z[0] + step[0];
                    d.z[1] = d.z[1] + step[1];
                    d
                }
                _ => PerCoordinate::nothing(),
            }
        }
    }
    impl<R: Real> Graded<R> for Turning<R> {
        type Proof = ();
        type Gradient = ByTree;
        type Kept = KeptIntegrals;
        const STEEP: bool = false;
    }
    impl<R: Real> DiscreteField<R> for Turning<R> {
        type Proof = ();
        type Parameters = [R; 6];
        type Start = [R; 4];
        type Inverse = ();
        const MEAN: Mean = Mean::NotClosed;
        #[inline]
        fn parameters(&self, h: R) -> [R; 6] {
            let (a0, k1, v0, v1, v2, v3);
            a0 = self.w;
            k1 = R::from_f64(0.5);
            v0 = -a0;
            v1 = k1 * a0;
            v2 = -v1;
            v3 = -h;
            [v0, a0, v1, v2, h, v3]
        }
        #[inline(always)]
        fn begin(
            &self,
            prepared: &[R; 6],
            Span { start, middle: t, end }: Span<R>,
            y: &[R; 2],
        ) -> [R; 4] {
            let (k0, q0, q1, v0, v1);
            k0 = R::from_f64(2.0);
            q0 = y[0];
            q1 = y[1];
            v0 = k0 * q0;
            v1 = k0 * q1;
            [q1, v0, v1, q0]
        }
        #[inline(always)]
        fn slope(
            &self,
            prepared: &[R; 6],
            start: &[R; 4],
            d: &[R; 2],
            f: &mut [R; 2],
            jacobian: &mut Square<[R; 2]>,
        ) {
            let (
                k0,
                dq1,
                start_0,
                start_1,
                dq0,
                start_2,
                prepared_1,
                start_3,
                prepared_0,
                prepared_2,
                prepared_3,
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
                v39,
                v40,
                v41,
            );
            k0 = R::from_f64(0.5);
            dq1 = d[1];
            start_0 = start[0];
            start_1 = start[1];
            dq0 = d[0];
            start_2 = start[2];
            prepared_1 = prepared[1];
            start_3 = start[3];
            prepared_0 = prepared[0];
            prepared_2 = prepared[2];
            prepared_3 = prepared[3];
            v0 = k0.multiply_add(dq1, start_0);
            v1 = start_1 + dq0;
            v2 = v1.abs();
            v3 = start_2 + dq1;
            v4 = v3.abs();
            v5 = v2 + v4;
            v6 = slope::scaled(v1, v5);
            v7 = v6 * v6;
            v8 = slope::scaled(v3, v5);
            v9 = v8 * v8;
            v10 = v7 + v9;
            v11 = slope::recip_above(v10, v10);
            v12 = prepared_1 * v0;
            v13 = k0.multiply_add(dq0, start_3);
            v14 = prepared_1 * v13;
            v15 = v14 * v8;
            v16 = -v12;
            v17 = v16.multiply_add(v6, v15);
            v18 = v17 * v11;
            v19 = prepared_0 * v0;
            v20 = -v6;
            v21 = v20.multiply_add(v18, v19);
            v22 = -v8;
            v23 = v22.multiply_add(v18, v14);
            v24 = slope::scaled(v18, v5);
            v25 = -v21;
            v26 = slope::scaled(v25, v5);
            v27 = prepared_2 * v8;
            v28 = v20.multiply_add(v24, v27);
            v29 = v28 - v26;
            v30 = v11 * v29;
            v31 = -v24;
            v32 = v20.multiply_add(v30, v31);
            v33 = -v23;
            v34 = slope::scaled(v33, v5);
            v35 = prepared_3 * v6;
            v36 = v22.multiply_add(v24, v35);
            v37 = v36 - v34;
            v38 = v11 * v37;
            v39 = v20.multiply_add(v38, prepared_3);
            v40 = v22.multiply_add(v30, prepared_2);
            v41 = v22.multiply_add(v38, v31);
            f[0] = v21;
            f[1] = v23;
            jacobian[0][0] = v32;
            jacobian[0][1] = v39;
            jacobian[1][0] = v40;
            jacobian[1][1] = v41;
        }
        #[inline(always)]
        fn equation(
            &self,
            _: (&Self::Constants, R),
            prepared: &[R; 6],
            start: &[R; 4],
            d: &[R; 2],
            image: &mut [R; 2],
            matrix: &mut Square<[R; 2]>,
        ) {
            let (
                k0,
                dq1,
                start_0,
                start_1,
                dq0,
                start_2,
                prepared_1,
                start_3,
                prepared_0,
                prepared_4,
                prepared_2,
                prepared_5,
                k12,
                prepared_3,
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
                v39,
                v40,
                v41,
                v42,
                v43,
                v44,
                v45,
                v46,
                v47,
            );
            k0 = R::from_f64(0.5);
            dq1 = d[1];
            start_0 = start[0];
            start_1 = start[1];
            dq0 = d[0];
            start_2 = start[2];
            prepared_1 = prepared[1];
            start_3 = start[3];
            prepared_0 = prepared[0];
            prepared_4 = prepared[4];
            prepared_2 = prepared[2];
            prepared_5 = prepared[5];
            k12 = R::from_f64(1.0);
            prepared_3 = prepared[3];
            v0 = k0.multiply_add(dq1, start_0);
            v1 = start_1 + dq0;
            v2 = v1.abs();
            v3 = start_2 + dq1;
            v4 = v3.abs();
            v5 = v2 + v4;
            v6 = slope::scaled(v1, v5);
            v7 = v6 * v6;
            v8 = slope::scaled(v3, v5);
            v9 = v8 * v8;
            v10 = v7 + v9;
            v11 = slope::recip_above(v10, v10);
            v12 = prepared_1 * v0;
            v13 = k0.multiply_add(dq0, start_3);
            v14 = prepared_1 * v13;
            v15 = v14 * v8;
            v16 = -v12;
            v17 = v16.multiply_add(v6, v15);
            v18 = v17 * v11;
            v19 = prepared_0 * v0;
            v20 = -v6;
            v21 = v20.multiply_add(v18, v19);
            v22 = prepared_4 * v21;
            v23 = -v8;
            v24 = v23.multiply_add(v18, v14);
            v25 = prepared_4 * v24;
            v26 = slope::scaled(v18, v5);
            v27 = -v21;
            v28 = slope::scaled(v27, v5);
            v29 = prepared_2 * v8;
            v30 = v20.multiply_add(v26, v29);
            v31 = v30 - v28;
            v32 = v11 * v31;
            v33 = -v26;
            v34 = v20.multiply_add(v32, v33);
            v35 = prepared_5.multiply_add(v34, k12);
            v36 = -v24;
            v37 = slope::scaled(v36, v5);
            v38 = prepared_3 * v6;
            v39 = v23.multiply_add(v26, v38);
            v40 = v39 - v37;
            v41 = v11 * v40;
            v42 = v20.multiply_add(v41, prepared_3);
            v43 = prepared_5 * v42;
            v44 = v23.multiply_add(v32, prepared_2);
            v45 = prepared_5 * v44;
            v46 = v23.multiply_add(v41, v33);
            v47 = prepared_5.multiply_add(v46, k12);
            image[0] = v22;
            image[1] = v25;
            matrix[0][0] = v35;
            matrix[0][1] = v43;
            matrix[1][0] = v45;
            matrix[1][1] = v47;
        }
        #[inline(always)]
        fn drift(&self, prepared: &[R; 6], sum: &[R; 2]) -> [R; 2] {
            let mut drift = <[R; 2] as Array>::zero();
            drift
        }
    }
    impl<R: Real> FourthOrderField<R> for Turning<R> {
        type Proof = ();
        type FourthParameters = [R; 12];
        type FourthStart = [R; 8];
        #[inline]
        fn fourth_parameters(&self, h: R) -> [R; 12] {
            let (
                k0,
                a0,
                k2,
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
            );
            k0 = R::from_f64(0.16666666666666666);
            a0 = self.w;
            k2 = R::from_f64(0.6666666666666666);
            k3 = R::from_f64(0.125);
            k4 = R::from_f64(0.08333333333333333);
            k5 = R::from_f64(0.5);
            v0 = k0 * a0;
            v1 = -v0;
            v2 = k2 * a0;
            v3 = -v2;
            v4 = k3 * h;
            v5 = -a0;
            v6 = -h;
            v7 = a0 * a0;
            v8 = k4 * h;
            v9 = v8 * v7;
            v10 = k5 * a0;
            v11 = -v10;
            [h, v1, v3, v4, v5, v0, v2, a0, v6, v9, v10, v11]
        }
        #[inline(always)]
        fn fourth_begin(
            &self,
            prepared: &[R; 12],
            Span { start, middle: t, end }: Span<R>,
            y: &[R; 2],
        ) -> [R; 8] {
            let (
                prepared_1,
                q1,
                prepared_7,
                q0,
                k4,
                prepared_5,
                prepared_4,
                v0,
                v1,
                v2,
                v3,
                v4,
                v5,
            );
            prepared_1 = prepared[1];
            q1 = y[1];
            prepared_7 = prepared[7];
            q0 = y[0];
            k4 = R::from_f64(2.0);
            prepared_5 = prepared[5];
            prepared_4 = prepared[4];
            v0 = prepared_1 * q1;
            v1 = prepared_7 * q0;
            v2 = k4 * q0;
            v3 = k4 * q1;
            v4 = prepared_5 * q0;
            v5 = prepared_4 * q1;
            [v0, q1, v1, q0, v2, v3, v4, v5]
        }
        #[inline(always)]
        fn fourth_slope<const NEARLY: bool>(
            &self,
            prepared: &[R; 12],
            start: &[R; 8],
            d: &[R; 2],
            image: &mut [R; 2],
            matrix: &mut Square<[R; 2]>,
        ) {
            let (
                start_1,
                dq1,
                start_3,
                dq0,
                prepared_4,
                start_2,
                k6,
                prepared_3,
                start_4,
                start_5,
                prepared_1,
                start_0,
                prepared_2,
                prepared_7,
                start_7,
                prepared_5,
                start_6,
                prepared_6,
                prepared_0,
                prepared_9,
                prepared_10,
                prepared_8,
                k22,
                prepared_11,
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
                v50,
                v51,
                v52,
                v53,
            );
            start_1 = start[1];
            dq1 = d[1];
            start_3 = start[3];
            dq0 = d[0];
            prepared_4 = prepared[4];
            start_2 = start[2];
            k6 = R::from_f64(0.5);
            prepared_3 = prepared[3];
            start_4 = start[4];
            start_5 = start[5];
            prepared_1 = prepared[1];
            start_0 = start[0];
            prepared_2 = prepared[2];
            prepared_7 = prepared[7];
            start_7 = start[7];
            prepared_5 = prepared[5];
            start_6 = start[6];
            prepared_6 = prepared[6];
            prepared_0 = prepared[0];
            prepared_9 = prepared[9];
            prepared_10 = prepared[10];
            prepared_8 = prepared[8];
            k22 = R::from_f64(1.0);
            prepared_11 = prepared[11];
            v0 = start_1 + dq1;
            v1 = start_3 + dq0;
            v2 = prepared_4.multiply_add(v1, start_2);
            v3 = k6.multiply_add(dq1, start_1);
            v4 = prepared_3.multiply_add(v2, v3);
            v5 = start_4 + dq0;
            v6 = v5.abs();
            v7 = start_5 + dq1;
            v8 = v7.abs();
            v9 = v6 + v8;
            v10 = slope::scaled(v5, v9);
            v11 = v10 * v10;
            v12 = slope::scaled(v7, v9);
            v13 = v12 * v12;
            v14 = v11 + v13;
            v15 = slope::recip_above(v14, v14);
            v16 = prepared_1.multiply_add(v0, start_0);
            v17 = prepared_2.multiply_add(v4, v16);
            v18 = prepared_7.multiply_add(v0, start_7);
            v19 = k6.multiply_add(dq0, start_3);
            v20 = prepared_3.multiply_add(v18, v19);
            v21 = prepared_5.multiply_add(v1, start_6);
            v22 = prepared_6.multiply_add(v20, v21);
            v23 = v17 * v10;
            v24 = v22.multiply_add(v12, v23);
            v25 = v24 * v15;
            v26 = -v10;
            v27 = v26.multiply_add(v25, v17);
            v28 = prepared_0 * v27;
            v29 = -v12;
            v30 = v29.multiply_add(v25, v22);
            v31 = prepared_0 * v30;
            v32 = slope::scaled(v25, v9);
            v33 = -v27;
            v34 = slope::scaled(v33, v9);
            v35 = prepared_9 - v32;
            v36 = prepared_10 * v12;
            v37 = v36 - v34;
            v38 = v10.multiply_add(v35, v37);
            v39 = v15 * v38;
            v40 = v26.multiply_add(v39, v35);
            v41 = prepared_8.multiply_add(v40, k22);
            v42 = -v30;
            v43 = slope::scaled(v42, v9);
            v44 = prepared_11 * v10;
            v45 = v44 - v43;
            v46 = v12.multiply_add(v35, v45);
            v47 = v15 * v46;
            v48 = v26.multiply_add(v47, prepared_11);
            v49 = prepared_8 * v48;
            v50 = v29.multiply_add(v39, prepared_10);
            v51 = prepared_8 * v50;
            v52 = v29.multiply_add(v47, v35);
            v53 = prepared_8.multiply_add(v52, k22);
            image[0] = v28;
            image[1] = v31;
            matrix[0][0] = v41;
            matrix[0][1] = v49;
            matrix[1][0] = v51;
            matrix[1][1] = v53;
        }
    }
    impl<R: Real> Collocated<R> for Turning<R> {
        type Proof = ();
        type Stages = ByField;
    }
    impl<R: Real> Collocation<R> for Turning<R> {
        type Proof = ();
        type Unknown = [R; 2];
        type Constants = [R; 2];
        const DERIVATIVE: usize = 1;
        #[inline]
        fn constants(&self) -> [R; 2] {
            let (a0, v0);
            a0 = self.w;
            v0 = -a0;
            [v0, a0]
        }
        #[inline(always)]
        fn start(z: &[R; 2]) -> ([R; 2], [R; 2]) {
            (*z, *z)
        }
        #[inline(always)]
        fn velocity(&self, prepared: &[R; 2], p: &[R; 2]) -> [R; 2] {
            let mut velocity = <[R; 2] as Array>::zero();
            velocity
        }
        #[inline(always)]
        fn field(
            &self,
            prepared: &[R; 2],
            t: R,
            y: &[R; 2],
            f: &mut [R; 2],
            jacobian: &mut Square<[R; 2]>,
        ) {
            let (prepared_0, q1, prepared_1, q0, k4, v0, v1);
            prepared_0 = prepared[0];
            q1 = y[1];
            prepared_1 = prepared[1];
            q0 = y[0];
            k4 = R::from_f64(0.0);
            v0 = prepared_0 * q1;
            v1 = prepared_1 * q0;
            f[0] = v0;
            f[1] = v1;
            jacobian[0][0] = k4;
            jacobian[0][1] = prepared_0;
            jacobian[1][0] = prepared_1;
            jacobian[1][1] = k4;
        }
        #[inline(always)]
        fn add(&self, prepared: &[R; 2], w: R, f: &[R; 2], y: &mut [R; 2]) {
            y[0] = w.multiply_add(f[0], y[0]);
            y[1] = w.multiply_add(f[1], y[1]);
        }
        #[inline(always)]
        fn increments(change: &[R; 2], impulse: &[R; 2]) -> [R; 2] {
            *change
        }
    }
    impl<R: Real> Jets<R> for Turning<R> {
        type Proof = ();
        type Switches = [R; 0];
        type Over<T: Real> = FlowState<[T; 2]>;
        const CONVOLUTIONS: usize = 0;
        #[inline]
        fn jet<const P: usize>(
            &self,
            unit: R,
            t: R,
            z: &[R; 2],
            _: &(),
            jet: &mut [PerCoordinate<[R; 2], ()>; P],
            switches: &mut [[R; 0]; P],
        ) {
            struct Coefficients<'a, R: Real, const P: usize> {
                k: [R; 3],
                coordinates: [R; 2],
                masks: [R::Mask; 0],
                u2: &'a mut [R; P],
                u3: &'a mut [R; P],
                jet: &'a mut [PerCoordinate<[R; 2], ()>; P],
                switches: &'a mut [[R; 0]; P],
            }
            impl<R: Real, const P: usize> recurrence::Series for Coefficients<'_, R, P> {
                #[inline(always)]
                fn order(&mut self, n: usize) {
                    let Self { k, coordinates, masks, u2, u3, jet, switches } = self;
                    let (whole, next) = (
                        recurrence::whole::<R>(n),
                        k[0] * recurrence::inverse::<R>(n + 1),
                    );
                    let (c2, c0, c3, c1);
                    c2 = coordinates[1];
                    c0 = k[1] * c2;
                    c3 = coordinates[0];
                    c1 = k[2] * c3;
                    jet[n].z[0] = (next) * k[1] * c2;
                    coordinates[0] = jet[n].z[0];
                    if n + 1 < P {
                        u3[n + 1] = jet[n].z[0];
                    }
                    jet[n].z[1] = (next) * k[2] * c3;
                    coordinates[1] = jet[n].z[1];
                    if n + 1 < P {
                        u2[n + 1] = jet[n].z[1];
                    }
                }
            }
            let q = z;
            let (q1, a0, q0, v0, v1, v2, v3);
            q1 = q[1];
            a0 = self.w;
            q0 = q[0];
            v0 = q1 * a0;
            v1 = -v0;
            v2 = q0 * a0;
            v3 = -a0;
            let (u2, u3) = (&mut [R::from_f64(0.0); P], &mut [R::from_f64(0.0); P]);
            u2[0] = q1;
            u3[0] = q0;
            jet[0].z[0] = unit * (v1);
            if P > 1 {
                u3[1] = jet[0].z[0];
            }
            jet[0].z[1] = unit * (v2);
            if P > 1 {
                u2[1] = jet[0].z[1];
            }
            recurrence::orders::<
                31,
                P,
            >(
                &mut Coefficients {
                    k: [unit, v3, a0],
                    coordinates: [jet[0].z[0], jet[0].z[1]],
                    masks: [],
                    u2,
                    u3,
                    jet,
                    switches,
                },
            );
        }
    }
    impl Turning {
        /// This system by Taylor series of its solution, from `state` on.
        ///
        /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
        pub fn taylor<M: TaylorMethod<Self, f64>>(
            self,
            method: M,
            state: FlowState<[f64; 2]>,
        ) -> TaylorIntegrator<Self, M, f64> {
            TaylorIntegrator::new(self, method, state)
        }
    }
};
