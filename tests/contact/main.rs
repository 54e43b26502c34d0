//! Contact systems: flows of pieces, methods, systems of the field.

mod flows;
mod systems;
