//! Fields with first integrals. Each is written as S(x) ∇H if S is known, and as a field with its integrals. Parameters are in the bodies, so both
//! forms have only the names of coordinates in common.

use geoint_runtime::prelude::*;

/// Predators and prey.
#[hamiltonian(structure = [[0.0, -x[0] * x[1]], [x[0] * x[1], 0.0]])]
pub(super) fn lotka_volterra(x: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()
}

#[vector_field(keeps(wealth = b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()))]
pub(super) fn predators(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]
}

/// A free body in angular velocities.
#[hamiltonian(structure = |i, j| {
    let k = 3 - i - j;
    (if j == i + 1 { -1.0 } else { 1.0 }) * inertia[k] * x[k] / (inertia[i] * inertia[j])
})]
pub(super) fn free_body(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (0..3).map(|i| inertia[i] * x[i] * x[i] / 2.0).sum()
}

#[vector_field(keeps(
    energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
    momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
))]
pub(super) fn euler_top(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// The same with a function of Lyapunov alone, of degree 4, for the permanent rotation with angular velocity `w`.
#[vector_field(keeps(lyapunov = {
    let [first, second] = [
        a * (c - a) * (x[0] * x[0] - w * w) + b * (c - b) * x[1] * x[1],
        b * (b - a) * x[1] * x[1] + c * (c - a) * x[2] * x[2],
    ];
    first * first + second
}))]
pub(super) fn lyapunov_top(x: [f64; 3], a: f64, b: f64, c: f64, w: f64) -> [f64; 3] {
    [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
}

/// The core of Lorenz 1984: no Poisson structure.
#[hamiltonian(structure = |i, j| if i == 0 { -x[j] } else { -b * x[0] })]
pub(super) fn lorenz_core(x: [f64; 3], b: f64) -> f64 {
    (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0
}

#[vector_field(keeps(half_square = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0))]
pub(super) fn lorenz_field(x: [f64; 3], b: f64) -> [f64; 3] {
    [-x[1] * x[1] - x[2] * x[2], x[0] * x[1] - b * x[0] * x[2], b * x[0] * x[1] + x[0] * x[2]]
}

/// Volterra's lattice, open.
#[hamiltonian(structure = |i, j| if j == i + 1 { x[i] * x[j] } else { 0.0 })]
pub(super) fn volterra(x: [f64; 5]) -> f64 {
    x.iter().sum()
}

#[vector_field(keeps(sum = x.iter().sum::<f64>(), odd = x[0].ln() + x[2].ln() + x[4].ln(), third = {
    let squares: f64 = x.iter().map(|x| x * x).sum();
    squares / 2.0 + (0..4).map(|i| x[i] * x[i + 1]).sum::<f64>()
}))]
pub(super) fn volterra_field(x: [f64; 5]) -> [f64; 5] {
    [x[0] * x[1], x[1] * (x[2] - x[0]), x[2] * (x[3] - x[1]), x[3] * (x[4] - x[2]), -x[4] * x[3]]
}

/// Three species in a ring.
#[hamiltonian(structure = |i, j| if j == i + 1 { x[i] * x[j] } else { -x[i] * x[j] })]
pub(super) fn ring(x: [f64; 3]) -> f64 {
    x.iter().sum()
}

#[vector_field(keeps(sum = x[0] + x[1] + x[2], product = x[0] * x[1] * x[2]))]
pub(super) fn ring_field(x: [f64; 3]) -> [f64; 3] {
    [x[0] * (x[1] - x[2]), x[1] * (x[2] - x[0]), x[2] * (x[0] - x[1])]
}

/// Susceptible, infected, recovered.
#[vector_field(keeps(people = x[0] + x[1] + x[2], spread = x[0].ln() + k / l * x[2]))]
pub(super) fn epidemic(x: [f64; 3], k: f64, l: f64) -> [f64; 3] {
    [-k * x[0] * x[1], k * x[0] * x[1] - l * x[1], l * x[1]]
}

/// x' = c ∇Σ × ∇I with the sum Σ of all people, which is linear, so that steps are c(m) ∇̄Σ × ∇̄I.
#[hamiltonian(structure = {
    let c = l * x[0] * x[1];
    [[0.0, c, -c], [-c, 0.0, c], [c, -c, 0.0]]
})]
pub(super) fn epidemic_product(x: [f64; 3], k: f64, l: f64) -> f64 {
    x[0].ln() + k / l * x[2]
}

/// The ring in the same way: ∇Σ × ∇Π.
#[hamiltonian(structure = nambu(x[0] + x[1] + x[2]))]
pub(super) fn ring_product(x: [f64; 3]) -> f64 {
    x[0] * x[1] * x[2]
}

/// A heavy top with its centre of mass at r.
#[hamiltonian(structure = se3)]
pub(super) fn heavy_top(x: [f64; 6], inertia: [f64; 3], r: [f64; 3]) -> f64 {
    let [m1, m2, m3, g1, g2, g3] = x;
    (m1 * m1 / inertia[0] + m2 * m2 / inertia[1] + m3 * m3 / inertia[2]) / 2.0 + r[0] * g1 + r[1] * g2 + r[2] * g3
}

