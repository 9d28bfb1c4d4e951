#pragma once

#include "Base/Progress.h"
#include "Materials/VoxelImage.h"
#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

struct ImageValuesOptions
{
  /// Cells are divided into parts whose edges are no longer than this, in voxels; from 0.05 to 10.
  /// Each part has eight Gauss points. At 1 and below, no voxel is missed.
  double SamplingStep = 1.0;
  /// Layers of voxels at the boundary of the mesh whose densities are extrapolated from inside;
  /// from 0 to 20. The boundary crosses the boxes of one layer, so that every image has that one;
  /// an image that is blurred by more than a voxel has more.
  int BoundaryLayers = 1;
  /// Bins of equal relative width, from the minimum to the maximum of the modulus; from 1 to
  /// 10,000. 50 bins divide a ratio of 200, from trabecular to cortical bone, into steps of 11 %.
  int Materials = 50;
};

/// Throws InvalidInput if an option is out of range.
void RequireInRange(const ImageValuesOptions& options);

/// How values of an image become a density and a modulus.
struct MaterialLaws
{
  std::vector<double> Values;            ///< of each sample; empty: there are no laws
  std::function<double(double)> Density; ///< of a value
  std::function<double(double)> Modulus; ///< of a density; >= 0 and finite on all values used
};

/// One entry, or row, for each cell.
struct ImageValuesResult
{
  Eigen::VectorXd Volumes;  ///< in the units of the mesh cubed
  Eigen::VectorXd Coverage; ///< share of the cell that lies in the image, from 0 to 1
  Eigen::MatrixXd Means;    ///< of each channel over the part in the image; 0 without such a part
  ///@{
  /// Means of the density and of the modulus over the part in the image; empty without laws.
  Eigen::VectorXd Density, Modulus;
  ///@}
};

/**
 * Computes the means of an image within solid cells.
 *
 * The image is the trilinear interpolation of its samples. A cell is divided into parts that are
 * smaller than a voxel (SamplingStep), with eight Gauss points each. Means of linear functions are
 * exact in tetrahedra, pyramids, wedges and hexahedra of any shape; other errors decrease with the
 * square of the step.
 *
 * The laws are evaluated at the Gauss points, and then averaged: the modulus of a mean density is
 * not the mean modulus (Taddei, Schileo, Helgason, Cristofolini and Viceconti 2007). Each law is
 * tabulated at 65,537 values of the image, and linear in between. It is called from the calling
 * thread.
 *
 * Throws InvalidInput where RequireVoxelImage does; if a cell is no linear solid cell, a point is
 * not finite, or a cell has no volume; with laws, if a cell is entirely outside of the image, or if
 * the modulus is negative or not finite somewhere in a cell, or 0 in all of it; if an option is out
 * of range. Throws Aborted.
 */
ImageValuesResult ComputeImageValues(const Cells& cells, const VoxelImage& image,
  const MaterialLaws& laws = {}, const ImageValuesOptions& options = {},
  const Progress& progress = {});

} // namespace shape
