//! Stays right: what is kept over long times, what bad input gets, how trajectories are walked.

mod conservation;
mod damping;
mod adaptive;
mod refusals;
mod poles;
mod walls;
mod switches;
mod domains;
mod near_misses;
mod long_steps;
mod rounding;
mod trajectories;
mod time;
