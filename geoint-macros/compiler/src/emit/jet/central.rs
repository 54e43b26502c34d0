//! Forces between bodies: groups of sums that the runtime computes as one.

use super::Writer;
use super::numbers::factor;
use crate::diff::jet::{Central, LANES, Operand, Source, Weight};
use crate::emit::tokens::Tokens;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

impl Writer<'_> {
    fn all_central(&self) -> &[Central] {
        self.lanes.as_ref().map_or(&[], |lanes| &lanes.central)
    }

    /// Whether a group is computed with others as one.
    pub(super) fn is_central(&self, group: usize) -> bool {
        self.lanes.as_ref().is_some_and(|lanes| lanes.central_of(group).is_some())
    }

    pub(super) fn central_names(&self) -> Vec<Ident> {
        (0..self.all_central().len()).map(|place| format_ident!("central{place}")).collect()
    }

    pub(super) fn central_types(&self) -> Vec<TokenStream> {
        let lanes = Literal::usize_unsuffixed(LANES);
        let of = |central: &Central| {
            let number = Literal::usize_unsuffixed(central.factors.len());
            quote!(recurrence::Central<[R; #lanes], #number, { P }>)
        };
        self.all_central().iter().map(of).collect()
    }

    /// The same with coefficients of order 0.
    pub(super) fn central_starts(&self, values: &[Tokens]) -> Vec<TokenStream> {
        let Some(lanes) = &self.lanes else { return vec![] };
        let beside = |array: usize| {
            let values = lanes.arrays[array].map(|Operand { source, .. }| &values[self.value(source)]);
            quote!([#(#values),*])
        };
        let start = |central: &Central| {
            let factors = central.factors.iter().copied().map(beside);
            let power = &lanes.groups[central.power];
            let (base, own) = (beside(power.operands[0]), beside(power.operands[1]));
            let Weight::Power(exponent) = power.weight else { return None };
            let exponent = factor(exponent, values);
            Some(quote!(recurrence::Central::new([#(#factors),*], #base, #own, #exponent)))
        };
        lanes.central.iter().filter_map(start).collect()
    }

    /// What is read of the same order.
    pub(super) fn read_by_central(&self, place: usize) -> Vec<Source> {
        self.factors(place).into_iter().flatten().collect()
    }

    fn factors(&self, place: usize) -> Vec<[Source; LANES]> {
        let Some(lanes) = &self.lanes else { return vec![] };
        let sources = |array: &usize| lanes.arrays[*array].map(|operand| operand.source);
        lanes.central[place].factors.iter().map(sources).collect()
    }

    /// Writes what is multiplied, where it is not written yet. That of all forces comes first: what is written number by number, and read side by
    /// side, has left the processor by then.
    pub(super) fn take_factors(&mut self, place: usize) {
        self.read_by_central(place).into_iter().for_each(|source| self.series(source));
        if !std::mem::replace(&mut self.order.central[place], true) {
            let name = format_ident!("central{place}");
            let factors = self.factors(place).into_iter().map(|sources| self.now(&sources));
            let taken = quote!(#name.take(n, [#(#factors),*]););
            self.order.body.extend(taken);
        }
    }

    /// Writes the coefficients of order n.
    pub(super) fn central(&mut self, place: usize) {
        self.take_factors(place);
        let [name, products] = ["central", "products"].map(|name| format_ident!("{name}{place}"));
        self.order.body.extend(quote!(#products = #name.order(n);));
        self.order.names.push(products);
        let Some(lanes) = &self.lanes else { return };
        let central = &lanes.central[place];
        let series = central.groups().into_iter().filter_map(|group| lanes.groups[group].series);
        let all: Vec<Source> = series.flatten().collect();
        for source in all {
            self.keep(source);
        }
    }

    /// The coefficients of order n of series side by side that follow from a group.
    pub(super) fn side(&self, group: usize) -> TokenStream {
        let Some((place, central)) = self.lanes.as_ref().and_then(|lanes| {
            let place = lanes.central_of(group)?;
            Some((place, &lanes.central[place]))
        }) else {
            let side = format_ident!("side{group}");
            return quote!(#side);
        };
        let [name, products] = ["central", "products"].map(|name| format_ident!("{name}{place}"));
        match central.products.iter().position(|product| *product == group) {
            Some(k) => {
                let k = Literal::usize_unsuffixed(k);
                quote!(#products[#k])
            }
            None if group == central.squares => quote!(#name.square(n)),
            None => quote!(#name.power(n)),
        }
    }
}
