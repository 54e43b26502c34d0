//! Is right: derivatives, orders, symplecticity, symmetry, clocks, and the tables behind them.

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
