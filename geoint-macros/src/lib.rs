//! The attributes of `geoint-runtime`, which re-exports them: a compiler from energy functions to integrators.
//!
//! Depend on `geoint-runtime`; the code that is emitted here names it.

// In reading order, which is the order of dependence too.
mod diagnostics;
mod messages;
mod ir;
mod parse;
mod lower;
mod analyze;
mod diff;
mod schedule;
mod split;
mod legendre;
mod derive;
mod check;
mod emit;
mod link;
mod compile;
mod expand;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Makes an integrable system from an energy H(q, p), or H(q, p, t) if it has an argument `t`.
///
/// The function stays as it is. A struct is added, named after it (`fn double_pendulum` gives `DoublePendulum`), with a
/// field for every argument that is not q, p or t, and with `system.integrator(method, h, state)`.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Two bodies; q is the vector between them.
/// #[hamiltonian]
/// fn kepler(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
///     (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
/// }
///
/// let start = State::new([1.0, 0.0], [0.0, 1.0]);
/// let mut sim = Kepler { m: 1.0, k: 1.0 }.integrator(BlanesMoanSrkn14a, 0.1, start);
/// for state in sim.until(6.28) {
///     println!("{:?}", state?.q);
/// }
/// # Ok::<(), StepError>(())
/// ```
///
/// # Arguments of the function
///
/// `q` and `p` have one type: `f64` (or `f32`), `[f64; N]`, `[[f64; D]; N]`, `VectorN<f64>`, `SVector<f64, N>`, or an array of
/// vectors. `t` is a scalar. Every other argument is a parameter, in one of the same shapes.
///
/// An attribute sees its function alone. Where lengths are constants of the file, or types have names, it is told what they are;
/// rustc checks that the file says the same:
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// const N: usize = 8;
/// type Chain = [f64; N];
///
/// /// Toda's chain.
/// #[hamiltonian(const N = 8, type Chain = [f64; N])]
/// fn toda(q: Chain, p: Chain, m: f64) -> f64 {
///     let mut e = 0.0;
///     for i in 0..N {
///         e += p[i] * p[i] / (2.0 * m) + (q[i] - q[(i + 1) % N]).exp();
///     }
///     e
/// }
/// # let mut sim = Toda { m: 1.3 }.integrator(PEFRL, 0.1, State::new([0.1; N], [0.0; N]));
/// # sim.step()?;
/// # Ok::<(), StepError>(())
/// ```
///
/// # Arguments of the attribute
///
/// - `name = Type`: the name of the struct.
/// - `q = x`, `p = px`, `t = time`: other names for positions, momenta and time.
/// - `const N = 8`, `type P = [f64; 3]`: what constants and names of types outside of the function are, each as often as needed.
/// - `with(f, g)`: functions under [`macro@energy_function`] that the body calls.
/// - `crate = path`: where the runtime is, if Cargo.toml does not name it.
/// - `damping = C`: friction, see below.
/// - `constraint = [g₁, g₂]`: functions of positions that stay zero, see below.
/// - `coordinates = jacobi`, `coordinates = heliocentric`, `split = "A | B"`: a part of the energy that is solved exactly, see below.
/// - `structure = S`: another phase space, see below.
/// - `require(separable, quadratic_kinetic)`: what you rely on; an error at the guilty term if it does not hold.
///
/// # The body
///
/// Ordinary Rust on numbers: literals, `let` with patterns and shadowing, blocks, `+ - * /`, `if … else` as an expression,
/// constant indices, `const` items and constants from outside, nested `fn`s, closures and functions under
/// [`macro@energy_function`] (inlined), `for` over ranges, `(a..b).map(…).sum::<f64>()` and the usual iterators (unrolled),
/// assignments to variables and their elements (`x = …`, `x[i] += …`), `continue` and `break`, the methods of `f64` that have a
/// derivative, and vectors of nalgebra with `dot`, `cross`, `norm`, `norm_squared`. Anything else is an error where it stands,
/// which says what is accepted.
///
/// Loops have a number of rounds that is known, and inside of a branch on data nothing outside of it is assigned to: there the
/// branch is a value, `x += if … { … } else { 0.0 }`.
///
/// Both sides of an `if` are differentiated, each where it holds; the branch stays a branch. Where the sides do not meet
/// smoothly no method has the order that it claims.
///
/// # A vector field
///
/// q' = X(q) is the first half of Hamilton's equations for H = p·X(q), an energy that is linear in p. It gives every field the
/// implicit methods: `ImplicitMidpoint` and `Gauss` make the step for q that they make for the field alone, whatever the momenta
/// are, which may begin at zero and then stay there. Explicit Runge–Kutta methods are there as well.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Lotka and Volterra: hares and lynxes.
/// #[hamiltonian]
/// fn lotka_volterra(q: [f64; 2], p: [f64; 2], a: f64, b: f64) -> f64 {
///     p[0] * q[0] * (a - q[1]) + p[1] * q[1] * (q[0] - b)
/// }
///
/// let [x, y] = [1.2, 0.7];
/// let kept = |[x, y]: [f64; 2]| x - 0.8 * x.ln() + y - 1.5 * y.ln();
/// let mut sim = LotkaVolterra { a: 1.5, b: 0.8 }.integrator(Gauss::<3>, 0.01, State::new([x, y], [0.0; 2]));
/// sim.advance(1000)?;
/// assert!((kept(sim.state().q) - kept([x, y])).abs() < 1e-11);
/// assert!(LotkaVolterra::<f64>::REPORT.contains("q follows the field ∂H/∂p by itself"));
/// # Ok::<(), StepError>(())
/// ```
///
/// Flows in closed form for the terms of such a field are found by [`macro@contact_hamiltonian`] with `lift`.
///
/// # Damping
///
/// `damping = C` adds −C ∂H/∂p to the force: q' = ∂H/∂p, p' = −∂H/∂q − C ∂H/∂p. C is an expression in the language of the
/// body that sees the arguments of the function: a number for all coordinates, an array or vector with a number a coordinate,
/// or a symmetric matrix as an array of arrays. It may depend on parameters, the state and time.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A mass in a medium that is denser below.
/// #[hamiltonian(damping = c * (-q).exp())]
/// fn sinking(q: f64, p: f64, m: f64, g: f64, c: f64) -> f64 {
///     p * p / (2.0 * m) + m * g * q
/// }
///
/// let mut sim = Sinking { m: 1.3, g: 9.81, c: 0.4 }.integrator(DiscreteGradient, 0.1, State::new(0.0, 0.0));
/// let mut energy = sim.energy();
/// for _ in 0..50 {
///     sim.step()?;
///     assert!(sim.energy() < energy);
///     energy = sim.energy();
/// }
/// # Ok::<(), StepError>(())
/// ```
///
/// A step of `DiscreteGradient` takes h ∇̄H·C ∇̄H off an energy that does not depend on time, to rounding and for every h > 0,
/// with ∇̄H the part of the discrete gradient for the momenta and C at the mean of both ends: the energy never grows.
/// `ImplicitMidpoint`, `Gauss` and `ExplicitEuler` keep their order. Methods that are made of kicks and drifts do not exist, nor
/// do those that keep the energy in other ways.
///
/// C must be positive semidefinite, to take energy away. What is known when the program is compiled is checked then. For the
/// rest a state is outside of the domain of such a system (`StepError::OutsideDomain`) where a coefficient on the diagonal is
/// negative, or a full matrix is not positive semidefinite. Wherever a step uses C the diagonal is looked at, and every pair of
/// coordinates in a matrix; a matrix for more than two as a whole only at the start of a run and at the end of every call of `step` or
/// `advance`, once in 1024 steps at least.
///
/// # Constraints
///
/// `constraint = [g₁, g₂]` binds positions to gᵢ(q) = 0, by forces −Gᵀλ with G = ∂g/∂q. The functions are expressions in the language of
/// the body, of positions and parameters; they have to be fewer than coordinates, and independent, which is decided when the program is
/// compiled. Methods are `Rattle`, which is symplectic, `DiscreteGradient`, which keeps the energy to rounding, and compositions of both.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A ladder with masses at its ends, between a wall and the floor.
/// #[hamiltonian(constraint = [((q[0] - q[2]).powi(2) + (q[1] - q[3]).powi(2) - l * l) / 2.0, q[0], q[3]])]
/// fn ladder(q: [f64; 4], p: [f64; 4], m: [f64; 2], l: f64, g: f64) -> f64 {
///     let kinetic = (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0]) + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1]);
///     kinetic + g * (m[0] * q[1] + m[1] * q[3])
/// }
///
/// let system = Ladder { m: [1.3, 0.7], l: 1.0, g: 9.81 };
/// let mut sim = system.integrator(DiscreteGradient, 0.01, State::new([0.0, 0.8, 0.6, 0.0], [0.0; 4]));
/// let energy = sim.energy();
/// sim.advance(30)?;
/// assert!((sim.energy() - energy).abs() < 1e-13);
/// # Ok::<(), StepError>(())
/// ```
///
/// A state starts with g = 0 and G ∂H/∂p = 0, up to rounding; another one is refused (`StepError::OffConstraint`), and
/// `system.state_on_constraint(&state)` gives the nearest one that does. Where constraints depend on each other, on the way of a step or at
/// its ends, it is refused (`StepError::DependentConstraints`): a parallelogram whose bars are in one line may go on in two ways. Momenta of
/// `DiscreteGradient` are off the constraints by O(h²) at the ends of steps, which does not grow: `sim.state_on_constraint()` shows them
/// without that.
///
/// # A part that is solved exactly
///
/// `WisdomHolman`, `Aba10_6_4`, `Perturbation(table)` and their like alternate the exact flow of a part A of the energy with kicks by the
/// rest B(q, t). Their error is small as B is; nothing else is asked of B, nor assumed of its size. A and B are
///
/// - the kinetic energy with the quadratic terms of V, and the other terms, where there are such: then nothing has to be said. Of masses that
///   springs couple up to 32 move together, by a matrix that is prepared: that pays for few, as eight;
/// - the quadratic terms with whatever else reads momenta, and the other terms, where q and p are coupled and the flow of the former is
///   known: a charge in a uniform magnetic field, a frame that rotates;
/// - those of `split = "A | B"`, if A has a flow in closed form, see below, and B reads positions and time alone;
/// - with `coordinates = jacobi` Kepler's motion of each body about those before it in the array, and what is left. Masses are read off T,
///   Σ |pᵢ|²/2mᵢ, and attractions off the terms −c/|qᵢ − qⱼ| of V; other terms of V may be any. An order of the bodies that is not that of
///   their distances makes B large, not wrong;
/// - with `coordinates = heliocentric` the same about body 0, for which no order of the others is asked. What moves body 0 is part of B, which
///   is larger: by `WisdomHolman` errors are some four times those in coordinates of Jacobi, by `Aba10_6_4` they are as small. Force gradients do
///   not exist. Where V has terms that read positions otherwise than by differences of bodies 1, 2, …, the flow of B is a step of order 2.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A star and two planets; their attraction has a small correction.
/// #[hamiltonian(coordinates = jacobi)]
/// fn planets(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], g: f64, c: f64) -> f64 {
///     let mut energy = 0.0;
///     for i in 0..3 {
///         energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
///         for j in 0..i {
///             let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
///             energy -= g * m[i] * m[j] * (1.0 / square.sqrt() + c / square);
///         }
///     }
///     energy
/// }
///
/// let system = Planets { m: [1.0, 1e-3, 3e-4], g: 1.0, c: 1e-6 };
/// let start = State::new([[0.0, 0.0], [1.0, 0.0], [-2.5, 0.0]], [[0.0, -8.1e-4], [0.0, 1e-3], [0.0, -1.9e-4]]);
/// let mut sim = system.integrator(WisdomHolmanGradient, 0.3, start);
/// let energy = sim.energy();
/// sim.advance(10_000)?;
/// assert!((sim.energy() / energy - 1.0).abs() < 1e-8);
/// # Ok::<(), StepError>(())
/// ```
///
/// The state is what it is without: coordinates of Jacobi, and the way of a processor, are between the first step and the state that is
/// looked at. A body whose mass is zero has no momentum that could be divided by it, and is refused (`StepError::OutsideDomain`); 1e-30 is
/// none. An orbit that meets the body in its focus ends there (`StepError::Pole`, with the body).
///
/// # Pieces
///
/// Where terms couple positions and momenta there are no kicks and drifts. H may still be a sum of pieces whose flows are known in closed form,
/// for `PieceSplitting` and its compositions. These are found:
///
/// - quadratic forms in which 32 degrees of freedom at most are coupled, with linear terms: charges in uniform fields, rotating frames, coupled
///   springs;
/// - F(ℓ₁, …, ℓₖ) of linear forms in involution: (p₁ − A(q₀))², F(q₀, p₁), cos(k·q), (q + p)⁴;
/// - p·X(q) where q' = X(q) has a solution in closed form; f(qᵢ)pᵢ²; products qᵐpⁿ; the conjugates of all these;
/// - F(A) of an A of these: (p² + q²)², a root of an oscillator.
///
/// Squares may be multiplied out. Of several ways those are taken whose flows never end, as that of q²p does, and of
/// these the one that costs least in a step; products of degree 3 or 4 are sums of powers of forms where that is better. `REPORT` lists the
/// pieces, their flows and costs, and what was rejected at which cost. `split = "terms | terms"` gives other pieces; that they add up to H is
/// decided exactly.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A charge in a magnetic bottle: the field is stronger at both ends.
/// #[hamiltonian]
/// fn bottle(q: [f64; 3], p: [f64; 3], b: f64) -> f64 {
///     let [x, y, z] = q;
///     let half = b * (1.0 + z * z) / 2.0;
///     ((p[0] + half * y).powi(2) + (p[1] - half * x).powi(2) + p[2] * p[2]) / 2.0
/// }
///
/// let start = State::new([0.02, 0.0, 0.0], [0.0, 0.5, 0.6]);
/// let mut sim = Bottle { b: 10.0 }.integrator(BlanesMoan6X.of(PieceSplitting), 0.05, start);
/// let energy = sim.energy();
/// sim.advance(10_000)?;
/// assert!((sim.energy() / energy - 1.0).abs() < 1e-4);
/// # Ok::<(), StepError>(())
/// ```
///
/// # Rigid bodies
///
/// `attitude = r` is for energies of rigid bodies: r, a `UnitQuaternion` of nalgebra, turns vectors of the body into vectors of space, and
/// m is the angular momentum in the frame of the body, a `Vector3`. Arrays of both are several bodies. The state is
/// `BodyState::new(r, m)`.
///
/// ```
/// use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
/// use geoint_runtime::prelude::*;
///
/// /// A heavy body about a fixed point; c is its weight times the centre of mass, in the frame of the body.
/// #[hamiltonian(attitude = r)]
/// fn heavy_body(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], c: Vector3<f64>) -> f64 {
///     (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0 + (r * c).z
/// }
///
/// let system = HeavyBody { inertia: [1.0, 2.0, 3.0], c: Vector3::new(0.3, -0.2, 0.7) };
/// let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.5, 1.6, -1.2));
/// let mut sim = system.integrator(BlanesMoanSrkn14a, 0.25, start);
/// let energy = sim.energy();
/// sim.advance(1000)?;
/// assert!((sim.energy() - energy).abs() < 1e-9);
/// # Ok::<(), StepError>(())
/// ```
///
/// The equations are r' = ½ r⊗(0, ω) and m' = m × ω + τ with ω = ∂H/∂m and the torque τᵢ = −½ (r⊗eᵢ)·∂H/∂r. The energy has to be
/// T(m) + V(r, t), with a T that is quadratic in the momentum of each body with constant coefficients; the term that is something else
/// is named. T may have a full tensor of inertia, and terms linear in m (wheels that spin). A kick adds hτ to m, a drift is the exact flow
/// of the free body, so that all tables of kicks and drifts have their order: those of Runge–Kutta–Nyström type and with force gradients
/// too. Where two moments of inertia are the same expression it is two rotations, else a Taylor series. `FiveRotations` is Verlet's method
/// with rotations about the principal axes in place of the exact flow. Explicit Runge–Kutta methods, compensated sums and adaptive steps are
/// there as well.
///
/// Bodies that move as a whole have centres of mass `q` with momenta `p` beside attitudes, in space, a `Vector3` a body each, and a state
/// `BodyState { t, r, m, q, p }`: H is T(m) + T(p) + V(r, q, t), with T(p) quadratic, too.
///
/// ```
/// use geoint_runtime::nalgebra::{UnitQuaternion, Vector3};
/// use geoint_runtime::prelude::*;
///
/// /// A body that hangs by a spring from the origin; d is where, from its centre of mass, in its own frame.
/// #[hamiltonian(attitude = r)]
/// fn hanging(
///     r: UnitQuaternion<f64>, m: Vector3<f64>, q: Vector3<f64>, p: Vector3<f64>,
///     inertia: [f64; 3], mass: f64, g: f64, d: Vector3<f64>, k: f64,
/// ) -> f64 {
///     (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0
///         + p.norm_squared() / (2.0 * mass) + mass * g * q.z + k * (q + r * d).norm_squared() / 2.0
/// }
///
/// let system = Hanging { inertia: [0.1, 0.2, 0.3], mass: 1.5, g: 9.81, d: Vector3::new(0.0, 0.1, 0.3), k: 50.0 };
/// let start = BodyState::new(UnitQuaternion::identity(), Vector3::new(0.1, 0.0, 0.2))
///     .with_centres(Vector3::new(0.1, 0.0, -0.6), Vector3::new(0.0, 0.4, 0.0));
/// let mut sim = system.integrator(BlanesMoanSrkn14a, 0.05, start);
/// let energy = sim.energy();
/// sim.advance(1000)?;
/// assert!((sim.energy() - energy).abs() < 1e-6);
/// # Ok::<(), StepError>(())
/// ```
///
/// Of an attitude the body may use `r * v`, `r.inverse() * v`, `r * s`, `r / s`, `transform_vector`, `inverse_transform_vector`,
/// `rotation_to`, `dot`, `imag`, `scalar`, its numbers `r.i`, `r.j`, `r.k`, `r.w`, and `r.coords`. A quaternion whose length is not 1
/// at the start of a run is refused (`StepError::NotNormalised`); in a run it is normalised once in 1024 steps.
///
/// # Another phase space
///
/// `structure = S` is for energies H(x) of coordinates x that are no positions and momenta: x' = S(x) ∇H(x) with a skew matrix S. The
/// coordinates are one argument, `x`, and the state is `FlowState { t, x }`.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Predators and prey.
/// #[hamiltonian(structure = [[0.0, -x[0] * x[1]], [x[0] * x[1], 0.0]])]
/// fn lotka_volterra(x: [f64; 2], a: f64, b: f64, c: f64, d: f64) -> f64 {
///     d * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()
/// }
///
/// let system = LotkaVolterra { a: 2.0, b: 1.0, c: 1.0, d: 1.0 };
/// let mut sim = system.integrator(DiscreteGradient, 0.1, FlowState::new([1.0, 0.5]));
/// let energy = system.energy(&sim.state());
/// sim.advance(1000)?;
/// assert!((system.energy(&sim.state()) - energy).abs() < 1e-13);
/// # Ok::<(), StepError>(())
/// ```
///
/// S is one of
///
/// - `so3`: x' = x × ∇H, for three coordinates or an array of such;
/// - `se3`: m' = m × ∂H/∂m + γ × ∂H/∂γ, γ' = γ × ∂H/∂m for x = (m, γ);
/// - `canonical`: the halves of x are positions and momenta;
/// - `nambu(C)`: x' = ∇C × ∇H for three coordinates and a second function C;
/// - an array of arrays, which is proven to be skew;
/// - a closure `|i, j| …` of indices, that is asked for i < j.
///
/// `DiscreteGradient` takes x₁ = x₀ + h S((x₀ + x₁)/2) ∇̄H: it keeps H, and every function C of degree 2 at most with S∇C = 0, to
/// rounding for every h. `FourthOrder` keeps H. `REPORT` says whether S is a Poisson structure. `damping = C` makes x' = (S − C) ∇H of it.
#[proc_macro_attribute]
pub fn hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    expand::expand(parse::Form::Hamiltonian, args.into(), item.into()).into()
}