/// Lagrange's.
#[vector_field(keeps(
    energy = (x[0] * x[0] + x[1] * x[1]) / (2.0 * a) + x[2] * x[2] / (2.0 * c) + l * x[5],
    length = (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2.0,
    vertical = x[0] * x[3] + x[1] * x[4] + x[2] * x[5],
    spin = x[2],
))]
pub(super) fn lagrange_top(x: [f64; 6], a: f64, c: f64, l: f64) -> [f64; 6] {
    let [m1, m2, m3, g1, g2, g3] = x;
    let [u, v, w] = [m1 / a, m2 / a, m3 / c];
    [
        m2 * w - m3 * v + g2 * l,
        m3 * u - m1 * w - g1 * l,
        m1 * v - m2 * u,
        g2 * w - g3 * v,
        g3 * u - g1 * w,
        g1 * v - g2 * u,
    ]
}

/// Kovalevskaya's, with her integral.
#[vector_field(keeps(
    energy = (x[0] * x[0] + x[1] * x[1]) / 4.0 + x[2] * x[2] / 2.0 + x[3],
    length = (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2.0,
    vertical = x[0] * x[3] + x[1] * x[4] + x[2] * x[5],
    kovalevskaya = ((x[0] * x[0] - x[1] * x[1]) / 4.0 - x[3]).powi(2) + (x[0] * x[1] / 2.0 - x[4]).powi(2),
))]
pub(super) fn kovalevskaya_top(x: [f64; 6]) -> [f64; 6] {
    let [m1, m2, m3, g1, g2, g3] = x;
    let [u, v, w] = [m1 / 2.0, m2 / 2.0, m3];
    [m2 * w - m3 * v, m3 * u - m1 * w + g3, m1 * v - m2 * u - g2, g2 * w - g3 * v, g3 * u - g1 * w, g1 * v - g2 * u]
}

/// Goryachev's and Chaplygin's, without their integral, which is one for m·γ = 0 alone.
#[vector_field(keeps(
    energy = (x[0] * x[0] + x[1] * x[1]) / 8.0 + x[2] * x[2] / 2.0 + x[3],
    length = (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2.0,
    vertical = x[0] * x[3] + x[1] * x[4] + x[2] * x[5],
))]
pub(super) fn goryachev_top(x: [f64; 6]) -> [f64; 6] {
    let [m1, m2, m3, g1, g2, g3] = x;
    let [u, v, w] = [m1 / 4.0, m2 / 4.0, m3];
    [m2 * w - m3 * v, m3 * u - m1 * w + g3, m1 * v - m2 * u - g2, g2 * w - g3 * v, g3 * u - g1 * w, g1 * v - g2 * u]
}

/// Toda's lattice in Flaschka's variables b₁…b₄, a₁…a₃.
#[hamiltonian(structure = |i, j| if j == i + 4 { x[j] } else if i > 0 && i < 4 && j == i + 3 { -x[j] } else { 0.0 })]
pub(super) fn toda(x: [f64; 7]) -> f64 {
    (0..4).map(|i| x[i] * x[i] / 2.0).sum::<f64>() + (4..7).map(|i| x[i] * x[i]).sum::<f64>()
}

#[vector_field(keeps(
    energy = (0..4).map(|i| x[i] * x[i] / 2.0).sum::<f64>() + (4..7).map(|i| x[i] * x[i]).sum::<f64>(),
    sum = x[0] + x[1] + x[2] + x[3],
    cubes = (0..4).map(|i| x[i].powi(3) / 3.0).sum::<f64>() + (0..3).map(|i| x[4 + i].powi(2) * (x[i] + x[i + 1])).sum::<f64>(),
))]
pub(super) fn toda_field(x: [f64; 7]) -> [f64; 7] {
    let [b1, b2, b3, b4, a1, a2, a3] = x;
    [
        2.0 * a1 * a1,
        2.0 * (a2 * a2 - a1 * a1),
        2.0 * (a3 * a3 - a2 * a2),
        -2.0 * a3 * a3,
        a1 * (b2 - b1),
        a2 * (b3 - b2),
        a3 * (b4 - b3),
    ]
}

/// Four vortices; x₁…x₄, y₁…y₄.
#[hamiltonian(structure = |i, j| if j == i + 4 { 1.0 / gamma[i] } else { 0.0 })]
pub(super) fn vortices(x: [f64; 8], gamma: [f64; 4]) -> f64 {
    let mut energy = 0.0;
    for i in 0..4 {
        for j in 0..i {
            let (dx, dy) = (x[i] - x[j], x[4 + i] - x[4 + j]);
            energy -= gamma[i] * gamma[j] * (dx * dx + dy * dy).ln();
        }
    }
    energy
}

