#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>

namespace shape
{

struct NetworkDescriptorOptions
{
  /// The scale of the surface that the network sees. The first two also move the centroid of the
  /// area to the origin.
  enum class ScaleType
  {
    UnitArea = 0,   ///< area 1
    UnitRadius = 1, ///< distance 1 from the centroid to the farthest point
    Given = 2       ///< as given, and in its place
  };
  ScaleType Scale = ScaleType::UnitArea;
  /// Number of eigenpairs (SolveLaplaceEigenproblem) for the network's inputs; >= 2. A network that
  /// declares a number gets that number instead.
  int NumberOfEigenpairs = 128;
};

/**
 * Computes descriptors of the points of a surface by a trained neural network, such as the features
 * of a deep functional map (Litany, Remez, Rodola, Bronstein and Bronstein, "Deep functional maps:
 * structured prediction for dense shape correspondence", 2017). Nothing is trained here.
 *
 * network: the content of an ONNX file, which OpenCV evaluates in a process of its own, on one
 * thread and in single precision. It has one output, with a row for each point. Its inputs are
 * recognised by their names:
 *
 * | name                | shape   |                                                     |
 * |---------------------|---------|-----------------------------------------------------|
 * | Positions           | n x 3   | the points                                          |
 * | Normals             | n x 3   | unit normals, pointing outwards                     |
 * | Masses              | n       | the area around each point                          |
 * | Eigenvalues         | k       | of the Laplacian, ascending                         |
 * | Eigenfunctions      | n x k   | orthonormal with the weights Masses                 |
 * | HeatKernelSignature | n x any | ComputeHeatKernelSignature; 100 columns if it is open |
 * | WaveKernelSignature | n x any | ComputeWaveKernelSignature; 100 columns if it is open |
 * | Arrays              | n x d   | the given arrays                                    |
 *
 * Dimensions of size 1 may be added to these shapes, as in 1 x n x 3, n x 1 or k x 1.
 *
 * surface: triangles (RequireTriangles); for Normals, facing outwards. arrays: n x d; d may be 0.
 * Returns n x the number of the output's columns; 0 at points without a triangle. Throws
 * InvalidInput if ShapeMap was built without OpenCV, if the content is no network that OpenCV can
 * evaluate, if an input has another name, shape or type, if the output is no row for each point, or
 * if an option is out of range; SolveFailure if the evaluation crashes or its result is not finite;
 * Aborted.
 */
Eigen::MatrixXd ComputeNetworkDescriptors(const Surface& surface, const std::string& network,
  const Eigen::MatrixXd& arrays, const NetworkDescriptorOptions& options = {},
  const Progress& progress = {});

} // namespace shape
