//! Is right: derivatives, orders, symplecticity, symmetry, clocks, and the tables behind them.

/// What a method `M` in a wrapper passes on, for methods of which a test changes the rest.
macro_rules! passed_on {
    () => {
        type Proof = M::Proof;
        type Prepared = M::Prepared;
        type Memory = M::Memory;

        fn claims(&self) -> Claims {
            self.0.claims()
        }
        fn memory() -> Self::Memory {
            M::memory()
        }
        fn step<C: Summation<S::Phase>, P: Probe<S, f64>>(
            prepared: &Self::Prepared,
            memory: &mut Self::Memory,
            step: Step<'_, S, f64, C, P>,
        ) -> Result<(), Refusal> {
            M::step(prepared, memory, step)
        }
    };
}

mod double;
mod defects;
mod estimates;
mod families;
mod kepler;
mod language;
mod derivatives;
mod first_integrals;
mod slopes;
mod tables;
mod modified;
mod orders;
mod perturbed;
mod corrected;
mod geometry;
mod guesses;
mod discrete_gradients;
mod mean_value;
mod bodies;
mod branches;
mod clock;
mod quotients;
mod rigid_body;
