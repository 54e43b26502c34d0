//! The splittings of a system into pieces, one type for each kind of pieces.

/// A splitting of a system into pieces. The attribute macros implement [`Pieces`](crate::system::Pieces) for every splitting that the system has.
#[doc(alias("operator splitting", "symplectic"))]
pub trait PieceKind: Copy + Default {
    /// The name of the method.
    const NAME: &'static str;
}

/// A splitting all of whose flows are exact. Tables of maps Φ and adjoints Φ*, such as [`BlanesMoan4X`](crate::BlanesMoan4X), need them: the driver merges the
/// last flow of Φ with the first one of Φ*, and a step of order 2 in its place would leave the table with order 2.
#[diagnostic::on_unimplemented(
    message = "`{Self}` solves equations in place of flows, and this table would have order 2",
    label = "this table needs exact flows",
    note = "compositions of steps keep their order: `Suzuki4.of(PlanarSplitting)`, `Yoshida6a.of(PlanarDiscreteGradient)`"
)]
pub trait ExactFlows: PieceKind {}

impl ExactFlows for PieceSplitting {}
impl ExactFlows for ContactSplitting {}
impl ExactFlows for PoissonSplitting {}

/// e^(h/2 X₁) … e^(h/2 Xₖ₋₁) e^(h Xₖ) e^(h/2 Xₖ₋₁) … e^(h/2 X₁): the exact flows of the pieces of H(q, p, t), for energies whose terms
/// couple positions and momenta. Order 2, symmetric, symplectic, explicit. The flow of every piece but the last is applied twice a step.
///
/// The pieces are found automatically, or are given by `split = "terms | terms"`. Examples are charges in magnetic fields, coupled
/// oscillators, polynomials of degree 4, and functions of energies with a known flow. `REPORT` lists the pieces with their rules and
/// costs. The pieces of H = T + V are a drift and a kick; use the methods for these. If the flow of a piece ends within a step, the step
/// is refused with the name of the piece.
///
/// ```
/// use geoint_runtime::methods::*;
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

/// e^(h/2 X₁) … e^(h/2 Xₖ₋₁) e^(h Xₖ) e^(h/2 Xₖ₋₁) … e^(h/2 X₁): the exact flows of the pieces of H for contact systems. A kick is in
/// the middle, or else the most expensive flow. Order 2, symmetric, a contact map. The flow of every piece but the last is applied twice
/// a step.
///
/// Beside constraints, for H = H₀(q, p, t) + γ(t)·s, the step is [`DampedRattle`](crate::method::constrained::DampedRattle): half of the flow of γs, a step of
/// RATTLE, and again half of the flow.
///
/// If the flow of a piece ends within a step, as for H = s², the step is refused with the name of the piece.
/// A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7.
#[doc(alias("Strang splitting", "contact integrator"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactSplitting;

/// Exact flows of the terms of H in x' = S(x) ∇H, in order and then in reverse order. Order 2, symmetric, explicit. If the bracket of S
/// is a Poisson bracket, the step is a Poisson map: it keeps Casimirs to rounding, and H to the order.
///
/// Coordinates are in involution if S_ij = 0 for all i and j among them. A term that reads only such coordinates leaves them at rest. It
/// moves the others by single equations or by a linear field: a rotation, a shear, an exponential, a tangent. Terms whose coordinates
/// are all in involution form one piece. Pieces that leave more coordinates at rest come first, then pieces of smaller index. Pieces
/// that move the coordinates they read come last, for example pairs of vortices. `REPORT` lists the pieces with their rules.
/// R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043.
///
/// ```
/// use geoint_runtime::methods::*;
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

/// The planar parts of x' = S(x) ∇I, in order and then in reverse order. Every pair with S_ij ≠ 0 is a part: xᵢ' = S_ij ∂_jI,
/// x_j' = −S_ij ∂_iI, and all other coordinates are at rest. Order 2, symmetric. Keeps I to rounding, other integrals to the order.
///
/// The flow of a plane is exact in three cases: I has degree 2 in both coordinates and S_ij reads neither (rotations, hyperbolic
/// rotations, shears); I is linear in both and S_ij has degree 2 at most (logistic flows); one coordinate is at rest. If all flows are
/// exact, the method is explicit. Up to 12 other planes are steps of a discrete gradient in two unknowns. More than 12 are a type error.
///
/// For a system given by its field f, S is searched for among matrices whose entries are quotients of the terms of f and ∇I. If there
/// are several, a matrix next to the diagonal is taken. If all flows are exact, planes of neighbouring coordinates come first. Otherwise
/// planes come in the order of the entries of S.
///
/// G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.
///
/// ```
/// use geoint_runtime::methods::*;
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

/// [`PlanarSplitting`] with a discrete gradient of I and S_ij at the midpoint in every plane, also in planes with a known flow. Planes come
/// in the order of the entries of S. Order 2, symmetric. Keeps I to rounding, other integrals to the order. Each plane has two unknowns,
/// which are solved for twice a step in all planes but the last. More than 12 planes are a type error.
///
/// G. R. W. Quispel & H. W. Capel, Phys. Lett. A 218 (1996) 223.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlanarDiscreteGradient;
