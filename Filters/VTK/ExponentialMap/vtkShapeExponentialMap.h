/**
 * @class   vtkShapeExponentialMap
 * @brief   lays the part of a surface around a seed out in the plane, and gives it texture
 * coordinates
 *
 * Input: a surface, open or closed, that may hang together in any way (polygons are triangulated
 * inside; points at one place count as one). Blocks and distributed pieces are joined first; in
 * parallel the first process has the patch.
 *
 * Output: the patch: the triangles whose points the front reaches within Radius, with the data of
 * their points and cells. Point arrays: `ExponentialMap` (double, 2; the texture coordinates: (0.5,
 * 0.5) at the seed, the disk of the radius fills the square), `TargetPosition` (double, 3; the same
 * in the surface's units, z = 0, the seed at the origin), `GeodesicDistance` (from the seed),
 * `OriginalPointId`. Cell arrays: `Flipped` and `Torn` (int, 0 or 1; torn: the image is more than
 * twice as long as the triangle, where the front met itself behind a limb), `ConformalDistortion`,
 * `SymmetricDirichlet` (as Shape Map Quality has them).
 *
 * Field data: ExponentialMap.Seed, .SeedNormal, .XAxis (where the patch begins, and where u goes;
 * 3), .SeedDistance (of Seed from the surface), .Radius, .Flipped and .Torn (triangles), .FlipRate
 * (flipped, of all), .Mended (triangles), .ConformalDistortion and .SymmetricDirichlet (2: what
 * half of the area of triangles neither flipped nor torn does not exceed, and 95 %), .Coverage
 * (their images' area, of the disk's), .Overlaps (1: parts of the image lie over one another),
 * .ReachesRim (1: the patch ends at a rim of the surface).
 *
 * While the surface and NormalSmoothing and UpwindAverage stay, what depends on these is kept: a
 * new seed or radius takes time for the patch alone.
 *
 * The mathematics: shape::ExponentialMap, shape::FlattenPatch.
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
  /// Where the patch begins: the closest place of the surface. Default: the origin.
  vtkSetVector3Macro(Seed, double);
  vtkGetVector3Macro(Seed, double);
  ///@}

  ///@{
  /// What becomes the direction of u, without its part along the normal at the seed; where that
  /// leaves nothing the x axis, turned as the z axis is turned to the normal. Default: 0 0 0.
  vtkSetVector3Macro(XDirection, double);
  vtkGetVector3Macro(XDirection, double);
  ///@}

  ///@{
  /// How far the patch reaches along the surface, in its units. 0: a tenth of the diagonal of its
  /// box. Default: 0.
  vtkShapeOption(Radius, double);
  ///@}

  ///@{
  /// Whether each place is the mean of what several neighbours that the front met before say, or
  /// what one says. Default: on.
  vtkShapeOption(UpwindAverage, bool);
  ///@}

  ///@{
  /// How often each normal is replaced by the mean of those around it. Default: 2.
  vtkShapeOption(NormalSmoothing, int);
  ///@}

  ///@{
  /// Whether the points around flipped triangles are moved so that these turn back; what is moved
  /// is no longer at its distance, and may depend on the radius near the rim. Default: off.
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
  /// The map of the surface as it is now.
  Kept& Update(const shape::Progress& progress);

  double Seed[3] = { 0.0, 0.0, 0.0 };
  double XDirection[3] = { 0.0, 0.0, 0.0 };
  shape::PatchLayoutOptions Options;
  std::unique_ptr<Kept> Cache;
};

#endif