/// Makes an integrable system from a vector field, x' = f(x) or x' = f(x, t), and keeps the first integrals that are named.
///
/// The function stays as it is, and a struct is added as by [`macro@hamiltonian`]. The state is `FlowState { t, x }`.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Euler's equations of a free body, in angular velocities.
/// #[vector_field(keeps(
///     energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
///     momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
/// ))]
/// fn euler_top(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
///     [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
/// }
///
/// let top = EulerTop { a: 1.0, b: 2.0, c: 3.0 };
/// let start = FlowState::new([0.5, 0.8, -0.4]);
/// let mut sim = top.integrator(DiscreteGradient, 0.1, start);
/// sim.advance(1000)?;
/// assert!((top.energy(&sim.state()) - top.energy(&start)).abs() < 1e-14);
/// assert!((top.momentum(&sim.state()) - top.momentum(&start)).abs() < 1e-14);
/// # Ok::<(), StepError>(())
/// ```
///
/// # Arguments of the function
///
/// `x` has one of the types that `q` may have under [`macro@hamiltonian`], and the function returns the same shape. `t` is time. Every
/// other argument is a parameter.
///
/// # What is kept
///
/// `keeps(name = I, …)` names functions I of x, parameters and t, in the language of the body. That each is constant is proven when the
/// program is compiled: f·∇I + ∂I/∂t = 0, by multiplying out, at every state at which all of it is defined. A function that is not
/// constant is an error, which shows what remains of that. So is one that was not proven to be constant; `keeps(assume(name = I))`
/// accepts it, and `REPORT` then says that it is assumed; what is wrong almost everywhere is refused all the same.
///
/// What is kept under the name `energy` is the energy of runs as well: `sim.energy()`; of other fields that is not a number.
///
/// `keeps(name = I, but = b)` is for what a loss or a force b(x) changes alone: (f − b)·∇I = 0 is proven, and a step of
/// `DiscreteGradient` changes I by h b(m)·∇̄I exactly, m the middle of the step.
///
/// ```
/// # use geoint_runtime::prelude::*;
/// /// Lorenz 1984: a conservative core, loss and forcing; |x|²/2 changes by exactly what the last two do.
/// #[vector_field(keeps(half_square = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0, but = [a * (f - x[0]), g - x[1], -x[2]]))]
/// fn lorenz84(x: [f64; 3], a: f64, b: f64, f: f64, g: f64) -> [f64; 3] {
///     [
///         -x[1] * x[1] - x[2] * x[2] + a * (f - x[0]),
///         x[0] * x[1] - b * x[0] * x[2] + g - x[1],
///         b * x[0] * x[1] + x[0] * x[2] - x[2],
///     ]
/// }
/// # let mut sim = Lorenz84 { a: 0.25, b: 4.0, f: 8.0, g: 1.0 }.integrator(DiscreteGradient, 0.01, FlowState::new([1.0, 0.5, -0.3]));
/// # sim.step()?;
/// # Ok::<(), StepError>(())
/// ```
///
/// # Steps
///
/// With the discrete gradients ḡ of all integrals in the columns of G, `DiscreteGradient` takes
///
/// x₁ = x₀ + h (F − G (GᵀG)⁻¹ GᵀF), F = f((x₀ + x₁)/2),
///
/// which is symmetric, of order 2, and keeps all integrals to rounding for every h. `FourthOrder` takes the same with
/// F = (f(x₀) + 4 f(c) + f(x₁))/6, c = (x₀ + x₁)/2 + h/8 (f(x₀) − f(x₁)), of order 4. Where gradients vanish or depend on each other, as
/// in permanent rotations, those that say nothing new take no part. M. Dahlby, B. Owren & T. Yaguchi, J. Phys. A 44 (2011) 305205.
///
/// Without `keeps` there are the methods for every field: Runge–Kutta methods, `ImplicitMidpoint` and `Gauss`.
///
/// # Arguments of the attribute
///
/// - `name = Type`: the name of the struct.
/// - `x = y`, `t = time`: other names for coordinates and time.
/// - `keeps(…)`: see above.
/// - `const N = 8`, `type P = [f64; 3]`, `with(f, g)`, `crate = path`: as for [`macro@hamiltonian`].
#[proc_macro_attribute]
pub fn vector_field(args: TokenStream, item: TokenStream) -> TokenStream {
    expand::expand(parse::Form::Field, args.into(), item.into()).into()
}

