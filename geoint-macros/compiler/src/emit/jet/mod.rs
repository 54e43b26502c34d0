//! The emitted Taylor coefficients of a solution: the coefficients of order 0, and one body for all other orders.
//!
//! The body is the method `order` of a struct of references. The runtime calls it with literal numbers for the first orders, so that the
//! optimiser unrolls the sums while the code stays small, and in a loop for the others. Each series is a local array, because the optimiser
//! then knows that no two arrays overlap.

mod arrays;
mod central;
mod numbers;
mod order;
mod rules;

use super::context::Context;
use super::implementation::proven;
use super::structure::state;
use super::tokens::{Tokens, element};
use crate::derive::JetKernel;
use crate::diff::jet::{Jet, LANES, Operand, Packs, Rate, Rule, Source, Value};
use crate::ir::Symbol;
use crate::parse::over_scalar;
use arrays::series_array;
use numbers::{StepNumber, entry, zero};
use order::Order;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Upper limit of unrolled code in bytes. Longer code is slower than a loop.
const MOST_CODE: usize = 16 << 10;

/// Lower limit of the number of unrolled orders. Fewer orders gain less than their code costs.
const FEWEST_ORDERS: usize = 6;

/// The highest order of a Taylor method.
const MOST_ORDERS: usize = 31;

/// Upper limit of unrolled orders with packs. More orders take more than 1.5 s to compile (double pendulum, order 12: 2 s). From order 15 on, the
/// compiler does not unroll the sums, and a step takes twice the time.
const MOST_ORDERS_OF_PACKS: usize = 9;

/// Returns `impl Jets` for the system, and the user's method `taylor`.
pub(super) fn jets(context: &Context<'_>, kernel: &JetKernel) -> TokenStream {
    let JetKernel { jet, start } = kernel;
    let (phase, parts, action) = (context.phase_type(), context.parts(), context.action_type());
    let energy = context.energy;
    let (plain, float, coordinates) = (&energy.name, &energy.float, &energy.coordinates.ty);
    let (state, over) = (state(context.form), over_scalar(coordinates, float, &format_ident!("T")));
    let given = if context.form.has_action() { quote!(s: &R) } else { quote!(_: &()) };
    let switches = Literal::usize_unsuffixed(jet.switches.len());
    let convolutions = Literal::usize_unsuffixed(jet.convolutions());
    let packs = Packs::of(jet);
    let orders = orders(jet, packs.as_ref());
    let packs = &packs.unwrap_or_default();
    let order = Order::new(jet, packs);
    let mut writer = Writer { context, jet, packs, orders, numbers: vec![], packed_numbers: vec![], order };
    let coefficients = writer.coefficients();
    let body = context.outputs(start, |outputs| {
        let values: Vec<Tokens> = outputs.into_iter().flat_map(|values| values.all).collect();
        writer.start(&values)
    });
    let items = quote! {
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
            #coefficients
            #parts
            #body
        }
    };
    let jets = proven(context, quote!(Jets<R>), items);
    quote! {
        #jets
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

/// Writes the code of one system.
struct Writer<'a> {
    context: &'a Context<'a>,
    jet: &'a Jet,
    /// The sums in packs. Empty if there are few sums.
    packs: &'a Packs,
    /// The function of the runtime that calls the orders.
    orders: TokenStream,
    /// The numbers computed once per step, for all orders.
    numbers: Vec<StepNumber>,
    /// Packs of numbers computed once per step, for groups of series.
    packed_numbers: Vec<[StepNumber; LANES]>,
    /// The code of one order so far.
    order: Order,
}

