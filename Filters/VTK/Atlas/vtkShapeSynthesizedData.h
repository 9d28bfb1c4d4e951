#pragma once

#include "vtkShapeSeenInput.h"

#include "Atlas/Synthesize.h"
#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Quality/CellSimplices.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

class vtkDataSet;
class vtkMultiProcessController;
class vtkPointSet;
class vtkShapeAlgorithm;

/// A template's surface, and where the mean and the modes take its points.
struct vtkShapeAtlasShape
{
  shape::Surface Template; ///< at the positions of the template
  shape::ModeValues Images;
};

/// The input Data of vtkShapeSynthesize, carried by the maps of the mean and of the modes. It is
/// prepared once, and then moved at any weights.
class vtkShapeSynthesizedData
{
public:
  /// Solves for the maps and evaluates them at the points of `data`, unless both are the same as at
  /// the last call. whole: the gathered Atlas. Every process calls it.
  void Prepare(vtkShapeAlgorithm& filter, vtkPointSet* whole, const vtkShapeAtlasShape& atlas,
    const shape::SynthesizeOptions& options, const shape::Progress& progress);

  struct Result
  {
    std::vector<Eigen::RowVector3d> Outside; ///< points with OutsideDomain = 1
    double InvertedBefore = 0.0, InvertedAfter = 0.0;
    double MinimumScaledJacobian = 1.0;
    double Hexahedra = 0.0; ///< number of blocks of hexahedra
    double BoundaryPoints = 0.0;
    double BoundaryDistance = 0.0; ///< in the unit of length
    double NotUntangled = 0.0;     ///< inverted cells in blocks that cannot be untangled
  };
  /// Moves the data of this process. atlas: as in Prepare. sample: the surface at these weights.
  Result Move(vtkShapeAlgorithm& filter, const vtkShapeAtlasShape& atlas,
    const shape::Surface& sample, const Eigen::VectorXd& weights,
    const shape::SynthesizeOptions& options, const shape::Progress& progress);

  /// The largest distance of a point of this process from the template, divided by its longest
  /// side.
  double TemplateDistance() const;
  double Tetrahedra() const;

private:
  struct Block;
  static Block ReadBlock(const shape::FiniteElementMap& map, const vtkShapeAtlasShape& atlas,
    vtkDataSet* data, const shape::Progress& progress);
  static void Check(const Block& block, const vtkShapeAtlasShape& atlas,
    const shape::Surface& sample, const shape::SynthesizeOptions& options, vtkDataSet* given,
    vtkPointSet* moved, Result& result, const shape::Progress& progress);

  vtkShapeSeenInput SeenAtlas, SeenData;
  int Tetrahedrons = 0; ///< of the options, at the last call
  std::unique_ptr<const shape::FiniteElementMap> Map;
  std::vector<std::shared_ptr<const Block>> Blocks;
};
