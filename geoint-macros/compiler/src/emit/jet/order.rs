//! The emitted code for one order n of the Taylor coefficients.
//!
//! - A *series* is the list of the Taylor coefficients of one node of the energy's graph. The code computes the coefficient of order n of each series.
//! - Up to four series with the same formula form a *group*. Their coefficients are computed side by side in an array of four lanes, so that the compiler
//!   can use vector instructions. `Packs` of `diff/jet` finds the groups.
//! - A *sum* is the part of a coefficient that reads lower orders only, such as Σ uₖ vₙ₋ₖ for 0 < k < n.
//! - *Central* groups are the forces between pairs of bodies, such as (x, y, z)/r³. The runtime computes all groups of one force in one loop.
//!
//! This file decides the order in which the coefficients are emitted: first the sums of all groups, then each series after those that it reads at the same order.

use super::Writer;
use super::arrays::{Stored, coefficient, kept, newest, side_by_side, weighted};
use super::numbers::Prepared;
use crate::diff::jet::{LANES, Operand, Rule, Source, Weight};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The writer of one order, with the state of its emission.
#[derive(Default)]
pub(super) struct Order {
    /// The code so far.
    pub(super) body: TokenStream,
    /// The variables that the code declares.
    pub(super) names: Vec<Ident>,
    /// Whether each series has been emitted.
    series: Vec<bool>,
    /// Whether the coefficient of order n has been copied into each array of lanes.
    arrays: Vec<bool>,
    /// Whether each central force has been emitted.
    pub(super) central: Vec<bool>,
}

