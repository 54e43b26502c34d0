//! Conserved functions are proven, and no false identity passes. The tests use identities with one wrong sign, and random fields that are built
//! from random integrals with decimals, roots, quotients, conditions and time.

use super::points::word;
use super::{arrays, coordinates, length};
use crate::analyze::claims::is_kept;
use crate::analyze::identity;
use crate::diff::derivative_along;
use crate::ir::{Function, Graph, Id, Number, Ratio, Relation, Symbol};
use crate::tests::Noise;
use crate::tests::eval::eval;
use proc_macro2::TokenStream;
use quote::quote;

/// Identities, each with a variant in which one sign is changed.
fn pairs() -> Vec<[TokenStream; 2]> {
    macro_rules! pairs {
        ($($holds:expr, $fails:expr;)*) => { vec![$([quote!($holds), quote!($fails)]),*] };
    }
    pairs! {
        (q - p).powi(3) + 3.0 * q * p * (q - p) - q.powi(3) + p.powi(3), (q - p).powi(3) - 3.0 * q * p * (q - p) - q.powi(3) + p.powi(3);
        0.1 * q * (q + 0.2) - 0.1 * q * q - 0.02 * q, 0.1 * q * (q + 0.2) - 0.1 * q * q + 0.02 * q;
        1.0 / (q - p) - 1.0 / (q + p) - 2.0 * p / (q * q - p * p), 1.0 / (q - p) - 1.0 / (q + p) + 2.0 * p / (q * q - p * p);
        q / (1.0 + q) + 1.0 / (1.0 + q) - 1.0, q / (1.0 + q) - 1.0 / (1.0 + q) - 1.0;
        (q + p).sin() * (q - p).sin() - q.sin().powi(2) + p.sin().powi(2), (q + p).sin() * (q - p).sin() - q.sin().powi(2) - p.sin().powi(2);
        (q + p).cos() + (q - p).cos() - 2.0 * q.cos() * p.cos(), (q + p).cos() - (q - p).cos() - 2.0 * q.cos() * p.cos();
        (2.0 * q).cos() - 2.0 * q.cos().powi(2) + 1.0, (2.0 * q).cos() - 2.0 * q.cos().powi(2) - 1.0;
        (0.3 * q).tan() * (0.3 * q).cos() - (0.3 * q).sin(), (0.3 * q).tan() * (0.3 * q).cos() + (0.3 * q).sin();
        (q - p).exp() * p.exp() - q.exp(), (q - p).exp() * (-p).exp() - q.exp();
        q.cosh() + q.sinh() - q.exp(), q.cosh() - q.sinh() - q.exp();
        (q + p).cosh() - q.cosh() * p.cosh() - q.sinh() * p.sinh(), (q + p).cosh() - q.cosh() * p.cosh() + q.sinh() * p.sinh();
        (1.0 - q.tanh()) * q.cosh() - (-q).exp(), (1.0 - q.tanh()) * q.cosh() - q.exp();
        (q * p / u).ln() - q.ln() - p.ln() + u.ln(), (q * p / u).ln() - q.ln() - p.ln() - u.ln();
        (3.0 * q.ln() - 2.0 * p.ln()).exp() * p * p - q.powi(3), (3.0 * q.ln() + 2.0 * p.ln()).exp() * p * p - q.powi(3);
        (q * q + p * p).sqrt().powi(4) - q.powi(4) - 2.0 * q * q * p * p - p.powi(4),
            (q * q + p * p).sqrt().powi(4) - q.powi(4) + 2.0 * q * q * p * p - p.powi(4);
        q / (q * q + p * p).sqrt().powi(3) - q * (q * q + p * p).sqrt() / (q * q + p * p).powi(2),
            q / (q * q + p * p).sqrt().powi(3) + q * (q * q + p * p).sqrt() / (q * q + p * p).powi(2);
        (1.0 + q * q).sqrt() - q - 1.0 / ((1.0 + q * q).sqrt() + q), (1.0 + q * q).sqrt() + q - 1.0 / ((1.0 + q * q).sqrt() + q);
        if q < 0.0 { q * q } else { 0.0 } - (q.abs() - q) * (q.abs() - q) / 4.0, if q < 0.0 { q * q } else { 0.0 } - (q.abs() + q) * (q.abs() - q) / 4.0;
        if q == 0.0 { p } else { q * p / q } - p, if q == 0.0 { -p } else { q * p / q } - p;
        (2.0_f64.sqrt() * q - p) * (2.0_f64.sqrt() * q + p) - 2.0 * q * q + p * p, (2.0_f64.sqrt() * q - p) * (2.0_f64.sqrt() * q - p) - 2.0 * q * q + p * p;
        a * (q - 0.7).powi(2) - a * q * q + 1.4 * a * q - 0.49 * a, a * (q - 0.7).powi(2) - a * q * q + 1.4 * a * q + 0.49 * a;
        (q * t).sin().powi(2) - (1.0 - (2.0 * q * t).cos()) / 2.0, (q * t).sin().powi(2) - (1.0 + (2.0 * q * t).cos()) / 2.0;
    }
}

