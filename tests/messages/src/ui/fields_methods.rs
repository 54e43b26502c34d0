mod flow_keeps_nothing {
    use geoint_runtime::prelude::*;

    /// There is nothing to project onto.
    #[vector_field]
    fn lorenz(x: [f64; 3], s: f64, r: f64, b: f64) -> [f64; 3] {
        [s * (x[1] - x[0]), r * x[0] - x[1] - x[0] * x[2], x[0] * x[1] - b * x[2]]
    }

    fn uses() {
        let mut sim = Lorenz { s: 10.0, r: 28.0, b: 8.0 / 3.0 }.integrator(DiscreteGradient, 0.01, FlowState::new([1.0; 3]));
        sim.advance(10).unwrap();
    }
}

mod flow_keeps_nothing_of_order_four {
    use geoint_runtime::prelude::*;

    /// There is nothing to project onto.
    #[vector_field]
    fn lorenz(x: [f64; 3], s: f64, r: f64, b: f64) -> [f64; 3] {
        [s * (x[1] - x[0]), r * x[0] - x[1] - x[0] * x[2], x[0] * x[1] - b * x[2]]
    }

    fn uses() {
        let method = FourthOrder(DiscreteGradient);
        let mut sim = Lorenz { s: 10.0, r: 28.0, b: 8.0 / 3.0 }.integrator(method, 0.01, FlowState::new([1.0; 3]));
        sim.advance(10).unwrap();
    }
}

mod flow_relaxed {
    use geoint_runtime::{methods::*, prelude::*};

    /// Nothing is named that could be kept.
    #[vector_field]
    fn circle(x: [f64; 3], w: f64) -> [f64; 3] {
        [w * x[1], -w * x[0], x[2].sin()]
    }

    fn uses() {
        let mut sim = Circle { w: 1.3 }.integrator(Relaxation(RK4), 0.01, FlowState::new([1.0; 3]));
        sim.advance(10).unwrap();
    }
}

mod flow_swells {
    use geoint_runtime::prelude::*;

    /// Of the thesis: div f = t + 2, so that there is no H to be kept.
    #[vector_field]
    fn swelling(x: [f64; 2], t: f64) -> [f64; 2] {
        [x[0] * t - 2.0 * x[1], x[0] + 2.0 * x[1]]
    }

    fn uses() {
        let mut sim = Swelling.integrator(DiscreteGradient, 0.01, FlowState::new([1.0; 2]));
        sim.advance(10).unwrap();
    }
}

mod planes_of_a_field {
    use geoint_runtime::{methods::*, prelude::*};

    /// S is 1 + x², the sum that ∇I is divided by: no quotient of terms of both.
    #[vector_field(keeps(square = (1.0 + x[0] * x[0] + x[1] * x[1]).ln() + x[0] * x[1]))]
    fn turning(x: [f64; 2], w: f64) -> [f64; 2] {
        let [a, b] = x;
        let c = 1.0 + a * a + b * b;
        [w * (2.0 * b + c * a), -w * (2.0 * a + c * b)]
    }

    fn uses() {
        let mut sim = Turning { w: 1.3 }.integrator(PlanarSplitting, 0.01, FlowState::new([1.0; 2]));
        sim.advance(10).unwrap();
    }
}

mod planes_in_a_table_of_pieces {
    use geoint_runtime::{methods::*, prelude::*};

    #[hamiltonian(structure = |_, _| 1.0)]
    fn quartic(x: [f64; 3], k: f64) -> f64 {
        x.iter().map(|x| k * x.powi(4)).sum()
    }

    fn uses() {
        let _ = Quartic { k: 1.3 }.integrator(BlanesMoan4X.of(PlanarDiscreteGradient), 0.01, FlowState::new([1.0; 3]));
    }
}

mod planes_solved_for {
    use geoint_runtime::{methods::*, prelude::*};

    /// Every plane would have an equation of its own: 15.
    #[hamiltonian(structure = |_, _| 1.0)]
    fn quartic(x: [f64; 6], k: f64) -> f64 {
        x.iter().map(|x| k * x.powi(4)).sum()
    }

    fn uses() {
        let mut sim = Quartic { k: 1.3 }.integrator(PlanarItohAbePair, 0.01, FlowState::new([1.0; 6]));
        sim.advance(10).unwrap();
    }
}

mod planes_without_flows {
    use geoint_runtime::{methods::*, prelude::*};

    /// None of 15 planes has a flow in closed form.
    #[hamiltonian(structure = |_, _| 1.0)]
    fn quartic(x: [f64; 6], k: f64) -> f64 {
        x.iter().map(|x| k * x.powi(4)).sum()
    }

    fn uses() {
        let mut sim = Quartic { k: 1.3 }.integrator(Suzuki4.of(PlanarSplitting), 0.01, FlowState::new([1.0; 6]));
        sim.advance(10).unwrap();
    }
}

fn main() {}
