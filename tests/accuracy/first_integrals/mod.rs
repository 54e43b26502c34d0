//! Fields with first integrals. Compares the errors of all conserving steps with solutions of twenty digits, and checks the integrals at every step.
//! Control methods must fail.
//!
//! The solutions are Taylor series of order 40 in arithmetic of 220 bits.

#![allow(clippy::excessive_precision, reason = "all digits of the reference solutions, rounded once")]

mod compared;
mod edges;
mod long;
mod poles;
mod recovered;
mod splittings;
mod systems;
mod time;
mod units;

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::space::Array;
use geoint_runtime::system::FirstIntegrals;
use systems::*;

/// A system at a start, with its solution.
struct Motion<S, const N: usize> {
    name: &'static str,
    system: S,
    start: [f64; N],
    time: f64,
    end: [f64; N],
    /// The number of steps of the first run; the others have 2 and 4 times as many.
    steps: u64,
}

impl<S, const N: usize> Motion<S, N>
where
    S: FirstIntegrals<State = FlowState<[f64; N]>, Phase = [f64; N]>,
{
    /// The largest error of a coordinate at the end, and the largest change of each integral on the way.
    fn run<M: Method<S>>(&self, method: M, steps: u64) -> (f64, Vec<f64>) {
        let Motion { system, start, time, end, .. } = self;
        let mut sim = Integrator::new(*system, method, time / steps as f64, FlowState::new(*start));
        let values = |state: FlowState<[f64; N]>| system.integrals(state.t, &state.x).as_slice().to_vec();
        let before = values(sim.state());
        let mut changes = vec![0.0_f64; before.len()];
        for _ in 0..steps {
            sim.step().unwrap_or_else(|error| panic!("{}: {error}", self.name));
            for (change, (a, b)) in changes.iter_mut().zip(values(sim.state()).iter().zip(&before)) {
                *change = change.max((a - b).abs());
            }
        }
        let x = sim.state().x;
        (x.iter().zip(end).map(|(x, end)| (x - end).abs()).fold(0.0, f64::max), changes)
    }

    /// Compares errors in n, 2n, 4n steps with a row of the table, the order with the claim, and changes of integrals with rounding.
    fn holds<M: Method<S> + Copy>(&self, method: M, row: &[f64]) {
        let name = format!("{}, {}", self.name, method.name());
        let errors = [0, 1, 2].map(|k| {
            let (error, changes) = self.run(method, self.steps << k);
            if let Some(expected) = row.get(k) {
                assert!((error / expected - 1.0).abs() < 0.02, "{name}, {k}: {error:.3e}, not {expected:.3e}");
            }
            for change in changes {
                assert!(change <= 2e-14, "{name}, {k}: an integral moves by {change:e}");
            }
            error
        });
        let claimed = f64::from(method.claims().order);
        let [coarse, fine] = [0, 1].map(|k| (errors[k] / errors[k + 1]).log2() - claimed);
        assert!(fine.abs() < 0.05, "{name}: order {:.3}", claimed + fine);
        // In longer steps the next term of the error is visible. The deviation from the claimed order then falls to a quarter.
        assert!(coarse.abs() < 0.05 || (3.0..5.0).contains(&(coarse / fine)), "{name}: {coarse:.3}, then {fine:.3}");
    }
}

const FOURTH: FourthOrder<DiscreteGradient> = FourthOrder(DiscreteGradient);

/// A row: steps with S(m), projected steps of order 2 and 4, and the composition of the first.
macro_rules! rows {
    ($($test:ident: $start:expr, $time:expr, $steps:expr, $end:expr; { $($system:expr => $($method:ident $row:expr),+;)+ })*) => {$(
        #[test]
        fn $test() {
            $({
                let motion = Motion {
                    name: stringify!($system), system: $system, start: $start, time: $time, end: $end, steps: $steps,
                };
                $(rows!(@ $method motion $row);)+
            })+
        }
    )*};
    (@ Second $motion:ident $row:expr) => { $motion.holds(DiscreteGradient, &$row) };
    (@ Fourth $motion:ident $row:expr) => { $motion.holds(FOURTH, &$row) };
    (@ Suzuki $motion:ident $row:expr) => { $motion.holds(Suzuki4.of(DiscreteGradient), &$row) };
}

const VERTICAL: [f64; 3] = [0.6, 0.0, 0.8];

