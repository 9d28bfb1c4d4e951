/**
 * @class   vtkShapeGeodesicDistance
 * @brief   how far it is along a surface from the nearest seed to each of its points
 *
 * Inputs
 * - Input: an oriented 2-manifold, open or closed, of any number of components (polygons are
 *   triangulated inside). Blocks and distributed pieces are joined first; each process gets its own
 *   back.
 * - Seeds: any dataset, such as points, curves or an extracted selection; each of its points
 * counts, at the closest place of the surface.
 *
 * Output: the same surface with the point array `GeodesicDistance` (double, in the surface's
 * units): -1 at points of components where no seed is. Field data:
 * GeodesicDistance.UnreachedPoints, the number of these.
 *
 * Heat: each of its two or three factorisations is one library call: an abort takes effect at its
 * end.
 *
 * The mathematics: shape::ComputeGeodesicDistance.
 */
#ifndef vtkShapeGeodesicDistance_h
#define vtkShapeGeodesicDistance_h

#include "vtkShapeAlgorithm.h"

#include "Geodesics/GeodesicDistance.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeGeodesicDistance : public vtkShapeAlgorithm
{
public:
  static vtkShapeGeodesicDistance* New();
  vtkTypeMacro(vtkShapeGeodesicDistance, vtkShapeAlgorithm);

  ///@{
  /// 0 = Heat: smooth, near to them. 1 = Exact: the shortest paths on the polyhedron. 2 =
  /// Dijkstra: along edges, never too short. Default: Heat.
  vtkShapeEnumOption(Method, shape::GeodesicDistanceOptions::MethodType,
    shape::GeodesicDistanceOptions::MethodType::Heat,
    shape::GeodesicDistanceOptions::MethodType::Dijkstra);
  ///@}

protected:
  vtkShapeGeodesicDistance();
  ~vtkShapeGeodesicDistance() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeGeodesicDistance(const vtkShapeGeodesicDistance&) = delete;
  void operator=(const vtkShapeGeodesicDistance&) = delete;

  shape::GeodesicDistanceOptions Options;
};

#endif
