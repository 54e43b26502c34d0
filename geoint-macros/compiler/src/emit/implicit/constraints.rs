//! Constraints, and the equations of steps that keep them.

use super::prepared::Prepared;
use super::{square, write_field};
use crate::derive::{ConstraintKernels, StepKernel};
use crate::emit::kernel::{Context, write};
use crate::emit::structure::self_type;
use crate::emit::system::cotangent;
use crate::ir::{Graph, Symbol, print::Printer};
use crate::schedule::Plan;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// `impl ConstrainedSystem`, `impl ConstrainedStep` for each method, and what users call.
pub(super) fn constraints(context: &Context<'_>, graph: &Graph, kernels: &ConstraintKernels<Plan>) -> TokenStream {
    let ConstraintKernels { constraints, quadratic, values, velocity, departure, steps } = kernels;
    let (name, array, phase, parts) = (self_type(context), context.array(), context.phase(), context.parts());
    let (m, places) = (constraints.len(), context.coordinates());
    let multipliers = row(m);
    let rows: Vec<Vec<usize>> = (0..m).map(|k| vec![k]).collect();
    let printer = Printer::new(graph, context);
    let formulas = constraints.iter().map(|constraint| {
        let formula = printer.excerpt(*constraint);
        let rate = format!("the rate of {formula}");
        quote!([#formula, #rate])
    });
    let values = context.values(values, |values| {
        let (values, slopes) = values.split_at(m);
        let nested: Vec<Vec<usize>> =
            rows.iter().flat_map(|row| places.iter().map(move |place| [&row[..], place].concat())).collect();
        let (values, slopes) = (write("values", &rows, values), write("gradients", &nested, slopes));
        quote!(#values #slopes)
    });
    let velocity = context.values(velocity, |values| {
        let (velocity, inverse_mass) = values.split_at(places.len());
        let velocity = write("velocity", &places, velocity);
        let inverse_mass = write("inverse_mass", &square(&places), inverse_mass);
        quote!(#velocity #inverse_mass)
    });
    let departure = context.values(departure, |values| {
        let kinds = values.chunks(2 * m).map(|kind| {
            let kinds = kind.chunks(m).map(|numbers| quote!([#(#numbers),*]));
            quote!([#(#kinds),*])
        });
        quote!([#(#kinds),*])
    });
    let cotangent = cotangent(context);
    let steps = steps.iter().map(|(method, kernel)| step(context, method, kernel));
    let inherent = inherent(context);
    quote! {
        #cotangent
        impl<R: Real> ConstrainedSystem<R> for #name {
            type Proof = ();
            type Multipliers = #multipliers;
            const CONSTRAINTS: &'static [[&'static str; 2]] = &[#(#formulas),*];
            const QUADRATIC: bool = #quadratic;

            #[inline]
            fn constraints(&self, q: &#array, values: &mut #multipliers, gradients: &mut Gradients<Self, R>) {
                #values
            }
            #[inline]
            fn velocity(&self, t: R, z: &#phase, velocity: &mut #array, inverse_mass: &mut Square<#array>) {
                #parts
                #velocity
            }
            fn departure(&self, t: R, z: &#phase) -> [[#multipliers; 2]; 2] {
                #parts
                #departure
            }
        }
        impl<R: Real> Graded<R> for #name {
            type Proof = ();
            type Gradient = ByConstraint;
            type Kept = ();
        }
        #(#steps)*
        #inherent
    }
}

/// The array type of unknowns in a row.
fn row(unknowns: usize) -> TokenStream {
    let unknowns = Literal::usize_unsuffixed(unknowns);
    quote!([R; #unknowns])
}

fn step(context: &Context<'_>, method: &str, step: &StepKernel<Plan>) -> TokenStream {
    let StepKernel { unknowns, kernel: plan } = step;
    let (name, method) = (self_type(context), format_ident!("{method}"));
    let (phase, parts, unknown) = (context.phase(), context.parts(), context.unknown_type(unknowns.len()));
    let names = [["Constants", "constants"], ["Start", "begin"]];
    let start: (&[Symbol], &str) = (&[], "");
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, plan, names, (start, &parts, &quote!(t: R, z: &#phase)));
    let given: (&[Symbol], &str) = (unknowns, "x");
    let residual = context
        .planned(&plan.last[0], given, |values| write_field(context, ["residual", "matrix"], &plan.last[0], &values));
    let halves: Vec<Vec<usize>> = (0..2)
        .flat_map(|half| context.coordinates().into_iter().map(move |place| [vec![half], place].concat()))
        .collect();
    let end = context.planned(&plan.last[1], given, |values| write("end", &halves, &values));
    let origin = context
        .planned(&plan.last[2], given, |values| write("origin", &context.unknown_places(unknowns.len()), &values));
    quote! {
        impl<R: Real> ConstrainedStep<#method, R> for #name {
            type Proof = ();
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
            fn end(&self, prepared: &#prepared, start: &#started, x: &#unknown) -> #phase {
                let mut end = <#phase as Array>::zero();
                #end
                end
            }
            #[inline(always)]
            fn origin(&self, prepared: &#prepared, start: &#started) -> #unknown {
                let mut origin = <#unknown as Array>::zero();
                #origin
                origin
            }
        }
    }
}

/// What users call.
fn inherent(context: &Context<'_>) -> TokenStream {
    let (name, float, coordinates) = (&context.energy.name, &context.energy.float, &context.energy.coordinates.ty);
    quote! {
        impl #name {
            /// The nearest state that is on the constraints: positions are moved in the metric of the mass matrix, and momenta lose what
            /// leads away.
            ///
            /// # Errors
            /// Where no state is near, or constraints depend on each other there.
            pub fn state_on_constraint(
                &self,
                state: &State<#coordinates>,
            ) -> ::core::result::Result<State<#coordinates>, StepError> {
                state_on_constraint::<Self, #float>(self, state)
            }
        }
    }
}
