//! The coefficient of order n by each rule.

use super::numbers::{Prepared, constant, scaled, zero};
use super::{Writer, array_of, coordinate, kept};
use crate::diff::jet::{Factor, Packs, Rule, Source, Weight, sums};
use crate::ir::Number;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Sums of more terms are multiplied as a whole.
const MOST_TERMS: usize = 2;

impl Writer<'_> {
    /// The coefficient of order n of a series, or of several side by side that have the same rule.
    pub(super) fn coefficient(&mut self, own: &[Source]) -> TokenStream {
        let jet = self.jet;
        let (first, rule) = (own[0], &jet.series[own[0]].rule);
        let operands: Vec<Vec<Source>> = (0..rule.operands().len())
            .map(|k| own.iter().map(|source| jet.series[*source].rule.operands()[k]).collect())
            .collect();
        let operands: Vec<&[Source]> = operands.iter().map(Vec::as_slice).collect();
        match *rule {
            Rule::State(symbol) => {
                let at_hand = self.coordinates_at_hand().iter().position(|rate| rate.symbol == symbol);
                match at_hand {
                    Some(rate) => coordinate(rate),
                    None if self.has_array(first) => {
                        let array = kept(first);
                        quote!(#array[n])
                    }
                    None => {
                        let place = self.place(symbol);
                        quote!(jet[n - 1].#place)
                    }
                }
            }
            Rule::Affine(slope) => {
                let slope = self.number(Prepared::Slope(Number::ONE, slope));
                quote!(recurrence::affine(#slope, n))
            }
            Rule::Linear(ref terms) => self.linear(terms),
            Rule::Product(..) => {
                let (starts, c, sum) = (self.starts(&operands), self.present(&operands), self.sum(own, 0));
                quote!(recurrence::product([#(#starts),*], [#(#c),*], #sum))
            }
            Rule::Shift { start, slope, of } => {
                let start = self.number(Prepared::Value(start));
                let slope = self.number(Prepared::Slope(Number::ONE, slope));
                let (before, c) = (self.before(of), self.now(&[of]));
                quote!(#start.multiply_add(#c, #slope * #before))
            }
            Rule::Squares(_) => {
                let (starts, c, sum) = (self.starts(&operands), self.present(&operands), self.sum(own, 0));
                quote!(recurrence::squares([#(#starts),*], [#(#c),*], #sum))
            }
            Rule::Quotient(..) => {
                let over = self.numbers(operands[1], |w, writer| Prepared::Reciprocal(writer.value(w)));
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
                let over = self.numbers(own, |y, writer| Prepared::HalfReciprocal(writer.value(y)));
                let (starts, c, sum) = (self.starts(&[own]), self.now(operands[0]), self.sum(own, 0));
                quote!(recurrence::root([#(#starts,)* #over], #c, #sum))
            }
            Rule::Power(_, exponent) => {
                let ratio = self.numbers(own, |y, writer| {
                    let u = writer.jet.series[y].rule.operands()[0];
                    Prepared::Ratio(exponent, writer.value(y), writer.value(u))
                });
                let (starts, c, sum) = (self.starts(&operands), self.now(operands[0]), self.sum(own, 0));
                quote!(recurrence::power([#(#starts,)* #ratio], #c, #sum, n))
            }
            Rule::Integral { factor, .. } => {
                let (starts, c, sum) = (self.starts(&operands[..1]), self.now(operands[1]), self.sum(own, 0));
                times(factor, own, quote!(recurrence::integral(#(#starts)*, #c, #sum, n)))
            }
            Rule::Wave { factor, slope, by } => {
                let (slope, before) = (self.number(Prepared::Slope(factor, slope)), self.before(by));
                quote!(#slope * #before * recurrence::inverse::<R>(n))
            }
            Rule::Quadrature { factor, .. } => {
                let inverse = self.numbers(operands[1], |over, writer| Prepared::Reciprocal(writer.value(over)));
                let (starts, c, sum) = (self.starts(&operands[1..]), self.now(operands[0]), self.sum(own, 0));
                let c = times(factor, own, c);
                quote!(recurrence::quadrature([#(#starts,)* #inverse], #c, #sum, n))
            }
            Rule::Angle { square, .. } => {
                let inverse = self.number(Prepared::Reciprocal(self.value(square)));
                let (starts, c) = (self.starts(&operands), self.present(&operands[..2]));
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

    /// The coefficients of order 0.
    fn starts(&mut self, all: &[&[Source]]) -> Vec<TokenStream> {
        all.iter()
            .map(|sources| self.numbers(sources, |source, writer| Prepared::Value(writer.value(source))))
            .collect()
    }

    /// The coefficients of order n.
    fn present(&self, all: &[&[Source]]) -> Vec<TokenStream> {
        all.iter().map(|sources| self.now(sources)).collect()
    }

    /// The coefficient of order n − 1.
    fn before(&self, source: Source) -> TokenStream {
        let array = kept(source);
        quote!(#array[n - 1])
    }

    /// A sum in the coefficient of order n of a series, or those of several side by side.
    fn sum(&mut self, own: &[Source], i: usize) -> TokenStream {
        let sum = sums(&self.jet.series[own[0]].rule, own[0]).swap_remove(i);
        if let Some((group, lane)) = self.lanes.as_ref().and_then(|lanes| lanes.place(&sum)) {
            let (group, lane) = (format_ident!("sums{group}"), Literal::usize_unsuffixed(lane));
            return if own.len() > 1 { quote!(#group) } else { quote!(#group[#lane]) };
        }
        let places = |lanes: &Packs| sum.parts().iter().map(|part| lanes.place(part)).collect::<Option<Vec<_>>>();
        if let Some(places) = self.lanes.as_ref().and_then(places) {
            let mut parts = places.into_iter().map(|(group, lane)| {
                let (group, lane) = (format_ident!("sums{group}"), Literal::usize_unsuffixed(lane));
                quote!(#group[#lane])
            });
            if let Weight::Power(exponent) = sum.weight {
                let next = self.number(Prepared::Next(exponent));
                let [weighted, plain] = [parts.next(), parts.next()];
                return quote!(#next.multiply_add(#weighted, -whole * #plain));
            }
            return quote!((#(#parts)+*));
        }
        let arrays: Vec<Ident> = sum.operands.into_iter().map(array_of).collect();
        self.sum_of(sum.weight, &arrays)
    }

    /// One sum, or many side by side.
    pub(super) fn sum_of(&mut self, weight: Weight, arrays: &[Ident]) -> TokenStream {
        match weight {
            Weight::One => quote!(recurrence::sum(#(#arrays,)* n)),
            Weight::Square => quote!(recurrence::sum_of_squares([#(&*#arrays),*], n)),
            Weight::Power(exponent) => {
                let next = self.number(Prepared::Next(exponent));
                quote!(recurrence::sum_of_power(#(#arrays,)* #next, n))
            }
        }
    }

    /// The coefficient of order n of a series times a number that is known before. What coefficients are multiplied by meets that number first: no
    /// product of both is waited for. Of many terms these would be many products.
    pub(super) fn times(&mut self, number: TokenStream, source: Source) -> TokenStream {
        let jet = self.jet;
        match jet.series[source].rule {
            Rule::Linear(ref terms) if terms.len() == 1 => {
                let (factor, source) = terms[0];
                let number = self.product(number, factor);
                self.times(number, source)
            }
            Rule::Linear(ref terms) if (2..=MOST_TERMS).contains(&terms.len()) => {
                let mut sum: Option<TokenStream> = None;
                for (factor, source) in terms {
                    let (factor, c) = (self.product(number.clone(), *factor), self.now(&[*source]));
                    sum = Some(match sum {
                        Some(sum) => quote!((#factor).multiply_add(#c, #sum)),
                        None => quote!(#factor * #c),
                    });
                }
                sum.unwrap_or(number)
            }
            _ => {
                let c = self.now(&[source]);
                quote!(#number * #c)
            }
        }
    }

    fn product(&mut self, number: TokenStream, factor: Factor) -> TokenStream {
        match factor {
            Factor::Number(factor) if factor == Number::ONE => number,
            Factor::Number(factor) if factor == Number::MINUS_ONE => quote!(-(#number)),
            Factor::Number(factor) => {
                let factor = constant(factor);
                quote!((#number) * #factor)
            }
            Factor::Value(value) => {
                let factor = self.number(Prepared::Value(value));
                quote!((#number) * #factor)
            }
        }
    }

    /// Σ factor·c, what is known last added last.
    fn linear(&mut self, terms: &[(Factor, Source)]) -> TokenStream {
        let mut sum: Option<TokenStream> = None;
        for (factor, source) in terms {
            let c = self.now(&[*source]);
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
        sum.unwrap_or_else(zero)
    }
}

/// c·x of numbers, or of numbers side by side.
fn times(c: Number, own: &[Source], x: TokenStream) -> TokenStream {
    match c {
        _ if own.len() == 1 => scaled(c, x),
        Number::ONE => x,
        _ => {
            let c = constant(c);
            quote!(recurrence::scaled(#c, #x))
        }
    }
}
