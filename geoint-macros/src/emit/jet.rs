//! The Taylor coefficients of a solution: the start, and one body for every order.
//!
//! The body stands once. It is called with literal numbers for the first orders, for which the optimiser then unrolls the sums, as
//! long as the code stays small; the others go through a loop. Series are local arrays, an argument each: then no two of them can be
//! the same memory.

use super::kernel::{Context, element};
use super::system::{self_type, state};
use crate::derive::JetKernel;
use crate::diff::jet::{Factor, Jet, LANES, Lanes, Operand, Rate, Rule, Source, Value, Weight, sums};
use crate::ir::{Number, Symbol};
use crate::parse::over_scalar;
use crate::schedule::Plan;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Code beyond this many bytes is slower than a loop: the double pendulum with 20 unrolled orders (48 KB) takes 1.8 times of the loop.
const MOST_CODE: usize = 16 << 10;

/// Fewer unrolled orders are not worth their code.
const FEWEST: usize = 6;

/// No method has more orders than this.
const MOST_ORDERS: usize = 32;

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
    let mut writer = Writer { context, jet, lanes: Lanes::of(jet), numbers: vec![] };
    let order = writer.order();
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
            pub fn taylor<M: TaylorMethod>(self, method: M, state: #state<#coordinates>) -> TaylorIntegrator<Self, M, #float> {
                TaylorIntegrator::new(self, method, state)
            }
        }
    }
}

struct Writer<'a> {
    context: &'a Context<'a>,
    jet: &'a Jet,
    /// Sums side by side; one by one if there are few.
    lanes: Option<Lanes>,
    /// What orders read of the start, by the values there.
    numbers: Vec<Prepared>,
}

/// An array of coefficients, an entry an order.
struct Stored {
    name: Ident,
    /// Whether entries are coefficients side by side.
    of_lanes: bool,
    /// The entry of order 0, if it is not zero.
    first: Option<TokenStream>,
}

