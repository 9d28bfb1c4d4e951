#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/SurfaceCut.h"

#include <array>
#include <map>
#include <vector>

class vtkDataSet;

/// Writes the image of a surface that was cut open, block by block.
class vtkShapeCutImage
{
public:
  /// surface: the complete surface, before the cut. positions: k x 3, the images of the points of
  /// `cut`. given: if the surface was repaired, the given point of each of its points; else empty.
  vtkShapeCutImage(const shape::Mesh& surface, const std::vector<int>& given,
    const shape::CutSurface& cut, const Eigen::MatrixXd& positions);

  /// Writes the image of the block `from` to `to`, as triangles. The image has the arrays of the
  /// block, `SourcePosition`, and `OriginalPointId`, which is the index in the block of the point
  /// that was copied. The points that kept their index when the surface was cut come first, in
  /// order. Triangles that a repair removed have no image. whole: for each point of the block, its
  /// index in the complete surface.
  void Fill(vtkDataSet* from, const std::vector<int>& whole, vtkDataSet* to) const;

private:
  /// Returns the given point of a point of the complete surface.
  int ToGiven(int point) const { return this->Given.empty() ? point : this->Given[point]; }

  const shape::Mesh& Surface;
  const std::vector<int>& Given;
  const shape::CutSurface& Cut;
  const Eigen::MatrixXd& Positions;
  /// The index of each triangle. The key is its points, rotated so that the lowest comes first.
  std::map<std::array<int, 3>, int> Triangles;
};
