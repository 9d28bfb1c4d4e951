/**
 * @class   vtkShapeMapDifference
 * @brief   where two surfaces differ in area and in angles, by a map between them
 *
 * SurfaceA: an oriented 2-manifold, open or closed, with the map array (double, 3): where on
 * SurfaceB its points go: by TargetCell and TargetBarycentric, where they are there beside
 * TargetPosition, else to the closest places. SurfaceB: another such surface. Blocks and
 * distributed pieces of each are joined first; each process gets its own back.
 *
 * Output 0: SurfaceA with the point arrays
 * - `AreaDifference`: the ratio of areas around the point, B's over A's;
 * - `ConformalDifference`: 1 where the map is conformal; else how much larger the Dirichlet energy
 *   of a function around the point becomes: (s / t + t / s) / 2 for stretches s and t, or t / s on
 *   a limb so thin that functions vary along it only;
 * - `AreaEigenfunctions`, `ConformalEigenfunctions`: of the two operators (10 components, the
 *   eigenvalues farthest from 1 first): large where the surfaces differ as much as that.
 * The first two are means over as much as NumberOfEigenpairs functions can tell apart. Field data:
 * MapDifference.AreaEigenvalues, .ConformalEigenvalues; .UndeterminedFunctions: of SurfaceB,
 * because too little of it is reached; .PreciseMap: 1 where TargetCell was used, else 0.
 *
 * Output 1: a table, on one process: the operators as matrices in the eigenbasis of SurfaceA's
 * Laplacian, a row for each function; columns Area0, Area1, ..., Conformal0, ...
 *
 * Each factorisation is one library call: an abort takes effect at its end.
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
  /// The point array (3 components) of SurfaceA that says where its points go. Default:
  /// TargetPosition.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  ///@}

  ///@{
  /// How many functions of SurfaceA the operators act on. Default: 50.
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
