//! Unit quaternions of nalgebra: attitudes of rigid bodies and their operations.

use super::Lowering;
use super::value::Value;
use crate::ir::{Id, Number};
use proc_macro2::Ident;
use syn::ExprMethodCall;

pub(super) const OPERATORS: &str =
    "an attitude `r` turns vectors, `r * v`, is followed by another one, `r * s`, and relative to it, `r / s`";

pub(super) const FIELDS: &str =
    "an attitude has the numbers `i`, `j`, `k`, `w`, and all of them as the vector `coords`";

const METHODS: &str = "an attitude has `inverse`, `transform_vector`, `inverse_transform_vector`, `rotation_to`, `dot`, `imag`, \
                       `scalar`, the numbers `i`, `j`, `k`, `w`, and turns vectors, `r * v`";

/// Returns the field `i`, `j`, `k`, `w` or `coords` of a quaternion.
pub(super) fn field_of_quaternion(name: &Ident, r: &[Id; 4]) -> Option<Value> {
    if name == "coords" {
        return Some(Value::Vector(r.to_vec()));
    }
    ["i", "j", "k", "w"].iter().zip(r).find(|(number, _)| name == *number).map(|(_, id)| Value::Real(*id))
}

impl Lowering {
    pub(super) fn method_of_quaternion(&mut self, call: &ExprMethodCall, r: &[Id; 4], arguments: &[Value]) -> Value {
        match (call.method.to_string().as_str(), arguments) {
            ("inverse" | "conjugate", []) => Value::Quaternion(self.conjugate(r)),
            ("transform_vector", [Value::Vector(v)]) if v.len() == 3 => self.rotated(r, v),
            ("inverse_transform_vector", [Value::Vector(v)]) if v.len() == 3 => {
                let inverse = self.conjugate(r);
                self.rotated(&inverse, v)
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

    /// Returns the inverse of a unit quaternion.
    pub(super) fn conjugate(&mut self, [i, j, k, w]: &[Id; 4]) -> [Id; 4] {
        let [i, j, k] = [i, j, k].map(|x| self.graph.neg(*x));
        [i, j, k, *w]
    }

    /// Returns a⊗b.
    pub(super) fn product(&mut self, a: &[Id; 4], b: &[Id; 4]) -> [Id; 4] {
        let graph = &mut self.graph;
        let mut entry = |positive: &[(usize, usize)], negative: &[(usize, usize)]| {
            let mut terms: Vec<Id> = positive.iter().map(|(i, j)| graph.mul(a[*i], b[*j])).collect();
            for (i, j) in negative {
                let product = graph.mul(a[*i], b[*j]);
                terms.push(graph.neg(product));
            }
            graph.sum(&terms)
        };
        let [i, j, k] = [0, 1, 2].map(|n| {
            let (j, k) = ((n + 1) % 3, (n + 2) % 3);
            entry(&[(3, n), (n, 3), (j, k)], &[(k, j)])
        });
        [i, j, k, entry(&[(3, 3)], &[(0, 0), (1, 1), (2, 2)])]
    }

    /// Returns the rotated vector v + 2w u×v + 2 u×(u×v), where u is the vector part of the quaternion. Precondition: v has three components.
    ///
    /// The operations and their order are those of nalgebra.
    pub(super) fn rotated(&mut self, r: &[Id; 4], v: &[Id]) -> Value {
        let u = &r[..3];
        let twice = self.cross_product(u, v).map(|x| self.graph.scale(Number::integer(2), x));
        let second = self.cross_product(u, &twice);
        let graph = &mut self.graph;
        let component = |n: usize| {
            let first = graph.mul(r[3], twice[n]);
            graph.sum(&[v[n], first, second[n]])
        };
        Value::Vector((0..3).map(component).collect())
    }

    /// Returns a × b. Precondition: both vectors have three components.
    pub(super) fn cross_product(&mut self, a: &[Id], b: &[Id]) -> [Id; 3] {
        let graph = &mut self.graph;
        core::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let (first, second) = (graph.mul(a[j], b[k]), graph.mul(a[k], b[j]));
            graph.sub(first, second)
        })
    }
}
