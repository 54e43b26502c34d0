//! Unit quaternions of nalgebra: attitudes, and what is computed of them.

use super::Lowering;
use super::value::Value;
use crate::ir::{Id, Number};
use syn::ExprMethodCall;

pub(super) const OPERATORS: &str =
    "an attitude `r` turns vectors, `r * v`, is followed by another one, `r * s`, and relative to it, `r / s`";

pub(super) const FIELDS: &str =
    "an attitude has the numbers `i`, `j`, `k`, `w`, and all of them as the vector `coords`";

const METHODS: &str = "an attitude has `inverse`, `transform_vector`, `inverse_transform_vector`, `rotation_to`, `dot`, `imag`, \
                       `scalar`, the numbers `i`, `j`, `k`, `w`, and turns vectors, `r * v`";

impl Lowering {
    /// `r.i`, `r.coords`.
    pub(super) fn field_of_quaternion(&mut self, name: &proc_macro2::Ident, ids: &[Id; 4]) -> Option<Value> {
        if name == "coords" {
            return Some(Value::Vector(ids.to_vec()));
        }
        let i = ["i", "j", "k", "w"].iter().position(|number| name == number)?;
        Some(Value::Real(ids[i]))
    }

    pub(super) fn method_of_quaternion(
        &mut self,
        call: &ExprMethodCall,
        name: &str,
        r: &[Id; 4],
        arguments: &[Value],
    ) -> Value {
        match (name, arguments) {
            ("inverse" | "conjugate", []) => Value::Quaternion(self.conjugate(r)),
            ("transform_vector", [Value::Vector(v)]) if v.len() == 3 => {
                Value::Vector(self.rotated(r, &[v[0], v[1], v[2]]).to_vec())
            }
            ("inverse_transform_vector", [Value::Vector(v)]) if v.len() == 3 => {
                let inverse = self.conjugate(r);
                Value::Vector(self.rotated(&inverse, &[v[0], v[1], v[2]]).to_vec())
            }
            ("rotation_to", [Value::Quaternion(other)]) => {
                let inverse = self.conjugate(r);
                Value::Quaternion(self.product(other, &inverse))
            }
            ("dot", [Value::Quaternion(other)]) => Value::Real(self.graph.dot(r, other)),
            ("imag" | "vector", []) => Value::Vector(r[..3].to_vec()),
            ("scalar", []) => Value::Real(r[3]),
            _ => self.refuse(&call.method, METHODS),
        }
    }

    /// The inverse of a unit quaternion.
    pub(super) fn conjugate(&mut self, [i, j, k, w]: &[Id; 4]) -> [Id; 4] {
        let [i, j, k] = [i, j, k].map(|x| self.graph.neg(*x));
        [i, j, k, *w]
    }

    /// a⊗b.
    pub(super) fn product(&mut self, a: &[Id; 4], b: &[Id; 4]) -> [Id; 4] {
        let ([u, w], [v, z]) = ([&a[..3], &a[3..]], [&b[..3], &b[3..]]);
        let graph = &mut self.graph;
        let mut entry = |terms: [(Id, Id, bool); 4]| {
            let terms = terms.map(|(a, b, negative)| {
                let product = graph.mul(a, b);
                if negative { graph.neg(product) } else { product }
            });
            graph.sum(&terms)
        };
        let mut imaginary = |n: usize| {
            let (j, k) = ((n + 1) % 3, (n + 2) % 3);
            entry([(w[0], v[n], false), (u[n], z[0], false), (u[j], v[k], false), (u[k], v[j], true)])
        };
        let [x, y, z_] = [0, 1, 2].map(&mut imaginary);
        let real = entry([(w[0], z[0], false), (u[0], v[0], true), (u[1], v[1], true), (u[2], v[2], true)]);
        [x, y, z_, real]
    }

    /// v + 2w u×v + 2 u×(u×v), as nalgebra computes it; the vector part is u.
    pub(super) fn rotated(&mut self, [i, j, k, w]: &[Id; 4], v: &[Id; 3]) -> [Id; 3] {
        let u = [*i, *j, *k];
        let twice = self.cross_product(&u, v).map(|x| self.graph.scale(Number::integer(2), x));
        let second = self.cross_product(&u, &twice);
        let graph = &mut self.graph;
        core::array::from_fn(|n| {
            let first = graph.mul(*w, twice[n]);
            graph.sum(&[v[n], first, second[n]])
        })
    }

    fn cross_product(&mut self, a: &[Id; 3], b: &[Id; 3]) -> [Id; 3] {
        let graph = &mut self.graph;
        core::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let (first, second) = (graph.mul(a[j], b[k]), graph.mul(a[k], b[j]));
            graph.sub(first, second)
        })
    }
}
