//! Contact systems: flows of pieces, methods, systems of the field.

mod cases;
mod flows;
mod implicit;
mod laws;
mod measure;
mod methods;
mod refusals;
mod runs;
mod systems;
