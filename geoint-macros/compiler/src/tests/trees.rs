//! The discrete gradient of whole energies: random energies, and energies with branches and angles.

use super::fuzz::{config, energy};
use super::lowered;
use super::precise::{self, Big, big};
use super::rounding::{Rounded, rounded};
use crate::ir::op::Domain;
use crate::ir::{Function, Graph, Id, Node, Symbol};
use crate::{diff, lower, parse};
use proc_macro2::TokenStream;
use proptest::prelude::*;
use quote::quote;

/// A step in (q, p, s), and the value of other symbols.
#[derive(Clone, Copy, Debug)]
struct Step {
    start: [f64; 3],
    increment: [f64; 3],
    rest: f64,
}

impl Step {
    fn read(&self, symbol: Symbol) -> f64 {
        match symbol {
            Symbol::Position(_) => self.start[0],
            Symbol::Momentum(_) => self.start[1],
            Symbol::Action => self.start[2],
            Symbol::PositionIncrement(_) => self.increment[0],
            Symbol::MomentumIncrement(_) => self.increment[1],
            Symbol::ActionIncrement => self.increment[2],
            Symbol::Parameter(i) => self.rest + 0.37 * f64::from(i),
            _ => self.rest,
        }
    }

    /// Returns the smallest increment, which decides the number of digits.
    fn smallest(&self) -> f64 {
        self.increment.iter().filter(|d| **d != 0.0).fold(1.0, |a: f64, b| a.min(b.abs()))
    }

    /// Returns a step that starts at the end of this step.
    fn reached(&self) -> Step {
        Step { start: [0, 1, 2].map(|i| self.start[i] + self.increment[i]), ..*self }
    }
}

/// A point of a step.
#[derive(Clone, Copy, PartialEq)]
enum At {
    Start,
    End,
}

/// Enough for differences of numbers up to 10⁴⁰, before the digits for the smallest increment.
const BITS: usize = 400;

/// An energy with one degree of freedom, its gradient and discrete gradient.
struct Tree {
    graph: Graph,
    energy: Id,
    gradient: [Id; 3],
    slopes: [Id; 3],
}

impl Tree {
    fn new(mut lowered: lower::Lowered) -> Tree {
        let (graph, energy) = (&mut lowered.graph, lowered.terms.energy);
        let gradient = diff::gradient(graph, energy, 1);
        let slopes = diff::discrete_gradient(graph, energy, 1);
        let [gradient, slopes] = [gradient, slopes].map(|g| [g.q[0], g.p[0], g.s]);
        Tree { graph: lowered.graph, energy, gradient, slopes }
    }

    fn of(item: TokenStream) -> Tree {
        Tree::new(lowered(item).1)
    }

    /// Returns the values of some nodes with bounds on their rounding errors.
    fn rounded(&self, roots: [Id; 3], step: &Step) -> [Rounded; 3] {
        roots.map(|root| rounded(&self.graph, root, &|symbol| step.read(symbol)))
    }

    /// Returns whether a condition of the energy differs between the ends of a step.
    fn crosses(&self, step: &Step) -> bool {
        let ends = [*step, step.reached()];
        self.graph.reachable(&[self.energy]).into_iter().any(|id| {
            let [a, b] = ends.map(|end| rounded(&self.graph, id, &|symbol| end.read(symbol)).value);
            matches!(self.graph.node(id), Node::Compare(..)) && a != b
        })
    }

    /// Returns the exact energy at a point of the step, if it exists.
    fn energy(&self, step: &Step, at: At) -> Option<Big> {
        let bits = BITS + (-step.smallest().log2()) as usize;
        precise::value(&self.graph, self.energy, bits, &|symbol| {
            let start = big(step.read(symbol), bits);
            let increment = match symbol {
                Symbol::Position(_) => step.increment[0],
                Symbol::Momentum(_) => step.increment[1],
                Symbol::Action => step.increment[2],
                _ => 0.0,
            };
            if at == At::End { start + big(increment, bits) } else { start }
        })
    }

    /// Returns ∇̄H·d − (H(x₁) − H(x₀)) with a bound on its rounding error, if all values exist.
    fn defect(&self, step: &Step) -> Option<Rounded> {
        let change = self.energy(step, At::End)? - self.energy(step, At::Start)?;
        let slopes = self.rounded(self.slopes, step);
        if !slopes.iter().all(|slope| slope.value.is_finite() && slope.error.is_finite()) {
            return None;
        }
        let bits = change.precision();
        let along = |i: usize| big(slopes[i].value, bits) * big(step.increment[i], bits);
        let value = (along(0) + along(1) + along(2) - change).to_f64().value();
        let error: f64 = (0..3).map(|i| (slopes[i].error * step.increment[i]).abs()).sum();
        Some(Rounded { value, error: error + 1e-60 * step.smallest() })
    }
}

