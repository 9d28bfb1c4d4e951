/**
 * @class   vtkShapeMapQuality
 * @brief   how far a map of a surface or solid is from an isometry, cell by cell and in sum
 *
 * The map takes each point to its map array, and each cell's corners with it. J is its Jacobian on
 * a triangle, or at a corner of a solid cell, with singular values s_i in d = 2 or 3 dimensions.
 *
 * Input: any data set with the map array (double, 3) at its points, also image data, composite or
 * distributed. Solid cells (tetrahedra, pyramids, wedges, hexahedra, voxels) are looked at in their
 * corners, a pyramid in those of its base; other cells, such as polygons, in the simplices that
 * they are cut into. Where there are solid cells, surface cells are not counted; points and lines
 * never are.
 *
 * Output 0: the input with the cell arrays
 * - `JacobianDeterminant`: the least ratio of areas or volumes in the cell, negative where flipped.
 *   A surface's sign is against +z (where the images lie in the plane z = 0), the radius (on the
 *   unit sphere), or the surface around the triangle, in this block of this process: see
 *   shape::EvaluateMapQuality.
 * - `Flipped`: 1 where that is negative.
 * - `Dirichlet` (|J|^2 / 2), `SymmetricDirichlet` (|J|^2 + |J^-1|^2: 4 for an isometry of surfaces,
 *   6 of solids, the least), `ConformalDistortion` (|J|^2 / (d |det J|^(2/d)): 1 for a similarity,
 *   the least), `ARAP` (sum of (s_i - 1)^2, the least s_i negative where flipped): means over the
 *   cell. 1e30 stands for infinity.
 * - `Degenerate`: 1 where the cell has no area or volume (it then has the values of an isometry),
 *   or where its image, or a part of that, has none (SymmetricDirichlet and ConformalDistortion are
 *   then 1e30).
 *
 * Output 1: a table of the measures: Measure, Minimum, Mean (weighted by area or volume, where the
 * measure is defined), Maximum, and Share: of the cells, in the row JacobianDeterminant those that
 * are flipped, in the others those where the measure is not defined: without size, or 1e30. Over
 * all blocks and processes, without ghost cells.
 *
 * Field data of output 0: MapQuality.Cells, .FlippedCells, .DegenerateCells, and the numbers of the
 * table, each by its column and row: MapQuality.MeanSymmetricDirichlet,
 * MapQuality.ShareJacobianDeterminant.
 *
 * The mathematics: shape::EvaluateMapQuality.
 */
#ifndef vtkShapeMapQuality_h
#define vtkShapeMapQuality_h

#include "vtkShapeAlgorithm.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeMapQuality : public vtkShapeAlgorithm
{
public:
  static vtkShapeMapQuality* New();
  vtkTypeMacro(vtkShapeMapQuality, vtkShapeAlgorithm);

  ///@{
  /// The point array (3 components) that says where each point goes. Default: TargetPosition.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  ///@}

protected:
  vtkShapeMapQuality();
  ~vtkShapeMapQuality() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeMapQuality(const vtkShapeMapQuality&) = delete;
  void operator=(const vtkShapeMapQuality&) = delete;

  std::string MapArray = "TargetPosition";
};

#endif
