/**
 * @class   vtkShapeHarmonicVolumeMap
 * @brief   carries a solid onto another by the harmonic map that a boundary map determines
 *
 * Each coordinate of the map is harmonic inside the boundary surface and takes the values of the
 * boundary's map array on it; it is found as the potential of point charges outside the solid
 * (the method of fundamental solutions).
 *
 * Inputs
 * - Domain: what is carried: points or cells of any dataset, also composite or distributed.
 * - Boundary: the closed surface of the solid and of its voids, with the map array (double, 3) at
 *   its points.
 * - Features (optional, repeatable): points, curves or surfaces inside, with the map array where
 *   they bring their images, and `Weight` (one component; FeatureWeight where absent): places that
 *   the map should also send there, in the least-squares sense.
 * - TargetFeatures (optional, repeatable): the images of the Features without the map array, in the
 *   same order: curves are matched with curves by arc length, points with points by order.
 * - Target (optional): the surface that the boundary goes to. Refused where its genus or number of
 *   components is not the boundary's; then .TargetDistance says how far the boundary's images are
 *   from it.
 *
 * Outputs
 * - 0: the domain moved, with `SourcePosition` (double, 3) and `OutsideDomain` (1 at points outside
 *   the boundary, which keep their place). Point normals are dropped.
 * - 1: the charge set: the map as a formula, evaluable anywhere inside: points with `Charge`
 *   (double, 3), field data `Affine` (3 x 4).
 * - 2: a table of levels: Level, Sources, Collocations, RMSEVertices, RMSEInside, Maximum, Seconds,
 *   Kept (0: the level lowered nothing and is not in the map), RegionId. Errors are of the whole
 *   boundary, at its points and inside its triangles, divided by the longest side of the target's
 *   box; with Exact, those of the region's own boundary.
 *
 * Field data of outputs 0 and 1: HarmonicVolumeMap.RMSEVertices, .RMSEInside, .Maximum,
 * .RMSEFeatures (0 without features), .FeaturePoints, .OffsetDistance (of the nearest charges),
 * .OutsidePoints (over all processes, without ghosts), .DeletedSources, .InsertedSources,
 * .TargetDistance (root mean square / longest side; with Target only); of Accelerated, and 0
 * otherwise: .Iterations, .RefinedPoints (that the boundary was refined by),
 * .PointsWithoutCharge (of the boundary: in gaps too narrow for one, or in the middle of triangles
 * without area); and in words .Method and .Stop: Tolerance (reached), Levels (all that were asked
 * for were fitted), NoImprovement (the last levels gained less than LeastGain), Refinement
 * (Accelerated: the boundary would have to be refined more than MostRefined). With Exact the
 * counts are sums over the layers' maps.
 *
 * With Exact, closed surfaces among the Features are met as well as the boundary is: by the maximum
 * principle no one harmonic map can, so each is a border between layers, and each layer has a
 * harmonic map of its own, with charges on both sides of it, by any Method. The map is continuous
 * across borders. Points and curves stay soft, in the layer that they lie in, and must bring
 * `Weight`: without, they ask to be met exactly, which is refused. The charge set then has
 * `RegionId` (int) at its points, of the charges: the region whose map they belong to, numbered as
 * Shape Tetrahedralize does (0 around the first border, i + 1 inside Features i among the surfaces;
 * pieces of one region that do not touch have numbers of their own, after these), and on its cells:
 * the region that they enclose, -1 for voids; field data `Affine` with 12 numbers, the rows of A
 * and b, for each region, and `Skin`, how thick the skin inside each region's border is in which
 * the map around passes into its own. Further field data, an entry for each region:
 * HarmonicVolumeMap.BorderRMSEVertices, .BorderRMSEInside, .BorderMaximum, of the map at the
 * surface around it, .BorderJumpRMS and .BorderJumpMaximum, by how much the two fitted maps differ
 * there, which the skin makes up for.
 *
 * With FreeBoundary: .DistortionBefore, .DistortionAfter (mean symmetric Dirichlet energy of the
 * solid, images scaled to its volume: 6 for an isometry), and in words .FreeBoundary: Slid, or
 * NotLower where that did not lower it and the images stay where they were.
 *
 * With FoldFree output 0 is what vtkShapeUntangle makes of the moved domain, with its arrays and
 * HarmonicVolumeMap.InvertedBefore and .InvertedAfter: a mesh, beside the charge set, which is the
 * map, folding or not.
 *
 * A singular value decomposition is a single library call: an abort takes effect at its end.
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
  /// The point array of Boundary and Features that says where each point goes.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  ///@}

  ///@{
  /// How the charges are found. 0 = Accelerated: close to the boundary, by iteration with fast
  /// sums; where that leaves too much over, the boundary is refined. 1 = MultiLevel: a sum of maps,
  /// each fitted to what the ones before left over. 2 = SingleShot: one map, from one
  /// decomposition. Default: Accelerated.
  vtkShapeEnumOption(Method, shape::HarmonicVolumeMapOptions::MethodType,
    shape::HarmonicVolumeMapOptions::MethodType::Accelerated,
    shape::HarmonicVolumeMapOptions::MethodType::SingleShot);
  ///@}

  ///@{
  /// Accelerated and MultiLevel stop when RMSEInside, divided by the longest side of the target's
  /// box, is no more.
  vtkShapeOption(Tolerance, double);
  ///@}

  ///@{
  /// How many maps are fitted at most; MultiLevel: among how many of them the sources are dealt.
  vtkShapeOption(MaximumLevels, int);
  vtkShapeOption(SourceSubsets, int);
  ///@}

  ///@{
  /// Accelerated: how many points the refined boundary has at most for each point of the boundary.
  vtkShapeOption(MostRefined, double);
  ///@}

  ///@{
  /// MultiLevel stops where two levels in a row lower what is left over by less than this share.
  vtkShapeOption(LeastGain, double);
  ///@}

  ///@{
  /// The weight of features without a `Weight` array: weight w counts as w equal equations.
  vtkShapeOption(FeatureWeight, double);
  ///@}

  ///@{
  /// Whether closed surfaces among the Features are met exactly: each is then a border between
  /// layers with a harmonic map each. Default: false.
  vtkSetMacro(Exact, bool);
  vtkGetMacro(Exact, bool);
  vtkBooleanMacro(Exact, bool);
  ///@}

  ///@{
  /// How many collocation points and sources there are for each point of the boundary.
  vtkShapeOption(CollocationRatio, double);
  vtkShapeOption(SourceRatio, double);
  ///@}

  ///@{
  /// How far outside the boundary the farthest sources lie, divided by the longest side of its box;
  /// the last of MultiLevel's subsets lies sqrt(SourceSubsets) times nearer. 0 = the nearest
  /// at 1.25 times the spacing of the points where the map is fitted, between 0.01 and 0.15.
  /// Default: 0.
  vtkShapeOption(OffsetDistance, double);
  ///@}

  ///@{
  /// How collocation points and sources are spread: 0 = Uniform, 1 = GeometryAdaptive.
  vtkShapeEnumOption(CollocationSampling, shape::SamplingMode, shape::SamplingMode::Uniform,
    shape::SamplingMode::GeometryAdaptive);
  vtkShapeEnumOption(SourceSampling, shape::SamplingMode, shape::SamplingMode::Uniform,
    shape::SamplingMode::GeometryAdaptive);
  ///@}

  ///@{
  /// Singular values below it are left out, where the boundary's longest side counts as 1.
  vtkShapeOption(SingularValueThreshold, double);
  ///@}

  ///@{
  /// Whether the images of the boundary's points slide on the Target, which must be connected, so
  /// that the map is distorted less. The boundary's solid is filled with tetrahedra for that.
  /// Default: off.
  vtkSetMacro(FreeBoundary, bool);
  vtkGetMacro(FreeBoundary, bool);
  ///@}

  ///@{
  /// Whether the moved domain, which must have solid cells, is untangled so that none is inverted,
  /// its boundary on the boundary's image: see vtkShapeUntangle. The charge set stays the map,
  /// which may fold. Default: off.
  vtkSetMacro(FoldFree, bool);
  vtkGetMacro(FoldFree, bool);
  ///@}

  ///@{
  /// GiB that one decomposition may take; a larger system is refused.
  vtkShapeOption(MaximumMemory, double);
  ///@}

protected:
  vtkShapeHarmonicVolumeMap();
  ~vtkShapeHarmonicVolumeMap() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeHarmonicVolumeMap(const vtkShapeHarmonicVolumeMap&) = delete;
  void operator=(const vtkShapeHarmonicVolumeMap&) = delete;

  /// The map of the whole inputs; the facts about it become field data of `facts`.
  shape::VolumeMapResult Solve(vtkPolyData* facts, const shape::Progress& progress);

  std::string MapArray = "TargetPosition";
  bool Exact = false;
  bool FreeBoundary = false;
  bool FoldFree = false;
  shape::HarmonicVolumeMapOptions Options;
  std::shared_ptr<shape::AcceleratedSetup> Setup; ///< of the last boundary
};

#endif
