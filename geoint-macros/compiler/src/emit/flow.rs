//! Items of flows x' = f(x, t) only: the field, and the integrals.

use super::context::Context;
use super::implementation::proven;
use super::structure::self_type;
use super::system::keeps_energy;
use crate::derive::{Integrals, NamedFunction, System};
use crate::parse::Energy;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns the user's methods: the field, and a method for each callable integral.
pub(super) fn inherent(context: &Context<'_>, system: &System) -> TokenStream {
    let Energy { name, float, coordinates, .. } = context.energy;
    let coordinates = &coordinates.ty;
    let all = system.integrals.iter().flat_map(|integrals| integrals.all.iter().enumerate());
    // The energy already has a method.
    let callable = all.filter(|(_, of)| of.callable && (system.value.is_none() || of.name != "energy"));
    let functions = callable.map(|(i, NamedFunction { name: integral, .. })| {
        let (function, i) = (format_ident!("{integral}"), Literal::usize_unsuffixed(i));
        let doc = format!("The integral `{integral}` of a state.");
        quote! {
            #[doc = #doc]
            pub fn #function(&self, state: &FlowState<#coordinates>) -> #float {
                let (t, z, ()) = Snapshot::parts(*state);
                NamedFunctions::values(self, t, &z)[#i]
            }
        }
    });
    quote! {
        /// x' at a state.
        pub fn field(&self, state: &FlowState<#coordinates>) -> #coordinates {
            let (t, z, ()) = Snapshot::parts(*state);
            let mut slopes = <<#name as PhaseSpace<#float>>::Phase as Array>::zero();
            DifferentialEquation::rate(self, t, &z, &mut slopes);
            <FlowState<#coordinates> as Snapshot>::of(t, slopes, ()).x
        }
        #(#functions)*
    }
}

/// Returns the trait of all named functions with its implementation, and `impl FirstIntegrals` and `impl SteadyIntegrals` for the constant functions.
pub(super) fn integrals(context: &Context<'_>, integrals: &Integrals) -> TokenStream {
    let (name, phase, parts) = (self_type(context), context.phase_type(), context.parts());
    let count = Literal::usize_unsuffixed(integrals.all.len());
    let values = context.returned(&integrals.values);
    let constant = (!integrals.constant.is_empty()).then(|| constant(context, integrals));
    let steady = (!integrals.steady.is_empty()).then(|| steady(context, integrals));
    quote! {
        trait NamedFunctions<R: Real>: PhaseSpace<R> {
            fn values(&self, t: R, z: &Self::Phase) -> [R; #count];
        }
        impl<R: Real> NamedFunctions<R> for #name {
            #[inline]
            fn values(&self, t: R, z: &#phase) -> [R; #count] {
                #parts
                #values
            }
        }
        #constant
        #steady
    }
}

/// Returns `impl FirstIntegrals`.
fn constant(context: &Context<'_>, integrals: &Integrals) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase_type());
    let names = integrals.constant.iter().map(|i| &integrals.all[*i].name);
    let indices = integrals.constant.iter().map(|i| Literal::usize_unsuffixed(*i));
    let count = Literal::usize_unsuffixed(integrals.constant.len());
    quote! {
        impl<R: Real> FirstIntegrals<R> for #name {
            type Values = [R; #count];
            const NAMES: &'static [&'static str] = &[#(#names),*];

            #[inline]
            fn integrals(&self, t: R, z: &#phase) -> [R; #count] {
                let all = NamedFunctions::values(self, t, z);
                [#(all[#indices]),*]
            }
        }
    }
}

/// Returns `impl SteadyIntegrals`: gradients and changes of the integrals that do not depend on time. Projections use them.
fn steady(context: &Context<'_>, integrals: &Integrals) -> TokenStream {
    let (phase, parts) = (context.phase_type(), context.parts());
    let count = Literal::usize_unsuffixed(integrals.steady.len());
    let (slopes, changes) = (context.assigned(&integrals.slopes), context.returned(&integrals.changes));
    let energy = integrals.energy.map(|k| {
        let (k, i) = (Literal::usize_unsuffixed(k), Literal::usize_unsuffixed(integrals.steady[k]));
        keeps_energy(context, &quote!(Integral<#k>), Some(quote!(NamedFunctions::values(self, t, z)[#i])))
    });
    let items = quote! {
        type Steady = [R; #count];

        #[inline]
        fn slopes(&self, z: &#phase) -> [#phase; #count] {
            #parts
            let mut slopes = [<#phase as Array>::zero(); #count];
            #slopes
            slopes
        }
        #[inline]
        fn changes(&self, z: &#phase, dz: &#phase) -> [R; #count] {
            #parts
            #changes
        }
    };
    let steady = proven(context, quote!(SteadyIntegrals<R>), items);
    quote!(#steady #energy)
}
