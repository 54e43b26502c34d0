//! Steps do not cross poles of the energy, even if no sign differs at the ends of the step.
//!
//! The energies have denominators that touch zero, several poles within one step, and poles that depend on a parameter. Poles divide the axis of q
//! into cells. An accepted step has no pole on the straight line between its ends, so a system with one degree of freedom stays in its cell.

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{DiscreteField, SolvedByGauss};
use geoint_runtime::system::Autonomous;
use geoint_runtime::{Hamiltonian, Method};
use geoint_tests::grid::pairs;
use geoint_tests::methods::{self, Visitor};
use std::f64::consts::{PI, TAU};

/// Defines energies H = p²/2m + k·V(q), and a function that visits each of them with k = −0.3 (attracting poles) and with k = 0.3 (repelling poles).
///
/// A row holds V, the name of the system, a function that numbers the cell of q, and a start. V or the force is undefined at the boundaries of cells.
macro_rules! walls {
    ($list:ident: $($name:ident($q:ident, $p:ident, $m:ident) $potential:expr => $System:ident, |$x:ident| $cell:expr, $start:expr;)*) => {
        $( #[hamiltonian]
        fn $name($q: f64, $p: f64, $m: f64, k: f64) -> f64 { $p * $p / (2.0 * $m) + k * ($potential) } )*

        fn $list<V: Walls>(visitor: &mut V) {
            $( for k in [-0.3, 0.3] {
                visitor.wall(stringify!($name), $System { $m: 1.3, k }, |$x| $cell, $start);
            } )*
        }
    };
}

/// A test that visits systems with poles.
trait Walls {
    fn wall<S>(&mut self, name: &str, system: S, cell: fn(f64) -> f64, start: f64)
    where
        S: DiscreteField + Autonomous<Coordinates = f64> + SolvedByGauss + SolvedBy<DiscreteGradient>;
}

walls! { kinds:
    cosine(q, p, m) 1.0 / (1.0 - q.cos()) => Cosine, |q| (q / TAU).floor(), 1.0;
    square_of_tangent(q, p, m) q.tan().powi(2) => SquareOfTangent, |q| (q / PI).round(), 0.4;
    negative_parameter(q, p, m) 1.0 / (q * q - m).powi(2) => NegativeParameter, |q| (q * q - 1.3).signum() * q.signum(), 2.0;
}

walls! { others:
    logarithm_of_cosine(q, p, m) q.cos().ln() => LogarithmOfCosine, |q| (q / PI).round(), 0.4;
    centre(q, p, m) 1.0 / q.hypot(0.0) => Centre, |q| q.signum(), 1.0;
    expanded_square(q, p, m) 1.0 / (q * q - 2.0 * q + 1.0) => ExpandedSquare, |q| (q - 1.0).signum(), 2.0;
    expanded_fourth(q, p, m) 1.0 / (q.powi(4) - 2.0 * q * q + 1.0) => ExpandedFourth, |q| (q - 1.0).signum(), 2.0;
    hyperbolic(q, p, m) 1.0 / (q.cosh() - 1.0) => Hyperbolic, |q| q.signum(), 1.0;
    bell(q, p, m) 1.0 / (1.0 - (-q * q).exp()) => Bell, |q| q.signum(), 1.0;
    sine_squared(q, p, m) 1.0 / q.sin().powi(2) => SineSquared, |q| (q / PI).floor(), 1.0;
    cosine_squared(q, p, m) 1.0 / (1.0 - q.cos().powi(2)) => CosineSquared, |q| (q / PI).floor(), 1.0;
    root_of_cosine(q, p, m) 1.0 / (2.0 - 2.0 * q.cos()).sqrt() => RootOfCosine, |q| (q / TAU).floor(), 1.0;
    secant(q, p, m) 1.0 / q.cos() => Secant, |q| (q / PI).round(), 0.4;
    larger(q, p, m) 1.0 / q.abs().max(-q) => Larger, |q| q.signum(), 1.0;
    cubic_root(q, p, m) 1.0 / (q * q).cbrt() => CubicRoot, |q| q.signum(), 1.0;
    shifted_norm(q, p, m) 1.0 / ((q - 1.0) * (q - 1.0) + (2.0 * q - 2.0) * (2.0 * q - 2.0)).sqrt() => ShiftedNorm, |q| (q - 1.0).signum(), 2.0;
    cotangent(q, p, m) 1.0 / q.tanh() => Cotangent, |q| q.signum(), 1.0;
    lennard_jones(q, p, m) (q * q).powi(-6) - (q * q).powi(-3) => LennardJones, |q| q.signum(), 1.5;
    finite_spring(q, p, m) (4.0 - q * q).ln() => FiniteSpring, |q| if q.abs() < 2.0 { 0.0 } else { q.signum() }, 1.0;
    two_walls(q, p, m) ((4.0 - q * q) * (q * q - 9.0)).powi(-2) => TwoWalls, |q| if q.abs() < 2.0 { 0.0 } else { q.signum() }, 1.0;
    inverse_tangent(q, p, m) (0.5 * q).atanh().powi(2) => InverseTangent, |q| if q.abs() < 2.0 { 0.0 } else { q.signum() }, 1.0;
    of_the_sine(q, p, m) q.sin().atanh().powi(2) => OfTheSine, |q| (q / PI).round(), 0.4;
    negative_power(q, p, m) (q * q).powf(-m) => NegativePower, |q| q.signum(), 1.0;
    in_a_branch(q, p, m) if q < 0.5 { 1.0 / (1.0 - q.cos()) } else { 1.0 / (1.0 - 0.5_f64.cos()) } => InABranch, |q| if q > 0.0 { 0.0 } else { (q / TAU).floor() }, 1.0;
    root_gap(q, p, m) (q * q - 1.0).sqrt() => RootGap, |q| q.signum(), 2.0;
    simplified(q, p, m) q * q.recip() * q => Simplified, |q| q.signum(), 1.0;
}

