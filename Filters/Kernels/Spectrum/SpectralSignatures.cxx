#include "Spectrum/SpectralSignatures.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace shape
{
namespace
{

/// Returns the number of zero eigenvalues. Throws InvalidInput if fewer than `others` are nonzero.
Eigen::Index ZeroCount(const LaplaceEigenpairs& spectrum, int others)
{
  const auto zeros = (spectrum.Eigenvalues.array() <= 0.0).count();
  if (spectrum.Eigenvalues.size() < zeros + others)
  {
    throw InvalidInput("NumberOfEigenpairs is " + std::to_string(spectrum.Eigenvalues.size()) +
      ", of which " + std::to_string(zeros) +
      " have constant eigenfunctions, one for each component; it must be at least " +
      std::to_string(zeros + others) +
      "; increase it, refine the surface if it has fewer points, or merge points at the same "
      "position with Clean");
  }
  return zeros;
}

double Between(double first, double last, int i, int count)
{
  return count > 1 ? first + (last - first) * i / (count - 1) : first;
}

/// Returns the weight of each eigenfunction at each time (k x times); each column sums to 1.
Eigen::MatrixXd HeatWeights(const LaplaceEigenpairs& spectrum, int times)
{
  const Eigen::Index zeros = ZeroCount(spectrum, 1);
  // exp(-4 ln 10) = 1e-4. So at the first time the last eigenfunction has decayed to 1e-4, and at
  // the last time the first one that is not constant.
  const double reach = 4.0 * std::log(10.0);
  const double first = std::log(reach / spectrum.Eigenvalues.tail(1)(0)),
               last = std::log(reach / spectrum.Eigenvalues(zeros));
  Eigen::MatrixXd weights(spectrum.Eigenvalues.size(), times);
  for (int i = 0; i < times; ++i)
  {
    weights.col(i) =
      (-std::exp(Between(first, last, i, times)) * spectrum.Eigenvalues).array().exp();
  }
  // Sun et al. 2009: divided by the heat trace.
  weights.array().rowwise() /= weights.colwise().sum().array().eval();
  return weights;
}

/// Returns the weight of each eigenfunction at each energy (k x energies).
Eigen::MatrixXd WaveWeights(const LaplaceEigenpairs& spectrum, int energies)
{
  const Eigen::Index zeros = ZeroCount(spectrum, 1);
  // Aubry et al. 2011, equation 6: a normal distribution of the logarithm of the energy.
  const Eigen::ArrayXd logarithms =
    spectrum.Eigenvalues.tail(spectrum.Eigenvalues.size() - zeros).array().log();
  const double first = logarithms(0), last = logarithms.tail(1)(0);
  const double deviation =
    // in case all are equal
    std::max(0.07 * (last - first), std::numeric_limits<double>::epsilon());
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(spectrum.Eigenvalues.size(), energies);
  for (int i = 0; i < energies; ++i)
  {
    const double energy = Between(first + 2.0 * deviation, last - 2.0 * deviation, i, energies);
    weights.col(i).tail(logarithms.size()) =
      (-(logarithms - energy).square() / (2.0 * deviation * deviation)).exp();
  }
  weights.array().rowwise() /= weights.colwise().sum().array().eval();
  return weights;
}

/// Returns the weighted sum of the squared eigenfunctions, times the area.
Eigen::MatrixXd Signature(const LaplaceEigenpairs& spectrum, const Eigen::MatrixXd& weights)
{
  return spectrum.Masses.sum() * (spectrum.Eigenfunctions.array().square().matrix() * weights);
}

} // namespace

Eigen::MatrixXd ComputeHeatKernelSignature(const LaplaceEigenpairs& spectrum, int times)
{
  return Signature(spectrum, HeatWeights(spectrum, times));
}

Eigen::MatrixXd ComputeWaveKernelSignature(const LaplaceEigenpairs& spectrum, int energies)
{
  return Signature(spectrum, WaveWeights(spectrum, energies));
}

Eigen::MatrixXd ComputeWaveKernelFrom(const LaplaceEigenpairs& spectrum, int point, int energies)
{
  return spectrum.Masses.sum() *
    (spectrum.Eigenfunctions *
      (spectrum.Eigenfunctions.row(point).transpose().asDiagonal() *
        WaveWeights(spectrum, energies)));
}

Eigen::MatrixXd ComputeSpectralEmbedding(const LaplaceEigenpairs& spectrum, int dimensions)
{
  const Eigen::Index zeros = ZeroCount(spectrum, dimensions);
  // Rustamov 2007, section 4.
  return spectrum.Eigenfunctions.middleCols(zeros, dimensions) *
    spectrum.Eigenvalues.segment(zeros, dimensions).cwiseSqrt().cwiseInverse().asDiagonal();
}

} // namespace shape