impl Writer<'_> {
    /// Returns the struct of all coefficients, and the method that computes those of order n.
    pub(super) fn body(&mut self) -> TokenStream {
        let jet = self.jet;
        let (groups, lane_arrays) =
            self.lanes.as_ref().map_or((0, 0), |lanes| (lanes.groups.len(), lanes.arrays.len()));
        self.order = Order {
            series: vec![false; jet.series.len()],
            arrays: vec![false; lane_arrays],
            central: vec![false; self.central_names().len()],
            ..Order::default()
        };
        let unit = self.number(Prepared::Unit);
        // Sums read lower orders only, so those of groups come first. Sums beside their readers would be 5 % faster for planets with registers of four
        // numbers, and 10 % slower without such registers and for a double pendulum.
        for place in 0..groups {
            if !self.is_central(place) {
                self.sums(place);
            }
        }
        for place in 0..self.central_names().len() {
            self.take_factors(place);
        }
        for source in &jet.order {
            self.series(*source);
        }
        for array in self.arrays_of_lanes() {
            self.pack(array);
        }
        let Order { mut body, names, .. } = std::mem::take(&mut self.order);
        for (i, rate) in jet.rates.iter().enumerate() {
            body.extend(self.next(i, *rate));
        }
        for (i, (_, source)) in jet.switches.iter().enumerate() {
            let (i, value) = (Literal::usize_unsuffixed(i), self.or_zero(*source));
            body.extend(quote!(switches[n][#i] = #value;));
        }
        let (phase, action, arrays) = (self.context.phase(), self.context.action(), self.arrays(&[]));
        let types: Vec<TokenStream> = arrays.iter().map(Stored::entry).collect();
        let arrays: Vec<Ident> = arrays.into_iter().map(|array| array.name).collect();
        let (central, central_types) = (self.central_names(), self.central_types());
        let [numbers, coordinates, masks, switches] =
            [self.numbers.len(), self.coordinates_at_hand().len(), jet.conditions.len(), jet.switches.len()]
                .map(Literal::usize_unsuffixed);
        let beside = (!self.beside.is_empty()).then(|| {
            let [lanes, number] = [LANES, self.beside.len()].map(Literal::usize_unsuffixed);
            [quote!(beside: [[R; #lanes]; #number],), quote!(beside,)]
        });
        let [beside, beside_name] = beside.unwrap_or_default();
        let at_hand = self.are_at_hand().then(|| {
            let [lanes, number] = [LANES, lane_arrays].map(Literal::usize_unsuffixed);
            [quote!(newest: [[R; #lanes]; #number],), quote!(newest,)]
        });
        let [at_hand, at_hand_name] = at_hand.unwrap_or_default();
        // The generated struct holds what the orders share:
        // k, beside: numbers computed once per step, and the same for four series side by side
        // newest: the newest entry of each array of lanes, which stays in registers if there are few
        // coordinates: the newest coefficient of each coordinate, likewise
        // masks: which branch each condition has taken at the start of the step
        // jet, switches: the results, for each order
        // Braces around P, because a type of the user may be called `P`.
        quote! {
            struct Coefficients<'a, R: Real, const P: usize> {
                k: [R; #numbers],
                #beside
                #at_hand
                coordinates: [R; #coordinates],
                masks: [R::Mask; #masks],
                #(#arrays: &'a mut [#types; P],)*
                #(#central: &'a mut #central_types,)*
                jet: &'a mut [PerCoordinate<#phase, #action>; P],
                switches: &'a mut [[R; #switches]; P],
            }
            impl<R: Real, const P: usize> recurrence::Series for Coefficients<'_, R, { P }> {
                #[inline(always)]
                fn order(&mut self, n: usize) {
                    let Self { k, #beside_name #at_hand_name coordinates, masks, #(#arrays,)* #(#central,)* jet, switches } = self;
                    let (whole, next) = (recurrence::whole::<R>(n), #unit * recurrence::inverse::<R>(n + 1));
                    let (#(#names,)*);
                    #body
                }
            }
        }
    }

    /// Returns the group of a series, with all series that are derived from it.
    fn group_of(&self, source: Source) -> Option<(usize, [Source; LANES])> {
        self.lanes.as_ref()?.group_of(source)
    }

    /// Emits a series and the others of its group, after the series that they read.
    pub(super) fn series(&mut self, source: Source) {
        let jet = self.jet;
        let mut open = vec![source];
        while let Some(source) = open.pop() {
            if self.order.series[source] {
                continue;
            }
            let group = self.group_of(source);
            let all: Vec<Source> = group.map_or(vec![source], |(_, series)| series.to_vec());
            let central = group.and_then(|(group, _)| self.lanes.as_ref()?.central_of(group));
            let reads = match central {
                Some(place) => self.read_by_central(place),
                None => all.iter().flat_map(|source| jet.series[*source].rule.now()).collect(),
            };
            let before: Vec<Source> = reads.into_iter().filter(|read| !self.order.series[*read]).collect();
            if !before.is_empty() {
                open.push(source);
                open.extend(before);
                continue;
            }
            if let Some(place) = central {
                self.central(place);
            } else if let Some((group, _)) = group {
                for k in 0..jet.series[source].rule.operands().len() {
                    let operands = all.iter().map(|source| jet.series[*source].rule.operands()[k]);
                    self.pack_operands(&operands.collect::<Vec<_>>());
                }
                let (name, value) = (format_ident!("side{group}"), self.coefficient(&all));
                self.order.body.extend(quote!(#name = #value;));
                self.order.names.push(name);
            } else {
                let (name, value) = (coefficient(source), self.coefficient(&all));
                self.order.body.extend(quote!(#name = #value;));
                self.order.names.push(name);
            }
            for source in all {
                self.keep(source);
            }
        }
    }

    /// Emits the sum of a group, if there are groups.
    fn sums(&mut self, place: usize) {
        let Some(group) = self.lanes.as_ref().map(|lanes| &lanes.groups[place]) else { return };
        let (weight, operands) = (group.weight, group.operands.clone());
        let arrays: Vec<Ident> = operands.iter().copied().map(side_by_side).collect();
        let sum = if weight == Weight::One && self.are_at_hand() {
            let newest = operands.into_iter().map(newest);
            quote!(recurrence::sum_with_newest(#(#arrays,)* [#(#newest),*], n))
        } else {
            self.sum_of(weight, &arrays)
        };
        let name = format_ident!("sums{place}");
        self.order.body.extend(quote!(#name = #sum;));
        self.order.names.push(name);
    }

    /// Emits the copy of a single series into its own array, and into the array of n times its coefficients.
    pub(super) fn keep(&mut self, source: Source) {
        if std::mem::replace(&mut self.order.series[source], true) {
            return;
        }
        let name = self.now(&[source]);
        if self.has_array(source) && !matches!(self.jet.series[source].rule, Rule::State(_)) {
            let array = kept(source);
            self.order.body.extend(quote!(#array[n] = #name;));
        }
        if self.has_weighted_array(source) {
            let array = weighted(source);
            self.order.body.extend(quote!(#array[n] = whole * #name;));
        }
    }

    /// Emits the copy of the operands' coefficients into their array of lanes, if any. An operand that is read up to the previous order only may
    /// not have its coefficient yet.
    fn pack_operands(&mut self, operands: &[Source]) {
        if !operands.iter().all(|source| self.order.series[*source]) {
            return;
        }
        let array = <&[Source; LANES]>::try_from(operands).ok().and_then(|all| self.lanes.as_ref()?.array_of(all));
        if let Some(array) = array {
            self.pack(array);
        }
    }

    /// Emits the copy of the coefficients of order n into an array of lanes.
    fn pack(&mut self, array: usize) {
        let Some(operands) = self.lanes.as_ref().map(|lanes| lanes.arrays[array]) else { return };
        if std::mem::replace(&mut self.order.arrays[array], true) {
            return;
        }
        let name = side_by_side(array);
        let sources = operands.map(|operand| operand.source);
        let value = if let Some((group, series)) = self.group_of(sources[0])
            && series == sources
            && operands.iter().all(|operand| operand.weighted == operands[0].weighted)
        {
            let side = self.side(group);
            if operands[0].weighted { quote!(recurrence::scaled(whole, #side)) } else { quote!(#side) }
        } else {
            let entries = operands.map(|Operand { source, weighted }| {
                let c = self.now(&[source]);
                if weighted { quote!(whole * #c) } else { c }
            });
            quote!([#(#entries),*])
        };
        self.order.body.extend(if self.are_at_hand() {
            let newest = newest(array);
            quote!(#newest = #value; #name[n] = #newest;)
        } else {
            quote!(#name[n] = #value;)
        });
    }

    /// Returns the expression of the coefficient of order n of one series, or of the array of the coefficients of four.
    pub(super) fn now(&self, sources: &[Source]) -> TokenStream {
        if let [source] = sources {
            let Some((group, series)) = self.group_of(*source) else {
                let name = coefficient(*source);
                return quote!(#name);
            };
            let (side, lane) = (self.side(group), series.iter().position(|other| other == source));
            let lane = Literal::usize_unsuffixed(lane.unwrap_or(0));
            return quote!(#side[#lane]);
        }
        let all = <[Source; LANES]>::try_from(sources).ok();
        let (group, array) = (self.group_of(sources[0]), all.and_then(|all| self.lanes.as_ref()?.array_of(&all)));
        match (group, array) {
            (Some((group, series)), _) if Some(series) == all => self.side(group),
            (_, Some(array)) => {
                let array = side_by_side(array);
                quote!(#array[n])
            }
            _ => {
                let entries = sources.iter().map(|source| self.now(&[*source]));
                quote!([#(#entries),*])
            }
        }
    }
}
