#pragma once

#include "Distortion/Distortion.h"

// What the tests of distortions share.
namespace shapetest
{

constexpr shape::Distortion AllMeasures[] = { shape::Distortion::SymmetricDirichlet,
  shape::Distortion::ExponentialSymmetricDirichlet, shape::Distortion::AMIPS,
  shape::Distortion::ConformalAMIPS, shape::Distortion::Hencky, shape::Distortion::ARAP };

} // namespace shapetest
