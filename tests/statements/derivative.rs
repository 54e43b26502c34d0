//! The derivative of a map of contact phase space, by dual numbers: factor of the contact form η = ds − p dq, defect of the form, volume.

use geoint_runtime::Method;
use geoint_tests::bare::Bare;
use geoint_tests::scalars::Dual;
use geoint_tests::scene::{Scene, contact_defect};

/// A map and its derivative: column j belongs to coordinate j of the start.
pub(crate) struct Derivative {
    pub(crate) before: Vec<f64>,
    pub(crate) after: Vec<f64>,
    columns: Vec<Vec<f64>>,
}

impl Derivative {
    /// Differentiates a map of (q, p, s) by dual numbers.
    pub(crate) fn of(before: Vec<f64>, map: impl Fn(&[Dual]) -> Vec<Dual>) -> Self {
        let mut derivative = Derivative { before, after: vec![], columns: vec![] };
        for j in 0..derivative.before.len() {
            let mut x: Vec<Dual> = derivative.before.iter().map(|x| Dual::from(*x)).collect();
            x[j] = Dual::variable(derivative.before[j]);
            let end = map(&x);
            derivative.after = end.iter().map(|x| x.value()).collect();
            derivative.columns.push(end.iter().map(|x| x.derivative()).collect());
        }
        derivative
    }

    /// Differentiates one step of a method.
    pub(crate) fn of_step<P: Scene, M: Method<P::Over<Dual>, Dual>>(method: M, h: f64) -> Self {
        let (start, x) = P::start();
        Self::of(x, |x| {
            let mut sim = Bare::<P, M, Dual>::new(method, h.into(), start.into(), x);
            sim.advance(1).expect("a step");
            sim.state()
        })
    }

    /// Returns λ, the value of η after the map on the image of ∂/∂s.
    pub(crate) fn factor(&self) -> f64 {
        let n = self.before.len() / 2;
        let image = &self.columns[2 * n];
        image[2 * n] - (0..n).map(|i| self.after[n + i] * image[i]).sum::<f64>()
    }

    /// Returns by how much η after the map differs from λη.
    pub(crate) fn defect(&self) -> f64 {
        contact_defect(&self.columns, &self.before, &self.after)
    }

    /// Returns the determinant of the derivative, by Gauss' elimination.
    pub(crate) fn volume(&self) -> f64 {
        let (mut rows, mut volume) = (self.columns.clone(), 1.0);
        for k in 0..rows.len() {
            let pivot = (k..rows.len()).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs())).unwrap_or(k);
            if pivot != k {
                rows.swap(k, pivot);
                volume = -volume;
            }
            let (above, below) = rows.split_at_mut(k + 1);
            let row = &above[k];
            volume *= row[k];
            for other in below {
                let ratio = other[k] / row[k];
                other.iter_mut().zip(row).for_each(|(x, y)| *x -= ratio * y);
            }
        }
        volume
    }

    /// Returns the relative distance of the volume from λⁿ⁺¹.
    pub(crate) fn excess(&self) -> f64 {
        (self.volume() / self.factor().powi(self.before.len() as i32 / 2 + 1) - 1.0).abs()
    }
}
