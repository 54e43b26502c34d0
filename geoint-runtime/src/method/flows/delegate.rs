//! Methods whose steps are those of another method.

/// Implements the steps of a method by the steps of an inner method. `part` and `own` are the coefficients and the memory of the inner method.
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

/// Implements a method by an inner method, for systems with the given property.
macro_rules! delegate {
    ([$($generics:tt)*] $method:ty, [$($property:tt)*], $inner:ty, |$this:ident| $table:expr) => {
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
                Method::<S, R>::claims(&$table)
            }
            fn name(&self) -> Name {
                let $this = self;
                Method::<S, R>::name(&$table)
            }

            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                let $this = self;
                Method::prepare(&$table, system, h)
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
