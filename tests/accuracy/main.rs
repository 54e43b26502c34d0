//! Accuracy: derivatives, orders, symplecticity, symmetry and time, and the tables and functions behind these properties.

/// Forwards the associated types, the claims and the step of `Method` to the method `M` in the wrapper `Wrapper<M>(M)`. The test writes the other
/// items.
macro_rules! delegate_step {
    () => {
        type Proof = M::Proof;
        type Prepared = M::Prepared;
        type Memory = M::Memory;

        fn claims(&self) -> Claims {
            self.0.claims()
        }
        fn memory(z: &S::Phase) -> Self::Memory {
            M::memory(z)
        }
        fn step<C: Summation<S::Phase>, P: Probe<S, f64>>(
            prepared: &Self::Prepared,
            memory: &mut Self::Memory,
            step: Step<'_, S, f64, C, P>,
        ) -> Result<(), Failure> {
            M::step(prepared, memory, step)
        }
    };
}

/// Double-double arithmetic, the scalar of the reference solutions.
mod double;
/// Error estimates of Gauss methods.
mod defects;
/// Error estimates of Runge–Kutta–Nyström tables.
mod estimates;
/// Emitted loops over many alike terms.
mod families;
/// Kepler's equation and Kepler's motion.
mod kepler;
/// Functions and syntax that an energy may use.
mod language;
/// Values, gradients and Jacobians of every problem.
mod derivatives;
/// Fields with first integrals.
mod first_integrals;
/// Emitted divided differences.
mod slopes;
/// Order conditions of all tables.
mod tables;
/// Modified energy of Störmer–Verlet.
mod modified;
/// Observed orders of methods.
mod orders;
/// Methods for H = A + B with a small B.
mod perturbed;
/// Projected and relaxed Runge–Kutta methods.
mod corrected;
/// Corrections of invariants where a coordinate hardly moves.
mod free_flights;
/// Corrections of invariants with an angle.
mod turns;
/// Integrals that jump.
mod jumping_integrals;
/// Symplecticity and symmetry.
mod geometry;
/// Number of evaluations in implicit steps.
mod guesses;
/// Methods with discrete gradients.
mod discrete_gradients;
/// Mean value of the gradient along a step.
mod mean_value;
/// Rigid bodies with attitudes.
mod bodies;
/// Branches of an energy, with scalars for two trajectories.
mod branches;
/// Time of a run with steps of one length, and `f32`.
mod clock;
/// Number of preparations of coefficients.
mod preparations;
/// Divided differences beside quotients of differences.
mod quotients;
/// A rigid body as a system that implements the traits by hand.
mod rigid_body;
