//! Where the energy is defined: what is tested at a point.

use super::damping;
use super::kernel::Context;
use super::poles;
use crate::derive::{Domain, Sign};
use crate::ir::{Graph, print::Printer};
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::quote;

/// The items of `PhaseSpace` that speak of the domain.
pub(super) fn domain(context: &Context<'_>, graph: &Graph, domain: &Domain<Plan>) -> TokenStream {
    let (phase, parts, action) = (context.phase(), context.parts(), context.action());
    let outside = outside_domain(context, graph, domain);
    let poles = domain.poles.as_ref().map(|poles| poles::poles(context, graph, poles));
    let jumps = domain.jumps.as_ref().map(|jumps| poles::jumps(context, graph, jumps));
    let examined = domain.examined.then(|| {
        quote!(
            const EXAMINED: bool = true;
        )
    });
    quote! {
        fn outside_domain(
            &self, t: R, z: &#phase, s: &#action,
        ) -> ::core::option::Option<&'static str> {
            #parts
            #outside
        }
        #examined
        #poles
        #jumps
    }
}

/// The first condition that does not hold.
fn outside_domain(context: &Context<'_>, graph: &Graph, domain: &Domain<Plan>) -> TokenStream {
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    context.values(&domain.arguments, |mut values| {
        let matrix = damping::matrix_test(context, &values.split_off(domain.checks.len()));
        let tests = domain.checks.iter().zip(values).map(|(check, value)| {
            let test = match check.if_it_is {
                Sign::Negative => quote!(.any_below(0.0)),
                Sign::NotPositive => quote!(.any_not_positive()),
                Sign::Zero => quote!(.abs().any_not_positive()),
            };
            let message = format!("{}: {}", check.what, printer.excerpt(check.term));
            quote!(if #value #test { return ::core::option::Option::Some(#message); })
        });
        quote!(#(#tests)* #matrix ::core::option::Option::None)
    })
}
