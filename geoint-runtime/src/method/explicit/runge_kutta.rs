//! Explicit Runge–Kutta methods: yᵢ = x₀ + h Σ aᵢⱼ kⱼ, kᵢ = f(yᵢ), x₁ = x₀ + h Σ bᵢ kᵢ.
//!
//! By themselves they keep linear invariants only. [`Projection`](crate::Projection) and [`Relaxation`](crate::Relaxation) make them keep the
//! energy. The unmodified methods serve for comparison.

use crate::method::explicit::tableau::Tableau;
use crate::method::explicit::{check_mass, may_be_singular};
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Estimate, Failure, Method, Name, Probe, Step};
use crate::scalar::{Real, zero};
use crate::space::{Action, Array, PerCoordinate, Summation};
use crate::system::{Poles, Rates};

/// An explicit Runge–Kutta method of `K` stages, for every H.
///
/// ```
/// use geoint_runtime::RungeKutta;
///
/// /// The explicit midpoint rule.
/// const MIDPOINT: RungeKutta<2> = RungeKutta::new(2, [0.0, 0.5], [&[], &[0.5]], [0.0, 1.0]);
/// ```
///
/// A table does not compile if a row does not add up to its node, or if the weights do not add up to 1:
///
/// ```compile_fail,E0080
/// # use geoint_runtime::RungeKutta;
/// const MIDPOINT: RungeKutta<2> = RungeKutta::new(2, [0.0, 0.5], [&[], &[0.4]], [0.0, 1.0]);
/// ```
#[doc(alias("Butcher tableau", "explicit Runge-Kutta"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RungeKutta<const K: usize> {
    name: Name,
    order: u32,
    tableau: Tableau<K>,
    /// Weights of two estimates of the error of a step, the estimate of the higher order first.
    estimators: Option<[[f64; K]; 2]>,
}

impl<const K: usize> RungeKutta<K> {
    /// Returns a method of order `order` with nodes `c` and weights `b`. Row i contains the coefficients aᵢⱼ of stage i, i of them at most.
    ///
    /// # Panics
    /// If K is 0, if row i has more than i entries, if a row does not add up to its node, or if the weights do not add up to 1. For a
    /// constant table this is an error of compilation.
    pub const fn new(order: u32, c: [f64; K], rows: [&[f64]; K], b: [f64; K]) -> Self {
        assert!(K >= 1, "a method has at least one stage");
        assert!(adds_up(&b, 1.0), "the weights add up to 1");
        let mut a = [[0.0; K]; K];
        let mut i = 0;
        while i < K {
            assert!(rows[i].len() <= i, "stage i of an explicit method knows those before it");
            assert!(adds_up(rows[i], c[i]), "a row adds up to its node");
            let mut j = 0;
            while j < rows[i].len() {
                a[i][j] = rows[i][j];
                j += 1;
            }
            i += 1;
        }
        RungeKutta { name: Name::new("RungeKutta"), order, tableau: Tableau { a, b, c }, estimators: None }
    }

    /// Sets the name of the method.
    pub const fn named(mut self, name: &'static str) -> Self {
        self.name = Name::new(name);
        self
    }

    /// Adds the weights of two estimates of the error of a step, e₅ of the higher order and e₃. The error is taken to be
    /// e₅²/√(e₅² + e₃²/100).
    pub(super) const fn estimated(mut self, estimators: [[f64; K]; 2]) -> Self {
        assert!(adds_up(&estimators[0], 0.0) && adds_up(&estimators[1], 0.0), "weights of an estimate add up to 0");
        self.estimators = Some(estimators);
        self
    }

    /// The coefficients.
    pub const fn tableau(&self) -> &Tableau<K> {
        &self.tableau
    }
}

/// The coefficients times h, and the poles of the system.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<R, const K: usize> {
    a: [[R; K]; K],
    b: [R; K],
    c: [R; K],
    estimators: Option<[[R; K]; 2]>,
    poles: Poles,
}

/// Computes Σ wᵢ kᵢ.
#[inline(always)]
fn weighted_sum<A: Array, Z: Action<A::Real>>(
    weights: &[A::Real],
    rates: &[PerCoordinate<A, Z>],
) -> PerCoordinate<A, Z> {
    let mut sum = PerCoordinate::zero();
    for (w, rate) in weights.iter().zip(rates) {
        sum.add_scaled(*w, rate);
    }
    sum
}

