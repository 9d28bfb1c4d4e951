/**
 * @class   vtkShapeMapDifference
 * @brief   show where two surfaces differ in area and in angles, given a map between them
 *
 * Inputs
 * - SurfaceA: an oriented 2-manifold, open or closed, with the map array (double, 3) onto SurfaceB.
 *   If the map array is `TargetPosition`, its companions `TargetCell` and `TargetBarycentric` are
 *   used if they are present. Otherwise, images are projected to the closest positions.
 * - SurfaceB: an oriented 2-manifold, open or closed. Blocks and distributed pieces of each surface
 *   are joined first, and each process gets its own pieces back.
 *
 * Output 0: SurfaceA with the point arrays
 * - `AreaDifference`: the factor by which the map changes the area around the point (area on
 *   SurfaceB divided by area on SurfaceA).
 * - `ConformalDifference`: the factor by which the map changes the Dirichlet energy of functions
 *   around the point. It is 1 where the map is conformal. If the map stretches lengths by s and t
 *   in two orthogonal directions, it is (s / t + t / s) / 2. On a protrusion so thin that functions
 *   vary only along it, it is t / s.
 * - `AreaEigenfunctions`, `ConformalEigenfunctions`: eigenfunctions of the operators of area and of
 *   conformal difference (10 components, in order of the distance of their eigenvalues from 1). An
 *   eigenfunction is large where the surfaces differ by the factor given by its eigenvalue.
 * - `OffsetAreaDifference`, `OffsetConformalDifference`, if OffsetDistance is not 0: the first two
 *   for the offset surfaces. Where they differ from these, the curvature differs.
 * The first two arrays are means over the smallest regions that NumberOfEigenpairs functions can
 * resolve.
 *
 * Facts: MapDifference.OffsetDistance, .AreaEigenvalues, .ConformalEigenvalues,
 * .UndeterminedFunctions (number of functions on SurfaceB that the map covers too little to
 * determine) and .PreciseMap (1 if `TargetCell` was used, otherwise 0). The eigenvalues are also
 * field data of output 0.
 *
 * Output 1: a table, on one process, with both operators as matrices in the eigenbasis of the
 * Laplacian of SurfaceA. It has a row for each eigenfunction and the columns Area0, Area1, ...,
 * Conformal0, ... If OffsetDistance is not 0, it also has OffsetArea0, ..., OffsetConformal0, ...
 * in the eigenbasis of the offset surface of SurfaceA. Its field data has
 * MapDifference.OffsetDistance. vtkShapeFromOperators recovers SurfaceB from this table.
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
  vtkShapeEnumOption(Products, shape::MapDifferenceOptions::ProductsType,
    shape::MapDifferenceOptions::ProductsType::Eigenfunctions,
    shape::MapDifferenceOptions::ProductsType::Triangles);
  vtkShapeOptionAs(OffsetDistance, OffsetDistance, double);
  ///@}

protected:
  vtkShapeMapDifference();
  ~vtkShapeMapDifference() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeMapDifference(const vtkShapeMapDifference&) = delete;
  void operator=(const vtkShapeMapDifference&) = delete;

  std::string MapArray = "TargetPosition";
  double OffsetDistance = 0.0; ///< 0: no operators of offset surfaces
  shape::MapDifferenceOptions Options;
};

#endif
