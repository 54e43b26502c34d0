//! An expansion without its implementations of these traits:
//!
//! - ConformalContact
//! - CotangentSpace
//! - SteppedAs
//! - Separable
//! - QuadraticKinetic
//! - ForceGradient
//! - MechanicalContact
//! - SteppedAs
//! - ModifiedEnergy
//! - ContactEquation
//! - ImplicitMethod
//! - ContactStages
//! - Jets

/// A pendulum with friction.
fn damped(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 - q.cos() + gamma * s
}
#[allow(clippy::derive_partial_eq_without_eq, reason = "generated code")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
/// A pendulum with friction.
/**
# What was derived

```text
H = p²/2 - cos(q) + s·gamma

Structure
- ∂H/∂s = gamma, and H' = −H ∂H/∂s
- |H|^−2 is the density of an invariant measure where H ≠ 0
- positions and momenta move without s: `without_action` leaves it out
- T + g·s + V with quadratic T: kick and drift exist, and all tables have their order

Decaying by the factor e^(−(gamma)·t), all alike, so that quotients are constant
- H: it does not read time
`ContactDiscreteGradient` multiplies H by what its equation says, to rounding

Pieces with flows in closed form, in the order of half a step
- p²/2 + s·gamma
  damped drift: p·Wp/2 + g s, g constant or k/(t₀ + t) (M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206)
  exact in time; sums and products 5, functions 2
- -cos(q)
  prolongation: p·a(q, s) + b(q, s) (P. G. Kevrekidis, arXiv:2605.09103 (2026))
  exact in time; sums and products 4, functions 2

Implicit steps, for the increments of all positions, momenta and the action
- `ContactMidpoint`, unknowns 3: sums and products 20, functions 2 an iteration
- `ContactDiscreteGradient`, unknowns 3: sums and products 25, functions 4 an iteration
- `ContactGauss`, unknowns 2 a stage: sums and products 2, functions 2 a stage of an iteration: s follows, and friction costs nothing beside `Gauss`
```*/
struct Damped<R = f64> {
    ///The parameter `gamma` of the energy.
    pub gamma: R,
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
        let _ = damped;
    };
    impl Damped {
        /// What was derived from the energy: derivatives or pieces, structure, what is conserved, operations, and what is
        /// skipped and why.
        pub const REPORT: &'static str = "H = p²/2 - cos(q) + s·gamma\n\nStructure\n- ∂H/∂s = gamma, and H' = −H ∂H/∂s\n- |H|^−2 is the density of an invariant measure where H ≠ 0\n- positions and momenta move without s: `without_action` leaves it out\n- T + g·s + V with quadratic T: kick and drift exist, and all tables have their order\n\nDecaying by the factor e^(−(gamma)·t), all alike, so that quotients are constant\n- H: it does not read time\n`ContactDiscreteGradient` multiplies H by what its equation says, to rounding\n\nPieces with flows in closed form, in the order of half a step\n- p²/2 + s·gamma\n  damped drift: p·Wp/2 + g s, g constant or k/(t₀ + t) (M. Vermeeren, A. Bravetti & M. Seri, J. Phys. A 52 (2019) 445206)\n  exact in time; sums and products 5, functions 2\n- -cos(q)\n  prolongation: p·a(q, s) + b(q, s) (P. G. Kevrekidis, arXiv:2605.09103 (2026))\n  exact in time; sums and products 4, functions 2\n\nImplicit steps, for the increments of all positions, momenta and the action\n- `ContactMidpoint`, unknowns 3: sums and products 20, functions 2 an iteration\n- `ContactDiscreteGradient`, unknowns 3: sums and products 25, functions 4 an iteration\n- `ContactGauss`, unknowns 2 a stage: sums and products 2, functions 2 a stage of an iteration: s follows, and friction costs nothing beside `Gauss`\n";
        /// The energy of a state.
        pub fn energy(&self, state: &ContactState<f64>) -> f64 {
            PhaseSpace::energy(self, state)
        }
        /// Returns an `Integrator` of this system under a method, with step size `h` (negative to go back in time), from `state` on.
        ///
        /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
        pub fn integrator<M: Method<Self, f64, Proof = P>, P>(
            self,
            method: M,
            h: f64,
            state: ContactState<f64>,
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
            state: ContactState<f64>,
        ) -> Given<P, Adaptive<Self, M, f64>> {
            Adaptive::new(self, method, tolerance, state)
        }
    }
    impl<R: Real> PhaseSpace<R> for Damped<R> {
        type State = ContactState<R>;
        type Phase = [[R; 1]; 2];
        type Action = R;
        #[inline]
        fn hamiltonian(&self, t: R, z: &[[R; 1]; 2], s: &R) -> R {
            let [q, p] = z;
            let (p0, q0, action, a0, k4, v0, v1, v2, v3, v4);
            p0 = p[0];
            q0 = q[0];
            action = *s;
            a0 = self.gamma;
            k4 = R::from_f64(0.5);
            v0 = p0 * p0;
            v1 = q0.cos();
            v2 = action * a0;
            v3 = k4.multiply_add(v0, v2);
            v4 = v3 - v1;
            v4
        }
        fn outside_domain(
            &self,
            t: R,
            z: &[[R; 1]; 2],
            s: &R,
        ) -> ::core::option::Option<&'static str> {
            let [q, p] = z;
            ::core::option::Option::None
        }
        fn invalid_parameter(&self) -> ::core::option::Option<&'static str> {
            if self.gamma != self.gamma {
                return ::core::option::Option::Some("gamma");
            }
            ::core::option::Option::None
        }
    }
    impl<R: Real> ContactSystem<R> for Damped<R> {
        type Proof = ();
        #[inline]
        fn gradient(
            &self,
            t: R,
            z: &[[R; 1]; 2],
            s: &R,
            slopes: &mut [[R; 1]; 2],
            ds: &mut R,
        ) {
            let [q, p] = z;
            let (q0, p0, a0, v0);
            q0 = q[0];
            p0 = p[0];
            a0 = self.gamma;
            v0 = q0.sin();
            slopes[0][0] = v0;
            slopes[1][0] = p0;
            *ds = a0;
        }
    }
    impl<R: Real> FlowPieces<ContactSplitting, R> for Damped<R> {
        const PIECES: &'static [FlowPiece] = &[
            FlowPiece {
                name: "p²/2 + s·gamma",
                clock: PieceClock::Own,
                solved: false,
                may_end: false,
            },
            FlowPiece {
                name: "-cos(q)",
                clock: PieceClock::Own,
                solved: false,
                may_end: false,
            },
        ];
        const SYMPLECTIC: bool = true;
        const CONSERVES_ENERGY: bool = false;
        type Proof = ();
        type Flows = ([R; 4], [R; 2]);
        type Frozen = ([R; 0], [R; 0]);
        #[inline]
        fn prepare_flows(&self, outer: R, last: R) -> ([R; 4], [R; 2]) {
            (
                {
                    let h = outer;
                    let (a0, k1, v0, v1, v2, v3, v4, v5, v6, v7, v8);
                    a0 = self.gamma;
                    k1 = R::from_f64(0.5);
                    v0 = a0 * h;
                    v1 = -v0;
                    v2 = slope::phi_1(v1);
                    v3 = h * v2;
                    v4 = v0 * v2;
                    v5 = -v4;
                    v6 = slope::rest(v1, v5);
                    v7 = k1 * h;
                    v8 = v7 * v2;
                    [v3, v6, v5, v8]
                },
                {
                    let h = last;
                    let (v0,);
                    v0 = -h;
                    [v0, h]
                },
            )
        }
        #[inline(always)]
        fn freeze(&self, flows: &([R; 4], [R; 2]), t: R) -> ([R; 0], [R; 0]) {
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
            flows: &([R; 4], [R; 2]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            z: &mut [[R; 1]; 2],
            s: &mut R,
        ) {
            let [q, p] = z;
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let (
                        prepared_0,
                        p0,
                        q0,
                        prepared_1,
                        prepared_2,
                        prepared_3,
                        action,
                        v0,
                        v1,
                        v2,
                        v3,
                        v4,
                    );
                    prepared_0 = prepared[0];
                    p0 = p[0];
                    q0 = q[0];
                    prepared_1 = prepared[1];
                    prepared_2 = prepared[2];
                    prepared_3 = prepared[3];
                    action = *s;
                    v0 = prepared_0.multiply_add(p0, q0);
                    v1 = slope::grown(p0, prepared_1, prepared_2);
                    v2 = p0 * p0;
                    v3 = prepared_3.multiply_add(v2, action);
                    v4 = slope::grown(v3, prepared_1, prepared_2);
                    q[0] = v0;
                    p[0] = v1;
                    *s = v4;
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let (q0, prepared_0, p0, prepared_1, action, v0, v1, v2, v3);
                    q0 = q[0];
                    prepared_0 = prepared[0];
                    p0 = p[0];
                    prepared_1 = prepared[1];
                    action = *s;
                    (v0, v1) = q0.sin_cos();
                    v2 = prepared_0.multiply_add(v0, p0);
                    v3 = prepared_1.multiply_add(v1, action);
                    p[0] = v2;
                    *s = v3;
                }
                _ => {}
            }
        }
        #[inline(always)]
        fn increments(
            &self,
            piece: usize,
            flows: &([R; 4], [R; 2]),
            frozen: &([R; 0], [R; 0]),
            t: R,
            x: &PerCoordinate<[[R; 1]; 2], R>,
        ) -> PerCoordinate<[[R; 1]; 2], R> {
            match piece {
                0 => {
                    let (prepared, start) = (&flows.0, &frozen.0);
                    let PerCoordinate { z: [q, p], s } = x;
                    let mut d: PerCoordinate<[[R; 1]; 2], R> = PerCoordinate::nothing();
                    let (
                        prepared_0,
                        p0,
                        prepared_2,
                        prepared_3,
                        action,
                        v0,
                        v1,
                        v2,
                        v3,
                        v4,
                        v5,
                    );
                    prepared_0 = prepared[0];
                    p0 = p[0];
                    prepared_2 = prepared[2];
                    prepared_3 = prepared[3];
                    action = *s;
                    v0 = prepared_0 * p0;
                    v1 = prepared_2 * p0;
                    v2 = p0 * p0;
                    v3 = prepared_3.multiply_add(v2, action);
                    v4 = prepared_3 * v2;
                    v5 = prepared_2.multiply_add(v3, v4);
                    d.z[0][0] = v0;
                    d.z[1][0] = v1;
                    d.s = v5;
                    d
                }
                1 => {
                    let (prepared, start) = (&flows.1, &frozen.1);
                    let PerCoordinate { z: [q, p], s } = x;
                    let mut d: PerCoordinate<[[R; 1]; 2], R> = PerCoordinate::nothing();
                    let (q0, prepared_0, prepared_1, v0, v1, v2, v3);
                    q0 = q[0];
                    prepared_0 = prepared[0];
                    prepared_1 = prepared[1];
                    (v0, v1) = q0.sin_cos();
                    v2 = prepared_0 * v0;
                    v3 = prepared_1 * v1;
                    d.z[1][0] = v2;
                    d.s = v3;
                    d
                }
                _ => PerCoordinate::nothing(),
            }
        }
    }
    impl Damped {
        /// H + h²H₂, which steps of length `h` keep, or let decay as the flow of H + h²H₂ does, up to h⁴.
        pub fn modified_energy(&self, h: f64, state: &ContactState<f64>) -> f64 {
            ModifiedEnergy::modified_energy(self, h, state)
        }
    }
    impl Damped {
        /// This system by Taylor series of its solution, from `state` on.
        ///
        /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
        pub fn taylor<M: TaylorMethod<Self, f64>>(
            self,
            method: M,
            state: ContactState<f64>,
        ) -> TaylorIntegrator<Self, M, f64> {
            TaylorIntegrator::new(self, method, state)
        }
    }
};
