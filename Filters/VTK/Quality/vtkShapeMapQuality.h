/**
 * @class   vtkShapeMapQuality
 * @brief   measure how far a map of a surface or solid is from an isometry
 *
 * The map takes each point to the position in its map array, and interpolates between the corners
 * of each cell. J is the Jacobian of the map, on a triangle (d = 2) or at a corner of a solid cell
 * (d = 3). Its d singular values are s_i.
 *
 * Input: any data set with the map array (double, 3) at its points, including image data. It may be
 * composite or distributed. Solid cells (tetrahedra, pyramids, wedges, hexahedra, voxels) are
 * measured at their corners; for pyramids, these are the four corners of the base. Other cells,
 * such as polygons, are divided into simplices. Points and lines are not measured. If there are
 * solid cells, surface cells are not measured, either.
 *
 * Output 0: the input with the cell arrays
 * - `JacobianDeterminant`: the minimum, over the cell, of the factor by which the map changes area
 *   or volume. It is negative if the cell is flipped. A triangle is flipped if its image faces
 *   opposite to +z (images in the plane z = 0), or inwards (images on the unit sphere). Otherwise,
 *   its image is compared with the images of the surrounding triangles of the same block and
 *   process. See shape::EvaluateMapQuality.
 * - `Flipped` (int): 1 if `JacobianDeterminant` is negative, otherwise 0.
 * - `Dirichlet`: |J|^2 / 2.
 * - `SymmetricDirichlet`: |J|^2 + |J^-1|^2. Its minimum, for isometries, is 4 on surfaces and 6 in
 *   solids.
 * - `ConformalDistortion`: |J|^2 / (d |det J|^(2/d)). Its minimum, for similarities, is 1.
 * - `ARAP`: the sum of (s_i - 1)^2. In flipped cells, the smallest s_i is taken as negative.
 * - `Hencky`: the sum of log(|s_i|)^2. 0 for an isometry.
 * - `AMIPS`: exp(c + a / 2), where c is the distortion of angles, and a is `AreaDistortion`. Its
 *   minimum, for isometries, is exp(3/2).
 * - `AreaDistortion`: (|det J| + 1 / |det J|) / 2, of areas or volumes. Its minimum is 1.
 * - `L2Stretch`, `LinfStretch`: |J^-1| / sqrt(d) and 1 / min |s_i|: the mean and the maximum factor
 *   by which the image must be stretched to get the source back.
 * - `SmallestSingularValue`, `LargestSingularValue`: min |s_i| and max |s_i|.
 * - `Degenerate` (int): 1 if the cell or a part of its image has no area or volume. If the cell
 *   itself has none, the measures have the values of an isometry. Otherwise, the measures that
 *   divide by the size of the image are 1e30.
 * Energies are means over the cell. Infinite values are replaced by 1e30.
 *
 * Output 1: a table of the measures over all blocks and processes, without ghost cells. The columns
 * are Measure, Minimum, Mean, Maximum and Share. The mean is weighted by area or volume, over the
 * cells with a defined measure. In the row JacobianDeterminant, Share is the share of flipped
 * cells. In the other rows, it is the share of cells whose measure is undefined, either because the
 * cell has no area or volume, or because the value is 1e30.
 *
 * Facts: MapQuality.Cells, .FlippedCells, .DegenerateCells, and the numbers of the
 * table. Their names consist of the column and the row, such as MapQuality.MeanSymmetricDirichlet
 * and MapQuality.ShareJacobianDeterminant.
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
