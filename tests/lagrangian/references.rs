//! Final states against solutions to twenty digits, which were found from the Lagrangians by another method.

use crate::systems::*;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// The largest difference.
fn far<const N: usize>(found: [f64; N], expected: [f64; N]) -> f64 {
    found.iter().zip(expected).fold(0.0, |far, (found, expected)| f64::max(far, (found - expected).abs()))
}

/// Runs to a time and compares positions, and velocities.
macro_rules! reaches {
    ($name:ident: $system:expr, $start:expr, $time:literal, $method:expr, $steps:literal => $q:expr, $v:expr, $within:literal) => {
        #[test]
        fn $name() -> Result<(), StepError> {
            let system = $system;
            let mut sim = system.integrator($method, $time / f64::from($steps), $start(&system));
            sim.advance($steps)?;
            let (q, v) = (into(sim.state().q), into(sim.velocity()));
            assert!(far(q, into($q)) < $within, "{q:?} {:.1e} {:.1e}", far(q, into($q)), far(v, into($v)));
            assert!(far(v, into($v)) < $within, "{v:?} {:.1e}", far(v, into($v)));
            Ok(())
        }
    };
}

/// Coordinates in a row.
fn into<Q: geoint_runtime::Coordinates>(q: Q) -> Q::Array {
    q.into_array()
}

pub(crate) const DOUBLE_PENDULUM: DoublePendulum = DoublePendulum { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81 };
pub(crate) const BRAKED: Braked = Braked { m: [1.0, 0.6], l: [1.0, 0.8], g: 9.81, gamma: 0.3 };
pub(crate) const ARM: Arm = Arm { m: [2.0, 1.0, 0.5], l: [1.0, 0.8, 0.5], g: 9.81 };

reaches!(cubic: Cubic { epsilon: 0.2, delta: 0.1 }, |s: &Cubic| s.at(0.8, 0.5), 5.0, Gauss::<3>, 400
    => -0.289_294_104_917_705_64, 1.059_984_813_576_050_4, 1e-13);
reaches!(double_pendulum: DOUBLE_PENDULUM, |s: &DoublePendulum| s.at([0.0, 1.4], [0.0, 0.0]), 2.0, Gauss::<3>, 1000
    => [0.448_335_338_590_095_85, -0.395_189_239_437_110_16], [1.632_829_344_777_859_8, -0.298_964_447_871_316_94], 1e-13);
reaches!(spherical_pendulum: SphericalPendulum { m: 1.0, l: 1.0, g: 9.81 }, |s: &SphericalPendulum| s.at([1.0, 0.0], [0.0, 2.0]), 3.0, Gauss::<4>, 400
    => [0.849_050_422_962_852_4, 10.868_062_174_150_499], [1.278_805_364_921_398_7, 2.513_213_702_062_041], 1e-13);
reaches!(hoop: Hoop { omega: 4.0, g: 9.81 }, |s: &Hoop| s.at(0.5, 0.0), 3.0, Gauss::<3>, 400
    => 1.049_199_089_925_089_8, 0.952_849_402_595_231_9, 1e-13);
reaches!(hoop_by_kicks: Hoop { omega: 4.0, g: 9.81 }, |s: &Hoop| s.at(0.5, 0.0), 3.0, BlanesMoanSrkn14a, 400
    => 1.049_199_089_925_089_8, 0.952_849_402_595_231_9, 1e-13);
reaches!(parabola: Parabola { omega: 2.0, g: 9.81 }, |s: &Parabola| s.at(1.0, 0.0), 3.0, Gauss::<4>, 400
    => 0.814_372_818_184_970_8, -1.200_081_897_567_637_9, 1e-13);
reaches!(relativistic: Relativistic { m: 1.0, c: 1.0, k: 1.0 }, |s: &Relativistic| s.at(2.0, 0.0), 10.0, Gauss::<4>, 400
    => 1.998_656_821_955_235_8, 0.073_139_252_586_946_94, 1e-13);
reaches!(relativistic_by_kicks: Relativistic { m: 1.0, c: 1.0, k: 1.0 }, |s: &Relativistic| s.at(2.0, 0.0), 10.0, KahanLi8_17a.of(StormerVerlet), 800
    => 1.998_656_821_955_235_8, 0.073_139_252_586_946_94, 1e-12);
reaches!(moving_pivot: MovingPivot { a: 0.1, omega: 20.0, g: 9.81 }, |s: &MovingPivot| s.at(3.0, 0.1), 1.0, Gauss::<4>, 400
    => 2.369_899_917_770_885_8, -0.791_313_689_917_934_7, 1e-13);
reaches!(charge: Charge { k: 0.25 }, |s: &Charge| s.at([1.0, 0.0], [0.0, 0.5]), 5.0, Gauss::<3>, 400
    => [0.460_774_781_804_450_07, 0.911_161_209_706_787_9], [-0.477_824_799_565_82, -0.020_478_918_654_218_896], 1e-13);