rows! {
    lotka_volterra: [1.0, 0.5], 5.0, 50, [0.77147673840262978160, 0.51045216400203446710]; {
        LotkaVolterra { a: 2.0, b: 1.0, c: 1.0 } => Second [7.339e-3, 1.838e-3, 4.597e-4], Suzuki [3.016e-6];
        Predators { a: 2.0, b: 1.0, c: 1.0 } => Second [3.340e-4, 7.973e-5, 1.969e-5], Fourth [2.072e-5, 1.298e-6, 8.119e-8];
    }

    euler_top: [0.5, 0.8, -0.4], 10.0, 100, [-0.85561253291713022033, 0.39740054543889689429, -0.56629580211666389173]; {
        FreeBody { inertia: [1.0, 2.0, 3.0] } => Second [9.027e-4, 2.258e-4, 5.645e-5], Suzuki [5.855e-8];
        EulerTop { a: 1.0, b: 2.0, c: 3.0 } => Second [9.027e-4, 2.258e-4, 5.645e-5], Fourth [8.412e-8, 5.260e-9, 3.288e-10];
        LyapunovTop { a: 1.0, b: 2.0, c: 3.0, w: 0.5 } => Second [9.027e-4], Fourth [9.151e-8];
    }

    lorenz84_core: [1.0, 0.5, -0.3], 3.0, 60, [-1.1274566134891053462, -0.21756567454193858326, 0.14665183926834799221]; {
        LorenzCore { b: 4.0 } => Second [1.345e-2, 3.414e-3, 8.566e-4], Suzuki [7.819e-6];
        LorenzField { b: 4.0 } => Second [1.345e-2, 3.414e-3, 8.566e-4], Fourth [8.149e-6, 5.107e-7, 3.194e-8];
    }

    volterra5: [1.0, 0.5, 0.8, 1.2, 0.6], 3.0, 30,
        [2.5295809086075229707, 0.078530750263851688815, 1.2831423193222661713, 0.060863164275746965526, 0.14788285753061220365]; {
        Volterra => Second [4.714e-4, 1.179e-4, 2.946e-5], Suzuki [4.321e-8];
        VolterraField => Second [2.882e-4, 7.207e-5, 1.802e-5], Fourth [2.899e-8, 1.814e-9, 1.134e-10];
    }

    ring3: [1.0, 0.5, 0.8], 5.0, 50, [0.95356474896859081907, 0.48952391985507311643, 0.85691133117633606449]; {
        Ring => Second [2.393e-3, 5.987e-4, 1.497e-4], Suzuki [3.162e-7];
        RingProduct => Second [2.459e-3];
        RingField => Second [2.315e-3, 5.791e-4, 1.448e-4], Fourth [3.355e-7, 2.097e-8, 1.311e-9];
    }

    epidemics: [0.9, 0.1, 0.0], 10.0, 50, [0.058959749238950772248, 0.032526994586720315814, 0.90851325617432891194]; {
        EpidemicProduct { k: 1.5, l: 0.5 } => Second [6.795e-5, 1.701e-5, 4.253e-6];
        Epidemic { k: 1.5, l: 0.5 } => Second [3.615e-5, 9.049e-6, 2.263e-6], Fourth [2.323e-8, 1.451e-9, 9.071e-11];
    }

    lagrange: [0.3, -0.2, 2.0, VERTICAL[0], VERTICAL[1], VERTICAL[2]], 5.0, 50,
        [-1.1469732122463854901, -0.93183370060149636357, 2.0, -0.94971702955080800372, -0.12623583522340901208,
         0.28653460120313219441]; {
        HeavyTop { inertia: [2.0, 2.0, 1.0], r: [0.0, 0.0, 1.0] } => Second [2.928e-2, 7.350e-3, 1.839e-3], Suzuki [1.145e-5];
        LagrangeTop { a: 2.0, c: 1.0, l: 1.0 } => Second [2.928e-2, 7.350e-3, 1.839e-3], Fourth [1.734e-5, 1.086e-6, 6.788e-8];
    }

    kovalevskaya: [0.3, -0.2, 0.5, VERTICAL[0], VERTICAL[1], VERTICAL[2]], 5.0, 50,
        [1.1601930438033888589, 1.1272590121190907921, -0.57298984740226171146, -0.060848877436403746300, 0.071075203946147870697,
         -0.99561324293057844058]; {
        HeavyTop { inertia: [2.0, 2.0, 1.0], r: [1.0, 0.0, 0.0] } => Second [4.803e-3, 1.202e-3, 3.006e-4], Suzuki [7.472e-7];
        KovalevskayaTop => Second [4.374e-3, 1.095e-3, 2.739e-4], Fourth [1.168e-6, 7.312e-8, 4.571e-9];
    }

    goryachev: [0.4, 0.3, -0.3, VERTICAL[0], VERTICAL[1], VERTICAL[2]], 5.0, 50,
        [-2.2272284377830630335, 1.8634927218740777820, 0.59072334447721822587, -0.55237098967358042588, -0.43471674586206646449,
         -0.71127184721042124622]; {
        HeavyTop { inertia: [4.0, 4.0, 1.0], r: [1.0, 0.0, 0.0] } => Second [2.043e-3, 5.124e-4, 1.282e-4], Suzuki [4.100e-7];
        GoryachevTop => Second [2.043e-3, 5.124e-4, 1.282e-4], Fourth [5.242e-7, 3.279e-8, 2.050e-9];
    }

    toda_flaschka: [0.5, -0.2, 0.3, -0.4, 1.0, 0.7, 0.9], 3.0, 30,
        [1.4665053656488018624, 0.79738827219901983477, -0.73686146624697855633, -1.3270321716008431408, 0.089305856663195050467,
         0.039517999633558566882, 0.12345107192865709968]; {
        Toda => Second [1.528e-3, 3.897e-4, 9.790e-5], Suzuki [1.627e-6];
        TodaField => Second [1.193e-3, 3.048e-4, 7.662e-5], Fourth [6.171e-6, 3.874e-7, 2.424e-8];
    }

    vortices4: [0.0, 1.0, 0.2, -1.1, 0.0, 0.3, 1.2, -0.4], 1.0, 50,
        [1.2131199504944379595, -1.5530891711957601067, -0.29701546410884065870, 0.032014309262747198375, -1.9315032888371548361,
         -0.55207141742493087460, -2.5057253649990021506, -0.42335974710399518842]; {
        Vortices { gamma: [1.0, 2.0, -1.0, 3.0] } => Second [4.251e-3, 1.070e-3, 2.681e-4], Suzuki [3.028e-6];
        VortexField { gamma: [1.0, 2.0, -1.0, 3.0] } => Second [7.224e-3, 1.796e-3, 4.483e-4], Fourth [8.506e-6, 5.321e-7, 3.327e-8];
    }

    ablowitz_ladik4: [0.5, 0.1, -0.2, 0.3, 0.0, 0.4, 0.2, -0.1], 2.0, 40,
        [-0.13423447273867066019, 0.0018969427673376861584, 0.26757772295915770435, 0.15825055912463559002, 0.55044711613164499503,
         -0.10124090257074487773, -0.067567555249788739612, 0.42978123526427892912]; {
        AblowitzLadik => Second [2.399e-3, 6.031e-4, 1.510e-4], Suzuki [9.321e-7];
        AblowitzField => Second [2.027e-3, 5.093e-4, 1.275e-4], Fourth [9.663e-7, 6.051e-8, 3.783e-9];
    }

    charges: [0.5, -0.3, 0.2, 0.4, 0.7, -0.1], 5.0, 50,
        [-0.63772189560547351992, 0.61721232894004678030, -0.19668686109139586141, -0.53834266129082627439, -0.36740455661945594058,
         0.10259489007550804684]; {
        Charge => Second [4.529e-3, 1.144e-3, 2.868e-4], Suzuki [2.078e-6];
        ChargeField => Second [4.332e-3, 1.095e-3, 2.744e-4], Fourth [3.257e-6, 2.040e-7, 1.275e-8];
    }

    waves: [0.7, 0.5, 0.3, 0.1, -0.4, 0.6], 5.0, 50,
        [0.75846928991382281614, -0.72422158367188693999, -0.27485150777108191817, -0.26897134434147789266, 0.18200094934649253275,
         -0.47627240194737550976]; {
        ThreeWaves => Second [2.905e-4, 7.268e-5, 1.817e-5], Suzuki [9.063e-8];
        WaveField => Second [3.669e-4, 9.195e-5, 2.300e-5], Fourth [1.008e-7, 6.318e-9, 3.952e-10];
    }

    henon_and_heiles: [0.1, -0.2, 0.3, 0.25], 2.0, 10,
        [0.19978796855935517248, 0.23415479193657240149, -0.31368408051810332377, 0.023625090875938378016]; {
        HenonHeiles => Second [3.159e-3, 7.921e-4, 1.982e-4], Fourth [3.890e-6, 2.439e-7, 1.525e-8];
    }
}

