//! Look up the words of this documentation. Each entry has one or two sentences.
//!
//! This program contains some of the words:
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// An energy: T(p) gives the drift, V(q) gives the kick.
//! #[hamiltonian]
//! fn oscillator(q: f64, p: f64, k: f64) -> f64 {
//!     p * p / 2.0 + k * q * q / 2.0
//! }
//!
//! let system = Oscillator { k: 1.0 }; // a system: an energy with its parameters
//! let mut run = system.integrator(StormerVerlet, 0.1, State::new(1.0, 0.0)); // a run: a system, a method, a step size, a state
//! run.step()?; // a step: half a kick, a drift, half a kick
//! let event = run.until_event(10.0, Direction::Down, |x| x.q)?; // an event: q changes its sign
//! assert!(event.is_some_and(|event| (event.state.t - 1.57).abs() < 1e-2));
//! # Ok::<(), StepError>(())
//! ```
//!
//! - **Action** s: the integral of the Lagrangian along the motion, s' = p·q' − H. Contact systems have it as a third variable.
//! - **Adaptive run**: a run that chooses each step from an estimate of its error. See [`Adaptive`](crate::Adaptive).
//! - **Adjoint** of a method: its step with −h, inverted. A symmetric method is its own adjoint.
//! - **Casimir**: a function C with S∇C = 0. Every energy on the same Poisson structure keeps it.
//! - **Collocation**: a method whose polynomial satisfies the equations of motion at chosen times in the step. See [`Gauss`](crate::Gauss).
//! - **Compensated sum**: a sum that carries its rounding error along. Call `.compensated()` on a run.
//! - **Composition**: several steps of one map with different lengths, such that their errors cancel. It raises the order.
//! - **Constraint**: a function g(q, t) that stays zero, such as the distance of two joints minus the length of their bar; with `rolling`, a function of
//!   velocities. Its **multiplier** gives its force.
//! - **Contact form** ds − p dq: the structure of contact systems. Their flow multiplies it by a factor.
//! - **Dense output**: states between the ends of steps. The steps themselves do not change.
//! - **Discrete gradient**: a vector ∇̄H with ∇̄H·(x₁ − x₀) = H(x₁) − H(x₀) for the ends x₀, x₁ of a step. Used for ∇H, it keeps the energy exactly.
//! - **Divided difference** (slope): (f(b) − f(a))/(b − a), written without 0/0 and without cancellation.
//! - **Drift**: the flow of the kinetic energy T(p). It changes positions only.
//! - **Event**: a time at which a function of the state changes its sign, such as an impact.
//! - **Explicit method**: a method that computes a step directly. An **implicit method** solves equations for the end of the step.
//! - **Flow**: the map from a state to the state a time h later. A step is an approximation of it.
//! - **Force**: −∂H/∂q. The number of its evaluations measures the work of a run.
//! - **Force gradient**: a derivative of the force, used in some kicks to reach a higher order with fewer forces.
//! - **Hamiltonian** H(q, p): the energy in positions and momenta. It determines the motion: q' = ∂H/∂p, p' = −∂H/∂q.
//! - **Integral** (first integral, invariant): a function of the state that stays constant along every motion.
//! - **Jacobi coordinates**: the position of each body relative to the centre of mass of the bodies before it.
//! - **Jet**: the Taylor coefficients of a solution at one time, up to some order.
//! - **Kick**: the flow of the potential energy V(q). It changes momenta only.
//! - **Lagrangian** L(q, v): for mechanical systems, kinetic minus potential energy in positions and velocities.
//! - **Legendre transform**: the passage from L(q, v) to H(q, p) = p·v − L with p = ∂L/∂v.
//! - **Map**: a step as a function of the state.
//! - **Mass matrix** M = ∂²L/∂v²: it relates velocities and momenta, p = Mv, if L is quadratic in v without linear terms.
//! - **Modified energy**: an energy near H that a symplectic method keeps almost exactly. Thus the error of H does not grow.
//! - **Newton's iteration**: the solver of implicit steps. It repeats linear corrections until only rounding errors remain.
//! - **Order** p: the error of a run is proportional to hᵖ. Half of the step divides it by 2ᵖ.
//! - **Piece**: a sum of terms of the energy whose flow is known in closed form.
//! - **Poisson bracket** {f, g} = ∇f·S∇g: the rate of f under the energy g. A skew matrix S(x) defines it if it satisfies Jacobi's identity.
//! - **Pole**: a state at which the energy is infinite, such as a collision of two bodies.
//! - **Predictor**: the first guess of an implicit step, extrapolated from earlier steps.
//! - **Processor**: a change of variables at the start and at the output of a run. It removes a part of the error once, not in each step.
//! - **Projection**: a correction after each step, back to the values of the invariants. See [`Projection`](crate::Projection).
//! - **Rayleigh function** R(q, v): its derivative −∂R/∂v is the friction force.
//! - **Relaxation**: a small change of the length of each step, such that the energy stays. See [`Relaxation`](crate::Relaxation).
//! - **Report**: the constant `REPORT` of a system, with all derived formulas and proven properties.
//! - **Residual**: the difference between both sides of an equation that is being solved. It is zero at the solution.
//! - **Rounding error**: the error of a floating-point number, about 1e-16 of its value for `f64`.
//! - **Runge–Kutta–Nyström method**: a table of kicks and drifts for T quadratic in p. It needs fewer forces for its order.
//! - **Section** (Poincaré section): the states of a run at which a function is zero, for instance all passages through a plane.
//! - **Separable**: an energy of the form T(p) + V(q).
//! - **Splitting**: a method that alternates the exact flows of parts of the energy.
//! - **Stage**: an intermediate state within a step.
//! - **Step size** h: the time of one step. It may be negative.
//! - **Symmetric** (time-symmetric): a step with h and then a step with −h lead back to the start.
//! - **Symplectic**: a map that keeps the form dp ∧ dq, as every Hamiltonian flow does. In one degree of freedom it keeps areas.
//! - **Tableau, table**: the coefficients of a method. Splittings have lengths of kicks and drifts, Runge–Kutta methods have stages and weights.
//! - **Taylor series**: the solution as a polynomial in time of high order. See [`Taylor`](crate::Taylor).
//! - **Tolerance**: the accepted error of a step, relative to the largest magnitude of the coordinate so far.
//!
//! Next: [coming from other libraries](super::_15_coming_from), [errors and remedies](super::_16_errors).
