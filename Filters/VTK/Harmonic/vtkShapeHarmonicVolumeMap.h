/**
 * @class   vtkShapeHarmonicVolumeMap
 * @brief   map a solid onto another by the harmonic map that a boundary map determines
 *
 * Each coordinate of the map is harmonic inside the boundary surface and equals the map array of
 * the boundary on it. It is the potential of point charges outside the solid (the method of
 * fundamental solutions).
 *
 * Inputs
 * - Domain: points or cells of any data set, also composite or distributed.
 * - Boundary: the closed surface of the solid and of its voids, with the map array (double, 3) at
 *   its points.
 * - Features (optional, repeatable): points, curves or surfaces inside, which the map sends to
 *   their images in the least-squares sense. The images are the map array, or the TargetFeatures.
 *   `Weight` (one component) is optional and defaults to FeatureWeight.
 * - TargetFeatures (optional, repeatable): the images of the Features without the map array, in
 *   the same order. Curves are paired with curves by arc length, points with points by order.
 * - Target (optional): the surface that the boundary goes to. It is an error if its genus or
 *   number of components is not that of the boundary.
 *
 * Outputs
 * - 0: the domain moved, without point normals, with `SourcePosition` (double, 3) and
 *   `OutsideDomain` (1 at points outside the boundary, which keep their position).
 * - 1: the charge set, which stores the map: points with `Charge` (double, 3), field data `Affine`
 *   (3 x 4). It can be evaluated anywhere inside.
 * - 2: a table of levels: Level, Sources, Collocations, RMSEVertices, RMSEInside, Maximum,
 *   Seconds, Kept, RegionId. Kept is 0 if the level reduced no error and is not in the map. Errors
 *   are of the whole boundary, at its points and inside its triangles, divided by the longest edge
 *   of the target's bounding box. With Exact they are those of the region's own boundary.
 *
 * Field data of outputs 0 and 1, with the prefix HarmonicVolumeMap
 * - .RMSEVertices, .RMSEInside, .Maximum, .RMSEFeatures (0 without features), .FeaturePoints.
 * - .OffsetDistance: of the nearest charges. .DeletedSources, .InsertedSources.
 * - .OutsidePoints: over all processes, without ghosts.
 * - .TargetDistance: with Target only, the root mean square distance of the boundary's images from
 *   it, divided by the longest edge.
 * - .Iterations, .RefinedPoints (added to the boundary): of Accelerated, otherwise 0.
 * - .PointsWithoutCharge: of Accelerated, otherwise 0. Boundary points in gaps too narrow for a
 *   charge, or inside degenerate triangles.
 * - .Method (a string).
 * - .Stop (a string): Tolerance (reached), Levels (all were fitted), NoImprovement (the last
 *   levels gained less than LeastGain), or Refinement (Accelerated would have to refine more than
 *   MostRefined).
 * - With Exact the counts are sums over the maps of the layers.
 *
 * With Exact, closed surfaces among the Features are met as exactly as the boundary. By the
 * maximum principle no single harmonic map can do this. Each of these surfaces is therefore an
 * interface between layers, and each layer has a harmonic map, with charges on both sides, by any
 * Method. The map is continuous across interfaces. Points and curves are met in the least-squares
 * sense in the layer that contains them. They must have `Weight`: without it they would have to be
 * met exactly, which is an error.
 *
 * With Exact the charge set also has
 * - `RegionId` (int) at its points: the region to whose map a charge belongs. Numbers are those of
 *   vtkShapeTetrahedralize: 0 around the first interface, i + 1 inside surface i of the Features.
 *   Unconnected pieces of one region have numbers of their own, after these.
 * - `RegionId` (int) at its cells: the region that they enclose, -1 for voids.
 * - Field data `Affine` with 12 numbers for each region: the rows of A and b.
 * - Field data `Skin` for each region: the thickness of the skin inside its interface in which the
 *   outer map blends into its own.
 * and field data with an entry for each region, with the prefix HarmonicVolumeMap
 * - .BorderRMSEVertices, .BorderRMSEInside, .BorderMaximum: errors of the map at the surface
 *   around it.
 * - .BorderJumpRMS, .BorderJumpMaximum: difference of the two fitted maps there, for which the
 *   skin compensates.
 *
 * With FreeBoundary the field data have .DistortionBefore and .DistortionAfter: the mean symmetric
 * Dirichlet energy of the solid, images scaled to its volume, 6 for an isometry. The boundary's
 * solid is filled with tetrahedra for this. .FreeBoundary (a string) is Slid, or NotLower if the
 * energy did not decrease and the images are unchanged.
 *
 * With FoldFree output 0 is the result of vtkShapeUntangle for the moved domain, with its arrays,
 * .InvertedBefore and .InvertedAfter. The charge set still stores the harmonic map, which may
 * fold.
 *
 * A singular value decomposition cannot be interrupted, so an abort takes effect at its end.
 *
 * The mathematics: shape::ComputeVolumeMap, shape::ComputeHarmonicVolumeMap.
 */
