//! Central forces, such as (x, y, z)/r³ between two bodies: groups of sums that the runtime computes in one loop.

use super::Writer;
use super::arrays::pack_type;
use super::numbers::{entry, factor};
use crate::diff::jet::{Central, LANES, Operand, Source, Weight};
use crate::emit::tokens::Tokens;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

impl Writer<'_> {
    /// Returns the variables of all central forces, each with its type.
    pub(super) fn central_types(&self) -> impl Iterator<Item = (Ident, TokenStream)> {
        self.packs.central.iter().enumerate().map(|(place, central)| {
            let (pack, count) = (pack_type(), Literal::usize_unsuffixed(central.factors.len()));
            (central_name(place), quote!(&'a mut recurrence::Central<#pack, #count, { P }>))
        })
    }

    /// Returns the variables of all central forces, each with its initial value from coefficients of order 0.
    pub(super) fn central_starts(&self, values: &[Tokens]) -> Vec<(Ident, TokenStream)> {
        let packs = self.packs;
        let pack = |array: usize| {
            let values = packs.arrays[array].map(|Operand { source, .. }| &values[self.value(source)]);
            quote!([#(#values),*])
        };
        let start = |(place, central): (usize, &Central)| {
            let factors = central.factors.iter().copied().map(pack);
            let power = &packs.groups[central.power];
            let Weight::Power(exponent) = power.weight else { return None };
            let (operands, exponent) = (power.operands.iter().copied().map(pack), factor(exponent, values));
            Some((central_name(place), quote!(recurrence::Central::new([#(#factors),*], #(#operands,)* #exponent))))
        };
        packs.central.iter().enumerate().filter_map(start).collect()
    }

    /// Returns the series that are multiplied by the power of the distance, in packs. A force reads them at order n.
    pub(super) fn central_factors(&self, place: usize) -> Vec<[Source; LANES]> {
        let sources = |array: &usize| self.packs.arrays[*array].map(|operand| operand.source);
        self.packs.central[place].factors.iter().map(sources).collect()
    }

    /// Emits the call that stores the factors, once. The factors of all forces come first. Their stores are then complete before the first load of a pack,
    /// which waits for four separate stores.
    pub(super) fn take_factors(&mut self, place: usize) {
        let factors = self.central_factors(place);
        factors.iter().flatten().for_each(|source| self.series(*source));
        if !std::mem::replace(&mut self.order.central[place], true) {
            let (name, factors) = (central_name(place), factors.iter().map(|sources| self.now(sources)));
            let taken = quote!(#name.take(n, [#(#factors),*]););
            self.order.body.extend(taken);
        }
    }

    /// Emits the coefficients of order n of all series that follow from a central force.
    pub(super) fn central(&mut self, place: usize) {
        self.take_factors(place);
        let name = central_name(place);
        self.order.declare(format_ident!("products{place}"), quote!(#name.order(n)));
        let packs = self.packs;
        let series = packs.central[place].groups().into_iter().filter_map(|group| packs.groups[group].series);
        series.flatten().for_each(|source| self.keep(source));
    }

    /// Returns the pack of coefficients of order n that follow from a group.
    pub(super) fn pack_of_group(&self, group: usize) -> TokenStream {
        let Some(place) = self.packs.central_of(group) else {
            return group_name(group).into_token_stream();
        };
        let (name, products, central) =
            (central_name(place), format_ident!("products{place}"), &self.packs.central[place]);
        match central.products.iter().position(|product| *product == group) {
            Some(k) => entry(products, k),
            None if group == central.squares => quote!(#name.square(n)),
            None => quote!(#name.power(n)),
        }
    }
}

/// Returns the variable of a central force.
fn central_name(place: usize) -> Ident {
    format_ident!("central{place}")
}

/// Returns the variable of the pack that follows from a group outside of central forces.
pub(super) fn group_name(group: usize) -> Ident {
    format_ident!("side{group}")
}