/// Makes an integrable system from a contact Hamiltonian H(q, p, s), or H(q, p, s, t): energy that is lost or driven.
///
/// The equations are q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H; H itself changes by H' = −H ∂H/∂s + ∂H/∂t. With
/// H = p²/2m + V(q) + γs this is a particle with friction, p' = −V'(q) − γp, and s is its action.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A pendulum in a viscous medium; q in rad, p in kg m²/s.
/// #[contact_hamiltonian]
/// fn damped_pendulum(q: f64, p: f64, s: f64, m: f64, l: f64, g: f64, gamma: f64) -> f64 {
///     p * p / (2.0 * m * l * l) - m * g * l * q.cos() + gamma * s
/// }
///
/// let system = DampedPendulum { m: 1.0, l: 1.0, g: 9.81, gamma: 0.1 };
/// let mut sim = system.integrator(ContactSplitting, 0.01, ContactState::new(2.0, 0.0, 0.0));
/// sim.advance(1000)?;
/// println!("{:?}", sim.state());
/// # Ok::<(), StepError>(())
/// ```
///
/// The function's arguments and body are as for [`macro@hamiltonian`], with `s` for the action, a scalar, or `_s` where the
/// energy does not read it.
///
/// # Pieces
///
/// H is taken apart into the fewest pieces whose flows are known in closed form; `REPORT` lists them, with the rule behind each
/// and their order in a step. Steps go through the flows and back, the most expensive one in the middle. A coefficient that
/// depends on time is integrated exactly where its antiderivative is elementary, otherwise frozen in the middle of a step.
/// Where a term is in no such piece, `ContactGauss`, `ContactMidpoint` and `ContactDiscreteGradient` are left, which are for every H.
///
/// # Arguments of the attribute
///
/// - `name = Type`: the name of the struct.
/// - `q = x`, `p = px`, `s = z`, `t = time`: other names for positions, momenta, action and time.
/// - `const N = 8`, `type P = [f64; 3]`: as for [`macro@hamiltonian`].
/// - `split = "terms | terms"`: the pieces, if they are to be others than those found: sums of terms in the language of the body,
///   which add up to H: that is decided exactly, however they are written.
/// - `lift`: q' = X(q) written as H = p·X(q), or a flow of (q, s) written as p·a(q, s) + b(q, s). The momenta are not followed,
///   which would blow up in finite time: they stay what they are, and the energy is not a number. A field of q alone has the
///   argument `_s`.
/// - `with(f, g)`: functions under [`macro@energy_function`] that the body calls.
/// - `crate = path`: where the runtime is, if Cargo.toml does not name it.
#[proc_macro_attribute]
pub fn contact_hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    expand::expand(parse::Form::Contact, args.into(), item.into()).into()
}

