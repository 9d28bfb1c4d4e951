#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/SurfaceCut.h"

#include <array>
#include <map>
#include <vector>

class vtkDataSet;

/// The image of a surface that was cut open, written block by block.
class vtkShapeCutImage
{
public:
  /// surface: the complete, uncut surface. positions: of the points of `cut` (k x 3).
  vtkShapeCutImage(
    const shape::Mesh& surface, const shape::CutSurface& cut, const Eigen::MatrixXd& positions);

  /// Writes the image of the block `from` to `to`, as triangles. It has the block's arrays,
  /// `SourcePosition`, and `OriginalPointId`: the point of the block that each point is a copy of.
  /// Points that keep their number in the complete surface come first, in order. whole: for each
  /// point of the block, its number in the complete surface.
  void Fill(vtkDataSet* from, const std::vector<int>& whole, vtkDataSet* to) const;

private:
  const shape::Mesh& Surface;
  const shape::CutSurface& Cut;
  const Eigen::MatrixXd& Positions;
  /// Indices of triangles by their points, the lowest first.
  std::map<std::array<int, 3>, int> Triangles;
};