/// Momenta at the start.
const MOMENTA: [f64; 3] = [-0.7, -3.0, 8.0];
/// Step sizes.
const STEPS: [f64; 4] = [0.03, 0.1, 0.9, 2.0];

/// Runs a system with each visited method, asserts that q stays in its cell, and counts the runs that a refused step ends.
struct Stay<S> {
    wall: String,
    system: S,
    cell: fn(f64) -> f64,
    start: f64,
    /// One of `few` pairs of a momentum and a step is taken in unoptimised builds.
    few: usize,
    refused: u32,
}

impl<S: Hamiltonian<Coordinates = f64>> Visitor<S, f64> for Stay<S> {
    fn visit<M: Method<S> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        // Explicit methods are not tested here.
        if ["ExplicitEuler", "RK4", "DOP853"].contains(&name.as_str()) {
            return;
        }
        for (p, h) in pairs(&MOMENTA, &STEPS, self.few, &format!("{}, {name}", self.wall)) {
            let start = State::new(self.start, p);
            let mut sim = self.system.integrator(method, h, start);
            let (mut outcome, mut steps) = (Ok(()), 0);
            while steps < 60 && outcome.is_ok() {
                outcome = sim.step();
                let q = sim.state().q;
                // Rounding of π may put q on the boundary. A neighbouring number in the cell is enough.
                let near = [q, q.next_up(), q.next_down()];
                let stays = near.iter().any(|q| (self.cell)(*q) == (self.cell)(self.start));
                assert!(stays, "{}, {name}: {q} in step {steps} of {h} from {start:?}", self.wall);
                steps += 1;
            }
            self.refused += u32::from(matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { .. }, .. })));
            // `advance` gives the same result as single steps.
            let mut bulk = self.system.integrator(method, h, start);
            assert_eq!(
                (bulk.advance(60), bulk.state()),
                (outcome, sim.state()),
                "{}, {name}: {h} from {start:?}",
                self.wall
            );
        }
    }
}

/// Visits one method of every kind.
struct Every;

impl Walls for Every {
    fn wall<S>(&mut self, name: &str, system: S, cell: fn(f64) -> f64, start: f64)
    where
        S: DiscreteField + Autonomous<Coordinates = f64> + SolvedByGauss + SolvedBy<DiscreteGradient>,
    {
        let mut stay = Stay { wall: name.into(), system, cell, start, few: 1, refused: 0 };
        methods::kinds_of_general(&mut stay);
        methods::kinds_of_discrete_gradient(&mut stay);
        methods::kinds_of_itoh_abe(&mut stay);
        methods::itoh_abe_one_way(&mut stay);
        methods::coordinate_increment(&mut stay);
        // Walls that no run meets would test nothing.
        assert!(stay.refused > 10, "{name}: {}", stay.refused);
    }
}

/// No kind of method crosses the poles of three systems.
#[test]
fn no_method_crosses_a_wall() {
    kinds(&mut Every);
}

/// Visits one method of each family, because the list of systems is long.
struct Families;

impl Walls for Families {
    fn wall<S>(&mut self, name: &str, system: S, cell: fn(f64) -> f64, start: f64)
    where
        S: DiscreteField + Autonomous<Coordinates = f64> + SolvedByGauss + SolvedBy<DiscreteGradient>,
    {
        let mut stay = Stay { wall: name.into(), system, cell, start, few: 3, refused: 0 };
        stay.visit(DiscreteGradient);
        stay.visit(Gonzalez);
        stay.visit(ItohAbe);
        stay.visit(MeanValue::<2>);
        stay.visit(ImplicitMidpoint);
        stay.visit(Gauss::<3>);
        assert!(stay.refused > 0, "{name}");
    }
}

/// No family of methods crosses the poles of the other systems.
#[test]
fn no_wall_is_crossed() {
    others(&mut Families);
}
