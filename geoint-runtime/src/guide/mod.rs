//! A guide in nineteen pages. Each opens with one sentence and a program that runs.
//!
//! | page | about |
//! |---|---|
//! | [First picture](_01_first_picture) | |
//! | [Which attribute](_02_which_attribute) | |
//! | [Which method](_03_which_method) | |
//! | [The language of energies](_04_language) | |
//! | [The report, line by line](_05_report) | |
//! | [A run in practice](_06_runs) | |
//! | [Energy kept exactly](_07_energy) | |
//! | [Friction, heat, driving](_08_friction) | |
//! | [Planets](_09_planets) | |
//! | [Lagrangians, mechanisms, constraints](_10_mechanisms) | |
//! | [Fields with integrals, rigid bodies](_11_fields) | |
//! | [Events, sections, states between steps](_12_events) | |
//! | [Games and real time](_13_real_time) | |
//! | [When the macro cannot help](_14_by_hand) | |
//! | [Coming from other libraries](_15_coming_from) | |
//! | [Errors and remedies](_16_errors) | |
//! | [Evidence](_17_evidence) | |
//! | [Limits](_18_limits) | |
//! | [Glossary](_19_glossary) | |

pub mod _01_first_picture;
pub mod _02_which_attribute;
pub mod _03_which_method;
pub mod _04_language;
pub mod _05_report;
pub mod _06_runs;
pub mod _07_energy;
pub mod _08_friction;
pub mod _09_planets;
pub mod _10_mechanisms;
pub mod _11_fields;
pub mod _12_events;
pub mod _13_real_time;
pub mod _14_by_hand;
pub mod _15_coming_from;
pub mod _16_errors;
pub mod _17_evidence;
pub mod _18_limits;
pub mod _19_glossary;
