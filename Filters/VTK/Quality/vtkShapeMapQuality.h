/**
 * @class   vtkShapeMapQuality
 * @brief   measure how far a map of a surface or solid is from an isometry
 *
 * The map takes each point to its map array, and each cell with its corners. J is its Jacobian on
 * a triangle, or at a corner of a solid cell, with singular values s_i in d = 2 or 3 dimensions.
 *
 * Input: any data set with the map array (double, 3) at its points, also image data, composite or
 * distributed. Solid cells (tetrahedra, pyramids, wedges, hexahedra, voxels) are measured at their
 * corners, a pyramid at those of its base. Other cells, such as polygons, are divided into
 * simplices. If there are solid cells, surface cells are not counted. Points and lines never are.
 *
 * Output 0: the input with the cell arrays
 * - `JacobianDeterminant`: the minimum ratio of areas or volumes in the cell, negative if flipped.
 *   The orientation of a surface is measured against +z if the images lie in the plane z = 0, and
 *   against the radius on the unit sphere. Otherwise it is measured against the surface around the
 *   triangle, in this block of this process. See shape::EvaluateMapQuality.
 * - `Flipped`: 1 if that is negative.
 * - `Dirichlet`: |J|^2 / 2.
 * - `SymmetricDirichlet`: |J|^2 + |J^-1|^2. Its minimum is 4 for an isometry of surfaces and 6 of
 *   solids.
 * - `ConformalDistortion`: |J|^2 / (d |det J|^(2/d)). Its minimum is 1 for a similarity.
 * - `ARAP`: the sum of (s_i - 1)^2, with the smallest s_i negative if flipped.
 * - `Degenerate`: 1 if the cell has no area or volume (it then has the values of an isometry), or
 *   if its image, or a part of it, has none. SymmetricDirichlet and ConformalDistortion are then
 *   1e30.
 * Energies are means over the cell. 1e30 stands for infinity.
 *
 * Output 1: a table of the measures over all blocks and processes, without ghost cells. The
 * columns are Measure, Minimum, Mean (weighted by area or volume, where defined), Maximum and
 * Share. Share is the share of flipped cells in the row JacobianDeterminant. In other rows it is
 * the share of cells whose measure is undefined: without size, or 1e30.
 *
 * Field data of output 0: MapQuality.Cells, .FlippedCells, .DegenerateCells, and the numbers of
 * the table by column and row, such as MapQuality.MeanSymmetricDirichlet and
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
  /// The properties. Effects and ranges: vtkShapeMapQuality.xml.
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