/// Returns whether rounding explains a difference. `error` is in units of ε.
fn is_rounding(difference: f64, error: f64) -> bool {
    difference.abs() <= f64::EPSILON * error + f64::MIN_POSITIVE
}

/// Returns whether slopes do not exist: a denominator, or the cosine under a tangent, changes its sign over a step, or an argument is at the end of a
/// domain, where the derivative is infinite.
fn is_singular(tree: &mut Tree, step: &Step) -> bool {
    let ends = [*step, step.reached()];
    tree.graph.reachable(&[tree.energy]).into_iter().any(|id| {
        let at_ends = |graph: &Graph, id| ends.map(|end| rounded(graph, id, &|symbol| end.read(symbol)).value);
        let denominator = match tree.graph.node(id).clone() {
            Node::Power(base, exponent) if exponent.numerator < 0 => base,
            Node::Call(Function::Tan, args) => tree.graph.call(Function::Cos, &args),
            Node::Call(function, args) => {
                let Domain::Interval(low, high, _) = function.entry().domain else { return false };
                return at_ends(&tree.graph, args[0]).iter().any(|x| *x <= low || *x >= high);
            }
            _ => return false,
        };
        let [a, b] = at_ends(&tree.graph, denominator);
        a * b <= 0.0
    })
}

/// Checks the discrete chain rule, the limit of a zero step, and symmetry.
fn check(tree: &mut Tree, step: &Step) {
    match tree.defect(step) {
        Some(defect) => assert!(is_rounding(defect.value, defect.error), "chain rule: {defect:?}"),
        None => {
            let exists = [At::Start, At::End].iter().all(|at| tree.energy(step, *at).is_some());
            let gradient = tree.rounded(tree.gradient, step).iter().all(|slope| slope.error.is_finite());
            assert!(!exists || !gradient || is_singular(tree, step), "there should be slopes");
        }
    }
    let still = Step { increment: [0.0; 3], ..*step };
    for (slope, derivative) in tree.rounded(tree.slopes, &still).iter().zip(tree.rounded(tree.gradient, &still)) {
        let error = slope.error + derivative.error;
        let same = is_rounding(slope.value - derivative.value, error);
        assert!(same || !error.is_finite(), "gradient: {slope:?} {derivative:?}");
    }
    // The start, increment and end of this step are exact.
    let coarse = |x: f64| (x * 1024.0).round() / 1024.0;
    let there = Step { start: step.start.map(coarse), increment: step.increment.map(coarse), ..*step };
    let back = Step { increment: there.increment.map(|d| -d), ..there.reached() };
    for (there, back) in tree.rounded(tree.slopes, &there).iter().zip(tree.rounded(tree.slopes, &back)) {
        let error = there.error + back.error;
        assert!(is_rounding(there.value - back.value, error) || !error.is_finite(), "symmetry: {there:?} {back:?}");
    }
}

/// Draws a step.
fn step() -> impl Strategy<Value = Step> {
    let point = |size: f64| prop::array::uniform3(-size..size);
    // The sizes of steps reach down to the smallest numbers.
    let exponent = prop_oneof![4 => -0.5..0.5, 3 => -16.0..0.0, 1 => -322.0..-16.0];
    (point(2.0), point(1.0), exponent, 0.5..1.5).prop_map(|(start, direction, exponent, rest)| {
        let size = 10_f64.powf(exponent);
        Step { start, increment: direction.map(|d| size * d), rest }
    })
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn random_energies(
        (form, text) in energy(&["q", "p", "q", "p", "t", "a", "w[1]", "0.5", "2.0"]),
        steps in prop::collection::vec(step(), 2),
    ) {
        let energy = parse::energy(form, quote!(), syn::parse_str(&text).expect("a function")).expect("an energy");
        // Lowering refuses constants that are not finite.
        if let Ok(lowered) = lower::body(&energy) {
            let mut tree = Tree::new(lowered);
            for step in steps {
                check(&mut tree, &step);
            }
        }
    }
}

/// Calls `visit` with short and long steps between many points.
fn steps(mut visit: impl FnMut(&Step)) {
    let places = [-1.7, -0.6, -0.04, 0.2, 0.55];
    for [q0, q1] in places.iter().flat_map(|a| places.map(|b| [*a, b])) {
        for [p0, p1] in [[0.3, -0.8], [1.1, 1.1], [-0.2, 0.02]] {
            for size in [1.0, 0.01] {
                let increment = [size * (q1 - q0), size * (p1 - p0), 0.0];
                visit(&Step { start: [q0, p0, 0.0], increment, rest: 0.9 });
            }
        }
    }
}

