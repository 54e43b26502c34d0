//! Constraints, and the equations of the steps that keep them.

use super::methods;
use super::prepared::Prepared;
use crate::derive::{ConstraintKernels, StepKernel};
use crate::emit::context::{Context, array_type};
use crate::emit::exact;
use crate::emit::implementation::{flag, proven};
use crate::emit::structure::state;
use crate::emit::system::cotangent;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns `impl ConstrainedSystem`, `impl ConstrainedStep` for each method, and the public methods of the struct.
pub(super) fn constraints(context: &Context<'_>, kernels: &ConstraintKernels) -> TokenStream {
    let ConstraintKernels { rows, quadratic, values, velocity, departure, multipliers, steps } = kernels;
    let (array, phase, parts) = (context.positions_type(), context.phase_type(), context.parts());
    let row = array_type(&[rows.len()]);
    let printer = context.printer();
    // Names for messages: of the value, and of its rate. A row without a value is a rate itself.
    let formulas = rows.iter().map(|row| {
        let formula = printer.excerpt(row.written);
        let rate = if row.value.is_some() { format!("the rate of {formula}") } else { formula.clone() };
        quote!([#formula, #rate])
    });
    let [values, velocity] = [values, velocity].map(|routine| context.assigned(routine));
    let [departure, multipliers] = [departure, multipliers].map(|routine| context.returned(routine));
    let quadratic = flag("QUADRATIC", *quadratic);
    let items = quote! {
        type Multipliers = #row;
        const CONSTRAINTS: &'static [[&'static str; 2]] = &[#(#formulas),*];
        #quadratic

        #[inline]
        fn constraints(
            &self,
            t: R,
            q: &#array,
            values: &mut #row,
            gradients: &mut Gradients<Self, R>,
            drifts: &mut #row,
        ) {
            #values
        }
        #[inline]
        fn velocity(&self, t: R, z: &#phase, velocity: &mut #array, inverse_mass: &mut Square<#array>) {
            #parts
            #velocity
        }
        fn departure(&self, t: R, z: &#phase) -> [[#row; 2]; 2] {
            #parts
            #departure
        }
        fn multipliers(&self, t: R, z: &#phase) -> #row {
            #parts
            #multipliers
        }
    };
    let cotangent = cotangent(context);
    let constrained = proven(context, quote!(ConstrainedSystem<R>), items);
    let solved = match context.form.has_action() {
        true => {
            let solved = methods::solved_by(context, "ContactDiscreteGradient", "MultiplierStep");
            let splitting =
                exact::stepped_as(context, "ContactSplitting", &quote!(DampedRattle<ContactSplitting>), None);
            let leapfrog = exact::stepped_as(context, "ContactLeapfrog", &quote!(DampedRattle<ContactLeapfrog>), None);
            quote!(#solved #splitting #leapfrog)
        }
        false => methods::solved_by(context, "DiscreteGradient", "MultiplierStep"),
    };
    let steps = steps.iter().map(|(method, kernel)| step(context, method, kernel));
    let inherent = inherent(context, rows.len());
    quote!(#cotangent #constrained #solved #(#steps)* #inherent)
}

/// Returns `impl ConstrainedStep` for a method.
fn step(context: &Context<'_>, method: &str, step: &StepKernel) -> TokenStream {
    let StepKernel { unknowns, kernel } = step;
    let method = format_ident!("{method}");
    let (phase, parts, unknown) = (context.phase_type(), context.parts(), array_type(&unknowns.extents));
    let increments = context.per_coordinate_type();
    // The argument of the action, and the variable of its increment with its value as the result.
    let (given, increment, result) = match context.form.has_action() {
        true => (quote!(s: &R), quote!(let mut ds = R::from_f64(0.0); let action = &mut ds;), quote!(ds)),
        false => (quote!(_: &()), quote!(), quote!(())),
    };
    let names = [["Constants", "constants"], ["Start", "begin"]];
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, kernel, names, &parts, &quote!(t: R, start: R, end: R, z: &#phase, #given));
    let [residual, end, origin] = ["residual", "end", "origin"].map(|name| context.assigned(kernel.routine(name)));
    let items = quote! {
        type Unknown = #unknown;
        #types

        #functions
        #[inline(always)]
        fn residual(
            &self,
            prepared: &#prepared,
            start: &#started,
            x: &#unknown,
            residual: &mut #unknown,
            matrix: &mut Square<#unknown>,
        ) {
            #residual
        }
        #[inline(always)]
        fn end(&self, prepared: &#prepared, start: &#started, x: &#unknown) -> #increments {
            let mut end = <#phase as Array>::zero();
            #increment
            #end
            PerCoordinate { z: end, s: #result }
        }
        #[inline(always)]
        fn origin(&self, prepared: &#prepared, start: &#started) -> #unknown {
            let mut origin = <#unknown as Array>::zero();
            #origin
            origin
        }
    };
    proven(context, quote!(ConstrainedStep<#method, R>), items)
}

/// Returns the public methods of the struct.
fn inherent(context: &Context<'_>, rows: usize) -> TokenStream {
    let (name, float, coordinates) = (&context.energy.name, &context.energy.float, &context.energy.coordinates.ty);
    let state = state(context.form);
    quote! {
        impl #name {
            /// A state near this one that is on the constraints. Positions move the shortest way to first order, in the metric of the mass matrix. Momenta lose
            /// the part that leads away.
            ///
            /// # Errors
            /// If no such state is near, if constraints depend on each other there, or if the state is not finite.
            pub fn state_on_constraint(
                &self,
                state: &#state<#coordinates>,
            ) -> ::core::result::Result<#state<#coordinates>, StepError> {
                state_on_constraint::<Self, #float>(self, state)
            }

            /// The multipliers of a state: λ of the force −Gᵀλ for each `constraint` with gradient G, then μ of the force Aᵀμ for each row A of `rolling`.
            pub fn multipliers(&self, state: &#state<#coordinates>) -> [#float; #rows] {
                let (t, z, _) = state.parts();
                ConstrainedSystem::multipliers(self, t, &z)
            }
        }
    }
}
