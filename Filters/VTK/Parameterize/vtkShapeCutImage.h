#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/SurfaceCut.h"

#include <array>
#include <map>
#include <vector>

class vtkDataSet;

/// The image of a surface that was cut open: parts of it, block by block.
class vtkShapeCutImage
{
public:
  /// surface: the whole, uncut. positions: of the points of `cut` (k x 3).
  vtkShapeCutImage(
    const shape::Mesh& surface, const shape::CutSurface& cut, const Eigen::MatrixXd& positions);

  /// Makes `to` the image of a block, as triangles, with its arrays and `SourcePosition`, and
  /// `OriginalPointId`: the point of the block that each point is a copy of. Those that keep their
  /// number in the whole come first, in order. whole: for each point of the block, its number
  /// there.
  void Fill(vtkDataSet* from, const std::vector<int>& whole, vtkDataSet* to) const;

private:
  const shape::Mesh& Surface;
  const shape::CutSurface& Cut;
  const Eigen::MatrixXd& Positions;
  std::map<std::array<int, 3>, int> Triangles; ///< by their points, the lowest first
};
