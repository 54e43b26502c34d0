//! The arrays of coefficients, and their names.

use super::Writer;
use super::numbers::zero;
use crate::diff::jet::{LANES, Operand, Packs, Rate, Source};
use crate::emit::tokens::Tokens;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The newest entries of so many arrays stay in registers, or the newest coefficients of so many coordinates.
const MOST_AT_HAND: usize = 8;

/// An array of coefficients, an entry an order.
pub(super) struct Stored {
    pub(super) name: Ident,
    /// Whether entries are coefficients side by side.
    pub(super) of_lanes: bool,
    /// The entry of order 0, if it is not zero.
    pub(super) first: Option<Tokens>,
}

impl Stored {
    /// The type of an entry.
    pub(super) fn entry(&self) -> TokenStream {
        let lanes = Literal::usize_unsuffixed(LANES);
        if self.of_lanes { quote!([R; #lanes]) } else { quote!(R) }
    }

    pub(super) fn zeros(&self) -> TokenStream {
        let ([lanes, first], zero) = ([LANES, 0].map(Literal::usize_unsuffixed), zero());
        if self.of_lanes { quote!(recurrence::Aligned([[#zero; #lanes]; P]).#first) } else { quote!([#zero; P]) }
    }
}

pub(super) fn kept(source: Source) -> Ident {
    format_ident!("u{source}")
}

pub(super) fn weighted(source: Source) -> Ident {
    format_ident!("ju{source}")
}

/// The array of one operand.
pub(super) fn array_of(operand: Operand) -> Ident {
    if operand.weighted { weighted(operand.source) } else { kept(operand.source) }
}

/// The array of operands side by side.
pub(super) fn side_by_side(array: usize) -> Ident {
    format_ident!("lanes{array}")
}

/// The newest entry of such an array, at hand.
pub(super) fn newest(array: usize) -> TokenStream {
    let array = Literal::usize_unsuffixed(array);
    quote!(newest[#array])
}

/// The newest coefficient of a coordinate, at hand, by the place of its rate.
pub(super) fn coordinate(rate: usize) -> TokenStream {
    let rate = Literal::usize_unsuffixed(rate);
    quote!(coordinates[#rate])
}

pub(super) fn coefficient(source: Source) -> Ident {
    format_ident!("c{source}")
}

impl Writer<'_> {
    /// Whether sums take the newest entries of arrays of lanes as they were computed. Numbers that were written one by one and are read side by side are waited
    /// for until they have left the processor: a twentieth of a step. Of more arrays they have no room in registers.
    pub(super) fn are_at_hand(&self) -> bool {
        (1..=MOST_AT_HAND).contains(&self.arrays_of_lanes().len())
    }

    /// The coordinates whose newest coefficients are read as they were computed: those in memory are waited for until they have been written, a twentieth
    /// of a step (double pendulum). With many coordinates registers are better used for others (three bodies: a tenth).
    pub(super) fn coordinates_at_hand(&self) -> &[Rate] {
        let rates = &self.jet.rates;
        if rates.len() <= MOST_AT_HAND { rates } else { &[] }
    }

    /// Whether the coefficients of a series have an array of their own: a coordinate has one also where orders are unrolled, and arrays
    /// registers.
    pub(super) fn has_array(&self, source: Source) -> bool {
        let series = &self.jet.series[source];
        let in_sums = series.kept && self.is_read_alone(Operand { source, weighted: false });
        in_sums || series.before
    }

    pub(super) fn has_weighted_array(&self, source: Source) -> bool {
        self.jet.series[source].weighted && self.is_read_alone(Operand { source, weighted: true })
    }

    /// Whether an operand is read in a sum that is not side by side with others.
    fn is_read_alone(&self, operand: Operand) -> bool {
        self.lanes.as_ref().is_none_or(|lanes| lanes.is_read_alone(operand))
    }

    /// The arrays of coefficients side by side, but for those of forces.
    pub(super) fn arrays_of_lanes(&self) -> Vec<usize> {
        let arrays = |lanes: &Packs| (0..lanes.arrays.len()).filter(|array| !lanes.is_central(*array)).collect();
        self.lanes.as_ref().map(arrays).unwrap_or_default()
    }

    /// The arrays, in order, as the body of an order and its calls name them.
    pub(super) fn arrays(&self, values: &[Tokens]) -> Vec<Stored> {
        let value = |source: Source| values.get(self.value(source)).cloned();
        let (zero, mut arrays) = (Tokens::from(zero()), vec![]);
        for source in 0..self.jet.series.len() {
            if self.has_array(source) {
                arrays.push(Stored { name: kept(source), of_lanes: false, first: value(source) });
            }
            if self.has_weighted_array(source) {
                arrays.push(Stored { name: weighted(source), of_lanes: false, first: None });
            }
        }
        for i in self.arrays_of_lanes() {
            let Some(operands) = self.lanes.as_ref().map(|lanes| lanes.arrays[i]) else { continue };
            let first = operands.map(|Operand { source, weighted }| {
                value(source).filter(|_| !weighted).unwrap_or_else(|| zero.clone())
            });
            arrays.push(Stored { name: side_by_side(i), of_lanes: true, first: Some(quote!([#(#first),*]).into()) });
        }
        arrays
    }
}
