/**
 * @class   vtkShapeCageDeform
 * @brief   deform any data set by a closed surface around it, whose points move
 *
 * Inputs
 * - Input: any data set, which may be composite or distributed.
 * - Cage: a closed surface, gathered from all blocks and processes. Polygons are triangulated
 *   internally. It may have several components, of any orientation, and a component inside another
 *   one bounds a void.
 * - MovedCage: the same surface with its points moved: as many points, and the same polygons, in
 * the same order.
 *
 * Output: the input moved, without point normals, with the point arrays
 * - `SourcePosition` (double, 3).
 * - `OutsideDomain` (int): 0 if the point moved. It is 1 if the point is outside the cage and
 *   Coordinates is Harmonic or Green, or if it is farther away than 100 times the size of the cage.
 *   Such points keep their position.
 * - `DeformationGradient` (double, 9; if the property of this name is on): the derivatives of the
 * new position by the old one, in rows: first those of x.
 *
 * Facts: CageDeform.OutsidePoints, the number of points with OutsideDomain 1 (over all processes,
 * without ghosts), and CageDeform.Tetrahedra, the number of tetrahedra of Harmonic, otherwise 0.
 *
 * The mathematics: shape::CageDeformer.
 */
#ifndef vtkShapeCageDeform_h
#define vtkShapeCageDeform_h

#include "vtkShapeAlgorithm.h"

#include "Cage/CageDeform.h" // for the options

#include <vector> // for points

class VTKSHAPEFILTERS_EXPORT vtkShapeCageDeform : public vtkShapeAlgorithm
{
public:
  static vtkShapeCageDeform* New();
  vtkTypeMacro(vtkShapeCageDeform, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeCageDeform.xml. Enumerations and defaults:
  /// shape::CageDeformOptions.
  vtkShapeEnumOption(Coordinates, shape::CageCoordinates, shape::CageCoordinates::MeanValue,
    shape::CageCoordinates::Green);
  vtkShapeOption(Tetrahedra, int);
  vtkShapeOption(ReproduceAffine, bool);
  vtkShapeOption(DeformationGradient, bool);
  ///@}

protected:
  vtkShapeCageDeform();
  ~vtkShapeCageDeform() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCageDeform(const vtkShapeCageDeform&) = delete;
  void operator=(const vtkShapeCageDeform&) = delete;

  /// Writes the output, and returns the points that did not move, without ghosts.
  std::vector<Eigen::RowVector3d> Move(
    const shape::CageDeformer& deformer, const shape::Progress& progress);

  shape::CageDeformOptions Options;
};

#endif
