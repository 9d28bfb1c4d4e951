/**
 * @class   vtkShapeSkeleton
 * @brief   extract the curve skeleton of a solid, and match it with that of another
 *
 * Inputs
 * - Input: the closed surface of a solid, of one or several components, none inside another. It may
 *   be composite or distributed.
 * - Target (optional): the closed surface of another solid.
 *
 * Output: the skeleton (vtkPolyData), a polyline for each branch between junctions and ends, and a
 * vertex for each component whose skeleton is a point. In parallel, the first process has all of
 * it.
 * - Point array `Radius` (double): the distance from the surface, in its units.
 * - Point array `Degree` (int): the number of edges at the point.
 * - Point array `TargetPosition` (double, 3), if there is a Target: the position on its skeleton.
 * - Cell array `BranchId` (int): the number of the branch, from 0.
 * - Cell array `TargetBranchId` (int), if there is a Target: the branch of its skeleton; -1 for a
 *   branch within a junction.
 * With a Target, short branches may be left out (LargestOmission). Two branches that are one
 * without them have the number of the first.
 *
 * Facts: Skeleton.Points, .Branches, .Junctions, .Ends, .Cycles, .Components, .OutsidePoints;
 * with a Target also .Difference, .AmbiguousBranches, .LeftOut, .TargetLeftOut.
 *
 * The mathematics: shape::ExtractCurveSkeleton, shape::MatchSkeletons.
 */
#ifndef vtkShapeSkeleton_h
#define vtkShapeSkeleton_h

#include "vtkShapeAlgorithm.h"

#include "Skeleton/Skeleton.h"         // for the options
#include "Skeleton/SkeletonMatching.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeSkeleton : public vtkShapeAlgorithm
{
public:
  static vtkShapeSkeleton* New();
  vtkTypeMacro(vtkShapeSkeleton, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeSkeleton.xml. Enumerations and defaults:
  /// shape::CurveSkeletonOptions, shape::SkeletonMatchingOptions.
  vtkShapeOption(Resolution, double);
  vtkShapeOption(VelocityWeight, double);
  vtkShapeOption(MedialWeight, double);
  vtkShapeEnumOptionOf(Matching, Ambiguous, shape::SkeletonMatchingOptions::AmbiguityType,
    shape::SkeletonMatchingOptions::AmbiguityType::Refuse,
    shape::SkeletonMatchingOptions::AmbiguityType::First);
  vtkShapeOptionOf(Matching, Tolerance, double);
  vtkShapeOptionOf(Matching, LargestDifference, double);
  vtkShapeOptionOf(Matching, LargestOmission, double);
  ///@}

protected:
  vtkShapeSkeleton();
  ~vtkShapeSkeleton() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeSkeleton(const vtkShapeSkeleton&) = delete;
  void operator=(const vtkShapeSkeleton&) = delete;

  shape::CurveSkeletonOptions Options;
  shape::SkeletonMatchingOptions Matching;
};

#endif
