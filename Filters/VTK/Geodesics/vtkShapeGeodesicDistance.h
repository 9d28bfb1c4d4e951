/**
 * @class   vtkShapeGeodesicDistance
 * @brief   compute the geodesic distance of each point of a surface from the nearest seed
 *
 * Inputs
 * - Input: an oriented 2-manifold, open or closed, of any number of components. Polygons are
 *   triangulated internally. Blocks and distributed pieces are joined first, and each process gets
 *   its own pieces back.
 * - Seeds (optional): any data set, such as points, curves or an extracted selection. Each point is
 *   projected to the surface. SeedPoints are further seeds. At least one seed is required.
 *
 * Output: the same surface with the point array `GeodesicDistance` (double, in the units of the
 * surface). On components without a seed, the distance is -1. Facts:
 * GeodesicDistance.UnreachedPoints, the number of points on such components.
 *
 * If only the seeds change, everything that depends only on Input is reused.
 *
 * The mathematics: shape::ComputeGeodesicDistance.
 */
#ifndef vtkShapeGeodesicDistance_h
#define vtkShapeGeodesicDistance_h

#include "vtkShapeAlgorithm.h"

#include "Geodesics/GeodesicDistance.h" // for the options

#include <memory> // for what is kept
#include <vector> // for positions

class VTKSHAPEFILTERS_EXPORT vtkShapeGeodesicDistance : public vtkShapeAlgorithm
{
public:
  static vtkShapeGeodesicDistance* New();
  vtkTypeMacro(vtkShapeGeodesicDistance, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeGeodesicDistance.xml. Enumerations and defaults:
  /// shape::GeodesicDistanceOptions.
  vtkShapeEnumOption(Method, shape::GeodesicDistanceOptions::MethodType,
    shape::GeodesicDistanceOptions::MethodType::Heat,
    shape::GeodesicDistanceOptions::MethodType::Dijkstra);
  void SetNumberOfSeedPoints(int count);
  void SetSeedPoints(int index, double x, double y, double z);
  std::vector<double> GetSeedPoints() { return this->SeedPoints; }
  ///@}

protected:
  vtkShapeGeodesicDistance();
  ~vtkShapeGeodesicDistance() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeGeodesicDistance(const vtkShapeGeodesicDistance&) = delete;
  void operator=(const vtkShapeGeodesicDistance&) = delete;

  Eigen::MatrixXd FindSeeds(); ///< the points of Seeds, and SeedPoints

  shape::GeodesicDistanceOptions Options;
  std::vector<double> SeedPoints;
  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
