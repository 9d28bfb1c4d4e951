#include "Correspondence/Functional/Private/LandmarkKernels.h"

#include "Spectrum/SpectralSignatures.h"

#include <algorithm>

namespace shape
{

Eigen::MatrixXd ComputeLandmarkKernels(
  const LaplaceEigenpairs& spectrum, const Landmarks& landmarks, int which, int energies)
{
  constexpr std::size_t maximum = 12;
  const std::size_t used = std::min(landmarks.size(), maximum);
  Eigen::MatrixXd kernels(spectrum.Masses.size(), energies * used);
  for (std::size_t i = 0; i < used; ++i)
  {
    kernels.middleCols(energies * i, energies) =
      ComputeWaveKernelFrom(spectrum, landmarks[i * landmarks.size() / used][which], energies);
  }
  return kernels;
}

} // namespace shape
