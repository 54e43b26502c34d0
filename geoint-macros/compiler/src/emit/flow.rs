//! What flows offer beside the common part: their field, and what they keep.

use super::kernel::{Context, write};
use super::structure::self_type;
use super::system::keeps_energy;
use crate::derive::{Integrals, System};
use crate::ir::Symbol;
use crate::parse::Energy;
use crate::schedule::Plan;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The functions that users call.
pub(super) fn inherent(context: &Context<'_>, system: &System<Plan>) -> TokenStream {
    let Energy { name, float, coordinates, .. } = context.energy;
    let coordinates = &coordinates.ty;
    let names = system.integrals.iter().flat_map(|integrals| integrals.names.iter().enumerate());
    // The energy has a function already.
    let named = |i: usize| system.integrals.as_ref().is_some_and(|integrals| integrals.functions[i]);
    let names = names.filter(|(i, name)| named(*i) && (system.value.is_none() || *name != "energy"));
    let functions = names.map(|(i, integral)| {
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

/// What is kept, or changes in a known way; and `impl FirstIntegrals` of what is kept.
pub(super) fn integrals(context: &Context<'_>, integrals: &Integrals<Plan>) -> TokenStream {
    let (name, phase, parts) = (self_type(context), context.phase(), context.parts());
    let count = Literal::usize_unsuffixed(integrals.names.len());
    let values = context.values(&integrals.values, |values| quote!([#(#values),*]));
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

/// What is kept.
fn constant(context: &Context<'_>, integrals: &Integrals<Plan>) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase());
    let names = integrals.constant.iter().map(|i| &integrals.names[*i]);
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

/// What is kept and does not read time, with what projections need of it.
fn steady(context: &Context<'_>, integrals: &Integrals<Plan>) -> TokenStream {
    let (name, phase, parts) = (self_type(context), context.phase(), context.parts());
    let places = context.coordinates();
    let count = Literal::usize_unsuffixed(integrals.steady.len());
    let slopes = context.values(&integrals.slopes, |values| {
        let all = (0..integrals.steady.len()).flat_map(|k| places.iter().map(move |place| [&[k], &place[..]].concat()));
        write("slopes", &all.collect::<Vec<_>>(), &values)
    });
    let energy = integrals.energy.map(|k| {
        let (k, i) = (Literal::usize_unsuffixed(k), Literal::usize_unsuffixed(integrals.steady[k]));
        keeps_energy(context, &quote!(Integral<#k>), Some(quote!(NamedFunctions::values(self, t, z)[#i])))
    });
    let increments: Vec<Symbol> = (0..context.energy.degrees()).map(Symbol::PositionIncrement).collect();
    let changes = context.planned(&integrals.changes.last[0], (&increments, "dz"), |values| quote!([#(#values),*]));
    quote! {
        impl<R: Real> SteadyIntegrals<R> for #name {
            type Proof = ();
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
        }
        #energy
    }
}
