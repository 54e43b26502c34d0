//! Stays right: what is kept over long times, what bad input gets, how trajectories are walked.

mod conservation;
mod adaptive;
mod refusals;
mod trajectories;
