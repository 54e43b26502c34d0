//! Takes common factors out of sums: a·x·y + b·x is x·(a·y + b), with one product less.

use super::lowering::Lowering;
use crate::ir::{HashMap, Id, Node, Number, Symbol};

/// A summand: a number times factors. All factors of earlier levels are one factor, with the magnitude of the number.
struct Summand {
    scale: Number,
    /// The factors. None if other nodes need the product as a whole.
    factors: Vec<Id>,
    /// The number of factors, a numeric one included.
    width: usize,
    whole: (Number, Id),
}

/// The number of operations of a sum with fused multiply-add, and without.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
struct Cost {
    fused: usize,
    separate: usize,
}

impl<F: Fn(Symbol) -> usize> Lowering<'_, F> {
    /// Returns a sum with common factors taken out, as long as this saves operations.
    pub(super) fn factored(&mut self, terms: Vec<(Number, Id)>) -> Vec<(Number, Id)> {
        if terms.len() < 2 {
            return terms;
        }
        let mut summands: Vec<Summand> = terms.iter().map(|(c, id)| self.taken_apart(*c, *id)).collect();
        let mut same = true;
        while let Some(factor) = best(&summands) {
            same = false;
            let (with, mut without): (Vec<_>, Vec<_>) =
                summands.into_iter().partition(|summand| summand.factors.contains(&factor));
            let sum = self.divided(with, factor);
            self.factored_out.insert(sum, ());
            let product = self.graph.mul(factor, sum);
            let (c, product) = self.graph.coefficient(product);
            without.push(self.taken_apart(c, product));
            summands = without;
        }
        if same { terms } else { summands.into_iter().map(|summand| summand.whole).collect() }
    }

    /// Returns a sum as a product, if the sum is a product. The product is then fused with the sum around it.
    pub(super) fn as_product(&mut self, c: Number, id: Id) -> (Number, Id) {
        let Node::Linear(constant, terms) = self.graph.node(id) else { return (c, id) };
        if !constant.is_zero() || terms.len() < 2 || !self.is_single(id) {
            return (c, id);
        }
        let terms = terms.clone();
        if !terms.iter().all(|(_, id)| self.is_now(*id)) {
            return (c, id);
        }
        match self.factored(terms)[..] {
            [(own, product)] => (c.mul(own), product),
            _ => (c, id),
        }
    }

    /// Expands products in a sum with a constant, if this moves operations to an earlier level: 1 + a·(½ + b·y) is (1 + a/2) + ab·y.
    pub(super) fn spread(&mut self, constant: Number, terms: Vec<(Number, Id)>) -> (Number, Vec<(Number, Id)>) {
        if constant.is_zero() || !terms.iter().all(|(_, id)| self.is_now(*id)) {
            return (constant, terms);
        }
        let mut all = vec![self.graph.number(constant)];
        for (c, id) in terms {
            let (mut now, mut early) = (vec![], vec![]);
            self.by_level(id, &mut now, &mut early);
            let is_spread = now.len() == 1 && (!early.is_empty() || !c.is_one()) && {
                let prefactor = self.graph.product(&early);
                let prefactor = self.graph.scale(c, prefactor);
                self.absorbed(prefactor, &mut now)
            };
            all.push(if is_spread { now[0] } else { self.graph.scale(c, id) });
        }
        let sum = self.graph.sum(&all);
        match self.graph.node(sum) {
            Node::Linear(constant, terms) => (*constant, terms.clone()),
            Node::Number(constant) => (*constant, vec![]),
            _ => (Number::ZERO, vec![(Number::ONE, sum)]),
        }
    }

    /// Multiplies a prefactor into a sum among the factors, if the product is free: 2·(½ + b·y) is 1 + 2b·y, where b has an earlier level.
    /// Returns whether a sum absorbed the prefactor.
    pub(super) fn absorbed(&mut self, prefactor: Id, factors: &mut [Id]) -> bool {
        let exact = self.graph.as_number(prefactor).is_some_and(is_power_of_two);
        let Some(place) = factors.iter().position(|id| self.absorbs(*id, exact)) else { return false };
        let Node::Linear(constant, terms) = self.graph.node(factors[place]).clone() else { return false };
        let mut all = vec![self.graph.scale(constant, prefactor)];
        for (c, id) in terms {
            let term = self.graph.mul(prefactor, id);
            all.push(self.graph.scale(c, term));
        }
        factors[place] = self.graph.sum(&all);
        true
    }

    /// Returns whether a sum can absorb a prefactor. Each term must have a coefficient of an earlier level. One term must be a number, unless
    /// products with the prefactor are `exact`: otherwise two terms may nearly cancel, and their exact difference would be lost, as in k(2x − a).
    fn absorbs(&mut self, id: Id, exact: bool) -> bool {
        let Node::Linear(constant, terms) = self.graph.node(id) else { return false };
        // A factor does not return into the sum from which it was taken.
        if constant.is_zero() && !exact || !self.is_single(id) || self.factored_out.contains(id) {
            return false;
        }
        for (c, id) in terms.clone() {
            let mut flat = vec![];
            self.flat_factors(id, &mut flat);
            let early = flat.iter().filter(|factor| !self.is_now(**factor)).count();
            let has_number = c != Number::ONE && c != Number::MINUS_ONE;
            if early == flat.len() && !exact || early == 0 && !has_number {
                return false;
            }
        }
        true
    }

    /// Collects the factors of a node, of this level and of earlier levels.
    pub(super) fn by_level(&mut self, id: Id, now: &mut Vec<Id>, early: &mut Vec<Id>) {
        let mut factors = vec![];
        self.divided_factors(id, &mut factors);
        for id in factors {
            if self.is_now(id) { now.push(id) } else { early.push(id) }
        }
    }

    /// Returns the factors of c·node.
    fn taken_apart(&mut self, c: Number, id: Id) -> Summand {
        let (mut factors, mut early) = (vec![], vec![]);
        self.by_level(id, &mut factors, &mut early);
        let mut now = vec![];
        for id in factors {
            match *self.graph.node(id) {
                Node::Power(base, exponent)
                    if exponent.is_integer() && (2..=4).contains(&exponent.numerator) && self.is_single(id) =>
                {
                    for _ in 0..exponent.numerator {
                        now.push(base);
                    }
                }
                _ => now.push(id),
            }
        }
        let (mut scale, mut width) = (c, now.len());
        if !early.is_empty() {
            let prefactor = self.graph.product(&early);
            scale = if c.is_negative() { Number::MINUS_ONE } else { Number::ONE };
            now.push(self.graph.scale(c.mul(scale), prefactor));
            width += 1;
        } else if c != Number::ONE && c != Number::MINUS_ONE {
            width += 1;
        }
        let shared = matches!(self.graph.node(id), Node::Product(_)) && !self.is_single(id);
        Summand { scale, factors: if shared { vec![] } else { now }, width, whole: (c, id) }
    }

    /// Returns the sum of all summands, each divided by a factor. Sums among the factors stay whole: a difference of close numbers is exact.
    fn divided(&mut self, summands: Vec<Summand>, factor: Id) -> Id {
        let (mut constant, mut terms) = (Number::ZERO, vec![]);
        for Summand { scale, mut factors, .. } in summands {
            if let Some(place) = factors.iter().position(|other| *other == factor) {
                factors.remove(place);
            }
            let product = self.graph.product(&factors);
            match *self.graph.node(product) {
                Node::Number(c) => constant = constant.add(scale.mul(c)),
                _ => {
                    let (c, id) = self.graph.coefficient(product);
                    terms.push((scale.mul(c), id));
                }
            }
        }
        self.graph.linear(constant, terms)
    }
}