/// The state after a run from t = 0.
fn end<S, M, const N: usize>(system: S, method: M, start: [f64; N], time: f64, steps: u64) -> FlowState<[f64; N]>
where
    S: PhaseSpace<State = FlowState<[f64; N]>>,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, time / steps as f64, FlowState::new(start));
    sim.advance(steps).unwrap_or_else(|error| panic!("{error}"));
    sim.state()
}

/// Controls: methods that conserve none, or not all, of these functions.
#[test]
fn controls_fail() {
    let moves = |name: &str, function: &dyn Fn(f64) -> f64, expected: f64| {
        let change = (function(1.0) - function(0.0)).abs();
        assert!((change / expected - 1.0).abs() < 0.05, "{name} moves by {change:.3e}, not {expected:.1e}");
    };
    /// A function at the start, or at the end.
    macro_rules! along {
        ($system:expr, $start:expr, $end:expr, $function:ident) => {{
            let (system, ends) = ($system, [FlowState::new($start), $end]);
            move |side: f64| system.$function(&ends[side as usize])
        }};
    }
    let start = [1.0, 0.5];
    let predators = Predators { a: 2.0, b: 1.0, c: 1.0 };
    let midpoint = end(predators, ImplicitMidpoint, start, 5.0, 50);
    moves("midpoint, wealth", &along!(predators, start, midpoint, wealth), 5.6e-4);

    let start = [0.3, -0.2, 2.0, VERTICAL[0], VERTICAL[1], VERTICAL[2]];
    let top = LagrangeTop { a: 2.0, c: 1.0, l: 1.0 };
    let runge_kutta = end(top, RK4, start, 5.0, 50);
    moves("RK4, energy", &along!(top, start, runge_kutta, energy), 1.5e-5);
    moves("RK4, length", &along!(top, start, runge_kutta, length), 1.8e-5);

    let start = [1.0, 0.5, 0.8, 1.2, 0.6];
    moves("Kahan, odd", &along!(VolterraField, start, end(VolterraField, Kahan, start, 3.0, 30), odd), 2.2e-3);
    moves("S(m), odd", &along!(VolterraField, start, end(Volterra, DiscreteGradient, start, 3.0, 30), odd), 5.6e-4);

    let start = [1.0, 0.5, 0.8];
    moves("S(m), product", &along!(RingField, start, end(Ring, DiscreteGradient, start, 5.0, 50), product), 3.3e-6);

    let start = [0.5, 0.1, -0.2, 0.3, 0.0, 0.4, 0.2, -0.1];
    let sites = end(AblowitzLadik, DiscreteGradient, start, 2.0, 40);
    moves("S(m), norm", &along!(AblowitzField, start, sites, norm), 1.0e-4);
}

