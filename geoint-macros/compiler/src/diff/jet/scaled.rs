//! Moves a constant from the terms of sums into a power.
//!
//! A force between two bodies enters both rates with a common constant, such as the gravitational constant. If the power of the distance carries the
//! constant, the rates are plain sums and differences.
//!
//! The recurrences of powers and products are linear in their own coefficients. Thus a factor of the value at the start of a step, the coefficient of order 0, is a
//! factor of all orders.

use super::{Builder, Factor, Rule, Source, Value};
use crate::ir::{Id, Number};

impl Builder<'_> {
    /// Scales powers whose products are all read several times, and only as multiples of one constant.
    pub(super) fn scale_powers(&mut self) {
        let mut readers = vec![vec![]; self.jet.series.len()];
        for (source, series) in self.jet.series.iter().enumerate() {
            series.rule.now().into_iter().for_each(|read: Source| readers[read].push(source));
        }
        // Series that rates or switches read keep their values.
        let outside = |source: &Source| {
            let mut rates = self.jet.rates.iter().map(|rate| rate.source);
            let mut switches = self.jet.switches.iter().map(|(_, source)| *source);
            rates.any(|read| read == Some(*source)) || switches.any(|read| read == Some(*source))
        };
        let is_inside: Vec<bool> = (0..readers.len()).map(|source| !outside(&source)).collect();
        for power in 0..readers.len() {
            let products = &readers[power];
            let scales = is_inside[power]
                && !products.is_empty()
                && matches!(self.jet.series[power].rule, Rule::Power(..))
                && products.iter().all(|product| {
                    let is_product = matches!(self.jet.series[*product].rule, Rule::Product(a, b) if a != b);
                    is_product && is_inside[*product] && readers[*product].len() > 1
                });
            let Some(constant) = scales.then(|| self.common_constant(products, &readers)).flatten() else { continue };
            for source in products.iter().copied().chain([power]) {
                let value = self.jet.values[self.jet.series[source].value];
                let scaled = self.graph.mul(constant, value);
                self.jet.series[source].value = self.value(scaled);
            }
            for product in products {
                readers[*product].iter().for_each(|reader| self.reduce_to_signs(*product, *reader));
            }
        }
    }

    /// The constant c such that all readers of the products are sums with factors c and −c. Returns `None` if there is none, or if c is a number.
    fn common_constant(&mut self, products: &[Source], readers: &[Vec<Source>]) -> Option<Id> {
        let mut common = None;
        for product in products {
            for reader in &readers[*product] {
                let Rule::Linear(terms) = self.jet.series[*reader].rule.clone() else { return None };
                for (factor, _) in terms.iter().filter(|(_, source)| source == product) {
                    let Factor::Value(value) = *factor else { return None };
                    let (c, constant) = self.parts(value);
                    let size = if c.is_negative() { c.neg() } else { c };
                    let constant = self.graph.scale(size, constant);
                    if *common.get_or_insert(constant) != constant {
                        return None;
                    }
                }
            }
        }
        common
    }

    /// A constant as a number times a node.
    fn parts(&self, value: Value) -> (Number, Id) {
        self.graph.coefficient(self.jet.values[value])
    }

    /// Replaces the factors of a product in a sum by their signs.
    fn reduce_to_signs(&mut self, product: Source, reader: Source) {
        let Rule::Linear(mut terms) = self.jet.series[reader].rule.clone() else { return };
        for (factor, _) in terms.iter_mut().filter(|(_, source)| *source == product) {
            if let Factor::Value(value) = *factor {
                let (c, _) = self.parts(value);
                *factor = Factor::Number(if c.is_negative() { Number::MINUS_ONE } else { Number::ONE });
            }
        }
        self.jet.series[reader].rule = Rule::Linear(terms);
    }
}
