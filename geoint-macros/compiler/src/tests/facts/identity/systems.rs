//! Fields with integrals and skew matrices.

use super::{arrays, coordinates};
use crate::ir::{Graph, Id, Symbol};
use proc_macro2::TokenStream;
use quote::quote;

/// A field f with its integrals, and a skew matrix S with f = S∇I for the first integral I.
pub(super) struct Field {
    pub(super) name: &'static str,
    n: usize,
    setup: TokenStream,
    field: TokenStream,
    /// Functions, and whether the field keeps each.
    pub(super) integrals: Vec<(TokenStream, bool)>,
    pub(super) matrix: Option<TokenStream>,
    /// Indices of the integrals that are Casimirs of the matrix.
    pub(super) casimirs: Vec<usize>,
}

/// The field, its integrals, and the rows of the matrix in one graph.
pub(super) struct Lowered {
    pub(super) graph: Graph,
    pub(super) x: Vec<Symbol>,
    pub(super) field: Vec<Id>,
    pub(super) integrals: Vec<Id>,
    pub(super) matrix: Vec<Vec<Id>>,
}

impl Field {
    pub(super) fn lowered(&self) -> Lowered {
        self.with(&self.integrals.iter().map(|(integral, _)| integral.clone()).collect::<Vec<_>>())
    }