impl<R: Real, const K: usize> Prepared<R, K> {
    /// Computes the rate kᵢ of stage `i` from the rates of the stages before it.
    #[inline(always)]
    fn rate<S: Rates<R>, C, P: Probe<S, R>>(
        &self,
        i: usize,
        before: &[PerCoordinate<S::Phase, S::Action>],
        Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    ) -> PerCoordinate<S::Phase, S::Action> {
        let mut stage = PerCoordinate::of(x);
        stage.add_scaled(R::from_f64(1.0), &weighted_sum(&self.a[i][..i], before));
        probe.visit(t + self.c[i], &stage.z, &stage.s);
        system.rates(t + self.c[i], &stage)
    }

    /// Computes the rates of all stages.
    #[inline(always)]
    fn rates<S: Rates<R>, C, P: Probe<S, R>>(
        &self,
        mut step: Step<'_, S, R, C, P>,
    ) -> [PerCoordinate<S::Phase, S::Action>; K] {
        let (mut rates, ends) = ([PerCoordinate::zero(); K], [step.t; 2]);
        // The loop over stages is unrolled, so that the rates stay in registers.
        macro_rules! stages {
            ($($i:literal)*) => { $(
                if const { $i < K } {
                    rates[$i] = self.rate($i, &rates[..$i], step.part(ends));
                }
            )* };
        }
        if const { !P::EFFORT.is_thorough() && K <= 16 } {
            stages!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
        } else {
            for i in 0..K {
                rates[i] = self.rate(i, &rates[..i], step.part(ends));
            }
        }
        rates
    }

    /// Refuses a step if a mass matrix is singular on the straight line from its start to a stage, or to its end.
    #[inline(always)]
    fn check_mass<S: Rates<R>, C, P>(
        &self,
        rates: &[PerCoordinate<S::Phase, S::Action>; K],
        Step { system, t, end, x, .. }: &Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        if !may_be_singular::<S, R>() {
            return Ok(());
        }
        for i in 1..K {
            let increment = weighted_sum(&self.a[i][..i], rates);
            check_mass(&self.poles, *system, [*t, *t + self.c[i]], x, &increment)?;
        }
        check_mass(&self.poles, *system, [*t, *end], x, &weighted_sum(&self.b, rates))?;
        Ok(())
    }
}

impl<S: Rates<R>, R: Real, const K: usize> Method<S, R> for RungeKutta<K> {
    type Proof = S::Proof;
    type Prepared = Prepared<R, K>;
    type Memory = ();

    fn claims(&self) -> Claims {
        Claims {
            order: self.order,
            symmetric: false,
            symplectic: false,
            conserves_energy: false,
            perturbed: &[],
            forces: Some(K as u32),
        }
    }

    fn name(&self) -> Name {
        self.name
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let times_h = |row: &[f64]| {
            let mut products = [zero(); K];
            for (product, x) in products.iter_mut().zip(row) {
                *product = R::from_f64(*x) * h;
            }
            products
        };
        let Tableau { a: rows, b, c } = &self.tableau;
        let mut a = [[zero(); K]; K];
        for (i, (products, row)) in a.iter_mut().zip(rows).enumerate() {
            *products = times_h(&row[..i]);
        }
        let estimators = self.estimators.as_ref().map(|[higher, lower]| [times_h(higher), times_h(lower)]);
        Prepared { a, b: times_h(b), c: times_h(c), estimators, poles: Poles::of(system) }
    }

    fn memory(_: &S::Phase) {}

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        (): &mut (),
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        let rates = prepared.rates(step.part([step.t; 2]));
        prepared.check_mass(&rates, &step)?;
        super::add_and_normalise::<S, R, C>(step.x, &weighted_sum(&prepared.b, &rates));
        Ok(())
    }

    /// One less than the order of the method. With e₅ = O(h⁶) and e₃ = O(h⁴), the estimate of DOP853 is O(h⁸), while the method has an error of O(h⁹) a step.
    fn order_of_estimate(&self) -> Option<u32> {
        self.estimators.map(|_| self.order - 1)
    }

    #[inline]
    fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        (): &mut (),
        mut step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Failure>> {
        let estimators = prepared.estimators.as_ref()?;
        let rates = prepared.rates(step.part([step.t; 2]));
        if let Err(refusal) = prepared.check_mass(&rates, &step) {
            return Some(Err(refusal));
        }
        super::add_and_normalise::<S, R, C>(step.x, &weighted_sum(&prepared.b, &rates));
        let [higher, lower] = estimators;
        Some(Ok([weighted_sum(higher, &rates), weighted_sum(lower, &rates)]))
    }
}
