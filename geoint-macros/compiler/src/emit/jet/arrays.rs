//! The emitted arrays of coefficients: their names, types and first entries.
//!
//! A *pack* is an array of four coefficients of one order, so that the compiler can use vector instructions.

use super::Writer;
use super::numbers::zero;
use crate::diff::jet::{LANES, Operand, Rate, Source};
use crate::emit::tokens::Tokens;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// Registers hold the newest entries of at most eight arrays of packs, or of at most eight coordinates.
const MOST_IN_REGISTERS: usize = 8;

/// An array with an entry for each order.
pub(super) struct CoefficientArray {
    pub(super) name: Ident,
    /// One operand, or the operands of a pack.
    operands: Vec<Operand>,
}

impl CoefficientArray {
    /// Returns whether an entry is a pack.
    fn is_packed(&self) -> bool {
        self.operands.len() == LANES
    }

    /// Returns the type of an entry.
    pub(super) fn entry_type(&self) -> TokenStream {
        if self.is_packed() { pack_type() } else { quote!(R) }
    }

    /// Returns an array of zeros. Arrays of packs are aligned to vector registers.
    pub(super) fn zeros(&self) -> TokenStream {
        let (zero, lanes, first) = (zero(), Literal::usize_unsuffixed(LANES), Literal::usize_unsuffixed(0));
        if self.is_packed() { quote!(recurrence::Aligned([[#zero; #lanes]; P]).#first) } else { quote!([#zero; P]) }
    }

    /// Returns the entry of order 0, if it is not zero.
    pub(super) fn first(&self, writer: &Writer<'_>, values: &[Tokens]) -> Option<TokenStream> {
        let value = |operand: &Operand| (!operand.weighted).then(|| &values[writer.value(operand.source)]);
        if let [operand] = &self.operands[..] {
            return value(operand).map(ToTokens::to_token_stream);
        }
        let entries = self.operands.iter().map(|operand| value(operand).map_or_else(zero, |v| v.to_token_stream()));
        Some(quote!([#(#entries),*]))
    }
}

/// Returns the type of a pack.
pub(super) fn pack_type() -> TokenStream {
    let lanes = Literal::usize_unsuffixed(LANES);
    quote!([R; #lanes])
}

/// Returns the name of the array of one series.
pub(super) fn series_array(source: Source) -> Ident {
    format_ident!("u{source}")
}

/// Returns the name of the array of one operand.
pub(super) fn operand_array(operand: Operand) -> Ident {
    let source = operand.source;
    if operand.weighted { format_ident!("ju{source}") } else { series_array(source) }
}

/// Returns the name of an array of packs.
pub(super) fn pack_array(array: usize) -> Ident {
    format_ident!("lanes{array}")
}

impl Writer<'_> {
    /// Returns whether sums take the newest packs from registers. A load of a pack waits until four separate stores are complete: 5 % of a step.
    /// The registers do not suffice for more arrays.
    pub(super) fn packs_in_registers(&self) -> bool {
        (1..=MOST_IN_REGISTERS).contains(&self.pack_arrays().count())
    }

    /// Returns the coordinates whose newest coefficients stay in registers. A load would wait for the store: 5 % of a step (double pendulum).
    /// With many coordinates, other numbers profit more from the registers (three bodies: 10 %).
    pub(super) fn coordinates_in_registers(&self) -> &[Rate] {
        let rates = &self.jet.rates;
        if rates.len() <= MOST_IN_REGISTERS { rates } else { &[] }
    }

    /// Returns whether an operand has its own array: a sum outside of packs reads the operand, or a rule reads its previous coefficient.
    pub(super) fn has_array(&self, operand: Operand) -> bool {
        let series = &self.jet.series[operand.source];
        let (in_sums, before) = if operand.weighted { (series.weighted, false) } else { (series.kept, series.before) };
        before || in_sums && (self.packs.arrays.is_empty() || self.packs.is_read_alone(operand))
    }

    /// Returns the arrays of packs, without the arrays that the runtime keeps for central forces.
    pub(super) fn pack_arrays(&self) -> impl Iterator<Item = usize> + use<'_> {
        (0..self.packs.arrays.len()).filter(|array| !self.packs.is_central(*array))
    }

    /// Returns all arrays in the order of their declaration.
    pub(super) fn arrays(&self) -> Vec<CoefficientArray> {
        let operands = (0..self.jet.series.len())
            .flat_map(|source| [false, true].map(|weighted| Operand { source, weighted }))
            .filter(|operand| self.has_array(*operand));
        let single = operands.map(|operand| (operand_array(operand), vec![operand]));
        let packed = self.pack_arrays().map(|array| (pack_array(array), self.packs.arrays[array].to_vec()));
        single.chain(packed).map(|(name, operands)| CoefficientArray { name, operands }).collect()
    }
}