/// Returns the function of the runtime that calls the orders, with the number of unrolled orders. With packs, it unrolls all orders or none.
/// A loop over the last orders would put the arrays of all orders into memory, and clear them.
fn orders(jet: &Jet, packs: Option<&Packs>) -> TokenStream {
    let sums = jet.convolutions();
    let code = |orders: usize| 6 * sums * orders * orders + 16 * jet.series.len() * orders;
    let (call, most) = match packs {
        None => (quote!(orders), MOST_ORDERS),
        Some(_) => (quote!(all_orders), MOST_ORDERS_OF_PACKS),
    };
    let most = (1..=most).take_while(|orders| code(*orders) <= MOST_CODE).last().unwrap_or(0);
    let most = Literal::usize_unsuffixed(if most < FEWEST_ORDERS { 0 } else { most });
    quote!(recurrence::#call::<#most, { P }>)
}

impl Writer<'_> {
    /// Returns a number computed once per step.
    fn number(&mut self, number: StepNumber) -> TokenStream {
        entry(quote!(k), interned(&mut self.numbers, number))
    }

    /// Returns a number computed once per step for one series, or a pack of numbers for four.
    fn numbers(&mut self, sources: &[Source], number: impl Fn(Source) -> StepNumber) -> TokenStream {
        let Ok(sources) = <[Source; LANES]>::try_from(sources) else { return self.number(number(sources[0])) };
        entry(quote!(beside), interned(&mut self.packed_numbers, sources.map(number)))
    }

    /// Returns the value at the start of a step from which a series begins.
    fn value(&self, source: Source) -> Value {
        self.jet.series[source].value
    }

    /// Returns the assignments of the coefficient of order n + 1 of a coordinate, whose rate has the index `i`.
    fn next(&mut self, i: usize, rate: Rate) -> TokenStream {
        let component = self.component(rate.symbol);
        let value = rate.source.map_or_else(zero, |source| self.times(quote!(next), source));
        let newest = (i < self.coordinates_in_registers().len()).then(|| {
            let name = entry(quote!(coordinates), i);
            quote!(#name = jet[n].#component;)
        });
        let array = self.coordinate_array(rate.symbol).map(|array| {
            quote! {
                if n + 1 < P {
                    #array[n + 1] = jet[n].#component;
                }
            }
        });
        quote!(jet[n].#component = #value; #newest #array)
    }

    /// Returns the array of a coordinate, if it has one.
    fn coordinate_array(&self, symbol: Symbol) -> Option<Ident> {
        let source = self.jet.series.iter().position(|series| series.rule == Rule::State(symbol))?;
        self.has_array(Operand { source, weighted: false }).then(|| series_array(source))
    }

    /// Returns the field of a coordinate in a state.
    fn component(&self, symbol: Symbol) -> Tokens {
        let flow = self.context.form.is_flow();
        match symbol {
            Symbol::Position(i) if flow => element("z", &self.context.coordinate(i)),
            Symbol::Position(i) => element("z", &[0]).at(&self.context.coordinate(i)),
            Symbol::Momentum(i) => element("z", &[1]).at(&self.context.coordinate(i)),
            _ => "s".into(),
        }
    }

    /// Returns the coefficient of order n of a series, or zero.
    fn or_zero(&self, source: Option<Source>) -> TokenStream {
        source.map_or_else(zero, |source| self.now(&[source]))
    }

    /// Returns the code that computes the coefficients of order 0 and calls the orders.
    fn start(&self, values: &[Tokens]) -> TokenStream {
        let numbers = self.numbers.iter().map(|number| number.tokens(values));
        let packed_numbers = self.packed_numbers.iter().map(|numbers| {
            let numbers = numbers.map(|number| number.tokens(values));
            quote!([#(#numbers),*])
        });
        let packed_numbers = (!self.packed_numbers.is_empty()).then(|| quote!(beside: [#(#packed_numbers),*],));
        let newest = self.packs_in_registers().then(|| {
            let [lanes, count] = [LANES, self.packs.arrays.len()].map(Literal::usize_unsuffixed);
            quote!(newest: [[R::from_f64(0.0); #lanes]; #count],)
        });
        let masks = self.jet.conditions.iter().map(|value| &values[*value]);
        let mut first = TokenStream::new();
        let arrays = self.arrays();
        for array in &arrays {
            let name = &array.name;
            first.extend(array.first(self, values).map(|start| quote!(#name[0] = #start;)));
        }
        for rate in &self.jet.rates {
            let (component, value) = (self.component(rate.symbol), &values[rate.value]);
            first.extend(quote!(jet[0].#component = unit * (#value);));
            if let Some(array) = self.coordinate_array(rate.symbol) {
                first.extend(quote!(if P > 1 { #array[1] = jet[0].#component; }));
            }
        }
        for (i, (value, _)) in self.jet.switches.iter().enumerate() {
            let (i, value) = (Literal::usize_unsuffixed(i), &values[*value]);
            first.extend(quote!(switches[0][#i] = #value;));
        }
        let orders = &self.orders;
        let coordinates = self.coordinates_in_registers().iter().map(|rate| {
            let component = self.component(rate.symbol);
            quote!(jet[0].#component)
        });
        let zeros = arrays.iter().map(|array| (array.name.clone(), array.zeros()));
        let (names, starts): (Vec<Ident>, Vec<TokenStream>) = zeros.chain(self.central_starts(values)).unzip();
        quote! {
            let (#(#names,)*) = (#(&mut #starts,)*);
            #first
            #orders(&mut Coefficients {
                k: [#(#numbers),*], #packed_numbers #newest coordinates: [#(#coordinates),*], masks: [#(#masks),*], #(#names,)* jet, switches,
            });
        }
    }
}

/// Returns the index of an element of a list, and appends a new element.
fn interned<T: PartialEq>(list: &mut Vec<T>, element: T) -> usize {
    list.iter().position(|other| *other == element).unwrap_or_else(|| {
        list.push(element);
        list.len() - 1
    })
}
