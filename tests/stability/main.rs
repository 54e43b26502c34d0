//! Stays right: what is kept over long times, what bad input gets, how trajectories are walked.

mod damping;
mod adaptive;
mod by_value;
mod refusals;
mod poles;
mod poles_in_time;
mod walls;
mod steep;
mod switches;
mod domains;
mod forms;
mod near_misses;
mod small_waves;
mod amplitudes;
mod units;
mod long_steps;
mod rest;
mod rounding;
mod time;
mod end_of_time;
mod names;
mod tolerance;
mod one_by_one;
mod saved;
mod settled;
mod hostile;
