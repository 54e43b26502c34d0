//! Explicit Runge–Kutta methods: yᵢ = x₀ + h Σ aᵢⱼ kⱼ, kᵢ = f(yᵢ), x₁ = x₀ + h Σ bᵢ kᵢ.
//!
//! They keep nothing by themselves. They are here because [`Projection`](crate::Projection) and
//! [`Relaxation`](crate::Relaxation) make them keep the energy, and as the measure of what that is worth.

#![allow(non_upper_case_globals)]
#![allow(clippy::excessive_precision, reason = "all digits that are published, rounded once")]

use crate::method::explicit::tableau::Tableau;
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Estimate, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Summation};
use crate::system::Rates;

/// An explicit Runge–Kutta method of `K` stages, for every H.
///
/// ```
/// use geoint_runtime::RungeKutta;
///
/// /// The explicit midpoint rule.
/// const MIDPOINT: RungeKutta<2> = RungeKutta::new(2, [0.0, 0.5], [&[], &[0.5]], [0.0, 1.0]);
/// ```
///
/// A row that does not add up to its node, or weights that do not add up to 1, do not compile:
///
/// ```compile_fail,E0080
/// # use geoint_runtime::RungeKutta;
/// const MIDPOINT: RungeKutta<2> = RungeKutta::new(2, [0.0, 0.5], [&[], &[0.4]], [0.0, 1.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RungeKutta<const K: usize> {
    name: Name,
    order: u32,
    tableau: Tableau<K>,
    /// Weights of two estimates of the error of a step.
    estimators: Option<[[f64; K]; 2]>,
}

