//! Routines of a Lagrangian, added to the system that is derived from it.

use super::{Kernels, System};
use crate::compilation::Compilation;
use crate::diff;
use crate::ir::Id;
use crate::legendre::{self, Canonical, FirstOrder, Inverse, Legendre, Route};
use crate::schedule::{Kernel, Levels, Output, Routine, Scheduler, Space};

/// L, and the maps between velocities and momenta.
#[derive(Debug)]
pub(crate) struct Lagrangian {
    /// L as a function of velocities.
    pub(crate) value: Routine,
    /// ∂L/∂v.
    pub(crate) momenta: Routine,
    /// v as a function of momenta, if it has a closed form.
    pub(crate) velocities: Option<Routine>,
}

impl Lagrangian {
    /// Computes the statements of all routines.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        let Lagrangian { value, momenta, velocities } = self;
        [value, momenta].into_iter().chain(velocities).for_each(|routine| routine.schedule(scheduler));
    }
}

/// The Lagrangian of a system that is given by its energy, if ∂H/∂p = v has a formula for p.
#[derive(Debug)]
pub(crate) struct OfEnergy {
    /// L as a function of velocities, for the report.
    pub(crate) lagrangian: Id,
    /// p = ∂L/∂v.
    pub(crate) momenta: Routine,
}

impl System {
    /// Adds the Lagrangian of an energy, if it has a formula.
    pub(crate) fn with_inverse(mut self, compilation: &mut Compilation<'_>, energy: Id) -> System {
        let (degrees, positions) = (compilation.degrees(), compilation.positions());
        let found = legendre::inverse(&mut compilation.graph, energy, degrees);
        self.of_energy = found.map(|Inverse { lagrangian, momenta }| OfEnergy {
            lagrangian,
            momenta: Routine::array("momentum", "momentum", &positions, momenta),
        });
        self
    }

    /// Adds L with its momenta and velocities.
    pub(crate) fn of_lagrangian(self, compilation: &Compilation<'_>, legendre: &Legendre) -> System {
        let Legendre { lagrangian, momenta, route, divisors, .. } = legendre;
        let velocities = match route {
            Route::Energy { velocities, .. } => Some(&velocities[..]),
            Route::Velocities { .. } => None,
        };
        self.with_lagrangian(compilation, *lagrangian, momenta, velocities, divisors)
    }

    /// Adds L that is linear in velocities, and collocation in canonical coordinates if these are known.
    pub(crate) fn of_first_order(mut self, compilation: &mut Compilation<'_>, found: &FirstOrder) -> System {
        if let (Kernels::Field(field), Some(Canonical { values, rates, .. })) = (&mut self.kernels, &found.canonical) {
            let Space { symbols, extents } = &field.coordinates;
            let [values_by, rates_by] = [values, rates].map(|of| diff::jacobian(&mut compilation.graph, of, symbols));
            let canonical = vec![
                Output::array("value", extents, values.clone()),
                Output::array("rate", extents, rates.clone()),
                Output::square("value_by", extents, &values_by),
                Output::square("rate_by", extents, &rates_by),
            ];
            field.canonical = Some(Kernel::new(Levels::Prepared, vec![Routine::new("canonical", canonical)]));
        }
        self.with_lagrangian(compilation, found.lagrangian, &found.momenta, None, &found.divisors)
    }

    /// Adds the routines of L, and marks the poles at which its mass matrix is singular: the zeros of `divisors`.
    fn with_lagrangian(
        mut self,
        compilation: &Compilation<'_>,
        lagrangian: Id,
        momenta: &[Id],
        velocities: Option<&[Id]>,
        divisors: &[Id],
    ) -> System {
        let vector = |name, nodes: &[Id]| Routine::array(name, name, &compilation.positions(), nodes.to_vec());
        if let Some(poles) = &mut self.domain.poles {
            poles.mark_mass(divisors);
        }
        self.lagrangian = Some(Lagrangian {
            value: Routine::number("lagrangian", lagrangian),
            momenta: vector("momentum", momenta),
            velocities: velocities.map(|velocities| vector("velocity", velocities)),
        });
        self
    }
}
