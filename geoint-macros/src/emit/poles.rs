//! Poles between the ends of a step: what the runtime asks of them.

use super::kernel::{Context, element};
use super::straight_line;
use crate::analyze::{Jump, Pole, Quick};
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::parse::Form;
use crate::schedule;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The items of `PhaseSpace` that speak of poles; nothing where there is none.
pub(super) fn poles(context: &Context<'_>, graph: &mut Graph, poles: &[Pole]) -> Option<TokenStream> {
    if poles.is_empty() {
        return None;
    }
    let list = list(context, graph, poles);
    let signs = signs_hold(context, graph, poles);
    let clear = clear_of_poles(context, graph, poles);
    let vanishing = vanishing(context, graph, poles);
    Some(quote!(#list #signs #clear #vanishing))
}

/// What is known of each without looking.
fn list(context: &Context<'_>, graph: &Graph, poles: &[Pole]) -> TokenStream {
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    // By its path: users' structs may have this name.
    let runtime = &context.energy.runtime;
    let pole = quote!(#runtime::private::Pole);
    let entries = poles.iter().map(|each| {
        let what = format!("a pole between the ends of the step: {}", printer.excerpt(each.term));
        let (by_structure, by_parameters) = (each.quick.is_some(), each.by_parameters);
        let timed = context.energy.form == Form::Contact && !each.reads_state;
        quote!(#pole { what: #what, by_structure: #by_structure, by_parameters: #by_parameters, timed: #timed })
    });
    quote!(const POLES: &'static [#pole] = &[#(#entries),*];)
}

/// Nodes, each once, and where they are.
#[derive(Default)]
struct Roots(Vec<Id>);

impl Roots {
    fn index(&mut self, id: Id) -> Literal {
        let index = self.0.iter().position(|known| *known == id).unwrap_or_else(|| {
            self.0.push(id);
            self.0.len() - 1
        });
        Literal::usize_unsuffixed(index)
    }
}

/// The signs of parameters on which tests by structure rely.
fn signs_hold(context: &Context<'_>, graph: &mut Graph, poles: &[Pole]) -> Option<TokenStream> {
    let (mut roots, mut tests) = (Roots::default(), vec![]);
    for pole in poles {
        if let Some(Quick::Forms(_, signs)) = &pole.quick {
            tests.extend(signs.positive.iter().map(|id| (roots.index(*id), quote!(.all_positive()))));
            tests.extend(signs.not_negative.iter().map(|id| (roots.index(*id), quote!(.all_at_least_zero()))));
        }
    }
    if tests.is_empty() {
        return None;
    }
    let body = context.routine(graph, &roots.0, |values| {
        let tests = tests.iter().map(|(i, test)| quote!(signs[#i]#test));
        quote!(let signs = [#(#values),*]; #(#tests)&&*)
    });
    Some(quote!(fn signs_hold(&self) -> bool { #body }))
}

/// Tests by structure: those that divided differences do not make, and the rest.
fn clear_of_poles(context: &Context<'_>, graph: &mut Graph, poles: &[Pole]) -> Option<TokenStream> {
    let (mut always, mut otherwise) = (Tests::default(), Tests::default());
    for pole in poles {
        let signs = if pole.noticed { &mut otherwise } else { &mut always };
        match &pole.quick {
            Some(Quick::Forms(forms, _)) => signs.opposite(forms),
            Some(Quick::Angle { value, argument }) => {
                signs.opposite(&[*value]);
                always.far(*argument);
            }
            Some(Quick::SineOf(..)) | None => {}
        }
    }
    let (array, action) = (context.array(), context.action());
    let always = always.emit(context, graph);
    let otherwise = otherwise.emit(context, graph).map(|tests| quote!(if !divided { #tests }));
    if always.is_none() && otherwise.is_none() {
        return None;
    }
    Some(quote! {
        #[inline]
        fn clear_of_poles(
            &self, divided: bool, t: [R; 2], q: [&#array; 2], p: [&#array; 2], s: [&#action; 2],
        ) -> bool {
            #always
            #otherwise
            true
        }
    })
}

/// Tests of values at both ends.
#[derive(Default)]
struct Tests {
    roots: Roots,
    /// Numbers that have to be positive.
    margins: Vec<TokenStream>,
}

impl Tests {
    /// Vectors of values at both ends must not be opposite.
    fn opposite(&mut self, forms: &[Id]) {
        let products = forms.iter().map(|form| {
            let i = self.roots.index(*form);
            quote!(start[#i] * end[#i])
        });
        let product = products.reduce(|sum, product| quote!(#sum + #product));
        self.add(quote!((#product)));
    }

    /// An angle must move by less than π.
    fn far(&mut self, angle: Id) {
        let i = self.roots.index(angle);
        self.add(quote!((R::from_f64(9.0) - (end[#i] - start[#i]) * (end[#i] - start[#i]))));
    }

    fn add(&mut self, margin: TokenStream) {
        if self.margins.iter().all(|known| known.to_string() != margin.to_string()) {
            self.margins.push(margin);
        }
    }

    fn emit(self, context: &Context<'_>, graph: &mut Graph) -> Option<TokenStream> {
        let Tests { roots: Roots(roots), margins } = self;
        if margins.is_empty() {
            return None;
        }
        let (array, action, count) = (context.array(), context.action(), Literal::usize_unsuffixed(roots.len()));
        let values = context.routine(graph, &roots, |values| quote!([#(#values),*]));
        Some(quote! {
            let values = |t: R, q: &#array, p: &#array, s: &#action| -> [R; #count] { #values };
            let (start, end) = (values(t[0], q[0], p[0], s[0]), values(t[1], q[1], p[1], s[1]));
            if #(#margins.any_not_positive())||* {
                return false;
            }
        })
    }
}

/// What must not vanish, one pole after the other, in any scalar.
fn vanishing(context: &Context<'_>, graph: &mut Graph, poles: &[Pole]) -> TokenStream {
    let roots: Vec<Vec<Id>> = poles.iter().map(|pole| vec![pole.enclosable]).collect();
    enclosed(context, graph, "vanishing", &roots)
}

/// A function of `PhaseSpace` that gives values in any scalar, chosen by an index.
fn enclosed(context: &Context<'_>, graph: &mut Graph, name: &str, choices: &[Vec<Id>]) -> TokenStream {
    let parameters = context.scalars();
    let input = |symbol: Symbol| match symbol {
        Symbol::Q(i) => element(quote!(q), &[i as usize]),
        Symbol::P(i) => element(quote!(p), &[i as usize]),
        Symbol::S => quote!(s),
        Symbol::Parameter(i) if (i as usize) < parameters.len() => element(quote!(parameters), &[i as usize]),
        symbol => context.input(symbol),
    };
    let mut arm = |(i, roots): (usize, &Vec<Id>)| {
        let block = schedule::routine(graph, roots);
        let body = straight_line::routine(&block, &input, |values| match &values[..] {
            [value] => value.clone(),
            _ => quote!([#(#values),*]),
        });
        let i = Literal::usize_unsuffixed(i);
        let pattern = if i.to_string() == (choices.len() - 1).to_string() { quote!(_) } else { quote!(#i) };
        quote!(#pattern => { #body })
    };
    let arms: Vec<TokenStream> = choices.iter().enumerate().map(&mut arm).collect();
    let values = |scalar: TokenStream| match choices[0].len() {
        1 => scalar,
        n => {
            let n = Literal::usize_unsuffixed(n);
            quote!([#scalar; #n])
        }
    };
    let (name, outside, inside) = (format_ident!("{name}"), values(quote!(Scalar)), values(quote!(R)));
    quote! {
        fn #name<Scalar: Real>(
            &self, index: usize, lift: impl Fn(R) -> Scalar, t: Scalar, q: &[Scalar], p: &[Scalar], s: Scalar,
        ) -> #outside {
            fn values<R: Real>(index: usize, parameters: &[R], t: R, q: &[R], p: &[R], s: R) -> #inside {
                match index { #(#arms)* }
            }
            values(index, &[#(lift(#parameters)),*], t, q, p, s)
        }
    }
}

/// The items of `PhaseSpace` that speak of conditions; nothing where none reads the state.
pub(super) fn jumps(context: &Context<'_>, graph: &mut Graph, jumps: &[Jump]) -> Option<TokenStream> {
    if jumps.is_empty() {
        return None;
    }
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    let what = jumps
        .iter()
        .map(|jump| format!("the energy jumps at the end of the step, by {}", printer.excerpt(jump.height)));
    let what: Vec<String> = what.collect();
    let (array, action, count) = (context.array(), context.action(), Literal::usize_unsuffixed(jumps.len()));
    let sides: Vec<Id> = jumps.iter().map(|jump| jump.side).collect();
    let sides = context.routine(graph, &sides, |values| quote!([#(#values),*]));
    let roots: Vec<Vec<Id>> = jumps.iter().map(|jump| vec![jump.side, jump.height]).collect();
    let heights = enclosed(context, graph, "jump", &roots);
    Some(quote! {
        const JUMPS: &'static [&'static str] = &[#(#what),*];

        #[inline]
        fn same_sides(&self, t: R, q: [&#array; 2], p: [&#array; 2], s: [&#action; 2]) -> bool {
            let sides = |q: &#array, p: &#array, s: &#action| -> [R; #count] { #sides };
            sides(q[0], p[0], s[0]) == sides(q[1], p[1], s[1])
        }
        #heights
    })
}
