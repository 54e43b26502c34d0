//! The functions that only steps use.

/// What divided differences and flows are made of, as a pattern: no energy is written with these functions. One list, so that matches name each
/// function that they are about, and stay exhaustive.
macro_rules! of_steps {
    () => {
        $crate::ir::Function::RecipAbove
            | $crate::ir::Function::Scaled
            | $crate::ir::Function::Root
            | $crate::ir::Function::Sinc
            | $crate::ir::Function::SincDerivative
            | $crate::ir::Function::Sinhc
            | $crate::ir::Function::SinhcDerivative
            | $crate::ir::Function::Arc
            | $crate::ir::Function::ArcDerivative
            | $crate::ir::Function::ExpSlope
            | $crate::ir::Function::ExpSlopeDerivative
            | $crate::ir::Function::Exp2Slope
            | $crate::ir::Function::LnSlope
            | $crate::ir::Function::LnSlopeDerivative
            | $crate::ir::Function::TanhSlope
            | $crate::ir::Function::TanhSlopeDerivative
            | $crate::ir::Function::PowfSlope
            | $crate::ir::Function::PowfSlopeDerivative
            | $crate::ir::Function::AbsSlope
            | $crate::ir::Function::AbsSlopeDerivative
            | $crate::ir::Function::Phi1
            | $crate::ir::Function::Phi1Derivative
            | $crate::ir::Function::StumpffC0
            | $crate::ir::Function::StumpffC1
            | $crate::ir::Function::StumpffC1Derivative
            | $crate::ir::Function::DecayMean
            | $crate::ir::Function::AtMost
            | $crate::ir::Function::Rest
            | $crate::ir::Function::Grown
            | $crate::ir::Function::SineAt
            | $crate::ir::Function::SineSlope
            | $crate::ir::Function::CosineAt
            | $crate::ir::Function::CosineSlope
            | $crate::ir::Function::FlowMatrix
            | $crate::ir::Function::FlowChange
            | $crate::ir::Function::Spread
            | $crate::ir::Function::Swept
            | $crate::ir::Function::KeplerF
            | $crate::ir::Function::KeplerG
            | $crate::ir::Function::KeplerFRate
            | $crate::ir::Function::KeplerGRate
    };
}
pub(crate) use of_steps;
