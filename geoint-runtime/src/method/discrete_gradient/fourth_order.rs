//! Order 4 by a modified structure matrix in place of J.

use super::energy::{Energy, Slope};
use super::matrix::{Matrix, turned};
use super::mean::{Corrected, MeanGradient};
use crate::method::{Name, Probe, Refusal};
use crate::scalar::Real;
use crate::space::Array;
use crate::space::vector::{difference, moved, opposite, scaled, sum};
use crate::system::{Conservative, DiscreteField};

/// A step of order 4 that keeps what a symmetric method of order 2 keeps, in one solve.
///
/// `FourthOrder(DiscreteGradient)` projects a mean velocity, x₁ = x₀ + h (F − G(GᵀG)⁻¹GᵀF): the tree discrete gradients of what is kept
/// are the columns of G, and F = (f(x₀) + 4 f(c) + f(x₁))/6. It is for every energy without damping, with the momenta that its report
/// names, and every field with first integrals; see
/// [`FourthOrderField`](crate::system::FourthOrderField). For canonical systems the projection has a metric, so that it does not
/// depend on units, and across a condition of the energy the step is that of [`DiscreteGradient`](super::DiscreteGradient), of order 2. On a
/// circle, and on other orbits all along which the gradient of a momentum depends on that of the energy, no step keeps both in this way: there
/// it keeps the energy, and loses of the momentum the square of what it is off the orbit by; which steps do so need not be the same on the way back.
/// An oscillation that turns by more than half a turn in a step, hω > √12, would be projected along the surface of constant energy: the change
/// of the energy by a correction λ, λ ∇H(x₁)·(1 − h ∂F)⁻¹MG, is in it as 1 − (hω)²/12. Such steps are refused where a part of the energy is in
/// such oscillations.
///
/// With another mean g of gradients, as in `FourthOrder(Gonzalez)`, x₁ = x₀ + h S̃ g(x₀, x₁) and S̃ = J + ⅔h JQJ − h²/12 JBJBJ, where B =
/// ∇²H((x₀ + x₁)/2) and Q = ½(Dᵀ − D), D half the difference of ∂g/∂x₁ and ∂g/∂x₀.
///
/// Order 4, symmetric, for every H; S̃ is skew, so that the energy is kept where g keeps it, to rounding for every h. If H depends on time, terms of Magnus' series, with differences of ∇H over the step, keep the order.
/// At the same h, [`Suzuki4`](crate::Suzuki4) of the same map costs about as much as this second form, and has a tenth of its error.
///
/// After S. Eidnes, BIT 62 (2022) 1207; Q is taken from both ends, because with that of one end, ∂g(x₀, y)/∂y at
/// y = (x₀ + 2x₁)/3, the step is not symmetric, and of order 3 where third derivatives are not constant. For
/// [`MeanValue`](super::MeanValue), where Q = 0: G. R. W. Quispel & D. I. McLaren, J. Phys. A 41 (2008) 045206.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FourthOrder<G>(
    /// The symmetric method of order 2.
    pub G,
);

impl<G: Corrected> MeanGradient for FourthOrder<G> {
    const OF_ENERGIES: bool = G::OF_ENERGIES;

    fn mean_name(&self) -> Name {
        Name::new("FourthOrder").of(self.0.mean_name())
    }

    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
        G::is_exact::<S, R>()
    }

    /// (1 + ⅔h QJ − h²/12 BJBJ)g with the derivative of g: what is left out of that is O(h²).
    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Refusal> {
        let (h, [one, half, sixth, twelfth]) = (energy.h, [1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 12.0].map(R::from_f64));
        let Slope { g, mut derivative } = self.0.between(energy, x, d)?;
        let (rate, mut w) = (turned(&g), g);
        if !G::CURL_FREE {
            // g is symmetric: with the ends exchanged, the derivative is that with respect to x₀.
            let end = sum(x, d);
            let mut start = self.0.between(energy, &end, &opposite(d))?.derivative;
            let twist = |slope: &mut Matrix<_>| difference(&slope.transpose_times(&rate), &slope.times(&rate));
            w.add_scaled(sixth * h, &difference(&twist(&mut derivative), &twist(&mut start)));
        }
        let m = moved(x, half, d);
        let mut middle = energy.gradient(energy.t, &m);
        let bend = turned(&middle.derivative.times(&rate));
        w.add_scaled(-h * h * twelfth, &middle.derivative.times(&bend));

        w.add_scaled(one, &driving(energy, &m, &mut middle));
        Ok(Slope { g: w, derivative })
    }
}

/// h²/24 ∇H'' + h²/12 (B'J∇H − BJ∇H'), with differences over the step for derivatives with respect to time.
///
/// Zero, to the last bit, if H does not depend on time.
fn driving<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
    energy: &mut Energy<'_, S, R, P>,
    m: &S::Phase,
    middle: &mut Slope<S::Array>,
) -> S::Phase {
    let (h, [half, sixth, twelfth]) = (energy.h, [1.0 / 2.0, 1.0 / 6.0, 1.0 / 12.0].map(R::from_f64));
    let mut before = energy.gradient(energy.t - half * h, m);
    let mut after = energy.gradient(energy.t + half * h, m);
    let (rate, change) = (turned(&middle.g), difference(&after.g, &before.g));
    let mut bracket = difference(&after.derivative.times(&rate), &before.derivative.times(&rate));
    bracket = difference(&bracket, &middle.derivative.times(&turned(&change)));
    let curvature = difference(&difference(&after.g, &middle.g), &difference(&middle.g, &before.g));
    moved(&scaled(sixth, &curvature), h * twelfth, &bracket)
}