/// Branches that meet or jump, are defined on their side only, are nested, stand inside a function, or contain a jump only.
#[test]
fn steps_from_branch_to_branch_keep_the_chain_rule() {
    let energies = [
        quote! { fn wall(q: f64, p: f64, k: f64) -> f64 { p * p / 1.4 + if q < 0.1 { k * (q - 0.1).powi(2) } else { 0.0 } } },
        quote! { fn cut(q: f64, p: f64, k: f64) -> f64 {
            let r = q * q + p * p;
            p.cos() + if r < 1.0 { k * (1.0 - r).powi(3) } else { 0.0 }
        } },
        quote! { fn domain(q: f64, p: f64) -> f64 { p * p + if q > 0.0 { q * q.ln() - p * q.sqrt() } else { p * q.exp_m1() } } },
        quote! { fn step(q: f64, p: f64, k: f64) -> f64 { p * p + if q < p * p { k } else { -0.4 } } },
        quote! { fn nested(q: f64, p: f64, k: f64) -> f64 {
            p * p / 1.4 + if q < -0.5 { k * q } else if q < 0.1 || p > 1.0 { -0.5 * k * q.cos() } else { q.powi(3) - p }
        } },
        quote! { fn inside(q: f64, p: f64, k: f64) -> f64 {
            let x = if p + q > 0.2 { k * q * p } else { 0.3 * p.sin() };
            (2.0 * x).sin() * x.exp() + p * p / (1.0 + x * x)
        } },
    ];
    for energy in energies {
        let mut tree = Tree::of(energy.clone());
        let mut crossings = 0;
        steps(|step| {
            check(&mut tree, step);
            assert!(tree.defect(step).is_some(), "{energy} has no slopes at {step:?}");
            crossings += usize::from(tree.crosses(step));
        });
        assert!(crossings > 8, "{energy}");
    }
}

/// On one side of a condition, the slope equals the slope of this side to the last bit.
#[test]
fn a_branch_that_is_not_left_has_its_own_slopes() {
    let both = Tree::of(
        quote! { fn f(q: f64, p: f64) -> f64 { p.exp() + if q < 0.0 { q.sin() * p } else { p * q.powi(3) } } },
    );
    let sides = [
        Tree::of(quote! { fn f(q: f64, p: f64) -> f64 { p.exp() + q.sin() * p } }),
        Tree::of(quote! { fn f(q: f64, p: f64) -> f64 { p.exp() + p * q.powi(3) } }),
    ];
    steps(|step| {
        let (first, last) = (step.start[0] < 0.0, step.start[0] + step.increment[0] < 0.0);
        if first == last {
            let side = &sides[usize::from(!first)];
            let [found, expected] = [&both, side].map(|tree| tree.rounded(tree.slopes, step).map(|slope| slope.value));
            assert_eq!(found, expected);
        }
    });
}

/// Across branches that meet smoothly, slopes have order 2: half the step gives a quarter of the distance to the gradient at the middle.
#[test]
fn slopes_across_a_branch_are_consistent() {
    let tree = Tree::of(quote! { fn cut(q: f64, p: f64) -> f64 {
        let r = q * q + p * p;
        q.sin() * p + if r < 1.0 { (1.0 - r).powi(3) } else { 0.0 }
    } });
    let error = |size: f64| {
        let step =
            Step { start: [0.6 - 0.5 * size, 0.8 - 0.2 * size, 0.0], increment: [size, 0.4 * size, 0.0], rest: 1.0 };
        assert!(tree.crosses(&step));
        let middle = Step { start: [0.6, 0.8, 0.0], ..step };
        let [found, expected] = [tree.rounded(tree.slopes, &step), tree.rounded(tree.gradient, &middle)];
        (found[0].value - expected[0].value).hypot(found[1].value - expected[1].value)
    };
    let ratio = error(0.02) / error(0.01);
    assert!((3.5..4.5).contains(&ratio), "{ratio}");
}

/// A function with period 2π in an angle has no jump where `atan2` jumps.
#[test]
fn steps_across_the_cut_of_an_angle_keep_the_chain_rule() {
    let mut tree = Tree::of(quote! { fn angle(q: f64, p: f64, k: f64) -> f64 {
        let angle = p.atan2(q);
        k * (3.0 * angle).cos() + (angle - 0.4).sin().exp() * q * p
    } });
    let mut crossings = 0;
    steps(|step| {
        let end = [step.start[0] + step.increment[0], step.start[1] + step.increment[1]];
        check(&mut tree, step);
        crossings += usize::from(step.start[0] < 0.0 && end[0] < 0.0 && step.start[1] * end[1] < 0.0);
    });
    assert!(crossings > 4);
}
