#pragma once

#include "vtkShapeAtlas.h"
#include "vtkShapeBlocks.h"

#include "Atlas/Atlas.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <string>
#include <vector>

/// Reads the shapes of vtkShapeAtlas.
namespace vtkShapeAtlasInput
{

/// The shapes with the points of the template.
struct Population
{
  std::vector<Eigen::MatrixXd> Shapes;
  vtkSmartPointer<vtkPolyData> TemplateData;
  shape::Mesh Template;
  int TemplateNumber = -1; ///< -1: it was given
  ///@{
  /// With maps: for each shape, its triangles, and where the template's points are on them.
  std::vector<Eigen::MatrixXi> Triangles;
  std::vector<shape::SurfacePoints> Samples;
  ///@}
  double LargestGap = 0.0; ///< of a template point from a mapped shape, per longest side
};

/// templateData: the given template, or null. Throws shape::InvalidInput if the shapes do not
/// correspond, or positions are not finite; shape::Aborted.
Population Read(const std::vector<vtkShapeBlocks::Block>& blocks, vtkPolyData* templateData,
  vtkShapeAtlas::CorrespondenceType correspondence, const shape::Progress& progress);

/// Returns the point arrays of real numbers, of one component, that all shapes have.
std::vector<std::string> ListQuantities(const std::vector<vtkShapeBlocks::Block>& blocks);

/// Returns the values of a quantity at the points of the template, a column for each shape.
Eigen::MatrixXd ReadQuantity(const std::string& name,
  const std::vector<vtkShapeBlocks::Block>& blocks, const Population& population);

} // namespace vtkShapeAtlasInput