#[test]
fn one_sign_decides() {
    let pairs = pairs();
    assert!(pairs.len() >= 20);
    for side in 0..2 {
        let all = pairs.iter().map(|pair| &pair[side]);
        let all = quote!([#(#all),*]);
        let (mut graph, roots) = arrays(4, &quote!(let [q, p, u, v] = x;), &[&all]);
        assert_eq!(length(&all), pairs.len());
        for (root, pair) in roots[0].iter().zip(&pairs) {
            let found = word(&identity(&mut graph, *root));
            let right = if side == 0 { found == "multiplied" || found == "points" } else { found.starts_with("wrong") };
            assert!(right, "{} is {found}", pair[side]);
        }
    }
}

/// Random expressions in three coordinates, two parameters and time.
struct Random {
    graph: Graph,
    noise: Noise,
}

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.noise.between(0.0, n as f64) as usize
    }

    /// A decimal literal.
    fn decimal(&mut self) -> Id {
        let tenths = self.below(39) as i128 - 19;
        let number = Ratio::new(if tenths == 0 { 7 } else { tenths }, 10).map_or(Number::ONE, Number::Exact);
        self.graph.number(number)
    }

    fn leaf(&mut self, time: bool) -> Id {
        match self.below(if time { 7 } else { 6 }) {
            i @ 0..=2 => self.graph.symbol(Symbol::Position(i as u32)),
            i @ 3..=4 => self.graph.symbol(Symbol::Parameter(i as u32 - 3)),
            5 => self.decimal(),
            _ => self.graph.symbol(Symbol::Time),
        }
    }

    fn expression(&mut self, depth: usize, time: bool) -> Id {
        if depth == 0 {
            return self.leaf(time);
        }
        let a = self.expression(depth - 1, time);
        let b = if self.below(2) == 0 { self.expression(depth - 1, time) } else { self.leaf(time) };
        let (rule, strict) = (self.below(12), self.below(2) == 0);
        let g = &mut self.graph;
        match rule {
            0 | 1 => g.add(a, b),
            2 => g.sub(a, b),
            3 | 4 => g.mul(a, b),
            5 => g.div(a, b),
            6 => {
                let square = g.pow(a, Ratio::integer(2));
                let one = g.integer(1);
                let sum = g.add(square, one);
                g.sqrt(sum)
            }
            7 => g.pow(a, Ratio::integer(2)),
            8 => g.call(Function::Sin, &[a]),
            9 => {
                let half = g.scale(Number::HALF, a);
                let bounded = g.call(Function::Sin, &[half]);
                g.call(Function::Exp, &[bounded])
            }
            10 => {
                let square = g.pow(a, Ratio::integer(2));
                let one = g.integer(1);
                let sum = g.add(square, one);
                g.call(Function::Ln, &[sum])
            }
            // A guard, which may be at zero.
            _ => {
                let zero = g.zero();
                let relation = if strict { Relation::Less } else { Relation::LessEqual };
                let condition = g.compare(relation, a, zero);
                let product = g.mul(a, b);
                g.select(condition, product, zero)
            }
        }
    }
}

/// Counts the proofs for fields that keep an integral, and for fields that do not.
#[derive(Debug, Default)]
struct Counts {
    fields: usize,
    proven: usize,
    wrong: usize,
}

