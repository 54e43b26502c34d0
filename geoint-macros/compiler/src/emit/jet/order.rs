//! The emitted code for one order n of the Taylor coefficients.
//!
//! - A *series* is the list of the Taylor coefficients of one node of the energy's graph. The code computes the coefficient of order n of each series.
//! - Up to four series with equal formulas form a *group*. Their coefficients are computed side by side in a *pack*, an array of four numbers, so that the
//!   compiler can use vector instructions. `diff/jet` finds the groups.
//! - A *sum* is the part of a coefficient that reads lower orders only, such as Σ uₖ vₙ₋ₖ for 0 < k < n.
//! - *Central forces* act between pairs of bodies, such as (x, y, z)/r³. The runtime computes all groups of one force in one loop.
//!
//! The sums of all groups are emitted first. Each series then follows the series that it reads at order n.

use super::Writer;
use super::arrays::{CoefficientArray, operand_array, pack_array, pack_type};
use super::central::group_name;
use super::numbers::{StepNumber, entry};
use crate::diff::jet::{Jet, LANES, Operand, Packs, Rule, Source, Weight};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The emitted code of one order, and its completed parts.
pub(super) struct Order {
    /// The code so far.
    pub(super) body: TokenStream,
    /// The variables assigned by the code.
    names: Vec<Ident>,
    /// True for each emitted series.
    series: Vec<bool>,
    /// True for each array of packs that contains the coefficients of order n.
    arrays: Vec<bool>,
    /// True for each central force with emitted factors.
    pub(super) central: Vec<bool>,
}

impl Order {
    /// Returns the state before the first emission.
    pub(super) fn new(jet: &Jet, packs: &Packs) -> Order {
        Order {
            body: TokenStream::new(),
            names: vec![],
            series: vec![false; jet.series.len()],
            arrays: vec![false; packs.arrays.len()],
            central: vec![false; packs.central.len()],
        }
    }