/// The report names properties of a field or structure that the user has not listed.
#[test]
fn what_is_found_is_reported() {
    let reports = |report: &str, line: &str| assert!(report.contains(line), "{line} is missing in\n{report}");
    reports(HeavyTop::<f64>::REPORT, "a Casimir");
    reports(HeavyTop::<f64>::REPORT, "a Poisson structure: Jacobi's identity holds");
    reports(LorenzCore::<f64>::REPORT, "not a Poisson structure: in Jacobi's identity indices (0, 1, 2) leave");
    reports(EulerTop::<f64>::REPORT, "kept, proven by multiplying out");
    reports(KovalevskayaTop::REPORT, "kovalevskaya = ");
    // Steps take this reciprocal for positive x only. The report writes it as a reciprocal.
    reports(LotkaVolterra::<f64>::REPORT, "a/x[1]");
    // Steps of order 4 keep both Casimirs of a heavy top.
    assert_eq!(<HeavyTop as FirstIntegrals>::NAMES.len(), 3);
    assert_eq!(<Volterra as FirstIntegrals>::NAMES, ["energy"]);
    // The sum of all species is linear.
    reports(Volterra::REPORT, "constant as well, not listed");
    // A logarithm is no less a Casimir where H does not take it.
    reports(Volterra::REPORT, "ln(x[0]) + ln(x[2]) + ln(x[4]): a Casimir; `FourthOrder` does not take it");
}
