mod flow_assumed_wrong {
    use geoint_runtime::prelude::*;

    /// Only what may be true is assumed.
    #[vector_field(keeps(assume(saddle = x[0] * x[0] - x[1] * x[1])))]
    fn turning(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

mod flow_dependent_integrals {
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(sum = x[0] + x[1] + x[2], product = x[0] * x[1] * x[2], square = (x[0] + x[1] + x[2]).powi(2)))]
    fn ring(x: [f64; 3]) -> [f64; 3] {
        [x[0] * (x[1] - x[2]), x[1] * (x[2] - x[0]), x[2] * (x[0] - x[1])]
    }
}

mod flow_integral_named_as_a_function {
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(field = x[0] * x[0] + x[1] * x[1]))]
    fn turning(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

mod flow_integral_on_a_level {
    use geoint_runtime::prelude::*;

    /// The integral of Goryachev and Chaplygin is one for m·γ = 0 alone.
    #[vector_field(keeps(goryachev = x[2] * (x[0] * x[0] + x[1] * x[1]) - 4.0 * x[0] * x[5]))]
    fn top(x: [f64; 6]) -> [f64; 6] {
        let [m1, m2, m3, g1, g2, g3] = x;
        let [u, v, w] = [m1 / 4.0, m2 / 4.0, m3];
        [m2 * w - m3 * v, m3 * u - m1 * w + g3, m1 * v - m2 * u - g2, g2 * w - g3 * v, g3 * u - g1 * w, g1 * v - g2 * u]
    }
}

mod flow_integral_that_jumps {
    use geoint_runtime::prelude::*;

    /// Its derivative is zero on both sides.
    #[vector_field(keeps(radius = x[0] * x[0] + x[1] * x[1] + if x[0] > l { 1.0 } else { 0.0 }))]
    fn turning(x: [f64; 2], l: f64) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

mod flow_integral_that_reads_time {
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(begun = x[0] * t.cos() + x[1] * t.sin()))]
    fn turning(x: [f64; 2], t: f64) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

mod flow_more_integrals_than_fit {
    use geoint_runtime::prelude::*;

    /// In the plane there is one.
    #[vector_field(keeps(radius = x[0] * x[0] + x[1] * x[1], other = (x[0] * x[0] + x[1] * x[1]).sin()))]
    fn turning(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }

    #[vector_field(keeps(square = w * w))]
    fn constant(x: [f64; 2], w: f64) -> [f64; 2] {
        [w * x[1], -w * x[0]]
    }
}

mod flow_unproven_integral {
    use geoint_runtime::prelude::*;

    /// atan x + atan 1/x is π/2 for positive x.
    #[vector_field(keeps(energy = (x[0] * x[0] + x[1] * x[1]) / 2.0))]
    fn swing(x: [f64; 2]) -> [f64; 2] {
        [x[1] * ((x[1] * x[1]).atan() + (1.0 / (x[1] * x[1])).atan()), -x[0] * std::f64::consts::FRAC_PI_2]
    }
}

mod flow_wrong_integral {
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(
        energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
        momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] - c * c * x[2] * x[2]) / 2.0,
    ))]
    fn euler_top(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
        [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
    }
}

mod flow_integral_that_jumps_along_solutions {
    use geoint_runtime::prelude::*;

    /// The radius is constant, so that rounding decides whether it is more than 1.
    #[vector_field(keeps(radius = if x[0].hypot(x[1]) > 1.0 { x[0].hypot(x[1]) } else { 2.0 * x[0].hypot(x[1]) }))]
    fn turning(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

mod flow_integral_with_half_a_turn {
    use geoint_runtime::prelude::*;

    /// The angle of (x², x) is atan x, or atan x + π.
    #[vector_field(keeps(height = x[1] - (x[0].powi(2).atan2(x[0]) - x[0].atan())))]
    fn still(x: [f64; 2]) -> [f64; 2] {
        [1.0, 0.0]
    }
}

fn main() {}
