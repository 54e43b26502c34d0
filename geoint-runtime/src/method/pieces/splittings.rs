//! The splittings, by what their pieces are.

/// A splitting, which selects pieces of a system. The attribute macros emit [`Pieces`](crate::system::Pieces) for each one that the system has.
#[doc(alias("operator splitting", "symplectic"))]
pub trait Splitting: Copy + Default {
    /// The name of the method.
    const NAME: &'static str;
}

/// e^(h/2 X₁) … e^(h/2 Xₖ₋₁) e^(h Xₖ) e^(h/2 Xₖ₋₁) … e^(h/2 X₁): the exact flows of the pieces of H(q, p, t), for energies whose terms
/// couple positions and momenta. Order 2, symmetric, symplectic, explicit; the flow of every piece but the last is applied twice a step.
///
/// Pieces are found by themselves: charges in magnetic fields, coupled oscillators, polynomials of degree 4, functions of energies with a
/// known flow; or given by `split = "terms | terms"`. `REPORT` lists them with their rules and what they cost. Of H = T + V they are a
/// drift and a kick, and methods for these serve it. Where the flow of a piece ends within a step, the step is refused with its name.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A charge in a field that grows with x.
/// #[hamiltonian]
/// fn charge(q: [f64; 2], p: [f64; 2], m: f64, b: f64, slope: f64) -> f64 {
///     let [x, _] = q;
///     (p[0] * p[0] + (p[1] - b * (x + slope * x * x / 2.0)).powi(2)) / (2.0 * m)
/// }
///
/// let system = Charge { m: 1.5, b: 2.0, slope: 0.1 };
/// let start = State::new([0.0, 0.0], [0.9, 0.3]);
/// let mut sim = system.integrator(Suzuki4.of(PieceSplitting), 0.05, start);
/// let energy = sim.energy();
/// sim.advance(20_000)?;
/// assert!((sim.energy() / energy - 1.0).abs() < 1e-6);
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias("Boris", "magnetic field"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PieceSplitting;

/// e^(h/2 X₁) … e^(h/2 Xₖ₋₁) e^(h Xₖ) e^(h/2 Xₖ₋₁) … e^(h/2 X₁): the exact flows of the pieces of H, with a kick or else the most
/// expensive flow in the middle. Order 2, symmetric, a contact map; the flow of every piece but the last is applied twice a step.
///
/// Where the flow of a piece ends within a step, as that of H = s² does, the step is refused with the name of the piece.
/// A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7.
#[doc(alias("Strang splitting", "contact integrator"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactSplitting;

/// Exact flows of the terms of H in x' = S(x) ∇H, one after the other and back. Order 2, symmetric, explicit; a Poisson map if the bracket
/// of S is one, so that Casimirs are kept to rounding, and H to the order.
///
/// A term that reads only coordinates in involution, S_ij = 0 for i and j among them, leaves these at rest, and moves the others by single
/// equations or by a linear field: a rotation, a shear, an exponential, a tangent. Terms whose coordinates are all in involution are one
/// piece. Pieces that leave more coordinates at rest come first, then those of smaller index; last those that move what they read, as
/// the pairs of vortices. `REPORT` lists them with their rules. R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A heavy top: angular momentum m and the vertical γ in its own frame.
/// #[hamiltonian(structure = se3)]
/// fn heavy_top(x: [f64; 6], inertia: [f64; 3], r: [f64; 3]) -> f64 {
///     let [m1, m2, m3, g1, g2, g3] = x;
///     (m1 * m1 / inertia[0] + m2 * m2 / inertia[1] + m3 * m3 / inertia[2]) / 2.0 + r[0] * g1 + r[1] * g2 + r[2] * g3
/// }
///
/// let top = HeavyTop { inertia: [2.0, 2.0, 1.0], r: [1.0, 0.0, 0.0] };
/// let start = FlowState::new([0.3, -0.2, 0.5, 0.6, 0.0, 0.8]);
/// let mut sim = top.integrator(Suzuki4.of(PoissonSplitting), 0.05, start);
/// sim.advance(2000)?;
/// let [m1, m2, m3, g1, g2, g3] = sim.state().x;
/// assert!((g1 * g1 + g2 * g2 + g3 * g3 - 1.0).abs() < 1e-13);
/// assert!((m1 * g1 + m2 * g2 + m3 * g3 - 0.58).abs() < 1e-13);
/// assert!((sim.energy() - top.energy(&start)).abs() < 1e-5);
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias = "Lie-Poisson")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PoissonSplitting;

/// The planar parts of x' = S(x) ∇I, one after the other and back: xᵢ' = S_ij ∂_jI, x_j' = −S_ij ∂_iI with everything else at rest, for
/// every pair with S_ij ≠ 0. Order 2, symmetric; keeps I to rounding, other integrals to the order.
///
/// Flows are exact, and the method explicit, where I is of degree 2 in both coordinates and S_ij reads neither (rotations, hyperbolic
/// rotations, shears), where I is linear in both and S_ij is of degree 2 at most (logistic flows), and where one coordinate rests. Up to 12
/// other planes are steps of a discrete gradient in two unknowns; more of them are a type error. Of a field S is searched for, among
/// matrices made of quotients of the terms of f and ∇I; where there are many, one next to the diagonal is taken. Where all flows are exact
/// neighbouring coordinates come first, else planes come in the order of the entries of S.
///
/// G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Volterra's lattice: xᵢ' = xᵢ (xᵢ₊₁ − xᵢ₋₁).
/// #[hamiltonian(structure = |i, j| if j == i + 1 { x[i] * x[j] } else { 0.0 })]
/// fn volterra(x: [f64; 5]) -> f64 {
///     x.iter().sum()
/// }
///
/// let start = FlowState::new([1.0, 0.5, 0.8, 1.2, 0.6]);
/// let mut sim = Volterra.integrator(PlanarSplitting, 0.05, start);
/// sim.advance(2000)?;
/// assert!((sim.energy() - 4.1).abs() < 1e-13);
/// assert!(sim.state().x.iter().all(|x| *x > 0.0));
/// # Ok::<(), StepError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanarSplitting;

/// [`PlanarSplitting`] with a discrete gradient of I in every plane, S_ij in the middle, whether a flow is known there or not: planes come
/// in the order of the entries of S. Order 2, symmetric; keeps I to rounding, other integrals to the order. Two unknowns a plane, solved for
/// twice a step in all planes but the last; of more than 12 planes a type error.
///
/// G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanarDiscreteGradient;