/// Makes an integrable system from a Lagrangian L(q, v) with the velocities v = q', or L(q, v, t), or L(q, v, s, t).
///
/// Its energy is H = p·v − L with p = ∂L/∂v. The state is (q, p), as under [`macro@hamiltonian`], or (q, p, s) with an argument `s`, as under
/// [`macro@contact_hamiltonian`]. Where v follows from p by a formula that is not too long, all methods that are for H are for L; where it
/// does not, steps are solved for velocities.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Two pendulums; q angles from below, v their rates.
/// #[lagrangian]
/// fn double_pendulum(q: [f64; 2], v: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
///     let x = [l[0] * v[0], l[1] * v[1]];
///     let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
///     let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
///     kinetic + (m[0] + m[1]) * g * l[0] * q[0].cos() + m[1] * g * l[1] * q[1].cos()
/// }
///
/// let system = DoublePendulum { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81 };
/// // At rest, the lower one out of the vertical.
/// let mut sim = system.integrator(DiscreteGradient, 0.01, system.at([0.0, 1.4], [0.0, 0.0]));
/// let energy = sim.energy();
/// sim.advance(1000)?;
/// assert!((sim.energy() - energy).abs() < 1e-12);
/// println!("{:?} {:?}", sim.state().q, system.velocity(&sim.state()));
/// # Ok::<(), StepError>(())
/// ```
///
/// # Functions
///
/// - `system.at(q, v)` and `system.at_time(t, q, v)` are states; with an action `system.at(q, v, s)`, `system.at_time(t, q, v, s)`.
/// - `system.momentum(t, q, v)` and `system.lagrangian(t, q, v)` are p and L, with `s` as a last argument where there is one.
/// - `system.velocity(&state)`, or `sim.velocity()`, are v.
/// - `system.from_positions(t, before, now, h)` is the state at t with the momentum that the implicit midpoint rule has after a step of length h
///   from one position to the other: with these recursions of positions alone can be compared, or started. Not with an action, nor with
///   constraints.
/// - `system.energy(&state)` is H, which is T + V where L = T − V with a T that is quadratic in v, and else is not: `REPORT` says so.
///
/// # Which Lagrangians
///
/// The mass matrix M = ∂²L/∂v² must not be singular everywhere. Velocities that M couples, directly or by others, are a part. Of a part
/// v follows from p in closed form where L is quadratic in v, by M = LDLᵀ without an inverse; and where L has linear terms and one of
///
/// - A√(S + v·Cv), such as −mc²√(1 − v·v/c²), or n√(1 + v·v) of light;
/// - A|v|ⁿ of one velocity, A eᵛ, A ln v, A cosh v, with a multiple of v and a constant inside.
///
/// A and C, S and M may read positions, time and the action. M is freed of coordinates on which it does not depend: what is written in
/// Cartesian coordinates, with sin² + cos² in it, is as good as what was simplified by hand. A pole of H is where M is singular, and no
/// implicit step leads over it.
///
/// # Velocities as unknowns
///
/// H would be long where M couples three velocities or more and depends on positions, and has no formula for other functions of v. Then
/// `ImplicitMidpoint` and `Gauss` are solved for the velocities of their stages: the same map with half of the unknowns, from the
/// derivatives of L alone. `DiscreteGradient`, of an L that is quadratic in v, is the polarised one: with
/// Λ(q) = ½v₀·M(q)v₁ + a(q)·(v₀ + v₁)/2 − V(q) and its tree slopes Λ[q₀, q₁] in q,
///
/// q₁ − q₀ = h (v₀ + v₁)/2, p₁ − p₀ = h Λ[q₀, q₁], p = M(q)v + a(q) at both ends.
///
/// It keeps the energy to rounding for every h, and the momenta of coordinates that L does not read; of order 2 and symmetric, so that
/// `Suzuki4` and others raise its order. Explicit Runge–Kutta methods solve for v wherever they evaluate L. An end of a step at which the
/// determinant of M has another sign than at the start of the run is refused (`StepError::Singular`).
///
/// With an action `ContactMidpoint` and `ContactGauss` are solved for velocities, and for s where it acts back; `ContactDiscreteGradient` is the
/// polarised one, with slopes Λ_q and Λ_s in q and s, p̄ = (p₀ + p₁)/2 and the energy H₀ before the step,
///
/// p₁ − p₀ = h (Λ_q + Λ_s p̄), s₁ − s₀ = h (p̄·v̄ − H₀ φ₁(hΛ_s)), φ₁(x) = (eˣ − 1)/x,
///
/// so that H₁ = H₀ exp(hΛ_s) to rounding. `ContactGauss` is solved for velocities wherever L is quadratic in v.
///
/// Momenta that no term of L changes when all of it moves or turns are in `REPORT`; Gauss methods keep them, or let them all decay by one
/// factor.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Masses on a chain of rods of length 1; q angles from below.
/// #[lagrangian]
/// fn chain(q: [f64; 4], v: [f64; 4], m: f64, g: f64) -> f64 {
///     let (mut x, mut y, mut depth, mut sum) = (0.0, 0.0, 0.0, 0.0);
///     for i in 0..4 {
///         let (sin, cos) = q[i].sin_cos();
///         x += v[i] * cos;
///         y += v[i] * sin;
///         depth += cos;
///         sum += 0.5 * m * (x * x + y * y) + m * g * depth;
///     }
///     sum
/// }
///
/// let system = Chain { m: 0.7, g: 9.81 };
/// let mut sim = system.integrator(DiscreteGradient, 0.01, system.at([0.5, 1.0, -0.5, 0.3], [0.0; 4]));
/// let energy = sim.energy();
/// sim.advance(500)?;
/// assert!((sim.energy() - energy).abs() < 1e-12);
/// # Ok::<(), StepError>(())
/// ```
///
/// # Linear in velocities
///
/// L = ϑ(q)·v − H(q, t) has equations of first order, Ω q' = ∇H with Ωᵢⱼ = ∂ᵢϑⱼ − ∂ⱼϑᵢ. Ω is derived, and inverted in closed form; states
/// are `FlowState { t, x }` with x = q alone, `system.at(q)`. Everything is there that
/// `#[hamiltonian(structure = Ω⁻¹)]` has, such as `DiscreteGradient`, which keeps H to rounding. Where Ω vanishes on half of the
/// coordinates, as it does where half of ϑ is zero, `Gauss` and `ImplicitMidpoint` move the others with their momenta, and are
/// symplectic: C. L. Ellison et al., Phys. Plasmas 25 (2018) 052502. `REPORT` names the canonical coordinates, or says that there are none.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Prey and predators.
/// #[lagrangian]
/// fn animals(q: [f64; 2], v: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
///     let [x, y] = q;
///     y.ln() / x * v[0] + b * x - c * x.ln() + b * y - a * y.ln()
/// }
///
/// let system = Animals { a: 1.0, b: 0.7, c: 0.5 };
/// let mut sim = system.integrator(Gauss::<2>, 0.1, system.at([1.0, 1.5]));
/// let energy = sim.energy();
/// sim.advance(1000)?;
/// assert!((sim.energy() - energy).abs() < 1e-8);
/// # Ok::<(), StepError>(())
/// ```
///
/// # Friction
///
/// `rayleigh = R` adds −∂R/∂v to the force, for a function R(q, v, t) that is least at rest. Where R is a quadratic form in v, the energy
/// falls at the rate 2R, else at v·∂R/∂v, as for drag `c * v.abs().powi(3) / 3.0` or dry friction `c * (v * v + e * e).sqrt()`; in a step of
/// `DiscreteGradient` by what the mean velocity says, exactly. A step in which R would feed energy is refused.
///
/// `force = F` adds F(q, v, t), a number, or an array like q: torques of motors, or what else has no potential. A step of
/// `DiscreteGradient` adds h v̄·F at the middle of the step to the energy, exactly.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A pendulum with friction in its joint.
/// #[lagrangian(rayleigh = c * v * v / 2.0)]
/// fn pendulum(q: f64, v: f64, m: f64, l: f64, g: f64, c: f64) -> f64 {
///     m * l * l * v * v / 2.0 + m * g * l * q.cos()
/// }
///
/// let system = Pendulum { m: 0.7, l: 1.2, g: 9.81, c: 0.2 };
/// let mut sim = system.integrator(DiscreteGradient, 0.1, system.at(1.0, 0.0));
/// let energy = sim.energy();
/// sim.advance(100)?;
/// assert!(sim.energy() < energy);
/// # Ok::<(), StepError>(())
/// ```
///
/// # Herglotz' principle
///
/// With an argument `s`, the action, s' = L(q, v, s, t), and the equations are d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v: those of the contact
/// Hamiltonian p·v − L. A term −γs is friction. There is neither `rayleigh` nor `force`: with these no step is a contact map.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// A pendulum that is braked.
/// #[lagrangian]
/// fn braked(q: f64, v: f64, s: f64, m: f64, g: f64, gamma: f64) -> f64 {
///     m * v * v / 2.0 + m * g * q.cos() - gamma * s
/// }
///
/// let system = Braked { m: 0.7, g: 9.81, gamma: 0.2 };
/// let mut sim = system.integrator(Suzuki4.of(ContactSplitting), 0.05, system.at(1.0, 0.0, 0.0));
/// sim.advance(100)?;
/// # Ok::<(), StepError>(())
/// ```
///
/// # Arguments of the attribute
///
/// - `name = Type`: the name of the struct.
/// - `q = x`, `v = xdot`, `s = z`, `t = time`: other names for positions, velocities, action and time.
/// - `rayleigh = R`, `force = F`: see above.
/// - `constraint = [g₁, g₂]`: functions of positions and parameters that stay zero; see [`hamiltonian`].
/// - `require(regular, quadratic, constant_mass)`: L is not linear in velocities; it is quadratic in them; ∂²L/∂v² is constant.
/// - `require(separable, quadratic_kinetic, conservative)`, `const N = 8`, `type P = [f64; 3]`, `with(f, g)`, `crate = path`: as for
///   [`macro@hamiltonian`]; what is required is required of H.
#[proc_macro_attribute]
pub fn lagrangian(args: TokenStream, item: TokenStream) -> TokenStream {
    expand::expand(parse::Form::Lagrangian, args.into(), item.into()).into()
}

