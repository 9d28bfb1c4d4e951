/**
 * @class   vtkShapeMapDifference
 * @brief   show where two surfaces differ in area and in angles, given a map between them
 *
 * Inputs
 * - SurfaceA: an oriented 2-manifold, open or closed, with the map array (double, 3) onto
 *   SurfaceB. `TargetCell` and `TargetBarycentric` are used if they accompany `TargetPosition`.
 *   Otherwise images are projected to the closest positions.
 * - SurfaceB: another such surface. Blocks and distributed pieces of each are joined first, and
 *   each process gets its own back.
 *
 * Output 0: SurfaceA with the point arrays
 * - `AreaDifference`: the ratio of areas around the point, B divided by A.
 * - `ConformalDifference`: 1 where the map is conformal, otherwise the factor of the Dirichlet
 *   energy of a function around the point. For stretches s and t it is (s / t + t / s) / 2. On a
 *   protrusion so thin that functions vary only along it, it is t / s.
 * - `AreaEigenfunctions`, `ConformalEigenfunctions`: eigenfunctions of both operators (10
 *   components, the eigenvalues farthest from 1 first). They are large where the surfaces differ
 *   by that amount.
 * The first two are means over regions that NumberOfEigenpairs functions can resolve.
 *
 * Field data: MapDifference.AreaEigenvalues, .ConformalEigenvalues, .UndeterminedFunctions
 * (functions of SurfaceB that are undetermined because the map reaches too little of it) and
 * .PreciseMap (1 if `TargetCell` was used, otherwise 0).
 *
 * Output 1: a table, on one process, with the operators as matrices in the eigenbasis of the
 * Laplacian of SurfaceA. It has a row for each function and the columns Area0, Area1, ...,
 * Conformal0, ...
 *
 * A factorisation cannot be interrupted, so an abort takes effect at its end.
 *
 * The mathematics: shape::MapDifference.
 */
#ifndef vtkShapeMapDifference_h
#define vtkShapeMapDifference_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Evaluate/MapDifference.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeMapDifference : public vtkShapeAlgorithm
{
public:
  static vtkShapeMapDifference* New();
  vtkTypeMacro(vtkShapeMapDifference, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeMapDifference.xml. Enumerations and defaults:
  /// shape::MapDifferenceOptions.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkShapeOption(NumberOfEigenpairs, int);
  ///@}

protected:
  vtkShapeMapDifference();
  ~vtkShapeMapDifference() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeMapDifference(const vtkShapeMapDifference&) = delete;
  void operator=(const vtkShapeMapDifference&) = delete;

  std::string MapArray = "TargetPosition";
  shape::MapDifferenceOptions Options;
};

#endif
