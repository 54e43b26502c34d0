//! Gauss collocation one dimension up, for contact systems.

mod factors;
mod stages;

use crate::method::explicit::tableau::Tableau;
use crate::method::gauss::prepared::Prepared;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::{And, Claims, Method, Name, Probe, Refusal, Step, check_end, start};
use crate::scalar::Real;
use crate::solving::linear;
use crate::solving::newton::Newton;
use crate::solving::size::Sizes;
use crate::space::{Array, Summation};
use crate::system::ContactStages;
use factors::Factors;
use stages::StagePoints;

/// Gauss collocation with `S` stages, 1 to 6, in the symplectisation. Order 2S, symmetric, a contact map, for every H.
///
/// With P = r p, r' = r ∂H/∂s and r = 1 at the start of a step, (q, P, s) and r are moved by the Hamiltonian r H(q, P/r, s), whose collocation
/// commutes with scaling of (P, r): so it is a contact map, which multiplies ds − p dq by 1/r₁. With all derivatives at the stages,
///
/// qᵢ = q₀ + h Σ aᵢⱼ ∂H/∂p, rᵢ pᵢ = p₀ − h Σ aᵢⱼ rⱼ ∂H/∂q, sᵢ = s₀ + h Σ aᵢⱼ (p·∂H/∂p − H), rᵢ = 1 + h Σ aᵢⱼ rⱼ ∂H/∂s.
///
/// One stage is [`ContactMidpoint`](crate::ContactMidpoint). Solved for q, p and s of all stages; where H = g(t)·s + H₀(q, p, t) the factors rᵢ
/// are known beforehand and s follows, so that friction costs nothing beside [`Gauss`]. A step is refused where r₁ is not positive. All
/// p·(Aq + b) that the flow multiplies by one factor are multiplied by 1/r₁.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactGauss<const S: usize>;

/// The coefficients of one step.
#[derive(Clone, Copy, Debug)]
pub struct PreparedContact<P, R, const S: usize> {
    stages: Prepared<P, R, S>,
    /// bᵀA⁻¹: what increments of the stages add up to in the end.
    shares: [R; S],
}

impl<Y: ContactStages<R>, R: Real, const S: usize> Method<Y, R> for ContactGauss<S>
where
    Gauss<S>: GaussTableau<S>,
{
    type Proof = <<Gauss<S> as GaussTableau<S>>::Proof as And<<Y as ContactStages<R>>::Proof>>::Both;
    type Prepared = PreparedContact<Y::StageConstants, R, S>;
    type Memory = Newton<[Y::Moved; S]>;

    fn claims(&self) -> Claims {
        Claims::of_order(2 * S as u32).symmetric().symplectic()
    }

    fn name(&self) -> Name {
        let names = [
            "ContactGauss<1>",
            "ContactGauss<2>",
            "ContactGauss<3>",
            "ContactGauss<4>",
            "ContactGauss<5>",
            "ContactGauss<6>",
        ];
        Name::new(names[S - 1])
    }

    fn prepare(&self, system: &Y, h: R) -> Self::Prepared {
        PreparedContact {
            stages: Prepared::new(system, system.stage_constants(), h),
            shares: shares(&Gauss::<S>::TABLEAU).map(R::from_f64),
        }
    }

    fn memory() -> Self::Memory {
        Newton::new(Y::Array::LEN, 2 + (Y::Moved::LEN - Y::Phase::LEN))
    }

    #[inline(always)]
    fn step<C: Summation<Y::Phase>, P: Probe<Y, R>>(
        prepared: &Self::Prepared,
        newton: &mut Self::Memory,
        Step { system, t, x, probe }: Step<'_, Y, R, C, P>,
    ) -> Result<(), Refusal> {
        let mut origin = Y::Moved::zero();
        let entries = origin.as_mut_slice();
        entries[..Y::Phase::LEN].copy_from_slice(Array::as_slice(&x.z));
        if let Some(s) = entries.get_mut(Y::Phase::LEN) {
            *s = x.s;
        }
        probe.visit(t, &x.z, &x.s);
        let Prepared { poles, h, .. } = &prepared.stages;
        let known = Factors::known(system, &prepared.stages, t)?;
        let equation = StagePoints { system, prepared, t, origin, known };
        let (d, _) = newton.solve(&equation, probe).checked()?;
        let end = equation.end((&d, x.s)).ok_or(Refusal::Singular)?;
        let before = start::<Y, R, C>(x);
        x.add_everywhere(&end);
        check_end(poles, [t, t + *h], &before, Step { system, t, x, probe })
    }
}

/// bᵀA⁻¹.
fn shares<const S: usize>(Tableau { a, b, .. }: &Tableau<S>) -> [f64; S] {
    let mut transposed: [[f64; S]; S] = core::array::from_fn(|i| core::array::from_fn(|j| a[j][i]));
    let mut shares = *b;
    // The matrix of a Gauss method is regular.
    linear::solve::<[f64; S]>(&mut transposed, &mut shares, &Sizes::equal());
    shares
}
