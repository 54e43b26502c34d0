//! Processed methods: χ⁻¹ ∘ K ∘ … ∘ K ∘ χ. The kernel K is cheap. The processor χ is applied before the first step, and its inverse after the last.

use super::{Perturbation, limit_by_rest};
use crate::method::perturbed::Inner;
use crate::method::splitting::steps_of;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::{Real, zero};
use crate::space::{Point, Summation};
use crate::system::Perturbed;

/// Nodes of the processor.
const NODES: usize = 4;

/// Shifts aᵢ along the flow of A in units of h, aᵢ = i √(7/40): the spacing of J. Wisdom, M. Holman & J. Touma, Fields Inst. Comm. 10 (1996) 217.
#[allow(clippy::excessive_precision, reason = "all digits that are known, rounded once")]
const SHIFTS: [f64; NODES] = [
    0.41833001326703777398908601289259374469640768464934,
    0.83666002653407554797817202578518748939281536929867,
    1.254990039801113321967258038677781234089223053948,
    1.6733200530681510959563440515703749787856307385973,
];

/// Fractions bᵢ of h for the kicks at these shifts: 2 Σ bᵢ aᵢ^(2k−1)/(2k−1)! = B₂ₖ(½)/(2k)! for k = 1, …, 4 with Bernoulli's polynomials B₂ₖ.
#[allow(clippy::excessive_precision, reason = "all digits that are known, rounded once")]
const KICKS: [f64; NODES] = [
    -0.12808306259348757025513479371479760181733964159608,
    0.056696110900636835767727720496846376435738556601966,
    -0.013622904174198380932207407388173612926865242680775,
    0.0014395903148023266294002147662697033394595734940552,
];

/// Half of A, B, half of A, with a processor that removes the errors of first order in B up to O(h¹⁰). A step costs as much as its kernel.
///
/// The processor costs 12 kicks and 16 flows of A before the first step of a run, and again for every state that is read. Read states
/// seldom. To first order in B, the kernel differs from the exact flow by a derivative along A, D = h{·, A}. The processor
/// χ = 1/(2 sinh D/2) − 1/D removes this difference.
/// J. Wisdom, M. Holman & J. Touma, Fields Inst. Comm. 10 (1996) 217; J. Wisdom, Astron. J. 131 (2006) 2294.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Processed<M> {
    kernel: Perturbation<M>,
    name: &'static str,
    orders: &'static [u32],
}

impl<M> Processed<M> {
    /// Returns the kernel with a processor, under the name `name`. `orders` are the orders (s₁, s₂, …) of the processed method.
    pub(in crate::method) const fn new(name: &'static str, orders: &'static [u32], kernel: M) -> Self {
        Processed { kernel: Perturbation(kernel), name, orders }
    }
}

/// Coefficients of the kernel, of the processor and of its inverse.
#[derive(Clone, Debug)]
pub struct Prepared<P, E, K, R> {
    kernel: P,
    nodes: [Node<E, K, R>; NODES],
}

/// Coefficients of one node of the processor, for a shift a and a kick b.
#[derive(Clone, Debug)]
struct Node<E, K, R> {
    /// The shift a.
    shift: R,
    /// Flows of A by a, −2a, 2a and −a.
    flows: [E; 4],
    /// Kicks by b/2 and −b for the processor, by −b/2 and b for its inverse.
    kicks: [[K; 2]; 2],
}

/// Applies A(a) B(b/2) A(−2a) B(−b) A(2a) B(b/2) A(−a) for every node. `back` is 0 for the processor and 1 for its inverse, which has the opposite kicks.
// Do not inline: rustc 1.95 vectorises the inlined code wrongly at `opt-level = 3`. The relative energy error of four bodies was 1e-3.
#[inline(never)]
fn apply_nodes<'a, S: Perturbed<R>, R: Real>(
    nodes: impl Iterator<Item = &'a Node<S::Exact, S::Rest, R>>,
    back: usize,
    system: &S,
    t: R,
    [q, p]: &mut S::Phase,
) where
    S::Exact: 'a,
    S::Rest: 'a,
{
    for Node { shift, flows: [to, across, again, home], kicks } in nodes {
        let [outer, middle] = &kicks[back];
        // The shifts of a node add up to 0, so the clock of A is back at t after it. A flow of A at frozen time uses t throughout.
        let mut at = zero::<R>();
        let sequence = [
            (to, *shift, Some(outer)),
            (across, -*shift, Some(middle)),
            (again, *shift, Some(outer)),
            (home, zero(), None),
        ];
        for (flow, end, kick) in sequence {
            system.exact(flow, if S::EXACT_IN_TIME { t + at } else { t }, q, p, &mut ());
            at = end;
            if let Some(kick) = kick {
                system.rest(kick, t + at, q, p, &mut ());
            }
        }
    }
}

impl<S: Perturbed<R>, R: Real, M: Method<Inner<S>, R>> Method<S, R> for Processed<M> {
    type Proof = M::Proof;
    type Prepared = Prepared<<Perturbation<M> as Method<S, R>>::Prepared, S::Exact, S::Rest, R>;
    type Memory = M::Memory;
    const SINGLY: bool = M::SINGLY;
    const INNER: bool = true;

    fn claims(&self) -> Claims {
        let kernel = self.kernel.0.claims();
        let order = self.orders.iter().copied().min().unwrap_or(kernel.order);
        // `symmetric` is false: the processor is even in h only up to the remaining error.
        limit_by_rest::<S, R>(Claims { order, symmetric: false, perturbed: self.orders, ..kernel })
    }

    fn name(&self) -> Name {
        Name::new(self.name)
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let part = |fraction: f64| R::from_f64(fraction) * h;
        let flow = |fraction| system.prepare_exact(part(fraction));
        let kick = |fraction| system.prepare_rest(part(fraction));
        let node = |i: usize| {
            let (a, b) = (SHIFTS[i], KICKS[i]);
            let kicks = [[kick(0.5 * b), kick(-b)], [kick(-0.5 * b), kick(b)]];
            Node { shift: part(a), flows: [flow(a), flow(-2.0 * a), flow(2.0 * a), flow(-a)], kicks }
        };
        Prepared { kernel: self.kernel.prepare(system, h), nodes: core::array::from_fn(node) }
    }

    fn memory() -> Self::Memory {
        M::memory()
    }

    fn enter(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        system.enter(z);
        apply_nodes(prepared.nodes.iter(), 0, system, t, z);
    }

    fn leave(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        apply_nodes(prepared.nodes.iter().rev(), 1, system, t, z);
        system.leave(z);
    }

    steps_of!(Perturbation<M>, |prepared| &prepared.kernel);
}
