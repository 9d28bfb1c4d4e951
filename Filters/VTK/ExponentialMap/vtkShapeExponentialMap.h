/**
 * @class   vtkShapeExponentialMap
 * @brief   flatten the part of a surface around a seed
 *
 * Input: a surface, open or closed, which may be non-manifold. Polygons are triangulated
 * internally, and coincident points are treated as one. Blocks and distributed pieces are joined
 * first. In parallel, the first process has the patch. The input may also be a point cloud: data
 * without polygons and lines, whose points sample a surface. Its point normals are used if it has
 * any, and are estimated otherwise (shape::ConnectSamples).
 *
 * Output: the patch, which consists of the triangles whose points are all within the distance
 * Radius of the seed. The patch has the point and cell data of the input, and the point arrays
 * - `ExponentialMap` (double, 2): texture coordinates. The seed is at (0.5, 0.5), and the disk with
 *   the radius of the patch touches all edges of the unit square.
 * - `TargetPosition` (double, 3): the same coordinates in the units of the surface, with z = 0 and
 *   the seed at the origin.
 * - `GeodesicDistance` (double): the distance from the seed. `OriginalPointId`: the index of the
 *   point in the input.
 * It also has the cell arrays
 * - `Flipped`, `Torn` (int, 0 or 1). A triangle is torn if the longest edge of its image is more
 *   than twice as long as its own longest edge. There the front met itself behind a protrusion.
 * - `ConformalDistortion`, `SymmetricDirichlet`: as defined in vtkShapeMapQuality.
 * The patch of a point cloud has a vertex for each point within the distance Radius. It has no cell
 * arrays but those of the input's vertices, and the point array `Normals` if they were estimated.
 * The facts then describe the triangles between neighbouring points.
 *
 * Facts, with the prefix ExponentialMap
 * - .Seed, .SeedNormal, .XAxis (3 numbers each): origin of the patch, its normal, and the direction
 *   of the first texture coordinate.
 * - .SeedDistance: distance of Seed from the surface. .Radius: the radius that was used.
 * - .Flipped, .Torn: numbers of flipped and of torn triangles. .FlipRate: the share of flipped
 *   triangles. .Mended: the number of repaired triangles.
 * - .ConformalDistortion, .SymmetricDirichlet (2 numbers each): median and 95th percentile,
 *   weighted by area, over the triangles that are neither flipped nor torn. .Coverage: the area of
 *   the images of these triangles divided by the area of the disk.
 * - .Overlaps: 1 if parts of the image overlap. .ReachesRim: 1 if the patch ends at a boundary of
 *   the surface. .LocalTriangles: the number of triangles between the points of a cloud; 0 for a
 *   surface. .EstimatedNormals: 1 if the normals of a point cloud were estimated.
 *
 * Intermediate results are reused until the surface, NormalSmoothing or UpwindAverage changes. The
 * time for a new seed or radius depends only on the size of the patch.
 *
 * The mathematics: shape::ExponentialMap, shape::FlattenPatch, shape::ConnectSamples.
 */
#ifndef vtkShapeExponentialMap_h
#define vtkShapeExponentialMap_h

#include "vtkShapeAlgorithm.h"

#include "ExponentialMap/PatchLayout.h" // for the options

#include <memory> // for what is kept

class VTKSHAPEFILTERS_EXPORT vtkShapeExponentialMap : public vtkShapeAlgorithm
{
public:
  static vtkShapeExponentialMap* New();
  vtkTypeMacro(vtkShapeExponentialMap, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeExponentialMap.xml. Enumerations and defaults:
  /// shape::PatchLayoutOptions.
  vtkSetVector3Macro(Seed, double);
  vtkGetVector3Macro(Seed, double);
  vtkSetVector3Macro(XDirection, double);
  vtkGetVector3Macro(XDirection, double);
  vtkShapeOption(Radius, double);
  vtkShapeOption(UpwindAverage, bool);
  vtkShapeOption(NormalSmoothing, int);
  vtkShapeOption(MendFlips, bool);
  ///@}

protected:
  vtkShapeExponentialMap();
  ~vtkShapeExponentialMap() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeExponentialMap(const vtkShapeExponentialMap&) = delete;
  void operator=(const vtkShapeExponentialMap&) = delete;

  struct Kept;
  /// Returns the map of the current surface, which is built only if the surface or an option has
  /// changed.
  Kept& Update(const shape::Progress& progress);
  void ConnectPoints(const shape::Progress& progress); ///< makes the map of a point cloud

  double Seed[3] = { 0.0, 0.0, 0.0 };
  double XDirection[3] = { 0.0, 0.0, 0.0 };
  shape::PatchLayoutOptions Options;
  std::unique_ptr<Kept> Cache;
};

#endif
