//! Powers that carry a constant: what a force between two bodies is multiplied by for both, masses and the constant of gravity, the power may have from
//! the start. The rates of the bodies are sums and differences then.

use super::{Builder, Factor, Rule, Source, Value};
use crate::ir::{Id, Number};

impl Builder<'_> {
    /// Scales powers whose products are all read several times, and by nothing but multiples of one constant.
    pub(super) fn scale_powers(&mut self) {
        let mut readers = vec![vec![]; self.jet.series.len()];
        for (source, series) in self.jet.series.iter().enumerate() {
            series.rule.now().into_iter().for_each(|read: Source| readers[read].push(source));
        }
        // What is read outside of series is left as it is.
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
            for (product, reader) in
                products.iter().flat_map(|product| readers[*product].iter().map(move |sum| (*product, *sum)))
            {
                self.take_signs_of(product, reader);
            }
        }
    }

    /// The constant of which all sums that read some products read multiples by 1 and −1, if it is not 1.
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

    /// A constant as a number times what is left.
    fn parts(&self, value: Value) -> (Number, Id) {
        self.graph.coefficient(self.jet.values[value])
    }

    /// Leaves of the multiples of a product in a sum their signs.
    fn take_signs_of(&mut self, product: Source, reader: Source) {
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
