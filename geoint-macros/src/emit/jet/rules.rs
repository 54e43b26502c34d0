//! The coefficient of order n by each rule.

use super::numbers::{Prepared, constant, scaled};
use super::{Writer, array_of, coefficient, kept};
use crate::diff::jet::{Factor, Rule, Source, Weight, sums};
use crate::ir::Number;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

impl Writer<'_> {
    /// The coefficient of order n.
    pub(super) fn coefficient(&mut self, source: Source) -> TokenStream {
        let own = source;
        match self.jet.series[source].rule.clone() {
            Rule::State(_) if self.has_array(source) => {
                let array = kept(source);
                quote!(#array[n])
            }
            Rule::State(symbol) => {
                let place = self.place(symbol);
                quote!(jet[n - 1].#place)
            }
            Rule::Affine(slope) => {
                let slope = self.number(Prepared::Slope(Number::ONE, slope));
                quote!(recurrence::affine(#slope, n))
            }
            Rule::Linear(terms) => self.linear(&terms),
            Rule::Product(a, b) => {
                let (starts, c) = ([a, b].map(|of| self.start_of(of)), [a, b].map(coefficient));
                let sum = self.sum(own, 0);
                quote!(recurrence::product([#(#starts),*], [#(#c),*], #sum))
            }
            Rule::Shift { start, slope, of } => {
                let start = self.number(Prepared::Value(start));
                let slope = self.number(Prepared::Slope(Number::ONE, slope));
                let (before, c) = (self.before(of), coefficient(of));
                quote!(#start.multiply_add(#c, #slope * #before))
            }
            Rule::Squares(all) => {
                let starts: Vec<TokenStream> = all.iter().map(|of| self.start_of(*of)).collect();
                let (c, sum) = (all.iter().copied().map(coefficient), self.sum(own, 0));
                quote!(recurrence::squares([#(#starts),*], [#(#c),*], #sum))
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
                let (slope, before) = (self.number(Prepared::Slope(factor, slope)), self.before(by));
                quote!(#slope * #before * recurrence::inverse::<R>(n))
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
        let sum = sums(&self.jet.series[own].rule, own).swap_remove(i);
        if let Some((group, lane)) = self.lanes.as_ref().and_then(|lanes| lanes.place(&sum)) {
            let (group, lane) = (format_ident!("sums{group}"), Literal::usize_unsuffixed(lane));
            return quote!(#group[#lane]);
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
}