/// The classical method. Order 4, 4 gradients, for every H; keeps nothing. W. Kutta, Z. Math. Phys. 46 (1901) 435.
pub const RK4: RungeKutta<4> = RungeKutta::new(
    4,
    [0.0, 0.5, 0.5, 1.0],
    [&[], &[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
)
.named("RK4");

/// Order 8, 12 gradients, for every H; keeps nothing. The method of order 8 of DOP853 with its estimators of order 5 and 3,
/// from which [`Adaptive`](crate::Adaptive) knows the error of a step: E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential
/// Equations I* (1993), section II.5 and (II.10.17), after J. R. Dormand & P. J. Prince; thirty digits as in their program.
pub const DOP853: RungeKutta<12> = RungeKutta::new(
    8,
    [
        0.0,
        0.0526001519587677318785587544488,
        0.0789002279381515978178381316732,
        0.118350341907227396726757197510,
        0.281649658092772603273242802490,
        0.333333333333333333333333333333,
        0.25,
        0.307692307692307692307692307692,
        0.651282051282051282051282051282,
        0.6,
        0.857142857142857142857142857142,
        1.0,
    ],
    [
        &[],
        &[0.0526001519587677318785587544488],
        &[0.0197250569845378994544595329183, 0.0591751709536136983633785987549],
        &[0.0295875854768068491816892993775, 0.0, 0.0887627564304205475450678981324],
        &[0.241365134159266685502369798665, 0.0, -0.884549479328286085344864962717, 0.924834003261792003115737966543],
        &[
            0.037037037037037037037037037037,
            0.0,
            0.0,
            0.170828608729473871279604482173,
            0.125467687566822425016691814123,
        ],
        &[0.037109375, 0.0, 0.0, 0.170252211019544039314978060272, 0.0602165389804559606850219397283, -0.017578125],
        &[
            0.0370920001185047927108779319836,
            0.0,
            0.0,
            0.170383925712239993810214054705,
            0.107262030446373284651809199168,
            -0.0153194377486244017527936158236,
            0.00827378916381402288758473766002,
        ],
        &[
            0.624110958716075717114429577812,
            0.0,
            0.0,
            -3.36089262944694129406857109825,
            -0.868219346841726006818189891453,
            27.5920996994467083049415600797,
            20.1540675504778934086186788979,
            -43.4898841810699588477366255144,
        ],
        &[
            0.477662536438264365890433908527,
            0.0,
            0.0,
            -2.48811461997166764192642586468,
            -0.590290826836842996371446475743,
            21.2300514481811942347288949897,
            15.2792336328824235832596922938,
            -33.2882109689848629194453265587,
            -0.0203312017085086261358222928593,
        ],
        &[
            -0.93714243008598732571704021658,
            0.0,
            0.0,
            5.18637242884406370830023853209,
            1.09143734899672957818500254654,
            -8.14978701074692612513997267357,
            -18.5200656599969598641566180701,
            22.7394870993505042818970056734,
            2.49360555267965238987089396762,
            -3.0467644718982195003823669022,
        ],
        &[
            2.27331014751653820792359768449,
            0.0,
            0.0,
            -10.5344954667372501984066689879,
            -2.00087205822486249909675718444,
            -17.9589318631187989172765950534,
            27.9488845294199600508499808837,
            -2.85899827713502369474065508674,
            -8.87285693353062954433549289258,
            12.3605671757943030647266201528,
            0.643392746015763530355970484046,
        ],
    ],
    [
        0.0542937341165687622380535766363,
        0.0,
        0.0,
        0.0,
        0.0,
        4.45031289275240888144113950566,
        1.89151789931450038304281599044,
        -5.8012039600105847814672114227,
        0.31116436695781989440891606237,
        -0.152160949662516078556178806805,
        0.201365400804030348374776537501,
        0.0447106157277725905176885569043,
    ],
)
.estimated([
    [
        0.01312004499419488073250102996,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.225156446376204440720569753,
        -0.4957589496572501915214079952,
        1.664377182454986536961530415,
        -0.3503288487499736816886487290,
        0.3341791187130174790297318841,
        0.08192320648511571246570742613,
        -0.02235530786388629525884427845,
    ],
    [
        -0.1898007540724076157147023285757,
        0.0,
        0.0,
        0.0,
        0.0,
        4.45031289275240888144113950566,
        1.89151789931450038304281599044,
        -5.8012039600105847814672114227,
        -0.42268232132379199294522513542,
        -0.152160949662516078556178806805,
        0.201365400804030348374776537501,
        0.0226517921983608258118062039043,
    ],
])
.named("DOP853");

impl<const K: usize> RungeKutta<K> {
    /// A method of order `order` with nodes `c`, weights `b` and, in row i, the i coefficients aᵢⱼ of stage i.
    ///
    /// # Panics
    /// When the program is compiled, if the table is a constant: if K is 0, if a row is longer than the stages before it, if a row
    /// does not add up to its node, or if the weights do not add up to 1.
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

    /// The same method under a name of its own.
    pub const fn named(mut self, name: &'static str) -> Self {
        self.name = Name::new(name);
        self
    }

    /// The same method with the weights of two estimates of the error of a step, e₅ of the higher order and e₃: the error is taken to be
    /// e₅²/(e₅² + e₃²/100)½.
    const fn estimated(mut self, estimators: [[f64; K]; 2]) -> Self {
        assert!(adds_up(&estimators[0], 0.0) && adds_up(&estimators[1], 0.0), "weights of an estimate add up to 0");
        self.estimators = Some(estimators);
        self
    }

    /// The coefficients.
    pub const fn tableau(&self) -> &Tableau<K> {
        &self.tableau
    }
}

/// The coefficients times h.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<R, const K: usize> {
    a: [[R; K]; K],
    b: [R; K],
    c: [R; K],
    estimators: Option<[[R; K]; 2]>,
}

/// Σ wᵢ kᵢ.
#[inline(always)]
fn weighed<A: Array, Z: Action<A::Real>>(weights: &[A::Real], rates: &[PerCoordinate<A, Z>]) -> PerCoordinate<A, Z> {
    let mut sum = PerCoordinate::zero();
    for (w, rate) in weights.iter().zip(rates) {
        sum.add_scaled(*w, rate);
    }
    sum
}

impl<R: Real, const K: usize> Prepared<R, K> {
    /// The rates of all stages.
    #[inline(always)]
    fn rates<S: Rates<R>, C, P: Probe<S, R>>(
        &self,
        Step { system, t, x, probe }: Step<'_, S, R, C, P>,
    ) -> [PerCoordinate<S::Phase, S::Action>; K] {
        let mut rates = [PerCoordinate::zero(); K];
        for i in 0..K {
            let mut stage = PerCoordinate::of(x);
            stage.add_scaled(R::from_f64(1.0), &weighed(&self.a[i][..i], &rates));
            probe.visit(t + self.c[i], &stage.z, &stage.s);
            rates[i] = system.rates(t + self.c[i], &stage);
        }
        rates
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

    fn prepare(&self, _: &S, h: R) -> Self::Prepared {
        let times_h = |row: [f64; K]| row.map(|x| R::from_f64(x) * h);
        let Tableau { a, b, c } = self.tableau;
        let estimators = self.estimators.map(|both| both.map(times_h));
        Prepared { a: a.map(times_h), b: times_h(b), c: times_h(c), estimators }
    }

    fn memory() {}

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        (): &mut (),
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let rates = prepared.rates(step.part(step.t));
        step.x.add_everywhere(&weighed(&prepared.b, &rates));
        Ok(())
    }

    /// One less than that of the formula, as of the product of orders 5 and 3 in it.
    fn order_of_estimate(&self) -> Option<u32> {
        self.estimators.map(|_| self.order - 1)
    }

    #[inline]
    fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        (): &mut (),
        mut step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Refusal>> {
        let estimators = prepared.estimators.as_ref()?;
        let rates = prepared.rates(step.part(step.t));
        step.x.add_everywhere(&weighed(&prepared.b, &rates));
        Some(Ok(estimators.each_ref().map(|weights| weighed(weights, &rates))))
    }
}