/// Fields f = S∇I − ∂I/∂t ∇I/|∇I|² with random I and S keep I; a field with one changed sign does not.
fn checked(seeds: std::ops::Range<u64>) -> Counts {
    let mut counts = Counts::default();
    let x = coordinates(3);
    for seed in seeds {
        let mut random = Random { graph: Graph::default(), noise: Noise(seed + 7) };
        let time = seed % 3 == 0;
        let expression = random.expression(2 + (seed % 2) as usize, time);
        // A term that reads all coordinates.
        let [a, b, c] = [0, 1, 2].map(|i| random.graph.symbol(Symbol::Position(i)));
        let [weight, other] = [random.decimal(), random.decimal()];
        let cubic = random.graph.product(&[weight, a, b, c]);
        let square = random.graph.product(&[other, a, a]);
        let integral = random.graph.sum(&[expression, cubic, square]);
        let entries = [0, 1, 2].map(|_| random.expression(1, time));
        let Random { graph: mut g, mut noise } = random;
        let all: Vec<Symbol> = x.iter().copied().chain([Symbol::Time]).collect();
        let slopes = crate::diff::jacobian(&mut g, &[integral], &all).remove(0);
        // v × ∇I, term by term. One of the six terms is changed.
        let mut terms: Vec<[Id; 2]> = (0..3)
            .map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let back = g.mul(entries[k], slopes[j]);
                [g.mul(entries[j], slopes[k]), g.neg(back)]
            })
            .collect();
        let squares: Vec<Id> = slopes[..3].iter().map(|slope| g.pow(*slope, Ratio::integer(2))).collect();
        let square = g.sum(&squares);
        if g.is_zero(square) {
            continue;
        }
        let field = |g: &mut Graph, terms: &[[Id; 2]]| -> Vec<Id> {
            let rate = g.div(slopes[3], square);
            let mut field = vec![];
            for (pair, slope) in terms.iter().zip(&slopes) {
                let along = g.mul(rate, *slope);
                let along = g.neg(along);
                field.push(g.sum(&[pair[0], pair[1], along]));
            }
            field
        };
        counts.fields += 1;
        let f = field(&mut g, &terms);
        let verdict = is_kept(&mut g, &x, &f, integral, None);
        assert!(!matches!(verdict, crate::analyze::Identity::Wrong(_)), "seed {seed}: {verdict:?}");
        counts.proven += usize::from(verdict.is_zero());

        let (i, side) = ((seed % 3) as usize, (seed % 2) as usize);
        terms[i][side] = g.neg(terms[i][side]);
        let f = field(&mut g, &terms);
        let derivative = derivative_along(&mut g, &x, &f, integral, None);
        let total = g.sum(&derivative);
        let verdict = is_kept(&mut g, &x, &f, integral, None);
        // A proven zero is zero at states of all signs, and on both sides of conditions.
        let mut largest = 0.0_f64;
        for _ in 0..40 {
            let state: Vec<f64> = (0..6)
                .map(|_| (noise.between(-4.0, 4.0)).round() / 2.0 + noise.between(0.0, 1.0).round() * 0.3)
                .collect();
            let value = |symbol| match symbol {
                Symbol::Position(i) => state[i as usize],
                Symbol::Parameter(i) => state[3 + i as usize],
                _ => state[5],
            };
            let tame = g.reachable(&[total]).into_iter().all(|id| eval(&g, id, &value).abs() < 1e4);
            let now = eval(&g, total, &value);
            if tame && now.is_finite() {
                largest = largest.max(now.abs());
            }
        }
        assert!(!verdict.is_zero() || largest < 1e-6, "seed {seed}: {verdict:?}, {largest:e}");
        counts.wrong += usize::from(matches!(verdict, crate::analyze::Identity::Wrong(_)));
    }
    counts
}

#[test]
fn random_fields_keep_what_they_are_made_of_and_nothing_else() {
    let counts = checked(0..150);
    assert!(
        counts.fields > 100 && counts.proven * 10 > counts.fields * 9 && counts.wrong * 2 > counts.fields,
        "{counts:?}"
    );
}

#[test]
#[ignore = "takes a minute"]
fn many_random_fields() {
    println!("{:?}", checked(150..6000));
}
