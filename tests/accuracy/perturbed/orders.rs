//! Orders in h and in the size of B.

use super::*;

const FREQUENT: f64 = 1.3;

fn end<M: Method<Hardening<Double>, Double>>(method: M, epsilon: f64, steps: u64) -> Vec<Double> {
    let [m, k, epsilon] = [1.0 / FREQUENT, FREQUENT, epsilon].map(Double::from);
    let start = State::new(Double::from(0.9), Double::from(0.3));
    let mut sim = Hardening { m, k, epsilon }.integrator(method, Double::from(4.0) / steps as f64, start);
    sim.advance(steps).expect("no singularity");
    flat(&sim.state())
}

/// Observes the last order of every table that claims several orders: the order of h if the rest is not small.
#[derive(Default)]
struct Orders {
    visited: usize,
    failures: Vec<String>,
}

impl Orders {
    fn observe<M: Method<Hardening<Double>, Double>>(
        &mut self,
        method: M,
        epsilon: f64,
        steps: u64,
        claimed: u32,
        tolerance: f64,
    ) {
        let exact = end(Rnia10_8_6, epsilon, 2048);
        let [long, short] = [steps, 2 * steps].map(|steps| distance(&end(method, epsilon, steps), &exact));
        let observed = (long / short).log2();
        println!("{:24} {epsilon:5.0e} claims {claimed}, observed {observed:.2}", method.name().to_string());
        if (observed - f64::from(claimed)).abs() > tolerance {
            self.failures.push(format!("{} at {epsilon}: claims {claimed}, observed {observed:.2}", method.name()));
        }
    }

    fn finish(self, expected: usize) {
        assert!(self.failures.is_empty(), "{}", self.failures.join("\n"));
        assert_eq!(self.visited, expected);
    }
}

impl Visitor<Hardening<Double>, Double> for Orders {
    fn visit<M: Method<Hardening<Double>, Double> + 'static>(&mut self, method: M) {
        let Claims { perturbed: [_, .., last], .. } = method.claims() else { return };
        self.visited += 1;
        self.observe(method, 0.03, 64, *last, 0.15);
    }
}

#[test]
fn tables_have_the_order_of_h_that_they_claim() {
    let mut orders = Orders::default();
    methods::perturbed(&mut orders);
    methods::perturbed_gradient(&mut orders);
    methods::processed(&mut orders);
    orders.finish(12);
}

/// To first order in B, a step sums B at the points that A has reached. The order is the order of this quadrature. For the next power the quadrature
/// must be wrong, because the table claims no more.
#[test]
fn to_first_order_in_the_rest_tables_are_quadratures() {
    fn check(name: &str, claims: Claims, drifts: &[f64], kicks: &[f64]) {
        let [first, ..] = *claims.perturbed else { panic!("{name} claims nothing") };
        let defect = |power: u32| {
            let mut reached = 0.0;
            let sum: f64 = drifts
                .iter()
                .zip(kicks)
                .map(|(a, b)| {
                    reached += a;
                    // About the middle of the step, where odd powers vanish.
                    b * (reached - 0.5_f64).powi(power as i32)
                })
                .sum();
            let exact = if power.is_multiple_of(2) { 0.5_f64.powi(power as i32) / f64::from(power + 1) } else { 0.0 };
            (sum - exact).abs() / 0.5_f64.powi(power as i32)
        };
        for power in 0..first {
            assert!(defect(power) < 1e-13, "{name}: {power}, {:e}", defect(power));
        }
        assert!(defect(first) > 1e-9, "{name} is of higher order than it claims: {:e}", defect(first));
    }
    macro_rules! check {
        ($($table:ident $($part:ident)*;)*) => { $({
            let table = $table.0$(.$part())*;
            let (drifts, _, kicks) = table.coefficients();
            check(stringify!($table), table.claims(), drifts, kicks);
        })* };
    }
    check!(WisdomHolman; Saba4; Aba8_4; Aba8_6_4; Aba10_6_4; Saba2Gradient; Saba3Gradient; Saba4Gradient; Saba5Gradient; Rnia10_8_6 table;);
}

/// Observes the order of h of errors that are quadratic in B. The even part in the size of B isolates these errors.
struct Middle(usize);

impl Visitor<Hardening<Double>, Double> for Middle {
    fn visit<M: Method<Hardening<Double>, Double> + 'static>(&mut self, method: M) {
        let Claims { perturbed: [_, middle, _], .. } = method.claims() else { return };
        self.0 += 1;
        let sizes = [1e-4, -1e-4, 0.0];
        // Tables have the digits of `f64`. Their error without B is subtracted as well.
        let even = |[plus, minus, none]: [Vec<Double>; 3]| {
            let both = plus.iter().zip(&minus).map(|(plus, minus)| *plus + *minus);
            both.zip(&none).map(|(both, none)| both - *none - *none).collect::<Vec<_>>()
        };
        let exact = even(sizes.map(|size| end(Rnia10_8_6, size, 1024)));
        let error = |steps| distance(&even(sizes.map(|size| end(method, size, steps))), &exact);
        let observed = (error(16) / error(32)).log2();
        println!("{:24} claims {middle}, observed {observed:.2}", method.name().to_string());
        assert!((observed - f64::from(*middle)).abs() < 0.1, "{}: {observed:.2}", method.name());
    }
}

/// Methods claim three orders. The middle one belongs to errors of second order in B.
#[test]
fn errors_of_second_order_in_the_rest_have_the_order_in_the_middle() {
    let mut middle = Middle(0);
    methods::perturbed(&mut middle);
    methods::perturbed_gradient(&mut middle);
    assert_eq!(middle.0, 3);
}

/// A processor removes errors of first order in B, like a better quadrature.
#[test]
fn processors_take_errors_of_first_order_away() {
    let mut orders = Orders::default();
    orders.observe(WisdomHolmanProcessed, 1e-6, 8, 10, 0.6);
    orders.observe(WisdomHolmanGradient, 1e-6, 8, 10, 0.6);
    orders.observe(WisdomHolman, 1e-6, 16, 2, 0.1);
    orders.finish(0);
}
