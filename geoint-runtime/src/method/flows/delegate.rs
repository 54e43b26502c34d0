//! Methods whose steps are those of another method. Macros, because an implementation for all methods with an inner method would overlap with others.

/// Implements the steps of a method by the steps of an inner method: `steps_of!(Inner, |prepared, memory| (part, own))`. `part` and `own` are the coefficients and
/// the memory of the inner method within those of the method. The short form passes the whole memory.
macro_rules! steps_of {
    ($inner:ty, |$prepared:ident| $part:expr) => {
        $crate::method::flows::steps_of!($inner, |$prepared, memory| ($part, memory));
    };
    ($inner:ty, |$prepared:ident, $memory:ident| ($part:expr, $own:expr)) => {
        #[inline(always)]
        fn step<Sums: Summation<S::Phase>, Watching: Probe<S, R>>(
            $prepared: &Self::Prepared,
            $memory: &mut Self::Memory,
            step: Step<'_, S, R, Sums, Watching>,
        ) -> Result<(), Failure> {
            <$inner as Method<S, R>>::step($part, $own, step)
        }

        #[inline(always)]
        fn advance<Sums: Summation<S::Phase>>(
            $prepared: &Self::Prepared,
            $memory: &mut Self::Memory,
            system: &S,
            clock: &Clock<R>,
            steps: u64,
            x: &mut Point<S::Phase, Sums, S::Action>,
        ) -> Result<(), Failure> {
            <$inner as Method<S, R>>::advance($part, $own, system, clock, steps, x)
        }
    };
}

/// Implements a method by an inner method, for systems with the given property, a trait with a `Proof`. The closure returns the inner method.
///
/// Limit: the inner method must use the defaults of `enter`, `leave`, `way_back`, `is_in_range`, `estimated` and `COMPOSES_TO`, which are not forwarded.
macro_rules! delegate {
    ([$($generics:tt)*] $method:ty, [$($property:tt)*], $inner:ty, |$this:ident| $inner_method:expr) => {
        impl<$($generics)* S: $($property)*, R: Real> Method<S, R> for $method
        where
            $inner: Method<S, R>,
        {
            type Proof = <S as $($property)*>::Proof;
            type Prepared = <$inner as Method<S, R>>::Prepared;
            type Memory = <$inner as Method<S, R>>::Memory;
            const HANDLING: $crate::method::Handling = <$inner as Method<S, R>>::HANDLING;

            fn claims(&self) -> Claims {
                let $this = self;
                Method::<S, R>::claims(&$inner_method)
            }
            fn name(&self) -> Name {
                let $this = self;
                Method::<S, R>::name(&$inner_method)
            }

            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                let $this = self;
                Method::prepare(&$inner_method, system, h)
            }
            #[inline(always)]
            fn shows_domain(prepared: &Self::Prepared) -> bool {
                <$inner as Method<S, R>>::shows_domain(prepared)
            }
            fn memory(z: &S::Phase) -> Self::Memory {
                <$inner as Method<S, R>>::memory(z)
            }
            $crate::method::flows::steps_of!($inner, |prepared| prepared);
        }
    };
}
pub(in crate::method) use {delegate, steps_of};