    /// Emits a variable.
    pub(super) fn declare(&mut self, name: Ident, value: TokenStream) {
        self.body.extend(quote!(#name = #value;));
        self.names.push(name);
    }
}

impl Writer<'_> {
    /// Returns the struct of all coefficients, and its method that computes the coefficients of order n. Call it once, because the statements are
    /// collected in `self`.
    pub(super) fn coefficients(&mut self) -> TokenStream {
        let (jet, packs) = (self.jet, self.packs);
        let unit = self.number(StepNumber::Unit);
        // Sums read lower orders only, so the sums of groups come first. Sums beside their readers would be 5 % faster for planets with registers of
        // four numbers, and 10 % slower without such registers and for a double pendulum.
        for group in (0..packs.groups.len()).filter(|group| packs.central_of(*group).is_none()) {
            self.group_sum(group);
        }
        for place in 0..packs.central.len() {
            self.take_factors(place);
        }
        for source in &jet.order {
            self.series(*source);
        }
        for array in self.pack_arrays().collect::<Vec<_>>() {
            self.pack(array);
        }
        for (i, rate) in jet.rates.iter().enumerate() {
            let next = self.next(i, *rate);
            self.order.body.extend(next);
        }
        for (i, (_, source)) in jet.switches.iter().enumerate() {
            let (i, value) = (Literal::usize_unsuffixed(i), self.or_zero(*source));
            self.order.body.extend(quote!(switches[n][#i] = #value;));
        }
        let (fields, types): (Vec<Ident>, Vec<TokenStream>) = self.fields().into_iter().unzip();
        let Order { body, names, .. } = &self.order;
        // Braces around P, because a type of the user may be called `P`.
        quote! {
            struct Coefficients<'a, R: Real, const P: usize> {
                #(#fields: #types,)*
            }
            impl<R: Real, const P: usize> recurrence::Series for Coefficients<'_, R, { P }> {
                #[inline(always)]
                fn order(&mut self, n: usize) {
                    let Self { #(#fields),* } = self;
                    let (whole, next) = (recurrence::whole::<R>(n), #unit * recurrence::inverse::<R>(n + 1));
                    let (#(#names,)*);
                    #body
                }
            }
        }
    }

    /// Returns the fields of the struct of coefficients, each with its type:
    /// - `k`, `beside`: numbers computed once per step, and packs of four of them, which stand beside packs of coefficients in sums
    /// - `newest`: the newest entry of each array of packs, if registers hold them
    /// - `coordinates`: the newest coefficients of the coordinates, if registers hold them
    /// - `masks`: the branch that each condition takes at the start of the step; all orders follow this branch
    /// - the arrays and the central forces
    /// - `jet`, `switches`: the results, for each order: coefficients of the coordinates, and of functions whose sign decides a condition
    fn fields(&self) -> Vec<(Ident, TokenStream)> {
        let list = |name: &str, entry: &TokenStream, count: usize| {
            let count = Literal::usize_unsuffixed(count);
            (format_ident!("{name}"), quote!([#entry; #count]))
        };
        let (number, pack) = (quote!(R), pack_type());
        let mut fields = vec![list("k", &number, self.numbers.len())];
        fields.extend((!self.packed_numbers.is_empty()).then(|| list("beside", &pack, self.packed_numbers.len())));
        fields.extend(self.packs_in_registers().then(|| list("newest", &pack, self.packs.arrays.len())));
        fields.push(list("coordinates", &number, self.coordinates_in_registers().len()));
        fields.push(list("masks", &quote!(R::Mask), self.jet.conditions.len()));
        let borrowed = |array: CoefficientArray| {
            let entry = array.entry_type();
            (array.name, quote!(&'a mut [#entry; P]))
        };
        fields.extend(self.arrays().into_iter().map(borrowed));
        fields.extend(self.central_types());
        let (phase, action) = (self.context.phase_type(), self.context.action_type());
        fields.push((format_ident!("jet"), quote!(&'a mut [PerCoordinate<#phase, #action>; P])));
        let switches = Literal::usize_unsuffixed(self.jet.switches.len());
        fields.push((format_ident!("switches"), quote!(&'a mut [[R; #switches]; P])));
        fields
    }

    /// Emits a series and the others of its group, after the series that they read at order n.
    pub(super) fn series(&mut self, source: Source) {
        let (jet, packs) = (self.jet, self.packs);
        let mut open = vec![source];
        while let Some(source) = open.pop() {
            if self.order.series[source] {
                continue;
            }
            let group = packs.group_of(source);
            let central = group.and_then(|(group, _)| packs.central_of(group));
            let all: Vec<Source> = group.map_or(vec![source], |(_, series)| series.to_vec());
            let reads = match central {
                Some(place) => self.central_factors(place).concat(),
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
                continue;
            }
            let name = if let Some((group, series)) = group {
                self.pack_operands(&series);
                group_name(group)
            } else {
                coefficient(source)
            };
            let value = self.coefficient(&all);
            self.order.declare(name, value);
            all.into_iter().for_each(|source| self.keep(source));
        }
    }

    /// Emits the sum of a group.
    fn group_sum(&mut self, group: usize) {
        let (weight, operands) = (self.packs.groups[group].weight, &self.packs.groups[group].operands);
        let arrays: Vec<Ident> = operands.iter().copied().map(pack_array).collect();
        let sum = if weight == Weight::One && self.packs_in_registers() {
            let newest = operands.iter().map(|array| entry(quote!(newest), *array));
            quote!(recurrence::sum_with_newest(#(#arrays,)* [#(#newest),*], n))
        } else {
            self.sum_of(weight, &arrays)
        };
        self.order.declare(sums_name(group), sum);
    }

    /// Emits the copy of a series into its own array, and into the array of n times its coefficients.
    pub(super) fn keep(&mut self, source: Source) {
        if std::mem::replace(&mut self.order.series[source], true) {
            return;
        }
        let value = self.now(&[source]);
        let [plain, weighted] = [false, true].map(|weighted| Operand { source, weighted });
        if self.has_array(plain) && !matches!(self.jet.series[source].rule, Rule::State(_)) {
            let array = operand_array(plain);
            self.order.body.extend(quote!(#array[n] = #value;));
        }
        if self.has_array(weighted) {
            let array = operand_array(weighted);
            self.order.body.extend(quote!(#array[n] = whole * #value;));
        }
    }

    /// Emits the copies of the operands of a group into their arrays of packs. An operand that is read up to the previous order only may not have its
    /// coefficient yet; the last statements of the order copy it.
    fn pack_operands(&mut self, series: &[Source; LANES]) {
        let jet = self.jet;
        for k in 0..jet.series[series[0]].rule.operands().len() {
            let operands = series.map(|source| jet.series[source].rule.operands()[k]);
            if operands.iter().all(|source| self.order.series[*source])
                && let Some(array) = self.packs.array_of(&operands)
            {
                self.pack(array);
            }
        }
    }

    /// Emits the copy of the coefficients of order n into an array of packs, once.
    fn pack(&mut self, array: usize) {
        if std::mem::replace(&mut self.order.arrays[array], true) {
            return;
        }
        let operands = self.packs.arrays[array];
        let (name, weighted) = (pack_array(array), operands[0].weighted);
        let value = if let Some((group, series)) = self.packs.group_of(operands[0].source)
            && operands == series.map(|source| Operand { source, weighted })
        {
            let pack = self.pack_of_group(group);
            if weighted { quote!(recurrence::scaled(whole, #pack)) } else { pack }
        } else {
            let entries = operands.map(|Operand { source, weighted }| {
                let c = self.now(&[source]);
                if weighted { quote!(whole * #c) } else { c }
            });
            quote!([#(#entries),*])
        };
        self.order.body.extend(if self.packs_in_registers() {
            let newest = entry(quote!(newest), array);
            quote!(#newest = #value; #name[n] = #newest;)
        } else {
            quote!(#name[n] = #value;)
        });
    }

    /// Returns the coefficient of order n of one series, or the pack of the coefficients of four.
    pub(super) fn now(&self, sources: &[Source]) -> TokenStream {
        match (sources, self.packs.group_of(sources[0])) {
            ([source], None) => coefficient(*source).into_token_stream(),
            ([source], Some((group, series))) => {
                let lane = series.iter().position(|other| other == source).unwrap_or(0);
                entry(self.pack_of_group(group), lane)
            }
            (_, Some((group, series))) if series == *sources => self.pack_of_group(group),
            _ => {
                let array = sources.try_into().ok().and_then(|sources| self.packs.array_of(sources));
                if let Some(array) = array.map(pack_array) {
                    return quote!(#array[n]);
                }
                let entries = sources.iter().map(|source| self.now(&[*source]));
                quote!([#(#entries),*])
            }
        }
    }
}

/// Returns the variable of the coefficient of order n of a series outside of groups.
fn coefficient(source: Source) -> Ident {
    format_ident!("c{source}")
}

/// Returns the variable of the pack of sums of a group.
pub(super) fn sums_name(group: usize) -> Ident {
    format_ident!("sums{group}")
}
