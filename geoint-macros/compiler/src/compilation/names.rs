//! Names of symbols as the user wrote them.

use crate::ir::{Symbol, print::Naming};
use crate::lower::VELOCITY;
use crate::parse::{Energy, Form, Role, Shape};
use proc_macro2::TokenStream;

/// The user's names of coordinates, parameters and constants.
pub(crate) struct Names<'a> {
    pub(crate) energy: &'a Energy,
    /// Constants that are defined outside of the function. Their symbols follow the parameters.
    pub(crate) constants: Vec<TokenStream>,
}

impl Naming for Names<'_> {
    fn name(&self, symbol: Symbol) -> String {
        let of_role = |role: Role, i: u32| match role {
            Role::Action | Role::Time => self.of(role),
            _ => indexed(self.of(role), &self.energy.coordinates.shape, i as usize),
        };
        if self.energy.form == Form::Bodies
            && let Some(name) = self.of_body(symbol)
        {
            return name;
        }
        match symbol {
            Symbol::Position(i) => of_role(Role::Position, i),
            Symbol::Momentum(i) => of_role(Role::Momentum, i),
            Symbol::Velocity(i) => of_role(Role::Velocity, i),
            Symbol::Action => of_role(Role::Action, 0),
            Symbol::Time | Symbol::StepStart | Symbol::StepEnd => of_role(Role::Time, 0),
            Symbol::StepLength => "h".into(),
            Symbol::GradientWeight => "g".into(),
            Symbol::PositionIncrement(i) => format!("d{}", of_role(Role::Position, i)),
            Symbol::MomentumIncrement(i) => format!("d{}", of_role(Role::Momentum, i)),
            Symbol::ActionIncrement => format!("d{}", of_role(Role::Action, 0)),
            Symbol::VelocityIncrement(i) => format!("d{}", of_role(Role::Velocity, i)),
            Symbol::Multiplier(k) => format!("λ[{k}]"),
            Symbol::Parameter(index) => self.of_parameter(index as usize),
        }
    }
}

impl Names<'_> {
    /// Returns the name of an argument. A Lagrangian has no argument for momenta, and an energy has none for velocities: these have default names.
    pub(crate) fn of(&self, role: Role) -> String {
        let default = match role {
            Role::Momentum => "p",
            // A parameter may have the usual name of velocities.
            Role::Velocity if self.energy.arguments.iter().any(|argument| argument.name == VELOCITY) => "q'",
            Role::Velocity => VELOCITY,
            _ => "",
        };
        self.energy.argument(role).map_or_else(|| default.into(), |argument| argument.name.to_string())
    }

    /// Returns the name of a scalar of a parameter, or of a constant.
    fn of_parameter(&self, mut index: usize) -> String {
        for argument in self.energy.parameters() {
            if index < argument.shape.len() {
                return indexed(argument.name.to_string(), &argument.shape, index);
            }
            index -= argument.shape.len();
        }
        self.constants[index].to_string().replace(' ', "")
    }

    /// Returns the name of a component of an attitude, an angular momentum, or a centre of mass.
    fn of_body(&self, symbol: Symbol) -> Option<String> {
        let attitudes = 4 * self.energy.bodies();
        let (vector, quaternion) = (["x", "y", "z", ""], ["i", "j", "k", "w"]);
        let (role, index, components) = match symbol {
            Symbol::Position(i) if i < attitudes => (Role::Attitude, i, quaternion),
            Symbol::Momentum(i) if i < attitudes => (Role::AngularMomentum, i, vector),
            Symbol::Position(i) => (Role::Position, i - attitudes, vector),
            Symbol::Momentum(i) => (Role::Momentum, i - attitudes, vector),
            _ => return None,
        };
        let argument = self.energy.argument(role)?;
        let body = if argument.shape.extents.len() == 1 { String::new() } else { format!("[{}]", index / 4) };
        Some(format!("{}{body}.{}", argument.name, components[index as usize % 4]))
    }
}

/// `name[i][j]…` of the `i`-th number of an array.
fn indexed(name: String, shape: &Shape, i: usize) -> String {
    shape.indices(i).iter().fold(name, |name, index| format!("{name}[{index}]"))
}