#[vector_field(keeps(
    energy = {
        let mut energy = 0.0;
        for i in 0..4 {
            for j in 0..i {
                let (dx, dy) = (x[i] - x[j], x[4 + i] - x[4 + j]);
                energy -= gamma[i] * gamma[j] * (dx * dx + dy * dy).ln();
            }
        }
        energy
    },
    across = (0..4).map(|i| gamma[i] * x[i]).sum::<f64>(),
    along = (0..4).map(|i| gamma[i] * x[4 + i]).sum::<f64>(),
    impulse = (0..4).map(|i| gamma[i] * (x[i] * x[i] + x[4 + i] * x[4 + i]) / 2.0).sum::<f64>(),
))]
pub(super) fn vortex_field(x: [f64; 8], gamma: [f64; 4]) -> [f64; 8] {
    let mut f = [0.0; 8];
    for i in 0..4 {
        for j in 0..4 {
            if i != j {
                let (dx, dy) = (x[i] - x[j], x[4 + i] - x[4 + j]);
                let square = dx * dx + dy * dy;
                f[i] -= 2.0 * gamma[j] * dy / square;
                f[4 + i] += 2.0 * gamma[j] * dx / square;
            }
        }
    }
    f
}

/// Ablowitz and Ladik, four sites in a ring; q₁…q₄, p₁…p₄.
#[hamiltonian(structure = |i, j| if j == i + 4 { 1.0 + x[i] * x[i] + x[j] * x[j] } else { 0.0 })]
pub(super) fn ablowitz_ladik(x: [f64; 8]) -> f64 {
    (0..4)
        .map(|i| {
            let next = (i + 1) % 4;
            (1.0 + x[i] * x[i] + x[4 + i] * x[4 + i]).ln() - x[i] * x[next] - x[4 + i] * x[4 + next]
        })
        .sum()
}

#[vector_field(keeps(
    energy = (0..4).map(|i| {
        let next = (i + 1) % 4;
        (1.0 + x[i] * x[i] + x[4 + i] * x[4 + i]).ln() - x[i] * x[next] - x[4 + i] * x[4 + next]
    }).sum::<f64>(),
    norm = (0..4).map(|i| (1.0 + x[i] * x[i] + x[4 + i] * x[4 + i]).ln()).sum::<f64>(),
))]
pub(super) fn ablowitz_field(x: [f64; 8]) -> [f64; 8] {
    let mut f = [0.0; 8];
    for i in 0..4 {
        let (next, last) = ((i + 1) % 4, (i + 3) % 4);
        let w = 1.0 + x[i] * x[i] + x[4 + i] * x[4 + i];
        f[i] = -w * (x[4 + next] + x[4 + last]) + 2.0 * x[4 + i];
        f[4 + i] = w * (x[next] + x[last]) - 2.0 * x[i];
    }
    f
}

/// A charge in the magnetic field (0, 0, 1 + 0.3 x y).
#[hamiltonian(structure = |i, j| if j == i + 3 { 1.0 } else if i == 3 && j == 4 { 1.0 + 0.3 * x[0] * x[1] } else { 0.0 })]
pub(super) fn charge(x: [f64; 6]) -> f64 {
    (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2.0 + x[0] * x[0] / 2.0 + x[1].powi(4) / 4.0 + x[2] * x[2] / 5.0
}

#[vector_field(keeps(
    energy = (x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2.0 + x[0] * x[0] / 2.0 + x[1].powi(4) / 4.0 + x[2] * x[2] / 5.0
))]
pub(super) fn charge_field(x: [f64; 6]) -> [f64; 6] {
    let b = 1.0 + 0.3 * x[0] * x[1];
    [x[3], x[4], x[5], -x[0] + x[4] * b, -x[1].powi(3) - x[3] * b, -0.4 * x[2]]
}

/// Three waves; real parts, imaginary parts.
#[hamiltonian(structure = canonical)]
pub(super) fn three_waves(x: [f64; 6]) -> f64 {
    let [q1, q2, q3, p1, p2, p3] = x;
    -((q1 * q2 - p1 * p2) * q3 + (q1 * p2 + p1 * q2) * p3)
}

#[vector_field(keeps(
    energy = -((x[0] * x[1] - x[3] * x[4]) * x[2] + (x[0] * x[4] + x[3] * x[1]) * x[5]),
    first = (x[0] * x[0] + x[3] * x[3] + x[2] * x[2] + x[5] * x[5]) / 2.0,
    second = (x[1] * x[1] + x[4] * x[4] + x[2] * x[2] + x[5] * x[5]) / 2.0,
))]
pub(super) fn wave_field(x: [f64; 6]) -> [f64; 6] {
    let [q1, q2, q3, p1, p2, p3] = x;
    [
        p2 * q3 - q2 * p3,
        p1 * q3 - q1 * p3,
        -(q1 * p2 + p1 * q2),
        q2 * q3 + p2 * p3,
        q1 * q3 + p1 * p3,
        q1 * q2 - p1 * p2,
    ]
}

/// Hénon and Heiles.
#[hamiltonian(structure = canonical)]
pub(super) fn henon_heiles(x: [f64; 4]) -> f64 {
    (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]) / 2.0 + x[0] * x[0] * x[1] - x[1].powi(3) / 3.0
}