#ifndef vtkShapeHarmonicVolumeMap_h
#define vtkShapeHarmonicVolumeMap_h

#include "vtkShapeAlgorithm.h"

#include "Harmonic/VolumeMap.h" // for the options

#include <memory>

class vtkPolyData;

class VTKSHAPEFILTERS_EXPORT vtkShapeHarmonicVolumeMap : public vtkShapeAlgorithm
{
public:
  static vtkShapeHarmonicVolumeMap* New();
  vtkTypeMacro(vtkShapeHarmonicVolumeMap, vtkShapeAlgorithm);

  ///@{
  /// The feature inputs.
  void AddFeatures(vtkAlgorithmOutput* feature);
  void RemoveAllFeatures();
  void AddTargetFeatures(vtkAlgorithmOutput* target);
  void RemoveAllTargetFeatures();
  ///@}

  ///@{
  /// The properties. Effects and ranges: vtkShapeHarmonicVolumeMap.xml. Enumerations and defaults:
  /// shape::HarmonicVolumeMapOptions.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkShapeEnumOption(Method, shape::HarmonicVolumeMapOptions::MethodType,
    shape::HarmonicVolumeMapOptions::MethodType::Accelerated,
    shape::HarmonicVolumeMapOptions::MethodType::SingleShot);
  vtkShapeOption(Tolerance, double);
  vtkShapeOption(MaximumLevels, int);
  vtkShapeOption(SourceSubsets, int);
  vtkShapeOption(MostRefined, double);
  vtkShapeOption(LeastGain, double);
  vtkShapeOption(FeatureWeight, double);
  vtkSetMacro(Exact, bool);
  vtkGetMacro(Exact, bool);
  vtkBooleanMacro(Exact, bool);
  vtkShapeOption(CollocationRatio, double);
  vtkShapeOption(SourceRatio, double);
  vtkShapeOption(OffsetDistance, double);
  vtkShapeEnumOption(CollocationSampling, shape::SamplingMode, shape::SamplingMode::Uniform,
    shape::SamplingMode::GeometryAdaptive);
  vtkShapeEnumOption(SourceSampling, shape::SamplingMode, shape::SamplingMode::Uniform,
    shape::SamplingMode::GeometryAdaptive);
  vtkShapeOption(SingularValueThreshold, double);
  vtkSetMacro(FreeBoundary, bool);
  vtkGetMacro(FreeBoundary, bool);
  vtkSetMacro(FoldFree, bool);
  vtkGetMacro(FoldFree, bool);
  vtkShapeOption(MaximumMemory, double);
  ///@}

protected:
  vtkShapeHarmonicVolumeMap();
  ~vtkShapeHarmonicVolumeMap() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeHarmonicVolumeMap(const vtkShapeHarmonicVolumeMap&) = delete;
  void operator=(const vtkShapeHarmonicVolumeMap&) = delete;

  /// Computes the map of the gathered inputs; the facts about it are added to the field data of
  /// `facts`.
  shape::VolumeMapResult Solve(vtkPolyData* facts, const shape::Progress& progress);

  std::string MapArray = "TargetPosition";
  bool Exact = false;
  bool FreeBoundary = false;
  bool FoldFree = false;
  shape::HarmonicVolumeMapOptions Options;
  std::shared_ptr<shape::AcceleratedSetup> Setup; ///< of the last boundary
};

#endif
