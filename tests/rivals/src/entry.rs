//! A way to the end of a problem, at several efforts.

/// Whose it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whose {
    /// Generated code and a method of the runtime.
    Ours,
    /// Another crate.
    Rival,
    /// Rust written by hand for this problem and method.
    Hand,
}

/// A method on a problem.
pub struct Entry {
    /// Whose it is.
    pub whose: Whose,
    /// Curves of one family are drawn as one.
    pub family: &'static str,
    /// What it is called.
    pub name: String,
    /// From the least to the largest: numbers of steps, or tolerances.
    pub efforts: Vec<f64>,
    /// The states at the times of the problem, one after the other, or nothing where the method refuses.
    pub run: Run,
}

/// From an effort to states.
pub type Run = Box<dyn Fn(f64) -> Option<Vec<f64>>>;

impl Entry {
    /// An entry with a number of steps for an effort: an eighth of `first` and on, by factors of √2. At `first` it is about stable.
    pub fn steps(
        whose: Whose,
        family: &'static str,
        name: impl Into<String>,
        first: u64,
        run: impl Fn(u64) -> Option<Vec<f64>> + 'static,
    ) -> Self {
        let efforts = (-6..32).map(|k| (first as f64 * 2_f64.powf(0.5 * f64::from(k))).ceil()).collect();
        Entry { whose, family, name: name.into(), efforts, run: Box::new(move |n| run(n as u64)) }
    }

    /// An entry with a tolerance for an effort, from 10⁻² on by factors of √10.
    pub fn tolerances(
        whose: Whose,
        family: &'static str,
        name: impl Into<String>,
        run: impl Fn(f64) -> Option<Vec<f64>> + 'static,
    ) -> Self {
        let efforts = (4..32).map(|k| 10_f64.powf(-0.5 * f64::from(k))).collect();
        Entry { whose, family, name: name.into(), efforts, run: Box::new(run) }
    }
}

/// What is measured of an entry at an effort.
#[derive(Clone, Debug)]
pub struct Point {
    /// Steps or tolerance.
    pub effort: f64,
    /// The error, relative.
    pub error: f64,
    /// How long runs took, round by round.
    pub seconds: Vec<f64>,
}

impl Point {
    /// The shortest run.
    pub fn least(&self) -> f64 {
        self.seconds.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The run in the middle.
    pub fn median(&self) -> f64 {
        median(self.seconds.clone())
    }
}

/// The number in the middle; NaN of none.
pub fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(f64::NAN)
}
