//! The Taylor coefficients of a solution: the start, and one body for every order.
//!
//! The body stands once, as the method of a struct of references: the runtime calls it with literal numbers for the first orders, for
//! which the optimiser then unrolls the sums, as long as the code stays small, and the others go through a loop. Series are local arrays:
//! then no two of them can be the same memory.

mod arrays;
mod central;
mod numbers;
mod order;
mod rules;

use super::given::element;
use super::kernel::Context;
use super::structure::{self_type, state};
use super::tokens::Tokens;
use crate::derive::JetKernel;
use crate::diff::jet::{Jet, LANES, Packs, Rate, Rule, Source, Value};
use crate::ir::Symbol;
use crate::parse::over_scalar;
use crate::schedule::Plan;
use arrays::{Stored, array_of, coordinate, kept};
use numbers::{Prepared, prepared, zero};
use order::Order;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Code beyond this many bytes is slower than a loop.
const MOST_CODE: usize = 16 << 10;

/// Fewer unrolled orders are not worth their code.
const FEWEST: usize = 6;

/// No method has more orders than this.
const MOST_ORDERS: usize = 31;

/// With more orders code with sums side by side takes more than 1.5 s to compile (a double pendulum, order 12: 2 s), and from 15 on the compiler leaves
/// loops over sums: twice the time.
const MOST_ORDERS_OF_LANES: usize = 9;

/// `impl Jets`, and the method that users call.
pub(super) fn jets(context: &Context<'_>, found: &JetKernel<Plan>) -> TokenStream {
    let JetKernel { jet, start } = found;
    let (name, phase, parts, action) = (self_type(context), context.phase(), context.parts(), context.action());
    let energy = context.energy;
    let (plain, float, coordinates) = (&energy.name, &energy.float, &energy.coordinates.ty);
    let scalar = format_ident!("T");
    let (state, over) = (state(energy.form), over_scalar(coordinates, float, &scalar));
    let given = if energy.form.has_action() { quote!(s: &R) } else { quote!(_: &()) };
    let switches = Literal::usize_unsuffixed(jet.switches.len());
    let convolutions = Literal::usize_unsuffixed(jet.convolutions());
    let mut writer =
        Writer { context, jet, lanes: Packs::of(jet), numbers: vec![], beside: vec![], order: Order::default() };
    let order = writer.body();
    let body = context.planned(&start.last[0], (&[], ""), |values| writer.start(&values));
    quote! {
        impl<R: Real> Jets<R> for #name {
            type Proof = ();
            type Switches = [R; #switches];
            type Over<T: Real> = #state<#over>;
            const CONVOLUTIONS: usize = #convolutions;

            #[inline]
            fn jet<const P: usize>(
                &self,
                unit: R,
                t: R,
                z: &#phase,
                #given,
                jet: &mut [PerCoordinate<#phase, #action>; P],
                switches: &mut [[R; #switches]; P],
            ) {
                #order
                #parts
                #body
            }
        }
        impl #plain {
            /// This system by Taylor series of its solution, from `state` on.
            ///
            /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
            pub fn taylor<M: TaylorMethod<Self, #float>>(self, method: M, state: #state<#coordinates>) -> TaylorIntegrator<Self, M, #float> {
                TaylorIntegrator::new(self, method, state)
            }
        }
    }
}

struct Writer<'a> {
    context: &'a Context<'a>,
    jet: &'a Jet,
    /// Sums side by side; one by one if there are few.
    lanes: Option<Packs>,
    /// What orders read of the start, by the values there.
    numbers: Vec<Prepared>,
    /// The same of series side by side.
    beside: Vec<[Prepared; LANES]>,
    order: Order,
}

