//! Planar Itoh–Abe methods: every plane moves by divided differences of the integral in one coordinate at a time.
//!
//! The list of pieces of [`PlanarItohAbe`] contains the pieces of its step in order, then the pieces of the adjoint step in reverse order.

use super::flow::{Flows, apply};
use crate::method::composition::substeps;
use crate::method::{Claims, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::Summation;
use crate::system::{Pieces, Poles};

/// The planar parts of x' = S(x) ∇I in order, i < j, each by divided differences of I in one coordinate:
/// x₁ᵢ − x₀ᵢ = h S_ij I\[x₁ᵢ, (x₀ⱼ, x₁ⱼ)\], x₁ⱼ − x₀ⱼ = −h S_ij I\[(x₀ᵢ, x₁ᵢ), x₀ⱼ\] with S_ij at x₀. Order 1. Keeps I to rounding for every h,
/// other integrals to the order.
///
/// For one degree of freedom, q' = ∂H/∂p, p' = −∂H/∂q, the method equals [`ItohAbe`](crate::ItohAbe), and so does
/// [`CoordinateIncrement`](crate::CoordinateIncrement). Each plane has two unknowns. More than 12 planes are a type error.
///
/// G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanarItohAbe;

/// The adjoint of [`PlanarItohAbe`]: a step of length −h of that method leads from x₁ back to x₀.
///
/// Order 1. Keeps I to rounding for every h.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanarItohAbeAdjoint;

/// [`PlanarItohAbe`] for h/2, then [`PlanarItohAbeAdjoint`] for h/2. Order 2, symmetric. Keeps I to rounding for every h.
///
/// ```
/// use geoint_runtime::methods::*;
/// use geoint_runtime::prelude::*;
///
/// /// The core of Lorenz 1984.
/// #[hamiltonian(structure = |i, j| if i == 0 { -x[j] } else { -b * x[0] })]
/// fn lorenz_core(x: [f64; 3], b: f64) -> f64 {
///     (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0
/// }
///
/// let start = FlowState::new([1.0, 0.5, -0.3]);
/// let mut sim = LorenzCore { b: 4.0 }.integrator(PlanarItohAbePair, 0.05, start);
/// let energy = sim.energy();
/// sim.advance(1000)?;
/// assert!((sim.energy() - energy).abs() < 1e-13);
/// # Ok::<(), StepError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanarItohAbePair;

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F, R> {
    flows: F,
    /// h/2, the time after the start of the step at which frozen functions of time are evaluated.
    half: R,
    poles: Poles,
}

macro_rules! increments {
    ($($method:ident: order $order:literal, symmetric $symmetric:literal, $part:literal of a step in $pieces:expr;)*) => { $(
        impl<S: Pieces<PlanarItohAbe, R>, R: Real> Method<S, R> for $method {
            type Proof = <S as Pieces<PlanarItohAbe, R>>::Proof;
            type Prepared = Prepared<S::Flows, R>;
            type Memory = ();

            fn claims(&self) -> Claims {
                Claims { symmetric: $symmetric, conserves_energy: S::CONSERVES_ENERGY, ..Claims::of_order($order) }
            }

            fn name(&self) -> Name {
                Name::new(stringify!($method))
            }

            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                let part = R::from_f64($part) * h;
                Prepared { flows: system.prepare_flows(part, part), half: R::from_f64(0.5) * h, poles: Poles::of(system) }
            }

            fn memory(_: &S::Phase) {}

            #[inline]
            fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
                Prepared { flows, half, poles }: &Self::Prepared,
                (): &mut (),
                mut step: Step<'_, S, R, C, P>,
            ) -> Result<(), Failure> {
                let (start, pieces) = (step.t, $pieces(S::PIECES.len()));
                let frozen = step.system.freeze(flows, start + *half);
                step.probe.visit(start, &step.x.z, &step.x.s);
                apply::<S, PlanarItohAbe, R, C, P>(pieces, Flows { flows, frozen: &frozen, poles }, step.part([start; 2]))
            }
        }
    )* };
}

increments! {
    PlanarItohAbe: order 1, symmetric false, 1.0 of a step in |all| 0..all / 2;
    PlanarItohAbeAdjoint: order 1, symmetric false, 1.0 of a step in |all| all / 2..all;
    PlanarItohAbePair: order 2, symmetric true, 0.5 of a step in |all| 0..all;
}

substeps!([] PlanarItohAbePair);
