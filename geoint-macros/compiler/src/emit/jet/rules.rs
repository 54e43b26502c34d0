//! The emitted coefficient of order n of a series, for each rule.

use super::Writer;
use super::arrays::{operand_array, series_array};
use super::numbers::{StepNumber, constant, entry, scaled, zero};
use super::order::sums_name;
use crate::diff::jet::{Factor, Operand, Rule, Source, Sum, Weight, sums};
use crate::ir::{Number, Symbol};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

/// A number is multiplied into the terms of a sum of at most two terms, and into longer sums as a whole.
const MOST_TERMS: usize = 2;

impl Writer<'_> {
    /// Returns the coefficient of order n of a series, or the pack of coefficients of a group. The list `own` has one series or four.
    pub(super) fn coefficient(&mut self, own: &[Source]) -> TokenStream {
        let jet = self.jet;
        let value = |source: Source| jet.series[source].value;
        let rule = &jet.series[own[0]].rule;
        let operands: Vec<Vec<Source>> = (0..rule.operands().len())
            .map(|k| own.iter().map(|source| jet.series[*source].rule.operands()[k]).collect())
            .collect();
        let operands: Vec<&[Source]> = operands.iter().map(Vec::as_slice).collect();
        match *rule {
            Rule::State(symbol) => self.coordinate(own[0], symbol),
            Rule::Affine(slope) => {
                let slope = self.number(StepNumber::Slope(Number::ONE, slope));
                quote!(recurrence::affine(#slope, n))
            }
            Rule::Linear(ref terms) => self.linear(terms),
            Rule::Product(..) | Rule::Squares(_) => {
                let function = if let Rule::Product(..) = rule { quote!(product) } else { quote!(squares) };
                let (starts, c, sum) = (self.starts(&operands), self.present(&operands), self.sum(own, 0));
                quote!(recurrence::#function([#(#starts),*], [#(#c),*], #sum))
            }
            Rule::Shift { start, slope, of } => {
                let start = self.number(StepNumber::Value(start));
                let slope = self.number(StepNumber::Slope(Number::ONE, slope));
                let (before, c) = (before(of), self.now(&[of]));
                quote!(#start.multiply_add(#c, #slope * #before))
            }
            Rule::Quotient(..) => {
                let over = self.numbers(operands[1], |w| StepNumber::Reciprocal(value(w)));
                let (starts, c) = (self.starts(&[operands[1], own]), self.present(&operands));
                let sum = self.sum(own, 0);
                quote!(recurrence::quotient([#(#starts,)* #over], [#(#c),*], #sum))
            }
            Rule::Reciprocal(_) => {
                let (starts, c) = (self.starts(&[operands[0], own]), self.now(operands[0]));
                let sum = self.sum(own, 0);
                quote!(recurrence::reciprocal([#(#starts),*], #c, #sum))
            }
            Rule::Root(_) => {
                let over = self.numbers(own, |y| StepNumber::HalfReciprocal(value(y)));
                let (starts, c, sum) = (self.starts(&[own]), self.now(operands[0]), self.sum(own, 0));
                quote!(recurrence::root([#(#starts,)* #over], #c, #sum))
            }
            Rule::Power(_, exponent) => {
                let ratio = self.numbers(own, |y| {
                    let u = jet.series[y].rule.operands()[0];
                    StepNumber::Ratio(exponent, value(y), value(u))
                });
                let (starts, c, sum) = (self.starts(&operands), self.now(operands[0]), self.sum(own, 0));
                quote!(recurrence::power([#(#starts,)* #ratio], #c, #sum, n))
            }
            Rule::Integral { factor, .. } => {
                let (starts, c, sum) = (self.starts(&operands[..1]), self.now(operands[1]), self.sum(own, 0));
                times(factor, own, quote!(recurrence::integral(#(#starts)*, #c, #sum, n)))
            }
            Rule::Wave { factor, slope, by } => {
                let (slope, before) = (self.number(StepNumber::Slope(factor, slope)), before(by));
                quote!(#slope * #before * recurrence::inverse::<R>(n))
            }
            Rule::Quadrature { factor, .. } => {
                let inverse = self.numbers(operands[1], |over| StepNumber::Reciprocal(value(over)));
                let (starts, c, sum) = (self.starts(&operands[1..]), self.now(operands[0]), self.sum(own, 0));
                let c = times(factor, own, c);
                quote!(recurrence::quadrature([#(#starts,)* #inverse], #c, #sum, n))
            }
            Rule::Angle { square, .. } => {
                let inverse = self.number(StepNumber::Reciprocal(value(square)));
                let (starts, c) = (self.starts(&operands), self.present(&operands[..2]));
                let sums = [0, 1, 2].map(|i| self.sum(own, i));
                quote!(recurrence::angle([#(#starts,)* #inverse], [#(#c),*], [#(#sums),*], n))
            }
            Rule::Select(condition, first, second) => {
                let place = jet.conditions.iter().position(|other| *other == condition).unwrap_or(0);
                let (mask, [first, second]) =
                    (entry(quote!(masks), place), [first, second].map(|source| self.or_zero(source)));
                quote!({
                    let [chosen] = R::choose(#mask, || [#first], || [#second]);
                    chosen
                })
            }
        }
    }

    /// Returns the coefficient of order n of a coordinate, which the previous order has computed.
    fn coordinate(&self, source: Source, symbol: Symbol) -> TokenStream {
        if let Some(rate) = self.coordinates_in_registers().iter().position(|rate| rate.symbol == symbol) {
            entry(quote!(coordinates), rate)
        } else if self.has_array(Operand { source, weighted: false }) {
            let array = series_array(source);
            quote!(#array[n])
        } else {
            let component = self.component(symbol);
            quote!(jet[n - 1].#component)
        }
    }

    /// Returns the coefficients of order 0.
    fn starts(&mut self, all: &[&[Source]]) -> Vec<TokenStream> {
        let jet = self.jet;
        let start = |source: Source| StepNumber::Value(jet.series[source].value);
        all.iter().map(|sources| self.numbers(sources, start)).collect()
    }

    /// Returns the coefficients of order n.
    fn present(&self, all: &[&[Source]]) -> Vec<TokenStream> {
        all.iter().map(|sources| self.now(sources)).collect()
    }

    /// Returns one of the sums in the coefficient of order n of a series, or a pack of sums for a group.
    fn sum(&mut self, own: &[Source], i: usize) -> TokenStream {
        let sum = sums(&self.jet.series[own[0]].rule, own[0]).swap_remove(i);
        if let Some((group, lane)) = self.packs.place(&sum) {
            let pack = sums_name(group);
            return if own.len() > 1 { pack.into_token_stream() } else { entry(pack, lane) };
        }
        let lane = |part: &Sum| self.packs.place(part).map(|(group, lane)| entry(sums_name(group), lane));
        let parts = sum.parts().iter().map(lane).collect::<Option<Vec<_>>>();
        match (sum.weight, parts.as_deref()) {
            (Weight::Power(exponent), Some([weighted, plain])) => {
                let next = self.number(StepNumber::Next(exponent));
                quote!(#next.multiply_add(#weighted, -whole * #plain))
            }
            (_, Some(parts)) => quote!((#(#parts)+*)),
            (weight, None) => {
                let arrays: Vec<Ident> = sum.operands.into_iter().map(operand_array).collect();
                self.sum_of(weight, &arrays)
            }
        }
    }

    /// Returns the sum over lower orders, of arrays of numbers or of packs.
    pub(super) fn sum_of(&mut self, weight: Weight, arrays: &[Ident]) -> TokenStream {
        match weight {
            Weight::One => quote!(recurrence::sum(#(#arrays,)* n)),
            Weight::Square => quote!(recurrence::sum_of_squares([#(&*#arrays),*], n)),
            Weight::Power(exponent) => {
                let next = self.number(StepNumber::Next(exponent));
                quote!(recurrence::sum_of_power(#(#arrays,)* #next, n))
            }
        }
    }

    /// Returns a known number times the coefficient of order n of a series. The number enters the terms of a short linear combination, so that no
    /// operation waits for the product of both. A long combination would need many such products.
    pub(super) fn times(&mut self, number: TokenStream, source: Source) -> TokenStream {
        let jet = self.jet;
        match &jet.series[source].rule {
            Rule::Linear(terms) if terms.len() == 1 => {
                let (factor, source) = terms[0];
                let number = self.product(number, factor);
                self.times(number, source)
            }
            Rule::Linear(terms) if (2..=MOST_TERMS).contains(&terms.len()) => {
                let add = |sum: Option<TokenStream>, (factor, source): &(Factor, Source)| {
                    let (factor, c) = (self.product(number.clone(), *factor), self.now(&[*source]));
                    Some(match sum {
                        Some(sum) => quote!((#factor).multiply_add(#c, #sum)),
                        None => quote!(#factor * #c),
                    })
                };
                terms.iter().fold(None, add).unwrap_or_else(zero)
            }
            _ => {
                let c = self.now(&[source]);
                quote!(#number * #c)
            }
        }
    }

    /// Returns a known number times a factor.
    fn product(&mut self, number: TokenStream, factor: Factor) -> TokenStream {
        match factor {
            Factor::Number(Number::ONE) => number,
            Factor::Number(Number::MINUS_ONE) => quote!(-(#number)),
            _ => {
                let factor = self.factor(factor);
                quote!((#number) * #factor)
            }
        }
    }

    /// Returns a factor.
    fn factor(&mut self, factor: Factor) -> TokenStream {
        match factor {
            Factor::Number(number) => constant(number),
            Factor::Value(value) => self.number(StepNumber::Value(value)),
        }
    }

    /// Returns Σ factor·c in the order of the terms. The coefficient computed last is added last.
    fn linear(&mut self, terms: &[(Factor, Source)]) -> TokenStream {
        let add = |sum: Option<TokenStream>, (factor, source): &(Factor, Source)| {
            let c = self.now(&[*source]);
            Some(match (sum, *factor) {
                (Some(sum), Factor::Number(Number::ONE)) => quote!(#sum + #c),
                (Some(sum), Factor::Number(Number::MINUS_ONE)) => quote!(#sum - #c),
                (None, Factor::Number(Number::ONE)) => c,
                (None, Factor::Number(Number::MINUS_ONE)) => quote!(-#c),
                (sum, factor) => {
                    let factor = self.factor(factor);
                    sum.map_or_else(|| quote!(#factor * #c), |sum| quote!(#factor.multiply_add(#c, #sum)))
                }
            })
        };
        terms.iter().fold(None, add).unwrap_or_else(zero)
    }
}

/// Returns the coefficient of order n − 1.
fn before(source: Source) -> TokenStream {
    let array = series_array(source);
    quote!(#array[n - 1])
}

/// Returns c·x for a number x, or for a pack of a group.
fn times(c: Number, own: &[Source], x: TokenStream) -> TokenStream {
    if own.len() == 1 || c == Number::ONE {
        return scaled(c, x);
    }
    let c = constant(c);
    quote!(recurrence::scaled(#c, #x))
}
