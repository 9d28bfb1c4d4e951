#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The number of eigenvalues by which spectra are compared.
inline constexpr int SpectrumSize = 30;

/// Returns the distances of spectra (N x N): the root mean square of log(a / b) of the eigenvalues
/// a, b of two surfaces of area 1, without the first one, which is 0.
Eigen::MatrixXd CompareSpectra(const std::vector<Eigen::VectorXd>& spectra);

/// Returns the pairs of shapes to match: each with its `neighbours` nearest ones, and the minimum
/// spanning tree, which connects all. First ones first.
std::vector<std::array<int, 2>> FindShapeGraph(const Eigen::MatrixXd& distances, int neighbours);

} // namespace shape
