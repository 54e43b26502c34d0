mod flow_but_of_nothing {
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(but = [-x[0], -x[1]]))]
    fn decay(x: [f64; 2]) -> [f64; 2] {
        [-x[0], -x[1]]
    }
}

mod flow_of_an_energy {
    use geoint_runtime::prelude::*;

    #[vector_field]
    fn free_body(x: [f64; 3]) -> f64 {
        x[0] * x[0] + x[1] * x[1] / 2.0 + x[2] * x[2] / 3.0
    }
}

mod flow_of_another_shape {
    use geoint_runtime::prelude::*;

    #[vector_field]
    fn lorenz(x: [f64; 3], s: f64, r: f64) -> [f64; 2] {
        [s * (x[1] - x[0]), r * x[0] - x[1] - x[0] * x[2]]
    }
}

mod flow_of_two_numbers {
    use geoint_runtime::prelude::*;

    #[vector_field]
    fn turning(x: [f64; 2]) -> (f64, f64) {
        (x[1], -x[0])
    }
}

mod flow_that_keeps_no_names {
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(x[0] * x[0] + x[1] * x[1]))]
    fn turning(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }

    #[vector_field(keeps = x[0] * x[0] + x[1] * x[1])]
    fn rotating(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }

    #[vector_field(keeps)]
    fn swinging(x: [f64; 2]) -> [f64; 2] {
        [x[1], -x[0]]
    }
}

mod flow_with_structure {
    use geoint_runtime::prelude::*;

    #[vector_field(structure = so3)]
    fn free_body(x: [f64; 3]) -> [f64; 3] {
        [x[1] * x[2], -x[2] * x[0], 0.0]
    }
}

mod flow_without_coordinates {
    use geoint_runtime::prelude::*;

    #[vector_field]
    fn pendulum(q: f64, p: f64) -> [f64; 2] {
        [p, -q.sin()]
    }
}

mod flow_wrong_but {
    use geoint_runtime::prelude::*;

    #[vector_field(keeps(square = x[0] * x[0] + x[1] * x[1], but = [-x[0], x[1]]))]
    fn decay(x: [f64; 2]) -> [f64; 2] {
        [x[1] - x[0], -x[0] - x[1]]
    }
}

fn main() {}