impl Writer<'_> {
    /// How orders are called, and how many are unrolled at most. With sums side by side all or none: where a loop is left, arrays are in memory for
    /// all of them, and must be cleared.
    fn orders(&self) -> TokenStream {
        let sums = self.jet.convolutions();
        let code = |orders: usize| 6 * sums * orders * orders + 16 * self.jet.series.len() * orders;
        let (call, most) = match self.lanes {
            Some(_) => (quote!(all_orders), MOST_ORDERS_OF_LANES),
            None => (quote!(orders), MOST_ORDERS),
        };
        let most = (1..=most).take_while(|orders| code(*orders) <= MOST_CODE).last().unwrap_or(0);
        let most = Literal::usize_unsuffixed(if most < FEWEST { 0 } else { most });
        quote!(recurrence::#call::<#most, { P }>)
    }

    /// A number of the start, as orders read it.
    fn number(&mut self, number: Prepared) -> TokenStream {
        let place = self.numbers.iter().position(|other| *other == number).unwrap_or_else(|| {
            self.numbers.push(number);
            self.numbers.len() - 1
        });
        let place = Literal::usize_unsuffixed(place);
        quote!(k[#place])
    }

    /// A number of the start for each of several series side by side, or for one.
    fn numbers(&mut self, sources: &[Source], number: impl Fn(Source, &Self) -> Prepared) -> TokenStream {
        let Ok(sources) = <[Source; LANES]>::try_from(sources) else { return self.number(number(sources[0], self)) };
        let numbers = sources.map(|source| number(source, self));
        let place = self.beside.iter().position(|other| *other == numbers).unwrap_or_else(|| {
            self.beside.push(numbers);
            self.beside.len() - 1
        });
        let place = Literal::usize_unsuffixed(place);
        quote!(beside[#place])
    }

    fn value(&self, source: Source) -> Value {
        self.jet.series[source].value
    }

    /// The coefficient of order n + 1 of a coordinate, the place of its rate.
    fn next(&mut self, i: usize, rate: Rate) -> TokenStream {
        let place = self.place(rate.symbol);
        let value = match rate.source {
            Some(source) => self.times(quote!(next), source),
            None => zero(),
        };
        let at_hand = self.coordinates_at_hand().get(i).map(|_| {
            let name = coordinate(i);
            quote!(#name = jet[n].#place;)
        });
        let array = self.array_of(rate.symbol).map(|array| {
            quote! {
                if n + 1 < P {
                    #array[n + 1] = jet[n].#place;
                }
            }
        });
        quote!(jet[n].#place = #value; #at_hand #array)
    }

    /// The array of a coordinate that has one.
    fn array_of(&self, symbol: Symbol) -> Option<Ident> {
        let source = self.jet.series.iter().position(|series| series.rule == Rule::State(symbol))?;
        self.has_array(source).then(|| kept(source))
    }

    /// Where a coordinate is in a point.
    fn place(&self, symbol: Symbol) -> Tokens {
        let flow = self.context.energy.form.is_flow();
        match symbol {
            Symbol::Position(i) if flow => element("z", &self.context.coordinate(i)),
            Symbol::Position(i) => element("z", &[0]).at(&self.context.coordinate(i)),
            Symbol::Momentum(i) => element("z", &[1]).at(&self.context.coordinate(i)),
            _ => "s".into(),
        }
    }

    fn or_zero(&self, source: Option<Source>) -> TokenStream {
        source.map_or_else(zero, |source| self.now(&[source]))
    }

    /// The values at the start, the coefficients of order 0, and all orders.
    fn start(&self, values: &[Tokens]) -> TokenStream {
        let numbers = self.numbers.iter().map(|number| prepared(*number, values));
        let beside = self.beside.iter().map(|numbers| {
            let numbers = numbers.map(|number| prepared(number, values));
            quote!([#(#numbers),*])
        });
        let beside = (!self.beside.is_empty()).then(|| quote!(beside: [#(#beside),*],));
        let at_hand = self.are_at_hand().then(|| {
            let [lanes, number] = [LANES, self.lanes.iter().map(|lanes| lanes.arrays.len()).sum()];
            let [lanes, number] = [lanes, number].map(Literal::usize_unsuffixed);
            quote!(newest: [[R::from_f64(0.0); #lanes]; #number],)
        });
        let masks = self.jet.conditions.iter().map(|value| &values[*value]);
        let mut first = TokenStream::new();
        let arrays = self.arrays(values);
        for Stored { name, first: start, .. } in &arrays {
            first.extend(start.as_ref().map(|start| quote!(#name[0] = #start;)));
        }
        for rate in &self.jet.rates {
            let (place, value) = (self.place(rate.symbol), &values[rate.value]);
            first.extend(quote!(jet[0].#place = unit * (#value);));
            if let Some(array) = self.array_of(rate.symbol) {
                first.extend(quote!(if P > 1 { #array[1] = jet[0].#place; }));
            }
        }
        for (i, (value, _)) in self.jet.switches.iter().enumerate() {
            let (i, value) = (Literal::usize_unsuffixed(i), &values[*value]);
            first.extend(quote!(switches[0][#i] = #value;));
        }
        let places = self.coordinates_at_hand().iter().map(|rate| self.place(rate.symbol));
        let coordinates = places.map(|place| quote!(jet[0].#place));
        let orders = self.orders();
        let zeros: Vec<TokenStream> = arrays.iter().map(Stored::zeros).collect();
        let arrays: Vec<Ident> = arrays.into_iter().map(|array| array.name).collect();
        let (central, central_starts) = (self.central_names(), self.central_starts(values));
        quote! {
            let (#(#arrays,)* #(#central,)*) = (#(&mut #zeros,)* #(&mut #central_starts,)*);
            #first
            #orders(&mut Coefficients {
                k: [#(#numbers),*], #beside #at_hand coordinates: [#(#coordinates),*], masks: [#(#masks),*], #(#arrays,)* #(#central,)* jet, switches,
            });
        }
    }
}