impl Stored {
    /// The type of an entry.
    fn entry(&self) -> TokenStream {
        let lanes = Literal::usize_unsuffixed(LANES);
        if self.of_lanes { quote!([R; #lanes]) } else { quote!(R) }
    }

    fn zeros(&self) -> TokenStream {
        let lanes = Literal::usize_unsuffixed(LANES);
        if self.of_lanes { quote!([[R::from_f64(0.0); #lanes]; P]) } else { quote!([R::from_f64(0.0); P]) }
    }
}

/// A number that is computed once a step.
#[derive(Clone, Copy, PartialEq)]
enum Prepared {
    Value(Value),
    /// 1/v.
    Reciprocal(Value),
    /// 1/(2v).
    HalfReciprocal(Value),
    /// α + 1.
    Next(Factor),
    /// α·w/u.
    Ratio(Factor, Value, Value),
    /// c·v.
    Scaled(Number, Value),
}

fn kept(source: Source) -> Ident {
    format_ident!("u{source}")
}

fn weighted(source: Source) -> Ident {
    format_ident!("ju{source}")
}

/// The array of one operand.
fn array_of(operand: Operand) -> Ident {
    if operand.weighted { weighted(operand.source) } else { kept(operand.source) }
}

/// The array of operands side by side.
fn side_by_side(array: usize) -> Ident {
    format_ident!("lanes{array}")
}

fn coefficient(source: Source) -> Ident {
    format_ident!("c{source}")
}

/// A constant of the scalar type.
fn constant(number: Number) -> TokenStream {
    let literal = Literal::f64_unsuffixed(number.to_f64().abs());
    match number.to_f64() {
        x if x.is_nan() => quote!(R::from_f64(f64::NAN)),
        x if x.is_infinite() && x > 0.0 => quote!(R::from_f64(f64::INFINITY)),
        x if x.is_infinite() => quote!(R::from_f64(-f64::INFINITY)),
        x if x < 0.0 => quote!(R::from_f64(-#literal)),
        _ => quote!(R::from_f64(#literal)),
    }
}

impl Writer<'_> {
    /// How many orders are unrolled.
    fn unrolled(&self) -> usize {
        let sums = self.lanes.as_ref().map_or(self.jet.convolutions(), |lanes| lanes.groups.len());
        let code = |orders: usize| 6 * sums * orders * orders + 16 * self.jet.series.len() * orders;
        let most = (1..MOST_ORDERS).take_while(|orders| code(*orders) <= MOST_CODE).last().unwrap_or(0);
        if most < FEWEST { 0 } else { most }
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

    fn value(&self, source: Source) -> Value {
        self.jet.series[source].value
    }

    /// Whether the coefficients of a series have an array of their own.
    fn has_array(&self, source: Source) -> bool {
        let series = &self.jet.series[source];
        let in_sums = self.lanes.is_none() && series.kept;
        in_sums || series.before || matches!(series.rule, Rule::State(_))
    }

    fn has_weighted_array(&self, source: Source) -> bool {
        self.lanes.is_none() && self.jet.series[source].weighted
    }

    /// The arrays, in order, as the body of an order and its calls name them.
    fn arrays(&self, values: &[TokenStream]) -> Vec<Stored> {
        let value = |source: Source| values.get(self.value(source)).cloned();
        let mut arrays = vec![];
        for source in 0..self.jet.series.len() {
            if self.has_array(source) {
                arrays.push(Stored { name: kept(source), of_lanes: false, first: value(source) });
            }
            if self.has_weighted_array(source) {
                arrays.push(Stored { name: weighted(source), of_lanes: false, first: None });
            }
        }
        for (i, operands) in self.lanes.iter().flat_map(|lanes| &lanes.arrays).enumerate() {
            let first = operands.map(|Operand { source, weighted }| {
                value(source).filter(|_| !weighted).unwrap_or(quote!(R::from_f64(0.0)))
            });
            arrays.push(Stored { name: side_by_side(i), of_lanes: true, first: Some(quote!([#(#first),*])) });
        }
        arrays
    }

    /// The body of an order.
    fn order(&mut self) -> TokenStream {
        let mut body = TokenStream::new();
        let groups: Vec<_> = self.lanes.iter().flat_map(|lanes| lanes.groups.clone()).collect();
        for (i, group) in groups.iter().enumerate() {
            let (name, sum) = (format_ident!("sums{i}"), self.sum_of(group.weight, group.operands.map(side_by_side)));
            body.extend(quote!(#name = #sum;));
        }
        for source in &self.jet.order {
            let (name, value) = (coefficient(*source), self.coefficient(*source));
            let state = matches!(self.jet.series[*source].rule, Rule::State(_));
            let kept = (self.has_array(*source) && !state).then(|| {
                let array = kept(*source);
                quote!(#array[n] = #name;)
            });
            let weighted = self.has_weighted_array(*source).then(|| {
                let array = weighted(*source);
                quote!(#array[n] = whole * #name;)
            });
            body.extend(quote!(#name = #value; #kept #weighted));
        }
        for (i, operands) in self.lanes.iter().flat_map(|lanes| &lanes.arrays).enumerate() {
            let (name, entries) = (
                side_by_side(i),
                operands.map(|Operand { source, weighted }| {
                    let c = coefficient(source);
                    if weighted { quote!(whole * #c) } else { quote!(#c) }
                }),
            );
            body.extend(quote!(#name[n] = [#(#entries),*];));
        }
        for rate in &self.jet.rates {
            body.extend(self.next(*rate));
        }
        for (i, (_, source)) in self.jet.switches.iter().enumerate() {
            let (i, value) = (Literal::usize_unsuffixed(i), self.or_zero(*source));
            body.extend(quote!(switches[n][#i] = #value;));
        }
        let (phase, action, arrays) = (self.context.phase(), self.context.action(), self.arrays(&[]));
        let types = arrays.iter().map(Stored::entry);
        let arrays = arrays.iter().map(|array| &array.name);
        let names = self.jet.order.iter().map(|source| coefficient(*source));
        let names = names.chain((0..groups.len()).map(|i| format_ident!("sums{i}")));
        let [numbers, masks, switches] =
            [self.numbers.len(), self.jet.conditions.len(), self.jet.switches.len()].map(Literal::usize_unsuffixed);
        quote! {
            #[inline(always)]
            fn order<R: Real, const P: usize>(
                n: usize,
                k: &[R; #numbers],
                masks: &[R::Mask; #masks],
                #(#arrays: &mut [#types; P],)*
                jet: &mut [PerCoordinate<#phase, #action>; P],
                switches: &mut [[R; #switches]; P],
            ) {
                let (whole, next) = (R::from_f64(n as f64), R::from_f64(1.0 / (n + 1) as f64));
                let (#(#names,)*);
                #body
            }
        }
    }

    /// The coefficient of order n + 1 of a coordinate.
    fn next(&self, rate: Rate) -> TokenStream {
        let place = self.place(rate.symbol);
        let value = match rate.source {
            Some(source) => {
                let coefficient = coefficient(source);
                quote!(next * #coefficient)
            }
            None => quote!(R::from_f64(0.0)),
        };
        match self.array_of(rate.symbol) {
            Some(array) => quote! {
                jet[n].#place = #value;
                if n + 1 < P {
                    #array[n + 1] = jet[n].#place;
                }
            },
            None => quote!(jet[n].#place = #value;),
        }
    }

    /// The array of a coordinate that something reads.
    fn array_of(&self, symbol: Symbol) -> Option<Ident> {
        self.jet.series.iter().position(|series| series.rule == Rule::State(symbol)).map(kept)
    }

    /// Where a coordinate is in a point.
    fn place(&self, symbol: Symbol) -> TokenStream {
        let flow = self.context.energy.form.is_flow();
        match symbol {
            Symbol::Q(i) if flow => element(quote!(z), &self.context.coordinate(i)),
            Symbol::Q(i) => element(quote!(z[0]), &self.context.coordinate(i)),
            Symbol::P(i) => element(quote!(z[1]), &self.context.coordinate(i)),
            _ => quote!(s),
        }
    }

    fn or_zero(&self, source: Option<Source>) -> TokenStream {
        source.map_or(quote!(R::from_f64(0.0)), |source| {
            let name = coefficient(source);
            quote!(#name)
        })
    }

    /// The coefficient of order n.
    fn coefficient(&mut self, source: Source) -> TokenStream {
        let own = source;
        match self.jet.series[source].rule.clone() {
            Rule::State(_) => {
                let array = kept(source);
                quote!(#array[n])
            }
            Rule::Affine(slope) => {
                let slope = self.number(Prepared::Value(slope));
                quote!(recurrence::affine(#slope, n))
            }
            Rule::Linear(terms) => self.linear(&terms),
            Rule::Product(a, b) => {
                let (starts, c) = ([a, b].map(|of| self.start_of(of)), [a, b].map(coefficient));
                let sum = self.sum(own, 0);
                quote!(recurrence::product([#(#starts),*], [#(#c),*], #sum))
            }
            Rule::Shift { start, slope, of } => {
                let [start, slope] = [start, slope].map(|value| self.number(Prepared::Value(value)));
                let (before, c) = (self.before(of), coefficient(of));
                quote!(#start.multiply_add(#c, #slope * #before))
            }
            Rule::Square(a) => {
                let (start, c, sum) = (self.start_of(a), coefficient(a), self.sum(own, 0));
                quote!(recurrence::square(#start, #c, #sum))
            }
            Rule::Quotient(a, w) => {
                let over = self.number(Prepared::Reciprocal(self.value(w)));
                let (starts, c) = ([w, own].map(|of| self.start_of(of)), [a, w].map(coefficient));
                let sum = self.sum(own, 0);
                quote!(recurrence::quotient([#(#starts,)* #over], [#(#c),*], #sum))
            }
            Rule::Reciprocal(w) => {
                let (starts, c, sum) = ([w, own].map(|of| self.start_of(of)), coefficient(w), self.sum(own, 0));
                quote!(recurrence::reciprocal([#(#starts),*], #c, #sum))
            }
            Rule::Root(u) => {
                let over = self.number(Prepared::HalfReciprocal(self.value(own)));
                let (start, c, sum) = (self.start_of(own), coefficient(u), self.sum(own, 0));
                quote!(recurrence::root([#start, #over], #c, #sum))
            }
            Rule::Power(u, exponent) => {
                let ratio = self.number(Prepared::Ratio(exponent, self.value(own), self.value(u)));
                let (start, c, sum) = (self.start_of(u), coefficient(u), self.sum(own, 0));
                quote!(recurrence::power([#start, #ratio], #c, #sum, n))
            }
            Rule::Integral { factor, by, of } => {
                let (start, c, sum) = (self.start_of(by), coefficient(of), self.sum(own, 0));
                scaled(factor, quote!(recurrence::integral(#start, #c, #sum, n)))
            }
            Rule::Wave { factor, slope, by } => {
                let (slope, before) = (self.number(Prepared::Scaled(factor, slope)), self.before(by));
                quote!(#slope * #before * R::from_f64(1.0 / n as f64))
            }
            Rule::Quadrature { factor, of, over } => {
                let inverse = self.number(Prepared::Reciprocal(self.value(over)));
                let (start, c, sum) = (self.start_of(over), coefficient(of), self.sum(own, 0));
                let c = scaled(factor, quote!(#c));
                quote!(recurrence::quadrature([#start, #inverse], #c, #sum, n))
            }
            Rule::Angle { y, x, square } => {
                let inverse = self.number(Prepared::Reciprocal(self.value(square)));
                let (starts, c) = ([y, x, square].map(|of| self.start_of(of)), [y, x].map(coefficient));
                let sums = [0, 1, 2].map(|i| self.sum(own, i));
                quote!(recurrence::angle([#(#starts,)* #inverse], [#(#c),*], [#(#sums),*], n))
            }
            Rule::Select(condition, first, second) => {
                let place = self.jet.conditions.iter().position(|other| *other == condition).unwrap_or(0);
                let (place, [first, second]) =
                    (Literal::usize_unsuffixed(place), [first, second].map(|source| self.or_zero(source)));
                quote!({
                    let [chosen] = R::choose(masks[#place], || [#first], || [#second]);
                    chosen
                })
            }
        }
    }

    /// The coefficient of order 0.
    fn start_of(&mut self, source: Source) -> TokenStream {
        self.number(Prepared::Value(self.value(source)))
    }

    /// The coefficient of order n − 1.
    fn before(&self, source: Source) -> TokenStream {
        let array = kept(source);
        quote!(#array[n - 1])
    }

    /// A sum in the coefficient of order n of a series.
    fn sum(&mut self, own: Source, i: usize) -> TokenStream {
        let sum = sums(&self.jet.series[own].rule, own)[i];
        if let Some((group, lane)) = self.lanes.as_ref().and_then(|lanes| lanes.place(sum)) {
            let (group, lane) = (format_ident!("sums{group}"), Literal::usize_unsuffixed(lane));
            return quote!(#group[#lane]);
        }
        let arrays = sum.operands.map(array_of);
        self.sum_of(sum.weight, arrays)
    }

    /// One sum, or many side by side.
    fn sum_of(&mut self, weight: Weight, [u, w]: [Ident; 2]) -> TokenStream {
        match weight {
            Weight::One => quote!(recurrence::sum(#u, #w, n)),
            Weight::Square => quote!(recurrence::sum_of_square(#u, n)),
            Weight::Power(exponent) => {
                let next = self.number(Prepared::Next(exponent));
                quote!(recurrence::sum_of_power(#u, #w, #next, n))
            }
        }
    }

    /// Σ factor·c, what is known last added last.
    fn linear(&mut self, terms: &[(Factor, Source)]) -> TokenStream {
        let mut sum: Option<TokenStream> = None;
        for (factor, source) in terms {
            let c = coefficient(*source);
            let factor = match *factor {
                Factor::Number(number) if number == Number::ONE || number == Number::MINUS_ONE => {
                    sum = Some(match (sum, number == Number::ONE) {
                        (Some(sum), true) => quote!(#sum + #c),
                        (Some(sum), false) => quote!(#sum - #c),
                        (None, true) => quote!(#c),
                        (None, false) => quote!(-#c),
                    });
                    continue;
                }
                Factor::Number(number) => constant(number),
                Factor::Value(value) => self.number(Prepared::Value(value)),
            };
            sum = Some(match sum {
                Some(sum) => quote!(#factor.multiply_add(#c, #sum)),
                None => quote!(#factor * #c),
            });
        }
        sum.unwrap_or(quote!(R::from_f64(0.0)))
    }

    /// The values at the start, the coefficients of order 0, and all orders.
    fn start(&self, values: &[TokenStream]) -> TokenStream {
        let numbers = self.numbers.iter().map(|number| prepared(*number, values));
        let masks = self.jet.conditions.iter().map(|value| &values[*value]);
        let mut first = TokenStream::new();
        let arrays = self.arrays(values);
        for Stored { name, first: start, .. } in &arrays {
            first.extend(start.as_ref().map(|start| quote!(#name[0] = #start;)));
        }
        for rate in &self.jet.rates {
            let (place, value) = (self.place(rate.symbol), &values[rate.value]);
            first.extend(quote!(jet[0].#place = #value;));
            if let Some(array) = self.array_of(rate.symbol) {
                first.extend(quote!(if P > 1 { #array[1] = #value; }));
            }
        }
        for (i, (value, _)) in self.jet.switches.iter().enumerate() {
            let (i, value) = (Literal::usize_unsuffixed(i), &values[*value]);
            first.extend(quote!(switches[0][#i] = #value;));
        }
        let unrolled = self.unrolled();
        let zeros: Vec<TokenStream> = arrays.iter().map(Stored::zeros).collect();
        let arrays: Vec<Ident> = arrays.into_iter().map(|array| array.name).collect();
        let literal = (1..=unrolled).map(Literal::usize_unsuffixed);
        let rest = Literal::usize_unsuffixed(unrolled + 1);
        let [numbers_len, masks_len] = [self.numbers.len(), self.jet.conditions.len()].map(Literal::usize_unsuffixed);
        quote! {
            let k: [R; #numbers_len] = [#(#numbers),*];
            let masks: [R::Mask; #masks_len] = [#(#masks),*];
            let (#(mut #arrays,)*) = (#(#zeros,)*);
            #first
            // Names are those of this place wherever it is used.
            macro_rules! orders {
                ($($n:expr)*) => {
                    $(order($n, &k, &masks, #(&mut #arrays,)* jet, switches);)*
                };
            }
            macro_rules! literal_orders {
                ($($n:literal)*) => {
                    $(if $n < P { orders!($n); })*
                };
            }
            literal_orders!(#(#literal)*);
            for n in #rest..P {
                orders!(n);
            }
        }
    }
}

/// A number of the start, from the values there.
fn prepared(number: Prepared, values: &[TokenStream]) -> TokenStream {
    let factor = |factor: Factor| match factor {
        Factor::Number(number) => constant(number),
        Factor::Value(value) => values[value].clone(),
    };
    match number {
        Prepared::Value(value) => values[value].clone(),
        Prepared::Reciprocal(value) => {
            let value = &values[value];
            quote!(R::from_f64(1.0) / #value)
        }
        Prepared::HalfReciprocal(value) => {
            let value = &values[value];
            quote!(R::from_f64(0.5) / #value)
        }
        Prepared::Next(Factor::Number(exponent)) => constant(exponent.add(Number::ONE)),
        Prepared::Next(Factor::Value(exponent)) => {
            let exponent = &values[exponent];
            quote!(#exponent + R::from_f64(1.0))
        }
        Prepared::Ratio(exponent, w, u) => {
            let (exponent, w, u) = (factor(exponent), &values[w], &values[u]);
            quote!(#exponent * #w / #u)
        }
        Prepared::Scaled(c, value) => {
            let (c, value) = (constant(c), &values[value]);
            quote!(#c * #value)
        }
    }
}

/// c·x.
fn scaled(c: Number, x: TokenStream) -> TokenStream {
    match c {
        Number::ONE => x,
        Number::MINUS_ONE => quote!(-#x),
        _ => {
            let c = constant(c);
            quote!(#c * #x)
        }
    }
}