    /// The field with other integrals.
    pub(super) fn with(&self, integrals: &[TokenStream]) -> Lowered {
        let all = quote!([#(#integrals),*]);
        let zeros = vec![quote!(0.0); self.n * self.n];
        let matrix = self.matrix.clone().unwrap_or(quote!([#(#zeros),*]));
        let (graph, mut found) = arrays(self.n, &self.setup, &[&self.field, &all, &matrix]);
        let matrix = found.remove(2).chunks(self.n).map(<[Id]>::to_vec).collect();
        let integrals = found.remove(1);
        Lowered { graph, x: coordinates(self.n), field: found.remove(0), integrals, matrix }
    }
}

fn top(name: &'static str, inertia: [f64; 3], r: [f64; 3], last: (TokenStream, bool)) -> Field {
    let ([a, b, c], [r1, r2, r3]) = (inertia, r);
    Field {
        name,
        n: 6,
        setup: quote! {
            let [m1, m2, m3, g1, g2, g3] = x;
            let (w1, w2, w3) = (m1 / #a, m2 / #b, m3 / #c);
        },
        field: quote! {[
            m2 * w3 - m3 * w2 + g2 * #r3 - g3 * #r2,
            m3 * w1 - m1 * w3 + g3 * #r1 - g1 * #r3,
            m1 * w2 - m2 * w1 + g1 * #r2 - g2 * #r1,
            g2 * w3 - g3 * w2, g3 * w1 - g1 * w3, g1 * w2 - g2 * w1
        ]},
        integrals: vec![
            (quote!((m1 * w1 + m2 * w2 + m3 * w3) / 2.0 + #r1 * g1 + #r2 * g2 + #r3 * g3), true),
            (quote!((g1 * g1 + g2 * g2 + g3 * g3) / 2.0), true),
            (quote!(m1 * g1 + m2 * g2 + m3 * g3), true),
            last,
        ],
        matrix: Some(quote! {[
            0.0, -m3, m2, 0.0, -g3, g2, m3, 0.0, -m1, g3, 0.0, -g1, -m2, m1, 0.0, -g2, g1, 0.0,
            0.0, -g3, g2, 0.0, 0.0, 0.0, g3, 0.0, -g1, 0.0, 0.0, 0.0, -g2, g1, 0.0, 0.0, 0.0, 0.0
        ]}),
        casimirs: vec![1, 2],
    }
}

/// Four point vortices. The loops sum the field and the energy over pairs.
fn vortices() -> Field {
    Field {
        name: "vortices",
        n: 8,
        setup: quote! {
            let g = [1.0, 2.0, -1.0, 3.0];
            let mut h = 0.0;
            let mut f = [0.0; 8];
            for i in 0..4 {
                for j in 0..4 {
                    if i != j {
                        let (dx, dy) = (x[i] - x[j], x[4 + i] - x[4 + j]);
                        let r = dx * dx + dy * dy;
                        f[i] -= 2.0 * g[j] * dy / r;
                        f[4 + i] += 2.0 * g[j] * dx / r;
                        if j < i { h -= g[i] * g[j] * r.ln(); }
                    }
                }
            }
        },
        field: quote!([f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]]),
        integrals: vec![
            (quote!(h), true),
            (quote!(g[0] * x[0] + g[1] * x[1] + g[2] * x[2] + g[3] * x[3]), true),
            (quote!(g[0] * x[4] + g[1] * x[5] + g[2] * x[6] + g[3] * x[7]), true),
            (
                quote!(
                    (g[0] * (x[0] * x[0] + x[4] * x[4])
                        + g[1] * (x[1] * x[1] + x[5] * x[5])
                        + g[2] * (x[2] * x[2] + x[6] * x[6])
                        + g[3] * (x[3] * x[3] + x[7] * x[7]))
                        / 2.0
                ),
                true,
            ),
        ],
        matrix: None,
        casimirs: vec![],
    }
}

pub(super) fn fields() -> Vec<Field> {
    vec![
        Field {
            name: "Lotka–Volterra",
            n: 2,
            setup: quote!(),
            field: quote!([x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]),
            integrals: vec![(quote!(b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()), true)],
            matrix: Some(quote!([0.0, -x[0] * x[1], x[0] * x[1], 0.0])),
            casimirs: vec![],
        },
        Field {
            name: "Euler top",
            n: 3,
            setup: quote!(let (u, v, w) = (x[0], x[1], x[2]);),
            field: quote!([(b - c) / a * v * w, (c - a) / b * w * u, (a - b) / c * u * v]),
            integrals: vec![
                (quote!((a * u * u + b * v * v + c * w * w) / 2.0), true),
                (quote!((a * a * u * u + b * b * v * v + c * c * w * w) / 2.0), true),
            ],
            matrix: Some(quote! {[
                0.0, -c * w / (a * b), b * v / (a * c),
                c * w / (a * b), 0.0, -a * u / (b * c),
                -b * v / (a * c), a * u / (b * c), 0.0
            ]}),
            casimirs: vec![1],
        },
        Field {
            name: "Lorenz core",
            n: 3,
            setup: quote!(),
            field: quote! {[
                -x[1] * x[1] - x[2] * x[2], x[0] * x[1] - b * x[0] * x[2], b * x[0] * x[1] + x[0] * x[2]
            ]},
            integrals: vec![(quote!((x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0), true)],
            matrix: Some(quote!([0.0, -x[1], -x[2], x[1], 0.0, -b * x[0], x[2], b * x[0], 0.0])),
            casimirs: vec![],
        },
        Field {
            name: "Volterra lattice",
            n: 5,
            setup: quote!(let [p, q, r, s, u] = x;),
            field: quote!([p * q, q * (r - p), r * (s - q), s * (u - r), -u * s]),
            integrals: vec![
                (quote!(p + q + r + s + u), true),
                (quote!(p.ln() + r.ln() + u.ln()), true),
                (quote!((p * p + q * q + r * r + s * s + u * u) / 2.0 + p * q + q * r + r * s + s * u), true),
            ],
            matrix: Some(quote! {[
                0.0, p * q, 0.0, 0.0, 0.0, -p * q, 0.0, q * r, 0.0, 0.0, 0.0, -q * r, 0.0, r * s, 0.0,
                0.0, 0.0, -r * s, 0.0, s * u, 0.0, 0.0, 0.0, -s * u, 0.0
            ]}),
            casimirs: vec![1],
        },
        Field {
            name: "ring",
            n: 3,
            setup: quote!(),
            field: quote!([x[0] * (x[1] - x[2]), x[1] * (x[2] - x[0]), x[2] * (x[0] - x[1])]),
            integrals: vec![(quote!(x[0] + x[1] + x[2]), true), (quote!(x[0] * x[1] * x[2]), true)],
            matrix: Some(quote! {[
                0.0, x[0] * x[1], -x[0] * x[2], -x[0] * x[1], 0.0, x[1] * x[2], x[0] * x[2], -x[1] * x[2], 0.0
            ]}),
            casimirs: vec![1],
        },
        Field {
            name: "epidemic",
            n: 3,
            setup: quote!(),
            field: quote!([-a * x[0] * x[1], a * x[0] * x[1] - b * x[1], b * x[1]]),
            integrals: vec![(quote!(x[0] + x[1] + x[2]), true), (quote!(x[0].ln() + a / b * x[2]), true)],
            matrix: None,
            casimirs: vec![],
        },
        top("Lagrange top", [2.0, 2.0, 1.0], [0.0, 0.0, 1.0], (quote!(m3), true)),
        top(
            "Kovalevskaya top",
            [2.0, 2.0, 1.0],
            [1.0, 0.0, 0.0],
            (quote!(((m1 * m1 - m2 * m2) / 4.0 - g1).powi(2) + (m1 * m2 / 2.0 - g2).powi(2)), true),
        ),
        top(
            "Goryachev top",
            [4.0, 4.0, 1.0],
            [1.0, 0.0, 0.0],
            (quote!(m3 * (m1 * m1 + m2 * m2) - 4.0 * m1 * g3), false),
        ),
        Field {
            name: "Toda",
            n: 7,
            setup: quote!(let [p, q, r, s, u, v, w] = x;),
            field: quote! {[
                2.0 * u * u, 2.0 * (v * v - u * u), 2.0 * (w * w - v * v), -2.0 * w * w,
                u * (q - p), v * (r - q), w * (s - r)
            ]},
            integrals: vec![
                (quote!((p * p + q * q + r * r + s * s) / 2.0 + u * u + v * v + w * w), true),
                (quote!(p + q + r + s), true),
                (
                    quote!(
                        (p.powi(3) + q.powi(3) + r.powi(3) + s.powi(3)) / 3.0
                            + u * u * (p + q)
                            + v * v * (q + r)
                            + w * w * (r + s)
                    ),
                    true,
                ),
            ],
            matrix: Some(quote! {[
                0.0, 0.0, 0.0, 0.0, u, 0.0, 0.0,
                0.0, 0.0, 0.0, 0.0, -u, v, 0.0,
                0.0, 0.0, 0.0, 0.0, 0.0, -v, w,
                0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -w,
                -u, u, 0.0, 0.0, 0.0, 0.0, 0.0,
                0.0, -v, v, 0.0, 0.0, 0.0, 0.0,
                0.0, 0.0, -w, w, 0.0, 0.0, 0.0
            ]}),
            casimirs: vec![1],
        },
        vortices(),
        Field {
            name: "Ablowitz–Ladik",
            n: 8,
            setup: quote! {
                let mut norm = 0.0;
                let mut next = 0.0;
                let mut f = [0.0; 8];
                for i in 0..4 {
                    let (up, down) = ((i + 1) % 4, (i + 3) % 4);
                    let w = 1.0 + x[i] * x[i] + x[4 + i] * x[4 + i];
                    f[i] = -w * (x[4 + up] + x[4 + down]) + 2.0 * x[4 + i];
                    f[4 + i] = w * (x[up] + x[down]) - 2.0 * x[i];
                    norm += w.ln();
                    next += x[i] * x[up] + x[4 + i] * x[4 + up];
                }
            },
            field: quote!([f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7]]),
            integrals: vec![(quote!(norm - next), true), (quote!(norm), true)],
            matrix: None,
            casimirs: vec![],
        },
        Field {
            name: "charge",
            n: 6,
            setup: quote!(let [q1, q2, q3, v1, v2, v3] = x; let m = 1.0 + 0.3 * q1 * q2;),
            field: quote!([v1, v2, v3, -q1 + v2 * m, -q2 * q2 * q2 - v1 * m, -0.4 * q3]),
            integrals: vec![(
                quote!((v1 * v1 + v2 * v2 + v3 * v3) / 2.0 + q1 * q1 / 2.0 + q2.powi(4) / 4.0 + q3 * q3 / 5.0),
                true,
            )],
            matrix: Some(quote! {[
                0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
                -1.0, 0.0, 0.0, 0.0, m, 0.0, 0.0, -1.0, 0.0, -m, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0
            ]}),
            casimirs: vec![],
        },
        Field {
            name: "three waves",
            n: 6,
            setup: quote!(let [q1, q2, q3, p1, p2, p3] = x;),
            field: quote! {[
                -(q2 * p3 - p2 * q3), -(q1 * p3 - p1 * q3), -(q1 * p2 + p1 * q2),
                q2 * q3 + p2 * p3, q1 * q3 + p1 * p3, q1 * q2 - p1 * p2
            ]},
            integrals: vec![
                (quote!(-((q1 * q2 - p1 * p2) * q3 + (q1 * p2 + p1 * q2) * p3)), true),
                (quote!((q1 * q1 + p1 * p1 + q3 * q3 + p3 * p3) / 2.0), true),
                (quote!((q2 * q2 + p2 * p2 + q3 * q3 + p3 * p3) / 2.0), true),
            ],
            matrix: Some(quote! {[
                0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
                -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0
            ]}),
            casimirs: vec![],
        },
    ]
}