/// Returns whether products with a number are exact.
fn is_power_of_two(number: Number) -> bool {
    const DIGITS: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
    number.to_f64().is_normal() && number.to_f64().to_bits() & DIGITS == 0
}

/// Returns the factor with the largest saving, if any factor saves operations. The first of equals wins.
fn best(summands: &[Summand]) -> Option<Id> {
    let mut places: HashMap<Id, Vec<usize>> = HashMap::default();
    let mut shared = vec![];
    for (i, summand) in summands.iter().enumerate() {
        for (place, factor) in summand.factors.iter().enumerate() {
            if summand.factors[..place].contains(factor) {
                continue;
            }
            let with = places.entry(*factor).or_default();
            with.push(i);
            if with.len() == 2 {
                shared.push(*factor);
            }
        }
    }
    if shared.is_empty() {
        return None;
    }
    let whole: Total = summands.iter().map(Work::of).collect();
    let (mut least, mut best) = (whole.cost(), None);
    for factor in shared {
        let with = || places[&factor].iter().map(|i| &summands[*i]);
        let inner = with().map(|summand| Work::without(summand, factor)).collect::<Total>().cost();
        let taken: Total = with().map(Work::of).collect();
        let outer = whole.replaced(taken, Work::PAIR).cost();
        let cost = Cost { fused: inner.fused + outer.fused, separate: inner.separate + outer.separate };
        if cost < least {
            (least, best) = (cost, Some(factor));
        }
    }
    best
}

/// The products of a summand. The last one may be fused with the sum.
struct Work {
    products: usize,
    fused: bool,
}

impl Work {
    /// The new summand: the common factor times a sum.
    const PAIR: Work = Work { products: 1, fused: true };

    /// Returns the products of a summand.
    fn of(summand: &Summand) -> Work {
        Work::products(summand.width, summand.factors.iter())
    }

    /// Returns the products of a summand without a factor.
    fn without(summand: &Summand, factor: Id) -> Work {
        let place = summand.factors.iter().position(|other| *other == factor);
        let others = summand.factors.iter().enumerate().filter(|(other, _)| Some(*other) != place);
        Work::products(summand.width - 1, others.map(|(_, id)| id))
    }

    /// Returns the products of some factors. Powers are not fused: x² − y² is zero where x = y.
    fn products<'a>(width: usize, mut factors: impl Iterator<Item = &'a Id>) -> Work {
        let first = factors.next();
        let alike = 1 + factors.filter(|other| Some(*other) == first).count();
        Work { products: width.saturating_sub(1), fused: width > 1 && alike < width }
    }
}

/// The numbers of summands, products and fused products of a sum.
#[derive(Clone, Copy, Default)]
struct Total {
    sums: usize,
    products: usize,
    fused: usize,
}

impl FromIterator<Work> for Total {
    fn from_iter<I: IntoIterator<Item = Work>>(all: I) -> Total {
        all.into_iter().fold(Total::default(), Total::with)
    }
}

impl Total {
    /// Adds a summand.
    fn with(self, work: Work) -> Total {
        Total {
            sums: self.sums + 1,
            products: self.products + work.products,
            fused: self.fused + usize::from(work.fused),
        }
    }

    /// Replaces some summands by a new summand.
    fn replaced(self, some: Total, by: Work) -> Total {
        let rest = Total {
            sums: self.sums - some.sums,
            products: self.products - some.products,
            fused: self.fused - some.fused,
        };
        rest.with(by)
    }

    /// Returns the operations of the sum. The sum starts with a summand, if possible without a product to fuse.
    fn cost(self) -> Cost {
        let Total { sums, products, fused } = self;
        let starts = usize::from(fused == sums);
        let separate = products + sums - 1;
        Cost { fused: separate - (fused - starts), separate }
    }
}
