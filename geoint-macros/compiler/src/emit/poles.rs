//! Poles of the energy, and changes of conditions, between the start and the end of a step.

use super::context::{Context, Values, by_output};
use super::implementation::flag;
use super::tokens::Tokens;
use super::writer::{Names, routine};
use crate::analyze::Jump;
use crate::derive::{Jumps, Margin, Margins, Poles, Signs};
use crate::ir::Symbol;
use crate::schedule::{Array, Kernel, Layout};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns the items of `PhaseSpace` about poles.
pub(super) fn poles(context: &Context<'_>, poles: &Poles) -> TokenStream {
    let list = list(context, poles);
    let signs = poles.signs.as_ref().map(|signs| signs_hold(context, signs));
    let clear = clear_of_poles(context, poles);
    let vanishing = enclosed(context, "vanishing", &poles.vanishing, quote!(Scalar), quote!(R));
    quote!(#list #signs #clear #vanishing)
}

/// Returns the list of all poles, with their known properties.
fn list(context: &Context<'_>, poles: &Poles) -> TokenStream {
    let printer = context.printer();
    // The path is full, because a struct of the user may have this name.
    let runtime = &context.energy.runtime;
    let pole = quote!(#runtime::private::Pole);
    let entries = poles.all.iter().map(|each| {
        let (term, edge) = (printer.excerpt(each.term), each.is_edge);
        let what = match edge {
            false => format!("a pole between the ends of the step: {term}"),
            true => format!("an edge of the domain between the ends of the step: {term}"),
        };
        let (by_structure, by_parameters, timed) = (each.quick.is_some(), each.by_parameters, each.of_time);
        let of_mass = each.of_mass;
        quote!(#pole {
            what: #what, by_structure: #by_structure, by_parameters: #by_parameters, timed: #timed, edge: #edge, of_mass: #of_mass
        })
    });
    quote!(const POLES: &'static [#pole] = &[#(#entries),*];)
}

/// Returns the function that checks the signs of parameters. Tests by structure rely on these signs.
fn signs_hold(context: &Context<'_>, signs: &Signs) -> TokenStream {
    let body = context.outputs(&signs.0, |outputs| {
        let tests = outputs.iter().flat_map(|values| {
            let positive = values.output.name == "positive";
            values.all.iter().map(move |value| match positive {
                true => quote!(#value.all_positive()),
                false => quote!(#value.all_at_least_zero()),
            })
        });
        quote!(#(#tests)&&*)
    });
    quote!(fn signs_hold(&self) -> bool { #body })
}

/// Returns the function with the tests by structure. Divided differences make some of the tests themselves.
fn clear_of_poles(context: &Context<'_>, poles: &Poles) -> Option<TokenStream> {
    let (phase, action) = (context.phase_type(), context.action_type());
    let always = poles.always.as_ref().map(|margins| positive(context, margins));
    let undivided = poles.undivided.as_ref().map(|margins| {
        let tests = positive(context, margins);
        quote!(if !divided { #tests })
    });
    (always.is_some() || undivided.is_some()).then(|| {
        quote! {
            #[inline]
            fn clear_of_poles(
                &self, divided: bool, t: [R; 2], z: [&#phase; 2], s: [&#action; 2],
            ) -> bool {
                #always
                #undivided
                true
            }
        }
    })
}

/// Returns the statements that return `false` if a margin is not positive.
fn positive(context: &Context<'_>, Margins { values, margins }: &Margins) -> TokenStream {
    let (phase, parts, action) = (context.phase_type(), context.parts(), context.action_type());
    let (count, values) = (Literal::usize_unsuffixed(values.nodes().len()), context.returned(values));
    let margin = |margin: &Margin| match margin {
        Margin::Together(places) => {
            let places = places.iter().map(|i| Literal::usize_unsuffixed(*i));
            let products = places.map(|i| quote!(start[#i] * end[#i]));
            quote!((#(#products)+*))
        }
        Margin::Near(place) => {
            let i = Literal::usize_unsuffixed(*place);
            quote!((R::from_f64(9.0) - (end[#i] - start[#i]) * (end[#i] - start[#i])))
        }
    };
    let margins = margins.iter().map(margin);
    quote! {
        let values = |t: R, z: &#phase, s: &#action| -> [R; #count] { #parts #values };
        let (start, end) = (values(t[0], z[0], s[0]), values(t[1], z[1], s[1]));
        if #(#margins.any_not_positive())||* {
            return false;
        }
    }
}

/// Returns a generic function of `PhaseSpace`. It evaluates one of several expressions, chosen by an index, in any scalar type.
fn enclosed(
    context: &Context<'_>,
    name: &str,
    choices: &Kernel,
    outside: TokenStream,
    inside: TokenStream,
) -> TokenStream {
    let row = Layout::of(context.energy).row_of_parameters();
    let (parameters, layout) = (context.scalars(), Layout::flat(&context.energy.coordinates.shape, &row));
    let array = |array| match array {
        Array::Parameter(_) => Tokens::from("parameters"),
        Array::Number(Symbol::Action) => Tokens::from("s"),
        array => context.array_name("z", array),
    };
    let arms = choices.routines.iter().enumerate().map(|(i, choice)| {
        let names = Names { registers: &context.registers, layout: &layout, array: &array };
        let body = routine(&choice.block, names, |results| {
            by_output(choice, results).iter().map(Values::returned).collect::<TokenStream>()
        });
        let number = Literal::usize_unsuffixed(i);
        let pattern = if i + 1 == choices.routines.len() { quote!(_) } else { quote!(#number) };
        quote!(#pattern => { #body })
    });
    let name = format_ident!("{name}");
    quote! {
        fn #name<Scalar: Real>(
            &self, index: usize, lift: impl Fn(R) -> Scalar, t: Scalar, z: &[Scalar], s: Scalar,
        ) -> #outside {
            fn values<R: Real>(index: usize, parameters: &[R], t: R, z: &[R], s: R) -> #inside {
                match index { #(#arms)* }
            }
            values(index, &[#(lift(#parameters)),*], t, z, s)
        }
    }
}

/// Returns the items of `PhaseSpace` about jumps at conditions.
pub(super) fn jumps(context: &Context<'_>, jumps: &Jumps) -> TokenStream {
    let printer = context.printer();
    let height = |jump: &Jump| printer.excerpt(jump.shown);
    let is_flow = context.form.is_flow();
    let what = jumps.all.iter().map(|jump| match is_flow {
        true => format!("an integral jumps where a condition changes, by {}: shift one side so that both meet", height(jump)),
        false => format!(
            "the energy jumps where a condition changes, by {}: shift one side so that both meet, or take a method that keeps the energy, \
             such as `DiscreteGradient`",
            height(jump)
        ),
    });
    let (phase, parts, action) = (context.phase_type(), context.parts(), context.action_type());
    let count = Literal::usize_unsuffixed(jumps.all.len());
    let may_jump = jumps.edge.map(|_| flag("CONTINUOUS", false));
    let sides = context.returned(&jumps.sides);
    let heights = enclosed(context, "jump", &jumps.heights, quote!([Scalar; 2]), quote!([R; 2]));
    quote! {
        const JUMPS: &'static [&'static str] = &[#(#what),*];
        #may_jump

        #[inline]
        fn same_sides(&self, t: R, z: [&#phase; 2], s: [&#action; 2]) -> bool {
            let sides = |z: &#phase, s: &#action| -> [R; #count] { #parts #sides };
            sides(z[0], s[0]) == sides(z[1], s[1])
        }
        #heights
    }
}
