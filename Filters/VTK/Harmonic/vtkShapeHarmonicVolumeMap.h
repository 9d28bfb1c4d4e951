/**
 * @class   vtkShapeHarmonicVolumeMap
 * @brief   map a solid onto another by the harmonic map that a boundary map determines
 *
 * Each coordinate of the map is a harmonic function inside the boundary surface. On the boundary,
 * the map equals the map array. The map is the sum of an affine map and the potentials of point
 * charges outside the solid (the method of fundamental solutions). With the method FiniteElements,
 * it is linear in each of the tetrahedra that fill the solid.
 *
 * Inputs
 * - Domain: any data set, which may be composite or distributed.
 * - Boundary: the closed surface that bounds the solid and its voids, with the map array (double,
 *   3) at its points. An unstructured grid of solid cells stands for its boundary.
 * - Features (optional, repeatable): points, curves or surfaces inside the solid, whose images are
 *   fitted in the least-squares sense. The images are given by the map array of the Features or, if
 *   there is none, by the TargetFeatures. The point array `Weight` (one component) is optional; its
 *   default is FeatureWeight.
 * - TargetFeatures (optional, repeatable): the images of the Features that have no map array, in
 *   the same order. Curves are paired by arc length, and points by their order.
 * - Target (optional): the surface to which the boundary goes. It must have the same genus and the
 *   same number of components as the boundary.
 *
 * Outputs
 * - 0: the moved domain, without point normals, with the point arrays `SourcePosition` (double, 3)
 *   and `OutsideDomain` (int). `OutsideDomain` is 1 at points outside the boundary, which keep
 *   their position.
 * - 1: the charge set, which stores the map (vtkShapeApplyVolumeMap). It has the point array
 *   `Charge` (double, 3 components) and the field data array `Affine` (3 tuples of 4 components).
 *   With FiniteElements, it is the map of finite elements instead (vtkShapeFiniteElements): the
 *   points of the tetrahedra with `TargetPosition`, and the field data array `Tetrahedra`.
 * - 2: a table of levels: Level, Sources, Collocations, RMSEVertices, RMSEInside, Maximum, Seconds,
 *   Kept, RegionId, RMSECollocations. Kept is 0 if the level did not reduce the error and was
 *   discarded. The errors refer to the complete boundary, at its points and inside its triangles;
 *   RMSECollocations refers to the collocation points on it, and is 0 if there are none. They are
 *   divided by the longest edge of the bounding box of the target. With Exact, the errors refer to
 *   the boundary of the region.
 *
 * Facts, with the prefix HarmonicVolumeMap
 * - .RMSEVertices, .RMSEInside, .Maximum, .RMSEFeatures (0 without features), .FeaturePoints.
 * - .OffsetDistance: distance of the nearest charges from the boundary, also field data of the
 *   charge set. .DeletedSources,
 *   .InsertedSources: numbers of sources that were removed or added.
 * - .OutsidePoints: number of points outside the boundary, over all processes, without ghosts.
 * - .TargetDistance: only with Target, the root mean square distance of the images of the boundary
 *   from Target, divided by the longest edge of the bounding box of Target.
 * - .Iterations, .RefinedPoints (number of points added to the boundary): only for Accelerated,
 *   otherwise 0.
 * - .PointsWithoutCharge: only for Accelerated, otherwise 0. It is the number of boundary points
 *   that have no normal or lie in gaps too narrow for a charge.
 * - .Tetrahedra: only for FiniteElements, otherwise 0.
 * - .Method (a string): the method that was used.
 * - .Stop (a string): why no further level was fitted. "Tolerance": the error reached this
 *   parameter. "Levels": all levels were fitted. "NoImprovement": the last levels gained less than
 *   LeastGain. "Refinement": further refinement would exceed MostRefined.
 * - With Exact, the counts are sums over the maps of all layers.
 *
 * With Exact, the images of closed surfaces among the Features are fitted as exactly as the images
 * of the boundary. By the maximum principle, a single harmonic map cannot do this. Therefore, each
 * of these surfaces is an interface between two layers. Each layer has its own harmonic map, which
 * Method computes, with charges outside the layer. The map is continuous across interfaces. Points
 * and curves are fitted in the least-squares sense, in the layer that contains them. They must have
 * the point array `Weight`. Without it, they would have to be fitted exactly, which is an error.
 *
 * With Exact, the charge set also has
 * - `RegionId` (int) at its points: the region to whose map a charge belongs. Regions are numbered
 *   like in vtkShapeTetrahedralize: 0 outside all interfaces, and i + 1 inside surface i of the
 *   Features. If a region has several components, each further component gets a number after these.
 * - `RegionId` (int) at its cells: the region that their surface encloses, -1 for voids.
 * - Field data `Affine` with 12 numbers for each region: the rows of A and b.
 * - Field data `Skin` with a number for each region: the thickness of the skin along the inner side
 *   of its interface. In the skin, the map of the outer layer is blended into the map of the
 *   region.
 * There are also facts with the prefix HarmonicVolumeMap and an entry for each region:
 * - .BorderRMSEVertices, .BorderRMSEInside, .BorderMaximum: errors of the map of the region on the
 *   surface around the region.
 * - .BorderJumpRMS, .BorderJumpMaximum: difference between the fitted maps on both sides of this
 *   surface. The skin removes this difference.
 *
 * With FreeBoundary, there are also these facts:
 * - .DistortionBefore, .DistortionAfter: the mean symmetric Dirichlet energy of the map, after
 *   scaling the image to the volume of the solid. It is 6 for an isometry. The mean is that of the
 *   charges' formula at 20,000 positions inside, where the map does not fold.
 * - .FoldedBefore, .FoldedAfter: the share of these positions where the map folds, from 0 to 1. If
 *   it is not 0, the mean energy is uncertain, because it is not bounded beside folds.
 * - .FreeBoundary (a string): Slid or, if no map with a lower energy and no larger share of folds
 *   was found, NotLower. Images and map are then as given.
 * - .SlidShare: how much of the way the images slid, from 0 to 1: 1, or less if the whole way made
 *   the map worse.
 *
 * With FoldFree, the moved domain is untangled (shape::ComputeFoldFreeMap). Unstructured grids get
 * the arrays of vtkShapeUntangle, and structured grids only `Inverted`. The facts
 * also have .InvertedBefore and .InvertedAfter, the numbers of inverted cells. The charge set still
 * stores the harmonic map, which may fold.
 *
 * With Certify, the facts also have .CertifiedShare, .UndecidedShare and .InvertedShare, shares of
 * the volume: what vtkShapeCertificate proves about the charge set with its default properties.
 *
 * With Repair, the map is replaced where it folds (shape::RepairMap). The charge set then has the
 * field data `RepairPoints` and `RepairTargetPosition` (double, 3), `RepairShare` (double) and
 * `RepairTetrahedra` (int, 4). The moved domain and all readers of the charge set use the repaired
 * map. The facts have the shares of Certify, for the repaired map. .CertifiedBefore is that of the
 * charges. .CoreShare is the share of the volume in which the map is replaced, and .RingShare that
 * in which it is blended.
 *
 * FiniteElements takes no Features, and neither Exact nor FreeBoundary. Its table has one level
 * with the number of unknowns as Sources and Collocations.
 *
 * The mathematics: shape::ComputeVolumeMap, shape::ComputeHarmonicVolumeMap,
 * shape::ComputeFiniteElements.
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
  /// The connections of the inputs Features and TargetFeatures.
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
    shape::HarmonicVolumeMapOptions::MethodType::FiniteElements);
  vtkShapeOption(Tolerance, double);
  vtkShapeOption(MaximumLevels, int);
  vtkShapeOption(SourceSubsets, int);
  vtkShapeOption(MostRefined, double);
  vtkShapeOption(ChargeDistance, double);
  vtkShapeOption(LeastGain, double);
  vtkShapeOption(FeatureWeight, double);
  vtkSetMacro(Exact, bool);
  vtkGetMacro(Exact, bool);
  vtkBooleanMacro(Exact, bool);
  vtkShapeOption(CollocationRatio, double);
  vtkShapeOption(SourceRatio, double);
  vtkShapeOption(OffsetDistance, double);
  vtkShapeEnumOption(CollocationSampling, shape::SamplingMode, shape::SamplingMode::Uniform,
    shape::SamplingMode::Quadric);
  vtkShapeEnumOption(SourceSampling, shape::SamplingMode, shape::SamplingMode::Uniform,
    shape::SamplingMode::Quadric);
  vtkShapeOption(SingularValueThreshold, double);
  vtkSetMacro(FreeBoundary, bool);
  vtkGetMacro(FreeBoundary, bool);
  vtkSetMacro(FoldFree, bool);
  vtkGetMacro(FoldFree, bool);
  vtkSetMacro(Certify, bool);
  vtkGetMacro(Certify, bool);
  vtkSetMacro(Repair, bool);
  vtkGetMacro(Repair, bool);
  vtkShapeOption(MaximumMemory, double);
  vtkShapeOption(Tetrahedra, int);
  vtkShapeEnumOptionAs(Options.Device.Kind, Device, shape::SumDevice::KindType,
    shape::SumDevice::KindType::Automatic, shape::SumDevice::KindType::OpenCL);
  ///@}

protected:
  vtkShapeHarmonicVolumeMap();
  ~vtkShapeHarmonicVolumeMap() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeHarmonicVolumeMap(const vtkShapeHarmonicVolumeMap&) = delete;
  void operator=(const vtkShapeHarmonicVolumeMap&) = delete;

  /// Computes the map from the gathered inputs, and adds its errors and choices to the field data
  /// of `facts`.
  shape::VolumeMapResult Solve(
    vtkPolyData* facts, shape::AcceleratedSetup& setup, const shape::Progress& progress);

  std::string MapArray = "TargetPosition";
  bool Exact = false;
  bool FreeBoundary = false;
  bool FoldFree = false;
  bool Certify = false;
  bool Repair = false;
  shape::HarmonicVolumeMapOptions Options;
  std::shared_ptr<shape::AcceleratedSetup> Setup; ///< reused if the boundary does not change
};

#endif