reaches!(arm: ARM, |s: &Arm| s.at([0.5, 0.4, -0.3], [0.0, 0.0, 1.0]), 1.0, Gauss::<4>, 100
    => [-0.375_432_378_799_586_33, -0.368_132_413_713_317_57, 0.137_926_972_387_209_15],
    [-1.108_979_607_263_031_3, 0.666_992_303_954_245_8, -1.626_811_823_753_248_9], 2e-13);
reaches!(braked: BRAKED, |s: &Braked| s.at([0.0, 1.4], [0.0, 0.0], 0.0), 2.0, KahanLi8_17a.of(ContactMidpoint), 400
    => [0.333_568_811_836_901_52, -0.382_021_839_677_322_04], [1.054_955_979_220_659_7, 0.124_369_280_640_925_56], 1e-12);
reaches!(growing: Growing { a: 0.1 }, |s: &Growing| s.at(1.0, 0.5, 0.3), 2.0, KahanLi8_17a.of(ContactMidpoint), 200
    => 0.532_274_454_733_603_7, -0.666_565_417_405_414_9, 1e-12);
reaches!(fading: Fading { a: 0.1 }, |s: &Fading| s.at([1.0, 0.2], [0.1, 0.8], 0.0), 3.0, KahanLi8_17a.of(ContactSplitting), 300
    => [-0.898_317_829_766_006_4, 0.258_568_765_720_447_75], [-0.293_059_757_368_273_65, -0.529_672_814_786_582_4], 1e-12);
reaches!(quadratic_dissipation: QuadraticDissipation { a: 0.05 }, |s: &QuadraticDissipation| s.at(0.5, 0.5, -0.2), 10.0, KahanLi8_17a.of(ContactSplitting), 500
    => -0.821_997_590_162_185_7, -0.152_271_926_731_794_23, 1e-12);
reaches!(driven: Driven { a: 0.1, b: 0.3 }, |s: &Driven| s.at(-0.25, 0.75, 0.0), 10.0, BlanesMoanSrkn14a, 400
    => 0.818_905_670_409_786_7, -1.113_727_709_339_871_3, 1e-12);

/// The action that Herglotz' principle is about.
#[test]
fn the_action_is_that_of_herglotz() -> Result<(), StepError> {
    let mut sim = BRAKED.integrator(KahanLi8_17a.of(ContactMidpoint), 0.005, BRAKED.at([0.0, 1.4], [0.0, 0.0], 0.0));
    sim.advance(400)?;
    assert!((sim.state().s - 30.686_536_218_045_865).abs() < 1e-11, "{}", sim.state().s);
    let system = Growing { a: 0.1 };
    let mut sim = system.integrator(KahanLi8_17a.of(ContactMidpoint), 0.01, system.at(1.0, 0.5, 0.3));
    sim.advance(200)?;
    assert!((sim.state().s - 1.224_646_676_919_682_4).abs() < 1e-12, "{}", sim.state().s);
    assert!((sim.state().p + 0.829_826_842_080_439_4).abs() < 1e-12, "{}", sim.state().p);
    Ok(())
}

/// Follows the cycloid between two of its points, and checks Beltrami's constant.
#[test]
fn a_brachistochrone_is_a_cycloid() -> Result<(), StepError> {
    let point = |a: f64| (a - a.sin(), 1.0 - a.cos(), a.sin() / (1.0 - a.cos()));
    let ((x, y, slope), (end, ..)) = (point(1.0), point(2.0));
    let start = Brachistochrone.at_time(x, y, slope);
    let mut sim = Brachistochrone.integrator(Gauss::<4>, (end - x) / 100.0, start);
    sim.advance(100)?;
    assert!((sim.state().q - 1.416_146_836_547_142_4).abs() < 1e-13);
    assert!((sim.velocity() - 0.642_092_615_934_330_7).abs() < 1e-13);
    let mut sim = Brachistochrone.integrator(DiscreteGradient, (end - x) / 10.0, start);
    sim.advance(10)?;
    let beltrami = sim.state().q * (1.0 + sim.velocity().powi(2));
    assert!((beltrami - 2.0).abs() < 1e-13, "{beltrami}");
    Ok(())
}

/// Its energy is a square root, whose square is a quadratic form, which Gauss methods keep.
#[test]
fn a_catenary_is_a_hyperbolic_cosine() -> Result<(), StepError> {
    let mut sim = Catenary.integrator(Gauss::<2>, 0.1, Catenary.at(1.0, 0.0));
    sim.advance(20)?;
    assert!((sim.state().q - 2_f64.cosh()).abs() < 2e-6);
    let beltrami = sim.state().q / (1.0 + sim.velocity().powi(2)).sqrt();
    assert!((beltrami - 1.0).abs() < 1e-14, "{beltrami}");
    Ok(())
}