/// Makes a function one that energies may call: it is inlined, and differentiated with them.
///
/// An attribute sees the item under it alone. So the function is named in the energy's attribute, `with(…)`, and has this one above
/// itself. It is an ordinary function for everybody else.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// mod forces {
///     use geoint_runtime::prelude::*;
///
///     /// 4ε((σ/r)¹² − (σ/r)⁶) as a function of r².
///     #[energy_function]
///     pub fn lennard_jones(square: f64, epsilon: f64, sigma: f64) -> f64 {
///         let x = (sigma * sigma / square).powi(3);
///         4.0 * epsilon * (x * x - x)
///     }
/// }
/// use forces::lennard_jones;
///
/// /// Two atoms on a line.
/// #[hamiltonian(with(lennard_jones))]
/// fn dimer(q: f64, p: f64, m: f64, epsilon: f64, sigma: f64) -> f64 {
///     p * p / (2.0 * m) + lennard_jones(q * q, epsilon, sigma)
/// }
///
/// let mut sim = Dimer { m: 1.3, epsilon: 1.0, sigma: 1.0 }.integrator(DiscreteGradient, 0.01, State::new(1.2, 0.0));
/// sim.advance(1000)?;
/// assert!((sim.energy() - lennard_jones(1.44, 1.0, 1.0)).abs() < 1e-14);
/// # Ok::<(), StepError>(())
/// ```
///
/// The body is in the language of energies. Where the energy calls the function, it sees what is inside of it, and other functions
/// under this attribute that it names itself: `#[energy_function(with(g))]`. A constant from outside is named from the root of the
/// crate, `crate::forces::CUTOFF`, or repeated if it is an integer: `const N = 3`.
///
/// `with(module::f)` takes a path, and the body calls the function by the same. It can be named in its own crate only, and
/// where it is visible; and where a function without the attribute does not hide it. An energy may have this attribute beside its
/// own, and be a part of another one. Functions that call each other, or themselves, cannot be inlined.
#[proc_macro_attribute]
pub fn energy_function(args: TokenStream, item: TokenStream) -> TokenStream {
    expand::energy_function(args.into(), item.into()).into()
}

/// What asks for a function, by a name that says what to do if it is none under `#[energy_function]`.
#[doc(hidden)]
#[proc_macro]
pub fn put_energy_function_above_it(input: TokenStream) -> TokenStream {
    link::put(input.into()).into()
}

/// Where macros of functions under `#[energy_function]` call back.
#[doc(hidden)]
#[proc_macro]
pub fn resume(input: TokenStream) -> TokenStream {
    expand::resume(input.into()).into()
}

/// The number of unknowns up to which Newton's iteration has a kernel of its own: for the runtime, which decides by the same.
#[doc(hidden)]
#[proc_macro]
pub fn most_unknowns(_: TokenStream) -> TokenStream {
    proc_macro::TokenTree::from(proc_macro::Literal::usize_unsuffixed(derive::MOST_UNKNOWNS)).into()
}
